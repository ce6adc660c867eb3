use super::{channel, recording, simulator, times};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Kind, Recording};
use gyrospec::simulate::{Options, Simulator};
use gyrospec::units::Unit;
use gyrospec::{Error, ErrorKind};
use proptest::prelude::*;

fn one_state(rate: &str, initial: &str) -> String {
    format!(
        r#"
        name = "one"
        [inputs]
        u = {{ unit = "V" }}
        [parameters]
        T = {{ value = 2, unit = "s" }}
        w = {{ value = 1, unit = "V" }}
        [states]
        y = {{ rate = "{rate}", unit = "V", initial = {initial} }}
        [outputs]
        out = {{ equals = "y", unit = "V" }}
        "#
    )
}

fn measured() -> Recording {
    let time = times(10.0, 0.1);
    recording(vec![channel("u", "V", &time, f64::sin), channel("out", "V", &time, |_| 0.0)])
}

fn refused(model: &str, recording: &Recording) -> Error {
    Simulator::new(&Model::parse(model).unwrap(), recording, &Options::default()).unwrap_err()
}

#[test]
fn a_division_by_zero_at_the_first_step_names_the_term() {
    let e = refused(&one_state("(u - y)/T + u*u/(T*y)", "0"), &measured());
    assert_eq!(e.kind(), ErrorKind::NotComputed);
    assert!(e.to_string().contains("u*u/(T*y)\n              ^^^^^^^^^"), "{e}");
    assert!(e.hint().unwrap().contains("T*y"), "{e}");
    let e = refused(&one_state("(u - y)/T + lag(u, 0*T)/T", "0"), &measured());
    assert!(e.to_string().contains("lag"), "{e}");
}

#[test]
fn a_model_that_blows_up_is_told_and_the_rest_is_a_gap() {
    let s = simulator(&one_state("y*y/(T*w)", "1"), &measured());
    let run = s.run(&s.parameters(), &[1.0]).unwrap();
    let (t, state) = run.blew_up.unwrap();
    assert!(state == 0 && t > 1.9 && t < 2.5, "{t}");
    assert!(run.outputs[0][0] == 1.0 && run.outputs[0][100].is_nan());
}

#[test]
fn no_steady_state_is_an_error() {
    let e = refused(&one_state("(y*y + w*w)/(T*w)", "\"steady\""), &measured());
    assert!(e.hint().is_some(), "{e}");
}

#[test]
fn channels_must_be_there_and_fit() {
    let model = one_state("(u - y)/T", "0");
    let time = times(1.0, 0.1);
    let near = recording(vec![channel("uu", "V", &time, f64::sin), channel("out", "V", &time, |_| 0.0)]);
    assert!(refused(&model, &near).to_string().contains("uu"));
    let wrong = recording(vec![channel("u", "m", &time, f64::sin), channel("out", "V", &time, |_| 0.0)]);
    assert_eq!(refused(&model, &wrong).kind(), ErrorKind::Units);
    let apart: Vec<f64> = time.iter().map(|t| t + 50.0).collect();
    let apart = recording(vec![channel("u", "V", &time, f64::sin), channel("out", "V", &apart, |_| 0.0)]);
    assert!(refused(&model, &apart).to_string().contains("share no time"));
    let trials = measured().with_kind(Kind::Trials);
    assert!(refused(&model, &trials).to_string().contains("trials"));
}

#[test]
fn predictions_stop_where_inputs_stop_and_in_their_gaps() {
    let model = r#"
        name = "same"
        [inputs]
        u = { unit = "V" }
        [outputs]
        out = { equals = "u", unit = "V" }
    "#;
    let time = times(10.0, 0.1);
    let mut u: Channel = channel("u", "V", &time[10..80], |t| t);
    u.values[30..45].fill(f64::NAN);
    let s = simulator(model, &recording(vec![u, channel("out", "V", &time, |_| 0.0)]));
    let got = s.run(&[], &[]).unwrap().outputs.remove(0);
    for (t, y) in time.iter().zip(got) {
        let known = (1.0..=3.9001).contains(t) || (5.4999..=7.9001).contains(t);
        assert_eq!(y.is_finite(), known, "{t}");
        assert!(!known || (y - t).abs() < 1e-12);
    }
}

#[test]
fn a_root_below_a_floor_is_crossed() {
    // Torricelli: h' = -k sqrt(h), empty at t = 2 sqrt(h0)/k = 2, then it stays empty.
    let model = r#"
        name = "tank"
        [parameters]
        k = { value = 1, unit = "m^0.5/s" }
        [states]
        h = { rate = "-k*sqrt(max(h, 0))", unit = "m", initial = 1 }
        [outputs]
        level = { equals = "h", unit = "m" }
    "#;
    let time = times(4.0, 0.03);
    let s = simulator(model, &recording(vec![channel("level", "m", &time, |_| 0.0)]));
    let got = super::outputs(&s);
    let off = super::worst(&time, &got, |t| (1.0 - t / 2.0).max(0.0).powi(2));
    assert!(off < 1e-4, "{off}");
}

