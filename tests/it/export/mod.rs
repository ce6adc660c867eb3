//! `gyrospec export`: code in other languages, run without this program, against `simulate`.

mod mockup;
mod refused;

use crate::skipped::skipped;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Every function with a memory, a delay of an input and of a state, a curve, a surface, and names that no language takes.
const EVERYTHING: &str = r#"
name = "everything \" */ at once"
[inputs]
u = { unit = "m" }
[parameters]
m = { value = 2.0, unit = "kg" }
lambda = { value = 0.7, unit = "N*s/m", meaning = "damping */ of \"air\"" }
k = { value = 30.0, unit = "N/m" }
"Fµ" = { value = 1.5, unit = "N" }
double = { value = 0.13, unit = "s" }
fn = { value = 217, unit = "ms" }
gap = { value = 0.05, unit = "m" }
L = { value = 1, unit = "m" }
V = { value = 1, unit = "m/s" }
F = { value = 1, unit = "N" }
[definitions]
spring = { unit = "N", equals = "curve(x, -L, -F, 0*L, 0.2*F, L, 3*F)" }
[states]
x = { unit = "m", initial = 0.1, rate = "v" }
v = { unit = "m/s", initial = 0.0, rate = "(k*(delay(u, fn) - backlash(x, gap)) - lambda*v - Fµ*sign(v) - spring)/m" }
[outputs]
y = { unit = "m", equals = "lag(x, double) + hysteresis(x, gap)" }
z = { unit = "m", equals = "rate_limit(x, 0.5*V) + 0.1*L*relay(x, gap) + delay(x, fn) + L*step(v)" }
w = { unit = "N", equals = "surface(x, v, [-L, 0*L, L], [-V, V], [F, 2*F, 0*F, F, 4*F, -3*F])" }
"#;

/// Smooth laws and every function without a memory; it begins where it stands still.
const SMOOTH: &str = r#"
name = "smooth"
[inputs]
u = { unit = "N" }
[parameters]
m = { value = 2.0, unit = "kg" }
c = { value = 1.7, unit = "N*s/m" }
k = { value = 30.0, unit = "N/m" }
k3 = { value = 12.0, unit = "N/m^3" }
L = { value = 1, unit = "m" }
[states]
x = { unit = "m", initial = "steady", rate = "v" }
v = { unit = "m/s", initial = "steady", rate = "(u - c*v - k*x - k3*x^3)/m" }
[outputs]
a = { unit = "m", equals = "x" }
b = { unit = "1", equals = "sin(x/L) - -cos(2*x/L)^2*tan(x/L)/(1 - (x/L - 3))^-1 + tanh(x/L) + exp(-x/L) + ln(2 + x/L)" }
c_out = { unit = "1", equals = "sqrt(4 + x/L) + asin(x/L/5) + acos(x/L/5) + atan(x/L) + atan2(x, 2*L) + sinh(x/L)*cosh(x/L)" }
d = { unit = "1", equals = "abs(x/L) + min(x/L, 0.1) + max(x/L, 0.2) + clamp(x/L, -0.1, 0.3) + pi*(2 + x/L)^1.5" }
"#;

/// Two reaches of a river, which begin where they stand still; their laws have no slope at 0 and no value below.
const REACHES: &str = r#"
name = "reaches"
[inputs]
u = { unit = "m^3/s" }
[parameters]
q = { value = 2, unit = "m^3/s" }
Q = { value = 1.5, unit = "m^3/s" }
A = { value = 3, unit = "m^2" }
L = { value = 1, unit = "m" }
[definitions]
through = { equals = "Q*(h/L)^1.67", unit = "m^3/s" }
down = { equals = "Q*(g/L)^1.67", unit = "m^3/s" }
[states]
h = { unit = "m", initial = "steady", rate = "(q + u - through)/A" }
g = { unit = "m", initial = "steady", rate = "(through - down)/A" }
[outputs]
stage = { unit = "m", equals = "g" }
leaves = { unit = "m^3/s", equals = "down" }
"#;

/// Nothing that goes on in time.
const STATIC: &str = r#"
name = "static"
[inputs]
u = { unit = "m" }
[parameters]
late = { value = 0.215, unit = "s" }
gap = { value = 0.2, unit = "m" }
L = { value = 1, unit = "m" }
[outputs]
y = { unit = "m", equals = "2*delay(u, late) + u^2/L" }
s = { unit = "1", equals = "sign(u) + step(u - 0.1*L)" }
"#;

/// The call in the folder.
fn gyrospec(folder: &Path, call: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_gyrospec")).args(call).current_dir(folder).output().unwrap()
}

