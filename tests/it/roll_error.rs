//! The paper's rolling errors, and roll spectra, each against another way to them.

use approx::assert_relative_eq;
use gyrospec::gyro::{Gyrosphere, seed};
use gyrospec::lti::{TransferFunction, cross_moment};
use gyrospec::spectrum::{
    EvenSamples, Roll, Sea, autocovariance, fit_correlation, fit_rational, roll_intervals, welch,
    without_slow,
};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

#[test]
fn both_examples_of_the_paper() {
    let (sphere, roll, heading) = seed::example_2_1();
    assert_relative_eq!(seed::regular_error(&sphere, &roll, heading).to_degrees(), -0.2824, epsilon = 5e-5);
    let (sphere, roll, heading) = seed::example_3_1();
    let derived = seed::irregular_error(&sphere, &roll, heading).unwrap();
    assert_relative_eq!(derived.to_degrees(), -4.497, epsilon = 5e-4);
    let printed = seed::irregular_error_as_printed(&sphere, &roll, heading);
    assert_relative_eq!(printed.to_degrees(), -0.7157, epsilon = 5e-5);
    assert_relative_eq!(derived, seed::irregular_error_closed(&sphere, &roll, heading), max_relative = 1e-13);
}

#[test]
fn narrow_roll_turns_into_regular_roll() {
    let (sphere, roll, heading) = seed::example_3_1();
    let amplitude = (2.0 * roll.variance).sqrt();
    let regular = seed::regular_error(&sphere, &seed::Regular { amplitude, frequency: 0.8 }, heading);
    for decay in [1e-4, 1e-6, 1e-8] {
        let narrow = Roll { decay, ..roll };
        let irregular = seed::irregular_error(&sphere, &narrow, heading).unwrap();
        // what is left is the white tail, in proportion to μ
        assert_relative_eq!(irregular, regular, max_relative = 20.0 * decay);
    }
}

#[test]
fn the_density_is_the_transform_of_the_correlation_function() {
    let roll = Roll::new(0.03, 0.15, 0.7).unwrap();
    for omega in [0.0_f64, 0.4, 0.7, 1.5] {
        // S(ω) = 2∫₀^∞ K(τ) cos ωτ dτ
        let (step, count) = (1e-3, 200_000);
        let value = |k: i32| {
            let t = f64::from(k) * step;
            roll.correlation(t) * (omega * t).cos()
        };
        let sum: f64 = (1..count).map(value).sum::<f64>() + 0.5 * value(0);
        assert_relative_eq!(roll.density(omega), 2.0 * step * sum, max_relative = 1e-6);
        assert_relative_eq!(roll.density(omega), roll.shaping().power(omega), max_relative = 1e-13);
    }
    let one = TransferFunction::constant(1.0);
    let variance = cross_moment(&roll.shaping(), &one, &one).unwrap().value;
    assert_relative_eq!(variance, 0.03, max_relative = 1e-14);
}

#[test]
fn half_of_example_3_1_is_the_white_tail() {
    let (sphere, roll, heading) = seed::example_3_1();
    let low = TransferFunction::new(&[1.0], &[1.0 / 2.5, 1.0]).unwrap();
    let banded = roll.shaping().then(&low).then(&low).differentiated().unwrap().differentiated().unwrap();
    let lag = TransferFunction::new(&[1.0], &[sphere.lag, 1.0]).unwrap();
    let moment = cross_moment(&banded, &TransferFunction::constant(1.0), &lag).unwrap().value;
    let error = seed::error_of_moment(&sphere, moment, heading).to_degrees();
    assert_relative_eq!(error, -2.49, epsilon = 5e-3);
}

