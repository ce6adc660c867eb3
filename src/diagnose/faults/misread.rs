//! Channels of the wrong sign or unit, and parts of the model with the wrong sign: what fits only turned over or by
//! another factor.

use super::short;
use crate::diagnose::answer::{DataFault, Finding, SiteName, Value};
use crate::diagnose::bench::Bench;
use crate::diagnose::catalogue::edit;
use crate::diagnose::choose::{CHANCE, TIE};
use crate::diagnose::measure::chance;
use crate::estimate::fit::{Effort, ParameterEstimate, Status};
use crate::estimate::{Fit, fit};
use crate::expression::{BinaryOp, Expr};
use crate::model::{Model, Parameter};
use crate::record::Recording;
use crate::units::{Unit, significant};
use rayon::prelude::*;

/// Share of an output's spread from which on a misfit is bad.
pub(super) const BADLY: f64 = 0.3;
/// Share of that misfit that a mended channel may leave.
pub(super) const BETTER: f64 = 0.25;

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

/// What fits only turned over or in another unit.
pub struct Misread {
    /// The fault.
    pub fault: DataFault,
    /// The channel, where it is one.
    pub(super) channel: Option<String>,
    /// The number of the fitted recording in which alone it is so; none where it is so in all.
    pub(super) only: Option<usize>,
    /// What it is multiplied by.
    pub(super) factor: f64,
    /// The model as given, with what is its own mended.
    pub model: Model,
    /// The model fitted with it mended.
    pub fit: Fit,
}

impl Misread {
    /// Mends the fitted recordings and the separate ones.
    pub fn mend(&self, recordings: &mut [Recording], separate: &mut [Recording]) {
        let Some(channel) = &self.channel else { return };
        match self.only {
            Some(n) => scale(&mut recordings[n..=n], channel, self.factor),
            None => [recordings, separate].into_iter().for_each(|all| scale(all, channel, self.factor)),
        }
    }
}

pub(super) fn scale(recordings: &mut [Recording], channel: &str, factor: f64) {
    let own = recordings.iter_mut().flat_map(|r| &mut r.channels).filter(|c| c.name == channel);
    own.for_each(|c| c.values.iter_mut().for_each(|v| *v *= factor));
}

/// What may be wrong by a factor; what is more likely so stands first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Part {
    /// A sensor is mounted the wrong way round more easily than a command is given so.
    Output,
    Input,
    Definition,
    Parameter,
}

impl Part {
    fn word(self) -> &'static str {
        match self {
            Self::Output => "output",
            Self::Input => "input",
            Self::Definition => "definition",
            Self::Parameter => "parameter",
        }
    }

    fn is_channel(self) -> bool {
        matches!(self, Self::Output | Self::Input)
    }
}

/// A factor that something may be wrong by.
#[derive(Clone, Copy)]
pub(super) struct Way<'m> {
    pub name: &'m str,
    pub part: Part,
    pub factor: f64,
    words: &'static str,
}

impl Way<'_> {
    /// The model and its recordings with the factor in them.
    fn mended(&self, model: &Model, bench: &Bench) -> (Model, Vec<Recording>) {
        let (mut model, mut recordings) = (model.clone(), bench.recordings.clone());
        match self.part {
            Part::Output | Part::Input => scale(&mut recordings, self.name, self.factor),
            Part::Definition => {
                for d in model.definitions.iter_mut().filter(|d| d.name == self.name) {
                    d.equals = Expr::Neg(Box::new(d.equals.clone()));
                }
            }
            Part::Parameter => model.parameters.iter_mut().filter(|p| p.name == self.name).for_each(turn),
        }
        (model, recordings)
    }
}

fn turn(p: &mut Parameter) {
    p.value = -p.value;
    (p.min, p.max) = (p.max.map(|x| -x), p.min.map(|x| -x));
}

