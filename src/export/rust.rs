//! Rust, one file without dependencies.

use super::Language;
use super::body::{Lines, columns, guards};
use super::lowered::{Lowered, Value};
use super::spell::{Words, called};
use super::{runner, said};
use crate::Result;
use crate::expression::{Expr, Function};
use crate::model::{Initial, Model};
use std::fmt::Write;

/// Keywords, and the names of the file itself.
const RESERVED: &str = "as async await break const continue crate dyn else enum extern false fn for if impl in let loop \
    match mod move mut pub ref return self Self static struct super trait true type unsafe use where while abstract become \
    box do final gen macro override priv try typeof unsized virtual yield union None Some Ok Err t x u p m first \
    Parameters Memory Inputs States derivatives outputs update switches delays relay play limit sign settle past keep \
    curve surface rank step Trial advance steady solved lines stop run main tabled read INPUTS OUTPUTS STATES ALL COLUMNS \
    START WHICH AT_ZERO INPUT_NAMES OUTPUT_NAMES";

const TEXT: &str = include_str!("text/rust.txt");

struct Rust;

impl Words for Rust {
    fn name(&self, name: &str) -> String {
        if name == "pi" { "std::f64::consts::PI".into() } else { name.into() }
    }

    fn power(&self, a: &Expr, b: &Expr) -> String {
        format!("f64::powf({}, {})", self.spell(a), self.spell(b))
    }

    fn call(&self, f: Function, x: &[String]) -> String {
        let list = |x: &[String]| format!("&[{}]", x.join(", "));
        match f {
            Function::Clamp => format!("f64::min(f64::max({}, {}), {})", x[0], x[1], x[2]),
            Function::Sign => format!("sign({}, 0.0)", x[0]),
            Function::Step => format!("(0.5 + 0.5*sign({}, 1.0))", x[0]),
            Function::Curve => {
                let knots: Vec<String> = x[1..].chunks(2).map(|k| format!("({}, {})", k[0], k[1])).collect();
                format!("curve({}, {})", x[0], list(&knots))
            }
            Function::Surface(n, m) => {
                let (n, m) = (2 + usize::from(n), usize::from(m));
                let lists = [list(&x[2..n]), list(&x[n..n + m]), list(&x[n + m..])];
                format!("surface({}, {}, {})", x[0], x[1], lists.join(", "))
            }
            _ => called(&format!("f64::{}", f.name()), x),
        }
    }
}

impl Lines for Rust {
    fn bind(&self, name: &str, value: &str) -> String {
        format!("let {name} = {value};")
    }

    fn line(&self, statement: &str) -> String {
        format!("{statement};")
    }

    fn at_start(&self, statement: &str) -> String {
        format!("if first {{\n        {statement};\n    }}")
    }

    fn kept(&self) -> &'static str {
        "m."
    }

    fn helper(&self, name: &str) -> String {
        name.into()
    }

    fn parameter(&self, _: &str, own: &str) -> String {
        format!("p.{own}")
    }
}

/// The model in Rust.
pub(super) fn text(model: &Model) -> Result<String> {
    let reserved: Vec<&str> = RESERVED.split_whitespace().collect();
    let own = Lowered::of(model, &reserved)?;
    runner::spoken(&own, Language::Rust)?;
    let mut out = head(&own);
    data(&own, &mut out);
    memory(&own, &mut out);
    functions(&own, &mut out);
    out.push_str(&runner::blocks(TEXT, &|word| runner::holds(&own, word)));
    Ok(out)
}

fn head(own: &Lowered<'_>) -> String {
    let mut lines = said::head(own, true);
    lines.push("A program: rustc -O model.rs && ./model < inputs.csv > outputs.csv".into());
    let lines: String = lines.iter().map(|l| format!("//! {l}\n").replace("//! \n", "//!\n")).collect();
    format!("{lines}\n#![allow(dead_code, non_snake_case, non_camel_case_types, unused)]\n")
}

fn data(own: &Lowered<'_>, out: &mut String) {
    let model = own.model;
    let words = |name: &str, unit, meaning| format!("/// {name}, {}\n", said::comment(unit, meaning));
    let names = |list: &[&String]| list.iter().map(|n| format!("\"{n}\"")).collect::<Vec<_>>().join(", ");
    let inputs: Vec<&String> = model.inputs.iter().map(|i| &i.name).collect();
    let outputs: Vec<&String> = model.outputs.iter().map(|o| &o.name).collect();
    let _ = writeln!(out, "\npub const INPUTS: usize = {};", inputs.len());
    let _ = writeln!(
        out,
        "pub const OUTPUTS: usize = {};\npub const STATES: usize = {};",
        outputs.len(),
        model.states.len()
    );
    let _ =
        writeln!(out, "const ALL: usize = {};\nconst COLUMNS: usize = {};", own.states(), columns(own).len());
    for i in &model.inputs {
        out.push_str(&words(&i.name, &i.unit, i.meaning.as_ref()));
    }
    let list = |ending: &str, list: String| format!("{ending}[{list}];\n");
    out.push_str(&list("pub const INPUT_NAMES: [&str; INPUTS] = ", names(&inputs)));
    for o in &model.outputs {
        out.push_str(&words(&o.name, &o.unit, o.meaning.as_ref()));
    }
    out.push_str(&list("pub const OUTPUT_NAMES: [&str; OUTPUTS] = ", names(&outputs)));
    for s in &model.states {
        out.push_str(&words(&s.name, &s.unit, s.meaning.as_ref()));
    }
    let start: Vec<String> = model.states.iter().map(|s| start(s.initial)).collect();
    out.push_str(&list("/// The states at the start; NaN is the steady state at the first inputs.\npub const START: [f64; STATES] = ", start.join(", ")));
    let which = (0..inputs.len()).chain(own.columns.iter().map(|c| c.input));
    out.push_str(&list(
        "const WHICH: [usize; COLUMNS] = ",
        which.map(|i| i.to_string()).collect::<Vec<_>>().join(", "),
    ));
    out.push_str("\n/// The states, and what follows a signal behind them.\npub type States = [f64; ALL];\n");
    out.push_str("/// The inputs, and those that are late behind them.\npub type Inputs = [f64; COLUMNS];\n");
    parameters(own, out);
}

