//! LaTeX that stays on the page.
//!
//! Purpose: long formulas in lines.
//! Method: a formula that is too wide is set as a display of broken lines; sums that stand inside products get letters
//! of their own and follow below. Widths are those of the symbols at ten points.
//! References: none needed.
//! Numerical aspects: none; text only.

use super::glyph::letter_of;
use super::latex::latex;
use super::text::{factors, fraction, is_sum, terms};
use crate::expression::Expr;
use crate::symbolic::print::sum::{Item, Measure, lines};
use std::fmt::Write;

/// Points in a line: A4 with margins of 2 cm has 482, less the left side.
const LINE: f64 = 400.0;
/// Points of a sum in brackets that is not taken apart.
const PART: f64 = 240.0;
/// Points of a sign and the blanks around it.
const SIGN: f64 = 13.0;

/// left = right, in one line where it fits.
pub fn set(left: &str, right: &Expr) -> String {
    let line = format!("{left} = {}", latex(right));
    if width(&line) <= LINE {
        return line;
    }
    let mut display = Display { letter: free_letter(right), named: Vec::new() };
    let whole = display.shortened(right);
    let mut text = format!("{{\\allowdisplaybreaks\n\\begin{{align*}}\n{}", equation(left, &whole));
    for (number, sum) in display.named.iter().enumerate() {
        let name = format!("{}_{{{}}}", display.letter, number + 1);
        let _ = write!(text, " \\\\\n{}", equation(&name, sum));
    }
    text + "\n\\end{align*}}"
}

/// Sums that were given letters.
struct Display {
    letter: &'static str,
    named: Vec<Expr>,
}

impl Display {
    /// The expression with a letter for every long sum inside it and, where it is still too wide, for both sides
    /// of its line.
    fn shortened(&mut self, expression: &Expr) -> Expr {
        if let Expr::Neg(positive) = expression {
            return -self.shortened(positive);
        }
        let inside = self.inside(expression);
        let (above, below) = fraction(&inside);
        if is_sum(&inside) || below.is_empty() || width(&latex(&inside)) <= LINE {
            return inside;
        }
        let product = |side: Vec<&Expr>| side.into_iter().cloned().reduce(|x, y| x * y);
        let sides = [product(above), product(below)].map(|side| side.unwrap_or(Expr::Number(1.0)));
        let [above, below] =
            sides.map(|side| if width(&latex(&side)) <= LINE { side } else { self.named(side) });
        above / below
    }

    /// Terms of a sum stay beside each other; a sum in a product, power or function is named if it is long.
    fn inside(&mut self, expression: &Expr) -> Expr {
        let sum = is_sum(expression);
        expression.map_children(&mut |child| {
            let inner = self.inside(child);
            if sum || !is_sum(&inner) || width(&latex(&inner)) <= PART { inner } else { self.named(inner) }
        })
    }

    fn named(&mut self, sum: Expr) -> Expr {
        let place = self.named.iter().position(|known| *known == sum).unwrap_or(self.named.len());
        if place == self.named.len() {
            self.named.push(sum);
        }
        Expr::name(format!("{}{}", self.letter, place + 1))
    }
}

/// A letter that no symbol of the expression has.
fn free_letter(expression: &Expr) -> &'static str {
    let names = expression.names();
    let taken = |letter: &str| names.iter().any(|name| letter_of(name) == letter);
    ["S", "Q", "R", "V", "W", "X", "Y", "Z"].into_iter().find(|letter| !taken(letter)).unwrap_or("SS")
}

/// One equation, broken before the signs of its sum or before the factors of its product.
fn equation(left: &str, right: &Expr) -> String {
    let measure = Measure { sign: SIGN, line: LINE };
    let sum = terms(right, false);
    let broken = if sum.len() > 1 || width(&latex(right)) <= LINE {
        let item = |(term, negative): &(Expr, bool)| {
            let text = latex(term);
            Item { negative: *negative, width: width(&text), text }
        };
        lines(&sum.iter().map(item).collect::<Vec<_>>(), &measure)
    } else {
        product_lines(right)
    };
    format!("{left} &= {}", broken.join(" \\\\\n&\\quad "))
}

fn product_lines(product: &Expr) -> Vec<String> {
    let (mut lines, mut used) = (vec![String::new()], 0.0);
    for factor in factors(product) {
        let text = if is_sum(factor) { format!(r"\left({}\right)", latex(factor)) } else { latex(factor) };
        let own = width(&text) + 4.0;
        if used > 0.0 && used + own > LINE {
            lines.push(String::from(r"\cdot"));
            used = SIGN;
        }
        used += own;
        if let Some(line) = lines.last_mut() {
            let _ = write!(line, " {text}");
        }
    }
    lines.iter().map(|line| line.trim().to_owned()).collect()
}

/// The width of LaTeX in print, in points.
fn width(text: &str) -> f64 {
    Reader { rest: text }.row()
}

struct Reader<'a> {
    rest: &'a str,
}

impl Reader<'_> {
    fn next(&mut self) -> Option<char> {
        let c = self.rest.chars().next()?;
        self.rest = &self.rest[c.len_utf8()..];
        Some(c)
    }

    /// Up to the end of a group or of the text.
    fn row(&mut self) -> f64 {
        let mut sum = 0.0;
        while let Some(c) = self.next() {
            sum += match c {
                '}' => break,
                '{' => self.row(),
                '^' | '_' => 0.75 * self.group(),
                '\\' => self.command(),
                '+' | '-' | '=' => SIGN,
                '(' | ')' | '|' | ',' => 4.5,
                ' ' => 0.0,
                '0'..='9' => 5.0,
                _ => 6.5,
            };
        }
        sum
    }

    /// What stands in braces, or one character.
    fn group(&mut self) -> f64 {
        match self.next() {
            Some('{') => self.row(),
            Some('\\') => self.command(),
            _ => 6.0,
        }
    }

    fn command(&mut self) -> f64 {
        let length = self.rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(self.rest.len());
        let (name, rest) = self.rest.split_at(length);
        self.rest = rest;
        match name {
            "" => self.next().map_or(0.0, |_| 5.0), // an escaped character
            "frac" => self.group().max(self.group()) + 3.0,
            "sqrt" => self.group() + 9.0,
            "left" | "right" | "mathit" | "operatorname" => 0.0,
            "cdot" => 8.0,
            "sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" | "exp" | "ln" | "min" | "max" | "arcsin"
            | "arccos" | "arctan" => 5.0 * name.len() as f64 + 3.0,
            _ => 7.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_formulas_stay_in_a_line_and_long_ones_are_broken() {
        let short = Expr::parse("a*(b + c)/(2*d)").unwrap();
        assert_eq!(set("I", &short), r"I = \frac{a \left(b + c\right)}{2 d}");
        let sum = |name: &str| (0..40).map(|k| format!("{name}{k}*x^2")).collect::<Vec<_>>().join(" + ");
        let long = Expr::parse(&format!("({})^2*k/({})", sum("S"), sum("b"))).unwrap();
        let text = set("I", &long);
        assert!(text.contains("I &= \\frac{Q_{1}^{2} k}{Q_{2}} \\\\\nQ_{1} &= S_{0} x^{2}"), "{text}");
        let widest = text.lines().map(width).fold(0.0, f64::max);
        assert!(widest < LINE + 30.0, "{widest}");
        let product = (0..90).map(|k| format!("a{k}")).collect::<Vec<_>>().join("*");
        let text = set("I", &Expr::parse(&format!("1/({product})")).unwrap());
        assert!(text.contains("\\quad \\cdot a_{"), "{text}");
    }
}
