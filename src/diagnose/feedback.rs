//! Whether an input follows what the model leaves over: someone steers by the output.
//!
//! # Purpose
//! A disturbance that nobody recorded goes round a closed loop. It stands in the input as well, so that laws of the input
//! explain it, on what was held out too, and the values of parameters lean.
//!
//! # Method
//! The input and what is left are turned into innovations, each by its own autoregression. Where the loop is open, what is
//! new in the input is independent of all that was left before. Of the correlations ρ_k of what is new in the input with
//! innovations k samples earlier, n Σ ρ_k² is then chi-squared (Haugh 1976). k = 0 counts where an input is held and acts on
//! no output at once: what it sets now shows later. A new course outweighs thousands of small answers to the sea: innovations
//! far out are drawn in. A command in stairs answers nothing between its leaps. It is asked where no law is left: what such a
//! law leaves goes with the input as well.
//!
//! # References
//! L. D. Haugh, JASA 71 (1976) 378-385; C. W. J. Granger, Econometrica 37 (1969) 424-438; L. Ljung, System Identification,
//! 2nd ed. 1999, 13.4 (what a closed loop does to a model without a model of its noise).

use super::catalogue::edit;
use super::screen::log_chance;
use crate::estimate::Fit;
use crate::estimate::fit::Series;
use crate::estimate::noise::{Autoregression, robust_deviation};
use crate::record::{Channel, Hold, Kind, Recording, looks_held};

/// Order of the autoregressions, and earlier samples that are looked at.
const ORDER: usize = 20;
const LAGS: usize = 20;
/// ln of the chance from which on the input follows, and least share of what is new in it that what is left explains.
const CHANCE: f64 = -30.0;
const SHARE: f64 = 0.1;
/// Deviations beyond which an innovation counts as so many.
const OUTLIER: f64 = 3.0;
/// Fewest samples.
const FEWEST: usize = 10 * LAGS;
/// Deviation of what is left over that of its innovations from which on it is no noise of a sensor but a disturbance.
const DISTURBED: f64 = 5.0;

/// ln of the chance from which on an input is set from what an output shows at the same moment.
const AT_ONCE: f64 = -10.0;
/// The share of its weight on what is new in an input that an error of a sensor has on the rest of it: all, where the sensor
/// feels the input; none, where the input is set from the reading. And standard deviations that it is sure by.
const FELT: (f64, f64) = (0.5, 2.0);

/// A closed loop.
pub struct Loop {
    /// What is steered, an input.
    pub input: String,
    /// By what, an output.
    pub output: String,
}

impl Loop {
    /// What to know of it.
    pub fn says(&self) -> String {
        let Self { input, output } = self;
        format!(
            "{input} follows what the model leaves of “{output}”: someone steers by it, and what disturbs was not recorded. It goes round this loop and looks like a law of {input}, on what was held out too, so that no name is proved and the values of the parameters lean; record what disturbs, or {input} moved by a plan of its own"
        )
    }
}

/// An input that surely follows what a fit leaves of an output, where that is far more than its innovations.
pub fn of(recordings: &[Recording], fit: &Fit) -> Option<Loop> {
    let disturbed = |s: &&Series| {
        let noise = fit.noise.get(s.output).map(|n| &n.autoregression);
        noise.is_some_and(|a| a.variance() > DISTURBED.powi(2) * a.innovation_variance())
    };
    let inputs = || fit.model.inputs.iter().map(|i| i.name.as_str());
    let pairs = recordings.iter().zip(&fit.records);
    let all = pairs.flat_map(|(r, record)| record.series.iter().filter(disturbed).map(move |s| (r, s)));
    let mut all = all.flat_map(|(r, s)| inputs().filter_map(move |i| Some((r.find(i)?, s))));
    let acts_at_once = |input: &Channel, series: &Series| {
        let shown = &fit.model.outputs[series.output].equals;
        !input.hold.is_held() || edit::reaches(&fit.model, shown, &input.name)
    };
    let is_closed = |(i, s): &(&Channel, &Series)| follows(i, s, usize::from(acts_at_once(i, s)));
    let (input, series) = all.find(is_closed)?;
    Some(Loop { input: input.name.clone(), output: fit.model.outputs[series.output].name.clone() })
}

