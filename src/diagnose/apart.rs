//! How far two models that fit alike would part on another recording.
//!
//! # Purpose
//! Tell which change of an input would part a mechanism from the one that fits as well, and by how much,
//! before anybody goes to sea for it.
//!
//! # Method
//! The recording's own inputs are swung half as far, or twice as far, one at a time, from where they began,
//! so that both models start as they were fitted; both run over it. Where they part is the root mean
//! square of the difference of their predictions, against what the model leaves over now. Half as far is
//! preferred where it is enough: nobody is asked to go where neither model was tried.
//!
//! # References
//! W. G. Hunter, A. M. Reiner, Technometrics 7 (1965) 307 (designs that part rival models).

use super::bench::{self, Bench, Stand};
use crate::Result;
use crate::estimate::Fit;
use crate::record::Channel;

/// How many times as far an input is swung.
const SWINGS: [(f64, &str); 2] = [(0.5, "half"), (2.0, "twice")];
/// Difference over what is left that is enough.
const ENOUGH: f64 = 2.0;

/// Where two models part.
pub struct Apart {
    /// The input.
    pub input: String,
    /// How far it is swung, in words.
    pub swing: &'static str,
    /// Number of the output.
    pub output: usize,
    /// Root mean square of the difference of the predictions, SI.
    pub difference: f64,
    /// The same over what is left there now.
    pub ratio: f64,
}

/// The change of an input that parts two fitted models most.
pub fn farthest(bench: &Bench, (first, other): &(Fit, Fit)) -> Option<Apart> {
    let inputs = first.model.inputs.iter().take(bench.own_inputs);
    let changes = inputs.flat_map(|i| SWINGS.map(|s| (i.name.clone(), s)));
    let parted: Vec<Apart> = changes
        .filter_map(|(input, (factor, swing))| {
            let swung = swung(bench, &input, factor);
            let (output, difference) = parted(&swung, first, other).ok()??;
            Some(Apart { input, swing, output, difference, ratio: difference / first.rmse[output] })
        })
        .filter(|a| a.ratio.is_finite())
        .collect();
    let best = |all: &mut dyn Iterator<Item = Apart>| all.max_by(|a, b| a.ratio.total_cmp(&b.ratio));
    let (near, far): (Vec<Apart>, Vec<Apart>) = parted.into_iter().partition(|a| a.swing == SWINGS[0].1);
    let near = best(&mut near.into_iter());
    if near.as_ref().is_some_and(|a| a.ratio >= ENOUGH) {
        near
    } else {
        best(&mut near.into_iter().chain(far))
    }
}

/// The bench with one input swung otherwise about its first value; one that has one sign keeps it.
fn swung(bench: &Bench, input: &str, factor: f64) -> Bench {
    let mut recordings = bench.recordings.clone();
    let own = |c: &&mut Channel| c.name == input && !c.wraps;
    for c in recordings.iter_mut().flat_map(|r| &mut r.channels).filter(own) {
        let known = || c.values.iter().copied().filter(|v| v.is_finite());
        let start = known().next().unwrap_or(0.0);
        let lowest = if known().all(|v| v >= 0.0) { 0.0 } else { f64::NEG_INFINITY };
        let highest = if known().all(|v| v <= 0.0) { 0.0 } else { f64::INFINITY };
        let swing = |v: f64| (start + factor * (v - start)).max(lowest).min(highest);
        c.values.iter_mut().filter(|v| v.is_finite()).for_each(|v| *v = swing(*v));
    }
    Bench { recordings, budget: bench.budget.clone(), ..*bench }
}

/// The output at which two models part most, with the root mean square of the difference.
fn parted(bench: &Bench, first: &Fit, other: &Fit) -> Result<Option<(usize, f64)>> {
    let run = |f: &Fit| {
        let records = bench.ready(&f.model, f.starts(), (bench.rough(first), Vec::new()))?;
        bench::run(&records, &Stand::of(f), &[])
    };
    let (a, b) = (run(first)?, run(other)?);
    let mut sums = vec![(0.0, 0_usize); first.model.outputs.len()];
    for (a, b) in a.iter().zip(&b) {
        let (sum, count) = &mut sums[a.output];
        for (x, y) in a.residual.iter().zip(&b.residual) {
            *sum += (x - y).powi(2);
            *count += 1;
        }
    }
    let each = sums.iter().enumerate().filter(|(_, s)| s.1 > 0);
    let each = each.map(|(o, (sum, count))| (o, (sum / *count as f64).sqrt()));
    Ok(each.max_by(|a, b| (a.1 / first.rmse[a.0]).total_cmp(&(b.1 / first.rmse[b.0]))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::{FitOptions, fit};
    use crate::model::Model;
    use crate::record::Recording;
    use crate::units::Unit;

    /// A square wave of ±1 shows y = a u and y = a u |u| alike; swung twice as far from its first value 1
    /// it is 1 and −3, where they differ by 0 and 6 a.
    #[test]
    fn a_law_and_its_square_part_where_the_input_swings_farther() {
        let unit = |text: &str| Unit::parse(text).expect("a unit");
        let time: Vec<f64> = (0..400).map(f64::from).collect();
        let u: Vec<f64> = (0..400).map(|i| if i % 8 < 4 { 1.0 } else { -1.0 }).collect();
        let y = u.iter().enumerate().map(|(i, u)| 2.0 * u + if i % 3 == 0 { 0.8 } else { -0.4 }).collect();
        let channels =
            vec![Channel::new("u", unit("V"), time.clone(), u), Channel::new("y", unit("V"), time, y)];
        let recording = Recording::from_channels("made", channels).expect("a recording");
        let fitted = |equals: &str| {
            let text = format!(
                "name = \"m\"\n[inputs]\nu = {{ unit = \"V\" }}\n[parameters]\na = {{ value = 1, unit = \"1\", fit = true }}\none = {{ value = 1, unit = \"V\" }}\n[outputs]\ny = {{ equals = \"{equals}\", unit = \"V\" }}\n"
            );
            let model = Model::parse(&text).expect("a model");
            fit(&model, std::slice::from_ref(&recording), &FitOptions::default()).expect("a fit")
        };
        let pair = (fitted("a*u"), fitted("a*u*abs(u)/one"));
        let bench = Bench::new(&pair.0.model, vec![recording.clone()], false, 1);
        let apart = farthest(&bench, &pair).expect("an input");
        assert_eq!((apart.input.as_str(), apart.swing), ("u", "twice"));
        let a = pair.0.model.parameters[0].value;
        assert!((a - 2.0).abs() < 0.01, "{a}");
        let wanted = 6.0 * a / 2f64.sqrt();
        assert!((apart.difference / wanted - 1.0).abs() < 0.02, "{} {wanted}", apart.difference);
    }
}
