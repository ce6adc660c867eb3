//! The roll of a ship in a seaway, beside it rudder and pitch.

use super::Plant;

pub(super) const PLANT: Plant = Plant {
    name: "ship",
    model: r#"
name = "roll of a ship"
[inputs]
slope = { unit = "deg" }
[parameters]
wn = { value = 0.57, unit = "rad/s", fit = true, min = 0.05, max = 5 }
z = { value = 0.06, unit = "1", fit = true, min = 0, max = 2 }
kw = { value = 0.8, unit = "1", fit = true, min = 0, max = 10 }
[states]
phi = { rate = "p", unit = "rad", initial = 0.05 }
p = { rate = "wn^2*(kw*slope - phi) - 2*z*wn*p", unit = "rad/s", initial = 0.0 }
[outputs]
roll = { equals = "phi", unit = "deg" }
"#,
    known: &[],
    rows: 4000,
    step: 0.25,
    drive: |d| {
        vec![
            ("slope", "deg", d.waves(0.0, 3.0, 7.0..15.0)),
            ("rudder", "deg", d.steps(0.0, 6.0, 8.0)),
            ("pitch", "deg", d.waves(0.3, 1.5, 5.0..9.0)),
        ]
    },
};
