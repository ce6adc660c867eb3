//! Forms of laws that others met: by a square, over a length that moves, in a loop, turned over not at once, a heavy part
//! behind a body whose speed alone is known, and what is sure behind what only lowers the error more.

use crate::diagnose::noise;
use crate::laws_met::{inputs, named, run, run_with_two, runge_kutta, second_inputs, told};

/// A panel of a fifth of the craft's inertia, damped by 2 %: what the recording shows is the swing of both against each
/// other.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_heavy_panel_behind_a_speed() {
    let model = r#"
        name = "craft"
        [inputs]
        torque = { unit = "N*m" }
        [parameters]
        J = { value = 2, unit = "kg*m^2", fit = true, min = 0.1 }
        drag = { value = 0, unit = "N*m", fit = true }
        [states]
        w = { rate = "(torque + drag)/J", unit = "rad/s", initial = 0 }
        [outputs]
        rate = { equals = "w", unit = "deg/s" }
    "#;
    // J w' + Jp (w' + s'') = u, Jp (w' + s'') = -(k s + d s'); the panel alone swings at 3 rad/s
    let (hub, panel) = (1.6, 0.35);
    let states = run(|[w, s, v], u| {
        let pull = 9.0 * s + 2.0 * 0.02 * 3.0 * v;
        let own = (u + panel * pull) / hub;
        let _ = w;
        [own, v, -own - pull]
    });
    let rate = states.iter().map(|x| x[0].to_degrees()).collect();
    let answer = told(model, &[("torque", "N*m", inputs(), 0.0), ("rate", "deg/s", rate, 1.0)]);
    let found = named(&answer);
    assert!(matches!(found[..], [("extra-resonance", "w", c)] if (c - panel).abs() < 0.03), "{found:?}");
    let both = 3.0 * (1.0 + panel / hub).sqrt();
    assert!((answer.findings[0].parameters[1].value - both).abs() < 0.02, "{}", answer.says);
}

#[test]
fn wind_acts_by_its_square() {
    let model = r#"
        name = "dish"
        [inputs]
        torque = { unit = "N*m" }
        [parameters]
        J = { value = 2, unit = "kg*m^2", fit = true, min = 0.1 }
        b = { value = 3, unit = "N*m*s/rad", fit = true, min = 0 }
        k = { value = 8, unit = "N*m/rad" }
        [states]
        a = { rate = "w", unit = "rad", initial = 0 }
        w = { rate = "(torque - b*w - k*a)/J", unit = "rad/s", initial = 0 }
        [outputs]
        azimuth = { equals = "a", unit = "rad" }
    "#;
    let wind = |v: f64| 2.0 + 2.0 * v;
    let states =
        run_with_two(|[a, w], [u, v]| [w, (u + 0.1 * wind(v) * wind(v).abs() - 1.8 * w - 8.0 * a) / 1.5]);
    let azimuth = states.iter().map(|x| x[0]).collect();
    let blows = second_inputs().into_iter().map(wind).collect();
    let answer = told(
        model,
        &[("torque", "N*m", inputs(), 0.0), ("wind", "m/s", blows, 0.0), ("azimuth", "rad", azimuth, 0.004)],
    );
    let found = named(&answer);
    assert!(matches!(found[..], [("cross-coupling", "w", c)] if (c - 0.1).abs() < 2e-3), "{}", answer.says);
}

