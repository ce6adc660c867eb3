//! Tables for people: Markdown and LaTeX.
//!
//! Purpose: I_n on a page; up to order 8 expanded, above that as shared minors.
//! Method: the numerator is grouped by the coefficients of G, common letters stand before the bracket; lines are
//! broken by the width that their symbols take in print.
//! References: none needed.
//! Numerical aspects: none; text only.

use super::sum::{Item, Measure, lines};
use super::{Exporter, HIGHEST_EXPANDED, programs};
use crate::Result;
use crate::symbolic::integer::Integer;
use crate::symbolic::minors::{Letter, Product, Program};
use crate::symbolic::polynomial::Polynomial;
use crate::symbolic::ring::{Monomial, Ring};
use crate::symbolic::table::Table;
use std::fmt::Write;
use std::ops::RangeInclusive;

/// Markdown or LaTeX.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Style {
    Markdown,
    Latex,
}

/// All orders in one document.
impl Exporter for Style {
    fn name(&self) -> &'static str {
        match self {
            Self::Markdown => "markdown",
            Self::Latex => "latex",
        }
    }

    fn print(&self, orders: RangeInclusive<usize>) -> Result<String> {
        let mut text = self.head();
        for program in &programs(orders)? {
            let equations = if program.order <= HIGHEST_EXPANDED {
                expanded(program, *self)?
            } else {
                shared(program, *self)
            };
            text.push_str(&self.section(program.order, &equations));
        }
        if *self == Self::Latex {
            text.push_str("\\end{document}\n");
        }
        Ok(text)
    }
}

/// An equation: its left side and the lines of its right side.
struct Equation(String, Vec<String>);

impl Style {
    fn head(self) -> String {
        match self {
            Self::Markdown => "# Tables of I_n\n\n\
                I_n = (1/2π) ∫ G(jω) / (H(jω) H(−jω)) dω over all ω = N / D, for\n\
                H(s) = a0 s^n + a1 s^(n−1) + … + an, all roots in the left half plane, and\n\
                G(s) = b0 s^(2n−2) + b1 s^(2n−4) + … + b(n−1).\n\
                No common factor of N and D is left. Written by `gyrospec table --format markdown`.\n"
                .into(),
            Self::Latex => "\\documentclass[a4paper,10pt]{article}\n\
                \\usepackage{amsmath}\n\\usepackage[margin=2cm]{geometry}\n\
                \\allowdisplaybreaks\n\\begin{document}\n\
                \\noindent $\\displaystyle I_n = \\frac{1}{2\\pi}\\int_{-\\infty}^{\\infty}\
                \\frac{G(j\\omega)}{H(j\\omega)\\,H(-j\\omega)}\\,d\\omega = \\frac{N_n}{D_n}$ for\n\
                $H(s) = a_0 s^n + a_1 s^{n-1} + \\dots + a_n$, all roots in the left half plane, and\n\
                $G(s) = b_0 s^{2n-2} + b_1 s^{2n-4} + \\dots + b_{n-1}$;\n\
                no common factor of $N_n$ and $D_n$ is left.\n"
                .into(),
        }
    }

    fn section(self, order: usize, equations: &[Equation]) -> String {
        let mut text = String::new();
        match self {
            Self::Markdown => {
                let _ = write!(text, "\n## I_{order}\n\n```text\n");
                for Equation(left, right) in equations {
                    let indent = " ".repeat(left.chars().count() + 3);
                    let _ = writeln!(text, "{left} = {}", right.join(&format!("\n{indent}")));
                }
                text.push_str("```\n");
            }
            Self::Latex => {
                let _ = writeln!(text, "\\section*{{$I_{{{order}}}$}}\n\\begin{{align*}}");
                let equations: Vec<String> = equations
                    .iter()
                    .map(|Equation(left, right)| format!("{left} &= {}", right.join(" \\\\\n&\\quad ")))
                    .collect();
                let _ = writeln!(text, "{}\n\\end{{align*}}", equations.join(" \\\\\n"));
            }
        }
        text
    }

    /// LaTeX in points: 482 on the page, less the left side and the indent.
    fn measure(self) -> Measure {
        match self {
            Self::Markdown => Measure { sign: 3.0, line: 96.0 },
            Self::Latex => Measure { sign: 13.0, line: 405.0 },
        }
    }

    fn named(self, name: &str, order: usize) -> String {
        match self {
            Self::Markdown => name.into(),
            Self::Latex => format!("{name}_{{{order}}}"),
        }
    }

    fn letter(self, name: char, index: usize, exponent: u32) -> String {
        match (self, exponent) {
            (Self::Markdown, 1) => format!("{name}{index}"),
            (Self::Markdown, _) => format!("{name}{index}^{exponent}"),
            (Self::Latex, 1) => format!("{name}_{{{index}}}"),
            (Self::Latex, _) => format!("{name}_{{{index}}}^{{{exponent}}}"),
        }
    }