/// Two sines at uneven times, as `t,u`, with units where they are wanted.
fn table(unit: &str) -> String {
    let rows = (0..1001).map(|i| {
        let t = 0.02 * f64::from(i) + 0.004 * f64::from(i % 3);
        format!("{t},{}\n", 0.5 * (1.3 * t).sin() + 0.2 * (4.1 * t + 1.0).sin())
    });
    let header = if unit.is_empty() { "t,u\n".to_string() } else { format!("t [s],u [{unit}]\n") };
    header + &rows.collect::<String>()
}

/// Columns of a table by name, without units.
fn columns(text: &str) -> Vec<(String, Vec<f64>)> {
    let mut rows = text.lines();
    let names = rows.next().unwrap().split(',').map(|n| n.split(' ').next().unwrap().to_string());
    let mut all: Vec<(String, Vec<f64>)> = names.map(|n| (n, Vec::new())).collect();
    for row in rows {
        for (column, cell) in all.iter_mut().zip(row.split(',')) {
            column.1.push(cell.parse().unwrap_or(f64::NAN));
        }
    }
    all
}

/// The largest difference of each output, as a share of its spread.
fn differences(reference: &str, other: &str, outputs: &[&str]) -> Vec<f64> {
    let (reference, other) = (columns(reference), columns(other));
    let find = |all: &[(String, Vec<f64>)], name: &str| {
        all.iter().find(|c| c.0 == name).unwrap_or_else(|| panic!("no column {name}")).1.clone()
    };
    let difference = |name: &&str| {
        let (a, b) = (find(&reference, name), find(&other, name));
        assert_eq!(a.len(), b.len());
        let most = a.iter().copied().fold(f64::MIN, f64::max) - a.iter().copied().fold(f64::MAX, f64::min);
        a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, |m, d| if d.is_nan() { d } else { d.max(m) })
            / most
    };
    outputs.iter().map(difference).collect()
}

/// How a language is run: its compiler with the options, none where there is nothing to compile.
const LANGUAGES: [(&str, &str, &[&str]); 3] = [
    ("python", "model.py", &[]),
    (
        "c",
        "model.c",
        &[
            "cc",
            "-std=c99",
            "-Wall",
            "-Wextra",
            "-Wpedantic",
            "-Werror",
            "-O1",
            "-DMODEL_PROGRAM",
            "-o",
            "c.out",
            "model.c",
            "-lm",
        ],
    ),
    (
        "rust",
        "model.rs",
        &["rustc", "--edition=2021", "-Copt-level=1", "-Dwarnings", "-o", "rust.out", "model.rs"],
    ),
];

/// What the code in a language gives for the table; none where the machine has no such language.
fn ran(
    folder: &Path,
    (language, file, compiler): (&str, &str, &[&str]),
    arguments: &[&str],
) -> Option<String> {
    let out = gyrospec(folder, &["export", "model.toml", "--to", language, "--out", file]);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let mut program = if let [compiler, options @ ..] = compiler {
        let Ok(done) = Command::new(compiler).args(options).current_dir(folder).output() else {
            skipped(format!("no compiler `{compiler}`: export to {language}"));
            return None;
        };
        assert!(done.status.success(), "{language}: {}", String::from_utf8_lossy(&done.stderr));
        Command::new(folder.join(format!("{language}.out")))
    } else {
        let mut program = Command::new("python3");
        program.arg(folder.join(file));
        program
    };
    std::fs::write(folder.join("plain.csv"), table("")).unwrap();
    let input = std::fs::File::open(folder.join("plain.csv")).unwrap();
    let Ok(child) = program.args(arguments).stdin(input).stdout(Stdio::piped()).spawn() else {
        skipped(format!("nothing runs {language}: export to it"));
        return None;
    };
    let out = child.wait_with_output().unwrap();
    assert!(out.status.success(), "{language} {arguments:?}");
    Some(String::from_utf8(out.stdout).unwrap())
}

/// A model beside what `simulate` gives for it.
fn simulated(model: &str, unit: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.toml"), model).unwrap();
    std::fs::write(folder.path().join("in.csv"), table(unit)).unwrap();
    let out = gyrospec(
        folder.path(),
        &["simulate", "model.toml", "in.csv", "--out", "reference.csv", "--tolerance", "1e-8"],
    );
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let reference = std::fs::read_to_string(folder.path().join("reference.csv")).unwrap();
    (folder, reference)
}

