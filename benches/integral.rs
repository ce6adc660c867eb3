//! Every method of I_n by order, white numerator unless said otherwise; ratios within one run.
//!
//! `plain` is the bare recursion without scaling, checks or bound: the floor to measure against.
#![allow(missing_docs)]

#[path = "../tests/it/integral/families.rs"]
#[allow(dead_code)]
mod families;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use faer::Mat;
use families::{Family, coefficients, generator, polynomial};
use gyrospec::integral::{
    Integrand, batch, determinant, evaluate, evaluate_fast, exact, gradient, quadrature,
};
use std::hint::black_box;

const ORDERS: [usize; 6] = [3, 5, 7, 10, 20, 40];

/// The bare recursion in place, white G = 1.
fn plain(h: &[f64], work: &mut Vec<f64>) -> f64 {
    work.clear();
    work.extend_from_slice(h);
    let n = h.len() - 1;
    for k in 1..n {
        let alpha = work[k - 1] / work[k];
        for i in (k + 1..n).step_by(2) {
            work[i] -= alpha * work[i + 1];
        }
    }
    0.5 / (work[n - 1] * work[n])
}

/// Two determinants of faer, unscaled, and their ratio.
fn faer_determinants(h: &[f64]) -> f64 {
    let n = h.len() - 1;
    let at = |i: usize, j: usize| (2 * j + 1).checked_sub(i).and_then(|k| h.get(k)).copied().unwrap_or(0.0);
    let hurwitz = Mat::from_fn(n, n, at);
    let white = Mat::from_fn(n, n, |i, j| if i > 0 { at(i, j) } else { f64::from(u8::from(j == n - 1)) });
    let sign = if n % 2 == 1 { 0.5 } else { -0.5 };
    sign * white.determinant() / (h[0] * hurwitz.determinant())
}

/// The crate as it comes: one call over (0, 1) with ω = x/(1 − x).
fn quadrature_crate(h: &[f64]) -> f64 {
    let f = |x: f64| {
        let value = gyrospec::poly::at_frequency(h, x / (1.0 - x));
        1.0 / (value.norm_sqr() * (1.0 - x) * (1.0 - x))
    };
    ::quadrature::integrate(f, 0.0, 1.0, 1e-12).integral / std::f64::consts::PI
}

type Group<'a> = BenchmarkGroup<'a, WallTime>;

fn time<T>(group: &mut Group, name: &str, n: usize, mut call: impl FnMut() -> T) {
    group.bench_function(BenchmarkId::new(name, n), |b| b.iter(&mut call));
}

fn methods(c: &mut Criterion) {
    let mut group = c.benchmark_group("white");
    for n in ORDERS {
        let h = polynomial(Family::Well, n, &mut generator(n as u64));
        let mut g = vec![0.0; n];
        g[n - 1] = 1.0;
        let p = Integrand::new(&h, &g).unwrap();
        let mut work = Vec::new();
        time(&mut group, "plain", n, || plain(black_box(&h), &mut work));
        time(&mut group, "evaluate_fast", n, || evaluate_fast(black_box(&p)));
        time(&mut group, "evaluate", n, || evaluate(black_box(&p)));
        time(&mut group, "exact", n, || exact::evaluate(black_box(&p)));
        time(&mut group, "gradient", n, || gradient::gradient(black_box(&p)));
        time(&mut group, "determinant", n, || determinant::evaluate(black_box(&p)));
        time(&mut group, "quadrature", n, || quadrature::evaluate(black_box(&p), 1e-9));
        time(&mut group, "faer", n, || faer_determinants(black_box(&h)));
        time(&mut group, "crate", n, || quadrature_crate(black_box(&h)));
    }
    group.finish();
}

fn general(c: &mut Criterion) {
    let mut group = c.benchmark_group("general");
    for n in ORDERS {
        let mut rng = generator(n as u64);
        let (h, g) = (polynomial(Family::Well, n, &mut rng), coefficients(n, &mut rng));
        let p = Integrand::new(&h, &g).unwrap();
        time(&mut group, "evaluate_fast", n, || evaluate_fast(black_box(&p)));
        time(&mut group, "evaluate", n, || evaluate(black_box(&p)));
        time(&mut group, "exact", n, || exact::evaluate(black_box(&p)));
    }
    group.finish();
}

fn batches(c: &mut Criterion) {
    let mut group = c.benchmark_group("batch");
    let count = 2048;
    group.throughput(Throughput::Elements(count as u64));
    for n in [3, 5, 10] {
        let mut rng = generator(n as u64);
        let (mut h, mut g) = (Vec::new(), vec![0.0; count * n]);
        for k in 0..count {
            h.extend(polynomial(Family::Well, n, &mut rng));
            g[k * n + n - 1] = 1.0;
        }
        time(&mut group, "abreast", n, || batch::evaluate_fast(n, black_box(&h), &g));
        time(&mut group, "single", n, || {
            let all = h.chunks(n + 1).zip(g.chunks(n));
            all.map(|(h, g)| evaluate_fast(&Integrand::new(h, g).unwrap()).unwrap().value).sum::<f64>()
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(std::time::Duration::from_millis(100))
        .measurement_time(std::time::Duration::from_millis(400))
        .sample_size(20)
        .without_plots();
    targets = methods, general, batches
}
criterion_main!(benches);
