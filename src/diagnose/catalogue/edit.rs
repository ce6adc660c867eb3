//! Edits of a model: where forces enter, how a signal is replaced, which unit an expression has.

use crate::estimate::{Range, Side};
use crate::expression::{BinaryOp, Expr, Function};
use crate::model::{Definition, Model, Parameter, State};
use crate::units::{Dimension, Unit};
use std::collections::BTreeSet;

/// The unit of a product, quotient, power or call, spelled from the units of its names.
pub fn unit_of(e: &Expr, of_name: &dyn Fn(&str) -> Option<Unit>) -> Unit {
    match e {
        Expr::Number(_) => Unit::one(),
        Expr::Name(n) => of_name(n).unwrap_or_else(Unit::one).of_differences(),
        Expr::Neg(a) => unit_of(a, of_name),
        Expr::Binary(op, a, b) => match op {
            BinaryOp::Add | BinaryOp::Sub => unit_of(a, of_name),
            BinaryOp::Mul => unit_of(a, of_name).times(&unit_of(b, of_name)),
            BinaryOp::Div => unit_of(a, of_name).over(&unit_of(b, of_name)),
            BinaryOp::Pow => b.constant().map_or_else(Unit::one, |p| unit_of(a, of_name).power(p)),
        },
        Expr::Call(f, args) => match f {
            Function::Sqrt => unit_of(&args[0], of_name).power(0.5),
            Function::Abs
            | Function::Min
            | Function::Max
            | Function::Clamp
            | Function::Delay
            | Function::Lag
            | Function::Backlash
            | Function::Hysteresis
            | Function::RateLimit => unit_of(&args[0], of_name),
            Function::Curve => unit_of(&args[2], of_name),
            Function::Surface(n, m) => unit_of(&args[2 + usize::from(*n) + usize::from(*m)], of_name),
            Function::Foreign(f) => f.unit(),
            _ => Unit::one(),
        },
    }
}

/// The unit of a name of the model; `t` is in seconds.
pub fn unit_of_name(model: &Model, name: &str) -> Option<Unit> {
    let second = || Unit::of(Dimension::TIME);
    let input = || model.inputs.iter().find(|i| i.name == name).map(|i| i.unit.clone());
    let parameter = || model.parameters.iter().find(|p| p.name == name).map(|p| p.unit.clone());
    let definition = || model.definitions.iter().find(|d| d.name == name).map(|d| d.unit.clone());
    let state = || model.states.iter().find(|s| s.name == name).map(|s| s.unit.clone());
    if name == "t" {
        return Some(second());
    }
    input().or_else(parameter).or_else(definition).or_else(state)
}

/// A name that a model does not use, nor what else is asked about: the wanted one, or that with the next free number.
pub fn free_name(model: &Model, wanted: &str, is_other: impl Fn(&str) -> bool) -> String {
    let is_taken = |n: &str| {
        n == "pi"
            || unit_of_name(model, n).is_some()
            || model.outputs.iter().any(|o| o.name == n)
            || is_other(n)
    };
    let later = (2..).map(|i| format!("{wanted}_{i}"));
    std::iter::once(wanted.to_string()).chain(later).find(|n| !is_taken(n)).unwrap_or_default()
}

/// Whether a unit is one of speed: a length or an angle a second.
pub fn is_rate(unit: &Unit) -> bool {
    let metres = Unit::parse("m/s").is_ok_and(|u| u.dimension() == unit.dimension());
    metres || is_frequency(unit)
}

/// Whether an expression is a name, or a number times or under it.
pub fn is_multiple_of(e: &Expr, name: &str) -> bool {
    match e {
        Expr::Name(n) => n == name,
        Expr::Binary(BinaryOp::Div, a, b) => is_multiple_of(a, name) && matches!(**b, Expr::Number(_)),
        Expr::Binary(BinaryOp::Mul, a, b) => {
            let number = |x: &Expr| matches!(x, Expr::Number(_));
            number(a) && is_multiple_of(b, name) || number(b) && is_multiple_of(a, name)
        }
        _ => false,
    }
}

/// Whether a term of a sum is a signal times a number.
pub fn has_multiple_of(model: &Model, sum: &Expr, name: &str) -> bool {
    terms_of(model, sum).iter().any(|t| is_multiple_of(t, name))
}

fn is_sum(e: &Expr) -> bool {
    matches!(e, Expr::Binary(BinaryOp::Add | BinaryOp::Sub, _, _))
}

