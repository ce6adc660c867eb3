//! What a program meets first: a model run on a recording, fitted to recordings, diagnosed; the
//! rolling error of a compass.
//!
//! [`simulate`], [`fit`], [`diagnose`] and [`roll_error`] take what is needed and give a request; what may be chosen is a method of
//! it, and `run` does the work. The command line and the Python package ask through the same requests.

mod asking;
mod diagnosing;
mod fitting;
mod rolling;
mod simulating;

pub use asking::Asking;
pub use diagnosing::{Diagnosed, Diagnosing, diagnose};
pub use fitting::{Estimated, Fitted, Fitting, fit};
pub use rolling::{Rolled, Rolling, roll_error};
pub use simulating::{Simulated, SimulatedOutput, Simulating, simulate};
