//! Every method against rational arithmetic.

use super::families::{FAMILIES, coefficients, generator, polynomial};
use dashu_ratio::RBig;
use gyrospec::ErrorKind;
use gyrospec::exact::rational;
use gyrospec::integral::{Integrand, Method, evaluate, evaluate_fast, exact};

fn exactly(h: &[f64], g: &[f64]) -> Result<RBig, gyrospec::Error> {
    let all = |x: &[f64]| x.iter().map(|v| rational(*v)).collect::<Vec<_>>();
    exact::rational(&all(h), &all(g))
}

/// |value − exact| in units in the last place of the value, and whether the bound holds.
fn distance(value: f64, bound: f64, truth: &RBig) -> (f64, bool) {
    let error = rational(value) - truth;
    let size = if error < RBig::ZERO { -error } else { error };
    let ulp = f64::from_bits(value.abs().to_bits() + 1) - value.abs();
    ((&size / rational(ulp)).to_f64().value(), size <= rational(bound))
}

#[test]
fn evaluate_keeps_its_promise_over_all_families() {
    let mut rng = generator(1);
    let (mut worst, mut escalated, mut total) = (0.0f64, 0, 0);
    for round in 0..40 {
        for family in FAMILIES {
            for n in 1..=64 {
                if n > 20 && (n + round) % 8 != 0 {
                    continue;
                }
                let h = polynomial(family, n, &mut rng);
                let mut g = coefficients(n, &mut rng);
                if round % 2 == 0 {
                    g[..n - 1].fill(0.0);
                }
                let p = Integrand::new(&h, &g).unwrap();
                match (exactly(&h, &g), evaluate(&p)) {
                    (Ok(truth), Ok(answer)) => {
                        let (ulps, held) = distance(answer.value, answer.error_bound, &truth);
                        assert!(held, "{family:?} {n}: {ulps} ulp, {answer:?}");
                        worst = worst.max(ulps);
                        escalated += usize::from(answer.method == Method::Exact);
                        let fast = evaluate_fast(&p).unwrap();
                        let (_, held) = distance(fast.value, fast.error_bound, &truth);
                        assert!(held, "{family:?} {n}: {fast:?}");
                    }
                    (Err(a), Err(b)) => assert_eq!(a.kind(), b.kind(), "{family:?} {n}"),
                    (Ok(_), Err(b)) => assert_eq!(b.kind(), ErrorKind::OutOfRange, "{family:?} {n} {b}"),
                    (a, b) => panic!("{family:?} {n}: {a:?} {b:?}"),
                }
                total += 1;
            }
        }
    }
    println!("{total} cases, worst {worst} ulp, {escalated} by the exact tier");
    assert!(worst <= 2.0, "{worst} ulp");
}
