//! What a navigator relies on: the side of an error, the sea's direction, ranges, and where the theory ends.

use approx::assert_relative_eq;
use gyrospec::gyro::{Axis, Gyrosphere, Instrument, Motion, SIGN, elastic::Lag, seed};
use gyrospec::lti::{StateSpace, TransferFunction};
use gyrospec::spectrum::{Hull, Roll};
use serde_json::Value;
use std::f64::consts::FRAC_PI_2;
use std::path::Path;
use std::process::Command;

fn called(words: &str, folder: &Path) -> (i32, String, String) {
    let out = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .args(words.split(' '))
        .current_dir(folder)
        .output()
        .unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (out.status.code().unwrap(), text(&out.stdout), text(&out.stderr))
}

fn json(words: &str) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let (code, text, message) = called(&format!("{words} --json"), folder.path());
    assert_eq!(code, 0, "{words}: {message}");
    serde_json::from_str(&text).unwrap()
}

fn mean(words: &str) -> f64 {
    json(words)["rows"][0]["mean_deg"].as_f64().unwrap()
}

/// a × b, east, north, up.
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[test]
fn a_positive_error_is_to_the_west() {
    let s = Gyrosphere::seed();
    let still = Motion::roll(&Roll::new(1e-8, 0.1, 0.8).unwrap());
    let mut compass = Instrument::new(s, Box::new(Lag));
    compass.speed = 10.0;
    let (speed, r) = (10.0, gyrospec::gyro::EARTH_RADIUS);
    let northward = compass.system(&still, 0.0).unwrap();
    // an axis fixed among the stars, pointing e to the east and u upwards, seen from the moving ground: n′ = −ω × n
    let (sin, cos) = s.latitude.sin_cos();
    let ground = [-speed / r, s.earth_rate * cos, s.earth_rate * sin];
    for (e, u) in [(0.0, 0.0), (1e-3, 0.0), (0.0, 1e-3)] {
        let seen = cross(ground, [e, 1.0, u]).map(|v| -v);
        let alpha = -e;
        // the rates of β without couples, as the program has them; α′ takes lP and C besides
        let beta_rate = northward.slow[(1, 0)] * alpha + northward.constant[1];
        assert_relative_eq!(beta_rate, seen[2], max_relative = 1e-9);
        if u == 0.0 {
            assert_relative_eq!(northward.constant[0], -seen[0], max_relative = 1e-9);
        }
    }
    // so a compass on a northward course reads high
    assert!(compass.sailing_error(0.0) > 0.0);
    // and on north-east the pendulum's mass, which lags to the south-east, turns it east
    let (sphere, roll, heading) = seed::example_3_1();
    assert!(seed::irregular_error(&sphere, &roll, heading).unwrap() < 0.0);
}

#[test]
fn every_output_says_which_side_an_error_is() {
    let folder = tempfile::tempdir().unwrap();
    let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ").replace("&#39;", "'");
    let said = |words: &str| called(words, folder.path()).1;
    for words in [
        "roll-error",
        "roll-error --heading 45",
        "roll-error --heading 45 --json",
        "roll-error --formula --json",
        "roll-error --html -",
        "roll-error --against latitude --html -",
        "roll-error --help",
    ] {
        assert!(plain(&said(words)).contains(SIGN), "{words}:\n{}", said(words));
    }
    let picture = said("roll-error --svg -");
    assert!(SIGN.split("; ").all(|part| picture.replace("&#39;", "'").contains(part)), "{picture}");
    assert!(
        said("roll-error --html -").contains("(east, reads low)")
            || said("roll-error --html -").contains("(west, reads high)")
    );
    for file in ["docs/symbols.md", "python/gyrospec/_api.py", "python/gyrospec/_results/_rolling.py"] {
        let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap();
        assert!(plain(&text).contains(SIGN), "{file}");
    }
}

