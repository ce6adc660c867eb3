//! Tables as functions in Rust, Python and C.

use super::recursion::Recursion;
use super::{Exporter, programs};
use crate::Result;
use std::fmt::Write;
use std::ops::RangeInclusive;

/// A language that the tables are written in.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Language {
    Rust,
    Python,
    C,
}

/// Conditions in one line of code.
const CONDITIONS: usize = 7;

/// One function an order.
impl Exporter for Language {
    fn name(&self) -> &'static str {
        match self {
            Self::Rust => "rust",
            Self::Python => "python",
            Self::C => "c",
        }
    }

    fn print(&self, orders: RangeInclusive<usize>) -> Result<String> {
        programs(orders.clone())?;
        let mut text = self.head();
        for n in orders {
            text.push('\n');
            text.push_str(&function(n, *self));
        }
        Ok(text)
    }
}

/// What most languages give for an H that is not stable.
pub(super) const UNSTABLE: &str = "Where H is not stable: not a number.";

/// What stands above the functions, line by line.
pub(super) fn preface(where_unstable: &str) -> [&str; 9] {
    [
        "I_n = (1/2 pi) integral of G(jw) / (H(jw) H(-jw)) dw over all w,",
        "H(s) = a0 s^n + a1 s^(n-1) + ... + an with all roots in the left half plane,",
        "G(s) = b0 s^(2n-2) + b1 s^(2n-4) + ... + b(n-1).",
        "The ratio of the published determinants, by Routh's rows.",
        where_unstable,
        "Relative error measured at 2000 random points an order, damping ratios from 0.2, terms of G of",
        "one sign: at most 4e-15 up to order 10 and 2e-14 up to order 14. Elsewhere it grows with the",
        "condition of the integral; `gyrospec integral` gives all digits and a bound for any H and G.",
        "Written by `gyrospec table`.",
    ]
}

impl Language {
    fn head(self) -> String {
        let says = preface(match self {
            Self::Python => "Where H is not stable: not a number, or ZeroDivisionError.",
            _ => UNSTABLE,
        });
        let mark = match self {
            Self::Rust => "//",
            Self::Python => "#",
            Self::C => " *",
        };
        let mut text = String::new();
        for (place, line) in says.iter().enumerate() {
            let mark = if self == Self::C && place == 0 { "/*" } else { mark };
            let _ = writeln!(text, "{mark} {line}");
        }
        text.push_str(match self {
            Self::Rust => "",
            Self::Python => "import math\n\n",
            Self::C => " */\n#include <math.h>\n",
        });
        text
    }

    fn opening(self, n: usize) -> String {
        match self {
            Self::Rust => format!(
                "/// I_{n} from a0 ... a{n} and b0 ... b{}.\npub fn i{n}(a: &[f64; {}], b: &[f64; {n}]) -> f64 {{\n",
                n - 1,
                n + 1
            ),
            Self::Python => {
                format!("def i{n}(a, b):\n    \"\"\"I_{n} from a0 ... a{n} and b0 ... b{}.\"\"\"\n", n - 1)
            }
            Self::C => format!("double gyrospec_i{n}(const double a[{}], const double b[{n}])\n{{\n", n + 1),
        }
    }

    fn assigned(self, name: &str, value: &str) -> String {
        match self {
            Self::Rust => format!("    let {name} = {value};\n"),
            Self::Python => format!("    {name} = {value}\n"),
            Self::C => format!("    const double {name} = {value};\n"),
        }
    }

    /// The value, or not a number where a multiplier is not above 0.
    fn closing(self, recursion: &Recursion) -> String {
        let Recursion { multipliers, value, .. } = recursion;
        let (and, indent) = match self {
            Self::Python => ("and", "            "),
            _ => ("&&", "        "),
        };
        let lines: Vec<String> = multipliers
            .chunks(CONDITIONS)
            .map(|some| {
                some.iter().map(|q| format!("{q} > 0.0")).collect::<Vec<_>>().join(&format!(" {and} "))
            })
            .collect();
        let stable = lines.join(&format!("\n{indent}{and} "));
        match self {
            Self::Rust => {
                format!("    let stable = {stable};\n    if stable {{ {value} }} else {{ f64::NAN }}\n}}\n")
            }
            Self::Python => {
                format!("    stable = ({stable})\n    return {value} if stable else math.nan\n")
            }
            Self::C => format!("    const int stable = {stable};\n    return stable ? {value} : NAN;\n}}\n"),
        }
    }
}

fn function(n: usize, language: Language) -> String {
    let (mut text, recursion) = (language.opening(n), Recursion::new(n));
    for (name, value) in &recursion.steps {
        text.push_str(&language.assigned(name, value));
    }
    text.push_str(&language.closing(&recursion));
    text
}
