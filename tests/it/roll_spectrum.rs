//! `roll-error --spectrum`: beside complex arithmetic, beside the variance, and beside the periodogram of a simulation.

use crate::roll_error::asked;
use approx::assert_relative_eq;
use gyrospec::Complex64;
use gyrospec::gyro::Gyrosphere;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::Value;
use std::f64::consts::{PI, TAU};

const BANDED: [&str; 7] =
    ["--irregular", "10deg,0.1,0.8", "--band", "2.5rad/s", "--heading", "45", "--spectrum"];

fn said(words: &[&str]) -> Value {
    let (code, out, message) = asked(&[words, &["--json"]].concat());
    assert_eq!(code, 0, "{words:?}: {message}");
    serde_json::from_str(&out).unwrap()
}

/// ω and the densities of the whole, of the swing and of the products, rad²·s.
fn densities(told: &Value) -> Vec<[f64; 4]> {
    let names = ["omega_rad_per_s", "density_deg2_s", "by_swing_deg2_s", "by_products_deg2_s"];
    let rows = told["densities"].as_array().unwrap().iter();
    rows.map(|r| {
        let [w, all @ ..] = names.map(|n| r[n].as_f64().unwrap());
        let [a, b, c] = all.map(|x| x.to_radians().to_radians());
        [w, a, b, c]
    })
    .collect()
}

/// The density of hθ̈ of the roll behind its two low-passes.
fn acceleration(w: f64) -> f64 {
    let (variance, mu, eps) = (10f64.to_radians().powi(2), 0.1, 0.8);
    let b2: f64 = mu * mu + eps * eps;
    let roll = 4.0 * variance * mu * b2 / ((b2 - w * w).powi(2) + 4.0 * mu * mu * w * w);
    (3.0 * w * w).powi(2) * roll / (1.0 + (w / 2.5).powi(2)).powi(2)
}

/// What a swing of W₂ and a push m on β make of α at s = jω: (2.1) solved by hand.
fn answers(w: f64) -> [Complex64; 2] {
    let g = Gyrosphere::seed();
    let (l, c, n, f) =
        (g.pendulous / g.momentum, g.damper / g.momentum, g.earth_rate * g.latitude.cos(), g.flow);
    let s = Complex64::new(0.0, w);
    // α s = l β + c λ + (l/g) W₂,  β s = −n α + m,  λ (s + F) = −F β − (F/g) W₂
    let by_beta = Complex64::from(l) - c * f / (s + f);
    let whole = s + n * by_beta / s;
    [by_beta / g.gravity / whole, by_beta / s / whole]
}

#[test]
fn its_values_are_those_of_complex_arithmetic() {
    let told = said(&BANDED);
    let all = densities(&told);
    let g = Gyrosphere::seed();
    // M_y/H = −(P/g)²/(H C₀) sin K cos K · a·(R a), R = 1/(1 + jTω)
    let push = (g.weight / g.gravity).powi(2) / (g.momentum * g.stiffness) * 0.5;
    let lag = |w: f64| 1.0 / Complex64::new(1.0, g.lag * w);
    let step = 2e-3;
    for k in [0, all.len() / 5, all.len() / 2, 3 * all.len() / 4, all.len() - 20] {
        let [w, whole, swing, products] = all[k];
        let [by_w2, by_push] = answers(w);
        assert_relative_eq!(swing, 0.5 * acceleration(w) * by_w2.norm_sqr(), max_relative = 1e-9);
        // (1/2π) ∫ S(ν) S(ω − ν) (|R(ω − ν)|² + R*(ν) R(ω − ν)) dν
        let folded: f64 = (-40_000..40_000)
            .map(|i| {
                let v = (f64::from(i) + 0.5) * step;
                let both = lag(w - v).norm_sqr() + (lag(v).conj() * lag(w - v)).re;
                acceleration(v) * acceleration(w - v) * both * step
            })
            .sum();
        let truth = push * push * folded / TAU * by_push.norm_sqr();
        assert_relative_eq!(products, truth, max_relative = 1e-5);
        assert_relative_eq!(whole, swing + products, max_relative = 1e-12);
    }
}

#[test]
fn it_adds_up_to_the_variance_and_rises_where_narrow_motions_are() {
    for words in [
        &BANDED[..],
        &["--irregular", "4deg,0.002,0.65", "--band", "3", "--spectrum"],
        &["--sea", "pm", "--spectrum"],
    ] {
        let told = said(words);
        let all = densities(&told);
        // trapezoids of S ω over ln ω, and what lies below the first, where S is level
        let area = |part: usize| -> f64 {
            let inner: f64 = all
                .windows(2)
                .map(|p| 0.5 * (p[0][part] * p[0][0] + p[1][part] * p[1][0]) * (p[1][0] / p[0][0]).ln())
                .sum();
            (inner + all[0][part] * all[0][0]) / PI
        };
        let spread = |name: &str| told[name].as_f64().unwrap().to_radians();
        for (part, name) in [(1, "spread_deg"), (2, "spread_by_swing_deg"), (3, "spread_by_products_deg")] {
            assert_relative_eq!(area(part).sqrt(), spread(name), max_relative = 0.02);
        }
    }
}

