//! Formulas in LaTeX.

use super::glyph::latex_name;
use super::text::{ends_clearly, factors, fraction, is_sum, leading_minus};
use crate::expression::{BinaryOp, Expr, Function};

/// The expression in LaTeX, without delimiters.
pub fn latex(expression: &Expr) -> String {
    match expression {
        Expr::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), left, right) => {
            let sign = if *op == BinaryOp::Sub { '-' } else { '+' };
            let right = if *op == BinaryOp::Sub && is_sum(right) { bracket(right) } else { latex(right) };
            format!("{} {sign} {right}", latex(left))
        }
        Expr::Neg(inner) if is_sum(inner) => format!("-{}", bracket(inner)),
        Expr::Neg(inner) => format!("-{}", latex(inner)),
        Expr::Binary(BinaryOp::Mul | BinaryOp::Div, ..) if leading_minus(expression).is_some() => {
            format!("-{}", leading_minus(expression).as_ref().map(latex).unwrap_or_default())
        }
        Expr::Binary(BinaryOp::Mul | BinaryOp::Div, ..) => {
            let (above, below) = fraction(expression);
            if below.is_empty() {
                joined(&above)
            } else {
                format!(r"\frac{{{}}}{{{}}}", side(&above), side(&below))
            }
        }
        _ => factor(expression),
    }
}

/// One side of a line; a sum that stands there alone needs no brackets.
fn side(factors: &[&Expr]) -> String {
    if let [one] = factors { latex(one) } else { joined(factors) }
}

fn joined(factors: &[&Expr]) -> String {
    let mut line = String::new();
    for (place, f) in factors.iter().enumerate() {
        let next = match f {
            Expr::Call(function, arguments) => {
                call(*function, arguments, ends_clearly(&factors[place + 1..]))
            }
            _ => factor(f),
        };
        let figures =
            line.ends_with(|c: char| c.is_ascii_digit()) && next.starts_with(|c: char| c.is_ascii_digit());
        line.push_str(if line.is_empty() {
            ""
        } else if figures {
            r" \cdot "
        } else {
            " "
        });
        line.push_str(&next);
    }
    line
}

fn bracket(expression: &Expr) -> String {
    format!(r"\left({}\right)", latex(expression))
}

fn factor(expression: &Expr) -> String {
    match expression {
        Expr::Number(value) => number(*value),
        Expr::Name(name) => latex_name(name),
        Expr::Call(function, arguments) => call(*function, arguments, true),
        Expr::Binary(BinaryOp::Pow, base, exponent) => {
            let base = match &**base {
                simple @ (Expr::Name(_) | Expr::Number(_)) => factor(simple),
                other => bracket(other),
            };
            format!("{base}^{{{}}}", latex(exponent))
        }
        _ => bracket(expression),
    }
}

fn number(value: f64) -> String {
    let text = value.to_string();
    if text.len() < 12 {
        return text;
    }
    let text = format!("{value:e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    format!(r"{digits} \cdot 10^{{{exponent}}}")
}

/// A call; `bare` leaves the brackets of a plain argument away.
fn call(function: Function, arguments: &[Expr], bare: bool) -> String {
    let name = match function {
        Function::Sqrt => return format!(r"\sqrt{{{}}}", arguments.first().map(latex).unwrap_or_default()),
        Function::Abs => {
            return format!(r"\left|{}\right|", arguments.first().map(latex).unwrap_or_default());
        }
        Function::Sin
        | Function::Cos
        | Function::Tan
        | Function::Sinh
        | Function::Cosh
        | Function::Tanh
        | Function::Exp
        | Function::Ln
        | Function::Min
        | Function::Max => format!(r"\{}", function.name()),
        Function::Asin | Function::Acos | Function::Atan => format!(r"\arc{}", &function.name()[1..]),
        _ => format!(r"\operatorname{{{}}}", function.name().replace('_', r"\_")),
    };
    if let [argument] = arguments
        && bare
        && factors(argument).iter().all(|f| matches!(f, Expr::Name(_) | Expr::Number(_)))
    {
        return format!("{name} {}", latex(argument));
    }
    let arguments: Vec<String> = arguments.iter().map(latex).collect();
    format!(r"{name}\left({}\right)", arguments.join(", "))
}
