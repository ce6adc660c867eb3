//! # What it is
//! An input that keeps each of its values until the next one, as a command from a computer does, and was read as
//! straight lines between its samples.
//!
//! # Signature in a recording
//! The output follows half a sample later than the model, most where the input moves fast.
//!
//! # Equation
//! ```text
//!     u(t) = u_k for t_k <= t < t_{k+1}
//! ```
//!
//! # What else looks like this
//! input-delay and output-delay of half a sample, input-lag and output-lag. Where the output shows a whole sample or
//! more, it is one of these.
//!
//! # Reference
//! G. F. Franklin, J. D. Powell, M. Workman, Digital Control of Dynamic Systems, 3rd ed. (1998), 4.3.
//!
//! # Example
//! The voltage of a motor that a controller sets 50 times a second.

use super::{Group, Mechanism, no_proposals};

/// An input that is held between its samples.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "input-hold",
    "an input that is held between its samples",
    Group::Fault,
    include_str!("input_hold.rs"),
    no_proposals,
);
