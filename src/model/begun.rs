//! What a model may begin with in the place of equations: the table of a simulation, or a Functional Mock-up Unit.

use crate::record::{Channel, Source, Zero};
use std::path::PathBuf;
use std::sync::Arc;

/// The series that a simulation elsewhere computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Simulated {
    /// Its table.
    pub file: PathBuf,
    /// The columns that the model speaks of, by their names there; SI, on a clock of their own.
    pub channels: Arc<[Channel]>,
    /// The table with its hash.
    pub source: Source,
    /// The moment that its times count from, where it tells.
    pub(crate) zero: Option<Zero>,
}

impl Simulated {
    /// Whether an input of the model is one of its columns.
    pub fn gives(&self, input: &str) -> bool {
        self.channels.iter().any(|c| c.name == input)
    }
}

/// The unit that a model begins with.
#[cfg(feature = "fmu")]
#[derive(Clone)]
pub struct Mockup {
    /// Its archive.
    pub file: PathBuf,
    /// The archive with its hash.
    pub source: Source,
    /// The names that the model gives its variables.
    pub(super) names: Vec<String>,
    /// The number of its code, where it is a function.
    pub(super) code: Option<u16>,
    /// What steps it, where it steps itself.
    pub(super) drive: Option<Arc<crate::fmu::Drive>>,
    /// Parameters of a unit that steps itself that are fitted.
    pub(super) fitted: Vec<String>,
    /// What of it is left out.
    pub(super) notes: Vec<String>,
    /// Whether the description gives any of its numbers a unit.
    pub(super) has_units: bool,
    /// Inputs and outputs that a channel of another name holds: section, name, channel.
    pub(super) channels: Vec<(String, String, String)>,
}

#[cfg(feature = "fmu")]
impl std::fmt::Debug for Mockup {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Mockup").field("file", &self.file).finish_non_exhaustive()
    }
}

#[cfg(feature = "fmu")]
impl PartialEq for Mockup {
    fn eq(&self, other: &Self) -> bool {
        self.file == other.file && self.names == other.names && self.channels == other.channels
    }
}
