//! Strapdown systems and single gyros that vibrate: what vibration leaves in the mean of what they read, and what it
//! and their noise do to a heading found from them.
//!
//! Body axes: x forward, y to starboard, z down. A drift is what a gyro reads in the mean less the mean rate, rad/s; a
//! bias what an accelerometer reads so, m/s².
//!
//! | file | effect |
//! |---|---|
//! | `coning` | ½⟨φ × φ̇⟩, two rotations in quadrature |
//! | `sculling` | ⟨φ × a⟩, a rotation and an acceleration in phase |
//! | `anisoinertia` | two rates in phase about the axes of one gyro |
//! | `anisoelasticity` | two accelerations in phase on a float that gives way |
//! | `tuned_rotor` | two turns a revolution on a dry-tuned rotor |
//! | `vibration_square` | an accelerometer's square term |
//! | `heading` | the heading found by gyrocompassing with drifts and biases |
//! | `north_seeking` | the spread of that heading by the gyros' noise and by the sea |
//! | `system` | all of it together |

mod anisoelasticity;
mod anisoinertia;
mod coning;
mod heading;
mod north_seeking;
mod sculling;
mod system;
mod tuned_rotor;
mod vibration;
mod vibration_square;

pub use anisoelasticity::Anisoelasticity;
pub use anisoinertia::Anisoinertia;
pub use coning::coning;
pub use heading::{EARTH_RATE, Found, GRAVITY, by_gyrocompassing};
pub use north_seeking::{NorthSeeking, Seaway, aligned};
pub use sculling::sculling;
pub use system::{Disturbance, Effect, Findings, MountedRotor, Place, RotorReads, Spread, System};
pub use tuned_rotor::TunedRotor;
pub use vibration::{Shaken, Vibration};
pub use vibration_square::square_term;

/// A vector along the body's axes x, y, z.
pub type Vector = [f64; 3];
