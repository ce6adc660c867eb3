//! A cell that is charged and discharged, beside it its temperature.

use super::Plant;

pub(super) const PLANT: Plant = Plant {
    name: "battery",
    model: r#"
name = "battery cell"
[inputs]
current = { unit = "A" }
[parameters]
Q = { value = 2.5, unit = "A*h" }
E0 = { value = 3.3, unit = "V", fit = true, min = 1, max = 5 }
kE = { value = 0.8, unit = "V", fit = true, min = 0, max = 5 }
R0 = { value = 0.03, unit = "ohm", fit = true, min = 0, max = 10 }
R1 = { value = 0.05, unit = "ohm", fit = true, min = 1e-4, max = 10 }
C1 = { value = 1500, unit = "F", fit = true, min = 1, max = 1e6 }
[states]
soc = { rate = "-current/Q", unit = "1", initial = 0.6 }
v1 = { rate = "current/C1 - v1/(R1*C1)", unit = "V", initial = 0.0 }
[outputs]
voltage = { equals = "E0 + kE*soc - R0*current - v1", unit = "V" }
"#,
    known: &["soc"],
    rows: 3000,
    step: 2.0,
    drive: |d| {
        let mut current = d.waves(0.0, 1.2, 20.0..1200.0);
        let held = d.steps(0.0, 0.8, 40.0);
        current.iter_mut().zip(&held).for_each(|(c, h)| *c += h);
        vec![("current", "A", current), ("cell", "degC", d.waves(27.0, 4.0, 900.0..5000.0))]
    },
};
