//! What a curve looks like, in a formula of few numbers: a likeness, never a name.
//!
//! # Method
//! Over its knots the curve is compared with a straight line and one or two terms more; some terms have a place and a
//! width, which are tried over the curve's range. A formula says the curve where it leaves no more of it than the curve's
//! own standard error, or a twentieth of what the line leaves if that is more; of those the one with the fewest
//! numbers is told. A straight line trades with the model's own parameters, so that errors are those of what it leaves.
//!
//! # References
//! T. Hastie, R. Tibshirani, J. Friedman, The Elements of Statistical Learning, 2nd ed. (2009), sect. 7.10 (the simplest
//! within one standard error).

use crate::diagnose::catalogue::{Proposal, edit};
use crate::diagnose::words::quantity;
use crate::estimate::Fit;
use crate::expression::{Expr, Function};
use crate::units::Unit;

/// Points at which a curve is compared.
const POINTS: usize = 60;
/// Share of the squares that a line leaves, up to which a formula says the curve.
const ENOUGH: f64 = 0.05;
/// Share of the curve's squares below which a line says it all.
const STRAIGHT: f64 = 0.01;
/// Places and widths that are tried.
const TRIED: i32 = 24;

/// A term of a signal `{s}`, with a place `{p}` and a width `{w}` or without: its text, and its value.
type Term = (&'static str, fn(f64, f64, f64) -> f64);

const PLAIN: [Term; 7] = [
    ("{s}^2", |s, _, _| s * s),
    ("{s}*abs({s})", |s, _, _| s * s.abs()),
    ("{s}^3", |s, _, _| s.powi(3)),
    ("abs({s})", |s, _, _| s.abs()),
    ("sign({s})*sqrt(abs({s}))", |s, _, _| s.signum() * s.abs().sqrt()),
    ("1/{s}", |s, _, _| 1.0 / s),
    ("ln({s})", |s, _, _| s.ln()),
];

/// Terms with a width alone.
const WIDE: [Term; 4] = [
    ("exp({s}/{w})", |s, _, w| (s / w).exp()),
    ("exp(-{s}/{w})", |s, _, w| (-s / w).exp()),
    ("{s}/(1 + abs({s})/{w})", |s, _, w| s / (1.0 + s.abs() / w)),
    ("{s}/(1 + ({s}/{w})^2)", |s, _, w| s / (1.0 + (s / w).powi(2))),
];

const PLACED: [Term; 4] = [
    ("max({s} - {p}, 0)", |s, p, _| (s - p).max(0.0)),
    ("tanh(({s} - {p})/{w})", |s, p, w| ((s - p) / w).tanh()),
    ("exp(-(({s} - {p})/{w})^2)", |s, p, w| (-((s - p) / w).powi(2)).exp()),
    ("sin(({s} - {p})/{w})", |s, p, w| ((s - p) / w).sin()),
];

/// Some terms, each with its place and width, and the share of the squares that they leave.
struct Formula {
    terms: Vec<(&'static str, f64, f64)>,
    left: f64,
}

/// What a fitted law looks like, if a few simple terms say it.
pub(super) fn likeness(p: &Proposal, fit: &Fit) -> Option<String> {
    let curve = Curve::of(p, fit)?;
    let y = curve.values(None)?;
    let rest = without_line(&curve.places, &y);
    let mean = y.iter().sum::<f64>() / y.len() as f64;
    let moved: Vec<f64> = y.iter().map(|v| v - mean).collect();
    let error = curve.variance(fit, p, &y)?;
    if squares(&rest) < STRAIGHT * squares(&moved) || squares(&rest) < error {
        return Some(format!("a straight line in {}", curve.signal));
    }
    let enough = ENOUGH.max(error / squares(&rest));
    let found = formulas(&curve.places, &rest).into_iter().find(|f| f.left < enough)?;
    let shown = |x: f64, difference: bool| {
        let unit = &curve.unit;
        quantity(if difference { unit.difference_from_si(x) } else { unit.from_si(x) }, unit.text())
    };
    let text = |(text, place, width): &(&str, f64, f64)| {
        let text = text.replace("{s}", &curve.signal).replace("{p}", &shown(*place, false));
        text.replace("{w}", &shown(*width, true))
    };
    let all: Vec<String> = found.terms.iter().map(text).collect();
    Some(format!("a straight line and a part with {}", all.join(" and one with ")))
}

fn squares(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum()
}

/// The best formula of each number of numbers, the fewest first.
fn formulas(s: &[f64], rest: &[f64]) -> Vec<Formula> {
    let (low, range) = (s[0], s[s.len() - 1] - s[0]);
    let widths = || (1..=TRIED).map(move |k| 0.02 * range * 1.25_f64.powi(k));
    let places = (0..=TRIED).map(|k| low + range * f64::from(k) / f64::from(TRIED));
    let grid: Vec<(f64, f64)> = places.flat_map(|p| widths().map(move |w| (p, w))).collect();
    let one =
        |t: &Term, p: f64, w: f64| Formula { terms: vec![(t.0, p, w)], left: left(s, rest, &[(t, p, w)]) };
    let plain = PLAIN.iter().map(|t| one(t, 0.0, 1.0));
    let wide = WIDE.iter().flat_map(|t| widths().map(move |w| one(t, 0.0, w)));
    let pairs = (0..PLAIN.len()).flat_map(|i| (0..i).map(move |j| (&PLAIN[j], &PLAIN[i])));
    let two = pairs.map(|(a, b)| Formula {
        terms: vec![(a.0, 0.0, 1.0), (b.0, 0.0, 1.0)],
        left: left(s, rest, &[(a, 0.0, 1.0), (b, 0.0, 1.0)]),
    });
    let placed = PLACED.iter().flat_map(|t| grid.iter().map(move |(p, w)| one(t, *p, *w)));
    [best(plain), best(wide.chain(two)), best(placed)].into_iter().flatten().collect()
}

fn best(all: impl Iterator<Item = Formula>) -> Option<Formula> {
    all.min_by(|a, b| a.left.total_cmp(&b.left))
}

/// Share of the squares of what a line leaves that terms leave beside a line; 1 where they cannot be told.
fn left(s: &[f64], rest: &[f64], terms: &[(&Term, f64, f64)]) -> f64 {
    let mut rest = rest.to_vec();
    let mut before: Vec<Vec<f64>> = Vec::new();
    let all = squares(&rest);
    for (term, place, width) in terms {
        let values: Vec<f64> = s.iter().map(|x| term.1(*x, *place, *width)).collect();
        let whole = squares(&values);
        let mut own = without_line(s, &values);
        for b in &before {
            take(&mut own, b);
        }
        let share = squares(&own) / whole;
        if share.is_nan() || share < 1e-12 {
            return 1.0;
        }
        take(&mut rest, &own);
        before.push(own);
    }
    squares(&rest) / all
}

/// Takes from values what goes with others.
fn take(from: &mut [f64], other: &[f64]) {
    let along = from.iter().zip(other).map(|(a, b)| a * b).sum::<f64>() / squares(other);
    from.iter_mut().zip(other).for_each(|(a, b)| *a -= along * b);
}

/// A fitted curve over its knots, SI.
struct Curve {
    call: Expr,
    parameters: Vec<(String, f64)>,
    signal: String,
    unit: Unit,
    places: Vec<f64>,
}

impl Curve {
    fn of(p: &Proposal, fit: &Fit) -> Option<Self> {
        let signal = p.depends.first()?.clone();
        let term = Expr::parse(&p.term).ok()?;
        let call = edit::find(&term, &|e| matches!(e, Expr::Call(Function::Curve, _)))?.clone();
        let Expr::Call(_, arguments) = &call else { return None };
        let parameters = fit.model.parameters.iter().map(|q| (q.name.clone(), q.value)).collect();
        let unit = edit::unit_of_name(&fit.model, &signal)?;
        let curve = Self { call: call.clone(), parameters, signal, unit, places: Vec::new() };
        // z = (s − mean)/spread, read at s = 0 and 1
        let (zero, one) = (curve.with(&arguments[0], 0.0, None)?, curve.with(&arguments[0], 1.0, None)?);
        let at = |e: &Expr| Some((curve.with(e, 0.0, None)? - zero) / (one - zero));
        let (first, last) = (at(&arguments[1])?, at(&arguments[arguments.len() - 2])?);
        let step = (last - first) / (POINTS - 1) as f64;
        let places = (0..POINTS).map(|i| first + step * i as f64).collect();
        Some(Self { places, ..curve })
    }

    /// An expression at a value of the signal, with one parameter moved.
    fn with(&self, e: &Expr, s: f64, moved: Option<(&str, f64)>) -> Option<f64> {
        let by = |n: &str| moved.filter(|m| m.0 == n).map_or(0.0, |m| m.1);
        let parameter = |n: &str| self.parameters.iter().find(|q| q.0 == n).map(|q| q.1 + by(n));
        e.value(&|n| if n == self.signal { Some(s) } else { parameter(n) })
    }

    /// The curve, with one height moved.
    fn values(&self, moved: Option<(&str, f64)>) -> Option<Vec<f64>> {
        self.places.iter().map(|s| self.with(&self.call, *s, moved)).collect()
    }

    /// Expected squares, over all places, of the error of what a straight line leaves of the curve; 0 where the heights
    /// have no covariance.
    fn variance(&self, fit: &Fit, p: &Proposal, y: &[f64]) -> Option<f64> {
        let mut moves = Vec::new();
        for a in &p.added {
            let Some(k) = fit.unknowns.iter().position(|u| *u == a.name) else { continue };
            let deviation = fit.covariance[(k, k)].sqrt();
            if !(deviation > 0.0 && deviation.is_finite()) {
                continue;
            }
            let moved = self.values(Some((&a.name, deviation)))?;
            let slope: Vec<f64> = moved.iter().zip(y).map(|(m, y)| (m - y) / deviation).collect();
            moves.push((k, without_line(&self.places, &slope)));
        }
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let pairs = moves.iter().flat_map(|a| moves.iter().map(move |b| (a, b)));
        let sum: f64 = pairs.map(|(a, b)| fit.covariance[(a.0, b.0)] * product(&a.1, &b.1)).sum();
        Some(if sum.is_finite() { sum.max(0.0) } else { 0.0 })
    }
}

/// What a straight line leaves of values at evenly spaced places.
fn without_line(s: &[f64], y: &[f64]) -> Vec<f64> {
    let n = s.len() as f64;
    let (middle, mean) = (s.iter().sum::<f64>() / n, y.iter().sum::<f64>() / n);
    let (cross, square) = s
        .iter()
        .zip(y)
        .fold((0.0, 0.0), |sum, (s, y)| (sum.0 + (s - middle) * (y - mean), sum.1 + (s - middle).powi(2)));
    s.iter().zip(y).map(|(s, y)| y - mean - cross / square * (s - middle)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(f: impl Fn(f64) -> f64, from: f64, to: f64) -> Vec<&'static str> {
        let s: Vec<f64> = (0..POINTS).map(|i| from + (to - from) * i as f64 / (POINTS - 1) as f64).collect();
        let rest = without_line(&s, &s.iter().map(|x| f(*x)).collect::<Vec<f64>>());
        let found = formulas(&s, &rest).into_iter().find(|f| f.left < ENOUGH);
        found.map_or_else(Vec::new, |f| f.terms.iter().map(|t| t.0).collect())
    }

    #[test]
    fn the_formula_of_fewest_numbers_that_says_a_curve_is_told() {
        assert_eq!(told(|s| 3.0 + 2.0 * s - 0.5 * s.powi(3), -2.0, 2.0), ["{s}^3"]);
        assert_eq!(told(|s| s * s.abs() + s, -3.0, 2.0), ["{s}*abs({s})"]);
        assert_eq!(told(|s| 4.0 * s / (1.0 + (s / 0.3).powi(2)), -2.0, 2.0), ["{s}/(1 + ({s}/{w})^2)"]);
        assert_eq!(told(|s| (-((s - 0.7) / 0.2).powi(2)).exp(), -2.0, 2.0), ["exp(-(({s} - {p})/{w})^2)"]);
        assert!(told(|s| (9.0 * s * s).sin(), -2.0, 2.0).is_empty());
    }
}
