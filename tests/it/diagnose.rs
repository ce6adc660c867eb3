//! The diagnosis on recordings made by a stepper that shares nothing with the simulator.

mod calibrated;
mod no_noise;

use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::diagnose::laboratory::{Scenario, Stepper};
use gyrospec::diagnose::{Diagnosis, Request, diagnose};
use gyrospec::estimate::fit::Silent;
use gyrospec::expression::Expr;
use gyrospec::model::{Initial, Model};
use gyrospec::record::{Channel, Recording};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::sync::LazyLock;

/// Noise of lag-one correlation 0.9 and unit deviation, from a small congruential generator.
pub fn noise(n: usize, mut seed: u64) -> Vec<f64> {
    let mut uniform = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut e = 0.0;
    (0..n)
        .map(|_| {
            let white = (0..12).map(|_| uniform()).sum::<f64>();
            e = 0.9 * e + (1.0f64 - 0.81).sqrt() * white;
            e
        })
        .collect()
}

/// The axis of the laboratory with every second of its rows: 2500 in 50 s.
pub fn axis() -> Scenario {
    let mut scenario = Scenario::axis(5).unwrap();
    let thinned = |c: &Channel| {
        let of = |v: &[f64]| v.iter().copied().step_by(2).collect::<Vec<f64>>();
        Channel { hold: c.hold, ..Channel::new(&*c.name, c.unit.clone(), of(&c.time), of(&c.values)) }
    };
    let channels = scenario.recording.channels.iter().map(thinned).collect();
    scenario.recording = Recording::from_channels(&*scenario.recording.name, channels).unwrap();
    scenario
}

/// The axis with another force in its sum, simulated and covered with noise of 1 % of the motion.
pub fn recording(force: Option<&str>) -> (Model, Recording) {
    moved(axis(), force)
}

/// The same with the inputs of a scenario.
pub fn moved(scenario: Scenario, force: Option<&str>) -> (Model, Recording) {
    covered(scenario, force, |n| noise(n, 77))
}

/// The same with noise of its own, of the size of 1.
fn covered(scenario: Scenario, force: Option<&str>, noise: impl Fn(usize) -> Vec<f64>) -> (Model, Recording) {
    let mut truth = scenario.model.clone();
    if let Some(force) = force {
        truth.states[1].rate = Expr::parse(&format!("(force - Fv*v - k*q - {force})/M")).unwrap();
    }
    let mut recording = scenario.recording.clone();
    let time = recording.channels[0].time.to_vec();
    let y = Stepper::new(&truth, &scenario.recording).unwrap().outputs(&time).remove(0);
    let size = (y.iter().map(|v| v * v).sum::<f64>() / y.len() as f64).sqrt();
    let position = recording.channels.iter_mut().find(|c| c.name == "position").unwrap();
    for ((v, y), e) in position.values.iter_mut().zip(&y).zip(noise(y.len())) {
        *v = y + 0.01 * size * e;
    }
    let mut model = scenario.model;
    model.parameters[0].value *= 1.2;
    model.parameters[1].value *= 0.7;
    for s in &mut model.states {
        s.initial = Initial::Fit;
    }
    (model, recording)
}

/// What is said of a force that the catalogue lacks; found once for all tests that read it.
pub fn of_no_name() -> &'static Answer {
    static ANSWER: LazyLock<Answer> = LazyLock::new(|| {
        let (model, recording) = recording(Some("3*sin(50*q)*(v/0.3)^2"));
        diagnosed(&model, recording).answer
    });
    &ANSWER
}

pub fn diagnosed(model: &Model, recording: Recording) -> Diagnosis {
    let recordings = [recording];
    let request = Request {
        model,
        source: None,
        recordings: &recordings,
        separate: &[],
        seed: 1,
        time_limit: None,
        progress: &Silent,
    };
    diagnose(&request).unwrap()
}

#[test]
fn dry_friction_is_named_with_its_size_and_proved() {
    let (model, recording) = recording(Some("1.5*sign(v)"));
    let d = diagnosed(&model, recording);
    assert_eq!(d.answer.verdict, Verdict::Named, "{}", d.answer.says);
    let first = &d.answer.findings[0];
    assert_eq!((first.code.as_str(), first.site.name.as_str()), ("dry-friction", "v"));
    assert!((first.parameters[0].value - 1.5).abs() < 0.1, "{first:?}");
    assert!(d.answer.proof[0].holdout_after < 0.5 * d.answer.proof[0].holdout_before);
    assert!(d.answer.proof[0].improvement_low > 0.0);
}

