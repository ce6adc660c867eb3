//! Relations between symbols, such as b² = μ² + ε², as rewriting rules.
//!
//! Purpose: one normal form for equal expressions, and the shortest of several readings for print.
//! Method: the left side, a product of powers, is replaced wherever it divides a term until none is left; for print
//! each relation is also read backwards, solved for a power on its right side.
//! References: D. Cox, J. Little, D. O'Shea, Ideals, Varieties, and Algorithms, chapter 2 (division by one relation).
//! Numerical aspects: exact. Normal forms are unique where the left sides share no symbol; several relations with
//! common symbols may leave equal expressions unlike, never unequal ones alike.

use super::alphabet::Alphabet;
use crate::expression::Expr;
use crate::symbolic::fraction::Fraction;
use crate::symbolic::integer::Integer;
use crate::symbolic::polynomial::Polynomial;
use crate::symbolic::ring::Monomial;
use crate::{Error, Result};

/// Rewriting steps after which a relation is taken to be endless.
const MOST_STEPS: usize = 64;

/// A relation as it is written: left = right.
#[derive(Clone, PartialEq, Debug)]
pub struct Relation {
    /// A product of powers.
    pub left: Expr,
    /// What it is equal to.
    pub right: Expr,
}

impl Relation {
    /// Reads `left = right`.
    ///
    /// # Errors
    /// Bad input, where there is not exactly one `=` or a side cannot be read.
    ///
    /// ```
    /// let relation = gyrospec::symbolic::Relation::parse("b^2 = mu^2 + eps^2")?;
    /// assert_eq!(relation.left.to_string(), "b^2");
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self> {
        match text.split('=').collect::<Vec<_>>()[..] {
            [left, right] => Ok(Self { left: Expr::parse(left)?, right: Expr::parse(right)? }),
            _ => Err(Error::bad_input(format!("'{text}' is no relation"))
                .with_hint("write one equation, such as b^2 = mu^2 + eps^2")),
        }
    }
}

/// lead = right: the lead is replaced wherever it divides a term.
#[derive(Clone, Debug)]
pub struct Rule {
    lead: Monomial,
    right: Fraction,
}

impl Rule {
    /// A relation read from left to right.
    ///
    /// # Errors
    /// Bad input, where the left side is no product of powers.
    pub fn forward(relation: &Relation, alphabet: &Alphabet) -> Result<Self> {
        let (left, right) = (alphabet.fraction(&relation.left)?, alphabet.fraction(&relation.right)?);
        let (Some((lead, coefficient)), [_]) = (left.numerator.terms().first(), left.numerator.terms())
        else {
            return Err(Error::bad_input(format!("the left side {} of a relation is a sum", relation.left))
                .with_hint("solve it for a product of powers, such as b^2 = mu^2 + eps^2"));
        };
        if *lead == Monomial::ONE {
            return Err(Error::bad_input(format!(
                "the left side {} of a relation has no letter",
                relation.left
            ))
            .with_hint("solve it for a product of powers, such as b^2 = mu^2 + eps^2"));
        }
        let number = Fraction::whole(Polynomial::constant(alphabet.ring(), coefficient.clone()));
        let right = right.times(&Fraction::whole(left.denominator))?.over(&number)?;
        Ok(Self { lead: *lead, right })
    }

    /// The same relation solved for each power on its right side that stands there alone.
    pub fn backward(&self, alphabet: &Alphabet) -> Result<Vec<Self>> {
        let ring = alphabet.ring();
        if self.right.denominator.as_constant().is_none() || self.right.numerator.terms().len() < 2 {
            return Ok(Vec::new());
        }
        let mut rules = Vec::new();
        for (monomial, coefficient) in self.right.numerator.terms() {
            let powers: Vec<_> = ring.powers(*monomial).collect();
            let [(symbol, exponent)] = powers[..] else { continue };
            let alone = self
                .right
                .numerator
                .terms()
                .iter()
                .all(|(m, _)| m == monomial || ring.exponent(*m, symbol) == 0);
            if alone && exponent > 0 && ring.exponent(self.lead, symbol) == 0 {
                // c·v = d·lead − rest
                let own = Polynomial::term(ring, *monomial, coefficient.clone());
                let lead = Polynomial::term(ring, self.lead, Integer::ONE).times(&self.right.denominator)?;
                let above = lead.minus(&self.right.numerator.minus(&own));
                let below = Polynomial::constant(ring, coefficient.clone());
                rules.push(Self { lead: *monomial, right: Fraction::new(&above, &below)? });
            }
        }
        Ok(rules)
    }

    /// The normal form of a polynomial under this rule.
    pub fn applied(&self, polynomial: &Polynomial) -> Result<Fraction> {
        let ring = polynomial.ring();
        let mut sum = Fraction::whole(polynomial.clone());
        for _ in 0..MOST_STEPS {
            let (mut hit, mut kept) = (Vec::new(), Vec::new());
            for (monomial, coefficient) in sum.numerator.terms() {
                match ring.quotient(*monomial, self.lead) {
                    Some(rest) => hit.push((rest, coefficient.clone())),
                    None => kept.push((*monomial, coefficient.clone())),
                }
            }
            if hit.is_empty() {
                return Ok(sum);
            }
            let replaced = Fraction::whole(Polynomial::collect(ring, hit)).times(&self.right)?;
            let whole = replaced.plus(&Fraction::whole(Polynomial::collect(ring, kept)))?;
            sum = whole.over(&Fraction::whole(sum.denominator))?;
        }
        Err(Error::not_computed("a relation brings its own left side back without end")
            .with_hint("solve it for the symbol that shall disappear"))
    }
}

/// The normal form of a ratio under all rules.
pub fn normal_form(fraction: &Fraction, rules: &[Rule]) -> Result<Fraction> {
    let mut form = fraction.clone();
    for _ in 0..MOST_STEPS {
        let before = form.clone();
        for rule in rules {
            form = rule.applied(&form.numerator)?.over(&rule.applied(&form.denominator)?)?;
        }
        if form == before {
            return Ok(form);
        }
    }
    Err(Error::not_computed("the relations bring each other's left sides back without end"))
}
