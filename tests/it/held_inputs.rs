//! Whether an input is held between its samples or runs straight is settled before anything is named.

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
    T = { value = 0.2, unit = "s", fit = true, min = 1e-3, max = 1e3 }
    K = { value = 2, unit = "rad/s/V", fit = true }
    [states]
    w = { rate = "(K*u - w)/T", unit = "rad/s", initial = 0 }
    [outputs]
    speed = { equals = "w", unit = "rad/s" }
"#;
const STEP: f64 = 0.02;

/// Speed of the motor with T = 0.25 s and K = 2.2 rad/s/V, by the exact solution between samples: of a held voltage,
/// or of one that runs straight, so many samples late, or early.
fn recorded(is_held: bool, late: isize, seed: u64) -> Recording {
    recorded_with(|u| u, (is_held, late), seed)
}

/// The same where of each voltage only some acts.
fn recorded_with(acts: impl Fn(f64) -> f64, (is_held, late): (bool, isize), seed: u64) -> Recording {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut normal = || -> f64 { StandardNormal.sample(&mut rng) };
    let (count, time_constant, gain) = (3000, 0.25, 2.2);
    let mut u = vec![0.0; count];
    for i in 1..count {
        u[i] = 0.9 * u[i - 1] + normal();
    }
    let decay = f64::exp(-STEP / time_constant);
    let mut w = vec![0.0; count];
    for i in 1..count {
        let at = |i: usize| acts(i.checked_add_signed(-late).and_then(|i| u.get(i)).copied().unwrap_or(0.0));
        let (from, to) = (at(i - 1), if is_held { at(i - 1) } else { at(i) });
        // w(h) = (w − K u₀ + K s T) e^(−h/T) + K u₀ + K s (h − T) for u = u₀ + s t
        let ramp = gain * (to - from) / STEP;
        let settled = |t: f64| gain * from + ramp * (t - time_constant);
        w[i] = (w[i - 1] - settled(0.0)) * decay + settled(STEP);
    }
    let time: Vec<f64> = (0..count).map(|i| STEP * i as f64).collect();
    let noisy = w.iter().map(|w| w + 0.05 * normal()).collect();
    let unit = |text: &str| Unit::parse(text).unwrap();
    let channels = vec![
        Channel::new("u", unit("V"), time.clone(), u),
        Channel::new("speed", unit("rad/s"), time, noisy),
    ];
    Recording::from_channels("motor", channels).unwrap()
}

fn answer(is_held: bool, late: isize, seed: u64) -> Answer {
    diagnosed(&Model::parse(MOTOR).unwrap(), recorded(is_held, late, seed)).answer
}

/// A fit reads an input as the diagnosis of the same recording does, and says so.
#[test]
fn a_fit_reads_a_held_command_as_held() {
    let model = Model::parse(MOTOR).unwrap();
    for is_held in [true, false] {
        let recordings = [recorded(is_held, 0, 9)];
        let fitted = gyrospec::fit(&model, &recordings).run().unwrap();
        for (name, truth) in [("T", 0.25), ("K", 2.2)] {
            let p = fitted.parameter(name).unwrap();
            assert!((p.value - truth).abs() < 3.0 * (p.high - p.low) / 4.0, "{is_held} {name} {}", p.value);
        }
        assert!(fitted.holdout_rmse("speed").unwrap() < 0.053);
        let told = fitted.warnings().any(|w| w.starts_with("u is held between its samples, and was read so"));
        assert_eq!(told, is_held);
    }
}

#[test]
fn a_held_command_leads_to_no_name() {
    for seed in [1, 2] {
        let told = answer(true, 0, seed);
        assert_eq!(told.verdict, Verdict::NothingMissing, "{}", told.says);
        assert!(told.findings.is_empty());
        let fault = &told.faults[0];
        assert_eq!((fault.finding.code.as_str(), told.faults.len()), ("input-hold", 1));
        assert!(fault.finding.evidence.as_ref().is_some_and(|e| e.log_likelihood_ratio > 3.0));
        assert!(told.says.contains("hold = \"previous\"") && !told.says.contains("Faults"), "{}", told.says);
    }
}

