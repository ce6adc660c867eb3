//! Sizes: a deviation that outliers do not move, the step of a quantised signal, and how long noise
//! remembers.

/// The standard deviation of clean normal noise with this median absolute value about the median.
///
/// ```
/// use gyrospec::estimate::noise::robust_deviation;
/// // evenly spread over ±1, and one wild value
/// let mut y: Vec<f64> = (-50..=50).map(|i| f64::from(i) / 50.0).collect();
/// y[7] = 1e9;
/// assert!(robust_deviation(&y) < 1.0);
/// ```
pub fn robust_deviation(values: &[f64]) -> f64 {
    let mut kept: Vec<f64> = values.iter().copied().filter(|y| y.is_finite()).collect();
    if kept.is_empty() {
        return f64::NAN;
    }
    let centre = median(&mut kept);
    for y in &mut kept {
        *y = (*y - centre).abs();
    }
    // 1/Φ⁻¹(3/4)
    1.482_602_218_505_602 * median(&mut kept)
}

fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// The step of a quantised signal: the smallest difference between distinct values, if most
/// differences are whole multiples of it; None for a signal that is not visibly quantised.
///
/// ```
/// use gyrospec::estimate::noise::smallest_step;
/// let y: Vec<f64> = (0..200).map(|i| (f64::from(i) * 0.37).sin()).map(|y| (y * 50.0).round() / 50.0).collect();
/// assert!((smallest_step(&y).unwrap() - 0.02).abs() < 1e-9);
/// ```
pub fn smallest_step(values: &[f64]) -> Option<f64> {
    let mut kept: Vec<f64> = values.iter().copied().filter(|y| y.is_finite()).collect();
    let total = kept.len();
    kept.sort_unstable_by(f64::total_cmp);
    let range = kept.last()? - kept.first()?;
    let mut differences: Vec<f64> =
        kept.windows(2).map(|w| w[1] - w[0]).filter(|d| *d > 1e-9 * range).collect();
    if differences.is_empty() || differences.len() * 3 > total * 2 {
        return None;
    }
    let step = median(&mut differences.clone());
    differences.retain(|d| {
        let times = d / step;
        (times - times.round()).abs() > 0.05 || times.round() < 1.0
    });
    (differences.len() * 20 <= total).then_some(step)
}

/// Samples over which the noise remembers: τ = 1 + 2 Σ ρ_k while ρ_k stays above 0.05.
pub fn correlation_time(stretches: &[&[f64]]) -> f64 {
    let energy: f64 = stretches.iter().flat_map(|s| s.iter()).map(|y| y * y).sum();
    let longest = stretches.iter().map(|s| s.len()).max().unwrap_or(0);
    let count: usize = stretches.iter().map(|s| s.len()).sum();
    if energy <= 0.0 {
        return 1.0;
    }
    let (mut time, mut lag) = (1.0, 1);
    // Steps grow with the lag, so that long memories cost no more than short ones.
    while lag < longest / 2 {
        let (mut product, mut pairs) = (0.0, 0_usize);
        for s in stretches.iter().filter(|s| s.len() > lag) {
            product += s.iter().zip(&s[lag..]).map(|(a, b)| a * b).sum::<f64>();
            pairs += s.len() - lag;
        }
        let rho = product / pairs.max(1) as f64 / (energy / count as f64);
        if rho < 0.05 {
            break;
        }
        let next = lag + (lag / 8).max(1);
        time += 2.0 * rho * (next - lag) as f64;
        lag = next;
    }
    time
}

/// Means of consecutive blocks of `factor` samples; a rest shorter than a block is left out.
pub fn block_means(stretch: &[f64], factor: usize) -> Vec<f64> {
    stretch.chunks_exact(factor.max(1)).map(|c| c.iter().sum::<f64>() / c.len() as f64).collect()
}
