//! A recording: read from a file, or made of columns of numbers.

use super::array;
use super::fault::PyResult;
use gyrospec::record::{self, Channel, Constant, Hold, Kind, Source, Span};
use gyrospec::units::{Dimension, Unit};
use gyrospec::{Error, ErrorKind, Result};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use sha2::{Digest, Sha256};
use std::path::PathBuf;
use std::sync::Arc;

/// Measured signals on one clock, or a table of steady trials.
#[pyclass(frozen, module = "gyrospec")]
pub struct Recording(pub Arc<record::Recording>);

/// A column as Python hands it over: name, unit, values, whether it wraps, whether it holds.
type Column<'py> = (String, String, Bound<'py, PyAny>, bool, bool);

/// The times and the values of a channel.
type Samples<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

/// What is known of a recording besides its columns.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct Known {
    fit: Vec<(f64, f64)>,
    holdout: Vec<(f64, f64)>,
    constants: Vec<(String, f64, String)>,
}

#[pymethods]
impl Recording {
    /// Reads a CSV file, an NMEA 0183 log, or a TOML file that names its tables.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        Ok(Self(Arc::new(py.detach(|| record::Recording::read(&path))?)))
    }

    /// Makes a recording of columns; without time they are trials.
    #[staticmethod]
    fn of_columns(
        name: String,
        time: Option<(Bound<'_, PyAny>, String, String)>,
        columns: Vec<Column<'_>>,
        known: Known,
    ) -> PyResult<Self> {
        let kind = if time.is_some() { Kind::Time } else { Kind::Trials };
        let time: Arc<[f64]> = if let Some((values, unit, name)) = &time {
            seconds(&array::column("the time", values)?, unit, name)?.into()
        } else {
            let rows = columns.first().map_or(Ok(0), |c| c.2.len())?;
            (0..rows).map(|i| i as f64).collect()
        };
        let channels = columns.iter().map(|c| channel(c, &time)).collect::<PyResult<Vec<_>>>()?;
        Ok(Self(Arc::new(made(name, kind, channels, known)?)))
    }

    /// Its name in reports.
    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    /// "time" or "trials".
    #[getter]
    fn kind(&self) -> &'static str {
        if self.0.kind == Kind::Trials { "trials" } else { "time" }
    }

    /// Names of its channels.
    #[getter]
    fn channels(&self) -> Vec<&str> {
        self.0.channels.iter().map(|c| c.name.as_str()).collect()
    }

    /// The unit of each channel.
    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for c in &self.0.channels {
            dict.set_item(&c.name, c.unit.text())?;
        }
        Ok(dict)
    }

    /// Its files, each with its SHA-256; what came from memory stands in angle brackets.
    #[getter]
    fn sources(&self) -> Vec<(String, &str)> {
        self.0.sources.iter().map(|s| (s.file.display().to_string(), s.sha256.as_str())).collect()
    }

    /// What was noticed while it was read.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.0.notes.iter().map(ToString::to_string).collect()
    }

    /// Times in s (row numbers of trials) and values of a channel in its unit; NaN is a gap.
    fn channel<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Samples<'py>> {
        let c = self.0.channel(name)?;
        let values: Vec<f64> = c.values.iter().map(|v| c.unit.from_si(*v)).collect();
        Ok((c.time.to_vec().into_pyarray(py), values.into_pyarray(py)))
    }

    fn __repr__(&self) -> String {
        let all: Vec<String> =
            self.0.channels.iter().map(|c| format!("{} [{}] x {}", c.name, c.unit, c.len())).collect();
        format!("Recording('{}', {})", self.0.name, all.join(", "))
    }
}

