//! The gyrosphere family, its rectified error, and the rotating gimbal.
//!
//! The horizontal directions are those of the rolling-error paper: W₁ along the parallel,
//! W₂ along the meridian, with W₁ = −hθ̈ cos K and W₂ = +hθ̈ sin K for roll θ of a ship on
//! heading K; x is the shift of the centre of mass along the parallel.

pub mod elastic;
mod free;
pub mod gimbal;
mod gyrosphere;
mod identify;
mod instrument;
mod monte_carlo;
mod motion;
pub mod rectified;
pub mod seed;
mod sweep;

pub use free::FreeMotion;
pub use gyrosphere::Gyrosphere;
pub use identify::{Estimate, Identified, Trial, identify};
pub use instrument::{EARTH_RADIUS, HeadingError, Instrument};
pub use monte_carlo::{MonteCarlo, Simulated};
pub use motion::{Axis, Motion, Signal};
pub use sweep::sweep;
