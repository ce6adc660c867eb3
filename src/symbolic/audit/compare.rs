//! Where two expressions differ, and by which number.

use crate::Result;
use crate::expression::{BinaryOp, Expr};
use crate::symbolic::formula::{bounded, terms};
use crate::symbolic::{Relation, Sampler, Simplifier, Values, value};
use std::collections::BTreeSet;

/// Points at which a ratio is tried.
const POINTS: usize = 12;
/// Agreement of equal values, beside rounding.
const TOLERANCE: f64 = 1e-12;

/// A difference: what is printed and what should be there; one of them may be missing.
pub type Place = (Option<Expr>, Option<Expr>);

/// For which values of their symbols two expressions are equal.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Equality {
    Always,
    Positive,
    Never,
}

/// Whether two expressions are equal under the relations, at least for positive symbols.
pub fn same(x: &Expr, y: &Expr, simplifier: &Simplifier) -> bool {
    equality(x, y, simplifier) != Equality::Never
}

/// Where two expressions are equal under the relations.
pub fn equality(x: &Expr, y: &Expr, simplifier: &Simplifier) -> Equality {
    if x == y || simplifier.vanishes(&(x.clone() - y.clone())).is_ok_and(|zero| zero) {
        return Equality::Always;
    }
    let agree = |signs| agree(x, y, &simplifier.relations, signs).is_ok_and(|yes| yes);
    match (agree(false), agree(true)) {
        (true, true) => Equality::Always,
        (true, false) => Equality::Positive,
        _ => Equality::Never,
    }
}

/// Whether two expressions have equal values at random points, also with every second symbol below 0 if asked for.
fn agree(x: &Expr, y: &Expr, relations: &[Relation], signs: bool) -> Result<bool> {
    let mut sampler = Sampler::new(&[x, y], relations);
    let related: BTreeSet<&str> =
        relations.iter().flat_map(|r| [&r.left, &r.right]).flat_map(|side| side.names()).collect();
    let mut tried = 0;
    for draw in 0..40 * POINTS {
        let Some(mut values) = sampler.draw(&Values::new())? else { continue };
        let free = values.iter_mut().filter(|(name, _)| signs && !related.contains(name.as_str()));
        free.enumerate().filter(|(k, _)| (draw >> (k % 8)) % 2 == 0).for_each(|(_, (_, v))| *v = -*v);
        let (x, y) = (bounded(x, &values)?, bounded(y, &values)?);
        if !x.value.is_finite() || !y.value.is_finite() {
            continue;
        }
        let size = x.value.abs().max(y.value.abs());
        if (x.value - y.value).abs() > TOLERANCE * size + 4.0 * (x.bound + y.bound) {
            return Ok(false);
        }
        tried += 1;
        if tried == POINTS {
            return Ok(true);
        }
    }
    Ok(signs || tried > 0)
}

/// The number that all are, to a tolerance; none where they differ, are 0 or not finite.
pub fn constant(numbers: &[f64], tolerance: f64) -> Option<f64> {
    let first = *numbers.first()?;
    let one = numbers.iter().all(|r| (r - first).abs() <= tolerance * first.abs());
    (one && first.is_finite() && first != 0.0).then_some(first)
}

fn near(x: f64, y: f64) -> bool {
    (x - y).abs() <= 1e-9 * y.abs()
}

/// y/x, if it is one number at random points.
///
/// # Errors
/// Bad input, where a relation does not hold.
pub fn constant_ratio(x: &Expr, y: &Expr, relations: &[Relation]) -> Result<Option<f64>> {
    let mut sampler = Sampler::new(&[x, y], relations);
    let mut ratios: Vec<f64> = Vec::new();
    for _ in 0..40 * POINTS {
        let Some(values) = sampler.draw(&Values::new())? else { continue };
        let of = |name: &str| values.get(name).copied();
        ratios.push(value(y, &of)? / value(x, &of)?);
        if ratios.len() == POINTS {
            return Ok(constant(&ratios, 1e-9));
        }
    }
    Ok(None)
}

/// A number in words: as a simple fraction times a power of π where it is one.
pub fn in_words(number: f64) -> String {
    use std::f64::consts::PI;
    for (power, below) in [(1.0, ""), (PI, ""), (PI * PI, ""), (1.0 / PI, "π"), (1.0 / (PI * PI), "π²")] {
        for denominator in 1..=24 {
            let numerator = number / power * f64::from(denominator);
            let whole = numerator.round();
            if whole != 0.0 && whole.abs() <= 1000.0 && near(numerator, whole) {
                return fraction(whole, denominator, power, below);
            }
        }
    }
    let decade = number.abs().log10();
    if near(decade, decade.round()) { format!("10^{}", decade.round()) } else { format!("{number:.6}") }
}

fn fraction(whole: f64, denominator: i32, power: f64, below: &str) -> String {
    let pi = match power {
        p if p <= 1.0 => "",
        p if p < 4.0 => "π",
        _ => "π²",
    };
    let above = match (whole, pi) {
        (_, "") => format!("{whole}"),
        (1.0, _) => pi.into(),
        _ => format!("{whole}{pi}"),
    };
    match (denominator, below) {
        (1, "") => above,
        (1, _) => format!("{above}/{below}"),
        (_, "") => format!("{above}/{denominator}"),
        _ => format!("{above}/({denominator}{below})"),
    }
}

