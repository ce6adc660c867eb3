//! The closed form of the mean error, by the symbols' own derivation.

use super::Arguments;
use super::json::smallness;
use super::parameters::{Compass, Part};
use super::table::{beyond, unjudged};
use crate::gyro::seed;
use crate::gyro::validity::Smallness;
use crate::symbolic::{Derived, FormulaRequest, formula, irregular_roll};
use crate::{Error, Result};
use std::fmt::Write;

pub fn text(compass: &Compass, a: &Arguments) -> Result<String> {
    if a.motion.is_sea() {
        return Err(Error::usage("a sea's fitted spectrum has no short formula")
            .with_hint("leave --sea away: the formula is for irregular roll of the form (3.3)"));
    }
    if a.motion.is_regular() {
        return Err(Error::usage("the closed form is for irregular roll; on regular roll the lag has (2.4)").with_hint(
            "−P²θ₀²h²p⁴ sin 2K/(4 g² H U C₀ cos φ (1 + p²T²)) = mean α; --regular without --formula gives its value",
        ));
    }
    let derived = derived(compass.part(&a.instrument)?)?;
    let Values { means, motion, validity } = values(compass, a)?;
    if a.json {
        let row =
            |(heading, mean): &(f64, f64)| serde_json::json!({ "heading_deg": heading, "mean_deg": mean });
        let value = serde_json::json!({
            "schema": "gyrospec.roll-error-formula/1",
            "formula": derived.formula.text(),
            "order": derived.order,
            "points_checked": derived.points,
            "motion": motion,
            "sign": crate::gyro::SIGN,
            "validity": validity.iter().map(smallness).collect::<Vec<_>>(),
            "values": means.iter().map(row).collect::<Vec<_>>(),
        });
        return Ok(format!("{value:#}\n"));
    }
    let mut out = format!(
        "Mean heading error on irregular roll K(τ) = A e^(−μ|τ|)(cos ετ + (μ/ε) sin ε|τ|), b² = μ² + ε²:\n\n{}\n\n\
         derived from I_{}; agrees with the numeric engine at {} random points\n\n\
         Here ({}; {motion}; latitude {:.1}°, h = {} m):\n",
        derived.formula.text(),
        derived.order,
        derived.points,
        compass.says,
        compass.sphere.latitude.to_degrees(),
        compass.sphere.lever
    );
    for (heading, mean) in means {
        let _ = writeln!(out, "  heading {heading:>6.1}°   {mean:>10.5}°  ({})", crate::gyro::side(mean));
    }
    let beyond = beyond(&validity);
    if !beyond.is_empty() {
        let _ = writeln!(out, "\n{beyond}");
    }
    let unjudged = unjudged(&validity);
    if !unjudged.is_empty() {
        let _ = write!(out, "\n{unjudged}");
    }
    Ok(out)
}

/// What the closed form gives.
struct Values {
    /// Heading and mean, degrees.
    means: Vec<(f64, f64)>,
    /// The motion in words.
    motion: String,
    /// What the linear theory takes for small, where the mean is largest.
    validity: Vec<Smallness>,
}

fn values(compass: &Compass, a: &Arguments) -> Result<Values> {
    let roll = compass.roll.unwrap_or_else(|| seed::example_3_1().1);
    let described = a.motion.motion(&roll, None)?;
    let headings = if a.rows.has_headings() { a.rows.headings()? } else { vec![45f64.to_radians()] };
    let instrument = compass.instrument(&a.instrument)?;
    let value = |heading: &f64| -> Result<(f64, f64)> {
        let mean = instrument.rectified_error(&described.motion, *heading)?;
        crate::gyro::validity::bounded(mean)?;
        Ok((heading.to_degrees(), mean.to_degrees()))
    };
    let means: Vec<(f64, f64)> = headings.iter().map(value).collect::<Result<_>>()?;
    let largest = |i: &usize, j: &usize| means[*i].1.abs().total_cmp(&means[*j].1.abs());
    let worst = headings[(0..means.len()).max_by(largest).unwrap_or(0)];
    let error = instrument.error(&described.motion, worst)?;
    let validity = instrument.smallness(&described.motion, worst, &error)?;
    Ok(Values { means, motion: described.says, validity })
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