/// A way with the model fitted after it.
struct Mend<'m> {
    way: Way<'m>,
    model: Model,
    fit: Fit,
    /// The largest misfit of an output as a share of its size.
    misfit: f64,
    /// Log-likelihood, outputs relative to their sizes.
    likelihood: f64,
}

/// Looks for a channel of the wrong sign or unit, and for a definition or a parameter of the wrong sign, where the model
/// as given fits badly. A channel that never changes has no sign and no unit that could be seen: what acts as evenly is
/// as likely. In a linear model an input too large is an output too small: what fits as well is told beside.
///
/// An input beside a stronger one may be turned over and yet spoil little. Where the model fits but for a part, each input
/// is turned over from the values that were fitted, and any other factor must fit no better: else a law of another size
/// is missing. Units are not asked there: an input that does not act is any unit too large.
pub fn misread(bench: &Bench, model: &Model, base: &Fit) -> Option<Misread> {
    let (before, is_bad) = (misfit(bench, base), fits_badly(bench, base));
    let (from, fitted) = if is_bad { (model, None) } else { (&base.model, Some(before)) };
    let (mends, tried) = mends(bench, from, fitted);
    // 2 Δln L = n ln(S₀/S₁), the factor one more unknown.
    let is_sure = |m: &Mend<'_>| {
        let samples = independent(&m.fit);
        let degrees = samples - m.fit.values.len() as f64 - 1.0;
        tried as f64 * chance(2.0 * samples * (before / m.misfit).ln(), 1, samples, degrees) < CHANCE
    };
    let stands = |m: &Mend<'_>| m.misfit < BETTER * before && is_sure(m) && (is_bad || is_exact(bench, m));
    let mut stand: Vec<Mend<'_>> = mends.into_iter().filter(stands).collect();
    let most = stand.iter().map(|m| m.likelihood).fold(f64::NEG_INFINITY, f64::max);
    stand.retain(|m| m.likelihood > most - TIE);
    if stand.iter().any(|m| !is_turned(&m.way)) && is_another_value(bench, model, base, &stand) {
        stand.retain(|m| is_turned(&m.way));
    }
    stand.sort_by_key(|m| m.way.part);
    let first = stand.first()?;
    let others: Vec<(Way<'_>, String)> = stand[1..].iter().map(|m| (m.way, wrong(&m.way))).collect();
    let mut says = wrong(&first.way);
    if !first.way.part.is_channel() {
        let percent = |share: f64| significant(100.0 * share, 2);
        let (before, then) = (percent(before), percent(first.misfit));
        says += &format!(" (it misses {before} % of the output's spread as it stands, {then} % then)");
    }
    let fault = fault((first.way, says), &others);
    let Mend { way, model: mended, fit, .. } = stand.swap_remove(0);
    // A channel leaves the model as it was given.
    let model = if way.part.is_channel() { model.clone() } else { mended };
    let channel = way.part.is_channel().then(|| way.name.to_string());
    Some(Misread { fault, channel, only: None, factor: way.factor, model, fit })
}

/// Whether a fitted model misses a large part of what an output shows.
pub fn fits_badly(bench: &Bench, base: &Fit) -> bool {
    misfit(bench, base) > BADLY
}

/// The largest misfit of an output as a share of its size.
fn misfit(bench: &Bench, fit: &Fit) -> f64 {
    relative(bench, fit, "", 1.0).into_iter().fold(0.0, f64::max)
}

