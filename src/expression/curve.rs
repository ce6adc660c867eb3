//! The monotone cubic through knots, straight beyond them.
//!
//! # References
//! F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300: slopes by the weighted harmonic mean.

/// The value at x of the curve through (x₁, y₁), (x₂, y₂), …, given in that order; not a number where the x do not rise.
pub(super) fn curve(x: f64, knots: &[f64]) -> f64 {
    let n = knots.len() / 2;
    let (at, y) = (|k: usize| knots[2 * k], |k: usize| knots[2 * k + 1]);
    if (1..n).any(|k| at(k) <= at(k - 1)) {
        return f64::NAN;
    }
    let chord = |k: usize| (y(k + 1) - y(k)) / (at(k + 1) - at(k));
    let slope = |k: usize| {
        if k == 0 || k == n - 1 {
            return chord(k.min(n - 2));
        }
        let (a, b) = (chord(k - 1), chord(k));
        if a * b <= 0.0 {
            return 0.0;
        }
        // m = 3 (h₁ + h₂)/((2h₂ + h₁)/d₁ + (h₂ + 2h₁)/d₂)
        let (before, after) = (at(k) - at(k - 1), at(k + 1) - at(k));
        3.0 * (before + after) / ((2.0 * after + before) / a + (after + 2.0 * before) / b)
    };
    if x <= at(0) {
        return y(0) + slope(0) * (x - at(0));
    }
    if x >= at(n - 1) {
        return y(n - 1) + slope(n - 1) * (x - at(n - 1));
    }
    let k = (1..n).find(|k| x < at(*k)).unwrap_or(n - 1) - 1;
    // Hermite's cubic on [x₁, x₂]: y₁ + r (m₁ + r ((3d − 2m₁ − m₂)/h + r (m₁ + m₂ − 2d)/h²)),  r = x − x₁
    let (h, r, d) = (at(k + 1) - at(k), x - at(k), chord(k));
    let (first, last) = (slope(k), slope(k + 1));
    y(k) + r * (first + r * ((3.0 * d - 2.0 * first - last) / h + r * (first + last - 2.0 * d) / (h * h)))
}

#[cfg(test)]
mod tests {
    use super::curve;

    #[test]
    fn it_goes_through_its_knots_stays_monotone_and_is_straight_beyond() {
        let knots = [0.0, 1.0, 1.0, 2.0, 1.5, 2.0, 3.0, 8.0];
        for k in knots.chunks(2) {
            assert!((curve(k[0], &knots) - k[1]).abs() < 1e-15);
        }
        let values: Vec<f64> = (0..=3000).map(|i| curve(0.001 * f64::from(i), &knots)).collect();
        assert!(values.windows(2).all(|w| w[1] >= w[0]));
        // the level part between equal knots is level
        assert!((curve(1.2, &knots) - 2.0).abs() < 1e-15);
        let beyond = curve(5.0, &knots) - curve(4.0, &knots);
        assert!((beyond - 4.0).abs() < 1e-12 && (curve(-1.0, &knots) - 0.0).abs() < 1e-12);
    }

    #[test]
    fn knots_on_a_line_give_the_line() {
        let knots = [-2.0, -3.0, 0.5, 2.0, 1.0, 3.0, 4.0, 9.0];
        for i in -40..60 {
            let x = 0.1 * f64::from(i);
            assert!((curve(x, &knots) - (1.0 + 2.0 * x)).abs() < 1e-12);
        }
    }
}
