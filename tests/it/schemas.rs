//! Every JSON output of the program against its schema in `docs/schemas`: none of its fields is missing,
//! misnamed or left out of the schema.

use crate::diagnose::{diagnosed, of_no_name, recording};
use gyrospec::diagnose::answer::Verdict;
use serde_json::{Map, Value};
use std::path::Path;
use std::process::Command;

fn schema(name: &str) -> Value {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/schemas");
    let text = std::fs::read_to_string(folder.join(format!("{name}.json"))).unwrap();
    serde_json::from_str(&text).unwrap()
}

/// Checks a value by the keywords of JSON Schema 2020-12 that the schemas here use; any other is an error.
fn check(schema: &Value, root: &Value, value: &Value, at: &str) -> Result<(), String> {
    let wrong = |what: &str| Err(format!("{at}: {what}: {value}"));
    for (keyword, wanted) in schema.as_object().unwrap() {
        match keyword.as_str() {
            "$ref" => {
                let place = wanted.as_str().unwrap().trim_start_matches('#');
                check(root.pointer(place).unwrap(), root, value, at)?;
            }
            "type" => {
                let kinds = wanted.as_array().cloned().unwrap_or_else(|| vec![wanted.clone()]);
                if !kinds.iter().any(|k| is_of(k.as_str().unwrap(), value)) {
                    return wrong(&format!("is no {wanted}"));
                }
            }
            "const" if value != wanted => return wrong("is another constant"),
            "enum" if !wanted.as_array().unwrap().contains(value) => return wrong("is none of the words"),
            "minimum" if value.as_f64() < wanted.as_f64() && value.is_number() => {
                return wrong("is too small");
            }
            "maximum" if value.as_f64() > wanted.as_f64() => return wrong("is too large"),
            "minItems" if value.as_array().is_some_and(|v| (v.len() as u64) < wanted.as_u64().unwrap()) => {
                return wrong("has too few items");
            }
            "maxItems" if value.as_array().is_some_and(|v| (v.len() as u64) > wanted.as_u64().unwrap()) => {
                return wrong("has too many items");
            }
            "const" | "enum" | "minimum" | "maximum" | "minItems" | "maxItems" | "$schema" | "$defs"
            | "title" | "description" | "properties" => {}
            "anyOf" => {
                let each = wanted.as_array().unwrap().iter();
                let failures: Vec<String> =
                    each.map(|s| check(s, root, value, at)).map_while(Result::err).collect();
                if failures.len() == wanted.as_array().unwrap().len() {
                    return Err(failures.join(" | "));
                }
            }
            "items" => {
                for (i, item) in value.as_array().into_iter().flatten().enumerate() {
                    check(wanted, root, item, &format!("{at}/{i}"))?;
                }
            }
            "required" => {
                let has = |name: &Value| value.get(name.as_str().unwrap()).is_some();
                if let Some(name) = wanted.as_array().unwrap().iter().find(|n| value.is_object() && !has(n)) {
                    return wrong(&format!("has no {name}"));
                }
            }
            "additionalProperties" => fields(schema, root, value, at)?,
            other => panic!("{at}: the test does not know the keyword {other}"),
        }
    }
    Ok(())
}

fn fields(schema: &Value, root: &Value, value: &Value, at: &str) -> Result<(), String> {
    for (name, field) in value.as_object().into_iter().flatten() {
        let own = schema.get("properties").and_then(|p| p.get(name));
        match own.unwrap_or(&schema["additionalProperties"]) {
            Value::Bool(false) => return Err(format!("{at}: {name} is not in the schema")),
            own => check(own, root, field, &format!("{at}/{name}"))?,
        }
    }
    Ok(())
}

fn is_of(kind: &str, value: &Value) -> bool {
    match kind {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        _ => panic!("{kind} is no type"),
    }
}

/// An output fits its schema, and no longer does where any of its fields has another name.
fn fits(name: &str, value: &Value) {
    let schema = schema(name);
    check(&schema, &schema, value, name).unwrap_or_else(|e| panic!("{e}"));
    let mut places = Vec::new();
    objects(value, "", &mut places);
    for (place, key) in places.into_iter().filter(|(place, _)| !place.ends_with("/powers")) {
        let mut other = value.clone();
        let object: &mut Map<String, Value> = other.pointer_mut(&place).unwrap().as_object_mut().unwrap();
        let field = object.remove(&key).unwrap();
        object.insert(format!("{key}_"), field);
        assert!(check(&schema, &schema, &other, name).is_err(), "{name}: {place}/{key} may be misnamed");
    }
}

/// All fields of all objects in a value; of each array the first few items stand for the rest.
fn objects(value: &Value, at: &str, found: &mut Vec<(String, String)>) {
    for (key, field) in value.as_object().into_iter().flatten() {
        found.push((at.to_string(), key.clone()));
        objects(field, &format!("{at}/{key}"), found);
    }
    for (i, item) in value.as_array().into_iter().flatten().take(3).enumerate() {
        objects(item, &format!("{at}/{i}"), found);
    }
}

/// Standard output of the program as JSON, whatever it ends with.
fn said(call: &[&str]) -> Value {
    let program = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(call)
        .output()
        .unwrap();
    let text = String::from_utf8(program.stdout).unwrap();
    serde_json::from_str(&text)
        .unwrap_or_else(|e| panic!("{call:?}: {e}: {text} {}", String::from_utf8_lossy(&program.stderr)))
}

