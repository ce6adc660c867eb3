//! The mean rolling error of many compasses on many rolls at once.

use super::array;
use super::fault::PyResult;
use gyrospec::gyro::{Gyrosphere, sweep};
use gyrospec::spectrum::Roll;
use gyrospec::{Error, Result};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::BTreeMap;

/// Cases between two looks at the keyboard.
const BLOCK: usize = 1 << 16;

/// The mean error in rad of each row; columns in SI, by the names of the symbol table, and what
/// no column gives is the paper's compass. NaN where a row has no error.
#[pyfunction]
pub fn roll_error_sweep<'py>(
    py: Python<'py>,
    columns: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let mut given: BTreeMap<String, PyReadonlyArray1<'py, f64>> = BTreeMap::new();
    for (name, values) in columns {
        let name: String = name.extract()?;
        let values = array::column(&format!("the column `{name}`"), &values)?;
        given.insert(name, values);
    }
    let views: Vec<_> = given.iter().map(|(name, values)| (name.as_str(), values.as_array())).collect();
    let count = views.first().map_or(0, |v| v.1.len());
    if let Some((name, other)) = views.iter().find(|v| v.1.len() != count) {
        let text = format!("the column `{name}` has {} rows, `{}` {count}", other.len(), views[0].0);
        return Err(Error::bad_input(text).into());
    }
    let mut errors = Vec::with_capacity(count);
    for from in (0..count).step_by(BLOCK) {
        let to = (from + BLOCK).min(count);
        let part = py.detach(|| -> Result<Vec<f64>> {
            let cases = (from..to).map(|row| case(&views, row)).collect::<Result<Vec<_>>>()?;
            Ok(sweep(&cases)?.into_iter().map(|e| e.unwrap_or(f64::NAN)).collect())
        })?;
        errors.extend(part);
        py.check_signals()?;
    }
    Ok(errors.into_pyarray(py))
}

type View<'a> = (&'a str, numpy::ndarray::ArrayView1<'a, f64>);

/// What the mean error by the elastic lag does not depend on.
const IDLE: [&str; 3] = ["lP", "C", "F"];

fn case(columns: &[View<'_>], row: usize) -> Result<(Gyrosphere, Roll, f64)> {
    let (mut sphere, mut roll, mut heading) = gyrospec::gyro::seed::example_3_1();
    for (name, values) in columns {
        let place = match *name {
            "heading" => Some(&mut heading),
            idle if IDLE.contains(&idle) => None,
            _ => sphere.named(name).or_else(|| roll.named(name)),
        };
        *place.ok_or_else(|| unknown(name))? = values[row];
    }
    Ok((sphere, roll, heading))
}

fn unknown(name: &str) -> Error {
    let all = Gyrosphere::NAMES.into_iter().filter(|n| !IDLE.contains(n));
    let all: Vec<&str> = all.chain(Roll::NAMES).chain(["heading"]).collect();
    let meant = gyrospec::error::nearest(name, all.iter().copied())
        .map(|n| format!("did you mean {n}? "))
        .unwrap_or_default();
    Error::bad_input(format!("the mean rolling error does not depend on `{name}`"))
        .with_hint(format!("{meant}it depends on {}", all.join(", ")))
}
