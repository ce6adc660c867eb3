//! One spectral integral.

use super::array;
use super::fault::PyResult;
use gyrospec::Error;
use gyrospec::integral::{Integrand, evaluate};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// What a pickle makes an integral of again: its type and the fields of it.
type Reduced<'py> = (Bound<'py, PyAny>, (f64, f64, f64, String));

/// A value of I_n with what is known of it.
#[pyclass(frozen, eq, module = "gyrospec")]
#[derive(PartialEq)]
pub struct Integral(gyrospec::Integral);

#[pymethods]
impl Integral {
    /// An answer from its fields, as pickle keeps them.
    #[staticmethod]
    fn _of(value: f64, error_bound: f64, condition: f64, method: &str) -> PyResult<Self> {
        let unknown = |_| Error::bad_input(format!("`{method}` is no method of the integral"));
        let method = serde_json::from_value(method.into()).map_err(unknown)?;
        Ok(Self(gyrospec::Integral { value, error_bound, condition, method }))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        let gyrospec::Integral { value, error_bound, condition, .. } = slf.get().0;
        Ok((slf.get_type().getattr("_of")?, (value, error_bound, condition, slf.get().method())))
    }

    /// The integral.
    #[getter]
    fn value(&self) -> f64 {
        self.0.value
    }

    /// abs(value - exact) <= error_bound for the doubles given, guaranteed.
    #[getter]
    fn error_bound(&self) -> f64 {
        self.0.error_bound
    }

    /// Relative change of the value by relative changes of the coefficients.
    #[getter]
    fn condition(&self) -> f64 {
        self.0.condition
    }

    /// The method that gave the value.
    #[getter]
    fn method(&self) -> String {
        let name = serde_json::to_value(self.0.method).unwrap_or_default();
        name.as_str().unwrap_or_default().to_owned()
    }

    /// The fields by name, as `gyrospec integral --json` has them.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("status", "ok")?;
        dict.set_item("value", self.0.value)?;
        dict.set_item("error_bound", self.0.error_bound)?;
        dict.set_item("condition", self.0.condition.is_finite().then_some(self.0.condition))?;
        dict.set_item("method", self.method())?;
        Ok(dict)
    }

    /// The line that `gyrospec integral --json` prints.
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
        let gyrospec::Integral { value, error_bound, condition, .. } = self.0;
        format!(
            "Integral(value={value:?}, error_bound={error_bound:.2e}, condition={condition:.4}, method='{}')",
            self.method()
        )
    }

    fn _repr_html_(&self) -> String {
        let gyrospec::Integral { value, error_bound, condition, .. } = self.0;
        format!(
            "<table><tr><th>value</th><td>{value:?}</td></tr><tr><th>error at most</th><td>{error_bound:.2e}</td></tr>\
             <tr><th>condition</th><td>{condition:.4}</td></tr><tr><th>method</th><td>{}</td></tr></table>",
            self.method()
        )
    }
}

/// The spectral integral I_n, within two units in the last place of the exact value.
///
/// I_n = 1/(2 pi) * integral of G(jw)/(H(jw) H(-jw)) over all w, the variance of noise behind a filter.
///
/// h: a0 a1 ... an of H(s) = a0 s^n + ... + an.
/// g: b0 ... b(n-1) of the even G(s) = b0 s^(2n-2) + b1 s^(2n-4) + ... + b(n-1).
/// c: instead of g, C with G(s) = C(s) C(-s), highest power first.
///
/// Without g and c, h is a stable system of one input and output, a transfer function or a state space of python-control or
/// SciPy: the variance of its output at white noise of the spectral density 1.
///
/// Raises InputError, UnstableError, ImaginaryAxisError, OutOfRangeError.
///
/// >>> integral([1, 2, 3], [0, 1]).value   # b1/(2 a1 a2)
/// 0.08333333333333333
#[pyfunction]
#[pyo3(signature = (h, g=None, *, c=None))]
pub fn integral(
    py: Python<'_>,
    h: &Bound<'_, PyAny>,
    g: Option<&Bound<'_, PyAny>>,
    c: Option<&Bound<'_, PyAny>>,
) -> PyResult<Integral> {
    if g.is_none() && c.is_none() {
        // polynomials of a system
        let both = py.import("gyrospec._linear").and_then(|m| m.call_method1("coefficients", (h,)))?;
        let (h, c) = (both.get_item(0)?, both.get_item(1)?);
        return integral(py, &h, None, Some(&c));
    }
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
