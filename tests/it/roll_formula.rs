//! Closed forms on regular roll and in a sea: the printed letters and numbers beside the part followed in time and
//! beside complex arithmetic.

use crate::roll_error::asked;
use approx::assert_relative_eq;
use gyrospec::Complex64;
use gyrospec::gyro::Gyrosphere;
use gyrospec::gyro::elastic::{Elastic, Inertia, Lag, Relaxing};
use gyrospec::gyro::seed::Regular;
use gyrospec::rolling::{ClosedForm, Excitation, Source, closed_form_on};
use serde_json::Value;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

fn said(words: &[&str]) -> Value {
    let (code, out, message) = asked(words);
    assert_eq!(code, 0, "{words:?}: {message}");
    serde_json::from_str(&out).unwrap()
}

fn mean(told: &Value) -> f64 {
    told["values"][0]["mean_deg"].as_f64().unwrap()
}

/// The mean of P/(g H U cos φ) W₂ x over some periods of a roll of 5° at 0.7 rad/s on heading 30°, degrees: the part,
/// ẏ of its states and its x, followed by Runge and Kutta's method.
fn followed<const N: usize>(
    low: f64,
    rates: impl Fn(&[f64; N], f64) -> [f64; N],
    x: impl Fn(&[f64; N]) -> f64,
) -> f64 {
    let s = Gyrosphere::seed();
    let (p, heading, steps) = (0.7, 30f64.to_radians(), 2000);
    let roll = |t: f64| -5f64.to_radians() * low * p * p * s.lever * (p * t).sin();
    let (w1, w2) = (|t: f64| -roll(t) * heading.cos(), |t: f64| roll(t) * heading.sin());
    let h = TAU / p / f64::from(steps);
    let (mut y, mut sum) = ([0.0; N], 0.0);
    let plus = |y: &[f64; N], k: &[f64; N], h: f64| -> [f64; N] { std::array::from_fn(|i| y[i] + h * k[i]) };
    for k in 0..40 * steps {
        let t = h * f64::from(k);
        if k >= 39 * steps {
            sum += w2(t) * x(&y) / f64::from(steps);
        }
        let k1 = rates(&y, w1(t));
        let k2 = rates(&plus(&y, &k1, 0.5 * h), w1(t + 0.5 * h));
        let k3 = rates(&plus(&y, &k2, 0.5 * h), w1(t + 0.5 * h));
        let k4 = rates(&plus(&y, &k3, h), w1(t + h));
        y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
    }
    (s.weight / (s.gravity * s.momentum * s.earth_rate * s.latitude.cos()) * sum).to_degrees()
}

