//! Roll and sea spectra, shaping filters, rational fits.
//!
//! One convention everywhere: two-sided densities S(ω) over angular frequency with
//! K(τ) = (1/2π)∫ S(ω) e^{jωτ} dω, so that the variance is K(0) = (1/2π)∫ S dω.

mod bend;
mod correlation;
mod encounter;
mod even;
mod hull;
mod interval;
mod jackknife;
mod least_squares;
mod rational;
mod roll;
mod roll_damping;
mod sea;
mod welch;

pub use bend::bent;
pub use correlation::{CorrelationFit, autocovariance, fit_correlation};
pub use encounter::{Encounter, SlopeSpectrum};
pub use even::{EvenSamples, even_samples, without_slow};
pub use hull::Hull;
pub use interval::Interval;
pub use jackknife::{RollIntervals, roll_intervals};
pub(crate) use least_squares::{LeastSquares, least_squares};
pub use rational::{RationalFit, fit_rational};
#[cfg(feature = "diagnose")]
pub(crate) use rational::{Search, Shape, fit_shapes};
pub use roll::Roll;
#[cfg(feature = "diagnose")]
pub(crate) use sea::GRAVITY;
pub use sea::Sea;
pub use welch::{MeasuredSpectrum, welch};
