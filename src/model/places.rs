//! Where things stand in a model file, so that an error can point there.

use crate::Error;
use std::collections::BTreeMap;
use std::ops::Range;

/// Lines and columns of a text.
pub(super) struct Text<'a>(pub &'a str);

impl Text<'_> {
    /// Line and column, both from 1, of a byte.
    pub fn line_column(&self, byte: usize) -> (usize, usize) {
        let before = self.0.get(..byte).unwrap_or(self.0);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
        (line, column)
    }

    /// The error with the place of a span.
    pub fn at(&self, e: Error, span: &Range<usize>) -> Error {
        let (line, column) = self.line_column(span.start);
        e.with_line(line).with_column(column)
    }
}

/// The place and the written text of an expression.
#[derive(Clone)]
pub(super) struct Place {
    line: usize,
    column: usize,
    pub text: String,
}

/// The places of expressions by their dotted path (`states.v.rate`).
#[derive(Default)]
pub(super) struct Places(BTreeMap<String, Place>);

impl Places {
    /// Remembers where a string value stands; `span` includes its quotes.
    pub fn add(&mut self, path: String, text: &Text<'_>, span: &Range<usize>, value: &str) {
        let written = text.0.get(span.clone()).unwrap_or("");
        let quotes = written.chars().take_while(|c| *c == '"' || *c == '\'').count().min(written.len() / 2);
        let (line, column) = text.line_column(span.start);
        self.0.insert(path, Place { line, column: column + quotes, text: value.to_string() });
    }

    /// The text of an expression as it was written.
    pub fn text(&self, path: &str) -> Option<&str> {
        self.0.get(path).map(|p| p.text.as_str())
    }

    /// The error, moved from the expression's own columns to those of the file.
    pub fn put(&self, path: &str, e: Error) -> Error {
        let e = e.about(path);
        match self.0.get(path) {
            Some(place) => {
                let column = place.column + e.column().unwrap_or(1) - 1;
                e.with_line(place.line).with_column(column)
            }
            None => e,
        }
    }
}
