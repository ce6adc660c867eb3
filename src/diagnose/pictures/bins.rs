//! Means of samples along a signal.

/// A sample: its signal, its value, and the number of its row in time.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    /// The signal.
    pub x: f64,
    /// The value.
    pub y: f64,
    /// Standard deviation of a fitted value, 0 for a measured one.
    pub deviation: f64,
    /// Row in time.
    pub row: usize,
}

/// Share of derivatives that is left out at both ends: the wildest stand at the ends of a stretch, and would hide the
/// law.
pub const WILD: f64 = 0.01;

/// The least and the greatest of the finite values that are left without a share at both ends.
pub fn between(values: impl Iterator<Item = f64>, share: f64) -> (f64, f64) {
    let mut order: Vec<f64> = values.filter(|v| v.is_finite()).collect();
    order.sort_unstable_by(f64::total_cmp);
    let cut = (share * order.len() as f64) as usize;
    order.get(cut).map_or((f64::NAN, f64::NAN), |low| (*low, order[order.len() - 1 - cut]))
}

/// Means in bins of equal width between the outer half per cents of the signal.
///
/// The 95 % band of a mean comes from the scatter of the visits to its bin: samples that follow each
/// other in time are one visit, as they are not independent.
pub fn means(samples: &[Sample], bins: usize) -> Vec<[f64; 4]> {
    let of = |visits: &[(f64, f64)]| -> f64 {
        let n = visits.len() as f64;
        let weight: f64 = visits.iter().map(|v| v.1).sum();
        let mean = visits.iter().map(|v| v.0 * v.1).sum::<f64>() / weight;
        // s² = Σ w²(ȳ_v − ȳ)² / (Σ w)² · n/(n − 1)
        let square: f64 = visits.iter().map(|v| (v.1 * (v.0 - mean) / weight).powi(2)).sum();
        1.96 * (square * n / (n - 1.0).max(1.0)).sqrt()
    };
    binned(samples, bins)
        .into_iter()
        .map(|own| {
            let (x, y, _) = mean(&own);
            let half = of(&visits(&own));
            [x, y, y - half, y + half]
        })
        .collect()
}

/// The fitted curve: means of fitted values with 1.96 of their own deviations.
pub fn curve(samples: &[Sample], bins: usize) -> Vec<[f64; 4]> {
    let point = |own: Vec<Sample>| {
        let (x, y, deviation) = mean(&own);
        [x, y, y - 1.96 * deviation, y + 1.96 * deviation]
    };
    binned(samples, bins).into_iter().map(point).collect()
}

fn mean(own: &[Sample]) -> (f64, f64, f64) {
    let n = own.len() as f64;
    let of = |f: fn(&Sample) -> f64| own.iter().map(f).sum::<f64>() / n;
    (of(|s| s.x), of(|s| s.y), of(|s| s.deviation))
}

/// Mean and number of samples of each visit.
fn visits(own: &[Sample]) -> Vec<(f64, f64)> {
    let mut all: Vec<(f64, f64)> = Vec::new();
    let mut last = None;
    for s in own {
        match all.last_mut() {
            Some(v) if last.is_some_and(|l| s.row <= l + 1) => {
                v.0 = (v.0 * v.1 + s.y) / (v.1 + 1.0);
                v.1 += 1.0;
            }
            _ => all.push((s.y, 1.0)),
        }
        last = Some(s.row);
    }
    all
}

/// Samples of each bin, in order of time; empty bins are left out.
fn binned(samples: &[Sample], bins: usize) -> Vec<Vec<Sample>> {
    let (low, high) = between(samples.iter().map(|s| s.x), 0.005);
    let width = (high - low) / bins as f64;
    let mut all = vec![Vec::new(); bins];
    for s in samples.iter().filter(|s| s.x >= low && s.x <= high && s.y.is_finite()) {
        let at = if width > 0.0 { ((s.x - low) / width) as usize } else { 0 };
        all[at.min(bins - 1)].push(*s);
    }
    all.retain(|b| !b.is_empty());
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_wildest_are_left_out_at_both_ends() {
        let of = |share: f64| between((0..=200).map(f64::from).chain([f64::NAN]), share);
        assert_eq!((of(0.0), of(0.01)), ((0.0, 200.0), (2.0, 198.0)));
        assert!(between([f64::NAN].into_iter(), 0.0).0.is_nan() && means(&[], 3).is_empty());
    }

    #[test]
    fn the_mean_of_a_sign_is_a_step() {
        let at = |i: usize| (i as f64 * 0.01).sin();
        let sample = |i: usize| Sample { x: at(i), y: 3.0 * at(i).signum(), deviation: 0.1, row: i };
        let samples: Vec<Sample> = (0..20_000).map(sample).collect();
        let all = means(&samples, 20);
        assert!(all.first().is_some_and(|m| (m[1] + 3.0).abs() < 1e-9));
        assert!(all.last().is_some_and(|m| (m[1] - 3.0).abs() < 1e-9));
        let band = curve(&samples, 20)[0];
        assert!((band[3] - band[2] - 0.392).abs() < 1e-9);
    }
}
