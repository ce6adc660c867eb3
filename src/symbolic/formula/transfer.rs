//! A mean value over doubles.
//!
//! Purpose: what a formula is held against.
//! Method: transfer functions are multiplied out over doubles, not with the symbolic algebra, and the engine integrates.
//! References: none needed.
//! Numerical aspects: the engine gives all digits for the coefficients that come out of the multiplication.

use super::calculus::value;
use super::derive::{LAPLACE, Source};
use super::sampler::Values;
use crate::expression::{BinaryOp, Expr};
use crate::integral::{Integrand, evaluate};
use crate::{Error, ErrorKind, Result};

/// A mean value over doubles and the size of what it is summed from.
#[derive(Clone, Copy, Debug)]
pub struct Mean {
    /// The mean at these numbers, by the engine.
    pub value: f64,
    /// The largest of its parts, one for each coefficient of G; what is small against it is rounding.
    pub scale: f64,
}

/// H and G at given values of the symbols.
pub struct Numbers {
    /// a0 … an.
    pub a: Vec<f64>,
    /// b0 … b(n-1), with the odd part of G left out.
    pub b: Vec<f64>,
    /// What b was summed from, in size.
    sizes: Vec<f64>,
    /// What stands before the integral.
    factor: f64,
}

impl Numbers {
    /// H and G of a source.
    ///
    /// # Errors
    /// Bad input, where a symbol has no value or H is a constant there; out of range, where the mean is infinite.
    pub fn new(source: &Source, values: &Values) -> Result<Self> {
        let of = |e: &Expr| Ratio::of(e, values);
        let (h, g, sizes, factor) = match source {
            Source::Ratio { h, g } => {
                let (h, g) = (of(h)?, of(g)?);
                let (below_h, below_g) = (h.below[0], g.below[0]);
                let sizes = magnitudes(&g.above);
                (h.above, g.above, sizes, below_h * below_h / below_g)
            }
            Source::MeanProduct { first, second, shaping, density } => {
                let shaping = of(shaping)?;
                let (first, second) = (of(first)?.times(&shaping), of(second)?.times(&shaping));
                // of one denominator every root counts once
                let one = vec![1.0];
                let (h, to_first, to_second) = if first.below == second.below {
                    (first.below.clone(), &one, &one)
                } else {
                    (convolved(&first.below, &second.below), &second.below, &first.below)
                };
                let left = convolved(&first.above, to_first);
                let right = mirrored(&convolved(&second.above, to_second));
                let sizes = convolved(&magnitudes(&left), &magnitudes(&right));
                let density = value(density, &|n| values.get(n).copied())?;
                (h, convolved(&left, &right), sizes, density)
            }
        };
        let ((a, b), (_, sizes)) = (descending(&h, &g), descending(&h, &sizes));
        if a.len() < 2 {
            return Err(Error::bad_input("H is a constant at these values"));
        }
        if b.len() + 1 != a.len() || sizes.len() != b.len() {
            return Err(Error::new(
                ErrorKind::OutOfRange,
                "the mean is infinite: G has too high a degree in s at these values",
            ));
        }
        if !a.iter().chain(&b).chain(&sizes).all(|x| x.is_finite()) {
            return Err(Error::new(ErrorKind::OutOfRange, "H or G is no finite number at these values"));
        }
        Ok(Self { a, b, sizes, factor })
    }

    fn integral(&self, b: &[f64]) -> Result<f64> {
        Ok(evaluate(&Integrand::new(&self.a, b)?)?.value)
    }

    /// The mean value.
    ///
    /// # Errors
    /// Those of the engine: unstable, imaginary axis, out of range, bad input.
    pub fn mean(&self) -> Result<Mean> {
        let whole = self.integral(&self.b)?;
        let mut scale = whole.abs();
        for (k, size) in self.sizes.iter().enumerate() {
            let mut alone = vec![0.0; self.b.len()];
            alone[k] = *size;
            scale = scale.max(self.integral(&alone).map_or(0.0, f64::abs));
        }
        Ok(Mean { value: self.factor * whole, scale: self.factor.abs() * scale })
    }
}

