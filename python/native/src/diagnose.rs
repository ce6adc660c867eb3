//! What a model leaves out.

use super::fault::PyResult;
use super::model::Model;
use super::recording::Recording;
use super::told::Told;
use super::work::patiently;
use gyrospec::record;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::sync::Arc;
use std::time::Duration;

/// The recordings themselves.
pub fn owned(recordings: &[PyRef<'_, Recording>]) -> Vec<record::Recording> {
    recordings.iter().map(|r| record::Recording::clone(&r.0)).collect()
}

/// A wall time from a number of seconds.
pub fn seconds(time: f64) -> PyResult<Duration> {
    let refused = || PyValueError::new_err("time_limit is a number of seconds above 0");
    Ok(Duration::try_from_secs_f64(time).ok().filter(|t| !t.is_zero()).ok_or_else(refused)?)
}

#[pyfunction]
pub fn diagnose(
    py: Python<'_>,
    model: PyRef<'_, Model>,
    recordings: Vec<PyRef<'_, Recording>>,
    holdout: Vec<PyRef<'_, Recording>>,
    seed: u64,
    time_limit: Option<f64>,
) -> PyResult<Told> {
    let (model, source) = (Arc::clone(&model.0), model.1.clone());
    let (recordings, separate) = (owned(&recordings), owned(&holdout));
    let time_limit = time_limit.map(seconds).transpose()?;
    let (found, json) = patiently(py, move |progress| {
        let asked = gyrospec::diagnose(&model, &recordings)
            .holdout(&separate)
            .seed(seed)
            .source(&source)
            .progress(progress)
            .time_limit(time_limit);
        let found = asked.run()?;
        let json = found.json()?;
        Ok((Arc::new(found), json))
    })?;
    let again = Arc::clone(&found);
    Ok(Told {
        json,
        warnings: found.notes().to_vec(),
        model: Some(Py::new(py, Model::from(found.model().clone()))?),
        picture: String::new(),
        text: Box::new(move || again.text()),
        html: Box::new(move || found.html()),
    })
}