/// Times in s.
fn seconds(values: &numpy::PyReadonlyArray1<'_, f64>, unit: &str, name: &str) -> Result<Vec<f64>> {
    let unit = Unit::parse(unit).map_err(|e| e.about(&format!("the column of time, `{name}`")))?;
    if unit.dimension() != Dimension::TIME {
        let says = format!("`{name}` is taken for the time, but it is in {unit}, which is no unit of time");
        return Err(Error::new(ErrorKind::Units, says).with_hint(
            "the first column is the time; else say which one is: time='...' (a frame's index by its name)",
        ));
    }
    Ok(values.as_array().iter().map(|t| unit.to_si(*t)).collect())
}

fn channel((name, unit, values, wraps, previous): &Column<'_>, time: &Arc<[f64]>) -> PyResult<Channel> {
    let about = format!("the column `{name}`");
    let unit = Unit::parse(unit).map_err(|e| e.about(&about))?;
    let values = array::column(&about, values)?;
    // the one copy: into SI
    let mut values: Vec<f64> = values.as_array().iter().map(|v| unit.to_si(*v)).collect();
    if let Some(row) = values.iter().position(|v| v.is_infinite()) {
        return Err(Error::bad_input(format!("{about} is infinite in row {row}"))
            .with_hint("a gap is NaN")
            .into());
    }
    if *wraps {
        if unit.dimension() != Dimension::NONE {
            return Err(Error::new(ErrorKind::Units, format!("{about} wraps, but {unit} is no angle")).into());
        }
        record::unwrap(&mut values);
    }
    let mut channel = Channel::new(name, unit, Arc::clone(time), values);
    channel.wraps = *wraps;
    channel.hold = if *previous { Hold::Previous } else { Hold::Linear };
    Ok(channel)
}

fn made(name: String, kind: Kind, channels: Vec<Channel>, known: Known) -> Result<record::Recording> {
    let source = Source { file: PathBuf::from(format!("<{name}>")), sha256: hash(&channels) };
    let at_pace = |c| if kind == Kind::Trials { c } else { record::at_its_pace(c) };
    let channels = channels.into_iter().map(at_pace).collect();
    let mut recording = record::Recording::from_channels(name, channels)?.with_kind(kind);
    recording.sources.push(source);
    if !(known.fit.is_empty() && known.holdout.is_empty()) {
        recording = recording.with_spans(spans(known.fit, "fitted")?, spans(known.holdout, "held out")?);
        apart(&recording)?;
    }
    for (name, value, unit) in known.constants {
        let unit = Unit::parse(&unit).map_err(|e| e.about(&format!("the constant `{name}`")))?;
        recording.constants.push(Constant { name, value: unit.to_si(value), unit });
    }
    Ok(recording)
}

fn spans(given: Vec<(f64, f64)>, used: &str) -> Result<Vec<Span>> {
    let mut spans: Vec<Span> = Vec::new();
    for (from, to) in given {
        if !(from.is_finite() && to.is_finite() && from <= to) {
            return Err(Error::bad_input(format!("[{from}, {to}] is no span")).with_hint("from < to"));
        }
        let own = Span::new(from, to);
        if let Some(both) = spans.iter().find_map(|s| s.overlap(&own)) {
            return Err(both.twice(used));
        }
        spans.push(own);
    }
    spans.sort_by(|a, b| a.from.total_cmp(&b.from));
    Ok(spans)
}

/// Nothing is both fitted and held out.
fn apart(recording: &record::Recording) -> Result<()> {
    let spans = &recording.spans;
    match spans.holdout.iter().find_map(|h| spans.fit.iter().find_map(|f| f.overlap(h))) {
        Some(both) => {
            Err(Error::bad_input(format!("{} to {} is both fitted and held out", both.from, both.to)))
        }
        None => Ok(()),
    }
}

/// A hash of the numbers and of what they mean.
fn hash(channels: &[Channel]) -> String {
    let mut hash = Sha256::new();
    for c in channels {
        hash.update(format!("{} [{}]\n", c.name, c.unit));
        for x in c.time.iter().chain(&c.values) {
            hash.update(x.to_le_bytes());
        }
    }
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
