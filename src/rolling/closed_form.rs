//! The mean error on irregular roll in symbols, by the symbols' own derivation, and its values.

use super::{Compass, Excitation, SeaMotion, ShipMotion};
use crate::expression::Expr;
use crate::gyro::elastic::{Elastic, Letters};
use crate::gyro::validity::{Smallness, bounded};
use crate::symbolic::{Derived, Formula, FormulaRequest, formula, irregular_roll};
use crate::{Error, Result};

/// The highest order n of an I_n that is written out: beyond it the formula fills pages.
pub(super) const LONGEST: usize = 6;

/// The mean error on irregular roll in symbols.
#[derive(Debug, Clone, PartialEq)]
pub enum ClosedForm {
    /// Written out.
    Written(Derived),
    /// I_n as the integral that it is, where it would fill pages.
    Integral {
        /// n.
        order: usize,
        /// The integral and what stands in it, in lines.
        text: String,
    },
}

impl ClosedForm {
    /// The formula as plain text.
    pub fn text(&self) -> String {
        match self {
            Self::Written(derived) => derived.formula.text(),
            Self::Integral { text, .. } => text.clone(),
        }
    }

    /// n of the I_n behind it; 0 where it needs none, on a sine.
    pub fn order(&self) -> usize {
        match self {
            Self::Written(derived) => derived.order,
            Self::Integral { order, .. } => *order,
        }
    }

    /// The number of random points at which it agrees with the numeric engine; 0 for an integral.
    pub fn points(&self) -> usize {
        match self {
            Self::Written(derived) => derived.points,
            Self::Integral { .. } => 0,
        }
    }
}

/// The mean error on irregular roll of the form (3.3), in symbols; behind two low-passes at ω_c where the motion
/// has a `band`.
///
/// ```
/// use gyrospec::gyro::elastic::Lag;
/// use gyrospec::rolling::closed_form;
/// assert_eq!(closed_form(&Lag, None)?.order(), 3);           // from I₃
/// assert_eq!(closed_form(&Lag, Some(2.5))?.order(), 5);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `Usage` for a part that is not linear.
pub fn closed_form(part: &dyn Elastic, band: Option<f64>) -> Result<ClosedForm> {
    let request = request(part, band.is_some())?;
    let order = order(&request)?;
    if order > LONGEST {
        return Ok(ClosedForm::Integral { order, text: integral(&request, order)? });
    }
    let (derivation, simplifier) = (request.derivation()?, request.simplifier()?);
    formula(&derivation, &simplifier).map(ClosedForm::Written)
}

/// n of the I_n that a request describes, at numbers in the letters' place: with all of them a suspension of many parts
/// would first be multiplied out.
pub(super) fn order(r: &FormulaRequest) -> Result<usize> {
    let number = |name: &str| {
        // any numbers do at which nothing cancels that does not in symbols
        let sum = name.bytes().fold(7u32, |sum, b| (31 * sum + u32::from(b)) % 997);
        (name != "s" && name != "K").then(|| Expr::number(f64::from(sum + 1) / 64.0))
    };
    let at = |text: &Option<String>| {
        let at =
            |text: &String| -> Result<String> { Ok(Expr::parse(text)?.substitute_each(&number).to_string()) };
        text.as_ref().map(at).transpose()
    };
    let [first, second, shaping, density] = [at(&r.first)?, at(&r.second)?, at(&r.shaping)?, at(&r.density)?];
    let numbers = FormulaRequest { first, second, shaping, density, ..FormulaRequest::default() };
    numbers.derivation()?.order(&numbers.simplifier()?)
}

/// The paper's irregular roll with another centre of mass, behind two low-passes.
pub(super) fn request(part: &dyn Elastic, banded: bool) -> Result<FormulaRequest> {
    let letters = part.letters().ok_or_else(|| {
        Error::usage(format!("{} is not linear: its mean error has no closed form", part.name()))
            .with_hint("every linear part has one; without --formula the figures of this one are simulated")
    })?;
    Ok(with(letters, banded))
}

fn with(letters: Letters, banded: bool) -> FormulaRequest {
    let mut paper = irregular_roll();
    if banded {
        paper.shaping = paper.shaping.map(|s| format!("{s}/(s/omega_c + 1)^2"));
        (paper.printed, paper.keep) = (None, Vec::new());
    }
    if paper.second.as_deref() == Some(&*letters.shift) {
        return paper;
    }
    let (second, order) = (Some(letters.shift.into_owned()), letters.order.into_owned());
    FormulaRequest { second, order, printed: None, keep: Vec::new(), ..paper }
}

/// α as the integral that the request describes.
pub(super) fn integral(r: &FormulaRequest, order: usize) -> Result<String> {
    let told = |name: &str, text: &Option<String>| -> Result<String> {
        Ok(Formula::parse(name, text.as_deref().unwrap_or("1"))?.text())
    };
    let times = told("α", &r.times)?;
    let lines = [("F(s)", &r.first), ("X(s)", &r.second), ("W(s)", &r.shaping), ("N", &r.density)];
    let lines = lines.iter().map(|(name, text)| Ok(format!("  {}", told(name, text)?)));
    Ok(format!(
        "{times} · (1/2π) ∫ F(jω) X(−jω) |W(jω)|² N dω, an I_{order}, with\n{}",
        lines.collect::<Result<Vec<_>>>()?.join("\n")
    ))
}

/// What the closed form gives.
#[derive(Debug, Clone)]
pub struct ClosedValues {
    /// Heading and mean, rad.
    pub means: Vec<(f64, f64)>,
    /// What the linear theory takes for small, where the mean is largest.
    pub smallness: Vec<Smallness>,
    /// What became of a sea.
    pub sea: Option<SeaMotion>,
}

/// The value of the mean error on each heading, rad.
///
/// # Errors
/// `BadInput` without headings; as [`Instrument::error`](crate::gyro::Instrument::error); `OutOfRange` beyond what the
/// linear theory gives.
pub fn closed_values(compass: &Compass, excitation: &Excitation, headings: &[f64]) -> Result<ClosedValues> {
    let (ShipMotion { motion, regular, sea }, instrument) = (excitation.motion()?, compass.instrument());
    let value = |heading: &f64| -> Result<(f64, f64)> {
        let mean = match &regular {
            Some(sine) => instrument.regular_error(sine, *heading)?.rectified,
            None => instrument.rectified_error(&motion, *heading)?,
        };
        bounded(mean)?;
        Ok((*heading, mean))
    };
    let means: Vec<(f64, f64)> = headings.iter().map(value).collect::<Result<_>>()?;
    let worst = means.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    let (worst, _) = *worst.ok_or_else(|| Error::bad_input("a mean error has a heading"))?;
    let smallness = match &regular {
        Some(sine) => {
            instrument.regular_smallness(&motion, worst, &instrument.regular_error(sine, worst)?)?
        }
        None => instrument.smallness(&motion, worst, &instrument.error(&motion, worst)?)?,
    };
    Ok(ClosedValues { means, smallness, sea })
}
