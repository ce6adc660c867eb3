//! Guards that jump: what slides on a surface, or is on its way to it, when a held input or another switch moves it.

use super::sensitivities::check;
use super::{channel, outputs, recording, simulator, times};
use gyrospec::record::{Channel, Hold, Recording};

/// Sampled ten times as often as the input.
const STEP: f64 = 0.05;
const END: f64 = 14.0;

/// A staircase; the limit of 1.7 V/s ends some of its stairs on the way.
fn stairs(t: f64) -> f64 {
    [0.0, 4.0, 4.0, -1.0, 2.5, 2.5, 3.0][(0.5 * (t + 1e-9)) as usize % 7]
}

fn held(u: impl Fn(f64) -> f64) -> Recording {
    let mut input = channel("u", "V", &times(END, 0.5), u);
    input.hold = Hold::Previous;
    recording(vec![input, channel("y", "V", &times(END, STEP), |_| 0.0)])
}

fn model(states: &str, output: &str) -> String {
    format!(
        r#"
        name = "jumps"
        [inputs]
        u = {{ unit = "V" }}
        [parameters]
        r = {{ value = 1.7, unit = "V/s" }}
        a = {{ value = 3, unit = "V" }}
        w = {{ value = 0.4, unit = "V" }}
        T = {{ value = 0.7, unit = "s" }}
        one = {{ value = 1, unit = "s" }}
        [states]
        {states}
        [outputs]
        y = {{ equals = "{output}", unit = "V" }}
        "#
    )
}

/// What follows a goal that stands still between two samples, no faster than 1.7 V/s.
fn limited(start: f64, goal: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut y = start;
    let next = |t: &f64| {
        let now = y;
        y += (goal(*t) - y).clamp(-1.7 * STEP, 1.7 * STEP);
        now
    };
    times(END, STEP).iter().map(next).collect()
}

fn off(got: &[f64], wanted: &[f64]) -> f64 {
    assert_eq!(got.len(), wanted.len());
    got.iter().zip(wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

const STILL: &str = r#"x = { rate = "u/one", unit = "V", initial = 0 }"#;

#[test]
fn a_limited_rate_follows_a_held_input() {
    let got = outputs(&simulator(&model(STILL, "rate_limit(u, r)"), &held(stairs)));
    let wanted = limited(0.0, stairs);
    assert!(off(&got, &wanted) < 1e-9, "{}", off(&got, &wanted));
    // rests, ramps both ways, and turns round on the way
    let turned = wanted.windows(3).filter(|w| (w[1] - w[0]) * (w[2] - w[1]) < 0.0).count();
    assert!(turned > 0 && wanted.windows(2).any(|w| w[0] == w[1]));
}

#[test]
fn a_limited_rate_follows_a_relay_that_a_state_throws() {
    // x runs from -1 V at 1 V/s: over half the gap, 0.2 V, at 1.2 s
    let states = r#"x = { rate = "u/one", unit = "V", initial = -1 }"#;
    let got = outputs(&simulator(&model(states, "rate_limit(a*relay(x, w), r)"), &held(|_| 1.0)));
    let wanted = limited(-3.0, |t| if t < 1.2 - 1e-9 { -3.0 } else { 3.0 });
    assert!(off(&got, &wanted) < 1e-9, "{}", off(&got, &wanted));
}

#[test]
fn what_a_belt_carries_along_follows_its_jumps() {
    // dry friction of 1.7 V/s between the belt, whose speed is u, and what lies on it
    let states = r#"x = { rate = "r*sign(u - x)", unit = "V", initial = 0 }"#;
    let got = outputs(&simulator(&model(states, "x"), &held(stairs)));
    let wanted = limited(0.0, stairs);
    assert!(off(&got, &wanted) < 1e-9, "{}", off(&got, &wanted));
}

#[test]
fn tangents_of_a_limited_rate_behind_a_held_input() {
    for limited in ["rate_limit(u, r)", "rate_limit(delay(u, w/r), r)"] {
        let states = format!(r#"x = {{ rate = "({limited} - x)/T", unit = "V", initial = 0.3 }}"#);
        check(&simulator(&model(&states, "x"), &held(stairs)), 1e-5, 1e-4);
    }
}

/// x' = u, y = x + 2 max(u, 0) + 3 v with u set after what is measured at its samples and v with them: what y shows at a sample is
/// under the u before it and the v of it.
#[test]
fn what_is_set_after_a_reading_is_seen_by_the_next() {
    let time = times(6.0, 0.5);
    let (u, v) = (|t: f64| stairs(t), |t: f64| (3.0 * t).sin());
    let after = Channel { hold: Hold::AfterReading, ..channel("u", "V", &time, u) };
    let with = Channel { hold: Hold::Previous, ..channel("v", "V", &time, v) };
    let r = recording(vec![after, with, channel("y", "V", &time, |_| 0.0)]);
    let before = |k: usize| u(time[k.saturating_sub(1)]);
    let inputs = "name = \"after\"\n[inputs]\nu = { unit = \"V\" }\nv = { unit = \"V\" }\n";
    let moving = "[parameters]\none = { value = 1, unit = \"s\" }\n[states]\nx = { rate = \"u/one\", unit = \"V\", initial = 0 }\n";
    let output = |x: &str| format!("[outputs]\ny = {{ equals = \"{x}2*max(u, 0) + 3*v\", unit = \"V\" }}");
    for (model, of_x) in
        [(format!("{inputs}{moving}{}", output("x + ")), 1.0), (format!("{inputs}{}", output("")), 0.0)]
    {
        let got = outputs(&simulator(&model, &r));
        let mut x = 0.0;
        for (k, got) in got.iter().enumerate() {
            let wanted = of_x * x + 2.0 * before(k).max(0.0) + 3.0 * v(time[k]);
            assert!((got - wanted).abs() < 1e-9, "{got} for {wanted} at {}", time[k]);
            x += 0.5 * u(time[k]);
        }
    }
}
