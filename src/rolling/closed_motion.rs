//! The mean error in symbols on any motion that has one: irregular roll, regular roll, roll in a sea.

use super::closed_form::{ClosedForm, LONGEST, closed_form, integral, order, request};
use super::{Excitation, ShipMotion, Source, Waves};
use crate::expression::Expr;
use crate::gyro::elastic::Elastic;
use crate::gyro::{Axis, Motion};
use crate::lti::TransferFunction;
use crate::symbolic::{Formula, Relation, Simplifier, SineMean};
use crate::units::significant;
use crate::{Error, Result};

/// The mean error on a motion, in symbols; the roll of a sea is white noise through a filter with numbers.
///
/// ```
/// use gyrospec::gyro::{elastic::Lag, seed::Regular};
/// use gyrospec::rolling::{Excitation, Source, closed_form_on};
/// let roll = Source::Regular(Regular { amplitude: 0.1, frequency: 0.7 });
/// let closed = closed_form_on(&Lag, &Excitation { source: roll, band: None })?;
/// // (2.4)
/// assert_eq!(closed.text(), "α = −P² θ_0² h² p⁴ sin 2K / (4 H U C0 g² (1 + T²p²) cos φ)");
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `Usage` for a part that is not linear, and for a sea with motions beside roll that change the mean; as
/// [`Excitation::motion`].
pub fn closed_form_on(part: &dyn Elastic, excitation: &Excitation) -> Result<ClosedForm> {
    match &excitation.source {
        Source::Irregular(_) => closed_form(part, excitation.band),
        Source::Regular(_) => on_sine(part, excitation.band.is_some()),
        Source::Sea(waves) => in_sea(part, waves, excitation),
    }
}

/// ½θ₀² Re F(jp) X(−jp) with W₁ and W₂ by θ̈, behind two low-passes at ω_c.
fn on_sine(part: &dyn Elastic, banded: bool) -> Result<ClosedForm> {
    let r = request(part, false)?;
    let read = |text: &Option<String>, behind: &str| {
        Expr::parse(&format!("({}){behind}", text.as_deref().unwrap_or("1")))
    };
    let behind = if banded { "*s^2/(s/omega_c + 1)^2" } else { "*s^2" };
    let mean = SineMean {
        name: "alpha".into(),
        first: read(&r.first, behind)?,
        second: read(&r.second, behind)?,
        amplitude: Expr::name("theta_0"),
        frequency: "p".into(),
        times: read(&r.times, "")?,
    };
    if order(&r)? > LONGEST {
        return Ok(ClosedForm::Integral { order: 0, text: unwritten(&mean) });
    }
    let relations = vec![Relation::parse("sin(K)*cos(K) = sin(2*K)/2")?];
    let order = format!("P theta_0 {} p", r.order).split(' ').map(String::from).collect();
    mean.derived(&Simplifier { relations, order, ..Simplifier::default() }).map(ClosedForm::Written)
}

/// The mean on a sine by its transfer functions.
fn unwritten(mean: &SineMean) -> String {
    let told =
        |name: &str, e: &Expr| Formula { name: name.into(), by: Vec::new(), expression: e.clone() }.text();
    let (times, first, second) =
        (told("α", &mean.times), told("F(s)", &mean.first), told("X(s)", &mean.second));
    format!("{times} · ½ θ_0² Re F(jp) X(−jp), with\n  {first}\n  {second}")
}

/// The integral of roll in a sea, whose filter W(s) stands in it with its numbers.
fn in_sea(part: &dyn Elastic, waves: &Waves, excitation: &Excitation) -> Result<ClosedForm> {
    let moves = |a: &&Axis| matches!(a, Axis::Pitch | Axis::Sway | Axis::Surge);
    if let Some(axis) = waves.also.iter().find(moves) {
        return Err(Error::usage(format!("the formula is that of roll alone, and {} changes the mean too", format!("{axis:?}").to_lowercase()))
            .with_hint("leave it away from --also, or ask without --formula: the table has the mean of all motions together"));
    }
    let ShipMotion { motion, sea, .. } = excitation.motion()?;
    let mut roll = sea.and_then(|s| s.roll).ok_or_else(no_filter)?;
    if let Some(corner) = excitation.band {
        let low = TransferFunction::new(&[1.0], &[1.0 / corner, 1.0])?;
        roll = roll.then(&low).then(&low);
    }
    same(&roll, &motion)?;
    // X(s) has the order of the integral on irregular roll less the two of the roll
    let bare = request(part, false)?;
    let order = order(&bare)? - 2 + roll.order();
    let mut r = bare;
    let accelerated = [roll.numerator(), &[0.0, 0.0]].concat();
    r.shaping = Some(format!("({})/({})", polynomial(&accelerated), polynomial(roll.denominator())));
    r.density = None;
    Ok(ClosedForm::Integral { order, text: integral(&r, order)? })
}

/// Sees that a filter makes the roll of a motion: that their variances agree.
fn same(roll: &TransferFunction, motion: &Motion) -> Result<()> {
    let sigma = motion.system().state_covariance()?.matrix;
    let c = motion.derivative(Axis::Roll, 0)?.state;
    let each = (0..c.len()).flat_map(|i| (0..c.len()).map(move |j| (i, j)));
    let variance: f64 = each.map(|(i, j)| c[i] * c[j] * sigma[(i, j)]).sum();
    if (roll.variance()?.value / variance - 1.0).abs() < 1e-6 {
        return Ok(());
    }
    Err(no_filter())
}

fn no_filter() -> Error {
    Error::usage("the roll of this sea is no single filter of one noise, so that it has no short formula")
        .with_hint("ask without --formula for its mean")
}

/// A polynomial in s, descending coefficients with twelve digits: eight lose a digit or two of the mean where roots lie close.
fn polynomial(c: &[f64]) -> String {
    let top = c.len() - 1;
    let term = |(k, x): (usize, &f64)| {
        (*x != 0.0).then(|| match top - k {
            0 => significant(*x, 12),
            1 => format!("{}*s", significant(*x, 12)),
            power => format!("{}*s^{power}", significant(*x, 12)),
        })
    };
    c.iter().enumerate().filter_map(term).collect::<Vec<_>>().join(" + ").replace("+ -", "- ")
}
