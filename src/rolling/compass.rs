//! The compass's numbers: the paper's, a built-in model's, or those of a file's `[parameters]`; what a file leaves out
//! is the paper's gyrocompass, or the built-in it extends.

use super::equations;
use crate::gyro::elastic::{Elastic, Inertia, Lag, Relaxing};
use crate::gyro::{Gyrosphere, Instrument, range};
use crate::model::{Model, Number, Numbers};
use crate::spectrum::Roll;
use crate::units::Unit;
use crate::{Error, Result};

/// A compass with the account of where its numbers come from.
#[derive(Debug, Clone)]
pub struct Compass {
    /// Its numbers.
    pub sphere: Gyrosphere,
    /// The elastic part.
    pub part: Box<dyn Elastic>,
    /// Speed of the ship over the ground, m/s.
    pub speed: f64,
    /// The roll that its file describes by A, mu and eps.
    pub roll: Option<Roll>,
    /// Where the numbers come from.
    pub origin: Origin,
}

/// Where the numbers of a compass come from.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Origin {
    /// The built-in model behind them; `None`: the paper.
    pub builtin: Option<String>,
    /// The parameters that the file gives.
    pub given: Vec<String>,
    /// Those of them that the theory does not use.
    pub unused: Vec<String>,
}

impl Compass {
    /// The gyrocompass of the rolling-error paper with the elastic lag.
    pub fn paper() -> Self {
        Self {
            sphere: Gyrosphere::seed(),
            part: Box::new(Lag),
            speed: 0.0,
            roll: None,
            origin: Origin::default(),
        }
    }

    /// The compass of a built-in model.
    ///
    /// # Errors
    /// `BadInput` for an unknown name, and for a model without an elastic part.
    pub fn builtin(name: &str) -> Result<Self> {
        let mut f = Filling::of_paper();
        f.builtin(name)?;
        f.compass()
    }

    /// The compass of the text of a model file, or of a file with `[parameters]` alone.
    ///
    /// ```
    /// use gyrospec::rolling::Compass;
    /// let compass = Compass::parse("[parameters]\nh = { value = 15, unit = \"m\" }\nT2 = 4\nkappa = 0.1").unwrap();
    /// assert!(compass.sphere.lever == 15.0 && compass.part.name() == "lag and liquid flow");
    /// assert_eq!(compass.origin.given, ["h", "T2", "kappa"]);
    /// ```
    ///
    /// # Errors
    /// `BadInput` or `Units` with the place of what is wrong; a model whose equations are not those of a gyrosphere.
    pub fn parse(text: &str) -> Result<Self> {
        let mut f = Filling::of_paper();
        f.read(text)?;
        f.compass()
    }

    /// The compass with its elastic part.
    pub fn instrument(&self) -> Instrument {
        let mut instrument = Instrument::new(self.sphere, self.part.clone());
        instrument.speed = self.speed;
        instrument
    }
}

/// The numbers of a second relaxation.
const FLOW: [&str; 2] = ["T2", "kappa"];

/// All names of the symbol table.
fn names() -> impl Iterator<Item = &'static str> {
    Gyrosphere::NAMES.into_iter().chain(Roll::NAMES).chain(FLOW)
}

/// What a file's parameters have filled so far.
struct Filling {
    sphere: Gyrosphere,
    roll: [Option<f64>; 3],
    /// T₂ and κ of a second relaxation.
    flow: [Option<f64>; 2],
    origin: Origin,
    /// The states of the model, where the file is one or extends one.
    states: Vec<String>,
    /// The parameters of the model that the file extends, with their units.
    inherited: Vec<(String, Unit)>,
    /// Whether the file has states or definitions of its own, which may need other parameters.
    own: bool,
}

impl Filling {
    fn of_paper() -> Self {
        Self {
            sphere: Gyrosphere::seed(),
            roll: [None; 3],
            flow: [None; 2],
            origin: Origin::default(),
            states: Vec::new(),
            inherited: Vec::new(),
            own: false,
        }
    }

