//! What a fit and a diagnosis are asked with.

use crate::diagnose::Request;
use crate::estimate::fit::{Progress, Silent};
use crate::model::Model;
use crate::record::{Recording, Source};
use std::fmt;
use std::marker::PhantomData;
use std::time::Duration;

/// Work on a model and recordings that is asked for; its `run` gives an `R`. See [`fit`](crate::fit) and
/// [`diagnose`](fn@crate::diagnose).
pub struct Asking<'a, R> {
    pub(super) request: Request<'a>,
    gives: PhantomData<fn() -> R>,
}

impl<'a, R> Asking<'a, R> {
    pub(super) fn new(model: &'a Model, recordings: &'a [Recording]) -> Self {
        let request = Request {
            model,
            source: None,
            recordings,
            separate: &[],
            seed: 1,
            time_limit: None,
            progress: &Silent,
        };
        Self { request, gives: PhantomData }
    }

    /// Recordings that are held out whole; the others are then fitted whole, unless they say otherwise.
    #[must_use]
    pub fn holdout(mut self, recordings: &'a [Recording]) -> Self {
        self.request.separate = recordings;
        self
    }

    /// Seed of everything random; 1 unless told.
    #[must_use]
    pub fn seed(mut self, seed: u64) -> Self {
        self.request.seed = seed;
        self
    }

    /// Wall time after which the search ends with the best so far, and says so; the same inputs then no longer give
    /// the same bytes.
    #[must_use]
    pub fn time_limit(mut self, limit: impl Into<Option<Duration>>) -> Self {
        self.request.time_limit = limit.into();
        self
    }

    /// Who hears how far it has come.
    #[must_use]
    pub fn progress(mut self, progress: &'a dyn Progress) -> Self {
        self.request.progress = progress;
        self
    }

    /// The file of the model, for the list of inputs in a report.
    #[must_use]
    pub fn source(mut self, source: &'a Source) -> Self {
        self.request.source = Some(source);
        self
    }
}

impl<R> fmt::Debug for Asking<'_, R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Asking").field("model", &self.request.model.name).finish_non_exhaustive()
    }
}
