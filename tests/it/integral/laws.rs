//! Laws of the integral, and the closed forms of the classical tables.

use super::exactness::{distance, exactly};
use super::families::{FAMILIES, coefficients, generator, polynomial};
use approx::assert_ulps_eq;
use gyrospec::integral::{Integrand, evaluate, evaluate_fast};
use gyrospec::poly::product;
use proptest::prelude::*;

fn value(h: &[f64], g: &[f64]) -> f64 {
    evaluate(&Integrand::new(h, g).unwrap()).unwrap().value
}

/// The tables of James, Nichols and Phillips, written as printed there with the signs of (3.11).
fn table(a: &[f64], b: &[f64]) -> f64 {
    match a.len() - 1 {
        1 => b[0] / (2.0 * a[0] * a[1]),
        2 => (-b[0] + a[0] * b[1] / a[2]) / (2.0 * a[0] * a[1]),
        3 => {
            (-a[2] * b[0] + a[0] * b[1] - a[0] * a[1] * b[2] / a[3])
                / (2.0 * a[0] * (a[0] * a[3] - a[1] * a[2]))
        }
        4 => {
            let n = b[0] * (-a[1] * a[4] + a[2] * a[3]) - a[0] * a[3] * b[1]
                + a[0] * a[1] * b[2]
                + a[0] * b[3] / a[4] * (a[0] * a[3] - a[1] * a[2]);
            n / (2.0 * a[0] * (a[0] * a[3] * a[3] + a[1] * a[1] * a[4] - a[1] * a[2] * a[3]))
        }
        _ => {
            let m0 = a[3] * a[4] - a[2] * a[5];
            let n = b[0]
                * (-a[0] * a[4] * a[5] + a[1] * a[4] * a[4] + a[2] * a[2] * a[5] - a[2] * a[3] * a[4])
                + a[0] * b[1] * m0
                + a[0] * b[2] * (a[0] * a[5] - a[1] * a[4])
                + a[0] * b[3] * (-a[0] * a[3] + a[1] * a[2])
                + a[0] * b[4] / a[5]
                    * (-a[0] * a[1] * a[5] + a[0] * a[3] * a[3] + a[1] * a[1] * a[4] - a[1] * a[2] * a[3]);
            let d = a[0] * a[0] * a[5] * a[5] - 2.0 * a[0] * a[1] * a[4] * a[5] - a[0] * a[2] * a[3] * a[5]
                + a[0] * a[3] * a[3] * a[4]
                + a[1] * a[1] * a[4] * a[4]
                + a[1] * a[2] * a[2] * a[5]
                - a[1] * a[2] * a[3] * a[4];
            n / (2.0 * a[0] * d)
        }
    }
}

#[test]
fn the_closed_forms_of_the_classical_tables_come_out() {
    let mut rng = generator(3);
    for n in 1..=5 {
        for _ in 0..200 {
            let h = polynomial(FAMILIES[0], n, &mut rng);
            let g = coefficients(n, &mut rng);
            let ours = evaluate(&Integrand::new(&h, &g).unwrap()).unwrap();
            let slack = 64.0 * f64::EPSILON * ours.condition * ours.value.abs();
            assert!((table(&h, &g) - ours.value).abs() <= slack, "{n} {h:?} {g:?}");
        }
    }
}