#[test]
fn a_slope_acts_by_its_parts_on_roll_and_pitch() {
    // a ship that answers both parts alike moves as the waves do: only their bearing from north counts, K + ν
    let alike = TransferFunction::new(&[1.0, 0.0, 0.0], &[1.0, 0.5, 0.7]).unwrap();
    let waves = Roll::new(0.01, 0.1, 0.8).unwrap().shaping();
    let low = TransferFunction::new(&[1.0], &[0.5, 1.0]).unwrap();
    let one = StateSpace::from_transfer(&waves.then(&alike).then(&low).then(&low));
    let compass = Instrument::new(Gyrosphere::seed(), Box::new(Lag));
    let error = |heading: f64, from: f64| {
        let (athwart, along) = Hull::slopes(from);
        let parts = faer::Mat::from_fn(2, one.order(), |i, j| [athwart, along][i] * one.c[(0, j)]);
        let system = StateSpace::new(one.a.clone(), one.b.clone(), parts, faer::Mat::zeros(2, 1)).unwrap();
        let motion = Motion::new(system, &[Axis::Roll, Axis::Pitch]).unwrap();
        compass.rectified_error(&motion, heading.to_radians()).unwrap()
    };
    let wanted = error(70.0, 60f64.to_radians());
    assert!(wanted.abs() > 1e-6);
    for (heading, from) in [(10.0, 120.0), (100.0, 30.0), (170.0, -40.0), (-50.0, 180.0), (40.0, 90.0)] {
        assert_relative_eq!(error(heading, f64::to_radians(from)), wanted, max_relative = 1e-9);
    }
    let hull = Hull::default();
    assert!(hull.pitch_response(FRAC_PI_2).is_err() && hull.pitch_response(-FRAC_PI_2).is_err());
    assert!(hull.roll_response(0.0).is_err() && hull.roll_response(2.0 * FRAC_PI_2).is_err());
    // the slope along the ship falls as the cosine, but for what the waterplane averages out
    let slow = num_complex::Complex64::new(0.0, 1e-3);
    let ratio =
        hull.pitch_response(1.0).unwrap().at(slow).norm() / hull.pitch_response(0.0).unwrap().at(slow).norm();
    assert_relative_eq!(ratio, 1f64.cos(), max_relative = 1e-3);
}

/// The mean over a rectangle of the height of a plane wave of height 1 and number k, by a grid of midpoints.
fn averaged(k: f64, from: f64, length: f64, beam: f64) -> f64 {
    let (n, m) = (400, 100);
    let place = |i: usize, of: usize, size: f64| size * ((i as f64 + 0.5) / of as f64 - 0.5);
    let wave = |i, j| (k * (place(i, n, length) * from.cos() + place(j, m, beam) * from.sin())).cos();
    (0..n).map(|i| (0..m).map(|j| wave(i, j)).sum::<f64>()).sum::<f64>() / (n * m) as f64
}

#[test]
fn the_slope_averaged_over_a_hull_is_that_of_a_grid_of_points() {
    let hull = Hull { length: 70.0, beam: 12.0, ..Hull::default() };
    for from in [0.0f64, 30.0, 60.0, 80.0, 89.0, 90.0, 91.0, 100.0, 150.0, 270.0, 285.0] {
        let from = from.to_radians();
        let extent = (70.0 * from.cos()).hypot(12.0 * from.sin());
        for half in [0.1f64, 0.3, 0.6, 1.0] {
            let k = 2.0 * half / extent;
            let s = num_complex::Complex64::new(0.0, (9.81 * k).sqrt());
            let power = hull.heave_response(from).unwrap().at(s).norm_sqr();
            let direct = averaged(k, from, 70.0, 12.0).powi(2);
            // what is cut off begins with 2u⁶/189 of 1/S²; the grid is good to 1e-5
            let cut = 2.0 * half.powi(6) / 189.0;
            assert!((power - direct).abs() < 1.5 * cut + 2e-5, "{from} {half}: {power} {direct}");
        }
    }
}

#[test]
fn the_error_is_even_and_smooth_about_a_sea_from_abeam() {
    let at = |from: f64, more: &str| {
        mean(format!("roll-error --sea jonswap --sea-from {from} --heading 45 {more}").trim_end())
    };
    // waves of twice the peak's frequency and above hardly count: what they lose bounds what the mean loses
    let k = 4.0 * (std::f64::consts::TAU / 8.0).powi(2) / 9.81;
    let kept = |from: f64, length: f64| {
        (averaged(k, from.to_radians(), length, 15.0) * from.to_radians().sin()).powi(2)
    };
    for (more, length) in [("", 90.0), ("--ship-length 150m", 150.0)] {
        let abeam = at(90.0, more);
        let fall = |away: f64| 1.0 - at(90.0 + away, more) / abeam;
        let bound = |away: f64| 1.0 - kept(90.0 + away, length) / kept(90.0, length);
        assert!(fall(1.0) > 0.0 && fall(1.0) < bound(1.0), "{} {}", fall(1.0), bound(1.0));
        assert_relative_eq!(fall(1.0), fall(-1.0), max_relative = 1e-6);
        // second order: half the angle, a quarter of the fall
        assert_relative_eq!(fall(1.0) / fall(0.5), 4.0, max_relative = 0.02);
    }
    let told = called("roll-error --sea jonswap --heading 45", &std::env::temp_dir()).1;
    assert!(told.contains("a ship of 90 m (six beams) by 15 m"), "{told}");
    let told = called("roll-error --sea jonswap --ship-length 100m --heading 45", &std::env::temp_dir()).1;
    assert!(told.contains("a ship of 100 m by 15 m"), "{told}");
}

