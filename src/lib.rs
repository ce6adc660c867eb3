//! Spectral integrals, the rolling error of gyrocompasses, and the diagnosis of
//! what a simulation leaves out.
//!
//! What a program meets first stands here:
//!
//! | to | call | feature |
//! |---|---|---|
//! | integrate G/(H(jω)·H(−jω)) over all ω | [`evaluate`] or [`evaluate_fast`] of an [`Integrand`] | |
//! | see one integral by every method | [`crosscheck`](fn@crosscheck) | |
//! | print I_n in symbols | [`print_tables`], [`Table`] | `symbolic` |
//! | derive a mean or a variance in symbols | [`formula`](fn@formula) | `symbolic` |
//! | describe a compass and the roll that disturbs it | [`Gyrosphere`], [`Instrument`], [`Roll`] | `instruments` |
//! | ask for the rolling error | [`roll_error`] of a [`Compass`] | `diagnose` |
//! | read a recording | [`Recording::read`] | `instruments` |
//! | read a model, and run it on a recording | [`Model::read`], [`simulate`](fn@simulate) | `diagnose` |
//! | fit its parameters | [`fit`](fn@fit) | `diagnose` |
//! | find what it leaves out | [`diagnose`](fn@diagnose) | `diagnose` |
//! | write it in another language | [`export`](fn@export) to a [`Language`] | `diagnose` |
//!
//! Without any feature there is the integral with its exact tier alone; `cli`, the default, is all of it and the
//! program. The rooms behind, from the ground up; each imports only what stands above it:
//!
//! | room | holds |
//! |---|---|
//! | [`error`] | one opaque error with a kind and data |
//! | [`units`] | the closed list of units |
//! | [`integral`] | I_n by recursion, moments, determinant, exact arithmetic, quadrature |
//! | [`symbolic`] | the same integrals in symbols |
//! | [`lti`] | transfer functions, state space, covariance |
//! | [`spectrum`] | roll and sea spectra |
//! | [`record`] | recordings |
//! | [`gyro`] | gyrospheres, the rotating gimbal, strapdown systems |
//! | [`model`] | model files |
//! | [`export`](mod@export) | a model in other languages |
//! | [`simulate`](mod@simulate) | a model on a recording |
//! | [`diagnose`](mod@diagnose) | what is missing |
//! | [`rolling`] | the rolling error as it is asked for: compass, motion, rows |

#[cfg(feature = "diagnose")]
pub mod diagnose;
pub mod error;
#[cfg(feature = "diagnose")]
#[doc(hidden)]
pub mod estimate;
#[doc(hidden)]
pub mod exact;
#[cfg(feature = "diagnose")]
pub mod export;
#[cfg(any(feature = "symbolic", feature = "instruments"))]
#[doc(hidden)]
pub mod expression;
#[cfg(feature = "fmu")]
mod fmu;
#[cfg(feature = "instruments")]
pub mod gyro;
pub mod integral;
#[cfg(feature = "instruments")]
pub mod lti;
#[cfg(feature = "diagnose")]
pub mod model;
#[doc(hidden)]
pub mod poly;
#[cfg(feature = "instruments")]
pub mod record;
#[cfg(feature = "diagnose")]
#[doc(hidden)]
pub mod report;
#[cfg(feature = "diagnose")]
pub mod rolling;
#[cfg(feature = "diagnose")]
pub mod simulate;
#[cfg(feature = "instruments")]
pub mod spectrum;
#[cfg(feature = "symbolic")]
pub mod symbolic;
#[doc(hidden)]
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
pub use integral::{Estimate, Integral, Integrand, evaluate, evaluate_fast};
pub use num_complex::Complex64;

#[cfg(feature = "symbolic")]
pub use symbolic::{Formula, FormulaRequest, Table, TableFormat, formula, print_tables};

#[cfg(feature = "instruments")]
pub use gyro::{Axis, Gyrosphere, Instrument, MonteCarlo, Motion};
#[cfg(feature = "instruments")]
pub use lti::{StateSpace, TransferFunction};
#[cfg(feature = "instruments")]
pub use record::Recording;
#[cfg(feature = "instruments")]
pub use spectrum::{Hull, Roll, Sea};

#[cfg(feature = "diagnose")]
pub use diagnose::answer::{Finding, Proof, Verdict};
#[cfg(feature = "diagnose")]
pub use estimate::fit::{Progress, Silent};
#[cfg(feature = "fmu")]
pub use export::export_fmu;
#[cfg(feature = "diagnose")]
pub use export::{Language, export};
#[cfg(feature = "diagnose")]
pub use facade::{
    Asking, Diagnosed, Diagnosing, Estimated, Fitted, Fitting, Rolled, Rolling, Simulated, SimulatedOutput,
    Simulating, diagnose, fit, roll_error, simulate,
};
#[cfg(feature = "diagnose")]
pub use model::Model;
#[cfg(feature = "diagnose")]
pub use rolling::{Against, Compass, Waves};
#[cfg(any(feature = "symbolic", feature = "instruments"))]
pub use units::Unit;