#[test]
fn a_simulation_has_its_spectrum() {
    let told = said(&BANDED);
    let g = Gyrosphere::seed();
    let (l, c, n, f) =
        (g.pendulous / g.momentum, g.damper / g.momentum, g.earth_rate * g.latitude.cos(), g.flow);
    let push = (g.weight / g.gravity).powi(2) / (g.momentum * g.stiffness) * 0.5;
    let (mu, eps, corner) = (0.1, 0.8, 2.5);
    let b2: f64 = mu * mu + eps * eps;
    let strength = (4.0 * 10f64.to_radians().powi(2) * mu * b2).sqrt();
    // θ, θ̇ and two low-passes; the acceleration behind them; R a; α, β, λ
    let rates = |y: &[f64; 8], w: f64| -> [f64; 8] {
        let rough = -b2 * y[0] - 2.0 * mu * y[1];
        let [low, smooth] = [corner * (y[0] - y[2]), corner * (y[2] - y[3])];
        // θ̇₁ = ω_c(θ − θ₁), θ̇₂ = ω_c(θ₁ − θ₂), so that θ̈₂ = ω_c(θ̇₁ − θ̇₂)
        let a = 3.0 * corner * (low - smooth);
        let (w2, half) = (a * 0.5f64.sqrt(), y[4]);
        let m = -push * a * half;
        [
            y[1],
            rough + strength * w,
            low,
            smooth,
            (a - y[4]) / g.lag,
            l * y[6] + c * y[7] + l / g.gravity * w2,
            m - n * y[5],
            -f * (y[6] + y[7]) - f / g.gravity * w2,
        ]
    };
    let (step, segment, segments) = (0.05, 8000usize, 1000usize);
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let mut y = [0.0; 8];
    let mut advance = |y: &mut [f64; 8]| {
        let deviate: f64 = (0..12).map(|_| rng.random_range(0.0..1.0)).sum::<f64>() - 6.0;
        let w = deviate / f64::sqrt(step);
        let plus =
            |y: &[f64; 8], k: &[f64; 8], h: f64| -> [f64; 8] { std::array::from_fn(|i| y[i] + h * k[i]) };
        let k1 = rates(y, w);
        let k2 = rates(&plus(y, &k1, 0.5 * step), w);
        let k3 = rates(&plus(y, &k2, 0.5 * step), w);
        let k4 = rates(&plus(y, &k3, step), w);
        *y = std::array::from_fn(|i| y[i] + step / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
    };
    for _ in 0..20_000 {
        advance(&mut y);
    }
    let all = densities(&told);
    let near = |w: f64| all.iter().min_by(|a, b| (a[0] - w).abs().total_cmp(&(b[0] - w).abs())).unwrap();
    let chosen = [near(0.3), near(0.8), near(1.5)];
    // Hann's window against the slow wandering
    let window: Vec<f64> = (0..segment).map(|k| 1.0 - (TAU * k as f64 / segment as f64).cos()).collect();
    let mut power = [0.0; 3];
    for _ in 0..segments {
        let mut sums = [Complex64::ZERO; 3];
        for (k, weight) in window.iter().enumerate() {
            for (sum, row) in sums.iter_mut().zip(chosen) {
                *sum += Complex64::cis(-row[0] * step * k as f64) * (weight * y[5]);
            }
            advance(&mut y);
        }
        for (p, sum) in power.iter_mut().zip(sums) {
            // E|Σ w α e^{−jωt}|² = S Σ w²/step
            *p += sum.norm_sqr() * step / (1.5 * segment as f64) / segments as f64;
        }
    }
    for (p, row) in power.iter().zip(chosen) {
        println!("{} rad/s: simulated {p:e}, told {:e}", row[0], row[1]);
        // a periodogram's deviation is its mean: 2.58/√1000 in 99 of 100 cases
        assert_relative_eq!(*p, row[1], max_relative = 0.083);
    }
}

#[test]
fn what_has_no_spectrum_is_refused_with_its_reason() {
    for (words, code, says) in [
        (&["--regular", "5deg,0.7", "--spectrum"][..], 2, "lines at 0.7 and 1.4 rad/s"),
        (&["--friction", "2N", "--band", "2.5", "--spectrum"], 2, "not linear"),
        (&["--heading", "1", "--heading", "2", "--spectrum"], 2, "one --heading"),
        (&["--spectrum", "--formula"], 2, "cannot be used with"),
        (&["--spectrum", "--json", "--html", "-"], 2, "one result"),
        (&["examples/roll.csv", "--spectrum"], 2, "a recording says nothing of"),
    ] {
        let (found, _, message) = asked(words);
        assert!(found == code && message.contains(says), "{words:?}: {found} {message}");
    }
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("s.html");
    let (code, out, _) = asked(&["--spectrum", "--html", page.to_str().unwrap()]);
    assert!(code == 0 && out.contains("two-sided") && out.contains("min"), "{out}");
    let page = std::fs::read_to_string(page).unwrap();
    assert!(page.contains("by products of motions") && page.contains("<polyline"));
}
