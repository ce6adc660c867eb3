//! LaTeX: the equations, and a list of what stands in them.

use super::runner;
use super::spell::{Binding, whole};
use crate::expression::{BinaryOp, Expr, Function};
use crate::model::{Initial, Model};
use crate::text::one_line;
use crate::units::{Unit, significant};
use std::fmt::Write;

/// Functions that mathematics has no sign for: their name, and what it means.
const OWN: [(Function, &str, &str); 7] = [
    (Function::Step, "step", "$\\operatorname{step}(x)$ is 0 for $x < 0$, else 1"),
    (
        Function::Lag,
        "lag",
        "$y = \\operatorname{lag}(x, T)$ has $T\\,\\dot{y} = x - y$ and is steady at the start",
    ),
    (
        Function::Backlash,
        "play",
        "$\\operatorname{play}(x, g)$ moves only when $x$ pushes it, at half the gap $g$",
    ),
    (Function::Hysteresis, "hyst", "$\\operatorname{hyst}(x, g)$ is $x$ without a play of the gap $g$"),
    (
        Function::Relay,
        "relay",
        "$\\operatorname{relay}(x, g)$ is 1 after $x$ rose over $g/2$, and $-1$ after it fell under $-g/2$",
    ),
    (Function::RateLimit, "limit", "$\\operatorname{limit}(x, r)$ follows $x$ no faster than $r$"),
    (
        Function::Curve,
        "curve",
        "$\\operatorname{curve}(x, x_1, y_1, x_2, y_2, \\dots)$ is the monotone cubic through its knots, straight beyond them",
    ),
];
const SURFACE: &str = "$\\operatorname{surface}(x, y, \\dots)$ is bilinear between its knots, places along $x$, along $y$ \
    and a value for each $y$ at the first $x$, then at the next; it is straight beyond them";
/// The letters whose names are commands.
const GREEK: [&str; 24] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu",
    "nu", "xi", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega", "varphi",
];

/// The model as a document of LaTeX.
pub(super) fn text(model: &Model) -> String {
    let mut out = String::from(
        "\\documentclass{article}\n\\usepackage[T1]{fontenc}\n\\usepackage{amsmath,longtable}\n",
    );
    let _ = writeln!(out, "\\begin{{document}}\n\\section*{{{}}}", plain(&model.name));
    let mut lines: Vec<String> =
        model.definitions.iter().map(|d| equation(&symbol(&d.name), &d.equals)).collect();
    lines.extend(model.states.iter().map(|s| equation(&format!("\\dot{{{}}}", symbol(&s.name)), &s.rate)));
    lines.extend(model.outputs.iter().map(|o| equation(&symbol(&o.name), &o.equals)));
    if !lines.is_empty() {
        let _ = writeln!(out, "\\begin{{align*}}\n{}\n\\end{{align*}}", lines.join(" \\\\\n"));
    }
    let meanings = meanings(model);
    if !meanings.is_empty() {
        let _ = writeln!(out, "Here {}.\n", meanings.join("; "));
    }
    listed(model, &mut out);
    out.push_str("\\end{document}\n");
    out
}

fn equation(left: &str, right: &Expr) -> String {
    format!("{left} &= {}", spell(right))
}

/// What the functions mean that a reader may not know.
fn meanings(model: &Model) -> Vec<&'static str> {
    let own = OWN.iter().filter(|(f, ..)| runner::calls(model, &|other| other == *f)).map(|o| o.2);
    let surface = runner::calls(model, &|f| matches!(f, Function::Surface(..))).then_some(SURFACE);
    own.chain(surface).collect()
}

