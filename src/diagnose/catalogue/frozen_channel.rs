//! # What it is
//! A channel repeats one value while the system moves: a lost link, a hung logger, ice.
//!
//! # Signature in a recording
//! Many equal samples in a row where the neighbours say that there was motion.
//!
//! # Equation
//! ```text
//!     y(t) = y(t1)  for  t1 <= t <= t2
//! ```
//!
//! # What else looks like this
//! output-saturation (at the end of the range), a system that really rests, quantisation.
//!
//! # Reference
//! V. Barnett, T. Lewis, Outliers in Statistical Data (1994).
//!
//! # Example
//! A heading that stays at 225.3 deg for a minute while the ship turns.

use super::{Group, Mechanism, no_proposals};

/// A channel that is stuck.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "frozen-channel",
    "a channel that is stuck",
    Group::Fault,
    include_str!("frozen_channel.rs"),
    no_proposals,
);
