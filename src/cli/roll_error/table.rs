//! The table of errors: mean ± spread against heading, latitude or sea state.

use super::Arguments;
use super::measured::{self, Analysis};
use super::options::{Against, Described, RowOptions};
use super::parameters::Compass;
use crate::gyro::{HeadingError, Instrument, MonteCarlo, Simulated, seed};
use crate::report::polar::{Point, Polar};
use crate::spectrum::Roll;
use crate::{Error, Result};
use rayon::prelude::*;
use std::fmt::Write;

/// One row to compute: its instrument, motion and heading.
pub struct Case {
    pub instrument: Instrument,
    pub motion: Described,
    /// rad.
    pub heading: f64,
    /// The value of what the rows run over, in its unit of print.
    pub value: f64,
    /// The mean by quadrature over a measured spectrum, rad.
    pub measured: Option<f64>,
}

/// What is computed, with the words around it.
pub struct Plan {
    pub compass: Compass,
    pub motion_says: String,
    /// The recorded roll, where the motion is one.
    pub recorded: Option<Analysis>,
    pub after: String,
    /// The irregular roll of the form (3.3), where the motion is one.
    pub roll: Option<Roll>,
    pub cases: Vec<Case>,
    pub against: Against,
    /// Whether the mean to trust is that by the measured spectrum.
    pub by_spectrum: bool,
}

/// One row computed.
pub struct Row {
    pub heading: f64,
    pub value: f64,
    pub error: HeadingError,
    pub measured: Option<f64>,
    pub simulated: Option<Simulated>,
}

impl Plan {
    /// The plan of the options alone.
    pub fn of_options(compass: Compass, a: &Arguments, rows: &RowOptions) -> Result<Self> {
        let roll = match compass.roll {
            Some(roll) => roll,
            None => seed::example_3_1().1,
        };
        let described = a.motion.motion(&roll, None)?;
        let motion_says = described.says.clone();
        let cases = cases(&compass, &roll, a, rows)?;
        let after = tail(&compass.instrument(&a.instrument)?, &described)?;
        let roll = a.motion.irregular_roll(&roll)?;
        Ok(Self {
            compass,
            motion_says,
            recorded: None,
            after,
            roll,
            cases,
            against: rows.against,
            by_spectrum: false,
        })
    }

    /// Computes the rows, with so many days simulated beside each.
    pub fn evaluate(&self, days: Option<usize>, seed: u64) -> Result<Vec<Row>> {
        self.cases.par_iter().map(|case| case.evaluate(days, seed)).collect()
    }

    /// Whether the rows go around the card.
    pub fn goes_round(&self) -> bool {
        self.against == Against::Heading && self.cases.len() > 8
    }

    /// The mean of a row to trust, rad.
    pub fn mean(&self, row: &Row) -> f64 {
        row.measured.filter(|_| self.by_spectrum).unwrap_or_else(|| row.error.mean())
    }

    /// The polar picture of the rows, where they run over headings.
    pub fn polar(&self, rows: &[Row]) -> Result<Polar> {
        if self.against != Against::Heading {
            return Err(Error::usage("the polar picture runs over headings; leave --against away"));
        }
        let point = |r: &Row| Point {
            heading: r.heading,
            mean: self.mean(r).to_degrees(),
            spread: r.error.spread.to_degrees(),
        };
        let title = format!("Heading error, {}", self.compass.instrument_name);
        let by = if self.by_spectrum { "; the mean is that by the measured spectrum" } else { "" };
        Ok(Polar {
            title,
            subtitle: format!("{}{by}", self.motion_says),
            points: rows.iter().map(point).collect(),
        })
    }
}

fn cases(compass: &Compass, roll: &Roll, a: &Arguments, rows: &RowOptions) -> Result<Vec<Case>> {
    let headings = rows.headings()?;
    let lone = match headings[..] {
        [one] => one,
        _ if rows.has_headings() && rows.against != Against::Heading => {
            return Err(Error::usage("--against latitude and --against height take one --heading"));
        }
        _ => 45f64.to_radians(),
    };
    let case = |instrument, heading, height, value| -> Result<Case> {
        Ok(Case { instrument, motion: a.motion.motion(roll, height)?, heading, value, measured: None })
    };
    match rows.against {
        Against::Heading => headings
            .iter()
            .map(|k| case(compass.instrument(&a.instrument)?, *k, None, k.to_degrees()))
            .collect(),
        Against::Latitude => (0..=16)
            .map(|k| {
                let degrees = 5.0 * f64::from(k);
                let mut instrument = compass.instrument(&a.instrument)?;
                instrument.sphere.latitude = degrees.to_radians();
                case(instrument, lone, None, degrees)
            })
            .collect(),
        Against::Height if !a.motion.is_sea() => {
            Err(Error::usage("--against height needs a sea")
                .with_hint("say --sea pm, bretschneider or jonswap"))
        }
        Against::Height => (1..=16)
            .map(|k| {
                let height = 0.5 * f64::from(k);
                case(compass.instrument(&a.instrument)?, lone, Some(height), height)
            })
            .collect(),
    }
}

