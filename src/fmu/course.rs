//! A unit for co-simulation: stepped as a whole over the times of a recording; only its outputs are known.
//!
//! # Numerical aspects
//! Where the unit takes slopes of its inputs (FMI 2.0, `canInterpolateInputs`), an input runs straight through its values at
//! a quarter and three quarters of a step, which no leap at an end of it bends. Elsewhere it has during a step its value in
//! the middle: a staircase, whose leaps a unit with a backlash, a rate limit or a derivative sees. At the end of a step it
//! has the value of the end. Where the unit allows it a sample is gone in four steps.

use super::Fmu;
use super::exchange::Scalar;
use super::seat::{Place, get, set};
use crate::{Error, Result};
use gyrospec_fmi::{Instance, Kind, Refused, Version};
use std::sync::Arc;

/// Steps in an interval between samples.
const PARTS: usize = 4;

/// A unit for co-simulation with what a model gives it and asks of it.
pub(crate) struct Drive {
    pub fmu: Arc<Fmu>,
    pub inputs: Vec<(String, Scalar)>,
    pub parameters: Vec<(String, Scalar)>,
    pub outputs: Vec<(String, Scalar)>,
}

/// What is asked of a run; everything in SI.
pub(crate) struct Course<'a> {
    /// Times at which the outputs are wanted, s, rising.
    pub times: &'a [f64],
    /// The inputs at a time.
    pub inputs: &'a dyn Fn(f64) -> Vec<f64>,
    /// The parameters.
    pub parameters: &'a [f64],
}

impl Drive {
    fn places(list: &[(String, Scalar)]) -> Vec<Place> {
        list.iter().map(|(_, s)| s.place).collect()
    }

    /// Values in the units of the unit.
    fn own(list: &[(String, Scalar)], si: &[f64]) -> Vec<f64> {
        list.iter().zip(si).map(|((_, s), v)| s.unit.from_si(*v)).collect()
    }

    /// The outputs at the times, output by output, in SI.
    ///
    /// # Errors
    /// `NotComputed` where the unit refuses a call, with the call and the time.
    pub fn run(&self, course: &Course<'_>) -> Result<Vec<Vec<f64>>> {
        let (Some(first), Some(last)) = (course.times.first(), course.times.last()) else {
            return Ok(vec![Vec::new(); self.outputs.len()]);
        };
        let d = &self.fmu.description;
        let wrong = |t: f64, e: &dyn std::fmt::Display| {
            Error::not_computed(format!("the FMU {} stops at t = {t} s: {e}", d.name))
                .with_file(&self.fmu.source.file)
        };
        let mut unit = Instance::new(&self.fmu.library, Kind::CoSimulation, &d.token, &self.fmu.resources())
            .map_err(|e| wrong(*first, &e))?;
        self.start(&mut unit, course, (*first, *last)).map_err(|e| wrong(*first, &e))?;
        let mut all = vec![Vec::with_capacity(course.times.len()); self.outputs.len()];
        self.read(&mut unit, &mut all).map_err(|e| wrong(*first, &e))?;
        for w in course.times.windows(2) {
            let parts = self.parts(w[1] - w[0]);
            let at =
                |k: usize| if k == parts { w[1] } else { w[0] + (w[1] - w[0]) * k as f64 / parts as f64 };
            for k in 0..parts {
                let ends = self.step(&mut unit, course, (at(k), at(k + 1))).map_err(|e| wrong(at(k), &e))?;
                if ends {
                    return Err(wrong(at(k + 1), &"it ends the simulation itself"));
                }
            }
            self.read(&mut unit, &mut all).map_err(|e| wrong(w[1], &e))?;
        }
        Ok(all)
    }

    fn start(
        &self,
        unit: &mut Instance,
        course: &Course<'_>,
        (from, to): (f64, f64),
    ) -> std::result::Result<(), Refused> {
        let (places, values) =
            (Self::places(&self.parameters), Self::own(&self.parameters, course.parameters));
        set(&self.fmu, unit, &places, &values)?;
        let inputs = Self::own(&self.inputs, &(course.inputs)(from));
        if self.fmu.description.version == Version::Two {
            set(&self.fmu, unit, &Self::places(&self.inputs), &inputs)?;
        }
        unit.begin_initialisation(from, Some(to))?;
        set(&self.fmu, unit, &Self::places(&self.inputs), &inputs)?;
        unit.end_initialisation()
    }

    /// Into how many steps an interval is divided.
    fn parts(&self, interval: f64) -> usize {
        let Some(i) = self.fmu.description.simulation.as_ref() else { return 1 };
        let steps = |own: f64| interval / PARTS as f64 / own;
        let fits =
            i.own_step.is_none_or(|own| (steps(own) - steps(own).round()).abs() < 1e-6 && steps(own) > 0.5);
        if self.inputs.is_empty() || !i.takes_any_step || !fits { 1 } else { PARTS }
    }

    fn step(
        &self,
        unit: &mut Instance,
        course: &Course<'_>,
        (from, to): (f64, f64),
    ) -> std::result::Result<bool, Refused> {
        let places = Self::places(&self.inputs);
        let at = |t: f64| Self::own(&self.inputs, &(course.inputs)(t));
        let step = to - from;
        let mut values = at(from + 0.5 * step);
        let (mut references, mut slopes) = (Vec::new(), Vec::new());
        if self.fmu.description.simulation.as_ref().is_some_and(|i| i.takes_input_slopes) {
            let (early, late) = (at(from + 0.25 * step), at(from + 0.75 * step));
            for (k, p) in places.iter().enumerate() {
                let v = &self.fmu.description.variables[p.variable];
                if v.number.is_real() && !v.is_discrete {
                    let slope = (late[k] - early[k]) / (0.5 * step);
                    values[k] = early[k] - 0.25 * step * slope;
                    references.push(v.reference);
                    slopes.push(slope);
                }
            }
        }
        set(&self.fmu, unit, &places, &values)?;
        unit.input_slopes(&references, &slopes)?;
        let ends = unit.step(from, step)?;
        set(&self.fmu, unit, &places, &at(to))?;
        Ok(ends)
    }

    fn read(&self, unit: &mut Instance, all: &mut [Vec<f64>]) -> std::result::Result<(), Refused> {
        let mut values = vec![0.0; self.outputs.len()];
        get(&self.fmu, unit, &Self::places(&self.outputs), &mut values)?;
        for ((list, value), (_, s)) in all.iter_mut().zip(values).zip(&self.outputs) {
            list.push(s.unit.to_si(value));
        }
        Ok(())
    }
}
