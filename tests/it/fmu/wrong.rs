//! What bad units get: a message and an exit code, whatever they do.

use super::made::{DESCRIPTION, EXCHANGE, SIMULATION, archive, library, mass, place};
use std::path::Path;
use std::process::{Command, Output};

/// Runs the program in a folder on its `mass.fmu` and a recording there.
fn program(folder: &Path, seconds: &str) -> Output {
    let rows: String = (0..600).map(|i| format!("{},{},{}\n", 0.1 * f64::from(i), 1, 0)).collect();
    std::fs::write(folder.join("log.csv"), format!("t [s],force [N],position [m]\n{rows}")).unwrap();
    Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .args(["simulate", "mass.fmu", "log.csv", "--out", "out.csv"])
        .current_dir(folder)
        .env("GYROSPEC_FMU_SECONDS", seconds)
        .output()
        .unwrap()
}

/// The exit code and what it said; nothing was written.
fn refused(folder: &Path, seconds: &str) -> (Option<i32>, String) {
    let ran = program(folder, seconds);
    assert!(!folder.join("out.csv").exists(), "a file was written");
    (ran.status.code(), String::from_utf8(ran.stderr).unwrap())
}

#[test]
fn a_unit_that_works_simulates() {
    let folder = tempfile::tempdir().unwrap();
    if mass(folder.path(), EXCHANGE, "(void)0").is_some() {
        let ran = program(folder.path(), "20");
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
        assert!(folder.path().join("out.csv").exists());
    }
}

#[test]
fn a_crash_is_a_message() {
    for kind in [EXCHANGE, SIMULATION] {
        for (wrong, says) in [("*(volatile int*)0=1", "segmentation fault"), ("abort()", "abort")] {
            let folder = tempfile::tempdir().unwrap();
            if mass(folder.path(), kind, wrong).is_none() {
                return;
            }
            let (code, said) = refused(folder.path(), "20");
            assert!(code == Some(3) && said.contains(says), "{code:?}: {said}");
        }
    }
}

#[test]
fn a_call_that_never_returns_is_ended() {
    let folder = tempfile::tempdir().unwrap();
    if mass(folder.path(), SIMULATION, "for(;;)").is_some() {
        let (code, said) = refused(folder.path(), "2");
        assert!(code == Some(3) && said.contains("does not return"), "{code:?}: {said}");
    }
}

#[test]
fn a_call_that_is_refused_says_which() {
    for kind in [EXCHANGE, SIMULATION] {
        let folder = tempfile::tempdir().unwrap();
        if mass(folder.path(), kind, "return 3").is_none() {
            return;
        }
        let (code, said) = refused(folder.path(), "20");
        assert!(code == Some(3) && said.contains("gave error"), "{code:?}: {said}");
    }
}

#[test]
fn damaged_archives_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let Some(library) = library(folder, "(void)0") else { return };
    let description = DESCRIPTION.replace("KINDS", EXCHANGE);
    let (text, path) = (description.as_bytes(), folder.join("mass.fmu"));
    let place = place();
    let whole: [(&str, &[u8]); 2] = [("modelDescription.xml", text), (&place, &library)];
    archive(&path, &whole);
    let bytes = std::fs::read(&path).unwrap();
    let expect = |says: &str| {
        let (code, said) = refused(folder, "20");
        assert!(
            code == Some(2) && said.contains(says) && said.contains("mass.fmu"),
            "{says}: {code:?}: {said}"
        );
    };
    std::fs::write(&path, &bytes[..bytes.len() / 2]).unwrap();
    expect("no archive");
    let mut spoiled = bytes.clone();
    spoiled[300..900].fill(0x55);
    std::fs::write(&path, spoiled).unwrap();
    expect("archive");
    archive(&path, &[whole[0], ("../outside.txt", b"x")]);
    expect("outside");
    assert!(!folder.parent().unwrap().join("outside.txt").exists());
    archive(&path, &[whole[1]]);
    expect("modelDescription.xml");
    archive(&path, &[("modelDescription.xml", &text[..400]), whole[1]]);
    expect("no XML");
    archive(&path, &[whole[0], ("binaries/win64/mass.dll", &library)]);
    expect("win64");
    archive(&path, &[whole[0], (&place, b"no library")]);
    // the words of the loader, which differ by system
    expect(if cfg!(target_os = "linux") { "does not load: dlopen failed: " } else { "does not load: " });
    let with = |from: &str, to: &str| {
        let changed = description.replacen(from, to, 1);
        assert_ne!(changed, description);
        archive(&path, &[("modelDescription.xml", changed.as_bytes()), whole[1]]);
    };
    with("modelIdentifier=\"mass\"", "modelIdentifier=\"other\"");
    expect(&format!("names the library other.{}, and", place.rsplit('.').next().unwrap()));
    with("valueReference=\"2\"", "valueReference=\"two\"");
    expect("speed has the valueReference \"two\"");
    with("valueReference=\"2\" ", "");
    expect("speed has no valueReference");
    with("derivative=\"2\"", "");
    expect("index \"8\" as the rate of a state");
    let other = description.replace("fmiVersion=\"2.0\"", "fmiVersion=\"1.0\"");
    archive(&path, &[("modelDescription.xml", other.as_bytes()), whole[1]]);
    expect("1.0");
    for (from, to, says) in [
        ("guid=\"{mass}\"", "guid=\"{other}\"", "the guid {other} of modelDescription.xml is not its own"),
        ("valueReference=\"1\"", "valueReference=\"77\"", "fmi2GetReal gave error"),
    ] {
        let other = description.replacen(from, to, 1);
        archive(&path, &[("modelDescription.xml", other.as_bytes()), whole[1]]);
        let (code, said) = refused(folder, "20");
        assert!(code == Some(3) && said.contains(says) && said.contains("export"), "{said}");
    }
    // rates that the structure does not list: the states would never move
    let still = description.replace(RATES, "");
    archive(&path, &[("modelDescription.xml", still.as_bytes()), whole[1]]);
    expect("stand still");
}

const RATES: &str = r#"<Derivatives><Unknown index="7"/><Unknown index="8"/></Derivatives>"#;

#[test]
fn a_unit_that_lists_no_rates_but_steps_itself_does_so() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let Some(library) = library(folder, "(void)0") else { return };
    let mut runs = Vec::new();
    for rates in [RATES, ""] {
        let text = DESCRIPTION.replace("KINDS", &format!("{EXCHANGE}{SIMULATION}")).replace(RATES, rates);
        let entries: [(&str, &[u8]); 2] = [("modelDescription.xml", text.as_bytes()), (&place(), &library)];
        archive(&folder.join("mass.fmu"), &entries);
        let ran = program(folder, "20");
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
        let said = String::from_utf8_lossy(&ran.stderr).contains("lists no derivative of a state");
        assert_eq!(said, rates.is_empty());
        runs.push(std::fs::read_to_string(folder.join("out.csv")).unwrap());
        std::fs::remove_file(folder.join("out.csv")).unwrap();
    }
    let last = |text: &String| -> f64 {
        let row = text.lines().last().unwrap().split(',').collect::<Vec<_>>();
        row.iter().rev().find_map(|c| c.parse().ok()).unwrap()
    };
    // one by our steps, the other by its own: the spring under 1 N
    assert!((last(&runs[0]) - last(&runs[1])).abs() < 0.02 && last(&runs[0]).abs() > 0.01, "{runs:?}");
}
