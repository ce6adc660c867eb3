//! Laws of what stands inside a model: of a definition, of what a parameter multiplies, of a sensor's own angle, of a
//! parameter that is known.

use crate::diagnose::{diagnosed, noise};
use crate::laws_met::{inputs, named, run, run_with_two, second_inputs, told};
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Hold, Recording};
use gyrospec::units::Unit;

const OVEN: &str = r#"
    name = "oven with its controller"
    [inputs]
    wanted = { unit = "K" }
    [parameters]
    C = { value = 3, unit = "J/K", fit = true, min = 0.2, max = 30 }
    h = { value = 1, unit = "W/K", fit = true, min = 0.05, max = 10 }
    Kp = { value = 4, unit = "W/K" }
    Ki = { value = 0.8, unit = "W/K/s" }
    [definitions]
    power = { equals = "Kp*(wanted - T) + Ki*z", unit = "W" }
    [states]
    T = { rate = "(power - h*T)/C", unit = "K", initial = 0 }
    z = { rate = "wanted - T", unit = "K*s", initial = 0 }
    [outputs]
    oven = { equals = "T", unit = "K" }
"#;

/// What is said of the oven whose power has a rate by its own state and what the controller wants, and acts through `felt`.
fn oven(level: f64, felt: impl Fn(f64, f64) -> (f64, f64)) -> Answer {
    oven_of(OVEN, level, felt)
}

/// The same by another model.
fn oven_of(model: &str, level: f64, felt: impl Fn(f64, f64) -> (f64, f64)) -> Answer {
    let states = run(|[t, z, heater], u| {
        let wanted = u + level - t;
        let (acts, rate) = felt(4.0 * wanted + 0.8 * z, heater);
        [(acts - 0.5 * t) / 2.0, wanted, rate]
    });
    let wanted = inputs().iter().map(|u| u + level).collect();
    let oven = states.iter().map(|x| x[0]).collect();
    told(model, &[("wanted", "K", wanted, 0.0), ("oven", "K", oven, 0.01)])
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_controller_that_can_heat_and_cannot_cool() {
    let answer = oven(2.0, |power, _| (power.max(0.0), 0.0));
    let found = named(&answer);
    assert!(matches!(found[..], [("input-saturation", "power", l)] if l.abs() < 0.1), "{found:?}");
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_controller_whose_heater_lags() {
    let answer = oven(6.0, |power, heater| (heater, (power - heater) / 0.15));
    // with little loss a lag of the whole balance does as well
    let [found] = &answer.findings[..] else { panic!("{}", answer.says) };
    assert_eq!((found.code.as_str(), found.site.name.as_str()), ("extra-lag", "power"), "{}", answer.says);
    let others = ["neglected-inertia"];
    assert!(found.ties.iter().all(|t| others.contains(&t.as_str())), "{}", answer.says);
    assert!((found.parameters[0].value - 0.15).abs() < 0.01, "{}", answer.says);
}

#[test]
fn a_controller_whose_small_demands_do_nothing() {
    let answer = oven(0.0, |power, _| (power - power.clamp(-2.0, 2.0), 0.0));
    let found = named(&answer);
    assert!(matches!(found[..], [("input-dead-zone", "power", d)] if (d - 2.0).abs() < 0.1), "{found:?}");
}

/// A controller whose gains have the wrong sign runs away, and no law of physics says so.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_controller_that_feeds_back_the_wrong_way() {
    let wrong = OVEN.replace("value = 4,", "value = -4,").replace("value = 0.8,", "value = -0.8,");
    let answer = oven_of(&wrong, 6.0, |power, _| (power, 0.0));
    assert_eq!(answer.verdict, Verdict::DataFault, "{}", answer.says);
    let fault = &answer.faults[0].finding;
    assert_eq!((fault.code.as_str(), fault.site.name.as_str()), ("wrong-sign", "power"), "{}", answer.says);
    assert!(answer.proof[0].holdout_after < 1.1 * 0.01, "{}", answer.says);
    // and what is missing beside it is found beside it
    let answer = oven_of(&wrong, 2.0, |power, _| (power.max(0.0), 0.0));
    let found = named(&answer);
    assert!(matches!(found[..], [("input-saturation", "power", l)] if l.abs() < 0.1), "{found:?}");
    assert_eq!(answer.faults[0].finding.code, "wrong-sign");
}

/// A spring that drives away, held back by damping alone: the steps that such runs take are no steps of the model with
/// the sign mended, and what is missing beside it is found.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_is_missing_beside_a_spring_that_drives_away() {
    let model = r#"
        name = "table"
        [inputs]
        force = { unit = "N" }
        [parameters]
        c = { value = 1, unit = "N*s/m", fit = true, min = 0.05, max = 20 }
        c2 = { value = 3, unit = "N*s^2/m^2", fit = true, min = 0 }
        k = { value = 40, unit = "N/m", fit = true, min = 5, max = 500 }
        m = { value = 2, unit = "kg" }
        g = { value = 9.80665, unit = "m/s^2" }
        [definitions]
        felt_rate = { equals = "(force - c*v + k*x - c2*v*abs(v))/m", unit = "m/s^2" }
        [states]
        x = { rate = "v", unit = "m", initial = 0 }
        v = { rate = "felt_rate", unit = "m/s", initial = 0 }
        [outputs]
        place = { equals = "x", unit = "mm" }
        felt = { equals = "felt_rate/g", unit = "1" }
    "#;
    let rate =
        |x: f64, v: f64, u: f64| (10.0 * u - 1.2 * v - 50.0 * x - 3.0 * v * v.abs() - 60.0 * x.powi(3)) / 2.0;
    let states = run(|[x, v], u| [v, rate(x, v, u)]);
    let place = states.iter().map(|x| 1e3 * x[0]).collect();
    let felt = states.iter().zip(inputs()).map(|(x, u)| rate(x[0], x[1], u) / 9.80665).collect();
    let force = inputs().iter().map(|u| 10.0 * u).collect();
    let columns = [("force", "N", force, 0.0), ("place", "mm", place, 1.0), ("felt", "1", felt, 0.002)];
    let answer = told(model, &columns);
    let found = named(&answer);
    assert!(
        matches!(found[..], [("cubic-stiffness", "v", k3)] if (k3 - 60.0).abs() < 2.0),
        "{}",
        answer.says
    );
    assert_eq!(answer.faults[0].finding.code, "wrong-sign");
}

