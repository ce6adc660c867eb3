use super::*;
use crate::model::Model;
use crate::record::{Channel, Hold, Recording};
use crate::simulate::{Options, Simulator, Unknown};
use crate::units::Unit;

/// A body on a spring between an input's sine and dry friction, which sticks and slips.
const STICKING: &str = r#"
    name = "sticking"
    [inputs]
    force = { unit = "N" }
    [parameters]
    m = { value = 2, unit = "kg" }
    c = { value = 30, unit = "N/m" }
    r = { value = 1.5, unit = "N*s/m" }
    F = { value = 4, unit = "N" }
    [states]
    q = { rate = "v", unit = "m", initial = 0.1 }
    v = { rate = "(force - c*q - r*v - F*sign(v))/m", unit = "m/s", initial = 0 }
    [outputs]
    place = { equals = "q", unit = "m" }
"#;

/// A fast lag before a slow one with friction, which only the stiff method runs.
const STIFF: &str = r#"
    name = "stiff"
    [inputs]
    force = { unit = "N" }
    [parameters]
    T = { value = 1e-5, unit = "s" }
    r = { value = 1.5, unit = "N*s/m" }
    F = { value = 2, unit = "N" }
    m = { value = 2, unit = "kg" }
    [states]
    pull = { rate = "(force*(1 + 0.1*tanh(force/F)) - pull)/T", unit = "N", initial = 0 }
    v = { rate = "(pull - r*v - F*sign(v))/m", unit = "m/s", initial = 0 }
    [outputs]
    speed = { equals = "v", unit = "m/s" }
"#;

/// A loop that is closed late.
const LATE: &str = r#"
    name = "late"
    [inputs]
    force = { unit = "N" }
    [parameters]
    F = { value = 0.2, unit = "N" }
    Td = { value = 0.31, unit = "s" }
    r = { value = 1.5, unit = "N*s/m" }
    m = { value = 2, unit = "kg" }
    [states]
    v = { rate = "(force - r*delay(v, Td) - F*sign(v))/m", unit = "m/s", initial = 0.1 }
    [outputs]
    speed = { equals = "v", unit = "m/s" }
"#;

/// What stands still, changes at a time and when an input turns, and remembers.
const MIXED: &str = r#"
    name = "mixed"
    [inputs]
    force = { unit = "N" }
    pull = { unit = "N" }
    [parameters]
    m = { value = 2, unit = "kg" }
    c = { value = 30, unit = "N/m" }
    r = { value = 1.5, unit = "N*s/m" }
    F = { value = 0.4, unit = "N" }
    gap = { value = 0.02, unit = "m" }
    t0 = { value = 41.003, unit = "s" }
    [states]
    q = { rate = "v", unit = "m", initial = 0.1 }
    v = { rate = "(force*(1 + 0.3*step(t - t0)) + abs(pull) - c*backlash(q, gap) - r*v - F*sign(v))/m", unit = "m/s", initial = 0 }
    [outputs]
    place = { equals = "q", unit = "m" }
    speed = { equals = "v + 0.01*force/r", unit = "m/s" }
"#;

fn seen(name: &str, unit: &str, time: &[f64], values: Vec<f64>) -> Channel {
    Channel::new(name, Unit::parse(unit).unwrap(), time.to_vec(), values)
}

/// Of an output nothing but its times matters.
fn wanted(name: &str, unit: &str, time: &[f64]) -> Channel {
    seen(name, unit, time, vec![0.0; time.len()])
}

/// Times 0.02 s apart.
fn times(count: u32) -> Vec<f64> {
    (0..count).map(|i| 0.02 * f64::from(i)).collect()
}

fn wave(time: &[f64], frequency: f64) -> Vec<f64> {
    time.iter().map(|t| 5.0 * (frequency * t).sin() + 2.0 * (2.3 * t).cos()).collect()
}

fn ready(model: &Model, channels: Vec<Channel>) -> Simulator {
    let recording = Recording::from_channels("made", channels).unwrap();
    Simulator::new(model, &recording, &Options::default()).unwrap()
}

/// Force held as given, pull a line between samples; the place is seen from a first sample on every so many, the speed
/// later by some part of a step.
fn mixed(hold: Hold, (first, every): (usize, usize), later: f64) -> Simulator {
    let time = times(6001);
    let mut force = seen("force", "N", &time, wave(&time, 0.7));
    force.hold = hold;
    let pull = seen("pull", "N", &time, wave(&time, 0.3));
    let some: Vec<f64> = time.iter().copied().skip(first).step_by(every).collect();
    let place = wanted("place", "m", &some);
    let shifted: Vec<f64> = time.iter().map(|t| t + later * 0.02).collect();
    ready(&Model::parse(MIXED).unwrap(), vec![force, pull, place, wanted("speed", "m/s", &shifted)])
}

