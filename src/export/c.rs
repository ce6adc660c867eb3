//! C99, one file that needs the mathematics library alone.

use super::Language;
use super::body::{Lines, columns, guards};
use super::lowered::{Lowered, Value};
use super::spell::{Words, called};
use super::{runner, said};
use crate::Result;
use crate::expression::{Expr, Function};
use crate::model::{Initial, Model};
use std::fmt::Write;

/// Keywords, what the standard library and compilers define, and the names of the file itself.
const RESERVED: &str = "auto break case char const continue default do double else enum extern float for goto if inline \
    int long register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while \
    asm typeof linux unix NULL NAN INFINITY isnan isinf errno stdin stdout stderr bool true false main \
    M_E M_LOG2E M_LOG10E M_LN2 M_LN10 M_PI M_PI_2 M_PI_4 M_1_PI M_2_PI M_2_SQRTPI M_SQRT2 M_SQRT1_2 MAXFLOAT HUGE_VAL HUGE_VALF \
    HUGE_VALL FP_NAN FP_INFINITE FP_ZERO FP_SUBNORMAL FP_NORMAL FP_ILOGB0 FP_ILOGBNAN FP_FAST_FMA FP_FAST_FMAF FP_FAST_FMAL \
    MATH_ERRNO MATH_ERREXCEPT math_errhandling DOMAIN SING OVERFLOW UNDERFLOW TLOSS PLOSS X_TLOSS fpclassify isfinite isnormal \
    isgreater isgreaterequal isless islessequal islessgreater isunordered offsetof EOF BUFSIZ RAND_MAX EXIT_SUCCESS EXIT_FAILURE \
    SEEK_SET SEEK_CUR SEEK_END FILENAME_MAX FOPEN_MAX __STDC__ L_tmpnam TMP_MAX MB_CUR_MAX P_tmpdir size_t t x u p m to \
    first fabs fmin fmax pow sin cos tan asin acos atan atan2 sinh cosh tanh exp log sqrt ceil signbit div abs min max \
    model_parameters model_defaults model_start model_memory model_derivatives model_outputs model_update model_switches \
    model_delays model_relay model_play model_limit model_sign model_settle model_rank model_past model_keep model_chord \
    model_slope model_curve model_line model_surface model_step model_trial model_end model_hold model_choose \
    model_advance model_solve model_steady model_lines model_stop model_run";

const TEXT: &str = include_str!("text/c.txt");
const RUNNER: &str = include_str!("text/c_runner.txt");
const PROGRAM: &str = include_str!("text/c_program.txt");

/// What every function of the model is given.
const GIVEN: &str = "double t, const double *x, const double *u, const model_parameters *p,";

struct C;

impl Words for C {
    fn name(&self, name: &str) -> String {
        if name == "pi" { "3.141592653589793".into() } else { name.into() }
    }

    fn power(&self, a: &Expr, b: &Expr) -> String {
        format!("pow({}, {})", self.spell(a), self.spell(b))
    }

    fn call(&self, f: Function, x: &[String]) -> String {
        match f {
            Function::Ln => called("log", x),
            Function::Abs => called("fabs", x),
            Function::Min => called("fmin", x),
            Function::Max => called("fmax", x),
            Function::Clamp => format!("fmin(fmax({}, {}), {})", x[0], x[1], x[2]),
            Function::Sign => format!("model_sign({}, 0.0)", x[0]),
            Function::Step => format!("(0.5 + 0.5*model_sign({}, 1.0))", x[0]),
            Function::Curve => format!("model_curve({}, {}, {})", x[0], x.len() / 2, literal(&x[1..])),
            Function::Surface(n, m) => {
                format!("model_surface({}, {}, {n}, {m}, {})", x[0], x[1], literal(&x[2..]))
            }
            _ => called(f.name(), x),
        }
    }
}

fn literal(x: &[String]) -> String {
    format!("(const double[]){{{}}}", x.join(", "))
}

impl Lines for C {
    fn bind(&self, name: &str, value: &str) -> String {
        format!("const double {name} = {value};")
    }

    fn line(&self, statement: &str) -> String {
        format!("{statement};")
    }

    fn at_start(&self, statement: &str) -> String {
        format!("if (first)\n        {statement};")
    }

    fn kept(&self) -> &'static str {
        "m->"
    }

    fn helper(&self, name: &str) -> String {
        format!("model_{name}")
    }

    fn parameter(&self, _: &str, own: &str) -> String {
        format!("p->{own}")
    }
}

/// The model in C.
pub(super) fn text(model: &Model) -> Result<String> {
    let own = lowered(model)?;
    let mut out = code(&own);
    out.push_str("\n#ifdef MODEL_PROGRAM\n");
    names(&own, &mut out);
    out.push_str(&runner::blocks(PROGRAM, &|word| runner::holds(&own, word)));
    out.push_str("#endif\n");
    Ok(out)
}

