//! What bands and seas ask of the rolling error: steps of a simulation, the end of a measured spectrum, waves that
//! break.

use crate::roll_error::{asked, asked_json, command};
use crate::roll_tail::mean_by_quadrature;
use approx::assert_relative_eq;
use gyrospec::gyro::elastic::{Friction, InTime};
use gyrospec::gyro::{BUDGET, Effort, FEWEST, Gyrosphere, Instrument, Motion};
use gyrospec::spectrum::{Roll, even_samples, welch};
use std::sync::Mutex;
use std::time::Instant;

/// A number behind a word in a text.
fn number_after(text: &str, word: &str) -> f64 {
    let rest = text.split(word).nth(1).unwrap_or_else(|| panic!("no `{word}` in {text}"));
    let end = rest.find(|c: char| !(c.is_ascii_digit() || ".e-".contains(c))).unwrap_or(rest.len());
    rest[..end].parse().unwrap_or_else(|_| panic!("no number behind `{word}` in {text}"))
}

#[test]
fn a_band_that_takes_too_many_steps_is_refused_at_once_with_one_that_does_not() {
    let since = Instant::now();
    let (code, out, message) = asked(&["--friction", "2N", "--band", "3000rad/s", "--heading", "45"]);
    assert!(code == 3 && out.is_empty() && message.contains("steps"), "{message}");
    assert!(since.elapsed().as_secs() < 10);
    let band = number_after(&message, "with --band ");
    let told = number_after(&message, "it takes ");
    // what is proposed is affordable: a hundred memories of 10 s and a quarter more, in steps of 0.06 of
    // the time scale √(⟨θ̇²⟩/⟨θ̈²⟩), by ∫ ω^2n S/(1 + ω²/ω_c²)² dω
    let d = 1e-4;
    let power = |order: i32| -> f64 {
        let of = |k: i32| {
            let w = 1e-3 * (f64::from(k) * d).exp();
            let low = (1.0 + (w / band).powi(2)).powi(2);
            Roll::new(0.03, 0.1, 0.8).unwrap().density(w) * w.powi(2 * order) / low * w * d
        };
        (0..200_000).map(of).sum()
    };
    let steps = 1250.0 / (0.06 * (power(1) / power(2)).sqrt());
    assert_relative_eq!(told, 2.0 * FEWEST as f64 * steps, max_relative = 2e-3);
    assert!(band < 3000.0 && told < BUDGET);
    // a roll with too long a memory, and a lag that is too long
    let (code, _, message) =
        asked(&["--irregular=10deg,1e-4,0.8", "--friction=2N", "--band=2.5", "--heading=45"]);
    assert!(code == 3 && message.contains("times the decay") && message.contains("--regular"), "{message}");
    let (code, _, message) = command(
        "compass.toml",
        "[parameters]\nT = 1000.0\n",
        &["--friction=2N", "--band=2.5", "--heading=45"],
    );
    assert!(code == 3 && message.contains("lag T of 1000 s"), "{message}");
}

#[test]
fn the_steps_of_a_moment_are_counted_before_and_told_during_the_work() {
    let of = |band: f64| {
        let motion = Motion::roll(&Roll::new(0.03, 0.1, 0.8).unwrap()).band_limited(band, 2).unwrap();
        (Instrument::new(Gyrosphere::seed(), Box::new(Friction { force: 0.01 })), motion)
    };
    let (compass, motion) = of(300.0);
    let effort = compass.effort(&motion).unwrap();
    assert!(effort.check("friction").is_ok() && effort.replicates() as f64 * effort.steps() <= BUDGET);
    let (compass, motion) = of(5000.0);
    assert!(
        compass.effort(&motion).unwrap().check("friction").is_err() && compass.moment(&motion, 0.7).is_err()
    );
    let (compass, motion) = of(2.5);
    let shares = Mutex::new(Vec::new());
    let told = compass.moment_with(&motion, 0.7, &|share| shares.lock().unwrap().push(share)).unwrap();
    assert_eq!(told, compass.moment(&motion, 0.7).unwrap());
    let mut shares = shares.into_inner().unwrap();
    shares.sort_by(f64::total_cmp);
    assert!(shares.len() >= FEWEST && shares[0] > 0.0 && shares[shares.len() - 1] <= 1.0);
    // a light part that rings is solved in parts of its own period
    let ringing = Gyrosphere { lag: 1e-6, ..Gyrosphere::seed() };
    let parts = Friction { force: 1.0 };
    let parts = |s: &Gyrosphere| {
        use gyrospec::gyro::elastic::Elastic;
        parts.in_time(s, 0.05).unwrap().map(|law: Box<dyn InTime>| law.parts())
    };
    assert!(parts(&ringing) > Some(10) && parts(&Gyrosphere::seed()) == Some(1));
    let effort = Effort { step: 0.05, parts: 20, memory: 10.0, lag: 0.4 };
    assert_relative_eq!(effort.steps(), 20.0 * 1.25 * 1000.0 / 0.05);
}