#[test]
fn a_complete_model_lacks_nothing_under_coloured_noise() {
    let (model, recording) = recording(None);
    let d = diagnosed(&model, recording);
    assert_eq!(d.answer.verdict, Verdict::NothingMissing, "{}", d.answer.says);
    assert!(d.answer.findings.is_empty() && !d.answer.detection.smallest_visible.is_empty());
}

/// More rows than an effect needs to stand out of white noise do not make it large enough to count.
#[test]
fn what_would_have_shown_shows() {
    let with = |force: Option<&str>| {
        let (model, recording) = covered(axis(), force, |n| {
            let mut rng = ChaCha8Rng::seed_from_u64(11);
            (0..n).map(|_| StandardNormal.sample(&mut rng)).collect()
        });
        diagnosed(&model, recording).answer
    };
    let complete = with(None);
    assert_eq!(complete.verdict, Verdict::NothingMissing, "{}", complete.says);
    let shown = complete.detection.smallest_visible.iter().find(|v| v.code == "input-square").unwrap();
    let of = |part: f64| with(Some(&format!("-({}*force^3)", part * shown.value)));
    let named = of(1.6);
    let first = &named.findings[0];
    let codes: Vec<&str> = std::iter::once(&first.code).chain(&first.ties).map(String::as_str).collect();
    assert!(codes.contains(&"input-square"), "{}: {}", shown.value, named.says);
    let less = of(0.6);
    assert_eq!(less.verdict, Verdict::NothingMissing, "{}: {}", shown.value, less.says);
}

/// Waves in position follow such a law in part: they must not pass for it.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_law_of_two_signals_outside_the_catalogue_is_unknown() {
    let answer = of_no_name();
    assert_eq!(answer.verdict, Verdict::Unknown, "{}", answer.says);
    let left = answer.unexplained.as_ref().unwrap();
    assert_eq!(left.signal, "q, v");
    assert!(left.p_value < 1e-6, "{left:?}");
}

/// A second effect a tenth as large as the first is found too, where nothing is left after it.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_small_second_effect_is_found_beside_a_large_one() {
    let (model, recording) = recording(Some("(4000*q^3 + 0.25*sign(v))"));
    let d = diagnosed(&model, recording);
    let codes: Vec<&str> = d.answer.findings.iter().map(|f| f.code.as_str()).collect();
    assert_eq!(codes, ["cubic-stiffness", "dry-friction"], "{}", d.answer.says);
    let friction = &d.answer.findings[1].parameters[0];
    assert!((friction.value - 0.25).abs() < 0.08, "{friction:?}");
}

#[test]
fn a_stuck_sensor_is_a_fault_and_no_physics() {
    let (model, mut recording) = recording(None);
    let position = recording.channels.iter_mut().find(|c| c.name == "position").unwrap();
    let held = position.values[1000];
    position.values[1000..1300].fill(held);
    let d = diagnosed(&model, recording);
    assert_eq!(d.answer.verdict, Verdict::DataFault, "{}", d.answer.says);
    assert_eq!(d.answer.findings[0].code, "frozen-channel");
    assert_eq!(d.answer.findings.len(), 1);
    assert_eq!(d.answer.faults.len(), 1);
}

/// The recording as a table in other units, under other names.
fn table(recording: &Recording, columns: [(&str, &str, f64, &str); 2]) -> String {
    let mut text =
        format!("when [s],{} [{}],{} [{}]\n", columns[0].3, columns[0].1, columns[1].3, columns[1].1);
    let channels = columns.map(|(name, _, factor, _)| (recording.find(name).unwrap(), factor));
    for (i, t) in channels[0].0.time.iter().enumerate() {
        let value = |k: usize| channels[k].0.values[i] * channels[k].1;
        text += &format!("{t:.3},{:.9e},{:.9e}\n", value(0), value(1));
    }
    text
}

