//! Text, JSON and HTML reports; computes nothing.

pub mod braille;
pub mod correlation;
pub mod diagnosis;
pub mod fit;
pub mod identified;
pub mod json;
pub mod page;
pub mod pendulous;
pub mod polar;
pub mod rolling;
pub mod simulated;
pub mod strapdown;
pub mod svg;
pub mod terminal;