/// Exact samples of irregular roll: the process behind (3.3) is AR(2) with one moving average;
/// here by fine steps of its differential equation instead.
fn made_roll(roll: &Roll, step: f64, count: usize, seed: u64) -> Vec<f64> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let inner = 200;
    let dt = step / f64::from(inner);
    let gain = 2.0 * (roll.variance * roll.decay * roll.b2()).sqrt();
    let (mut angle, mut rate) = (roll.variance.sqrt(), 0.0);
    (0..count)
        .map(|_| {
            for _ in 0..inner {
                let noise: f64 = StandardNormal.sample(&mut rng);
                rate += dt * (-2.0 * roll.decay * rate - roll.b2() * angle) + gain * dt.sqrt() * noise;
                angle += dt * rate;
            }
            angle
        })
        .collect()
}

#[test]
fn spectrum_and_fit_of_a_made_roll_come_back() {
    let truth = Roll::new(4e-3, 0.08, 0.65).unwrap();
    let values = made_roll(&truth, 0.5, 20_000, 11);
    let spectrum = welch(&values, 0.5, 512).unwrap();
    let variance = spectrum.integral(|_| 1.0);
    assert_relative_eq!(variance, truth.variance, max_relative = 0.1);
    assert!((spectrum.peak() - truth.b2().sqrt()).abs() < 0.08);
    let fit = fit_correlation(&autocovariance(&values, 120), 0.5, spectrum.peak(), 0.0).unwrap();
    assert_relative_eq!(fit.roll.frequency, truth.frequency, max_relative = 0.03);
    assert_relative_eq!(fit.roll.decay, truth.decay, max_relative = 0.25);
    assert!(fit.r_squared > 0.97 && fit.misfit < 0.05);
}

#[test]
fn a_spectrum_leaves_gaps_out() {
    let mut values = made_roll(&Roll::new(4e-3, 0.08, 0.65).unwrap(), 0.5, 4000, 12);
    let whole = welch(&values, 0.5, 256).unwrap();
    values[1000..1100].fill(f64::NAN);
    let holed = welch(&values, 0.5, 256).unwrap();
    assert!(holed.segments < whole.segments && holed.segments > 20);
    assert_relative_eq!(holed.integral(|_| 1.0), whole.integral(|_| 1.0), max_relative = 0.15);
}

#[test]
fn seas_have_their_height_and_rational_fits_state_their_error() {
    let seas = [
        Sea::PiersonMoskowitz { height: 3.0 },
        Sea::Bretschneider { height: 2.0, peak: 0.8 },
        Sea::Jonswap { height: 2.0, peak: 0.7, gamma: 3.3 },
    ];
    for sea in seas {
        sea.check().unwrap();
        let omega: Vec<f64> = (1..2000).map(|k| f64::from(k) * 0.02 * sea.peak()).collect();
        let density: Vec<f64> = omega.iter().map(|w| sea.density(*w)).collect();
        let area: f64 = density.iter().sum::<f64>() * 0.02 * sea.peak() / std::f64::consts::PI;
        assert_relative_eq!(4.0 * area.sqrt(), sea.height(), max_relative = 0.02);
        let fit = fit_rational(&omega[..200], &density[..200], &[1.0; 200], &[0, 1, 3, 5]).unwrap();
        assert!(fit.error < 0.2, "{sea:?}: {}", fit.error);
        let made: f64 = omega[..200].iter().map(|w| (fit.shaping.power(*w) - sea.density(*w)).abs()).sum();
        assert_relative_eq!(fit.error, made / density[..200].iter().sum::<f64>(), max_relative = 1e-6);
    }
}

#[test]
fn the_compass_refuses_impossible_numbers() {
    let seed = Gyrosphere::seed();
    assert!(seed.check().is_ok());
    assert!(Gyrosphere { latitude: std::f64::consts::FRAC_PI_2, ..seed }.check().is_err());
    assert!(Gyrosphere { stiffness: 0.0, ..seed }.check().is_err());
    assert!(Gyrosphere { lag: f64::NAN, ..seed }.check().is_err());
}

