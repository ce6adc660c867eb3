//! What a finding explains, against the signal that it goes with.
//!
//! # Purpose
//! Let a person see the law that was named: the dry friction as a step, the cubic spring as a cubic.
//!
//! # Method
//! Partial residuals. Where the rate of the state at which the finding acts is seen in the recording,
//! by differentiation of a smoothed output, the rate that the model gives without the finding is taken
//! from it, along the run of the fitted model; what is left stands beside the finding's own effect.
//! Where the finding acts on an output, the same is done with the output. Else the free-run residual
//! of the model without the finding, but with all others, stands beside how far it moves the prediction.
//!
//! # References
//! R. A. Berk, D. E. Booth, Statistical Methods & Applications 4 (1995) 263 (partial residuals).
//!
//! # Numerical aspects
//! Differentiated noise is large: the means along the signal count, not the single samples.

use super::bins::{self, Sample, WILD};
use super::probe::{Accused, Probe};
use super::{Assembly, Law, Point};
use crate::diagnose::catalogue::{Proposal, SiteKind, edit};
use crate::diagnose::inert::{self, Inert};
use crate::estimate::Fit;
use crate::estimate::fit::{Effort, setup};
use crate::estimate::smooth::Smoother;
use crate::expression::Expr;
use crate::model::Model;
use crate::model::shown::{Seen, seen_states};
use crate::record::{Channel, Recording, principal};
use crate::units::Unit;

/// Samples that are looked at.
const SAMPLES: usize = 6000;
/// Samples that are drawn.
const DRAWN: usize = 1200;
/// Means along the signal.
const MEANS: usize = 24;
/// Points of the curve.
const CURVE: usize = 160;

/// A picture a finding, where it can be drawn; before that of what a parameter's law brings, that law itself.
pub fn laws(assembly: &Assembly<'_>) -> Vec<Law> {
    let of = |p: &Proposal| {
        let effect = direct(assembly, p).or_else(|| moved(assembly, p));
        varying(assembly, p).into_iter().chain(effect)
    };
    assembly.found.taken.iter().flat_map(|t| of(&t.proposal)).collect()
}

/// A parameter against the signal that it varies with, along the run of the fitted model.
fn varying(assembly: &Assembly<'_>, p: &Proposal) -> Option<Law> {
    let (bench, fit) = (&assembly.bench, &assembly.found.last);
    let model = &fit.model;
    let own =
        model.parameters.iter().find(|q| p.site.kind == SiteKind::Parameter && q.name == p.site.name)?;
    let term = Expr::parse(&p.term).ok()?;
    let unit = edit::unit_of(&term, &|n| edit::unit_of_name(model, n));
    // where the term is more than the parameter itself it is drawn by what it brings alone
    if unit.dimension() != own.unit.dimension() || !term.mentions(&own.name) {
        return None;
    }
    let accused = Accused::of(model, p, &clock(assembly));
    let mut probe = Probe::of(model);
    probe.watch(accused.along.clone());
    probe.watch(term.clone());
    let spread = spread(fit, p);
    for (a, deviation) in p.added.iter().zip(&spread.deviations) {
        let value = model.parameters.iter().find(|q| q.name == a.name)?.value;
        let moved = probe.constant(value + deviation, &a.unit);
        let whole = probe.variant(&term, &|e| e.substitute(&a.name, &moved));
        probe.watch(whole);
    }
    let channel = bench.recordings.first()?.find(&model.outputs.first()?.name)?;
    let times: Vec<f64> = measured(channel, &bench.spans(model, 0), 0)?.iter().map(|m| m[0]).collect();
    let rows = probe.run(bench, fit, &times)?;
    let along = accused.values(&rows);
    let sample = |(row, (_, v)): (usize, &(f64, Vec<f64>))| {
        let pulls: Vec<f64> = v[2..].iter().map(|b| b - v[1]).collect();
        let deviation = own.unit.difference_from_si(spread.of(&pulls)).abs();
        Sample { x: along[row], y: own.unit.from_si(v[1]), deviation, row }
    };
    let curve: Vec<Sample> = rows.iter().enumerate().map(sample).collect();
    let words = Words {
        signal: accused.words,
        signal_unit: accused.unit,
        effect: own.name.clone(),
        effect_unit: own.unit.clone(),
        formula: term.to_string(),
    };
    Some(law(p, words, (&[], 0.0), &curve))
}