/// Whether an input that is mended fits no better by any other factor.
fn is_exact(bench: &Bench, mend: &Mend<'_>) -> bool {
    let (mut model, recordings) = mend.way.mended(&mend.fit.model, bench);
    let name = edit::free_name(&model, "factor", |_| false);
    let [by, input] = [name.as_str(), mend.way.name].map(|n| Box::new(Expr::name(n)));
    let times = Expr::Binary(BinaryOp::Mul, by, input);
    edit::for_each(&mut model, |_, e| *e = e.substitute(mend.way.name, &times));
    model.parameters.push(Parameter {
        name,
        value: 1.0,
        unit: Unit::one(),
        fit: true,
        min: None,
        max: None,
        meaning: None,
    });
    let Ok(freed) = fit(&model, &recordings, &bench.options(Effort::Near, 10)) else { return false };
    // Both on one scale: the samples that are independent beside the smaller model.
    let pairs = mend.fit.rmse.iter().zip(&freed.rmse).enumerate();
    let gains = pairs.map(|(k, (one, free))| samples_of(&mend.fit, k) * (one / free).ln());
    let gain: f64 = gains.filter(|g| g.is_finite()).sum();
    let samples = independent(&mend.fit);
    chance(2.0 * gain, 1, samples, samples - freed.values.len() as f64) > CHANCE
}

/// Share of the misfit that a unit leaves up to which a value that is another one explains more.
const FAR_LESS: f64 = 0.5;
/// How many times as large as a bound a value is no other unit.
const NEAR_BOUND: f64 = 2.0;

/// Whether one value, held for known, that is another explains far more than a unit, or a bound that is too narrow as much.
fn is_another_value(bench: &Bench, model: &Model, base: &Fit, units: &[Mend<'_>]) -> bool {
    let least = units.iter().map(|m| m.misfit).fold(f64::INFINITY, f64::min);
    let refitted = |model: &Model| {
        let fit = fit(model, &bench.recordings, &bench.options(Effort::Near, 10)).ok()?;
        let misfit = misfit(bench, &fit);
        Some((fit, misfit))
    };
    let known = model.parameters.iter().enumerate().filter(|(_, p)| !p.fit && p.value != 0.0);
    let freed: Vec<Model> = known
        .map(|(k, _)| {
            let mut other = model.clone();
            other.parameters[k].fit = true;
            other
        })
        .collect();
    let explains = |m: &Model| refitted(m).is_some_and(|(_, misfit)| misfit < FAR_LESS * least);
    freed.par_iter().with_max_len(1).any(explains)
        || wider(model, base).is_some_and(|(wide, pressed)| {
            let near = |fit: &Fit| {
                pressed.iter().all(|(k, bound)| {
                    let ratio = fit.parameters[*k].value / bound;
                    ratio < NEAR_BOUND && ratio > 1.0 / NEAR_BOUND
                })
            };
            refitted(&wide).is_some_and(|(fit, misfit)| misfit < least * (1.0 + FAR_LESS) && near(&fit))
        })
}

/// The model without the bounds that its fit presses against, and these; none where it presses against none.
fn wider(model: &Model, base: &Fit) -> Option<(Model, Vec<(usize, f64)>)> {
    let at =
        |(k, p): (usize, &ParameterEstimate)| matches!(p.status, Status::AtBound(_)).then_some((k, p.value));
    let pressed: Vec<(usize, f64)> = base.parameters.iter().enumerate().filter_map(at).collect();
    let mut wide = model.clone();
    for (k, _) in &pressed {
        (wide.parameters[*k].min, wide.parameters[*k].max) = (None, None);
    }
    (!pressed.is_empty()).then_some((wide, pressed))
}

/// Every channel of a model that moves, turned over and in every unit that it may be in.
pub(super) fn readings(model: &Model, moves: impl Fn(&str) -> bool) -> impl Iterator<Item = Way<'_>> {
    let inputs = model.inputs.iter().map(|i| (&i.name, &i.unit, Part::Input));
    let channels = inputs.chain(model.outputs.iter().map(|o| (&o.name, &o.unit, Part::Output)));
    channels.filter(move |c| moves(c.0)).flat_map(|(name, unit, part)| {
        factors(unit).into_iter().map(move |(factor, words)| Way { name, part, factor, words })
    })
}

