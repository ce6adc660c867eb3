//! The model file: expressions, dimensions, dual numbers, built-in models.
//!
//! ```
//! use gyrospec::model::Model;
//! let model = Model::parse(r#"
//!     name = "a falling stone"
//!     [parameters]
//!     g = { value = 981, unit = "cm/s^2" }
//!     [states]
//!     z = { rate = "v", unit = "m", initial = 100 }
//!     v = { rate = "-g", unit = "m/s", initial = 0 }
//!     [outputs]
//!     height = { equals = "z", unit = "m" }
//! "#)?;
//! assert_eq!(model.parameters[0].value, 9.81);
//! assert_eq!(Model::parse(&model.to_toml())?, model);
//! # Ok::<(), gyrospec::Error>(())
//! ```

mod angular;
mod bare;
mod begun;
mod builtin;
mod check;
mod clocks;
mod form;
mod free;
mod kelvins;
mod knots;
#[cfg(feature = "fmu")]
mod mockup;
#[cfg(not(feature = "fmu"))]
#[path = "no_mockup.rs"]
mod mockup;
mod numbers;
mod parts;
mod places;
pub(crate) mod program;
mod read;
mod scalar;
pub(crate) mod shown;
mod simulated;
mod unmeasured;
mod write;

#[cfg(feature = "fmu")]
pub use begun::Mockup;
pub use begun::Simulated;
pub use builtin::BUILTIN;
pub use numbers::{Number, Numbers};
pub use parts::{Definition, Initial, Input, Model, Output, Parameter, State};
pub(crate) use scalar::power_slopes;
pub use scalar::{Dual, Scalar};

#[cfg(test)]
mod tests;
