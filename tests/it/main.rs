//! All integration tests, in one binary: one module a capability.
#![allow(clippy::print_stdout, clippy::print_stderr)] // what was skipped, and figures for the record

mod audit;
mod diagnose;
mod fit;
mod formula;
mod fuzz;
mod gyro;
mod gyro_time;
mod help;
mod house;
mod integral;
mod integral_command;
mod lti;
mod quality;
mod record;
mod report;
mod results;
mod roll_error;
mod simulate;
mod symbolic;
mod transcript;