/// Every reading of a channel, and every definition that acts and every parameter of one sign, turned over.
fn ways<'m>(bench: &Bench, model: &'m Model) -> Vec<Way<'m>> {
    let read = readings(model, |name| bench.moves(name));
    let turned = |name: &'m String, part| Way { name, part, factor: -1.0, words: "" };
    let acts = |name: &str| model.states.iter().any(|x| edit::reaches(model, &x.rate, name));
    let definitions = model.definitions.iter().filter(|d| acts(&d.name));
    let of_one_sign = |p: &&Parameter| {
        let bounds = (p.min.is_some_and(|x| x >= 0.0), p.max.is_some_and(|x| x <= 0.0));
        p.value != 0.0 && (!p.fit || bounds.0 || bounds.1)
    };
    read.chain(definitions.map(|d| turned(&d.name, Part::Definition)))
        .chain(model.parameters.iter().filter(of_one_sign).map(|p| turned(&p.name, Part::Parameter)))
        .collect()
}

/// The ways after which the model can be fitted, with how many were tried. Of a model that is fitted and misses no more than
/// a share: inputs turned over alone, and only what misses less after one step is fitted to the end.
fn mends<'m>(bench: &Bench, model: &'m Model, fitted: Option<f64>) -> (Vec<Mend<'m>>, usize) {
    let mut ways = ways(bench, model);
    ways.retain(|w| fitted.is_none() || w.part == Part::Input && is_turned(w));
    let mend = |way: &Way<'m>| {
        let (model, recordings) = way.mended(model, bench);
        let refitted = |steps: usize| {
            let fit = fit(&model, &recordings, &bench.options(Effort::Near, steps)).ok()?;
            let shares = relative(bench, &fit, way.name, way.factor);
            let misfit = shares.iter().copied().fold(0.0, f64::max);
            Some((fit, shares, misfit))
        };
        if fitted.is_some_and(|before| refitted(1).is_none_or(|(_, _, misfit)| misfit >= before)) {
            return None;
        }
        let (fit, shares, misfit) = refitted(10)?;
        let of = |(k, share): (usize, &f64)| -share.ln() * samples_of(&fit, k);
        let likelihood = shares.iter().enumerate().map(of).sum();
        Some(Mend { way: *way, model, fit, misfit, likelihood })
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

/// What is wrong, in words.
pub(super) fn wrong(w: &Way<'_>) -> String {
    let name = w.name;
    match w.part {
        Part::Definition => format!("the model's own {name} has the wrong sign: turned over, it fits"),
        Part::Parameter => format!("the parameter {name} has the wrong sign: turned over, it fits"),
        _ if is_turned(w) => format!("{name} has the wrong sign: turned over, it fits"),
        _ => format!("{name} holds {}: multiplied by {}, it fits", w.words, short(w.factor)),
    }
}

fn is_turned(w: &Way<'_>) -> bool {
    w.factor == -1.0
}

fn code(w: &Way<'_>) -> &'static str {
    if is_turned(w) { "wrong-sign" } else { "wrong-unit" }
}

/// The fault that a way mends, with what mends it as well; each in words.
pub(super) fn fault((way, mut says): (Way<'_>, String), others: &[(Way<'_>, String)]) -> DataFault {
    let way = &way;
    if !others.is_empty() {
        let as_well: Vec<String> = others.iter().map(|(_, says)| format!("or {says}")).collect();
        says += &format!(" ({}: the data cannot tell which)", as_well.join(", "));
    }
    let mut ties: Vec<String> =
        others.iter().map(|(o, _)| code(o)).filter(|c| *c != code(way)).map(String::from).collect();
    ties.dedup();
    let finding = Finding {
        code: code(way).to_string(),
        site: SiteName { kind: way.part.word().to_string(), name: way.name.to_string() },
        term: format!("{}*{}", short(way.factor), way.name),
        says,
        parameters: vec![Value {
            name: "factor".into(),
            value: way.factor,
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
