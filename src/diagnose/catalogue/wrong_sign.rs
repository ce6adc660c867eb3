//! # What it is
//! A channel counts in the other direction than the model: port for starboard, up for down. Or a definition or a
//! parameter of the model has the wrong sign: a controller that feeds back so that the model runs away.
//!
//! # Signature in a recording
//! The model fits well with it turned over, and not at all as it stands.
//!
//! # Equation
//! ```text
//!     u -> -u    or    y -> -y    or    d -> -d    or    p -> -p      d a definition, p a parameter
//! ```
//!
//! # What else looks like this
//! misalignment by half a turn; a gain that should be negative.
//!
//! # Reference
//! SNAME, Nomenclature for treating the motion of a submerged body through a fluid (1950), on
//! signs.
//!
//! # Example
//! A roll angle positive to port.

use super::{Group, Mechanism, no_proposals};

/// A channel with the wrong sign.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "wrong-sign",
    "a channel with the wrong sign",
    Group::Fault,
    include_str!("wrong_sign.rs"),
    no_proposals,
);
