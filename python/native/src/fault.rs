//! Errors as Python exceptions, of one class a kind and with the text that the program prints.

use gyrospec::text::shown;
use gyrospec::{Error, ErrorKind};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The class in `gyrospec._errors` for a kind.
fn class(kind: ErrorKind) -> &'static str {
    match kind {
        ErrorKind::Usage => "UsageError",
        ErrorKind::Units => "UnitsError",
        ErrorKind::Io | ErrorKind::ClosedPipe => "FileError",
        ErrorKind::Unstable => "UnstableError",
        ErrorKind::ImaginaryAxis => "ImaginaryAxisError",
        ErrorKind::OutOfRange => "OutOfRangeError",
        ErrorKind::NotComputed => "NotComputedError",
        // a kind that is newer than this file is one of input
        _ => "InputError",
    }
}

fn exception<'py>(py: Python<'py>, e: &Error) -> Result<Bound<'py, PyAny>, PyErr> {
    let made = py.import("gyrospec._errors")?.getattr(class(e.kind()))?.call1((shown(&e.to_string()),))?;
    let data = PyDict::new(py);
    data.set_item("file", e.file())?;
    data.set_item("line", e.line())?;
    data.set_item("column", e.column())?;
    data.set_item("hint", e.hint())?;
    if let Some(count) = e.right_half_plane_roots() {
        data.set_item("right_half_plane_roots", count)?;
    }
    if let Some(decimal) = e.decimal() {
        data.set_item("decimal", decimal)?;
    }
    for (name, value) in data {
        made.setattr(name.cast::<pyo3::types::PyString>()?, value)?;
    }
    Ok(made)
}

/// What keeps a call from its answer: an error of the library or one of Python.
pub enum Fault {
    Own(Error),
    Python(PyErr),
}

/// The result of what Python calls.
pub type PyResult<T> = Result<T, Fault>;

impl From<Error> for Fault {
    fn from(e: Error) -> Self {
        Self::Own(e)
    }
}

impl From<PyErr> for Fault {
    fn from(e: PyErr) -> Self {
        Self::Python(e)
    }
}

impl From<Fault> for PyErr {
    fn from(fault: Fault) -> Self {
        match fault {
            Fault::Python(e) => e,
            Fault::Own(e) => {
                Python::attach(|py| exception(py, &e).map_or_else(|failure| failure, PyErr::from_value))
            }
        }
    }
}
