//! T and C₀ of a compass from measured errors.

use super::fault::PyResult;
use super::work::patiently;
use gyrospec::cli::identify::answer;
use pyo3::prelude::*;

/// The JSON that `gyrospec identify --json` prints, by its words.
#[pyfunction]
pub fn identify(py: Python<'_>, words: Vec<String>) -> PyResult<String> {
    patiently(py, move |_| answer(&words))
}
