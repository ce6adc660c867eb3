//! What long work hands over: its JSON, its words, its page, the model that it ends with.

use super::model::Model;
use gyrospec::text::shown;
use pyo3::prelude::*;

/// Makes a text when it is asked for.
pub type Later = Box<dyn Fn() -> String + Send + Sync>;

/// The result of a fit, a diagnosis or a rolling error, before it has names in Python.
#[pyclass(frozen, module = "gyrospec._gyrospec")]
pub struct Told {
    pub json: String,
    pub warnings: Vec<String>,
    pub model: Option<Py<Model>>,
    /// A picture as SVG; empty where there is none.
    pub picture: String,
    pub text: Later,
    pub html: Later,
}

#[pymethods]
impl Told {
    #[getter]
    fn json(&self) -> &str {
        &self.json
    }

    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.warnings.iter().map(|w| shown(w).into_owned()).collect()
    }

    #[getter]
    fn model(&self, py: Python<'_>) -> Option<Py<Model>> {
        self.model.as_ref().map(|m| m.clone_ref(py))
    }

    #[getter]
    fn picture(&self) -> &str {
        &self.picture
    }

    fn text(&self, py: Python<'_>) -> String {
        py.detach(|| shown(&(self.text)()).into_owned())
    }

    fn html(&self, py: Python<'_>) -> String {
        py.detach(|| (self.html)())
    }
}