#[test]
fn a_sea_from_abeam_excites_no_pitch_and_heave_moves_no_mean() {
    let folder = tempfile::tempdir().unwrap();
    for (words, says) in [
        ("--sea pm --also pitch", "no slope along the ship"),
        ("--sea pm --sea-from -90 --also pitch", "no slope along the ship"),
        ("--sea pm --sea-from 180", "no slope athwart"),
        ("--sea pm --sea-from 0 --also heave", "no slope athwart"),
        ("--sea pm --sea-from 400", "lies outside"),
    ] {
        let (code, _, message) = called(&format!("roll-error {words}"), folder.path());
        assert!(code == 2 && message.contains(says), "{words}: {message}");
    }
    let (plain, heaving) =
        ("roll-error --sea jonswap --heading 45", "roll-error --sea jonswap --also heave --heading 45");
    assert_relative_eq!(mean(plain), mean(heaving), max_relative = 1e-9);
    assert!(json(heaving)["note"].as_str().unwrap().contains("rows of α and λ"));
    assert!(!json(plain)["note"].as_str().unwrap().contains("rows of α and λ"));
    let (rigid, soft) = ("roll-error --heading 45", "roll-error --heading 45 --vertical 1e4N/m,0.5s");
    assert_relative_eq!(mean(rigid), mean(soft), max_relative = 1e-9);
    assert!(json(soft)["note"].as_str().unwrap().contains("rows of α and λ"));
    // ahead, pitch alone is left, and it opposes what roll did
    assert!(mean("roll-error --sea jonswap --sea-from 0 --also pitch --heading 45") > 0.0);
}

#[test]
fn a_number_outside_its_range_is_refused_with_what_was_meant() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        std::fs::write(folder.path().join(name), format!("[parameters]\n{text}\n")).unwrap();
    };
    file("cgs.toml", "g = 981.0");
    file("lat.toml", "lat = 46.5");
    file("weight.toml", "P = { value = 8.5e6 }");
    file("eps.toml", "A = 0.01\nmu = 0.1\neps = { value = 800, unit = \"rad/s\" }");
    file("bodies.toml", "Ix1 = -1e-6");
    file("base.toml", "sigma = { value = 900, unit = \"rad/s\" }");
    for (words, says) in [
        ("roll-error --latitude 1000deg", "1000 deg lies outside -89.9 … 89.9 deg"),
        ("roll-error --latitude 90", "finds north"),
        ("roll-error --irregular 4,0.06,0.65", "4 rad (229.2 deg)"),
        ("roll-error --irregular 4,0.06,0.65", "did you mean 4deg?"),
        ("roll-error --irregular 4deg,0,0.65", "lies outside"),
        ("roll-error --irregular 4deg,0.06,650", "lies outside"),
        ("roll-error --irregular 4deg,0.06,0.1Hz", "turns or radians?"),
        ("roll-error --regular 30,0.7", "did you mean 30deg?"),
        ("roll-error --regular 5deg,0", "lies outside"),
        ("roll-error --lever 300", "did you mean 300cm?"),
        ("roll-error --speed 60", "did you mean 60kn?"),
        ("roll-error --heading 1000", "lies outside"),
        ("roll-error --sea pm --height 300m", "lies outside"),
        ("roll-error --sea jonswap --period 0", "lies outside"),
        ("roll-error --sea jonswap --gamma 30", "gamma"),
        ("roll-error --sea pm --ship 9s,80,0.7,15m", "lies outside"),
        ("roll-error --sea pm --ship 9s,0.08,0.7,1500m", "lies outside"),
        ("roll-error --band 0", "lies outside"),
        ("roll-error --flow 4s,1e6", "lies outside"),
        ("roll-error --meridian 0N/m,1s", "lies outside"),
        ("roll-error --friction 1e9N", "lies outside"),
        ("roll-error --free-play 3", "did you mean 3mm?"),
        ("roll-error cgs.toml", "did you mean 981cm/s^2?"),
        ("roll-error lat.toml", "did you mean 46.5deg?"),
        ("roll-error weight.toml", "did you mean 8.5e6dyn?"),
        ("roll-error eps.toml", "lies outside"),
        ("gimbal bodies.toml", "lies outside"),
        ("gimbal base.toml", "lies outside"),
        ("gimbal --corner 0", "no slow rate"),
    ] {
        let (code, _, message) = called(words, folder.path());
        assert!(code == 2 && message.contains(says), "{words}: {code} {message}");
    }
    // the library has the same ranges
    assert!(Gyrosphere { latitude: 1000f64.to_radians(), ..Gyrosphere::seed() }.check().is_err());
    let compass = Instrument::new(Gyrosphere::seed(), Box::new(Lag));
    assert!(compass.error(&Motion::roll(&Roll::new(0.01, 0.1, 0.8).unwrap()), 200.0).is_err());
}

