//! Prints an expression so that it reads back to the same tree.

use super::{BinaryOp, Expr, Function};
use std::fmt::{self, Display, Formatter};

/// How tightly a construct binds, loosest first.
#[derive(PartialEq, PartialOrd, Clone, Copy)]
enum Binding {
    Sum,
    Product,
    Sign,
    Power,
    Atom,
}

fn binding(e: &Expr) -> Binding {
    match e {
        Expr::Number(x) if x.is_sign_negative() => Binding::Sign,
        Expr::Number(_) | Expr::Name(_) | Expr::Call(..) => Binding::Atom,
        Expr::Neg(_) => Binding::Sign,
        Expr::Binary(BinaryOp::Add | BinaryOp::Sub, ..) => Binding::Sum,
        Expr::Binary(BinaryOp::Mul | BinaryOp::Div, ..) => Binding::Product,
        Expr::Binary(BinaryOp::Pow, ..) => Binding::Power,
    }
}

fn operand(e: &Expr, in_parentheses: bool, f: &mut Formatter<'_>) -> fmt::Result {
    if in_parentheses { write!(f, "({e})") } else { e.fmt(f) }
}

fn number(x: f64, f: &mut Formatter<'_>) -> fmt::Result {
    if x != 0.0 && !(1e-4..1e7).contains(&x.abs()) { write!(f, "{x:e}") } else { write!(f, "{x}") }
}

/// The arguments with which a list in brackets begins and ends.
fn lists(function: Function) -> ([usize; 3], [usize; 3]) {
    let Function::Surface(n, m) = function else { return ([usize::MAX; 3], [usize::MAX; 3]) };
    let (n, m) = (usize::from(n), usize::from(m));
    ([2, 2 + n, 2 + n + m], [1 + n, 1 + n + m, 1 + n + m + n * m])
}

impl Display for Expr {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(x) => number(*x, f),
            Self::Name(name) => f.write_str(name),
            Self::Neg(a) => {
                f.write_str("-")?;
                operand(a, binding(a) < Binding::Sign, f)
            }
            Self::Binary(op, a, b) => {
                let (symbol, left, right) = match op {
                    BinaryOp::Add => (" + ", Binding::Sum, Binding::Product),
                    BinaryOp::Sub => (" - ", Binding::Sum, Binding::Product),
                    BinaryOp::Mul => ("*", Binding::Product, Binding::Power),
                    BinaryOp::Div => ("/", Binding::Product, Binding::Power),
                    BinaryOp::Pow => ("^", Binding::Atom, Binding::Sign),
                };
                operand(a, binding(a) < left, f)?;
                f.write_str(symbol)?;
                operand(b, binding(b) < right, f)
            }
            Self::Call(function, arguments) => {
                write!(f, "{}(", function.name())?;
                if let Function::Foreign(foreign) = function {
                    write!(f, "{}, ", foreign.result)?;
                }
                let (opens, closes) = lists(*function);
                for (i, a) in arguments.iter().enumerate() {
                    f.write_str(if i == 0 { "" } else { ", " })?;
                    f.write_str(if opens.contains(&i) { "[" } else { "" })?;
                    a.fmt(f)?;
                    f.write_str(if closes.contains(&i) { "]" } else { "" })?;
                }
                f.write_str(")")
            }
        }
    }
}
