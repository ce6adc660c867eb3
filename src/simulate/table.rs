//! # Purpose
//! What depends on the measured inputs and the time alone, kept once a mesh instead of computed once a run.
//!
//! # Numerical aspects
//! The rows are the bits that the code gives. A run asks by the number of the piece, never by a time, and computes anew
//! where an event has cut a piece.

use crate::model::program::Register;
use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};

/// Registers at the times of a method's stages.
#[derive(Debug)]
pub(super) struct Table {
    /// The registers that are kept: first those that code makes.
    pub registers: Vec<Register>,
    /// How many of them code makes; the others are measured, or the time itself, for steps that are marched over.
    pub made: usize,
    /// Length of each step, s, and the time at its end, for such steps alone.
    pub lengths: Vec<f64>,
    pub ends: Vec<f64>,
    /// Row by row what stands after each jump, and how many jumps come before each interval, for such steps alone.
    pub after_jumps: Vec<f64>,
    pub jumps: Vec<usize>,
    /// The first row of each interval.
    pub first: Vec<usize>,
    /// Rows a step: one at its end, and where there are two one in its middle before that.
    pub stages: usize,
    /// Row by row, register by register.
    pub values: Vec<f64>,
}

impl Table {
    /// What code makes at a stage of a piece of an interval, register by register.
    pub fn made(&self, interval: usize, piece: usize, stage: usize) -> impl Iterator<Item = (Register, f64)> {
        let row = self.first[interval] + self.stages * piece + stage;
        let values = &self.values[row * self.registers.len()..];
        self.registers.iter().copied().zip(values.iter().copied()).take(self.made)
    }

    /// The number of the first step in an interval.
    pub fn step(&self, interval: usize) -> usize {
        self.first[interval] / self.stages
    }

    /// The rows of some steps.
    pub fn rows(&self, steps: Range<usize>) -> &[f64] {
        let numbers = self.stages * self.registers.len();
        &self.values[steps.start * numbers..steps.end * numbers]
    }

    /// The rows of the jumps from the beginning of an interval on.
    pub fn jumps_from(&self, interval: usize) -> &[f64] {
        &self.after_jumps[self.jumps[interval] * self.registers.len()..]
    }
}

/// What a table is for: steps in a usual interval, rows a step, and whether the steps are marched over.
pub(super) type Use = (usize, usize, bool);

/// A table; none where none is worth it.
type Entry = (Use, Option<Arc<Table>>);

/// The tables of a mesh.
#[derive(Debug, Default)]
pub(super) struct Tables(Mutex<Vec<Entry>>);

impl Tables {
    /// The table for a use, made if there is none yet.
    pub fn of(&self, plan: Use, make: impl FnOnce() -> Option<Table>) -> Option<Arc<Table>> {
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
