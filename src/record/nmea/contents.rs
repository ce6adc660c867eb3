//! What a log holds, for whoever writes a recording file for it.

use super::group::Group;

/// What a log holds.
pub(crate) struct Contents {
    /// Its first moment, in its own words.
    pub start: String,
    pub fields: Vec<Listed>,
    /// What is to be said of sentences that nothing is known of.
    pub unknown: Option<String>,
}

/// A field of a sentence, as a recording file names it.
pub(crate) struct Listed {
    pub name: String,
    pub sentence: String,
    pub id: Option<u32>,
    pub field: usize,
    pub unit: String,
    pub wraps: bool,
    /// Whether there is a number in it anywhere.
    pub has_numbers: bool,
}

impl Group {
    /// The fields of one sort of sentence.
    pub fn contents(&self) -> impl Iterator<Item = Listed> {
        self.selections.iter().zip(&self.values).map(|(s, values)| Listed {
            name: s.wanted.name.clone(),
            sentence: s.wanted.column.clone(),
            id: s.id,
            field: s.field,
            unit: s.unit.text().to_owned(),
            wraps: s.wanted.wraps,
            has_numbers: values.iter().any(|v| !v.is_nan()),
        })
    }
}