/// Every name: its value or its start, unit and meaning.
fn listed(model: &Model, out: &mut String) {
    out.push_str("\\begin{longtable}{llll}\nsymbol & value & unit & meaning \\\\\n\\hline\n");
    let mut row = |name: &str, value: String, unit: &Unit, meaning: &str| {
        let _ = writeln!(out, "${}$ & {value} & {} & {meaning} \\\\", symbol(name), of_unit(unit));
    };
    let words =
        |meaning: &Option<String>, otherwise: &str| meaning.as_ref().map_or(otherwise.into(), |m| plain(m));
    for p in &model.parameters {
        row(&p.name, valued(p.value, &p.unit), &p.unit, &words(&p.meaning, ""));
    }
    for i in &model.inputs {
        row(&i.name, String::new(), &i.unit, &words(&i.meaning, "input"));
    }
    for s in &model.states {
        let start = match s.initial {
            Initial::Number(x) => format!("{} at the start", valued(x, &s.unit)),
            Initial::Steady => "steady at the start".into(),
            Initial::Fit => "fitted at the start".into(),
        };
        row(&s.name, start, &s.unit, &words(&s.meaning, "state"));
    }
    for d in &model.definitions {
        row(&d.name, String::new(), &d.unit, &words(&d.meaning, ""));
    }
    for o in &model.outputs {
        row(&o.name, String::new(), &o.unit, &words(&o.meaning, "output"));
    }
    out.push_str("\\end{longtable}\n");
}

/// A value of SI in the unit, with six digits.
fn valued(si: f64, unit: &Unit) -> String {
    let text = significant(unit.from_si(si), 6);
    let (mantissa, power) = text.split_once('e').map_or((text.as_str(), ""), |(m, p)| (m, p));
    let mantissa =
        if mantissa.contains('.') { mantissa.trim_end_matches('0').trim_end_matches('.') } else { mantissa };
    let power = if power.is_empty() { String::new() } else { format!("e{power}") };
    format!("${}$", power_of_ten(&format!("{mantissa}{power}")))
}

fn power_of_ten(text: &str) -> String {
    match text.split_once('e') {
        None => text.to_string(),
        Some(("1", power)) => format!("10^{{{power}}}"),
        Some((mantissa, power)) => format!("{mantissa} \\cdot 10^{{{power}}}"),
    }
}

/// The expression; what stands in a fraction or under a root needs no parentheses.
fn spell(e: &Expr) -> String {
    match e {
        Expr::Number(x) => power_of_ten(&format!("{x:?}").trim_end_matches(".0").replace("e-0", "e-")),
        Expr::Name(name) => symbol(name),
        Expr::Neg(a) => format!("-{}", within(a, Binding::Product)),
        Expr::Binary(BinaryOp::Div, a, b) => format!("\\frac{{{}}}{{{}}}", spell(a), spell(b)),
        Expr::Binary(BinaryOp::Pow, a, b) => power(a, b),
        Expr::Binary(BinaryOp::Mul, a, b) => {
            let left = if matches!(**a, Expr::Neg(_)) { spell(a) } else { within(a, Binding::Product) };
            let right = within(b, Binding::Power);
            let touches = right.starts_with(|c: char| c.is_ascii_digit());
            format!("{left}{}{right}", if touches { " \\cdot " } else { " \\, " })
        }
        Expr::Binary(op, a, b) => {
            let sign = if *op == BinaryOp::Add { "+" } else { "-" };
            let right = within(b, Binding::Product);
            let right = if right.starts_with('-') { enclosed(&right) } else { right };
            format!("{} {sign} {right}", spell(a))
        }
        Expr::Call(f, x) => call(*f, &x.iter().map(spell).collect::<Vec<_>>()),
    }
}

fn within(e: &Expr, least: Binding) -> String {
    let spelt = spell(e);
    let binds = match e {
        Expr::Neg(_) | Expr::Binary(BinaryOp::Add | BinaryOp::Sub, ..) => Binding::Sum,
        Expr::Binary(BinaryOp::Mul, ..) => Binding::Product,
        _ => Binding::Power,
    };
    // a product within a product needs none either
    let is_product = matches!(e, Expr::Binary(BinaryOp::Mul, ..)) && least == Binding::Power;
    if binds < least && !is_product { enclosed(&spelt) } else { spelt }
}

fn enclosed(spelt: &str) -> String {
    format!("\\left({spelt}\\right)")
}

fn power(a: &Expr, b: &Expr) -> String {
    match (a, whole(b)) {
        (Expr::Call(f @ (Function::Sin | Function::Cos | Function::Tan), x), Some(n)) if n > 1 => {
            format!("\\{}^{{{n}}}{}", f.name(), enclosed(&spell(&x[0])))
        }
        (Expr::Name(_), _) => format!("{{{}}}^{{{}}}", spell(a), spell(b)),
        (Expr::Number(x), _) if *x >= 0.0 && !format!("{x:?}").contains('e') => {
            format!("{}^{{{}}}", spell(a), spell(b))
        }
        (Expr::Call(Function::Abs, _), _) => format!("{}^{{{}}}", spell(a), spell(b)),
        _ => format!("{}^{{{}}}", enclosed(&spell(a)), spell(b)),
    }
}

