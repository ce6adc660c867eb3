//! The bilinear surface through the knots of a grid, straight beyond them.

/// The value at (x, y) of the surface through knots: n places along x, m along y, and m values at each place along x, in
/// that order; not a number where places do not rise.
pub(super) fn surface([x, y]: [f64; 2], n: usize, knots: &[f64]) -> f64 {
    if n < 2 || knots.len() < n {
        return f64::NAN;
    }
    let (along, rest) = knots.split_at(n);
    // m places and n·m values are left
    let (across, z) = rest.split_at(rest.len() / (n + 1));
    let m = across.len();
    let rises = |places: &[f64]| places.windows(2).all(|w| w[0] < w[1]);
    if m < 2 || !rises(along) || !rises(across) {
        return f64::NAN;
    }
    let cell = |places: &[f64], at: f64| places[1..places.len() - 1].iter().filter(|p| at > **p).count();
    let (i, j) = (cell(along, x), cell(across, y));
    let line = |j: usize| {
        let (low, high) = (z[i * m + j], z[(i + 1) * m + j]);
        low + (x - along[i]) * (high - low) / (along[i + 1] - along[i])
    };
    line(j) + (y - across[j]) * (line(j + 1) - line(j)) / (across[j + 1] - across[j])
}

#[cfg(test)]
mod tests {
    use super::surface;

    const PLACES: [f64; 7] = [-1.0, 0.5, 2.0, 4.0, 0.0, 1.0, 3.0];

    fn of(z: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let (along, across) = PLACES.split_at(4);
        PLACES.iter().copied().chain(along.iter().flat_map(|x| across.iter().map(|y| z(*x, *y)))).collect()
    }

    #[test]
    fn knots_of_a_bilinear_law_give_that_law_everywhere() {
        let law = |x: f64, y: f64| 1.0 + 2.0 * x - 3.0 * y + 0.5 * x * y;
        let knots = of(law);
        for i in -30..60 {
            for j in -20..50 {
                let (x, y) = (0.1 * f64::from(i), 0.1 * f64::from(j));
                assert!((surface([x, y], 4, &knots) - law(x, y)).abs() < 1e-12, "{x} {y}");
            }
        }
    }

    #[test]
    fn it_goes_through_its_knots_without_a_leap() {
        let law = |x: f64, y: f64| (x * 1.7).sin() + (y * 2.3).cos();
        let knots = of(law);
        for x in &PLACES[..4] {
            for y in &PLACES[4..] {
                assert!((surface([*x, *y], 4, &knots) - law(*x, *y)).abs() < 1e-14);
            }
        }
        let values: Vec<f64> =
            (-2000..5000).map(|k| surface([0.001 * f64::from(k), 0.7], 4, &knots)).collect();
        assert!(values.windows(2).all(|w| (w[1] - w[0]).abs() < 0.005));
        assert!(surface([0.0, 0.0], 2, &[1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0]).is_nan());
    }
}
