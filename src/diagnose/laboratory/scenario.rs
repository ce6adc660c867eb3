//! A model with a recording whose inputs are used.

use super::plants::{self, Plant};
use crate::diagnose::bench::Bench;
use crate::model::{Initial, Model};
use crate::record::{Channel, Kind, Recording};
use crate::units::Unit;
use crate::{Error, Result};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A model with a recording whose inputs are used.
#[derive(Clone)]
pub struct Scenario {
    /// The plant's name, or the model's.
    pub name: String,
    /// The model, at its true values.
    pub model: Model,
    /// The recording; a plant's outputs are still empty.
    pub recording: Recording,
    /// States whose start is known; that of the others is fitted.
    known: Vec<String>,
}

impl Scenario {
    /// The laboratory's axis, driven by a drawn force.
    ///
    /// # Errors
    /// Never, unless the plant's file is broken.
    pub fn axis(seed: u64) -> Result<Self> {
        let axis = plants::ALL.iter().find(|p| p.name == "axis");
        let axis = axis.ok_or_else(|| Error::not_computed("the laboratory has no axis"))?;
        Self::drawn(axis, &mut ChaCha8Rng::seed_from_u64(seed))
    }

    /// A plant under drawn inputs.
    ///
    /// # Errors
    /// Never, unless the plant's file is broken.
    pub fn drawn(plant: &Plant, rng: &mut ChaCha8Rng) -> Result<Self> {
        let model = Model::parse(plant.model)?;
        let (time, driven) = plant.draw(rng);
        let recorded = |(name, unit, values): (&str, &str, Vec<f64>)| {
            let unit = Unit::parse(unit)?;
            let values = values.iter().map(|v| unit.to_si(*v)).collect();
            Ok(Channel::new(name, unit, time.clone(), values))
        };
        let mut channels = driven.into_iter().map(recorded).collect::<Result<Vec<_>>>()?;
        let empty = |o: &crate::model::Output| {
            Channel::new(&*o.name, o.unit.clone(), time.clone(), vec![0.0; time.len()])
        };
        channels.extend(model.outputs.iter().map(empty));
        let recording = Recording::from_channels("laboratory", channels)?;
        let known = plant.known.iter().map(ToString::to_string).collect();
        Ok(Self { name: plant.name.into(), model, recording, known })
    }

    /// A user's model and recording: the model is fitted first.
    ///
    /// # Errors
    /// Where it is a table of trials, outputs have times of their own, or it cannot be fitted.
    pub fn of(model: &Model, recording: &Recording, seed: u64) -> Result<Self> {
        one_clock(model, recording)?;
        let f = Bench::new(model, vec![recording.clone()], false, seed).full_fit(model)?;
        let mut model = f.model.clone();
        for (s, x) in model.states.iter_mut().zip(&f.records[0].initials) {
            if x.is_finite() {
                s.initial = Initial::Number(*x);
            }
        }
        Ok(Self { name: model.name.clone(), model, recording: recording.clone(), known: Vec::new() })
    }

    /// The model as a user has it: fitted parameters a third off, starts to be fitted.
    pub fn start(&self, rng: &mut ChaCha8Rng) -> Model {
        let mut start = self.model.clone();
        for p in start.parameters.iter_mut().filter(|p| p.fit) {
            // by a factor of what a user reads: a third of 20 °C, not of 293 K
            let off = p.unit.to_si(p.unit.from_si(p.value) * f64::exp(rng.random_range(-0.3..0.3)));
            p.value = off.clamp(p.min.unwrap_or(f64::NEG_INFINITY), p.max.unwrap_or(f64::INFINITY));
        }
        for s in start.states.iter_mut().filter(|s| !self.known.contains(&s.name)) {
            s.initial = Initial::Fit;
        }
        start
    }
}

/// Refuses what the recordings that are made cannot hold: trials, and outputs with times of their own.
fn one_clock(model: &Model, recording: &Recording) -> Result<()> {
    if recording.kind == Kind::Trials {
        return Err(Error::bad_input(
            "the laboratory makes recordings in time, and this is a table of trials",
        ));
    }
    let outputs = model.outputs.iter().filter_map(|o| recording.find(&o.name));
    let times: Vec<&[f64]> = outputs.map(|c| &c.time[..]).collect();
    if times.windows(2).any(|w| w[0] != w[1]) {
        let error =
            Error::bad_input("the outputs have times of their own, and the laboratory makes one table");
        return Err(error.with_hint("give a recording whose outputs are sampled together"));
    }
    Ok(())
}
