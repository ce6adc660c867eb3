//! The mean by a measured spectrum for every linear part, beside the part followed in time on the same samples.

use approx::assert_relative_eq;
use gyrospec::gyro::Gyrosphere;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

const STEP: f64 = 0.1;

/// Four hours of roll at 10 Hz, rad: white noise through a resonance and two low-passes, by Heun's rule.
fn made(seed: u64) -> Vec<f64> {
    let (mu, b2, corner) = (0.08, 0.65, 3.0);
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let rates = |y: [f64; 4], w: f64| {
        [y[1], w - b2 * y[0] - 2.0 * mu * y[1], corner * (y[0] - y[2]), corner * (y[2] - y[3])]
    };
    let (mut y, mut all) = ([0.0; 4], Vec::new());
    for k in 0..8 * 150_000 {
        let h = STEP / 8.0;
        let w = 0.045 * ((0..12).map(|_| rng.random_range(0.0..1.0)).sum::<f64>() - 6.0) / f64::sqrt(h);
        let first = rates(y, w);
        let second = rates([0, 1, 2, 3].map(|i| y[i] + h * first[i]), w);
        y = [0, 1, 2, 3].map(|i| y[i] + 0.5 * h * (first[i] + second[i]));
        if k % 8 == 7 && k >= 8 * 6000 {
            all.push(y[3]);
        }
    }
    all
}

/// x of a part ż = A z + B W, x = Σ z, by the trapezoid rule.
fn answer<const N: usize>(a: [[f64; N]; N], b: [f64; N], w: &[f64]) -> Vec<f64> {
    let mut z = [0.0; N];
    let mut all = vec![0.0];
    for pair in w.windows(2) {
        // (1 − hA/2) z' = (1 + hA/2) z + h B (w + w')/2, by elimination
        let mut m: [[f64; N]; N] = std::array::from_fn(|i| {
            std::array::from_fn(|j| f64::from(u8::from(i == j)) - 0.5 * STEP * a[i][j])
        });
        let mut r: [f64; N] = std::array::from_fn(|i| {
            z[i] + 0.5 * STEP * ((0..N).map(|j| a[i][j] * z[j]).sum::<f64>() + b[i] * (pair[0] + pair[1]))
        });
        for i in 0..N {
            for k in i + 1..N {
                let by = m[k][i] / m[i][i];
                let above = m[i];
                (0..N).for_each(|j| m[k][j] -= by * above[j]);
                r[k] -= by * r[i];
            }
        }
        for i in (0..N).rev() {
            let known: f64 = (i + 1..N).map(|j| m[i][j] * z[j]).sum();
            z[i] = (r[i] - known) / m[i][i];
        }
        all.push(z[0]);
    }
    all
}

/// Behind two low-passes of first order.
fn banded(roll: &[f64], corner: f64) -> Vec<f64> {
    let once = |x: &[f64]| answer([[-corner]], [corner], x);
    once(&once(roll))
}

/// The mean of P/(g H U cos φ)(W₂ x − W₁ y) on heading 45°, degrees.
fn mean(roll: &[f64], x: impl Fn(&[f64]) -> Vec<f64>, y: impl Fn(&[f64]) -> Vec<f64>) -> f64 {
    let s = Gyrosphere::seed();
    // θ̈ by differences of fourth order
    let bent = |v: &[f64]| -v[0] + 16.0 * v[1] - 30.0 * v[2] + 16.0 * v[3] - v[4];
    let w2: Vec<f64> =
        roll.windows(5).map(|v| s.lever * 0.5f64.sqrt() * bent(v) / (12.0 * STEP * STEP)).collect();
    let w1: Vec<f64> = w2.iter().map(|w| -w).collect();
    let (x, y) = (x(&w1), y(&w2));
    let products = (1000..w2.len()).map(|k| w2[k] * x[k] - w1[k] * y[k]);
    let moment = products.sum::<f64>() / (w2.len() - 1000) as f64;
    (s.weight / (s.gravity * s.momentum * s.earth_rate * s.latitude.cos()) * moment).to_degrees()
}

