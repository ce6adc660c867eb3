//! Values and derivatives of expressions.
//!
//! Purpose: a formula that evaluates and differentiates in any of its symbols.
//! Method: the rules of calculus on the tree.
//! References: none needed.
//! Numerical aspects: values are as good as the formula is conditioned; steps and corners are differentiated piecewise.

use crate::error::nearest;
use crate::expression::{BinaryOp, Expr, Function};
use crate::{Error, Result};
use std::collections::BTreeSet;

/// The value of an expression where the names have values.
///
/// # Errors
/// Bad input, where a name has no value.
///
/// ```
/// use gyrospec::{expression::Expr, symbolic::value};
/// let area = Expr::parse("pi*r^2")?;
/// assert_eq!(value(&area, &|name| (name == "r").then_some(2.0))?, 4.0 * std::f64::consts::PI);
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn value(expression: &Expr, of: &dyn Fn(&str) -> Option<f64>) -> Result<f64> {
    match expression {
        Expr::Number(number) => Ok(*number),
        Expr::Name(name) => of(name)
            .or((name == "pi").then_some(std::f64::consts::PI))
            .ok_or_else(|| Error::bad_input(format!("the symbol {name} has no value"))),
        Expr::Neg(inner) => Ok(-value(inner, of)?),
        Expr::Binary(BinaryOp::Pow, base, exponent) => {
            let (base, exponent) = (value(base, of)?, value(exponent, of)?);
            let whole = exponent.fract() == 0.0 && exponent.abs() < 1e6;
            Ok(if whole { base.powi(exponent as i32) } else { base.powf(exponent) })
        }
        Expr::Binary(op, left, right) => Ok(op.of(value(left, of)?, value(right, of)?)),
        Expr::Call(function, arguments) => {
            let arguments = arguments.iter().map(|a| value(a, of)).collect::<Result<Vec<_>>>()?;
            Ok(function.of(&arguments))
        }
    }
}

/// Every symbol of an expression; unlike its names, with the time `t`.
pub fn symbols(expression: &Expr) -> BTreeSet<&str> {
    let mut symbols = expression.names();
    if expression.mentions("t") {
        symbols.insert("t");
    }
    symbols
}

/// Refuses a name that is no letter of a formula.
///
/// # Errors
/// Bad input, with the nearest letter that there is.
pub fn known_letter(name: &str, known: &BTreeSet<String>) -> Result<()> {
    if known.contains(name) {
        return Ok(());
    }
    let letters = || known.iter().map(String::as_str);
    let hint = match nearest(name, letters()) {
        Some(near) => format!("the nearest is {near}"),
        None if known.is_empty() => "it has none".into(),
        None => format!("it has {}", letters().collect::<Vec<_>>().join(", ")),
    };
    Err(Error::bad_input(format!("'{name}' is no letter of this formula")).with_hint(hint))
}

/// The derivative of an expression in one name, lightly simplified.
///
/// # Errors
/// Not computed, where the name stands under a function with a memory, or in min, max or clamp.
///
/// ```
/// use gyrospec::{expression::Expr, symbolic::derivative};
/// let slope = derivative(&Expr::parse("a*sin(2*K)")?, "K")?;
/// assert_eq!(slope.to_string(), "a*(cos(2*K)*2)");
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn derivative(expression: &Expr, name: &str) -> Result<Expr> {
    if !expression.mentions(name) {
        return Ok(Expr::Number(0.0));
    }
    match expression {
        Expr::Number(_) => Ok(Expr::Number(0.0)),
        Expr::Name(_) => Ok(Expr::Number(1.0)),
        Expr::Neg(inner) => Ok(minus(derivative(inner, name)?)),
        Expr::Binary(op, left, right) => binary(*op, left, right, name),
        Expr::Call(function, arguments) => {
            let [argument] = arguments.as_slice() else { return Err(refused(expression, name)) };
            let outer = outer(*function, argument).ok_or_else(|| refused(expression, name))?;
            Ok(times(outer, derivative(argument, name)?))
        }
    }
}

fn refused(expression: &Expr, name: &str) -> Error {
    Error::not_computed(format!("the derivative of {expression} in {name} is not worked out"))
}