/// A command that stays for seven samples, of a motor that follows within one, its speed in °/s under rad/s: read as straight, the
/// command leaves more than a wrong unit may, and so hides it.
#[test]
fn how_a_command_is_read_hides_no_wrong_unit() {
    let known = MOTOR
        .replace(
            "K = { value = 2, unit = \"rad/s/V\", fit = true }",
            "K = { value = 2.2, unit = \"rad/s/V\" }",
        )
        .replace(
            "T = { value = 0.2, unit = \"s\", fit = true, min = 1e-3, max = 1e3 }",
            "T = { value = 0.007, unit = \"s\" }",
        )
        .replace("initial = 0", "initial = \"fit\"");
    assert!(known.contains("0.007") && known.contains("2.2") && known.contains("fit"));
    let mut rng = ChaCha8Rng::seed_from_u64(21);
    let mut normal = || -> f64 { StandardNormal.sample(&mut rng) };
    let levels: Vec<f64> = (0..300).map(|_| 3.0 * normal()).collect();
    let u: Vec<f64> = (0..2100).map(|i| levels[i / 7]).collect();
    let (decay, mut w) = (f64::exp(-STEP / 0.007), vec![0.0; u.len()]);
    for i in 1..u.len() {
        w[i] = 2.2 * u[i - 1] + (w[i - 1] - 2.2 * u[i - 1]) * decay;
    }
    let time: Vec<f64> = (0..u.len()).map(|i| STEP * i as f64).collect();
    let degrees = w.iter().map(|w| (w + 0.05 * normal()).to_degrees()).collect();
    let unit = |text: &str| Unit::parse(text).unwrap();
    let channels = vec![
        Channel::new("u", unit("V"), time.clone(), u),
        Channel::new("speed", unit("rad/s"), time, degrees),
    ];
    let told =
        diagnosed(&Model::parse(&known).unwrap(), Recording::from_channels("motor", channels).unwrap())
            .answer;
    let faults: Vec<(&str, &str)> =
        told.faults.iter().map(|f| (f.finding.code.as_str(), f.finding.site.name.as_str())).collect();
    assert_eq!(told.verdict, Verdict::DataFault, "{}", told.says);
    assert!(
        faults.contains(&("wrong-unit", "speed")) && faults.contains(&("input-hold", "u")),
        "{}",
        told.says
    );
    assert_eq!(told.located.sites.len(), 1, "{:?}", told.located.sites);
}

#[test]
fn what_runs_straight_is_left_so() {
    let told = answer(false, 0, 3);
    assert_eq!((told.verdict, told.faults.len()), (Verdict::NothingMissing, 0), "{}", told.says);
}

#[test]
fn a_delay_of_two_samples_is_no_hold() {
    let told = answer(false, 2, 4);
    let finding = &told.findings[0];
    let codes = std::iter::once(&finding.code).chain(&finding.ties);
    assert!(codes.into_iter().any(|c| c.ends_with("-delay")), "{}", told.says);
    assert!(told.faults.is_empty());
    let late = &finding.parameters[0];
    assert!((late.value - 2.0 * STEP).abs() < 0.2 * STEP, "{}", told.says);
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn an_output_that_answers_before_its_input_has_rows_that_are_shifted() {
    for (early, seed) in [(1, 5), (3, 6)] {
        let told = answer(false, -early, seed);
        let finding = &told.findings[0];
        assert_eq!((told.verdict, finding.code.as_str()), (Verdict::Named, "clock-offset"), "{}", told.says);
        assert_eq!((told.findings.len(), finding.site.name.as_str()), (1, "u"));
        let offset = &finding.parameters[0];
        let true_one = early as f64 * STEP;
        assert!((offset.value - true_one).abs() < 0.05 * STEP, "{}", told.says);
        assert!(offset.low < true_one && true_one < offset.high, "{}", told.says);
    }
}

/// The voltage comes in stairs from a logger whose clock runs so much fast; the motor by its exact solution from stair
/// to stair.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn the_clock_of_a_held_command_runs_fast() {
    let fast = 1e-3;
    let mut rng = ChaCha8Rng::seed_from_u64(8);
    let mut normal = || -> f64 { StandardNormal.sample(&mut rng) };
    let (stairs, every, time_constant, gain) = (200, 0.5, 0.25, 2.2);
    let u: Vec<f64> = (0..stairs).map(|_| 3.0 * normal()).collect();
    let logged: Vec<f64> = (0..stairs).map(|k| every * f64::from(k) * (1.0 + fast)).collect();
    let time: Vec<f64> = (0..4950).map(|i| STEP * f64::from(i)).collect();
    let (mut w, mut k, mut t) = (0.0, 0, 0.0);
    let mut speed = Vec::new();
    for to in &time {
        while t < *to {
            let next = to.min(every * (k + 1) as f64);
            w = gain * u[k] + (w - gain * u[k]) * f64::exp(-(next - t) / time_constant);
            t = next;
            k += usize::from(t < *to);
        }
        speed.push(w + 0.05 * normal());
    }
    let unit = |text: &str| Unit::parse(text).unwrap();
    let mut command = Channel::new("u", unit("V"), logged, u);
    command.hold = Hold::Previous;
    let mut answered = Channel::new("speed", unit("rad/s"), time, speed);
    answered.table = 1;
    let made = Recording::from_channels("motor", vec![command, answered]).unwrap();
    let told = diagnosed(&Model::parse(MOTOR).unwrap(), made).answer;
    let finding = &told.findings[0];
    assert_eq!((told.verdict, finding.code.as_str()), (Verdict::Named, "clock-drift"), "{}", told.says);
    // a clock that runs fast gains
    let rate = &finding.parameters[0];
    assert!((rate.value - fast).abs() < 0.03 * fast, "{}", told.says);
}

