//! Mean and spread of the rolling error.

use super::fault::PyResult;
use super::model::Model;
use super::recording::Recording;
use super::told::Told;
use super::work::patiently;
use gyrospec::cli::roll_error::{Given, asked};
use gyrospec::gyro::elastic::PARTS;
use gyrospec::report::polar;
use gyrospec::report::rolling::{Sheet, card, json, page, text};
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;

/// A compass: a file or the name of a built-in model, or a model.
#[derive(FromPyObject)]
pub enum Compass<'py> {
    Model(PyRef<'py, Model>),
    Path(PathBuf),
}

/// The arguments that ask for an elastic part: name, names of its numbers (none for a switch), what it does.
#[pyfunction]
pub fn elastic_options() -> Vec<(String, &'static str, &'static str)> {
    let options = PARTS.iter().flat_map(|part| part.options);
    options.map(|o| (o.name.replace('-', "_"), o.numbers, o.help)).collect()
}

#[pyfunction]
pub fn roll_error(
    py: Python<'_>,
    compass: Option<Compass<'_>>,
    recording: Option<PyRef<'_, Recording>>,
    options: Vec<String>,
) -> PyResult<Told> {
    let (path, model) = match compass {
        Some(Compass::Model(model)) => (None, Some(model.0.to_toml())),
        Some(Compass::Path(path)) => (Some(path), None),
        None => (None, None),
    };
    let recording = recording.map(|r| Arc::clone(&r.0));
    let told = patiently(py, move |progress| {
        let given = Given { path: path.as_deref(), text: model.as_deref(), recording: recording.as_deref() };
        let (asked, seed) = asked(&options, &given)?;
        let table = asked.table(progress)?;
        let json = json(&table)?;
        // a point or two are no picture of a card
        let picture = card(&table).filter(|_| table.rows.len() > 2).map(|c| polar::svg(&c));
        Ok((Arc::new(table), seed, json, picture.unwrap_or_default()))
    })?;
    let (table, seed, json, picture) = told;
    let again = Arc::clone(&table);
    Ok(Told {
        json,
        warnings: Vec::new(),
        model: None,
        picture,
        text: Box::new(move || text(&again)),
        html: Box::new(move || {
            let formula = table.closed_form().map(|f| f.text());
            page(&Sheet { table: &table, every: 1, formula: formula.as_deref(), seed })
        }),
    })
}
