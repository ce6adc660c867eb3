//! What a curve looks like, in a formula of few numbers: a likeness, never a name.
//!
//! # Method
//! Over its knots the curve is compared with a straight line and one term more; some terms have a place and a width,
//! which are tried over the curve's range. A term without them goes first: the others are told only where none of the
//! first leaves a twentieth of what the line leaves.

use crate::diagnose::catalogue::{Proposal, edit};
use crate::diagnose::words::quantity;
use crate::estimate::Fit;
use crate::expression::{Expr, Function};
use crate::units::Unit;

/// Points at which a curve is compared.
const POINTS: usize = 60;
/// Share of the squares that a line leaves, up to which one more term says the curve.
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

const PLACED: [Term; 4] = [
    ("max({s} - {p}, 0)", |s, p, _| (s - p).max(0.0)),
    ("tanh(({s} - {p})/{w})", |s, p, w| ((s - p) / w).tanh()),
    ("exp(-(({s} - {p})/{w})^2)", |s, p, w| (-((s - p) / w).powi(2)).exp()),
    ("sin(({s} - {p})/{w})", |s, p, w| ((s - p) / w).sin()),
];

/// What a fitted law looks like, if a simple term says it.
pub(super) fn likeness(p: &Proposal, fit: &Fit) -> Option<String> {
    let (signal, unit, s, y) = course(p, fit)?;
    let rest = without_line(&s, &y);
    let squares = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>();
    let mean = y.iter().sum::<f64>() / y.len() as f64;
    let moved: Vec<f64> = y.iter().map(|v| v - mean).collect();
    if squares(&rest) < STRAIGHT * squares(&moved) {
        return Some(format!("a straight line in {signal}"));
    }
    let left = |term: &Term, place: f64, width: f64| {
        let own = without_line(&s, &s.iter().map(|x| term.1(*x, place, width)).collect::<Vec<f64>>());
        let cross: f64 = own.iter().zip(&rest).map(|(a, b)| a * b).sum();
        let share = 1.0 - cross * cross / (squares(&own) * squares(&rest));
        if share.is_finite() { share } else { 1.0 }
    };
    let (low, range) = (s[0], s[s.len() - 1] - s[0]);
    let places = (0..=TRIED).map(|k| low + range * f64::from(k) / f64::from(TRIED));
    let widths = (1..=TRIED).map(|k| 0.02 * range * 1.18_f64.powi(k));
    let grid: Vec<(f64, f64)> = places.flat_map(|p| widths.clone().map(move |w| (p, w))).collect();
    let plain = PLAIN.iter().map(|t| (left(t, 0.0, 1.0), t, 0.0, 1.0));
    let placed = || PLACED.iter().flat_map(|t| grid.iter().map(move |(p, w)| (t, *p, *w)));
    let placed = || best(placed().map(|(t, p, w)| (left(t, p, w), t, p, w)).collect());
    let found = best(plain.collect()).filter(|b| b.0 < ENOUGH).or_else(placed).filter(|b| b.0 < ENOUGH)?;
    let shown = |x: f64, difference: bool| {
        quantity(if difference { unit.difference_from_si(x) } else { unit.from_si(x) }, unit.text())
    };
    let text = found.1.0.replace("{s}", &signal).replace("{p}", &shown(found.2, false));
    Some(format!("a straight line and a part with {}", text.replace("{w}", &shown(found.3, true))))
}

/// The term that leaves least, with its place and width.
fn best(all: Vec<(f64, &Term, f64, f64)>) -> Option<(f64, &Term, f64, f64)> {
    all.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The signal of a law with its unit, and the curve over its knots, SI.
fn course(p: &Proposal, fit: &Fit) -> Option<(String, Unit, Vec<f64>, Vec<f64>)> {
    let signal = p.depends.first()?.clone();
    let term = Expr::parse(&p.term).ok()?;
    let curve = edit::find(&term, &|e| matches!(e, Expr::Call(Function::Curve, _)))?;
    let Expr::Call(_, arguments) = curve else { return None };
    let parameter = |n: &str| fit.model.parameters.iter().find(|q| q.name == n).map(|q| q.value);
    let with = |e: &Expr, s: f64| e.value(&|n| if n == signal { Some(s) } else { parameter(n) });
    // z = (s − mean)/spread, read at s = 0 and 1
    let (zero, one) = (with(&arguments[0], 0.0)?, with(&arguments[0], 1.0)?);
    let at = |z: f64| (z - zero) / (one - zero);
    let (first, last) = (with(&arguments[1], 0.0)?, with(&arguments[arguments.len() - 2], 0.0)?);
    let step = (at(last) - at(first)) / (POINTS - 1) as f64;
    let s: Vec<f64> = (0..POINTS).map(|i| at(first) + step * i as f64).collect();
    let y: Option<Vec<f64>> = s.iter().map(|s| with(curve, *s)).collect();
    let unit = edit::unit_of_name(&fit.model, &signal)?;
    Some((signal, unit, s, y?))
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
