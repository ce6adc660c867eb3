//! The spectral integral against exact rational arithmetic.

pub mod crossed;
mod exactness;
pub mod families;
mod laws;
mod methods;
mod refusals;
