//! The diagnosis on recordings made by a stepper that shares nothing with the simulator.

use gyrospec::diagnose::answer::Verdict;
use gyrospec::diagnose::laboratory::{Scenario, Stepper};
use gyrospec::diagnose::{Diagnosis, Request, diagnose};
use gyrospec::estimate::fit::Silent;
use gyrospec::expression::Expr;
use gyrospec::model::{Initial, Model};
use gyrospec::record::Recording;

/// Noise of lag-one correlation 0.9 and unit deviation, from a small congruential generator.
fn noise(n: usize, mut seed: u64) -> Vec<f64> {
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

/// The axis with another force in its sum, simulated and covered with noise of 1 % of the motion.
fn recording(force: Option<&str>) -> (Model, Recording) {
    let scenario = Scenario::axis(5).unwrap();
    let mut truth = scenario.model.clone();
    if let Some(force) = force {
        truth.states[1].rate = Expr::parse(&format!("(force - Fv*v - k*q - {force})/M")).unwrap();
    }
    let mut recording = scenario.recording.clone();
    let time = recording.channels[0].time.to_vec();
    let y = Stepper::new(&truth, &scenario.recording).unwrap().outputs(&time).remove(0);
    let size = (y.iter().map(|v| v * v).sum::<f64>() / y.len() as f64).sqrt();
    let position = recording.channels.iter_mut().find(|c| c.name == "position").unwrap();
    for ((v, y), e) in position.values.iter_mut().zip(&y).zip(noise(y.len(), 77)) {
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

fn diagnosed(model: &Model, recording: Recording) -> Diagnosis {
    let recordings = [recording];
    let request = Request { model, recordings: &recordings, separate: &[], seed: 1, progress: &Silent };
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
}
