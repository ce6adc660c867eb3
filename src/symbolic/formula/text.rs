//! Formulas as plain text with Greek letters and raised figures.
//!
//! Single letters stand close together, as in print; where a product holds a longer name its factors are set apart.

use super::glyph::text_name;
use crate::expression::{BinaryOp, Expr, Function};

/// The expression as text.
pub fn text(expression: &Expr) -> String {
    sum(expression, 0)
}

/// How deep brackets are nested decides how wide sums are set.
fn sum(expression: &Expr, depth: usize) -> String {
    let (plus, minus) = if depth < 2 { (" + ", " − ") } else { ("+", "−") };
    match expression {
        Expr::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), left, right) => {
            let negative = *op == BinaryOp::Sub;
            let sign = if negative { minus } else { plus };
            let right = if is_sum(right) && negative { bracket(right, depth) } else { sum(right, depth) };
            format!("{}{sign}{right}", sum(left, depth))
        }
        Expr::Neg(inner) if is_sum(inner) => format!("−{}", bracket(inner, depth)),
        Expr::Neg(inner) => format!("−{}", sum(inner, depth)),
        _ => match leading_minus(expression) {
            Some(positive) => format!("−{}", product(&positive, depth)),
            None => product(expression, depth),
        },
    }
}

/// A product or quotient that begins with a minus, without it.
pub fn leading_minus(expression: &Expr) -> Option<Expr> {
    match expression {
        Expr::Neg(inner) => Some((**inner).clone()),
        Expr::Binary(op @ (BinaryOp::Mul | BinaryOp::Div), left, right) => {
            Some(Expr::Binary(*op, Box::new(leading_minus(left)?), right.clone()))
        }
        _ => None,
    }
}

pub fn is_sum(expression: &Expr) -> bool {
    matches!(expression, Expr::Binary(BinaryOp::Add | BinaryOp::Sub, ..) | Expr::Neg(_))
}

fn bracket(expression: &Expr, depth: usize) -> String {
    let inside = sum(expression, depth + 1);
    if depth == 0 && inside.contains('(') { format!("[{inside}]") } else { format!("({inside})") }
}

fn product(expression: &Expr, depth: usize) -> String {
    let (above, below) = fraction(expression);
    let line = if depth == 0 { " / " } else { "/" };
    match below.as_slice() {
        [] => joined(&above, depth),
        [one] => format!("{}{line}{}", joined(&above, depth), factor(one, depth)),
        _ => format!("{}{line}({})", joined(&above, depth), joined(&below, depth)),
    }
}

/// The factors above and below the line of a chain of products and quotients; a 1 is left out beside others.
pub fn fraction(expression: &Expr) -> (Vec<&Expr>, Vec<&Expr>) {
    let (mut above, mut below) = match expression {
        Expr::Binary(BinaryOp::Mul, left, right) => {
            let ((above, below), (more, under)) = (fraction(left), fraction(right));
            ([above, more].concat(), [below, under].concat())
        }
        Expr::Binary(BinaryOp::Div, left, right) => {
            let ((above, below), (under, more)) = (fraction(left), fraction(right));
            ([above, more].concat(), [below, under].concat())
        }
        _ => (vec![expression], Vec::new()),
    };
    let one = |e: &&Expr| **e == Expr::Number(1.0);
    below.retain(|e| !one(e));
    if above.iter().any(|e| !one(e)) {
        above.retain(|e| !one(e));
    } else {
        above.truncate(1);
    }
    (above, below)
}

/// The terms of a sum; the flag is a minus.
pub fn terms(expression: &Expr, minus: bool) -> Vec<(Expr, bool)> {
    match expression {
        Expr::Neg(inner) => terms(inner, !minus),
        Expr::Binary(BinaryOp::Add, x, y) => [terms(x, minus), terms(y, minus)].concat(),
        Expr::Binary(BinaryOp::Sub, x, y) => [terms(x, minus), terms(y, !minus)].concat(),
        _ => vec![(expression.clone(), minus)],
    }
}