#[test]
fn powers_of_two_in_time_and_gain_change_only_the_exponent() {
    let mut rng = generator(4);
    for family in FAMILIES {
        for n in [1, 2, 3, 5, 8, 13] {
            let (h, g) = (polynomial(family, n, &mut rng), coefficients(n, &mut rng));
            for (time, gain) in [(3, -7), (-11, 20), (1, 200), (-20, -300), (25, 0)] {
                let two = |k: i32| 2f64.powi(k);
                let h2: Vec<f64> = h.iter().zip(0..).map(|(a, i)| a * two(time * i + gain)).collect();
                let g2: Vec<f64> = g.iter().zip(0..).map(|(b, k)| b * two(2 * time * k)).collect();
                // H(s) → 2^gain·2^(time·n)·H(s/2^time), G likewise, dω = 2^time dω′
                let back = two(time) * two(-gain) * two(-gain) * two(-2 * time);
                let (a, b) = (Integrand::new(&h, &g).unwrap(), Integrand::new(&h2, &g2).unwrap());
                assert_eq!(evaluate(&b).unwrap().value, evaluate(&a).unwrap().value * back, "{family:?} {n}");
                assert_eq!(evaluate_fast(&b).unwrap().value, evaluate_fast(&a).unwrap().value * back);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn the_sign_of_h_does_not_matter(seed in 0u64..10_000, n in 1usize..20) {
        let mut rng = generator(seed);
        let (h, g) = (polynomial(FAMILIES[0], n, &mut rng), coefficients(n, &mut rng));
        let minus: Vec<f64> = h.iter().map(|a| -a).collect();
        prop_assert_eq!(value(&h, &g), value(&minus, &g));
    }

    #[test]
    fn the_integral_is_additive_in_g(seed in 0u64..10_000, n in 1usize..12) {
        let mut rng = generator(seed);
        let h = polynomial(FAMILIES[0], n, &mut rng);
        // multiples of 2⁻²⁰, so that the sum is exact
        let grid = |x: f64| (x * 1_048_576.0).round() / 1_048_576.0;
        let (g, k): (Vec<f64>, Vec<f64>) =
            (coefficients(n, &mut rng).into_iter().map(grid).collect(), coefficients(n, &mut rng).into_iter().map(grid).collect());
        let both: Vec<f64> = g.iter().zip(&k).map(|(a, b)| a + b).collect();
        let (x, y) = (value(&h, &g), value(&h, &k));
        prop_assert!((x + y - value(&h, &both)).abs() <= 4.0 * f64::EPSILON * (x.abs() + y.abs()));
    }

    #[test]
    fn a_common_stable_factor_cancels(seed in 0u64..10_000, n in 1usize..10, r in 1i32..9) {
        let mut rng = generator(seed);
        // whole numbers, so that the products are exact
        let h: Vec<f64> = polynomial(FAMILIES[0], n, &mut rng).iter().map(|a| (a * 64.0).round()).collect();
        let g: Vec<f64> = coefficients(n, &mut rng).iter().map(|b| (b * 64.0).round()).collect();
        prop_assume!(evaluate(&Integrand::new(&h, &g).unwrap()).is_ok());
        let r = f64::from(r);
        let wide = product(&h, &[1.0, r]);
        // G·(s + r)(r − s) = G·(r² − s²)
        let mut g2 = vec![0.0; n + 1];
        for (i, b) in g.iter().enumerate() {
            g2[i] -= b;
            g2[i + 1] += r * r * b;
        }
        assert_ulps_eq!(value(&wide, &g2), value(&h, &g), max_ulps = 2);
    }

    #[test]
    fn any_finite_numbers_get_a_right_value_or_a_refusal(
        h in prop::collection::vec(any::<f64>().prop_filter("finite", |x| x.is_finite()), 2..8),
        g in prop::collection::vec(any::<f64>().prop_filter("finite", |x| x.is_finite()), 7)
    ) {
        prop_assume!(h[0] != 0.0);
        for sign in [false, true] {
            let h: Vec<f64> = h.iter().map(|x| if sign { x.abs() } else { *x }).collect();
            let g = &g[..h.len() - 1];
            match (exactly(&h, g), evaluate(&Integrand::new(&h, g).unwrap())) {
                (Ok(truth), Ok(answer)) => {
                    let (ulps, held) = distance(answer.value, answer.error_bound, &truth);
                    prop_assert!(held && (ulps <= 2.0 || answer.value == 0.0), "{} {:?}", ulps, answer);
                }
                (Ok(_), Err(e)) => prop_assert_eq!(e.kind(), gyrospec::ErrorKind::OutOfRange),
                (Err(a), Err(b)) => prop_assert_eq!(a.kind(), b.kind()),
                (a, b) => prop_assert!(false, "{:?} {:?}", a, b),
            }
        }
    }
}
