//! `gyrospec strapdown`: its figures beside closed forms, and what it refuses.

use approx::assert_relative_eq;
use serde_json::Value;
use std::f64::consts::{SQRT_2, TAU};
use std::process::Command;

fn called(words: &str, json: bool) -> (i32, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gyrospec"));
    let out =
        command.arg("strapdown").args(words.split(' ')).args(json.then_some("--json")).output().unwrap();
    let said = String::from_utf8_lossy(&out.stdout) + String::from_utf8_lossy(&out.stderr);
    (out.status.code().unwrap(), said.into_owned())
}

fn said(words: &str) -> Value {
    let (code, said) = called(words, true);
    assert_eq!(code, 0, "{words}: {said}");
    serde_json::from_str(&said).unwrap()
}

fn number(of: &Value, at: &str) -> f64 {
    of.pointer(at).and_then(Value::as_f64).unwrap_or_else(|| panic!("{at} in {of}"))
}

/// The effect of a name.
fn effect<'a>(of: &'a Value, name: &str) -> &'a Value {
    of["effects"].as_array().unwrap().iter().find(|e| e["effect"] == name).unwrap()
}

const EARTH: f64 = 7.292_115e-5;

#[test]
fn narrow_vibrations_are_sines_with_their_closed_forms() {
    let told = said(
        "--resonance 30Hz,1e-7 --angular y=0.1mrad --angular z=0.2mrad,-90 --linear y=2m/s^2 --linear z=3m/s^2,30deg \
         --anisoinertia zy,2g*cm^2,3e-3 --anisoelasticity yz,100g,3e-3,3kHz,2kHz,0.1 --square 2e-6s^2/m \
         --latitude 60 --heading 30",
    );
    let (a, b, p, q, w) = (1e-4 * SQRT_2, 2e-4 * SQRT_2, 2.0 * SQRT_2, 3.0 * SQRT_2, 30.0 * TAU);
    let third = 30f64.to_radians();
    // y and z in quadrature cone about x: ½ a b ω, and what is read is the opposite
    assert_relative_eq!(
        number(effect(&told, "coning"), "/drift_rad_per_s/0"),
        -0.5 * a * b * w,
        max_relative = 1e-5
    );
    // ⟨φ × a⟩_x = ½ a q cos 30° − ½ b p cos 90°
    let scull = 0.5 * a * q * third.cos();
    assert_relative_eq!(number(effect(&told, "sculling"), "/bias_m_per_s2/0"), -scull, max_relative = 1e-5);
    // rates in quadrature have no product
    let inertia = number(effect(&told, "anisoinertia"), "/drift_rad_per_s/2");
    assert!(inertia.abs() < 1e-5 * 2e-7 / 3e-3 * a * b * w * w, "{inertia}");
    let (slow, fast) = (TAU * 2000.0, TAU * 3000.0);
    let elastic = 0.1 / 3e-3 * (1.0 / (slow * slow) - 1.0 / (fast * fast)) * 0.5 * p * q * third.cos();
    let found = number(effect(&told, "anisoelasticity"), "/drift_rad_per_s/1");
    // the suspension's own resonance adds some (30/2000)² and its damping a little out of phase
    assert_relative_eq!(found, elastic, max_relative = 5e-3);
    let square = effect(&told, "square-term");
    assert_relative_eq!(number(square, "/bias_m_per_s2/2"), 2e-6 * 0.5 * q * q, max_relative = 1e-9);
    // the sum, and the heading by its parts along the east: x sin K + y cos K
    let (whole, names) =
        (effect(&told, "together"), ["coning", "sculling", "anisoinertia", "anisoelasticity", "square-term"]);
    let sum = |at: &str| names.iter().map(|n| number(effect(&told, n), at)).sum::<f64>();
    let east = |key: &str| 0.5 * sum(&format!("/{key}/0")) + third.cos() * sum(&format!("/{key}/1"));
    let error = -east("drift_rad_per_s") / (0.5 * EARTH) + east("bias_m_per_s2") / 9.80665 * 3f64.sqrt();
    assert_relative_eq!(number(whole, "/heading_error_deg"), error.to_degrees(), max_relative = 1e-9);
    assert_relative_eq!(sum("/heading_error_deg"), error.to_degrees(), max_relative = 1e-9);
}

#[test]
fn spreads_and_a_rotor_have_their_closed_forms() {
    let told = said(
        "--walk 0.006deg/h^0.5 --latitude 60 --heading 30 --loop 10min,0.7 --align 400s --irregular 4deg,0.06,0.65 \
         --lever 3m --tuned-rotor z,6000rpm,60g*cm^2,1g*cm^2,1arcsec",
    );
    let (walk, north, w, z) = (1e-4f64.to_radians(), 0.5 * EARTH, TAU / 600.0, 0.7);
    let by_walk = walk * (w / (4.0 * z * north * north) + (1.0 + 4.0 * z * z) / (4.0 * z * w)).sqrt();
    assert_relative_eq!(number(&told, "/spread/by_walk_deg"), by_walk.to_degrees(), max_relative = 1e-12);
    assert_relative_eq!(
        number(&told, "/spread/aligned_deg"),
        (walk / (north * 20.0)).to_degrees(),
        max_relative = 1e-12
    );
    // (1/2π)∫ (k₂ h ω³ sin K/g)² S_θ/|H|² dω by the rule of the midpoint
    let (mu, eps, gain) = (0.06, 0.65, w * w / north * 3.0 * 0.5 / 9.80665);
    let b2: f64 = mu * mu + eps * eps;
    let density = |x: f64| {
        let roll = 4.0 * 4f64.to_radians().powi(2) * mu * b2 / ((b2 - x * x).powi(2) + 4.0 * mu * mu * x * x);
        (gain * x.powi(3)).powi(2) * roll / ((w * w - x * x).powi(2) + (2.0 * z * w * x).powi(2))
    };
    let count = 200_000;
    let each = (0..count).map(|k| {
        let t = (f64::from(k) + 0.5) / f64::from(count) * TAU / 4.0;
        density(0.3 * t.tan()) * 0.3 / t.cos().powi(2)
    });
    let variance = each.sum::<f64>() / f64::from(count) / 2.0;
    assert_relative_eq!(
        number(&told, "/spread/by_sea_deg"),
        variance.sqrt().to_degrees(),
        max_relative = 1e-6
    );
    // κ N θ₀ with κ = 1/240
    let drift = TAU * 100.0 / 240.0 * (1.0 / 3600f64).to_radians();
    assert_relative_eq!(number(&told, "/tuned_rotor/drift_rad_per_s"), drift, max_relative = 1e-9);
    assert_relative_eq!(
        number(&told, "/tuned_rotor/largest_heading_error_deg"),
        (drift / north).to_degrees(),
        max_relative = 1e-9
    );
}

