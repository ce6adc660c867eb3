//! A model run on a recording.

use super::fault::PyResult;
use super::model::Model;
use super::recording::Recording;
use gyrospec::Error;
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use std::sync::Arc;

/// One run, in the units of the model.
#[pyclass(frozen, module = "gyrospec._gyrospec")]
pub struct Simulated(gyrospec::Simulated);

/// Time, measured, predicted, rms error and worst error of one output.
type Output<'py> =
    (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, f64, f64);

/// Name, unit and values of a state or a definition.
type Signal<'py> = (String, String, Bound<'py, PyArray1<f64>>);

#[pymethods]
impl Simulated {
    /// Names and units of the outputs that the recording measured.
    #[getter]
    fn outputs(&self) -> Vec<(String, String)> {
        self.0.outputs().map(|o| (o.name, o.unit)).collect()
    }

    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.0.warnings()
    }

    #[getter]
    fn solver_error(&self) -> f64 {
        self.0.solver_error()
    }

    #[getter]
    fn text(&self) -> String {
        self.0.text()
    }

    fn output<'py>(&self, py: Python<'py>, number: usize) -> PyResult<Output<'py>> {
        let unknown = || Error::usage(format!("there is no output {number}"));
        let o = self.0.outputs().nth(number).ok_or_else(unknown)?;
        Ok((
            o.time.into_pyarray(py),
            o.measured.into_pyarray(py),
            o.predicted.into_pyarray(py),
            o.rms_error,
            o.worst_error,
        ))
    }

    /// States and definitions at the given times: name, unit, values.
    fn trace<'py>(&self, py: Python<'py>, time: Vec<f64>) -> PyResult<Vec<Signal<'py>>> {
        let s = self.0.simulator();
        let trace = py.detach(|| s.trace(&s.parameters(), &s.initials(), time.into()))?;
        let m = s.model();
        let names = m.states.iter().map(|x| (&x.name, &x.unit));
        let names = names.chain(m.definitions.iter().map(|x| (&x.name, &x.unit)));
        let columns = trace.states.iter().chain(&trace.definitions);
        Ok(names
            .zip(columns)
            .map(|((name, unit), si)| {
                let values: Vec<f64> = si.iter().map(|v| unit.from_si(*v)).collect();
                (name.clone(), unit.text().to_owned(), values.into_pyarray(py))
            })
            .collect())
    }
}

#[pyfunction]
pub fn simulate(
    py: Python<'_>,
    model: PyRef<'_, Model>,
    recording: PyRef<'_, Recording>,
    tolerance: f64,
) -> PyResult<Simulated> {
    let (model, recording) = (Arc::clone(&model.0), Arc::clone(&recording.0));
    if tolerance.is_nan() || tolerance <= 0.0 {
        return Err(Error::usage("the tolerance must be a positive number, such as 1e-5").into());
    }
    let work = || gyrospec::simulate(&model, &recording).tolerance(tolerance).run();
    Ok(Simulated(py.detach(work)?))
}
