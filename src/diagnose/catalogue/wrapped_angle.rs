//! # What it is
//! An angle that passes north jumps from 360 to 0 deg and is read as it stands.
//!
//! # Signature in a recording
//! Jumps of exactly one turn between neighbours.
//!
//! # Equation
//! ```text
//!     y -> y modulo 360 deg
//! ```
//!
//! # What else looks like this
//! outliers, clock-jump. In a recording file, `wraps = true` cures it.
//!
//! # Reference
//! K. V. Mardia, P. E. Jupp, Directional Statistics (2000).
//!
//! # Example
//! A heading about north without `wraps = true`.

use super::{Group, Mechanism, no_proposals};

/// An angle that jumps by a turn.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "wrapped-angle",
    "an angle that jumps by a turn",
    Group::Fault,
    include_str!("wrapped_angle.rs"),
    no_proposals,
);
