//! Tables of I_n with letters.

use super::fault::PyResult;
use gyrospec::symbolic::{print_tables, read_orders};
use pyo3::prelude::*;

#[pyfunction]
pub fn table(py: Python<'_>, orders: &str, format: &str) -> PyResult<String> {
    Ok(py.detach(|| print_tables(read_orders(orders)?, format.parse()?))?)
}