/// What the finding acts on.
struct Target {
    /// The whole expression.
    whole: Expr,
    /// What a unit of the drawn effect brings in the expression.
    factor: Expr,
    /// Unit of the drawn effect.
    unit: Unit,
    /// Words for the axis.
    words: String,
    /// The finding's term in the unit of the drawn effect; empty where it cannot be told.
    formula: String,
    /// How the expression is measured: a derivative of an output.
    measured: Seen,
}

fn target(model: &Model, p: &Proposal) -> Option<Target> {
    let own: Vec<&String> = p.added.iter().map(|a| &a.name).chain(&p.constants).collect();
    let touched = |e: &Expr| own.iter().any(|n| edit::reaches(model, e, n));
    for (s, seen) in model.states.iter().zip(seen_states(model)) {
        let Some(seen) = seen.filter(|seen| seen.order < 2 && touched(&s.rate)) else { continue };
        let unit = edit::unit_of(edit::sum_of(model, &s.rate), &|n| edit::unit_of_name(model, n));
        let rate = edit::opened(model, &s.rate);
        return Some(Target {
            formula: inner_term(model, rate, p).map_or_else(String::new, |e| e.to_string()),
            factor: edit::with_sum(model, rate, &|_| Expr::Number(1.0)),
            whole: s.rate.clone(),
            unit,
            words: format!("what is missing at {}", s.name),
            measured: Seen { output: seen.output, order: seen.order + 1 },
        });
    }
    let (output, o) = model.outputs.iter().enumerate().find(|(_, o)| touched(&o.equals))?;
    Some(Target {
        whole: o.equals.clone(),
        factor: Expr::Number(1.0),
        unit: o.unit.of_differences(),
        words: format!("what is missing in {}", o.name),
        formula: if p.neutral.is_some() { p.term.clone() } else { String::new() },
        measured: Seen { output, order: 0 },
    })
}

/// What a finding adds to the innermost sum of a rate: its term without what stands around that sum. A term that
/// stands in the place of another is more than what it adds.
fn inner_term(model: &Model, rate: &Expr, p: &Proposal) -> Option<Expr> {
    const PLACE: &str = "place_of_the_sum";
    if !p.replaced.is_empty() {
        return None;
    }
    let around = edit::with_sum(model, rate, &|_| Expr::name(PLACE));
    within(&around, &Expr::parse(&p.term).ok()?, PLACE)
}

/// The part of a term that stands where a pattern has a name.
fn within(pattern: &Expr, term: &Expr, place: &str) -> Option<Expr> {
    match (pattern, term) {
        (Expr::Name(n), _) if n == place => Some(term.clone()),
        (_, Expr::Neg(a)) => Some(Expr::Neg(Box::new(within(pattern, a, place)?))),
        (Expr::Binary(p, a, b), Expr::Binary(q, c, d)) if p == q => {
            if b == d {
                within(a, c, place)
            } else if a == c {
                within(b, d, place)
            } else {
                None
            }
        }
        _ => None,
    }
}

/// Partial residuals of the rate or the output that the finding acts on.
fn direct(assembly: &Assembly<'_>, p: &Proposal) -> Option<Law> {
    let (bench, fit) = (&assembly.bench, &assembly.found.last);
    let model = &fit.model;
    let target = target(model, p)?;
    let without = Inert::of(p)?;
    let accused = Accused::of(model, p, &clock(assembly));
    let mut probe = Probe::of(model);
    let rest = match &without {
        Inert::Passed(_) => probe.variant(&target.whole, &|e| without.expression(e, &|_| None)),
        Inert::Values(values) => {
            let mut at_rest: Vec<(&str, Expr)> = Vec::new();
            for a in &p.added {
                let value = *values.get(a.name.as_str())?;
                at_rest.push((&a.name, probe.constant(value, &a.unit)));
            }
            let named = |n: &str| at_rest.iter().find(|(own, _)| *own == n).map(|(_, e)| e.clone());
            probe.variant(&target.whole, &|e| without.expression(e, &named))
        }
    };
    for e in [accused.along.clone(), target.factor.clone(), rest, target.whole.clone()] {
        probe.watch(e);
    }
    let spread = spread(fit, p);
    for (a, deviation) in p.added.iter().zip(&spread.deviations) {
        let value = model.parameters.iter().find(|q| q.name == a.name)?.value;
        let moved = probe.constant(value + deviation, &a.unit);
        let whole = probe.variant(&target.whole, &|e| e.substitute(&a.name, &moved));
        probe.watch(whole);
    }
    let channel = bench.recordings.first()?.find(&model.outputs[target.measured.output].name)?;
    let measured = measured(channel, &bench.spans(model, 0), target.measured.order)?;
    let times: Vec<f64> = measured.iter().map(|m| m[0]).collect();
    let rows = probe.run(bench, fit, &times)?;
    let (mut data, mut curve) = (Vec::new(), Vec::new());
    let of_y = |y: f64| target.unit.difference_from_si(y);
    let along = accused.values(&rows);
    for (row, (t, v)) in rows.iter().enumerate() {
        let Some(m) = measured.get(times.partition_point(|x| x < t)) else { continue };
        let (x, factor, rest, whole) = (along[row], v[1], v[2], v[3]);
        let difference = if channel.wraps { principal(m[1] - rest) } else { m[1] - rest };
        let pulls: Vec<f64> = v[4..].iter().map(|b| (b - whole) / factor).collect();
        let deviation = of_y(spread.of(&pulls)).abs();
        data.push(Sample { x, y: of_y(difference / factor), deviation: 0.0, row });
        curve.push(Sample { x, y: of_y((whole - rest) / factor), deviation, row });
    }
    let words = Words {
        signal: accused.words,
        signal_unit: accused.unit,
        effect: target.words,
        effect_unit: target.unit,
        formula: target.formula,
    };
    let wild = if target.measured.order > 0 { WILD } else { 0.0 };
    Some(law(p, words, (&data, wild), &curve))
}

