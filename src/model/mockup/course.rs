//! A unit that steps itself: only its outputs are known, as courses of time.
//!
//! # Method
//! An output y stands in expressions as `y_simulated`, which is computed on the times of a recording. Where parameters p
//! of the unit are fitted it is a definition, linear in them about where they stand,
//! y = (y₀ − Σ p₀ ∂y/∂p) + Σ p ∂y/∂p, with central differences of whole runs; a fit moves p₀ first (`estimate`).

use super::super::begun::Mockup;
use super::super::simulated::ENDING;
use super::super::{Definition, Input, Model, Output};
use super::output;
use super::parts::{Entry, Parts};
use crate::expression::{BinaryOp, Expr};
use crate::fmu::{Course, Drive, Fmu};
use crate::record::{Channel, Recording};
use crate::units::Unit;
use crate::{Error, Result};
use std::sync::Arc;

/// What stands behind the name of the part that does not depend on fitted parameters, and before a parameter's name.
const REST: &str = "_simulated_rest";
const BY: &str = "_simulated_by_";

/// Share of a parameter that a difference steps.
const STEP: f64 = 1e-4;

/// Outputs of a unit that steps itself.
pub(super) fn as_course(fmu: &Arc<Fmu>, parts: &Parts, model: &mut Model) -> Drive {
    let outputs: Vec<&Entry> = parts.outputs.iter().filter(|e| parts.is_compared(e)).collect();
    for e in &outputs {
        let own = format!("{}{ENDING}", e.name);
        let meaning = Some(format!("{} as the FMU has it", e.name));
        model.inputs.push(Input { name: own.clone(), unit: e.scalar.unit.clone(), meaning });
        model.outputs.push(output(e, Expr::Name(own)));
    }
    Drive {
        fmu: fmu.clone(),
        inputs: parts.inputs.iter().map(Entry::pair).collect(),
        parameters: parts.parameters.iter().map(Entry::pair).collect(),
        outputs: outputs.into_iter().map(Entry::pair).collect(),
    }
}

/// Puts what a unit gives as a line in its fitted parameters.
pub(super) fn linearise(model: &mut Model) {
    let Some((mockup, drive)) = model.fmu.clone().and_then(|m| Some((m.clone(), m.drive?))) else { return };
    let is_own = |name: &str| drive.parameters.iter().any(|(n, _)| n == name);
    let fitted: Vec<(String, Unit)> = model
        .parameters
        .iter()
        .filter(|p| p.fit && is_own(&p.name) && mockup.names.contains(&p.name))
        .map(|p| (p.name.clone(), p.unit.clone()))
        .collect();
    if fitted.is_empty() {
        return;
    }
    for (stem, scalar) in &drive.outputs {
        let (whole, unit) = (format!("{stem}{ENDING}"), &scalar.unit);
        model.inputs.retain(|i| i.name != whole);
        let rest = format!("{stem}{REST}");
        let mut equals = Expr::Name(rest.clone());
        model.inputs.push(Input { name: rest, unit: unit.clone(), meaning: None });
        for (p, by) in &fitted {
            let name = format!("{stem}{BY}{p}");
            let term = Expr::Binary(
                BinaryOp::Mul,
                Box::new(Expr::Name(p.clone())),
                Box::new(Expr::Name(name.clone())),
            );
            equals = Expr::Binary(BinaryOp::Add, Box::new(equals), Box::new(term));
            let slope = unit.of_differences().dimension().over(by.of_differences().dimension());
            model.inputs.push(Input { name, unit: Unit::of(slope), meaning: None });
        }
        let meaning = Some(format!("{stem} as the FMU has it"));
        model.definitions.push(Definition { name: whole, equals, unit: unit.clone(), meaning });
    }
    if let Some(m) = &mut model.fmu {
        m.fitted = fitted.into_iter().map(|f| f.0).collect();
    }
}

/// What a unit gave on a recording, in SI: its times, and each output of the unit on them.
pub(crate) struct Ran {
    pub times: Arc<[f64]>,
    pub outputs: Vec<Vec<f64>>,
    table: usize,
}

impl Model {
    /// Whether an input or definition of the model is what the FMU gives when it steps itself.
    pub(in super::super) fn steps(&self, name: &str) -> bool {
        let drive = self.fmu.as_ref().and_then(|m| m.drive.as_ref());
        drive.is_some_and(|d| {
            d.outputs.iter().any(|(stem, _)| {
                let behind = name.strip_prefix(stem.as_str());
                behind.is_some_and(|b| b == ENDING || b == REST || b.starts_with(BY))
            })
        })
    }

    /// Numbers of the parameters of an FMU that steps itself that are fitted.
    pub(crate) fn stepping(&self) -> Vec<usize> {
        let Some(m) = &self.fmu else { return Vec::new() };
        let number = |name: &String| self.parameters.iter().position(|p| p.name == *name);
        m.fitted.iter().filter_map(number).collect()
    }

    /// For each output of the FMU the output of the model that is it and nothing more.
    pub(crate) fn stepped_as(&self) -> Vec<Option<usize>> {
        let Some(drive) = self.fmu.as_ref().and_then(|m| m.drive.as_ref()) else { return Vec::new() };
        let is = |o: &Output, stem: &str| o.equals == Expr::Name(format!("{stem}{ENDING}"));
        drive.outputs.iter().map(|(stem, _)| self.outputs.iter().position(|o| is(o, stem))).collect()
    }

