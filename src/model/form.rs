//! The TOML tables of a model file, with places and with the nearest key for an unknown one.

use super::places::Text;
use crate::error::nearest;
use crate::text::is_lost;
use crate::{Error, Result};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value of the file.
pub(super) struct Field<'a> {
    pub key: &'a str,
    key_span: Range<usize>,
    pub span: Range<usize>,
    value: &'a DeValue<'a>,
}

/// A table of the file, its fields in the order of the file.
pub(super) struct Form<'a> {
    pub path: String,
    pub fields: Vec<Field<'a>>,
    text: &'a Text<'a>,
    span: Range<usize>,
}

/// Reads the text as TOML.
pub(super) fn toml<'a>(text: &Text<'a>) -> Result<Spanned<DeTable<'a>>> {
    DeTable::parse(text.0).map_err(|e| {
        let mut error = Error::bad_input(format!("this is no TOML: {}", e.message().trim()));
        let first = text.0.lines().find(|l| !l.trim().is_empty()).unwrap_or_default();
        if first.contains(',') && !first.contains('=') {
            error = error.with_hint("it looks like a CSV file: a model comes first, then its recording");
        }
        e.span().map_or(error.clone(), |span| text.at(error, &span))
    })
}

impl<'a> Form<'a> {
    /// The whole file.
    pub fn root(table: &'a Spanned<DeTable<'a>>, text: &'a Text<'a>) -> Self {
        Self::of(String::new(), table.get_ref(), table.span(), text)
    }

    fn of(path: String, table: &'a DeTable<'a>, span: Range<usize>, text: &'a Text<'a>) -> Self {
        let mut fields: Vec<Field<'a>> = table
            .iter()
            .map(|(k, v)| Field { key: k.get_ref(), key_span: k.span(), span: v.span(), value: v.get_ref() })
            .collect();
        fields.sort_by_key(|f| f.key_span.start);
        Self { path, fields, text, span }
    }

    /// Refuses keys that are not known.
    pub fn allow(&self, known: &[&str]) -> Result<()> {
        match self.fields.iter().find(|f| !known.contains(&f.key)) {
            None => Ok(()),
            Some(f) => {
                let place = if self.path.is_empty() { "a model file".into() } else { self.path.clone() };
                let e = Error::bad_input(format!("{place} has no key {:?}", f.key));
                let e = match nearest(f.key, known.iter().copied()) {
                    Some(near) => e.with_hint(format!("the nearest known key is {near}")),
                    None => e.with_hint(format!("known keys are {}", known.join(", "))),
                };
                Err(self.text.at(e, &f.key_span))
            }
        }
    }

    /// The tables inside this one, by name.
    pub fn tables(&self) -> Result<Vec<(&'a str, Range<usize>, Form<'a>)>> {
        self.fields
            .iter()
            .map(|f| Ok((f.key, f.key_span.clone(), self.table(f.key)?)))
            .map(|entry| entry.map(|(key, span, form)| form.map(|form| (key, span, form))))
            .filter_map(Result::transpose)
            .collect()
    }

    /// The table of that name inside this one, if there is one.
    pub fn table(&self, name: &str) -> Result<Option<Form<'a>>> {
        let Some(f) = self.field(name) else { return Ok(None) };
        match f.value {
            DeValue::Table(t) => Ok(Some(Form::of(self.path_of(name), t, f.span.clone(), self.text))),
            _ => Err(self.wrong(f, "a table: { … }")),
        }
    }

    /// Whether that key holds a table.
    pub fn is_table(&self, key: &str) -> bool {
        self.field(key).is_some_and(|f| matches!(f.value, DeValue::Table(_)))
    }

    /// The dotted path of a key.
    pub fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_string() } else { format!("{}.{key}", self.path) }
    }

    /// The field of that key.
    pub fn field(&self, key: &str) -> Option<&Field<'a>> {
        self.fields.iter().find(|f| f.key == key)
    }

    /// The error with the place of a span.
    #[cfg(feature = "fmu")]
    pub fn at(&self, e: Error, span: &Range<usize>) -> Error {
        self.text.at(e, span)
    }

    fn wrong(&self, f: &Field<'_>, wanted: &str) -> Error {
        let found = match f.value {
            DeValue::Float(x) => x.as_str().to_owned(),
            other => format!("a value of type {}", other.type_str()),
        };
        let e = Error::bad_input(format!("{} must be {wanted}, not {found}", self.path_of(f.key)));
        self.text.at(e, &f.span)
    }

    /// A string.
    pub fn string(&self, key: &str) -> Result<Option<&'a str>> {
        let Some(f) = self.field(key) else { return Ok(None) };
        f.value.as_str().map(Some).ok_or_else(|| self.wrong(f, "a string in quotes"))
    }

    /// A finite number, written whole or with a point.
    pub fn number(&self, key: &str) -> Result<Option<f64>> {
        let Some(f) = self.field(key) else { return Ok(None) };
        let value = match f.value {
            DeValue::Integer(i) => i64::from_str_radix(i.as_str(), i.radix()).ok().map(|i| i as f64),
            DeValue::Float(x) if is_lost(x.as_str()) => {
                return Err(self.wrong(f, "0 or a number that is not as near to it"));
            }
            DeValue::Float(x) => x.as_str().parse().ok(),
            _ => None,
        };
        value.filter(|v| v.is_finite()).map(Some).ok_or_else(|| self.wrong(f, "a finite number"))
    }

    /// true or false.
    pub fn flag(&self, key: &str) -> Result<Option<bool>> {
        let Some(f) = self.field(key) else { return Ok(None) };
        f.value.as_bool().map(Some).ok_or_else(|| self.wrong(f, "true or false"))
    }

    /// An error at a key, or at the table where the key is missing.
    pub fn error(&self, key: &str, e: Error) -> Error {
        let span = self.field(key).map_or(&self.span, |f| &f.span);
        self.text.at(e, span)
    }

    /// The error of a key that must be there.
    pub fn missing(&self, key: &str, example: &str) -> Error {
        let e = Error::bad_input(format!("{} has no {key}", self.path)).with_hint(format!("add {example}"));
        self.error(key, e)
    }
}
