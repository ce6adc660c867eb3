//! Noise models, least squares and fits: what the data say about a model, and how surely.

mod bootstrap;
mod coordinates;
mod correlation;
mod covariance;
pub mod fit;
mod identify;
mod least_squares;
pub mod noise;
mod saddle;
pub(crate) mod smooth;
pub(crate) mod triangle;

pub use bootstrap::improvement;
pub use coordinates::{Range, Side};
pub use correlation::{
    Correlation, Lags, Pair, autocorrelation, correlations, cross_correlation, fit_percent,
};
pub use covariance::{Stretch, coloured_covariance, half_width, independent_samples, inverse_square};
pub use fit::{Fit, FitOptions, fit, holdout};
pub use identify::{Direction, unseen};
pub use least_squares::{End, Minimum, Problem, Stopping, minimise};
pub use triangle::Triangle;
