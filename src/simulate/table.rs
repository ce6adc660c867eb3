//! # Purpose
//! What depends on the measured inputs and the time alone, kept once a mesh instead of computed once a run.
//!
//! # Numerical aspects
//! The rows are the bits that the code gives. A run asks by the number of the piece, never by a time, and computes anew
//! where an event has cut a piece.

use crate::model::program::Register;
use std::sync::{Arc, Mutex, PoisonError};

/// Registers at the times of a method's stages.
#[derive(Debug)]
pub(super) struct Table {
    /// The registers that are kept.
    pub registers: Vec<Register>,
    /// The first row of each interval.
    pub first: Vec<usize>,
    /// Rows a step: one at its end, and where there are two one in its middle before that.
    pub stages: usize,
    /// Row by row, register by register.
    pub values: Vec<f64>,
}

impl Table {
    /// The row of a stage of a piece of an interval.
    pub fn row(&self, interval: usize, piece: usize, stage: usize) -> &[f64] {
        let row = self.first[interval] + self.stages * piece + stage;
        &self.values[row * self.registers.len()..][..self.registers.len()]
    }
}

/// Steps in a usual interval and rows a step, and the table for them; none where none is worth it.
type Entry = ((usize, usize), Option<Arc<Table>>);

/// The tables of a mesh.
#[derive(Debug, Default)]
pub(super) struct Tables(Mutex<Vec<Entry>>);

impl Tables {
    /// The table for so many steps in a usual interval and rows a step, made if there is none yet.
    pub fn of(&self, plan: (usize, usize), make: impl FnOnce() -> Option<Table>) -> Option<Arc<Table>> {
        let mut tables = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, table)) = tables.iter().find(|(of, _)| *of == plan) {
            return table.clone();
        }
        let table = make().map(Arc::new);
        // runs of other steps are trials: one more table than the first is enough
        tables.truncate(1);
        tables.push((plan, table.clone()));
        table
    }
}
