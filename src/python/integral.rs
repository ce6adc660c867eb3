//! One spectral integral.

use super::array;
use crate::Error;
use crate::integral::{Answer, Integrand, evaluate};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// A value of I_n with what is known of it.
#[pyclass(frozen, module = "gyrospec")]
pub struct Integral(Answer);

#[pymethods]
impl Integral {
    #[getter]
    fn value(&self) -> f64 {
        self.0.value
    }

    #[getter]
    fn error_bound(&self) -> f64 {
        self.0.error_bound
    }

    #[getter]
    fn condition(&self) -> f64 {
        self.0.condition
    }

    #[getter]
    fn method(&self) -> String {
        let name = serde_json::to_value(self.0.method).unwrap_or_default();
        name.as_str().unwrap_or_default().to_owned()
    }

    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("status", "ok")?;
        dict.set_item("value", self.0.value)?;
        dict.set_item("error_bound", self.0.error_bound)?;
        dict.set_item("condition", self.0.condition.is_finite().then_some(self.0.condition))?;
        dict.set_item("method", self.method())?;
        Ok(dict)
    }

    fn to_json(&self) -> String {
        let mut answer = serde_json::json!({ "status": "ok" });
        answer["value"] = self.0.value.into();
        answer["error_bound"] = self.0.error_bound.into();
        answer["condition"] = self.0.condition.into();
        answer["method"] = self.method().into();
        answer.to_string()
    }

    fn __float__(&self) -> f64 {
        self.0.value
    }

    fn __repr__(&self) -> String {
        let Answer { value, error_bound, condition, .. } = self.0;
        format!(
            "Integral(value={value:?}, error_bound={error_bound:.2e}, condition={condition:.4}, method='{}')",
            self.method()
        )
    }

    fn _repr_html_(&self) -> String {
        let Answer { value, error_bound, condition, .. } = self.0;
        format!(
            "<table><tr><th>value</th><td>{value:?}</td></tr><tr><th>error at most</th><td>{error_bound:.2e}</td></tr>\
             <tr><th>condition</th><td>{condition:.4}</td></tr><tr><th>method</th><td>{}</td></tr></table>",
            self.method()
        )
    }
}

#[pyfunction]
#[pyo3(signature = (h, g=None, *, c=None))]
pub fn integral(
    py: Python<'_>,
    h: &Bound<'_, PyAny>,
    g: Option<&Bound<'_, PyAny>>,
    c: Option<&Bound<'_, PyAny>>,
) -> PyResult<Integral> {
    let h = array::row("h", h)?;
    let (is_square, numerator) = match (g, c) {
        (Some(g), None) => (false, array::row("g", g)?),
        (None, Some(c)) => (true, array::row("c", c)?),
        _ => return Err(Error::usage("give g or c, one of the two").into()),
    };
    let answer = py.detach(|| {
        evaluate(&if is_square {
            Integrand::from_square(&h, &numerator)?
        } else {
            Integrand::new(&h, &numerator)?
        })
    })?;
    Ok(Integral(answer))
}
