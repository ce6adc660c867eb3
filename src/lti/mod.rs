//! Transfer functions, state space, covariance, cross-spectral integrals.
