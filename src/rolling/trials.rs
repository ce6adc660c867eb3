//! T and C₀ of a compass from a table of measured errors on regular roll.

use super::Compass;
use crate::gyro::elastic::{Elastic, Lag};
use crate::gyro::range::{self, Range};
use crate::gyro::seed::{Regular, regular_error};
use crate::gyro::{Gyrosphere, Identified, Trial, identify};
use crate::record::{Channel, Kind, Recording};
use crate::units::{Dimension, Unit};
use crate::{Error, Result};
use std::f64::consts::TAU;

/// One trial with what the fit makes of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrialRow {
    /// Its row in the table, from 1.
    pub number: usize,
    /// The trial.
    pub trial: Trial,
    /// The error by (2.4) with T and C₀ as found, rad.
    pub fitted: f64,
}

/// What a table of trials says.
#[derive(Debug, Clone)]
pub struct Identification {
    /// T and C₀.
    pub found: Identified,
    /// The trials that were used.
    pub rows: Vec<TrialRow>,
    /// Rows with gaps, which were not.
    pub left_out: usize,
    /// Columns that say nothing here.
    pub unused: Vec<String>,
}

/// Columns that may be there.
const NAMES: [&str; 6] = ["heading", "amplitude", "period", "frequency", "latitude", "error"];

/// T and C₀ from a table of trials: `heading`, `amplitude` (of the compass's own path, θ₀h, or of the roll, which the
/// compass's lever multiplies), `period` or `frequency`, `error`, and `latitude` where it is not the compass's.
///
/// ```
/// use gyrospec::{Recording, Unit, record::{Channel, Kind}, rolling::{Compass, identification}};
/// let compass = Compass::paper();
/// let rows: Vec<f64> = (0..40).map(f64::from).collect();
/// let made = |name: &str, unit: &str, f: &dyn Fn(f64) -> f64| {
///     Channel::new(name, Unit::parse(unit).unwrap(), rows.clone(), rows.iter().map(|k| f(*k)).collect())
/// };
/// // (2.4) by hand for C0 = 1e5 N/m and T = 0.5 s at 60°
/// let s = gyrospec::Gyrosphere { latitude: 60f64.to_radians(), ..compass.sphere };
/// let by = (s.weight / s.gravity).powi(2) * 0.25f64.powi(2) / (4.0 * s.momentum * s.earth_rate * s.latitude.cos() * 1e5);
/// let error = |k: f64| { let p = 0.5 + 0.03 * k; -by * p.powi(4) * (0.3 * k).sin() / (1.0 + 0.25 * p * p) };
/// let columns = vec![
///     made("heading", "rad", &|k| 0.15 * k), made("amplitude", "m", &|_| 0.25),
///     made("frequency", "rad/s", &|k| 0.5 + 0.03 * k), made("latitude", "rad", &|_| 60f64.to_radians()),
///     made("error", "rad", &error),
/// ];
/// let mut table = Recording::from_channels("made", columns)?;
/// table.kind = Kind::Trials;
/// let told = identification(&table, &compass)?;
/// assert!((told.found.stiffness.value / 1e5 - 1.0).abs() < 1e-6 && (told.found.lag.value - 0.5).abs() < 1e-6);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `BadInput` or `Units` with the column and the row of what is wrong; `Usage` for a compass whose part is not the
/// lag; as [`identify`].
pub fn identification(table: &Recording, compass: &Compass) -> Result<Identification> {
    if table.kind != Kind::Trials {
        return Err(Error::bad_input("a recording on a clock is no table of trials")
            .with_hint("write kind = \"trials\" into it, one row a steady trial"));
    }
    if compass.part.name() != Lag.name() {
        let text =
            format!("T and C0 are those of the {}, and this compass has {}", Lag.name(), compass.part.name());
        return Err(Error::usage(text)
            .with_hint("name a compass whose centre of mass lags by (2.3) of Potemkin 1978 alone"));
    }
    compass.sphere.check()?;
    let columns = Columns::of(table)?;
    let (mut numbers, mut trials) = (Vec::new(), Vec::new());
    for row in 0..columns.error.len() {
        if columns.is_whole(row) {
            numbers.push(row + 1);
            trials.push(columns.trial(row, &compass.sphere)?);
        }
    }
    let found = identify(&trials, &compass.sphere)?;
    let row =
        |(number, trial): (usize, Trial)| TrialRow { number, trial, fitted: fitted(&trial, &found, compass) };
    let left_out = columns.error.len() - trials.len();
    let rows = numbers.into_iter().zip(trials).map(row).collect();
    let names = table.channels.iter().map(|c| &c.name);
    let is_used = |n: &&String| NAMES.iter().any(|known| named(table, known).is_some_and(|c| c.name == **n));
    let unused = names.filter(|n| !is_used(n)).cloned().collect();
    Ok(Identification { found, rows, left_out, unused })
}

