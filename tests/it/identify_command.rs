//! `gyrospec identify`: T and C₀ beside a search that shares no code with it, intervals that hold the truth as often as
//! they say, and what it refuses.

use approx::assert_relative_eq;
use gyrospec::gyro::{Gyrosphere, Trial, identify};
use serde_json::Value;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

fn called(words: &[&str]) -> (i32, String) {
    let out = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .arg("identify")
        .args(words)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&out.stdout) + String::from_utf8_lossy(&out.stderr);
    (out.status.code().unwrap(), said.into_owned())
}

fn number(of: &Value, at: &str) -> f64 {
    of.pointer(at).and_then(Value::as_f64).unwrap_or_else(|| panic!("{at} in {of}"))
}

/// Knuth's linear congruence, and a sum of twelve for a normal deviate.
struct Chance(u64);

impl Chance {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
    }
}

/// (2.4) of the paper's compass at 46.5°, rad: −P²(θ₀h)²p⁴ sin 2K/(4 g² H U C₀ cos φ (1 + p²T²)).
fn error(heading: f64, path: f64, p: f64, [lag, stiffness]: [f64; 2]) -> f64 {
    let (weight, momentum, g, earth) = (85.0, 15.5, 9.81, 7.3e-5);
    let north = 46.5f64.to_radians().cos();
    -(weight * path * p * p).powi(2) * (2.0 * heading).sin()
        / (4.0 * g * g * momentum * earth * stiffness * north * (1.0 + (p * lag).powi(2)))
}

/// Heading (degrees), path (cm) and period (s) of trial k.
fn trial(k: usize) -> (usize, usize, usize) {
    (30 + 45 * (k % 8), 20 + k % 7, 4 + k / 8)
}

fn example() -> String {
    let (mut chance, mut text) =
        (Chance(1), "heading [deg],amplitude [cm],period [s],error [deg]\n".to_owned());
    for k in 0..48 {
        let (heading, path, period) = trial(k);
        let p = std::f64::consts::TAU / period as f64;
        let truth = error((heading as f64).to_radians(), 0.01 * path as f64, p, [0.44, 1.35e5]);
        let _ =
            writeln!(text, "{heading},{path},{period},{:.3}", truth.to_degrees() + 0.02 * chance.normal());
    }
    text
}

#[test]
fn the_example_is_made_as_its_page_says() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/trials.csv");
    assert_eq!(std::fs::read_to_string(file).unwrap(), example());
}

#[test]
fn its_answer_is_that_of_a_search_over_the_lag() {
    let (code, said) = called(&["examples/trials.csv", "--latitude", "46.5", "--json"]);
    assert_eq!(code, 0, "{said}");
    let told: Value = serde_json::from_str(&said).unwrap();
    let rows: Vec<[f64; 4]> = example()
        .lines()
        .skip(1)
        .map(|l| {
            let n: Vec<f64> = l.split(',').map(|x| x.parse().unwrap()).collect();
            [n[0].to_radians(), 0.01 * n[1], std::f64::consts::TAU / n[2], n[3].to_radians()]
        })
        .collect();
    // 1/C₀ is linear for a given T: the squares that are left, and C₀
    let left = |lag: f64| -> (f64, f64) {
        let units: Vec<f64> = rows.iter().map(|r| error(r[0], r[1], r[2], [lag, 1.0])).collect();
        let give = units.iter().zip(&rows).map(|(u, r)| u * r[3]).sum::<f64>()
            / units.iter().map(|u| u * u).sum::<f64>();
        (units.iter().zip(&rows).map(|(u, r)| (r[3] - give * u).powi(2)).sum(), 1.0 / give)
    };
    // the golden section
    let (mut low, mut high, golden) = (0.0, 3.0, 0.5 * (5f64.sqrt() - 1.0));
    for _ in 0..100 {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        if left(a).0 < left(b).0 { high = b } else { low = a }
    }
    let lag = 0.5 * (low + high);
    assert_relative_eq!(number(&told, "/T_s/value"), lag, max_relative = 1e-5);
    assert_relative_eq!(number(&told, "/C0_N_per_m/value"), left(lag).1, max_relative = 1e-5);
    let residual = (left(lag).0 / 46.0).sqrt().to_degrees();
    assert_relative_eq!(number(&told, "/residual_deg"), residual, max_relative = 1e-6);
    assert!((0.012..0.03).contains(&residual));
    let row = &told["rows"][7];
    let (heading, path, period) = trial(7);
    let fitted = error(
        (heading as f64).to_radians(),
        0.01 * path as f64,
        std::f64::consts::TAU / period as f64,
        [lag, left(lag).1],
    );
    assert_relative_eq!(number(row, "/fitted_deg"), fitted.to_degrees(), max_relative = 1e-4);
    for (name, truth) in [("T_s", 0.44), ("C0_N_per_m", 1.35e5)] {
        assert!(
            number(&told, &format!("/{name}/low")) < truth && truth < number(&told, &format!("/{name}/high"))
        );
    }
}

