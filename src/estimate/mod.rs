//! Noise models, least squares and fits: what the data say about a model, and how surely.

mod coordinates;
pub mod fit;
mod identify;
mod least_squares;
pub mod noise;
mod triangle;

pub use coordinates::{Range, Side};
pub use fit::{Fit, FitOptions, fit, holdout};
pub use identify::{Direction, unseen};
pub use least_squares::{End, Minimum, Problem, Stopping, minimise};
pub use triangle::Triangle;
