//! Whether a formula turns into another one where a symbol goes to a limit.
//!
//! Purpose: to judge a printed limit, also one that is 0, and to say when the formula diverges instead.
//! Method: the symbol approaches its limit in half decades, the other symbols stay; the difference must fall to 1e-4
//! of the size that the formula has far from the limit and must not stop at a value of its own. Where the right side
//! contains the symbol itself, the difference is measured by the right side at the same place.
//! References: none needed.
//! Numerical aspects: the approach ends where rounding errors reach 1e-6 of that size; approaches slower than a power
//! of the distance are not recognised.

use super::compare::{constant, in_words};
use super::{Check, CheckKind};
use crate::expression::Expr;
use crate::symbolic::formula::{Bounded, bounded};
use crate::symbolic::{Relation, Sampler, Values};
use crate::{Error, Result};

/// Random points at which a limit is tried.
const POINTS: usize = 8;
/// Half decades of the approach, and how many of them count as far from the limit.
const STEPS: i32 = 80;
const FAR: usize = 4;
/// A limit given as a number at least as large is infinity.
const INFINITE: f64 = 1e9;
/// How well the formula must agree, and the largest rounding error at which it is still looked at.
const CLOSE: f64 = 1e-4;
const ROUNDING: f64 = 1e-6;
/// A difference below is none, in parts of the size.
const NOTHING: f64 = 1e-13;

/// What is asked about a limit.
pub struct Question<'a> {
    pub printed: &'a Expr,
    pub becomes: &'a Expr,
    pub symbol: &'a str,
    pub to: f64,
}

/// What one approach shows.
#[derive(Clone, Copy, PartialEq)]
enum Shown {
    Holds,
    Vanishes,
    Diverges,
    /// It goes elsewhere; the number is wanted/printed.
    Differs(f64),
}

/// Both formulas on the way to the limit.
struct Approach {
    pairs: Vec<(Bounded, Bounded)>,
    size: f64,
    /// The right side goes along with the symbol.
    moving: bool,
}

/// Judges a limit; `about` names it, `wanted` is the right side in print.
///
/// # Errors
/// Bad input, where relations contradict each other or the limit is no number.
pub fn judge(question: &Question, relations: &[Relation], about: &str, wanted: &str) -> Result<Check> {
    if question.to.is_nan() {
        return Err(Error::bad_input(format!("{about}: 'to' is no number")));
    }
    let mut sampler = Sampler::new(&[question.printed, question.becomes], relations);
    let mut shown = Vec::new();
    for _ in 0..40 * POINTS {
        let approach = Approach::walk(question, &sampler)?;
        sampler.draw(&Values::new())?;
        shown.extend(approach.map(|approach| approach.shows()));
        if shown.len() == POINTS {
            break;
        }
    }
    let all = |what: Shown| !shown.is_empty() && shown.iter().all(|one| *one == what);
    let ratios: Vec<f64> =
        shown.iter().filter_map(|one| if let Shown::Differs(r) = one { Some(*r) } else { None }).collect();
    let ratio = constant(&ratios, CLOSE).filter(|_| ratios.len() == shown.len());
    let message = if shown.is_empty() {
        "no values were found at which it can be tried".into()
    } else if all(Shown::Holds) {
        format!("turns into {wanted}")
    } else if all(Shown::Diverges) {
        format!("diverges, {wanted} is wanted")
    } else if all(Shown::Vanishes) {
        format!("vanishes, {wanted} is wanted")
    } else if let Some(ratio) = ratio {
        format!("off by a constant, wanted/printed = {}", in_words(snapped(ratio)))
    } else {
        format!("does not turn into {wanted}")
    };
    let holds = all(Shown::Holds);
    let ratio = if holds { Some(1.0) } else { ratio };
    Ok(Check { kind: CheckKind::Limit, holds, message: format!("{about}: {message}"), ratio })
}