#[test]
fn words_say_what_and_which_way() {
    let (code, text) = called(
        "--resonance 30Hz,0.05 --angular x=0.1mrad --angular y=0.1mrad,-90deg --coherence 0.9 --latitude 60 --heading 45",
        false,
    );
    assert_eq!(code, 0, "{text}");
    for words in [
        "angle about y: standard deviation 1e-4 rad about 30 Hz",
        "coherence of each two: 0.9",
        "drift about z",
        "°/h",
        "reads high",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    // a heading that no small angle is
    let far = "--tuned-rotor z,6000rpm,60g*cm^2,1g*cm^2,1arcsec --latitude 45";
    assert!(called(far, false).1.contains("BEYOND THE LINEAR THEORY"));
    assert_eq!(
        (
            &said(far)["linear_theory_holds"],
            &said(&far.replace("1arcsec", "0.1arcsec"))["linear_theory_holds"]
        ),
        (&Value::Bool(false), &Value::Bool(true))
    );
    // in phase: no cone, and it is said so
    let (code, text) = called("--resonance 30Hz,0.05 --angular x=0.1mrad --angular y=0.1mrad", false);
    assert!(code == 0 && text.contains("not in the phase for it"), "{text}");
}

#[test]
fn what_is_of_no_use_or_out_of_reach_is_refused_with_its_reason() {
    let cone = "--resonance 30Hz,0.1 --angular x=1mrad --angular y=1mrad,-90";
    for (words, says) in [
        ("--latitude 60", "nothing is asked"),
        ("--angular x=1mrad", "at which frequency"),
        ("--resonance 30Hz,0.1 --angular x=1mrad", "one --angular alone"),
        ("--resonance 30Hz,0.1 --linear x=1m/s^2", "--linear alone"),
        ("--resonance 30Hz,0.1 --angular x=1mrad --angular x=2mrad", "comes twice"),
        ("--resonance 30Hz,0.1 --angular w=1mrad", "no axis"),
        ("--resonance 30Hz,0.1 --angular 1mrad", "AXIS=DEVIATION"),
        ("--resonance 30Hz,0.1 --angular x=1mrad,0,20Hz", "AXIS=DEVIATION"),
        ("--resonance 30Hz,0.1 --angular x=1 --angular y=1mrad", "did you mean 1mrad?"),
        ("--resonance 30Hz,0 --angular x=1mrad --angular y=1mrad", "lies outside"),
        ("--resonance 30Hz,0.1 --tuned-rotor z,6000rpm,1e-5,1e-7,1e-6", "--resonance is of no use"),
        ("--resonance 30Hz,0.1 --angular x=1mrad --linear x=1m/s^2 --coherence 2", "lies outside"),
        ("--tuned-rotor z,6000rpm,1e-5,1e-7,1e-6 --coherence 0.5", "--coherence is of no use"),
        ("--tuned-rotor z,6000rpm,1e-5,1e-5,1e-6", "not small beside the rotor"),
        ("--tuned-rotor xy,6000rpm,1e-5,1e-7,1e-6", "an axis, x, y or z"),
        ("--tuned-rotor z,6000rpm", "takes 4 numbers"),
        ("--tuned-rotor z,6000rpm,1e-5,1e-7,1e-6 --heading 10", "--heading is of no use without --latitude"),
        ("--tuned-rotor z,6000rpm,1e-5,1e-7,1e-6 --heading 10 --latitude 5", "--heading is of no use here"),
        ("--walk 1e-6 --latitude 50", "--loop or --align"),
        ("--walk 1e-6 --align 10s", "--latitude"),
        ("--loop 10min,0.7 --latitude 50", "--walk or --irregular"),
        ("--align 10s --latitude 50", "--walk"),
        ("--irregular 4deg,0.1,0.6 --latitude 50", "go together"),
        ("--irregular 4deg,0.1,0.6 --lever 2m --latitude 50 --loop 10min,0.7", "--heading"),
    ] {
        let (code, said) = called(words, false);
        assert!(code == 2 && said.contains(says), "{words}: {said}");
    }
    for (more, says) in [
        ("--anisoinertia xz,1e-7,1e-3", "about its input and its spin axis"),
        ("--anisoinertia xx,1e-7,1e-3", "are one"),
        ("--anisoinertia x,1e-7,1e-3", "such as xz"),
        ("--anisoelasticity xy,0.1,1e-3,900Hz,1kHz,0.1", "needs --linear"),
        ("--square 1e-6", "--square needs --linear"),
        ("--latitude 90", "U cos φ"),
    ] {
        let (code, said) = called(&format!("{cone} {more}"), false);
        assert!(code == 2 && said.contains(says), "{more}: {said}");
    }
}