/// Whether a sum stands under the products and quotients of an expression, definitions opened.
fn leads_to_sum(model: &Model, e: &Expr) -> bool {
    let mut opened = Opened::new(model);
    let mut left = vec![e];
    while let Some(e) = left.pop() {
        match e {
            Expr::Name(n) => left.extend(opened.once(n).map(|d| &d.equals)),
            Expr::Binary(BinaryOp::Mul, a, b) => left.extend([&**a, &**b]),
            Expr::Binary(BinaryOp::Div, a, _) => left.push(a),
            other if is_sum(other) => return true,
            _ => {}
        }
    }
    false
}

/// The definitions of a model, each given once however often it is used: written out, a chain of them
/// that use each other twice would double at every link.
struct Opened<'m> {
    model: &'m Model,
    seen: BTreeSet<&'m str>,
}

impl<'m> Opened<'m> {
    fn new(model: &'m Model) -> Self {
        Self { model, seen: BTreeSet::new() }
    }

    /// The definition of that name, the first time that it is asked for.
    fn once(&mut self, name: &str) -> Option<&'m Definition> {
        let d = self.model.definitions.iter().find(|d| d.name == name)?;
        self.seen.insert(&d.name).then_some(d)
    }
}

/// The number of the definition that a rate is, where no other rate uses it, or where it is the acceleration of one speed: what
/// other rates use then feels every force on that speed too.
pub fn home(model: &Model, rate: &Expr) -> Option<usize> {
    let Expr::Name(name) = rate else { return None };
    let i = model.definitions.iter().position(|d| d.name == *name)?;
    let own = model.states.iter().filter(|s| reaches(model, &s.rate, name)).count() == 1;
    let mut accelerated = model.states.iter().filter(|s| s.rate == *rate);
    let is_moving = |v: &State| is_speed(model, v) || is_rate(&v.unit);
    let is_acceleration = accelerated.next().is_some_and(is_moving) && accelerated.next().is_none();
    (own || is_acceleration).then(|| home(model, &model.definitions[i].equals).unwrap_or(i))
}

/// Whether another state's rate is a state, or a multiple of it.
fn is_speed(model: &Model, v: &State) -> bool {
    model.states.iter().any(|s| is_multiple_of(&s.rate, &v.name))
}

/// Whether a rate is a state alone, as that of a position is its speed: no force enters there.
pub fn is_kinematic(model: &Model, rate: &Expr) -> bool {
    matches!(rate, Expr::Name(n) if model.states.iter().any(|s| s.name == *n))
}

/// The expression of a rate: of the definition that it is, where it is one.
pub fn opened<'e>(model: &'e Model, rate: &'e Expr) -> &'e Expr {
    home(model, rate).map_or(rate, |i| &model.definitions[i].equals)
}

/// The innermost sum that forms a rate: under its products and quotients.
pub fn sum_of<'e>(model: &'e Model, rate: &'e Expr) -> &'e Expr {
    sum_in(model, opened(model, rate))
}

fn sum_in<'e>(model: &Model, e: &'e Expr) -> &'e Expr {
    match e {
        Expr::Binary(BinaryOp::Mul, a, b) if leads_to_sum(model, e) => {
            if leads_to_sum(model, a) {
                sum_in(model, a)
            } else {
                sum_in(model, b)
            }
        }
        Expr::Binary(BinaryOp::Div, a, _) if leads_to_sum(model, a) => sum_in(model, a),
        other => other,
    }
}

/// The difference that drives a state after what acts on it, where the state is no speed: u - x of x' = (u - x)/T.
pub fn follows<'m>(model: &'m Model, x: &'m State) -> Option<&'m Expr> {
    let sum = sum_of(model, &x.rate);
    let is_itself = |t: &Expr| matches!(t, Expr::Name(n) if *n == x.name);
    (!is_speed(model, x) && terms_of(model, sum).iter().any(is_itself)).then_some(sum)
}

/// The terms of a sum without their signs; every definition that is a sum is opened once.
pub fn terms_of(model: &Model, sum: &Expr) -> Vec<Expr> {
    let mut opened = Opened::new(model);
    let (mut left, mut terms) = (vec![sum], Vec::new());
    while let Some(e) = left.pop() {
        match e {
            Expr::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => left.extend([&**b, &**a]),
            Expr::Neg(a) => left.push(a),
            Expr::Name(n) if model.definitions.iter().any(|d| d.name == *n && is_sum(&d.equals)) => {
                left.extend(opened.once(n).map(|d| &d.equals));
            }
            other => terms.push(other.clone()),
        }
    }
    terms
}

/// The terms of a sum as laws: of a term that is a sum of laws over parameters, as forces over a mass, those.
pub fn laws_of(model: &Model, sum: &Expr) -> Vec<Expr> {
    let opened = |term: Expr| match laws_over(model, &term) {
        Some(sum) => laws_of(model, sum),
        None => vec![term],
    };
    terms_of(model, sum).into_iter().flat_map(opened).collect()
}