/// The place after a number of half decades.
fn place(to: f64, step: i32) -> f64 {
    let near = 10f64.powf(-0.5 * f64::from(step));
    match to {
        0.0 => near,
        to if to.abs() >= INFINITE => to.signum() / near,
        to => to * (1.0 + 0.3 * near),
    }
}

impl Approach {
    /// The values up to where rounding errors grow too large; none where there are too few.
    fn walk(question: &Question, sampler: &Sampler) -> Result<Option<Self>> {
        let mut all = Vec::new();
        for step in 0..STEPS {
            let fixed = Values::from([(question.symbol.to_owned(), place(question.to, step))]);
            // a clone draws the same values of the other symbols at every step
            if let Some(values) = sampler.clone().draw(&fixed)? {
                all.push((bounded(question.printed, &values)?, bounded(question.becomes, &values)?));
            }
        }
        let moving = question.becomes.mentions(question.symbol);
        let finite = |pair: &&(Bounded, Bounded)| pair.0.value.is_finite() && pair.1.value.is_finite();
        let far = all.iter().filter(finite).take(FAR);
        let size = far.map(|(x, y)| x.value.abs().max(y.value.abs())).fold(0.0, f64::max);
        let usable = |(x, y): &(Bounded, Bounded)| {
            let size = if moving { y.value.abs() } else { size.max(x.value.abs()) };
            x.value.is_finite() && x.bound + y.bound <= ROUNDING * size
        };
        let pairs: Vec<_> = all.into_iter().skip_while(|p| !usable(p)).take_while(usable).collect();
        Ok((pairs.len() > FAR).then_some(Self { pairs, size, moving }))
    }

    fn shows(&self) -> Shown {
        let last = self.pairs.len() - 1;
        let (x, y) = self.pairs[last];
        if self.settles(|(x, y)| x.value - y.value) {
            Shown::Holds
        } else if self.diverges() {
            Shown::Diverges
        } else if y.value == 0.0 {
            Shown::Differs(f64::NAN)
        } else if !self.moving && self.settles(|(x, _)| x.value) {
            Shown::Vanishes
        } else {
            Shown::Differs(y.value / x.value)
        }
    }

    /// Whether a quantity goes to 0 along the way.
    fn settles(&self, of: impl Fn(&(Bounded, Bounded)) -> f64) -> bool {
        let part = |k: usize| {
            let size = if self.moving { self.pairs[k].1.value.abs() } else { self.size };
            let left = of(&self.pairs[k]).abs();
            if left == 0.0 { 0.0 } else { left / size }
        };
        let last = self.pairs.len() - 1;
        let (x, y) = self.pairs[last];
        let rounding = 16.0 * (x.bound + y.bound) / self.size.max(f64::MIN_POSITIVE);
        let nothing = NOTHING.max(if self.moving { 0.0 } else { rounding.min(CLOSE) });
        part(last) <= nothing || part(last) <= CLOSE && part(last) <= 0.9 * part(last - FAR)
    }

    /// Whether the printed formula grows by steps that do not become smaller.
    fn diverges(&self) -> bool {
        let step = |k: usize| (self.pairs[k].0.value.abs() - self.pairs[k - 1].0.value.abs()).max(0.0);
        let last = self.pairs.len() - 1;
        let middle = last / 2 + 1;
        step(last) > 1e-3 * self.pairs[last].0.value.abs() && step(last) >= 0.9 * step(middle)
    }
}

/// A number found near a limit, moved onto the simple multiple of a power of π that it is close to.
fn snapped(ratio: f64) -> f64 {
    use std::f64::consts::PI;
    for unit in [1.0, PI, 1.0 / PI] {
        for denominator in 1..=12 {
            let step = unit / f64::from(denominator);
            let near = (ratio / step).round() * step;
            if near != 0.0 && ((ratio - near) / near).abs() < 1e-6 {
                return near;
            }
        }
    }
    ratio
}
