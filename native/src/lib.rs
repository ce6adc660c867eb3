//! # Purpose
//! Steps of the explicit Runge-Kutta methods, with the rates of a model given as register code, as machine code.
//!
//! # Method
//! The code of the rates is straight: no jumps, one instruction a register. A whole step is one function or two, in
//! which the rates stand as often as the method asks for them, so that what passes between stages stays in the
//! processor's registers. Steps with nothing to look at between them are taken in one loop ([`March`]). Where a caller
//! has to look between (switches that slide, delays, implicit methods), rates, motions and slopes are functions of their
//! own. Numbers carry tangents ([`Dual`]); an instruction on a register without tangents costs none.
//!
//! # References
//! E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, section II.1.
//!
//! # Numerical aspects
//! The operations are those of an interpreter, in its order, without contraction, and functions are called, not copied:
//! values agree bit for bit, tangents but for the sign of a zero (and where a value is infinite).
//! This is the one package of the project with unsafe code. Why each block is sound stands above it.

#[cfg(feature = "jit")]
mod body;
mod code;
#[cfg(feature = "jit")]
mod lower;
#[cfg(feature = "jit")]
mod march;
mod number;
#[cfg(feature = "jit")]
mod round;
#[cfg_attr(feature = "jit", path = "steps.rs")]
#[cfg_attr(not(feature = "jit"), path = "none.rs")]
mod steps;
#[cfg(feature = "jit")]
mod unit;

pub use code::{
    Action, BEGIN, Care, JUMP, LISTS, MarchCode, Mark, Method, Op, Register, StepCode, Switch, TOO_LARGE,
    spread,
};
#[cfg(feature = "jit")]
pub use march::March;
pub use number::{Dual, Number};
#[cfg(not(feature = "jit"))]
pub use steps::March;
pub use steps::Steps;
