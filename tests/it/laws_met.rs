//! Laws that others met: an elastic joint behind a speed, a sensor with a bent calibration, the reading of one sensor in
//! another, a known coefficient of the wrong sign, two effects of which one hides the other.

use crate::diagnose::{diagnosed, noise};
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use std::f64::consts::TAU;

const STEP: f64 = 0.02;
const COUNT: usize = 3000;

fn input(t: f64) -> f64 {
    let lines = [(0.05, 0.3), (0.13, 0.2), (0.33, 1.7), (0.71, 4.0), (1.21, 0.9), (2.3, 2.8)];
    lines.iter().map(|(f, p)| (TAU * f * t + p).sin()).sum()
}

/// Another input: the same 37.3 s later.
fn second(t: f64) -> f64 {
    input(t + 37.3)
}

/// The states of a system at every sample, from rest; its input is straight between the samples.
pub fn run<const N: usize>(rates: impl Fn([f64; N], f64) -> [f64; N]) -> Vec<[f64; N]> {
    run_with_two(|x, [u, _]| rates(x, u))
}

pub fn run_with_two<const N: usize>(rates: impl Fn([f64; N], [f64; 2]) -> [f64; N]) -> Vec<[f64; N]> {
    runge_kutta((STEP, COUNT, 10), |t| [input(t), second(t)], rates)
}

/// The states of a system from rest at so many samples a step apart, by the rule of Runge and Kutta with so many steps
/// in each; inputs are straight between the samples.
pub fn runge_kutta<const N: usize, const M: usize>(
    (step, count, fine): (f64, usize, usize),
    inputs: impl Fn(f64) -> [f64; M],
    rates: impl Fn([f64; N], [f64; M]) -> [f64; N],
) -> Vec<[f64; N]> {
    let ahead = |x: [f64; N], k: [f64; N], h: f64| std::array::from_fn(|i| x[i] + h * k[i]);
    let h = step / fine as f64;
    let (mut x, mut all) = ([0.0; N], Vec::new());
    for i in 0..count {
        all.push(x);
        let [from, to] = [i, i + 1].map(|i| inputs(step * i as f64));
        for s in 0..fine {
            let u = |share: f64| -> [f64; M] {
                std::array::from_fn(|k| from[k] + (to[k] - from[k]) * (s as f64 + share) / fine as f64)
            };
            let k1 = rates(x, u(0.0));
            let k2 = rates(ahead(x, k1, 0.5 * h), u(0.5));
            let k3 = rates(ahead(x, k2, 0.5 * h), u(0.5));
            let k4 = rates(ahead(x, k3, h), u(1.0));
            x = std::array::from_fn(|j| x[j] + h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]));
        }
    }
    all
}

/// Channels with noise of a size, the first of them the input without any.
pub fn told(model: &str, columns: &[(&str, &str, Vec<f64>, f64)]) -> Answer {
    let time: Vec<f64> = (0..COUNT).map(|i| STEP * i as f64).collect();
    let channel = |(k, (name, unit, values, size)): (usize, &(&str, &str, Vec<f64>, f64))| {
        let unit = Unit::parse(unit).unwrap();
        let noisy = values.iter().zip(noise(COUNT, 11 + k as u64)).map(|(v, e)| unit.to_si(v + size * e));
        let noisy = noisy.collect();
        Channel::new(*name, unit, time.clone(), noisy)
    };
    let recording =
        Recording::from_channels("made", columns.iter().enumerate().map(channel).collect()).unwrap();
    diagnosed(&Model::parse(model).unwrap(), recording).answer
}

pub fn inputs() -> Vec<f64> {
    (0..COUNT).map(|i| input(STEP * i as f64)).collect()
}

/// The same 37.3 s later.
pub fn second_inputs() -> Vec<f64> {
    (0..COUNT).map(|i| second(STEP * i as f64)).collect()
}

/// The codes and places that are named, with the first value of each.
pub fn named(answer: &Answer) -> Vec<(&str, &str, f64)> {
    assert_eq!(answer.verdict, Verdict::Named, "{}", answer.says);
    answer.findings.iter().map(|f| (f.code.as_str(), f.site.name.as_str(), f.parameters[0].value)).collect()
}

