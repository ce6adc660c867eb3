//! A channel that a model asks for and a table does not have under that name.

use gyrospec::model::Model;
use gyrospec::record::Recording;

const MODEL: &str = r#"
    name = "axis"
    [inputs]
    force = { unit = "N" }
    [parameters]
    b = { value = 3, unit = "N*s/m", fit = true, min = 0.1 }
    [states]
    q = { rate = "force/b", unit = "m", initial = "fit" }
    [outputs]
    position = { equals = "q", unit = "m" }
"#;

/// What a fit says of a table with this header, and the columns that it would take by its own lines.
fn said(header: &str) -> (String, Option<Recording>) {
    let folder = tempfile::tempdir().unwrap();
    let rows: String = (0..50).map(|i| format!("{},5;{i};{},5;{i},25\n", i, i * i % 7)).collect();
    std::fs::write(folder.path().join("export.csv"), format!("{header}\n{rows}")).unwrap();
    let recording = Recording::read(folder.path().join("export.csv")).unwrap();
    let model = Model::parse(MODEL).unwrap();
    let error = gyrospec::fit(&model, std::slice::from_ref(&recording)).run().map(|_| ()).expect_err(header);
    let lines = error.hint().unwrap().split_once("[[tables]]").map(|(_, lines)| format!("[[tables]]{lines}"));
    let meant = lines.map(|lines| {
        std::fs::write(folder.path().join("r.toml"), lines).unwrap();
        Recording::read(folder.path().join("r.toml")).unwrap()
    });
    (error.to_string(), meant)
}

#[test]
fn the_columns_that_are_meant_are_written_down() {
    for (header, force, position) in [
        ("Zeit [s];Kraft [N];Weg [mm];Druck [bar]", 0, 1),
        ("Zeit [s];Force (N);Position_m;n [1/s]", 0, 1),
        ("Zeit [s];Druck [bar];position [m];Forces [N]", 2, 1),
    ] {
        let (says, meant) = said(header);
        let meant = meant.unwrap_or_else(|| panic!("{says}"));
        assert!(says.contains("GUESS"), "{says}");
        // columns 2 to 4 begin with 0, 0.5 and 0.25
        let begins = [0.0, 0.5, 0.25];
        for (name, column) in [("force", force), ("position", position)] {
            let c = meant.channel(name).unwrap();
            assert_eq!(c.unit.from_si(c.values[0]), begins[column], "{name}: {says}");
        }
    }
    // without a unit it is the model's that is offered, and said so
    let (says, meant) = said("Zeit [s];force;position [m];n [1]");
    assert!(says.contains("it has no unit there") && meant.is_some(), "{says}");
    // two that fit alike, and none that does, are left to the reader
    let (says, meant) = said("Zeit [s];A [N];B [N];position [m]");
    assert!(meant.is_none() && says.contains("no channel `force`"), "{says}");
}

/// A column that carries the name of an output is not offered as an input, however near the name.
#[test]
fn an_output_is_not_taken_for_an_input() {
    let model = Model::parse(
        "name = \"through\"\n[inputs]\nvalue_input = { unit = \"1\" }\n[outputs]\nvalue_output = { equals = \"value_input\", unit = \"1\" }\n",
    )
    .unwrap();
    let folder = tempfile::tempdir().unwrap();
    let says = |header: &str| {
        let file = folder.path().join("a.csv");
        std::fs::write(&file, format!("t [s],{header}\n0,1,2\n1,2,3\n")).unwrap();
        let recording = Recording::read(&file).unwrap();
        gyrospec::simulate(&model, &recording).run().map(|_| ()).expect_err(header).to_string()
    };
    let none = says("value_output [1],other [m]");
    assert!(none.contains("no channel `value_input`") && !none.contains("GUESS"), "{none}");
    let one = says("value_output [1],value_inputs [1]");
    assert!(one.contains("column = \"value_inputs\"") && !one.contains("\"value_output\""), "{one}");
}