/// M q″ = F − b q′ − k q.
pub const AXIS: &str = r#"
    name = "axis"
    [inputs]
    F = { unit = "N" }
    [parameters]
    M = { value = 2, unit = "kg", fit = true, min = 0.1, max = 100 }
    b = { value = 3, unit = "N*s/m", fit = true, min = 0, max = 100 }
    k = { value = 60, unit = "N/m", fit = true, min = 1, max = 1e4 }
    [states]
    q = { rate = "v", unit = "m", initial = "fit" }
    v = { rate = "(F - b*v - k*q)/M", unit = "m/s", initial = "fit" }
    [outputs]
    position = { equals = "q", unit = "m" }
"#;

/// The axis with M = 2.2, b = 2.5, k = 70 and a force of q and v that opposes it, so large that the reading of the
/// input cannot be told before that is known; solved by Runge and Kutta's method at a tenth of a sample, the input held.
fn opposed(input: fn(f64) -> f64, by: fn(f64, f64) -> f64, seed: u64) -> Recording {
    let (count, h) = (3000, STEP / 10.0);
    let force: Vec<f64> = (0..count).map(|i| input(STEP * f64::from(i))).collect();
    let add = |[q, v]: [f64; 2], h: f64, [a, b]: [f64; 2]| [q + h * a, v + h * b];
    let (mut state, mut position) = ([0.0, 0.0], Vec::new());
    for force in &force {
        position.push(state[0]);
        let rate = |[q, v]: [f64; 2]| [v, (force - 2.5 * v - 70.0 * q - by(q, v)) / 2.2];
        for _ in 0..10 {
            let a = rate(state);
            let b = rate(add(state, h / 2.0, a));
            let c = rate(add(state, h / 2.0, b));
            let d = rate(add(state, h, c));
            let mean = |k: usize| (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]) / 6.0;
            state = add(state, h, [mean(0), mean(1)]);
        }
    }
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut normal = || -> f64 { StandardNormal.sample(&mut rng) };
    let time: Vec<f64> = (0..count).map(|i| STEP * f64::from(i)).collect();
    let noisy = position.iter().map(|q| q + 2e-4 * normal()).collect();
    let unit = |text: &str| Unit::parse(text).unwrap();
    let channels = vec![
        Channel::new("F", unit("N"), time.clone(), force),
        Channel::new("position", unit("m"), time, noisy),
    ];
    Recording::from_channels("axis", channels).unwrap()
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_hold_behind_something_larger_is_nothing_beside_it() {
    let two = |t: f64| 30.0 * (1.3 * t).sin() + 20.0 * (4.1 * t + 1.0).sin();
    let many = |t: f64| (1..=25).map(f64::from).map(|k| 12.0 * (0.7 * k * t + k * k).sin()).sum::<f64>();
    for (made, code) in [
        (opposed(two, |q, _| 400.0 * q * q * q, 5), "cubic-stiffness"),
        (opposed(many, |_, v| 12.0 * v * v.abs(), 6), "quadratic-damping"),
    ] {
        let told = diagnosed(&Model::parse(AXIS).unwrap(), made).answer;
        let codes: Vec<&str> = told.findings.iter().map(|f| f.code.as_str()).collect();
        assert_eq!((told.verdict, codes.as_slice()), (Verdict::Named, &[code][..]), "{}", told.says);
        assert_eq!(told.faults[0].finding.code, "input-hold", "{}", told.says);
        assert!(told.faults[0].finding.evidence.as_ref().is_some_and(|e| e.log_likelihood_ratio > 3.0));
    }
}

