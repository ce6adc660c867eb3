//! Mean products on a sine.
//!
//! Purpose: the mean product of two signals that one sine drives, as a formula.
//! Method: y₁ = F(s) u and y₂ = X(s) u of u = a sin pt have the mean product ½a² Re F(jp) X(−jp), which is the even part
//! ½(F(s)X(−s) + F(−s)X(s)) with s² = −p².
//! References: none needed.
//! Numerical aspects: exact. Checked at random points by complex arithmetic in doubles, which shares nothing with the
//! symbolic algebra.

use super::calculus::value;
use super::derive::LAPLACE;
use super::sampler::{Sampler, Values};
use super::{Derived, Formula, Relation, Simplifier, verify};
use crate::expression::{BinaryOp, Expr};
use crate::{Error, Result};
use num_complex::Complex64;

/// What is to be derived: times · ⟨F u · X u⟩ for u = a sin pt.
///
/// ```
/// use gyrospec::expression::Expr;
/// use gyrospec::symbolic::{Simplifier, SineMean};
/// let read = |text: &str| Expr::parse(text).unwrap();
/// let mean = SineMean {
///     name: "x2".into(),
///     first: read("1/(T*s + 1)"),
///     second: read("1/(T*s + 1)"),
///     amplitude: read("a"),
///     frequency: "p".into(),
///     times: read("1"),
/// };
/// let derived = mean.derived(&Simplifier::default())?;
/// assert_eq!(derived.formula.text(), "x2 = a² / (2(1 + T²p²))");
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Clone, PartialEq, Debug)]
pub struct SineMean {
    /// The name of the result.
    pub name: String,
    /// F.
    pub first: Expr,
    /// X.
    pub second: Expr,
    /// a.
    pub amplitude: Expr,
    /// The name of p.
    pub frequency: String,
    /// What stands before the mean.
    pub times: Expr,
}

impl SineMean {
    /// The formula, checked; it needs no integral, so that its order is 0.
    ///
    /// # Errors
    /// Not computed, where it is beyond simplification or a check fails.
    pub fn derived(&self, simplifier: &Simplifier) -> Result<Derived> {
        let mut simplifier = simplifier.clone();
        simplifier.relations.push(Relation::parse(&format!("{LAPLACE}^2 = -{}^2", self.frequency))?);
        let mirror = |e: &Expr| e.substitute(LAPLACE, &Expr::Neg(Box::new(Expr::name(LAPLACE))));
        let product = |a: &Expr, b: &Expr| a.clone() * mirror(b);
        // ½a²·½(F(s)X(−s) + F(−s)X(s))
        let both = product(&self.first, &self.second) + product(&self.second, &self.first);
        let mean = self.times.clone() * self.amplitude.clone().pow(2.0) * both / Expr::number(4.0);
        let expression = simplifier.simplify(&mean)?;
        let formula = Formula { name: self.name.clone(), by: Vec::new(), expression };
        let points = self.checked(&formula, &simplifier)?;
        Ok(Derived { formula, order: 0, points })
    }

    /// The mean at given values by complex arithmetic, without the formula.
    ///
    /// # Errors
    /// Bad input, where a symbol has no value.
    pub fn mean(&self, values: &Values) -> Result<f64> {
        let of = |e: &Expr| value(e, &|name| values.get(name).copied());
        let s = Complex64::new(0.0, of(&Expr::name(&self.frequency))?);
        let product = at(&self.first, s, values)? * at(&self.second, s, values)?.conj();
        Ok(of(&self.times)? * 0.5 * of(&self.amplitude)?.powi(2) * product.re)
    }

    fn checked(&self, formula: &Formula, simplifier: &Simplifier) -> Result<usize> {
        if formula.expression.mentions(LAPLACE) {
            return Err(Error::not_computed("s is left in the mean on a sine"));
        }
        let all = [&self.first, &self.second, &self.amplitude, &self.times, &formula.expression];
        let relations: Vec<Relation> =
            simplifier.relations.iter().filter(|r| !r.left.mentions(LAPLACE)).cloned().collect();
        let mut sampler = Sampler::new(&all, &relations);
        for _ in 0..verify::POINTS {
            let Some(values) = sampler.draw(&Values::new())? else {
                return Err(Error::not_computed("the relations have no point at which to check the formula"));
            };
            let (mean, told) = (self.mean(&values)?, formula.evaluate(&values)?);
            let agrees = (mean - told).abs() <= 1e-9 * (mean.abs() + told.abs());
            if !agrees {
                return Err(Error::not_computed(format!(
                    "the formula gives {told}, complex arithmetic {mean}"
                )));
            }
        }
        Ok(verify::POINTS)
    }
}

/// A ratio of polynomials in s at a complex s.
fn at(e: &Expr, s: Complex64, values: &Values) -> Result<Complex64> {
    if !e.mentions(LAPLACE) {
        return Ok(Complex64::from(value(e, &|name| values.get(name).copied())?));
    }
    Ok(match e {
        Expr::Name(_) => s,
        Expr::Neg(inner) => -at(inner, s, values)?,
        Expr::Binary(op, x, y) => {
            let left = at(x, s, values)?;
            match op {
                BinaryOp::Add => left + at(y, s, values)?,
                BinaryOp::Sub => left - at(y, s, values)?,
                BinaryOp::Mul => left * at(y, s, values)?,
                BinaryOp::Div => left / at(y, s, values)?,
                BinaryOp::Pow => left.powf(y.constant().unwrap_or(f64::NAN)),
            }
        }
        _ => return Err(Error::bad_input(format!("s stands under a function: {e}"))),
    })
}
