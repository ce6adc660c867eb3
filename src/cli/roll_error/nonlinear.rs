//! Parts that are not linear: what they need of the motion, and what is said of their figures.

use super::options::Described;
use super::table::{Case, plain};
use super::tail::Tail;
use crate::cli::progress::Meter;
use crate::estimate::fit::Progress;
use crate::gyro::{HeadingError, Instrument, Moment, folded};
use crate::{Error, Result};
use std::collections::BTreeMap;

/// What parts that are not linear make of the motions, each computed once for all rows that share it: by
/// the folded heading and the height of the sea.
pub struct Moments(BTreeMap<[u64; 2], Moment>);

impl Moments {
    pub fn of(cases: &[Case], meter: &Meter) -> Result<Self> {
        let mut all = BTreeMap::new();
        for (i, case) in cases.iter().enumerate() {
            let missing = case.motion.regular.is_none() && !all.contains_key(&Self::key(case));
            if missing && !case.instrument.is_linear()? {
                meter.says("following the part in time", Some(i as f64 / cases.len() as f64));
                all.insert(Self::key(case), case.instrument.moment(&case.motion.motion, case.heading)?);
            }
        }
        Ok(Self(all))
    }

    pub fn get(&self, case: &Case) -> Option<&Moment> {
        self.0.get(&Self::key(case))
    }

    fn key(case: &Case) -> [u64; 2] {
        let (heading, _) = folded(&case.motion.motion, case.heading);
        [(heading * 1e12).round() as u64, case.height.unwrap_or(0.0).to_bits()]
    }
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
    Tail::of(instrument, described)
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
