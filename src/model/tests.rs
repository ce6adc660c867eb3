use super::*;
use crate::ErrorKind;

const AXIS: &str = r#"name = "axis"
[inputs]
force = { unit = "N" }
[parameters]
M  = { value = 90.0, unit = "kg", fit = true, min = 1.0, max = 1e3 }
Fv = { value = 200.0, unit = "N*s/m", fit = true }
[definitions]
drive = { equals = "force - loss", unit = "N" }
loss = { equals = "Fv*v", unit = "N" }
[states]
q = { rate = "v", unit = "mm", initial = "fit" }
v = { rate = "drive/M", unit = "m/s", initial = 0.5 }
[outputs]
position = { equals = "q", unit = "m" }
"#;

#[test]
fn reads_in_si_and_in_order() {
    let m = Model::parse(AXIS).unwrap();
    assert_eq!(m.parameters.iter().map(|p| p.name.as_str()).collect::<Vec<_>>(), ["M", "Fv"]);
    assert_eq!(m.states[0].initial, Initial::Fit);
    assert_eq!(m.states[1].initial, Initial::Number(0.5));
    assert_eq!((m.parameters[0].min, m.parameters[0].max), (Some(1.0), Some(1e3)));
    let order = m.definition_order().ok().unwrap();
    assert_eq!(order.iter().map(|d| d.name.as_str()).collect::<Vec<_>>(), ["loss", "drive"]);
}

#[test]
fn what_is_written_reads_back() {
    for (_, text) in BUILTIN {
        let m = Model::parse(text).unwrap();
        assert_eq!(Model::parse(&m.to_toml()).unwrap(), m);
    }
    let mut m = Model::parse(AXIS).unwrap();
    m.name = "quotes \" and \\ and \u{1b}".into();
    m.inputs[0].meaning = Some("drückt".into());
    assert_eq!(Model::parse(&m.to_toml()).unwrap(), m);
    m.name = "a title\nof two lines".into();
    assert_eq!(Model::parse(&m.to_toml()).unwrap().name, "a title of two lines");
}

#[test]
fn a_file_extends_a_builtin_field_by_field() {
    let text = "extends = \"gyrosphere\"\n[parameters]\nC0 = { value = 1.2e5, unit = \"kg/s^2\" }\nk = { value = 1, unit = \"1\" }\n";
    let m = Model::parse(text).unwrap();
    let base = Model::builtin("gyrosphere").unwrap();
    assert_eq!(m.parameters[0].value, 1.2e5);
    assert_eq!(m.parameters[0].max, base.parameters[0].max);
    assert_eq!(m.parameters.len(), base.parameters.len() + 1);
    let e = Model::parse("extends = \"gyrosfere\"").unwrap_err();
    assert!(e.hint().unwrap().contains("gyrosphere"), "{e}");
}

fn error_of(from: &str, to: &str) -> crate::Error {
    assert!(AXIS.contains(from), "{from}");
    Model::parse(&AXIS.replacen(from, to, 1)).unwrap_err()
}

#[test]
fn errors_point_into_the_file() {
    let cases = [
        ("\"drive/M\"", "\"drive/M + v\"", 12, 25, "m/s"),
        ("\"force - loss\"", "\"force - los\"", 8, 29, "loss"),
        ("unit = \"N\" }", "unt = \"N\" }", 3, 11, "unit"),
        ("[states]", "[stats]", 10, 2, "states"),
        ("\"Fv*v\"", "\"Fv*drive/force*v\"", 8, 21, "circle"),
        ("\"kg\"", "\"kgg\"", 5, 29, "kg"),
        ("value = 90.0", "value = \"90\"", 5, 16, "number"),
        ("min = 1.0", "min = 100", 5, 16, "bounds"),
        ("\"fit\" }", "\"fitt\" }", 11, 42, "steady"),
        ("\"Fv*v\"", "\"Fv*(v\"", 9, 23, "never closed"),
        (", initial = 0.5", "", 12, 5, "initial"),
    ];
    for (from, to, line, column, says) in cases {
        let e = error_of(from, to);
        assert_eq!((e.line(), e.column()), (Some(line), Some(column)), "{e}");
        assert!(e.to_string().contains(says), "{e}");
    }
    assert_eq!(error_of("\"drive/M\"", "\"drive\"").kind(), ErrorKind::Units);
}

#[test]
fn names_must_be_distinct_and_usable() {
    for (from, to) in [("loss =", "M ="), ("q =", "t ="), ("q =", "sin ="), ("q =", "\"a b\" =")] {
        let text = AXIS.replacen(from, to, 1).replacen("- loss", "- M*0", 1);
        assert!(Model::parse(&text).is_err(), "{to}");
    }
    assert!(Model::parse(&AXIS.replace("position =", "force =")).is_err());
    assert!(Model::parse("name = \"x\"").unwrap_err().to_string().contains("outputs"));
    assert!(Model::parse("name = ").is_err());
}
