//! A pendulum that a torque drives, taken as linear; beside it the temperature of the room.

use super::Plant;

pub(super) const PLANT: Plant = Plant {
    name: "pendulum",
    model: r#"
name = "driven pendulum"
[inputs]
torque = { unit = "N*m" }
[parameters]
J = { value = 0.12, unit = "kg*m^2", fit = true, min = 0.001, max = 10 }
c = { value = 0.12, unit = "N*m*s/rad", fit = true, min = 0, max = 10 }
k = { value = 2.4, unit = "N*m/rad", fit = true, min = 0, max = 100 }
[states]
phi = { rate = "w", unit = "rad", initial = 0.1 }
w = { rate = "(torque - c*w - k*phi)/J", unit = "rad/s", initial = 0.0 }
[outputs]
angle = { equals = "phi", unit = "deg" }
"#,
    known: &[],
    rows: 3000,
    step: 0.02,
    drive: |d| vec![("torque", "N*m", d.waves(0.0, 0.6, 0.6..6.0)), ("room", "degC", d.waves(21.0, 1.5, 20.0..90.0))],
};
