//! Which signals keep company: pairs whose product has a mean.
//!
//! # Purpose
//! A product of two signals that have nothing to do with each other averages out; only pairs that go
//! together, at whatever lag, can have a rectified effect.
//!
//! # Method
//! Both signals are read on one clock fine enough for the faster; the largest normalised correlation
//! over lags of a few of their paces decides.
//!
//! # References
//! J. S. Bendat, A. G. Piersol, Random Data, 4th ed. (2010), 5.1 (cross-correlation).

use super::catalogue::{Signal, SignalKind};
use crate::record::{Channel, Recording};

/// Correlation from which on two signals go together.
const TOGETHER: f64 = 0.2;
/// Steps of the common clock in the pace of the faster signal.
const STEPS: f64 = 3.0;
/// Lags looked at either way, in steps of the common clock.
const LAGS: usize = 12;
/// Samples of the common clock at most.
const MOST: usize = 20_000;

/// The pairs of moving inputs and channels that go together in a recording.
pub fn pairs(recording: &Recording, signals: &[Signal]) -> Vec<(String, String)> {
    let moving = |s: &&Signal| matches!(s.kind, SignalKind::Input | SignalKind::Channel) && s.varies();
    let moving: Vec<&Signal> = signals.iter().filter(moving).collect();
    let mut found = Vec::new();
    for (i, a) in moving.iter().enumerate() {
        for b in &moving[i + 1..] {
            if correlation(recording, a, b) > TOGETHER {
                found.push((a.name.clone(), b.name.clone()));
            }
        }
    }
    found
}

/// The largest size of the normalised correlation over the lags.
fn correlation(recording: &Recording, a: &Signal, b: &Signal) -> f64 {
    let (Some(x), Some(y)) = (recording.find(&a.name), recording.find(&b.name)) else { return 0.0 };
    let (Some(first), Some(last)) = (x.time.first().zip(y.time.first()), x.time.last().zip(y.time.last()))
    else {
        return 0.0;
    };
    let (from, to) = (first.0.max(*first.1), last.0.min(*last.1));
    let step = (a.pace.min(b.pace) / STEPS).max(x.median_step().unwrap_or(1.0));
    if to.is_nan() || step.is_nan() || to - from <= step * LAGS as f64 {
        return 0.0;
    }
    let count = (((to - from) / step) as usize).min(MOST);
    let x = read(x, from, step, count);
    let y = read(y, from, step, count);
    let lagged = |u: &[f64], v: &[f64], lag: usize| -> f64 {
        let sum: f64 = u[lag..].iter().zip(v).map(|(p, q)| p * q).sum();
        (sum / count as f64).abs()
    };
    (0..=LAGS.min(count)).flat_map(|l| [lagged(&x, &y, l), lagged(&y, &x, l)]).fold(0.0, f64::max)
}

/// A channel's latest values on a clock, of mean zero and spread one, gaps as zero.
fn read(channel: &Channel, from: f64, step: f64, count: usize) -> Vec<f64> {
    let mut row = 0;
    let mut values = Vec::with_capacity(count);
    for k in 0..count {
        let t = from + k as f64 * step;
        while row + 1 < channel.time.len() && channel.time[row + 1] <= t {
            row += 1;
        }
        values.push(channel.values[row]);
    }
    let known: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    let mean = known.iter().sum::<f64>() / known.len().max(1) as f64;
    let spread = super::watch::spread(&known);
    let scaled = |v: f64| if v.is_finite() && spread > 0.0 { (v - mean) / spread } else { 0.0 };
    values.into_iter().map(scaled).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Unit;

    fn signal(name: &str, pace: f64) -> Signal {
        Signal {
            name: name.to_string(),
            kind: SignalKind::Input,
            unit: Unit::one(),
            mean: 0.0,
            spread: 0.7,
            min: -1.0,
            max: 1.0,
            levels: 64,
            pace,
            is_turned: false,
        }
    }

    #[test]
    fn a_shifted_copy_keeps_company_and_another_frequency_does_not() {
        let time: Vec<f64> = (0..4000).map(|i| 0.1 * f64::from(i)).collect();
        let wave = |name: &str, f: &dyn Fn(f64) -> f64| {
            Channel::new(name, Unit::one(), time.clone(), time.iter().map(|t| f(*t)).collect())
        };
        let channels = vec![
            wave("roll", &|t| (0.8 * t).sin()),
            wave("late", &|t| (0.8 * t - 1.5).sin()),
            wave("other", &|t| (1.1 * t).sin()),
        ];
        let recording = Recording::from_channels("made", channels).unwrap();
        let signals = [signal("roll", 1.25), signal("late", 1.25), signal("other", 0.9)];
        assert_eq!(pairs(&recording, &signals), [("roll".to_string(), "late".to_string())]);
    }
}
