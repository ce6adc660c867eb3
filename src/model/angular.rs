//! Purpose: which quantities of a model count an angle, by their place in its equations.
//!
//! Method: `1/min` is a speed of what turns here and a decay there; only the equations tell. What units say of
//! angles is taken first, with what plainly holds none (times, currents, temperatures, torques that are
//! measured), and every equation then tells of the names in it, over and over until nothing new comes. What is
//! usual comes last and only where the rest is silent: a moment of inertia makes an angular acceleration of a
//! torque, and a pure number is no angle. What stays open is not asked for.
//!
//! Numerical aspects: none.

use super::Model;
use super::places::Places;
use crate::Result;
use crate::expression::{Angles, turns};
use crate::units::{Dimension, Ratio, Unit};
use std::collections::{BTreeMap, BTreeSet};

/// Rounds over all equations, after which the rest stays open.
const ROUNDS: usize = 20;

/// Powers of an angle: of the names that expressions use, and of the outputs.
struct Found {
    names: BTreeMap<String, Ratio>,
    outputs: BTreeMap<String, Ratio>,
}

impl Model {
    /// Refuses units that may mean turns of what counts an angle by its place in the equations.
    ///
    /// # Errors
    /// `Units`, with the question, at the unit.
    pub(super) fn turns_or_radians(&self, places: &Places) -> Result<()> {
        match self.asked().first() {
            Some((section, name, p)) => {
                let unit = self.units().find(|(s, n, _)| s == section && n == name).map(|u| u.2.clone());
                let e = unit.unwrap_or_else(Unit::one).asked_by_place(*p);
                Err(places.put(&format!("{section}.{name}.unit"), e))
            }
            None => Ok(()),
        }
    }

    /// Section, name and power of an angle of everything whose unit may mean turns.
    fn asked(&self) -> Vec<(&'static str, &str, Ratio)> {
        if self.is_free {
            return Vec::new();
        }
        let either = |u: &Unit| u.may_count_turns(Ratio::ONE) || u.may_count_turns(Ratio::ONE.negative());
        if !self.units().any(|(_, _, unit)| either(unit)) {
            return Vec::new();
        }
        let found = self.angles();
        let asked = self.units().filter_map(|(section, name, unit)| {
            let own = if section == "outputs" { &found.outputs } else { &found.names };
            let p = own.get(name).filter(|p| unit.may_count_turns(**p))?;
            Some((section, name, *p))
        });
        asked.collect()
    }

    /// Gives parameters and states that a program added the units of SI where theirs would be asked for.
    pub(crate) fn in_si_where_asked(&mut self, is_added: impl Fn(&str) -> bool) {
        let asked: BTreeSet<String> =
            self.asked().into_iter().map(|a| a.1.to_string()).filter(|n| is_added(n)).collect();
        let parameters = self.parameters.iter_mut().map(|p| (&p.name, &mut p.unit));
        let states = self.states.iter_mut().map(|s| (&s.name, &mut s.unit));
        for (_, unit) in parameters.chain(states).filter(|(name, _)| asked.contains(*name)) {
            *unit = Unit::of(unit.dimension());
        }
    }

    /// Refuses values of an input, a parameter or an output of this model in a unit that may mean turns where the
    /// model counts radians, or the other way round.
    ///
    /// # Errors
    /// `Units`, with the question and how to answer it.
    pub(crate) fn takes_unit(&self, section: &str, name: &str, given: &Unit) -> Result<()> {
        let Some((_, _, wanted)) = self.units().find(|(s, n, _)| *s == section && *n == name) else {
            return Ok(());
        };
        if wanted.text() == given.text() {
            return Ok(());
        }
        wanted.turns_or_radians(given)?;
        let either = [Ratio::ONE, Ratio::ONE.negative()].iter().any(|p| given.may_count_turns(*p));
        if !either || wanted.angle_power().is_some() {
            return Ok(());
        }
        let found = self.angles();
        let own = if section == "outputs" { &found.outputs } else { &found.names };
        match own.get(name).filter(|p| given.may_count_turns(**p)) {
            Some(p) => Err(given.asked_by_place(*p)),
            None => Ok(()),
        }
    }

    /// Every quantity: its section, its name and its unit.
    fn units(&self) -> impl Iterator<Item = (&'static str, &str, &Unit)> {
        let inputs = self.inputs.iter().map(|x| ("inputs", x.name.as_str(), &x.unit));
        let parameters = self.parameters.iter().map(|x| ("parameters", x.name.as_str(), &x.unit));
        let definitions = self.definitions.iter().map(|x| ("definitions", x.name.as_str(), &x.unit));
        let states = self.states.iter().map(|x| ("states", x.name.as_str(), &x.unit));
        let outputs = self.outputs.iter().map(|x| ("outputs", x.name.as_str(), &x.unit));
        inputs.chain(parameters).chain(definitions).chain(states).chain(outputs)
    }

