//! # What it is
//! The channel moves in steps that are large against what it should show.
//!
//! # Signature in a recording
//! Few distinct values, with equal distances; the residual is a saw.
//!
//! # Equation
//! ```text
//!     y -> q round(y/q)
//! ```
//!
//! # What else looks like this
//! A signal that really moves in steps; frozen-channel.
//!
//! # Reference
//! B. Widrow, I. Kollar, Quantization Noise (2008).
//!
//! # Example
//! A heading logged in whole degrees.

use super::{Group, Mechanism, no_proposals};

/// A coarse resolution.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "quantisation",
    "a coarse resolution",
    Group::Fault,
    include_str!("quantisation.rs"),
    no_proposals,
);
