//! Transfer functions, state space, covariance, cross-spectral integrals.
//!
//! Spectra are two-sided densities S(ω) with K(τ) = (1/2π)∫ S(ω) e^{jωτ} dω, so that white
//! noise of unit intensity has S = 1 and the variance of W(s)·noise is (1/2π)∫ |W(jω)|² dω.

mod covariance;
mod cross;
mod discrete;
mod gaussian;
mod poles;
mod state_space;
mod transfer;

#[doc(hidden)]
pub use covariance::{Covariance, stationary_covariance};
pub use cross::{CrossIntegral, cross_integrand, cross_moment, cross_rate_moment};
#[doc(hidden)]
pub use discrete::Discrete;
#[doc(hidden)]
pub use gaussian::Gaussian;
pub(crate) use poles::poles;
pub use state_space::StateSpace;
pub use transfer::TransferFunction;
