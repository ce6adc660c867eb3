//! What of the mean error comes from frequencies far above the motion's own.

use super::options::Described;
use crate::gyro::Instrument;
use crate::gyro::rectified::SlowFast;
use crate::units::significant;
use crate::{Error, Result};
use std::fmt::Write;

/// So many times its own frequency a motion hardly moves.
const FAR: f64 = 4.0;
/// No ship rolls above the first, rad/s; a band that is said may well lie below the second.
const NO_SHIP: [f64; 2] = [2.5, 10.0];
/// Further frequencies, rad/s, that the mean is told up to.
const CUTS: [f64; 4] = [10.0, 100.0, 1e3, 1e4];
/// Share of the mean from which on a band is asked for.
const MUCH: f64 = 0.05;
/// No simulation follows frequencies above this, rad/s.
const FOLLOWED: f64 = 100.0;
/// Panels of Simpson's rule for a factor e of the frequency.
const PANELS: f64 = 100.0;

/// The mean error on heading 45° by the motion's frequencies up to each of many.
pub struct Tail {
    /// Whether the acceleration has infinite variance.
    pub white: bool,
    /// From where on the frequencies count as tail, rad/s.
    pub from: f64,
    /// rad/s and rad, from `from` on.
    up_to: Vec<(f64, f64)>,
    /// rad.
    pub whole: f64,
}

impl Tail {
    /// `None` for a regular roll, a part that is not linear, and a motion of finite acceleration whose mean
    /// does not depend on such frequencies.
    pub fn of(instrument: &Instrument, described: &Described) -> Result<Option<Self>> {
        if described.regular.is_some() || !instrument.is_linear()? {
            return Ok(None);
        }
        let motion = &described.motion;
        let white = motion.has_white_acceleration();
        let from = (FAR * motion.own_frequency()?).max(NO_SHIP[usize::from(!white)]);
        let system = instrument.system(motion, 45f64.to_radians())?;
        let whole = system.rectified_mean()?[0];
        let tail = Self { white, from, up_to: cumulated(&system, from, whole)?, whole };
        Ok(Some(tail).filter(|t| white || t.share() > MUCH))
    }

    /// How much of the largest of them the means up to all frequencies above `omega` differ.
    pub fn share_above(&self, omega: f64) -> f64 {
        let all =
            || self.up_to.iter().filter(|m| m.0 >= omega * (1.0 - 1e-9)).map(|m| m.1).chain([self.whole]);
        let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max));
        let largest = low.abs().max(high.abs());
        // below that there is no mean but rounding
        if largest > 1e-12 { (high - low) / largest } else { 0.0 }
    }

    /// The share of all that counts as tail.
    pub fn share(&self) -> f64 {
        self.share_above(self.from)
    }

    /// Frequency, rad/s, mean up to it, rad, and share above it.
    pub fn told(&self) -> Vec<(f64, f64, f64)> {
        let at = |w: f64| {
            self.up_to.iter().find(|m| m.0 >= w * (1.0 - 1e-9)).map(|m| (w, m.1, self.share_above(w)))
        };
        cuts(self.from).into_iter().filter_map(at).collect()
    }

    /// Whether more than 2 % of the mean come from where no simulation follows the motion.
    pub fn is_beyond_simulation(&self) -> bool {
        self.white && self.share_above(FOLLOWED) > 0.02
    }

    pub fn text(&self) -> String {
        let mut out = if self.white {
            "This motion's acceleration has a white tail (infinite variance), which no ship has: frequencies\n".to_owned()
        } else {
            "This motion still moves where no ship does: frequencies\n".to_owned()
        };
        let _ = write!(
            out,
            "above {} rad/s count for {} of the mean. On heading 45° it is",
            significant(self.from, 3),
            percent(self.share())
        );
        for (omega, mean, share) in self.told() {
            let (mean, omega) = (mean.to_degrees(), significant(omega, 3));
            let _ = write!(out, " {mean:.3}° up to {omega} rad/s ({} above),", percent(share));
        }
        let _ = writeln!(out, "\nand {:.3}° with all of them.", self.whole.to_degrees());
        if self.share() > MUCH {
            out.push_str("Say --band with the frequency above which this ship does not move: the answer depends on it.\n");
        }
        out
    }
}

fn percent(share: f64) -> String {
    if share < 0.005 { "less than 1 %".to_owned() } else { format!("{:.0} %", 100.0 * share) }
}

fn cuts(from: f64) -> Vec<f64> {
    [from].into_iter().chain(CUTS.into_iter().filter(|w| *w > from)).collect()
}

/// The mean up to frequencies from `from` on: the whole less the integral of its density over those above,
/// by Simpson's rule over ln ω, and ω⁻² beyond the last.
fn cumulated(system: &SlowFast, from: f64, whole: f64) -> Result<Vec<(f64, f64)>> {
    let poles = system.fast.eigenvalues();
    let poles = poles.map_err(|_| Error::not_computed("the poles of the motion are not found"))?;
    let fastest = poles.iter().map(|p| p.re.hypot(p.im)).fold(from, f64::max);
    let mut ends = cuts(from);
    ends.push(1e3 * fastest.max(CUTS[3]));
    let f = |x: f64| x.exp() * system.mean_density(0, x.exp());
    let mut areas = vec![(from, 0.0)];
    for pair in ends.windows(2) {
        let (a, b) = (pair[0].ln(), pair[1].ln());
        let count = (PANELS * (b - a)).ceil();
        let h = (b - a) / count;
        for k in 0..count as usize {
            let x = a + k as f64 * h;
            areas.push(((x + h).exp(), h / 6.0 * (f(x) + 4.0 * f(x + 0.5 * h) + f(x + h))));
        }
    }
    let beyond = f(ends[ends.len() - 1].ln());
    let mut mean = whole - beyond - areas.iter().map(|a| a.1).sum::<f64>();
    Ok(areas
        .into_iter()
        .map(|(omega, area)| {
            mean += area;
            (omega, mean)
        })
        .collect())
}
