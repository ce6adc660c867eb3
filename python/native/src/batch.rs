//! Many integrals of one order: a row of two arrays is a problem.

use super::array;
use super::fault::PyResult;
use gyrospec::integral::{Estimate, Integrand, MAX_ORDER, batch, evaluate};
use gyrospec::{Error, ErrorKind, Result};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use rayon::prelude::*;

/// Rows between two looks at the keyboard.
const BLOCK: usize = 1 << 16;

/// Values, bounds of their errors, and a status each.
type Columns<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u8>>);

/// The number that stands for a refusal, in the order of `IntegralBatch.STATUS`.
fn status(e: &Error) -> u8 {
    match e.kind() {
        ErrorKind::Unstable => 1,
        ErrorKind::ImaginaryAxis => 2,
        ErrorKind::OutOfRange => 3,
        ErrorKind::NotComputed => 5,
        _ => 4,
    }
}

#[pyfunction]
#[pyo3(signature = (h, g, *, fast=true))]
pub fn integral_batch<'py>(
    py: Python<'py>,
    h: &Bound<'py, PyAny>,
    g: &Bound<'py, PyAny>,
    fast: bool,
) -> PyResult<Columns<'py>> {
    let (h, g) = (array::rows("h", h)?, array::rows("g", g)?);
    let (h, g) = (h.as_array(), g.as_array());
    let (count, n) = (h.nrows(), g.ncols());
    if g.nrows() != count || h.ncols() != n + 1 || n == 0 || n > MAX_ORDER {
        return Err(Error::bad_input(format!(
            "h has the shape {:?} and g {:?}; problems of order n are rows of n + 1 and of n numbers, equally many",
            h.shape(),
            g.shape()
        ))
        .into());
    }
    // no copy where the rows lie one after the other
    let (h, g) = (h.as_standard_layout(), g.as_standard_layout());
    let (h, g) = (h.as_slice().unwrap_or_default(), g.as_slice().unwrap_or_default());
    let (mut value, mut bound) = (Vec::with_capacity(count), Vec::with_capacity(count));
    let mut statuses = Vec::with_capacity(count);
    for (h, g) in h.chunks(BLOCK * (n + 1)).zip(g.chunks(BLOCK * n)) {
        for answer in py.detach(|| block(n, h, g, fast))? {
            let (e, s) = match answer {
                Ok(estimate) => (estimate, 0),
                Err(e) => (Estimate { value: f64::NAN, error_bound: f64::NAN }, status(&e)),
            };
            value.push(e.value);
            bound.push(e.error_bound);
            statuses.push(s);
        }
        py.check_signals()?;
    }
    Ok((value.into_pyarray(py), bound.into_pyarray(py), statuses.into_pyarray(py)))
}

fn block(n: usize, h: &[f64], g: &[f64], fast: bool) -> Result<Vec<Result<Estimate>>> {
    if fast {
        return batch::evaluate_fast(n, h, g);
    }
    let exact = |(h, g): (&[f64], &[f64])| {
        let answer = evaluate(&Integrand::new(h, g)?)?;
        Ok(Estimate { value: answer.value, error_bound: answer.error_bound })
    };
    Ok(h.par_chunks(n + 1).zip(g.par_chunks(n)).map(exact).collect())
}