#[test]
fn a_simulator_is_shared_between_threads() {
    fn shared<T: Send + Sync>(_: &T) {}
    shared(&simulator(&one_state("(u - y)/T", "0"), &measured()));
}

const PIECES: [&str; 25] = [
    "u",
    "y",
    "T",
    "t",
    "+",
    "-",
    "*",
    "/",
    "^",
    "(",
    ")",
    "sqrt(",
    "sign(",
    "abs(",
    "delay(u, 2*t)",
    "lag(y, 0.1*t)",
    "delay(y, 0*t)",
    "backlash(u, y)",
    "relay(u, u)",
    ", ",
    "max(u, y)",
    "2",
    "0",
    "1e9",
    "ln(",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn no_rate_makes_it_panic(pieces in prop::collection::vec(prop::sample::select(PIECES.to_vec()), 1..9)) {
        // Every unit is 1, so that most dimensions agree; 1/t makes it a rate.
        let model = one_state(&format!("1/t*({})", pieces.concat()), "1");
        let model = model.replace("\"V\"", "\"1\"").replace("\"s\"", "\"1\"");
        if let Ok(model) = Model::parse(&model) {
            let time: Vec<f64> = times(1.0, 0.25).iter().map(|t| t + 1.0).collect();
            let one = Unit::one().to_string();
            let r = recording(vec![channel("u", &one, &time, f64::sin), channel("out", &one, &time, |_| 0.0)]);
            if let Ok(s) = Simulator::new(&model, &r, &Options::default()) {
                let _ = s.run(&s.parameters(), &s.initials());
            }
        }
    }

    #[test]
    fn no_damaged_model_makes_it_panic(at in 0usize..400, with in "\\PC{0,3}", cut in 0usize..6) {
        let text = one_state("(u - y)/T + max(u, y)/T", "\"steady\"");
        let chars: Vec<char> = text.chars().collect();
        let at = at.min(chars.len());
        let rest = &chars[(at + cut).min(chars.len())..];
        let damaged: String = chars[..at].iter().copied().chain(with.chars()).chain(rest.iter().copied()).collect();
        if let Ok(model) = Model::parse(&damaged)
            && let Ok(s) = Simulator::new(&model, &measured(), &Options::default())
        {
            let _ = s.run(&s.parameters(), &s.initials());
        }
    }
}

#[test]
fn zeros_of_inputs_stay_zeros_under_a_root() {
    let time = times(10.0, 0.1);
    let level = |t: f64| if (3.0..6.0).contains(&t) { 0.0 } else { t.sin().abs() };
    let r = recording(vec![channel("u", "V", &time, level), channel("out", "V", &time, |_| 0.0)]);
    let s = simulator(&one_state("(w*sqrt(u/w) - y)/T", "0"), &r);
    let run = s.run(&s.parameters(), &[0.0]).unwrap();
    assert!(run.blew_up.is_none() && run.outputs[0].iter().all(|y| y.is_finite()));
}

#[test]
fn one_moment_is_no_recording_for_a_model_with_states() {
    let r = recording(vec![channel("u", "V", &[1.0], |_| 0.0), channel("out", "V", &[1.0], |_| 0.0)]);
    let e = refused(&one_state("(u - y)/T", "0"), &r);
    assert!(e.to_string().contains("one moment") && e.hint().is_some(), "{e}");
}

#[test]
fn growth_that_no_step_follows_is_not_damped_away() {
    let s = simulator(&one_state("1000*y/T", "1"), &measured());
    let run = s.run(&s.parameters(), &[1.0]).unwrap();
    let (t, _) = run.blew_up.unwrap();
    assert!(t <= 1.0, "{t}");
}

#[test]
fn an_output_without_a_number_is_told_with_its_samples() {
    // the root of a sine: no number in half of 0 to 10 s, from π on
    let model = one_state("(u - y)/T", "0").replace("equals = \"y\"", "equals = \"w*sqrt(u/w)\"");
    let ran = gyrospec::simulate(&Model::parse(&model).unwrap(), &measured()).run().unwrap();
    let told = ran.warnings().into_iter().find(|w| w.contains("no finite value")).unwrap();
    let lost = times(10.0, 0.1).iter().filter(|t| t.sin() < 0.0).count();
    assert!(
        told.contains(&format!("out has no finite value at {lost} of 101 samples, first at t = 3.2")),
        "{told}"
    );
}