fn start(initial: Initial) -> String {
    match initial {
        Initial::Number(x) => format!("{x:?}"),
        Initial::Fit => "0.0".into(),
        Initial::Steady => "f64::NAN".into(),
    }
}

fn parameters(own: &Lowered<'_>, out: &mut String) {
    let all = &own.model.parameters;
    let name = |name: &String| own.names.of(name).to_string();
    out.push_str("\n#[derive(Clone, Debug)]\npub struct Parameters {\n");
    for p in all {
        let _ = writeln!(
            out,
            "    /// {}\n    pub {}: f64,",
            said::comment(&p.unit, p.meaning.as_ref()),
            name(&p.name)
        );
    }
    out.push_str("}\n\nimpl Default for Parameters {\n    fn default() -> Self {\n        Self {\n");
    for p in all {
        let _ = writeln!(out, "            {}: {:?},", name(&p.name), p.value);
    }
    out.push_str("        }\n    }\n}\n\nimpl Parameters {\n    fn named(&mut self, name: &str) -> Option<&mut f64> {\n");
    out.push_str("        match name {\n");
    for p in all {
        let _ = writeln!(out, "            \"{}\" => Some(&mut self.{}),", p.name, name(&p.name));
    }
    out.push_str("            _ => None,\n        }\n    }\n}\n");
}

fn memory(own: &Lowered<'_>, out: &mut String) {
    let c = own.counts;
    out.push_str(
        "\n/// What is kept from step to step beside the states.\n#[derive(Clone, Debug, Default)]\n",
    );
    out.push_str("pub struct Memory {\n    since: f64,\n");
    for (name, count, kind) in [
        ("play", c.plays, "f64"),
        ("relay", c.relays, "f64"),
        ("limit", c.limits, "f64"),
        ("sign", c.signs, "f64"),
        ("stuck", c.signs, "bool"),
        ("past", c.pasts, "Vec<f64>"),
    ] {
        if count > 0 {
            let _ = writeln!(out, "    {name}: [{kind}; {count}],");
        }
    }
    out.push_str(if c.pasts > 0 { "    times: Vec<f64>,\n}\n" } else { "}\n" });
    if c.signs > 0 {
        let at_zero = own.locals.iter().filter_map(|l| match &l.value {
            Value::Sign(_, _, zero) => Some(format!("{zero:?}")),
            _ => None,
        });
        let list = at_zero.collect::<Vec<_>>().join(", ");
        let _ = writeln!(out, "\nconst AT_ZERO: [f64; {}] = [{list}];", c.signs);
    }
}

fn functions(own: &Lowered<'_>, out: &mut String) {
    let rates: Vec<&Expr> = own.rates.iter().collect();
    let outputs: Vec<&Expr> = own.outputs.iter().collect();
    let guards = guards(own);
    let given = "t: f64, x: &States, u: &Inputs, p: &Parameters, m: &Memory";
    let mut evaluate = |words: &str, name: &str, result: &str, es: &[&Expr]| {
        let mut lines = Rust.before(own, es);
        lines.push(format!("[{}]", es.iter().map(|e| Rust.spell(e)).collect::<Vec<_>>().join(", ")));
        function(out, words, &format!("{name}({given}) -> {result}"), &lines);
    };
    evaluate("The rates of the states x at the inputs u.", "derivatives", "States", &rates);
    evaluate("The outputs, in the order of [`OUTPUT_NAMES`].", "outputs", "[f64; OUTPUTS]", &outputs);
    if !guards.is_empty() {
        let result = format!("[f64; {}]", guards.len());
        evaluate("The arguments of the signs.", "switches", &result, &guards);
    }
    if own.remembers() {
        let mut lines = Rust.updated(own);
        if own.counts.pasts > 0 {
            lines.push("m.times.push(t);".into());
        }
        lines.push("m.since = t;".into());
        let head = "update(t: f64, x: &mut States, u: &Inputs, p: &Parameters, m: &mut Memory, first: bool)";
        function(out, "Keeps what is remembered at the end of a step, or at the start.", head, &lines);
    }
    if !own.columns.is_empty() {
        let agos: Vec<&Expr> = own.columns.iter().map(|c| &c.ago).collect();
        let mut lines = Rust.before(own, &agos);
        let none = own.model.inputs.iter().map(|_| "0.0".to_string());
        let all: Vec<String> = none.chain(agos.iter().map(|e| Rust.spell(e))).collect();
        lines.push(format!("[{}]", all.join(", ")));
        function(out, "How late each column is, s.", "delays(p: &Parameters) -> Inputs", &lines);
    }
}

fn function(out: &mut String, words: &str, head: &str, lines: &[String]) {
    let _ = writeln!(out, "\n/// {words}\npub fn {head} {{");
    for line in lines {
        let _ = writeln!(out, "    {line}");
    }
    out.push_str("}\n");
}
