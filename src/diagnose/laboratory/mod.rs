//! The laboratory: effects concealed in made recordings, and how often the diagnosis finds them.
//!
//! # Purpose
//! Measure power, wrong names, false alarms and the coverage of intervals of the very path that a user
//! takes: a model file and a recording file in, an answer out.
//!
//! # Method
//! A mechanism of the catalogue, drawn at random with a drawn size, is put into a model (or none, or
//! two, or a term that the catalogue does not have), simulated by a stepper of its own on the inputs of
//! a recording, and covered with coloured noise. The truth is written and sealed before the first
//! diagnosis and opened after the last.
//!
//! # References
//! P. Young, Recursive Estimation and Time-Series Analysis (2011), on data-based model tests.

mod maker;
mod stepper;
mod table;

pub use maker::{Case, Draw, Kind, Scenario, make};
pub use stepper::Stepper;
pub use table::{Outcome, tabulate};

use super::answer::{Answer, Value, Verdict};
use super::{Request, diagnose};
use crate::Result;
use crate::estimate::fit::Silent;
use crate::model::Model;
use crate::record::Recording;
use std::path::Path;

/// Diagnoses one case from its files alone.
///
/// # Errors
/// Where the files cannot be read or the model cannot be fitted.
pub fn examine(folder: &Path, number: usize, seed: u64) -> Result<Answer> {
    let model = Model::read(folder.join(format!("model-{number}.toml")))?;
    let recordings = [Recording::read(folder.join(format!("case-{number}.csv")))?];
    let request = Request {
        model: &model,
        source: None,
        recordings: &recordings,
        separate: &[],
        time_limit: None,
        seed,
        progress: &Silent,
    };
    Ok(diagnose(&request)?.answer)
}

/// Compares an answer with the truth.
pub fn judge(case: &Case, answer: &Answer) -> Outcome {
    let named: Vec<&str> = answer
        .findings
        .iter()
        .flat_map(|f| std::iter::once(f.code.as_str()).chain(f.ties.iter().map(String::as_str)))
        .collect();
    let claims = matches!(answer.verdict, Verdict::Named | Verdict::Tie);
    let right = case.codes.iter().all(|c| named.contains(&c.as_str()));
    let own = answer.findings.iter().filter(|f| case.codes.contains(&f.code));
    let own: Vec<&Value> = own.flat_map(|f| &f.parameters).collect();
    let value = |name: &str| own.iter().find(|p| p.name == name);
    let covered = case
        .values
        .iter()
        .filter_map(|(name, truth)| {
            let p = value(name).filter(|p| p.low.is_finite() && p.high.is_finite())?;
            Some((p.low..=p.high).contains(truth))
        })
        .collect();
    Outcome { verdict: answer.verdict, right, claims, covered: if right { covered } else { Vec::new() } }
}