/// Reads held inputs that are set from what an output shows at the same moment, and reach no output at once, as acting after
/// it: else the noise of the reading, which stands in the input, looks like an error of the sensor that goes with the
/// input. What to know of each.
pub fn read_first(recordings: &mut [Recording], separate: &mut [Recording], fit: &Fit) -> Vec<String> {
    let found = answering(recordings, fit, Hold::Previous);
    let channels = recordings.iter_mut().chain(separate).flat_map(|r| &mut r.channels);
    let is_found = |c: &&mut Channel| c.hold == Hold::Previous && found.iter().any(|f| f.0 == c.name);
    for c in channels.filter(is_found) {
        c.hold = Hold::AfterReading;
    }
    let says = |(name, output): (String, usize)| {
        let output = &fit.model.outputs[output].name;
        format!(
            "it looks as if {name} is set from what “{output}” shows in the same row, or what is missing goes with its steps: what is measured was read as it was before {name} acts, which to a command that nobody steers by is the same"
        )
    };
    found.into_iter().map(says).collect()
}

/// Inputs of a hold that reach no output at once and answer one at the same moment, with the number of that output.
pub fn answering(recordings: &[Recording], fit: &Fit, hold: Hold) -> Vec<(String, usize)> {
    let model = &fit.model;
    let waits = |name: &&String| {
        !model.is_simulated(name) && !model.outputs.iter().any(|o| edit::reaches(model, &o.equals, name))
    };
    let set_by = |name: &String| -> Option<usize> {
        let pairs = recordings.iter().zip(&fit.records).filter(|(r, _)| r.kind == Kind::Time);
        let mut all =
            pairs.flat_map(|(r, record)| record.series.iter().filter_map(|s| Some((r.find(name)?, s))));
        all.find(|(c, s)| c.hold == hold && answers_at_once(c, s)).map(|(_, s)| s.output)
    };
    model
        .inputs
        .iter()
        .map(|i| &i.name)
        .filter(waits)
        .filter_map(|name| Some((name.clone(), set_by(name)?)))
        .collect()
}

/// An input at the times of an output, and what is left of that, stretch by stretch.
fn beside(input: &Channel, series: &Series) -> Vec<[Vec<f64>; 2]> {
    let at = |r: &std::ops::Range<usize>| -> Option<[Vec<f64>; 2]> {
        let moved = series.time[r.clone()].iter().map(|t| input.value_from(*t)).collect::<Option<_>>()?;
        Some([moved, series.residual[r.clone()].to_vec()])
    };
    series.stretches.iter().filter_map(at).collect()
}

/// Whether what is new in an input goes with what is new in the residual of the same moment, and the rest of the input does
/// not, as it would were it the sensor that feels the input.
fn answers_at_once(input: &Channel, series: &Series) -> bool {
    let known = beside(input, series);
    let n = known.iter().map(|s| s[0].len()).sum::<usize>();
    if n < FEWEST {
        return false;
    }
    let moved = about_mean(&known, 0).1;
    let views: Vec<&[f64]> = moved.iter().map(Vec::as_slice).collect();
    let lefts: Vec<&[f64]> = known.iter().map(|s| s[1].as_slice()).collect();
    let [own, noise] = [&views, &lefts].map(|s| Autoregression::fit(s, ORDER));
    let all = |by: &Autoregression, which: &[&[f64]]| -> Vec<f64> {
        let size = by.innovation_variance().sqrt();
        which.iter().flat_map(|s| by.whiten(s)).map(|e| e * size).collect()
    };
    let (left, seen, new) = (all(&noise, &lefts), all(&noise, &views), all(&own, &views));
    let rest: Vec<f64> = seen.iter().zip(&new).map(|(s, v)| s - v).collect();
    // a new course would outweigh thousands of small answers
    let most = OUTLIER * robust_deviation(&new);
    let keeps: Vec<bool> = new.iter().map(|v| most <= 0.0 || v.abs() <= most).collect();
    let kept = |all: &[f64]| -> Vec<f64> { all.iter().zip(&keeps).filter(|k| *k.1).map(|k| *k.0).collect() };
    let (new, rest, left) = (kept(&new), kept(&rest), kept(&left));
    let n = new.len();
    // e = a v + b r + noise: v what is new in the input, r the rest of it, each as the noise is whitened
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let (vv, vr, rr, ee) = (dot(&new, &new), dot(&new, &rest), dot(&rest, &rest), dot(&left, &left));
    let (ve, re) = (dot(&new, &left), dot(&rest, &left));
    let (weight, determinant) = (ve / vv, vv * rr - vr * vr);
    let felt = (vv * re - vr * ve) / determinant;
    let deviation = (ee / n as f64 * vv / determinant).sqrt();
    let goes = log_chance(n as f64 * ve * ve / (vv * ee), 1) < AT_ONCE;
    goes && felt * weight.signum() + FELT.1 * deviation < FELT.0 * weight.abs()
}

