//! The page of the units that are read.

use super::{Unit, figure, names};
use std::fmt::Write;

const HEAD: &str = "\
# Units
Names of this list, joined by * and /, with whole or half powers and parentheses: rad/s^2, g*cm^2/s, V/Hz^0.5,
N*m*s/rad; 1 for none. Inside everything is SI and radians.

  name     in SI                  with prefixes
";

const FOOT: &str = "
# As people write them
°C ℃ (degC), ° (deg), Ω Ohm (ohm), µ (u), knots (kn), L (l); raised digits (m/s², s⁻¹); · ⋅ × for *.

# Turns or radians
For an angular speed rad/s, deg/s and rpm are plain. 1/min, Hz and rev/s are refused there with the question whether
turns or radians are meant, and so are gains and dampings that count an angle by their place in the equations; write
rad or rev in the unit. 1/s is taken as rad/s, and said. In a check of dimensions rad counts as 1.

# Temperatures
degC has its offset, 0 degC = 273.15 K. A difference of temperatures is one in K: give it that unit, since in degC
273.15 is taken off it.
";

/// Every unit of the closed list with its value in SI and its prefixes, and how units are written.
///
/// ```
/// assert!(gyrospec::units::list().contains("\n  kn       0.5144 m/s"));
/// ```
pub fn list() -> String {
    let mut out = HEAD.to_owned();
    for (name, prefixed) in names::families() {
        let Ok(unit) = Unit::parse(name) else { continue };
        let (value, si) = (figure(unit.difference_to_si(1.0)), unit.dimension().to_string());
        let si = match (name, si.as_str()) {
            ("1", _) => "1".to_owned(),
            ("rad" | "deg" | "arcmin" | "arcsec" | "rev", _) => format!("{value} rad"),
            ("rpm", _) => format!("{value} rad/s"),
            (_, "1") => value,
            (_, si) => format!("{value} {si}"),
        };
        let _ = writeln!(out, "{}", format!("  {name:<8} {si:<22} {}", prefixed.join(" ")).trim_end());
    }
    out + FOOT
}
