//! # What it is
//! Single samples that belong to no motion: transmission errors, cut sentences, dropped bits.
//!
//! # Signature in a recording
//! Isolated values many times the noise away from both neighbours; or, at any share, a number that loggers write where
//! nothing was measured, such as -9999, far off all else.
//!
//! # Equation
//! ```text
//!     y_i = y(t_i) + something large, for few i
//! ```
//!
//! # What else looks like this
//! Real shocks (several samples long), wrapped-angle (a whole turn), gap.
//!
//! # Reference
//! P. J. Huber, E. M. Ronchetti, Robust Statistics, 2nd ed. (2009).
//!
//! # Example
//! A depth of 999.9 in an echo sounder's log.

use super::{Group, Mechanism, no_proposals};

/// Single samples far off.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "outliers",
    "single samples far off",
    Group::Fault,
    include_str!("outliers.rs"),
    no_proposals,
);
