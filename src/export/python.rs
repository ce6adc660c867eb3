//! Python 3, its standard library alone.

use super::Language;
use super::body::{Lines, guards};
use super::lowered::{Lowered, only};
use super::spell::{Binding, Words, called, whole};
use super::{runner, said};
use crate::Result;
use crate::expression::{Expr, Function};
use crate::model::{Initial, Model};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Keywords, and the names of the file itself.
const RESERVED: &str = "False None True and as assert async await break class continue def del elif else except finally for from global \
    if import in is lambda nonlocal not or pass raise return try while with yield match t x u p m first math csv sys \
    main run min max abs bisect_right Memory derivatives outputs update switches delays _play _relay _limit _past \
    _keep _settle _sign _step _curve _line _surface _quotient _power _sqrt _ln _exp _asin _acos";

const TEXT: &str = include_str!("text/python.txt");

struct Python {
    /// Names of parameters, by which dividing is safe.
    parameters: BTreeSet<String>,
}

impl Words for Python {
    fn name(&self, name: &str) -> String {
        if name == "pi" { "math.pi".into() } else { name.into() }
    }

    fn power(&self, a: &Expr, b: &Expr) -> String {
        match whole(b) {
            Some(n) if n >= 0 => format!("{}**{n}", self.within(a, Binding::Atom)),
            _ => format!("_power({}, {})", self.spell(a), self.spell(b)),
        }
    }

    fn quotient(&self, a: &Expr, b: &Expr) -> Option<String> {
        let is_safe = only(b, &|name| name == "pi" || self.parameters.contains(name));
        (!is_safe).then(|| format!("_quotient({}, {})", self.spell(a), self.spell(b)))
    }

    fn call(&self, f: Function, x: &[String]) -> String {
        match f {
            Function::Sqrt | Function::Ln | Function::Exp | Function::Asin | Function::Acos => {
                called(&format!("_{}", f.name()), x)
            }
            Function::Sign => called("_sign", x),
            Function::Step => format!("(0.5 + 0.5*_sign({}, 1.0))", x[0]),
            Function::Curve => called("_curve", x),
            Function::Surface(n, m) => {
                let (n, m) = (2 + usize::from(n), usize::from(m));
                let list = |x: &[String]| format!("[{}]", x.join(", "));
                called(
                    "_surface",
                    &[x[0].clone(), x[1].clone(), list(&x[2..n]), list(&x[n..n + m]), list(&x[n + m..])],
                )
            }
            Function::Abs | Function::Min | Function::Max => called(f.name(), x),
            Function::Clamp => format!("min(max({}, {}), {})", x[0], x[1], x[2]),
            _ => called(&format!("math.{}", f.name()), x),
        }
    }
}

impl Lines for Python {
    fn bind(&self, name: &str, value: &str) -> String {
        format!("{name} = {value}")
    }

    fn line(&self, statement: &str) -> String {
        statement.into()
    }

    fn at_start(&self, statement: &str) -> String {
        format!("if first:\n        {statement}")
    }

    fn kept(&self) -> &'static str {
        "m."
    }

    fn helper(&self, name: &str) -> String {
        format!("_{name}")
    }

    fn parameter(&self, name: &str, _: &str) -> String {
        format!("p[\"{name}\"]")
    }
}

/// The model in Python.
pub(super) fn text(model: &Model) -> Result<String> {
    let reserved: Vec<&str> = RESERVED.split_whitespace().collect();
    let own = Lowered::of(model, &reserved)?;
    let parameters = model.parameters.iter().map(|p| own.names.of(&p.name).to_string()).collect();
    let python = Python { parameters };
    runner::spoken(&own, Language::Python)?;
    let mut out = head(&own);
    data(&own, &mut out);
    memory(&own, &mut out);
    functions(&own, &python, &mut out);
    let body = out.clone();
    out.push_str(&safe(&body));
    out.push_str(&runner::blocks(TEXT, &|word| runner::holds(&own, word)));
    Ok(format!("{}\n", out.trim_end()))
}

fn head(own: &Lowered<'_>) -> String {
    let mut lines = said::head(own, true);
    lines.push("A program: python3 model.py < inputs.csv > outputs.csv".into());
    lines.push("Example: run([0.0, 0.1], {\"input\": [0.0, 1.0]}, substeps=4)".replace(
        "{\"input\": [0.0, 1.0]}",
        &format!(
                "{{{}}}",
                own.model
                    .inputs
                    .iter()
                    .map(|i| format!("\"{}\": [0.0, 1.0]", i.name))
                    .collect::<Vec<_>>()
                    .join(", ")
            ),
    ));
    let commented: String = lines.iter().map(|l| format!("# {l}\n").replace("# \n", "#\n")).collect();
    format!("{commented}\nimport csv\nimport math\nimport sys\nfrom bisect import bisect_right\n\n")
}

