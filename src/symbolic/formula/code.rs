//! Formulas as functions in Rust, Python and C.

use super::Formula;
use super::calculus::symbols;
use super::identifier::{CodeLanguage, arguments, identifier};
use crate::expression::{BinaryOp, Expr, Function};
use crate::{Error, Result};
use std::fmt::Write;

/// A function of the symbols in alphabetical order.
pub fn function(formula: &Formula, language: CodeLanguage) -> Result<String> {
    let left = formula.by.iter().fold(formula.name.clone(), |name, by| format!("{name}_by_{by}"));
    let name = identifier(&left, language)?;
    let names = arguments(symbols(&formula.expression), language)?;
    let typed = |before: &str, after: &str| {
        names.iter().map(|n| format!("{before}{n}{after}")).collect::<Vec<_>>().join(", ")
    };
    let value = operand(&formula.expression, language, 0)?;
    let mut text = String::new();
    let _ = match language {
        CodeLanguage::Rust => writeln!(
            text,
            "#[allow(non_snake_case)]\npub fn {name}({}) -> f64 {{\n    {value}\n}}",
            typed("", ": f64")
        ),
        CodeLanguage::Python => {
            writeln!(text, "import math\n\n\ndef {name}({}):\n    return {value}", names.join(", "))
        }
        CodeLanguage::C => writeln!(
            text,
            "#include <math.h>\n\ndouble {name}({})\n{{\n    return {value};\n}}",
            if names.is_empty() { "void".into() } else { typed("double ", "") }
        ),
    };
    Ok(text)
}

/// How tightly the place binds into which an operand is put: 0 sum, 1 product, 2 right of a product, 3 sign.
fn operand(expression: &Expr, language: CodeLanguage, place: u8) -> Result<String> {
    let (text, own) = match expression {
        Expr::Number(value) => (format!("{value:?}"), 4),
        Expr::Name(name) if name == "pi" => (pi(language).into(), 4),
        Expr::Name(name) => (identifier(name, language)?, 4),
        Expr::Neg(inner) => (format!("-{}", operand(inner, language, 3)?), 1),
        Expr::Binary(BinaryOp::Pow, base, exponent) => (power(base, exponent, language)?, 4),
        Expr::Binary(op, left, right) => {
            let (sign, own, next) = match op {
                BinaryOp::Add => ('+', 0, 0),
                BinaryOp::Sub => ('-', 0, 1),
                BinaryOp::Mul => ('*', 1, 1),
                BinaryOp::Div | BinaryOp::Pow => ('/', 1, 2),
            };
            let right = operand(right, language, next.max(own))?;
            (format!("{} {sign} {right}", operand(left, language, own)?), own)
        }
        Expr::Call(function, arguments) => (call(*function, arguments, language)?, 4),
    };
    Ok(if own < place { format!("({text})") } else { text })
}

fn pi(language: CodeLanguage) -> &'static str {
    match language {
        CodeLanguage::Rust => "std::f64::consts::PI",
        CodeLanguage::Python => "math.pi",
        CodeLanguage::C => "3.141592653589793",
    }
}

fn power(base: &Expr, exponent: &Expr, language: CodeLanguage) -> Result<String> {
    let whole = exponent.constant().filter(|e| e.fract() == 0.0 && e.abs() < 1e6);
    let plain = |e: &Expr| operand(e, language, 0);
    Ok(match (language, whole) {
        (CodeLanguage::Rust, Some(e)) => format!("{}.powi({e})", atom(base, language)?),
        (CodeLanguage::Rust, None) => format!("{}.powf({})", atom(base, language)?, plain(exponent)?),
        (CodeLanguage::Python, Some(e)) if e >= 0.0 => format!("{}**{e}", atom(base, language)?),
        (CodeLanguage::Python, _) => format!("{}**{}", atom(base, language)?, atom(exponent, language)?),
        (CodeLanguage::C, _) => format!("pow({}, {})", plain(base)?, plain(exponent)?),
    })
}

/// An operand that a method or a power can follow.
fn atom(expression: &Expr, language: CodeLanguage) -> Result<String> {
    let constant = expression.constant().filter(|x| x.is_finite() && language == CodeLanguage::Rust);
    Ok(match (expression, constant) {
        (_, Some(number)) if number < 0.0 => format!("({number:?}_f64)"),
        (_, Some(number)) => format!("{number:?}_f64"), // a bare literal has no methods
        (Expr::Number(_) | Expr::Name(_), _) => operand(expression, language, 0)?,
        (Expr::Call(..), _) if language != CodeLanguage::Rust => operand(expression, language, 0)?,
        _ => format!("({})", operand(expression, language, 0)?),
    })
}

fn call(function: Function, arguments: &[Expr], language: CodeLanguage) -> Result<String> {
    let inside = arguments.iter().map(|a| operand(a, language, 0)).collect::<Result<Vec<_>>>()?;
    let name = function.name();
    let [first, rest @ ..] = inside.as_slice() else { return Ok(name.into()) };
    if function.has_memory() {
        return Err(Error::bad_input(format!("{name} has a memory and is no function of numbers")));
    }
    if matches!(function, Function::Curve | Function::Surface(..)) {
        return Err(Error::bad_input("a curve or surface through knots is written out in no formula"));
    }
    let all = inside.join(", ");
    Ok(match (function, language) {
        (Function::Sign, CodeLanguage::Rust) => {
            format!("f64::from(i8::from({first} > 0.0) - i8::from({first} < 0.0))")
        }
        (Function::Sign, CodeLanguage::Python) => format!("(({first} > 0) - ({first} < 0))"),
        (Function::Sign, CodeLanguage::C) => format!("(double)(({first} > 0) - ({first} < 0))"),
        (Function::Step, CodeLanguage::Rust) => format!("f64::from(u8::from({first} >= 0.0))"),
        (Function::Step, CodeLanguage::Python) => format!("float({first} >= 0)"),
        (Function::Step, CodeLanguage::C) => format!("(double)({first} >= 0)"),
        (Function::Clamp, CodeLanguage::Rust) => {
            format!("{}.max({}).min({})", atom(&arguments[0], language)?, rest[0], rest[1])
        }
        (Function::Clamp, CodeLanguage::Python) => format!("min(max({first}, {}), {})", rest[0], rest[1]),
        (Function::Clamp, CodeLanguage::C) => format!("fmin(fmax({first}, {}), {})", rest[0], rest[1]),
        (Function::Ln, CodeLanguage::C | CodeLanguage::Python) => {
            format!("{}log({first})", if language == CodeLanguage::C { "" } else { "math." })
        }
        (Function::Abs, CodeLanguage::C) => format!("fabs({first})"),
        (Function::Abs | Function::Min | Function::Max, CodeLanguage::Python) => format!("{name}({all})"),
        (Function::Min | Function::Max, CodeLanguage::C) => format!("f{name}({all})"),
        (_, CodeLanguage::Rust) => format!("{}.{name}({})", atom(&arguments[0], language)?, rest.join(", ")),
        (_, CodeLanguage::Python) => format!("math.{name}({all})"),
        (_, CodeLanguage::C) => format!("{name}({all})"),
    })
}
