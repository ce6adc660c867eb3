//! The spectral integral against exact rational arithmetic.

mod exactness;
mod families;
