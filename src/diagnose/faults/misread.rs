//! Channels of the wrong sign or unit: what fits only turned over or by another factor.

use super::short;
use crate::diagnose::answer::{DataFault, Finding, SiteName, Value};
use crate::diagnose::bench::Bench;
use crate::diagnose::choose::{CHANCE, TIE};
use crate::diagnose::measure::chance;
use crate::estimate::fit::Effort;
use crate::estimate::{Fit, fit};
use crate::model::Model;
use crate::record::Recording;
use crate::units::Unit;
use rayon::prelude::*;

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

/// A way to mend a channel, with the model fitted after it.
struct Mend<'m> {
    channel: &'m str,
    /// input or output.
    kind: &'static str,
    factor: f64,
    words: &'static str,
    fit: Fit,
    /// The largest misfit of an output as a share of its size.
    misfit: f64,
    /// Log-likelihood, outputs relative to their sizes.
    likelihood: f64,
}

/// Looks for a channel of the wrong sign or unit, where the model as given fits badly. A channel that never
/// changes has no sign and no unit that could be seen: what acts as evenly is as likely. In a linear model an
/// input too large is an output too small: what fits as well is told beside.
pub fn misread(bench: &Bench, model: &Model, base: &Fit) -> Option<Misread> {
    let before = relative(bench, base, "", 1.0).into_iter().fold(0.0, f64::max);
    if before <= BADLY {
        return None;
    }
    let (mends, tried) = mends(bench, model);
    // 2 Δln L = n ln(S₀/S₁), the factor one more unknown.
    let is_sure = |m: &Mend<'_>| {
        let samples = independent(&m.fit);
        let degrees = samples - m.fit.values.len() as f64 - 1.0;
        tried as f64 * chance(2.0 * samples * (before / m.misfit).ln(), 1, samples, degrees) < CHANCE
    };
    let mut stand: Vec<Mend<'_>> =
        mends.into_iter().filter(|m| m.misfit < BETTER * before && is_sure(m)).collect();
    let most = stand.iter().map(|m| m.likelihood).fold(f64::NEG_INFINITY, f64::max);
    stand.retain(|m| m.likelihood > most - TIE);
    // A sensor is mounted the wrong way round more easily than a command is given so.
    stand.sort_by_key(|m| m.kind == "input");
    let first = stand.first()?;
    let fault = fault(first, &stand[1..]);
    let Mend { channel, factor, fit, .. } = stand.swap_remove(0);
    Some(Misread { fault, channel: channel.to_string(), factor, fit })
}

/// Every channel that moves, turned over and in every unit that it may be in, with how many were tried.
fn mends<'m>(bench: &Bench, model: &'m Model) -> (Vec<Mend<'m>>, usize) {
    let inputs = model.inputs.iter().map(|i| (&i.name, &i.unit, "input"));
    let channels = inputs.chain(model.outputs.iter().map(|o| (&o.name, &o.unit, "output")));
    let ways = channels.filter(|c| bench.moves(c.0)).flat_map(|(channel, unit, kind)| {
        factors(unit).into_iter().map(move |(factor, words)| (channel, kind, factor, words))
    });
    let ways: Vec<(&'m String, &'static str, f64, &'static str)> = ways.collect();
    let mend = |&(channel, kind, factor, words): &(&'m String, &'static str, f64, &'static str)| {
        let mut recordings = bench.recordings.clone();
        scale(&mut recordings, channel, factor);
        let fit = fit(model, &recordings, &bench.options(Effort::Near, 10)).ok()?;
        let shares = relative(bench, &fit, channel, factor);
        let misfit = shares.iter().copied().fold(0.0, f64::max);
        let of = |(k, share): (usize, &f64)| -share.ln() * samples_of(&fit, k);
        let likelihood = shares.iter().enumerate().map(of).sum();
        Some(Mend { channel: channel.as_str(), kind, factor, words, fit, misfit, likelihood })
    };
    (ways.par_iter().with_max_len(1).filter_map(mend).collect(), ways.len())
}

/// The misfit of each output as a share of its own size, one channel scaled.
fn relative(bench: &Bench, fit: &Fit, scaled: &str, factor: f64) -> Vec<f64> {
    let pairs = fit.model.outputs.iter().zip(&fit.rmse);
    let share = |(o, r): (&crate::model::Output, &f64)| {
        let factor = if o.name == scaled { factor.abs() } else { 1.0 };
        r / (bench.spread(&o.name) * factor)
    };
    pairs.map(share).collect()
}

/// Independent samples of an output in a fit.
fn samples_of(fit: &Fit, output: usize) -> f64 {
    let series = fit.records.iter().flat_map(|r| &r.series).filter(|s| s.output == output);
    series.map(|s| s.residual.len()).sum::<usize>() as f64 / fit.noise[output].decimation as f64
}

fn independent(fit: &Fit) -> f64 {
    (0..fit.noise.len()).map(|k| samples_of(fit, k)).sum()
}

/// What is wrong with a channel, in words.
fn wrong(m: &Mend<'_>) -> String {
    if is_turned(m) {
        format!("{} has the wrong sign: turned over, it fits", m.channel)
    } else {
        format!("{} holds {}: multiplied by {}, it fits", m.channel, m.words, short(m.factor))
    }
}

fn is_turned(m: &Mend<'_>) -> bool {
    m.factor == -1.0
}

fn code(m: &Mend<'_>) -> &'static str {
    if is_turned(m) { "wrong-sign" } else { "wrong-unit" }
}

fn fault(m: &Mend<'_>, others: &[Mend<'_>]) -> DataFault {
    let mut says = wrong(m);
    if !others.is_empty() {
        let as_well: Vec<String> = others.iter().map(|o| format!("or {}", wrong(o))).collect();
        says += &format!(" ({}: the data cannot tell which)", as_well.join(", "));
    }
    let mut ties: Vec<String> = others.iter().map(code).filter(|c| *c != code(m)).map(String::from).collect();
    ties.dedup();
    let finding = Finding {
        code: code(m).to_string(),
        site: SiteName { kind: m.kind.to_string(), name: m.channel.to_string() },
        term: format!("{}*{}", short(m.factor), m.channel),
        says,
        parameters: vec![Value {
            name: "factor".into(),
            value: m.factor,
            low: f64::NAN,
            high: f64::NAN,
            unit: "1".into(),
        }],
        p_value: 0.0,
        share: 0.0,
        ties,
        resembles: false,
        evidence: None,
    };
    DataFault { finding, masked: true }
}
