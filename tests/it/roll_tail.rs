//! What of the rolling error a white tail counts for, and what of the theory it leaves unjudged.

use crate::roll_error::{asked, asked_json};
use approx::assert_relative_eq;
use gyrospec::spectrum::Roll;

/// The mean error on heading 45° of the paper's compass by a roll's frequencies from `low` to `high` rad/s,
/// degrees, by quadrature: ∫ S ω⁴ Re G(jω)/(1 + ω²/ω_c²)² dω/π with G from W₁ to x.
pub fn mean_by_quadrature(roll: &Roll, [low, high]: [f64; 2], band: f64, part: impl Fn(f64) -> f64) -> f64 {
    let s = gyrospec::gyro::Gyrosphere::seed();
    let count = 800_000;
    let d = (high / low).ln() / f64::from(count);
    let area: f64 = (0..count)
        .map(|k| {
            let w = low * ((f64::from(k) + 0.5) * d).exp();
            roll.density(w) * w.powi(4) * part(w) / (1.0 + (w / band).powi(2)).powi(2) * w * d
        })
        .sum();
    // W₁W₂ = −h²θ̈² sin K cos K
    let moment = -0.5 * s.lever * s.lever * area / std::f64::consts::PI;
    (s.weight / (s.gravity * s.momentum * s.earth_rate * s.latitude.cos()) * moment).to_degrees()
}

#[test]
fn the_share_of_the_tail_is_that_of_its_frequencies() {
    let s = gyrospec::gyro::Gyrosphere::seed();
    let (m, r, c) = (s.weight / s.gravity, s.lag * s.stiffness, s.stiffness);
    // Re m/(C₀ − mω² + jωr), and without inertia
    let inertia = |w: f64| m * (c - m * w * w) / ((c - m * w * w).powi(2) + (r * w).powi(2));
    let lag = |w: f64| m * c / (c * c + (r * w).powi(2));
    let example = "--irregular=0.17320508075688773rad,0.1,0.8";
    // the white tail of a slow and narrow roll, of a quick one, and a sine
    let (narrow, quick) = ("--irregular=1deg,0.001,5rad/s", "--irregular=1deg,0.3,3rad/s");
    let rolls = [(example, [0.1, 0.8]), (narrow, [0.001, 5.0]), (quick, [0.3, 3.0])];
    let parts: [(&str, &dyn Fn(f64) -> f64); 2] = [("--inertia", &inertia), ("--lever=3m", &lag)];
    let ends = [1e-3, 1e9];
    for ((option, part), (words, [mu, eps])) in parts.iter().flat_map(|p| rolls.map(|r| (*p, r))) {
        let told = asked_json(&[option, words]);
        let told = &told["white_tail"];
        let sigma: f64 = if words == example { 0.03f64.sqrt() } else { 1f64.to_radians() };
        let roll = Roll::new(sigma * sigma, mu, eps).unwrap();
        let whole = mean_by_quadrature(&roll, ends, f64::INFINITY, part);
        // far above the peak, wherever that is
        let from = told["above_rad_per_s"].as_f64().unwrap();
        assert!(from > 3.9 * eps && from < 4.5 * eps, "{words}: {from}");
        let mut wanted = Vec::new();
        for entry in told["means"].as_array().unwrap() {
            let above = entry["up_to_rad_per_s"]
                .as_f64()
                .map_or(0.0, |w| mean_by_quadrature(&roll, [w, ends[1]], f64::INFINITY, part));
            let said = entry["mean_deg"].as_f64().unwrap();
            wanted.push(whole - above);
            assert!((said - whole + above).abs() < 1e-4 * whole.abs(), "{option} {words} {entry} {wanted:?}");
        }
        assert!(wanted.len() > 3, "{wanted:?}");
        let largest = wanted.iter().fold(0.0f64, |a, b| a.max(b.abs()));
        let smallest = wanted.iter().fold(f64::INFINITY, |a, b| a.min(b.abs()));
        let share = told["share"].as_f64().unwrap();
        // between the frequencies told the mean with inertia passes its largest
        let near = if option == "--inertia" { 0.02 } else { 1e-3 };
        assert!((share - (1.0 - smallest / largest)).abs() < near, "{option} {words} {share} {wanted:?}");
    }
}

