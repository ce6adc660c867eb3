//! The table of errors: mean ± spread against heading, latitude or sea state.

use super::Arguments;
use super::described::Described;
use super::measured::{self, Analysis};
use super::nonlinear::{Moments, moves_finitely, not_linear, within};
use super::options::{Against, RowOptions};
use super::parameters::Compass;
use super::tail;
use crate::cli::progress::Meter;
use crate::estimate::fit::Progress;
use crate::gyro::validity::{LARGEST_MEAN, Smallness, bounded, steepness};
use crate::gyro::{Drive, HeadingError, IDLE, Instrument, MonteCarlo, SIGN, Simulated, Tail, seed};
use crate::report::polar::{Point, Polar};
use crate::spectrum::Roll;
use crate::{Error, Result};
use rayon::prelude::*;
use std::fmt::Write;
use std::sync::atomic::{AtomicUsize, Ordering};

/// One row to compute: its instrument, motion and heading.
pub struct Case {
    pub instrument: Instrument,
    pub motion: Described,
    /// rad.
    pub heading: f64,
    /// The value of what the rows run over, in its unit of print.
    pub value: f64,
    /// Significant height of its sea, m, where the rows run over it.
    pub height: Option<f64>,
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
    /// How much a white tail of the motion counts, where it has one.
    pub tail: Option<Tail>,
    /// The irregular roll of the form (3.3), where the motion is one.
    pub roll: Option<Roll>,
    pub cases: Vec<Case>,
    pub against: Against,
    /// Whether the mean to trust is that by the measured spectrum.
    pub by_spectrum: bool,
    /// What the linear theory takes for small, where the mean is largest; filled by [`Plan::evaluate`].
    pub smallness: Vec<Smallness>,
}

/// One row computed.
pub struct Row {
    pub heading: f64,
    pub value: f64,
    pub error: HeadingError,
    pub measured: Option<f64>,
    pub simulated: Option<Simulated>,
}

impl Row {
    /// Whether its figures are exact, and not those of a simulation.
    pub fn is_exact(&self) -> bool {
        self.error.rectified_margin == 0.0 && self.error.linearised.is_none()
    }
}

impl Plan {
    /// The plan of the options alone.
    pub fn of_options(compass: Compass, a: &Arguments, rows: &RowOptions) -> Result<Self> {
        let roll = match compass.roll {
            Some(roll) => roll,
            None => seed::example_3_1().1,
        };
        let described = a.motion.motion(&roll, None)?;
        let of_all = described.of_all.as_ref().filter(|_| rows.against == Against::Height);
        let motion_says = of_all.unwrap_or(&described.says).clone();
        let cases = cases(&compass, &roll, a, rows)?;
        let instrument = compass.instrument(&a.instrument)?;
        let tail = moves_finitely(&instrument, &described)?;
        if rows.days()?.is_some() && tail.as_ref().is_some_and(Tail::is_beyond_simulation) {
            return Err(Error::usage("the mean comes from frequencies that no simulation follows")
                .with_hint(
                    "limit the motion: say --band with the frequency above which this ship does not move",
                ));
        }
        let after =
            tail.as_ref().map_or_else(|| not_linear(&instrument, &described), |t| Ok(tail::text(t)))?;
        let after = after + &asides(compass.speed, a)?;
        let roll = a.motion.irregular_roll(&roll)?;
        Ok(Self {
            compass,
            motion_says,
            recorded: None,
            after,
            tail,
            roll,
            cases,
            against: rows.against,
            by_spectrum: false,
            smallness: Vec::new(),
        })
    }

    /// The rows, whatever the theory reaches.
    fn computed(&self, days: Option<usize>, seed: u64) -> Result<Vec<Row>> {
        let (meter, done) = (Meter, AtomicUsize::new(0));
        let moments = Moments::of(&self.cases, &meter)?;
        let row = |case: &Case| {
            let row = case.evaluate(days, seed, &moments)?;
            let share = (1 + done.fetch_add(1, Ordering::Relaxed)) as f64 / self.cases.len() as f64;
            meter.says("rows of the table", Some(share));
            Ok(row)
        };
        self.cases.par_iter().map(row).collect()
    }

    /// Computes the rows, with so many days simulated beside each; rows of latitudes and heights that no linear
    /// theory reaches are left out.
    pub fn evaluate(&mut self, days: Option<usize>, seed: u64) -> Result<Vec<Row>> {
        let all = self.computed(days, seed);
        let judged: Vec<(&Case, Row, Result<()>)> = self
            .cases
            .iter()
            .zip(all?)
            .map(|(case, row)| {
                let reached = bounded(self.mean(&row));
                (case, row, reached)
            })
            .collect();
        let reached = judged.iter().filter(|j| j.2.is_ok());
        let worst = reached.max_by(|a, b| self.mean(&a.1).abs().total_cmp(&self.mean(&b.1).abs()));
        let beyond: Vec<f64> = judged.iter().filter(|j| j.2.is_err()).map(|j| j.1.value).collect();
        let Some((case, row, _)) = worst.filter(|_| beyond.is_empty() || self.against != Against::Heading)
        else {
            return judged.into_iter().map(|(_, row, reached)| reached.map(|()| row)).collect();
        };
        let (motion, instrument) = (&case.motion.motion, &case.instrument);
        let mut smallness = match case.motion.regular {
            Some(_) => instrument.regular_smallness(motion, case.heading, &row.error)?,
            None => instrument.smallness(motion, case.heading, &row.error)?,
        };
        smallness.extend(case.motion.sea.as_ref().map(steepness));
        let rows = judged.into_iter().filter(|j| j.2.is_ok()).map(|j| j.1).collect();
        self.after.push_str(unjudged(&smallness));
        self.smallness = smallness;
        if !beyond.is_empty() {
            let left: Vec<String> = beyond.iter().map(ToString::to_string).collect();
            self.after.push_str(&format!(
                "Left out, since the linear theory would give a mean error beyond {:.0}°: {}.\n",
                LARGEST_MEAN.to_degrees(),
                left.join(", ")
            ));
        }
        Ok(rows)
    }

