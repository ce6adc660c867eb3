//! A model, read once and used often.

use super::fault::PyResult;
use gyrospec::error::nearest;
use gyrospec::model;
use gyrospec::record::Source;
use gyrospec::units::Unit;
use gyrospec::{Error, Result};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyType};
use std::path::PathBuf;
use std::sync::Arc;

/// A model: inputs, parameters, definitions, states, outputs; read once, used often.
#[pyclass(frozen, eq, module = "gyrospec")]
pub struct Model(pub Arc<model::Model>, pub Source);

impl PartialEq for Model {
    /// Models are the same wherever they came from.
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl From<model::Model> for Model {
    /// A model that lies in memory; its name stands in angle brackets.
    fn from(model: model::Model) -> Self {
        let place = PathBuf::from(format!("<{}>", model.name));
        let source = Source::of(&place, model.to_toml().as_bytes());
        Self(Arc::new(model), source)
    }
}

#[pymethods]
impl Model {
    /// Reads a model file.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let (model, source) = py.detach(|| model::Model::read_with_source(&path))?;
        Ok(Self(Arc::new(model), source))
    }

    /// Reads the text of a model file.
    #[staticmethod]
    fn parse(py: Python<'_>, text: &str) -> PyResult<Self> {
        Ok(py.detach(|| model::Model::parse(text.trim_start_matches('\u{feff}')))?.into())
    }

    /// One of the models that come along; `Model.builtins()` lists them.
    #[staticmethod]
    fn builtin(name: &str) -> PyResult<Self> {
        Ok(model::Model::builtin(name)?.into())
    }

    /// Names of the models that come along.
    #[staticmethod]
    fn builtins() -> Vec<&'static str> {
        model::BUILTIN.iter().map(|(name, ..)| *name).collect()
    }

    /// Its name.
    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    /// Names of the measured signals that drive it.
    #[getter]
    fn inputs(&self) -> Vec<&str> {
        self.0.inputs.iter().map(|x| x.name.as_str()).collect()
    }

    /// Names of its states.
    #[getter]
    fn states(&self) -> Vec<&str> {
        self.0.states.iter().map(|x| x.name.as_str()).collect()
    }

    /// Names of the measured signals that it predicts.
    #[getter]
    fn outputs(&self) -> Vec<&str> {
        self.0.outputs.iter().map(|x| x.name.as_str()).collect()
    }

    /// Values of the parameters, in their units.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for p in &self.0.parameters {
            dict.set_item(&p.name, p.unit.decimal_from_si(p.value))?;
        }
        Ok(dict)
    }

    /// The unit of every input, parameter, definition, state and output.
    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (name, unit) in units(&self.0) {
            dict.set_item(name, unit.text())?;
        }
        Ok(dict)
    }

    /// The same model with other values of parameters, in their units.
    #[pyo3(signature = (**values))]
    fn replace(&self, values: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let mut model = model::Model::clone(&self.0);
        for (name, value) in values.into_iter().flatten() {
            set(&mut model, &name.extract::<String>()?, value.extract()?)?;
        }
        model.check()?;
        Ok(model.into())
    }

    /// The model as a file.
    fn to_toml(&self) -> String {
        self.0.to_toml()
    }

    fn __repr__(&self) -> String {
        let m = &self.0;
        format!(
            "Model('{}', {} inputs, {} parameters, {} states, {} outputs)",
            m.name,
            m.inputs.len(),
            m.parameters.len(),
            m.states.len(),
            m.outputs.len()
        )
    }

    fn _repr_html_(&self) -> String {
        format!("<pre>{}</pre>", gyrospec::report::svg::escaped(&self.0.to_toml()))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (String,))> {
        let class: Bound<'py, PyType> = slf.get_type();
        Ok((class.getattr("parse")?, (slf.get().to_toml(),)))
    }
}

/// The unit of everything that has one.
fn units(m: &model::Model) -> impl Iterator<Item = (&String, &Unit)> {
    let inputs = m.inputs.iter().map(|x| (&x.name, &x.unit));
    let parameters = m.parameters.iter().map(|x| (&x.name, &x.unit));
    let definitions = m.definitions.iter().map(|x| (&x.name, &x.unit));
    let states = m.states.iter().map(|x| (&x.name, &x.unit));
    let outputs = m.outputs.iter().map(|x| (&x.name, &x.unit));
    inputs.chain(parameters).chain(definitions).chain(states).chain(outputs)
}

/// Gives a parameter a value in its unit.
fn set(model: &mut model::Model, name: &str, value: f64) -> Result<()> {
    let names: Vec<String> = model.parameters.iter().map(|p| p.name.clone()).collect();
    let Some(p) = model.parameters.iter_mut().find(|p| p.name == name) else {
        let meant = nearest(name, names.iter().map(String::as_str));
        let hint = meant.map_or_else(String::new, |n| format!("did you mean {n}? "));
        return Err(Error::bad_input(format!("the model `{}` has no parameter `{name}`", model.name))
            .with_hint(format!("{hint}it has {}", names.join(", "))));
    };
    let si = p.unit.to_si(value);
    if !si.is_finite() || p.min.is_some_and(|min| si < min) || p.max.is_some_and(|max| si > max) {
        return Err(Error::bad_input(format!("the value {value} of {name} lies outside its bounds")));
    }
    p.value = si;
    Ok(())
}