fn call(f: Function, x: &[String]) -> String {
    let of = |name: &str| format!("{name}{}", enclosed(&x.join(", ")));
    match f {
        Function::Sqrt => format!("\\sqrt{{{}}}", x[0]),
        Function::Abs => format!("\\left|{}\\right|", x[0]),
        Function::Exp => of("\\exp"),
        Function::Sign => of("\\operatorname{sgn}"),
        Function::Delay => format!("\\left.{}\\right|_{{t - {}}}", enclosed(&x[0]), x[1]),
        Function::Asin | Function::Acos | Function::Atan => of(&format!("\\arc{}", &f.name()[1..])),
        Function::Atan2 => of("\\operatorname{atan2}"),
        Function::Clamp => format!("\\min\\left(\\max\\left({}, {}\\right), {}\\right)", x[0], x[1], x[2]),
        Function::Surface(..) => of("\\operatorname{surface}"),
        _ => match OWN.iter().find(|o| o.0 == f) {
            Some((_, name, _)) => of(&format!("\\operatorname{{{name}}}")),
            None => of(&format!("\\{}", f.name())),
        },
    }
}

/// A name: Greek letters as such, what follows a `_` or a letter's digits below it, words upright.
fn symbol(name: &str) -> String {
    let ascii = super::names::plain(name);
    let whole = ascii.trim_matches('_');
    let letters = whole.trim_end_matches(|c: char| c.is_ascii_digit());
    let (stem, below) = whole.split_once('_').unwrap_or((letters, &whole[letters.len()..]));
    let (stem, below) = (stem.to_string(), below.replace('_', ","));
    let small = stem.to_ascii_lowercase();
    let stem = match stem.chars().count() {
        _ if GREEK.contains(&small.as_str()) => greek(&stem),
        1 => stem,
        _ => format!("\\mathrm{{{stem}}}"),
    };
    match below.as_str() {
        "" => stem,
        below if below.chars().all(|c| c.is_ascii_digit() || c == ',') => format!("{stem}_{{{below}}}"),
        below => format!("{stem}_{{\\mathrm{{{below}}}}}"),
    }
}

/// A Greek letter by its name; capitals that look like Latin ones are those.
fn greek(word: &str) -> String {
    let capital = word.starts_with(|c: char| c.is_ascii_uppercase());
    let has_sign =
        ["Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi", "Psi", "Omega"];
    match capital {
        false => format!("\\{}", if word == "omicron" { "o" } else { word }),
        true if has_sign.contains(&word) => format!("\\{word}"),
        true => format!("\\mathrm{{{word}}}"),
    }
}

fn of_unit(unit: &Unit) -> String {
    let mut out = String::from("$\\mathrm{");
    let text =
        unit.text().replace('*', "\\,").replace('%', "\\%").replace('°', "^{\\circ}").replace('µ', "\\mu ");
    let mut letters = text.chars().peekable();
    while let Some(c) = letters.next() {
        out.push(c);
        if c == '^' && letters.peek() != Some(&'{') {
            out.push('{');
            while let Some(d) = letters.next_if(|d| d.is_ascii_digit() || matches!(d, '-' | '.')) {
                out.push(d);
            }
            out.push('}');
        }
    }
    out + "}$"
}

/// Words in which no sign of LaTeX is left.
fn plain(text: &str) -> String {
    let mut out = String::new();
    for c in one_line(text).chars() {
        match c {
            '\\' => out.push_str("\\textbackslash{}"),
            '~' => out.push_str("\\textasciitilde{}"),
            '^' => out.push_str("\\textasciicircum{}"),
            '{' | '}' | '$' | '&' | '#' | '%' | '_' => out.extend(['\\', c]),
            '<' | '>' | '|' => {
                let _ = write!(out, "${c}$");
            }
            _ => out.push(c),
        }
    }
    out
}
