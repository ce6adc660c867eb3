//! Spectral integrals, the rolling error of gyrocompasses, and the diagnosis of
//! what a simulation leaves out.
//!
//! The rooms, from the ground up; each imports only what stands above it:
//!
//! | room | holds |
//! |---|---|
//! | [`text`] | texts of others as they may be shown |
//! | [`error`] | one opaque error with a kind and data |
//! | [`units`] | the closed list of units |
//! | [`expression`] | the expression language of models and formulas |
//! | [`exact`] | integers and rationals of any size |
//! | [`poly`] | polynomials, roots, the Hurwitz test |
//! | [`integral`] | I_n by recursion, moments, determinant, exact arithmetic, quadrature |
//! | [`symbolic`] | the same integrals with letters |
//! | [`lti`] | transfer functions, state space, covariance |
//! | [`spectrum`] | roll and sea spectra |
//! | [`record`] | recordings |
//! | [`gyro`] | gyrospheres and the rotating gimbal |
//! | [`model`] | model files |
//! | [`simulate`] | a model on a recording |
//! | [`estimate`] | noise models and fits |
//! | [`diagnose`] | what is missing |
//! | [`report`] | text, JSON, HTML |
//!
//! Features: without any there is the integral alone; `symbolic`, `instruments` and `diagnose` add their rooms, `cli`
//! (the default) the program.

#[cfg(feature = "diagnose")]
pub mod diagnose;
pub mod error;
#[cfg(feature = "diagnose")]
pub mod estimate;
pub mod exact;
#[cfg(any(feature = "symbolic", feature = "instruments"))]
pub mod expression;
#[cfg(feature = "instruments")]
pub mod gyro;
pub mod integral;
#[cfg(feature = "instruments")]
pub mod lti;
#[cfg(feature = "diagnose")]
pub mod model;
pub mod poly;
#[cfg(feature = "instruments")]
pub mod record;
#[cfg(feature = "diagnose")]
pub mod report;
#[cfg(feature = "diagnose")]
pub mod simulate;
#[cfg(feature = "instruments")]
pub mod spectrum;
#[cfg(feature = "symbolic")]
pub mod symbolic;
pub mod text;
#[cfg(any(feature = "symbolic", feature = "instruments"))]
pub mod units;

#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod cli;
#[cfg(feature = "diagnose")]
mod facade;

/// What the README shows of the library runs as a test.
#[cfg(all(doctest, feature = "cli"))]
#[doc = include_str!("../README.md")]
pub struct Readme;

pub use error::{Error, ErrorKind, Result};
pub use integral::crosscheck::{Crosscheck, crosscheck};
pub use integral::{Answer, Estimate, Integrand, evaluate, evaluate_fast};

#[cfg(feature = "symbolic")]
pub use symbolic::{Formula, FormulaRequest, Table, TableFormat, formula, print_tables};

#[cfg(feature = "instruments")]
pub use gyro::{Gyrosphere, Instrument, MonteCarlo, Motion};
#[cfg(feature = "instruments")]
pub use lti::{StateSpace, TransferFunction};
#[cfg(feature = "instruments")]
pub use record::Recording;
#[cfg(feature = "instruments")]
pub use spectrum::Roll;

#[cfg(feature = "diagnose")]
pub use diagnose::answer::{Finding, Proof, Verdict};
#[cfg(feature = "diagnose")]
pub use facade::{
    Diagnosed, Diagnosing, Estimated, Fitted, Fitting, Simulated, SimulatedOutput, Simulating, diagnose, fit,
    simulate,
};
#[cfg(feature = "diagnose")]
pub use model::Model;
#[cfg(any(feature = "symbolic", feature = "instruments"))]
pub use units::Unit;