/// Wind whose mean outweighs its motion acts mean and all, and by its square from either side alike: no offset stands beside
/// the one, no product with its own past in the place of the other.
#[test]
fn wind_acts_as_it_is_recorded() {
    let model = r#"
        name = "cart"
        [inputs]
        push = { unit = "N" }
        [parameters]
        m = { value = 2, unit = "kg", fit = true, min = 0.1 }
        b = { value = 3, unit = "N*s/m", fit = true, min = 0 }
        [states]
        v = { rate = "(push - b*v)/m", unit = "m/s", initial = 0 }
        [outputs]
        speed = { equals = "v", unit = "m/s" }
    "#;
    let found = |mean: f64, law: &dyn Fn(f64) -> f64| {
        let states = run_with_two(|[v], [u, w]| [(u + law(mean + w) - 1.8 * v) / 1.5]);
        let speed = states.iter().map(|x| x[0]).collect();
        let wind = second_inputs().into_iter().map(|w| mean + w).collect();
        let columns =
            [("push", "N", inputs(), 0.0), ("wind", "m/s", wind, 0.0), ("speed", "m/s", speed, 0.01)];
        told(model, &columns)
    };
    let plain = found(8.0, &|w| 0.4 * w);
    assert!(
        matches!(named(&plain)[..], [("cross-coupling", "v", c)] if (c - 0.4).abs() < 5e-3),
        "{}",
        plain.says
    );
    let even = found(0.0, &|w| 0.2 * w * w);
    assert!(
        matches!(named(&even)[..], [("cross-coupling", "v", c)] if (c - 0.2).abs() < 5e-3),
        "{}",
        even.says
    );
}

/// A load on a rope that is hauled: the force of Coriolis, over the length.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_rope_that_is_hauled() {
    let model = r#"
        name = "load"
        [inputs]
        a = { unit = "m/s^2" }
        L = { unit = "m" }
        [parameters]
        g = { value = 9.81, unit = "m/s^2" }
        d = { value = 0.1, unit = "1/s", fit = true, min = 0, max = 5 }
        [states]
        th = { rate = "om", unit = "rad", initial = 0 }
        om = { rate = "-(g*sin(th) + a*cos(th))/L - d*om", unit = "rad/s", initial = 0 }
        [outputs]
        sway = { equals = "th", unit = "deg" }
    "#;
    // the third state is the length less 3 m
    let states = run_with_two(|[th, om, l], [u, v]| {
        let (length, hoist) = (3.0 + l, 0.5 * v);
        let swing = -(9.81 * th.sin() + 0.3 * u * th.cos()) / length;
        [om, swing - 0.08 * om - 2.0 * hoist * om / length, hoist]
    });
    let of = |k: usize, by: f64, from: f64| states.iter().map(|x| from + by * x[k]).collect::<Vec<f64>>();
    let moved = |u: Vec<f64>, by: f64| u.into_iter().map(|x| by * x).collect::<Vec<f64>>();
    let answer = told(
        model,
        &[
            ("a", "m/s^2", moved(inputs(), 0.3), 0.0),
            ("L", "m", of(2, 1.0, 3.0), 0.0),
            ("hoist", "m/s", moved(second_inputs(), 0.5), 0.0),
            ("sway", "deg", of(0, 180.0 / std::f64::consts::PI, 0.0), 0.05),
        ],
    );
    let found = named(&answer);
    assert!(
        matches!(found[..], [("product-coupling", "om", c)] if (c + 2.0).abs() < 0.05),
        "{}",
        answer.says
    );
}

/// A cell whose voltage is another while it is charged: the loop closes by and by with what flows.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn the_voltage_of_a_cell_runs_in_a_loop() {
    let model = r#"
        name = "cell"
        [inputs]
        I = { unit = "A" }
        [parameters]
        E = { value = 3.2, unit = "V", fit = true }
        k = { value = 0.01, unit = "V/(A*s)", fit = true, min = 0 }
        R = { value = 0.02, unit = "V/A", fit = true, min = 0 }
        [states]
        q = { rate = "-I", unit = "A*s", initial = 0 }
        [outputs]
        U = { equals = "E + k*q - R*I", unit = "V" }
    "#;
    // z' = q' - |q'| z/z0, z0 = 0.8 C, 30 mV high
    let states = run(|[_, z], u| [-u, -u - u.abs() * z / 0.8]);
    let volts = states.iter().zip(inputs()).map(|([q, z], i)| 3.3 + 0.02 * q - 0.015 * i + 0.03 / 0.8 * z);
    let answer = told(model, &[("I", "A", inputs(), 0.0), ("U", "V", volts.collect(), 0.002)]);
    let found = named(&answer);
    assert!(
        matches!(found[..], [("hysteresis", "U", k)] if (k - 0.03 / 0.8).abs() < 2e-3),
        "{}",
        answer.says
    );
    assert!((answer.findings[0].parameters[1].value - 0.8).abs() < 0.05, "{}", answer.says);
}

