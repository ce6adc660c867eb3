//! Mean products of two filtered signals against partial fractions in rationals, closed forms and refusals.

use crate::integral::crossed::{Crossed, case, exactly};
use crate::integral::families::FAMILIES;
use approx::assert_relative_eq;
use dashu_ratio::RBig;
use gyrospec::ErrorKind;
use gyrospec::exact::rational;
use gyrospec::lti::{TransferFunction, cross_moment, cross_rate_moment};

fn filter(numerator: &[f64], denominator: &[f64]) -> TransferFunction {
    TransferFunction::new(numerator, denominator).unwrap()
}

#[test]
fn no_bound_is_broken_beside_partial_fractions_in_rationals() {
    let mut compared = 0;
    for seed in 0..200u64 {
        let x = case(FAMILIES[seed as usize % 4], seed);
        let Crossed { shaping, first, second, rate } = &x;
        let answer = if *rate {
            cross_rate_moment(shaping, first, second)
        } else {
            cross_moment(shaping, first, second)
        };
        let Some(truth) = exactly(&x) else {
            assert_eq!(answer.unwrap_err().kind(), ErrorKind::OutOfRange, "{x:?}");
            continue;
        };
        let answer = answer.unwrap();
        let error = rational(answer.value) - &truth;
        let error = if error < RBig::ZERO { -error } else { error };
        assert!(error <= rational(answer.error_bound), "{x:?}: {answer:?}");
        assert!(answer.error_bound <= 1.2e-16 * answer.value.abs(), "{x:?}: {answer:?}");
        compared += 1;
    }
    assert!(compared > 150, "{compared}");
}

#[test]
fn a_rounded_product_breaks_the_bound_that_exact_products_keep() {
    // (s + 1/3)³ and (s + 1/7)² leave more than 53 bits in their products
    let lag = |rate: f64| filter(&[1.0], &[1.0, rate]);
    let (first, second) = (lag(1.0 / 3.0).then(&lag(0.1)), lag(1.0 / 7.0));
    let shaping = lag(0.7).then(&lag(1.0 / 3.0));
    let x = Crossed { shaping, first, second, rate: true };
    let truth = exactly(&x).unwrap();
    let answer = cross_rate_moment(&x.shaping, &x.first, &x.second).unwrap();
    let off = |value: f64, bound: f64| {
        let error = rational(value) - &truth;
        (if error < RBig::ZERO { -error } else { error }) > rational(bound)
    };
    assert!(!off(answer.value, answer.error_bound));
    let rate = x.second.differentiated().unwrap();
    let rounded = gyrospec::lti::cross_integrand(&x.shaping, &x.first, &rate).unwrap();
    let p = gyrospec::Integrand::new(&rounded.h, &rounded.g).unwrap();
    let plain = gyrospec::evaluate(&p).unwrap();
    assert!(off(plain.value, plain.error_bound), "{plain:?} {answer:?}");
}

#[test]
fn a_pair_of_filters_in_quadrature_turns_at_half_the_product_of_amplitudes() {
    // x = resonance, y = (s − ω)/(s + ω)·x behind it: ⟨x ẏ⟩ → σ²ω as the damping goes to 0
    let one = TransferFunction::constant(1.0);
    let w = 188.0_f64;
    let mut before = f64::INFINITY;
    for zeta in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5] {
        let x = filter(&[(4.0 * zeta * w * w * w).sqrt()], &[1.0, 2.0 * zeta * w, w * w]);
        let y = x.then(&filter(&[-1.0, w], &[1.0, w]));
        let rate = cross_rate_moment(&one, &x, &y).unwrap().value;
        let off = (rate / w - 1.0).abs();
        assert!(off < 2.0 * zeta && off < before, "{zeta}: {off}");
        before = off;
        // the same the other way round, and none of a signal with itself
        assert_eq!(cross_rate_moment(&one, &y, &x).unwrap().value, -rate);
        assert_eq!(cross_rate_moment(&one, &x, &x).unwrap().value, 0.0);
    }
}

#[test]
fn a_condition_tells_what_a_changed_coefficient_does() {
    // ⟨x²⟩ = 1/(2·c·k) of s² + c s + k: each coefficient of H and G counts once, a0 not at all
    let x = filter(&[1.0], &[1.0, 0.25, 3.0]);
    let answer = x.variance().unwrap();
    assert_relative_eq!(answer.value, 1.0 / 1.5, max_relative = 1e-15);
    assert_relative_eq!(answer.condition, 3.0, max_relative = 1e-12);
    // in any time: s = 2²⁰ s′
    let t = 20f64.exp2();
    let slow = filter(&[1.0], &[t * t, 0.25 * t, 3.0]);
    assert_relative_eq!(slow.variance().unwrap().condition, 3.0, max_relative = 1e-12);
}

#[test]
fn what_has_no_mean_is_refused_with_its_reason() {
    let one = TransferFunction::constant(1.0);
    let lag = filter(&[1.0], &[1.0, 1.0]);
    let refused = |a: &TransferFunction, b: &TransferFunction, word: &str| {
        let e = cross_rate_moment(&one, a, b).unwrap_err();
        assert!(e.kind() == ErrorKind::OutOfRange && e.to_string().contains(word), "{e}");
    };
    refused(&one, &one, "which has no rate");
    refused(&one, &lag, "the rate of the other too");
    refused(&lag, &one, "the rate of the other too");
    let growing = filter(&[1.0], &[1.0, -1.0, 1.0]);
    assert_eq!(cross_rate_moment(&one, &growing, &lag).unwrap_err().kind(), ErrorKind::Unstable);
    let swinging = filter(&[1.0], &[1.0, 0.0, 1.0]);
    assert_eq!(cross_rate_moment(&one, &swinging, &lag).unwrap_err().kind(), ErrorKind::ImaginaryAxis);
    // a signal that is zero, or two without poles, leave nothing
    assert_eq!(cross_rate_moment(&one, &TransferFunction::constant(0.0), &lag).unwrap().value, 0.0);
    assert_eq!(cross_moment(&one, &TransferFunction::constant(0.0), &one).unwrap().value, 0.0);
}
