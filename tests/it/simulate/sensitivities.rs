use super::{channel, recording, simulator, times};
use gyrospec::record::{Hold, Recording};
use gyrospec::simulate::{Simulator, Unknown};

/// Compares exact tangents with central differences, as shares of the largest tangent.
pub fn check(s: &Simulator, step: f64, within: f64) {
    let (p, x) = (s.parameters(), s.initials());
    let parameters = (0..p.len()).map(Unknown::Parameter);
    let unknowns: Vec<Unknown> = parameters.chain((0..x.len()).map(Unknown::Initial)).collect();
    let run = s.run_with_sensitivities(&p, &x, &unknowns).unwrap();
    for (u, unknown) in unknowns.iter().enumerate() {
        let moved = |sign: f64| {
            let (mut p, mut x) = (p.clone(), x.clone());
            let (value, h) = match *unknown {
                Unknown::Parameter(k) => (&mut p[k], step * s.parameters()[k].abs().max(1e-3)),
                Unknown::Initial(k) => (&mut x[k], step),
            };
            *value += sign * h;
            (s.run(&p, &x).unwrap().outputs.remove(0), h)
        };
        let ((above, h), (below, _)) = (moved(1.0), moved(-1.0));
        let exact = &run.sensitivities[0][u];
        let size = exact.iter().fold(1e-9f64, |m, v| m.max(v.abs()));
        let off: Vec<f64> = exact
            .iter()
            .zip(above.iter().zip(&below))
            .map(|(e, (a, b))| (e - (a - b) / (2.0 * h)).abs())
            .collect();
        let mean = off.iter().sum::<f64>() / off.len() as f64;
        assert!(mean < within * size, "{unknown:?}: {} of {size}", mean / size);
    }
}

fn axis(rate: &str, more: &str) -> String {
    format!(
        r#"
        name = "axis"
        [inputs]
        force = {{ unit = "N" }}
        [parameters]
        M = {{ value = 1.3, unit = "kg" }}
        k = {{ value = 20, unit = "N/m" }}
        Fc = {{ value = 0.6, unit = "N" }}
        {more}
        [states]
        q = {{ rate = "v", unit = "m", initial = 0.3 }}
        v = {{ rate = "{rate}", unit = "m/s", initial = 0.1 }}
        [outputs]
        position = {{ equals = "q", unit = "m" }}
        "#
    )
}

fn record(hold: Hold) -> Recording {
    let time = times(6.0, 0.02);
    let coarse = times(6.0, 0.5);
    let mut force = channel("force", "N", &coarse, |t| 2.0 * (1.3 * t).sin() + (2.9 * t).cos());
    force.hold = hold;
    recording(vec![force, channel("position", "m", &time, |_| 0.0)])
}

#[test]
fn smooth_models() {
    let s = simulator(
        &axis("(force - k*q - Fc*tanh(v/s))/M", "s = { value = 0.3, unit = \"m/s\" }"),
        &record(Hold::Linear),
    );
    check(&s, 1e-6, 1e-6);
}

#[test]
fn through_stick_and_slip() {
    let s = simulator(&axis("(force - k*q - Fc*sign(v))/M", ""), &record(Hold::Linear));
    let events = s.run(&s.parameters(), &s.initials()).unwrap().events;
    assert!(events > 5, "{events}");
    check(&s, 1e-6, 1e-4);
}

#[test]
fn through_delays_of_straight_and_of_held_inputs() {
    let model = axis(
        "(delay(force, T) - k*q - Fc*tanh(v/s))/M",
        "s = { value = 0.3, unit = \"m/s\" }\nT = { value = 0.23, unit = \"s\" }",
    );
    check(&simulator(&model, &record(Hold::Linear)), 1e-5, 1e-4);
    check(&simulator(&model, &record(Hold::Previous)), 1e-5, 1e-4);
}

/// Two copies of a held input that jump at one time each move with a delay of their own, and one that does not move
/// may jump beside them.
#[test]
fn through_delays_of_held_inputs_that_jump_together() {
    for (first, second) in [(0.23, 0.23), (0.0, 0.0)] {
        let model = axis(
            "(0.5*delay(force, T) + 0.3*delay(force, S) + 0.2*force - k*q - Fc*tanh(v/s))/M",
            &format!(
                "s = {{ value = 0.3, unit = \"m/s\" }}\nT = {{ value = {first:?}, unit = \"s\" }}\nS = {{ value = {second:?}, unit = \"s\" }}"
            ),
        );
        check(&simulator(&model, &record(Hold::Previous)), 1e-5, 1e-4);
    }
}

/// A clock of another rate: copies of a held input, each of its own delay, of which one or two count at a time.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn through_the_rate_of_a_clock() {
    let copies: Vec<String> =
        (0..=4).map(|i| format!("delay(force, -rate*{i}*part)*max(0, 1 - abs(t/part - {i}))")).collect();
    for rate in [0.0, -0.003] {
        let model = axis(
            &format!("(({}) - k*q - Fc*tanh(v/s))/M", copies.join(" + ")),
            &format!(
                "s = {{ value = 0.3, unit = \"m/s\" }}\npart = {{ value = 1, unit = \"s\" }}\nrate = {{ value = {rate:?}, unit = \"1\" }}"
            ),
        );
        check(&simulator(&model, &record(Hold::Previous)), 1e-5, 1e-4);
    }
}

#[test]
fn through_delays_of_states_and_backlash() {
    let more = "T = { value = 0.23, unit = \"s\" }\ngap = { value = 0.05, unit = \"m\" }";
    check(
        &simulator(
            &axis(
                "(force - k*delay(q, T) - 8*Fc*v*d)/M",
                &format!("{more}\nd = {{ value = 1, unit = \"s/m\" }}"),
            ),
            &record(Hold::Linear),
        ),
        1e-5,
        1e-3,
    );
    check(
        &simulator(
            &axis(
                "(force - k*backlash(q, gap) - 4*Fc*v*d)/M",
                &format!("{more}\nd = {{ value = 1, unit = \"s/m\" }}"),
            ),
            &record(Hold::Linear),
        ),
        1e-6,
        1e-2,
    );
}

#[test]
fn through_an_end_stop_and_a_steady_start() {
    let more = "L = { value = 0.15, unit = \"m\" }\nks = { value = 900, unit = \"N/m\" }";
    let model = axis(
        "(force - k*q - ks*(max(q, L) - L) - Fc*v*d)/M",
        &format!("{more}\nd = {{ value = 1, unit = \"s/m\" }}"),
    );
    check(&simulator(&model, &record(Hold::Linear)), 1e-5, 5e-4);
    let steady = model
        .replace("initial = 0.3", "initial = \"steady\"")
        .replace("initial = 0.1", "initial = \"steady\"");
    let s = simulator(&steady, &record(Hold::Linear));
    let run = s.run(&s.parameters(), &s.initials()).unwrap();
    assert!((run.outputs[0][0] - 1.0 / 20.0).abs() < 1e-12);
}
