//! Formulas as functions in Rust, Python and C.

use super::Formula;
use super::calculus::symbols;
use crate::expression::{BinaryOp, Expr, Function};
use std::fmt::Write;

/// A language that a formula is written in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CodeLanguage {
    /// Rust.
    Rust,
    /// Python 3.
    Python,
    /// C99.
    C,
}

/// Words that are no names in at least one of the languages.
const RESERVED: [&str; 45] = [
    "as", "and", "assert", "auto", "break", "case", "char", "const", "continue", "def", "default", "del",
    "do", "double", "else", "enum", "except", "extern", "float", "fn", "for", "from", "global", "if", "impl",
    "import", "in", "int", "is", "lambda", "let", "long", "loop", "match", "mod", "not", "or", "pass", "ref",
    "return", "self", "short", "type", "where", "yield",
];

/// A function of the symbols in alphabetical order.
pub fn function(formula: &Formula, language: CodeLanguage) -> String {
    let left = formula.by.iter().fold(formula.name.clone(), |name, by| format!("{name}_by_{by}"));
    let name = identifier(&left);
    let names: Vec<String> = symbols(&formula.expression).into_iter().map(identifier).collect();
    let typed = |before: &str, after: &str| {
        names.iter().map(|n| format!("{before}{n}{after}")).collect::<Vec<_>>().join(", ")
    };
    let value = operand(&formula.expression, language, 0);
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
    text
}

fn identifier(name: &str) -> String {
    if RESERVED.contains(&name) { format!("{name}_") } else { name.into() }
}

/// How tightly the place binds into which an operand is put: 0 sum, 1 product, 2 right of a product, 3 sign.
fn operand(expression: &Expr, language: CodeLanguage, place: u8) -> String {
    let (text, own) = match expression {
        Expr::Number(value) => (format!("{value:?}"), 4),
        Expr::Name(name) if name == "pi" => (pi(language).into(), 4),
        Expr::Name(name) => (identifier(name), 4),
        Expr::Neg(inner) => (format!("-{}", operand(inner, language, 3)), 1),
        Expr::Binary(BinaryOp::Pow, base, exponent) => (power(base, exponent, language), 4),
        Expr::Binary(op, left, right) => {
            let (sign, own, next) = match op {
                BinaryOp::Add => ('+', 0, 0),
                BinaryOp::Sub => ('-', 0, 1),
                BinaryOp::Mul => ('*', 1, 1),
                BinaryOp::Div | BinaryOp::Pow => ('/', 1, 2),
            };
            let right = operand(right, language, next.max(own));
            (format!("{} {sign} {right}", operand(left, language, own)), own)
        }
        Expr::Call(function, arguments) => (call(*function, arguments, language), 4),
    };
    if own < place { format!("({text})") } else { text }
}

fn pi(language: CodeLanguage) -> &'static str {
    match language {
        CodeLanguage::Rust => "std::f64::consts::PI",
        CodeLanguage::Python => "math.pi",
        CodeLanguage::C => "3.141592653589793",
    }
}

fn power(base: &Expr, exponent: &Expr, language: CodeLanguage) -> String {
    let whole = exponent.constant().filter(|e| e.fract() == 0.0 && e.abs() < 1e6);
    match (language, whole) {
        (CodeLanguage::Rust, Some(e)) => format!("{}.powi({e})", atom(base, language)),
        (CodeLanguage::Rust, None) => {
            format!("{}.powf({})", atom(base, language), operand(exponent, language, 0))
        }
        (CodeLanguage::Python, Some(e)) if e >= 0.0 => format!("{}**{e}", atom(base, language)),
        (CodeLanguage::Python, _) => format!("{}**{}", atom(base, language), atom(exponent, language)),
        (CodeLanguage::C, _) => {
            format!("pow({}, {})", operand(base, language, 0), operand(exponent, language, 0))
        }
    }
}

/// An operand that a method or a power can follow.
fn atom(expression: &Expr, language: CodeLanguage) -> String {
    match expression {
        Expr::Number(_) | Expr::Name(_) => operand(expression, language, 0),
        Expr::Call(..) if language != CodeLanguage::Rust => operand(expression, language, 0),
        _ => format!("({})", operand(expression, language, 0)),
    }
}

fn call(function: Function, arguments: &[Expr], language: CodeLanguage) -> String {
    let inside: Vec<String> = arguments.iter().map(|a| operand(a, language, 0)).collect();
    let [first, rest @ ..] = inside.as_slice() else { return function.name().into() };
    match (function, language) {
        (Function::Sign, CodeLanguage::Rust) => {
            format!("f64::from(i8::from({first} > 0.0) - i8::from({first} < 0.0))")
        }
        (Function::Sign, CodeLanguage::Python) => format!("(({first} > 0) - ({first} < 0))"),
        (Function::Sign, CodeLanguage::C) => format!("(double)(({first} > 0) - ({first} < 0))"),
        (Function::Step, CodeLanguage::Rust) => format!("f64::from(u8::from({first} >= 0.0))"),
        (Function::Step, CodeLanguage::Python) => format!("float({first} >= 0)"),
        (Function::Step, CodeLanguage::C) => format!("(double)({first} >= 0)"),
        (Function::Ln, CodeLanguage::C) => format!("log({first})"),
        (Function::Ln, CodeLanguage::Python) => format!("math.log({first})"),
        (Function::Abs, CodeLanguage::C) => format!("fabs({first})"),
        (Function::Abs, CodeLanguage::Python) => format!("abs({first})"),
        (Function::Min | Function::Max, CodeLanguage::Python) => {
            format!("{}({})", function.name(), inside.join(", "))
        }
        (Function::Min | Function::Max, CodeLanguage::C) => {
            format!("f{}({})", function.name(), inside.join(", "))
        }
        (_, CodeLanguage::Rust) => {
            format!("{}.{}({})", atom(&arguments[0], language), function.name(), rest.join(", "))
        }
        (_, CodeLanguage::Python) => format!("math.{}({})", function.name(), inside.join(", ")),
        (_, CodeLanguage::C) => format!("{}({})", function.name(), inside.join(", ")),
    }
}
