//! Locate the mismatch, name what was left out, prove it.
//!
//! [`diagnose`] fits a model to recordings, looks for faults of the data, searches the catalogue for
//! what the model leaves out, and proves what it finds on what was held out.

pub mod answer;
mod apart;
mod assemble;
pub mod bench;
pub mod catalogue;
mod choose;
mod company;
mod faults;
pub mod laboratory;
mod locate;
mod measure;
mod next;
pub mod pictures;
mod propose;
pub mod prove;
mod race;
mod response;
mod rest;
mod screen;
mod search;
mod verdict;
mod watch;
mod words;

use crate::Result;
use crate::estimate::Fit;
use crate::estimate::fit::Progress;
use crate::model::Model;
use crate::record::{Recording, Source};
use answer::Answer;
use bench::Bench;
use prove::Held;

/// What is to be diagnosed.
pub struct Request<'a> {
    /// The model.
    pub model: &'a Model,
    /// The model's file, for the list of inputs.
    pub source: Option<&'a Source>,
    /// Recordings that are fitted.
    pub recordings: &'a [Recording],
    /// Recordings that are held out whole.
    pub separate: &'a [Recording],
    /// Seed of everything random.
    pub seed: u64,
    /// Who hears the progress.
    pub progress: &'a dyn Progress,
}

/// A diagnosis with all that a report draws.
pub struct Diagnosis {
    /// The answer.
    pub answer: Answer,
    /// The model as given, fitted.
    pub before: Fit,
    /// The model with the findings, fitted.
    pub after: Fit,
    /// Residuals before and after on what was held out, by output.
    pub held: (Vec<Held>, Vec<Held>),
    /// The recordings as they were fitted, faults masked.
    pub recordings: Vec<Recording>,
    /// The series behind the pictures.
    pub pictures: pictures::Pictures,
}

/// Diagnoses a model against recordings.
///
/// # Errors
/// Where a channel is missing, or the model cannot be simulated or fitted at all.
pub fn diagnose(request: &Request<'_>) -> Result<Diagnosis> {
    let model = request.model;
    request.progress.says("looking for faults in the data", None);
    let cleaned = faults::clean(model, request.recordings);
    let separate = faults::clean(model, request.separate);
    let mut bench = Bench::new(model, cleaned.recordings, !request.separate.is_empty(), request.seed);
    request.progress.says("fitting the model as it stands", None);
    let mut base = bench.full_fit(model)?;
    let mut found_faults: Vec<answer::Finding> = cleaned
        .faults
        .iter()
        .chain(&separate.faults)
        .chain(&faults::coarse(model, &bench.recordings, &base))
        .map(|f| faults::finding(model, request.recordings, f))
        .collect();
    let spoiled = [cleaned.faults, separate.faults].concat();
    if let Some(misread) = faults::misread(&bench, model, &base) {
        found_faults.push(misread.finding);
        bench.recordings = misread.recordings;
        base = misread.fit;
    }
    let given: Vec<f64> = model.parameters.iter().map(|p| p.value).collect();
    let found = search::search(&bench, base, &given, request.progress)?;
    request.progress.says("running what was held out", None);
    assemble::Assembly { request, bench, separate: separate.recordings, found, faults: found_faults }
        .finish(&spoiled)
}
