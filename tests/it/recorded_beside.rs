//! Causes that were recorded and that the model does not read: they go before what only might be, in the form in which
//! they act.

use crate::fields::{Plant, first, value};
use gyrospec::diagnose::answer::{Answer, Verdict};

/// A room of 300 s beside air whose temperature swings once in 3000 s; the air less 293 K turns with its quadrature. The thermometer
/// in the air has the same share of noise as that in the room.
const ROOM: Plant<'_> = Plant {
    step: 6.0,
    start: &[297.0, 295.0, 0.0],
    inputs: &[("P", "W")],
    states: &[("T", "K"), ("air", "K"), ("quadrature", "K")],
    sizes: &[(40.0, 30.0)],
    noise: 0.02,
    measured: 2,
};
const ROOM_MODEL: &str = r#"
    name = "room"
    [inputs]
    P = { unit = "W" }
    [parameters]
    R = { value = 0.28, unit = "K/W", fit = true }
    tau = { value = 280, unit = "s", fit = true, min = 1 }
    Ta = { value = 293, unit = "K" }
    [states]
    T = { rate = "(R*P - (T - Ta))/tau", unit = "K", initial = "fit" }
    [outputs]
    T_meas = { equals = "T", unit = "K" }
"#;

/// The room, with a heat that swings as the air does or at three times its pace.
fn room(of_air: f64, of_another: f64) -> Answer {
    let w = std::f64::consts::TAU / 3000.0;
    ROOM.diagnosed(ROOM_MODEL, |x, u| {
        let (air, phase) = (x[1] - 293.0, x[2].atan2(x[1] - 293.0));
        let another = of_another * (3.0 * phase).sin();
        vec![(0.3 * u[0] - (x[0] - 293.0) + of_air * air + another) / 300.0, -w * x[2], w * air]
    })
}

#[test]
fn a_recorded_day_goes_before_a_wave_of_its_period() {
    let found = room(1.0, 0.0);
    assert_ne!(first(&found), "periodic-force", "{}", found.says);
    assert!(matches!(found.verdict, Verdict::Named | Verdict::Tie), "{}", found.says);
    let term = &found.findings[0].term;
    assert!(term.contains("air_meas"), "{term}");
    let [low, c, high] = value(&found, "c");
    assert!((c - 1.0).abs() < 0.02 && low < high, "{low} {c} {high}");
    // a wave of another pace is none of the air's
    let found = room(0.0, 2.0);
    assert_eq!((found.verdict, first(&found)), (Verdict::Named, "periodic-force"), "{}", found.says);
    assert_eq!(room(0.0, 0.0).verdict, Verdict::NothingMissing);
}

/// A slide of 1.5 kg on a spring along the radius of a table, whose speed is recorded.
const SLIDE: Plant<'_> = Plant {
    step: 0.02,
    start: &[0.24, 0.0],
    inputs: &[("F", "N"), ("table", "rad/s")],
    states: &[("r", "m"), ("v", "m/s")],
    sizes: &[(0.0, 6.0), (1.8, 1.2)],
    noise: 0.02,
    measured: 1,
};
const SLIDE_MODEL: &str = r#"
    name = "slide"
    [inputs]
    F = { unit = "N" }
    [parameters]
    m = { value = 1.2, unit = "kg", fit = true, min = 0.1, max = 20 }
    c = { value = 5, unit = "N*s/m", fit = true, min = 0, max = 100 }
    k = { value = 90, unit = "N/m", fit = true, min = 1, max = 2000 }
    r0 = { value = 0.22, unit = "m", fit = true, min = 0, max = 2 }
    [states]
    r = { rate = "v", unit = "m", initial = "fit" }
    v = { rate = "(F - c*v - k*(r - r0))/m", unit = "m/s", initial = "fit" }
    [outputs]
    r_meas = { equals = "r", unit = "m" }
