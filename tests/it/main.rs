//! All integration tests, in one binary: one module a capability.

mod house;
mod record;
mod symbolic;
