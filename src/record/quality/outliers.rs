//! Purpose: single samples that belong to no motion.
//!
//! Method: a sample's distance from the median of its four neighbours, against what is usual in
//! this channel: the larger of the spread by the median absolute deviation, the spread by the
//! 97th percentile (which grows where pulses are the channel's nature), the quantum, and the 80th
//! percentile nearby (which grows where the motion is fast just there). It must be twelve times
//! that, the sample must stand out to one side from both neighbours, and these must agree among
//! themselves.
//!
//! References: P. J. Huber, E. M. Ronchetti, Robust Statistics, 2nd ed. (2009).

use super::{Fault, FaultKind, quantile, quantum};
use crate::record::{Channel, Span};

const FAR: f64 = 12.0;
/// Of the normal distribution: median and 97th percentile of |x|.
const NORMAL_MEDIAN: f64 = 0.6745;
const NORMAL_97: f64 = 2.170;
const NORMAL_80: f64 = 1.282;
/// Samples to each side that count as nearby.
const NEARBY: usize = 30;
/// Neighbours may differ by this share of the outlier's distance.
const NEIGHBOURS_AGREE: f64 = 0.3;
const FEWEST_SAMPLES: usize = 30;
/// More than one sample in so many are the channel's nature.
const MOST: usize = 20;

/// Samples far off; each span is one sample; `size` is the largest distance, SI.
pub fn outliers(channel: &Channel) -> Option<Fault> {
    let samples: Vec<(f64, f64)> = channel.samples().collect();
    if samples.len() < FEWEST_SAMPLES {
        return None;
    }
    let distances: Vec<f64> = samples.windows(5).map(distance).collect();
    let mut sizes: Vec<f64> = distances.iter().map(|d| d.abs()).collect();
    let spread = (quantile(&mut sizes, 0.5)? / NORMAL_MEDIAN)
        .max(quantile(&mut sizes, 0.97)? / NORMAL_97)
        .max(quantum(channel).unwrap_or(0.0));
    if spread == 0.0 {
        return None;
    }
    let far = |i: &usize| {
        let (w, d) = (&samples[*i..*i + 5], distances[*i]);
        d.abs() > FAR * spread && stands_out(w, d) && d.abs() > FAR * nearby(&distances, *i)
    };
    let found: Vec<(f64, f64)> =
        (0..distances.len()).filter(far).map(|i| (samples[i + 2].0, distances[i])).collect();
    if found.is_empty() || found.len() > samples.len() / MOST {
        return None;
    }
    let size = found.iter().map(|f| f.1.abs()).fold(0.0, f64::max);
    let spans = found.iter().map(|f| Span::new(f.0, f.0)).collect();
    Some(Fault { samples: found.len(), size, ..Fault::of(FaultKind::Outliers, channel, spans) })
}

/// The usual distance nearby.
fn nearby(distances: &[f64], at: usize) -> f64 {
    let around = &distances[at.saturating_sub(NEARBY)..(at + NEARBY).min(distances.len())];
    let mut sizes: Vec<f64> = around.iter().map(|d| d.abs()).collect();
    quantile(&mut sizes, 0.8).unwrap_or(0.0) / NORMAL_80
}

/// x₂ − median(x₀, x₁, x₃, x₄)
fn distance(w: &[(f64, f64)]) -> f64 {
    let mut four = [w[0].1, w[1].1, w[3].1, w[4].1];
    four.sort_unstable_by(f64::total_cmp);
    w[2].1 - 0.5 * (four[1] + four[2])
}

fn stands_out(w: &[(f64, f64)], distance: f64) -> bool {
    let (before, after) = (w[2].1 - w[1].1, w[2].1 - w[3].1);
    before * after > 0.0 && (before - after).abs() < NEIGHBOURS_AGREE * distance.abs()
}