#[test]
fn intervals_of_a_fitted_roll_hold_it() {
    let truth = Roll::new(4e-3, 0.08, 0.65).unwrap();
    let runs = 30;
    let held: usize = (0..runs)
        .filter(|seed| {
            let values = made_roll(&truth, 0.5, 7200, 100 + seed);
            let samples = EvenSamples { step: 0.5, values };
            let rolling = without_slow(&samples, 0.2).unwrap().values;
            let fit = fit_correlation(&autocovariance(&rolling, 120), 0.5, 0.65, 0.2).unwrap();
            let i = roll_intervals(&rolling, &fit).unwrap();
            let mu = i.decay.unwrap();
            mu.low < truth.decay && truth.decay < mu.high
        })
        .count();
    // ten blocks of six minutes: near 95 %, and not below 80 %
    assert!(held * 10 >= runs as usize * 8, "{held} of {runs}");
}

#[test]
fn what_a_high_pass_took_is_not_missed_in_the_fit() {
    let truth = Roll::new(4e-3, 0.08, 0.65).unwrap();
    let whole = made_roll(&truth, 0.5, 100_000, 7);
    let samples = EvenSamples { step: 0.5, values: whole };
    let rolling = without_slow(&samples, 0.3).unwrap().values;
    let measured = autocovariance(&rolling, 120);
    // a tenth of the variance is gone, yet A comes back
    assert!(measured[0] < 0.93 * truth.variance);
    let fit = fit_correlation(&measured, 0.5, 0.65, 0.3).unwrap();
    assert_relative_eq!(fit.roll.variance, truth.variance, max_relative = 0.04);
    assert_relative_eq!(fit.roll.decay, truth.decay, max_relative = 0.08);
}

/// The command on a file of the given text; its exit code, results and messages.
pub fn command(name: &str, text: &str, options: &[&str]) -> (i32, String, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .arg("roll-error")
        .arg(&path)
        .args(options)
        .output()
        .unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().unwrap(), text(&output.stdout), text(&output.stderr))
}

#[test]
fn a_roll_that_stands_still_and_a_column_that_is_no_time_are_told() {
    let rows: String = (0..500).map(|k| format!("{},3.0\n", 0.2 * f64::from(k))).collect();
    let (code, _, message) = command("still.csv", &format!("time [s],roll [deg]\n{rows}"), &[]);
    assert!(code == 2 && message.contains("no motion"), "{message}");
    let (code, _, message) = command("bare.csv", "roll,pitch\n1,2\n2,3\n", &["--roll", "roll:deg"]);
    assert!(code == 2 && message.contains("no column of time"), "{message}");
}

#[test]
fn a_name_that_no_gyrosphere_has_is_refused_with_the_nearest() {
    let file = "[parameters]\nC_0 = { value = 1e5, unit = \"N/m\" }\n";
    let (code, _, message) = command("compass.toml", file, &[]);
    assert!(code == 2 && message.contains("did you mean C0?"), "{message}");
}

#[test]
fn the_part_of_a_model_is_the_part_computed() {
    let json = |file: &str, options: &[&str]| -> serde_json::Value {
        let all: Vec<&str> = options.iter().copied().chain(["--json", "--heading", "45"]).collect();
        let (code, text, message) = command("compass.toml", file, &all);
        assert_eq!(code, 0, "{message}");
        serde_json::from_str(&text).unwrap()
    };
    let of_model = json("extends = \"gyrosphere-flow\"\n[parameters]\nT2 = 4.0\n", &[]);
    let of_options = json("extends = \"gyrosphere\"\n", &["--flow", "4s,0.2"]);
    assert_eq!(of_model["rows"][0]["mean_deg"], of_options["rows"][0]["mean_deg"]);
    let of_model = json("extends = \"gyrosphere-inertia\"\n", &[]);
    let of_options = json("extends = \"gyrosphere\"\n", &["--inertia"]);
    assert_eq!(of_model["rows"][0]["mean_deg"], of_options["rows"][0]["mean_deg"]);
}

/// The command without a file; its exit code, results and messages.
pub fn asked(options: &[&str]) -> (i32, String, String) {
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .arg("roll-error")
        .args(options)
        .output()
        .unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().unwrap(), text(&output.stdout), text(&output.stderr))
}