fn binary(op: BinaryOp, left: &Expr, right: &Expr, name: &str) -> Result<Expr> {
    let (l, r) = (left.clone(), right.clone());
    match op {
        BinaryOp::Add => Ok(plus(derivative(left, name)?, derivative(right, name)?)),
        BinaryOp::Sub => Ok(plus(derivative(left, name)?, minus(derivative(right, name)?))),
        BinaryOp::Mul => Ok(plus(times(derivative(left, name)?, r), times(l, derivative(right, name)?))),
        BinaryOp::Div => {
            // (l/r)′ = l′/r − l r′/r²
            let first = over(derivative(left, name)?, r.clone());
            let second = over(times(l, derivative(right, name)?), r.pow(2.0));
            Ok(plus(first, minus(second)))
        }
        BinaryOp::Pow => {
            if let Some(n) = right.constant() {
                // (lⁿ)′ = n lⁿ⁻¹ l′
                let lowered = if n == 2.0 { l } else { l.pow(n - 1.0) };
                return Ok(times(times(Expr::number(n), lowered), derivative(left, name)?));
            }
            // (lʳ)′ = lʳ (r′ ln l + r l′/l)
            let growth = times(derivative(right, name)?, Expr::call(Function::Ln, [l.clone()]));
            let inner = over(times(r.clone(), derivative(left, name)?), l.clone());
            Ok(times(Expr::Binary(BinaryOp::Pow, Box::new(l), Box::new(r)), plus(growth, inner)))
        }
    }
}

/// f′ at the argument, for functions of one argument.
fn outer(function: Function, x: &Expr) -> Option<Expr> {
    let call = |f: Function| Expr::call(f, [x.clone()]);
    let one = || Expr::Number(1.0);
    let square = || x.clone().pow(2.0);
    Some(match function {
        Function::Sin => call(Function::Cos),
        Function::Cos => -call(Function::Sin),
        Function::Tan => one() + call(Function::Tan).pow(2.0),
        Function::Asin => one() / Expr::call(Function::Sqrt, [one() - square()]),
        Function::Acos => -(one() / Expr::call(Function::Sqrt, [one() - square()])),
        Function::Atan => one() / (one() + square()),
        Function::Sinh => call(Function::Cosh),
        Function::Cosh => call(Function::Sinh),
        Function::Tanh => one() - call(Function::Tanh).pow(2.0),
        Function::Exp => call(Function::Exp),
        Function::Ln => one() / x.clone(),
        Function::Sqrt => one() / (Expr::Number(2.0) * call(Function::Sqrt)),
        Function::Abs => call(Function::Sign),
        Function::Sign | Function::Step => Expr::Number(0.0),
        _ => return None,
    })
}

fn is(expression: &Expr, number: f64) -> bool {
    *expression == Expr::Number(number)
}

fn plus(left: Expr, right: Expr) -> Expr {
    match (is(&left, 0.0), is(&right, 0.0), right) {
        (true, _, right) => right,
        (_, true, _) => left,
        (_, _, Expr::Neg(right)) => left - *right,
        (_, _, right) => left + right,
    }
}

fn minus(inner: Expr) -> Expr {
    match inner {
        Expr::Neg(inner) => *inner,
        inner if is(&inner, 0.0) => inner,
        inner => -inner,
    }
}

fn times(left: Expr, right: Expr) -> Expr {
    match (left, right) {
        (zero, _) | (_, zero) if is(&zero, 0.0) => zero,
        (one, other) | (other, one) if is(&one, 1.0) => other,
        (Expr::Neg(left), right) => minus(times(*left, right)),
        (left, Expr::Neg(right)) => minus(times(left, *right)),
        (left, right) => left * right,
    }
}

fn over(left: Expr, right: Expr) -> Expr {
    if is(&left, 0.0) { left } else { left / right }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_agree_with_differences() {
        for text in [
            "sin(2*x)/x^3 - (x+1)^2",
            "sqrt(x^2+1)*exp(-x) + atan(x)*tanh(x)",
            "x^x + x^2.5 + 2^x",
            "asin(x/4)*acos(x/3) - ln(x)*cosh(x)/sinh(x)",
            "abs(-x)*cos(x)*tan(x)",
        ] {
            let e = Expr::parse(text).unwrap();
            let slope = derivative(&e, "x").unwrap();
            let at = |e: &Expr, x: f64| value(e, &|name| (name == "x").then_some(x)).unwrap();
            let (x, h) = (0.7, 1e-5);
            let difference = (at(&e, x + h) - at(&e, x - h)) / (2.0 * h);
            approx::assert_relative_eq!(at(&slope, x), difference, max_relative = 1e-8);
        }
    }
}