#[test]
fn a_load_behind_an_elastic_joint_of_a_speed() {
    let model = r#"
        name = "joint"
        [inputs]
        torque = { unit = "N*m" }
        [parameters]
        J = { value = 1.3, unit = "kg*m^2", fit = true, min = 0.3, max = 10 }
        b = { value = 2, unit = "N*m*s/rad", fit = true, min = 0.5, max = 20 }
        [states]
        w = { rate = "(torque - b*w)/J", unit = "rad/s", initial = 0 }
        [outputs]
        speed = { equals = "w", unit = "rad/s" }
    "#;
    // motor of 1.2 and load of 0.7 kg m2; the load alone swings at √(k/0.7) = 14 rad/s, both at √(k/0.7 + k/1.2)
    let (k, d) = (0.7 * 14.0 * 14.0, 0.4);
    let states = run(|[w, twist, load], u| {
        let through = k * twist + d * (w - load);
        [(u - 3.0 * w - through) / 1.2, w - load, through / 0.7]
    });
    let speed = states.iter().map(|x| x[0]).collect();
    let answer = told(model, &[("torque", "N*m", inputs(), 0.0), ("speed", "rad/s", speed, 0.005)]);
    let found = named(&answer);
    assert!(matches!(found[..], [("extra-resonance", "w", c)] if (c - 0.7).abs() < 0.05), "{found:?}");
    let both = 14.0 * (1.0f64 + 0.7 / 1.2).sqrt();
    assert!((answer.findings[0].parameters[1].value - both).abs() < 0.25, "{}", answer.says);
}

/// What a heated body loses to a room.
pub const FURNACE: &str = r#"
    name = "furnace"
    [inputs]
    power = { unit = "W" }
    [parameters]
    C = { value = 0.3, unit = "J/K", fit = true, min = 0.02, max = 3 }
    H = { value = 0.08, unit = "W/K", fit = true, min = 0.005, max = 1 }
    room = { value = 20, unit = "degC" }
    [states]
    T = { rate = "(power - H*(T - room))/C", unit = "K", initial = 293.15 }
    [outputs]
    probe = { equals = "T", unit = "degC" }
"#;

#[test]
fn a_sensor_whose_calibration_bends() {
    // the probe is right at 0 degC and reads less the hotter it is
    let above = run(|[x], u| [(u + 3.0 - 0.05 * x) / 0.2]);
    let power = inputs().iter().map(|u| u + 3.0).collect();
    let reads = above.iter().map(|[x]| 20.0 + x).map(|t| t - 2e-3 * t * t).collect();
    let answer = told(FURNACE, &[("power", "W", power, 0.0), ("probe", "degC", reads, 0.02)]);
    let found = named(&answer);
    assert!(matches!(found[..], [("output-square", "probe", a)] if (a + 2e-3).abs() < 2e-4), "{found:?}");
}

#[test]
fn a_resistance_that_grows_in_series() {
    // the loss begins at 0.1 W/K and falls as scale grows on the wall, to 0.1/(1 + 0.02 t); time is the second state
    let states = run(|[x, t], u| [(u + 3.0 - 0.1 / (1.0 + 0.02 * t) * x) / 0.2, 1.0]);
    let power = inputs().iter().map(|u| u + 3.0).collect();
    let reads = states.iter().map(|x| 20.0 + x[0]).collect();
    let answer = told(FURNACE, &[("power", "W", power, 0.0), ("probe", "degC", reads, 0.02)]);
    assert!(matches!(answer.verdict, Verdict::Named | Verdict::Tie), "{}", answer.says);
    let first = &answer.findings[0];
    assert_eq!((first.code.as_str(), first.site.name.as_str()), ("parameter-drift", "H"), "{}", answer.says);
    // about t0 = 18 s, the middle of what is fitted: (1 + 0.02 t)/1.36 = 1 + (0.02/1.36)(t - t0)
    assert!(first.term.contains("H/(1 +"), "{}", first.term);
    assert!((first.parameters[0].value - 0.02 / 1.36).abs() < 2e-4, "{}", answer.says);
}