    /// A recording with what the FMU gives at the values of the model's parameters; `None` where it has that already.
    pub(in super::super) fn stepped(&self, recording: &Recording) -> Result<Option<Recording>> {
        let Some(drive) = self.fmu.as_ref().and_then(|m| m.drive.as_ref()) else { return Ok(None) };
        let own: Vec<&String> = self.inputs.iter().map(|i| &i.name).filter(|n| self.steps(n)).collect();
        if own.iter().all(|n| recording.find(n).is_some()) {
            return Ok(None);
        }
        let ran = self.step(recording)?;
        let slopes = self.stepping().into_iter().map(|k| self.slopes_by(recording, k));
        let slopes: Vec<(usize, Vec<Vec<f64>>)> = slopes.collect::<Result<_>>()?;
        let mut joined = recording.clone();
        let mut add = |name: String, unit: Unit, values: Vec<f64>| {
            let channel = Channel::new(name, unit, ran.times.clone(), values);
            joined.channels.push(Channel { table: ran.table, ..channel });
        };
        for (o, (stem, s)) in drive.outputs.iter().enumerate() {
            let mut rest = ran.outputs[o].clone();
            for (k, by) in &slopes {
                // y₀ − Σ p₀ ∂y/∂p
                let p = self.parameters[*k].value;
                rest.iter_mut().zip(&by[o]).for_each(|(r, slope)| *r -= p * slope);
                let name = format!("{stem}{BY}{}", self.parameters[*k].name);
                let unit =
                    self.inputs.iter().find(|i| i.name == name).map_or_else(Unit::one, |i| i.unit.clone());
                add(name, unit, by[o].clone());
            }
            let ending = if slopes.is_empty() { ENDING } else { REST };
            add(format!("{stem}{ending}"), s.unit.clone(), rest);
        }
        Ok(Some(joined))
    }

    /// The number of a parameter, and the derivatives of all outputs by it, by central differences.
    pub(crate) fn slopes_by(&self, recording: &Recording, k: usize) -> Result<(usize, Vec<Vec<f64>>)> {
        let p = &self.parameters[k];
        let h = STEP * if p.value == 0.0 { 1.0 } else { p.value.abs() };
        let (low, high) = (p.min.unwrap_or(f64::NEG_INFINITY), p.max.unwrap_or(f64::INFINITY));
        let at = |value: f64| {
            let mut moved = self.clone();
            moved.parameters[k].value = value.clamp(low, high);
            Ok::<_, Error>((moved.parameters[k].value, moved.step(recording)?.outputs))
        };
        let ((a, below), (b, above)) = (at(p.value - h)?, at(p.value + h)?);
        let by = |(y, z): (&Vec<f64>, &Vec<f64>)| {
            y.iter().zip(z).map(|(y, z)| if b > a { (z - y) / (b - a) } else { 0.0 }).collect()
        };
        Ok((k, below.iter().zip(&above).map(by).collect()))
    }

    /// Runs the FMU over a recording's times and inputs, at the values of the model's parameters.
    ///
    /// # Errors
    /// Where an input is not there or has a gap, and where the FMU stops.
    pub(crate) fn step(&self, recording: &Recording) -> Result<Ran> {
        let lost = || Error::not_computed("the model has no FMU that steps itself");
        let (mockup, drive) =
            self.fmu.as_ref().and_then(|m| Some((m, m.drive.as_ref()?))).ok_or_else(lost)?;
        let inputs = drive.inputs.iter().map(|(name, _)| recording.channel(&mockup.channel("inputs", name)));
        let inputs: Vec<&Channel> = inputs.collect::<Result<_>>()?;
        let measured = self.outputs.iter().find_map(|o| recording.find(&o.name));
        let clock = measured
            .or(inputs.first().copied())
            .ok_or_else(|| Error::bad_input(format!("'{}' has no channel of the FMU", recording.name)))?;
        let inside = |t: f64| inputs.iter().filter_map(|c| c.range()).all(|r| r.from <= t && t <= r.to);
        let times: Vec<f64> = clock.time.iter().copied().filter(|t| inside(*t)).collect();
        let at = |t: f64| inputs.iter().map(|c| c.value_at(t).unwrap_or(f64::NAN)).collect::<Vec<_>>();
        if let Some(t) = times.iter().find(|t| at(**t).iter().any(|v| v.is_nan())) {
            let e = Error::bad_input(format!(
                "an input of the FMU has a gap at t = {t} s in '{}'",
                recording.name
            ));
            return Err(e.with_hint(
                "an FMU that steps itself cannot wait: cut the recording there, or fill the gap",
            ));
        }
        let parameters = drive.parameters.iter().map(|(name, _)| self.value_of(name)).collect::<Vec<f64>>();
        let outputs = drive.run(&Course { times: &times, inputs: &at, parameters: &parameters })?;
        Ok(Ran { times: times.into(), outputs, table: clock.table })
    }

    fn value_of(&self, parameter: &str) -> f64 {
        self.parameters.iter().find(|p| p.name == parameter).map_or(0.0, |p| p.value)
    }
}

impl Mockup {
    /// The channel that holds an input or output.
    fn channel(&self, section: &str, name: &str) -> String {
        let own = self.channels.iter().find(|c| c.0 == section && c.1 == name);
        own.map_or_else(|| name.to_owned(), |c| c.2.clone())
    }
}
