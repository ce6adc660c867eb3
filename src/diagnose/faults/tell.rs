//! A fault in words.

use super::{is_input, short};
use crate::diagnose::answer::{DataFault, Finding, SiteName, Value};
use crate::diagnose::catalogue;
use crate::model::Model;
use crate::record::Recording;
use crate::record::quality::{Fault, FaultKind};
use crate::units::counted;

/// A fault of a recording as it is told; `place` names the recording where there are several.
pub fn told(model: &Model, recording: &Recording, f: &Fault, place: &str) -> DataFault {
    let kind = if is_input(model, &f.channel) == Some(true) { "input" } else { "output" };
    let (name, value, unit) = size(recording, f);
    let in_it = if place.is_empty() { String::new() } else { format!(" in “{place}”") };
    let finding = Finding {
        code: f.kind.code().to_string(),
        site: SiteName { kind: kind.to_string(), name: f.channel.clone() },
        term: catalogue::find(f.kind.code()).map(|m| m.title).unwrap_or_default().to_string(),
        says: sentence(f, value, &unit) + &in_it,
        parameters: vec![Value { name: name.to_string(), value, low: f64::NAN, high: f64::NAN, unit }],
        p_value: 0.0,
        share: 0.0,
        ties: Vec::new(),
        resembles: false,
        evidence: None,
    };
    DataFault { finding, masked: f.kind != FaultKind::Quantisation }
}

/// What is told of its size: name, value and unit.
fn size(recording: &Recording, f: &Fault) -> (&'static str, f64, String) {
    let unit = recording.find(&f.channel).map(|c| c.unit.clone());
    match (f.kind, unit) {
        (FaultKind::Gap, _) => ("length", f.size, "s".to_string()),
        (FaultKind::ClockDrift, _) | (_, None) => ("relative", f.size, "1".to_string()),
        (FaultKind::Frozen, Some(u)) => ("value", u.from_si(f.size), u.text().to_string()),
        (_, Some(u)) => ("size", u.difference_from_si(f.size), u.of_differences().text().to_string()),
    }
}

fn sentence(f: &Fault, value: f64, unit: &str) -> String {
    let at = f.spans.first().map_or_else(String::new, |s| {
        let (from, to) = (short(s.from), short(s.to));
        if from == to { format!(" at {from} s") } else { format!(" from {from} s to {to} s") }
    });
    let more = match f.spans.len() {
        0 | 1 => String::new(),
        2 => ", and once more".into(),
        n => format!(", and {} more times", n - 1),
    };
    let first = if f.spans.len() > 1 { format!(", first{at}") } else { at.clone() };
    let (channel, samples) = (&f.channel, counted(f.samples, "sample"));
    match f.kind {
        FaultKind::Frozen => format!("{channel} is stuck at {} {unit}{at}{more}", short(value)),
        FaultKind::Outliers => format!("{channel} has {samples} far off{first}"),
        FaultKind::Gap => format!("{channel} lacks {samples}{first}"),
        FaultKind::Quantisation => format!("{channel} moves in steps of {} {unit}", short(value)),
        FaultKind::WrappedAngle => format!("{channel} jumps by a turn and is not marked `wraps = true`"),
        FaultKind::ClockDrift => format!("the clock of {channel} changes its rate{at}"),
    }
}