/// An oven whose heater acts late, in a room that warms and cools: many forms of that slow effect lower the error by more
/// than the delay does, and none of them is as sure.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_is_late_beside_a_slow_room() {
    let model = r#"
        name = "oven"
        [inputs]
        P = { unit = "W" }
        [parameters]
        C = { value = 9, unit = "J/K", fit = true, min = 0.1 }
        h = { value = 3, unit = "W/K", fit = true, min = 0.05 }
        Ta = { value = 24, unit = "degC" }
        [states]
        T = { rate = "(P - h*(T - Ta))/C", unit = "degC", initial = "fit" }
        [outputs]
        oven = { equals = "T", unit = "degC" }
    "#;
    let (step, count) = (0.02, inputs().len());
    let mut room = noise(count, 77);
    for i in 1..count {
        room[i] = 0.995 * room[i - 1] + 0.1 * room[i];
    }
    // what the model holds at 24 degC is about 24.7 degC
    for r in &mut room {
        *r += 0.7;
    }
    let at = |t: f64| {
        let i = (t / step).round() as usize;
        room[i.min(count - 1)]
    };
    let drive = |t: f64| {
        let lines = [(0.05, 0.3), (0.13, 0.2), (0.33, 1.7), (0.71, 4.0), (1.21, 0.9)];
        lines.iter().map(|(f, p)| (std::f64::consts::TAU * f * t + p).sin()).sum::<f64>()
    };
    let power = |t: f64| 70.0 + 15.0 * drive(t);
    let states = runge_kutta(
        (step, count, 4),
        |t| [power(t - 0.11), at(t)],
        |[x], [p, r]| [(p - 2.3 * (x + 30.0 - r)) / 4.6],
    );
    let oven = states.iter().map(|x| 54.0 + x[0]).collect();
    let given = (0..count).map(|i| power(step * i as f64)).collect();
    let warm = room.iter().map(|r| 24.0 + r).collect();
    let answer =
        told(model, &[("P", "W", given, 0.0), ("room", "degC", warm, 0.0), ("oven", "degC", oven, 0.1)]);
    let found = named(&answer);
    let of = |code: &str| found.iter().find(|f| f.0 == code).map_or(f64::NAN, |f| f.2);
    assert!((of("input-delay") - 0.11).abs() < 0.01, "{}", answer.says);
    assert!((of("parameter-dependence") - 1.0).abs() < 0.03 && found.len() == 2, "{}", answer.says);
}

/// Friction that turns over within a range of speeds, beside another effect: no third one is named for the difference.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn friction_that_turns_over_not_at_once() {
    let model = r#"
        name = "gate"
        [inputs]
        push = { unit = "N" }
        [parameters]
        m = { value = 1.5, unit = "kg" }
        c = { value = 2, unit = "N*s/m", fit = true, min = 0 }
        k = { value = 8, unit = "N/m" }
        [states]
        x = { rate = "v", unit = "m", initial = 0 }
        v = { rate = "(push - c*v - k*x)/m", unit = "m/s", initial = 0 }
        [outputs]
        place = { equals = "x", unit = "m" }
    "#;
    let states = run_with_two(|[x, v], [u, head]| {
        [v, (u + 0.6 * head - 1.6 * v - 8.0 * x - 0.5 * (v / 0.02).tanh()) / 1.5]
    });
    let place = states.iter().map(|x| x[0]).collect();
    let answer = told(
        model,
        &[("push", "N", inputs(), 0.0), ("head", "m", second_inputs(), 0.0), ("place", "m", place, 0.0005)],
    );
    let mut found: Vec<&str> = named(&answer).iter().map(|f| f.0).collect();
    found.sort_unstable();
    assert_eq!(found, ["cross-coupling", "dry-friction"], "{}", answer.says);
}
