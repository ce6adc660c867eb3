//! The closed form of the mean error, by the symbols' own derivation.

use super::options::MotionOptions;
use super::parameters::Part;
use crate::symbolic::{Derived, FormulaRequest, formula, irregular_roll};
use crate::{Error, Result};

pub fn text(part: Part, motion: &MotionOptions, json: bool) -> Result<String> {
    if motion.is_sea() {
        return Err(Error::usage("a sea's fitted spectrum has no short formula")
            .with_hint("leave --sea away: the formula is for irregular roll of the form (3.3)"));
    }
    let derived = derived(part)?;
    if json {
        let value = serde_json::json!({
            "schema": "gyrospec.roll-error-formula/1",
            "formula": derived.formula.text(),
            "order": derived.order,
            "points_checked": derived.points,
        });
        return Ok(format!("{value:#}\n"));
    }
    Ok(format!(
        "Mean heading error on irregular roll K(τ) = A e^(−μ|τ|)(cos ετ + (μ/ε) sin ε|τ|), b² = μ² + ε²:\n\n{}\n\n\
         derived from I_{}; agrees with the numeric engine at {} random points\n",
        derived.formula.text(),
        derived.order,
        derived.points
    ))
}

/// The mean error with letters.
pub fn derived(part: Part) -> Result<Derived> {
    let request = request(part)?;
    formula(&request.derivation()?, &request.simplifier()?)
}

/// How W₁ moves x, in letters.
fn request(part: Part) -> Result<FormulaRequest> {
    let mut request = irregular_roll();
    let second = match part {
        Part::Lag => return Ok(request),
        // m ẍ + r ẋ + C₀ x = m W₁
        Part::Inertia => "-m*h*cos(K)/(m*s^2 + r*s + C0)",
        // two relaxations side by side
        Part::Flow(_) => "-P/(g*C0)*h*cos(K)*(1/(T*s + 1) + kappa/(T_2*s + 1))",
        Part::Other => {
            return Err(Error::usage("no closed form is kept for this part")
                .with_hint("formulas: the lag (no option), --inertia, --flow; any other: gyrospec formula"));
        }
    };
    request.second = Some(second.into());
    request.printed = None;
    request.keep.clear();
    if matches!(part, Part::Inertia) {
        request.order = "P m h A mu b H U g r C0".into();
    }
    Ok(request)
}
