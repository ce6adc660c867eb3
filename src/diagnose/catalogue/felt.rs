//! Outputs that give the rate of a state, as an accelerometer gives that of a speed: what acts on the state acts on them.

use crate::expression::Expr;
use crate::model::{Model, State};
use crate::units::Dimension;

/// Draws of the states, and how equal sums of numbers are.
const DRAWS: usize = 4;
const EQUAL: f64 = 1e-9;

/// The outputs that give the rate of a state or the opposite of it, but for what inputs and parameters alone add, with
/// the sign: numbers of the outputs. An accelerometer on a shaken floor shows the rate of its relative speed without the
/// shaking.
pub fn outputs(model: &Model, state: &State) -> Vec<(usize, f64)> {
    let dimension = state.unit.of_differences().dimension().over(Dimension::TIME);
    let alike = model.outputs.iter().enumerate().filter(|(_, o)| o.unit.dimension() == dimension);
    let sign = |e: &Expr| [1.0, -1.0].into_iter().find(|sign| follows(model, e, &state.rate, *sign));
    alike.filter_map(|(k, o)| Some((k, sign(&o.equals)?))).collect()
}

/// Whether an expression less a signed rate is the same wherever the states are.
fn follows(model: &Model, e: &Expr, rate: &Expr, sign: f64) -> bool {
    let at = |draw| Some((value(model, e, draw)?, value(model, rate, draw)?));
    let Some(seen) = (0..DRAWS).map(at).collect::<Option<Vec<(f64, f64)>>>() else { return false };
    let (e, r) = seen[0];
    let size = |x: f64, y: f64| x.abs().max(y.abs());
    let same = |(x, y): &(f64, f64)| {
        let (of_e, of_rate) = (x - e, sign * (y - r));
        (of_e - of_rate).abs() <= EQUAL * size(*x, *y).max(size(e, r))
    };
    let moves = seen.iter().any(|(_, y)| (y - r).abs() > EQUAL.sqrt() * size(*y, r));
    moves && seen.iter().all(same)
}

/// An expression at the parameters of the model, with inputs and time at fixed numbers and the states at others in each
/// draw; none where it remembers or has no value there.
fn value(model: &Model, e: &Expr, draw: usize) -> Option<f64> {
    // numbers that no model is made of
    let spread = |i: usize| 1.0 + (std::f64::consts::E * (i as f64 + 1.0)).fract();
    let lookup = |n: &str| {
        let input = || model.inputs.iter().position(|x| x.name == n).map(spread);
        let state = || model.states.iter().position(|x| x.name == n).map(|i| spread(7 * i + 13 * draw + 1));
        let parameter = || model.parameters.iter().find(|p| p.name == n).map(|p| p.value);
        let defined = || model.definitions.iter().find(|d| d.name == n);
        if n == "t" {
            return Some(1.0);
        }
        input().or_else(state).or_else(parameter).or_else(|| value(model, &defined()?.equals, draw))
    };
    e.value(&lookup)
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
            "#,
        )
        .unwrap();
        assert_eq!(outputs(&model, &model.states[1]), [(0, 1.0), (1, -1.0)]);
        assert_eq!(outputs(&model, &model.states[0]), [(4, 1.0)]);
    }
}
