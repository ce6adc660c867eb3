//! Numbers that come in: NumPy arrays without copying, other rows of numbers by NumPy's own reading.

use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyUntypedArray};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

/// A short row of numbers: an array of doubles, or any sequence of numbers.
pub fn row(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    if given.cast::<PyUntypedArray>().is_ok() {
        return Ok(column(name, given)?.as_array().to_vec());
    }
    given.extract::<Vec<f64>>().map_err(|_| no_numbers(name, "a row of real numbers", given))
}

/// A column: the array itself where it holds doubles, else as NumPy converts it.
pub fn column<'py>(name: &str, given: &Bound<'py, PyAny>) -> PyResult<PyReadonlyArray1<'py, f64>> {
    refuse_masked(name, given)?;
    given
        .extract()
        .or_else(|_| as_doubles(given)?.extract())
        .map_err(|_| no_numbers(name, "a row of real numbers", given))
}

/// A table with one problem a row.
pub fn rows<'py>(name: &str, given: &Bound<'py, PyAny>) -> PyResult<PyReadonlyArray2<'py, f64>> {
    refuse_masked(name, given)?;
    given
        .extract()
        .or_else(|_| as_doubles(given)?.extract())
        .map_err(|_| no_numbers(name, "a table of real numbers with one problem a row", given))
}

/// Refuses a masked array: what lies behind a mask is no number.
fn refuse_masked(name: &str, given: &Bound<'_, PyAny>) -> PyResult<()> {
    if given.hasattr("mask")? && given.hasattr("filled")? {
        return Err(PyTypeError::new_err(format!(
            "{name} is a masked array: fill what is masked, or leave it out"
        )));
    }
    Ok(())
}

fn as_doubles<'py>(given: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let array = given.py().import("numpy")?.call_method1("asarray", (given,))?;
    // numbers alone: no texts that look like numbers, no complex numbers that lose a part
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    if !["i", "u", "f", "b"].contains(&kind.as_str()) {
        return Err(PyTypeError::new_err("no real numbers"));
    }
    array.call_method1("astype", ("float64",))
}

fn no_numbers(name: &str, wanted: &str, given: &Bound<'_, PyAny>) -> PyErr {
    let what = given.get_type().name().map_or_else(|_| "this".to_owned(), |n| n.to_string());
    let shape = given.getattr("shape").map(|s| format!(" of shape {s}")).unwrap_or_default();
    PyTypeError::new_err(format!("{name} must be {wanted}, not {what}{shape}"))
}
