//! Every package that is built here has a licence that deny.toml allows.

use serde_json::Value;
use spdx::{Expression, Licensee, ParseMode};
use std::path::Path;
use std::process::Command;

/// The licences of deny.toml.
fn allowed() -> Vec<Licensee> {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("deny.toml")).unwrap();
    let deny: toml::Table = text.parse().unwrap();
    let names = deny["licenses"]["allow"].as_array().unwrap().iter();
    names.map(|name| Licensee::parse(name.as_str().unwrap()).unwrap()).collect()
}

fn is_allowed(licence: &str, allowed: &[Licensee]) -> bool {
    let expression = Expression::parse_mode(licence, ParseMode::LAX).unwrap();
    expression.evaluate(|asked| allowed.iter().any(|one| one.satisfies(asked)))
}

/// Name and licence of each package that is built for this system, from what Cargo has at hand.
fn packages() -> Vec<(String, String)> {
    let cargo = || Command::new(env!("CARGO"));
    let said = cargo().arg("-vV").output().unwrap();
    let version = String::from_utf8(said.stdout).unwrap();
    let host = version.lines().find_map(|l| l.strip_prefix("host: ")).unwrap();
    let mut command = cargo();
    command.args(["metadata", "--format-version", "1", "--offline", "--locked", "--filter-platform", host]);
    let said = command.current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    assert!(said.status.success(), "{}", String::from_utf8_lossy(&said.stderr));
    let metadata: Value = serde_json::from_slice(&said.stdout).unwrap();
    let text = |value: &Value| value.as_str().unwrap_or("none").to_string();
    let packages = metadata["packages"].as_array().unwrap().iter();
    packages.map(|p| (text(&p["name"]), text(&p["license"]))).collect()
}

#[test]
fn every_package_that_is_built_has_an_allowed_licence() {
    let (allowed, packages) = (allowed(), packages());
    assert!(packages.len() > 100, "{}", packages.len());
    for (name, licence) in packages {
        assert!(is_allowed(&licence, &allowed), "{name}: {licence}");
    }
}

#[test]
fn what_is_not_allowed_is_seen() {
    let allowed = allowed();
    for licence in ["MIT/Apache-2.0", "GPL-3.0-only OR MIT", "(MIT OR GPL-2.0-only) AND Unicode-3.0"] {
        assert!(is_allowed(licence, &allowed), "{licence}");
    }
    for licence in
        ["GPL-3.0-only", "MPL-2.0", "MIT AND GPL-2.0-only", "Apache-2.0 WITH Classpath-exception-2.0"]
    {
        assert!(!is_allowed(licence, &allowed), "{licence}");
    }
}
