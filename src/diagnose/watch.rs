//! The signals of a model while it runs: their sizes, spreads and paces.

use super::catalogue::{Signal, SignalKind, arguments, edit};
use crate::expression::{Expr, Function};
use crate::model::{Model, Output};
use crate::record::{Kind, Recording};

/// Times at which signals are looked at.
pub const LOOKS: usize = 3000;

/// Statistics of all signals, and of the largest term of each state's sum.
pub struct Looks {
    /// The signals.
    pub signals: Vec<Signal>,
    /// The sizes, by state.
    pub sizes: Vec<f64>,
    /// What parameters multiply, and its root mean square.
    pub arguments: Vec<(Expr, f64)>,
}

/// What the probing run watches.
pub struct Watched {
    names: Vec<(String, SignalKind)>,
    terms: Vec<(usize, Expr)>,
    arguments: Vec<Expr>,
}

impl Watched {
    /// States, definitions, outputs, inputs and the terms of every sum; inputs beyond the model's own
    /// are channels that a mechanism already uses.
    pub fn of(model: &Model, own_inputs: usize) -> Self {
        let states = model.states.iter().map(|s| (s.name.clone(), SignalKind::State));
        let definitions = model.definitions.iter().map(|d| (d.name.clone(), SignalKind::Definition));
        let outputs = model.outputs.iter().map(|o| (o.name.clone(), SignalKind::Output));
        let kind = |i: usize, name: &str| match i < own_inputs {
            _ if model.is_simulated(name) => SignalKind::Definition,
            true => SignalKind::Input,
            false => SignalKind::Channel,
        };
        let inputs = model.inputs.iter().enumerate().map(|(i, u)| (u.name.clone(), kind(i, &u.name)));
        let terms = model.states.iter().enumerate().flat_map(|(i, s)| {
            edit::terms_of(model, edit::sum_of(model, &s.rate)).into_iter().map(move |t| (i, t))
        });
        Self {
            names: states.chain(definitions).chain(outputs).chain(inputs).collect(),
            terms: terms.collect(),
            arguments: arguments::arguments(model),
        }
    }

    fn expression(model: &Model, name: &str, kind: SignalKind) -> Expr {
        let output = model.outputs.iter().find(|o| o.name == name && kind == SignalKind::Output);
        output.map_or_else(|| Expr::Name(name.to_string()), |o| o.equals.clone())
    }

    /// The same as outputs of a probing model.
    pub fn outputs(&self, model: &Model) -> Vec<Output> {
        let of = |e: Expr, i: usize| Output {
            name: format!("watched_{i}"),
            unit: edit::unit_of(&e, &|n| edit::unit_of_name(model, n)),
            equals: e,
            meaning: None,
        };
        let named = self.names.iter().map(|(n, kind)| Self::expression(model, n, *kind));
        let all = named.chain(self.terms.iter().map(|t| t.1.clone())).chain(self.arguments.iter().cloned());
        all.enumerate().map(|(i, e)| of(e, i)).collect()
    }

    /// Their statistics from the probing run.
    pub fn statistics(
        &self,
        model: &Model,
        recordings: &[Recording],
        values: &[Vec<f64>],
        pace: f64,
    ) -> Looks {
        let mut signals = Vec::new();
        for ((name, kind), v) in self.names.iter().zip(values) {
            let unit = model.outputs.iter().find(|o| o.name == *name && *kind == SignalKind::Output);
            let unit = unit.map(|o| o.unit.clone()).or_else(|| edit::unit_of_name(model, name));
            let unit = unit.unwrap_or_else(crate::units::Unit::one);
            signals.push(statistics(name.clone(), *kind, unit, v, pace));
        }
        let used = |name: &str| self.names.iter().any(|(n, _)| n == name);
        for c in recordings.iter().take(1).flat_map(|r| &r.channels).filter(|c| !used(&c.name)) {
            let everywhere = recordings.iter().all(|r| r.find(&c.name).is_some());
            let counts = recordings[0].kind == Kind::Trials && c.values.windows(2).all(|w| w[0] < w[1]);
            if everywhere && !counts {
                let stride = (c.values.len() / LOOKS).max(1);
                let v: Vec<f64> =
                    c.values.iter().step_by(stride).copied().filter(|v| v.is_finite()).collect();
                let step = c.median_step().unwrap_or(1.0) * stride as f64;
                signals.push(statistics(c.name.clone(), SignalKind::Channel, c.unit.clone(), &v, step));
            }
        }
        let size_of = |i: usize| {
            let own = self.terms.iter().zip(&values[self.names.len()..]).filter(|(t, _)| t.0 == i);
            own.map(|(_, v)| rms(v)).fold(0.0, f64::max)
        };
        for s in &mut signals {
            s.is_turned = takes_sine(model, &s.name);
        }
        let sizes = (0..model.states.len()).map(|i| Some(size_of(i)).filter(|s| *s > 0.0).unwrap_or(1.0));
        let arguments = self.arguments.iter().zip(&values[self.names.len() + self.terms.len()..]);
        let arguments = arguments.map(|(e, v)| (e.clone(), rms(v))).collect();
        Looks { signals, sizes: sizes.collect(), arguments }
    }
}

/// Root mean square.
pub fn rms(v: &[f64]) -> f64 {
    (v.iter().map(|x| x * x).sum::<f64>() / v.len().max(1) as f64).sqrt()
}

/// Root mean square about the mean.
pub fn spread(v: &[f64]) -> f64 {
    let mean = v.iter().sum::<f64>() / v.len().max(1) as f64;
    rms(&v.iter().map(|x| x - mean).collect::<Vec<_>>())
}

/// The same of a channel, over all recordings.
pub fn spread_of(recordings: &[Recording], name: &str) -> f64 {
    let channels = recordings.iter().filter_map(|r| r.find(name));
    let values: Vec<f64> =
        channels.flat_map(|c| c.values.iter().copied()).filter(|v| v.is_finite()).collect();
    spread(&values)
}

fn statistics(name: String, kind: SignalKind, unit: crate::units::Unit, v: &[f64], step: f64) -> Signal {
    let n = v.len().max(1) as f64;
    let mean = v.iter().sum::<f64>() / n;
    let spread = (v.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n).sqrt();
    let slope = (v.windows(2).map(|w| (w[1] - w[0]).powi(2)).sum::<f64>() / n).sqrt() / step;
    let mut sorted = v.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted.dedup();
    Signal {
        name,
        kind,
        unit,
        mean,
        spread,
        min: sorted.first().copied().unwrap_or(0.0),
        max: sorted.last().copied().unwrap_or(0.0),
        levels: sorted.len().min(64),
        pace: if slope > 0.0 { (spread / slope).max(0.3 * step) } else { f64::INFINITY },
        is_turned: false,
    }
}

/// Whether the model takes the sine of an expression with a name in it.
fn takes_sine(model: &Model, name: &str) -> bool {
    let sine =
        |e: &Expr| matches!(e, Expr::Call(Function::Sin, args) if args.iter().any(|a| a.mentions(name)));
    let definitions = model.definitions.iter().map(|d| &d.equals);
    let mut all = definitions
        .chain(model.states.iter().map(|s| &s.rate))
        .chain(model.outputs.iter().map(|o| &o.equals));
    all.any(|e| edit::find(e, &sine).is_some())
}