/// The model as C spells it.
pub(super) fn lowered(model: &Model) -> Result<Lowered<'_>> {
    let reserved: Vec<&str> = RESERVED.split_whitespace().collect();
    let own = Lowered::of(model, &reserved)?;
    runner::spoken(&own, Language::C)?;
    Ok(own)
}

/// The file without the program that reads and writes tables.
pub(super) fn code(own: &Lowered<'_>) -> String {
    let mut out = head(own);
    data(own, &mut out);
    memory(own, &mut out);
    let take = |text: &str| runner::blocks(text, &|word| runner::holds(own, word));
    out.push_str(&take(TEXT));
    functions(own, &mut out);
    out.push_str(&take(RUNNER));
    out
}

fn head(own: &Lowered<'_>) -> String {
    let mut lines = said::head(own, true);
    lines.push(
        "A program: cc -O2 -DMODEL_PROGRAM model.c -lm -o model && ./model < inputs.csv > outputs.csv".into(),
    );
    let lines: Vec<String> = lines.iter().map(|l| comment(l)).collect();
    format!(
        "/* {} */\n\n#include <math.h>\n#include <stddef.h>\n\n",
        lines.join("\n   ").replace("\n   \n", "\n\n")
    )
}

/// Text that cannot end a comment.
fn comment(text: &str) -> String {
    text.replace("*/", "* /").replace("/*", "/ *")
}

fn data(own: &Lowered<'_>, out: &mut String) {
    let model = own.model;
    out.push_str("#ifndef MODEL_LINKAGE\n#define MODEL_LINKAGE\n#endif\n\n");
    for (what, list) in [
        ("inputs", model.inputs.iter().map(|i| (&i.name, &i.unit, i.meaning.as_ref())).collect::<Vec<_>>()),
        ("states", model.states.iter().map(|s| (&s.name, &s.unit, s.meaning.as_ref())).collect()),
        ("outputs", model.outputs.iter().map(|o| (&o.name, &o.unit, o.meaning.as_ref())).collect()),
    ] {
        let _ = writeln!(out, "/* The {what}, in this order:");
        for (name, unit, meaning) in list {
            let _ = writeln!(out, "   {name}, {}", comment(&said::comment(unit, meaning)));
        }
        out.push_str("*/\n");
    }
    let c = own.counts;
    let counts = [
        ("INPUTS", model.inputs.len()),
        ("OUTPUTS", model.outputs.len()),
        ("STATES", model.states.len()),
        ("ALL", own.states()),
        ("COLUMNS", columns(own).len()),
        ("PARAMETERS", model.parameters.len()),
    ];
    let signs = [("SIGNS", c.signs), ("PASTS", c.pasts)];
    let all = counts.iter().chain(signs.iter().filter(|s| s.1 > 0));
    let all: Vec<String> = all.map(|(name, n)| format!("MODEL_{name} = {n}")).collect();
    let _ = writeln!(out, "enum {{ {} }};", all.join(", "));
    parameters(own, out);
    let start: Vec<String> = model.states.iter().map(|s| start(s.initial)).collect();
    let _ = writeln!(
        out,
        "\n/* The states at the start; NAN is the steady state at the first inputs */\n\
         MODEL_LINKAGE const double model_start[] = {{{}}};",
        if start.is_empty() { "0.0".into() } else { start.join(", ") }
    );
}

fn start(initial: Initial) -> String {
    match initial {
        Initial::Number(x) => format!("{x:?}"),
        Initial::Fit => "0.0".into(),
        Initial::Steady => "NAN".into(),
    }
}

fn parameters(own: &Lowered<'_>, out: &mut String) {
    let all = &own.model.parameters;
    out.push_str("\ntypedef struct {\n");
    for p in all {
        let words = comment(&said::comment(&p.unit, p.meaning.as_ref()));
        let _ = writeln!(out, "    double {}; /* {words} */", own.names.of(&p.name));
    }
    out.push_str(if all.is_empty() { "    double none;\n" } else { "" });
    let values: Vec<String> = all.iter().map(|p| format!("{:?}", p.value)).collect();
    let values = if values.is_empty() { "0.0".into() } else { values.join(", ") };
    let _ = writeln!(
        out,
        "}} model_parameters;\n\nMODEL_LINKAGE const model_parameters model_defaults = {{{values}}};"
    );
}

