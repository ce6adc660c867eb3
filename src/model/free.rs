//! Models without units: whoever wrote them gave none anywhere, so none is checked.

use super::form::Form;
use super::{Model, mockup};
use crate::Result;
use crate::record::{Channel, Recording};
use crate::units::Unit;

/// Whether a model file gives no unit at all, neither itself nor by what it begins with.
pub(super) fn says(root: &Form<'_>, begun: &Model) -> Result<bool> {
    if root.field("extends").is_some() || mockup::has_units(begun) {
        return Ok(false);
    }
    let mut is_any = false;
    for section in ["inputs", "parameters", "definitions", "states", "outputs"] {
        let Some(form) = root.table(section)? else { continue };
        for (_, _, fields) in form.tables()? {
            if fields.field("unit").is_some() {
                return Ok(false);
            }
            is_any = true;
        }
    }
    Ok(is_any || mockup::has(begun))
}

impl Model {
    /// A recording with the numbers of its table, where the model has no units; `None` where they are already so.
    pub(super) fn plainly(&self, recording: &Recording) -> Option<Recording> {
        let names = || self.inputs.iter().map(|i| &i.name).chain(self.outputs.iter().map(|o| &o.name));
        let is_plain = |c: &Channel| c.unit == Unit::one();
        if !self.is_free || names().filter_map(|n| recording.find(n)).all(is_plain) {
            return None;
        }
        let mut plain = recording.clone();
        let has = |c: &Channel| !is_plain(c) && names().any(|n| *n == c.name);
        for c in plain.channels.iter_mut().filter(|c| has(c)) {
            let unit = std::mem::replace(&mut c.unit, Unit::one());
            c.values = c.values.iter().map(|v| unit.from_si(*v)).collect();
        }
        Some(plain)
    }

    /// What a report says of a model without units.
    pub(crate) fn free_note(&self) -> Option<String> {
        const SAYS: &str =
            "the model gives no units: none is checked, and its numbers are those of the tables";
        self.is_free.then(|| SAYS.to_owned())
    }
}
