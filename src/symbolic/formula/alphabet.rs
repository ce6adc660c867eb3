//! From expressions to ratios of polynomials and back.
//!
//! Purpose: an expression in named symbols as exact algebra.
//! Method: names, and calls of functions of canonical arguments, are the symbols of a ring; half powers are powers
//! of a square root.
//! References: none needed.
//! Numerical aspects: decimal numbers are taken as the decimal fractions that they are written as.

use super::text::leading_minus;
use crate::expression::{BinaryOp, Expr, Function};
use crate::symbolic::fraction::Fraction;
use crate::symbolic::integer::Integer;
use crate::symbolic::polynomial::Polynomial;
use crate::symbolic::ring::{Monomial, Ring};
use crate::{Error, Result};
use dashu_int::IBig;
use std::sync::Arc;

/// The highest whole power that is multiplied out.
const HIGHEST_POWER: f64 = 200.0;

/// The longest sum that is written.
const MOST_TERMS: usize = 2000;

/// The symbols of a formula: names and calls, in the order in which they are printed.
#[derive(Debug)]
pub struct Alphabet {
    ring: Arc<Ring>,
    atoms: Vec<Expr>,
}

impl Alphabet {
    /// The symbols of some expressions; the names in `first` lead, the others follow as they appear, calls come last.
    pub fn new(expressions: &[&Expr], first: &[String]) -> Result<Self> {
        let mut atoms: Vec<Expr> = first.iter().map(Expr::name).collect();
        let mut calls = Vec::new();
        for expression in expressions {
            gather(&normal(expression)?, &mut atoms, &mut calls);
        }
        atoms.extend(calls);
        let ring = Ring::new(atoms.iter().map(ToString::to_string).collect())?;
        Ok(Self { ring, atoms })
    }

    /// The ring of the symbols.
    pub fn ring(&self) -> &Arc<Ring> {
        &self.ring
    }

    /// The expressions that the symbols stand for.
    pub fn atoms(&self) -> &[Expr] {
        &self.atoms
    }

    /// The place of a name.
    pub fn index(&self, name: &str) -> Option<usize> {
        self.ring.index(name)
    }

    /// An expression as a ratio.
    ///
    /// # Errors
    /// Not computed, where it has a symbol outside the alphabet or a power that is neither whole nor half.
    pub fn fraction(&self, expression: &Expr) -> Result<Fraction> {
        self.of_normal(&normal(expression)?)
    }

    fn of_normal(&self, expression: &Expr) -> Result<Fraction> {
        match expression {
            Expr::Number(value) => self.number(*value),
            Expr::Name(_) | Expr::Call(..) => {
                let text = expression.to_string();
                let symbol = self.index(&text).ok_or_else(|| {
                    Error::not_computed(format!("{text} is none of the symbols of this formula"))
                })?;
                Ok(Fraction::whole(Polynomial::symbol(&self.ring, symbol)?))
            }
            Expr::Neg(inner) => Ok(self.of_normal(inner)?.negated()),
            Expr::Binary(BinaryOp::Pow, base, exponent) => {
                let exponent = exponent.constant().unwrap_or(f64::NAN);
                if exponent.fract() != 0.0 || exponent.is_nan() {
                    return Err(Error::not_computed(format!("the power in {expression} is not worked out"))
                        .with_hint("powers are whole or half numbers"));
                }
                if exponent.abs() > HIGHEST_POWER {
                    return Err(Error::not_computed(format!(
                        "the power in {expression} is above {HIGHEST_POWER}"
                    )));
                }
                self.of_normal(base)?.to_power(exponent as i32)
            }
            Expr::Binary(op, left, right) => {
                let (left, right) = (self.of_normal(left)?, self.of_normal(right)?);
                match op {
                    BinaryOp::Add => left.plus(&right),
                    BinaryOp::Sub => left.plus(&right.negated()),
                    BinaryOp::Mul => left.times(&right),
                    BinaryOp::Div | BinaryOp::Pow => left.over(&right),
                }
            }
        }
    }

    fn number(&self, value: f64) -> Result<Fraction> {
        let wrong = || Error::bad_input(format!("{value} is no number for a formula"));
        let text = format!("{value:e}");
        let (digits, exponent) = text.split_once('e').ok_or_else(wrong)?;
        let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
        let digits: IBig = format!("{whole}{decimals}").parse().map_err(|_| wrong())?;
        let exponent = exponent.parse::<i64>().map_err(|_| wrong())? - decimals.len() as i64;
        let scale = IBig::from(10).pow(exponent.unsigned_abs() as usize);
        let constant = |value: IBig| Polynomial::constant(&self.ring, value);
        if exponent < 0 {
            Fraction::new(&constant(digits), &constant(scale))
        } else {
            Ok(Fraction::whole(constant(digits * scale)))
        }
    }

    /// One term without its sign, as an expression.
    pub fn term(&self, monomial: Monomial, coefficient: &Integer) -> Result<Expr> {
        let size = coefficient.magnitude();
        let number = (size != Integer::ONE || monomial == Monomial::ONE).then(|| whole(&size)).transpose()?;
        let powers =
            self.ring.powers(monomial).map(|(symbol, exponent)| power(&self.atoms[symbol], exponent));
        Ok(number.into_iter().chain(powers).reduce(|x, y| x * y).unwrap_or(Expr::Number(1.0)))
    }

