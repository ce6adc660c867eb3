//! A controller that reads the recorded sensor: the noise of a reading stands in the command of the same row, which acts
//! after it.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Hold, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const MOTOR: &str = r#"
    name = "motor"
    [inputs]
    u = { unit = "V" }
    [parameters]
    K = { value = 0.05, unit = "N*m/V" }
    b = { value = 0.002, unit = "N*m*s/rad", fit = true }
    J = { value = 0.0009, unit = "kg*m^2", fit = true }
    [states]
    w = { rate = "(K*u - b*w)/J", unit = "rad/s", initial = 0 }
    [outputs]
    speed = { equals = "w", unit = "rad/s" }
"#;
const SET: &str = "u is set from what “speed” shows in the same row";

/// How the voltage is set.
#[derive(Clone, Copy)]
struct Drive {
    /// The speed that its controller reads: the recorded one, one of a sensor of its own, or none: it is a plan.
    by: By,
    /// How the recording says that it runs between rows.
    hold: Hold,
    /// Coulomb friction, N m.
    friction: f64,
    /// What the recorded sensor feels of the voltage as it is when it is read, rad/s/V.
    felt: f64,
    seed: u64,
}

#[derive(Clone, Copy, PartialEq)]
enum By {
    Recorded,
    Another,
    Plan,
}

const LOOP: Drive = Drive { by: By::Recorded, hold: Hold::Previous, friction: 0.0, felt: 0.0, seed: 1 };

/// 30 s of 0.001 w' + 0.0015 w = 0.05 u − friction, u set each 10 ms; the sensors have 0.5 rad/s of noise.
fn found(drive: Drive) -> Answer {
    let mut rng = ChaCha8Rng::seed_from_u64(drive.seed);
    let mut drawn = || -> f64 { StandardNormal.sample(&mut rng) };
    let (mut w, mut sum, mut aim, mut u) = (0.0, 0.0, 0.0, 0.0);
    let (mut set, mut shown) = (Vec::new(), Vec::new());
    for row in 0..3000 {
        if row % 200 == 0 {
            aim = 40.0 * drawn();
        }
        if drive.by == By::Plan {
            u = 0.9 * u + 0.1 * (0.03 * aim + drawn());
        }
        let seen = w + drive.felt * u + 0.5 * drawn();
        let error = aim - if drive.by == By::Recorded { seen } else { w + 0.5 * drawn() };
        sum += 0.003 * error;
        if drive.by != By::Plan {
            u = 0.15 * error + sum;
        }
        set.push(u);
        shown.push(seen);
        let steps = 100;
        for _ in 0..steps {
            let rate = |w: f64| (0.05 * u - 0.0015 * w - drive.friction * (w / 0.1).tanh()) / 0.001;
            let h = 0.01 / f64::from(steps);
            w += h * rate(w + 0.5 * h * rate(w));
        }
    }
    let time: Vec<f64> = (0..shown.len()).map(|i| 0.01 * i as f64).collect();
    let unit = |u: &str| Unit::parse(u).unwrap();
    let channels = vec![
        Channel { hold: drive.hold, ..Channel::new("u", unit("V"), time.clone(), set) },
        Channel::new("speed", unit("rad/s"), time, shown),
    ];
    diagnosed(&Model::parse(MOTOR).unwrap(), Recording::from_channels("drive", channels).unwrap()).answer
}

fn is_told(answer: &Answer) -> bool {
    answer.notes.iter().any(|n| n.contains(SET))
}

#[test]
fn the_noise_of_a_reading_in_the_command_of_its_row_is_no_error_of_the_sensor() {
    for seed in 1..4 {
        let answer = found(Drive { seed, ..LOOP });
        assert_eq!(answer.verdict, Verdict::NothingMissing, "{seed}: {}", answer.says);
        assert!(is_told(&answer), "{seed}: {:?}", answer.notes);
    }
}

#[test]
fn nor_is_it_where_nobody_said_that_the_command_is_held() {
    let answer = found(Drive { hold: Hold::Linear, ..LOOP });
    assert_eq!(answer.verdict, Verdict::NothingMissing, "{}", answer.says);
    assert!(answer.faults.iter().any(|f| f.finding.code == "input-hold"), "{:?}", answer.faults);
}

#[test]
fn a_controller_with_a_sensor_of_its_own_is_not_told_so() {
    let answer = found(Drive { by: By::Another, ..LOOP });
    assert_eq!(answer.verdict, Verdict::NothingMissing, "{}", answer.says);
    assert!(!is_told(&answer), "{:?}", answer.notes);
}

#[test]
fn friction_keeps_its_name_in_such_a_loop() {
    let answer = found(Drive { friction: 0.05, ..LOOP });
    assert_eq!(answer.verdict, Verdict::Named, "{}", answer.says);
    assert_eq!(answer.findings[0].code, "dry-friction", "{}", answer.says);
}

/// A sensor that feels the voltage does so in the loop and out of it.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_sensor_that_feels_the_command_is_found() {
    for by in [By::Recorded, By::Plan] {
        let answer = found(Drive { by, felt: 1.5, ..LOOP });
        assert!(answer.findings.iter().any(|f| f.code == "output-cross-axis"), "{}", answer.says);
        assert!(by == By::Recorded || !is_told(&answer), "{:?}", answer.notes);
    }
}

const ROOM: &str = r#"
    name = "room"
    [inputs]
    heat = { unit = "W" }
    outside = { unit = "degC" }
    [parameters]
    k = { value = 80, unit = "W/K", fit = true }
    C = { value = 1e6, unit = "J/K", fit = true }
    [states]
    T = { rate = "(heat - k*(T - outside))/C", unit = "degC", initial = 20 }
    [outputs]
    room = { equals = "T", unit = "degC" }
"#;

/// Two days of 1.2 MJ/K under a thermostat that sets the heat each minute by a thermometer of 0.1 K, logged as it comes: with
/// straight lines between rows. The thermometer "feels" the heat then, on what was held out too, below its own noise.
#[test]
fn a_thermostat_logged_as_it_comes_lacks_nothing() {
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    let mut drawn = || -> f64 { StandardNormal.sample(&mut rng) };
    let (mut t, mut sum) = (20.0, 0.0);
    let minutes: Vec<f64> = (0..2880).map(|i| 60.0 * f64::from(i)).collect();
    let outside: Vec<f64> = minutes.iter().map(|s| 7.0 + 4.0 * (s * 7.272e-5).sin()).collect();
    let (mut heat, mut room) = (Vec::new(), Vec::new());
    for air in &outside {
        let seen = t + 0.1 * drawn();
        sum += (21.0 - seen) / 60.0;
        let set = (1000.0 * (21.0 - seen + sum)).clamp(0.0, 2500.0);
        heat.push(set);
        room.push(seen);
        // exact where the air outside stands still
        let rest = air + set / 100.0;
        t = rest + (t - rest) * f64::exp(-60.0 * 100.0 / 1.2e6);
    }
    let channel = |name: &str, unit: &str, values: Vec<f64>| {
        let unit = Unit::parse(unit).unwrap();
        let values = values.into_iter().map(|v| unit.to_si(v)).collect();
        Channel::new(name, unit, minutes.clone(), values)
    };
    let channels =
        vec![channel("heat", "W", heat), channel("outside", "degC", outside), channel("room", "degC", room)];
    let recording = Recording::from_channels("house", channels).unwrap();
    let answer = diagnosed(&Model::parse(ROOM).unwrap(), recording).answer;
    assert_eq!(answer.verdict, Verdict::NothingMissing, "{}", answer.says);
}
