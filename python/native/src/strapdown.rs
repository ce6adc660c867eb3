//! What vibration and noise do to a strapdown system.

use super::fault::PyResult;
use super::work::patiently;
use gyrospec::cli::strapdown::answer;
use pyo3::prelude::*;

/// The JSON that `gyrospec strapdown --json` prints, by its options.
#[pyfunction]
pub fn strapdown(py: Python<'_>, options: Vec<String>) -> PyResult<String> {
    patiently(py, move |_| answer(&options))
}
