//! A model as code that runs without this program.
//!
//! # Purpose
//! Writes a model, what was found included, in another language: its equations, and where that language computes,
//! a runner of fixed steps that does what a simulation of the model does.
//!
//! # Method
//! The model is brought into a form without memory of its own ([`lowered`](self)): lags become states, delayed inputs
//! columns of their own, plays, relays, rate limits and pasts values in a record that the runner keeps, signs switches
//! whose value is constant over a step. Each language then spells the same lines.
//!
//! # Numerical aspects
//! The runner is the classical method of Runge and Kutta. A sign whose both sides push towards its zero takes the value
//! that ends the step at that zero, so that dry friction sticks; one that crosses takes its mean over the step. The
//! method is of order 4 where nothing switches. Where signs, plays or rate limits act, its error falls as the step does,
//! to the first order: ten times the substeps leave about a tenth of it.
//!
//! ```
//! use gyrospec::{Language, Model, export};
//! let text = export(&Model::builtin("gyrosphere")?, Language::Python)?;
//! assert!(text.contains("def derivatives(t, x, u, p, m):"));
//! # Ok::<(), gyrospec::Error>(())
//! ```

mod body;
mod c;
mod language;
mod latex;
mod lowered;
#[cfg(feature = "fmu")]
mod mockup;
mod modelica;
mod names;
mod python;
mod refused;
mod runner;
mod rust;
mod said;
mod spell;

pub use language::Language;
#[cfg(feature = "fmu")]
pub use mockup::export_fmu;

use crate::Result;
use crate::model::Model;

/// The model as text of a language; SI inside, with the units of the model file in comments.
///
/// # Errors
/// `BadInput` for a model that is wrong, that other people's code computes, or that holds a function which the
/// language has no words for.
pub fn export(model: &Model, language: Language) -> Result<String> {
    refused::whole(model)?;
    model.compile()?;
    match language {
        Language::Python => python::text(model),
        Language::C => c::text(model),
        Language::Rust => rust::text(model),
        Language::Modelica => modelica::text(model),
        Language::Latex => Ok(latex::text(model)),
    }
}