#[test]
fn a_sensor_that_also_feels_what_another_does() {
    let model = r#"
        name = "mass"
        [inputs]
        force = { unit = "N" }
        [parameters]
        m = { value = 2, unit = "kg", fit = true, min = 0.2, max = 20 }
        c = { value = 1, unit = "N*s/m", fit = true, min = 0.1, max = 10 }
        k = { value = 30, unit = "N/m", fit = true, min = 3, max = 300 }
        [states]
        x = { rate = "v", unit = "m", initial = 0 }
        v = { rate = "(force - c*v - k*x)/m", unit = "m/s", initial = 0 }
        [outputs]
        position = { equals = "x", unit = "m" }
        acceleration = { equals = "(force - c*v - k*x)/m", unit = "m/s^2" }
    "#;
    let acceleration = |[x, v]: [f64; 2], u: f64| (u - 0.8 * v - 25.0 * x) / 1.5;
    let states = run(|x: [f64; 2], u| [x[1], acceleration(x, u)]);
    let felt: Vec<f64> = states.iter().zip(inputs()).map(|(x, u)| acceleration(*x, u)).collect();
    let seen = states.iter().zip(&felt).map(|(x, a)| x[0] + 4e-3 * a).collect();
    let columns =
        [("force", "N", inputs(), 0.0), ("position", "m", seen, 5e-4), ("acceleration", "m/s^2", felt, 5e-3)];
    let answer = told(model, &columns);
    let found = named(&answer);
    assert!(
        matches!(found[..], [("output-cross-axis", "position", c)] if (c - 4e-3).abs() < 2e-4),
        "{found:?}"
    );
}

#[test]
fn a_known_coefficient_of_the_wrong_sign() {
    let model = |kw: &str| {
        format!(
            r#"
            name = "ferry"
            [inputs]
            wind = {{ unit = "m/s" }}
            rudder = {{ unit = "rad" }}
            [parameters]
            K = {{ value = 0.5, unit = "1/s", fit = true, min = 0.05, max = 5 }}
            T = {{ value = 1.5, unit = "s", fit = true, min = 0.2, max = 20 }}
            kw = {{ value = 0.3, unit = "1/m"{kw} }}
            [states]
            r = {{ rate = "(K*rudder - r - kw*wind)/T", unit = "rad/s", initial = 0 }}
            [outputs]
            turn = {{ equals = "r", unit = "rad/s" }}
            "#
        )
    };
    let states = run_with_two(|[r], [wind, rudder]| [(0.8 * rudder + 0.4 * wind - r) / 2.0]);
    let turn: Vec<f64> = states.iter().map(|x| x[0]).collect();
    let rudder: Vec<f64> = (0..COUNT).map(|i| second(STEP * i as f64)).collect();
    // known, or pressed against 0: the wind acts otherwise, or its channel counts the other way
    for kw in ["", ", fit = true, min = 0, max = 1"] {
        let rudder = ("rudder", "rad", rudder.clone(), 0.0);
        let columns = [("wind", "m/s", inputs(), 0.0), rudder, ("turn", "rad/s", turn.clone(), 0.01)];
        let answer = told(&model(kw), &columns);
        assert_ne!(answer.verdict, Verdict::NothingMissing, "{kw}: {}", answer.says);
        assert!(answer.says.contains("wind"), "{kw}: {}", answer.says);
        assert!(answer.proof[0].holdout_after < 1.1 * 0.01, "{kw}: {}", answer.says);
    }
}

