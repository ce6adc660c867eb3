//! The answer of a diagnosis, as programs read it.

use super::catalogue::{self, Group};
use crate::simulate::Early;
use serde::{Deserialize, Serialize};

/// Name and version of the form.
pub const SCHEMA: &str = "gyrospec.diagnosis/2";

/// A number as JSON writes it: what is not finite becomes null.
#[allow(clippy::trivially_copy_pass_by_ref)] // the form that serde calls
fn number<S: serde::Serializer>(x: &f64, s: S) -> Result<S::Ok, S::Error> {
    if x.is_finite() { s.serialize_f64(*x) } else { s.serialize_none() }
}

/// What ended a search early, or false.
#[allow(clippy::trivially_copy_pass_by_ref, clippy::ref_option)] // the form that serde calls
fn early<S: serde::Serializer>(early: &Option<Early>, s: S) -> Result<S::Ok, S::Error> {
    match early {
        Some(early) => early.serialize(s),
        None => s.serialize_bool(false),
    }
}

/// What a diagnosis ends with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The model says all that the recording shows.
    NothingMissing,
    /// What is missing has a name.
    Named,
    /// Several names fit as well.
    Tie,
    /// Something is missing that no name fits.
    Unknown,
    /// The data are at fault, and show nothing physical beside that or leave the question open.
    DataFault,
    /// The recording cannot tell.
    NotIdentifiable,
}

impl Verdict {
    /// Whether what is missing has a name, or one of several.
    pub(super) fn has_names(self) -> bool {
        matches!(self, Self::Named | Self::Tie)
    }
}

/// A whole diagnosis; units are those of the model file.
#[derive(Debug, Clone, Serialize)]
pub struct Answer {
    /// Name and version of the form.
    pub schema: &'static str,
    /// The verdict: on the physics, by the data without their faults.
    pub verdict: Verdict,
    /// One paragraph in plain words.
    pub says: String,
    /// Whether anything is missing.
    pub detection: Detection,
    /// Where it sits.
    pub located: Located,
    /// What it is, largest share first; before that the faults, where the verdict is `data-fault`.
    pub findings: Vec<Finding>,
    /// What is wrong with the data.
    pub faults: Vec<DataFault>,
    /// What is left.
    pub unexplained: Option<Unexplained>,
    /// Before and after, an output each.
    pub proof: Vec<Proof>,
    /// What would tell more.
    pub next_experiment: Option<String>,
    /// The fitted parameters before and after.
    pub parameters: Vec<ParameterChange>,
    /// What a reader should know beside: what was not compared or not offered.
    pub notes: Vec<String>,
    /// How the answer was made.
    pub made: Made,
}

/// The test for anything missing.
#[derive(Debug, Clone, Serialize)]
pub struct Detection {
    /// Chance that all of it is noise.
    #[serde(serialize_with = "number")]
    pub p_value: f64,
    /// What this recording would have shown of each mechanism.
    pub smallest_visible: Vec<Visible>,
}

/// The smallest visible size of a mechanism.
#[derive(Debug, Clone, Serialize)]
pub struct Visible {
    /// Code.
    pub code: String,
    /// Where.
    pub site: SiteName,
    /// Its parameter.
    pub parameter: String,
    /// Its size.
    #[serde(serialize_with = "number")]
    pub value: f64,
    /// Unit.
    pub unit: String,
}

/// Where the mismatch sits: with the faults, where the verdict is `data-fault`.
#[derive(Debug, Clone, Serialize)]
pub struct Located {
    /// Sites that the data cannot tell apart.
    pub sites: Vec<SiteName>,
    /// Spans of time in order and apart, recording by recording; empty for everywhere.
    pub time: Vec<Spell>,
    /// Bands of angular frequency.
    pub bands: Vec<Band>,
    /// Signals that it goes with.
    pub signals: Vec<SignalChance>,
    /// What would tell the sites apart.
    pub separating_measurement: Option<String>,
}

/// A site.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct SiteName {
    /// state, input, output, parameter or definition.
    pub kind: String,
    /// Its name.
    pub name: String,
}

/// A span of time that the mismatch sits in, s.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Spell {
    /// First.
    pub from: f64,
    /// Last.
    pub to: f64,
    /// The recording whose clock it is, where there are several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub recording: Option<String>,
}

