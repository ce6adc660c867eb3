//! The laboratory: effects concealed in made recordings, and how often the diagnosis finds them.
//!
//! # Purpose
//! Measure power, wrong names, false alarms and the coverage of intervals of the very path that a user
//! takes: a model file and a recording file in, an answer out.
//!
//! # Method
//! A plant is drawn with its inputs. A mechanism of the catalogue, drawn at random with a drawn size, is put into its
//! model (or none, or two, or a term that the catalogue does not have), simulated by a stepper of its own, and covered
//! with noise so that what is left when the model without it is fitted, of two without either, is some times as large as
//! the noise. The truth is written and sealed before the first diagnosis and opened after the last.
//!
//! # References
//! P. Young, Recursive Estimation and Time-Series Analysis (2011), on data-based model tests.

mod conceal;
mod judge;
mod maker;
pub mod plants;
mod scenario;
mod stepper;
mod table;

pub use judge::{Judged, Outcome, judge};
pub use maker::{Case, Draw, Hidden, Kind, make};
pub use scenario::Scenario;
pub use stepper::Stepper;
pub use table::tabulate;

use super::answer::{Answer, Finding, Value, Verdict};
use super::{Request, diagnose};
use crate::Result;
use crate::estimate::fit::Silent;
use crate::model::Model;
use crate::record::Recording;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What was said of one case, as far as it is judged.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Said {
    /// The verdict.
    pub verdict: Verdict,
    /// What was found.
    pub findings: Vec<Named>,
}

/// One finding.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Named {
    /// Its code.
    pub code: String,
    /// Name of what it acts on.
    pub place: String,
    /// The term in the equation.
    pub term: String,
    /// Codes that fit as well.
    pub ties: Vec<String>,
    /// Whether it only resembles what is missing.
    pub resembles: bool,
    /// The ends of its parameters' intervals, where they have both.
    intervals: Vec<(String, f64, f64)>,
}

impl Named {
    fn of(finding: &Finding) -> Self {
        let bounded = |p: &&Value| p.low.is_finite() && p.high.is_finite();
        let ends = |p: &Value| (p.name.clone(), p.low, p.high);
        Self {
            code: finding.code.clone(),
            place: finding.site.name.clone(),
            term: finding.term.clone(),
            resembles: finding.resembles,
            ties: finding.ties.clone(),
            intervals: finding.parameters.iter().filter(bounded).map(ends).collect(),
        }
    }

    /// Whether it or a tie of it has a code.
    fn is_of(&self, code: &str) -> bool {
        std::iter::once(&self.code).chain(&self.ties).any(|c| c == code)
    }
}

impl Said {
    fn of(answer: &Answer) -> Self {
        Self { verdict: answer.verdict, findings: answer.findings.iter().map(Named::of).collect() }
    }
}

/// Diagnoses one case from its files alone.
///
/// # Errors
/// Where the files cannot be read or the model cannot be fitted.
pub fn examine(folder: &Path, number: usize, seed: u64) -> Result<Said> {
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
    Ok(Said::of(&diagnose(&request)?.answer))
}
