//! # What it is
//! A stretch of the recording is empty or its time stamps leap.
//!
//! # Signature in a recording
//! No samples for much longer than the usual step.
//!
//! # Equation
//! ```text
//!     no y(t)  for  t1 < t < t2
//! ```
//!
//! # What else looks like this
//! frozen-channel (the logger fills with the last value), clock-jump.
//!
//! # Reference
//! R. J. A. Little, D. B. Rubin, Statistical Analysis with Missing Data, 3rd ed. (2019).
//!
//! # Example
//! A minute lost while the file was changed.

use super::{Group, Mechanism, no_proposals};

/// Samples that are missing.
pub(super) const MECHANISM: Mechanism =
    Mechanism::new("gap", "samples that are missing", Group::Fault, include_str!("gap.rs"), no_proposals);