    /// Letters beside each other; in points a letter takes 6 and a digit of its index 4.5.
    fn item(self, negative: bool, symbols: &[String]) -> Item {
        let text = symbols.join(" ");
        match self {
            Self::Markdown => Item::plain(negative, text),
            Self::Latex => {
                let width = |symbol: &String| match symbol.split_once('_') {
                    Some((_, index)) => 6.0 + 4.5 * index.split('^').next().map_or(0, |i| i.len() - 2) as f64,
                    None => 5.0 * symbol.len() as f64,
                };
                Item { negative, width: symbols.iter().map(width).sum(), text }
            }
        }
    }
}

fn expanded(program: &Program, style: Style) -> Result<Vec<Equation>> {
    let (table, n) = (Table::expand(program)?, program.order);
    let mut numerator = Vec::new();
    for k in 0..n {
        let part = table.numerator.coefficients(n + 1 + k)?.swap_remove(1);
        let lead = table.numerator.ring().power(n + 1 + k, 1)?;
        numerator.extend(bracketed(&part, lead, k == 0, style)?);
    }
    let denominator = bracketed(&table.denominator, Monomial::ONE, true, style)?;
    Ok(vec![Equation(style.named("N", n), numerator), Equation(style.named("D", n), denominator)])
}

/// A polynomial times a lead, in lines: what all its terms share stands before the bracket.
fn bracketed(part: &Polynomial, lead: Monomial, first: bool, style: Style) -> Result<Vec<String>> {
    let ring = part.ring();
    let common = part.common_monomial();
    let (content, reversed) = readable_sign(part);
    let unit = Polynomial::term(ring, common, content.clone());
    let inside = part.divided_by(&unit)?.expect("the content divides");
    let before = item(ring, ring.product(lead, common)?, &content, style);
    let sign = match (content.is_negative(), first) {
        (true, true) => "-",
        (false, true) => "",
        (true, false) => "- ",
        (false, false) => "+ ",
    };
    if inside.as_constant().is_some() {
        return Ok(vec![format!("{sign}{}", before.text)]);
    }
    let mut items: Vec<Item> = inside.terms().iter().map(|(m, c)| item(ring, *m, c, style)).collect();
    if reversed {
        items.reverse();
    }
    let mut measure = style.measure();
    measure.line -= before.width + measure.sign;
    let mut broken = lines(&items, &measure);
    broken[0] = format!("{sign}{} ({}", before.text, broken[0]);
    broken.last_mut().expect("a sum has a line").push(')');
    Ok(broken)
}

/// The content with the sign under which a bracket begins with plus, and whether its terms stand in reverse for that.
fn readable_sign(part: &Polynomial) -> (Integer, bool) {
    let content = part.content();
    let ends_positive = part.terms().last().is_some_and(|(_, c)| !c.is_negative());
    if content.is_negative() && ends_positive { (-&content, true) } else { (content, false) }
}

fn item(ring: &Ring, monomial: Monomial, coefficient: &Integer, style: Style) -> Item {
    let mut symbols = Vec::new();
    let size = coefficient.magnitude();
    if size != Integer::ONE || monomial == Monomial::ONE {
        symbols.push(size.to_string());
    }
    let half = ring.names().len() / 2 + 1; // a0 … an come before b0 … b(n−1)
    let (a, b): (Vec<_>, Vec<_>) = ring.powers(monomial).partition(|(symbol, _)| *symbol < half);
    symbols.extend(b.into_iter().map(|(symbol, e)| style.letter('b', symbol - half, e)));
    symbols.extend(a.into_iter().map(|(symbol, e)| style.letter('a', symbol, e)));
    style.item(coefficient.is_negative(), &symbols)
}

fn shared(program: &Program, style: Style) -> Vec<Equation> {
    let broken =
        |sum: &[Product]| lines(&sum.iter().map(|p| factors(p, style)).collect::<Vec<_>>(), &style.measure());
    let mut equations: Vec<Equation> = program
        .minors
        .iter()
        .enumerate()
        .map(|(number, sum)| Equation(style.letter('m', number, 1), broken(sum)))
        .collect();
    equations.push(Equation(style.named("N", program.order), broken(&program.numerator)));
    let mut below = broken(&program.determinant);
    below[0] = format!("2 {} ({}", style.letter('a', 0, 1), below[0]);
    below.last_mut().expect("a sum has a line").push(')');
    equations.push(Equation(style.named("D", program.order), below));
    equations
}

fn factors(product: &Product, style: Style) -> Item {
    let letters = product.letters.iter().map(|letter| match *letter {
        Letter::A(k) => style.letter('a', k, 1),
        Letter::B(k) => style.letter('b', k, 1),
    });
    let symbols: Vec<String> = letters.chain(product.minor.map(|k| style.letter('m', k, 1))).collect();
    style.item(product.negative, &symbols)
}
