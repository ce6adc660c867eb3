//! Faulty data: found first, masked, and never turned into physics.

use super::answer::{Finding, SiteName, Value};
use super::bench::Bench;
use super::catalogue;
use crate::estimate::fit::Effort;
use crate::estimate::{Fit, fit};
use crate::model::Model;
use crate::record::quality::{self, Fault, FaultKind};
use crate::record::{Recording, unwrap};
use crate::units::{Unit, counted, significant};

/// Faults of the channels that a model uses, and the recordings without them.
pub struct Cleaned {
    /// Faults that nothing honest looks like, in channels that the model uses.
    pub faults: Vec<Fault>,
    /// The recordings with the spoiled samples made gaps.
    pub recordings: Vec<Recording>,
}

/// A misfit of up to so many times q/√12 is that of the steps alone.
const STEPS_ALONE: f64 = 1.3;

/// Looks for faults and masks them.
pub fn clean(model: &Model, recordings: &[Recording]) -> Cleaned {
    let used = |name: &str| {
        model.inputs.iter().any(|i| i.name == name) || model.outputs.iter().any(|o| o.name == name)
    };
    let mut all = Vec::new();
    let mut cleaned = Vec::new();
    for r in recordings {
        let mut faults = quality::faults(r);
        faults.retain(|f| f.sure && used(&f.channel));
        let mut recording = quality::masked(r, &faults);
        for f in faults.iter().filter(|f| f.kind == FaultKind::WrappedAngle) {
            for c in recording.channels.iter_mut().filter(|c| c.name == f.channel) {
                unwrap(&mut c.values);
                c.wraps = true;
            }
        }
        fill_inputs(model, &mut recording);
        cleaned.push(recording);
        all.extend(faults);
    }
    Cleaned { faults: all, recordings: cleaned }
}

/// Outputs whose misfit is no more than their own coarse steps q leave, q/√12: better physics
/// could not be seen in them.
pub fn coarse(model: &Model, recordings: &[Recording], base: &Fit) -> Vec<Fault> {
    let outputs = model.outputs.iter().zip(&base.rmse);
    let step = |name: &str| recordings.iter().filter_map(|r| r.find(name)).find_map(quality::coarse_steps);
    outputs
        .filter_map(|(o, rmse)| Some((step(&o.name)?, rmse)))
        .filter(|(fault, rmse)| **rmse < STEPS_ALONE * fault.size / 12_f64.sqrt())
        .map(|(fault, _)| fault)
        .collect()
}

/// Short masked stretches of inputs are bridged by straight lines, so that the simulation goes on.
fn fill_inputs(model: &Model, recording: &mut Recording) {
    for c in &mut recording.channels {
        if !model.inputs.iter().any(|i| i.name == c.name) {
            continue;
        }
        let known: Vec<usize> = (0..c.values.len()).filter(|i| c.values[*i].is_finite()).collect();
        for pair in known.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            if b > a + 1 && b - a <= 12 {
                for i in a + 1..b {
                    let share = (c.time[i] - c.time[a]) / (c.time[b] - c.time[a]);
                    c.values[i] = c.values[a] + share * (c.values[b] - c.values[a]);
                }
            }
        }
    }
}

/// A number of at most seven digits.
fn short(x: f64) -> String {
    let text = significant(x, 7);
    if text.contains('.') && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        text
    }
}

/// A fault as a finding.
pub fn finding(model: &Model, recordings: &[Recording], f: &Fault) -> Finding {
    let kind = if model.inputs.iter().any(|i| i.name == f.channel) { "input" } else { "output" };
    let unit = recordings.iter().find_map(|r| r.find(&f.channel)).map(|c| c.unit.clone());
    let place = f.spans.first().map_or_else(String::new, |s| {
        let (from, to) = (short(s.from), short(s.to));
        if from == to { format!(" at {from} s") } else { format!(" from {from} s to {to} s") }
    });
    let more = match f.spans.len() {
        0 | 1 => String::new(),
        2 => ", and once more".into(),
        n => format!(", and {} more times", n - 1),
    };
    let first = if f.spans.len() > 1 { format!(", first{place}") } else { place.clone() };
    let samples = counted(f.samples, "sample");
    let (name, value, unit_text) = match (f.kind, unit) {
        (FaultKind::Gap, _) => ("length", f.size, "s".to_string()),
        (FaultKind::ClockDrift, _) | (_, None) => ("relative", f.size, "1".to_string()),
        (FaultKind::Frozen, Some(u)) => ("value", u.from_si(f.size), u.text().to_string()),
        (_, Some(u)) => ("size", u.difference_from_si(f.size), u.of_differences().text().to_string()),
    };
    let title = catalogue::find(f.kind.code()).map(|m| m.title).unwrap_or_default();
    let what = match f.kind {
        FaultKind::Frozen => format!("{} is stuck at {} {unit_text}{place}{more}", f.channel, short(value)),
        FaultKind::Outliers => format!("{} has {samples} far off{first}", f.channel),
        FaultKind::Gap => format!("{} lacks {samples}{first}", f.channel),
        FaultKind::Quantisation => format!("{} moves in steps of {} {unit_text}", f.channel, short(value)),
        FaultKind::WrappedAngle => format!("{} jumps by a turn and is not marked `wraps = true`", f.channel),
        FaultKind::ClockDrift => format!("the clock of {} changes its rate{place}", f.channel),
    };
    Finding {
        code: f.kind.code().to_string(),
        site: SiteName { kind: kind.to_string(), name: f.channel.clone() },
        term: title.to_string(),
        says: what,
        parameters: vec![Value {
            name: name.to_string(),
            value,
            low: f64::NAN,
            high: f64::NAN,
            unit: unit_text,
        }],
        p_value: 0.0,
        share: 0.0,
        ties: Vec::new(),
    }
}

