//! Channels that a recording has under a name that the model uses for something else.

use crate::laws_met::{inputs, named, run_with_two, second_inputs, told};

/// A vessel in a room that the model holds to be at one temperature, `Ta`, which is also the name of the room's
/// thermometer; and of the vessel a second thermometer, which no output asks for.
#[test]
fn a_thermometer_is_called_like_the_constant_that_it_should_replace() {
    let model = r#"
        name = "vessel"
        [inputs]
        P = { unit = "W" }
        [parameters]
        C = { value = 3, unit = "J/K", fit = true, min = 0.1 }
        h = { value = 2, unit = "W/K", fit = true, min = 0.05 }
        Ta = { value = 20, unit = "degC" }
        [states]
        T = { rate = "(P - h*(T - Ta))/C", unit = "degC", initial = "fit" }
        [outputs]
        vessel = { equals = "T", unit = "degC" }
    "#;
    let states = run_with_two(|[x], [p, r]| [(10.0 * p - 2.4 * (x - 2.0 * r)) / 3.5]);
    let vessel: Vec<f64> = states.iter().map(|x| 20.0 + x[0]).collect();
    let power = inputs().into_iter().map(|p| 10.0 * p).collect();
    let room = second_inputs().into_iter().map(|r| 20.0 + 2.0 * r).collect();
    let again = vessel.clone();
    let answer = told(
        model,
        &[
            ("P", "W", power, 0.0),
            ("Ta", "degC", room, 0.0),
            ("T", "degC", again, 0.1),
            ("vessel", "degC", vessel, 0.05),
        ],
    );
    let found = named(&answer);
    assert!(found.len() == 1 && found[0].0 == "parameter-dependence", "{}", answer.says);
    assert!((found[0].2 - 1.0).abs() < 0.03, "{found:?}");
    assert!(answer.findings[0].term.contains("(Ta_recorded - Ta)"), "{}", answer.findings[0].term);
    let notes = answer.notes.join("\n");
    assert!(notes.contains("called `Ta_recorded` here"), "{notes}");
    assert!(notes.contains("`T` is recorded and is computed by the model"), "{notes}");
}
