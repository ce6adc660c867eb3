//! Laws of a state whose rate is a definition, of a sensor that gives a multiple of a rate, and of two axes of a rotor.

use crate::laws_met::{inputs, named, run, run_with_two, second_inputs, told};

/// What a body on springs feels in parts of g.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn an_accelerometer_in_parts_of_g() {
    let model = r#"
        name = "shelf"
        [inputs]
        ground = { unit = "m/s^2" }
        [parameters]
        c = { value = 1, unit = "N*s/m", fit = true, min = 0.05, max = 20 }
        k = { value = 60, unit = "N/m", fit = true, min = 5, max = 500 }
        m = { value = 2, unit = "kg" }
        g = { value = 9.80665, unit = "m/s^2" }
        [states]
        x = { rate = "v", unit = "m", initial = 0 }
        v = { rate = "-(c*v + k*x)/m - ground", unit = "m/s", initial = 0 }
        [outputs]
        shift = { equals = "x", unit = "m" }
        felt = { equals = "-(c*v + k*x)/(m*g)", unit = "1" }
    "#;
    let force = |x: f64, v: f64| -1.2 * v - 50.0 * x - 3.0 * v * v.abs();
    let states = run(|[x, v], ground| [v, force(x, v) / 2.0 - ground]);
    let shift = states.iter().map(|x| x[0]).collect();
    let felt = states.iter().map(|x| force(x[0], x[1]) / (2.0 * 9.80665)).collect();
    let columns =
        [("ground", "m/s^2", inputs(), 0.0), ("shift", "m", shift, 0.001), ("felt", "1", felt, 0.002)];
    let answer = told(model, &columns);
    let found = named(&answer);
    assert!(
        matches!(found[..], [("quadratic-damping", "v", d)] if (d - 1.5).abs() < 0.08),
        "{}",
        answer.says
    );
}

/// A roll whose acceleration is a definition, which an accelerometer above the axis feels beside gravity: what acts there
/// acts in both, in the unit of the moments.
#[test]
fn a_rate_that_is_a_definition_beside_a_tilt() {
    let model = r#"
        name = "roll of a bridge"
        [inputs]
        moment = { unit = "N*m" }
        [parameters]
        J = { value = 2, unit = "kg*m^2", fit = true, min = 0.2, max = 20 }
        b = { value = 1, unit = "N*m*s", fit = true, min = 0, max = 20 }
        k = { value = 15, unit = "N*m", fit = true, min = 1, max = 200 }
        z = { value = 3, unit = "m" }
        g = { value = 9.80665, unit = "m/s^2" }
        [definitions]
        turning = { equals = "(moment - b*p - k*sin(phi))/J", unit = "rad/s^2" }
        [states]
        phi = { rate = "p", unit = "rad", initial = 0 }
        p = { rate = "turning", unit = "rad/s", initial = 0 }
        [outputs]
        roll = { equals = "phi", unit = "rad" }
        across = { equals = "(z*turning + g*sin(phi))/g", unit = "1" }
    "#;
    let turning = |phi: f64, p: f64, m: f64| (m - 0.6 * p - 1.5 * p * p.abs() - 12.0 * phi.sin()) / 1.5;
    let moments: Vec<f64> = inputs().iter().map(|x| 2.0 * x).collect();
    let states = run(|[phi, p], m| [p, turning(phi, p, 2.0 * m)]);
    let roll = states.iter().map(|x| x[0]).collect();
    let across = states.iter().zip(&moments);
    let across = across.map(|(x, m)| (3.0 * turning(x[0], x[1], *m)) / 9.80665 + x[0].sin()).collect();
    let columns =
        [("moment", "N*m", moments, 0.0), ("roll", "rad", roll, 0.004), ("across", "1", across, 0.02)];
    let answer = told(model, &columns);
    let found = named(&answer);
    assert!(matches!(found[..], [("quadratic-damping", "p", c)] if (c - 1.5).abs() < 0.1), "{}", answer.says);
}

