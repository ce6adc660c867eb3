//! A derived formula against the numeric engine.
//!
//! Purpose: nothing is printed that was not checked at random points.
//! Method: symbols take random positive values, those on the left of a relation the value that it gives; transfer
//! functions are multiplied out over doubles, not with the symbolic algebra, and the engine integrates.
//! References: none needed.
//! Numerical aspects: points where H is not stable are drawn anew; the rest must agree to 1e-8.

use super::calculus::{symbols, value};
use super::derive::{LAPLACE, Source};
use super::rule::Relation;
use crate::expression::{BinaryOp, Expr};
use crate::integral::{Integrand, evaluate};
use crate::{Error, Result};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;

/// Agreement that is asked for.
const TOLERANCE: f64 = 1e-8;
/// Points that must agree.
pub const POINTS: usize = 32;
/// Draws in search of stable points.
const MOST_DRAWS: usize = 4000;

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
        .with_hint(format!("at random values the sides are {left} and {right}")))
}

/// Compares times·(mean value of the source) with the derived formula at random points; returns their number.
///
/// # Errors
/// Not computed, where a point differs or no stable point is found.
pub fn check(source: &Source, times: &Expr, relations: &[Relation], derived: &Expr) -> Result<usize> {
    let mut expressions = source.expressions();
    expressions.extend([times, derived]);
    let mut sampler = Sampler::new(&expressions, relations);
    let mut agreed = 0;
    for _ in 0..MOST_DRAWS {
        let Some(values) = sampler.draw(&Values::new())? else { continue };
        let of = |name: &str| values.get(name).copied();
        let Some(mean) = numeric(source, &values)? else { continue };
        let times = value(times, &of)?;
        let (wanted, found) = (times * mean.value, value(derived, &of)?);
        if !wanted.is_finite() || (wanted - found).abs() > TOLERANCE * (times * mean.scale).abs() {
            return Err(Error::not_computed(format!(
                "the derived formula is not printed: the engine gives {wanted}, the formula {found}"
            ))
            .with_hint(format!("at {values:?}; please report this")));
        }
        agreed += 1;
        if agreed == POINTS {
            return Ok(agreed);
        }
    }
    Err(Error::not_computed("no values between 0.3 and 3 were found for which H is stable")
        .with_hint("write H so that positive symbols make it stable, with minus signs written out"))
}

/// A mean value over doubles and the size of what it is summed from.
#[derive(Clone, Copy, Debug)]
pub struct Mean {
    /// The value.
    pub value: f64,
    /// The largest of its parts, one for each coefficient of G; what is small against it is rounding.
    pub scale: f64,
}

/// The mean value over doubles; none where H is not stable there.
///
/// # Errors
/// Bad input, where a symbol has no value.
pub fn numeric(source: &Source, values: &Values) -> Result<Option<Mean>> {
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
            let left = convolved(&first.above, &second.below);
            let right = mirrored(&convolved(&second.above, &first.below));
            let sizes = convolved(&magnitudes(&left), &magnitudes(&right));
            let density = value(density, &|n| values.get(n).copied())?;
            (convolved(&first.below, &second.below), convolved(&left, &right), sizes, density)
        }
    };
    let ((a, b), (_, sizes)) = (descending(&h, &g), descending(&h, &sizes));
    if a.len() < 2 || b.len() + 1 != a.len() || sizes.len() != b.len() {
        return Ok(None);
    }
    let integral = |b: &[f64]| Integrand::new(&a, b).and_then(|integrand| evaluate(&integrand));
    let Ok(whole) = integral(&b) else { return Ok(None) };
    let mut scale = whole.value.abs();
    for (k, size) in sizes.iter().enumerate() {
        let mut alone = vec![0.0; b.len()];
        alone[k] = *size;
        scale = scale.max(integral(&alone).map_or(0.0, |part| part.value.abs()));
    }
    Ok(Some(Mean { value: factor * whole.value, scale: factor.abs() * scale }))
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