/// The smallest parts in which a printed expression differs from the right one.
pub fn differences(printed: &Expr, right: &Expr, simplifier: &Simplifier) -> Vec<Place> {
    if same(printed, right, simplifier) {
        return Vec::new();
    }
    let sums = (terms(printed, false), terms(right, false));
    if sums.0.len() > 1 || sums.1.len() > 1 {
        let (pairs, left, mut over) = matched(sums.0, sums.1, simplifier);
        let mut places: Vec<Place> = pairs.iter().flat_map(|(x, y)| differences(x, y, simplifier)).collect();
        for (x, minus) in left {
            let turned =
                over.iter().position(|(y, _)| same(&x, y, simplifier)).map(|place| over.remove(place));
            places.push((Some(signed(x, minus)), turned.map(|(y, other)| signed(y, other))));
        }
        places.extend(over.into_iter().map(|(y, minus)| (None, Some(signed(y, minus)))));
        return places;
    }
    let products = (factors(printed, false), factors(right, false));
    if products.0.len() > 1 || products.1.len() > 1 {
        let (pairs, left, over) = matched(products.0, products.1, simplifier);
        let sign = |parts: &[Part]| matches!(parts, [(Expr::Neg(one), _)] if **one == Expr::Number(1.0));
        if pairs.is_empty() && (sign(&left) && over.is_empty() || left.is_empty() && sign(&over)) {
            return vec![(Some(printed.clone()), Some(right.clone()))];
        }
        let inner = pairs.iter().flat_map(|(x, y)| differences(x, y, simplifier));
        let rest = (!left.is_empty() || !over.is_empty()).then(|| (joined(&left), joined(&over)));
        return inner.chain(rest).collect();
    }
    if let (Expr::Call(f, x), Expr::Call(g, y)) = (printed, right)
        && f == g
        && let ([x], [y]) = (x.as_slice(), y.as_slice())
    {
        return differences(x, y, simplifier);
    }
    vec![(Some(printed.clone()), Some(right.clone()))]
}

/// A part of a sum or product; the flag is its minus, or that it stands below the line.
type Part = (Expr, bool);

/// Parts that are like each other but not equal, and the parts that are left over on either side.
type Matched = (Vec<(Expr, Expr)>, Vec<Part>, Vec<Part>);

/// Takes away what is equal, then pairs what is most alike.
fn matched(left: Vec<Part>, mut right: Vec<Part>, simplifier: &Simplifier) -> Matched {
    let mut rest = Vec::new();
    for part in left {
        match right.iter().position(|other| other.1 == part.1 && same(&other.0, &part.0, simplifier)) {
            Some(place) => {
                right.remove(place);
            }
            None => rest.push(part),
        }
    }
    let (mut pairs, mut alone) = (Vec::new(), Vec::new());
    let single = rest.len() == 1 && right.len() == 1;
    for (x, flag) in rest {
        let score =
            |part: &Part| if part.1 == flag { likeness(&x, &part.0) + usize::from(single) } else { 0 };
        let best = (0..right.len()).rev().max_by_key(|k| score(&right[*k])).filter(|k| score(&right[*k]) > 0);
        match best {
            Some(place) => pairs.push((x, right.remove(place).0)),
            None => alone.push((x, flag)),
        }
    }
    (pairs, alone, right)
}

/// How many names two expressions share; names that differ after `_` count half.
fn likeness(x: &Expr, y: &Expr) -> usize {
    let stem = |name: &str| name.split('_').next().unwrap_or_default().to_owned();
    let (x, y) = (x.names(), y.names());
    let stems: BTreeSet<String> = y.iter().map(|name| stem(name)).collect();
    2 * x.intersection(&y).count() + x.difference(&y).filter(|name| stems.contains(&stem(name))).count()
}

fn signed(term: Expr, minus: bool) -> Expr {
    if minus { -term } else { term }
}

fn joined(parts: &[Part]) -> Option<Expr> {
    let side = |below: bool| {
        parts.iter().filter(|part| part.1 == below).map(|part| part.0.clone()).reduce(|x, y| x * y)
    };
    match (side(false), side(true)) {
        (above, Some(below)) => Some(above.unwrap_or(Expr::Number(1.0)) / below),
        (above, None) => above,
    }
}

/// The factors of a product and whether they stand below the line.
fn factors(expression: &Expr, below: bool) -> Vec<Part> {
    match expression {
        Expr::Binary(BinaryOp::Mul, x, y) => [factors(x, below), factors(y, below)].concat(),
        Expr::Binary(BinaryOp::Div, x, y) => [factors(x, below), factors(y, !below)].concat(),
        Expr::Neg(inner) => [vec![(Expr::number(-1.0), below)], factors(inner, below)].concat(),
        _ => vec![(expression.clone(), below)],
    }
}
