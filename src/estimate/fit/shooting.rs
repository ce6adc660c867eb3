//! Starts by multiple shooting.
//!
//! # Purpose
//! Over a long run a slightly wrong period or a drifting start hides the way to the minimum; over
//! short segments, each with its own initial states, it does not.
//!
//! # Method
//! The fitted spans are cut into 8, then 4, then 2 segments a recording; every segment starts from the
//! measured states; parameters are carried from stage to stage.
//!
//! # References
//! H. G. Bock, Recent advances in parameter identification for ODEs, Birkhäuser 1983; L. A. Aguirre
//! and others on the path from one-step to free-run error, Signal Processing 90 (2010).

use super::harness::Record;
use super::options::FitOptions;
use super::problem::{given, problem};
use super::setup;
use crate::estimate::least_squares::{Stopping, minimise};
use crate::model::{Initial, Model};
use crate::record::{Recording, Span};

/// Segments a recording, stage by stage.
const STAGES: [usize; 3] = [8, 4, 2];

/// All parameters after the last stage that could be run; None if none could.
pub fn shoot(
    model: &Model,
    recordings: &[Recording],
    options: &FitOptions<'_>,
    start: &[f64],
) -> Option<Vec<f64>> {
    let mut loose = model.clone();
    for state in &mut loose.states {
        state.initial = Initial::Fit;
    }
    let quick = FitOptions {
        stopping: Stopping { iterations: 15, reduction: 1e-4, ..options.stopping },
        weighting: super::options::Weighting::FreeRun,
        initials: Vec::new(),
        ..options.clone()
    };
    let mut parameters = start.to_vec();
    let mut reached = None;
    for segments in STAGES {
        let records = cut(&loose, recordings, segments, &quick);
        if records.is_empty() {
            continue;
        }
        let p = problem(&loose, &records, parameters.clone(), &quick);
        let ranges = setup::ranges(&loose, &p.free, &records);
        if let Ok(minimum) = minimise(&p, &given(&p), &ranges, quick.stopping) {
            parameters = p.spread(&minimum.x).0;
            reached = Some(parameters.clone());
        }
    }
    reached
}

/// The records of all segments that hold samples.
fn cut(model: &Model, recordings: &[Recording], segments: usize, options: &FitOptions<'_>) -> Vec<Record> {
    let mut records = Vec::new();
    for (number, recording) in recordings.iter().enumerate() {
        for span in setup::spans(model, recording, options).fit {
            let length = span.length() / segments as f64;
            for k in 0..segments {
                let from = span.from + length * k as f64;
                let piece = [Span::new(from, from + length)];
                records.extend(setup::record(model, recording, number, &piece, options).ok());
            }
        }
    }
    records
}
