//! What a fit is asked to do.

use crate::estimate::least_squares::Stopping;
use crate::estimate::noise::NoiseModel;
use crate::simulate::{Budget, Planned};

/// Hears how far a long computation has come.
pub trait Progress: Sync {
    /// What is being done, and the share done so far where it is known.
    fn report(&self, stage: &str, share: Option<f64>);
}

/// Hears nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Progress for Silent {
    fn report(&self, _stage: &str, _share: Option<f64>) {}
}

/// How the residuals of several outputs, and of one output over time, are weighed.
#[derive(Debug, Clone, PartialEq)]
pub enum Weighting {
    /// The free-run error itself; each output over the size of its residual.
    FreeRun,
    /// Residuals whitened by frozen noise models, one an output in the model's order: generalised
    /// least squares, for likelihood ratios between models.
    Whitened(Vec<NoiseModel>),
}

/// How hard to look for the minimum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effort {
    /// From the values as they stand, nothing else: for refits near a known minimum.
    Near,
    /// All starts: given values, equation error, multiple shooting, drawn starts.
    Full,
}

/// What a fit is asked to do.
#[derive(Clone)]
pub struct FitOptions<'a> {
    /// How residuals are weighed.
    pub weighting: Weighting,
    /// How hard to look.
    pub effort: Effort,
    /// Starts that are drawn at random besides the reasoned ones.
    pub drawn_starts: usize,
    /// Seed of the drawn starts.
    pub seed: u64,
    /// When the walk stops.
    pub stopping: Stopping,
    /// Whether separate records are held out, so that fitted ones are used whole unless their file
    /// says otherwise.
    pub separate_holdout: bool,
    /// Share of an output's spread that the solver's error may reach; made finer by the fit where the
    /// noise turns out to be so small that it would show.
    pub tolerance: f64,
    /// Whether the solver keeps to that share whatever the noise: for fits that are only ranked.
    pub is_rough: bool,
    /// Whether what follows a gap of an input is left out until the model, at its own parameters, has
    /// forgotten the gap; else the gap alone is.
    pub waits: bool,
    /// Initial states to start from: one list a recording, one value a state; empty for none.
    pub initials: Vec<Vec<f64>>,
    /// Steps that did for much the same model, one a recording; empty for none.
    pub planned: Vec<Option<Planned>>,
    /// What the fit may spend; one fit alone spends it.
    pub budget: Budget,
    /// Who hears the progress.
    pub progress: &'a dyn Progress,
}

impl FitOptions<'_> {
    /// The same with nothing to end it early: for what is made of a fit.
    #[must_use]
    pub fn without_limit(&self) -> Self {
        Self { budget: Budget::default(), ..self.clone() }
    }
}

impl Default for FitOptions<'_> {
    fn default() -> Self {
        Self {
            weighting: Weighting::FreeRun,
            effort: Effort::Full,
            drawn_starts: 6,
            seed: 1,
            stopping: Stopping::default(),
            separate_holdout: false,
            tolerance: 1e-4,
            is_rough: false,
            waits: true,
            initials: Vec::new(),
            planned: Vec::new(),
            budget: Budget::default(),
            progress: &Silent,
        }
    }
}