#[test]
fn what_diagnose_writes_fits_its_schema() {
    fits(
        "diagnosis",
        &said(&["diagnose", "examples/clinometer.toml", "examples/clinometer.csv", "--json", "-"]),
    );
}

#[test]
fn a_diagnosis_fits_its_schema() {
    let (model, mut stuck) = recording(Some("1.5*sign(v)"));
    let position = &mut stuck.channels.iter_mut().find(|c| c.name == "position").unwrap().values;
    let held = position[500];
    position[500..650].fill(held);
    let named = diagnosed(&model, stuck.clone()).answer;
    assert_eq!((named.verdict, named.faults.len()), (Verdict::Named, 1));
    fits("diagnosis", &serde_json::to_value(&named).unwrap());
    let position = &mut stuck.channels.iter_mut().find(|c| c.name == "position").unwrap().values;
    position.fill(held);
    let still = diagnosed(&model, stuck).answer;
    assert_eq!(still.verdict, Verdict::DataFault);
    fits("diagnosis", &serde_json::to_value(&still).unwrap());
    let unknown = of_no_name();
    assert_eq!(unknown.verdict, Verdict::Unknown);
    fits("diagnosis", &serde_json::to_value(unknown).unwrap());
    // a finding may come with evidence
    let mut told = serde_json::to_value(&named).unwrap();
    let evidence = serde_json::json!({"log_likelihood_ratio": 99.5, "degrees": 1, "p_value": 1e-9, "holdout_share": 1.0});
    told["findings"][0]["evidence"] = evidence;
    fits("diagnosis", &told);
}

#[test]
fn fits_and_recordings_fit_their_schemas() {
    fits("fit", &said(&["fit", "examples/clinometer.toml", "examples/clinometer.csv", "--json", "-"]));
    fits("recording", &said(&["record", "examples/clinometer.csv", "--json"]));
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("r.csv");
    let rows: String =
        (0..400).map(|i| format!("{},{}\n", i, if i == 200 { 90.0 } else { f64::from(i).sin() })).collect();
    std::fs::write(&file, format!("t [s],x [m]\n{rows}")).unwrap();
    let told = said(&["record", file.to_str().unwrap(), "--json"]);
    assert_eq!(told["channels"][0]["faults"][0]["code"], "outliers");
    fits("recording", &told);
}

#[test]
fn integrals_and_tables_fit_their_schemas() {
    let answer = |h: &str, g: &str| said(&["integral", "--h", h, "--g", g, "--json", "--check"]);
    for (status, h, g) in [
        ("ok", "1 2 3", "0 1"),
        ("unstable", "1 -0.2 1", "0 1"),
        ("imaginary-axis", "1 0 1", "0 1"),
        ("out-of-range", "1e-200 1e-200", "1e300"),
        ("bad-input", "0 1", "1"),
    ] {
        let told = answer(h, g);
        assert_eq!(told["status"], status);
        fits("integral", &told);
    }
    fits("table", &said(&["table", "--orders", "1..4", "--format", "json"]));
    fits("audit", &said(&["audit", "--seed", "--format", "json"]));
    fits("gimbal", &said(&["gimbal", "--json"]));
    let shaken =
        ["--angular", "x=0.1mrad,0,30Hz,0.1", "--linear", "y=2m/s^2,20,40Hz,0.1", "--square", "1e-6"];
    let rotor = ["--tuned-rotor", "z,6000rpm,60g*cm^2,1g*cm^2,1arcsec", "--latitude", "45"];
    let noise = ["--walk", "1e-6", "--align", "300s", "--latitude", "45"];
    fits("strapdown", &said(&[&["strapdown", "--json"], &shaken[..], &rotor].concat()));
    fits("strapdown", &said(&[&["strapdown", "--json"], &noise[..]].concat()));
    let ship = ["--speed", "12kn", "--corrector", "40,10kn", "--manoeuvres", "5kn,10min"];
    fits("pendulous", &said(&["pendulous", "--latitude", "50", "--json"]));
    fits("pendulous", &said(&[&["pendulous", "--latitude", "50", "--json"], &ship[..]].concat()));
    let values = "m=1, r=1, c=1, N=1";
    let call = ["formula", "--h", "m*s^2 + r*s + c", "--g", "N", "--values", values, "--format", "json"];
    fits("formula", &said(&call));
    fits("formula", &said(&["formula", "--seed", "--format", "json"]));
}

#[test]
fn rolling_errors_fit_their_schemas() {
    for call in [
        &["roll-error", "--json"][..],
        &["roll-error", "--json", "--against", "latitude"],
        &["roll-error", "--json", "examples/roll.csv"],
        &["roll-error", "--json", "--inertia"],
        &["roll-error", "--json", "--free-play", "0.1mm", "--band", "2.5rad/s", "--heading", "45"],
        &["roll-error", "--json", "--sea", "pm", "--against", "height"],
    ] {
        fits("roll-error", &said(call));
    }
    for motion in [&[][..], &["--regular", "5deg,0.7"], &["--sea", "pm"]] {
        fits("roll-error-formula", &said(&[&["roll-error", "--formula", "--json"], motion].concat()));
    }
    fits("roll-error-spectrum", &said(&["roll-error", "--spectrum", "--json"]));
    fits("identified", &said(&["identify", "examples/trials.csv", "--json"]));
    fits("scorsby", &said(&["roll-error", "--scorsby", "--json"]));
    fits("deviation-card", &said(&["roll-error", "--sea=pm", "--card=2m,4m", "--json"]));
    fits("deviation-card", &said(&["roll-error", "--regular=5deg,9s", "--card=2deg", "--json"]));
}