/// The mean value over doubles.
///
/// # Errors
/// Unstable or imaginary axis, where H is not stable at these values; out of range, where the mean is infinite; bad
/// input, where a symbol has no value.
pub fn numeric(source: &Source, values: &Values) -> Result<Mean> {
    Numbers::new(source, values)?.mean()
}

fn magnitudes(x: &[f64]) -> Vec<f64> {
    x.iter().map(|c| c.abs()).collect()
}

/// a0 … an and b0 … b(n-1) from coefficients of rising powers.
fn descending(h: &[f64], g: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let mut a = h.to_vec();
    while a.last() == Some(&0.0) {
        a.pop();
    }
    a.reverse();
    let mut b: Vec<f64> = g.iter().copied().step_by(2).collect();
    while b.last() == Some(&0.0) && b.len() >= a.len() {
        b.pop();
    }
    b.resize(b.len().max(a.len().saturating_sub(1)), 0.0);
    b.reverse();
    (a, b)
}

fn convolved(x: &[f64], y: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; x.len() + y.len() - 1];
    for (i, x) in x.iter().enumerate() {
        for (k, y) in y.iter().enumerate() {
            product[i + k] += x * y;
        }
    }
    product
}

fn mirrored(x: &[f64]) -> Vec<f64> {
    x.iter().enumerate().map(|(k, c)| if k % 2 == 1 { -c } else { *c }).collect()
}

/// A ratio of polynomials in s over doubles, rising powers.
struct Ratio {
    above: Vec<f64>,
    below: Vec<f64>,
}

impl Ratio {
    fn of(expression: &Expr, values: &Values) -> Result<Self> {
        let constant = |x: f64| Self { above: vec![x], below: vec![1.0] };
        if !expression.mentions(LAPLACE) {
            return Ok(constant(value(expression, &|n| values.get(n).copied())?));
        }
        Ok(match expression {
            Expr::Neg(inner) => Self::of(inner, values)?.times(&constant(-1.0)),
            Expr::Binary(BinaryOp::Add, x, y) => Self::of(x, values)?.plus(&Self::of(y, values)?),
            Expr::Binary(BinaryOp::Sub, x, y) => {
                Self::of(x, values)?.plus(&Self::of(y, values)?.times(&constant(-1.0)))
            }
            Expr::Binary(BinaryOp::Mul, x, y) => Self::of(x, values)?.times(&Self::of(y, values)?),
            Expr::Binary(BinaryOp::Div, x, y) => Self::of(x, values)?.times(&Self::of(y, values)?.inverted()),
            Expr::Binary(BinaryOp::Pow, base, exponent) => {
                let exponent = exponent.constant().unwrap_or(f64::NAN);
                let base = Self::of(base, values)?;
                let base = if exponent < 0.0 { base.inverted() } else { base };
                (0..exponent.abs() as u32).fold(constant(1.0), |product, _| product.times(&base))
            }
            _ => Self { above: vec![0.0, 1.0], below: vec![1.0] },
        })
    }

    fn times(&self, other: &Self) -> Self {
        Self { above: convolved(&self.above, &other.above), below: convolved(&self.below, &other.below) }
    }

    fn plus(&self, other: &Self) -> Self {
        if self.below == other.below {
            let length = self.above.len().max(other.above.len());
            let at = |x: &[f64], k: usize| x.get(k).copied().unwrap_or(0.0);
            let above = (0..length).map(|k| at(&self.above, k) + at(&other.above, k)).collect();
            return Self { above, below: self.below.clone() };
        }
        let common = Self { above: self.below.clone(), below: self.below.clone() };
        let other_common = Self { above: other.below.clone(), below: other.below.clone() };
        self.times(&other_common).plus(&Self {
            above: convolved(&other.above, &common.above),
            below: convolved(&common.below, &other.below),
        })
    }

    fn inverted(self) -> Self {
        Self { above: self.below, below: self.above }
    }
}
