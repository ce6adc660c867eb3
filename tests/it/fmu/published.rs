//! The Reference FMUs of the Modelica Association beside their published results and beside the equations.

use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use gyrospec::{fit, simulate};
use std::path::PathBuf;

/// The folder of the Reference FMUs, beside that of the recordings.
fn folder() -> Option<PathBuf> {
    let recordings = std::env::var_os("GYROSPEC_RECORDINGS").map(PathBuf::from);
    let beside = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/fmus");
    let mut all = recordings.map(|r| r.join("../fmus")).into_iter().chain([beside]);
    let found = all.find(|f| f.is_dir());
    if found.is_none() || !cfg!(all(target_os = "linux", target_arch = "x86_64")) {
        crate::skipped::skipped("the Reference FMUs of the Modelica Association are not here");
        return None;
    }
    found
}

/// A unit of both versions, as far as it is there in both.
fn units(name: &str) -> Vec<PathBuf> {
    let Some(folder) = folder() else { return Vec::new() };
    ["fmi2", "fmi3"]
        .map(|v| folder.join(v).join(format!("{name}.fmu")))
        .into_iter()
        .filter(|f| f.exists())
        .collect()
}

/// A model that begins with a unit, and more of a model file.
fn model(unit: &std::path::Path, more: &str) -> Model {
    Model::parse(&format!("name = \"unit\"\nfmu = {:?}\n{more}", unit.display().to_string())).unwrap()
}

/// A recording of channels without units.
fn plain(times: &[f64], channels: &[(&str, &dyn Fn(f64) -> f64)]) -> Recording {
    let channel = |(name, of): &(&str, &dyn Fn(f64) -> f64)| {
        Channel::new(*name, Unit::parse("1").unwrap(), times.to_vec(), times.iter().map(|t| of(*t)).collect())
    };
    Recording::from_channels("made", channels.iter().map(channel).collect()).unwrap()
}

/// The largest difference, and the root of the mean square.
pub fn off(measured: impl Iterator<Item = f64>, predicted: impl Iterator<Item = f64>) -> (f64, f64) {
    let differences: Vec<f64> = measured.zip(predicted).map(|(a, b)| (a - b).abs()).collect();
    assert!(!differences.is_empty() && differences.iter().all(|d| d.is_finite()));
    let squares: f64 = differences.iter().map(|d| d * d).sum();
    (differences.iter().copied().fold(0.0, f64::max), (squares / differences.len() as f64).sqrt())
}

fn worst(model: &Model, recording: &Recording) -> Vec<(String, f64)> {
    let ran = simulate(model, recording).run().unwrap();
    ran.outputs().map(|o| (o.name().to_owned(), off(o.measured(), o.predicted()).0)).collect()
}

#[test]
fn published_results_come_back() {
    for name in ["BouncingBall", "Stair", "Resource"] {
        for unit in units(name) {
            let model = Model::read(&unit).unwrap();
            let published = unit.parent().unwrap().with_file_name(format!("{name}_out.csv"));
            let recording = model.read_recording(&published).unwrap();
            for (output, error) in worst(&model, &recording) {
                assert!(error <= 1e-9, "{}: {output} off by {error:e}", unit.display());
            }
        }
    }
}

/// The first column of numbers below the header of a published table.
fn column(name: &str, column: usize) -> Vec<f64> {
    let Some(folder) = folder() else { return Vec::new() };
    let text = std::fs::read_to_string(folder.join(format!("{name}_out.csv"))).unwrap();
    text.lines().skip(1).map(|l| l.split(',').nth(column).unwrap().parse().unwrap()).collect()
}

#[test]
fn the_page_of_units_tells_what_they_do() {
    let page = include_str!("../../../docs/fmus.md");
    let rows: Vec<Vec<&str>> =
        page.lines().filter(|l| l.starts_with("| ")).map(|l| l.split('|').map(str::trim).collect()).collect();
    let mut seen = 0;
    for row in rows.iter().filter(|r| r.len() == 8) {
        let Ok(told) = row[5].parse::<f64>() else { continue };
        for unit in units(row[1]) {
            assert!(row[2].contains(if unit.to_string_lossy().contains("fmi3") { "3.0" } else { "2.0" }));
            let model = Model::read(&unit).unwrap();
            let published = unit.parent().unwrap().with_file_name(format!("{}_out.csv", row[1]));
            let all = worst(&model, &model.read_recording(&published).unwrap());
            let largest = all.iter().map(|o| o.1).fold(0.0, f64::max);
            // three digits are told
            assert!(
                (largest - told).abs() <= 1e-3 * told + 1e-9,
                "{}: {largest} and not {told}",
                unit.display()
            );
            seen += 1;
        }
    }
    assert!(seen == 10 || folder().is_none(), "{seen}");
    // the published results that differ are those of explicit Euler steps
    let mut x = 1.0;
    for published in column("Dahlquist", 1) {
        assert!((published - x).abs() < 1e-12);
        x -= 0.1 * x;
    }
    let mut y = [2.0, 0.0];
    for (a, b) in column("VanDerPol", 1).into_iter().zip(column("VanDerPol", 2)) {
        assert!((a - y[0]).abs() + (b - y[1]).abs() < 1e-12, "{a} {b} {y:?}");
        y = [y[0] + 0.01 * y[1], y[1] + 0.01 * ((1.0 - y[0] * y[0]) * y[1] - y[0])];
    }
}

