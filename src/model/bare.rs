//! Tables without units, as simulations write them: a model that knows the units of its signals reads them.

use super::Model;
use crate::record::{Raw, Recording, clocks_of, columns};
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
    if raw.is_empty() {
        return whole;
    }
    let first = raw.iter().position(|c| c.since.is_some()).unwrap_or(0);
    let mut text = "name = \"table\"\n".to_owned();
    for side in clocks_of(&raw, first, |_| false) {
        // dates and clocks have no unit
        let clock = &raw[side.clock.unwrap_or(first)];
        let unit = if clock.since.is_some() { None } else { Some(clock.unit.as_deref().unwrap_or("s")) };
        let unit = unit.map(|u| format!(", unit = {}", toml_string(u))).unwrap_or_default();
        let of_side = channels(&raw[side.columns], wanted);
        if !of_side.is_empty() {
            let _ = write!(
                text,
                "[[tables]]\nfile = {}\ntime = {{ column = {}{unit} }}\n[tables.channels]\n{of_side}",
                toml_string(&file.to_string_lossy()),
                toml_string(&clock.name),
            );
        }
    }
    let there = || raw.iter().skip(1).map(|c| c.name.as_str());
    let is_there = |w: &&Wanted| there().any(|name| name == w.name);
    for w in wanted.iter().filter(|w| !is_there(w)) {
        if let Some(e) = absent(&there().collect::<Vec<_>>(), &w.name) {
            return Err(e);
        }
    }
    let mut read = Recording::parse(&text, "").or_else(|e| whole.map_err(|_| e))?;
    // the first source is the text above, which is no file
    if read.sources.len() > 1 {
        read.sources.remove(0);
    }
    Ok(read)
}

/// The lines of the wanted columns that are there.
fn channels(raw: &[Raw], wanted: &[Wanted]) -> String {
    let own = |w: &Wanted| raw.iter().find(|c| c.name == w.name);
    let line = |(w, own): (&Wanted, &Raw)| {
        let unit = own.unit.as_deref().or(w.unit.as_deref())?;
        let (name, column) = (toml_string(&w.name), toml_string(&own.name));
        Some(format!("{name} = {{ column = {column}, unit = {} }}\n", toml_string(unit)))
    };
    wanted.iter().filter_map(|w| own(w).map(|own| (w, own))).filter_map(line).collect()
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
