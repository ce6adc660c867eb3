//! Channels of the wrong sign or unit: what fits only turned over or by another factor.

use super::short;
use crate::diagnose::answer::{DataFault, Finding, SiteName, Value};
use crate::diagnose::bench::Bench;
use crate::estimate::fit::Effort;
use crate::estimate::{Fit, fit};
use crate::model::Model;
use crate::record::Recording;
use crate::units::Unit;

/// Share of an output's spread from which on a misfit is bad.
const BADLY: f64 = 0.3;
/// Share of that misfit that a mended channel may leave.
const BETTER: f64 = 0.25;

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
    /// The fault.
    pub fault: DataFault,
    /// The channel.
    channel: String,
    /// What it is multiplied by.
    factor: f64,
    /// The model fitted to the recordings mended.
    pub fit: Fit,
}

impl Misread {
    /// Mends recordings.
    pub fn mend(&self, recordings: &mut [Recording]) {
        scale(recordings, &self.channel, self.factor);
    }
}

fn scale(recordings: &mut [Recording], channel: &str, factor: f64) {
    let own = recordings.iter_mut().flat_map(|r| &mut r.channels).filter(|c| c.name == channel);
    own.for_each(|c| c.values.iter_mut().for_each(|v| *v *= factor));
}

/// Looks for a channel of the wrong sign or unit, where the model as given fits badly. A channel that never
/// changes has no sign and no unit that could be seen: what acts as evenly is as likely.
pub fn misread(bench: &Bench, model: &Model, base: &Fit) -> Option<Misread> {
    // Outputs are compared relative to their own size.
    let relative = |f: &Fit, scaled: &str, factor: f64| -> f64 {
        let pairs = model.outputs.iter().zip(&f.rmse);
        let shares = pairs.map(|(o, r)| {
            let factor = if o.name == scaled { factor.abs() } else { 1.0 };
            r / (bench.spread(&o.name) * factor)
        });
        shares.fold(0.0, f64::max)
    };
    let before = relative(base, "", 1.0);
    if before <= BADLY {
        return None;
    }
    let inputs = model.inputs.iter().map(|i| (&i.name, &i.unit, "input"));
    let channels = inputs.chain(model.outputs.iter().map(|o| (&o.name, &o.unit, "output")));
    let mut best: Option<(f64, Misread)> = None;
    for (channel, unit, kind) in channels.filter(|c| bench.moves(c.0)) {
        for (factor, words) in factors(unit) {
            let mut recordings = bench.recordings.clone();
            scale(&mut recordings, channel, factor);
            let Ok(fit) = fit(model, &recordings, &bench.options(Effort::Near, 10)) else { continue };
            let value = relative(&fit, channel, factor);
            if value < BETTER * before && best.as_ref().is_none_or(|b| value < b.0) {
                let fault = fault(channel, kind, factor, words);
                best = Some((value, Misread { fault, channel: channel.clone(), factor, fit }));
            }
        }
    }
    best.map(|b| b.1)
}

fn fault(channel: &str, kind: &str, factor: f64, words: &str) -> DataFault {
    let sign = factor == -1.0;
    let says = if sign {
        format!("{channel} has the wrong sign: turned over, it fits")
    } else {
        format!("{channel} holds {words}: multiplied by {}, it fits", short(factor))
    };
    let finding = Finding {
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
    };
    DataFault { finding, masked: true }
}
