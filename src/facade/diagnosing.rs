//! A model diagnosed against recordings.

use super::asking::Asking;
use crate::diagnose::answer::{Answer, DataFault, Finding, Proof, Verdict};
use crate::diagnose::{self as search, Diagnosis};
use crate::model::Model;
use crate::record::Recording;
use crate::report::diagnosis;
use crate::{Error, Result};
use std::fmt;

/// Asks what a model leaves out: fits it to recordings, locates the mismatch, names what was left out, and proves it
/// on what was held out.
///
/// ```
/// use gyrospec::{Model, Recording, Verdict, diagnose};
/// # let folder = tempfile::tempdir().unwrap();
/// # let file = folder.path().join("short.csv");
/// # std::fs::write(&file, "t [s],y [1]\n0,1\n1,0.6\n2,0.4\n3,0.2\n").unwrap();
/// let model = Model::parse(
///     "name = \"decay\"\n[parameters]\nT = { value = 1.0, unit = \"s\", min = 0.1, max = 10.0, fit = true }\n\
///      [states]\nx = { unit = \"1\", rate = \"-x/T\", initial = 1.0 }\n[outputs]\ny = { unit = \"1\", equals = \"x\" }\n",
/// )?;
/// let found = diagnose(&model, &[Recording::read(&file)?]).seed(1).run()?;
/// assert_eq!(found.verdict(), Verdict::NotIdentifiable); // four samples tell nothing
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn diagnose<'a>(model: &'a Model, recordings: &'a [Recording]) -> Diagnosing<'a> {
    Asking::new(model, recordings)
}

/// A diagnosis that is asked for; see [`diagnose`].
pub type Diagnosing<'a> = Asking<'a, Diagnosed>;

impl Diagnosing<'_> {
    /// Diagnoses the model.
    ///
    /// # Errors
    /// Where a channel is missing, recordings hold the same data, or the model cannot be simulated or fitted at all.
    pub fn run(self) -> Result<Diagnosed> {
        Ok(Diagnosed(search::diagnose(&self.request)?))
    }
}

/// What a model leaves out; see [`diagnose`].
pub struct Diagnosed(Diagnosis);

impl Diagnosed {
    /// Whether nothing is missing, something was named, or it cannot be told.
    pub fn verdict(&self) -> Verdict {
        self.0.answer.verdict
    }

    /// The verdict and its reasons in a paragraph.
    pub fn summary(&self) -> &str {
        &self.0.answer.says
    }

    /// What was found in the physics, the largest share first.
    pub fn findings(&self) -> &[Finding] {
        &self.0.answer.findings
    }

    /// What is wrong with the data.
    pub fn faults(&self) -> &[DataFault] {
        &self.0.answer.faults
    }

    /// The error before and after, on what was fitted and on what was held out, by output.
    pub fn proof(&self) -> &[Proof] {
        &self.0.answer.proof
    }

    /// What should be known though the work went on.
    pub fn notes(&self) -> &[String] {
        &self.0.answer.notes
    }

    /// The model with what was found, fitted.
    pub fn model(&self) -> &Model {
        &self.0.after.model
    }

    /// The diagnosis in words.
    pub fn text(&self) -> String {
        diagnosis::text(&self.0)
    }

    /// The diagnosis as JSON, schema `gyrospec.diagnosis/2`.
    ///
    /// # Errors
    /// `NotComputed`, should a number not be writable.
    pub fn json(&self) -> Result<String> {
        let text = serde_json::to_string_pretty(self.answer());
        text.map_err(|e| Error::not_computed(e.to_string()))
    }

    /// The diagnosis as one HTML page with pictures.
    pub fn html(&self) -> String {
        diagnosis::html(&self.0)
    }

    /// All of the answer, as the JSON has it.
    pub fn answer(&self) -> &Answer {
        &self.0.answer
    }
}

impl fmt::Debug for Diagnosed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Diagnosed").field("verdict", &self.verdict()).finish_non_exhaustive()
    }
}
