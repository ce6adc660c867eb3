//! A model fitted to recordings.

use super::diagnose::{owned, seconds};
use super::fault::PyResult;
use super::model::Model;
use super::recording::Recording;
use super::told::Told;
use super::work::patiently;
use pyo3::prelude::*;
use std::sync::Arc;

#[pyfunction]
pub fn fit(
    py: Python<'_>,
    model: PyRef<'_, Model>,
    recordings: Vec<PyRef<'_, Recording>>,
    holdout: Vec<PyRef<'_, Recording>>,
    seed: u64,
    time_limit: Option<f64>,
) -> PyResult<Told> {
    let (model, source) = (Arc::clone(&model.0), model.1.clone());
    let (recordings, separate) = (owned(&recordings), owned(&holdout));
    let time = time_limit.map(seconds).transpose()?;
    let (model, warnings, json, text, page) = patiently(py, move |progress| {
        let asked = gyrospec::fit(&model, &recordings)
            .holdout(&separate)
            .seed(seed)
            .source(&source)
            .progress(progress)
            .time_limit(time);
        let fitted = asked.run()?;
        let warnings = fitted.warnings().map(str::to_owned).collect();
        Ok((fitted.model().clone(), warnings, fitted.json()?, fitted.text(), fitted.html()))
    })?;
    Ok(Told {
        json,
        warnings,
        model: Some(Py::new(py, Model::from(model))?),
        picture: String::new(),
        text: Box::new(move || text.clone()),
        html: Box::new(move || page.clone()),
    })
}