fn data(own: &Lowered<'_>, out: &mut String) {
    let model = own.model;
    out.push_str("PARAMETERS = {\n");
    for p in &model.parameters {
        let comment = said::comment(&p.unit, p.meaning.as_ref());
        let _ = writeln!(out, "    \"{}\": {:?},  # {comment}", p.name, p.value);
    }
    out.push_str("}\nINITIAL = {\n");
    for s in &model.states {
        let (value, note) = match s.initial {
            Initial::Number(x) => (format!("{x:?}"), ""),
            Initial::Fit => ("0.0".to_string(), "; the model fits it to each recording: give your own"),
            Initial::Steady => ("None".to_string(), "; None is the steady state at the first inputs"),
        };
        let _ = writeln!(
            out,
            "    \"{}\": {value},  # {}{note}",
            s.name,
            said::comment(&s.unit, s.meaning.as_ref())
        );
    }
    out.push_str("}\n");
    let inputs = model.inputs.iter().map(|i| (&i.name, said::comment(&i.unit, i.meaning.as_ref())));
    let outputs = model.outputs.iter().map(|o| (&o.name, said::comment(&o.unit, o.meaning.as_ref())));
    list(out, "INPUTS", inputs);
    list(out, "OUTPUTS", outputs);
    if own.steps() {
        let _ = writeln!(out, "_LAGS = {}", own.counts.lags);
    }
    if own.counts.signs > 0 {
        let at_zero: Vec<String> = own
            .locals
            .iter()
            .filter_map(|l| match &l.value {
                super::lowered::Value::Sign(_, _, zero) => Some(format!("{zero:?}")),
                _ => None,
            })
            .collect();
        let _ = writeln!(out, "_AT_ZERO = [{}]", at_zero.join(", "));
    }
}

fn list<'a>(out: &mut String, name: &str, entries: impl Iterator<Item = (&'a String, String)>) {
    let _ = writeln!(out, "{name} = [");
    for (entry, comment) in entries {
        let _ = writeln!(out, "    \"{entry}\",  # {comment}");
    }
    out.push_str("]\n");
}

fn memory(own: &Lowered<'_>, out: &mut String) {
    out.push_str("\n\nclass Memory:\n    \"\"\"What is kept from step to step beside the states.\"\"\"\n\n");
    if !own.remembers() {
        out.push_str("    __slots__ = ()\n");
        return;
    }
    out.push_str("    def __init__(self):\n");
    let c = own.counts;
    for (name, count, value) in [
        ("play", c.plays, "0.0"),
        ("relay", c.relays, "0.0"),
        ("limit", c.limits, "0.0"),
        ("sign", c.signs, "0.0"),
        ("stuck", c.signs, "False"),
    ] {
        if count > 0 {
            let _ = writeln!(out, "        self.{name} = [{value}] * {count}");
        }
    }
    if c.pasts > 0 {
        let _ =
            writeln!(out, "        self.times = []\n        self.past = [[] for _ in range({})]", c.pasts);
    }
    out.push_str("        self.since = 0.0\n");
}

fn functions(own: &Lowered<'_>, python: &Python, out: &mut String) {
    let results = |es: &[&Expr]| {
        format!("return [{}]", es.iter().map(|e| python.spell(e)).collect::<Vec<_>>().join(", "))
    };
    let rates: Vec<&Expr> = own.rates.iter().collect();
    let outputs: Vec<&Expr> = own.outputs.iter().collect();
    let guards = guards(own);
    let mut function = |call: &str, words: &str, lines: &[String], last: &str| {
        let _ = write!(out, "\n\ndef {call}:\n    \"\"\"{words}\"\"\"\n");
        for line in lines {
            let _ = writeln!(out, "    {line}");
        }
        let _ = writeln!(out, "    {last}");
    };
    function(
        "derivatives(t, x, u, p, m)",
        "The rates of the states x at the inputs u.",
        &python.before(own, &rates),
        &results(&rates),
    );
    function(
        "outputs(t, x, u, p, m)",
        "The outputs, in the order of OUTPUTS.",
        &python.before(own, &outputs),
        &results(&outputs),
    );
    if own.counts.signs > 0 {
        let words = "The arguments of the signs.";
        function("switches(t, x, u, p, m)", words, &python.before(own, &guards), &results(&guards));
    }
    if own.remembers() {
        let times = if own.counts.pasts > 0 { "m.times.append(t)\n    " } else { "" };
        function(
            "update(t, x, u, p, m, first)",
            "Keeps what is remembered at the end of a step, or at the start.",
            &python.updated(own),
            &format!("{times}m.since = t"),
        );
    }
    if !own.columns.is_empty() {
        let agos: Vec<&Expr> = own.columns.iter().map(|c| &c.ago).collect();
        let pairs: Vec<String> =
            own.columns.iter().map(|c| format!("({}, {})", c.input, python.spell(&c.ago))).collect();
        function(
            "delays(p)",
            "Delayed inputs, which stand behind the others: number of the input, and how late, s.",
            &python.before(own, &agos),
            &format!("return [{}]", pairs.join(", ")),
        );
    }
}

/// Functions that give no number where the standard library raises; those that a text uses.
fn safe(text: &str) -> String {
    const ALL: [(&str, &str); 7] = [
        (
            "_quotient(",
            "def _quotient(a, b):\n    if b:\n        return a / b\n    return math.nan if a == 0 or a != a else math.copysign(math.inf, a) * math.copysign(1.0, b)\n",
        ),
        (
            "_power(",
            "def _power(a, b):\n    try:\n        return math.pow(a, b)\n    except ValueError:\n        return math.inf if a == 0 else math.nan\n    except OverflowError:\n        return math.inf\n",
        ),
        ("_sqrt(", "def _sqrt(x):\n    return math.sqrt(x) if x >= 0 else math.nan\n"),
        ("_ln(", "def _ln(x):\n    return math.log(x) if x > 0 else -math.inf if x == 0 else math.nan\n"),
        ("_exp(", "def _exp(x):\n    return math.exp(x) if x < 709.78 else math.inf\n"),
        ("_asin(", "def _asin(x):\n    return math.asin(x) if -1 <= x <= 1 else math.nan\n"),
        ("_acos(", "def _acos(x):\n    return math.acos(x) if -1 <= x <= 1 else math.nan\n"),
    ];
    ALL.iter().filter(|f| text.contains(f.0)).map(|f| format!("\n\n{}", f.1)).collect()
}