/// A loss that the formula adds in the place of taking it away ends at its least, 0.05 W/K; the controller holds the
/// model, so that what is missing is a loss: 0.5 W/K and the 0.05 that are added.
#[test]
fn a_loss_of_the_wrong_sign() {
    let wrong = OVEN.replace("power - h*T", "power + h*T");
    let answer = oven_of(&wrong, 6.0, |power, _| (power, 0.0));
    let found = named(&answer);
    assert!(matches!(found[..], [("linear-damping", "T", h)] if (h - 0.55).abs() < 0.01), "{found:?}");
}

/// A spring that the drawing calls one of 60 N/m is one of 66; or the mass is less by as much.
#[test]
fn a_known_value_that_is_another() {
    let model = r#"
        name = "scale"
        [inputs]
        load = { unit = "N" }
        [parameters]
        c = { value = 1, unit = "N*s/m", fit = true, min = 0.05, max = 20 }
        k = { value = 60, unit = "N/m" }
        m = { value = 2, unit = "kg" }
        S = { value = 1, unit = "V/m", fit = true, min = 0.1, max = 10 }
        [states]
        x = { rate = "v", unit = "m", initial = 0 }
        v = { rate = "(load - c*v - k*x)/m", unit = "m/s", initial = 0 }
        [outputs]
        signal = { equals = "S*x", unit = "V" }
    "#;
    let of = |k: f64| {
        let states = run(|[x, v], load| [v, (load - 1.5 * v - k * x) / 2.0]);
        let signal = states.iter().map(|x| 1.2 * x[0]).collect();
        told(model, &[("load", "N", inputs(), 0.0), ("signal", "V", signal, 0.002)])
    };
    let answer = of(66.0);
    let off = named(&answer);
    assert!(
        matches!(off[..], [("parameter-value", "k", d)] if (d - 6.0).abs() < 0.3)
            || matches!(off[..], [("parameter-value", "m", d)] if (d + 2.0 * 6.0 / 66.0).abs() < 0.01),
        "{}",
        answer.says
    );
    assert_eq!(of(60.0).verdict, Verdict::NothingMissing);
}