#[test]
fn its_intervals_hold_the_truth_as_often_as_they_say() {
    let (mut chance, truth) = (Chance(7), [0.44, 1.35e5]);
    let sphere = Gyrosphere::seed();
    let mut held = [0, 0];
    for _ in 0..400 {
        let made = |k: usize| {
            let (heading, path, period) = trial(k);
            let (heading, amplitude) = ((heading as f64).to_radians(), 0.01 * path as f64);
            let frequency = std::f64::consts::TAU / period as f64;
            let error = error(heading, amplitude, frequency, truth) + 3.5e-4 * chance.normal();
            Trial { heading, amplitude, frequency, latitude: sphere.latitude, error }
        };
        let trials: Vec<Trial> = (0..48).map(made).collect();
        let found = identify(&trials, &sphere).unwrap();
        for (count, (i, truth)) in held.iter_mut().zip([(found.lag, truth[0]), (found.stiffness, truth[1])]) {
            *count += usize::from((i.low..=i.high).contains(&truth));
        }
    }
    // 380 ± 11 in 99 of 100 cases
    println!("of 400 intervals {held:?} hold the truth");
    assert!(held.iter().all(|h| (369..=391).contains(h)), "{held:?}");
}

#[test]
fn amplitudes_as_angles_frequencies_latitudes_and_gaps_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("t.csv");
    let mut text =
        "run [1],heading [deg],amplitude [deg],frequency [rad/s],latitude [deg],error [deg]\n".to_owned();
    for k in 0..24 {
        let (heading, p) = (f64::from((20 + 25 * k) % 360), 0.5 + 0.05 * f64::from(k));
        let at60 = 46.5f64.to_radians().cos() / 0.5;
        let e = error(f64::to_radians(heading), 2.5 * f64::to_radians(5.0), p, [0.6, 1e5]) * at60;
        let e = if k == 5 { String::new() } else { e.to_degrees().to_string() };
        let _ = writeln!(text, "{k},{heading},5,{p},60,{e}");
    }
    std::fs::write(&file, text).unwrap();
    let (code, said) = called(&[file.to_str().unwrap(), "--lever", "2.5m", "--json"]);
    assert_eq!(code, 0, "{said}");
    let told: Value =
        serde_json::from_str(&said[said.find('{').unwrap()..=said.rfind('}').unwrap()]).unwrap();
    assert_relative_eq!(number(&told, "/T_s/value"), 0.6, max_relative = 1e-6);
    assert_relative_eq!(number(&told, "/C0_N_per_m/value"), 1e5, max_relative = 1e-6);
    assert_eq!((number(&told, "/rows_left_out"), told["rows"].as_array().unwrap().len()), (1.0, 23));
    let (_, text) = called(&[file.to_str().unwrap(), "--lever", "2.5m"]);
    assert!(text.contains("1 row with gaps is left out") && text.contains("C0 = { value = "), "{text}");
}

