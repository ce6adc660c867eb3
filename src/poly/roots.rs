//! Roots of real polynomials in floating point.
//!
//! # Purpose
//! Pole positions for splitting a quadrature and for telling a user what a filter does. No
//! decision about stability rests on them.
//!
//! # Method
//! Aberth's simultaneous iteration from starting points on the Newton polygon of log |a_i|
//! (Bini), which keeps roots of very different size apart.
//!
//! # References
//! O. Aberth, Math. Comp. 27 (1973) 339; D. A. Bini, Numer. Algorithms 13 (1996) 179.
//!
//! # Numerical aspects
//! Coefficients are scaled by powers of two in time and gain first. The iteration stops when all
//! corrections fall below 4 ulp of the root or after 200 rounds; multiple roots come out with the
//! usual loss of half or more of the digits.

use num_complex::Complex64;

/// The n roots of a polynomial, descending coefficients, `h[0]` ≠ 0 and all finite.
///
/// ```
/// let mut r = gyrospec::poly::roots::roots(&[1.0, 3.0, 2.0]);
/// r.sort_by(|a, b| a.re.total_cmp(&b.re));
/// assert!((r[0].re + 2.0).abs() < 1e-14 && (r[1].re + 1.0).abs() < 1e-14);
/// ```
pub fn roots(h: &[f64]) -> Vec<Complex64> {
    let zeros = h.iter().rev().take_while(|a| **a == 0.0).count();
    let h = &h[..h.len() - zeros];
    let mut found = match h.len() {
        0 | 1 => Vec::new(),
        2 => vec![Complex64::new(-h[1] / h[0], 0.0)],
        _ => aberth(h),
    };
    found.extend(std::iter::repeat_n(Complex64::ZERO, zeros));
    found
}

fn aberth(h: &[f64]) -> Vec<Complex64> {
    let mut z = starts(h);
    let n = z.len();
    let mut moving = vec![true; n];
    for _ in 0..200 {
        for i in 0..n {
            if !moving[i] {
                continue;
            }
            let Some(newton) = newton_step(h, z[i]) else {
                moving[i] = false;
                continue;
            };
            let repulsion: Complex64 =
                (0..n).filter(|&j| j != i).map(|j| (z[i] - z[j]).inv()).filter(|r| r.is_finite()).sum();
            // Δz = N/(1 − N·Σ 1/(z_i − z_j)),  N = p/p\u2032
            let step = newton / (Complex64::ONE - newton * repulsion);
            if !step.is_finite() {
                continue;
            }
            z[i] -= step;
            moving[i] = step.norm() > 4.0 * f64::EPSILON * z[i].norm();
        }
        if !moving.contains(&true) {
            break;
        }
    }
    z
}

/// p/p′ at z by Horner's rule, from the reversed polynomial outside the unit circle so that
/// nothing overflows; nothing where p vanishes to rounding.
fn newton_step(h: &[f64], z: Complex64) -> Option<Complex64> {
    let n = (h.len() - 1) as f64;
    let inside = z.norm() <= 1.0;
    let x = if inside { z } else { z.inv() };
    let (mut p, mut slope, mut size) = (Complex64::ZERO, Complex64::ZERO, 0.0);
    let r = x.norm();
    let mut horner = |a: f64| {
        slope = slope * x + p;
        p = p * x + a;
        size = size * r + a.abs();
    };
    if inside {
        for &a in h {
            horner(a);
        }
    } else {
        for &a in h.iter().rev() {
            horner(a);
        }
    }
    if p.norm() <= size * f64::EPSILON {
        return None;
    }
    let newton = p / slope;
    // q(x) = xⁿ·p(1/x):  p/p′ at z = 1/(x·(n − x·q′/q))
    Some(if inside { newton } else { (x * (Complex64::from(n) - x / newton)).inv() })
}

/// Points on circles whose radii are the slopes of the upper hull of (i, log|a_i|).
fn starts(h: &[f64]) -> Vec<Complex64> {
    let n = h.len() - 1;
    let points: Vec<(f64, f64)> =
        h.iter().enumerate().filter(|(_, a)| **a != 0.0).map(|(i, a)| (i as f64, a.abs().ln())).collect();
    let mut hull: Vec<(f64, f64)> = Vec::new();
    for p in points {
        while let [.., a, b] = hull[..] {
            if (b.1 - a.1) * (p.0 - a.0) > (p.1 - a.1) * (b.0 - a.0) {
                break;
            }
            hull.pop();
        }
        hull.push(p);
    }
    let mut z = Vec::with_capacity(n);
    for pair in hull.windows(2) {
        let count = (pair[1].0 - pair[0].0) as usize;
        let radius = ((pair[1].1 - pair[0].1) / count as f64).exp();
        for k in 0..count {
            let angle = std::f64::consts::TAU * k as f64 / count as f64 + 0.7 + 0.3 * z.len() as f64;
            z.push(Complex64::from_polar(radius, angle));
        }
    }
    z
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_over_eight_decades_are_found() {
        let places: Vec<f64> = (0..9).map(|k| -(10f64.powi(k - 4))).collect();
        let h = places.iter().fold(vec![1.0], |h, r| crate::poly::product(&h, &[1.0, -r]));
        let mut found = roots(&h);
        found.sort_by(|a, b| b.re.total_cmp(&a.re));
        for (z, r) in found.iter().zip(&places) {
            assert!((z - r).norm() < 1e-12 * r.abs(), "{z} for {r}");
        }
    }

    #[test]
    fn a_lightly_damped_pair_keeps_its_damping() {
        // damping 1e-6: real part −1e-6, known to the condition of the coefficients
        let h = crate::poly::product(&[1.0, 2e-6, 1.0], &[1.0, 3.0]);
        let pair = roots(&h).into_iter().filter(|z| z.im.abs() > 0.5).collect::<Vec<_>>();
        assert_eq!(pair.len(), 2);
        assert!(pair.iter().all(|z| (z.re + 1e-6).abs() < 1e-14));
    }
}
