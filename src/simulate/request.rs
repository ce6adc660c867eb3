//! What is asked of a run, and what it gives.

use super::budget::Budget;
use super::plan::Planned;
use super::probe::Clock;
use super::steps::Solver;
use crate::{Error, Result};

/// How to simulate.
#[derive(Debug, Clone)]
pub struct Options {
    /// Share of an output's spread by which halving the step may move it; 1e-5.
    pub tolerance: f64,
    /// Simulate from here to there only, s; the initial states then stand at the first.
    pub window: Option<(f64, f64)>,
    /// Fixed method and number of steps in a usual interval of the inputs; no check then.
    pub fixed: Option<(Solver, usize)>,
    /// Whether what follows a gap of an input is left out until the model, at its own parameters, has
    /// forgotten the gap; else the gap alone is.
    pub waits: bool,
    /// What the runs may spend; unlimited.
    pub budget: Budget,
    /// Steps that did for much the same model on the same mesh, instead of a search for them; each run sees whether
    /// they do.
    #[doc(hidden)]
    pub planned: Option<Planned>,
}

impl Options {
    /// The options with another tolerance.
    ///
    /// ```
    /// use gyrospec::simulate::Options;
    /// assert_eq!(Options::default().with_tolerance(1e-7)?.tolerance, 1e-7);
    /// assert!(Options::default().with_tolerance(2.0).is_err());
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// `Usage` for what is no share: not between 0 and 1.
    pub fn with_tolerance(self, share: f64) -> Result<Self> {
        if share > 0.0 && share < 1.0 {
            return Ok(Self { tolerance: share, ..self });
        }
        let says = format!("the tolerance {share} is no share of a standard deviation");
        Err(Error::usage(says).with_hint("give a number between 0 and 1, such as 1e-5"))
    }
}

impl Default for Options {
    fn default() -> Self {
        Self {
            tolerance: 1e-5,
            window: None,
            fixed: None,
            waits: true,
            budget: Budget::default(),
            planned: None,
        }
    }
}

/// Something that a run depends on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unknown {
    /// A parameter, by its number in the model.
    Parameter(usize),
    /// An initial state, by the state's number in the model.
    Initial(usize),
}

/// One run asked for.
#[derive(Clone)]
pub(super) struct Case<'a> {
    pub parameters: Vec<f64>,
    pub initials: &'a [f64],
    pub unknowns: &'a [Unknown],
    pub clocks: &'a [Clock],
}

/// One run.
#[derive(Debug, Clone)]
pub struct Trajectory {
    /// Predictions in SI, by output, at the times of the output; NaN where not covered.
    pub outputs: Vec<Vec<f64>>,
    /// By output, by unknown asked for, at the times of the output; empty where none were asked for.
    pub sensitivities: Vec<Vec<Vec<f64>>>,
    /// The solver's error as a share of the outputs' spread, by halving the step.
    pub solver_error: f64,
    /// The time and the state at which it blew up; what follows is NaN.
    pub blew_up: Option<(f64, usize)>,
    /// Number of events (switches that changed).
    pub events: usize,
}