    /// What of the linear theory does not hold, in words; empty where all of it does.
    pub fn beyond(&self) -> String {
        beyond(&self.smallness)
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
            warning: self.beyond(),
            points: rows.iter().map(point).collect(),
        })
    }
}

/// What of the linear theory does not hold, in words; empty where all of it does.
pub fn beyond(smallness: &[Smallness]) -> String {
    let broken = smallness.iter().filter(|s| s.is_judged() && !s.holds());
    let broken: Vec<String> = broken.map(Smallness::told).collect();
    if broken.is_empty() {
        return String::new();
    }
    format!(
        "BEYOND THE LINEAR THEORY where the mean is largest: {}. The figures are a guide at best.",
        broken.join(", ")
    )
}

/// What of the linear theory cannot be judged, in words.
pub fn unjudged(smallness: &[Smallness]) -> &'static str {
    if smallness.iter().all(Smallness::is_judged) {
        return "";
    }
    "The acceleration at the compass is infinite without a band, so it is not held against gravity: --band gives it an end.\n"
}

fn cases(compass: &Compass, roll: &Roll, a: &Arguments, rows: &RowOptions) -> Result<Vec<Case>> {
    let headings = rows.headings()?;
    if rows.against == Against::Latitude && a.instrument.latitude.is_some() {
        return Err(Error::usage("--against latitude runs over all latitudes; leave --latitude away"));
    }
    if rows.against == Against::Height && a.motion.has_height() {
        return Err(Error::usage("--against height runs over all heights; leave --height away"));
    }
    let lone = match headings[..] {
        [one] => one,
        _ if rows.has_headings() && rows.against != Against::Heading => {
            return Err(Error::usage("--against latitude and --against height take one --heading"));
        }
        _ => 45f64.to_radians(),
    };
    let case = |instrument, heading, height, value| -> Result<Case> {
        let motion = a.motion.motion(roll, height)?;
        Ok(Case { instrument, motion, heading, value, height, measured: None })
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
    fn evaluate(&self, days: Option<usize>, seed: u64, moments: &Moments) -> Result<Row> {
        let motion = &self.motion.motion;
        let drive =
            self.motion.regular.as_ref().map_or_else(|| Ok(Drive::irregular(motion)), Drive::regular)?;
        let error = match (&self.motion.regular, moments.get(self)) {
            (Some(roll), _) => self.instrument.regular_error(roll, self.heading)?,
            (None, Some(moment)) => self.instrument.error_by(moment, motion, self.heading)?,
            (None, None) => self.instrument.error(motion, self.heading)?,
        };
        let simulate = |days: usize| -> Result<Simulated> {
            let (step, settle) = (drive.step()?, 6.0 * 3600.0);
            let plan = MonteCarlo { step, duration: 86400.0, settle, runs: days, seed };
            plan.run(&self.instrument, &drive, self.heading)
        };
        let simulated = days.map(simulate).transpose()?;
        let Self { heading, value, measured, .. } = *self;
        Ok(Row { heading, value, error, measured, simulated })
    }
}

/// What else is to be said of what was asked for.
pub fn asides(speed: f64, a: &Arguments) -> Result<String> {
    let mut out = String::new();
    if a.motion.has_idle() || a.instrument.has_idle() {
        let what = if a.instrument.has_idle() { "compliance along the vertical" } else { "heave" };
        out.push_str(&format!("{what} changes no mean: {IDLE}.\n"));
    }
    if speed != 0.0 && a.motion.along()? {
        out.push_str(
            "The waves are met at their own frequency: the ship's speed through them is not counted.\n",
        );
    }
    Ok(out)
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
         compass: {}\nmotion: {}\nsign: {SIGN}\n",
        plan.compass.instrument_name, s.lever, plan.compass.says, plan.motion_says
    );
    let beyond = plan.beyond();
    if !beyond.is_empty() {
        let _ = writeln!(out, "{beyond}\n");
    }
    out.push_str(&heads(plan, rows));
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
        if !row.is_exact() {
            out.push_str(&within(e));
        }
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

fn heads(plan: &Plan, rows: &[&Row]) -> String {
    let any = |has: fn(&Row) -> bool| rows.iter().any(|r| has(r));
    let first = match plan.against {
        Against::Heading => "heading °",
        Against::Latitude => "latitude °",
        Against::Height => "height m",
    };
    let mut out = format!("{first:>10}        mean  ±  spread    by swing   by products");
    if any(|r| !r.is_exact()) {
        out.push_str("   mean within");
    }
    if any(|r| r.error.linearised.is_some()) {
        out.push_str("   linearised");
    }
    if any(|r| r.measured.is_some()) {
        out.push_str("   mean, measured spectrum");
    }
    if any(|r| r.simulated.is_some()) {
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