#[test]
fn names_and_units_steer_nothing() {
    let (_, made) = moved(Scenario::axis(5).unwrap(), Some("8*v*abs(v)"));
    let plain = r#"
        name = "axis"
        [inputs]
        force = { unit = "N" }
        [parameters]
        M = { value = 4.8, unit = "kg", fit = true, min = 0.1, max = 100 }
        Fv = { value = 4.2, unit = "N*s/m", fit = true, min = 0, max = 1000 }
        k = { value = 150, unit = "N/m", fit = true, min = 0, max = 1e5 }
        [states]
        q = { rate = "v", unit = "m", initial = "fit" }
        v = { rate = "(force - Fv*v - k*q)/M", unit = "m/s", initial = "fit" }
        [outputs]
        position = { equals = "q", unit = "m" }
    "#;
    let renamed = r#"
        name = "dry-friction of the temperature"
        [inputs]
        heading = { unit = "kN" }
        [parameters]
        F0 = { value = 4800, unit = "g", fit = true, min = 100, max = 1e5 }
        tau = { value = 0.0042, unit = "kN*s/m", fit = true, min = 0, max = 1 }
        offset = { value = 0.15, unit = "N/mm", fit = true, min = 0, max = 100 }
        [states]
        lag_1 = { rate = "drift", unit = "mm", initial = "fit" }
        drift = { rate = "(heading - tau*drift - offset*lag_1)/F0", unit = "mm/s", initial = "fit" }
        [outputs]
        clock = { equals = "lag_1", unit = "mm" }
    "#;
    let folder = tempfile::tempdir().unwrap();
    let answer = |model: &str, columns: [(&str, &str, f64, &str); 2]| {
        let path = folder.path().join("table.csv");
        std::fs::write(&path, table(&made, columns)).unwrap();
        diagnosed(&Model::parse(model).unwrap(), Recording::read(&path).unwrap()).answer
    };
    let a = answer(plain, [("force", "N", 1.0, "force"), ("position", "m", 1.0, "position")]);
    let b = answer(renamed, [("force", "kN", 1e-3, "heading"), ("position", "mm", 1e3, "clock")]);
    assert_eq!((a.verdict, b.verdict), (Verdict::Named, Verdict::Named), "{} {}", a.says, b.says);
    let (f, g) = (&a.findings[0], &b.findings[0]);
    assert_eq!((f.code.as_str(), g.code.as_str()), ("quadratic-damping", "quadratic-damping"));
    assert_eq!((f.site.name.as_str(), g.site.name.as_str()), ("v", "drift"));
    // The same coefficient, told in two units.
    let ratio = f.parameters[0].value / g.parameters[0].value;
    assert!((f.parameters[0].value - 8.0).abs() < 0.2, "{f:?}");
    assert!((ratio / ratio_of(&g.parameters[0].unit) - 1.0).abs() < 0.01, "{ratio} {}", g.parameters[0].unit);
}

/// SI units in a unit of quadratic damping.
fn ratio_of(unit: &str) -> f64 {
    gyrospec::units::Unit::parse(unit).unwrap().to_si(1.0)
}

#[test]
fn an_output_that_never_moves_tells_nothing() {
    let (model, mut recording) = recording(None);
    for c in &mut recording.channels {
        c.time = c.time[..200].into();
        c.values.truncate(200);
    }
    recording.channels.iter_mut().find(|c| c.name == "position").unwrap().values.fill(0.25);
    let d = diagnosed(&model, recording);
    assert_ne!(d.answer.verdict, Verdict::Named, "{}", d.answer.says);
    assert_ne!(d.answer.verdict, Verdict::NothingMissing, "{}", d.answer.says);
}

/// A table of trials of which the model knows an offset alone: the error goes with the square of the
/// amplitude and the sine of twice the heading.
#[test]
fn the_rolling_error_is_named_in_a_table_of_trials() {
    let model = Model::parse(
        r#"
        name = "no rolling error"
        [inputs]
        heading = { unit = "deg" }
        roll = { unit = "deg" }
        [parameters]
        b = { value = 0, unit = "deg", fit = true }
        [outputs]
        error = { equals = "b + 0*roll*sin(heading)", unit = "deg" }
        "#,
    )
    .unwrap();
    let scatter = noise(288, 5);
    let mut text = String::from("heading [deg],roll [deg],error [deg]\n");
    for (i, e) in scatter.iter().enumerate() {
        let (heading, roll) = (15.0 * (i % 24) as f64, 5.0 + 2.0 * (i / 24) as f64);
        let error = 0.2 + 0.004 * roll * roll * (2.0 * heading.to_radians()).sin() + 0.02 * e;
        text += &format!("{heading},{roll},{error:.5}\n");
    }
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("t.csv"), text).unwrap();
    let table = folder.path().join("t.toml");
    std::fs::write(&table, "name = \"t\"\nkind = \"trials\"\n[[tables]]\nfile = \"t.csv\"\n").unwrap();
    let d = diagnosed(&model, Recording::read(&table).unwrap());
    assert_eq!(d.answer.verdict, Verdict::Named, "{}", d.answer.says);
    let codes: Vec<&str> = d.answer.findings.iter().map(|f| f.code.as_str()).collect();
    assert_eq!(codes, ["rectified-motion"], "{}", d.answer.says);
}
