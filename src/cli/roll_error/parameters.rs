//! The compass's numbers from a file: `[parameters]` of a model file, or of a file that holds
//! nothing else; what it leaves out is the paper's gyrocompass, or the built-in it extends.

use super::equations;
use super::options::InstrumentOptions;
use crate::cli::input;
use crate::cli::quantity::{angle, quantity};
use crate::gyro::elastic::{Elastic, Inertia, Relaxing};
use crate::gyro::range::{self, Range};
use crate::gyro::{Gyrosphere, Instrument};
use crate::model::{Model, Number, Numbers};
use crate::spectrum::Roll;
use crate::units::Unit;
use crate::{Error, Result};
use std::path::Path;

/// The elastic part, as far as a model file or a closed form knows it.
#[derive(Clone, Copy)]
pub enum Part {
    /// (2.3).
    Lag,
    /// (2.2).
    Inertia,
    /// A second relaxation beside the lag.
    Flow(Relaxing),
    /// One that only the options know.
    Other,
}

/// A compass with the account of where its numbers come from.
#[derive(Clone)]
pub struct Compass {
    pub sphere: Gyrosphere,
    /// m/s.
    pub speed: f64,
    /// The roll that the file describes by A, mu and eps.
    pub roll: Option<Roll>,
    /// Where the numbers come from, in words.
    pub says: String,
    pub instrument_name: String,
    /// The part of the model file, where the options say none.
    part: Part,
}

impl Compass {
    /// The kind of part that the options ask for, else the model's.
    pub fn part(&self, options: &InstrumentOptions) -> Result<Part> {
        Ok(options.kind()?.unwrap_or(self.part))
    }

    /// The instrument with the part that the options ask for, else the model's.
    pub fn instrument(&self, options: &InstrumentOptions) -> Result<Instrument> {
        let mut instrument = Instrument::new(self.sphere, elastic(self.part, options)?);
        instrument.speed = self.speed;
        Ok(instrument)
    }
}

