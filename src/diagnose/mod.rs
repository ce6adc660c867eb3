//! Locate the mismatch, name what was left out, prove it.

pub mod catalogue;
