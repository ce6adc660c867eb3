//! One recording of several that is read otherwise than the others: a channel of the wrong sign or in another unit there alone.
//!
//! # Purpose
//! A model fitted to all of them follows none, and the laws that lower that error are no physics.
//!
//! # Method
//! Where the model misses one recording badly, it is fitted to the others without each in turn. Where these then fit far
//! better, each channel of the one left out is turned over and read in the units that it may be in, and the model is fitted
//! to all once more. What makes all of them fit, and no less so by a tenth more or less of the factor, is told and mended.

use super::misread::{BADLY, BETTER, factors};
use super::short;
use crate::diagnose::answer::{DataFault, Finding, SiteName, Value};
use crate::diagnose::bench::Bench;
use crate::diagnose::spread_of;
use crate::estimate::fit::{Effort, RecordFit, Series};
use crate::estimate::{Fit, fit};
use crate::model::Model;
use crate::record::Recording;
use crate::units::Unit;
use rayon::prelude::*;

/// Recordings that are asked at most: more than that are no exception.
const MOST: usize = 2;
/// What a factor is changed by, which must fit less well.
const BESIDE: [f64; 2] = [0.9, 1.1];

/// A channel of one recording that is mended.
pub struct Odd {
    /// The fault.
    pub fault: DataFault,
    /// The model as given, fitted with it mended.
    pub fit: Fit,
    way: Way,
}

/// A channel of a recording, and what it is multiplied by.
#[derive(Clone)]
struct Way {
    recording: usize,
    channel: String,
    is_output: bool,
    factor: f64,
    words: &'static str,
}

impl Way {
    fn mend(&self, recordings: &mut [Recording]) {
        let own = recordings.get_mut(self.recording).into_iter().flat_map(|r| &mut r.channels);
        let named = own.filter(|c| c.name == self.channel);
        named.for_each(|c| c.values.iter_mut().for_each(|v| *v *= self.factor));
    }
}

impl Odd {
    /// Mends the recordings that the model is fitted to.
    pub fn mend(&self, recordings: &mut [Recording]) {
        self.way.mend(recordings);
    }
}

/// Looks for the one recording that is read otherwise.
pub fn odd(bench: &Bench, model: &Model, base: &Fit) -> Option<Odd> {
    let all = &bench.recordings;
    let before = missed(base, all);
    if all.len() < 2 || bench.is_trials() || before <= BADLY {
        return None;
    }
    let without = |n: usize| {
        let others: Vec<Recording> =
            all.iter().enumerate().filter(|r| r.0 != n).map(|r| r.1.clone()).collect();
        Some((missed(&fitted(bench, model, &others)?, &others), n))
    };
    let left: Vec<Option<(f64, usize)>> = (0..all.len()).into_par_iter().map(without).collect();
    let mut suspects: Vec<(f64, usize)> =
        left.into_iter().flatten().filter(|l| l.0 < BETTER * before).collect();
    suspects.sort_by(|a, b| a.0.total_cmp(&b.0));
    let ways: Vec<Way> = suspects.iter().take(MOST).flat_map(|s| ways(bench, model, s.1)).collect();
    let mended = |way: &Way| {
        let mut recordings = all.clone();
        way.mend(&mut recordings);
        let fit = fitted(bench, model, &recordings)?;
        Some((missed(&fit, &recordings), way.clone(), fit))
    };
    let fits: Vec<Option<(f64, Way, Fit)>> = ways.par_iter().with_max_len(1).map(mended).collect();
    let mut stand: Vec<(f64, Way, Fit)> =
        fits.into_iter().flatten().filter(|m| m.0 < BETTER * before).collect();
    // of several that fit alike the data cannot tell which; a sensor is read wrong more easily than a command
    let least = stand.iter().map(|m| m.0).fold(f64::INFINITY, f64::min);
    stand.retain(|m| m.0 < least / BESIDE[0]);
    stand.sort_by_key(|m| !m.1.is_output);
    let (left, way, fit) = stand.first()?.clone();
    let changed = |by: &f64| mended(&Way { factor: way.factor * by, ..way.clone() });
    let is_exact = BESIDE.iter().filter_map(changed).all(|(other, ..)| other > left);
    let others: Vec<&Way> = stand[1..].iter().map(|m| &m.1).collect();
    is_exact.then(|| Odd { fault: fault(&way, &others, all), fit, way })
}

