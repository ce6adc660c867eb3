//! Factors of Hurwitz determinants that follow from factors of H.
//!
//! Purpose: denominators that fall apart where H was given in factors.
//! Method: the Hurwitz determinant of H₁H₂ is that of H₁ times that of H₂ times the resultant of H₁(s) and H₂(−s);
//! all three are tried as factors.
//! References: L. Orlando, Math. Ann. 71 (1911) 233.
//! Numerical aspects: exact.

use super::alphabet::Alphabet;
use super::derive::{LAPLACE, hurwitz};
use crate::Result;
use crate::expression::{BinaryOp, Expr};
use crate::symbolic::integer::Integer;
use crate::symbolic::polynomial::Polynomial;
use std::collections::HashMap;

/// The highest order of the determinant of a resultant.
const HIGHEST_SIZE: usize = 10;

/// The sums in some expressions, outermost first, without repeats and without the beginnings of longer sums.
pub fn sums<'a>(expressions: &[&'a Expr]) -> Vec<&'a Expr> {
    let mut sums = Vec::new();
    for expression in expressions {
        gather(expression, false, &mut sums);
    }
    sums
}

fn gather<'a>(expression: &'a Expr, in_sum: bool, sums: &mut Vec<&'a Expr>) {
    let sum = matches!(expression, Expr::Binary(BinaryOp::Add | BinaryOp::Sub, ..));
    if sum && !in_sum && !sums.contains(&expression) {
        sums.push(expression);
    }
    for child in expression.children() {
        gather(child, sum, sums);
    }
}

/// What the Hurwitz determinant of a product of these sums in s can be divisible by.
pub fn candidates(sums: &[&Expr], alphabet: &Alphabet) -> Result<Vec<Polynomial>> {
    let Some(symbol) = alphabet.index(LAPLACE) else { return Ok(Vec::new()) };
    let mut factors: Vec<Vec<Polynomial>> = Vec::new();
    for sum in sums.iter().filter(|sum| sum.mentions(LAPLACE)) {
        let mut a = alphabet.fraction(sum)?.numerator.coefficients(symbol)?;
        a.reverse();
        if (2..=HIGHEST_SIZE).contains(&a.len()) && !factors.contains(&a) {
            factors.push(a);
        }
    }
    let mut found = Vec::new();
    for (place, x) in factors.iter().enumerate() {
        found.extend(hurwitz(x)?.divided_by(&x[x.len() - 1])?);
        for y in factors[place + 1..].iter().filter(|y| x.len() + y.len() <= HIGHEST_SIZE) {
            found.push(resultant(x, &mirrored(y))?);
        }
    }
    found.retain(|p| p.terms().len() > 1);
    Ok(found)
}

/// The coefficients of p(−s), up to the sign of the whole.
fn mirrored(a: &[Polynomial]) -> Vec<Polynomial> {
    let sign = |k: usize| Integer::from(if k % 2 == 1 { -1 } else { 1 });
    a.iter().enumerate().map(|(k, c)| c.scaled(&sign(k))).collect()
}

/// The resultant of two polynomials in s, leading coefficients first.
fn resultant(x: &[Polynomial], y: &[Polynomial]) -> Result<Polynomial> {
    let (m, n) = (x.len() - 1, y.len() - 1);
    let row = |k: usize| if k < n { (x, k) } else { (y, k - n) };
    let rows: Vec<_> = (0..m + n).map(row).collect();
    determinant(&rows, 0, (1 << (m + n)) - 1, &mut HashMap::new())
}

/// The minor of the columns from `column` on and of the given rows; a row is a polynomial, shifted.
fn determinant(
    rows: &[(&[Polynomial], usize)],
    column: usize,
    set: u32,
    known: &mut HashMap<u32, Polynomial>,
) -> Result<Polynomial> {
    let ring = rows[0].0[0].ring();
    if set == 0 {
        return Ok(Polynomial::constant(ring, 1));
    }
    if let Some(minor) = known.get(&set) {
        return Ok(minor.clone());
    }
    let mut sum = Polynomial::constant(ring, 0);
    for (place, row) in (0..rows.len()).filter(|row| set >> row & 1 == 1).enumerate() {
        let (coefficients, shift) = rows[row];
        if let Some(entry) = column.checked_sub(shift).and_then(|k| coefficients.get(k)) {
            let minor = determinant(rows, column + 1, set & !(1 << row), known)?;
            let product = entry.times(&minor)?;
            sum = if place % 2 == 1 { sum.minus(&product) } else { sum.plus(&product) };
        }
    }
    known.insert(set, sum.clone());
    Ok(sum)
}
