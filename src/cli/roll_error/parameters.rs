//! The compass's numbers from a file: `[parameters]` of a model file, or of a file that holds
//! nothing else; what it leaves out is the paper's gyrocompass.

use crate::gyro::Gyrosphere;
use crate::units::Unit;
use crate::{Error, Result};
use std::path::Path;

/// A compass with the account of where its numbers come from.
pub struct Compass {
    pub sphere: Gyrosphere,
    /// Names that the file gives.
    pub given: Vec<String>,
    /// Names of the file that mean nothing here.
    pub unused: Vec<String>,
}

impl Compass {
    /// Where the numbers come from, in words.
    pub fn described(&self) -> String {
        if self.given.is_empty() {
            return "numbers of the paper".into();
        }
        let mut text = format!("{} as given, the rest of the paper", self.given.join(", "));
        if !self.unused.is_empty() {
            text.push_str(&format!("; not used: {}", self.unused.join(", ")));
        }
        text
    }
}

#[derive(serde::Deserialize)]
struct File {
    #[serde(default)]
    parameters: std::collections::BTreeMap<String, Entry>,
}

#[derive(serde::Deserialize)]
struct Entry {
    value: f64,
    #[serde(default = "one")]
    unit: String,
}

fn one() -> String {
    "1".into()
}

/// Whether the file is TOML with a table of parameters (or names a built-in model).
pub fn has_parameters(path: &Path) -> bool {
    let Ok(text) = std::fs::read_to_string(path) else { return false };
    text.parse::<toml::Table>().is_ok_and(|t| t.contains_key("parameters") || t.contains_key("extends"))
}

/// Reads the compass; without a path it is the paper's.
pub fn read(path: Option<&std::path::PathBuf>) -> Result<Compass> {
    let mut compass = Compass { sphere: Gyrosphere::seed(), given: Vec::new(), unused: Vec::new() };
    let Some(path) = path else { return Ok(compass) };
    let text = std::fs::read_to_string(path).map_err(|e| Error::io(path, &e))?;
    let file: File = toml::from_str(&text).map_err(|e| Error::bad_input(e.to_string()).with_file(path))?;
    for (name, entry) in &file.parameters {
        let fail = |e: Error| e.with_file(path);
        match slot(&mut compass.sphere, name) {
            Some((place, dimension)) => {
                *place = in_si(name, entry, dimension).map_err(fail)?;
                compass.given.push(name.clone());
            }
            None => compass.unused.push(name.clone()),
        }
    }
    compass.sphere.check().map_err(|e| e.with_file(path))?;
    Ok(compass)
}

/// Where a name of the symbol table goes, and its unit in SI.
fn slot<'a>(s: &'a mut Gyrosphere, name: &str) -> Option<(&'a mut f64, &'static str)> {
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

fn in_si(name: &str, entry: &Entry, wanted: &str) -> Result<f64> {
    let unit = Unit::parse(&entry.unit)?;
    if unit.dimension() != Unit::parse(wanted)?.dimension() {
        return Err(Error::new(
            crate::ErrorKind::Units,
            format!("{name} is given in {}, but it is measured in {wanted}", entry.unit),
        ));
    }
    Ok(unit.to_si(entry.value))
}
