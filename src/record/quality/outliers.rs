//! Purpose: single samples that belong to no motion.
//!
//! Method: a sample's distance from the median of its four neighbours, against what is usual in
//! this channel: the larger of the spread by the median absolute deviation, the spread by the
//! 97th percentile (which grows where pulses are the channel's nature), the quantum, and the 80th
//! percentile nearby (which grows where the motion is fast just there). It must be twelve times
//! that, the sample must stand out by as much from both neighbours, and these must agree among
//! themselves: the top of a smooth peak stands two fifths of that distance above its neighbours.
//!
//! An angle that jumps by a turn is unwrapped before: noise about north is none.
//!
//! A number that loggers write where nothing was measured, far off all others, is one at any share.
//!
//! References: P. J. Huber, E. M. Ronchetti, Robust Statistics, 2nd ed. (2009).

use super::{Fault, FaultKind, Samples, ends, quantile, quantum, wrapped_angle};
use crate::record::wrap::unwrap;
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
/// Share of the distance by which a sample stands out from each neighbour at least.
const ALONE: f64 = 0.7;
const FEWEST_SAMPLES: usize = 30;
/// More than one sample in so many are the channel's nature.
const MOST: usize = 20;

/// Samples far off; each span is one sample; `size` is the largest distance, SI.
pub fn outliers(channel: &Channel) -> Option<Fault> {
    let Samples { time, mut values } = Samples::of(channel);
    if values.len() < FEWEST_SAMPLES {
        return None;
    }
    if let Some(coded) = any_coded(channel, (&time, &values)) {
        return Some(coded);
    }
    if wrapped_angle(channel).is_some() {
        unwrap(values.to_mut());
    }
    let sizes = || values.windows(5).map(|w| distance(w).abs());
    let spread = (quantile(sizes(), 0.5)? / NORMAL_MEDIAN)
        .max(quantile(sizes(), 0.97)? / NORMAL_97)
        .max(quantum(channel).unwrap_or(0.0));
    if spread == 0.0 {
        return None;
    }
    let far = |(i, w): &(usize, &[f64])| {
        let d = distance(w).abs();
        d > FAR * spread && stands_out(w, d) && d > FAR * nearby(&values, *i)
    };
    let found: Vec<(f64, f64)> = values
        .windows(5)
        .enumerate()
        .filter(far)
        .map(|(i, w)| (time[i + 2], distance(w)))
        .take(values.len() / MOST + 1)
        .collect();
    if found.is_empty() || found.len() > values.len() / MOST {
        return None;
    }
    let size = found.iter().map(|f| f.1.abs()).fold(0.0, f64::max);
    let spans = found.iter().map(|f| Span::new(f.0, f.0)).collect();
    Some(Fault { samples: found.len(), size, ..Fault::of(FaultKind::Outliers, channel, spans) })
}

/// Numbers that loggers write where nothing was measured.
const CODES: [f64; 16] = [
    -9999.0,
    -999.0,
    -999.25,
    -99_999.0,
    -999_999.0,
    9999.0,
    99_999.0,
    999_999.0,
    -32_768.0,
    1e20,
    -1e20,
    1e30,
    -1e30,
    1e36,
    f64::MAX,
    -f64::MAX,
];
/// Times the range of all other samples that such a number lies off it.
const OFF: f64 = 10.0;
/// Share of the samples that must be others.
const OTHERS: f64 = 0.1;

/// Samples with a number that stands for none, as far as it lies off all others: no command is that either.
pub fn coded_outliers(channel: &Channel) -> Option<Fault> {
    let Samples { time, values } = Samples::of(channel);
    if values.len() < FEWEST_SAMPLES { None } else { any_coded(channel, (&time, &values)) }
}

fn any_coded(channel: &Channel, samples: (&[f64], &[f64])) -> Option<Fault> {
    CODES.iter().find_map(|code| coded(channel, samples, *code))
}

/// The samples that have such a number, at any share, far off all others.
fn coded(channel: &Channel, (time, values): (&[f64], &[f64]), code: f64) -> Option<Fault> {
    let is_code = |v: &f64| (channel.unit.from_si(*v) - code).abs() <= 1e-9 * code.abs();
    if !values.iter().any(is_code) {
        return None;
    }
    // a level that a machine is set to is held
    if code > 0.0 && values.windows(3).any(|w| w.iter().all(is_code)) {
        return None;
    }
    let others: Vec<f64> = values.iter().copied().filter(|v| !is_code(v)).collect();
    let (low, high) = ends(&others);
    let at = channel.unit.to_si(code);
    let off = (low - at).max(at - high);
    let is_off = high > low && off > OFF * (high - low);
    if !is_off || (others.len() as f64) < OTHERS * values.len() as f64 {
        return None;
    }
    let coded = time.iter().zip(values).filter(|(_, v)| is_code(v));
    let spans: Vec<Span> = coded.map(|(t, _)| Span::new(*t, *t)).collect();
    Some(Fault { samples: spans.len(), size: off, ..Fault::of(FaultKind::Outliers, channel, spans) })
}

/// The usual distance near the window that begins at a sample.
fn nearby(values: &[f64], at: usize) -> f64 {
    let around = &values[at.saturating_sub(NEARBY)..(at + 4 + NEARBY).min(values.len())];
    quantile(around.windows(5).map(|w| distance(w).abs()), 0.8).unwrap_or(0.0) / NORMAL_80
}

/// x₂ − median(x₀, x₁, x₃, x₄)
fn distance(w: &[f64]) -> f64 {
    let (a, b) = (w[0].min(w[1]), w[0].max(w[1]));
    let (c, d) = (w[3].min(w[4]), w[3].max(w[4]));
    // Of two pairs the middle numbers are the larger of the lesser and the lesser of the larger.
    w[2] - 0.5 * (a.max(c) + b.min(d))
}

fn stands_out(w: &[f64], distance: f64) -> bool {
    let (before, after) = (w[2] - w[1], w[2] - w[3]);
    let alone = before * after > 0.0 && before.abs().min(after.abs()) > ALONE * distance;
    alone && (before - after).abs() < NEIGHBOURS_AGREE * distance
}
