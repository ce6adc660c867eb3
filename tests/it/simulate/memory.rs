use super::{channel, outputs, recording, simulator, times, worst};
use std::f64::consts::PI;

/// A model whose output is an expression of the input u and a state x with rate u, from 0.
fn driven(expression: &str, parameters: &str) -> String {
    format!(
        r#"
        name = "memory"
        [inputs]
        u = {{ unit = "V" }}
        [parameters]
        {parameters}
        one = {{ value = 1, unit = "s" }}
        [states]
        x = {{ rate = "u/one", unit = "V", initial = 0 }}
        [outputs]
        y = {{ equals = "{expression}", unit = "V" }}
        "#
    )
}

fn check(expression: &str, parameters: &str, u: impl Fn(f64) -> f64, y: impl Fn(f64) -> f64, within: f64) {
    let time = times(12.0, 0.01);
    let r = recording(vec![channel("u", "V", &time, u), channel("y", "V", &time, |_| 0.0)]);
    let got = outputs(&simulator(&driven(expression, parameters), &r));
    let off = worst(&time, &got, y);
    assert!(off < within, "{expression}: {off}");
}

#[test]
fn delays_of_inputs_and_of_states() {
    let t = "T = { value = 0.333, unit = \"s\" }";
    let late = |t: f64| (t - 0.333).max(0.0);
    check("delay(u, T)", t, f64::sin, |t| late(t).sin(), 2e-5);
    check("delay(x, T)", t, f64::sin, |t| 1.0 - late(t).cos(), 3e-5);
    check("delay(delay(u, T), 2*T)", t, f64::sin, |t| (t - 0.999).max(0.0).sin(), 2e-5);
}

/// What an input makes through a memory, some time ago, is what the late input makes.
#[test]
fn delays_of_what_remembers_an_input() {
    let both = "T = { value = 0.333, unit = \"s\" }\nTl = { value = 0.5, unit = \"s\" }";
    let lagged = |t: f64| t - 0.5 + 0.5 * (-t / 0.5f64).exp();
    check("delay(lag(u, Tl), T)", both, |t| t, |t| lagged((t - 0.333).max(0.0)), 1e-6);
    check(
        "delay(2*u - lag(u, Tl), T)",
        both,
        |t| t,
        |t| 2.0 * (t - 0.333).max(0.0) - lagged((t - 0.333).max(0.0)),
        1e-6,
    );
    let twice = "delay(delay(lag(u, Tl), T), 2*T)";
    check(twice, both, |t| t, |t| lagged((t - 0.999).max(0.0)), 1e-6);
    // a state that takes part is remembered as it was: x = t^2/2
    let with_state = |t: f64| lagged(t) + 0.5 * t * t;
    check("delay(lag(u, Tl) + x/one*one, T)", both, |t| t, |t| with_state((t - 0.333).max(0.0)), 1e-4);
}

#[test]
fn a_lag_follows() {
    // y + T y' = t: y = t - T + T exp(-t/T)
    let y = |t: f64| t - 0.5 + 0.5 * (-t / 0.5f64).exp();
    check("lag(u, T)", "T = { value = 0.5, unit = \"s\" }", |t| t, y, 1e-6);
}

#[test]
fn backlash_lets_go_at_the_turns() {
    let gap = "gap = { value = 0.4, unit = \"V\" }";
    let y = |t: f64| {
        // u = sin t, half gap 0.2: pushed up to 0.8 at pi/2, then down to -0.8, and so on.
        let pushed_up = (t.sin() - 0.2).max(0.0);
        if t <= PI / 2.0 {
            return pushed_up;
        }
        let turn = ((t - PI / 2.0) / PI).floor();
        let side = if (turn as i32) % 2 == 0 { 1.0 } else { -1.0 };
        let from: f64 = 0.8 * side;
        if side > 0.0 { from.min(t.sin() + 0.2) } else { from.max(t.sin() - 0.2) }
    };
    check("backlash(u, gap)", gap, f64::sin, y, 1e-4);
    check("hysteresis(u, gap)", gap, f64::sin, |t| t.sin() - y(t), 1e-4);
}

#[test]
fn a_relay_switches_beyond_its_gap() {
    // x' = u*relay: the output is the relay itself, of u = sin t, thresholds +-0.5.
    let y = |t: f64| {
        let phase = t % (2.0 * PI);
        let (up, down) = (PI / 6.0, 7.0 * PI / 6.0);
        if t < up || (phase >= up && phase < down) { 1.0 } else { -1.0 }
    };
    let time = times(12.0, 0.0101);
    let r = recording(vec![channel("u", "V", &time, f64::sin), channel("y", "V", &time, |_| 0.0)]);
    let model = driven("one*relay(u, 1*v)/one", "v = { value = 1, unit = \"V\" }")
        .replace("unit = \"V\" }\n        \"", "");
    let model = model.replace("one*relay(u, 1*v)/one", "v*relay(u, v)");
    let got = outputs(&simulator(&model, &r));
    let wrong = time.iter().zip(&got).filter(|(t, g)| **g != y(**t)).count();
    assert!(wrong <= 4, "{wrong}");
}

#[test]
fn a_rate_limit_follows_what_it_can() {
    // u = sin t limited to 0.5 V/s: leaves at once, meets the sine where t/2 = sin t, then sticks
    // to it until the sine falls faster than the limit, at t = 2 pi/3.
    let time = times(2.5, 0.01);
    let r = recording(vec![channel("u", "V", &time, f64::sin), channel("y", "V", &time, |_| 0.0)]);
    let model = driven("rate_limit(u, r)", "r = { value = 0.5, unit = \"V/s\" }");
    let got = outputs(&simulator(&model, &r));
    let meet = 1.895_494_267_033_981;
    let leave = 2.0 * PI / 3.0;
    let y = |t: f64| {
        if t < meet {
            0.5 * t
        } else if t < leave {
            t.sin()
        } else {
            leave.sin() - 0.5 * (t - leave)
        }
    };
    assert!(worst(&time, &got, y) < 5e-5, "{}", worst(&time, &got, y));
}