/// The factors of a product, from left to right.
pub fn factors(expression: &Expr) -> Vec<&Expr> {
    match expression {
        Expr::Binary(BinaryOp::Mul, left, right) => [factors(left), factors(right)].concat(),
        _ => vec![expression],
    }
}

fn joined(factors: &[&Expr], depth: usize) -> String {
    let base = |e: &Expr| match e {
        Expr::Binary(BinaryOp::Pow, base, _) => (**base).clone(),
        _ => e.clone(),
    };
    let long =
        factors.iter().any(|f| matches!(base(f), Expr::Name(name) if text_name(&name).chars().count() > 1));
    let several = factors.iter().filter(|f| matches!(base(f), Expr::Name(_))).count() > 1;
    let mut line = String::new();
    for (place, f) in factors.iter().enumerate() {
        let next = match f {
            Expr::Call(function, arguments) if !ends_clearly(&factors[place + 1..]) => {
                bracketed_call(*function, arguments, depth)
            }
            _ => factor(f, depth),
        };
        let (last, first) = (line.chars().last(), next.chars().next());
        let calls = matches!(base(f), Expr::Call(..)) || last.is_some_and(|_| line.ends_with(is_argument));
        let letters = |c: Option<char>| c.is_some_and(char::is_alphabetic);
        let digits = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        let wide = letters(last) || (several && digits(last));
        let apart = calls || (long && depth < 2) || (depth == 0 && wide && letters(first)) || digits(first);
        if apart && last.is_some() {
            line.push(' ');
        }
        line.push_str(&next);
        if matches!(f, Expr::Call(..)) && !line.ends_with(')') {
            line.push(ARGUMENT);
        }
    }
    line.replace(ARGUMENT, "")
}

/// Marks the end of an argument without brackets while a product is set.
const ARGUMENT: char = '\u{1f}';

fn is_argument(c: char) -> bool {
    c == ARGUMENT
}

fn factor(expression: &Expr, depth: usize) -> String {
    match expression {
        Expr::Number(value) => format!("{value}"),
        Expr::Name(name) => text_name(name),
        Expr::Call(function, arguments) => call(*function, arguments, depth),
        Expr::Binary(BinaryOp::Pow, base, exponent) => {
            let base = match &**base {
                simple @ (Expr::Name(_) | Expr::Number(_)) => factor(simple, depth),
                other => bracket(other, depth),
            };
            format!("{base}{}", raised(exponent, depth))
        }
        _ => bracket(expression, depth),
    }
}

fn raised(exponent: &Expr, depth: usize) -> String {
    match exponent.constant() {
        Some(whole) if whole.fract() == 0.0 => whole.to_string().chars().map(superscript).collect(),
        _ => format!("^{}", factor(exponent, depth + 1)),
    }
}

fn superscript(c: char) -> char {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize])
}

/// sin 2K, but sin(a + b).
fn call(function: Function, arguments: &[Expr], depth: usize) -> String {
    let name = if function == Function::Sqrt { "√" } else { function.name() };
    if let [argument] = arguments
        && factors(argument).iter().all(|f| matches!(f, Expr::Name(_) | Expr::Number(_)))
    {
        let inside = joined(&factors(argument), depth + 2);
        let bare = factors(argument).len() == 1;
        return match function {
            Function::Sqrt if bare => format!("√{inside}"),
            Function::Sqrt => format!("√({inside})"),
            _ => format!("{name} {inside}"),
        };
    }
    bracketed_call(function, arguments, depth)
}

fn bracketed_call(function: Function, arguments: &[Expr], depth: usize) -> String {
    let name = if function == Function::Sqrt { "√" } else { function.name() };
    let arguments: Vec<String> = arguments.iter().map(|a| sum(a, depth + 1)).collect();
    format!("{name}({})", arguments.join(", "))
}

/// Whether an argument without brackets cannot be taken to go on in what follows.
pub fn ends_clearly(following: &[&Expr]) -> bool {
    following.first().is_none_or(|next| matches!(next, Expr::Call(..)))
}
