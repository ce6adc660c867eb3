//! Every example of every `--help` runs, and errors say where and what is near.

use crate::transcript::{play, typed, with_examples};
use gyrospec::units::Unit;
use std::path::Path;

/// Too long for a test.
const LONG: [&str; 1] = ["gyrospec laboratory"];

/// The files that the examples speak of.
fn prepare(folder: &Path) {
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    let example = |name: &str| std::fs::read_to_string(folder.join("examples").join(name)).unwrap();
    write("model.toml", &example("clinometer.toml"));
    let log: Vec<String> = example("clinometer.csv").lines().take(1051).map(str::to_string).collect();
    write("log.csv", &(log.join("\n") + "\n"));
    write("ship.csv", &(format!("time_s,roll_deg,clino_deg\n{}\n", log[1..700].join("\n"))));
    for (name, rows) in [("log", "0, 698"), ("day1", "0, 349"), ("day2", "350, 698"), ("day3", "700, 1049")] {
        let table = format!(
            "[[tables]]\nfile = \"log.csv\"\ntime = {{ column = \"time\", unit = \"s\" }}\nrows = [{rows}]\n"
        );
        write(&format!("{name}.toml"), &table);
    }
    write("compass.toml", "[parameters]\nh = { value = 3.0, unit = \"m\" }\n");
    write("trials.csv", &example("trials.csv"));
    write("cases.jsonl", "{\"h\":[1,2,3],\"g\":[0,1]}\n{\"h\":[1,1],\"c\":[1]}\n");
    let request = [
        "first = \"1/(T*s + 1)\"",
        "shaping = \"1/(s^2 + 2*mu*s + b^2)\"",
        "relations = [\"b^2 = mu^2 + eps^2\"]",
    ];
    write("request.toml", &request.join("\n"));
    write("ship.nmea", "2018-12-06T00:00:00Z $HEHDT,092.34,T*13\n2018-12-06T00:00:01Z $HEHDT,092.34,T*13\n");
}

/// The examples that a help text gives.
fn examples(help: &str) -> Vec<String> {
    let lines = help.lines().skip_while(|l| !l.starts_with("Examples:"));
    lines.filter_map(|l| l.strip_prefix("  gyrospec ")).map(|l| format!("gyrospec {l}")).collect()
}

fn subcommands(folder: &Path) -> Vec<String> {
    let help = typed("gyrospec --help", folder).1;
    let lines = help.lines().skip_while(|l| !l.starts_with("Commands:")).skip(1);
    let names = lines.take_while(|l| !l.is_empty()).filter_map(|l| l.split_whitespace().next());
    names.filter(|n| *n != "help" && *n != "about").map(str::to_string).collect()
}

#[test]
fn the_page_of_units_tells_each_that_is_read() {
    let (code, page) = typed("gyrospec explain units", &std::env::temp_dir());
    assert_eq!(code, 0);
    let rows: Vec<Vec<&str>> = page
        .lines()
        .skip_while(|l| !l.starts_with("  name"))
        .skip(1)
        .take_while(|l| !l.is_empty())
        .map(|l| l.split_whitespace().collect())
        .collect();
    // name, value, unit in SI where there is one, then the names with prefixes
    let mut names: Vec<&str> = Vec::new();
    for row in &rows {
        names.push(row[0]);
        let unit = Unit::parse(row[0]).unwrap();
        let value: f64 = row[1].parse().unwrap();
        assert!((unit.difference_to_si(1.0) / value - 1.0).abs() < 1e-3, "{row:?}");
        if let Some(si) = row.get(2).filter(|s| Unit::parse(s).is_ok()) {
            assert_eq!(Unit::parse(si).unwrap().dimension(), unit.dimension(), "{row:?}");
        }
        names.extend(row.iter().skip(3));
    }
    for name in names.iter().filter(|n| **n != "1") {
        Unit::parse(name).unwrap();
    }
    let fixed = "m cm mm kg g s ms min h N mN dyn Nm V mV A W Pa K Hz rad deg arcmin kn degC rpm bar mbar l kWh ohm nmi ft rev % d";
    assert!(fixed.split(' ').all(|n| names.contains(&n)), "{names:?}");
    assert!(
        ["°C", "Ω", "1/min", "turns or\nradians"]
            .iter()
            .all(|w| page.contains(w) || page.contains(&w.replace('\n', " "))),
        "{page}"
    );
}

#[test]
fn every_example_of_the_help_runs() {
    if cfg!(windows) {
        crate::skipped::skipped(format_args!(
            "the examples are written for a shell that this system does not have"
        ));
        return;
    }
    let folder = with_examples();
    prepare(folder.path());
    let commands = subcommands(folder.path());
    assert!(commands.len() > 14, "{commands:?}");
    for name in commands {
        let help = typed(&format!("gyrospec {name} --help"), folder.path()).1;
        let examples = examples(&help);
        assert!(!examples.is_empty(), "{name} gives no example:\n{help}");
        for example in examples.iter().filter(|e| !LONG.iter().any(|l| e.starts_with(l))) {
            let (code, said) = typed(example, folder.path());
            assert!((0..=1).contains(&code) && !said.contains("error:"), "{example}\n{code}: {said}");
        }
    }
}

#[test]
fn answers_and_refusals_are_as_shown() {
    play("tests/cmd/answers.md");
}

/// What the program says of a model or recording in which one thing is wrong.
fn complaint(from: &str, wrong: (&str, &str), command: &str) -> String {
    let folder = with_examples();
    let file = folder.path().join("examples").join(from);
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(text.contains(wrong.0), "{from} has no {}", wrong.0);
    std::fs::write(&file, text.replacen(wrong.0, wrong.1, 1)).unwrap();
    let (code, said) = typed(command, &folder.path().join("examples"));
    assert_eq!(code, 2, "{said}");
    said
}

#[test]
fn an_error_of_a_model_shows_its_place_and_the_nearest_name() {
    let said = |wrong| complaint("clinometer.toml", wrong, "gyrospec fit clinometer.toml clinometer.csv");
    let unit = said(("N*m*s\"", "N*m*sec\""));
    assert!(
        unit.contains("clinometer.toml:6:29:")
            && unit.contains("\n      ^^^\nhelp: the nearest known unit is s")
    );
    let function = said(("roll - a", "sni(roll) - a"));
    assert!(function.contains("\n      ^^^\nhelp: the nearest known function is sin"), "{function}");
    let key = said(("fit = true", "fitt = true"));
    assert!(key.contains("fitt = true") && key.contains("^^^^\nhelp: the nearest known key is fit"), "{key}");
    let dimension = said(("d*w", "d*a"));
    assert!(dimension.contains("N*m*s, but what it is added to has N*m") && dimension.contains("^^^"));
}

#[test]
fn an_error_of_a_recording_shows_its_place() {
    let said = |wrong| complaint("clinometer.csv", wrong, "gyrospec fit clinometer.toml clinometer.csv");
    let text = said(("\n0.25,0.72", "\n0.25,abc"));
    assert!(
        text.contains("clinometer.csv:3:6:") && text.contains("\n  0.25,abc,0.106\n       ^^^"),
        "{text}"
    );
    let unit = said(("roll [deg]", "roll [dge]"));
    assert!(unit.contains("the nearest known unit is deg"), "{unit}");
    let channel = said(("needle", "nedle"));
    assert!(channel.contains("has no channel `needle`") && channel.contains("nedle"), "{channel}");
}