/// An output of the first recording without and with a finding, both running free.
struct Moved {
    output: usize,
    time: Vec<f64>,
    without: Vec<f64>,
    with: Vec<f64>,
}

impl Moved {
    /// How much of what is left without the finding it takes away or adds.
    fn share(&self) -> f64 {
        let square = |v: f64| if v.is_finite() { v * v } else { 0.0 };
        let left: f64 = self.without.iter().map(|b| square(*b)).sum();
        let moved: f64 = self.without.iter().zip(&self.with).map(|(b, a)| square(b - a)).sum();
        if left > 0.0 { moved / left } else { 0.0 }
    }
}

/// The output that a finding moves most; all other findings stay as they are.
fn most_moved(assembly: &Assembly<'_>, p: &Proposal) -> Option<Moved> {
    let (bench, last) = (&assembly.bench, &assembly.found.last);
    let spans = bench.spans(&last.model, 0);
    let options = bench.options(Effort::Near, 0);
    let recording = bench.recordings.first()?;
    let record = setup::record(&last.model, recording, 0, &spans, &options).ok()?;
    let initials = &last.records.first()?.initials;
    let residuals = |model: &Model| -> Option<Vec<Vec<f64>>> {
        let record = setup::record(model, recording, 0, &spans, &options).ok()?;
        let parameters: Vec<f64> = model.parameters.iter().map(|q| q.value).collect();
        let run = record.run(&parameters, &inert::kept(model, &last.model, initials), &[]).ok()?;
        Some(record.tracks.iter().zip(&run.predictions).map(|(t, y)| t.residual(y)).collect())
    };
    let pairs = residuals(&Inert::of(p)?.model(&last.model, p)?)?.into_iter().zip(residuals(&last.model)?);
    let all = record.tracks.iter().zip(pairs).map(|(track, (without, with))| Moved {
        output: track.output,
        time: track.time.clone(),
        without,
        with,
    });
    all.max_by(|a, b| a.share().total_cmp(&b.share()))
}

/// Free-run residual of the model without the finding, beside how far the finding moves the prediction.
fn moved(assembly: &Assembly<'_>, p: &Proposal) -> Option<Law> {
    let (bench, found) = (&assembly.bench, &assembly.found);
    let m = most_moved(assembly, p)?;
    let accused = Accused::of(&found.last.model, p, &clock(assembly));
    let stride = m.time.len().div_ceil(SAMPLES).max(1);
    let at: Vec<usize> = (0..m.time.len()).step_by(stride).collect();
    let times: Vec<f64> = at.iter().map(|i| m.time[*i]).collect();
    let mut probe = Probe::of(&found.last.model);
    probe.watch(accused.along.clone());
    let rows = probe.run(bench, &found.last, &times)?;
    let along = accused.values(&rows);
    let output = &found.last.model.outputs[m.output];
    let unit = output.unit.of_differences();
    let (mut data, mut curve) = (Vec::new(), Vec::new());
    for (row, (t, _)) in rows.iter().enumerate() {
        let Some(i) = at.get(times.partition_point(|x| x < t)) else { continue };
        let x = along[row];
        let sample = |y: f64| Sample { x, y: unit.difference_from_si(y), deviation: 0.0, row };
        data.push(sample(m.without[*i]));
        curve.push(sample(m.without[*i] - m.with[*i]));
    }
    let words = Words {
        signal: accused.words,
        signal_unit: accused.unit,
        effect: format!("{}: measured less the model without it", output.name),
        effect_unit: unit,
        formula: String::new(),
    };
    Some(law(p, words, (&data, 0.0), &curve))
}

