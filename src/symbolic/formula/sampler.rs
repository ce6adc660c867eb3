//! Random values of symbols that satisfy the relations.
//!
//! Purpose: points at which formulas are compared.
//! Method: positive values around 1; a symbol on the left of a relation takes the value that it gives.
//! References: none needed.
//! Numerical aspects: a seeded generator, the same points in every run.

use super::calculus::{symbols, value};
use super::derive::LAPLACE;
use super::rule::Relation;
use crate::expression::{BinaryOp, Expr};
use crate::{Error, Result};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;

/// Values of symbols by name.
pub type Values = BTreeMap<String, f64>;

/// Draws values for symbols that satisfy the relations.
#[derive(Clone)]
pub struct Sampler<'a> {
    names: Vec<String>,
    relations: &'a [Relation],
    random: ChaCha8Rng,
}

impl<'a> Sampler<'a> {
    /// A sampler for all names of some expressions.
    pub fn new(expressions: &[&Expr], relations: &'a [Relation]) -> Self {
        let sides = relations.iter().flat_map(|r| [&r.left, &r.right]);
        let all = expressions.iter().copied().chain(sides).flat_map(symbols);
        let mut names: Vec<String> = all.filter(|name| *name != LAPLACE).map(String::from).collect();
        names.sort();
        names.dedup();
        Self { names, relations, random: ChaCha8Rng::seed_from_u64(1978) }
    }

    /// The names in some expressions and in the relations that take values of their own, given by no relation.
    pub fn free_in(&self, expressions: &[&Expr]) -> Vec<String> {
        let sides = self.relations.iter().flat_map(|r| [&r.left, &r.right]);
        let there: Vec<&str> = expressions.iter().copied().chain(sides).flat_map(symbols).collect();
        let mut solved: Vec<&str> = Vec::new();
        for relation in self.relations {
            let left = powers(&relation.left);
            let one = left.into_iter().find(|(name, power)| {
                *power != 0.0 && !relation.right.mentions(name) && !solved.contains(name)
            });
            solved.extend(one.map(|(name, _)| name));
        }
        let free = |name: &&String| there.contains(&name.as_str()) && !solved.contains(&name.as_str());
        self.names.iter().filter(free).cloned().collect()
    }

    /// Values between 0.3 and 3 for all names but the fixed ones; none where the relations have no such point.
    ///
    /// # Errors
    /// Bad input, where a relation between given values does not hold.
    pub fn draw(&mut self, fixed: &Values) -> Result<Option<Values>> {
        let random = &mut self.random;
        let mut values: Values = self
            .names
            .iter()
            .map(|name| (name.clone(), 10f64.powf(random.random_range(-0.5..0.5))))
            .collect();
        values.extend(fixed.clone());
        let mut solved: Vec<&str> = Vec::new();
        for relation in self.relations {
            let free = powers(&relation.left).into_iter().find(|(name, power)| {
                let taken = solved.contains(name) || fixed.contains_key(*name);
                *power != 0.0 && !relation.right.mentions(name) && !taken
            });
            match free {
                Some((name, power)) => {
                    let Some(solution) = solve(relation, name, power, &values)? else { return Ok(None) };
                    values.insert(name.into(), solution);
                    solved.push(name);
                }
                None => holds(relation, &values)?,
            }
        }
        Ok(Some(values))
    }
}

/// Given values with those that the relations add: b from b² = μ² + ε² where μ and ε are given.
///
/// # Errors
/// Bad input, where a relation contradicts the values.
pub fn completed(values: &Values, relations: &[Relation]) -> Result<Values> {
    let mut values = values.clone();
    for relation in relations {
        let missing = powers(&relation.left).into_iter().find(|(name, power)| {
            *power != 0.0 && !relation.right.mentions(name) && !values.contains_key(*name)
        });
        let known = |e: &Expr| {
            symbols(e).iter().all(|n| values.contains_key(*n) || missing.is_some_and(|m| m.0 == *n))
        };
        if !known(&relation.left) || !known(&relation.right) {
            continue;
        }
        match missing {
            Some((name, power)) => {
                if let Some(solution) = solve(relation, name, power, &values)? {
                    values.insert(name.into(), solution);
                }
            }
            None => holds(relation, &values)?,
        }
    }
    Ok(values)
}

/// The names in a product of powers of names, with their powers; none where it is anything else.
pub fn powers(product: &Expr) -> Vec<(&str, f64)> {
    match product {
        Expr::Name(name) => vec![(name, 1.0)],
        Expr::Binary(BinaryOp::Pow, base, exponent) => match (&**base, exponent.constant()) {
            (Expr::Name(name), Some(power)) => vec![(name, power)],
            _ => Vec::new(),
        },
        Expr::Binary(BinaryOp::Mul, left, right) => [powers(left), powers(right)].concat(),
        _ => Vec::new(),
    }
}

/// The value of a name that satisfies left = right, when the left side is name^power · rest.
fn solve(relation: &Relation, name: &str, power: f64, values: &Values) -> Result<Option<f64>> {
    let with_one = |n: &str| if n == name { Some(1.0) } else { values.get(n).copied() };
    let rest = value(&relation.left, &with_one)?;
    let right = value(&relation.right, &|n| values.get(n).copied())?;
    let solution = (right / rest).powf(1.0 / power);
    Ok((solution.is_finite() && solution > 0.0).then_some(solution))
}

fn holds(relation: &Relation, values: &Values) -> Result<()> {
    let side = |e: &Expr| value(e, &|n| values.get(n).copied());
    let (left, right) = (side(&relation.left)?, side(&relation.right)?);
    if (left - right).abs() <= 1e-9 * (left.abs() + right.abs()) {
        return Ok(());
    }
    Err(Error::bad_input(format!("the relation {} = {} does not hold", relation.left, relation.right))
        .with_hint(format!("at the values tried the sides are {left} and {right}")))
}