#[test]
fn what_it_cannot_read_or_tell_is_refused_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("t.csv");
    let head = "heading [deg],amplitude [cm],period [s],error [deg]\n45,25,5,-0.5\n";
    let on = |text: &str, words: &[&str]| {
        std::fs::write(&file, text).unwrap();
        called(&[&[file.to_str().unwrap()], words].concat())
    };
    for (text, words, code, says) in [
        (format!("{head}60,25,x,-0.1\n"), &[][..], 2, "t.csv:3"),
        (format!("{head}60,25,7,-0.1\n60,25,0.1,-0.1\n"), &[], 2, "column `period`, row 3"),
        (format!("{head}60,25,-7,-0.1\n60,25,6,-0.1\n"), &[], 2, "column `period`, row 2"),
        (format!("{head}60,25,7,-95\n30,25,6,0\n"), &[], 2, "column `error`, row 2"),
        (head.replace("error", "fault") + "60,25,7,-0.1\n", &[], 2, "no column `error`"),
        (head.replace(" [s]", "") + "60,25,7,-0.1\n", &[], 2, "period"),
        (head.replace("[cm]", "[kg]") + "60,25,7,-0.1\n30,25,6,-0.1\n", &[], 2, "kg"),
        (
            head.replace("period [s]", "frequency [Hz]") + "60,25,7,-0.1\n30,25,6,-0.1\n",
            &[],
            2,
            "column `frequency`, row 1",
        ),
        (head.replace("period", "period [s],frequency") + "60,25,7,8,-0.1\n", &[], 2, "t.csv"),
        (format!("{head}60,25,7,-0.1\n"), &[], 2, "at least three trials"),
        (head.replace("[cm]", "[deg]") + "60,25,7,-0.1\n30,25,6,-0.1\n", &[], 2, "say --lever"),
        (format!("{head}60,25,5,-0.4\n30,25,5,-0.42\n15,20,5,-0.2\n"), &[], 3, "more than one frequency"),
        // as if without noise: they fit exactly, and tell nothing all the same
        (
            head.replace("45,25,5,-0.5", "45,23,6,-0.3") + "45,23,6,-0.3\n45,23,6,-0.3\n0,23,6,0\n",
            &[],
            3,
            "more than one frequency",
        ),
        (format!("{head}60,25,7,-0.1\n30,25,6,-0.2\n"), &["--lever", "2m"], 2, "--lever is of no use"),
        (head.replace("-0.5", "0.5") + "60,25,7,0.1\n30,25,6,0.2\n", &[], 3, "sign"),
        ("name = \"x\"\n[[tables]]\nfile = \"t.csv\"\n".into(), &[], 2, "t.csv"),
    ] {
        let (found, said) = on(&text, words);
        assert!(found == code && said.contains(says), "{text}{words:?}: {found} {said}");
    }
    let (code, said) = called(&["examples/trials.csv", "--compass", "gyrosphere-flow"]);
    assert!(code == 2 && said.contains("T and C0 are those of the lag"), "{said}");
    let (code, said) = called(&["no-such.csv"]);
    assert!(code == 2 && said.contains("no-such.csv"), "{said}");
}

#[test]
fn its_page_tells_the_numbers_and_draws_each_trial() {
    let page = || {
        std::process::Command::new(env!("CARGO_BIN_EXE_gyrospec"))
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .args(["identify", "examples/trials.csv", "--latitude", "46.5", "--html", "-"])
            .output()
            .unwrap()
    };
    let out = page();
    let html = String::from_utf8(out.stdout).unwrap();
    assert!(
        out.status.success() && html.starts_with("<!doctype html>") && html.contains("T is 0."),
        "{html}"
    );
    // a dot is a path without length
    assert_eq!(html.matches("h0").count(), 2 * 48, "each trial in each picture");
    assert!(html.contains("what (2.4) leaves") && !html.contains("<script "));
}