/// The unit in which the first recording counts time.
fn clock(assembly: &Assembly<'_>) -> Unit {
    assembly.bench.recordings.first().map_or_else(Unit::one, Recording::time_unit)
}

/// What stands along the axes and beside the curve.
struct Words {
    signal: String,
    signal_unit: Unit,
    effect: String,
    effect_unit: Unit,
    formula: String,
}

/// The picture of samples, without a share of them at both ends, and of a curve.
fn law(p: &Proposal, words: Words, (data, wild): (&[Sample], f64), curve: &[Sample]) -> Law {
    let (low, high) = bins::between(data.iter().map(|s| s.y), wild);
    let inside = |y: f64| y >= low && y <= high;
    let kept: Vec<Sample> = data.iter().filter(|s| s.x.is_finite() && inside(s.y)).copied().collect();
    let drawn = kept.iter().step_by(kept.len().div_ceil(DRAWN).max(1));
    Law {
        code: p.code.to_string(),
        term: p.term.clone(),
        formula: words.formula,
        signal: words.signal,
        signal_unit: words.signal_unit.text().to_string(),
        effect: words.effect,
        effect_unit: words.effect_unit.text().to_string(),
        samples: drawn.map(|s| [s.x, s.y]).collect(),
        means: bins::means(&kept, MEANS),
        curve: bins::curve(curve, CURVE),
    }
}

/// Times and measured values, or derivatives, over the fitted spans.
fn measured(channel: &Channel, spans: &[crate::record::Span], order: usize) -> Option<Vec<Point>> {
    let fitted = |t: f64| spans.iter().any(|s| s.contains(t));
    let (time, values): (Vec<f64>, Vec<f64>) = channel.samples().filter(|(t, _)| fitted(*t)).unzip();
    let every = time.len().div_ceil(SAMPLES).max(1);
    if order == 0 {
        return Some(time.into_iter().zip(values).step_by(every).map(|(t, y)| [t, y]).collect());
    }
    let smoother = Smoother::new(&time, &values)?;
    Some((0..time.len()).step_by(every).map(|i| [time[i], smoother.jet(i)[order]]).collect())
}

/// Deviations of the added parameters and how they go together.
struct Spread {
    deviations: Vec<f64>,
    correlations: Vec<Vec<f64>>,
}

fn spread(fit: &Fit, p: &Proposal) -> Spread {
    let place: Vec<Option<usize>> =
        p.added.iter().map(|a| fit.unknowns.iter().position(|u| *u == a.name)).collect();
    let covariance = |i: usize, j: usize| match (place[i], place[j]) {
        (Some(a), Some(b)) => Some(fit.covariance[(a, b)]).filter(|c| c.is_finite()).unwrap_or(0.0),
        _ => 0.0,
    };
    let n = p.added.len();
    let deviations: Vec<f64> = (0..n).map(|i| covariance(i, i).max(0.0).sqrt()).collect();
    let correlation = |i: usize, j: usize| {
        let scale = deviations[i] * deviations[j];
        if scale > 0.0 { covariance(i, j) / scale } else { 0.0 }
    };
    let correlations = (0..n).map(|i| (0..n).map(|j| correlation(i, j)).collect()).collect();
    Spread { deviations, correlations }
}

impl Spread {
    /// Deviation of an effect that each parameter's own deviation moves by a pull.
    fn of(&self, pulls: &[f64]) -> f64 {
        // σ² = Σ_ij d_i ρ_ij d_j
        let mut square = 0.0;
        for (row, a) in self.correlations.iter().zip(pulls) {
            square += row.iter().zip(pulls).map(|(r, b)| a * r * b).sum::<f64>();
        }
        square.max(0.0).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::within;
    use crate::expression::Expr;

    #[test]
    fn a_term_is_told_without_what_stands_around_its_sum() {
        let told = |pattern: &str, term: &str| {
            let parsed = |text: &str| Expr::parse(text).unwrap();
            within(&parsed(pattern), &parsed(term), "x").map(|e| e.to_string())
        };
        assert_eq!(told("x/M", "-Fc*sign(v)/M").unwrap(), "-Fc*sign(v)");
        assert_eq!(told("k*(x/M)", "k*(F*v/M)").unwrap(), "F*v");
        assert_eq!(told("x", "a*v/M").unwrap(), "a*v/M");
        assert_eq!(told("x/M", "a*v/J"), None);
    }
}
