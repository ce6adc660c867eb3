//! Infers the dimension of an expression.
//!
//! A number is a pure number; only the literal 0 agrees with every dimension. Angles count as 1.

use super::{BinaryOp, Expr, Function, parse};
use crate::error::nearest;
use crate::units::{Dimension, Ratio};
use crate::{Error, ErrorKind, Result};
use std::collections::BTreeMap;

/// The dimensions of the names that an expression may use; `pi` and `t` are always known.
pub type Scope = BTreeMap<String, Dimension>;

/// A disagreement, and the way from the root to the subexpression that it concerns.
pub(super) struct Fault {
    pub path: Vec<usize>,
    pub message: String,
    pub hint: Option<String>,
}

/// `None` is the dimension of a literal 0: any.
type Inferred = Option<Dimension>;

impl Expr {
    /// The dimension of the expression; that of a bare 0 is none.
    ///
    /// ```
    /// use gyrospec::expression::{Expr, Scope};
    /// use gyrospec::units::Unit;
    /// let scope = Scope::from([("x".into(), Unit::parse("m")?.dimension())]);
    /// assert_eq!(Expr::parse("x/t^2")?.dimension(&scope)?, Unit::parse("m/s^2")?.dimension());
    /// let e = Expr::parse("x + 2*t")?.dimension(&scope).unwrap_err();
    /// assert!(e.to_string().contains("x + 2*t\n      ^^^"));
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// An unknown name, or terms that do not agree: the error underlines the term and names both.
    pub fn dimension(&self, scope: &Scope) -> Result<Dimension> {
        let found = infer(self, scope).map_err(|fault| shown(&fault, &self.to_string()))?;
        Ok(found.unwrap_or(Dimension::NONE))
    }

    /// Checks that the expression has a wanted dimension (a literal 0 has every one).
    ///
    /// # Errors
    /// As [`Expr::dimension`]; the error shows `text`, which must be what the expression was read from.
    pub fn expect_dimension(&self, wanted: Dimension, scope: &Scope, text: &str) -> Result<()> {
        match infer(self, scope).map_err(|fault| shown(&fault, text))? {
            Some(found) if found != wanted => {
                let message = format!("this has the unit {found}, but {wanted} is wanted");
                Err(shown(&Fault { path: Vec::new(), message, hint: None }, text))
            }
            _ => Ok(()),
        }
    }

    /// Checks that every name is known, whatever its unit.
    ///
    /// # Errors
    /// The first name that is not; the error shows `text`, which must be what the expression was read from.
    pub fn expect_names(&self, scope: &Scope, text: &str) -> Result<()> {
        named(self, scope).map_err(|fault| shown(&fault, text))
    }

    /// As [`Expr::dimension`], but tells a bare 0 (any dimension, `None`) from a pure number.
    ///
    /// # Errors
    /// As [`Expr::dimension`].
    pub fn inferred_dimension(&self, scope: &Scope) -> Result<Option<Dimension>> {
        infer(self, scope).map_err(|fault| shown(&fault, &self.to_string()))
    }
}

/// The error with the faulty place underlined in the text.
pub(super) fn shown(fault: &Fault, text: &str) -> Error {
    let mut e = Error::new(ErrorKind::Units, fault.message.clone());
    if let Ok((_, span)) = parse::spanned(text) {
        let place = fault.path.iter().try_fold(&span, |s, i| s.children.get(*i)).unwrap_or(&span);
        e = e.with_column(place.start + 1).with_excerpt(text, place.start, place.end - place.start);
    }
    match &fault.hint {
        Some(hint) => e.with_hint(hint.clone()),
        None => e,
    }
}

fn fault(message: impl Into<String>) -> Fault {
    Fault { path: Vec::new(), message: message.into(), hint: None }
}

pub(super) fn within<T>(index: usize, inner: Result<T, Fault>) -> Result<T, Fault> {
    inner.map_err(|mut fault| {
        fault.path.insert(0, index);
        fault
    })
}

fn spelled(d: Inferred) -> String {
    d.map_or("any unit".into(), |d| {
        if d.is_none() { "1 (a pure number or an angle)".into() } else { d.to_string() }
    })
}

fn infer(e: &Expr, scope: &Scope) -> Result<Inferred, Fault> {
    match e {
        Expr::Number(x) => Ok((*x != 0.0).then_some(Dimension::NONE)),
        Expr::Name(name) => of_name(name, scope).map(Some),
        Expr::Neg(a) => within(0, infer(a, scope)),
        Expr::Binary(op, a, b) => {
            let left = within(0, infer(a, scope))?;
            let right = within(1, infer(b, scope))?;
            match op {
                BinaryOp::Add | BinaryOp::Sub => agree(1, left, right, "what it is added to"),
                BinaryOp::Mul => Ok(Some(or_none(left).times(or_none(right)))),
                BinaryOp::Div => Ok(Some(or_none(left).over(or_none(right)))),
                BinaryOp::Pow => within(1, pure(right, "an exponent")).and_then(|()| power(left, b)),
            }
        }
        Expr::Call(function, arguments) => {
            let mut found = Vec::with_capacity(arguments.len());
            for (i, a) in arguments.iter().enumerate() {
                found.push(within(i, infer(a, scope))?);
            }
            of_call(*function, &found)
        }
    }
}