/// A span of time, s.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Stretch {
    /// First.
    pub from: f64,
    /// Last.
    pub to: f64,
}

/// A band of angular frequency with its share of the mismatch.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Band {
    /// rad/s.
    pub from: f64,
    /// rad/s.
    pub to: f64,
    /// Share, 0 to 1.
    pub share: f64,
}

/// A signal and the chance that the mismatch does not depend on it.
#[derive(Debug, Clone, Serialize)]
pub struct SignalChance {
    /// Name.
    pub name: String,
    /// Chance.
    #[serde(serialize_with = "number")]
    pub p_value: f64,
}

/// A mechanism found.
#[derive(Debug, Clone, Serialize)]
pub struct Finding {
    /// Code of the catalogue.
    pub code: String,
    /// Where.
    pub site: SiteName,
    /// The term in the equation.
    pub term: String,
    /// A sentence.
    pub says: String,
    /// Its parameters with 95 % intervals.
    pub parameters: Vec<Value>,
    /// Chance that it is noise.
    #[serde(serialize_with = "number")]
    pub p_value: f64,
    /// Share of the held-out improvement.
    #[serde(serialize_with = "number")]
    pub share: f64,
    /// Codes that fit as well.
    pub ties: Vec<String>,
    /// Whether it only resembles what is missing, and a law without a name stands in the model in its place.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub resembles: bool,
    /// What speaks for it beside the other findings; none for a fault of the data, or where it could not be left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub evidence: Option<Evidence>,
}

/// What speaks for one finding beside all others.
#[derive(Debug, Clone, Serialize)]
pub struct Evidence {
    /// ln of the ratio of the likelihoods with it and, refitted, without it.
    #[serde(serialize_with = "number")]
    pub log_likelihood_ratio: f64,
    /// Its parameters.
    pub degrees: usize,
    /// Chance that noise has such a ratio, for all that was tried.
    #[serde(serialize_with = "number")]
    pub p_value: f64,
    /// Share of the fall of the held-out error that is lost without it; printed, never judged.
    #[serde(serialize_with = "number")]
    pub holdout_share: f64,
}

/// A fault of the data.
#[derive(Debug, Clone, Serialize)]
pub struct DataFault {
    /// What it is and where.
    #[serde(flatten)]
    pub finding: Finding,
    /// Whether it was kept from the fit: its samples left out, or mended.
    pub masked: bool,
}

/// The code of an input that is held between its samples.
pub const INPUT_HOLD: &str = "input-hold";

/// The code of a law without a name.
pub const FREE_LAW: &str = catalogue::free_law::CODE;

impl DataFault {
    /// Whether it only says how an input runs between its samples, which is no fault of the data.
    pub fn is_reading(&self) -> bool {
        self.finding.code == INPUT_HOLD
    }

    /// Whether it is the model's own, not of the data.
    pub fn is_of_the_model(&self) -> bool {
        ["definition", "parameter"].contains(&self.finding.site.kind.as_str())
    }
}

/// What is at fault, in words, where faults have the verdict.
pub fn at_fault(faults: &[DataFault]) -> &'static str {
    if faults.iter().any(DataFault::is_of_the_model) {
        "A sign in the model is wrong"
    } else {
        "The data are at fault"
    }
}

/// Share of the held-out improvement from which on a finding stands in the sentence that says what was found.
const VISIBLE: f64 = 0.01;

impl Finding {
    /// Whether it is physics that explains less than 1 % of what was held out. The judgement on it rests on the fitted
    /// part and stands; only the sentence leaves it to the list.
    pub fn is_slight(&self) -> bool {
        self.share < VISIBLE && !self.is_fault()
    }

    /// Whether it is a fault of the data.
    pub fn is_fault(&self) -> bool {
        catalogue::find(&self.code).is_ok_and(|m| m.group == Group::Fault)
    }
}

/// The findings that a sentence names, faults of the data and mechanisms apart: without slight ones, unless there are
/// no others.
pub fn told(findings: &[Finding]) -> (Vec<&Finding>, Vec<&Finding>) {
    let all_slight = findings.iter().all(Finding::is_slight);
    findings.iter().filter(|f| all_slight || !f.is_slight()).partition(|f| f.is_fault())
}