/// Factors between units that people confuse, with words.
const FACTORS: [(f64, &str, &str); 12] = [
    (std::f64::consts::PI / 180.0, "degrees for radians", "rad"),
    (180.0 / std::f64::consts::PI, "radians for degrees", "rad"),
    (1852.0 / 3600.0, "knots for metres a second", "m/s"),
    (3600.0 / 1852.0, "metres a second for knots", "m/s"),
    (1e3, "a thousandth for the whole", ""),
    (1e-3, "the whole for a thousandth", ""),
    (10.0, "a tenth for the whole", ""),
    (0.1, "the whole for a tenth", ""),
    (9.80665, "g for metres a second squared", "m/s^2"),
    (1.0 / 9.80665, "metres a second squared for g", "m/s^2"),
    (60.0, "minutes for seconds, or the other way", "s"),
    (1.0 / 60.0, "seconds for minutes, or the other way", "s"),
];

/// Factors that a unit can be wrong by, and −1; those of angles hold for their rates too.
fn factors(unit: &Unit) -> Vec<(f64, &'static str)> {
    let own = |word: &str| {
        let is = |u: Unit| unit.dimension() == u.dimension();
        let rate = word == "rad" && Unit::parse("rad/s").is_ok_and(is);
        rate || Unit::parse(word).is_ok_and(is)
    };
    let known = FACTORS.iter().filter(|f| f.2.is_empty() || own(f.2)).map(|f| (f.0, f.1));
    std::iter::once((-1.0, "")).chain(known).collect()
}

/// A channel that fits only turned over or in another unit.
pub struct Misread {
    /// The finding.
    pub finding: Finding,
    /// The recordings mended.
    pub recordings: Vec<Recording>,
    /// The model fitted to them.
    pub fit: Fit,
}

/// Looks for a channel of the wrong sign or unit, where the model as given fits badly.
pub fn misread(bench: &Bench, model: &Model, base: &Fit) -> Option<Misread> {
    let spread = |name: &str| bench.spread(name);
    let badly = model.outputs.iter().zip(&base.rmse).any(|(o, r)| *r > 0.3 * spread(&o.name));
    if !badly {
        return None;
    }
    let channels = model
        .inputs
        .iter()
        .map(|i| (&i.name, &i.unit, "input"))
        .chain(model.outputs.iter().map(|o| (&o.name, &o.unit, "output")));
    let mut best: Option<(f64, Misread)> = None;
    for (channel, unit, kind) in channels {
        for (factor, words) in factors(unit) {
            let mut recordings = bench.recordings.clone();
            let own = recordings.iter_mut().flat_map(|r| &mut r.channels).filter(|c| c.name == *channel);
            own.for_each(|c| c.values.iter_mut().for_each(|v| *v *= factor));
            let Ok(f) = fit(model, &recordings, &bench.options(Effort::Near, 10)) else { continue };
            // Outputs are compared relative to their own size.
            let relative = |f: &Fit, scaled: bool| -> f64 {
                model
                    .outputs
                    .iter()
                    .zip(&f.rmse)
                    .map(|(o, r)| {
                        r / (spread(&o.name) * if scaled && o.name == *channel { factor.abs() } else { 1.0 })
                    })
                    .fold(0.0, f64::max)
            };
            let value = relative(&f, true);
            if value < 0.25 * relative(base, false) && best.as_ref().is_none_or(|b| value < b.0) {
                let finding = misread_finding(channel, kind, factor, words);
                best = Some((value, Misread { finding, recordings, fit: f }));
            }
        }
    }
    best.map(|b| b.1)
}

fn misread_finding(channel: &str, kind: &str, factor: f64, words: &str) -> Finding {
    let sign = factor == -1.0;
    let says = if sign {
        format!("{channel} has the wrong sign: turned over, it fits")
    } else {
        format!("{channel} holds {words}: multiplied by {}, it fits", short(factor))
    };
    Finding {
        code: if sign { "wrong-sign" } else { "wrong-unit" }.to_string(),
        site: SiteName { kind: kind.to_string(), name: channel.to_string() },
        term: format!("{}*{channel}", short(factor)),
        says,
        parameters: vec![Value {
            name: "factor".into(),
            value: factor,
            low: f64::NAN,
            high: f64::NAN,
            unit: "1".into(),
        }],
        p_value: 0.0,
        share: 0.0,
        ties: Vec::new(),
    }
}
