//! What stands in for machine code where none is made.

use crate::{MarchCode, Mark, Number, StepCode};
use std::convert::Infallible;

/// Steps as machine code; none here, since the package was built without its feature `jit`.
#[derive(Debug)]
pub struct Steps(Infallible);

impl Steps {
    /// Whether machine code is made at all.
    pub const MADE: bool = false;

    /// None: the caller interprets.
    pub fn compile(_: &StepCode<'_>, _: usize) -> Option<Self> {
        None
    }

    /// Never called.
    pub fn time<T: Number>(&self, _: &mut [T]) {
        match self.0 {}
    }

    /// Never called.
    pub fn output<T: Number>(&self, _: &mut [T]) {
        match self.0 {}
    }

    /// Never called.
    pub fn state<T: Number>(&self, _: &mut [T]) {
        match self.0 {}
    }

    /// Never called.
    pub fn motion<T: Number>(&self, _: &mut [T]) {
        match self.0 {}
    }

    /// Never called.
    pub fn slopes<T: Number>(&self, _: &mut [T]) {
        match self.0 {}
    }

    /// Never called.
    pub fn has_slopes(&self) -> bool {
        match self.0 {}
    }

    /// Never called.
    pub fn first_half<T: Number>(&self, _: &[T], _: &[T], _: &[T], _: f64, _: &mut [T], _: &mut [T]) {
        match self.0 {}
    }

    /// Never called.
    pub fn second_half<T: Number>(
        &self,
        _: &mut [T],
        _: (&[T], &[T], &[T]),
        _: f64,
        _: (&mut [T], &mut [T], &mut [T]),
    ) {
        match self.0 {}
    }

    /// Never called.
    pub fn heun<T: Number>(&self, _: &mut [T], _: (&[T], &[T]), _: f64, _: (&mut [T], &mut [T], &mut [T])) {
        match self.0 {}
    }
}

/// Steps in a loop; none here.
#[derive(Debug)]
pub struct March(Infallible);

impl March {
    /// None: the caller takes the steps one by one.
    pub fn compile(_: &StepCode<'_>, _: &MarchCode<'_>, _: usize) -> Option<Self> {
        None
    }

    /// Never called.
    pub fn run<T: Number>(
        &self,
        _: (&mut [T], &mut [T], &mut [T]),
        _: (&[f64], &[f64], &[f64], &[Mark]),
        _: &mut [f64],
        _: &mut [&mut [T]],
    ) -> usize {
        match self.0 {}
    }
}