impl Case {
    fn evaluate(&self, days: Option<usize>, seed: u64) -> Result<Row> {
        let mut error = self.instrument.error(&self.motion.motion, self.heading)?;
        if self.motion.regular {
            // a steady sine has a steady product: only its own swing spreads
            (error.spread, error.spread_quadratic) = (error.spread_linear, 0.0);
        }
        let simulated = match days {
            None => None,
            Some(days) => {
                let plan =
                    MonteCarlo { step: 0.1, duration: 86400.0, settle: 6.0 * 3600.0, runs: days, seed };
                let system = self.instrument.system(&self.motion.motion, self.heading)?;
                Some(plan.run(&system, 0, error.mean())?)
            }
        };
        let Self { heading, value, measured, .. } = *self;
        Ok(Row { heading, value, error, measured, simulated })
    }
}

/// What of the error depends on a white tail of the acceleration.
fn tail(instrument: &Instrument, described: &Described) -> Result<String> {
    if !described.motion.has_white_acceleration() || described.regular {
        return Ok(String::new());
    }
    let heading = 45f64.to_radians();
    let corner = 2.5;
    let whole = instrument.rectified_error(&described.motion, heading)?.to_degrees();
    let banded =
        instrument.rectified_error(&described.motion.band_limited(corner, 2)?, heading)?.to_degrees();
    Ok(format!(
        "This motion's acceleration has a white tail (infinite variance), which no ship has. On heading 45°\n\
         the mean is {whole:.3}° with it and {banded:.3}° behind two low-passes at {corner} rad/s: {:.0} % of it depend on the tail (see --band).\n",
        100.0 * (1.0 - banded / whole).abs()
    ))
}

/// A number without a sign on its zero.
pub fn plain(degrees: f64) -> f64 {
    if degrees.abs() < 5e-6 { 0.0 } else { degrees }
}

pub fn text(plan: &Plan, rows: &[&Row]) -> String {
    let mut out = plan.recorded.as_ref().map_or_else(String::new, measured::told);
    let s = &plan.compass.sphere;
    let place = match plan.against {
        Against::Latitude => format!("heading {:.0}°", plan.cases[0].heading.to_degrees()),
        Against::Heading => format!("latitude {:.1}°", s.latitude.to_degrees()),
        Against::Height => {
            format!(
                "heading {:.0}°, latitude {:.1}°",
                plan.cases[0].heading.to_degrees(),
                s.latitude.to_degrees()
            )
        }
    };
    let _ = writeln!(
        out,
        "Heading error of a gyrosphere: {}; h = {} m, {place}\n\
         compass: {}\nmotion: {}\n",
        plan.compass.instrument_name, s.lever, plan.compass.says, plan.motion_says
    );
    let simulated = rows.iter().any(|r| r.simulated.is_some());
    out.push_str(&heads(plan, rows.iter().any(|r| r.measured.is_some()), simulated));
    for row in rows {
        let e = &row.error;
        let _ = write!(
            out,
            "{:>9}   {:>10.5}° ±{:>9.5}°  {:>9.5}°  {:>9.5}°",
            format!("{:.1}", row.value),
            plain(e.mean().to_degrees()),
            e.spread.to_degrees(),
            e.spread_linear.to_degrees(),
            e.spread_quadratic.to_degrees()
        );
        if let Some(measured) = row.measured {
            let _ = write!(out, "   {:>10.5}°", plain(measured.to_degrees()));
        }
        if let Some(m) = &row.simulated {
            let _ = write!(out, "   {}", beside(m));
        }
        out.push('\n');
    }
    out.push('\n');
    if plan.compass.speed != 0.0 {
        out.push_str("The mean holds the error of course and speed, v_N/(R U cos φ + v_E).\n");
    }
    out.push_str(&plan.after);
    out
}

fn heads(plan: &Plan, measured: bool, simulated: bool) -> String {
    let first = match plan.against {
        Against::Heading => "heading °",
        Against::Latitude => "latitude °",
        Against::Height => "height m",
    };
    let mut out = format!("{first:>10}        mean  ±  spread    by swing   by products");
    if measured {
        out.push_str("   mean, measured spectrum");
    }
    if simulated {
        out.push_str("   simulated: mean (99 %), spread (99 %)");
    }
    out + "\n"
}

fn beside(m: &Simulated) -> String {
    let spread = m.variance.max(0.0).sqrt();
    let margin = if spread > 0.0 { 0.5 * m.variance_margin / spread } else { 0.0 };
    format!(
        "{:.5}° (±{:.5}), {:.5}° (±{:.5})",
        m.mean.to_degrees(),
        m.mean_margin.to_degrees(),
        spread.to_degrees(),
        margin.to_degrees()
    )
}
