//! The spectral integral against exact rational arithmetic.

mod exactness;
mod families;
mod laws;
mod methods;
mod refusals;