"#;

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_turns_pushes_outward() {
    let of = |mass: f64| {
        SLIDE.diagnosed(SLIDE_MODEL, |x, u| {
            let force = u[0] - 6.0 * x[1] - 100.0 * (x[0] - 0.25) + mass * u[1] * u[1] * x[0];
            vec![x[1], force / 1.5]
        })
    };
    let found = of(1.5);
    let names: Vec<&str> = found.findings.iter().map(|f| f.code.as_str()).collect();
    assert_eq!((found.verdict, &names[..]), (Verdict::Named, &["product-coupling"][..]), "{}", found.says);
    assert!(found.findings[0].term.contains("table^2*r"), "{}", found.findings[0].term);
    let name = &found.findings[0].parameters[0].name;
    let [low, _, high] = value(&found, name);
    assert!(low < 1.5 && 1.5 < high, "{low} to {high}");
    assert_eq!(of(0.0).verdict, Verdict::NothingMissing);
}

/// A tram of 42 t with a constant resistance and one that grows with its speed, on a line whose grade is recorded.
const TRAM: Plant<'_> = Plant {
    step: 0.5,
    start: &[8.0],
    inputs: &[("pull", "N"), ("grade", "rad")],
    states: &[("v", "m/s")],
    sizes: &[(9000.0, 6000.0), (0.0, 0.005)],
    noise: 0.02,
    measured: 1,
};
const TRAM_MODEL: &str = r#"
    name = "tram"
    [inputs]
    pull = { unit = "N" }
    [parameters]
    m = { value = 42000, unit = "kg" }
    r0 = { value = 1500, unit = "N", fit = true }
    r1 = { value = 800, unit = "N*s/m", fit = true, min = 0 }
    [states]
    v = { rate = "(pull - r0 - r1*v)/m", unit = "m/s", initial = "fit" }
    [outputs]
    v_meas = { equals = "v", unit = "m/s" }
"#;

#[test]
fn a_recorded_grade_acts_on_the_speed_and_changes_no_constant() {
    let of = |g: f64| {
        TRAM.diagnosed(TRAM_MODEL, |x, u| vec![(u[0] - 2000.0 - 700.0 * x[0]) / 42000.0 - g * u[1].sin()])
    };
    let found = of(9.81);
    assert_eq!((found.verdict, first(&found)), (Verdict::Named, "cross-coupling"), "{}", found.says);
    let [low, _, high] = value(&found, "c");
    let pull = -42000.0 * 9.81;
    assert!(low < pull && pull < high, "{low} to {high}");
    assert_eq!(of(0.0).verdict, Verdict::NothingMissing);
}

/// A thermoelectric cooler: a current pumps heat from its cold side to its warm one, and warms that by its square.
const COOLER: Plant<'_> = Plant {
    step: 2.0,
    start: &[293.0, 293.0],
    inputs: &[("I", "A")],
    states: &[("warm", "K"), ("cold", "K")],
    sizes: &[(0.0, 3.0)],
    noise: 0.02,
    measured: 2,
};
const COOLER_MODEL: &str = r#"
    name = "cooler"
    [inputs]
    I = { unit = "A" }
    [parameters]
    C = { value = 48, unit = "J/K" }
    p = { value = 1.5, unit = "W/A", fit = true }
    K = { value = 0.4, unit = "W/K", fit = true, min = 0 }
    h = { value = 0.4, unit = "W/K", fit = true, min = 0 }
    Ta = { value = 293, unit = "K" }
    [states]
    warm = { rate = "(p*I - K*(warm - cold) - h*(warm - Ta))/C", unit = "K", initial = "fit" }
    cold = { rate = "(K*(warm - cold) - p*I - h*(cold - Ta))/C", unit = "K", initial = "fit" }
    [outputs]
    warm_meas = { equals = "warm", unit = "K" }
    cold_meas = { equals = "cold", unit = "K" }
"#;

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_current_heats_by_its_square_beside_what_it_pumps() {
    let of = |r: f64| {
        COOLER.diagnosed(COOLER_MODEL, |x, u| {
            let pumped = 2.0 * u[0] - 0.3 * (x[0] - x[1]);
            let [warm, cold] = [0, 1].map(|k| -0.25 * (x[k] - 293.0));
            vec![(pumped + r * u[0] * u[0] + warm) / 48.0, (cold - pumped) / 48.0]
        })
    };
    let found = of(0.2);
    assert_eq!((found.verdict, first(&found)), (Verdict::Named, "cross-coupling"), "{}", found.says);
    assert!(found.findings[0].term.contains("I^2"), "{}", found.findings[0].term);
    let [low, _, high] = value(&found, "c");
    assert!(low < 0.2 && 0.2 < high, "{low} to {high}");
    assert_eq!(of(0.0).verdict, Verdict::NothingMissing);
}

