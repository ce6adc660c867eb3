//! A Functional Mock-up Unit 2.0: the model in C, compiled for this machine, with its description.
//!
//! The source lies in the archive too, so that other machines can compile it.

use super::lowered::{Lowered, Value};
use super::{c, refused, runner, said};
use crate::model::{Initial, Model};
use crate::units::Unit;
use crate::{Error, Result};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::{Cursor, Write as _};
use std::process::Command;

const TEXT: &str = include_str!("text/c_fmu.txt");

/// The model as the bytes of an FMU, for co-simulation and, where nothing but states has a memory, for model exchange.
///
/// # Errors
/// `BadInput` as [`export`](super::export); `NotComputed` where no C compiler can be run (`cc`, or what the variable
/// `CC` names), or where it fails.
///
/// ```no_run
/// use gyrospec::{Model, export_fmu};
/// std::fs::write("gyrosphere.fmu", export_fmu(&Model::builtin("gyrosphere")?)?).unwrap();
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn export_fmu(model: &Model) -> Result<Vec<u8>> {
    refused::whole(model)?;
    model.compile()?;
    let own = c::lowered(model)?;
    let name = super::names::class(&own.names, &model.name);
    let code = source(&own, &name);
    let library = compiled(&code)?;
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options = zip::write::SimpleFileOptions::default();
    let description = description(&own, &name, &code);
    let (folder, ending) = platform();
    let entries: [(String, &[u8]); 3] = [
        ("modelDescription.xml".into(), description.as_bytes()),
        (format!("binaries/{folder}/{name}.{ending}"), &library),
        ("sources/model.c".into(), code.as_bytes()),
    ];
    let wrong =
        |e: &dyn std::fmt::Display| Error::not_computed(format!("the archive cannot be written: {e}"));
    for (entry, bytes) in entries {
        zip.start_file(entry, options).map_err(|e| wrong(&e))?;
        zip.write_all(bytes).map_err(|e| wrong(&e))?;
    }
    Ok(zip.finish().map_err(|e| wrong(&e))?.into_inner())
}

/// Whether a solver can take the rates alone: only states have a memory.
fn is_smooth(own: &Lowered<'_>) -> bool {
    let c = own.counts;
    c.plays + c.relays + c.limits + c.pasts + c.signs == 0 && own.columns.is_empty()
}

fn source(own: &Lowered<'_>, name: &str) -> String {
    let code = c::code(own).replacen("/* ", &format!("/* {name}: "), 1);
    // steps are halved until a state moves by no more than that share of its size
    let tolerance = if is_smooth(own) { "1e-10" } else { "1e-6" };
    let head = format!("#define MODEL_TOLERANCE {tolerance}\n#define MODEL_PIECES 4096\n");
    let unit = runner::blocks(TEXT, &|word| runner::holds(own, word));
    let guid = token(&(code.clone() + &unit));
    format!("#define MODEL_LINKAGE static\n{code}\n{head}#define MODEL_GUID \"{guid}\"\n{unit}")
}

/// A token that the same model always has.
fn token(code: &str) -> String {
    let hash: String = Sha256::digest(code).iter().take(16).map(|b| format!("{b:02x}")).collect();
    format!("{{{hash}}}")
}

/// The folder of this machine in an archive, and the ending of its libraries.
fn platform() -> (String, &'static str) {
    let (system, ending) = match std::env::consts::OS {
        "macos" => ("darwin", "dylib"),
        "windows" => ("win", "dll"),
        _ => ("linux", "so"),
    };
    match std::env::consts::ARCH {
        "x86_64" => (format!("{system}64"), ending),
        other => (format!("{other}-{system}"), ending),
    }
}

