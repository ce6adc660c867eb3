//! Where fitted initial states begin in a run.

use super::{channel, recording, times};
use gyrospec::model::Model;
use gyrospec::simulate;

const SWING: &str = r#"
    name = "swing"
    [inputs]
    u = { unit = "m/s^2" }
    [parameters]
    W = { value = 2, unit = "1/s" }
    [states]
    x = { rate = "v", unit = "m", initial = START }
    v = { rate = "u - W^2*x", unit = "m/s", initial = START }
    [outputs]
    place = { equals = "x", unit = "cm" }
    speed = { equals = "v", unit = "m/s" }
    "#;

fn swing(start: &str) -> Model {
    Model::parse(&SWING.replace("START", start)).unwrap()
}

/// x = 0.3 cos 2t + 0.2 sin 2t m begins with a speed of 0.4 m/s that nothing measured.
#[test]
fn a_state_that_no_output_shows_begins_as_the_run_fits_best() {
    let time = times(6.0, 0.05);
    let x = |t: f64| 0.3 * (2.0 * t).cos() + 0.2 * (2.0 * t).sin();
    let mut measured =
        recording(vec![channel("u", "m/s^2", &time, |_| 0.0), channel("place", "cm", &time, x)]);
    let fitted = swing("\"fit\"");
    fitted.foresee(&mut measured);
    let ran = simulate(&fitted, &measured).tolerance(1e-8).run().unwrap();
    let rms = ran.output("place").unwrap().errors().0;
    assert!(rms < 1e-6, "{rms}");
    assert!(ran.text().contains("v begins at 0.4000"), "{}", ran.text());
    // a number stays what it is: 0.2 sin 2t is missed
    let ran = simulate(&swing("0.3"), &measured).run().unwrap();
    assert!(!ran.text().contains("begins at"), "{}", ran.text());
    let rms = ran.output("place").unwrap().errors().0;
    assert!(rms > 0.02, "{rms}");
}