/// The mean by the measured spectrum, and by the fit, degrees.
fn told(file: &Path, words: &[&str]) -> [f64; 2] {
    let out = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .arg("roll-error")
        .arg(file)
        .args(["--json", "--heading", "45"])
        .args(words)
        .output()
        .unwrap();
    assert!(out.status.success(), "{words:?}: {}", String::from_utf8_lossy(&out.stderr));
    let told: serde_json::Value = serde_json::from_slice(&out.stdout).unwrap();
    ["measured_spectrum_mean_deg", "mean_deg"].map(|name| told["rows"][0][name].as_f64().unwrap())
}

#[test]
fn the_mean_by_a_measured_spectrum_is_that_of_the_same_samples_followed_in_time() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("roll.csv");
    let s = Gyrosphere::seed();
    let (m, c0) = (s.weight / s.gravity, s.stiffness);
    let r = s.lag * c0;
    let none = |w: &[f64]| vec![0.0; w.len()];
    let lag = |w: &[f64]| answer([[-1.0 / s.lag]], [m / c0 / s.lag], w);
    let flow = |w: &[f64]| {
        let second = answer([[-1.0 / 4.0]], [0.3 * m / c0 / 4.0], w);
        lag(w).iter().zip(second).map(|(a, b)| a + b).collect::<Vec<_>>()
    };
    let heavy = |w: &[f64]| answer([[0.0, 1.0], [-c0 / m, -r / m]], [0.0, 1.0], w);
    let slosh = |w: &[f64]| {
        let second = answer([[0.0, 1.0], [-2.25, -0.6]], [0.0, 2e-5], w);
        lag(w).iter().zip(second).map(|(a, b)| a + b).collect::<Vec<_>>()
    };
    let across = |w: &[f64]| answer([[-1.0]], [m / 2e5], w);
    let heavy_across = |w: &[f64]| answer([[0.0, 1.0], [-2e5 / m, -2e5 / m]], [0.0, 1.0], w);
    let roll = made(1);
    let mut text = "time [s],roll [rad]\n".to_owned();
    roll.iter().enumerate().for_each(|(k, x)| writeln!(text, "{:.1},{x:.9}", STEP * k as f64).unwrap());
    std::fs::write(&file, text).unwrap();
    let narrower = banded(&roll, 1.5);
    for (words, truth) in [
        (&[][..], mean(&roll, lag, none)),
        (&["--inertia"], mean(&roll, heavy, none)),
        (&["--flow", "4s,0.3"], mean(&roll, flow, none)),
        (&["--slosh", "1.5,0.2,2e-5"], mean(&roll, slosh, none)),
        (&["--meridian", "2e5N/m,1s"], mean(&roll, lag, across)),
        (&["--inertia", "--meridian", "2e5N/m,1s"], mean(&roll, heavy, heavy_across)),
        (&["--band", "1.5rad/s"], mean(&narrower, lag, none)),
        (&["--band", "1.5rad/s", "--flow", "4s,0.3"], mean(&narrower, flow, none)),
    ] {
        let [measured, fitted] = told(&file, words);
        println!("{words:?}: spectrum {measured:.5}°, in time {truth:.5}°, by the fit {fitted:.5}°");
        // windows weigh the ends of a recording less
        assert_relative_eq!(measured, truth, max_relative = 0.015);
    }
}

