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
pub struct Simulated {
    ran: gyrospec::Simulated,
    warnings: Vec<String>,
}

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
        self.ran.outputs().map(|o| (o.name().to_owned(), o.unit().to_owned())).collect()
    }

    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.warnings.clone()
    }

    #[getter]
    fn solver_error(&self) -> f64 {
        self.ran.solver_error()
    }

    #[getter]
    fn text(&self) -> String {
        self.ran.text()
    }

    fn output<'py>(&self, py: Python<'py>, number: usize) -> PyResult<Output<'py>> {
        let unknown = || Error::usage(format!("there is no output {number}"));
        let o = self.ran.outputs().nth(number).ok_or_else(unknown)?;
        let (rms, worst) = o.errors();
        let measured: Vec<f64> = o.measured().collect();
        let predicted: Vec<f64> = o.predicted().collect();
        Ok((
            o.time().to_vec().into_pyarray(py),
            measured.into_pyarray(py),
            predicted.into_pyarray(py),
            rms,
            worst,
        ))
    }

    /// States and definitions at the given times: name, unit, values.
    fn trace<'py>(&self, py: Python<'py>, time: Vec<f64>) -> PyResult<Vec<Signal<'py>>> {
        let s = self.ran.simulator();
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
    let (model, mut recording) = (Arc::clone(&model.0), Arc::clone(&recording.0));
    let mut warnings = Vec::new();
    if model.outputs.iter().any(|o| recording.find(&o.name).is_none()) {
        warnings = model.foresee(Arc::make_mut(&mut recording));
    }
    let work = || gyrospec::simulate(&model, &recording).tolerance(tolerance).run();
    let ran = py.detach(work)?;
    warnings.extend(ran.warnings());
    Ok(Simulated { ran, warnings })
}
