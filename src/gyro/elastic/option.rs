//! How a program asks for an elastic part: options with numbers.

use super::part::Elastic;
use crate::gyro::range::Range;

/// The numbers in SI that each option of a part got; `None` for an option that was not said.
pub type Given = [Option<Vec<f64>>];

/// How an elastic part is asked for, by one or more of its options.
#[derive(Debug)]
pub struct Asked {
    /// Its options.
    pub options: &'static [PartOption],
    /// The part, from the numbers of its options in their order, of which at least one was said.
    pub make: fn(&Given) -> Box<dyn Elastic>,
}

/// An option of the command line, an argument in Python.
#[derive(Debug)]
pub struct PartOption {
    /// Its name, words parted by `-`.
    pub name: &'static str,
    /// Names of its numbers; empty for a switch.
    pub numbers: &'static str,
    /// The range of each of its numbers.
    pub ranges: &'static [&'static Range],
    /// What it does, in a sentence.
    pub help: &'static str,
}

/// The numbers of a part's first option.
pub(super) fn first(given: &Given) -> &[f64] {
    given.first().and_then(Option::as_deref).unwrap_or_default()
}
