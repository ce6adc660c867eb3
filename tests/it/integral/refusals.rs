//! Where there is no value: decided exactly, and where others answer wrongly without a word.

use gyrospec::integral::{Integrand, evaluate, evaluate_fast};
use gyrospec::{Error, ErrorKind};

fn white(h: &[f64]) -> Result<f64, Error> {
    let mut g = vec![0.0; h.len() - 1];
    *g.last_mut().unwrap() = 1.0;
    let p = Integrand::new(h, &g)?;
    let (a, b) = (evaluate(&p), evaluate_fast(&p));
    assert_eq!(a.as_ref().map_err(Error::kind).err(), b.as_ref().map_err(Error::kind).err());
    a.map(|a| a.value)
}

#[test]
fn what_peers_get_wrong_in_silence_is_right_here() {
    // a Lyapunov route returns −4.5e15 for this stable filter: w = 1e-6, damping 0.005
    let w = 1e-6;
    let h = [1.0, 2.0 * 0.005 * w, w * w];
    // I_2 = 1/(2·a1·a2)
    approx::assert_ulps_eq!(white(&h).unwrap(), 1.0 / (2.0 * h[1] * h[2]), max_ulps = 2);
    // and −2.5 for this unstable one
    let e = white(&[1.0, -0.2, 1.0]).unwrap_err();
    assert_eq!((e.kind(), e.right_half_plane_roots()), (ErrorKind::Unstable, Some(2)));
    // infinity for any pole slower than 1e-8 rad/s
    approx::assert_ulps_eq!(white(&[1.0, 1e-9]).unwrap(), 0.5e9, max_ulps = 2);
    // nothing for data scaled by 1e-9
    approx::assert_ulps_eq!(white(&[1e-9, 2e-9, 3e-9]).unwrap(), 1.0 / (2.0 * 2e-9 * 3e-9), max_ulps = 2);
}

#[test]
fn stability_is_decided_without_a_threshold() {
    let next = |x: f64| f64::from_bits(x.to_bits() + 1);
    // s³ + s² + s + 1 = (s + 1)(s² + 1); one last bit either way decides
    assert_eq!(white(&[1.0, 1.0, 1.0, 1.0]).unwrap_err().kind(), ErrorKind::ImaginaryAxis);
    assert!(white(&[1.0, 1.0, next(1.0), 1.0]).is_ok());
    let e = white(&[1.0, 1.0, 1.0, next(1.0)]).unwrap_err();
    assert_eq!((e.kind(), e.right_half_plane_roots()), (ErrorKind::Unstable, Some(2)));
    // a root at 0, and unstable wins where both hold
    assert_eq!(white(&[1.0, 1.0, 0.0]).unwrap_err().kind(), ErrorKind::ImaginaryAxis);
    assert_eq!(white(&[1.0, -1.0, 0.0]).unwrap_err().kind(), ErrorKind::Unstable);
}

#[test]
fn values_outside_the_doubles_are_said_in_decimal() {
    let e = white(&[1e-200, 1e-200]).unwrap_err();
    assert_eq!((e.kind(), e.decimal()), (ErrorKind::OutOfRange, Some("5.00e+399")));
    let e = white(&[1e200, 1e200]).unwrap_err();
    assert_eq!((e.kind(), e.decimal()), (ErrorKind::OutOfRange, Some("5.00e-401")));
}

#[test]
fn extreme_but_finite_coefficients_are_answered() {
    let tiny = 5e-324;
    // I_1 = 1/(2·a0·a1)
    approx::assert_ulps_eq!(white(&[tiny, 1e300]).unwrap(), 0.5 / 1e300 / tiny, max_ulps = 4);
    approx::assert_ulps_eq!(white(&[1e308, 1e-308]).unwrap(), 0.5, max_ulps = 2);
    assert!(white(&[f64::MAX, f64::MAX, f64::MAX]).is_err());
    let mut h = vec![1.0];
    for _ in 0..200 {
        h = gyrospec::poly::product(&h, &[1.0, 1.0]);
    }
    // (s + 1)²⁰⁰ with its coefficients rounded: no longer stable, and said so
    assert_eq!(white(&h).unwrap_err().kind(), ErrorKind::Unstable);
}

#[test]
fn bad_input_is_named() {
    for (h, g) in [
        (&[][..], &[][..]),
        (&[1.0], &[]),
        (&[0.0, 1.0], &[1.0]),
        (&[1.0, f64::NAN], &[1.0]),
        (&[1.0, 1.0], &[f64::INFINITY]),
        (&[1.0, 1.0], &[1.0, 2.0]),
    ] {
        assert_eq!(Integrand::new(h, g).unwrap_err().kind(), ErrorKind::BadInput);
    }
    let long = vec![1.0; 1_000_001];
    assert_eq!(Integrand::new(&long, &long[1..]).unwrap_err().kind(), ErrorKind::BadInput);
    assert!(Integrand::from_square(&[1.0, 1.0], &[]).is_err());
    assert!(Integrand::from_square(&[1.0, 1.0], &[1.0, 2.0]).is_err());
}