#[test]
fn a_sample_that_nothing_honest_makes_is_left_out_and_told() {
    let folder = tempfile::tempdir().unwrap();
    let text =
        std::fs::read_to_string(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/roll.csv"))
            .unwrap();
    let spiked: Vec<String> = text
        .lines()
        .enumerate()
        .map(|(k, row)| match row.rsplit_once(',') {
            Some((before, _)) if k == 701 => format!("{before},85"),
            _ => row.to_owned(),
        })
        .collect();
    let run = |name: &str, text: &str| {
        let file = folder.path().join(name);
        std::fs::write(&file, text).unwrap();
        let out = std::process::Command::new(env!("CARGO_BIN_EXE_gyrospec"))
            .arg("roll-error")
            .arg(&file)
            .args(["--heading", "45", "--json"])
            .output()
            .unwrap();
        let told: serde_json::Value = serde_json::from_slice(&out.stdout).unwrap();
        let mean = told["rows"][0]["measured_spectrum_mean_deg"].as_f64().unwrap();
        (mean, String::from_utf8_lossy(&out.stderr).into_owned())
    };
    let ((plain, silent), (spiked, said)) = (run("a.csv", &text), run("b.csv", &spiked.join("\n")));
    assert!(!silent.contains("left out"), "{silent}");
    assert!(said.contains("1 sample is left out, at 175 s (outliers)"), "{said}");
    assert!((spiked / plain - 1.0).abs() < 0.01, "{spiked} {plain}");
}

/// θ̈ of a roll of sixteen sines, rad/s², or θ itself, rad.
fn sines(t: f64, bent: bool) -> f64 {
    let one = |k: i32| {
        let w = 0.5 + 0.025 * f64::from(k);
        let amplitude = 0.02 * (-((w - 0.65) / 0.1).powi(2)).exp();
        amplitude * if bent { -w * w } else { 1.0 } * (w * t + 2.3 * f64::from(k * k)).sin()
    };
    (0..16).map(one).sum()
}

/// The mean of P/(g H U cos φ) W₂ x on heading 45° from `ends[0]` to `ends[1]`, degrees, of m ẍ + r ẋ + C₀ d(x) + F sgn ẋ
/// = m W₁ by Euler's implicit rule, d(x) without the play ±δ.
fn rubbed(friction: f64, play: f64, ends: [f64; 2]) -> f64 {
    let s = Gyrosphere::seed();
    let (m, c, dt) = (s.weight / s.gravity, s.stiffness, 1e-3);
    let r = s.lag * c;
    let (mut x, mut v, mut sum, mut count) = (0.0f64, 0.0f64, 0.0, 0);
    for k in 0..(ends[1] / dt) as usize {
        let t = dt * (k + 1) as f64;
        let w2 = s.lever * 0.5f64.sqrt() * sines(t, true);
        // (m/dt + r + c dt) v' + F Sgn v' = m v/dt − m W₂ − c (x − stop), where a stop holds
        let stop = x.clamp(-play, play);
        let held = if x.abs() >= play { c } else { 0.0 };
        let push = m * v / dt - m * w2 - held * (x - stop);
        v = (push.abs() - friction).max(0.0).copysign(push) / (m / dt + r + held * dt);
        x += dt * v;
        if t > ends[0] {
            (sum, count) = (sum + w2 * x, count + 1);
        }
    }
    (s.weight / (s.gravity * s.momentum * s.earth_rate * s.latitude.cos()) * sum / f64::from(count))
        .to_degrees()
}

#[test]
fn friction_and_play_on_a_recorded_roll_are_as_simulated() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("roll.csv");
    let mut text = "time [s],roll [rad]\n".to_owned();
    (0..14_400).for_each(|k| {
        writeln!(text, "{:.2},{:.9}", 0.25 * f64::from(k), sines(0.25 * f64::from(k), false)).unwrap();
    });
    std::fs::write(&file, text).unwrap();
    let told = |words: &[&str]| -> [f64; 2] {
        let out = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
            .arg("roll-error")
            .arg(&file)
            .args(["--json", "--heading", "45"])
            .args(words)
            .output()
            .unwrap();
        assert!(out.status.success(), "{words:?}: {}", String::from_utf8_lossy(&out.stderr));
        let told: serde_json::Value = serde_json::from_slice(&out.stdout).unwrap();
        ["mean_deg", "mean_margin_deg"].map(|name| told["rows"][0][name].as_f64().unwrap())
    };
    let linear = rubbed(0.0, 0.0, [80.0, 3560.0]);
    for (words, truth) in [
        (&["--friction", "0N"][..], linear),
        (&["--friction", "0.4N"], rubbed(0.4, 0.0, [80.0, 3560.0])),
        (&["--free-play", "3um"], rubbed(0.0, 3e-6, [80.0, 3560.0])),
        (&["--friction", "0.2N", "--free-play", "2um"], rubbed(0.2, 2e-6, [80.0, 3560.0])),
    ] {
        let [mean, margin] = told(words);
        println!("{words:?}: {mean:.5}° ± {margin:.5}°, in time {truth:.5}°, linear {linear:.5}°");
        // the same recording, but for its ends
        assert!((mean - truth).abs() < margin.min(0.02 * truth.abs()), "{mean} ± {margin}, {truth}");
    }
}
