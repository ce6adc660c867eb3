//! Expressions in the words of a language.

use crate::expression::{BinaryOp, Expr, Function};

/// How a language spells what expressions are made of.
pub(super) trait Words {
    /// A number that is not negative.
    fn number(&self, x: f64) -> String {
        format!("{x:?}")
    }

    /// A name, `pi` and `t` among them.
    fn name(&self, name: &str) -> String;

    /// a^b
    fn power(&self, a: &Expr, b: &Expr) -> String;

    /// a/b, where the sign `/` does not do.
    fn quotient(&self, _: &Expr, _: &Expr) -> Option<String> {
        None
    }

    /// f(a, …)
    fn call(&self, f: Function, arguments: &[String]) -> String;

    /// The expression.
    fn spell(&self, e: &Expr) -> String {
        match e {
            Expr::Number(x) => self.number(*x),
            Expr::Name(name) => self.name(name),
            Expr::Neg(a) => format!("-{}", self.within(a, Binding::Power)),
            Expr::Binary(BinaryOp::Pow, a, b) => self.power(a, b),
            Expr::Binary(BinaryOp::Div, a, b) => self.quotient(a, b).unwrap_or_else(|| {
                format!("{}/{}", self.within(a, Binding::Product), self.within(b, Binding::Power))
            }),
            Expr::Binary(op, a, b) => {
                let (sign, left, right) = match op {
                    BinaryOp::Add => (" + ", Binding::Sum, Binding::Product),
                    BinaryOp::Sub => (" - ", Binding::Sum, Binding::Product),
                    _ => ("*", Binding::Product, Binding::Power),
                };
                let (left, mut right) = (self.within(a, left), self.within(b, right));
                // no language reads two signs in a row in another way, but some read none
                if right.starts_with('-') {
                    right = format!("({right})");
                }
                format!("{left}{sign}{right}")
            }
            Expr::Call(f, arguments) => {
                let spelt: Vec<String> = arguments.iter().map(|a| self.spell(a)).collect();
                self.call(*f, &spelt)
            }
        }
    }

    /// The expression, in parentheses where it binds more loosely than that.
    fn within(&self, e: &Expr, least: Binding) -> String {
        let spelt = self.spell(e);
        if binding(e) < least { format!("({spelt})") } else { spelt }
    }
}

/// How tightly a construct binds, loosest first.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(super) enum Binding {
    Sum,
    Product,
    Sign,
    Power,
    Atom,
}

fn binding(e: &Expr) -> Binding {
    match e {
        Expr::Number(_) | Expr::Name(_) | Expr::Call(..) => Binding::Atom,
        Expr::Neg(_) => Binding::Sign,
        Expr::Binary(BinaryOp::Add | BinaryOp::Sub, ..) => Binding::Sum,
        Expr::Binary(BinaryOp::Mul | BinaryOp::Div, ..) => Binding::Product,
        Expr::Binary(BinaryOp::Pow, ..) => Binding::Power,
    }
}

/// The exponent as a whole number, where it is written as a small one.
pub(super) fn whole(exponent: &Expr) -> Option<i32> {
    let x = match exponent {
        Expr::Number(x) => *x,
        Expr::Neg(a) => match **a {
            Expr::Number(x) => -x,
            _ => return None,
        },
        _ => return None,
    };
    (x.fract() == 0.0 && x.abs() <= 16.0).then_some(x as i32)
}

/// `f(a, b)`
pub(super) fn called(f: &str, arguments: &[String]) -> String {
    format!("{f}({})", arguments.join(", "))
}
