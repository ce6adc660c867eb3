//! A stirred reactor with a jacket and a reaction of the first order, beside it the stirrer's speed.

use super::Plant;

pub(super) const PLANT: Plant = Plant {
    name: "reactor",
    model: r#"
name = "stirred reactor"
[inputs]
flow = { unit = "l/min" }
feed = { unit = "mmol/l" }
jacket = { unit = "degC" }
[parameters]
V = { value = 10, unit = "l" }
Tf = { value = 20, unit = "degC" }
k = { value = 0.08, unit = "1/min", fit = true, min = 0, max = 10 }
U = { value = 0.15, unit = "1/min", fit = true, min = 0, max = 10 }
b = { value = 0.3, unit = "K*l/mmol", fit = true, min = 0, max = 100 }
[states]
c = { rate = "flow/V*(feed - c) - k*c", unit = "mmol/l", initial = 100.0 }
T = { rate = "flow/V*(Tf - T) + b*k*c - U*(T - jacket)", unit = "degC", initial = 35.0 }
[outputs]
concentration = { equals = "c", unit = "mmol/l" }
temperature = { equals = "T", unit = "degC" }
"#,
    known: &[],
    rows: 3000,
    step: 15.0,
    drive: |d| {
        vec![
            ("flow", "l/min", d.waves(1.0, 0.2, 500.0..7000.0)),
            ("feed", "mmol/l", d.steps(200.0, 45.0, 1500.0)),
            ("jacket", "degC", d.waves(30.0, 4.0, 900.0..9000.0)),
            ("stirrer", "rpm", d.waves(300.0, 40.0, 900.0..9000.0)),
        ]
    },
};
