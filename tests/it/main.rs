//! All integration tests, in one binary: one module a capability.

mod fuzz;
mod formula;
mod house;
mod integral;
mod quality;
mod record;
mod simulate;
mod symbolic;
