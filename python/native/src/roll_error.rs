//! Mean and spread of the rolling error.

use super::fault::PyResult;
use super::model::Model;
use super::recording::Recording;
use super::told::Told;
use super::work::patiently;
use gyrospec::cli::roll_error::{Given, answer};
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;

/// A compass: a file or the name of a built-in model, or a model.
#[derive(FromPyObject)]
pub enum Compass<'py> {
    Model(PyRef<'py, Model>),
    Path(PathBuf),
}

#[pyfunction]
pub fn roll_error(
    py: Python<'_>,
    compass: Option<Compass<'_>>,
    recording: Option<PyRef<'_, Recording>>,
    options: Vec<String>,
) -> PyResult<Told> {
    let (path, text) = match compass {
        Some(Compass::Model(model)) => (None, Some(model.0.to_toml())),
        Some(Compass::Path(path)) => (Some(path), None),
        None => (None, None),
    };
    let recording = recording.map(|r| Arc::clone(&r.0));
    let answer = patiently(py, move |_| {
        answer(
            &options,
            &Given { path: path.as_deref(), text: text.as_deref(), recording: recording.as_deref() },
        )
    })?;
    let text = answer.text;
    let page = answer.html;
    Ok(Told {
        json: answer.json,
        warnings: Vec::new(),
        model: None,
        picture: answer.svg,
        text: Box::new(move || text.clone()),
        html: Box::new(move || page.clone()),
    })
}