#[test]
fn where_the_linear_theory_ends_is_said_with_its_figure() {
    let folder = tempfile::tempdir().unwrap();
    let words = "roll-error --irregular 8deg,0.06,0.65 --lever 15m --heading 45";
    let broken = |v: &Value| -> Vec<String> {
        let all = v["validity"].as_array().unwrap().iter();
        all.filter(|s| s["holds"] == false).map(|s| s["figure"].as_str().unwrap().to_owned()).collect()
    };
    let found = json(words);
    assert_eq!(broken(&found), ["mean"]);
    assert_eq!(found["validity"][0]["value"], found["rows"][0]["mean_deg"]);
    for more in ["", " --html -", " --svg -"] {
        let text = called(&format!("{words}{more}"), folder.path()).1;
        assert!(
            text.contains("BEYOND THE LINEAR THEORY") && text.contains("mean error -23.5°"),
            "{more}: {text}"
        );
    }
    assert!(broken(&json("roll-error --heading 45")).is_empty());
    assert_eq!(broken(&json("roll-error --irregular 20deg,0.1,0.3 --lever 0.2m --heading 45")), ["roll"]);
    assert_eq!(broken(&json("roll-error --irregular 1deg,0.1,0.8 --latitude 85 --heading 45")), ["latitude"]);
    // beyond any use: no number
    let (code, out, message) =
        called("roll-error --irregular 8deg,0.06,0.65 --lever 80m --heading 45", folder.path());
    assert!(code == 3 && out.is_empty() && message.contains("there is no number"), "{message}");
    let rows = json("roll-error --irregular 8deg,0.06,0.65 --lever 15m --against latitude");
    assert_eq!(rows["rows"].as_array().unwrap().len(), 14);
    assert!(
        rows["note"].as_str().unwrap().contains("Left out")
            && rows["note"].as_str().unwrap().contains("70, 75, 80")
    );
}

#[test]
fn the_figures_of_the_linear_theory_are_those_of_a_sine() {
    let (sphere, heading) = (Gyrosphere { lever: 12.0, ..Gyrosphere::seed() }, 0.3f64);
    let (amplitude, p) = (0.1, 0.9);
    let motion = Motion::roll(&Roll::new(0.5 * amplitude * amplitude, 1e-7 * p, p).unwrap());
    let compass = Instrument::new(sphere, Box::new(Lag));
    let error = compass.error(&motion, heading).unwrap();
    let all = compass.regular_smallness(&motion, heading, &error).unwrap();
    let value = |name: &str| all.iter().find(|s| s.figure == name).unwrap().value;
    let push = sphere.lever * amplitude * p * p / 2f64.sqrt();
    assert_relative_eq!(value("roll").to_radians(), amplitude / 2f64.sqrt(), max_relative = 1e-5);
    assert_relative_eq!(value("acceleration"), push / sphere.gravity, max_relative = 1e-5);
    // x = P W₁/(g C₀ √(1 + p²T²)), against lP/P
    let give = sphere.weight / (sphere.gravity * sphere.stiffness);
    let shift = give * push * heading.cos() / (p * sphere.lag).hypot(1.0);
    assert_relative_eq!(value("shift"), shift * sphere.weight / sphere.pendulous, max_relative = 1e-4);
}