/// One part of the two: an option beside a model with a part of its own is refused, since neither can be
/// taken without dropping the other.
fn elastic(of_file: Part, options: &InstrumentOptions) -> Result<Box<dyn Elastic>> {
    let asked = options.kind()?;
    if let (Some(_), Part::Inertia | Part::Flow(_)) = (asked, of_file) {
        let (own, symbols) = match of_file {
            Part::Inertia => ("inertia", "the model's x_rate"),
            _ => ("a second relaxation by liquid flow", "T2 and kappa"),
        };
        return Err(Error::usage(format!(
            "this model has an elastic part of its own, {own}, and an option asks for another"
        ))
        .with_hint(format!(
            "take the plain `gyrosphere` (without {symbols}) with the option, or leave the option away"
        )));
    }
    match (asked, of_file) {
        (None, Part::Inertia) => Ok(Box::new(Inertia)),
        (None, Part::Flow(relaxing)) => Ok(Box::new(relaxing)),
        _ => options.part(),
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
    given: Vec<String>,
    unused: Vec<String>,
    /// The states of the model, where the file is one or extends one.
    states: Vec<String>,
    /// The parameters of the model that the file extends, with their units.
    inherited: Vec<(String, Unit)>,
    /// Whether the file has states or definitions of its own, which may need other parameters.
    own: bool,
}

/// Whether the path is a built-in model, or TOML with parameters or a model's base.
pub fn has_parameters(path: &Path) -> bool {
    if !path.exists() {
        return path.to_str().is_some_and(|name| Model::builtin(name).is_ok());
    }
    let Ok(text) = input::text(path) else { return false };
    text.parse::<toml::Table>().is_ok_and(|t| t.contains_key("parameters") || t.contains_key("extends"))
}

/// Reads the compass from a file; without a path it is the paper's.
pub fn read(path: Option<&Path>, options: &InstrumentOptions) -> Result<Compass> {
    let mut f = Filling::of_paper();
    let base = path.map(|p| f.read(p)).transpose()?.flatten();
    f.compass(base.as_deref(), options).map_err(|e| if let Some(p) = path { e.with_file(p) } else { e })
}

/// Reads the compass from the text of such a file.
pub fn of_text(text: &str, options: &InstrumentOptions) -> Result<Compass> {
    let mut f = Filling::of_paper();
    let base = f.read_text(text)?;
    f.compass(base.as_deref(), options)
}

impl Filling {
    fn of_paper() -> Self {
        Self {
            sphere: Gyrosphere::seed(),
            roll: [None; 3],
            flow: [None; 2],
            given: Vec::new(),
            unused: Vec::new(),
            states: Vec::new(),
            inherited: Vec::new(),
            own: false,
        }
    }

    /// The compass, with what the options say of it.
    fn compass(mut self, base: Option<&str>, options: &InstrumentOptions) -> Result<Compass> {
        let set = |option: &Option<String>, name: &str, range: &Range, place: &mut f64| -> Result<()> {
            if let Some(text) = option {
                *place = quantity(name, text, range)?;
            }
            Ok(())
        };
        if let Some(text) = &options.latitude {
            self.sphere.latitude = angle("latitude", text, &range::LATITUDE)?;
        }
        set(&options.lever, "lever", &range::LEVER, &mut self.sphere.lever)?;
        let mut speed = 0.0;
        set(&options.speed, "speed", &range::SPEED, &mut speed)?;
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
        let instrument_name = elastic(part, options)?.name().to_owned();
        let says = self.says(base.unwrap_or("the paper"));
        Ok(Compass { sphere: self.sphere, speed, roll, says, instrument_name, part })
    }

    /// The elastic part that the model's states and parameters describe.
    fn part(&self) -> Result<Part> {
        let has = |name: &str| self.states.iter().any(|s| s == name);
        if !self.states.is_empty() && !has("x") {
            return Err(Error::bad_input(
                "this model has no part that gives way (no state `x`): roll is not rectified in it",
            )
            .with_hint("start from gyrosphere, gyrosphere-inertia or gyrosphere-flow"));
        }
        match self.flow {
            [Some(_), _] | [_, Some(_)] if has("x_rate") => Err(Error::bad_input(
                "this model has an elastic part with inertia, and T2 or kappa ask for another",
            )
            .with_hint("take gyrosphere-flow for the liquid flow, or leave T2 and kappa away")),
            [Some(time), Some(share)] => Ok(Part::Flow(Relaxing { time, share })),
            [None, None] if has("x_rate") => Ok(Part::Inertia),
            [None, None] => Ok(Part::Lag),
            _ => Err(Error::bad_input("liquid flow is described by both T2 and kappa, or by none of them")),
        }
    }

    /// Takes a file's parameters, or a built-in model's; returns the base that stands behind.
    fn read(&mut self, path: &Path) -> Result<Option<String>> {
        if !path.exists() && path.to_str().is_some_and(|name| Model::builtin(name).is_ok()) {
            let name = path.display().to_string();
            self.builtin(&name)?;
            return Ok(Some(format!("the built-in model {name}")));
        }
        let text = input::text(path)?;
        self.read_text(&text).map_err(|e| e.with_file(path))
    }

    /// Takes a file's parameters from its text.
    fn read_text(&mut self, text: &str) -> Result<Option<String>> {
        let file = Numbers::of_model(text)?;
        if let Some(name) = &file.extends {
            self.builtin(name)?;
        }
        self.states.extend(file.states);
        self.own = file.own;
        if file.own || file.outputs {
            equations::known(&Model::parse(text)?)?;
        }
        file.list.iter().try_for_each(|number| self.take(number).map_err(|e| number.place(e)))?;
        Ok(file.extends.map(|name| format!("the built-in model {name}")))
    }

    fn builtin(&mut self, name: &str) -> Result<()> {
        let model = Model::builtin(name)?;
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
                self.unused.push(name.to_owned());
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
        self.given.push(name.to_owned());
        Ok(())
    }

    fn says(&self, base: &str) -> String {
        let mut text = if self.given.is_empty() {
            format!("numbers of {base}")
        } else {
            format!("{} as given, the rest of {base}", self.given.join(", "))
        };
        if !self.unused.is_empty() {
            text.push_str("; not used here: ");
            text.push_str(&self.unused.join(", "));
        }
        text
    }
}