    fn compass(self) -> Result<Compass> {
        self.sphere.check()?;
        let roll = match self.roll {
            [Some(a), Some(mu), Some(eps)] => Some(Roll::new(a, mu, eps)?),
            [None, None, None] => None,
            _ => {
                return Err(Error::bad_input(
                    "a roll is described by all of A, mu and eps, or by none of them",
                ));
            }
        };
        let part = self.part()?;
        Ok(Compass { sphere: self.sphere, part, speed: 0.0, roll, origin: self.origin })
    }

    /// The elastic part that the model's states and parameters describe.
    fn part(&self) -> Result<Box<dyn Elastic>> {
        let has = |name: &str| self.states.iter().any(|s| s == name);
        if !self.states.is_empty() && !has("x") {
            return Err(Error::bad_input(
                "this model has no elastic part (no state `x`): roll is not rectified in it",
            )
            .with_hint("start from gyrosphere, gyrosphere-inertia or gyrosphere-flow"));
        }
        match self.flow {
            [Some(_), _] | [_, Some(_)] if has("x_rate") => Err(Error::bad_input(
                "this model has an elastic part with inertia, and T2 or kappa ask for another",
            )
            .with_hint("take gyrosphere-flow for the liquid flow, or leave T2 and kappa away")),
            [Some(time), Some(share)] => Ok(Box::new(Relaxing { time, share })),
            [None, None] if has("x_rate") => Ok(Box::new(Inertia)),
            [None, None] => Ok(Box::new(Lag)),
            _ => Err(Error::bad_input("liquid flow is described by both T2 and kappa, or by none of them")),
        }
    }

    /// Takes a file's parameters from its text.
    fn read(&mut self, text: &str) -> Result<()> {
        let file = Numbers::of_model(text)?;
        if let Some(name) = &file.extends {
            self.builtin(name)?;
        }
        self.states.extend(file.states);
        self.own = file.own;
        if file.own || file.outputs {
            equations::known(&Model::parse(text)?)?;
        }
        file.list.iter().try_for_each(|number| self.take(number).map_err(|e| number.place(e)))
    }

    fn builtin(&mut self, name: &str) -> Result<()> {
        let model = Model::builtin(name)?;
        self.origin.builtin = Some(name.to_owned());
        self.states.extend(model.states.iter().map(|s| s.name.clone()));
        for p in &model.parameters {
            self.inherited.push((p.name.clone(), p.unit.clone()));
            if let Some(place) = self.sphere.named(&p.name) {
                *place = p.value;
            } else if let Some(k) = FLOW.iter().position(|n| *n == p.name) {
                self.flow[k] = Some(p.value);
            }
        }
        Ok(())
    }

    fn take(&mut self, number: &Number) -> Result<()> {
        let name = number.name.as_str();
        let inherited = self.inherited.iter().find(|i| i.0 == name).map(|i| i.1.text().to_owned());
        if !names().any(|n| n == name) {
            if self.own || inherited.is_some() {
                self.origin.unused.push(name.to_owned());
                return Ok(());
            }
            let near = crate::error::nearest(&name.replace('_', ""), names())
                .map(|n| format!("did you mean {n}? "))
                .unwrap_or_default();
            return Err(Error::bad_input(format!("a gyrosphere has no parameter `{name}`"))
                .with_hint(format!("{near}it has {}", names().collect::<Vec<_>>().join(", "))));
        }
        if number.value.is_none() && inherited.is_some() {
            return Ok(());
        }
        // in a model's entry without a unit stays that of the model it extends
        let unit = number.unit.clone().or(inherited.filter(|_| number.full));
        let value = number.value()?;
        let range = range::of_compass(name);
        let value = range.map_or(Ok(value), |r| r.read(value, unit.as_deref())).map_err(|e| e.about(name))?;
        if let Some(k) = Roll::NAMES.iter().position(|n| *n == name) {
            self.roll[k] = Some(value);
        } else if let Some(k) = FLOW.iter().position(|n| *n == name) {
            self.flow[k] = Some(value);
        } else if let Some(place) = self.sphere.named(name) {
            *place = value;
        }
        self.origin.given.push(name.to_owned());
        Ok(())
    }
}
