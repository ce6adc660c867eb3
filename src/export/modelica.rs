//! Modelica 3, without its library.

use super::body::columns;
use super::lowered::{Lowered, Value};
use super::spell::{Binding, Words, called, whole};
use super::{Language, refused, runner, said};
use crate::Result;
use crate::expression::{Expr, Function};
use crate::model::{Initial, Model};
use crate::units::Unit;
use std::fmt::Write;

/// Keywords, operators that look like functions, and the names of the file itself.
const RESERVED: &str = "algorithm and annotation assert block break class connect connector constant constrainedby der \
    discrete each else elseif elsewhen encapsulated end enumeration equation expandable extends external false final flow \
    for function if import impure in initial inner input loop model not operator or outer output package parameter partial \
    protected public pure record redeclare replaceable return stream then true type when while within time Real Integer \
    Boolean String abs sign sqrt div mod rem ceil floor integer sin cos tan asin acos atan atan2 sinh cosh tanh exp log \
    log10 delay smooth noEvent pre edge change reinit sample homotopy semiLinear min max sum product size zeros ones fill \
    t curve surface";

const TEXT: &str = include_str!("text/modelica.txt");

struct Modelica;

impl Words for Modelica {
    fn name(&self, name: &str) -> String {
        match name {
            "pi" => "3.141592653589793".into(),
            "t" => "time".into(),
            _ => name.into(),
        }
    }

    fn power(&self, a: &Expr, b: &Expr) -> String {
        let exponent = match whole(b) {
            Some(n) if n < 0 => format!("({n})"),
            Some(n) => n.to_string(),
            None => self.within(b, Binding::Atom),
        };
        format!("{}^{exponent}", self.within(a, Binding::Atom))
    }

    fn call(&self, f: Function, x: &[String]) -> String {
        let list = |x: &[String]| format!("{{{}}}", x.join(", "));
        match f {
            Function::Ln => called("log", x),
            Function::Clamp => format!("min(max({}, {}), {})", x[0], x[1], x[2]),
            Function::Step => format!("(if {} >= 0 then 1 else 0)", x[0]),
            Function::Curve => {
                let every = |from: usize| x[from..].iter().step_by(2).cloned().collect::<Vec<_>>();
                called("curve", &[x[0].clone(), list(&every(1)), list(&every(2))])
            }
            Function::Surface(n, m) => {
                let (n, m) = (2 + usize::from(n), usize::from(m));
                let lists = [list(&x[2..n]), list(&x[n..n + m]), list(&x[n + m..])];
                format!("surface({}, {}, {})", x[0], x[1], lists.join(", "))
            }
            _ => called(f.name(), x),
        }
    }
}

/// The model in Modelica.
pub(super) fn text(model: &Model) -> Result<String> {
    let reserved: Vec<&str> = RESERVED.split_whitespace().collect();
    let own = Lowered::of(model, &reserved)?;
    runner::spoken(&own, Language::Modelica)?;
    let class = super::names::class(&own.names, &model.name);
    let mut out: String =
        said::head(&own, false).iter().map(|l| format!("// {l}\n").replace("// \n", "//\n")).collect();
    out.push_str(&dry(&own));
    let _ = writeln!(out, "model {class} \"{}\"", quoted(&model.name));
    declared(&own, &mut out);
    equations(&own, &mut out)?;
    let _ = writeln!(out, "end {class};");
    Ok(out)
}

/// What a solver has to be told of signs.
fn dry(own: &Lowered<'_>) -> String {
    if own.counts.signs == 0 || !own.steps() {
        return String::new();
    }
    "// A sign jumps here. Where it holds its argument at zero, as dry friction does, gyrospec lets it take any value between\n\
     // -1 and 1; Modelica has no words for that, and a solver will chatter there: take a friction element in its place.\n"
        .into()
}

fn declared(own: &Lowered<'_>, out: &mut String) {
    let model = own.model;
    let mut real =
        |kind: &str, name: &str, attributes: &str, unit: &Unit, tail: &str, meaning: Option<&String>| {
            let says = meaning.map(|m| format!(" \"{}\"", quoted(m))).unwrap_or_default();
            let _ = writeln!(out, "  {kind}Real {name}{}{tail}{says};", modified(unit, attributes));
        };
    for p in &model.parameters {
        real(
            "parameter ",
            own.names.of(&p.name),
            "",
            &p.unit,
            &format!(" = {:?}", p.value),
            p.meaning.as_ref(),
        );
    }
    for i in &model.inputs {
        real("input ", own.names.of(&i.name), "", &i.unit, "", i.meaning.as_ref());
    }
    for s in &model.states {
        let start = match s.initial {
            Initial::Number(x) => format!("start = {x:?}, fixed = true"),
            Initial::Fit => "start = 0.0, fixed = true".into(),
            Initial::Steady => String::new(),
        };
        real("", own.names.of(&s.name), &start, &s.unit, "", s.meaning.as_ref());
    }
    for (o, name) in model.outputs.iter().zip(output_names(own)) {
        real("output ", &name, "", &o.unit, "", o.meaning.as_ref());
    }
    let _ = writeln!(out, "protected");
    for d in &model.definitions {
        let _ = writeln!(out, "  Real {}{};", own.names.of(&d.name), modified(&d.unit, ""));
    }
    for name in columns(own).iter().skip(model.inputs.len()) {
        let _ = writeln!(out, "  Real {name};");
    }
    for l in own.locals.iter().filter(|l| !matches!(l.value, Value::Is(_))) {
        let kind = if matches!(l.value, Value::Relay(..)) {
            format!("  Boolean {}_up;\n", l.name)
        } else {
            String::new()
        };
        let _ = writeln!(out, "{kind}  Real {};", l.name);
    }
    out.push_str(&runner::blocks(TEXT, &|word| runner::holds(own, word)));
}

