//! The compass's numbers from a file: `[parameters]` of a model file, or of a file that holds
//! nothing else; what it leaves out is the paper's gyrocompass, or the built-in it extends.

use super::options::InstrumentOptions;
use super::quantity;
use crate::gyro::{Gyrosphere, Instrument, elastic};
use crate::model::Model;
use crate::spectrum::Roll;
use crate::units::Unit;
use crate::{Error, Result};
use std::path::Path;

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
}

impl Compass {
    /// The instrument with the part that the options ask for.
    pub fn instrument(&self, options: &InstrumentOptions) -> Result<Instrument> {
        let mut instrument = Instrument::new(self.sphere, options.part()?);
        instrument.speed = self.speed;
        Ok(instrument)
    }

    /// The same with the paper's lag.
    pub fn plain_instrument(&self) -> Instrument {
        Instrument::new(self.sphere, Box::new(elastic::Lag))
    }
}

#[derive(serde::Deserialize)]
struct File {
    extends: Option<String>,
    #[serde(default)]
    parameters: std::collections::BTreeMap<String, Entry>,
}

#[derive(serde::Deserialize)]
#[serde(untagged)]
enum Entry {
    Full { value: f64, unit: Option<String> },
    Bare(f64),
}

/// What a file's parameters have filled so far.
struct Filling {
    sphere: Gyrosphere,
    roll: [Option<f64>; 3],
    given: Vec<String>,
    unused: Vec<String>,
}

/// Whether the path is a built-in model, or TOML with parameters or a model's base.
pub fn has_parameters(path: &Path) -> bool {
    if !path.exists() {
        return path.to_str().is_some_and(|name| Model::builtin(name).is_ok());
    }
    let Ok(text) = std::fs::read_to_string(path) else { return false };
    text.parse::<toml::Table>().is_ok_and(|t| t.contains_key("parameters") || t.contains_key("extends"))
}

/// Reads the compass; without a path it is the paper's.
pub fn read(path: Option<&Path>, options: &InstrumentOptions) -> Result<Compass> {
    let mut f =
        Filling { sphere: Gyrosphere::seed(), roll: [None; 3], given: Vec::new(), unused: Vec::new() };
    let mut base = "the paper".to_owned();
    if let Some(path) = path {
        base = f.read(path)?.unwrap_or(base);
    }
    let set = |option: &Option<String>, name: &str, si: &str, place: &mut f64| -> Result<()> {
        if let Some(text) = option {
            *place = quantity(name, text, si)?;
        }
        Ok(())
    };
    set(&options.latitude, "latitude", "rad", &mut f.sphere.latitude)?;
    set(&options.lever, "lever", "m", &mut f.sphere.lever)?;
    let mut speed = 0.0;
    set(&options.speed, "speed", "m/s", &mut speed)?;
    f.sphere.check().map_err(|e| if let Some(p) = path { e.with_file(p) } else { e })?;
    let roll = match f.roll {
        [Some(a), Some(mu), Some(eps)] => Some(Roll::new(a, mu, eps)?),
        [None, None, None] => None,
        _ => return Err(Error::bad_input("a roll is described by all of A, mu and eps, or by none of them")),
    };
    let name = options.part()?.name().to_owned();
    Ok(Compass { sphere: f.sphere, speed, roll, says: f.says(&base), instrument_name: name })
}

impl Filling {
    /// Takes a file's parameters, or a built-in model's; returns the base that stands behind.
    fn read(&mut self, path: &Path) -> Result<Option<String>> {
        if !path.exists() && path.to_str().is_some_and(|name| Model::builtin(name).is_ok()) {
            let name = path.display().to_string();
            self.builtin(&name)?;
            return Ok(Some(format!("the built-in model {name}")));
        }
        let text = std::fs::read_to_string(path).map_err(|e| Error::io(path, &e))?;
        let file: File =
            toml::from_str(&text).map_err(|e| Error::bad_input(e.to_string().trim_end()).with_file(path))?;
        if let Some(name) = &file.extends {
            self.builtin(name).map_err(|e| e.with_file(path))?;
        }
        for (name, entry) in &file.parameters {
            self.take(name, entry).map_err(|e| e.with_file(path))?;
        }
        Ok(file.extends.map(|name| format!("the built-in model {name}")))
    }

    fn builtin(&mut self, name: &str) -> Result<()> {
        for p in &Model::builtin(name)?.parameters {
            if let Some((place, _)) = self.slot(&p.name) {
                *place = p.value;
            }
        }
        Ok(())
    }

    fn take(&mut self, name: &str, entry: &Entry) -> Result<()> {
        let (value, unit) = match entry {
            Entry::Full { value, unit } => (*value, unit.as_deref()),
            Entry::Bare(value) => (*value, None),
        };
        let roll = ["A", "mu", "eps"].iter().position(|n| *n == name);
        if let Some(place) = roll {
            self.roll[place] = Some(in_si(name, value, unit, ["rad^2", "1/s", "rad/s"][place])?);
        } else if let Some((place, si)) = self.slot(name) {
            *place = in_si(name, value, unit, si)?;
        } else {
            self.unused.push(name.to_owned());
            return Ok(());
        }
        self.given.push(name.to_owned());
        Ok(())
    }

    /// Where a name of the symbol table goes, and its unit in SI.
    fn slot(&mut self, name: &str) -> Option<(&mut f64, &'static str)> {
        let s = &mut self.sphere;
        Some(match name {
            "P" => (&mut s.weight, "N"),
            "H" => (&mut s.momentum, "N*m*s"),
            "lP" => (&mut s.pendulous, "N*m"),
            "C" => (&mut s.damper, "N*m"),
            "F" => (&mut s.flow, "1/s"),
            "C0" => (&mut s.stiffness, "N/m"),
            "T" => (&mut s.lag, "s"),
            "h" => (&mut s.lever, "m"),
            "lat" => (&mut s.latitude, "rad"),
            "g" => (&mut s.gravity, "m/s^2"),
            "U" => (&mut s.earth_rate, "rad/s"),
            _ => return None,
        })
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

fn in_si(name: &str, value: f64, unit: Option<&str>, wanted: &str) -> Result<f64> {
    let Some(unit) = unit else { return Ok(value) };
    let parsed = Unit::parse(unit)?;
    if parsed.dimension() != Unit::parse(wanted)?.dimension() {
        return Err(Error::new(
            crate::ErrorKind::Units,
            format!("{name} is given in {unit}, but it is measured in {wanted}"),
        ));
    }
    Ok(parsed.to_si(value))
}
