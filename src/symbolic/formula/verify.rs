//! A derived formula against the numeric engine.
//!
//! Purpose: nothing is printed that was not checked at random points.
//! Method: symbols take random positive values; where no such values make H stable, a walk from the damping of the
//! least damped root leads to values that do.
//! References: none needed.
//! Numerical aspects: points where H is not stable, and points where the formula loses more than the tolerance by
//! rounding, are drawn anew; the rest must agree to 1e-8.

use super::Simplifier;
use super::bounded::bounded;
use super::calculus::value;
use super::derive::Source;
use super::rule::Relation;
use super::sampler::{Sampler, Values};
use super::transfer::numeric;
use super::walk::Walk;
use crate::expression::Expr;
use crate::{Error, ErrorKind, Result};

/// Agreement that is asked for.
const TOLERANCE: f64 = 1e-8;
/// Points that must agree.
pub const POINTS: usize = 32;
/// Draws before a walk is begun, and points tried on the walk.
const MOST_DRAWS: usize = 400;

/// Compares times·(mean value of the source) with the derived formula at random points; returns their number.
///
/// # Errors
/// Not computed, where a point differs or no stable point is found; unstable, where H has no letters that could help.
pub fn check(source: &Source, times: &Expr, relations: &[Relation], derived: &Expr) -> Result<usize> {
    let mut expressions = source.expressions();
    expressions.extend([times, derived]);
    let mut sampler = Sampler::new(&expressions, relations);
    let mut agreed = 0;
    let comparison = Comparison { source, times, derived };
    let mut last = None;
    for _ in 0..MOST_DRAWS {
        let Some(values) = sampler.draw(&Values::new())? else { continue };
        match comparison.agrees(&values)? {
            Ok(true) => agreed += 1,
            Ok(false) => {}
            Err(e) => last = Some(e),
        }
        if agreed == POINTS {
            return Ok(agreed);
        }
    }
    let mut walk = Walk::new(source, sampler);
    if !walk.can_move()
        && let Some(e) = last
    {
        return Err(e);
    }
    for _ in 0..MOST_DRAWS {
        let Some(values) = walk.next_stable()? else { break };
        agreed += usize::from(comparison.agrees(&values)?.unwrap_or(false));
        if agreed == POINTS {
            return Ok(agreed);
        }
    }
    Err(Error::not_computed("no values were found for which H is stable, so the formula cannot be checked")
        .with_hint(
            "symbols stand for positive numbers: write the minus signs out, and relations that must hold",
        ))
}

/// A derived formula and what it must be equal to.
struct Comparison<'a> {
    source: &'a Source,
    times: &'a Expr,
    derived: &'a Expr,
}

impl Comparison<'_> {
    /// Whether a point counts: it does not where rounding drowns the comparison. The inner error says why H has no mean.
    fn agrees(&self, values: &Values) -> Result<Result<bool>> {
        let mean = match numeric(self.source, values) {
            Ok(mean) => mean,
            Err(e) if is_no_mean(&e) => return Ok(Err(e)),
            Err(e) => return Err(e),
        };
        let times = value(self.times, &|name| values.get(name).copied())?;
        let (wanted, scale) = (times * mean.value, (times * mean.scale).abs());
        let found = bounded(self.derived, values)?;
        if found.bound > TOLERANCE * scale {
            return Ok(Ok(false));
        }
        if wanted.is_finite() && (wanted - found.value).abs() <= TOLERANCE * scale {
            return Ok(Ok(true));
        }
        let says = format!("the engine gives {wanted}, the formula {}", found.value);
        Err(Error::not_computed(format!("the derived formula is not printed: {says}"))
            .with_hint(format!("at {values:?}; please report this")))
    }
}

/// A Hurwitz determinant that vanishes for all values comes from roots on the imaginary axis or from roots opposite to
/// each other; the engine knows which at some values.
pub fn true_reason(source: &Source, simplifier: &Simplifier, found: Error) -> Error {
    let mut sampler = Sampler::new(&source.expressions(), &simplifier.relations);
    match sampler.draw(&Values::new()).map(|values| values.map(|values| numeric(source, &values))) {
        Ok(Some(Err(e))) if found.kind() == ErrorKind::ImaginaryAxis && e.kind() == ErrorKind::Unstable => {
            Error::new(ErrorKind::Unstable, "H has opposite roots for all values, so it is not stable")
        }
        _ => found,
    }
}

/// Whether an error says that there is no mean value at some values.
pub fn is_no_mean(e: &Error) -> bool {
    matches!(e.kind(), ErrorKind::Unstable | ErrorKind::ImaginaryAxis | ErrorKind::OutOfRange)
}
