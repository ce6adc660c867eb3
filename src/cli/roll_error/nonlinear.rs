//! Parts that are not linear: what they need of the motion, and what is said of their figures.

use super::described::Described;
use super::table::{Case, plain};
use crate::cli::progress::Meter;
use crate::estimate::fit::Progress;
use crate::gyro::{BUDGET, Effort, FEWEST, HeadingError, Instrument, Moment, Tail, folded};
use crate::units::{figure, significant};
use crate::{Error, Result};
use std::collections::BTreeMap;

/// What parts that are not linear make of the motions, each computed once for all rows that share it: by
/// the folded heading and the height of the sea.
pub struct Moments(BTreeMap<[u64; 2], Moment>);

impl Moments {
    pub fn of(cases: &[Case], meter: &Meter) -> Result<Self> {
        let mut distinct: BTreeMap<[u64; 2], &Case> = BTreeMap::new();
        for case in cases.iter().filter(|c| c.motion.regular.is_none()) {
            if !case.instrument.is_linear()? {
                distinct.entry(Self::key(case)).or_insert(case);
            }
        }
        distinct.values().try_for_each(|case| affordable(case))?;
        let count = distinct.len() as f64;
        let moment = |(i, (key, case)): (usize, (&[u64; 2], &&Case))| {
            let told =
                |share: f64| meter.says("following the part in time", Some((i as f64 + share) / count));
            told(0.0);
            Ok((*key, case.instrument.moment_with(&case.motion.motion, case.heading, &told)?))
        };
        distinct.iter().enumerate().map(moment).collect::<Result<_>>().map(Self)
    }

    pub fn get(&self, case: &Case) -> Option<&Moment> {
        self.0.get(&Self::key(case))
    }

    fn key(case: &Case) -> [u64; 2] {
        let (heading, _) = folded(&case.motion.motion, case.heading);
        [(heading * 1e12).round() as u64, case.height.unwrap_or(0.0).to_bits()]
    }
}

/// Refuses a motion on which the part cannot be followed in a reasonable time, with what would help.
fn affordable(case: &Case) -> Result<()> {
    let (instrument, motion) = (&case.instrument, &case.motion);
    let effort = instrument.effort(&motion.motion)?;
    let Err(e) = effort.check(instrument.elastic.name()) else { return Ok(()) };
    for band in BANDS {
        let narrower = instrument.effort(&motion.clone().banded(band)?.motion)?;
        if narrower.step > 1.1 * effort.step && narrower.replicates() >= 2 * FEWEST {
            let steps = 2.0 * FEWEST as f64 * narrower.steps();
            return Err(e.with_hint(format!(
                "--band sets the length of a step, {} s here; with --band {band}rad/s it takes {} steps or more, some seconds",
                significant(effort.step, 3),
                figure(steps)
            )));
        }
    }
    Err(e.with_hint(lengthy(&effort)))
}

/// Bands that a ship may have, rad/s.
const BANDS: [f64; 9] = [1000.0, 500.0, 200.0, 100.0, 50.0, 20.0, 10.0, 5.0, 2.5];

/// What to change where no band helps.
fn lengthy(effort: &Effort) -> String {
    let over = FEWEST as f64 * effort.steps() / BUDGET;
    if effort.memory > (10.0 * effort.lag).max(10.0) {
        return format!(
            "the roll's memory of {} s, 1/mu, makes it long: with {} times the decay it takes some seconds; \
             a roll as regular as this is --regular",
            significant(effort.memory, 3),
            figure(over.ceil())
        );
    }
    if effort.parts > 1 {
        return format!(
            "the part rings, so that each step is solved in {} parts: a longer T damps it; without friction or play it is --inertia",
            effort.parts
        );
    }
    format!(
        "the lag T of {} s makes it long: with a {}th of it it takes some seconds",
        figure(effort.lag),
        figure(over.ceil())
    )
}

/// The tail of the motion; a part that is not linear needs one without.
pub fn moves_finitely(instrument: &Instrument, described: &Described) -> Result<Option<Tail>> {
    let white = described.regular.is_none() && described.motion.has_white_acceleration();
    if white && !instrument.is_linear()? {
        let what = instrument.elastic.name();
        return Err(Error::usage(format!(
            "with {what} the answer depends on the white tail of this motion's acceleration, which no ship has"
        ))
        .with_hint("say --band with the frequency above which this ship does not move, such as --band 2.5rad/s"));
    }
    if described.regular.is_some() { Ok(None) } else { instrument.tail(&described.motion) }
}

/// How the figures of a part that is not linear come about.
pub fn not_linear(instrument: &Instrument, described: &Described) -> Result<String> {
    if instrument.is_linear()? {
        return Ok(String::new());
    }
    let name = instrument.elastic.name();
    let (first, rest) = name.split_at(1);
    let beside = match described.regular {
        Some(_) => "the mean is right within the margin of its step.\n",
        None => {
            "the mean is right within the margin told\n\
             (99 %, with the error of the step). The linearised mean (Booton, Caughey) stands beside it, with what it is off by.\n"
        }
    };
    Ok(format!(
        "{}{rest} is not linear: mean and spread come from following it in time as it is; {beside}",
        first.to_uppercase()
    ))
}

/// The margin of a mean that was simulated, and what a linear part in its place would give.
pub fn within(e: &HeadingError) -> String {
    let margin = format!("   ±{:.5}° ", e.rectified_margin.to_degrees());
    let Some(linearised) = e.linearised else { return margin };
    let off = match e.rectified {
        0.0 => String::new(),
        true_one => format!(" ({:+.0} %)", 100.0 * (linearised / true_one - 1.0)),
    };
    let mean = plain((e.mean() - e.rectified + linearised).to_degrees());
    format!("{margin}  {mean:>10.5}°{off}")
}
