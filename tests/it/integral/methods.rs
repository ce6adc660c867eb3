//! The other methods against the exact value: determinant, quadrature, gradient, batch.

use super::exactness::exactly;
use super::families::{FAMILIES, Family, coefficients, generator, polynomial};
use dashu_ratio::RBig;
use gyrospec::exact::rational;
use gyrospec::integral::{
    Integrand, batch, determinant, evaluate, evaluate_fast, exact, gradient, quadrature,
};

#[test]
fn the_determinant_agrees_on_well_damped_filters() {
    let mut rng = generator(5);
    for n in 1..=12 {
        for _ in 0..20 {
            let (h, g) = (polynomial(Family::Well, n, &mut rng), coefficients(n, &mut rng));
            let p = Integrand::new(&h, &g).unwrap();
            let truth = evaluate(&p).unwrap();
            let value = determinant::evaluate(&p).unwrap();
            let slack = 1e-13 * truth.condition * truth.value.abs() * n as f64;
            assert!((value - truth.value).abs() <= slack, "{n}: {value} {truth:?}");
        }
    }
}

#[test]
fn quadrature_is_within_its_estimate_or_refuses() {
    let mut rng = generator(6);
    let mut refused = [0; 4];
    for (f, family) in FAMILIES.into_iter().enumerate() {
        for round in 0..60 {
            let n = 1 + round % 12;
            let h = polynomial(family, n, &mut rng);
            let mut g = coefficients(n, &mut rng);
            if round % 2 == 0 {
                g[..n - 1].fill(0.0);
            }
            let p = Integrand::new(&h, &g).unwrap();
            let truth = evaluate(&p).unwrap().value;
            match quadrature::evaluate(&p, 1e-7) {
                Ok(e) => {
                    assert!((e.value - truth).abs() <= 1e-7 * truth.abs(), "{family:?} {n}: {e:?} {truth}");
                }
                Err(_) => refused[f] += 1,
            }
        }
    }
    // it may refuse, but not as a habit
    assert!(refused.iter().all(|r| *r <= 12), "{refused:?} of 60 a family refused");
}

#[test]
fn the_gradient_agrees_with_exact_differences() {
    let mut rng = generator(7);
    for family in FAMILIES {
        for n in [1, 2, 3, 5, 8] {
            let (h, g) = (polynomial(family, n, &mut rng), coefficients(n, &mut rng));
            let p = Integrand::new(&h, &g).unwrap();
            let d = gradient::gradient(&p).unwrap();
            let all = |x: &[f64]| x.iter().map(|v| rational(*v)).collect::<Vec<RBig>>();
            for i in 0..=n {
                // central difference in rationals with a step of 2⁻⁶⁰ of the coefficient
                let step = rational(h[i]) / RBig::from(1u64 << 60);
                let at = |sign: i32| {
                    let mut h = all(&h);
                    h[i] += &step * RBig::from(sign);
                    exact::rational(&h, &all(&g)).unwrap()
                };
                let slope = ((at(1) - at(-1)) / (&step * RBig::from(2))).to_f64().value();
                let scale = evaluate(&p).unwrap();
                let slack = 1e-12 * (slope.abs() + scale.condition * (scale.value / h[i]).abs() * 1e-3);
                assert!((slope - d.h[i]).abs() <= slack, "{family:?} {n} a{i}: {slope} {}", d.h[i]);
            }
            let total: f64 = d.numerator.iter().zip(&g).map(|(x, b)| x * b).sum();
            let size: f64 = d.numerator.iter().zip(&g).map(|(x, b)| (x * b).abs()).sum();
            assert!((total - d.value).abs() <= 1e-14 * size, "linear in G");
        }
    }
}

#[test]
fn the_gradient_in_c_is_that_of_its_square() {
    let (h, c) = ([1.0, 3.0, 4.0, 2.5], [0.5, -2.0, 3.0]);
    let d = gradient::gradient(&Integrand::from_square(&h, &c).unwrap()).unwrap();
    let at = |k: usize, e: f64| {
        let mut c = c;
        c[k] += e;
        evaluate(&Integrand::from_square(&h, &c).unwrap()).unwrap().value
    };
    for k in 0..3 {
        // I is quadratic in C: the central difference is exact but for rounding
        let slope = (at(k, 0.25) - at(k, -0.25)) / 0.5;
        assert!((slope - d.numerator[k]).abs() < 1e-14, "{k}: {slope} {}", d.numerator[k]);
    }
}

#[test]
fn a_batch_gives_what_single_calls_give() {
    let mut rng = generator(8);
    for n in [1, 3, 5, 10] {
        let (mut h, mut g) = (Vec::new(), Vec::new());
        for k in 0..5003 {
            let family = if k % 97 == 0 { Family::OnePair } else { Family::Well };
            h.extend(polynomial(family, n, &mut rng));
            g.extend(coefficients(n, &mut rng));
        }
        h[17 * (n + 1) + n] = -1.0;
        g[29 * n] = f64::NAN;
        let answers = batch::evaluate_fast(n, &h, &g).unwrap();
        for (i, answer) in answers.iter().enumerate() {
            let p = Integrand::new(&h[i * (n + 1)..(i + 1) * (n + 1)], &g[i * n..(i + 1) * n]);
            match (answer, p.and_then(|p| evaluate_fast(&p))) {
                (Ok(a), Ok(b)) => assert_eq!((a.value, a.error_bound), (b.value, b.error_bound), "{i}"),
                (Err(a), Err(b)) => assert_eq!(a.kind(), b.kind()),
                (a, b) => panic!("{i}: {a:?} {b:?}"),
            }
        }
    }
    assert!(batch::evaluate_fast(2, &[1.0; 7], &[1.0; 4]).is_err());
}

#[test]
fn an_exact_zero_is_a_value() {
    let p = Integrand::new(&[1.0, 2.0, 3.0], &[0.0, 0.0]).unwrap();
    let a = evaluate(&p).unwrap();
    assert_eq!((a.value, a.error_bound), (0.0, 0.0));
    // −b0 + a0·b1/a2 = 0 without all of G being zero
    let p = Integrand::new(&[1.0, 2.0, 3.0], &[1.0, 3.0]).unwrap();
    assert_eq!(evaluate(&p).unwrap().value, 0.0);
    assert!(exactly(&[1.0, 2.0, 3.0], &[1.0, 3.0]).unwrap() == RBig::ZERO);
}

#[test]
fn quadrature_refuses_what_its_doubles_cannot_hold() {
    let h = [7.679704829345748e-295, 4.610821264732876e50, 2.585437239664259e200];
    let p = Integrand::new(&h, &[0.0, 1.0]).unwrap();
    assert!(evaluate(&p).unwrap().value > 0.0);
    assert!(quadrature::evaluate(&p, 1e-9).is_err());
}

#[test]
fn a_bound_near_the_smallest_normal_double_stays_narrow() {
    let p = Integrand::new(&[1.0, 1.0], &[6.12e-305]).unwrap();
    let a = evaluate(&p).unwrap();
    // I_1 = b0/(2·a0·a1), exact by halving
    assert_eq!(a.value, 3.06e-305);
    assert!(a.error_bound <= 1e-16 * a.value + 1e-323);
}