/// A data sheet of which two values are wrong, beside 20 s of record: either alone would leave as much as it mends.
#[test]
fn two_known_values_that_are_others() {
    let model = r#"
        name = "RC"
        [inputs]
        u = { unit = "V" }
        [parameters]
        tau = { value = 0.8, unit = "s" }
        K = { value = 1, unit = "1" }
        [states]
        x = { rate = "(K*u - x)/tau", unit = "V", initial = "fit" }
        [outputs]
        y = { equals = "x", unit = "V" }
    "#;
    for seed in [3, 4, 5] {
        let steps: Vec<f64> = noise(200, seed).iter().step_by(10).map(|e| 2.0 * e).collect();
        let u: Vec<f64> = (0..200).map(|i| steps[i / 10]).collect();
        // x(t + h) = x e^{−h/τ} + K u (1 − e^{−h/τ})
        let (keeps, mut x) = ((-0.1f64).exp(), 0.0);
        let mut y = Vec::new();
        for (u, e) in u.iter().zip(noise(2000, 40 + seed).iter().step_by(10)) {
            y.push(x + 0.01 * e);
            x = x * keeps + 1.3 * u * (1.0 - keeps);
        }
        let time: Vec<f64> = (0..200).map(|i| 0.1 * f64::from(i)).collect();
        let volt = || Unit::parse("V").unwrap();
        let input = Channel { hold: Hold::Previous, ..Channel::new("u", volt(), time.clone(), u) };
        let recording =
            Recording::from_channels("made", vec![input, Channel::new("y", volt(), time, y)]).unwrap();
        let answer = diagnosed(&Model::parse(model).unwrap(), recording).answer;
        let [found] = &answer.findings[..] else { panic!("{}", answer.says) };
        let values: Vec<f64> = found.parameters.iter().map(|p| p.value).collect();
        assert_eq!(found.code, "parameter-value", "{}", answer.says);
        assert!((values[0] - 0.2).abs() < 0.015 && (values[1] - 0.3).abs() < 0.01, "{}", answer.says);
    }
}

/// What acts on a body an accelerometer on it feels: here of the body's whole motion, while the model has that beside
/// the ground's.
#[test]
fn a_force_that_an_accelerometer_feels() {
    let model = r#"
        name = "floor of a frame"
        [inputs]
        ground = { unit = "m/s^2" }
        [parameters]
        c = { value = 1, unit = "N*s/m", fit = true, min = 0.05, max = 20 }
        k = { value = 60, unit = "N/m", fit = true, min = 5, max = 500 }
        m = { value = 2, unit = "kg" }
        [definitions]
        shear = { equals = "-c*v - k*x", unit = "N" }
        [states]
        x = { rate = "v", unit = "m", initial = 0 }
        v = { rate = "shear/m - ground", unit = "m/s", initial = 0 }
        [outputs]
        drift = { equals = "x", unit = "m" }
        felt = { equals = "shear/m", unit = "m/s^2" }
    "#;
    let shear = |x: f64, v: f64| -1.2 * v - 50.0 * x - 3.0 * v * v.abs();
    let states = run(|[x, v], ground| [v, shear(x, v) / 2.0 - ground]);
    let drift = states.iter().map(|x| x[0]).collect();
    let felt = states.iter().map(|x| shear(x[0], x[1]) / 2.0).collect();
    let columns =
        [("ground", "m/s^2", inputs(), 0.0), ("drift", "m", drift, 0.001), ("felt", "m/s^2", felt, 0.02)];
    let answer = told(model, &columns);
    let found = named(&answer);
    assert!(
        matches!(found[..], [("quadratic-damping", "v", d)] if (d - 1.5).abs() < 0.08),
        "{}",
        answer.says
    );
    let held: Vec<f64> = answer.proof.iter().map(|p| p.holdout_after).collect();
    assert!(held[0] < 1.1 * 0.001 && held[1] < 1.1 * 0.02, "{held:?}");
}