    /// A polynomial as a sum, low total degrees first.
    pub fn sum(&self, polynomial: &Polynomial) -> Result<Expr> {
        let count = polynomial.terms().len();
        if count > MOST_TERMS {
            return Err(Error::not_computed(format!(
                "the formula has a sum of {count} terms; {MOST_TERMS} are printed"
            ))
            .with_hint(
                "give several symbols one name or a value; where every coefficient is a symbol of its own, \
                    `gyrospec table` prints the whole of I_n",
            ));
        }
        let degree = |m: Monomial| self.ring.powers(m).map(|(_, e)| e).sum::<u32>();
        let mut terms: Vec<_> = polynomial.terms().iter().collect();
        terms.sort_by_key(|(m, c)| (degree(*m), c.is_negative(), std::cmp::Reverse(*m)));
        let mut sum: Option<Expr> = None;
        for (monomial, coefficient) in terms {
            let term = self.term(*monomial, coefficient)?;
            sum = Some(match (sum, coefficient.is_negative()) {
                (None, false) => term,
                (None, true) => -term,
                (Some(sum), false) => sum + term,
                (Some(sum), true) => sum - term,
            });
        }
        Ok(sum.unwrap_or(Expr::Number(0.0)))
    }

    /// A ratio as an expression, expanded.
    pub fn expression(&self, fraction: &Fraction) -> Result<Expr> {
        let above = self.sum(&fraction.numerator)?;
        let one = Polynomial::constant(&self.ring, 1);
        if fraction.denominator == one { Ok(above) } else { Ok(above / self.sum(&fraction.denominator)?) }
    }
}

/// A whole number as an expression.
///
/// # Errors
/// Not computed, where a double does not hold it.
pub fn whole(value: &Integer) -> Result<Expr> {
    let number = value.to_f64();
    if number.abs() < 9.0e15 {
        return Ok(Expr::number(number));
    }
    let digits = value.magnitude().to_string();
    Err(Error::not_computed(format!(
        "the formula holds a whole number of {} digits, {}…, which is too long to print exactly",
        digits.len(),
        &digits[..6]
    ))
    .with_hint("write a letter in place of very large or very small numbers"))
}

/// A symbol to a whole power.
pub fn power(base: &Expr, exponent: u32) -> Expr {
    if exponent == 1 { base.clone() } else { base.clone().pow(f64::from(exponent)) }
}

fn gather(expression: &Expr, names: &mut Vec<Expr>, calls: &mut Vec<Expr>) {
    match expression {
        Expr::Number(_) => {}
        Expr::Name(_) => {
            if !names.contains(expression) {
                names.push(expression.clone());
            }
        }
        Expr::Call(function, arguments) => {
            if !calls.contains(expression) {
                calls.push(expression.clone());
            }
            if *function == Function::Sqrt {
                // its square is its argument
                for argument in arguments {
                    gather(argument, names, calls);
                }
            }
        }
        _ => {
            for child in expression.children() {
                gather(child, names, calls);
            }
        }
    }
}

/// The expression with canonical arguments of functions, signs taken out of them, half powers as roots.
fn normal(expression: &Expr) -> Result<Expr> {
    match expression {
        Expr::Number(_) | Expr::Name(_) => Ok(expression.clone()),
        Expr::Neg(inner) => Ok(-normal(inner)?),
        Expr::Binary(BinaryOp::Pow, base, exponent) => {
            let twice = exponent.constant().map_or(f64::NAN, |e| 2.0 * e);
            if twice.fract() == 0.0 && twice.rem_euclid(2.0) == 1.0 {
                Ok(Expr::call(Function::Sqrt, [canonical(base)?]).pow(twice))
            } else {
                Ok(Expr::Binary(BinaryOp::Pow, Box::new(normal(base)?), exponent.clone()))
            }
        }
        Expr::Binary(op, left, right) => {
            Ok(Expr::Binary(*op, Box::new(normal(left)?), Box::new(normal(right)?)))
        }
        Expr::Call(function, _) if function.has_memory() => {
            Err(Error::bad_input(format!("{expression} has a memory and is no function of numbers")))
        }
        Expr::Call(function, arguments) => {
            let arguments = arguments.iter().map(canonical).collect::<Result<Vec<_>>>()?;
            Ok(parity(*function, arguments))
        }
    }
}

/// f(−x) as ∓f(x), where f is odd or even.
fn parity(function: Function, mut arguments: Vec<Expr>) -> Expr {
    let odd = matches!(
        function,
        Function::Sin
            | Function::Tan
            | Function::Asin
            | Function::Atan
            | Function::Sinh
            | Function::Tanh
            | Function::Sign
    );
    let even = matches!(function, Function::Cos | Function::Cosh | Function::Abs);
    let mut negative = false;
    if (odd || even)
        && let [argument] = arguments.as_mut_slice()
        && let Some(positive) = leading_minus(argument)
    {
        *argument = positive;
        negative = odd;
    }
    let call = Expr::Call(function, arguments);
    if negative { -call } else { call }
}

/// An expression in a form that does not depend on how it was written.
fn canonical(expression: &Expr) -> Result<Expr> {
    let mut names: Vec<String> = expression.names().into_iter().map(String::from).collect();
    names.sort();
    let alphabet = Alphabet::new(&[expression], &names)?;
    alphabet.expression(&alphabet.fraction(expression)?)
}
