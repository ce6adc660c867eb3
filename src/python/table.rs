//! Tables of I_n with letters.

use crate::cli::table as command;
use pyo3::prelude::*;

#[pyfunction]
pub fn table(py: Python<'_>, orders: &str, format: &str) -> PyResult<String> {
    Ok(py.detach(|| command::text(orders, format))?)
}
