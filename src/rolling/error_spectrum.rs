//! The spectrum of the heading error: where in frequency its spread comes from.

use super::{Compass, Excitation};
use crate::gyro::HeadingError;
use crate::lti::poles;
use crate::{Error, Result};
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// The density at one frequency, of the error's two parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Density {
    /// ω, rad/s.
    pub omega: f64,
    /// By the swing of the gyrosphere, rad²·s.
    pub swing: f64,
    /// By products of motions, rad²·s.
    pub products: f64,
}

impl Density {
    /// Of the whole error, rad²·s.
    pub fn whole(&self) -> f64 {
        self.swing + self.products
    }
}

/// The two-sided spectrum S of the heading error on one heading: its variance is (1/π) ∫₀^∞ S dω.
#[derive(Debug, Clone)]
pub struct ErrorSpectrum {
    /// K, rad.
    pub heading: f64,
    /// Mean and spread.
    pub error: HeadingError,
    /// The densities, by rising frequency.
    pub densities: Vec<Density>,
}

/// Frequencies a decade.
const FINE: f64 = 20.0;

/// A part of the spectrum that is a smaller share of the other one is lost in its rounding.
const ROUNDING: f64 = 1e-15;

/// A pole is narrow where its decay is less than this share of its frequency.
const NARROW: f64 = 0.3;

/// Frequencies evenly by their logarithm, and closer about narrow poles and twice their frequencies, where products
/// have their peaks.
fn frequencies([lowest, highest]: [f64; 2], poles: &[Complex64]) -> Vec<f64> {
    let count = (FINE * (highest / lowest).log10()).ceil() as usize;
    let mut all: Vec<f64> = (0..=count).map(|k| lowest * 10f64.powf(k as f64 / FINE)).collect();
    for pole in poles.iter().filter(|p| p.im > 0.0 && -p.re < NARROW * p.im) {
        // a quarter of the half width apart within it, ever wider outside
        let inside = (0..4).map(|k| 0.25 * f64::from(k));
        let outside = (0..).map(|k| 2f64.powf(0.5 * f64::from(k)));
        let offsets = inside.chain(outside.take_while(|x| -x * pole.re < 0.2 * pole.im));
        for x in offsets.flat_map(|x| [x, -x]) {
            all.extend([1.0, 2.0].map(|about| about * (pole.im + x * pole.re)));
        }
    }
    all.retain(|w| (lowest..=highest).contains(w));
    all.sort_by(f64::total_cmp);
    all.dedup_by(|b, a| *b - *a < 1e-9 * *a);
    all
}

/// The spectrum of the error, from a hundredth of the compass's own frequency to ten times that of the motion.
///
/// ```
/// use gyrospec::rolling::{Compass, Excitation, error_spectrum};
/// use gyrospec::spectrum::Roll;
/// let motion = Excitation::irregular(Roll::new(0.03, 0.1, 0.8)?);
/// let told = error_spectrum(&Compass::paper(), &motion, 45f64.to_radians())?;
/// // at low frequencies the products push the compass, at those of the roll it swings by itself
/// let (first, roll) = (&told.densities[0], told.densities.iter().find(|d| d.omega > 0.8).unwrap());
/// assert!(first.products > 1e3 * first.swing && roll.swing > 1e3 * roll.products);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `Usage` on a regular roll, whose error has lines and no density, and for a part that is not linear; as
/// [`Instrument::error`](crate::gyro::Instrument::error).
pub fn error_spectrum(compass: &Compass, excitation: &Excitation, heading: f64) -> Result<ErrorSpectrum> {
    let (motion, instrument) = (excitation.motion()?, compass.instrument());
    if !instrument.is_linear()? {
        let text = format!("no spectrum is known for {}, which is not linear", compass.part.name());
        return Err(
            Error::usage(text).with_hint("leave --spectrum away: its mean and spread are followed in time")
        );
    }
    if let Some(roll) = motion.regular {
        let p = roll.frequency;
        let text = format!(
            "the error on a regular roll has no density: it is a mean and lines at {p} and {} rad/s",
            2.0 * p
        );
        return Err(Error::usage(text)
            .with_hint("leave --spectrum away for its mean and its swing, or say --irregular"));
    }
    let motion = motion.motion;
    let lowest = TAU / compass.sphere.undamped_period() / 100.0;
    let highest = 10.0 * motion.own_frequency()?.max(0.1);
    let system = instrument.system(&motion, heading)?;
    let omega = frequencies(
        [lowest, highest],
        &[poles(&system.fast, "motion")?, poles(&system.slow, "compass")?].concat(),
    );
    // each run of frequencies by itself: they share nothing
    let runs: Result<Vec<Vec<(f64, f64)>>> =
        omega.par_chunks(16).map(|run| instrument.error_spectrum(&motion, heading, run)).collect();
    let both = runs?.into_iter().flatten();
    // what is less than rounding of the other part is not known, and may be below 0
    let seen = |part: f64, other: f64| if part < ROUNDING * other { 0.0 } else { part };
    let density = |(w, (swing, products)): (&f64, (f64, f64))| Density {
        omega: *w,
        swing: seen(swing, products),
        products: seen(products, swing),
    };
    let densities = omega.iter().zip(both).map(density).collect();
    Ok(ErrorSpectrum { heading, error: instrument.error(&motion, heading)?, densities })
}