/// The sum of laws, parameters times signals, that a quotient by parameters is.
fn laws_over<'e>(model: &'e Model, term: &'e Expr) -> Option<&'e Expr> {
    let Expr::Binary(BinaryOp::Div, over, under) = term else { return None };
    let is_parameter = |n: &str| model.parameters.iter().any(|p| p.name == n);
    let sum = match &**over {
        Expr::Name(n) => &model.definitions.iter().find(|d| d.name == *n)?.equals,
        Expr::Neg(a) => a,
        other => other,
    };
    let is_law =
        |t: &Expr| matches!(t, Expr::Binary(BinaryOp::Mul, _, _)) && t.names().into_iter().any(is_parameter);
    let is_constant = under.names().into_iter().all(is_parameter);
    (is_constant && is_sum(sum) && terms_of(model, sum).iter().any(is_law)).then_some(sum)
}

/// Whether the sum in a rate has a term that is a signal times parameters and numbers.
pub fn has_term_in(model: &Model, rate: &Expr, signal: &str) -> bool {
    coefficients(model, rate, signal).next().is_some()
}

/// Whether it has one of any size that a recording may ask for: one of its parameters is fitted and inside its bounds, or
/// it has none.
pub fn has_free_term_in(model: &Model, rate: &Expr, signal: &str) -> bool {
    let is_free = |p: &&Parameter| p.fit && pressed_against(p).is_none();
    coefficients(model, rate, signal).any(|all| all.is_empty() || all.iter().any(is_free))
}

/// The parameters of each term that is a signal times parameters and numbers.
fn coefficients<'m>(model: &'m Model, rate: &Expr, signal: &str) -> impl Iterator<Item = Vec<&'m Parameter>> {
    let of = |t: &Expr| -> Option<Vec<&'m Parameter>> {
        let others = t.names().into_iter().filter(|n| *n != signal);
        let known = others.map(|n| model.parameters.iter().find(|p| p.name == n)).collect::<Option<_>>()?;
        is_product_with(t, signal).then_some(known)
    };
    let found: Vec<_> = laws_of(model, sum_of(model, rate)).iter().filter_map(of).collect();
    found.into_iter()
}

/// At which of its bounds a parameter lies.
pub fn pressed_against(p: &Parameter) -> Option<Side> {
    Range::of(p).at_bound(p.value)
}

/// Whether an expression is a product or quotient with a name as one of its factors.
fn is_product_with(e: &Expr, name: &str) -> bool {
    match e {
        Expr::Name(n) => n == name,
        Expr::Neg(a) | Expr::Binary(BinaryOp::Div, a, _) => is_product_with(a, name),
        Expr::Binary(BinaryOp::Mul, a, b) => is_product_with(a, name) || is_product_with(b, name),
        _ => false,
    }
}

/// The expression of a rate with its innermost sum replaced by `with(sum)`.
pub fn with_sum(model: &Model, e: &Expr, with: &dyn Fn(&Expr) -> Expr) -> Expr {
    let boxed = |x: Expr| Box::new(x);
    match e {
        Expr::Binary(BinaryOp::Mul, a, b) if leads_to_sum(model, e) => {
            if leads_to_sum(model, a) {
                Expr::Binary(BinaryOp::Mul, boxed(with_sum(model, a, with)), b.clone())
            } else {
                Expr::Binary(BinaryOp::Mul, a.clone(), boxed(with_sum(model, b, with)))
            }
        }
        Expr::Binary(BinaryOp::Div, a, b) if leads_to_sum(model, a) => {
            Expr::Binary(BinaryOp::Div, boxed(with_sum(model, a, with)), b.clone())
        }
        other => with(other),
    }
}

/// a + b, with a leading minus of b written as a subtraction.
pub fn plus(a: &Expr, b: &Expr) -> Expr {
    let sub = |x: &Expr| Expr::Binary(BinaryOp::Sub, Box::new(a.clone()), Box::new(x.clone()));
    match leading_minus(b) {
        Some(positive) => sub(&positive),
        None => Expr::Binary(BinaryOp::Add, Box::new(a.clone()), Box::new(b.clone())),
    }
}

/// a - b, with a leading minus of b written as an addition.
pub fn minus(a: &Expr, b: &Expr) -> Expr {
    match leading_minus(b) {
        Some(positive) => Expr::Binary(BinaryOp::Add, Box::new(a.clone()), Box::new(positive)),
        None => Expr::Binary(BinaryOp::Sub, Box::new(a.clone()), Box::new(b.clone())),
    }
}

/// A product without its leading minus; none where it has none.
pub fn leading_minus(e: &Expr) -> Option<Expr> {
    match e {
        Expr::Neg(a) if !is_sum(a) => Some((**a).clone()),
        Expr::Binary(op @ (BinaryOp::Mul | BinaryOp::Div), a, b) => {
            Some(Expr::Binary(*op, Box::new(leading_minus(a)?), b.clone()))
        }
        _ => None,
    }
}

