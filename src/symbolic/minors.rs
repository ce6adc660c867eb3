//! The determinants of I_n as a straight-line program of shared minors.
//!
//! Purpose: numerator and denominator of I_n in symbols, without ever dividing.
//! Method: G(s) = P(s)H(-s) + P(-s)H(s) gives n linear equations for the coefficients of P whose matrix is the
//! Hurwitz matrix, M\[m\]\[i\] = a(2m+1-i), and I_n = p0/a0; Cramer's rule with both determinants expanded
//! along their columns. A minor of the last columns is known by its set of rows, so each is formed once, and
//! numerator and denominator share all of them.
//! References: James, Nichols, Phillips, Theory of Servomechanisms (1947), section 7.9 and appendix; seed (3.10), (3.11).
//! Numerical aspects: exact in symbols; over doubles the program is the published definition, not the best-conditioned way.

use crate::{Error, Result};
use std::collections::HashMap;
use std::ops::{Add, Mul, Neg};

/// The highest order in symbols: 29 symbols with exponents to 15 fill the packed form.
pub const HIGHEST_ORDER: usize = 14;

/// A letter of the tables.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Letter {
    /// A coefficient of H, a0 … an.
    A(usize),
    /// A coefficient of G, b0 … b(n-1).
    B(usize),
}

/// A signed product of letters and at most one earlier minor.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Product {
    /// Whether the sign is minus.
    pub negative: bool,
    /// The letters, one after another.
    pub letters: Vec<Letter>,
    /// The number of the minor that multiplies them.
    pub minor: Option<usize>,
}

/// I_n = numerator / (2 a0 · determinant), all three as sums over shared minors.
///
/// ```
/// let program = gyrospec::symbolic::Program::new(2)?;
/// // H = s² + 3 s + 2, G = 1: I_2 = 1/(2·3·2)
/// assert_eq!(program.evaluate(&[1.0, 3.0, 2.0], &[0.0, 1.0]), (1.0, 12.0));
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Program {
    /// The order n.
    pub order: usize,
    /// The minors, each a sum over letters and earlier minors.
    pub minors: Vec<Vec<Product>>,
    /// The sum above the line.
    pub numerator: Vec<Product>,
    /// The Hurwitz determinant below the line, to be multiplied by 2 a0.
    pub determinant: Vec<Product>,
}

impl Program {
    /// The program of order 1 … [`HIGHEST_ORDER`].
    pub fn new(order: usize) -> Result<Self> {
        if !(1..=HIGHEST_ORDER).contains(&order) {
            return Err(Error::usage(format!("there is no table of order {order}"))
                .with_hint(format!("orders go from 1 to {HIGHEST_ORDER}")));
        }
        let mut expansion = Expansion { order, minors: Vec::new(), known: HashMap::new() };
        let (mut numerator, mut determinant) = (Vec::new(), Vec::new());
        for row in 0..order {
            let rest = ((1_u32 << order) - 1) & !(1 << row);
            let Some(minor) = expansion.minor(1, rest) else { continue };
            // (−1)^(n−1) det M_b, column 0 replaced by b
            numerator.push(minor.led_by(Letter::B(row), (row + order - 1) % 2 == 1));
            if 2 * row < order {
                determinant.push(minor.led_by(Letter::A(2 * row + 1), row % 2 == 1));
            }
        }
        Ok(Self { order, minors: expansion.minors, numerator, determinant })
    }

    /// Numerator and denominator over any numbers that can be added and multiplied.
    ///
    /// `a` holds a0 … an and `b` holds b0 … b(n-1).
    pub fn evaluate<N>(&self, a: &[N], b: &[N]) -> (N, N)
    where
        N: Clone + Add<Output = N> + Mul<Output = N> + Neg<Output = N>,
    {
        let mut minors: Vec<N> = Vec::with_capacity(self.minors.len());
        for sum in &self.minors {
            let value = total(sum, a, b, &minors);
            minors.push(value);
        }
        let determinant = total(&self.determinant, a, b, &minors);
        let numerator = total(&self.numerator, a, b, &minors);
        (numerator, (a[0].clone() + a[0].clone()) * determinant)
    }
}

fn total<N>(sum: &[Product], a: &[N], b: &[N], minors: &[N]) -> N
where
    N: Clone + Add<Output = N> + Mul<Output = N> + Neg<Output = N>,
{
    let values = sum.iter().map(|product| {
        let letters = product.letters.iter().map(|letter| match *letter {
            Letter::A(k) => a[k].clone(),
            Letter::B(k) => b[k].clone(),
        });
        let factors = letters.chain(product.minor.map(|k| minors[k].clone()));
        let value = factors.reduce(|x, y| x * y).expect("a product has a factor");
        if product.negative { -value } else { value }
    });
    values.reduce(|x, y| x + y).expect("a sum has a term")
}

impl Product {
    fn led_by(&self, letter: Letter, minus: bool) -> Self {
        let letters = std::iter::once(letter).chain(self.letters.iter().copied()).collect();
        Self { negative: self.negative != minus, letters, minor: self.minor }
    }
}

struct Expansion {
    order: usize,
    minors: Vec<Vec<Product>>,
    known: HashMap<u32, Option<Product>>,
}

impl Expansion {
    /// The minor of the columns from `column` on and of the given rows; none where it vanishes identically.
    fn minor(&mut self, column: usize, rows: u32) -> Option<Product> {
        if rows == 0 {
            return Some(Product { negative: false, letters: Vec::new(), minor: None });
        }
        if let Some(known) = self.known.get(&rows) {
            return known.clone();
        }
        let mut sum = Vec::new();
        for (place, row) in (0..self.order).filter(|row| rows >> row & 1 == 1).enumerate() {
            let letter = 2 * row + 1; // M[m][i] = a(2m+1−i)
            if (column..=column + self.order).contains(&letter)
                && let Some(minor) = self.minor(column + 1, rows & !(1 << row))
            {
                sum.push(minor.led_by(Letter::A(letter - column), place % 2 == 1));
            }
        }
        let minor = match sum.len() {
            0 => None,
            1 => sum.pop(),
            _ => {
                self.minors.push(sum);
                Some(Product { negative: false, letters: Vec::new(), minor: Some(self.minors.len() - 1) })
            }
        };
        self.known.insert(rows, minor.clone());
        minor
    }
}
