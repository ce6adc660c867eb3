//! A ratio in factors, as a person would write it.
//!
//! Purpose: known factors kept factored, powers collected, the leading constant in front.
//! Method: trial division by known factors; then the common divisors of the coefficients in each symbol, and
//! repeated factors by the derivative; each factor is printed in the shortest reading that the relations allow.
//! References: D. E. Knuth, The Art of Computer Programming 2, section 4.6.1.
//! Numerical aspects: exact. A full factorisation is not attempted: a factor that holds all symbols, stands once
//! and is not among the known ones is not found.

use super::alphabet::{Alphabet, power, whole};
use super::rule::{Rule, normal_form};
use crate::expression::Expr;
use crate::symbolic::fraction::Fraction;
use crate::symbolic::gcd::{content_in, gcd, primitive};
use crate::symbolic::integer::Integer;
use crate::symbolic::polynomial::Polynomial;
use crate::{Error, Result};

/// A factor that is tried first, and how it is written.
pub struct Known {
    polynomial: Polynomial,
    written: Option<Written>,
}

/// An expression and the numbers p/q by which its value is p/q times the polynomial.
#[derive(Clone)]
struct Written {
    expression: Expr,
    numbers: (Integer, Integer),
}

/// Alphabet, relations and known factors: what a ratio is written with.
pub struct Writer<'a> {
    pub alphabet: &'a Alphabet,
    /// The relations, left to right.
    pub rules: &'a [Rule],
    /// The known factors.
    pub known: &'a [Known],
}

impl Known {
    /// A factor; `keep` prints it as it is written.
    pub fn new(expression: &Expr, keep: bool, alphabet: &Alphabet, rules: &[Rule]) -> Result<Self> {
        let form = normal_form(&alphabet.fraction(expression)?, rules)?;
        let polynomial = primitive(&form.numerator)?;
        let written = form.denominator.as_constant().filter(|_| keep).map(|below| Written {
            expression: expression.clone(),
            numbers: (form.numerator.content(), below),
        });
        Ok(Self { polynomial, written })
    }

    /// The factor as a polynomial.
    pub fn polynomial(&self) -> &Polynomial {
        &self.polynomial
    }

    /// A factor without a form of its own, less what is no sum in it.
    pub fn plain(polynomial: &Polynomial, rules: &[Rule]) -> Result<Self> {
        let form = normal_form(&Fraction::whole(polynomial.clone()), rules)?.numerator;
        let unit = Polynomial::term(form.ring(), form.common_monomial(), Integer::ONE);
        let polynomial = primitive(&form.divided_by(&unit)?.unwrap_or(form))?;
        Ok(Self { polynomial, written: None })
    }
}

/// Factors with powers, negative below the line.
struct Parts {
    above: Integer,
    below: Integer,
    symbols: Vec<i32>,
    sums: Vec<Sum>,
}

/// A sum to a power; what may as well stand with the other sign knows how it looks then.
struct Sum {
    written: Expr,
    turned: Option<Expr>,
    count: i32,
}

impl Writer<'_> {
    /// The ratio as an expression in factors.
    pub fn write(&self, fraction: &Fraction) -> Result<Expr> {
        let form = normal_form(fraction, self.rules)?;
        if form.is_zero() {
            return Ok(Expr::Number(0.0));
        }
        let mut parts = Parts {
            above: Integer::ONE,
            below: Integer::ONE,
            symbols: vec![0; self.alphabet.atoms().len()],
            sums: Vec::new(),
        };
        self.take(&form.numerator, 1, &mut parts)?;
        self.take(&form.denominator, -1, &mut parts)?;
        parts.expression(self.alphabet)
    }

    /// Splits a polynomial into parts of the given sign of power.
    fn take(&self, polynomial: &Polynomial, sign: i32, parts: &mut Parts) -> Result<()> {
        let mut rest = parts.monomial(polynomial, sign)?;
        for known in self.known.iter().filter(|known| known.polynomial.terms().len() > 1) {
            let mut count = 0;
            while let Some(quotient) = rest.divided_by(&known.polynomial)? {
                rest = quotient;
                count += sign;
            }
            if count != 0 {
                self.place(known, count, parts)?;
            }
        }
        for (factor, count) in split(&rest)? {
            self.place(&Known { polynomial: factor, written: None }, count * sign, parts)?;
        }
        Ok(())
    }

    /// Puts a factor among the parts, in its own form or in the shortest one.
    fn place(&self, known: &Known, count: i32, parts: &mut Parts) -> Result<()> {
        if let Some(Written { expression, numbers }) = &known.written {
            // expression = p/q · polynomial, so polynomial = q/p · expression
            parts.number(&numbers.1, count);
            parts.number(&numbers.0, -count);
            parts.sum(expression.clone(), None, count);
            return Ok(());
        }
        let short = self.shortest(&known.polynomial)?;
        parts.number(&short.denominator.content(), -count);
        let rest = parts.monomial(&short.numerator, count)?;
        if rest.as_constant().is_none() {
            let minus = rest.terms().iter().filter(|(_, c)| c.is_negative()).count();
            let turned = (2 * minus >= rest.terms().len())
                .then(|| self.alphabet.sum(&rest.scaled(&Integer::from(-1))))
                .transpose()?;
            parts.sum(self.alphabet.sum(&rest)?, turned, count);
        }
        Ok(())
    }

    /// The reading with the fewest terms, then the fewest symbols, over a number.
    fn shortest(&self, polynomial: &Polynomial) -> Result<Fraction> {
        let cost = |p: &Polynomial| {
            let symbols: usize = p.terms().iter().map(|(m, _)| p.ring().powers(*m).count()).sum();
            (p.terms().len(), symbols)
        };
        let mut best = Fraction::whole(polynomial.clone());
        for rule in self.rules {
            for backward in rule.backward(self.alphabet)? {
                let reading = backward.applied(&best.numerator)?;
                if reading.denominator.as_constant().is_some()
                    && cost(&reading.numerator) < cost(&best.numerator)
                {
                    let below = Fraction::whole(best.denominator.clone());
                    best = reading.over(&below)?;
                }
            }
        }
        Ok(best)
    }
}

