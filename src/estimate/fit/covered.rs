//! The band that the inputs cover.
//!
//! # Purpose
//! An input that is sampled more slowly than an output is read as a straight line between its samples. What that line
//! lacks, above half the input's rate of sampling, stands in the residual of every model, and a model that smooths is
//! rewarded for it.
//!
//! # Method
//! Samples of an output are averaged over the period of the slowest input that bends between its samples: what lies
//! above the frequency 1/(2 T) of its sampling is neither compared nor weighed.
//!
//! # Numerical aspects
//! An input bends where lines between every second of its samples miss those between by a share of its spread: a
//! temperature that is logged once a minute is as good as a line and shortens nothing.

use super::outcome::Warning;
use crate::model::Model;
use crate::record::{Channel, Hold, Kind, Recording};
use crate::units::figure;

/// Share of its spread by which an input that bends misses a line over two of its periods.
const BENDS: f64 = 0.02;

/// Samples of each output over which the slowest input that bends is one, at least 1.
pub fn samples_in_a_period(model: &Model, recordings: &[Recording]) -> Vec<usize> {
    let of = |name: &String| recordings.iter().map(|r| in_one(model, r, name)).max().unwrap_or(1);
    model.outputs.iter().map(|o| of(&o.name)).collect()
}

fn in_one(model: &Model, recording: &Recording, output: &str) -> usize {
    slowest(model, recording, output).map_or(1, |(_, slow, own)| (slow / own).round().max(1.0) as usize)
}

/// What a reader should know of inputs that bend between samples more than twice as far apart as an output's.
pub fn warnings(model: &Model, recordings: &[Recording]) -> Vec<Warning> {
    let mut told: Vec<String> = Vec::new();
    for (recording, output) in recordings.iter().flat_map(|r| model.outputs.iter().map(move |o| (r, &o.name)))
    {
        let Some((input, slow, own)) = slowest(model, recording, output) else { continue };
        // 1 − (ωT)²/12, the gain of lines, is that of a lag τ, 1 − (ωτ)²/2, at τ = T/√6
        let lag = slow / 6.0_f64.sqrt();
        let message = format!(
            "{input} turns between its samples, {} s apart, where {output} has one every {} s: read as lines it is \
             weaker than it was, as by a lag of {} s, and lags and delays of that size cannot be told from it",
            figure(slow),
            figure(own),
            figure(lag)
        );
        if slow >= 2.0 * own && !told.contains(&message) {
            told.push(message);
        }
    }
    told.into_iter().map(|message| Warning { message }).collect()
}

/// The slowest input that bends, its period and that of an output.
fn slowest<'a>(model: &'a Model, recording: &Recording, output: &str) -> Option<(&'a str, f64, f64)> {
    let own = recording.find(output).and_then(Channel::median_step);
    let own = own.filter(|s| *s > 0.0 && recording.kind != Kind::Trials)?;
    let period = |name: &'a String| {
        let channel = recording.find(name).filter(|c| bends(c))?;
        Some((name.as_str(), channel.median_step()?, own))
    };
    model.inputs.iter().filter_map(|i| period(&i.name)).max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Whether lines between its samples miss what it does there.
fn bends(channel: &Channel) -> bool {
    if channel.hold != Hold::Linear {
        return false;
    }
    let values: Vec<f64> = channel.samples().map(|(_, y)| y).collect();
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    let spread: f64 = values.iter().map(|y| (y - mean).powi(2)).sum();
    let missed: f64 = values.windows(3).map(|w| (w[1] - 0.5 * (w[0] + w[2])).powi(2)).sum();
    missed > BENDS * BENDS * spread
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Unit;

    fn recording(period: f64, frequency: f64) -> Recording {
        let channel = |name: &str, step: f64| {
            let time: Vec<f64> = (0..(60.0 / step) as usize).map(|k| k as f64 * step).collect();
            let values = time.iter().map(|t| (frequency * t).sin()).collect();
            Channel::new(name, Unit::parse("1").unwrap(), time, values)
        };
        let (u, y) = (channel("u", period), channel("y", 0.1));
        Recording::from_channels("made", vec![u, y]).unwrap()
    }

    fn lag() -> Model {
        let text = "name = \"lag\"\n[inputs]\nu = { unit = \"1\" }\n[parameters]\nT = { value = 1, unit = \"s\" }\n\
                    [states]\nx = { rate = \"(u - x)/T\", unit = \"1\", initial = 0.0 }\n[outputs]\n\
                    y = { equals = \"x\", unit = \"1\" }\n";
        Model::parse(text).unwrap()
    }

    #[test]
    fn what_bends_between_slow_samples_is_averaged_over_their_period() {
        // 1 − cos ωT = 0.46 at 1 rad/s, and 0.005 at 0.1 rad/s
        assert_eq!(samples_in_a_period(&lag(), &[recording(1.0, 1.0)]), [10]);
        assert_eq!(samples_in_a_period(&lag(), &[recording(1.0, 0.1)]), [1]);
        assert_eq!(samples_in_a_period(&lag(), &[recording(0.1, 9.0)]), [1]);
        let mut held = recording(1.0, 1.0);
        held.channels[0].hold = Hold::Previous;
        assert_eq!(samples_in_a_period(&lag(), &[held]), [1]);
    }
}
