//! The functions of the language, in one table.

use super::foreign::{self, Foreign};

/// A function of the expression language.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Function {
    /// sin(x), x in rad
    Sin,
    /// cos(x), x in rad
    Cos,
    /// tan(x), x in rad
    Tan,
    /// asin(x)
    Asin,
    /// acos(x)
    Acos,
    /// atan(x)
    Atan,
    /// atan2(y, x), both of one unit
    Atan2,
    /// sinh(x)
    Sinh,
    /// cosh(x)
    Cosh,
    /// tanh(x)
    Tanh,
    /// exp(x)
    Exp,
    /// ln(x)
    Ln,
    /// sqrt(x)
    Sqrt,
    /// abs(x)
    Abs,
    /// sign(x): −1, 0 or 1; held between −1 and 1 while its argument is stuck at 0
    Sign,
    /// min(a, b)
    Min,
    /// max(a, b)
    Max,
    /// step(x): 0 for x < 0, 1 from x = 0 on
    Step,
    /// clamp(x, lo, hi)
    Clamp,
    /// delay(x, T): x as it was T seconds ago; its first value before the start
    Delay,
    /// lag(x, T): first-order lag, T·ẏ = x − y, steady at the start
    Lag,
    /// backlash(x, gap): play of full width gap; y moves only when x pushes it, centred at the start
    Backlash,
    /// hysteresis(x, gap): x − backlash(x, gap), the elastic-plastic element; within ±gap/2
    Hysteresis,
    /// relay(x, gap): +1 after x rose over gap/2, −1 after it fell under −gap/2
    Relay,
    /// rate_limit(x, r): follows x with |ẏ| ≤ r
    RateLimit,
    /// curve(x, x1, y1, x2, y2, …): the monotone cubic through its knots, straight beyond them
    Curve,
    /// surface(x, y, [x1, …], [y1, …], [z11, z12, …]): bilinear between its knots and straight beyond them; so many x and
    /// y, and a z for each y at the first x, then at the next
    Surface(u16, u16),
    /// A result that other people's code computes from all its arguments
    Foreign(Foreign),
}

/// Every function with its name and its number of arguments, or the least.
const TABLE: [(Function, &str, usize); 27] = [
    (Function::Sin, "sin", 1),
    (Function::Cos, "cos", 1),
    (Function::Tan, "tan", 1),
    (Function::Asin, "asin", 1),
    (Function::Acos, "acos", 1),
    (Function::Atan, "atan", 1),
    (Function::Atan2, "atan2", 2),
    (Function::Sinh, "sinh", 1),
    (Function::Cosh, "cosh", 1),
    (Function::Tanh, "tanh", 1),
    (Function::Exp, "exp", 1),
    (Function::Ln, "ln", 1),
    (Function::Sqrt, "sqrt", 1),
    (Function::Abs, "abs", 1),
    (Function::Sign, "sign", 1),
    (Function::Min, "min", 2),
    (Function::Max, "max", 2),
    (Function::Step, "step", 1),
    (Function::Clamp, "clamp", 3),
    (Function::Delay, "delay", 2),
    (Function::Lag, "lag", 2),
    (Function::Backlash, "backlash", 2),
    (Function::Hysteresis, "hysteresis", 2),
    (Function::Relay, "relay", 2),
    (Function::RateLimit, "rate_limit", 2),
    (Function::Curve, "curve", 5),
    (Function::Surface(2, 2), "surface", 10),
];

impl Function {
    /// Every function of the language.
    pub fn all() -> impl Iterator<Item = Self> {
        TABLE.iter().map(|row| row.0)
    }

    /// The function of that name.
    pub fn named(name: &str) -> Option<Self> {
        TABLE.iter().find(|row| row.1 == name).map(|row| row.0)
    }