/// The figures in a sentence that stand before a word.
fn before(text: &str, word: &str) -> Vec<f64> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let ends = words.windows(2).filter(|w| w[1].starts_with(word));
    ends.filter_map(|w| w[0].trim_matches(|c: char| "(,°".contains(c)).parse().ok()).collect()
}

#[test]
fn a_share_of_the_tail_is_what_moving_the_band_changes() {
    let s = gyrospec::gyro::Gyrosphere::seed();
    let (m, r, c) = (s.weight / s.gravity, s.lag * s.stiffness, s.stiffness);
    let inertia = |w: f64| m * (c - m * w * w) / ((c - m * w * w).powi(2) + (r * w).powi(2));
    let words = ["--inertia", "--irregular=10deg,0.1,0.8"];
    let roll = Roll::new(10f64.to_radians().powi(2), 0.1, 0.8).unwrap();
    let told = asked_json(&words);
    let note = told["note"].as_str().unwrap();
    let whole = mean_by_quadrature(&roll, [1e-3, 1e9], f64::INFINITY, inertia);
    // sharp ends, ten to each factor of ten
    let ends = |from: f64| (0..60).map(move |k| from * 10f64.powf(0.1 * f64::from(k)));
    let upto = |w: f64| whole - mean_by_quadrature(&roll, [w, 1e9], f64::INFINITY, inertia);
    let span = |all: &[f64]| {
        let (low, high) = all.iter().fold((f64::MAX, 0.0f64), |(l, h), x| (l.min(x.abs()), h.max(x.abs())));
        1.0 - low / high
    };
    let means = told["white_tail"]["means"].as_array().unwrap();
    let mut shares = vec![told["white_tail"]["share"].as_f64().unwrap()];
    for entry in means.iter().filter(|m| m["up_to_rad_per_s"].is_f64()) {
        let from = entry["up_to_rad_per_s"].as_f64().unwrap();
        let all: Vec<f64> = ends(from).map(upto).chain([whole]).collect();
        let share = entry["share_above"].as_f64().unwrap();
        assert!((share - span(&all)).abs() < 5e-3, "{entry} {}", span(&all));
        shares.push(share);
    }
    // the text tells these figures, and what they are of
    let percents: Vec<f64> = shares.iter().map(|s| (100.0 * s).round()).collect();
    assert_eq!(before(note, "%"), percents, "{note}");
    // and the program's own band, whose end is soft, moved from 100 rad/s up
    let banded = |band: f64| {
        let told = asked_json(&[&words[..], &["--heading=45", "--band", &band.to_string()]].concat());
        told["rows"][0]["mean_deg"].as_f64().unwrap()
    };
    let unbanded = asked_json(&[&words[..], &["--heading=45"]].concat())["rows"][0]["mean_deg"].as_f64();
    let all: Vec<f64> = [100.0, 300.0, 1e3, 3e3, 1e4].into_iter().map(banded).chain(unbanded).collect();
    assert!((span(&all) - shares[3]).abs() < 0.02, "{all:?} {shares:?}");
}

#[test]
fn what_is_said_of_the_tail_is_what_it_counts_for() {
    let above = |told: &serde_json::Value, w: f64| -> f64 {
        let means = told["white_tail"]["means"].as_array().unwrap();
        means.iter().find(|m| m["up_to_rad_per_s"] == w).unwrap()["share_above"].as_f64().unwrap()
    };
    // by ∫ ω⁴ S/(1 + ω²T²): 7 % above 10 rad/s; with inertia half above 100
    let (lag, inertia) = (asked_json(&["--lever=3m"]), asked_json(&["--inertia"]));
    assert!((above(&lag, 10.0) - 0.07).abs() < 5e-3, "{lag}");
    assert!((above(&inertia, 100.0) - 0.49).abs() < 0.02, "{inertia}");
    for told in [&lag, &inertia] {
        let share = told["white_tail"]["share"].as_f64().unwrap();
        let note = told["note"].as_str().unwrap();
        assert!(note.contains("say --band") || note.contains("Say --band"), "{note}");
        assert!(note.contains(&format!("by up to {:.0} % of the largest", 100.0 * share)), "{note}");
        assert!(!note.contains("of the mean"), "{note}");
    }
    // a narrow roll and a sine hardly have a tail
    for (words, most) in [("--irregular=1deg,0.001,5rad/s", 2e-4), ("--irregular=10deg,1e-9,0.8", 1e-7)] {
        let told = asked_json(&[words]);
        assert!(told["white_tail"]["share"].as_f64().unwrap() < most, "{told}");
        let note = told["note"].as_str().unwrap();
        assert!(note.contains("less than 1 %") && !note.contains("Say --band"), "{note}");
    }
    // a band that is said, but where no ship moves
    let words = ["--inertia", "--irregular=10deg,0.1,0.8"];
    for (band, depends) in [("10000", true), ("1000", true), ("2.5", false)] {
        let told = asked_json(&[&words[..], &["--band", band]].concat());
        assert_eq!(told.get("white_tail").is_some(), depends, "{band}");
        assert_eq!(told["note"].as_str().unwrap().contains("depends on it"), depends, "{band}");
    }
    let mean =
        |band: &str| asked_json(&[&words[..], &["--band", band]].concat())["rows"][0]["mean_deg"].clone();
    assert!((mean("10000").as_f64().unwrap() / mean("1000").as_f64().unwrap() - 1.0).abs() > 0.1);
}