/// Two axes of a platform whose rotor turns at a recorded speed that the model does not use: one coefficient, the
/// rotor's moment of inertia, acts on both with opposite signs.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_rotor_on_two_axes() {
    let model = r#"
        name = "platform"
        [inputs]
        M = { unit = "N*m" }
        [parameters]
        Ja = { value = 1, unit = "kg*m^2", fit = true, min = 0.1, max = 10 }
        Jb = { value = 1, unit = "kg*m^2", fit = true, min = 0.1, max = 10 }
        ca = { value = 0.5, unit = "N*m*s", fit = true, min = 0, max = 10 }
        cb = { value = 0.5, unit = "N*m*s", fit = true, min = 0, max = 10 }
        ka = { value = 5, unit = "N*m", fit = true, min = 0, max = 100 }
        kb = { value = 5, unit = "N*m", fit = true, min = 0, max = 100 }
        [states]
        a = { rate = "wa", unit = "rad", initial = 0 }
        wa = { rate = "(M - ca*wa - ka*a)/Ja", unit = "rad/s", initial = 0 }
        b = { rate = "wb", unit = "rad", initial = 0 }
        wb = { rate = "(M - cb*wb - kb*b)/Jb", unit = "rad/s", initial = 0 }
        [outputs]
        first = { equals = "a", unit = "rad" }
        second = { equals = "b", unit = "rad" }
    "#;
    let spin = |u: f64| 100.0 + 15.0 * u;
    let h = 0.004;
    let states = run_with_two(|[a, wa, b, wb], [m, u]| {
        let (on_a, on_b) = (h * spin(u) * wb, -h * spin(u) * wa);
        [wa, (m - 0.4 * wa - 6.0 * a + on_a) / 1.2, wb, (m - 0.3 * wb - 9.0 * b + on_b) / 0.8]
    });
    let rotor = second_inputs().iter().map(|u| spin(*u)).collect();
    let of = |k: usize| states.iter().map(|x| x[k]).collect();
    let columns = [
        ("M", "N*m", inputs(), 0.0),
        ("rotor", "rad/s", rotor, 0.0),
        ("first", "rad", of(0), 0.004),
        ("second", "rad", of(2), 0.004),
    ];
    let answer = told(model, &columns);
    let found = named(&answer);
    assert!(
        matches!(found[..], [("product-coupling", "wa", c)] if (c - h).abs() < 0.03 * h),
        "{}",
        answer.says
    );
}

/// Brushes drop a voltage that does not grow with the current.
#[test]
fn the_brushes_of_a_motor() {
    let model = r#"
        name = "motor"
        [inputs]
        u = { unit = "V" }
        [parameters]
        R = { value = 1, unit = "V/A", fit = true, min = 0.05, max = 20 }
        L = { value = 0.3, unit = "V*s/A", fit = true, min = 0.01, max = 20 }
        ke = { value = 0.5, unit = "V*s", fit = true, min = 0.01, max = 5 }
        J = { value = 0.2, unit = "kg*m^2", fit = true, min = 0.01, max = 5 }
        [states]
        i = { rate = "(u - R*i - ke*w)/L", unit = "A", initial = 0 }
        w = { rate = "ke*i/J", unit = "rad/s", initial = 0 }
        [outputs]
        current = { equals = "i", unit = "A" }
        speed = { equals = "w", unit = "rad/s" }
    "#;
    let states =
        run(|[i, w], u| [(12.0 * u - 1.2 * i - 1.5 * f64::tanh(i / 0.002) - 0.6 * w) / 0.4, 0.6 * i / 0.25]);
    let voltage = inputs().iter().map(|u| 12.0 * u).collect();
    let [current, speed] = [0, 1].map(|k| states.iter().map(|x| x[k]).collect());
    let columns = [("u", "V", voltage, 0.0), ("current", "A", current, 0.05), ("speed", "rad/s", speed, 0.2)];
    let answer = told(model, &columns);
    let found = named(&answer);
    assert!(matches!(found[..], [("dry-friction", "i", d)] if (d - 1.5).abs() < 0.03), "{}", answer.says);
}

/// A flow through a pipe of which the model knows the inertia and a laminar loss alone.
#[test]
fn a_turbulent_flow() {
    let model = r#"
        name = "pipe"
        [inputs]
        head = { unit = "Pa" }
        [parameters]
        I = { value = 2e5, unit = "Pa*s^2/m^3", fit = true, min = 1e4, max = 1e7 }
        R = { value = 1e5, unit = "Pa*s/m^3", fit = true, min = 0, max = 1e7 }
        [states]
        Q = { rate = "(head - R*Q)/I", unit = "m^3/s", initial = 0 }
        [outputs]
        flow = { equals = "Q", unit = "l/s" }
    "#;
    let states = run(|[q], u| [(5e3 * u - 5e4 * q - 4e6 * q * q.abs()) / 1e5]);
    let head = inputs().iter().map(|u| 5e3 * u).collect();
    let flow = states.iter().map(|x| 1e3 * x[0]).collect();
    let answer = told(model, &[("head", "Pa", head, 0.0), ("flow", "l/s", flow, 0.2)]);
    let found = named(&answer);
    let is_right = |c: f64| (c / 4e6 - 1.0).abs() < 0.03;
    assert!(matches!(found[..], [("quadratic-damping", "Q", c)] if is_right(c)), "{}", answer.says);
}