/// A recording of such a roll in steps of a quarter of a second, with so many samples left out between two.
fn recorded(every: usize) -> (String, Vec<f64>, f64) {
    let truth = Roll::new(4e-3, 0.08, 0.65).unwrap();
    let values: Vec<f64> = truth.samples(0.25, 12_000, 5).into_iter().step_by(every).collect();
    let step = 0.25 * every as f64;
    let row = |(k, v): (usize, &f64)| format!("{},{v}\n", k as f64 * step);
    let rows: String = values.iter().enumerate().map(row).collect();
    (format!("time [s],roll [rad]\n{rows}"), values, step)
}

#[test]
fn what_lies_above_a_measured_band_is_weighed_with_the_integrand_of_the_part() {
    let s = Gyrosphere::seed();
    let (m, r, c) = (s.weight / s.gravity, s.lag * s.stiffness, s.stiffness);
    let lag = |w: f64| m / c / (1.0 + (w * s.lag).powi(2));
    let inertia = |w: f64| m * (c - m * w * w) / ((c - m * w * w).powi(2) + (r * w).powi(2));
    let flow = |w: f64| lag(w) + 0.5 * m / c / (1.0 + (4.0 * w).powi(2));
    let integrands: [&dyn Fn(f64) -> f64; 3] = [&lag, &inertia, &flow];
    let options: [&[&str]; 3] = [&[], &["--inertia"], &["--flow", "4s,0.5"]];
    for (words, part) in options.into_iter().zip(integrands) {
        for every in [1, 2, 4] {
            let (file, values, step) = recorded(every);
            let (code, text, message) =
                command("roll.csv", &file, &[words, &["--heading", "45", "--json"]].concat());
            assert_eq!(code, 0, "{message}");
            let told: serde_json::Value = serde_json::from_str(&text).unwrap();
            let of = |name: &str| told["roll"][name].as_f64().unwrap();
            let roll = Roll::new(of("A_rad2"), of("mu_per_s"), of("eps_rad_per_s")).unwrap();
            let (end, all) = (std::f64::consts::PI / step, 1e9);
            let above = mean_by_quadrature(&roll, [end, all], f64::INFINITY, part);
            let share = 100.0 * above / mean_by_quadrature(&roll, [1e-3, all], f64::INFINITY, part);
            let note = told["note"].as_str().unwrap();
            let wanted = if share < 0.0 {
                format!("would be {:.0} % larger", -share)
            } else {
                format!("{share:.0} % of the mean by the fit comes from frequencies above")
            };
            assert!(note.contains(&wanted), "{words:?} {every} {share}: {note}");
            // the same integrand under the measured spectrum
            let time: Vec<f64> = (0..values.len()).map(|k| k as f64 * step).collect();
            let even = even_samples(&time, &values).unwrap();
            let spectrum = welch(&even.values, even.step, (values.len() / 4).clamp(16, 4096)).unwrap();
            let moment = -0.5 * s.lever * s.lever * spectrum.integral(|w| w.powi(4) * part(w));
            let mean = s.weight / (s.gravity * s.momentum * s.earth_rate * s.latitude.cos()) * moment;
            let said = told["rows"][0]["measured_spectrum_mean_deg"].as_f64().unwrap();
            assert_relative_eq!(said, mean.to_degrees(), max_relative = 1e-6);
        }
    }
}

#[test]
fn a_sea_whose_waves_break_is_told() {
    let of = |words: &[&str]| -> serde_json::Value {
        let told = asked_json(words);
        let all = told["validity"].as_array().unwrap();
        all.iter().find(|v| v["figure"] == "steepness").cloned().unwrap_or_default()
    };
    // 8 m on waves of 9.81·16/2π = 25 m
    let steep = of(&["--sea=jonswap", "--height=8m", "--period=4s"]);
    let wanted = 8.0 * std::f64::consts::TAU / (9.81 * 16.0);
    assert_relative_eq!(steep["value"].as_f64().unwrap(), wanted, max_relative = 1e-9);
    assert!(steep["holds"] == false && steep["limit"] == 0.142);
    let (_, text, _) = asked(&["--sea=jonswap", "--height=8m", "--period=4s", "--heading=45"]);
    assert!(text.contains("BEYOND THE LINEAR THEORY") && text.contains("break"), "{text}");
    for words in
        [&["--sea=pm", "--height=12m"][..], &["--sea=jonswap"], &["--sea=bretschneider", "--height=3m"]]
    {
        assert_eq!(of(words)["holds"], true, "{words:?}");
    }
    assert!(of(&["--irregular=4deg,0.06,0.65"]).is_null());
}

#[test]
fn a_table_over_heights_tells_no_single_height() {
    for (sea, period) in [("pm", false), ("bretschneider", true), ("jonswap", true)] {
        let (code, text, message) = asked(&["--sea", sea, "--against", "height", "--sea-from", "60"]);
        assert_eq!(code, 0, "{message}");
        let line = text.lines().find(|l| l.starts_with("motion:")).unwrap();
        assert!(line.contains("each significant height") && !line.contains("3.00"), "{line}");
        assert_eq!(line.contains("8.0 s"), period, "{line}");
    }
    let (_, text, _) = asked(&["--sea=pm", "--height=3m", "--heading=45"]);
    assert!(text.contains("significant height 3.00 m, peak period"), "{text}");
}
