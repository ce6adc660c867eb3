//! The deviation card: each cell against the plain table, against (2.4) in plain arithmetic, and what is said on it.

use crate::roll_error::{asked, command};
use approx::assert_relative_eq;
use serde_json::Value;

/// The numbers of a CSV, without its header; empty cells are NaN.
fn numbers(csv: &str) -> Vec<Vec<f64>> {
    let cell = |c: &str| if c.is_empty() { f64::NAN } else { c.parse().unwrap() };
    csv.lines().skip(1).map(|l| l.split(',').map(cell).collect()).collect()
}

fn csv(options: &str) -> (String, Vec<Vec<f64>>) {
    let words: Vec<&str> = options.split(' ').chain(["--csv", "-"]).collect();
    let (code, out, message) = asked(&words);
    assert_eq!(code, 0, "{options}: {message}");
    (out.lines().next().unwrap().to_owned(), numbers(&out))
}

/// Mean and spread of the plain table on one heading.
fn plain(options: &str, heading: f64) -> [f64; 2] {
    let at = heading.to_string();
    let words: Vec<&str> = options.split(' ').chain(["--heading", &at, "--json"]).collect();
    let (code, out, message) = asked(&words);
    assert_eq!(code, 0, "{options}: {message}");
    let value: Value = serde_json::from_str(&out).unwrap();
    ["mean_deg", "spread_deg"].map(|name| value["rows"][0][name].as_f64().unwrap())
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn each_cell_is_that_of_the_plain_table() {
    for (motion, card, sizes) in [
        ("--sea pm --latitude 50", "--card 2m,5m", ["--height 2m", "--height 5m"]),
        (
            "--sea jonswap --period 10s --sea-from 60 --also pitch --speed 12kn",
            "--card 1m,3m",
            ["--height 1m", "--height 3m"],
        ),
        (
            "--inertia --band 2.5",
            "--card 2deg,5deg --irregular 5deg,0.1,0.8",
            ["--irregular 2deg,0.1,0.8", "--irregular 5deg,0.1,0.8"],
        ),
        ("--lever 10m", "--card 5deg --regular 2deg,8s", ["--regular 2deg,8s", "--regular 5deg,8s"]),
    ] {
        let (header, rows) = csv(&format!("{motion} {card}"));
        assert_eq!((rows.len(), rows[0].len()), (24, 5), "{header}");
        for row in rows.iter().step_by(7) {
            for (column, size) in sizes.iter().enumerate() {
                let [mean, spread] = plain(&format!("{motion} {size}"), row[0]);
                // the square root of a variance and back costs a digit or two
                assert_relative_eq!(row[1 + 2 * column], mean, max_relative = 1e-12, epsilon = 1e-15);
                assert_relative_eq!(row[2 + 2 * column], spread, max_relative = 1e-12);
            }
        }
    }
}

#[test]
fn regular_roll_has_the_papers_figures() {
    let (_, rows) =
        csv("--regular 3deg,0.98 --latitude 46.5 --card 6deg --heading 200 --heading 20 --heading 290");
    // (2.4) with the paper's numbers, h = 3 m, in CGS
    let (p, big_p, h, c0, t, lever) =
        (0.98f64, 8.5e6f64, 1.55e8, 13.5e7, 0.44f64, gyrospec::Gyrosphere::seed().lever * 100.0);
    let g = gyrospec::Gyrosphere::seed().gravity * 100.0;
    let u = gyrospec::Gyrosphere::seed().earth_rate;
    for row in rows {
        for (column, amplitude) in [(1, 3f64), (3, 6.0)] {
            let theta = amplitude.to_radians();
            let alpha = -1.0 / (c0 * (1.0 + p * p * t * t)) * big_p * big_p
                / (4.0 * h * u * 46.5f64.to_radians().cos())
                * theta.powi(2)
                * lever
                * lever
                * p.powi(4)
                / (g * g)
                * (2.0 * row[0].to_radians()).sin();
            assert_relative_eq!(row[column], alpha.to_degrees(), max_relative = 1e-6);
        }
    }
}

#[test]
fn a_recorded_roll_is_one_column_with_the_mean_to_trust() {
    let recording = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/roll.csv");
    let (_, rows) = csv(&format!("{recording} --heading 45 --heading 100 --card"));
    let (_, out, _) = asked(&[recording, "--heading", "45", "--heading", "100", "--json"]);
    let value: Value = serde_json::from_str(&out).unwrap();
    let name = value["trusted_mean"].as_str().unwrap();
    for (row, told) in rows.iter().zip(value["rows"].as_array().unwrap()) {
        assert_eq!(row.len(), 3);
        assert_relative_eq!(row[1], told[name].as_f64().unwrap(), max_relative = 1e-12);
    }
    let (code, _, message) = asked(&[recording, "--card", "2m"]);
    assert!(code == 2 && message.contains("one size"), "{message}");
}

#[test]
fn the_card_says_what_its_signs_mean_and_where_the_theory_ends() {
    let options = ["--sea", "jonswap", "--period", "7s", "--lever", "25m", "--card", "1m,3m,6m"];
    let (code, text, message) = asked(&options);
    assert_eq!(code, 0, "{message}");
    let (code, page, _) = asked(&[&options[..], &["--html", "-"]].concat());
    assert_eq!(code, 0);
    for out in [&text, &page] {
        assert!(out.contains("reads high (its north lies west): true heading = reading − figure"), "{out}");
        assert!(out.contains("reads low (its north lies east)"), "{out}");
        assert!(out.contains("–  beyond the linear theory: no figure") && out.contains(" *"), "{out}");
        assert!(out.contains("from 090° off the bow") && out.contains("25 m above the roll axis"), "{out}");
    }
    // the text shows the figures of the CSV, rounded, and no figure where it has none
    let (header, rows) = csv(&options.join(" "));
    assert!(header.contains("(+ reads high; a guide at best) [deg]"), "{header}");
    assert!(rows.iter().any(|r| r[5].is_nan()) && rows.iter().any(|r| r[5].is_finite()));
    for row in rows {
        let line = text.lines().find(|l| l.trim_start().starts_with(&format!("{:03}°", row[0]))).unwrap();
        for pair in row[1..].chunks(2).filter(|p| p[0].is_finite() && p[0].abs() > 0.005) {
            let sign = if pair[0] < 0.0 { "−" } else { "+" };
            let told = format!("{sign}{:.2} ±{:.2}", pair[0].abs(), pair[1]);
            assert!(line.contains(&told), "{told}: {line}");
        }
    }
    // all of it beyond: a card without figures, and no panic
    let (code, text, message) = asked(&["--sea", "pm", "--lever", "150m", "--card", "8m", "--heading", "45"]);
    assert!(code == 0 && text.contains("045°                –"), "{text}{message}");
}

#[test]
fn what_no_card_is_made_of_is_refused_with_what_to_say() {
    for (options, says) in [
        ("--card 1m", "m where rad is meant"),
        ("--sea pm --card 1deg", "deg where m is meant"),
        ("--sea pm --card 1m,,2m", "no quantity"),
        ("--sea pm --card ship.csv", "files stand before it"),
        ("--sea pm --card 1,2,3,4,5,6,7,8,9", "1 to 8 columns, not 9"),
        ("--sea pm --card 300m", "lies outside"),
        ("--card --against latitude", "cannot be used with"),
        ("--card --simulate 2", "cannot be used with"),
        ("--card --scorsby", "cannot be used with"),
        ("--card --svg x.svg", "cannot be used with"),
        ("--csv x.csv", "--card"),
        ("--csv x.csv --against latitude", "--card"),
        ("--sea pm --card --csv - --html -", "two results"),
    ] {
        let (code, out, message) = asked(&options.split(' ').collect::<Vec<_>>());
        assert!(code == 2 && out.is_empty() && message.contains(says), "{options}: {code} {message}");
    }
    // a part that is not linear asks for its band as the table does
    let (code, _, message) = asked(&["--friction", "2N", "--card", "--heading", "45"]);
    assert!(code == 2 && message.contains("--band"), "{message}");
    // a file's own roll stands among the sizes
    let file = "[parameters]\nA = { value = 16, unit = \"deg^2\" }\nmu = 0.1\neps = 0.8\n";
    let (code, out, message) = command("compass.toml", file, &["--heading", "45", "--card", "2deg"]);
    assert!(code == 0 && out.contains("2°               4°"), "{out}{message}");
}
