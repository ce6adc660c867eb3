//! The expression language of models and formulas: parse, print, check dimensions.

mod function;
mod tree;

pub use function::Function;
pub use tree::{BinaryOp, Expr};
