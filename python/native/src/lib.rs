//! The native half of the Python package `gyrospec`: one file a subject.
//!
//! Numbers come in as NumPy arrays and go out as such; reports go out as the JSON that the program
//! writes, and the Python half gives their fields names. Python's lock is let go during all work.
#![allow(missing_docs)] // what Python sees is documented in python/gyrospec/_gyrospec.pyi
#![allow(clippy::needless_pass_by_value)] // arguments come out of Python objects as values

mod array;
mod batch;
mod diagnose;
mod fault;
mod fit;
mod identify;
mod integral;
mod model;
mod pendulous;
mod recording;
mod roll_error;
mod simulate;
mod strapdown;
mod sweep;
mod table;
mod told;
mod units;
mod work;

use pyo3::prelude::*;

/// The native module `gyrospec._gyrospec`.
#[pymodule]
mod _gyrospec {
    #[pymodule_export]
    use super::batch::integral_batch;
    #[pymodule_export]
    use super::diagnose::diagnose;
    #[pymodule_export]
    use super::fit::fit;
    #[pymodule_export]
    use super::identify::identify;
    #[pymodule_export]
    use super::integral::{Integral, integral};
    #[pymodule_export]
    use super::model::Model;
    #[pymodule_export]
    use super::pendulous::pendulous;
    #[pymodule_export]
    use super::recording::Recording;
    #[pymodule_export]
    use super::roll_error::{elastic_options, roll_error};
    #[pymodule_export]
    use super::simulate::{Simulated, simulate};
    #[pymodule_export]
    use super::strapdown::strapdown;
    #[pymodule_export]
    use super::sweep::roll_error_sweep;
    #[pymodule_export]
    use super::table::table;
    #[pymodule_export]
    use super::told::Told;
    #[pymodule_export]
    use super::units::{powers, unit_of};

    /// The version of the package.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
}
