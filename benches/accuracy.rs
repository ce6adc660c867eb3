//! The accuracy table of the README: worst error of every method over the families.
//!
//! `cargo bench --bench accuracy -- --cases 1000000`; without a number a short run. Prints the
//! distance of `evaluate` from the exact integral in units in the last place, the share of cases
//! that needed the exact tier, and relative errors of the other methods; then mean products of two filtered signals
//! beside partial fractions in rationals, whether any bound was broken, and what a call of each takes.
#![allow(missing_docs, clippy::print_stdout)]

#[path = "../tests/it/integral/crossed.rs"]
mod crossed;
#[path = "../tests/it/integral/families.rs"]
mod families;

use dashu_ratio::RBig;
use families::{FAMILIES, Family, coefficients, generator, polynomial};
use gyrospec::exact::rational;
use gyrospec::integral::{Integrand, Method, determinant, evaluate, evaluate_fast, exact, quadrature};
use gyrospec::lti::{cross_moment, cross_rate_moment};
use rayon::prelude::*;
use std::hint::black_box;
use std::time::Instant;

/// Worst figures of one family.
#[derive(Clone, Copy, Default)]
struct Worst {
    cases: usize,
    ulps: f64,
    escalated: usize,
    fast: f64,
    broken_bounds: usize,
    determinant: f64,
    quadrature: f64,
    refused: usize,
}

impl Worst {
    fn join(self, o: Self) -> Self {
        Self {
            cases: self.cases + o.cases,
            ulps: self.ulps.max(o.ulps),
            escalated: self.escalated + o.escalated,
            fast: self.fast.max(o.fast),
            broken_bounds: self.broken_bounds + o.broken_bounds,
            determinant: self.determinant.max(o.determinant),
            quadrature: self.quadrature.max(o.quadrature),
            refused: self.refused + o.refused,
        }
    }
}

fn size(x: RBig) -> RBig {
    if x < RBig::ZERO { -x } else { x }
}

/// One problem; every 16th also goes through the slower methods.
fn case(family: Family, seed: u64) -> Worst {
    let mut rng = generator(seed);
    let n = [1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 20][seed as usize % 12];
    let n = if seed.is_multiple_of(997) { 64 } else { n };
    let h = polynomial(family, n, &mut rng);
    let mut g = coefficients(n, &mut rng);
    if seed.is_multiple_of(3) {
        g[..n - 1].fill(0.0);
    }
    let p = Integrand::new(&h, &g).unwrap();
    let all = |x: &[f64]| x.iter().map(|v| rational(*v)).collect::<Vec<_>>();
    let (Ok(truth), Ok(answer)) = (exact::rational(&all(&h), &all(&g)), evaluate(&p)) else {
        return Worst::default();
    };
    let error = |value: f64| size(rational(value) - &truth);
    let relative = |value: f64| (error(value) / size(truth.clone())).to_f64().value();
    let ulp = f64::from_bits(answer.value.abs().to_bits() + 1) - answer.value.abs();
    let fast = evaluate_fast(&p).unwrap();
    let broken =
        error(answer.value) > rational(answer.error_bound) || error(fast.value) > rational(fast.error_bound);
    let mut out = Worst {
        cases: 1,
        ulps: (error(answer.value) / rational(ulp)).to_f64().value(),
        escalated: usize::from(answer.method == Method::Exact),
        fast: relative(fast.value),
        broken_bounds: usize::from(broken),
        ..Worst::default()
    };
    if seed.is_multiple_of(16) {
        out.determinant = determinant::evaluate(&p).map_or(0.0, relative);
        match quadrature::evaluate(&p, 1e-9) {
            Ok(e) => out.quadrature = relative(e.value),
            Err(_) => out.refused = 1,
        }
    }
    out
}

