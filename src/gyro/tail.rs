//! # Purpose
//! What of the mean error comes from frequencies far above the motion's own.
//!
//! # Method
//! The mean by the frequencies up to ω is the whole less the integral of its density over those above, by Simpson's
//! rule over ln ω, and ω⁻² beyond the last.
//!
//! # Numerical aspects
//! The integral runs above the resonances, where the density is smooth; a narrow peak below costs nothing.

use super::rectified::SlowFast;
use super::{Instrument, Motion};
use crate::Result;
use crate::lti::poles;

/// So many times its own frequency a motion hardly moves.
const FAR: f64 = 4.0;
/// No ship rolls above the first, rad/s; a band that is said may well lie below the second.
const NO_SHIP: [f64; 2] = [2.5, 10.0];
/// Further frequencies, rad/s, that the mean is told up to.
const CUTS: [f64; 4] = [10.0, 100.0, 1e3, 1e4];
/// No simulation follows frequencies above this, rad/s.
const FOLLOWED: f64 = 100.0;
/// Panels of Simpson's rule for a factor e of the frequency.
const PANELS: f64 = 100.0;

/// The mean error on heading 45° by the motion's frequencies up to each of many.
#[derive(Debug, Clone)]
pub struct Tail {
    /// Whether the acceleration has infinite variance.
    pub white: bool,
    /// From where on the frequencies count as tail, rad/s.
    pub from: f64,
    /// rad/s and rad, from `from` on.
    up_to: Vec<(f64, f64)>,
    /// The mean by all frequencies, rad.
    pub whole: f64,
}

impl Instrument {
    /// The tail of the mean error on a random motion; `None` for a part that is not linear, and for a motion of
    /// finite acceleration whose mean hardly depends on frequencies above those of ships.
    ///
    /// # Errors
    /// As [`Instrument::error`].
    pub fn tail(&self, motion: &Motion) -> Result<Option<Tail>> {
        if !self.is_linear()? {
            return Ok(None);
        }
        let white = motion.has_white_acceleration();
        let from = (FAR * motion.own_frequency()?).max(NO_SHIP[usize::from(!white)]);
        let system = self.system(motion, 45f64.to_radians())?;
        let whole = system.rectified_mean()?[0];
        let tail = Tail { white, from, up_to: system.mean_up_to(0, from, whole)?, whole };
        Ok(Some(tail).filter(|t| white || t.is_much()))
    }
}

impl Tail {
    /// Share from which on a band is asked for.
    pub const MUCH: f64 = 0.05;

    /// By how much the mean changes where the end of the band moves above `omega` (rad/s): the span of the means by
    /// the frequencies up to each ω ≥ `omega`, as a share of the largest of them. Not of the mean by all of them,
    /// which with inertia may pass 0.
    pub fn share_above(&self, omega: f64) -> f64 {
        let all =
            || self.up_to.iter().filter(|m| m.0 >= omega * (1.0 - 1e-9)).map(|m| m.1).chain([self.whole]);
        let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max));
        let largest = low.abs().max(high.abs());
        // below that there is no mean but rounding
        if largest > 1e-12 { (high - low) / largest } else { 0.0 }
    }

    /// The same for all that counts as tail.
    pub fn share(&self) -> f64 {
        self.share_above(self.from)
    }

    /// Whether the answer depends on the tail.
    pub fn is_much(&self) -> bool {
        self.share() > Self::MUCH
    }

    /// Frequency, rad/s, mean up to it, rad, and share of [`Self::share_above`], for a few frequencies.
    pub fn table(&self) -> Vec<(f64, f64, f64)> {
        let at = |w: f64| {
            self.up_to.iter().find(|m| m.0 >= w * (1.0 - 1e-9)).map(|m| (w, m.1, self.share_above(w)))
        };
        cuts(self.from).filter_map(at).collect()
    }

    /// Whether the mean changes by more than 2 % where no simulation follows the motion.
    pub fn is_beyond_simulation(&self) -> bool {
        self.white && self.share_above(FOLLOWED) > 0.02
    }
}

fn cuts(from: f64) -> impl Iterator<Item = f64> {
    [from].into_iter().chain(CUTS.into_iter().filter(move |w| *w > from))
}

impl SlowFast {
    /// What the products add to the mean of slow state `row` by frequencies up to each of many, from `from` on,
    /// rad/s; `whole` is that by all of them.
    ///
    /// # Errors
    /// `NotComputed` where the poles of the motion are not found.
    pub(super) fn mean_up_to(&self, row: usize, from: f64, whole: f64) -> Result<Vec<(f64, f64)>> {
        let poles = poles(&self.fast, "motion")?;
        let fastest = poles.iter().map(|p| p.re.hypot(p.im)).fold(from, f64::max);
        let ends: Vec<f64> = cuts(from).chain([1e3 * fastest.max(CUTS[3])]).collect();
        let f = |x: f64| x.exp() * self.mean_density(row, x.exp());
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
}
