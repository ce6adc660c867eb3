//! A model on a recording.
//!
//! A [`Simulator`] is built once from a model and a recording: it compiles the expressions, lays
//! the mesh of the inputs, and chooses method and steps so that halving the step moves no output
//! by more than a stated share of its spread. Runs with other parameters and initial states, with
//! sensitivities if wanted, are then as quick as the arithmetic.

mod absent;
mod again;
mod budget;
mod course;
mod did;
mod events;
mod faults;
mod first;
mod functions;
mod gaps;
mod history;
mod linear;
mod machine;
mod march;
mod mesh;
mod native;
mod pieces;
mod plan;
mod probe;
mod request;
mod roughness;
mod run;
mod signals;
mod simulator;
mod slowest;
mod stages;
mod start;
mod static_run;
mod steps;
mod stiff;
mod table;
mod tabulate;
mod trace;
mod warnings;

pub use absent::present;
pub use budget::{Budget, Early};
pub use mesh::GAP_STEPS;
#[doc(hidden)]
pub use plan::Planned;
pub use request::{Options, Trajectory, Unknown};
pub use signals::{OutputSignal, coverage};
pub use simulator::Simulator;
#[doc(hidden)]
pub use stages::Stage;
pub use steps::Solver;
pub use trace::Trace;
pub use warnings::warnings;