#[test]
fn an_acceleration_without_end_is_not_judged() {
    let of = |words: &[&str]| -> serde_json::Value {
        let told = asked_json(words);
        let said = told["note"].as_str().unwrap().contains("not held against gravity");
        let all = told["validity"].as_array().unwrap().clone();
        let found = all.into_iter().find(|v| v["figure"] == "acceleration").unwrap();
        assert_eq!(said, found["value"].is_null(), "{told}");
        found
    };
    let free = of(&["--irregular=8deg,0.06,0.65", "--lever=15m"]);
    assert!(free["value"].is_null() && free["holds"].is_null(), "{free}");
    let banded = of(&["--irregular=8deg,0.06,0.65", "--lever=15m", "--band=100"]);
    // ∫ ω⁴ S/(1 + ω²/ω_c²)² dω/π
    let (band, roll) = (100.0f64, Roll::new(8f64.to_radians().powi(2), 0.06, 0.65).unwrap());
    let d = 2e-5;
    let square: f64 = (0..1_000_000)
        .map(|k| {
            let w = 1e-3 * (f64::from(k) * d).exp();
            roll.density(w) * w.powi(4) / (1.0 + (w / band).powi(2)).powi(2) * w * d
        })
        .sum();
    let wanted = 15.0 * (square / std::f64::consts::PI).sqrt() / gyrospec::gyro::Gyrosphere::seed().gravity;
    assert_relative_eq!(banded["value"].as_f64().unwrap(), wanted, max_relative = 1e-3);
    assert_eq!(banded["holds"], wanted <= 0.3);
    // a sine has an end
    assert!(of(&["--regular=10deg,0.8"])["holds"] == true);
}

#[test]
fn the_closed_form_says_where_its_theory_ends() {
    let words = ["--formula", "--irregular=8deg,0.06,0.65", "--lever=15m", "--heading=10", "--heading=45"];
    let (code, text, _) = asked(&words);
    assert!(
        code == 0 && text.contains("BEYOND THE LINEAR THEORY") && text.contains("mean error -23.5°"),
        "{text}"
    );
    let told = asked_json(&words[..4]);
    assert_eq!(told["validity"][0]["holds"], false);
    assert_eq!(told["validity"], asked_json(&words[1..4])["validity"]);
    let (_, text, _) = asked(&["--formula"]);
    assert!(!text.contains("BEYOND"), "{text}");
    assert_eq!(asked_json(&["--formula"])["validity"][0]["holds"], true);
}

#[test]
fn every_part_tells_its_tail_and_a_band_leaves_none() {
    for option in ["--inertia", "--flow=4s,0.2", "--meridian=2e5,1", "--vertical=2e5,1"] {
        assert!(asked_json(&[option])["white_tail"]["share"].as_f64().unwrap() > 0.05, "{option}");
        let banded = asked_json(&[option, "--band", "2.5rad/s"]);
        assert!(banded.get("white_tail").is_none(), "{option}");
        assert!(!banded["note"].as_str().unwrap().contains("tail"), "{option}");
    }
    assert!(asked_json(&["--regular", "5deg,0.8"]).get("white_tail").is_none());
}
