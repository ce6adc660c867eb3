//! The expression language of models and formulas: parse, print, check dimensions.
//!
//! ```
//! use gyrospec::expression::Expr;
//! let e = Expr::parse("-P^2*sin(2*heading) + drive")?;
//! assert_eq!(e.to_string(), "-P^2*sin(2*heading) + drive");
//! assert!(e.names().contains("heading"));
//! # Ok::<(), gyrospec::Error>(())
//! ```

mod dimension;
mod function;
mod parse;
mod print;
mod tree;
mod walk;

pub use dimension::Scope;
pub use function::Function;
pub use tree::{BinaryOp, Expr};
pub use walk::is_name;

#[cfg(test)]
mod tests;
