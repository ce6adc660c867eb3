//! A compass with a liquid ballistic.

use super::fault::PyResult;
use super::work::patiently;
use gyrospec::cli::pendulous::answer;
use pyo3::prelude::*;

/// The JSON that `gyrospec pendulous --json` prints, by its options.
#[pyfunction]
pub fn pendulous(py: Python<'_>, options: Vec<String>) -> PyResult<String> {
    patiently(py, move |_| answer(&options))
}