fn made(model: &Model, inputs: &[(&str, &str)], (name, unit): (&str, &str)) -> Simulator {
    let time = times(6001);
    let input = |i: &(&str, &str)| seen(i.0, i.1, &time, wave(&time, 0.7));
    ready(model, inputs.iter().map(input).chain([wanted(name, unit, &time)]).collect())
}

#[test]
fn machine_code_and_interpreter_give_the_same_runs() {
    let sphere = Model::builtin("gyrosphere").unwrap();
    let sticking = Model::parse(STICKING).unwrap();
    let cases = [
        made(&sphere, &[("roll_acc", "rad/s^2"), ("heading", "deg")], ("alpha", "deg")),
        made(&sticking, &[("force", "N")], ("place", "m")),
        made(&Model::parse(STIFF).unwrap(), &[("force", "N")], ("speed", "m/s")),
        made(&Model::parse(LATE).unwrap(), &[("force", "N")], ("speed", "m/s")),
    ];
    assert_eq!(cases[2].plan.method, Solver::Stiff);
    cases.iter().for_each(runs_are_the_same);
    // with so little asked of it, all is compiled with much care
    let careful = |s: &Simulator| {
        let mut s = s.clone();
        s.natives = Arc::new(Natives { worth: 1, kinds: Mutex::default() });
        runs_are_the_same(&s);
    };
    cases.iter().for_each(careful);
}

#[test]
fn steps_that_are_marched_over_give_the_same_runs() {
    for hold in [Hold::Linear, Hold::Previous, Hold::AfterReading] {
        for (place, later) in [((0, 1), 0.0), ((2, 3), 0.0), ((0, 1), 0.25)] {
            let simulator = mixed(hold, place, later);
            assert_ne!(simulator.plan.method, Solver::Stiff);
            runs_are_the_same(&simulator);
            let kinds = simulator.natives.kinds.lock().unwrap();
            let count = |n: &AtomicUsize| n.load(Ordering::Relaxed);
            let marches = |k: &Arc<Kind>| {
                let is_made = k.march.iter().any(|m| matches!(m.get(), Some(Some(_))));
                is_made && (later != 0.0 || 4 * count(&k.alone) < count(&k.asked))
            };
            assert!(!Steps::MADE || kinds.iter().all(marches), "most steps are marched over");
        }
    }
}

#[test]
fn a_window_without_a_jump_marches_as_one_with_jumps_does() {
    let time = times(12_000);
    let values = time.iter().map(|t| if *t < 120.0 { 3.0 } else { 5.0 * (0.7 * t).sin() }).collect();
    let mut force = seen("force", "N", &time, values);
    force.hold = Hold::Previous;
    let whole = ready(&Model::parse(STICKING).unwrap(), vec![force, wanted("place", "m", &time)]);
    for (from, to) in [(0.0, 110.0), (110.0, 220.0), (0.0, 110.0)] {
        runs_are_the_same(&whole.on_window(from, to).unwrap());
    }
}

fn runs_are_the_same(compiled: &Simulator) {
    let mut interpreted = compiled.clone();
    interpreted.natives = Arc::new(Natives { worth: usize::MAX, kinds: Mutex::default() });
    let (p, x) = (compiled.parameters(), compiled.initials());
    let unknowns = [Unknown::Parameter(0), Unknown::Parameter(1), Unknown::Initial(0)];
    let run = |s: &Simulator| s.run_with_sensitivities(&p, &x, &unknowns).unwrap();
    let (a, b) = (run(compiled), run(&interpreted));
    assert!(a.outputs[0].iter().any(|y| *y != 0.0), "something moves");
    let bits = |y: &[Vec<f64>]| y.iter().flatten().map(|y| y.to_bits()).collect::<Vec<u64>>();
    assert_eq!(bits(&a.outputs), bits(&b.outputs));
    for (a, b) in a.sensitivities.iter().flatten().flatten().zip(b.sensitivities.iter().flatten().flatten()) {
        assert!(a == b || (a.is_nan() && b.is_nan()), "{a} {b}");
    }
    assert_eq!((a.events, a.solver_error.to_bits()), (b.events, b.solver_error.to_bits()));
    let plain = |s: &Simulator| bits(&s.run(&p, &x).unwrap().outputs);
    assert_eq!(plain(compiled), plain(&interpreted));
    let kinds = compiled.natives.kinds.lock().unwrap();
    let tried = |k: &Arc<Kind>| {
        k.march.iter().any(|m| m.get().is_some()) || k.steps.iter().any(|s| s.get().is_some())
    };
    assert!(kinds.iter().all(tried), "all kinds were worth compiling");
}