/// Their published results are of a coarse solver; here they are held against the equations.
#[test]
fn units_that_a_solver_integrates_follow_their_equations() {
    let times: Vec<f64> = (0..201).map(|i| f64::from(i) * 0.05).collect();
    for unit in units("Dahlquist") {
        let model = model(&unit, "[parameters]\nk = { value = 0.7 }\n");
        let error = worst(&model, &plain(&times, &[("x", &|t: f64| (-0.7 * t).exp())]));
        assert!(error[0].1 < 1e-5, "{error:?}");
    }
    let truth = van_der_pol(1.0, &times);
    let at = |t: f64, k: usize| truth[(t / 0.05).round() as usize][k];
    for unit in units("VanDerPol") {
        let recording = plain(&times, &[("x0", &|t| at(t, 0)), ("x1", &|t| at(t, 1))]);
        // the solver is asked for 1e-5 of an output's spread a sample; along an oscillation some more gathers
        let error = worst(&model(&unit, ""), &recording);
        assert!(error.iter().all(|e| e.1 < 1e-4), "{error:?}");
    }
    for unit in units("StateSpace") {
        // ẋ = A x + u, y = x + u from x = 0, u = (1, 2, 3), the start of its inputs, A = I but for A₁₂ = 0.5:
        // x₂ = 2(eᵗ - 1), x₁ = (eᵗ - 1) + 0.5 ∫ eᵗ⁻ˢ x₂ ds = t eᵗ
        let model = model(&unit, "[inputs]\n[parameters]\nA_1_2 = { value = 0.5 }\n");
        let times: Vec<f64> = (0..101).map(|i| f64::from(i) * 0.02).collect();
        let recording = plain(
            &times,
            &[
                ("y_1", &|t: f64| 1.0 + t * t.exp()),
                ("y_2", &|t: f64| 2.0 * t.exp()),
                ("y_3", &|t: f64| 3.0 * t.exp()),
            ],
        );
        for (output, error) in worst(&model, &recording) {
            assert!(error < 1e-3, "{output} off by {error:e}");
        }
    }
}

/// Van der Pol's equation by classical Runge-Kutta steps of 0.5 ms.
fn van_der_pol(mu: f64, times: &[f64]) -> Vec<[f64; 2]> {
    let rate = |[x, v]: [f64; 2]| [v, mu * (1.0 - x * x) * v - x];
    let add = |a: [f64; 2], h: f64, b: [f64; 2]| [a[0] + h * b[0], a[1] + h * b[1]];
    let (mut y, mut all) = ([2.0, 0.0], vec![[2.0, 0.0]]);
    for w in times.windows(2) {
        let h = (w[1] - w[0]) / 40.0;
        for _ in 0..40 {
            let a = rate(y);
            let b = rate(add(y, h / 2.0, a));
            let c = rate(add(y, h / 2.0, b));
            let d = rate(add(y, h, c));
            y = std::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        }
        all.push(y);
    }
    all
}

#[test]
fn parameters_of_the_reference_units_are_fitted() {
    let times: Vec<f64> = (0..1001).map(|i| f64::from(i) * 0.02).collect();
    let truth = van_der_pol(1.3, &times);
    let at = |t: f64, k: usize| truth[(t / 0.02).round() as usize][k];
    // errors without a pattern, far below the signal
    let error = |t: f64| 1e-3 * (91.7 * t * t + 3.0).sin();
    for unit in units("VanDerPol") {
        let model = model(&unit, "[parameters]\nmu = { value = 0.8, fit = true }\n");
        let recording = plain(&times, &[("x0", &|t| at(t, 0) + error(t)), ("x1", &|t| at(t, 1) - error(t))]);
        let mu = fit(&model, &[recording]).run().unwrap().parameter("mu").unwrap().value;
        assert!((mu - 1.3).abs() < 1e-3, "{mu}");
    }
    for unit in units("Dahlquist") {
        let model = model(
            &unit,
            "[parameters]\nk = { value = 1, fit = true }\n[states]\nx = { initial = \"fit\" }\n",
        );
        let recording = plain(&times[..300], &[("x", &|t: f64| 1.2 * (-0.4 * t).exp() + error(t))]);
        let k = fit(&model, &[recording]).run().unwrap().parameter("k").unwrap().value;
        assert!((k - 0.4).abs() < 1e-3, "{k}");
    }
}

