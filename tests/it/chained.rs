//! Definitions that use each other twice: written out, thirty of them are 10⁹ terms; shared, they are thirty.

use std::path::Path;
use std::process::{Command, Output};

/// M x' = u − d x, by way of so many definitions, the last of which is the first times a number.
fn model(count: usize, link: impl Fn(usize) -> String, rate: &str) -> String {
    let links: String =
        (1..=count).map(|k| format!("q{k} = {{ equals = \"{}\", unit = \"N/kg\" }}\n", link(k))).collect();
    format!(
        "name = \"chain\"\n[inputs]\nu = {{ unit = \"N\" }}\n[parameters]\n\
         M = {{ value = 2, unit = \"kg\", fit = true, min = 0.1 }}\n\
         d = {{ value = 1, unit = \"N*s/m\", fit = true }}\n\
         [definitions]\nq0 = {{ equals = \"(u - d*x)/M\", unit = \"N/kg\" }}\n{links}\
         [states]\nx = {{ rate = \"{rate}\", unit = \"m/s\", initial = 0 }}\n\
         [outputs]\nspeed = {{ equals = \"x\", unit = \"m/s\" }}\n"
    )
}

/// 1.8 x' = u − 0.9 x − 0.8 sign x, in steps of 1 ms over 10 s, every fiftieth kept.
fn recording() -> String {
    let (mut x, mut rows) = (0.0f64, String::from("t [s],u [N],speed [m/s]\n"));
    for i in 0..10_000 {
        let t = 1e-3 * f64::from(i);
        let u = 3.0 * (0.7 * t).sin() + 2.0 * (2.3 * t + 1.0).sin();
        if i % 50 == 0 {
            let e = 0.005 * (f64::from(i) * 12.9898).sin().fract();
            rows += &format!("{t},{u},{}\n", x + e);
        }
        x += 1e-3 * (u - 0.9 * x - 0.8 * (x / 1e-3).tanh()) / 1.8;
    }
    rows
}

fn run(folder: &Path, call: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_gyrospec")).args(call).current_dir(folder).output().unwrap()
}

fn through_every_command(model: &str) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("m.toml"), model).unwrap();
    std::fs::write(folder.path().join("r.csv"), recording()).unwrap();
    let simulated = run(folder.path(), &["simulate", "m.toml", "r.csv"]);
    assert_eq!(simulated.status.code(), Some(0), "{simulated:?}");
    let fitted = run(folder.path(), &["fit", "m.toml", "r.csv", "--model-out", "f.toml"]);
    assert_eq!(fitted.status.code(), Some(0), "{fitted:?}");
    let found = ["diagnose", "m.toml", "r.csv", "--json", "-", "--html", "d.html", "--model-out", "d.toml"];
    let found = run(folder.path(), &found);
    assert_eq!(found.status.code(), Some(1), "{found:?}");
    let told: serde_json::Value = serde_json::from_slice(&found.stdout).unwrap();
    assert_eq!(told["findings"][0]["code"], "dry-friction", "{told:#}");
    for written in ["f.toml", "d.toml"] {
        let again = run(folder.path(), &["simulate", written, "r.csv"]);
        assert_eq!(again.status.code(), Some(0), "{again:?}");
    }
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_chain_of_halves_costs_what_its_links_cost() {
    through_every_command(&model(30, |k| format!("(q{0} + q{0})/2", k - 1), "q30"));
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_chain_of_fibonacci_numbers_costs_what_its_links_cost() {
    let link = |k: usize| if k == 1 { "q0".to_string() } else { format!("q{} + q{}", k - 1, k - 2) };
    // the 41st Fibonacci number stands before the first link in the last one
    through_every_command(&model(40, link, "q40/165580141"));
}

#[test]
fn a_fault_behind_a_chain_is_told_where_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let chain = model(40, |k| format!("q{0} + q{0}", k - 1), "q40").replace("/M\"", "/(M*0)\"");
    let (head, links) = chain.split_once("q0 = ").unwrap();
    let (links, tail) = links.split_once("[states]").unwrap();
    // the last link first in the file
    let links = format!("q0 = {links}");
    let turned: Vec<&str> = links.lines().rev().collect();
    let text = format!("{head}{}\n[states]{tail}", turned.join("\n"));
    std::fs::write(folder.path().join("m.toml"), text).unwrap();
    std::fs::write(folder.path().join("r.csv"), recording()).unwrap();
    let refused = run(folder.path(), &["simulate", "m.toml", "r.csv"]);
    let told = String::from_utf8_lossy(&refused.stderr);
    assert_eq!(refused.status.code(), Some(3), "{told}");
    assert!(told.contains("this divides by M*0"), "{told}");
}
