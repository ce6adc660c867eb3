//! The gyrosphere family, its rectified error, the rotating gimbal, and strapdown systems that vibrate.
//!
//! The horizontal directions are those of the rolling-error paper: W₁ along the parallel,
//! W₂ along the meridian (east and north positive), with W₁ = −hθ̈ cos K and W₂ = +hθ̈ sin K for roll θ of a ship on
//! heading K; x is the shift of the centre of mass along the parallel, west positive.

mod answer;
mod by_noise;
mod by_spectrum;
mod effort;
pub mod elastic;
mod free;
pub mod gimbal;
mod gyrosphere;
mod identify;
mod instrument;
mod kernel;
mod manoeuvre;
mod monte_carlo;
mod motion;
mod nonlinear;
mod path;
pub mod pendulous;
mod percentile;
mod quantile;
#[doc(hidden)]
pub mod range;
pub(crate) mod rectified;
mod replay;
pub mod seed;
pub mod strapdown;
mod sweep;
mod tail;
pub mod validity;

pub use by_noise::{NoiseDensity, OffBy};
pub use by_spectrum::BySpectrum;
pub use effort::{BUDGET, Effort, FEWEST};
pub use free::FreeMotion;
pub use gyrosphere::Gyrosphere;
pub use identify::{Identified, Trial, identify};
pub use instrument::{EARTH_RADIUS, HeadingError, Instrument};
pub use manoeuvre::Manoeuvres;
pub use monte_carlo::{MonteCarlo, SimulatedError};
pub use motion::{Axis, LinearSignal, Motion};
pub use nonlinear::{Moment, folded};
pub use path::Drive;
pub use pendulous::{Corrector, PendulousCompass};
pub use percentile::Shape;
pub use quantile::Quantile;
pub use replay::Replay;
pub use sweep::sweep;
pub use tail::Tail;

/// Which way an error of the heading is, for everybody who reads one.
///
/// From (2.1) at rest, α′ = −U sin φ + … and β′ = −U α cos φ + …: an axis fixed among the stars drifts east of a
/// meridian that turns with +U sin φ, and rises while it points east. So α counts to the west and β upwards.
pub const SIGN: &str = "+ is west: the compass's north lies west of true north, and the compass reads high; − is east: \
it reads low; the true heading is the reading minus the error";

/// Which motions leave the mean alone, and why.
pub const IDLE: &str = "the mean error follows from the row of β alone, U cos φ · mean α = mean M_y/H; heave, yaw and a \
part that gives way along the vertical push only the rows of α and λ: they move the mean tilt and the spread, \
not the mean heading";

/// An error that rounding makes of none, rad or degrees.
const NONE: f64 = 1e-9;

/// The side of an error, rad or degrees: `west, reads high`; none has no side.
pub fn side(error: f64) -> &'static str {
    if error.abs() < NONE {
        return "neither way";
    }
    if error < 0.0 { "east, reads low" } else { "west, reads high" }
}