/// A ball whose events move its states steps itself; the truth is its own run with other parameters.
#[test]
fn a_ball_that_bounces_is_fitted_by_whole_runs() {
    for unit in units("BouncingBall") {
        let times: Vec<f64> = (0..180).map(|i| f64::from(i) * 0.01).collect();
        let metres = Unit::parse("m").unwrap();
        let blank = Channel::new("h", metres.clone(), times.clone(), vec![0.0; times.len()]);
        let other =
            model(&unit, "[parameters]\ng = { value = -9.6 }\ne = { value = 0.72 }\n[outputs]\nh = {}\n");
        let ran = simulate(&other, &Recording::from_channels("blank", vec![blank]).unwrap()).run().unwrap();
        let heights: Vec<f64> = ran.outputs().next().unwrap().predicted().collect();
        let recording =
            [Recording::from_channels("ball", vec![Channel::new("h", metres, times, heights)]).unwrap()];
        let asked = "[parameters]\ng = { value = -9.81, fit = true }\ne = { value = 0.7, fit = true }\n[outputs]\nh = {}\n";
        let model = model(&unit, asked);
        let fitted = fit(&model, &recording).run().unwrap();
        let value = |name: &str| fitted.parameter(name).unwrap().value;
        assert!(
            (value("g") + 9.6).abs() < 1e-3 && (value("e") - 0.72).abs() < 1e-3,
            "{} {}",
            value("g"),
            value("e")
        );
    }
}

#[test]
fn every_type_of_number_passes_through() {
    for unit in units("Feedthrough") {
        let is_three = unit.to_string_lossy().contains("fmi3");
        let whole: &[&str] = if is_three {
            &[
                "Int8",
                "UInt8",
                "Int16",
                "UInt16",
                "Int32",
                "UInt32",
                "Int64",
                "UInt64",
                "Boolean",
                "Enumeration",
            ]
        } else {
            &["Int32", "Boolean", "Enumeration"]
        };
        let mut names: Vec<(String, bool)> =
            vec![("Float64_continuous".into(), false), ("Float64_discrete".into(), true)];
        if is_three {
            names.extend([("Float32_continuous".into(), false), ("Float32_discrete".into(), true)]);
        }
        names.extend(whole.iter().map(|n| ((*n).to_owned(), true)));
        let of = |name: &str, t: f64| match name {
            n if n.starts_with("Boolean") => f64::from(u8::from((t * 2.0) as i32 % 2 == 1)),
            n if n.starts_with("Enumeration") => 1.0 + f64::from((t * 3.0) as i32 % 2),
            n if n.contains("Int") => f64::from((t * 7.0) as i32 % 100),
            // exact in single precision too
            _ => f64::from((t * 64.0) as i32) / 64.0,
        };
        let times: Vec<f64> = (0..200).map(|i| f64::from(i) * 0.1).collect();
        let one = Unit::parse("1").unwrap();
        let mut channels = Vec::new();
        for (name, _) in &names {
            for end in ["input", "output"] {
                let mut c = Channel::new(
                    format!("{name}_{end}"),
                    one.clone(),
                    times.clone(),
                    times.iter().map(|t| of(name, *t)).collect(),
                );
                c.hold = gyrospec::record::Hold::Previous;
                channels.push(c);
            }
        }
        let list = |end: &str| names.iter().map(|(n, _)| format!("{n}_{end} = {{}}\n")).collect::<String>();
        let model = model(&unit, &format!("[inputs]\n{}[outputs]\n{}", list("input"), list("output")));
        let errors = worst(&model, &Recording::from_channels("made", channels).unwrap());
        assert_eq!(errors.len(), names.len());
        for (output, error) in errors {
            assert!(error == 0.0, "{}: {output} off by {error:e}", unit.display());
        }
    }
}

#[test]
fn what_nobody_can_step_is_refused_with_its_reason() {
    for unit in units("Clocks") {
        let error = Model::read(&unit).unwrap_err().to_string();
        assert!(error.contains("Scheduled Execution only"), "{error}");
    }
}
