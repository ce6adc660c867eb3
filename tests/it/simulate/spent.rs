//! What a run spends of its budget: counted in steps, never in seconds.

use super::{channel, recording, times, worst};
use gyrospec::model::Model;
use gyrospec::simulate::{Budget, Options, Simulator, Solver, Unknown};

/// A small heater of 0.1 ms in a room of 30 s, and samples of the room a second apart.
const HEATER: &str = r#"
    name = "heater"
    [parameters]
    Tr = { value = 30, unit = "s" }
    Th = { value = 1e-4, unit = "s" }
    full = { value = 1, unit = "V" }
    [states]
    h = { rate = "(full - h)/Th", unit = "V", initial = 1.5 }
    y = { rate = "(h - y)/Tr", unit = "V", initial = 0 }
    [outputs]
    room = { equals = "y", unit = "V" }
"#;

/// Where the heater starts far from rest it is at rest after a millisecond, and only these need fine steps.
#[test]
fn a_start_far_from_rest_costs_a_few_steps_not_finer_ones_throughout() {
    let time = times(120.0, 1.0);
    let budget = Budget::new(1_000_000_000, None);
    let options = Options { budget: budget.clone(), ..Options::default() };
    let r = recording(vec![channel("room", "V", &time, |_| 0.0)]);
    let s = Simulator::new(&Model::parse(HEATER).unwrap(), &r, &options).unwrap();
    assert_eq!(s.steps().0, Solver::Stiff);
    let cost = |start: f64| {
        let before = budget.spent();
        let run = s.run_with_sensitivities(&s.parameters(), &[start, 0.0], &[Unknown::Initial(0)]).unwrap();
        (budget.spent() - before, run)
    };
    let quiet = cost(1.5).0;
    for start in [3.0, 1000.0, -4e5] {
        let (spent, run) = cost(start);
        assert!(spent <= 3 * quiet, "{spent} from {start}, {quiet} from near rest");
        // y = 1 + C e^(−t/Th) − (1 + C) e^(−t/Tr), C = (h0 − 1)/(1 − Tr/Th)
        let (tr, th) = (30.0, 1e-4);
        let c = |h0: f64| (h0 - 1.0) / (1.0 - tr / th);
        let y = |t: f64| 1.0 + c(start) * (-t / th).exp() - (1.0 + c(start)) * (-t / tr).exp();
        let size = time.iter().map(|t| y(*t).abs()).fold(0.0, f64::max);
        let off = worst(&time, &run.outputs[0], y);
        assert!(off < 1e-4 * size, "{off} of {size} from {start}");
        let slope = c(2.0);
        let off = worst(&time, &run.sensitivities[0][0], |t| slope * ((-t / th).exp() - (-t / tr).exp()));
        assert!(off < 1e-4 * slope.abs(), "{off} of {slope} from {start}");
    }
}

const SWING: &str = r#"
    name = "swing"
    [parameters]
    w = { value = 100, unit = "rad/s" }
    damping = { value = 0.01, unit = "1" }
    L = { value = 2, unit = "m" }
    [states]
    x = { rate = "v", unit = "m", initial = 1 }
    v = { rate = "-w*w*x - 2*damping*w*v", unit = "m/s", initial = 0 }
    [outputs]
    place = { equals = "x/L", unit = "1" }
"#;

/// A run at parameters that ask for thousands of steps between two samples ends, and tells which they are.
#[test]
fn one_run_ends_after_its_share_and_says_why() {
    let time = times(10.0, 0.1);
    let most = 20_000_000;
    let budget = Budget::new(most, None);
    let options = Options { budget: budget.clone(), ..Options::default() };
    let r = recording(vec![channel("place", "1", &time, |_| 0.0)]);
    let s = Simulator::new(&Model::parse(SWING).unwrap(), &r, &options).unwrap();
    assert!(s.run(&s.parameters(), &s.initials()).unwrap().blew_up.is_none());
    let before = budget.spent();
    let e = s.run(&[3000.0, 0.01, 2.0], &s.initials()).expect_err("too fast");
    let spent = budget.spent() - before;
    assert!(spent <= most / 100, "{spent} steps");
    let says = e.to_string();
    for part in ["100000 steps", "stiff", "3.333e-4 s", "w = 3000 rad/s", "0.1 s apart"] {
        assert!(says.contains(part), "{part} in {says}");
    }
    assert!(!says.contains("L = "), "{says}");
    assert_eq!(e.kind(), gyrospec::ErrorKind::NotComputed);
    // a part of the budget changes nothing of it, and sensitivities do not count
    let options = Options { budget: budget.part(50), ..Options::default() };
    let part = Simulator::new(&Model::parse(SWING).unwrap(), &r, &options).unwrap();
    let all = [Unknown::Parameter(0), Unknown::Parameter(1), Unknown::Initial(0), Unknown::Initial(1)];
    assert!(part.run_with_sensitivities(&part.parameters(), &part.initials(), &all).is_ok());
}

/// x' = a x + u grows by e^500 in a step; a method that damps what is fast would run beside −u/a as if it were stable.
#[test]
fn what_grows_fast_is_not_damped_away() {
    let time = times(4.0, 0.01);
    let model = r#"
        name = "runaway"
        [inputs]
        u = { unit = "V/s" }
        [parameters]
        a = { value = 5e4, unit = "1/s" }
        [states]
        x = { rate = "a*x + u", unit = "V", initial = 0 }
        [outputs]
        y = { equals = "x", unit = "V" }
    "#;
    let r = recording(vec![channel("u", "V/s", &time, f64::sin), channel("y", "V", &time, |_| 0.0)]);
    for fixed in [None, Some((Solver::Stiff, 1))] {
        let options = Options { fixed, ..Options::default() };
        let s = Simulator::new(&Model::parse(model).unwrap(), &r, &options);
        let run = s.and_then(|s| s.run(&s.parameters(), &s.initials()));
        let stays = |y: &[f64]| y.iter().all(|y| y.abs() < 1.0);
        assert!(!run.is_ok_and(|run| stays(&run.outputs[0])));
    }
    // backwards it is a lag, and stays
    let stable = model.replace("value = 5e4", "value = -5e4");
    let s = Simulator::new(&Model::parse(&stable).unwrap(), &r, &Options::default()).unwrap();
    let run = s.run(&s.parameters(), &s.initials()).unwrap();
    assert!(worst(&time, &run.outputs[0], |t| t.sin() / 5e4) < 1e-9);
}
