//! Covariances and cross moments against closed forms and against each other.

use approx::assert_relative_eq;
use faer::Mat;
use gyrospec::ErrorKind;
use gyrospec::lti::{StateSpace, TransferFunction, cross_moment, stationary_covariance};
use num_complex::Complex64;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn filter(numerator: &[f64], denominator: &[f64]) -> TransferFunction {
    TransferFunction::new(numerator, denominator).unwrap()
}

/// A random stable filter of order n from its poles, time constants over `decades`.
fn random_filter(rng: &mut ChaCha8Rng, n: usize, decades: f64) -> TransferFunction {
    let mut made = TransferFunction::constant(1.0);
    while made.order() < n {
        let w = 10f64.powf(decades * (rng.random::<f64>() - 0.5));
        let next = if n - made.order() >= 2 && rng.random::<bool>() {
            filter(&[w * w], &[1.0, 2.0 * rng.random_range(0.05..1.0) * w, w * w])
        } else {
            filter(&[w], &[1.0, w])
        };
        made = made.then(&next);
    }
    made
}

#[test]
fn covariance_of_a_filter_is_its_spectral_integral() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let one = TransferFunction::constant(1.0);
    for case in 0..200 {
        let w = random_filter(&mut rng, 1 + case % 8, 2.0);
        let by_state = StateSpace::from_transfer(&w).output_covariance().unwrap()[(0, 0)];
        let by_integral = cross_moment(&one, &w, &w).unwrap().value;
        assert_relative_eq!(by_state, by_integral, max_relative = 1e-8);
    }
}

#[test]
fn cross_moment_is_the_output_covariance_of_both_filters_side_by_side() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    for case in 0..50 {
        let shaping = random_filter(&mut rng, 2, 1.0);
        let (w1, w2) = (random_filter(&mut rng, 1 + case % 3, 1.0), random_filter(&mut rng, 2, 1.0));
        let (s1, s2) = (StateSpace::from_transfer(&w1), StateSpace::from_transfer(&w2));
        let (n1, n2) = (s1.order(), s2.order());
        let both = StateSpace::new(
            Mat::from_fn(n1 + n2, n1 + n2, |i, j| match (i < n1, j < n1) {
                (true, true) => s1.a[(i, j)],
                (false, false) => s2.a[(i - n1, j - n1)],
                _ => 0.0,
            }),
            Mat::from_fn(n1 + n2, 1, |i, _| if i < n1 { s1.b[(i, 0)] } else { s2.b[(i - n1, 0)] }),
            Mat::from_fn(2, n1 + n2, |k, j| match (k, j < n1) {
                (0, true) => s1.c[(0, j)],
                (1, false) => s2.c[(0, j - n1)],
                _ => 0.0,
            }),
            Mat::zeros(2, 1),
        )
        .unwrap();
        let joint = StateSpace::from_transfer(&shaping).then(&both).unwrap();
        let covariance = joint.output_covariance().unwrap();
        let size = (covariance[(0, 0)] * covariance[(1, 1)]).sqrt();
        let by_integral = cross_moment(&shaping, &w1, &w2).unwrap().value;
        assert!((covariance[(0, 1)] - by_integral).abs() < 1e-9 * size, "case {case}");
    }
}

#[test]
fn covariance_holds_over_eight_decades_of_time_constants() {
    // independent lags beside each other: each variance is q/(2λ), each cross term q₁₂/(λ₁ + λ₂)
    let rates = [1e-4, 1e-2, 1.0, 1e2, 1e4];
    let a = Mat::from_fn(5, 5, |i, j| if i == j { -rates[i] } else { 0.0 });
    let q = Mat::from_fn(5, 5, |_, _| 1.0);
    let x = stationary_covariance(&a, &q).unwrap();
    for i in 0..5 {
        for j in 0..5 {
            assert_relative_eq!(x.matrix[(i, j)], 1.0 / (rates[i] + rates[j]), max_relative = 1e-11);
        }
    }
}

#[test]
fn covariance_refuses_what_has_none() {
    let one = Mat::from_fn(2, 2, |i, j| f64::from(u8::from(i == j)));
    let kind = |a: Mat<f64>| stationary_covariance(&a, &one).unwrap_err().kind();
    assert_eq!(kind(faer::mat![[0.0, 1.0], [-1.0, 0.2]]), ErrorKind::Unstable);
    assert_eq!(kind(faer::mat![[0.0, 1.0], [-1.0, 0.0]]), ErrorKind::ImaginaryAxis);
    assert_eq!(kind(faer::mat![[0.0, 1.0], [0.0, -1.0]]), ErrorKind::ImaginaryAxis);
    assert_eq!(kind(faer::mat![[f64::NAN, 1.0], [0.0, -1.0]]), ErrorKind::BadInput);
}

#[test]
fn both_signals_white_is_refused_and_one_white_is_the_mean_of_both_sides() {
    let one = TransferFunction::constant(1.0);
    let lag = filter(&[1.0], &[0.5, 1.0]);
    let direct = filter(&[1.0, 3.0], &[1.0, 1.0]);
    assert_eq!(cross_moment(&one, &direct, &direct).unwrap_err().kind(), ErrorKind::OutOfRange);
    // ⟨w · lagged w⟩: the correlation jumps from 0 to 1/T at zero lag; the mean is 1/(2T)
    assert_relative_eq!(cross_moment(&one, &one, &lag).unwrap().value, 1.0, max_relative = 1e-14);
}

#[test]
fn realisation_and_transfer_function_agree_at_complex_frequencies() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    for n in 1..7 {
        let w = random_filter(&mut rng, n, 1.0).beside(&TransferFunction::constant(0.25));
        let system = StateSpace::from_transfer(&w);
        for omega in [0.0, 0.3, 2.0] {
            let s = Complex64::new(0.1, omega);
            let (direct, realised) = (w.at(s), system.at(s)[(0, 0)]);
            assert!((direct.re - realised.re).hypot(direct.im - realised.im) < 1e-12 * direct.norm());
        }
    }
}
