//! What a model is made of.

#[cfg(feature = "fmu")]
use super::begun::Mockup;
use super::begun::Simulated;
use crate::expression::Expr;
use crate::units::Unit;

/// A measured signal that drives the model.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Name, also of the recording's channel.
    pub name: String,
    /// Unit of the model file.
    pub unit: Unit,
    /// Words for the report.
    pub meaning: Option<String>,
}

/// A parameter; every value in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Name in expressions.
    pub name: String,
    /// Value in SI.
    pub value: f64,
    /// Unit of the model file.
    pub unit: Unit,
    /// Whether a fit may move it.
    pub fit: bool,
    /// Lower bound in SI.
    pub min: Option<f64>,
    /// Upper bound in SI.
    pub max: Option<f64>,
    /// Words for the report.
    pub meaning: Option<String>,
}

/// A named expression.
#[derive(Debug, Clone, PartialEq)]
pub struct Definition {
    /// Name in expressions.
    pub name: String,
    /// The expression that gives its value.
    pub equals: Expr,
    /// Unit of the model file.
    pub unit: Unit,
    /// Words for the report.
    pub meaning: Option<String>,
}

/// Where a state starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Initial {
    /// A number, in SI.
    Number(f64),
    /// Fitted for each recording.
    Fit,
    /// The steady state of the model at the first inputs.
    Steady,
}

/// A state and its rate.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Name in expressions.
    pub name: String,
    /// Its rate of change, in state unit per second.
    pub rate: Expr,
    /// Unit of the model file.
    pub unit: Unit,
    /// Where it starts.
    pub initial: Initial,
    /// Words for the report.
    pub meaning: Option<String>,
}

/// A measured signal that the model predicts.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// Name, also of the recording's channel.
    pub name: String,
    /// The expression that is compared with the measured channel.
    pub equals: Expr,
    /// Unit of the model file.
    pub unit: Unit,
    /// Words for the report.
    pub meaning: Option<String>,
}

/// A model; every list in the order of its file.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// Its name in words, as reports show it.
    pub name: String,
    /// Measured signals that drive it.
    pub inputs: Vec<Input>,
    /// Its parameters, in the order of the file.
    pub parameters: Vec<Parameter>,
    /// Named expressions, in any order.
    pub definitions: Vec<Definition>,
    /// Its states, in the order of the file.
    pub states: Vec<State>,
    /// Measured signals that it predicts.
    pub outputs: Vec<Output>,
    /// Whether nothing in it has a unit: then its numbers are those of the recording, and no unit is checked.
    pub is_free: bool,
    /// What a simulation elsewhere computed, where the model speaks of that.
    pub simulated: Option<Simulated>,
    /// The Functional Mock-up Unit that it begins with.
    #[cfg(feature = "fmu")]
    pub fmu: Option<Mockup>,
}