/// Whether what is new in a channel answers innovations of what is left that many samples earlier or more.
fn follows(input: &Channel, series: &Series, first: usize) -> bool {
    if looks_held(&input.values) {
        return false;
    }
    let known = beside(input, series);
    let [Some(moved), Some(left)] = [0, 1].map(|k| innovations(&known, k)) else { return false };
    let size = |all: &[Vec<f64>]| all.iter().flatten().map(|x| x * x).sum::<f64>();
    let both = size(&moved) * size(&left);
    let correlation = |k: usize| {
        let lagged =
            moved.iter().zip(&left).map(|(u, e)| u.iter().skip(k).zip(e).map(|(u, e)| u * e).sum::<f64>());
        lagged.sum::<f64>() / both.sqrt()
    };
    let lags = first..=LAGS;
    let degrees = lags.clone().count();
    let share: f64 = lags.map(|k| correlation(k).powi(2)).sum();
    let n = moved.iter().map(Vec::len).sum::<usize>() as f64;
    share > SHARE && log_chance(n * share, degrees) < CHANCE
}

/// The mean of one of the two signals, and its stretches about it.
fn about_mean(stretches: &[[Vec<f64>; 2]], which: usize) -> (f64, Vec<Vec<f64>>) {
    let n = stretches.iter().map(|s| s[which].len()).sum::<usize>();
    let mean = stretches.iter().flat_map(|s| &s[which]).sum::<f64>() / n as f64;
    (mean, stretches.iter().map(|s| s[which].iter().map(|x| x - mean).collect()).collect())
}

/// Stretches of one of the two signals as innovations of its autoregression, about their mean; none where they are short
/// or stand still.
fn innovations(stretches: &[[Vec<f64>; 2]], which: usize) -> Option<Vec<Vec<f64>>> {
    let n = stretches.iter().map(|s| s[which].len()).sum::<usize>();
    let (mean, about) = about_mean(stretches, which);
    let views: Vec<&[f64]> = about.iter().map(Vec::as_slice).collect();
    let moves = about.iter().flatten().any(|x| x.abs() > 1e-12 * mean.abs());
    if n < FEWEST || !moves {
        return None;
    }
    let own = Autoregression::fit(&views, ORDER);
    let mut new: Vec<Vec<f64>> = views.iter().map(|v| own.whiten(v)).collect();
    let most = OUTLIER * robust_deviation(&new.concat());
    if most.is_nan() || most <= 0.0 {
        return None;
    }
    new.iter_mut().flatten().for_each(|x| *x = x.clamp(-most, most));
    Some(new)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Unit;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    /// x' = u + d with a wandering d, seen with noise; u is a controller's or a plan's.
    fn told(is_closed: bool, seed: u64) -> bool {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut drawn = || -> f64 { StandardNormal.sample(&mut rng) };
        let (mut x, mut predicted, mut d, mut aim, mut seen) = (0.0, 0.0, 0.0, 0.0, 0.0);
        let (mut u, mut left) = (Vec::new(), Vec::new());
        for i in 0..2000 {
            if i % 120 == 0 {
                aim = 5.0 * drawn();
            }
            let plan = 0.3 * (aim + (0.07 * f64::from(i)).sin());
            // by what was seen a row before
            let now = if is_closed { plan - 0.3 * seen } else { plan };
            seen = x + 0.02 * drawn();
            u.push(now);
            left.push(seen - predicted);
            d = 0.95 * d + 0.1 * drawn();
            x += 0.5 * (now - 0.4 * x + d);
            predicted += 0.5 * (now - 0.4 * predicted);
        }
        let time: Vec<f64> = (0..2000).map(f64::from).collect();
        let input = Channel::new("u", Unit::one(), time.clone(), u);
        let stretches = std::iter::once(0..left.len()).collect();
        let series = Series { output: 0, time, residual: left, sensitivities: Vec::new(), stretches };
        follows(&input, &series, 1)
    }

    #[test]
    fn a_controller_follows_what_disturbs_and_a_plan_does_not() {
        for seed in 0..10 {
            assert!(told(true, seed), "{seed}");
            assert!(!told(false, seed), "{seed}");
        }
    }
}
