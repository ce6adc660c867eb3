//! The expression language of models and formulas: parse, print, check dimensions.
//!
//! Operators `+ - * / ^` (`^` to the right and tighter than the sign), parentheses, numbers,
//! names, `pi`, `t`, and functions:
//!
//! | function | is |
//! |---|---|
//! | `sin cos tan asin acos atan sinh cosh tanh exp ln` | of a pure number or an angle in rad |
//! | `atan2(y, x)` | the angle of the point (x, y) |
//! | `sqrt(x)`, `abs(x)` | √x, \|x\| |
//! | `sign(x)` | −1, 0, 1; in a state's rate a true stick: between −1 and 1 while x is held at 0 |
//! | `step(x)` | 0 for x < 0, else 1 |
//! | `min(a, b)`, `max(a, b)`, `clamp(x, lo, hi)` | the smaller, the larger, x within bounds |
//! | `delay(x, T)` | x as it was T seconds ago (of an input also ahead, for T < 0); its first value before |
//! | `lag(x, T)` | y of T·ẏ = x − y, y = x at the start |
//! | `backlash(x, gap)` | play: y moves only when x pushes it at ±gap/2; y = x at the start |
//! | `hysteresis(x, gap)` | x − backlash(x, gap): the elastic-plastic element, within ±gap/2 |
//! | `relay(x, gap)` | 1 after x rose over gap/2, −1 after it fell under −gap/2 |
//! | `rate_limit(x, rate)` | follows x with \|ẏ\| ≤ rate |
//! | `curve(x, x1, y1, x2, y2, …)` | the monotone cubic through its knots, straight beyond them |
//!
//! ```
//! use gyrospec::expression::Expr;
//! let e = Expr::parse("-P^2*sin(2*heading) + drive")?;
//! assert_eq!(e.to_string(), "-P^2*sin(2*heading) + drive");
//! assert!(e.names().contains("heading"));
//! # Ok::<(), gyrospec::Error>(())
//! ```

mod angle;
mod curve;
mod dimension;
// without units from elsewhere nothing is asked of it
#[cfg_attr(not(feature = "fmu"), allow(dead_code))]
pub(crate) mod foreign;
mod function;
mod parse;
mod print;
mod surface;
mod tree;
mod turning;
mod walk;

pub use angle::Angles;
#[cfg(feature = "diagnose")]
pub(crate) use angle::turns;
pub use dimension::Scope;
pub use foreign::Foreign;
pub use function::Function;
pub use tree::{BinaryOp, Expr};
pub use turning::Units;
pub use walk::is_name;

#[cfg(test)]
mod tests;
