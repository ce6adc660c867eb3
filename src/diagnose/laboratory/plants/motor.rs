//! A direct-current motor under load, beside it the temperature of its winding.

use super::Plant;

pub(super) const PLANT: Plant = Plant {
    name: "motor",
    model: r#"
name = "direct-current motor"
[inputs]
voltage = { unit = "V" }
load = { unit = "N*m" }
[parameters]
R = { value = 1.2, unit = "ohm", fit = true, min = 0.01, max = 100 }
L = { value = 0.03, unit = "H", fit = true, min = 1e-4, max = 10 }
Km = { value = 0.06, unit = "N*m/A", fit = true, min = 1e-4, max = 10 }
J = { value = 0.002, unit = "kg*m^2", fit = true, min = 1e-5, max = 1 }
b = { value = 0.001, unit = "N*m*s/rad", fit = true, min = 0, max = 1 }
[states]
i = { rate = "(voltage - R*i - Km*w)/L", unit = "A", initial = 0.0 }
w = { rate = "(Km*i - b*w - load)/J", unit = "rad/s", initial = 0.0 }
[outputs]
current = { equals = "i", unit = "A" }
speed = { equals = "w", unit = "rpm" }
"#,
    known: &[],
    rows: 4000,
    step: 0.005,
    drive: |d| {
        vec![
            ("voltage", "V", d.waves(2.0, 6.0, 0.15..4.0)),
            ("load", "N*m", d.steps(0.04, 0.03, 0.6)),
            ("winding", "degC", d.waves(60.0, 12.0, 5.0..20.0)),
        ]
    },
};
