//! What a run needs besides numbers.

use super::budget::Allowance;
use super::mesh::Mesh;
use super::native::Natives;
use super::probe::Clock;
use super::steps::Solver;
use crate::model::program::Program;

/// Steps after which the time is looked at.
pub(super) const PATIENCE: usize = 256;

/// What a run needs besides numbers.
pub(super) struct Course<'a> {
    pub program: &'a Program,
    /// What of the program was made machine code.
    pub natives: &'a Natives,
    pub mesh: &'a Mesh,
    pub clocks: &'a [Clock],
    /// States that start where the model is steady.
    pub steady: &'a [usize],
    pub method: Solver,
    /// Steps in a usual interval of the mesh.
    pub substeps: usize,
    /// What the run may spend.
    pub allowance: &'a Allowance<'a>,
}