impl Parts {
    fn number(&mut self, value: &Integer, count: i32) {
        for _ in 0..count.unsigned_abs() {
            let place = if count > 0 { &mut self.above } else { &mut self.below };
            *place = place.times(value);
        }
    }

    /// Takes the number and the common symbols out of a polynomial and returns the rest.
    fn monomial(&mut self, polynomial: &Polynomial, count: i32) -> Result<Polynomial> {
        let (content, common) = (polynomial.content(), polynomial.common_monomial());
        self.number(&content, count);
        for (symbol, exponent) in polynomial.ring().powers(common) {
            self.symbols[symbol] += count * exponent as i32;
        }
        let unit = Polynomial::term(polynomial.ring(), common, content);
        polynomial.divided_by(&unit)?.ok_or_else(|| Error::not_computed("a content that does not divide"))
    }

    fn sum(&mut self, written: Expr, turned: Option<Expr>, count: i32) {
        match self.sums.iter_mut().find(|known| known.written == written) {
            Some(known) => known.count += count,
            None => self.sums.push(Sum { written, turned, count }),
        }
    }

    /// Turns one sum with as many minus as plus signs, where that saves the minus before the whole.
    fn save_minus(&mut self) -> bool {
        let odd = self.sums.iter_mut().find(|sum| sum.turned.is_some() && sum.count % 2 != 0);
        let turned = odd.and_then(|sum| sum.turned.take().map(|turned| sum.written = turned));
        turned.is_some()
    }

    fn expression(mut self, alphabet: &Alphabet) -> Result<Expr> {
        let common = self.above.gcd(&self.below);
        let lowest = |x: &Integer| x.divided_by(&common).unwrap_or_else(|| x.clone());
        let minus = self.above.is_negative() != self.below.is_negative();
        let negative = minus && !self.save_minus();
        let above = self.side(1, &lowest(&self.above.magnitude()), alphabet)?;
        let below = self.side(-1, &lowest(&self.below.magnitude()), alphabet)?;
        let size = match (above, below) {
            (above, None) => above.unwrap_or(Expr::Number(1.0)),
            (above, Some(below)) => above.unwrap_or(Expr::Number(1.0)) / below,
        };
        Ok(if negative { -size } else { size })
    }

    /// One side of the line: the number, the names, the sums, the calls.
    fn side(&self, sign: i32, number: &Integer, alphabet: &Alphabet) -> Result<Option<Expr>> {
        let number = (*number != Integer::ONE).then(|| whole(number)).transpose()?;
        let symbol = |calls: bool| {
            let atoms = alphabet.atoms().iter().zip(&self.symbols);
            atoms.filter(move |(atom, count)| **count * sign > 0 && matches!(atom, Expr::Call(..)) == calls)
        };
        let raised = |(base, count): (&Expr, &i32)| power(base, count.unsigned_abs());
        let here = self.sums.iter().filter(|sum| sum.count * sign > 0);
        let sums = here.map(|sum| power(&sum.written, sum.count.unsigned_abs()));
        let factors =
            number.into_iter().chain(symbol(false).map(raised)).chain(sums).chain(symbol(true).map(raised));
        Ok(factors.reduce(|x, y| x * y))
    }
}

/// Factors found by the common divisors of coefficients and by derivatives, with their powers.
fn split(polynomial: &Polynomial) -> Result<Vec<(Polynomial, i32)>> {
    if polynomial.as_constant().is_some() {
        return Ok(Vec::new());
    }
    let symbols = polynomial.ring().names().len();
    for symbol in (0..symbols).filter(|k| polynomial.degree(*k) > 0) {
        let divisor = match content_in(symbol, polynomial)? {
            content if content.as_constant().is_none() => content,
            _ => gcd(polynomial, &polynomial.derivative(symbol)?)?,
        };
        if divisor.as_constant().is_none()
            && let Some(rest) = polynomial.divided_by(&divisor)?
        {
            let mut factors: Vec<(Polynomial, i32)> = Vec::new();
            for (factor, count) in split(&primitive(&rest)?)?.into_iter().chain(split(&primitive(&divisor)?)?)
            {
                match factors.iter_mut().find(|(known, _)| *known == factor) {
                    Some((_, power)) => *power += count,
                    None => factors.push((factor, count)),
                }
            }
            return Ok(factors);
        }
    }
    Ok(vec![(polynomial.clone(), 1)])
}
