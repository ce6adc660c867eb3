//! Units as powers of the base units, and back.

use super::fault::PyResult;
use gyrospec::Error;
use gyrospec::units::{Dimension, Ratio, Unit};
use pyo3::prelude::*;

/// Powers of m, kg, s, A, K and mol of a unit; angles count as 1.
#[pyfunction]
pub fn powers(unit: &str) -> PyResult<[f64; 6]> {
    Ok(Unit::parse(unit)?.dimension().powers())
}

/// The SI unit of such powers.
#[pyfunction]
pub fn unit_of(powers: [f64; 6]) -> PyResult<String> {
    let mut whole = Dimension::NONE;
    for (base, power) in ["m", "kg", "s", "A", "K", "mol"].into_iter().zip(powers) {
        let power =
            Ratio::from_f64(power).ok_or_else(|| Error::bad_input("a power of a unit is no small ratio"))?;
        whole = whole.times(Unit::parse(base)?.dimension().power(power));
    }
    Ok(Unit::of(whole).text().to_owned())
}
