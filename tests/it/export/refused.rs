//! What cannot be exported, and the texts that nothing here can run.

use super::{EVERYTHING, SMOOTH, gyrospec};

fn folder(model: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.toml"), model).unwrap();
    folder
}

/// Exit code and standard error.
fn refused(folder: &std::path::Path, call: &[&str]) -> String {
    let out = gyrospec(folder, call);
    assert_eq!(out.status.code(), Some(2), "{call:?}: {}", String::from_utf8_lossy(&out.stdout));
    String::from_utf8(out.stderr).unwrap()
}

#[test]
fn what_has_no_equations_or_no_words_is_refused_with_a_reason() {
    let own = folder(SMOOTH);
    assert!(refused(own.path(), &["export", "model.toml", "--to", "fortran"]).contains("fortran"));
    assert!(refused(own.path(), &["export", "none.toml", "--to", "c"]).contains("none.toml"));
    // a memory that Modelica has no words for
    let all = folder(EVERYTHING);
    let words = refused(all.path(), &["export", "model.toml", "--to", "modelica", "--out", "model.mo"]);
    assert!(words.contains("backlash") && words.contains("modelica"), "{words}");
    assert!(!all.path().join("model.mo").exists());
    // an output in front of an input's name
    let words = refused(own.path(), &["export", "model.toml", "--to", "c", "--out", "model.toml"]);
    assert!(words.contains("model.toml"), "{words}");
    assert_eq!(std::fs::read_to_string(own.path().join("model.toml")).unwrap(), SMOOTH);
    let simulated = folder("name = \"s\"\nsimulated = \"s.csv\"\n[outputs]\ny = { unit = \"m\" }\n");
    std::fs::write(simulated.path().join("s.csv"), "t [s],y [m]\n0,1\n1,2\n").unwrap();
    assert!(refused(simulated.path(), &["export", "model.toml", "--to", "c"]).contains("no equations"));
}

#[test]
fn latex_writes_the_equations() {
    let out = gyrospec(folder(SMOOTH).path(), &["export", "gyrosphere", "--to", "latex"]);
    let text = String::from_utf8(out.stdout).unwrap();
    // Potemkin 1978, equation 1, as the digest has it
    for line in [
        "\\dot{x} &= \\frac{\\frac{P \\, W_{1}}{g \\, C_{0}} - x}{T}",
        "$C_{0}$ & $1.35 \\cdot 10^{8}$ & $\\mathrm{g/s^{2}}$ & stiffness of the sphere's centre of mass",
        "$\\beta$ & fitted at the start",
    ] {
        assert!(text.contains(line), "{line} is not in\n{text}");
    }
    let depth =
        |open: char, close: char| text.matches(open).count() as i64 - text.matches(close).count() as i64;
    assert_eq!((depth('{', '}'), text.matches("\\left").count()), (0, text.matches("\\right").count()));
}

#[test]
fn modelica_writes_a_class() {
    let own =
        folder(&SMOOTH.replace(
            "b = {",
            "lagging = { unit = \"m\", equals = \"lag(x, m/c) + delay(u/k, m/c)\" }\nb = {",
        ));
    let out = gyrospec(own.path(), &["export", "model.toml", "--to", "modelica"]);
    let text = String::from_utf8(out.stdout).unwrap();
    for line in [
        "model Smooth \"smooth\"",
        "  parameter Real k3(unit = \"N/m3\") = 12.0;",
        "  input Real u(unit = \"N\");",
        "  der(x) = 0;",
        "  lag_1 = x;",
        "  der(v) = (u - c*v - k*x - k3*x^3)/m;",
        "  der(lag_1) = (x - lag_1)/(m/c);",
        "  u_late_1 = delay(u, m/c);",
        "end Smooth;",
    ] {
        assert!(text.contains(line), "{line} is not in\n{text}");
    }
}

/// Names that are one without raised digits stay two.
#[test]
fn modelica_tells_outputs_apart() {
    let two = SMOOTH.replace(
        "[outputs]\n",
        "[outputs]\n\"q²\" = { unit = \"m\", equals = \"x\" }\nq2 = { unit = \"m\", equals = \"x\" }\n",
    );
    assert_ne!(two, SMOOTH);
    let out = gyrospec(folder(&two).path(), &["export", "model.toml", "--to", "modelica"]);
    let text = String::from_utf8(out.stdout).unwrap();
    assert!(["  q2 = x;", "  q2_out = x;"].iter().all(|line| text.contains(line)), "{text}");
}
