//! From transfer functions to a mean value in symbols.
//!
//! Purpose: the mean product of two signals that one noise drives, as a formula.
//! Method: H is the least common denominator of both transfer functions with the shaping filter, G the even part of
//! the product of the numerators, one of them at −s; I_n by the shared minors of its order.
//! References: seed (3.7) – (3.12); James, Nichols, Phillips, Theory of Servomechanisms (1947), chapter 7.
//! Numerical aspects: exact. A white part at lag zero counts as the mean of both sides, since the odd part of G
//! integrates to nothing.

use super::alphabet::Alphabet;
use crate::expression::Expr;
use crate::symbolic::fraction::Fraction;
use crate::symbolic::gcd::gcd;
use crate::symbolic::integer::Integer;
use crate::symbolic::minors::{HIGHEST_ORDER, Program};
use crate::symbolic::polynomial::Polynomial;
use crate::{Error, ErrorKind, Result};
use std::ops::{Add, Mul, Neg};

/// The name of the variable of transfer functions.
pub const LAPLACE: &str = "s";

/// What is integrated: (1/2π) ∫ … dω over all ω, with s = jω.
#[derive(Clone, PartialEq, Debug)]
pub enum Source {
    /// G(s)/(H(s)H(−s)).
    Ratio {
        /// H, all roots in the left half plane.
        h: Expr,
        /// G, even in s.
        g: Expr,
    },
    /// The mean product of two signals.
    MeanProduct {
        /// From the shaped noise to the first signal.
        first: Expr,
        /// From the shaped noise to the second signal.
        second: Expr,
        /// From white noise to the shaped noise.
        shaping: Expr,
        /// The density of the white noise, ∫ of its correlation over all lags.
        density: Expr,
    },
}

/// H and G over the symbols, and the factor before the integral of G/(H H).
pub struct Prepared {
    /// Coefficients a0 … an.
    pub a: Vec<Polynomial>,
    /// Coefficients b0 … b(n-1).
    pub b: Vec<Polynomial>,
    /// What multiplies I_n.
    pub factor: Fraction,
}

impl Source {
    /// The expressions in it.
    pub fn expressions(&self) -> Vec<&Expr> {
        match self {
            Self::Ratio { h, g } => vec![h, g],
            Self::MeanProduct { first, second, shaping, density } => vec![first, second, shaping, density],
        }
    }

    /// The expressions that decide on stability.
    pub fn poles(&self) -> Vec<&Expr> {
        match self {
            Self::Ratio { h, .. } => vec![h],
            Self::MeanProduct { first, second, shaping, .. } => vec![first, second, shaping],
        }
    }

    /// H, G and the factor before them.
    pub fn prepare(&self, alphabet: &Alphabet) -> Result<Prepared> {
        let fraction = |e: &Expr| alphabet.fraction(e);
        let (h, g, factor) = match self {
            Self::Ratio { h, g } => {
                let (h, g) = (fraction(h)?, fraction(g)?);
                let odd = |s: usize| {
                    Ok::<_, Error>(
                        g.numerator.coefficients(s)?.iter().skip(1).step_by(2).any(|c| !c.is_zero()),
                    )
                };
                if laplace(alphabet).map_or(Ok(false), odd)? {
                    return Err(Error::usage(
                        "G has an odd part in s, which counts for nothing in the integral",
                    )
                    .with_hint("write G in even powers: G(jω) with ω² as -s^2"));
                }
                let scale = Fraction::whole(h.denominator.times(&h.denominator)?);
                (h.numerator, g.numerator, scale.over(&Fraction::whole(g.denominator))?)
            }
            Self::MeanProduct { first, second, shaping, density } => {
                let shaping = fraction(shaping)?;
                let (first, second) = (fraction(first)?.times(&shaping)?, fraction(second)?.times(&shaping)?);
                let (h, g) = product(&first, &second, alphabet)?;
                (h, g, fraction(density)?)
            }
        };
        let under = |atom: &&Expr| matches!(atom, Expr::Call(..)) && atom.mentions(LAPLACE);
        if let Some(call) = alphabet.atoms().iter().find(under) {
            return Err(Error::bad_input(format!("s stands under a function: {call}"))
                .with_hint("transfer functions are ratios of polynomials in s"));
        }
        let symbol = laplace(alphabet);
        let above_below = [&factor.numerator, &factor.denominator];
        if symbol.is_some_and(|s| above_below.iter().any(|p| p.degree(s) > 0)) {
            return Err(Error::bad_input("H and G must be polynomials in s, and the density free of s"));
        }
        let (a, b) = coefficients(&h, &g, symbol)?;
        Ok(Prepared { a, b, factor })
    }
}

