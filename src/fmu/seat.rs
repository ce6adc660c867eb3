//! An instance of a unit for model exchange, held where a solver asks for rates.

use super::Fmu;
use gyrospec_fmi::{Instance, Kind, Refused, Version};

/// Rounds of an event before it is given up.
const ROUNDS: usize = 100;

/// A number among the values of a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Place {
    /// The variable, by its position.
    pub variable: usize,
    /// Which of its numbers.
    pub element: usize,
}

/// An instance with the parameters that it was started with.
pub(super) struct Seat {
    pub instance: Instance,
    pub parameters: Vec<f64>,
    indicators: Vec<f64>,
    room: Vec<f64>,
    next: Option<f64>,
    from: f64,
    /// What the inputs that change at events only were set to.
    discrete: Vec<f64>,
}

/// Sets numbers among the values of variables, in the units of the unit.
pub(super) fn set(
    fmu: &Fmu,
    instance: &mut Instance,
    places: &[Place],
    values: &[f64],
) -> Result<(), Refused> {
    let variables = &fmu.description.variables;
    let mut i = 0;
    while i < places.len() {
        let v = &variables[places[i].variable];
        let mut whole = v.start.clone();
        let first = places[i].variable;
        while i < places.len() && places[i].variable == first {
            whole[places[i].element] = values[i];
            i += 1;
        }
        instance.set(v.number, &[v.reference], &whole)?;
    }
    Ok(())
}

/// Reads numbers among the values of variables.
pub(super) fn get(
    fmu: &Fmu,
    instance: &mut Instance,
    places: &[Place],
    values: &mut [f64],
) -> Result<(), Refused> {
    let mut i = 0;
    while i < places.len() {
        let v = &fmu.description.variables[places[i].variable];
        let mut whole = vec![0.0; v.start.len()];
        instance.get(v.number, &[v.reference], &mut whole)?;
        let first = places[i].variable;
        while i < places.len() && places[i].variable == first {
            values[i] = whole[places[i].element];
            i += 1;
        }
    }
    Ok(())
}

impl Seat {
    /// Starts an instance at a time with parameters, in the units of the unit.
    pub fn start(
        fmu: &Fmu,
        (from, inputs, values): (f64, &[Place], &[f64]),
        (places, parameters): (&[Place], &[f64]),
    ) -> Result<Self, String> {
        let d = &fmu.description;
        let mut instance = Instance::new(&fmu.library, Kind::ModelExchange, &d.token, &fmu.resources())?;
        let all = |i: &mut Instance| -> Result<(), Refused> {
            set(fmu, i, places, parameters)?;
            if d.version == Version::Two {
                set(fmu, i, inputs, values)?;
            }
            i.begin_initialisation(from, None)?;
            set(fmu, i, inputs, values)?;
            i.end_initialisation()
        };
        all(&mut instance).map_err(|e| e.to_string())?;
        let n = d.states.iter().map(|s| d.variables[s.0].start.len()).sum();
        let mut seat = Self {
            instance,
            parameters: parameters.to_vec(),
            indicators: vec![0.0; d.indicators],
            room: vec![0.0; d.indicators.max(n)],
            next: None,
            from,
            discrete: discrete(fmu, inputs, values),
        };
        seat.settle().map_err(|e| e.to_string())?;
        let mut now = vec![0.0; d.indicators];
        seat.instance.indicators(&mut now).map_err(|e| e.to_string())?;
        seat.indicators = now;
        Ok(seat)
    }

    /// Goes through an event, from event mode to continuous time.
    fn settle(&mut self) -> Result<(), Refused> {
        for _ in 0..ROUNDS {
            let event = self.instance.update_discrete()?;
            self.next = event.next;
            if !event.again {
                return self.instance.enter_continuous();
            }
        }
        Err(Refused { call: "an event that never ends", status: 3 })
    }

    /// Whether time went back behind what the clock of the unit has seen.
    pub fn is_behind(&self, t: f64) -> bool {
        t < self.from
    }

    /// Brings the instance to a time and states; its inputs were set. Where an indicator changed sign, or the clock of
    /// the unit rings, it goes through the event, and stays where it was.
    pub fn move_to(&mut self, t: f64, x: &[f64]) -> Result<(), Refused> {
        self.instance.set_time(t)?;
        if !x.is_empty() {
            self.instance.set_states(x)?;
        }
        if self.indicators.is_empty() && self.next.is_none() {
            return Ok(());
        }
        let mut now = std::mem::take(&mut self.room);
        let n = self.indicators.len();
        let read = self.instance.indicators(&mut now[..n]);
        let crossed = now.iter().zip(&self.indicators).any(|(a, b)| (*a > 0.0) != (*b > 0.0));
        self.indicators.copy_from_slice(&now[..n]);
        self.room = now;
        read?;
        let rings = self.next.is_some_and(|next| t >= next);
        if rings {
            self.from = t;
        }
        if crossed || rings {
            self.instance.enter_events()?;
            self.settle()?;
            if !x.is_empty() {
                self.instance.set_states(x)?;
            }
        }
        Ok(())
    }

    /// Sets the inputs; those that change at events only, in an event.
    pub fn feed(&mut self, fmu: &Fmu, places: &[Place], values: &[f64]) -> Result<(), Refused> {
        let discrete = discrete(fmu, places, values);
        if discrete == self.discrete {
            let is_free = |p: &&Place| !fmu.description.variables[p.variable].is_discrete;
            if self.discrete.is_empty() {
                return set(fmu, &mut self.instance, places, values);
            }
            let (own, now): (Vec<Place>, Vec<f64>) =
                places.iter().zip(values).filter(|(p, _)| is_free(p)).map(|(p, v)| (*p, *v)).unzip();
            return set(fmu, &mut self.instance, &own, &now);
        }
        self.discrete = discrete;
        self.instance.enter_events()?;
        set(fmu, &mut self.instance, places, values)?;
        self.settle()
    }
}

/// The values of the inputs that change at events only.
fn discrete(fmu: &Fmu, places: &[Place], values: &[f64]) -> Vec<f64> {
    let both = places.iter().zip(values);
    both.filter(|(p, _)| fmu.description.variables[p.variable].is_discrete).map(|(_, v)| *v).collect()
}
