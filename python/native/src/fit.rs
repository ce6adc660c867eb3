//! A model fitted to recordings.

use super::diagnose::{owned, seconds};
use super::fault::PyResult;
use super::model::Model;
use super::recording::Recording;
use super::told::Told;
use super::work::patiently;
use gyrospec::estimate::fit::{
    FitOptions, ascertain, fit as find, holdout as run_held_out, residual_spectra, setup,
};
use gyrospec::report::fit::{FitReport, json, page, text};
use gyrospec::simulate::Budget;
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
    let (fitted, json, text, page) = patiently(py, move |progress| {
        setup::keep_apart(&model, &recordings, &separate)?;
        let separate_holdout = !separate.is_empty();
        let budget = Budget::new(u64::MAX, time);
        let options = FitOptions { seed, separate_holdout, budget, progress, ..FitOptions::default() };
        let mut fitted = find(&model, &recordings, &options)?;
        if fitted.ended_early.is_none() {
            ascertain(&mut fitted, &recordings, &options.without_limit())?;
        }
        let held_out = run_held_out(&fitted, &recordings, &separate, &options.without_limit())?;
        let report = FitReport {
            fit: &fitted,
            source: &source,
            held_out: &held_out,
            recordings: &recordings,
            separate: &separate,
            spectra: &residual_spectra(&fitted),
            seed,
        };
        let (json, text, page) = (json(&report)?, text(&report), page(&report));
        Ok((fitted, json, text, page))
    })?;
    Ok(Told {
        json,
        warnings: fitted.warnings.iter().map(|w| w.says.clone()).collect(),
        model: Some(Py::new(py, Model::from(fitted.model))?),
        picture: String::new(),
        text: Box::new(move || text.clone()),
        html: Box::new(move || page.clone()),
    })
}
