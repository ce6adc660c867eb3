//! Outputs that give the rate of a state, as an accelerometer gives that of a speed: what acts on the state acts on them.

use super::edit;
use crate::expression::{BinaryOp, Expr};
use crate::model::{Model, Output, Parameter, State};
use crate::units::Dimension;
use std::collections::BTreeMap;

/// Draws of the states and of the parameters, and how equal sums of numbers are.
const DRAWS: usize = 4;
const EQUAL: f64 = 1e-9;

/// The outputs that give the rate of a state, with what is added to the rate: numbers of the outputs and their new
/// expressions.
///
/// An output may give a multiple of the rate, in parts of g or in volts by its sensitivity, beside what inputs and
/// parameters alone add: an accelerometer on a shaken floor shows the rate of its relative speed without the shaking.
/// A multiple by what stands in the rate itself, as the mass does, is a gauge of some of the forces and may not feel
/// others.
pub fn outputs(model: &Model, state: &State, added: &Expr) -> Vec<(usize, Expr)> {
    let Some(draws) = Draws::of(model, &state.rate) else { return Vec::new() };
    let rate = state.unit.of_differences().dimension().over(Dimension::TIME);
    let felt = |(k, o): (usize, &Output)| {
        let factor = draws.factor(&o.equals, o.unit.of_differences().dimension().over(rate))?;
        Some((k, factor.joined(&o.equals, added)))
    };
    model.outputs.iter().enumerate().filter_map(felt).collect()
}

/// How often an output gives a rate: a number, with a parameter that multiplies or divides.
struct Factor<'m> {
    number: f64,
    parameter: Option<(BinaryOp, &'m str)>,
}

impl Factor<'_> {
    /// An output's expression with what is added to the rate.
    fn joined(&self, equals: &Expr, added: &Expr) -> Expr {
        let with = |op, a: Expr, b: Expr| Expr::Binary(op, Box::new(a), Box::new(b));
        let size = self.number.abs();
        let many =
            if size == 1.0 { added.clone() } else { with(BinaryOp::Mul, Expr::Number(size), added.clone()) };
        let felt = match self.parameter {
            Some((op, p)) => with(op, many, Expr::name(p)),
            None => many,
        };
        if self.number < 0.0 { edit::minus(equals, &felt) } else { edit::plus(equals, &felt) }
    }
}

/// The names of a model with numbers, and the rate there.
type World<'m> = (BTreeMap<&'m str, f64>, f64);

/// A rate at draws of the parameters, the first being their own values, and of the states.
struct Draws<'m> {
    worlds: Vec<Vec<World<'m>>>,
    /// Parameters that do not stand in the rate.
    outside: Vec<&'m Parameter>,
}

impl<'m> Draws<'m> {
    /// None where the rate remembers, or has no value somewhere.
    fn of(model: &'m Model, rate: &Expr) -> Option<Self> {
        let world = |parameters, states| {
            let names = named(model, parameters, states)?;
            let value = value(rate, &names)?;
            Some((names, value))
        };
        let worlds = (0..DRAWS).map(|p| (0..DRAWS).map(|s| world(p, s)).collect()).collect::<Option<_>>()?;
        let outside = model.parameters.iter().filter(|p| !edit::reaches(model, rate, &p.name)).collect();
        Some(Self { worlds, outside })
    }

    /// The factor, of a dimension, by which an expression follows the rate.
    fn factor(&self, e: &Expr, dimension: Dimension) -> Option<Factor<'m>> {
        let slopes = self.worlds.iter().map(|w| slope(e, w)).collect::<Option<Vec<f64>>>()?;
        if dimension == Dimension::NONE
            && let Some(number) = same(slopes.iter().copied())
        {
            return Some(Factor { number, parameter: None });
        }
        let by = |p: &&'m Parameter| {
            let values = self.worlds.iter().map(|w| w[0].0[p.name.as_str()]);
            let own = p.unit.dimension();
            let (op, number) = if own == dimension {
                (BinaryOp::Mul, same(slopes.iter().zip(values).map(|(s, v)| s / v)))
            } else if Dimension::NONE.over(own) == dimension {
                (BinaryOp::Div, same(slopes.iter().zip(values).map(|(s, v)| s * v)))
            } else {
                return None;
            };
            Some(Factor { number: number?, parameter: Some((op, &p.name)) })
        };
        self.outside.iter().find_map(by)
    }
}

/// The number that all are; one that is whole but for rounding is whole.
fn same(mut all: impl Iterator<Item = f64>) -> Option<f64> {
    let first = all.next().filter(|x| x.is_finite() && *x != 0.0)?;
    let near = |x: f64, y: f64| (x - y).abs() <= EQUAL * y.abs();
    let whole = first.round();
    all.all(|x| near(x, first)).then_some(if near(first, whole) { whole } else { first })
}