/// Names of the outputs beside those of all else.
fn output_names(own: &Lowered<'_>) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for o in &own.model.outputs {
        let mut name = super::names::plain(&o.name);
        while own.names.has(&name) || all.contains(&name) {
            name.push_str("_out");
        }
        all.push(name);
    }
    all
}

fn equations(own: &Lowered<'_>, out: &mut String) -> Result<()> {
    let model = own.model;
    let steady = model.states.iter().filter(|s| s.initial == Initial::Steady);
    let mut initial: Vec<String> = steady.map(|s| format!("der({}) = 0", own.names.of(&s.name))).collect();
    let mut lines = Vec::new();
    for (i, c) in own.columns.iter().enumerate() {
        let input = own.names.of(&model.inputs[own.columns[i].input].name);
        lines.push(format!("{} = delay({input}, {})", c.name, Modelica.spell(&c.ago)));
    }
    for l in &own.locals {
        let name = &l.name;
        let spelt = |e: &Expr| Modelica.spell(e);
        match &l.value {
            Value::Is(e) => lines.push(format!("{name} = {}", spelt(e))),
            Value::Lag(_, x, time) => {
                initial.push(format!("{name} = {}", spelt(x)));
                let time = Modelica.within(time, Binding::Power);
                lines.push(format!("der({name}) = ({} - {name})/{time}", spelt(x)));
            }
            Value::Past(_, x, ago) => lines.push(format!("{name} = delay({}, {})", spelt(x), spelt(ago))),
            Value::Sign(_, x, at_zero) => {
                let x = spelt(x);
                lines.push(format!("{name} = if {x} > 0 then 1 elseif {x} < 0 then -1 else {at_zero:?}"));
            }
            Value::Relay(_, x, gap) => {
                let (x, gap) = (spelt(x), Modelica.within(gap, Binding::Power));
                initial.push(format!("pre({name}_up) = ({x} >= 0)"));
                lines.push(format!("{name}_up = {x} > {gap}/2 or (pre({name}_up) and {x} >= -{gap}/2)"));
                lines.push(format!("{name} = if {name}_up then 1 else -1"));
            }
            Value::Play(..) => return Err(refused::function(Function::Backlash, Language::Modelica)),
            Value::Limit(..) => return Err(refused::function(Function::RateLimit, Language::Modelica)),
        }
    }
    for (s, rate) in model.states.iter().zip(&own.rates) {
        lines.push(format!("der({}) = {}", own.names.of(&s.name), Modelica.spell(rate)));
    }
    for (name, equals) in output_names(own).iter().zip(&own.outputs) {
        lines.push(format!("{name} = {}", Modelica.spell(equals)));
    }
    for (head, lines) in [("initial equation", initial), ("equation", lines)] {
        if !lines.is_empty() {
            let _ = writeln!(out, "{head}\n  {};", lines.join(";\n  "));
        }
    }
    Ok(())
}

/// Text between quotation marks.
fn quoted(text: &str) -> String {
    crate::text::one_line(text).replace('\\', "\\\\").replace('"', "\\\"")
}

/// What stands in parentheses behind a name.
fn modified(unit: &Unit, attributes: &str) -> String {
    let unit = of_modelica(unit).map(|u| format!("unit = \"{u}\""));
    let all: Vec<String> =
        unit.into_iter().chain((!attributes.is_empty()).then(|| attributes.to_string())).collect();
    if all.is_empty() { String::new() } else { format!("({})", all.join(", ")) }
}

/// The SI unit as Modelica writes it, `kg.m2/(s2.A)`; none for powers that are not whole, which it cannot write.
fn of_modelica(unit: &Unit) -> Option<String> {
    let si = said::si(unit);
    if si.contains('(') {
        return of_modelica(&Unit::of(unit.dimension()));
    }
    let mut factors = si.split('/');
    let above = factors.next()?.replace('*', ".").replace('^', "");
    let below: Vec<String> = factors.map(|f| f.replace('^', "")).collect();
    // `m^1/2` has been cut in two
    if below.iter().any(|f| f.starts_with(|c: char| c.is_ascii_digit())) {
        return None;
    }
    Some(match below.as_slice() {
        [] => above,
        [one] => format!("{above}/{one}"),
        _ => format!("{above}/({})", below.join(".")),
    })
}
