//! What is minimised.

use crate::Result;
use crate::estimate::triangle::Triangle;

/// A residual vector r(x) with its sensitivities, streamed.
pub trait Problem {
    /// How many unknowns x has.
    fn unknowns(&self) -> usize;

    /// ‖r(x)‖², or an error or a number that is not finite where r cannot be computed.
    fn sum_of_squares(&self, x: &[f64]) -> Result<f64>;

    /// The triangle of [∂r/∂x | r] at x.
    fn linearise(&self, x: &[f64]) -> Result<Triangle>;

    /// Whether the walk must end with the best so far.
    fn is_over(&self) -> bool {
        false
    }
}