pub fn asked_json(options: &[&str]) -> serde_json::Value {
    let all: Vec<&str> = options.iter().copied().chain(["--json", "--heading", "45"]).collect();
    let (code, text, message) = asked(&all);
    assert_eq!(code, 0, "{message}");
    serde_json::from_str(&text).unwrap()
}

#[test]
fn what_no_simulation_follows_is_refused_with_the_band_to_say() {
    for options in [&["--friction", "2N"][..], &["--free-play", "1e-5m"], &["--inertia", "--simulate", "2"]] {
        let (code, out, message) = asked(&[options, &["--heading", "45"]].concat());
        assert!(code == 2 && out.is_empty() && message.contains("--band"), "{options:?} {message}");
    }
    let rows: String = (0..3000)
        .map(|k| {
            format!(
                "{},{}\n",
                0.2 * f64::from(k),
                5.0 * (0.16 * f64::from(k)).sin() * (0.01 * f64::from(k)).cos()
            )
        })
        .collect();
    let recording = format!("time [s],roll [deg]\n{rows}");
    // a recorded roll drives the part itself, where it lasts long enough for an interval
    let (code, text, message) = command("roll.csv", &recording, &["--friction", "2N", "--heading", "45"]);
    assert!(code == 0 && text.contains("through the recording itself"), "{text}{message}");
    let short: String = recording.lines().take(1200).map(|l| format!("{l}\n")).collect();
    let (code, _, message) = command("roll.csv", &short, &["--friction", "2N"]);
    assert!(code == 2 && message.contains("six minutes"), "{message}");
}

#[test]
fn friction_is_told_as_simulated_with_its_margin_and_the_linearised_mean_beside() {
    let options = ["--friction", "2N", "--band", "2.5rad/s", "--latitude", "60"];
    let told = asked_json(&options);
    let row = |name: &str| told["rows"][0][name].as_f64().unwrap();
    // an independent simulation gives −0.755 ± 0.02
    let margin = row("mean_margin_deg");
    assert!((row("mean_deg") + 0.755).abs() < 0.02 + margin && margin < 0.02, "{told}");
    assert!((row("linearised_mean_deg") + 0.427).abs() < 1e-3 && row("spread_margin_deg") > 0.0);
    let (code, text, _) = asked(&[&options[..], &["--heading", "45"]].concat());
    assert!(code == 0 && text.contains("linearised") && text.contains("is not linear"), "{text}");
    // around the card, at every latitude and on every sea the same moments serve
    let (code, text, _) = asked(&["--friction", "2N", "--band", "2.5", "--against", "latitude", "--json"]);
    let all: serde_json::Value = serde_json::from_str(&text).unwrap();
    let at = all["rows"].as_array().unwrap().iter().find(|r| r["latitude_deg"] == 60.0).unwrap();
    assert!(code == 0 && (at["mean_deg"].as_f64().unwrap() - row("mean_deg")).abs() < 1e-9, "{at}");
}

#[test]
fn a_regular_roll_is_simulated_as_one() {
    let told = asked_json(&["--regular", "10deg,0.8", "--simulate", "2"]);
    let row = &told["rows"][0];
    let (mean, got) = (row["mean_deg"].as_f64().unwrap(), &row["simulated"]);
    // each day holds whole periods but for one part: no more than the step's error between them
    let off = (got["mean_deg"].as_f64().unwrap() - mean).abs();
    assert!(off < 3e-3 * mean.abs() + got["mean_margin_deg"].as_f64().unwrap(), "{row}");
    assert!(got["mean_margin_deg"].as_f64().unwrap() < 0.02 * mean.abs(), "{row}");
    // behind the low-passes its amplitude falls by 1 + p²/ω_c², its mean by the square
    let banded = asked_json(&["--regular", "10deg,0.8", "--band", "2.5"]);
    let fallen = banded["rows"][0]["mean_deg"].as_f64().unwrap() / mean;
    assert_relative_eq!(fallen, (1.0 + (0.8f64 / 2.5).powi(2)).powi(-2), max_relative = 1e-4);
}