/// Options, part, band and the mean in time.
type Case<'a> = (&'a [&'a str], Box<dyn Elastic>, Option<f64>, f64);

#[test]
fn on_regular_roll_letters_and_values_are_those_of_the_part_followed_in_time() {
    let s = Gyrosphere::seed();
    let m = s.weight / s.gravity;
    let r = s.lag * s.stiffness;
    let lag = |low: f64| followed(low, |y: &[f64; 1], w| [(m / s.stiffness * w - y[0]) / s.lag], |y| y[0]);
    let cases: [Case<'_>; 3] = [
        (&[], Box::new(Lag), None, lag(1.0)),
        (&["--band", "2rad/s"], Box::new(Lag), Some(2.0), lag(1.0 / (1.0 + 0.35 * 0.35))),
        (
            &["--flow", "3s,0.2"],
            Box::new(Relaxing { time: 3.0, share: 0.2 }),
            None,
            followed(
                1.0,
                |y: &[f64; 2], w| {
                    [(m / s.stiffness * w - y[0]) / s.lag, (0.2 * m / s.stiffness * w - y[1]) / 3.0]
                },
                |y| y[0] + y[1],
            ),
        ),
    ];
    let letters = [
        ("P", s.weight),
        ("g", s.gravity),
        ("H", s.momentum),
        ("U", s.earth_rate),
        ("C0", s.stiffness),
        ("T", s.lag),
        ("h", s.lever),
        ("phi", s.latitude),
        ("K", 30f64.to_radians()),
        ("theta_0", 5f64.to_radians()),
        ("p", 0.7),
        ("omega_c", 2.0),
        ("T_2", 3.0),
        ("kappa", 0.2),
        ("m", m),
        ("r", r),
    ];
    let letters: BTreeMap<String, f64> = letters.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
    let of = |part: &dyn Elastic, band: Option<f64>| {
        let roll = Source::Regular(Regular { amplitude: 0.1, frequency: 0.7 });
        let ClosedForm::Written(derived) = closed_form_on(part, &Excitation { source: roll, band }).unwrap()
        else {
            panic!("not written out")
        };
        derived.formula.evaluate(&letters).unwrap().to_degrees()
    };
    for (words, part, band, truth) in cases {
        let call = [&["--regular", "5deg,0.7", "--heading", "30", "--formula", "--json"], words].concat();
        assert_relative_eq!(mean(&said(&call)), truth, max_relative = 1e-6);
        assert_relative_eq!(of(part.as_ref(), band), truth, max_relative = 1e-6);
    }
    // with inertia by complex arithmetic: ½ θ₀² p⁴ h² Re m/(C₀ − m p² + j r p)
    let give = Complex64::new(m, 0.0) / Complex64::new(s.stiffness - m * 0.49, r * 0.7);
    let sines = 0.5 * (5f64.to_radians() * 0.49 * s.lever).powi(2) * -0.5 * 60f64.to_radians().sin();
    let truth = (s.weight / (s.gravity * s.momentum * s.earth_rate * s.latitude.cos()) * sines * give.re)
        .to_degrees();
    let call = ["--regular", "5deg,0.7", "--heading", "30", "--formula", "--json", "--inertia"];
    // the value stands for a roll so narrow that 1e-7 of it is lost
    assert_relative_eq!(mean(&said(&call)), truth, max_relative = 1e-6);
    assert_relative_eq!(of(&Inertia, None), truth, max_relative = 1e-9);
}

/// The coefficients, rising, of a polynomial in s as it is printed.
fn coefficients(text: &str) -> Vec<f64> {
    let text = text.trim_matches(['(', ')', ' ']).replace('−', "-").replace(" - ", " + -");
    let mut all = vec![0.0; 40];
    for term in text.split(" + ") {
        let (number, power) = term.split_once('s').map_or((term, None), |(n, p)| (n, Some(p)));
        let digits: String = power
            .unwrap_or_default()
            .chars()
            .map(|c| char::from_digit("⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|d| d == c).unwrap() as u32, 10).unwrap())
            .collect();
        let power = power.map_or(0, |_| digits.parse().unwrap_or(1));
        all[power] = if number.trim().is_empty() { 1.0 } else { number.trim().parse().unwrap() };
    }
    all
}

#[test]
fn in_a_sea_the_printed_filter_gives_the_mean() {
    let s = Gyrosphere::seed();
    for (words, order) in [
        (&["--sea", "jonswap"][..], 13),
        (
            &[
                "--sea",
                "bretschneider",
                "--height",
                "2m",
                "--period",
                "9s",
                "--sea-from",
                "50",
                "--band",
                "2.5",
            ],
            0,
        ),
    ] {
        let told = said(&[words, &["--heading", "30", "--formula", "--json"]].concat());
        let text = told["formula"].as_str().unwrap();
        let filter = text.lines().find(|l| l.contains("W(s) =")).unwrap_or_else(|| panic!("{text}"));
        let (above, below) = filter.split_once("= ").unwrap().1.split_once('/').unwrap();
        let (above, below) = (coefficients(above), coefficients(below));
        let at = |c: &[f64], w: f64| -> Complex64 {
            c.iter().enumerate().map(|(k, x)| Complex64::new(0.0, w).powi(k as i32) * x).sum()
        };
        // P/(g H U cos φ) · (1/2π) ∫ h sin K · Re(−P h cos K/(g C₀ (1 + jTω))) |W|² dω by the midpoints of ω = tan u
        let count = 400_000;
        let each = (0..count).map(|k| {
            let u = (f64::from(k) + 0.5) / f64::from(count) * TAU / 4.0;
            let w = u.tan();
            let power = (at(&above, w) / at(&below, w)).norm_sqr();
            power / (1.0 + (s.lag * w).powi(2)) / u.cos().powi(2)
        });
        let integral = each.sum::<f64>() / f64::from(count) * TAU / 4.0 / (TAU / 2.0);
        let (sin, cos) = 30f64.to_radians().sin_cos();
        let alpha = -s.weight.powi(2) * s.lever.powi(2) * sin * cos * integral
            / (s.gravity.powi(2) * s.momentum * s.earth_rate * s.stiffness * s.latitude.cos());
        assert_relative_eq!(mean(&told), alpha.to_degrees(), max_relative = 1e-6);
        assert!(order == 0 || told["order"] == order, "{}", told["order"]);
        assert_eq!(told["points_checked"], 0);
    }
    let (code, _, message) = asked(&["--sea", "pm", "--sea-from", "60", "--also", "pitch", "--formula"]);
    assert!(
        code == 2 && message.contains("pitch changes the mean too") && message.contains("--formula"),
        "{message}"
    );
    // heave changes no mean, and does not stand in the way
    assert_eq!(asked(&["--sea", "pm", "--also", "heave", "--formula"]).0, 0);
}