#[test]
fn an_effect_that_hides_another_is_found_with_it() {
    let model = r#"
        name = "tank"
        [inputs]
        order = { unit = "1" }
        [parameters]
        Q = { value = 0.8, unit = "m/s", fit = true, min = 0.1, max = 10 }
        k = { value = 0.05, unit = "1/s", fit = true, min = 0.002, max = 1 }
        [states]
        h = { rate = "Q*order - k*h", unit = "m", initial = 0 }
        [outputs]
        level = { equals = "h", unit = "m" }
    "#;
    // the pump does nothing below 0.6, and the float follows with a lag of 0.4 s
    let states = run(|[h, float], u| {
        let pumped = u - u.clamp(-0.6, 0.6);
        [pumped - 0.03 * h, (h - float) / 0.4]
    });
    let level = states.iter().map(|x| x[1]).collect();
    let answer = told(model, &[("order", "1", inputs(), 0.0), ("level", "m", level, 0.004)]);
    assert!(matches!(answer.verdict, Verdict::Named | Verdict::Tie), "{}", answer.says);
    assert_eq!(answer.findings.len(), 2, "{}", answer.says);
    // a lag of the float or of the tank, which commute
    let is_lag = |code: &str| ["neglected-inertia", "output-lag", "input-lag"].contains(&code);
    for f in &answer.findings {
        let wanted = if f.code == "input-dead-zone" { 0.6 } else { 0.4 };
        assert!(wanted > 0.5 || is_lag(&f.code), "{}", answer.says);
        assert!((f.parameters[0].value - wanted).abs() < 0.03, "{}", answer.says);
    }
}

#[test]
fn a_model_that_divides_by_a_state_starts_where_that_is_measured() {
    // water that flows through a vessel whose level is a state: V′ = 0.2 + 0.05 u − k V, V T′ = (0.2 + 0.05 u) (60 − T)
    let model = r#"
        name = "vessel"
        [inputs]
        flow = { unit = "l/s" }
        [parameters]
        k = { value = 0.08, unit = "1/s", fit = true, min = 0.01, max = 1 }
        hot = { value = 50, unit = "degC", fit = true }
        [states]
        V = { rate = "flow - k*V", unit = "l", initial = "fit" }
        T = { rate = "flow*(hot - T)/V", unit = "K", initial = "fit" }
        [outputs]
        volume = { equals = "V", unit = "l" }
        temperature = { equals = "T", unit = "degC" }
    "#;
    let flow = |u: f64| 0.2 + 0.05 * u;
    let states = run(|[v, t], u| [flow(u) - 0.1 * (2.0 + v), flow(u) * (60.0 - 20.0 - t) / (2.0 + v)]);
    let columns = [
        ("flow", "l/s", inputs().iter().map(|u| flow(*u)).collect(), 0.0),
        ("volume", "l", states.iter().map(|x| 2.0 + x[0]).collect(), 0.002),
        ("temperature", "degC", states.iter().map(|x| 20.0 + x[1]).collect(), 0.05),
    ];
    let answer = told(model, &columns);
    assert_eq!(answer.verdict, Verdict::NothingMissing, "{}", answer.says);
    assert!((answer.parameters[0].after - 0.1).abs() < 1e-3, "{}", answer.parameters[0].after);
}

#[test]
fn a_compass_that_feels_the_acceleration_to_the_north() {
    // alpha'' = -w^2 (alpha + k v) - 2 d w alpha', and alpha is thrown by 0.13 v' beside that: its ballistic deflection
    let model = r#"
        name = "gyrocompass, in a hurry"
        [inputs]
        north = { unit = "m/s" }
        [parameters]
        w = { value = 0.5, unit = "rad/s", fit = true, min = 0.05, max = 5 }
        d = { value = 0.4, unit = "1", fit = true, min = 0.01, max = 3 }
        k = { value = 0.2, unit = "deg*s/m" }
        [states]
        alpha = { rate = "turn", unit = "deg", initial = "fit" }
        turn = { rate = "-w^2*(alpha + k*north) - 2*d*w*turn", unit = "deg/s", initial = 0 }
        [outputs]
        off = { equals = "alpha", unit = "deg" }
    "#;
    let accelerates = |t: f64| (input(t + 1e-4) - input(t - 1e-4)) / 2e-4;
    let (w, d, throws) = (0.6, 0.3, 0.13);
    let states = runge_kutta(
        (STEP, COUNT, 10),
        |t| [input(t), accelerates(t)],
        |[a, b], [v, by]| [b + throws * by, -w * w * (a + 0.2 * v) - 2.0 * d * w * b],
    );
    let off = states.iter().map(|x| x[0]).collect();
    let answer = told(model, &[("north", "m/s", inputs(), 0.0), ("off", "deg", off, 0.01)]);
    let found = named(&answer);
    assert!(matches!(found[..], [("rate-coupling", "alpha", c)] if (c - throws).abs() < 0.003), "{found:?}");
}
