//! What is so in one recording of several alone: a leak, another outlet, a sensor set anew; and an outlet that always leaks.

use crate::fields::Plant;
use gyrospec::diagnose::answer::Verdict;
use gyrospec::diagnose::{Diagnosis, Request, diagnose};
use gyrospec::estimate::fit::Silent;
use gyrospec::model::Model;

/// A tank of 0.6 m² on two days, of which the second has other flows.
const DAYS: [Plant<'_>; 2] = [
    Plant {
        step: 2.0,
        start: &[0.5],
        inputs: &[("q", "m^3/s")],
        states: &[("h", "m")],
        sizes: &[(0.005, 0.002)],
        noise: 0.02,
        measured: 1,
    },
    Plant {
        step: 2.0,
        start: &[0.4],
        inputs: &[("q", "m^3/s")],
        states: &[("h", "m")],
        sizes: &[(0.006, -0.0025)],
        noise: 0.02,
        measured: 1,
    },
];
const TANK: &str = r#"
    name = "tank"
    [inputs]
    q = { unit = "m^3/s" }
    [parameters]
    A = { value = 0.7, unit = "m^2", fit = true, min = 0.01 }
    k = { value = 0.009, unit = "m^2/s", fit = true, min = 0 }
    [states]
    h = { rate = "(q - k*h)/A", unit = "m", initial = "fit" }
    [outputs]
    h_meas = { equals = "h", unit = "m" }
"#;

/// The diagnosis of both days, each with its outlet and its leak, m³/s.
fn days(outlets: [f64; 2], leaks: [f64; 2]) -> Diagnosis {
    let day = |n: usize| {
        let mut made = DAYS[n].recorded(|x, u| vec![(u[0] - outlets[n] * x[0] - leaks[n]) / 0.6]);
        made.name = ["monday", "tuesday"][n].into();
        made
    };
    let (model, recordings) = (Model::parse(TANK).unwrap(), [day(0), day(1)]);
    let request = Request {
        model: &model,
        source: None,
        recordings: &recordings,
        separate: &[],
        time_limit: None,
        seed: 1,
        progress: &Silent,
    };
    diagnose(&request).unwrap()
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_leak_on_one_day_is_told_as_one_of_that_day() {
    let a = days([0.01, 0.01], [0.0, 0.001]).answer;
    assert_eq!(a.findings.len(), 1, "{}", a.says);
    let f = &a.findings[0];
    assert_eq!(f.code, "constant-force", "{}", a.says);
    assert!(f.ties.iter().all(|t| t == "input-offset" || t == "output-offset"), "{:?}", f.ties);
    assert!(a.says.contains("in the recording 'tuesday' alone"), "{}", a.says);
    let v = &f.parameters[0];
    assert!(v.low < -0.001 && -0.001 < v.high && v.unit == "m^3/s", "{v:?}");
    // what is so on both days is no matter of one
    let a = days([0.01, 0.01], [0.001, 0.001]).answer;
    assert!(!a.says.contains("alone"), "{}", a.says);
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn an_outlet_that_is_another_on_one_day_is_a_parameter_that_changed() {
    let both = days([0.01, 0.013], [0.0, 0.0]);
    let a = &both.answer;
    assert_eq!((a.verdict, a.findings.len()), (Verdict::Named, 1), "{}", a.says);
    let f = &a.findings[0];
    assert_eq!((f.code.as_str(), f.site.name.as_str()), ("parameter-change", "k"), "{}", a.says);
    assert!(a.says.contains("in the recording 'tuesday' alone k is another"), "{}", a.says);
    let v = &f.parameters[0];
    assert!(v.low < 0.3 && 0.3 < v.high, "{v:?}");
    // the written model has the law, and the mark that constants of the recording set
    let model = &both.after.model;
    assert!(model.states[0].rate.mentions("in_tuesday"), "{}", model.states[0].rate);
    assert!(model.parameters.iter().any(|p| p.name == "in_tuesday" && p.value == 0.0 && !p.fit));
    assert_eq!(days([0.01, 0.01], [0.0, 0.0]).answer.verdict, Verdict::NothingMissing);
}
