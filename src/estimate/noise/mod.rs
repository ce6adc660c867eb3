//! What the residual is made of: autoregressive noise, its scale, its tests.
//!
//! Residuals of real instruments are coloured. Whatever is inferred from them stands on a noise model
//! first: [`Autoregression`] whitens, [`NoiseModel`] adds decimation where the sampling is far faster
//! than the noise, and the tests say whether anything is left.

mod autoregression;
mod model;
mod scale;
mod tests_of_whiteness;

pub use autoregression::Autoregression;
pub use model::{NoiseModel, Whitened};
pub use scale::{block_means, correlation_time, robust_deviation, smallest_step};
pub use tests_of_whiteness::{Portmanteau, portmanteau, runs};
