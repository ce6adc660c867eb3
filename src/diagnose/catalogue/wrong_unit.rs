//! # What it is
//! A channel holds degrees and says radians, knots for metres a second, millimetres for metres.
//!
//! # Signature in a recording
//! The model fits well when the channel is multiplied by a known factor between two units.
//!
//! # Equation
//! ```text
//!     u -> f u,  f = 180/pi, 1852/3600, 1000, 9.81 …
//! ```
//!
//! # What else looks like this
//! output-scale, a gain of the model.
//!
//! # Reference
//! NIST SP 811 (2008).
//!
//! # Example
//! A roll angle in degrees under a header that says rad.

use super::{Group, Mechanism, no_proposals};

/// A channel in another unit than it says.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "wrong-unit",
    "a channel in another unit than it says",
    Group::Fault,
    include_str!("wrong_unit.rs"),
    no_proposals,
);