fn laplace(alphabet: &Alphabet) -> Option<usize> {
    alphabet.index(LAPLACE)
}

/// H and G of two transfer functions from one white noise.
fn product(first: &Fraction, second: &Fraction, alphabet: &Alphabet) -> Result<(Polynomial, Polynomial)> {
    let common = gcd(&first.denominator, &second.denominator)?;
    let divided = |x: &Polynomial| Ok::<_, Error>(x.divided_by(&common)?.expect("a common divisor divides"));
    let h = divided(&first.denominator)?.times(&second.denominator)?;
    let left = first.numerator.times(&divided(&second.denominator)?)?;
    let right = second.numerator.times(&divided(&first.denominator)?)?;
    Ok((h, left.times(&mirrored(&right, laplace(alphabet)))?))
}

/// p(−s)
fn mirrored(polynomial: &Polynomial, symbol: Option<usize>) -> Polynomial {
    let ring = polynomial.ring();
    let odd = |m| symbol.is_some_and(|s| ring.exponent(m, s) % 2 == 1);
    let terms = polynomial.terms().iter().map(|(m, c)| (*m, if odd(*m) { -c } else { c.clone() }));
    Polynomial::collect(ring, terms.collect())
}

/// a0 … an and b0 … b(n-1), with the odd part of G left out.
fn coefficients(
    h: &Polynomial,
    g: &Polynomial,
    symbol: Option<usize>,
) -> Result<(Vec<Polynomial>, Vec<Polynomial>)> {
    let n = symbol.map_or(0, |s| h.degree(s)) as usize;
    let (Some(symbol), 1..=HIGHEST_ORDER) = (symbol, n) else {
        return Err(Error::bad_input(format!("H has the order {n} in s"))
            .with_hint(format!("orders go from 1 to {HIGHEST_ORDER}")));
    };
    let mut a = h.coefficients(symbol)?;
    a.reverse();
    let mut even: Vec<Polynomial> = g.coefficients(symbol)?.into_iter().step_by(2).collect();
    while even.len() > n && even.last().is_some_and(Polynomial::is_zero) {
        even.pop();
    }
    if even.len() > n {
        return Err(Error::new(
            ErrorKind::OutOfRange,
            format!("the mean is infinite: G has the degree {} in s, H only {n}", 2 * even.len() - 2),
        )
        .with_hint("a signal with a white part has no finite mean square; filter it first"));
    }
    even.resize(n, Polynomial::constant(h.ring(), 0));
    even.reverse();
    Ok((a, even))
}

impl Prepared {
    /// The integral, reduced; factors of its denominator may be known.
    pub fn integral<'a>(&self, factors: impl IntoIterator<Item = &'a Polynomial>) -> Result<Fraction> {
        let program = Program::new(self.b.len())?;
        let checked = |p: &Vec<Polynomial>| p.iter().cloned().map(|p| Checked(Ok(p))).collect::<Vec<_>>();
        let (above, below) = program.evaluate(&checked(&self.a), &checked(&self.b));
        let below = below.0?;
        if below.is_zero() {
            return Err(Error::new(
                ErrorKind::ImaginaryAxis,
                "H has a root on the imaginary axis for all values",
            )
            .with_hint(
                "the mean is infinite, as an integrator needs a leak; a root at 0 that G has as well is to be cancelled in both \
                 before",
            ));
        }
        Fraction::in_factors(&above.0?, &below, factors)?.times(&self.factor)
    }
}

/// The Hurwitz determinant of a polynomial with coefficients a0 … an.
pub fn hurwitz(a: &[Polynomial]) -> Result<Polynomial> {
    let program = Program::new(a.len() - 1)?;
    let zero = vec![Checked(Ok(Polynomial::constant(a[0].ring(), 0))); a.len() - 1];
    let a: Vec<Checked> = a.iter().cloned().map(|p| Checked(Ok(p))).collect();
    let below = program.evaluate(&a, &zero).1.0?;
    let twice_lead = a[0].0.clone()?.scaled(&Integer::from(2));
    below.divided_by(&twice_lead)?.ok_or_else(|| Error::bad_input("H has no leading coefficient"))
}

/// A polynomial, or why it could not be formed.
#[derive(Clone)]
struct Checked(Result<Polynomial>);

impl Checked {
    fn with(self, other: Self, op: impl Fn(&Polynomial, &Polynomial) -> Result<Polynomial>) -> Self {
        Self(self.0.and_then(|x| op(&x, &other.0?)))
    }
}

impl Add for Checked {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.with(other, |x, y| Ok(x.plus(y)))
    }
}

impl Mul for Checked {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.with(other, Polynomial::times)
    }
}

impl Neg for Checked {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|x| x.scaled(&Integer::from(-1))))
    }
}