fn compiled(code: &str) -> Result<Vec<u8>> {
    let compiler = std::env::var("CC").ok().filter(|c| !c.is_empty()).unwrap_or_else(|| "cc".into());
    let folder = tempfile::tempdir()
        .map_err(|e| Error::not_computed(format!("no folder can be made for the compiler: {e}")))?;
    let (source, library) = (folder.path().join("model.c"), folder.path().join("model.library"));
    let wrong = |what: String| {
        Error::not_computed(what).with_hint(
        "an FMU holds machine code: set the variable CC to a C compiler, or export to c and compile it elsewhere",
    )
    };
    std::fs::write(&source, code).map_err(|e| wrong(format!("the source cannot be written: {e}")))?;
    // the variable may hold options, as for make
    let mut words = compiler.split_whitespace();
    let out = Command::new(words.next().unwrap_or("cc"))
        .args(words)
        .args(["-std=c99", "-O2", "-shared", "-fPIC", "-fvisibility=hidden", "-o"])
        .args([&library, &source])
        .arg("-lm")
        .output()
        .map_err(|e| wrong(format!("the C compiler `{compiler}` cannot be run: {e}")))?;
    if !out.status.success() {
        let words = String::from_utf8_lossy(&out.stderr);
        let first = words.lines().find(|l| l.contains("error")).unwrap_or("it says nothing").to_string();
        return Err(wrong(format!("the C compiler `{compiler}` fails: {first}")));
    }
    std::fs::read(&library).map_err(|e| wrong(format!("the C compiler `{compiler}` left nothing: {e}")))
}

/// A variable of the description.
struct Variable {
    name: String,
    attributes: &'static str,
    /// Start and unit, derivative.
    real: String,
    meaning: Option<String>,
}

fn description(own: &Lowered<'_>, name: &str, code: &str) -> String {
    let guid = code.split("MODEL_GUID \"").nth(1).and_then(|c| c.split('"').next()).unwrap_or_default();
    let exchange = if is_smooth(own) {
        format!(
            "  <ModelExchange modelIdentifier=\"{name}\"><SourceFiles><File name=\"model.c\"/></SourceFiles></ModelExchange>\n"
        )
    } else {
        String::new()
    };
    let mut out = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription fmiVersion=\"2.0\" modelName=\"{}\" guid=\"{guid}\" \
         generationTool=\"gyrospec {}\" numberOfEventIndicators=\"0\">\n{exchange}  <CoSimulation modelIdentifier=\"{name}\" \
         canHandleVariableCommunicationStepSize=\"true\" canInterpolateInputs=\"true\"><SourceFiles><File \
         name=\"model.c\"/></SourceFiles></CoSimulation>\n",
        escaped(&own.model.name),
        env!("CARGO_PKG_VERSION"),
    );
    out.push_str(&units(own.model));
    let all = variables(own);
    out.push_str("  <ModelVariables>\n");
    for (at, v) in all.iter().enumerate() {
        let says = v.meaning.as_ref().map(|m| format!(" description=\"{}\"", escaped(m))).unwrap_or_default();
        let _ = writeln!(
            out,
            "    <ScalarVariable name=\"{}\" valueReference=\"{at}\"{says} {}><Real{}/></ScalarVariable>",
            escaped(&v.name),
            v.attributes,
            v.real
        );
    }
    out.push_str("  </ModelVariables>\n");
    out.push_str(&structure(own, &all));
    out.push_str("</fmiModelDescription>\n");
    out
}

