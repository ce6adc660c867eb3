//! What is wanted of a log.

use super::known;
use crate::record::request::Wanted;
use crate::units::Unit;
use crate::{Error, ErrorKind, Result};

/// What is wanted of a log.
pub(in crate::record) struct Request {
    /// The zero of time in nanoseconds since 1970; without it the first stamp is zero.
    pub zero: Option<i128>,
    /// Nothing means every field that is known here.
    pub wanted: Vec<Selection>,
    /// Number of the table in the recording.
    pub table: usize,
}

/// One field of one sort of sentence.
#[derive(Debug, Clone)]
pub(in crate::record) struct Selection {
    pub(super) wanted: Wanted,
    pub(super) unit: Unit,
    pub(super) field: usize,
    pub(super) id: Option<u32>,
    pub(super) form: known::Form,
}

impl Selection {
    /// A selection, checked against what is known of its sentence.
    pub(in crate::record) fn new(wanted: Wanted, field: usize, id: Option<u32>) -> Result<Self> {
        let sentence = wanted.column.clone();
        if field == 0 {
            return Err(Error::bad_input("fields count from 1, after the sentence's name"));
        }
        if let (true, None) = (known::is_numbered(&sentence), id) {
            return Err(Error::bad_input(format!("{sentence} comes in several sorts, by its number"))
                .with_hint("write id = 20, 22 or 23"));
        }
        if let (true, Some(id)) = (field == 1, id) {
            return Err(Error::bad_input(format!("field 1 of {sentence} is its number, {id}"))
                .with_hint("the first value after it is field 2"));
        }
        let known = known::field(&sentence, id, field);
        let own = known.map(|k| Unit::parse(k.unit)).transpose()?;
        if let (Some(given), Some(own)) = (&wanted.unit, &own) {
            own.turns_or_radians(given).map_err(|e| e.about(&format!("field {field} of {sentence}")))?;
        }
        let unit = match (wanted.unit.clone(), own) {
            (Some(unit), Some(own)) if unit.dimension() != own.dimension() => {
                return Err(Error::new(
                    ErrorKind::Units,
                    format!("field {field} of {sentence} is in {own}, not in {unit}"),
                )
                .with_hint(known::listing(&sentence, id)));
            }
            (Some(unit), _) | (None, Some(unit)) => unit,
            (None, None) => {
                return Err(Error::bad_input(format!("channel `{}` has no unit", wanted.name))
                    .with_hint("write unit = \"deg\", or \"1\" for none"));
            }
        };
        let form = known.map_or(known::Form::Number, |k| k.form);
        if let Some(fixed) = form.unit()
            && unit.to_si(1.0) != Unit::parse(fixed)?.to_si(1.0)
        {
            return Err(Error::new(
                ErrorKind::Units,
                format!("field {field} of {sentence} is read in {fixed}"),
            )
            .with_hint(format!("write unit = \"{fixed}\"")));
        }
        if wanted.wraps && !unit.dimension().is_none() {
            return Err(Error::bad_input(format!("`{}` in [{unit}] cannot wrap at a turn", wanted.name))
                .with_hint("wraps = true is for angles"));
        }
        Ok(Self { wanted, unit, field, id, form })
    }
}