const RUDDER: &str = r#"
    name = "sway of a boat"
    [inputs]
    rudder = { unit = "rad" }
    [parameters]
    C = { value = 30, unit = "N", fit = true, min = 3, max = 300 }
    d = { value = 2, unit = "N*s/m", fit = true, min = 0.2, max = 20 }
    m = { value = 2, unit = "kg" }
    U = { value = 4, unit = "m/s" }
    [states]
    v = { rate = "(C*(rudder - v/U) - d*v)/m", unit = "m/s", initial = 0 }
    [outputs]
    sway = { equals = "v", unit = "m/s" }
"#;

#[test]
fn a_force_that_saturates_with_its_own_angle() {
    let sway = |bend: f64| {
        let states = run(|[v], u| {
            let angle = 0.15 * u - v / 4.0;
            [(20.0 * angle / (1.0 + bend * angle * angle) - 3.0 * v) / 2.0]
        });
        states.iter().map(|x| x[0]).collect::<Vec<f64>>()
    };
    let rudder = || inputs().iter().map(|u| 0.15 * u).collect();
    let answer = told(RUDDER, &[("rudder", "rad", rudder(), 0.0), ("sway", "m/s", sway(6.0), 2e-3)]);
    let found = named(&answer);
    assert!(matches!(found[..], [("parameter-dependence", "C", a)] if (a - 6.0).abs() < 0.5), "{found:?}");
    // the same without: nothing is invented
    let answer = told(RUDDER, &[("rudder", "rad", rudder(), 0.0), ("sway", "m/s", sway(0.0), 2e-3)]);
    assert!(answer.findings.is_empty(), "{}", answer.says);
}

#[test]
fn an_encoder_whose_disc_is_eccentric() {
    let model = r#"
        name = "turntable"
        [inputs]
        torque = { unit = "N*m" }
        [parameters]
        J = { value = 2, unit = "kg*m^2", fit = true, min = 0.2, max = 20 }
        b = { value = 1, unit = "N*m*s/rad", fit = true, min = 0.1, max = 10 }
        [states]
        a = { rate = "w", unit = "rad", initial = 0 }
        w = { rate = "(torque - b*w)/J", unit = "rad/s", initial = 0 }
        [outputs]
        encoder = { equals = "a", unit = "deg" }
    "#;
    let states = run(|[_, w], u| [w, (2.0 * u + 0.3 - 0.8 * w) / 1.4]);
    let reads = states.iter().map(|x| (x[0] + 0.02 * x[0].sin() - 0.01 * x[0].cos()).to_degrees()).collect();
    let torque = inputs().iter().map(|u| 2.0 * u + 0.3).collect();
    let answer = told(model, &[("torque", "N*m", torque, 0.0), ("encoder", "deg", reads, 0.1)]);
    let found = named(&answer);
    let sine = 0.02f64.to_degrees();
    assert!(
        matches!(found[..], [("periodic-force", "encoder", a)] if (a - sine).abs() < 0.05 * sine),
        "{found:?}"
    );
    let cosine = answer.findings[0].parameters[1].value;
    assert!((cosine + 0.01f64.to_degrees()).abs() < 0.05 * sine, "{cosine}");
}

