//! The tree of an expression.

use super::Function;

/// The binary operations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BinaryOp {
    /// a + b
    Add,
    /// a − b
    Sub,
    /// a·b
    Mul,
    /// a/b
    Div,
    /// aᵇ, to the right and tighter than the sign
    Pow,
}

/// An expression.
#[derive(Debug, Clone, PartialEq)]
pub enum Expr {
    /// A number as written, finite and not negative after parsing.
    Number(f64),
    /// A name; `t` is the time and `pi` is π.
    Name(String),
    /// −a
    Neg(Box<Expr>),
    /// a ∘ b
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// f(a, …)
    Call(Function, Vec<Expr>),
}
