//! What a program meets first: a model run on a recording, fitted to recordings, diagnosed.
//!
//! [`simulate`], [`fit`] and [`diagnose`] take what is needed and give a request; what may be chosen is a method of
//! it, and `run` does the work. The command line and the Python package ask through the same requests.

mod diagnosing;
mod fitting;
mod simulating;

pub use diagnosing::{Diagnosed, Diagnosing, diagnose};
pub use fitting::{Estimated, Fitted, Fitting, fit};
pub use simulating::{Simulated, SimulatedOutput, Simulating, simulate};

use crate::model::Model;
use crate::record::Source;
use std::path::Path;

/// What stands among the inputs of a report for a model that was not read from a file: its own text.
fn unread(model: &Model) -> Source {
    Source::of(Path::new("model"), model.to_toml().as_bytes())
}