/// In the order of the value references.
fn variables(own: &Lowered<'_>) -> Vec<Variable> {
    let model = own.model;
    let unit = |u: &Unit| format!(" unit=\"{}\"", said::si(u));
    let bound = |name: &str, x: Option<f64>| x.map(|x| format!(" {name}=\"{x:?}\"")).unwrap_or_default();
    let mut all = Vec::new();
    for p in &model.parameters {
        let real = format!(
            "{}{}{} start=\"{:?}\"",
            unit(&p.unit),
            bound("min", p.min),
            bound("max", p.max),
            p.value
        );
        let attributes = "causality=\"parameter\" variability=\"fixed\"";
        all.push(Variable { name: p.name.clone(), attributes, real, meaning: p.meaning.clone() });
    }
    let mut state = |name: &str, initial: Initial, real: String, meaning: Option<String>| {
        let (attributes, start) = match initial {
            Initial::Number(x) => ("causality=\"local\" initial=\"exact\"", format!(" start=\"{x:?}\"")),
            Initial::Fit => ("causality=\"local\" initial=\"exact\"", " start=\"0.0\"".into()),
            Initial::Steady => ("causality=\"local\" initial=\"calculated\"", String::new()),
        };
        all.push(Variable { name: name.into(), attributes, real: real + &start, meaning });
    };
    for s in &model.states {
        state(&s.name, s.initial, unit(&s.unit), s.meaning.clone());
    }
    let lags = own.locals.iter().filter(|l| matches!(l.value, Value::Lag(..)));
    let lags: Vec<String> = lags.map(|l| l.name.clone()).collect();
    for name in &lags {
        state(name, Initial::Steady, String::new(), Some("follows a signal".into()));
    }
    let names = model.states.iter().map(|s| s.name.clone()).chain(lags);
    for (i, name) in names.enumerate() {
        let real = format!(" derivative=\"{}\"", model.parameters.len() + i + 1);
        all.push(Variable {
            name: format!("der({name})"),
            attributes: "causality=\"local\"",
            real,
            meaning: None,
        });
    }
    for i in &model.inputs {
        let real = unit(&i.unit) + " start=\"0.0\"";
        all.push(Variable {
            name: i.name.clone(),
            attributes: "causality=\"input\"",
            real,
            meaning: i.meaning.clone(),
        });
    }
    for o in &model.outputs {
        let is_taken = all.iter().any(|v| v.name == o.name);
        let name = if is_taken { format!("{}.output", o.name) } else { o.name.clone() };
        let attributes = "causality=\"output\" initial=\"calculated\"";
        all.push(Variable { name, attributes, real: unit(&o.unit), meaning: o.meaning.clone() });
    }
    all
}

/// The units by their powers of the base units.
fn units(model: &Model) -> String {
    let inputs = model.inputs.iter().map(|i| &i.unit);
    let parameters = model.parameters.iter().map(|p| &p.unit);
    let others = model.states.iter().map(|s| &s.unit).chain(model.outputs.iter().map(|o| &o.unit));
    let all: BTreeMap<String, &Unit> =
        inputs.chain(parameters).chain(others).map(|u| (said::si(u), u)).collect();
    let mut out = String::from("  <UnitDefinitions>\n");
    for (name, unit) in all {
        let powers = ["m", "kg", "s", "A", "K", "mol"].iter().zip(unit.dimension().powers());
        let mut base: String = powers
            .filter(|p| p.1 != 0.0 && p.1.fract() == 0.0)
            .map(|(b, p)| format!(" {b}=\"{p}\""))
            .collect();
        if name == "rad" || name.starts_with("rad/") {
            base.push_str(" rad=\"1\"");
        }
        let _ = writeln!(out, "    <Unit name=\"{}\"><BaseUnit{base}/></Unit>", escaped(&name));
    }
    out + "  </UnitDefinitions>\n"
}

fn structure(own: &Lowered<'_>, all: &[Variable]) -> String {
    let (n, parameters) = (own.states(), own.model.parameters.len());
    let unknowns = |at: &mut dyn Iterator<Item = usize>| {
        at.map(|i| format!("<Unknown index=\"{i}\"/>")).collect::<String>()
    };
    let outputs = all.len() - own.model.outputs.len() + 1..=all.len();
    let rates = parameters + n + 1..=parameters + 2 * n;
    let found = (1..=n).map(|i| parameters + i).filter(|i| all[i - 1].attributes.contains("calculated"));
    let mut initial: Vec<usize> = outputs.clone().chain(rates.clone()).chain(found).collect();
    initial.sort_unstable();
    let mut out = String::from("  <ModelStructure>\n");
    for (kind, list) in [
        ("Outputs", unknowns(&mut outputs.clone())),
        ("Derivatives", unknowns(&mut rates.clone())),
        ("InitialUnknowns", unknowns(&mut initial.into_iter())),
    ] {
        if !list.is_empty() {
            let _ = writeln!(out, "    <{kind}>{list}</{kind}>");
        }
    }
    out + "  </ModelStructure>\n"
}

fn escaped(text: &str) -> String {
    crate::text::one_line(text)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