/// (2.4) with what was found.
fn fitted(t: &Trial, found: &Identified, compass: &Compass) -> f64 {
    let sphere = Gyrosphere {
        stiffness: found.stiffness.value,
        lag: found.lag.value,
        lever: t.amplitude,
        latitude: t.latitude,
        ..compass.sphere
    };
    regular_error(&sphere, &Regular { amplitude: 1.0, frequency: t.frequency }, t.heading)
}

/// The column of a name, in whatever letters.
fn named<'a>(table: &'a Recording, name: &str) -> Option<&'a Channel> {
    // of two that differ in case neither is meant more than the other
    let mut alike = table.channels.iter().filter(|c| c.name.eq_ignore_ascii_case(name));
    let only = alike.next().filter(|_| alike.next().is_none());
    table.find(name).or(only)
}

/// The columns of a table.
struct Columns<'a> {
    heading: &'a Channel,
    amplitude: &'a Channel,
    /// A period or a frequency.
    swing: &'a Channel,
    latitude: Option<&'a Channel>,
    error: &'a Channel,
}

impl<'a> Columns<'a> {
    fn of(table: &'a Recording) -> Result<Self> {
        let find = |name: &str| named(table, name);
        let needed = |name: &str| {
            find(name).ok_or_else(|| {
                let there: Vec<&str> = table.channels.iter().map(|c| c.name.as_str()).collect();
                Error::bad_input(format!("the table has no column `{name}`")).with_hint(format!(
                    "it needs heading, amplitude, period (or frequency) and error, and has {}",
                    there.join(", ")
                ))
            })
        };
        let swing = match (find("period"), find("frequency")) {
            (Some(_), Some(_)) => {
                return Err(Error::bad_input("period and frequency say the same: give one of them"));
            }
            (None, Some(frequency)) => frequency,
            _ => needed("period")?,
        };
        let latitude = find("latitude");
        Ok(Self {
            heading: needed("heading")?,
            amplitude: needed("amplitude")?,
            swing,
            latitude,
            error: needed("error")?,
        })
    }

    fn all(&self) -> impl Iterator<Item = &'a Channel> {
        [self.heading, self.amplitude, self.swing, self.error].into_iter().chain(self.latitude)
    }

    fn is_whole(&self, row: usize) -> bool {
        self.all().all(|c| c.values[row].is_finite())
    }

    fn trial(&self, row: usize, sphere: &Gyrosphere) -> Result<Trial> {
        let read = |c: &Channel, range: &Range| {
            range.read(c.unit.from_si(c.values[row]), Some(c.unit.text())).map_err(|e| at(&e, c, row))
        };
        let is =
            |c: &Channel, unit: &str| Ok::<_, Error>(c.unit.dimension() == Unit::parse(unit)?.dimension());
        let amplitude = if is(self.amplitude, "m")? {
            read(self.amplitude, &range::ROLL_PATH)?
        } else {
            read(self.amplitude, &range::ROLL_AMPLITUDE)? * sphere.lever.abs()
        };
        let frequency = if self.swing.unit.dimension() == Dimension::TIME {
            let swing = range::ROLL_FREQUENCY.check(TAU / self.swing.values[row]);
            swing.map_err(|e| at(&e, self.swing, row))?
        } else if ["Hz", "rev/s"].contains(&self.swing.unit.text()) {
            // swings to and fro a second
            let swing = range::ROLL_FREQUENCY.check(TAU * self.swing.unit.from_si(self.swing.values[row]));
            swing.map_err(|e| at(&e, self.swing, row))?
        } else {
            read(self.swing, &range::ROLL_FREQUENCY)?
        };
        Ok(Trial {
            heading: read(self.heading, &range::HEADING)?,
            amplitude,
            frequency,
            latitude: self.latitude.map_or(Ok(sphere.latitude), |c| read(c, &range::LATITUDE))?,
            error: read(self.error, &range::HEADING_ERROR)?,
        })
    }
}

/// An error with its place in the table.
fn at(e: &Error, column: &Channel, row: usize) -> Error {
    let placed = Error::new(
        e.kind(),
        format!("column `{}`, row {} of the numbers: {}", column.name, row + 1, e.message()),
    );
    match e.hint() {
        Some(hint) => placed.with_hint(hint),
        None => placed,
    }
}