/// A seat of 25 kg on a spring that hardens, pushed by a drive that gives 330 N at most.
const SEAT: Plant<'_> = Plant {
    step: 0.01,
    start: &[0.0, 0.0],
    inputs: &[("F", "N")],
    states: &[("x", "m"), ("v", "m/s")],
    sizes: &[(0.0, 400.0)],
    noise: 0.02,
    measured: 1,
};
const SEAT_MODEL: &str = r#"
    name = "seat"
    [inputs]
    F = { unit = "N" }
    [parameters]
    m = { value = 25, unit = "kg" }
    d = { value = 100, unit = "N*s/m", fit = true, min = 0, max = 5000 }
    k = { value = 9000, unit = "N/m", fit = true, min = 100, max = 1000000 }
    [states]
    x = { rate = "v", unit = "m", initial = 0 }
    v = { rate = "(F - d*v - k*x)/m", unit = "m/s", initial = 0 }
    [outputs]
    x_meas = { equals = "x", unit = "m" }
"#;

/// A spring that hardens and a force that saturates look like one that a force softens, at first.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_limit_of_a_force_beside_a_spring_that_hardens() {
    let found = SEAT.diagnosed(SEAT_MODEL, |x, u| {
        let force = u[0].clamp(-330.0, 330.0) - 160.0 * x[1] - 11500.0 * x[0] - 3.2e6 * x[0].powi(3);
        vec![x[1], force / 25.0]
    });
    let mut names: Vec<&str> = found.findings.iter().map(|f| f.code.as_str()).collect();
    names.sort_unstable();
    assert_eq!(names, ["cubic-stiffness", "input-saturation"], "{}", found.says);
    assert!(matches!(found.verdict, Verdict::Named | Verdict::Tie), "{}", found.says);
}

/// The beam of a gravimeter at sea, overdamped with 8 s; the acceleration along it is recorded.
const BEAM: Plant<'_> = Plant {
    step: 0.5,
    start: &[0.004],
    inputs: &[("up", "m/s^2"), ("along", "m/s^2")],
    states: &[("beta", "rad")],
    sizes: &[(0.0, 0.4), (0.0, 0.6)],
    noise: 0.02,
    measured: 1,
};
const BEAM_MODEL: &str = r#"
    name = "beam"
    [inputs]
    up = { unit = "m/s^2" }
    [parameters]
    S = { value = 0.06, unit = "rad*s/m", fit = true, min = 0.001, max = 1 }
    T = { value = 10.5, unit = "s", fit = true, min = 0.5, max = 200 }
    b0 = { value = 0.001, unit = "rad", fit = true, min = -0.1, max = 0.1 }
    [states]
    beta = { rate = "S*up - (beta - b0)/T", unit = "rad", initial = "fit" }
    [outputs]
    beta_meas = { equals = "beta", unit = "rad" }
"#;

/// A product of a state with a channel that turns about 0 is no time constant that varies with it.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn the_cross_coupling_error_of_a_gravimeter_is_a_product() {
    let of = |c: f64| {
        BEAM.diagnosed(BEAM_MODEL, |x, u| vec![0.05 * u[0] - (x[0] - 0.0016) / 8.0 + c * x[0] * u[1]])
    };
    let found = of(0.06);
    let names: Vec<&str> = found.findings.iter().map(|f| f.code.as_str()).collect();
    assert_eq!((found.verdict, &names[..]), (Verdict::Named, &["product-coupling"][..]), "{}", found.says);
    let [low, c, high] = value(&found, &found.findings[0].parameters[0].name);
    assert!(low < c && c < high && (c - 0.06).abs() < 0.006, "{low} {c} {high}");
    assert_eq!(of(0.0).verdict, Verdict::NothingMissing);
}