#[test]
fn a_known_parameter_is_known_where_nothing_acts_on_it() {
    let model = r#"
        name = "room"
        [inputs]
        power = { unit = "W" }
        [parameters]
        C = { value = 3, unit = "J/K", fit = true, min = 0.2, max = 30 }
        share = { value = 0.5, unit = "1", fit = true, min = 0.05, max = 5 }
        h = { value = 0.4, unit = "W/K" }
        [states]
        T = { rate = "(share*power - h*T)/C", unit = "K", initial = 0 }
        [outputs]
        room = { equals = "T", unit = "K" }
    "#;
    // h is 0.4 W/K in still air, and half as much again for each m/s of wind
    let states = run_with_two(|[t], [u, w]| {
        let wind = (w + 1.0).abs();
        [(0.8 * (u + 4.0) - 0.4 * (1.0 + 0.5 * wind) * t) / 2.0]
    });
    let wind = second_inputs().iter().map(|w| (w + 1.0).abs()).collect();
    let power = inputs().iter().map(|u| u + 4.0).collect();
    let rooms = states.iter().map(|x| x[0]).collect();
    let columns = [("power", "W", power, 0.0), ("room", "K", rooms, 0.01), ("wind", "m/s", wind, 0.0)];
    let answer = told(model, &columns);
    let found = named(&answer);
    assert!(matches!(found[..], [("parameter-dependence", "h", a)] if (a - 0.5).abs() < 0.03), "{found:?}");
    let share = answer.parameters.iter().find(|p| p.name == "share").unwrap().after;
    assert!((share - 0.8).abs() < 0.02, "{share}");
}

#[test]
fn a_drag_of_the_speed_through_the_air() {
    let model = r#"
        name = "car"
        [inputs]
        force = { unit = "N" }
        [parameters]
        m = { value = 2, unit = "kg", fit = true, min = 0.2, max = 20 }
        kd = { value = 0.5, unit = "N*s^2/m^2", fit = true, min = 0.05, max = 5 }
        r = { value = 0.4, unit = "N*s/m", fit = true, min = 0.04, max = 4 }
        [states]
        v = { rate = "(force - kd*v*abs(v) - r*v)/m", unit = "m/s", initial = 0 }
        [outputs]
        speed = { equals = "v", unit = "m/s" }
    "#;
    let states = run_with_two(|[v], [u, w]| {
        let air: f64 = v + w;
        [(2.0 * u + 4.0 - 0.8 * air * air.abs() - 0.3 * v) / 1.5]
    });
    let force = inputs().iter().map(|u| 2.0 * u + 4.0).collect();
    let speed = states.iter().map(|x| x[0]).collect();
    let columns =
        [("force", "N", force, 0.0), ("speed", "m/s", speed, 0.01), ("wind", "m/s", second_inputs(), 0.0)];
    let answer = told(model, &columns);
    let found = named(&answer);
    assert!(matches!(found[..], [("cross-coupling", "v", c)] if (c - 1.0).abs() < 0.03), "{found:?}");
}