    /// The powers of an angle that units and equations tell.
    fn angles(&self) -> Found {
        let mut angles = Angles::default();
        let mut outputs = BTreeMap::new();
        for (section, name, unit) in self.units() {
            let known = unit.angle_power().or_else(|| plainly(section, unit.dimension()));
            let of = if section == "outputs" { &mut outputs } else { &mut angles.powers };
            of.extend(known.map(|p| (name.to_string(), p)));
        }
        let numbers = self.parameters.iter().filter(|p| p.unit.dimension().is_none() && turns(p.value));
        angles.turners = numbers.map(|p| p.name.clone()).collect();
        let states = self.states.iter().map(|s| s.name.clone());
        angles.moving = states.chain(self.definitions.iter().map(|d| d.name.clone())).collect();
        self.settle(&mut angles, &mut outputs);
        self.suppose(&mut angles, |angles, name, unit| {
            let d = unit.dimension();
            if d == inertia() {
                angles.inertias.insert(name.to_string());
            }
            (d == inertia()).then_some(Ratio::ONE.negative()).or(is_torque_gain(d).then_some(Ratio::ZERO))
        });
        self.settle(&mut angles, &mut outputs);
        self.suppose(&mut angles, |_, _, unit| unit.dimension().is_none().then_some(Ratio::ZERO));
        self.settle(&mut angles, &mut outputs);
        Found { names: angles.powers, outputs }
    }

    /// Supposes a power for the names that are still open.
    fn suppose(&self, angles: &mut Angles, of: impl Fn(&mut Angles, &str, &Unit) -> Option<Ratio>) {
        for (_, name, unit) in self.units().filter(|(section, _, _)| *section != "outputs") {
            let supposed = of(angles, name, unit);
            if let Some(p) = supposed.filter(|_| !angles.turners.contains(name)) {
                angles.powers.entry(name.to_string()).or_insert(p);
            }
        }
    }

    /// Lets every equation tell of its names until nothing new comes.
    fn settle(&self, angles: &mut Angles, outputs: &mut BTreeMap<String, Ratio>) {
        for _ in 0..ROUNDS {
            let before = angles.powers.len() + outputs.len();
            let of_states = self.states.iter().map(|s| (&s.name, &s.rate));
            let of_definitions = self.definitions.iter().map(|d| (&d.name, &d.equals));
            for (name, e) in of_definitions.chain(of_states) {
                let own = angles.take(e, angles.powers.get(name).copied());
                if let Some(p) = own {
                    angles.powers.entry(name.clone()).or_insert(p);
                }
            }
            for o in &self.outputs {
                let own = angles.take(&o.equals, outputs.get(&o.name).copied());
                if let Some(p) = own {
                    outputs.entry(o.name.clone()).or_insert(p);
                }
            }
            if angles.powers.len() + outputs.len() == before {
                return;
            }
        }
    }
}

/// A moment of inertia, kg·m².
fn inertia() -> Dimension {
    Unit::parse("kg*m^2").map_or(Dimension::NONE, |u| u.dimension())
}

/// Torque for a current or a temperature, N·m/A.
fn is_torque_gain(d: Dimension) -> bool {
    let [m, kg, s, ampere, kelvin, _] = d.powers();
    (m, kg, s) == (2.0, 1.0, -2.0) && (ampere, kelvin) != (0.0, 0.0)
}

/// Zero for what plainly holds no angle, whatever stands beside it: a time, and a signal of a current, a voltage, a
/// temperature, a mass, a force or a torque. A length may hide one, as that of a belt on its wheel does, and a
/// parameter may be a gain for one unit of angle.
fn plainly(section: &str, d: Dimension) -> Option<Ratio> {
    let [m, kg, s, ampere, kelvin, mol] = d.powers();
    let is_time = [m, kg, ampere, kelvin, mol] == [0.0; 5] && s > 0.0;
    let names = ["A", "K", "V", "kg", "mol", "N", "N*m", "Pa"];
    let is = |name: &&str| Unit::parse(name).is_ok_and(|u| u.dimension() == d);
    let is_signal = section != "parameters" && names.iter().any(is);
    let is_flow = !["parameters", "definitions"].contains(&section)
        && m == 0.0
        && [kg, ampere, kelvin, mol] != [0.0; 4];
    (is_time || is_signal || is_flow).then_some(Ratio::ZERO)
}
