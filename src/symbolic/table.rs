//! I_n as a ratio of two expanded polynomials.
//!
//! Purpose: the printed tables of I_n for the signs of (3.10), (3.11).
//! Method: the shared minors of the straight-line program, each expanded once and dropped after its last use.
//! References: those of the program of minors.
//! Numerical aspects: exact; no common factor is left, since the Hurwitz determinant of indeterminates divided by
//! an is irreducible and neither it nor 2, a0, an divides every coefficient of the numerator.

use super::integer::Integer;
use super::minors::{Letter, Product, Program};
use super::polynomial::Polynomial;
use super::ring::{Monomial, Ring};
use crate::Result;
use std::sync::Arc;

/// One I_n = numerator/denominator, expanded.
///
/// ```
/// let table = gyrospec::symbolic::Table::new(7)?;
/// assert_eq!((table.numerator.terms().len(), table.denominator.terms().len()), (85, 34));
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Table {
    /// The order n.
    pub order: usize,
    /// Above the line.
    pub numerator: Polynomial,
    /// Below the line.
    pub denominator: Polynomial,
}

/// The ring of a0 … an, b0 … b(n-1).
fn ring(order: usize) -> Result<Arc<Ring>> {
    let a = (0..=order).map(|k| format!("a{k}"));
    Ring::new(a.chain((0..order).map(|k| format!("b{k}"))).collect())
}

impl Table {
    /// The table of order 1 … [`HIGHEST_ORDER`](super::HIGHEST_ORDER).
    pub fn new(order: usize) -> Result<Self> {
        Self::expand(&Program::new(order)?)
    }

    /// The expansion of a straight-line program.
    pub fn expand(program: &Program) -> Result<Self> {
        let order = program.order;
        let ring = ring(order)?;
        let last = last_uses(program);
        let mut minors: Vec<Option<Polynomial>> = Vec::with_capacity(program.minors.len());
        for (number, sum) in program.minors.iter().enumerate() {
            let minor = expanded(&ring, sum, &minors)?;
            minors.push(Some(minor));
            for used in sum.iter().filter_map(|product| product.minor) {
                if last[used] == number {
                    minors[used] = None;
                }
            }
        }
        let numerator = expanded(&ring, &program.numerator, &minors)?;
        let determinant = expanded(&ring, &program.determinant, &minors)?;
        let denominator = determinant.times_term(ring.power(0, 1)?, &Integer::from(2))?;
        Ok(Self { order, numerator, denominator })
    }
}

/// The number of the sum in which each minor is used last.
fn last_uses(program: &Program) -> Vec<usize> {
    let mut last = vec![usize::MAX; program.minors.len()];
    for (number, sum) in program.minors.iter().enumerate() {
        for used in sum.iter().filter_map(|product| product.minor) {
            last[used] = number;
        }
    }
    for used in program.numerator.iter().chain(&program.determinant).filter_map(|product| product.minor) {
        last[used] = usize::MAX;
    }
    last
}

fn expanded(ring: &Arc<Ring>, sum: &[Product], minors: &[Option<Polynomial>]) -> Result<Polynomial> {
    let one = Polynomial::constant(ring, 1);
    let mut parts = Vec::with_capacity(sum.len());
    for product in sum {
        let mut monomial = Monomial::ONE;
        for letter in &product.letters {
            monomial = ring.product(monomial, ring.power(place(*letter, ring), 1)?)?;
        }
        let minor = product.minor.map_or(&one, |k| minors[k].as_ref().expect("kept until its last use"));
        parts.push(minor.times_term(monomial, &Integer::from(if product.negative { -1 } else { 1 }))?);
    }
    while parts.len() > 1 {
        parts =
            parts.chunks(2).map(|pair| if let [x, y] = pair { x.plus(y) } else { pair[0].clone() }).collect();
    }
    Ok(parts.pop().expect("a sum has a term"))
}

fn place(letter: Letter, ring: &Ring) -> usize {
    match letter {
        Letter::A(k) => k,
        Letter::B(k) => ring.names().len() / 2 + 1 + k,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_term_counts_are_met() {
        // counted with other engines: Singular, FLINT
        for (order, numerator, denominator) in [(1, 1, 1), (2, 2, 1), (7, 85, 34), (10, 1798, 549)] {
            let table = Table::new(order).unwrap();
            assert_eq!(
                (table.numerator.terms().len(), table.denominator.terms().len()),
                (numerator, denominator),
                "order {order}"
            );
        }
    }

    #[test]
    fn orders_outside_are_refused() {
        assert!(Table::new(0).is_err());
        assert!(Table::new(15).is_err());
    }
}