#[test]
fn a_rotor_that_does_not_face_the_wind() {
    let model = r#"
        name = "rotor"
        [inputs]
        wind = { unit = "m/s" }
        [parameters]
        J = { value = 2, unit = "kg*m^2", fit = true, min = 0.2, max = 20 }
        ca = { value = 0.5, unit = "kg", fit = true, min = 0.05, max = 5 }
        cb = { value = 0.5, unit = "kg*m", fit = true, min = 0.05, max = 5 }
        [states]
        w = { rate = "(ca*wind^2 - cb*wind*w)/J", unit = "rad/s", initial = 0 }
        [outputs]
        rotor = { equals = "w", unit = "rad/s" }
    "#;
    let yaw = |w: f64| 0.2 * w;
    let states = run_with_two(|[x], [u, w]| {
        let along = (0.7 * u + 6.0) * yaw(w).cos();
        [(0.4 * along * along - 0.3 * along * x) / 1.5]
    });
    let wind = inputs().iter().map(|u| 0.7 * u + 6.0).collect();
    let angle = second_inputs().iter().map(|w| yaw(*w).to_degrees()).collect();
    let rotor = states.iter().map(|x| x[0]).collect();
    let columns = [("wind", "m/s", wind, 0.0), ("rotor", "rad/s", rotor, 0.05), ("yaw", "deg", angle, 0.0)];
    let answer = told(model, &columns);
    let found = named(&answer);
    // cos y = 1 − y²/2 + y⁴/24 − …, of angles up to a right one
    let in_degrees = (1f64.to_radians()).powi(2);
    assert!(
        matches!(found[..], [("misalignment", "wind", a)] if (a + 0.45 * in_degrees).abs() < 0.08 * in_degrees),
        "{found:?}"
    );
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn an_elimination_that_saturates_far_below_its_mean_level() {
    let model = r#"
        name = "infusion"
        [inputs]
        dose = { unit = "kg/s" }
        [parameters]
        V = { value = 3, unit = "m^3", fit = true, min = 0.3, max = 30 }
        CL = { value = 1, unit = "m^3/s", fit = true, min = 0.01, max = 100 }
        k12 = { value = 0.5, unit = "1/s", fit = true, min = 0.05, max = 5 }
        k21 = { value = 0.2, unit = "1/s", fit = true, min = 0.02, max = 2 }
        [states]
        c1 = { rate = "dose/V - CL/V*c1 - k12*c1 + k21*c2", unit = "kg/m^3", initial = 0 }
        c2 = { rate = "k12*c1 - k21*c2", unit = "kg/m^3", initial = 0 }
        [outputs]
        plasma = { equals = "c1", unit = "kg/m^3" }
    "#;
    // half the largest rate is reached at 0.6 of what the mean level is some 2.5
    let states = run(|[c1, c2], u| {
        let lost = 3.0 / (1.0 + c1 / 0.6) / 2.0 * c1;
        [(0.5 * u + 1.6).abs() / 2.0 - lost - 0.4 * c1 + 0.3 * c2, 0.4 * c1 - 0.3 * c2]
    });
    let dose = inputs().iter().map(|u| (0.5 * u + 1.6).abs()).collect();
    let plasma = states.iter().map(|x| x[0]).collect();
    let answer = told(model, &[("dose", "kg/s", dose, 0.0), ("plasma", "kg/m^3", plasma, 0.01)]);
    let [found] = &answer.findings[..] else { panic!("{}", answer.says) };
    assert_eq!((found.code.as_str(), found.site.name.as_str()), ("saturable-rate", "CL"), "{}", answer.says);
    assert!((found.parameters[0].value * 0.6 - 1.0).abs() < 0.15, "{}", answer.says);
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_limit_and_a_loss_that_a_bend_of_the_input_stands_for() {
    let model = r#"
        name = "kiln"
        [inputs]
        drive = { unit = "1" }
        hall = { unit = "degC" }
        [parameters]
        P = { value = 3000, unit = "W", fit = true, min = 500, max = 20000 }
        hA = { value = 4, unit = "W/K", fit = true, min = 0.5, max = 40 }
        C = { value = 7, unit = "J/K", fit = true, min = 1, max = 70 }
        [states]
        T = { rate = "(P*drive - hA*(T - hall))/C", unit = "K", initial = "fit" }
        [outputs]
        kiln = { equals = "T", unit = "degC" }
    "#;
    let drive = |u: f64| (0.5 + 0.09 * u).clamp(0.04, 0.96);
    let hall = |w: f64| 295.0 + w;
    let states = run_with_two(|[above], [u, w]| {
        let t = 295.0 + above;
        let lost = 2.0 * (t - hall(w)) + 3e-9 * (t.powi(4) - hall(w).powi(4));
        [(4000.0 * drive(u).min(0.72) - lost) / 10.0]
    });
    let kiln = states.iter().map(|[above]| 21.85 + above).collect();
    let columns = [
        ("drive", "1", inputs().iter().map(|u| drive(*u)).collect(), 0.0),
        ("hall", "degC", second_inputs().iter().map(|w| hall(*w) - 273.15).collect(), 0.0),
        ("kiln", "degC", kiln, 2.0),
    ];
    let answer = told(model, &columns);
    let found: Vec<(&str, &str)> =
        answer.findings.iter().map(|f| (f.code.as_str(), f.site.name.as_str())).collect();
    assert!(found.contains(&("input-saturation", "drive")), "{}", answer.says);
    let loss = answer.findings.iter().find(|f| f.site.name == "T" || f.site.name == "hA");
    let is_radiation = |f: &gyrospec::diagnose::answer::Finding| {
        f.code == "radiation" || f.ties.iter().any(|t| t == "radiation")
    };
    assert!(found.len() == 2 && loss.is_some_and(is_radiation), "{}", answer.says);
}

/// A friction that the model has, smoothed, and its excess near rest, which the model lacks.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn friction_that_is_larger_near_rest_than_the_model_says() {
    let model = r#"
        name = "wrist"
        [inputs]
        torque = { unit = "N*m" }
        [parameters]
        J = { value = 0.8, unit = "kg*m^2" }
        b = { value = 1, unit = "N*m*s", fit = true, min = 0 }
        Fc = { value = 1, unit = "N*m", fit = true, min = 0 }
        k = { value = 10, unit = "N*m", fit = true, min = 0 }
        w0 = { value = 0.03, unit = "rad/s" }
        [definitions]
        rubs = { equals = "b*w + Fc*tanh(w/w0)", unit = "N*m" }
        [states]
        q = { rate = "w", unit = "rad", initial = 0 }
        w = { rate = "(torque - rubs - k*q)/J", unit = "rad/s", initial = 0 }
        [outputs]
        angle = { equals = "q", unit = "rad" }
    "#;
    let rubs = |w: f64| 1.6 * w + (1.4 + 1.9 * f64::exp(-(w / 0.3).powi(2))) * f64::tanh(w / 0.03);
    let states = run(|[q, w], u| [w, (6.0 * u - rubs(w) - 14.0 * q) / 0.8]);
    let angle = states.iter().map(|x| x[0]).collect();
    let torque = inputs().iter().map(|u| 6.0 * u).collect();
    let answer = told(model, &[("torque", "N*m", torque, 0.0), ("angle", "rad", angle, 0.005)]);
    let found = named(&answer);
    assert!(
        matches!(found[..], [("stribeck-friction", "w", f)] if (f - 1.9).abs() < 0.15),
        "{}",
        answer.says
    );
}

/// A leak through an opening goes with the root of what stands above the air outside.
#[test]
fn a_vessel_leaks_to_the_air() {
    let model = r#"
        name = "vessel"
        [inputs]
        valve = { unit = "1" }
        [parameters]
        a = { value = 0.2, unit = "1/s", fit = true, min = 0 }
        b = { value = 0.5, unit = "1/s", fit = true, min = 0 }
        ps = { value = 700, unit = "kPa" }
        pa = { value = 101.3, unit = "kPa" }
        [states]
        p = { rate = "a*valve*(ps - p) - b*(p - pa)", unit = "kPa", initial = 101.3 }
        [outputs]
        pressure = { equals = "p", unit = "kPa" }
    "#;
    // x = p - pa, in kPa
    let valve = |u: f64| 2.0 + 0.6 * u;
    let states = run(|[x], u| [0.3 * valve(u) * (598.7 - x) - 0.25 * x - 8.0 * f64::sqrt(x.max(0.0))]);
    let pressure = states.iter().map(|x| 101.3 + x[0]).collect();
    let opened = inputs().iter().map(|u| valve(*u)).collect();
    let answer = told(model, &[("valve", "1", opened, 0.0), ("pressure", "kPa", pressure, 0.3)]);
    let found = named(&answer);
    assert!(matches!(found[..], [("square-root-flow", "p", k)] if (k - 8.0).abs() < 0.4), "{}", answer.says);
}