fn memory(own: &Lowered<'_>, out: &mut String) {
    let c = own.counts;
    out.push_str(
        "\n/* What is kept from step to step beside the states */\ntypedef struct {\n    double since;\n",
    );
    for (name, count) in [("play", c.plays), ("relay", c.relays), ("limit", c.limits), ("sign", c.signs)] {
        if count > 0 {
            let _ = writeln!(out, "    double {name}[{count}];");
        }
    }
    if c.signs > 0 {
        let _ = writeln!(out, "    int stuck[{}];", c.signs);
    }
    if c.pasts > 0 {
        out.push_str("    double *times, *past;\n    size_t count, capacity;\n");
    }
    out.push_str("} model_memory;\n\n");
    if c.pasts > 0 {
        let late = own.columns.len();
        let _ = writeln!(
            out,
            "/* Instants that a run remembers, and the numbers that they need */\n\
             #define MODEL_ROOM(count, substeps) ((size_t)(count) * ((substeps) + {}) + 2)\n\
             #define MODEL_WORK(count, substeps) (MODEL_ROOM(count, substeps) * {})",
            late + 1,
            c.pasts + 1
        );
    } else {
        out.push_str("#define MODEL_WORK(count, substeps) 0\n");
    }
    let inputs = (0..own.model.inputs.len()).chain(own.columns.iter().map(|c| c.input));
    let which: Vec<String> = inputs.map(|i| i.to_string()).collect();
    let which = if which.is_empty() { "0".into() } else { which.join(", ") };
    let _ = writeln!(out, "#define MODEL_WHICH {{{which}}}");
    if c.signs > 0 {
        let at_zero = own.locals.iter().filter_map(|l| match &l.value {
            Value::Sign(_, _, zero) => Some(format!("{zero:?}")),
            _ => None,
        });
        let _ = writeln!(out, "#define MODEL_AT_ZERO {{{}}}", at_zero.collect::<Vec<_>>().join(", "));
    }
}

fn functions(own: &Lowered<'_>, out: &mut String) {
    let rates: Vec<&Expr> = own.rates.iter().collect();
    let outputs: Vec<&Expr> = own.outputs.iter().collect();
    let mut evaluate = |words: &str, name: &str, es: &[&Expr]| {
        let head = format!("model_{name}({GIVEN} const model_memory *m, double *to)");
        let mut lines = C.before(own, es);
        lines.extend(es.iter().enumerate().map(|(i, e)| format!("to[{i}] = {};", C.spell(e))));
        function(out, words, &head, "(void)t; (void)x; (void)u; (void)p; (void)m; (void)to;", &lines);
    };
    if own.states() > 0 {
        evaluate("The rates of the states x at the inputs u", "derivatives", &rates);
    }
    evaluate("The outputs", "outputs", &outputs);
    if own.counts.signs > 0 {
        evaluate("The arguments of the signs", "switches", &guards(own));
    }
    if own.remembers() {
        let mut lines = C.updated(own);
        if own.counts.pasts > 0 {
            lines.push("if (m->count < m->capacity)\n        m->times[m->count++] = t;".into());
        }
        lines.push("m->since = t;".into());
        let given = GIVEN.replace("const double *x", "double *x");
        let head = format!("model_update({given} model_memory *m, int first)");
        let words = "Keeps what is remembered at the end of a step, or at the start";
        function(out, words, &head, "(void)x; (void)u; (void)p; (void)first;", &lines);
    }
    if !own.columns.is_empty() {
        let agos: Vec<&Expr> = own.columns.iter().map(|c| &c.ago).collect();
        let first = own.model.inputs.len();
        let mut lines = C.before(own, &agos);
        lines.extend(agos.iter().enumerate().map(|(i, e)| format!("to[{}] = {};", first + i, C.spell(e))));
        let head = "model_delays(const model_parameters *p, double *to)";
        function(
            out,
            "How late each column is, s: delayed inputs stand behind the others",
            head,
            "(void)p;",
            &lines,
        );
    }
}

fn function(out: &mut String, words: &str, head: &str, unused: &str, lines: &[String]) {
    let _ = writeln!(out, "\n/* {words} */\nstatic void {head}\n{{\n    {unused}");
    for line in lines {
        let _ = writeln!(out, "    {line}");
    }
    out.push_str("}\n");
}

/// The names of inputs, parameters and outputs, as the program reads and writes them.
fn names(own: &Lowered<'_>, out: &mut String) {
    let model = own.model;
    for (what, list) in [
        ("input", model.inputs.iter().map(|i| &i.name).collect::<Vec<_>>()),
        ("parameter", model.parameters.iter().map(|p| &p.name).collect()),
        ("output", model.outputs.iter().map(|o| &o.name).collect()),
    ] {
        let list: Vec<String> = list.iter().map(|name| format!("\"{name}\", ")).collect();
        let _ = writeln!(out, "static const char *const model_{what}_names[] = {{{}NULL}};", list.concat());
    }
}
