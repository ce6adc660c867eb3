//! Tables as functions in Rust, Python and C, each with its shared minors.

use super::sum::{Item, Measure, lines};
use crate::symbolic::minors::{Letter, Product, Program};
use std::fmt::Write;

/// A language that the tables are written in.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Language {
    Rust,
    Python,
    C,
}

const WIDTH: Measure = Measure { sign: 3.0, line: 84.0 };

/// One function an order.
pub fn tables(programs: &[Program], language: Language) -> String {
    let mut text = language.head();
    for program in programs {
        text.push('\n');
        text.push_str(&function(program, language));
    }
    text
}

impl Language {
    fn head(self) -> String {
        let says = [
            "I_n = (1/2 pi) integral of G(jw) / (H(jw) H(-jw)) dw over all w,",
            "H(s) = a0 s^n + a1 s^(n-1) + ... + an with all roots in the left half plane,",
            "G(s) = b0 s^(2n-2) + b1 s^(2n-4) + ... + b(n-1).",
            "The ratio of the published determinants, in shared minors; written by `gyrospec table`.",
        ];
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
        if self == Self::C {
            text.push_str(" */\n");
        }
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

    fn assigned(self, name: &str, sum: &[String]) -> String {
        let (before, after) = match self {
            Self::Rust => ("let ", ";"),
            Self::Python => ("", ""),
            Self::C => ("const double ", ";"),
        };
        let broken = self == Self::Python && sum.len() > 1;
        let (open, close) = if broken { ("(", ")") } else { ("", "") };
        format!("    {before}{name} = {open}{}{close}{after}\n", sum.join("\n        "))
    }

    fn closing(self) -> &'static str {
        match self {
            Self::Rust => "    numerator / (2.0 * a[0] * determinant)\n}\n",
            Self::Python => "    return numerator / (2.0 * a[0] * determinant)\n",
            Self::C => "    return numerator / (2.0 * a[0] * determinant);\n}\n",
        }
    }
}

fn function(program: &Program, language: Language) -> String {
    let mut text = language.opening(program.order);
    for (number, sum) in program.minors.iter().enumerate() {
        text.push_str(&language.assigned(&format!("m{number}"), &broken(sum)));
    }
    text.push_str(&language.assigned("determinant", &broken(&program.determinant)));
    text.push_str(&language.assigned("numerator", &broken(&program.numerator)));
    text.push_str(language.closing());
    text
}

fn broken(sum: &[Product]) -> Vec<String> {
    let items: Vec<Item> =
        sum.iter().map(|product| Item::plain(product.negative, factors(product))).collect();
    lines(&items, &WIDTH)
}

fn factors(product: &Product) -> String {
    let letters = product.letters.iter().map(|letter| match letter {
        Letter::A(k) => format!("a[{k}]"),
        Letter::B(k) => format!("b[{k}]"),
    });
    letters.chain(product.minor.map(|k| format!("m{k}"))).collect::<Vec<_>>().join(" * ")
}
