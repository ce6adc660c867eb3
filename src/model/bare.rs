//! Tables without units, as simulations write them: a model that knows the units of its signals reads them.

use super::Model;
use crate::record::{Recording, columns};
use crate::text::toml_string;
use crate::{Error, Result};
use std::fmt::Write;
use std::path::Path;

/// A column that is looked for, and its unit where the table gives none.
pub(super) struct Wanted {
    pub name: String,
    pub unit: Option<String>,
}

/// Reads a table as it stands, or, where columns have no unit, those that are wanted, with the time in s.
/// `absent` makes the error of a column that is not there, from the names of those that are.
///
/// # Errors
/// As [`Recording::read`]; a column that is not there.
pub(super) fn read(
    file: &Path,
    wanted: &[Wanted],
    absent: impl Fn(&[&str], &str) -> Option<Error>,
) -> Result<Recording> {
    let whole = Recording::read(file);
    if whole.as_ref().is_ok_and(|r| r.origins.len() != 1 || r.left_out.is_empty()) {
        return whole;
    }
    let Ok(raw) = columns(file) else { return whole };
    let Some(time) = raw.first() else { return whole };
    // dates and clocks have no unit
    let clock = raw.iter().find(|c| c.since.is_some()).unwrap_or(time);
    let unit = if clock.since.is_some() { None } else { Some(time.unit.as_deref().unwrap_or("s")) };
    let unit = unit.map(|u| format!(", unit = {}", toml_string(u))).unwrap_or_default();
    let mut text = format!(
        "name = \"table\"\n[[tables]]\nfile = {}\ntime = {{ column = {}{unit} }}\n[tables.channels]\n",
        toml_string(&file.to_string_lossy()),
        toml_string(&clock.name),
    );
    for w in wanted {
        let Some(own) = raw.iter().find(|c| c.name == w.name) else {
            let there: Vec<&str> = raw.iter().skip(1).map(|c| c.name.as_str()).collect();
            match absent(&there, &w.name) {
                Some(e) => return Err(e),
                None => continue,
            }
        };
        if let Some(unit) = own.unit.as_deref().or(w.unit.as_deref()) {
            let (name, column) = (toml_string(&w.name), toml_string(&own.name));
            let _ = writeln!(text, "{name} = {{ column = {column}, unit = {} }}", toml_string(unit));
        }
    }
    let mut read = Recording::parse(&text, "").or_else(|e| whole.map_err(|_| e))?;
    // the first source is the text above, which is no file
    if read.sources.len() > 1 {
        read.sources.remove(0);
    }
    Ok(read)
}

impl Model {
    /// Reads a recording of this model: one of a Functional Mock-up Unit or of a model without units may lack units.
    ///
    /// # Errors
    /// As [`Recording::read`].
    pub fn read_recording(&self, file: impl AsRef<Path>) -> Result<Recording> {
        let file = file.as_ref();
        if !(self.is_free || super::mockup::has(self)) || file == Path::new("-") {
            return Recording::read(file);
        }
        let inputs = self.inputs.iter().map(|i| (&i.name, &i.unit));
        let signals = inputs.chain(self.outputs.iter().map(|o| (&o.name, &o.unit)));
        let wanted: Vec<Wanted> = signals
            .map(|(name, unit)| Wanted { name: name.clone(), unit: Some(unit.text().to_owned()) })
            .collect();
        let mut read = read(file, &wanted, |_, _| None)?;
        if read.name == "table" {
            read.name = file.file_stem().map_or_else(String::new, |s| s.to_string_lossy().into_owned());
        }
        Ok(read)
    }
}