/// A command that changes at each sample, read straight, beside a zone in which it does nothing: with its other laws a wrong
/// reading would lead elsewhere.
#[test]
fn a_hold_is_found_beside_a_dead_zone() {
    let acts = |u: f64| u - u.clamp(-0.8, 0.8);
    let told = diagnosed(&Model::parse(MOTOR).unwrap(), recorded_with(acts, (true, 0), 12)).answer;
    let codes: Vec<&str> = told.findings.iter().map(|f| f.code.as_str()).collect();
    assert_eq!((told.verdict, codes.as_slice()), (Verdict::Named, &["input-dead-zone"][..]), "{}", told.says);
    assert!(told.faults.iter().any(|f| f.finding.code == "input-hold"), "{}", told.says);
    let zone = &told.findings[0].parameters[0];
    assert!(zone.low < 0.8 && 0.8 < zone.high, "{}", told.says);
}

/// Stairs of half a second, whose reading hides behind friction: what stays and leaps is held unless the data say otherwise.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_command_that_stays_and_leaps_is_held_though_friction_hides_it() {
    let stairs = |t: f64| [30.0, -20.0, 5.0, 24.0, -31.0, 12.0, -9.0][(t / 0.5 + 1e-6) as usize * 3 % 7];
    let made = opposed(stairs, |_, v| 4.0 * (v / 5e-3).tanh(), 7);
    let model = Model::parse(AXIS).unwrap();
    let told = diagnosed(&model, made.clone()).answer;
    let codes: Vec<&str> = told.findings.iter().map(|f| f.code.as_str()).collect();
    assert_eq!((told.verdict, codes.as_slice()), (Verdict::Named, &["dry-friction"][..]), "{}", told.says);
    assert_eq!(told.faults[0].finding.code, "input-hold", "{}", told.says);
    let friction = &told.findings[0].parameters[0];
    assert!(friction.low < 4.0 && 4.0 < friction.high, "{}", told.says);
    // a run of a model that fits says that it would fit better held
    let law = AXIS.replace("b*v - k*q)", "b*v - k*q - 4*N*tanh(v/vs))").replace(
        "[states]",
        "N = { value = 1, unit = \"N\" }\n    vs = { value = 5e-3, unit = \"m/s\" }\n    [states]",
    );
    let law = law.replace("value = 2,", "value = 2.2,").replace("value = 3,", "value = 2.5,");
    let law = Model::parse(&law.replace("value = 60,", "value = 70,")).unwrap();
    let warned = |r: &Recording| gyrospec::simulate(&law, r).run().unwrap().warnings().join("; ");
    assert!(warned(&made).contains("F is read as straight lines"), "{}", warned(&made));
    let mut held = made;
    held.channels[0].hold = Hold::Previous;
    assert!(!warned(&held).contains("read as"), "{}", warned(&held));
}

/// A cell with an ohmic part and a store, under a held current: each sample has the current of its own row.
#[test]
fn a_held_input_acts_at_once_on_an_output_that_it_feeds() {
    let text = "name = \"cell\"\n[inputs]\ni = { unit = \"A\" }\n[parameters]\nR = { value = 0.5, unit = \"ohm\" }\n\
        T = { value = 3, unit = \"s\" }\nQ = { value = 0.2, unit = \"ohm\" }\n[states]\n\
        v = { rate = \"(Q*i - v)/T\", unit = \"V\", initial = 0 }\n[outputs]\n\
        u = { equals = \"R*i + v\", unit = \"V\" }\n";
    let times: Vec<f64> = (0..200).map(|k| 0.5 * f64::from(k)).collect();
    let currents: Vec<f64> = (0..200).map(|k| f64::from((k / 7) * 37 % 11) - 4.0).collect();
    let mut v = 0.0;
    let exact: Vec<f64> = currents
        .iter()
        .map(|i| {
            let now = 0.5 * i + v;
            v = 0.2 * i + (v - 0.2 * i) * (-0.5 / 3.0f64).exp();
            now
        })
        .collect();
    let unit = |text: &str| gyrospec::units::Unit::parse(text).unwrap();
    let mut current = Channel::new("i", unit("A"), times.clone(), currents);
    current.hold = gyrospec::record::Hold::Previous;
    let recording =
        Recording::from_channels("cell", vec![current, Channel::new("u", unit("V"), times, exact)]).unwrap();
    let ran = gyrospec::simulate(&Model::parse(text).unwrap(), &recording).run().unwrap();
    // the solver's tolerance is 1e-5 of the spread; a current of the row before would be off by volts
    assert!(ran.output("u").unwrap().errors().1 < 1e-5, "{:?}", ran.output("u").unwrap().errors());
}
