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

impl BinaryOp {
    /// a ∘ b
    pub fn of(self, a: f64, b: f64) -> f64 {
        match self {
            Self::Add => a + b,
            Self::Sub => a - b,
            Self::Mul => a * b,
            Self::Div => a / b,
            Self::Pow => a.powf(b),
        }
    }
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

impl Expr {
    /// A number; a negative one becomes the negation of a positive one, as the parser has it.
    pub fn number(value: f64) -> Self {
        if value.is_sign_negative() { Self::Neg(Box::new(Self::Number(-value))) } else { Self::Number(value) }
    }

    /// A name.
    pub fn name(name: impl Into<String>) -> Self {
        Self::Name(name.into())
    }

    /// f(arguments)
    pub fn call(function: Function, arguments: impl IntoIterator<Item = Self>) -> Self {
        Self::Call(function, arguments.into_iter().collect())
    }

    /// self^exponent
    #[must_use]
    pub fn pow(self, exponent: f64) -> Self {
        binary(BinaryOp::Pow, self, Self::number(exponent))
    }
}

fn binary(op: BinaryOp, a: Expr, b: Expr) -> Expr {
    Expr::Binary(op, Box::new(a), Box::new(b))
}

impl std::ops::Add for Expr {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        binary(BinaryOp::Add, self, other)
    }
}

impl std::ops::Sub for Expr {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        binary(BinaryOp::Sub, self, other)
    }
}

impl std::ops::Mul for Expr {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        binary(BinaryOp::Mul, self, other)
    }
}

impl std::ops::Div for Expr {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        binary(BinaryOp::Div, self, other)
    }
}

impl std::ops::Neg for Expr {
    type Output = Self;
    fn neg(self) -> Self {
        Self::Neg(Box::new(self))
    }
}
