//! Text, JSON and HTML reports; computes nothing.

pub mod braille;
pub mod diagnosis;
pub mod polar;
pub mod svg;
pub mod terminal;
