//! All integration tests, in one binary: one module a capability.

mod formula;
mod fuzz;
mod house;
mod integral;
mod quality;
mod record;
mod simulate;
mod symbolic;