fn agrees(model: &str, unit: &str, outputs: &[&str], substeps: &str, within: f64) {
    let (folder, reference) = simulated(model, unit);
    for language in LANGUAGES {
        let Some(other) = ran(folder.path(), language, &[substeps]) else { continue };
        for (name, d) in outputs.iter().zip(differences(&reference, &other, outputs)) {
            assert!(d < within, "{}: {name} is off by {d}", language.0);
        }
    }
}

#[test]
fn smooth_models_run_as_simulated() {
    agrees(SMOOTH, "N", &["a", "b", "c_out", "d"], "8", 1e-7);
}

#[test]
fn laws_of_powers_begin_steady_as_simulated() {
    agrees(REACHES, "m^3/s", &["stage", "leaves"], "8", 1e-7);
    let (_, reference) = simulated(REACHES, "m^3/s");
    // Q (g/L)^1.67 = q + u
    let stage = ((2.0 + 0.2 * 1f64.sin()) / 1.5f64).powf(1.0 / 1.67);
    let first = columns(&reference).into_iter().find(|c| c.0 == "stage").unwrap().1[0];
    assert!((first - stage).abs() < 1e-9, "{first} {stage}");
}

#[test]
fn models_without_states_run_as_simulated() {
    agrees(STATIC, "m", &["y", "s"], "1", 1e-12);
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn memories_delays_and_friction_run_as_simulated() {
    // backlash and friction have their events at the ends of steps: what is left falls with their number
    agrees(EVERYTHING, "m", &["y", "w"], "64", 3e-4);
    let (folder, reference) = simulated(EVERYTHING, "m");
    // a step jumps at an event: almost all samples lie beside it
    let Some(other) = ran(folder.path(), LANGUAGES[1], &["64"]) else { return };
    let column = |text: &str| columns(text).into_iter().find(|c| c.0 == "z").unwrap().1;
    let (a, b) = (column(&reference), column(&other));
    let apart = a.iter().zip(&b).filter(|(a, b)| (*a - *b).abs() > 2e-3).count();
    assert!(apart <= 3, "{apart} of {}", a.len());
}

#[test]
fn a_held_input_and_a_parameter_are_arguments_of_the_program() {
    let (folder, _) = simulated(SMOOTH, "N");
    let other = SMOOTH.replace("k = { value = 30.0", "k = { value = 45.0");
    std::fs::write(folder.path().join("model.toml"), other).unwrap();
    std::fs::write(
        folder.path().join("in.toml"),
        "[[tables]]\nfile = \"in.csv\"\ntime = { column = \"t\" }\nchannels.u = { column = \"u\", hold = \"previous\" }\n",
    )
    .unwrap();
    let out =
        gyrospec(folder.path(), &["simulate", "model.toml", "in.toml", "--out", "-", "--tolerance", "1e-9"]);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    std::fs::write(folder.path().join("model.toml"), SMOOTH).unwrap();
    for language in LANGUAGES {
        let Some(ran) = ran(folder.path(), language, &["8", "u", "k=45"]) else { continue };
        let d = differences(&String::from_utf8_lossy(&out.stdout), &ran, &["a"])[0];
        assert!(d < 1e-6, "{}: {d}", language.0);
    }
}

#[test]
fn programs_refuse_what_they_do_not_know() {
    let (folder, _) = simulated(SMOOTH, "N");
    for language in LANGUAGES {
        if ran(folder.path(), language, &["1"]).is_none() {
            continue;
        }
        let program = match language.0 {
            "python" => vec!["python3".to_string(), "model.py".into()],
            other => vec![folder.path().join(format!("{other}.out")).display().to_string()],
        };
        for (table, argument, wanted) in [
            ("t,u\n0,1\n1,2\n", "K=3", "K"),
            ("t,u\n0,1\n1,2\n", "-3", "-3"),
            ("t,v\n0,1\n1,2\n", "1", "no column u"),
            ("t,u\n1,1\n0,2\n", "1", "rise"),
            ("t,u\n0,1\n1,x\n", "1", "x"),
            ("", "1", ""),
        ] {
            let mut call = Command::new(&program[0]);
            call.args(&program[1..]).arg(argument).current_dir(folder.path());
            let mut child =
                call.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
            // a program that refuses its arguments may be gone before it reads
            let _ = std::io::Write::write_all(&mut child.stdin.take().unwrap(), table.as_bytes());
            let out = child.wait_with_output().unwrap();
            let words = String::from_utf8_lossy(&out.stderr);
            assert!(
                !out.status.success() && words.contains(wanted),
                "{} {argument} {table:?}: {words}",
                language.0
            );
        }
    }
}
