//! What follows an input in time by dynamics that the model does not have, and no law of present values shows.

use crate::diagnose::noise;
use crate::laws_met::{inputs, named, run, told};
use gyrospec::diagnose::answer::Verdict;

/// A room whose walls throw a sound back several times, and a model of the loudspeaker alone.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn walls_that_throw_a_sound_back() {
    let model = r#"
        name = "room"
        [inputs]
        drive = { unit = "V" }
        [parameters]
        T = { value = 0.5, unit = "s", fit = true, min = 0.01, max = 10 }
        K = { value = 0.5, unit = "Pa/V", fit = true, min = 0.01, max = 10 }
        [states]
        p = { rate = "(K*drive - p)/T", unit = "Pa", initial = 0 }
        [outputs]
        heard = { equals = "p", unit = "Pa" }
    "#;
    let mut drive = noise(inputs().len(), 5);
    for i in 1..drive.len() {
        drive[i] += 0.9 * drive[i - 1];
    }
    let mut straight = vec![0.0; drive.len()];
    for i in 1..drive.len() {
        // p' = (u - p)/T by the trapezoidal rule, T = 0.3 s
        let (a, h) = (0.3, 0.02);
        straight[i] = ((a - h / 2.0) * straight[i - 1] + h / 2.0 * (drive[i] + drive[i - 1])) / (a + h / 2.0);
    }
    let walls = [(0, 1.0), (55, 0.3), (95, -0.25), (170, 0.2), (265, -0.2)];
    let at = |i: usize, late: usize| i.checked_sub(late).map_or(0.0, |i| straight[i]);
    let heard =
        (0..drive.len()).map(|i| walls.iter().map(|(late, share)| share * at(i, *late)).sum()).collect();
    let answer = told(model, &[("drive", "V", drive, 0.0), ("heard", "Pa", heard, 0.02)]);
    assert_eq!(answer.verdict, Verdict::Unknown, "{}", answer.says);
    assert!(answer.says.contains("what drive was before"), "{}", answer.says);
    assert_eq!(answer.unexplained.map(|u| u.signal).as_deref(), Some("drive"));
}

/// A catalyst that dies by equal shares in equal times: over what is held out that is no straight line.
#[test]
fn what_decays_goes_on_decaying() {
    let model = r#"
        name = "reactor"
        [inputs]
        feed = { unit = "mol/m^3" }
        [parameters]
        k = { value = 1, unit = "1/s", fit = true, min = 0.01, max = 50 }
        d = { value = 0.5, unit = "1/s" }
        [states]
        c = { rate = "d*(feed - c) - k*c", unit = "mol/m^3", initial = 0 }
        [outputs]
        left = { equals = "c", unit = "mol/m^3" }
    "#;
    // time is a state of its own
    let states = run(|[c, t], u| [0.5 * (20.0 + 4.0 * u - c) - 2.0 * f64::exp(-t / 25.0) * c, 1.0]);
    let feed = inputs().iter().map(|u| 20.0 + 4.0 * u).collect();
    let left = states.iter().map(|x| x[0]).collect();
    let answer = told(model, &[("feed", "mol/m^3", feed, 0.0), ("left", "mol/m^3", left, 0.05)]);
    let found = named(&answer);
    assert!(
        matches!(found[..], [("parameter-drift", "k", a)] if (a + 1.0 / 25.0).abs() < 1e-3),
        "{}",
        answer.says
    );
    assert!(answer.proof[0].holdout_after < 0.06, "{}", answer.says);
}
