//! The two main calls against rational arithmetic.

use super::families::{FAMILIES, coefficients, generator, polynomial};
use dashu_ratio::RBig;
use gyrospec::ErrorKind;
use gyrospec::exact::rational;
use gyrospec::integral::{Integrand, Method, evaluate, evaluate_fast, exact};
use rand::RngExt;

pub fn exactly(h: &[f64], g: &[f64]) -> Result<RBig, gyrospec::Error> {
    let all = |x: &[f64]| x.iter().map(|v| rational(*v)).collect::<Vec<_>>();
    exact::rational(&all(h), &all(g))
}

/// |value − exact| in units in the last place of the value, and whether the bound holds.
pub fn distance(value: f64, bound: f64, truth: &RBig) -> (f64, bool) {
    let error = rational(value) - truth;
    let size = if error < RBig::ZERO { -error } else { error };
    let ulp = f64::from_bits(value.abs().to_bits() + 1) - value.abs();
    ((&size / rational(ulp)).to_f64().value(), size <= rational(bound))
}

/// One case: the promise of `evaluate` and the bound of `evaluate_fast`; the distance in ulp and
/// whether the exact tier was needed.
fn case(h: &[f64], p: &Integrand, truth: Result<RBig, gyrospec::Error>) -> (f64, bool) {
    match (truth, evaluate(p)) {
        (Ok(truth), Ok(answer)) => {
            let (ulps, held) = distance(answer.value, answer.error_bound, &truth);
            assert!(held && ulps <= 2.0, "{ulps} ulp, {answer:?} for {h:?}");
            let fast = evaluate_fast(p).unwrap();
            assert!(distance(fast.value, fast.error_bound, &truth).1, "{fast:?} for {h:?}");
            (ulps, answer.method == Method::Exact)
        }
        (Err(a), Err(b)) => {
            assert_eq!(a.kind(), b.kind(), "{h:?}");
            (0.0, true)
        }
        (Ok(_), Err(b)) => {
            assert_eq!(b.kind(), ErrorKind::OutOfRange, "{b} for {h:?}");
            (0.0, true)
        }
        (a, b) => panic!("{a:?} {b:?} for {h:?}"),
    }
}

#[test]
fn evaluate_keeps_its_promise_over_all_families() {
    let mut rng = generator(1);
    let (mut worst, mut escalated, mut total) = (0.0f64, 0, 0);
    let rounds = if std::env::var_os("GYROSPEC_LONG").is_some() { 160 } else { 48 };
    for round in 0..rounds {
        for family in FAMILIES {
            for n in (1..=64).filter(|n| *n <= 12 || (n + round) % 16 == 0) {
                let h = polynomial(family, n, &mut rng);
                let mut g = coefficients(n, &mut rng);
                if round % 2 == 0 {
                    g[..n - 1].fill(0.0);
                }
                let p = Integrand::new(&h, &g).unwrap();
                let (ulps, exact) = case(&h, &p, exactly(&h, &g));
                worst = worst.max(ulps);
                escalated += usize::from(exact);
                total += 1;
            }
        }
    }
    assert!(total >= 56 * rounds, "{total}");
    println!("{total} cases, worst {worst} ulp, {escalated} by the exact tier");
}

#[test]
fn a_squared_numerator_keeps_the_promise_too() {
    let mut rng = generator(2);
    for round in 0..60 {
        for family in FAMILIES {
            for n in (1..=40).filter(|n| *n <= 10 || (n + round) % 16 == 0) {
                let h = polynomial(family, n, &mut rng);
                let c = coefficients(rng.random_range(1..=n), &mut rng);
                let p = Integrand::from_square(&h, &c).unwrap();
                // G = C(s)C(−s) in rationals
                let mut g = vec![RBig::ZERO; n];
                let top = c.len() - 1;
                for i in 0..=top {
                    for j in (0..=top).filter(|j| (i + j) % 2 == 0) {
                        let term = rational(c[i]) * rational(c[j]);
                        let at = n - 1 - (2 * top - i - j) / 2;
                        if (top - j) % 2 == 0 {
                            g[at] += term;
                        } else {
                            g[at] -= term;
                        }
                    }
                }
                let exact_h: Vec<RBig> = h.iter().map(|v| rational(*v)).collect();
                case(&h, &p, exact::rational(&exact_h, &g));
            }
        }
    }
}