    /// The name as written in an expression.
    pub fn name(self) -> &'static str {
        match self {
            Self::Foreign(_) => foreign::NAME,
            Self::Surface(..) => "surface",
            _ => TABLE.iter().find(|row| row.0 == self).map_or("", |row| row.1),
        }
    }

    /// Whether it can be called with so many arguments.
    pub fn takes(self, count: usize) -> bool {
        match self {
            Self::Curve => count >= self.arity() && count % 2 == 1,
            Self::Foreign(f) => count == f.arity(),
            _ => count == self.arity(),
        }
    }

    /// The number of arguments; of a curve the least.
    pub fn arity(self) -> usize {
        match self {
            Self::Surface(n, m) => {
                let (n, m) = (usize::from(n), usize::from(m));
                2 + n + m + n * m
            }
            _ => TABLE.iter().find(|row| row.0 == self).map_or(1, |row| row.2),
        }
    }

    /// How it is called, for messages: `clamp(x, lo, hi)`.
    pub fn usage(self) -> &'static str {
        match self {
            Self::Atan2 => "atan2(y, x)",
            Self::Min => "min(a, b)",
            Self::Max => "max(a, b)",
            Self::Clamp => "clamp(x, lo, hi)",
            Self::Delay => "delay(x, T)",
            Self::Lag => "lag(x, T)",
            Self::Backlash => "backlash(x, gap)",
            Self::Hysteresis => "hysteresis(x, gap)",
            Self::Relay => "relay(x, gap)",
            Self::RateLimit => "rate_limit(x, rate)",
            Self::Curve => "curve(x, x1, y1, x2, y2, …)",
            Self::Surface(..) => "surface(x, y, [x1, …], [y1, …], [z11, z12, …])",
            _ => self.name(),
        }
    }

    /// The value of a function without memory; of one with memory the value when at rest.
    #[inline(always)] // a known function then costs what it computes
    pub fn of(self, x: &[f64]) -> f64 {
        let a = x.first().copied().unwrap_or(f64::NAN);
        let b = x.get(1).copied().unwrap_or(f64::NAN);
        match self {
            Self::Sin => a.sin(),
            Self::Cos => a.cos(),
            Self::Tan => a.tan(),
            Self::Asin => a.asin(),
            Self::Acos => a.acos(),
            Self::Atan => a.atan(),
            Self::Atan2 => a.atan2(b),
            Self::Sinh => a.sinh(),
            Self::Cosh => a.cosh(),
            Self::Tanh => a.tanh(),
            Self::Exp => a.exp(),
            Self::Ln => a.ln(),
            Self::Sqrt => a.sqrt(),
            Self::Abs => a.abs(),
            Self::Sign => f64::from(i8::from(a > 0.0) - i8::from(a < 0.0)),
            Self::Min => a.min(b),
            Self::Max => a.max(b),
            Self::Step => f64::from(u8::from(a >= 0.0)),
            Self::Clamp => a.max(b).min(x.get(2).copied().unwrap_or(f64::NAN)),
            Self::Delay | Self::Lag | Self::Backlash | Self::RateLimit => a,
            Self::Hysteresis => 0.0,
            Self::Foreign(f) => f.compute().map_or(f64::NAN, |c| c.value(x, usize::from(f.result))),
            Self::Curve => super::curve::curve(a, x.get(1..).unwrap_or_default()),
            Self::Surface(n, _) => {
                super::surface::surface([a, b], usize::from(n), x.get(2..).unwrap_or_default())
            }
            Self::Relay => f64::from(i8::from(a > b / 2.0) - i8::from(a < -b / 2.0)),
        }
    }

    /// Whether it is computed by a state or a held value of its own.
    #[cfg(feature = "diagnose")]
    pub(crate) fn keeps_state(self) -> bool {
        matches!(self, Self::Lag | Self::Backlash | Self::Hysteresis | Self::RateLimit)
    }

    /// Whether its value, or that of its slope, jumps somewhere.
    pub fn has_corners(self) -> bool {
        let jumps = matches!(self, Self::Sign | Self::Min | Self::Max | Self::Step | Self::Clamp);
        jumps || self.has_memory() && !matches!(self, Self::Delay | Self::Lag)
    }

    /// Whether its value depends on the past of its first argument.
    pub fn has_memory(self) -> bool {
        matches!(
            self,
            Self::Delay | Self::Lag | Self::Backlash | Self::Hysteresis | Self::Relay | Self::RateLimit
        )
    }
}
