//! One recording of several that is read otherwise than the others: a channel of the wrong sign or in another unit there alone.
//!
//! # Purpose
//! A model fitted to all of them follows none, and the laws that lower that error are no physics.
//!
//! # Method
//! Where the model misses one recording badly, it is fitted to the others without each in turn. Where these then fit far
//! better, each channel of the one left out is turned over and read in the units that it may be in, and the model is fitted
//! to all once more. What makes all of them fit, and no less so by a tenth more or less of the factor, is told and mended.

use super::misread::{BADLY, BETTER, Misread, Way, fault, readings, scale, wrong};
use crate::diagnose::bench::Bench;
use crate::diagnose::spread_of;
use crate::estimate::fit::{Effort, RecordFit, Series};
use crate::estimate::{Fit, fit};
use crate::model::Model;
use crate::record::Recording;
use rayon::prelude::*;

/// Recordings that are asked at most: more than that are no exception.
const MOST: usize = 2;
/// What a factor is changed by, which must fit less well.
const BESIDE: [f64; 2] = [0.9, 1.1];

/// A reading of a channel in one recording, with the model fitted after it and what that misses.
struct Mend<'m> {
    recording: usize,
    way: Way<'m>,
    fit: Fit,
    misfit: f64,
}

impl<'m> Mend<'m> {
    /// None where the model cannot be fitted.
    fn of(bench: &Bench, model: &Model, (recording, way): (usize, Way<'m>)) -> Option<Self> {
        let mut recordings = bench.recordings.clone();
        scale(&mut recordings[recording..=recording], way.name, way.factor);
        let fit = fitted(bench, model, &recordings)?;
        Some(Self { recording, way, misfit: missed(&fit, &recordings), fit })
    }

    fn told(&self, bench: &Bench) -> (Way<'m>, String) {
        let name = &bench.recordings[self.recording].name;
        (self.way, format!("in the recording “{name}” alone {}", wrong(&self.way)))
    }
}

/// Looks for the one recording that is read otherwise.
pub fn odd(bench: &Bench, model: &Model, base: &Fit) -> Option<Misread> {
    let before = missed(base, &bench.recordings);
    if bench.recordings.len() < 2 || bench.is_trials() || before <= BADLY {
        return None;
    }
    let stand = standing(bench, model, before);
    let (first, others) = stand.split_first()?;
    let changed = |by: &f64| {
        let mut way = first.way;
        way.factor *= by;
        Mend::of(bench, model, (first.recording, way))
    };
    if !BESIDE.iter().filter_map(changed).all(|other| other.misfit > first.misfit) {
        return None;
    }
    let others: Vec<(Way<'_>, String)> = others.iter().map(|m| m.told(bench)).collect();
    Some(Misread {
        fault: fault(first.told(bench), &others),
        channel: Some(first.way.name.to_owned()),
        only: Some(first.recording),
        factor: first.way.factor,
        model: model.clone(),
        fit: first.fit.clone(),
    })
}

/// The readings of one recording after which the model fits all of them; of several that fit alike the data cannot tell
/// which. A sensor is read wrong more easily than a command, and stands first.
fn standing<'m>(bench: &Bench, model: &'m Model, before: f64) -> Vec<Mend<'m>> {
    let of_one = |n: usize| {
        let moves = move |name: &str| spread_of(&bench.recordings[n..=n], name) > 0.0;
        readings(model, moves).map(move |way| (n, way))
    };
    let asked: Vec<(usize, Way<'m>)> = suspects(bench, model, before).into_iter().flat_map(of_one).collect();
    let mended = |one: &(usize, Way<'m>)| Mend::of(bench, model, *one);
    let mends: Vec<Option<Mend<'m>>> = asked.par_iter().with_max_len(1).map(mended).collect();
    let mut stand: Vec<Mend<'m>> =
        mends.into_iter().flatten().filter(|m| m.misfit < BETTER * before).collect();
    let least = stand.iter().map(|m| m.misfit).fold(f64::INFINITY, f64::min);
    stand.retain(|m| m.misfit < least / BESIDE[0]);
    stand.sort_by_key(|m| m.way.part);
    stand
}

/// The recordings without which the others fit far better, the likeliest first.
fn suspects(bench: &Bench, model: &Model, before: f64) -> Vec<usize> {
    let all = &bench.recordings;
    let without = |n: usize| {
        let others: Vec<Recording> =
            all.iter().enumerate().filter(|r| r.0 != n).map(|r| r.1.clone()).collect();
        Some((missed(&fitted(bench, model, &others)?, &others), n))
    };
    let left: Vec<Option<(f64, usize)>> = (0..all.len()).into_par_iter().map(without).collect();
    let mut found: Vec<(f64, usize)> = left.into_iter().flatten().filter(|l| l.0 < BETTER * before).collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.into_iter().take(MOST).map(|l| l.1).collect()
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