/// One mean product of two filtered signals, or of one with the rate of the other, beside partial fractions.
fn product(family: Family, seed: u64) -> Worst {
    let x = crossed::case(family, seed);
    let mean = if x.rate { cross_rate_moment } else { cross_moment };
    let (answer, truth) = (mean(&x.shaping, &x.first, &x.second), crossed::exactly(&x));
    let (Ok(answer), Some(truth)) = (&answer, &truth) else {
        // refused where there is none, and only there
        return Worst {
            refused: 1,
            broken_bounds: usize::from(answer.is_ok() != truth.is_some()),
            ..Worst::default()
        };
    };
    let error = size(rational(answer.value) - truth);
    let ulp = f64::from_bits(answer.value.abs().to_bits() + 1) - answer.value.abs();
    Worst {
        cases: 1,
        ulps: (error.clone() / rational(ulp)).to_f64().value(),
        broken_bounds: usize::from(error > rational(answer.error_bound)),
        ..Worst::default()
    }
}

/// The worst over a family's cases.
fn worst(cases: u64, f: usize, one: impl Fn(u64) -> Worst + Send + Sync) -> Worst {
    let seeds = (0..cases / 4).into_par_iter().map(|seed| seed + (f as u64) * 10_000_019);
    seeds.map(one).reduce(Worst::default, Worst::join)
}

/// Seconds a call, on one core.
fn seconds<T, R>(all: &[T], call: impl Fn(&T) -> R) -> f64 {
    let since = Instant::now();
    for x in all {
        let _ = black_box(call(x));
    }
    since.elapsed().as_secs_f64() / all.len() as f64
}

/// What a call of each takes, by family.
fn speeds(cases: u64) {
    println!("\nmicroseconds a call, on one core");
    println!("family     evaluate  evaluate_fast  cross_moment  cross_rate_moment");
    for family in FAMILIES {
        let filter = |seed: u64| {
            let mut rng = generator(seed);
            let n = [1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 20][seed as usize % 12];
            let h = polynomial(family, n, &mut rng);
            (h, coefficients(n, &mut rng))
        };
        let filters: Vec<(Vec<f64>, Vec<f64>)> = (0..cases).map(filter).collect();
        let integrals: Vec<Integrand> = filters.iter().map(|(h, g)| Integrand::new(h, g).unwrap()).collect();
        let products: Vec<crossed::Crossed> = (0..cases).map(|seed| crossed::case(family, seed)).collect();
        let mean = |rate: bool| {
            let those: Vec<&crossed::Crossed> = products.iter().filter(|x| x.rate == rate).collect();
            let of = if rate { cross_rate_moment } else { cross_moment };
            1e6 * seconds(&those, |x| of(&x.shaping, &x.first, &x.second))
        };
        println!(
            "{:9} {:9.2} {:14.2} {:13.1} {:18.1}",
            format!("{family:?}"),
            1e6 * seconds(&integrals, evaluate),
            1e6 * seconds(&integrals, evaluate_fast),
            mean(false),
            mean(true)
        );
    }
}

fn main() {
    let words: Vec<String> = std::env::args().collect();
    let given = words.iter().position(|w| w == "--cases").and_then(|i| words.get(i + 1)?.parse::<u64>().ok());
    let cases = given.unwrap_or(4_000);
    let mut broken = 0;
    println!(
        "family    cases  evaluate[ulp]  by exact  fast[rel]  bounds broken  determinant[rel]  quadrature[rel]  refused"
    );
    for (f, family) in FAMILIES.into_iter().enumerate() {
        let w = worst(cases, f, |seed| case(family, seed));
        println!(
            "{:9} {:5} {:13.4} {:9} {:10.1e} {:14} {:17.1e} {:16.1e} {:8}",
            format!("{family:?}"),
            w.cases,
            w.ulps,
            w.escalated,
            w.fast,
            w.broken_bounds,
            w.determinant,
            w.quadrature,
            w.refused
        );
        broken += w.broken_bounds;
    }
    println!("\nmean products of two filtered signals");
    println!("family    cases  [ulp]  bounds broken  without a mean");
    for (f, family) in FAMILIES.into_iter().enumerate() {
        let w = worst(cases, f, |seed| product(family, seed));
        let name = format!("{family:?}");
        println!("{name:9} {:5} {:6.4} {:14} {:15}", w.cases, w.ulps, w.broken_bounds, w.refused);
        broken += w.broken_bounds;
    }
    println!("{}", if broken == 0 { "no bound broken".into() } else { format!("{broken} BOUNDS BROKEN") });
    speeds(cases.min(4_000));
}
