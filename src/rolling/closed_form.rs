//! The mean error on irregular roll with letters, by the symbols' own derivation, and its values.

use super::{Compass, Excitation};
use crate::gyro::elastic::{Elastic, Letters};
use crate::gyro::validity::{Smallness, bounded};
use crate::symbolic::{Derived, FormulaRequest, formula, irregular_roll};
use crate::{Error, Result};

/// The highest order n of an I_n that is written out: beyond it the formula fills pages.
const LONGEST: usize = 6;

/// The mean error on irregular roll of the form (3.3), with letters.
///
/// ```
/// use gyrospec::gyro::elastic::Lag;
/// use gyrospec::rolling::closed_form;
/// assert_eq!(closed_form(&Lag)?.order, 3);           // from I₃
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `Usage` for a part that is not linear, and for one whose formula fills pages.
pub fn closed_form(part: &dyn Elastic) -> Result<Derived> {
    let letters = part.letters().ok_or_else(|| {
        Error::usage(format!("{} is not linear: its mean error has no closed form", part.name()))
            .with_hint("every linear part has one; without --formula the figures of this one are simulated")
    })?;
    let request = request(letters);
    let (derivation, simplifier) = (request.derivation()?, request.simplifier()?);
    let order = derivation.order(&simplifier)?;
    if order > LONGEST {
        let second = request.second.unwrap_or_default();
        return Err(Error::usage(format!("written out, I_{order} of this compass fills pages")).with_hint(
            format!(
                "gyrospec formula derives it: --first=\"h*sin(K)\" --second=\"{second}\" --shaping=\"{}\"",
                request.shaping.unwrap_or_default()
            ),
        ));
    }
    formula(&derivation, &simplifier)
}

/// The paper's irregular roll with another centre of mass.
fn request(letters: Letters) -> FormulaRequest {
    let paper = irregular_roll();
    if paper.second.as_deref() == Some(&*letters.shift) {
        return paper;
    }
    let (second, order) = (Some(letters.shift.into_owned()), letters.order.into_owned());
    FormulaRequest { second, order, printed: None, keep: Vec::new(), ..paper }
}

/// What the closed form gives.
#[derive(Debug, Clone)]
pub struct ClosedValues {
    /// Heading and mean, rad.
    pub means: Vec<(f64, f64)>,
    /// What the linear theory takes for small, where the mean is largest.
    pub smallness: Vec<Smallness>,
}

/// The value of the mean error on each heading, rad.
///
/// # Errors
/// `BadInput` without headings; as [`Instrument::error`](crate::gyro::Instrument::error); `OutOfRange` beyond what the
/// linear theory gives.
pub fn closed_values(compass: &Compass, excitation: &Excitation, headings: &[f64]) -> Result<ClosedValues> {
    let (motion, instrument) = (excitation.motion()?.motion, compass.instrument());
    let value = |heading: &f64| -> Result<(f64, f64)> {
        let mean = instrument.rectified_error(&motion, *heading)?;
        bounded(mean)?;
        Ok((*heading, mean))
    };
    let means: Vec<(f64, f64)> = headings.iter().map(value).collect::<Result<_>>()?;
    let worst = means.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    let (worst, _) = *worst.ok_or_else(|| Error::bad_input("a mean error has a heading"))?;
    let error = instrument.error(&motion, worst)?;
    let smallness = instrument.smallness(&motion, worst, &error)?;
    Ok(ClosedValues { means, smallness })
}