/// By how much an expression changes with the rate, the states being drawn; none where it changes otherwise.
fn slope(e: &Expr, worlds: &[World<'_>]) -> Option<f64> {
    let values = worlds.iter().map(|(names, r)| Some((value(e, names)?, *r))).collect::<Option<Vec<_>>>()?;
    let (e, r) = values[0];
    let furthest = values.iter().max_by(|a, b| (a.1 - r).abs().total_cmp(&(b.1 - r).abs()))?;
    let by = (furthest.0 - e) / (furthest.1 - r);
    let size = |x: f64, y: f64| x.abs().max(y.abs());
    let moves = (furthest.1 - r).abs() > EQUAL.sqrt() * size(furthest.1, r);
    let follows =
        |(x, y): &(f64, f64)| (x - e - by * (y - r)).abs() <= EQUAL * size(*x, e).max(by.abs() * size(*y, r));
    (moves && values.iter().all(follows)).then_some(by)
}

/// The names of a model with numbers: inputs and time at fixed ones, parameters and states at others in each draw. A
/// definition that remembers or has no value there has none.
fn named(model: &Model, parameters: usize, states: usize) -> Option<BTreeMap<&str, f64>> {
    // numbers that no model is made of
    let spread = |i: usize| 1.0 + (std::f64::consts::E * (i as f64 + 1.0)).fract();
    let inputs = model.inputs.iter().enumerate().map(|(i, x)| (x.name.as_str(), spread(i)));
    let drawn = |i: usize| spread(7 * i + 13 * states + 1);
    let moving = model.states.iter().enumerate().map(|(i, x)| (x.name.as_str(), drawn(i)));
    let fixed = |(i, p): (usize, &'_ Parameter)| match parameters {
        0 => p.value,
        draw => (if p.value == 0.0 { 1.0 } else { p.value }) * spread(5 * i + 11 * draw + 3),
    };
    let set = model.parameters.iter().enumerate().map(|(i, p)| (p.name.as_str(), fixed((i, p))));
    let mut names: BTreeMap<&str, f64> = inputs.chain(moving).chain(set).chain([("t", 1.0)]).collect();
    for d in model.definition_order().ok()? {
        if let Some(value) = value(&d.equals, &names) {
            names.insert(&d.name, value);
        }
    }
    Some(names)
}

fn value(e: &Expr, names: &BTreeMap<&str, f64>) -> Option<f64> {
    e.value(&|n| names.get(n).copied())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_accelerometer_gives_the_rate_of_a_speed_and_a_gauge_does_not() {
        let model = Model::parse(
            r#"
            name = "floor"
            [inputs]
            shaking = { unit = "m/s^2" }
            [parameters]
            c = { value = 3, unit = "N*s/m" }
            k = { value = 90, unit = "N/m" }
            m = { value = 2, unit = "kg" }
            bias = { value = 0.1, unit = "m/s^2" }
            g = { value = 9.81, unit = "m/s^2" }
            sensitivity = { value = 0.3, unit = "V*s^2/m", fit = true }
            [definitions]
            shear = { equals = "-c*v - k*x", unit = "N" }
            [states]
            x = { rate = "v", unit = "m", initial = 0 }
            v = { rate = "shear/m - shaking", unit = "m/s", initial = 0 }
            [outputs]
            relative = { equals = "-(c*v + k*x)/m - shaking", unit = "m/s^2" }
            absolute = { equals = "-shear/m + bias", unit = "m/s^2" }
            spring = { equals = "-k*x/m", unit = "m/s^2" }
            drift = { equals = "x", unit = "m" }
            speed = { equals = "v", unit = "m/s" }
            parts = { equals = "-shear/(m*g)", unit = "1" }
            volts = { equals = "2*sensitivity*shear/m", unit = "V" }
            gauge = { equals = "c*v + k*x", unit = "N" }
            "#,
        )
        .unwrap();
        let felt = |i: usize| -> Vec<(usize, String)> {
            let all = outputs(&model, &model.states[i], &Expr::name("a"));
            all.into_iter().map(|(k, e)| (k, e.to_string())).collect()
        };
        let added = |k: usize, what: &str| (k, format!("{} {what}", model.outputs[k].equals));
        let expected = [added(0, "+ a"), added(1, "- a"), added(5, "- a/g"), added(6, "+ 2*a*sensitivity")];
        assert_eq!(felt(1), expected);
        assert_eq!(felt(0), [added(4, "+ a")]);
    }
}