/// A value with its 95 % interval.
#[derive(Debug, Clone, Serialize)]
pub struct Value {
    /// Name.
    pub name: String,
    /// Value.
    #[serde(serialize_with = "number")]
    pub value: f64,
    /// Lower end.
    #[serde(serialize_with = "number")]
    pub low: f64,
    /// Upper end.
    #[serde(serialize_with = "number")]
    pub high: f64,
    /// Unit.
    pub unit: String,
}

/// What no name explains.
#[derive(Debug, Clone, Serialize)]
pub struct Unexplained {
    /// Chance that it is noise.
    #[serde(serialize_with = "number")]
    pub p_value: f64,
    /// The signal that it goes with.
    pub signal: String,
    /// [signal, effect, low, high] along the signal.
    pub shape: Vec<[f64; 4]>,
}

/// One output before and after.
#[derive(Debug, Clone, Serialize)]
pub struct Proof {
    /// Output.
    pub output: String,
    /// Unit of all figures.
    pub unit: String,
    /// The metric.
    pub metric: &'static str,
    /// How the model runs.
    pub mode: &'static str,
    /// On the fitted part, before.
    #[serde(serialize_with = "number")]
    pub fit_before: f64,
    /// On the fitted part, after.
    #[serde(serialize_with = "number")]
    pub fit_after: f64,
    /// On the held-out part, before.
    #[serde(serialize_with = "number")]
    pub holdout_before: f64,
    /// On the held-out part, after.
    #[serde(serialize_with = "number")]
    pub holdout_after: f64,
    /// Lower end of the 95 % interval of the fall.
    #[serde(serialize_with = "number")]
    pub improvement_low: f64,
    /// Upper end.
    #[serde(serialize_with = "number")]
    pub improvement_high: f64,
    /// Level of the noise.
    #[serde(serialize_with = "number")]
    pub noise_floor: f64,
}

/// A parameter before and after.
#[derive(Debug, Clone, Serialize)]
pub struct ParameterChange {
    /// Name.
    pub name: String,
    /// With the model as given, refitted.
    #[serde(serialize_with = "number")]
    pub before: f64,
    /// With the findings.
    #[serde(serialize_with = "number")]
    pub after: f64,
    /// Lower end of the 95 % interval.
    #[serde(serialize_with = "number")]
    pub low: f64,
    /// Upper end.
    #[serde(serialize_with = "number")]
    pub high: f64,
    /// Unit.
    pub unit: String,
}

/// How an answer was made.
#[derive(Debug, Clone, Serialize)]
pub struct Made {
    /// Program and version.
    pub program: String,
    /// Seed.
    pub seed: u64,
    /// What ended the search before it was through: `steps` or `time`; `false` where it was through. Never
    /// with the verdict `nothing-missing`.
    #[serde(serialize_with = "early")]
    pub ended_early: Option<Early>,
    /// The files read.
    pub inputs: Vec<InputFile>,
}

/// A file with its hash.
#[derive(Debug, Clone, Serialize)]
pub struct InputFile {
    /// Path.
    pub file: String,
    /// SHA-256 in hexadecimal.
    pub sha256: String,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn finding(code: &str, share: f64, low: f64) -> Finding {
        let value = Value { name: "a".into(), value: 1.0, low, high: 2.0, unit: "1".into() };
        Finding {
            code: code.into(),
            site: SiteName { kind: "state".into(), name: "v".into() },
            term: String::new(),
            says: String::new(),
            parameters: vec![value],
            p_value: 0.0,
            share,
            ties: Vec::new(),
            resembles: false,
            evidence: None,
        }
    }

    #[test]
    fn a_sentence_parts_faults_from_mechanisms_and_leaves_slight_ones_out() {
        let all = [
            finding("outliers", 0.0, f64::NAN),
            finding("dry-friction", 0.979, 0.5),
            finding("output-offset", 0.012, 0.5),
            finding("linear-damping", 0.009, -1.0),
            finding("backlash", 1e-6, 0.5),
        ];
        let codes = |v: Vec<&Finding>| v.iter().map(|f| f.code.clone()).collect::<Vec<_>>();
        let (faults, others) = told(&all);
        assert_eq!(codes(faults), ["outliers"]);
        assert_eq!(codes(others), ["dry-friction", "output-offset"]);
        assert_eq!(told(&all[4..]).1.len(), 1);
    }
}
