//! The functions that machine code calls, with their slopes.

use crate::expression::Function;
use crate::model::Scalar;
use crate::model::program::{slope, whole_power_parts};
use gyrospec_native::Action;

/// aᵇ
pub fn power() -> Action {
    Action::Two(value_of_power, power_by_base, power_by_exponent)
}

/// The angle of (x, y).
pub fn atan2() -> Action {
    Action::Two(angle, atan2_by_y, atan2_by_x)
}

/// A whole power.
pub fn whole() -> Action {
    Action::Whole(value_of_whole, whole_slope)
}

extern "C" fn value_of_power(a: f64, b: f64) -> f64 {
    a.power(b)
}

/// ∂aᵇ/∂a
extern "C" fn power_by_base(a: f64, b: f64) -> f64 {
    crate::model::power_slopes(a, b).0
}

/// ∂aᵇ/∂b
extern "C" fn power_by_exponent(a: f64, b: f64) -> f64 {
    crate::model::power_slopes(a, b).1
}

extern "C" fn angle(y: f64, x: f64) -> f64 {
    y.atan2(x)
}

extern "C" fn atan2_by_y(y: f64, x: f64) -> f64 {
    x / (y * y + x * x)
}

extern "C" fn atan2_by_x(y: f64, x: f64) -> f64 {
    -y / (y * y + x * x)
}

extern "C" fn value_of_whole(x: f64, n: i32) -> f64 {
    whole_power_parts(x, n).0
}

extern "C" fn whole_slope(x: f64, n: i32) -> f64 {
    whole_power_parts(x, n).1
}

/// Functions of one argument with their slopes.
macro_rules! functions {
    ($($name:ident),*) => {
        /// A function of one argument, where it has a slope of its own.
        pub fn one(f: Function) -> Option<Action> {
            match f {
                $(Function::$name => {
                    extern "C" fn value(x: f64) -> f64 {
                        Function::$name.of(&[x])
                    }
                    extern "C" fn by(x: f64, y: f64) -> f64 {
                        slope(Function::$name, x, y)
                    }
                    Some(Action::One(value, by))
                })*
                _ => None,
            }
        }
    };
}

functions!(Sin, Cos, Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh, Exp, Ln, Abs);