fn fitted(bench: &Bench, model: &Model, recordings: &[Recording]) -> Option<Fit> {
    fit(model, recordings, &bench.options(Effort::Near, 10)).ok()
}

/// The largest misfit of an output in a recording as a share of what it moves there.
fn missed(fit: &Fit, recordings: &[Recording]) -> f64 {
    let of = |(r, recording): (&RecordFit, &Recording)| {
        let series = r.series.iter().filter(|s| !s.residual.is_empty());
        let share = |s: &Series| {
            let squares = s.residual.iter().map(|e| e * e).sum::<f64>() / s.residual.len() as f64;
            let spread = spread_of(std::slice::from_ref(recording), &fit.model.outputs[s.output].name);
            if spread > 0.0 { squares.sqrt() / spread } else { 0.0 }
        };
        series.map(share).fold(0.0, f64::max)
    };
    fit.records.iter().zip(recordings).map(of).fold(0.0, f64::max)
}

/// Every channel of a recording that moves and that the model uses, turned over and in every unit that it may be in.
fn ways(bench: &Bench, model: &Model, recording: usize) -> Vec<Way> {
    let inputs = model.inputs.iter().map(|i| (&i.name, &i.unit, false));
    let outputs = model.outputs.iter().map(|o| (&o.name, &o.unit, true));
    let of = |(name, unit, is_output): (&String, &Unit, bool)| {
        let way = |(factor, words)| Way { recording, channel: name.clone(), is_output, factor, words };
        factors(unit).into_iter().map(way).collect::<Vec<_>>()
    };
    let moves = |name: &str| spread_of(&bench.recordings[recording..=recording], name) > 0.0;
    inputs.chain(outputs).filter(|c| moves(c.0)).flat_map(of).collect()
}

fn says(way: &Way, recordings: &[Recording]) -> String {
    let (name, recording) = (&way.channel, &recordings[way.recording].name);
    if way.factor == -1.0 {
        return format!(
            "in the recording “{recording}” alone {name} has the wrong sign: turned over, it fits"
        );
    }
    format!(
        "in the recording “{recording}” alone {name} holds {}: multiplied by {}, it fits",
        way.words,
        short(way.factor)
    )
}

fn fault(way: &Way, others: &[&Way], recordings: &[Recording]) -> DataFault {
    let code = |w: &Way| if w.factor == -1.0 { "wrong-sign" } else { "wrong-unit" };
    let as_well: Vec<String> = others.iter().map(|o| format!("or {}", says(o, recordings))).collect();
    let told = says(way, recordings);
    let says = match &as_well[..] {
        [] => told,
        all => format!("{told} ({}: the data cannot tell which)", all.join(", ")),
    };
    let mut ties: Vec<String> =
        others.iter().map(|o| code(o)).filter(|c| *c != code(way)).map(String::from).collect();
    ties.dedup();
    let (low, high) = (f64::NAN, f64::NAN);
    let value = Value { name: "factor".into(), value: way.factor, low, high, unit: "1".into() };
    let finding = Finding {
        code: code(way).into(),
        site: SiteName {
            kind: if way.is_output { "output" } else { "input" }.into(),
            name: way.channel.clone(),
        },
        term: format!("{}*{}", short(way.factor), way.channel),
        says,
        parameters: vec![value],
        p_value: 0.0,
        share: 0.0,
        ties,
        resembles: false,
        evidence: None,
    };
    DataFault { finding, masked: true }
}