fn named(e: &Expr, scope: &Scope) -> Result<(), Fault> {
    match e {
        Expr::Number(_) => Ok(()),
        Expr::Name(name) => of_name(name, scope).map(|_| ()),
        Expr::Neg(a) => within(0, named(a, scope)),
        Expr::Binary(_, a, b) => within(0, named(a, scope)).and_then(|()| within(1, named(b, scope))),
        Expr::Call(_, arguments) => {
            arguments.iter().enumerate().try_for_each(|(i, a)| within(i, named(a, scope)))
        }
    }
}

fn or_none(d: Inferred) -> Dimension {
    d.unwrap_or(Dimension::NONE)
}

fn of_name(name: &str, scope: &Scope) -> Result<Dimension, Fault> {
    match (scope.get(name), name) {
        (Some(d), _) => Ok(*d),
        (None, "t") => Ok(Dimension::TIME),
        (None, "pi") => Ok(Dimension::NONE),
        (None, _) => {
            let near = nearest(name, scope.keys().map(String::as_str));
            let hint = match near {
                Some(near) => format!("the nearest known name is {near}"),
                None => format!("the known names are {}", known(scope)),
            };
            Err(Fault { path: Vec::new(), message: format!("unknown name {name:?}"), hint: Some(hint) })
        }
    }
}

/// The names of a scope in order, not too many of them.
fn known(scope: &Scope) -> String {
    const MOST: usize = 12;
    let mut names: Vec<&str> = scope.keys().map(String::as_str).chain(["t", "pi"]).collect();
    names.sort_unstable();
    names.dedup();
    let more = if names.len() > MOST { ", …" } else { "" };
    names.truncate(MOST);
    format!("{}{more}", names.join(", "))
}

/// Both dimensions must be one; the fault points at part `index`, the right one.
fn agree(index: usize, left: Inferred, right: Inferred, other: &str) -> Result<Inferred, Fault> {
    match (left, right) {
        (Some(l), Some(r)) if l != r => {
            let message =
                format!("this term has the unit {}, but {other} has {}", spelled(right), spelled(left));
            within(index, Err(fault(message)))
        }
        _ => Ok(left.or(right)),
    }
}

fn pure(d: Inferred, what: &str) -> Result<(), Fault> {
    match d {
        Some(d) if !d.is_none() => {
            Err(fault(format!("{what} must be a pure number or an angle, but this has the unit {d}")))
        }
        _ => Ok(()),
    }
}

fn power(base: Inferred, exponent: &Expr) -> Result<Inferred, Fault> {
    let Some(d) = base.filter(|d| !d.is_none()) else {
        return Ok(Some(Dimension::NONE));
    };
    if let Some(ratio) = exponent.constant().and_then(Ratio::from_f64) {
        return Ok(Some(d.power(ratio)));
    }
    let message = format!("the power of something with a unit ({d}) must be a fixed simple number");
    let hint = Some("divide the base by a parameter of the same unit first".into());
    within(1, Err(Fault { path: Vec::new(), message, hint }))
}

/// What to do where a knot has another unit.
fn by_parameters(fault: Fault) -> Fault {
    let hint = "make the knots parameters with their units, as v1 = { value = -1, unit = \"m/s\" }";
    Fault { hint: Some(hint.into()), ..fault }
}

/// Places along x and y agree with their signals, all values with the first.
fn of_surface(n: usize, m: usize, d: &[Inferred]) -> Result<Inferred, Fault> {
    let places = 2 + n + m;
    let mut value = None;
    let mut signals = [d[0], d[1]];
    for (i, other) in d.iter().enumerate().skip(2) {
        if i < places {
            let signal = &mut signals[usize::from(i >= 2 + n)];
            *signal = agree(i, *signal, *other, "its signal").map_err(by_parameters)?;
        } else {
            value = agree(i, value, *other, "the values before it").map_err(by_parameters)?;
        }
    }
    Ok(value)
}

fn of_call(function: Function, d: &[Inferred]) -> Result<Inferred, Fault> {
    let first = d.first().copied().flatten();
    match function {
        Function::Sqrt => Ok(first.and_then(|x| Some(x.power(Ratio::new(1, 2)?)))),
        Function::Abs => Ok(first),
        Function::Sign | Function::Step => Ok(Some(Dimension::NONE)),
        Function::Foreign(f) => Ok(Some(f.unit().dimension())),
        Function::Min | Function::Max | Function::Clamp | Function::Backlash | Function::Hysteresis => {
            let mut all = d[0];
            for (i, other) in d.iter().enumerate().skip(1) {
                all = agree(i, all, *other, "what stands before it")?;
            }
            Ok(all)
        }
        Function::Curve => {
            let place = |i: usize| if i % 2 == 1 { 0 } else { 2 };
            let mut all = [d[0], None, d[2]];
            for (i, other) in d.iter().enumerate().skip(1) {
                let what = if i % 2 == 1 { "its signal" } else { "the value at its first knot" };
                all[place(i)] = agree(i, all[place(i)], *other, what).map_err(by_parameters)?;
            }
            Ok(all[2])
        }
        Function::Surface(n, m) => of_surface(usize::from(n), usize::from(m), d),
        Function::Atan2 | Function::Relay => {
            agree(1, d[0], d[1], "what stands before it").map(|_| Some(Dimension::NONE))
        }
        Function::Delay | Function::Lag => {
            let wanted = Some(Dimension::TIME);
            agree(1, wanted, d[1], "a time").map(|_| first)
        }
        Function::RateLimit => {
            let wanted = first.map(|x| x.over(Dimension::TIME));
            agree(1, wanted, d[1], "the first argument, per second,").map(|_| first)
        }
        _ => {
            within(0, pure(first, &format!("what {} takes", function.name()))).map(|()| Some(Dimension::NONE))
        }
    }
}
