//! # Purpose
//! The mean error by a measured spectrum of roll, beside that by the roll (3.3) fitted to it.
//!
//! # Method
//! A linear part makes of roll of density S the mean ∫₀^∞ k(ω) S(ω) dω, with k the part's own integrand: that of
//! [`SlowFast::mean_density`](super::rectified::SlowFast::mean_density) a unit of S. The measured spectrum ends with
//! its band; the fit goes on.
//!
//! # Numerical aspects
//! The mean by the fit up to the end of the band is the whole less the integral above, where nothing resonates; the
//! measured spectrum is summed by trapezoids. One heading serves all: the mean is in proportion to sin 2K.

use super::{Instrument, Motion};
use crate::spectrum::{MeasuredSpectrum, Roll};
use crate::{Error, ErrorKind, Result};
use std::f64::consts::{FRAC_PI_4, PI};

/// The mean error on heading 45° three ways, rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BySpectrum {
    /// By the fit.
    pub fitted: f64,
    /// By the fit up to the end of the measured band.
    pub banded: f64,
    /// By the measured spectrum.
    pub measured: f64,
}

impl BySpectrum {
    /// What of the mean by the fit lies above the measured band; its part of it.
    pub fn above(&self) -> f64 {
        self.part(self.fitted - self.banded)
    }

    /// By how much the fit's form makes the mean too large inside the band; its part of the mean by the fit.
    pub fn form(&self) -> f64 {
        self.part(self.banded - self.measured)
    }

    /// The mean by the measured spectrum for one of 1 by the fit, on any heading.
    pub fn ratio(&self) -> f64 {
        1.0 - self.part(self.fitted - self.measured)
    }

    /// A part of the mean by the fit; none where there is no mean.
    fn part(&self, of: f64) -> f64 {
        if self.fitted == 0.0 { 0.0 } else { of / self.fitted }
    }
}

impl Instrument {
    /// The mean error by a measured spectrum of roll and by its fit, both behind two low-passes at `band` (rad/s) where
    /// one is given, with the integrand of the elastic part.
    ///
    /// ```
    /// use gyrospec::gyro::{Gyrosphere, Instrument, elastic::Inertia};
    /// use gyrospec::spectrum::{Roll, welch};
    /// let roll = Roll::new(4e-3, 0.08, 0.65).unwrap();
    /// let spectrum = welch(&roll.samples(0.5, 20_000, 1), 0.5, 1024).unwrap();
    /// let compass = Instrument::new(Gyrosphere::seed(), Box::new(Inertia));
    /// let mean = compass.mean_by_spectrum(&roll, None, &spectrum).unwrap();
    /// // above 2π rad/s the inertia of the part takes away from the mean
    /// assert!(mean.above() < -0.2 && (mean.measured / mean.banded - 1.0).abs() < 0.2);
    /// ```
    ///
    /// # Errors
    /// `OutOfRange` for a part that is not linear; else as [`Instrument::error`].
    pub fn mean_by_spectrum(
        &self,
        roll: &Roll,
        band: Option<f64>,
        spectrum: &MeasuredSpectrum,
    ) -> Result<BySpectrum> {
        if !self.is_linear()? {
            let text = format!("no spectrum gives the mean by {}, which is not linear", self.elastic.name());
            return Err(Error::new(ErrorKind::OutOfRange, text));
        }
        let motion = Motion::roll(roll);
        let motion = band.map_or(Ok(motion.clone()), |corner| motion.band_limited(corner, 2))?;
        let system = self.system(&motion, FRAC_PI_4)?;
        let fitted = system.rectified_mean()?[0];
        let above = system.mean_up_to(0, PI / spectrum.step, fitted)?;
        let banded = above.first().map_or(fitted, |m| m.1);
        // (1/2π)∫ of both signs of ω, where the mean is ∫₀^∞
        let measured = spectrum.integral(|w| PI * system.mean_density(0, w) / roll.density(w));
        Ok(BySpectrum { fitted, banded, measured })
    }
}