/// Every expression of the model in which a signal may stand.
pub fn for_each(model: &mut Model, mut edit: impl FnMut(Place<'_>, &mut Expr)) {
    for d in &mut model.definitions {
        edit(Place::Definition(&d.name.clone()), &mut d.equals);
    }
    for s in &mut model.states {
        edit(Place::Rate(&s.name.clone()), &mut s.rate);
    }
    for o in &mut model.outputs {
        edit(Place::Output(&o.name.clone()), &mut o.equals);
    }
}

/// Where an expression stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place<'a> {
    /// In a definition.
    Definition(&'a str),
    /// In the rate of a state.
    Rate(&'a str),
    /// In an output.
    Output(&'a str),
}

/// Whether a name occurs in an expression or in a definition that it uses.
pub fn reaches(model: &Model, e: &Expr, name: &str) -> bool {
    model.reaches(e, name)
}

/// Whether a name stands in an expression outside its sines and cosines.
pub fn is_plainly_in(e: &Expr, name: &str) -> bool {
    match e {
        Expr::Name(n) => n == name,
        Expr::Call(Function::Sin | Function::Cos, _) => false,
        _ => e.children().into_iter().any(|child| is_plainly_in(child, name)),
    }
}

/// An expression with every subtree passed through `with`, from the leaves up.
pub fn rebuilt(e: &Expr, with: &dyn Fn(Expr) -> Expr) -> Expr {
    let inner = e.map_children(&mut |child| rebuilt(child, with));
    with(inner)
}

/// The first subtree, from the root down, of which something holds.
pub fn find<'e>(e: &'e Expr, holds: &dyn Fn(&Expr) -> bool) -> Option<&'e Expr> {
    if holds(e) {
        return Some(e);
    }
    e.children().into_iter().find_map(|child| find(child, holds))
}

/// Whether a unit is one over time, or an angle over time.
pub fn is_frequency(unit: &Unit) -> bool {
    unit.dimension() == Dimension::NONE.over(Dimension::TIME)
}

/// The unit of what acts on a state, from that of the innermost sum of its rate; it is that of the rate itself where the sum,
/// such as ω²·φ, counts another power of an angle.
pub fn unit_of_force(sum: Unit, state: &Unit) -> Unit {
    let is_other = |rate: &Unit| {
        let angle = rate.angle_power();
        rate.dimension() == sum.dimension() && angle.is_some() && angle != sum.angle_power()
    };
    let rate = Unit::parse("s").map(|second| state.over(&second));
    rate.ok().filter(is_other).unwrap_or(sum).usual()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_of_a_sum_is_a_multiple() {
        let model = Model::parse(
            "name = \"none\"\n[parameters]\nT = { value = 1, unit = \"s\" }\n[states]\nw = { rate = \"-w/T\", unit = \"1\", initial = 0 }\n\
                                  [definitions]\nboth = { equals = \"w + 1\", unit = \"1\" }\n\
                                  [outputs]\ny = { equals = \"w\", unit = \"1\" }\n",
        );
        let model = model.expect("a model");
        let has = |text: &str| has_multiple_of(&model, &Expr::parse(text).expect("an expression"), "w");
        assert!(["-w", "both"].into_iter().all(has));
        assert!(["w", "w/3", "w + c*i", "2*i - 4*w"].into_iter().all(has));
        assert!(!["c*i", "sin(w) + i", "w*w", "i/w"].into_iter().any(has));
    }

    #[test]
    fn the_unit_of_a_power_with_a_sign() {
        let of_name = |n: &str| Unit::parse(if n == "A" { "m^2" } else { "m^3/s" }).ok();
        let speed = Unit::parse("m/s").unwrap().dimension();
        for text in ["A^-1*q", "q*A^(-1)", "q*A^(-2/2)", "q/A"] {
            let unit = unit_of(&Expr::parse(text).unwrap(), &of_name);
            assert_eq!(unit.dimension(), speed, "{text}");
        }
    }

    #[test]
    fn what_acts_counts_the_angle_once() {
        let of = |sum: &str, state: &str| {
            unit_of_force(Unit::parse(sum).unwrap(), &Unit::parse(state).unwrap()).text().to_string()
        };
        assert_eq!(of("rad^3/s^2", "rad/s"), "rad/s^2");
        assert_eq!(of("rad^2/s^2", "deg/s"), "deg/s^2");
        assert_eq!(of("N*m", "rad/s"), "N*m");
        assert_eq!(of("1/h^2", "1/h"), "1/h^2");
    }
}