/// A drone whose roll is modelled alone; the turns about its two other axes are recorded beside.
const DRONE: Plant<'_> = Plant {
    step: 0.01,
    start: &[0.0, 0.0],
    inputs: &[("torque", "N*m"), ("pitch_rate", "rad/s"), ("yaw_rate", "rad/s")],
    states: &[("roll", "rad"), ("p", "rad/s")],
    sizes: &[(0.0, 0.02), (0.0, 1.0), (0.0, 0.8)],
    noise: 0.003,
    measured: 1,
};
const DRONE_MODEL: &str = r#"
    name = "roll axis"
    [inputs]
    torque = { unit = "N*m" }
    [parameters]
    J = { value = 0.009, unit = "kg*m^2", fit = true, min = 1e-4, max = 1 }
    d = { value = 0.02, unit = "N*m*s", fit = true, min = 0, max = 1 }
    [states]
    roll = { rate = "p", unit = "rad", initial = "fit" }
    p = { rate = "(torque - d*p)/J", unit = "rad/s", initial = "fit" }
    [outputs]
    roll_meas = { equals = "roll", unit = "rad" }
"#;

/// Euler's equation J p' = M - d p + (J_y - J_z) q r: neither of the two turns acts by itself.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn the_other_two_turns_of_a_body_act_on_the_third() {
    let of = |c: f64| {
        DRONE.diagnosed(DRONE_MODEL, |x, u| vec![x[1], (u[0] - 0.016 * x[1] + c * u[1] * u[2]) / 0.008])
    };
    let found = of(-0.008);
    let names: Vec<&str> = found.findings.iter().map(|f| f.code.as_str()).collect();
    assert_eq!((found.verdict, &names[..]), (Verdict::Named, &["product-coupling"][..]), "{}", found.says);
    assert!(found.findings[0].term.contains("pitch_rate*yaw_rate"), "{}", found.findings[0].term);
    let [low, c, high] = value(&found, &found.findings[0].parameters[0].name);
    assert!(low < -0.008 && -0.008 < high, "{low} {c} {high}");
    assert_eq!(of(0.0).verdict, Verdict::NothingMissing);
}

/// A wheelset on a track that is laid a little to one side and the other.
const WHEELSET: Plant<'_> = Plant {
    step: 0.01,
    start: &[0.0, 0.0],
    inputs: &[("wind", "N"), ("track", "m")],
    states: &[("y", "m"), ("v", "m/s")],
    sizes: &[(0.0, 3000.0), (0.0, 0.004)],
    noise: 0.05,
    measured: 1,
};
const WHEELSET_MODEL: &str = r#"
    name = "wheelset"
    [inputs]
    wind = { unit = "N" }
    track = { unit = "m" }
    [parameters]
    m = { value = 1000, unit = "kg" }
    d = { value = 7000, unit = "N*s/m", fit = true, min = 0, max = 1e6 }
    k = { value = 250e3, unit = "N/m", fit = true, min = 0, max = 1e8 }
    kt = { value = 150e3, unit = "N/m", fit = true, min = 0, max = 1e8 }
    [states]
    y = { rate = "v", unit = "m", initial = "fit" }
    v = { rate = "(wind - d*v - k*y + kt*track)/m", unit = "m/s", initial = "fit" }
    [outputs]
    y_meas = { equals = "y", unit = "mm" }
"#;

/// The flanges stand to both sides of the track, not of the place where the wheelset rests.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn flanges_stand_to_both_sides_of_the_track() {
    let of = |stop: f64| {
        WHEELSET.diagnosed(WHEELSET_MODEL, |x, u| {
            let away = x[0] - u[1];
            let flange = stop * ((away - 0.006).max(0.0) + (away + 0.006).min(0.0));
            vec![x[1], (u[0] - 6000.0 * x[1] - 300e3 * x[0] + 180e3 * u[1] - flange) / 1000.0]
        })
    };
    let found = of(600e3);
    let names: Vec<&str> = found.findings.iter().map(|f| f.code.as_str()).collect();
    assert_eq!((found.verdict, &names[..]), (Verdict::Named, &["end-stop"][..]), "{}", found.says);
    assert!(found.findings[0].term.contains("y - track"), "{}", found.findings[0].term);
    let [_, qs, _] = value(&found, "qs");
    assert!((qs - 0.006).abs() < 2e-4, "{qs}");
    assert_eq!(of(0.0).verdict, Verdict::NothingMissing);
}
