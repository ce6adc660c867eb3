//! Two tanks, the first over the second, that drain in proportion to their levels; beside them the water's temperature.

use super::Plant;

pub(super) const PLANT: Plant = Plant {
    name: "tanks",
    model: r#"
name = "two tanks"
[inputs]
pump = { unit = "l/min" }
side = { unit = "l/min" }
[parameters]
A1 = { value = 150, unit = "cm^2", fit = true, min = 1, max = 1e4 }
A2 = { value = 220, unit = "cm^2", fit = true, min = 1, max = 1e4 }
c1 = { value = 0.5, unit = "l/min/cm", fit = true, min = 0, max = 100 }
c2 = { value = 0.45, unit = "l/min/cm", fit = true, min = 0, max = 100 }
[states]
h1 = { rate = "(pump - c1*h1)/A1", unit = "cm", initial = 11.0 }
h2 = { rate = "(c1*h1 + side - c2*h2)/A2", unit = "cm", initial = 16.0 }
[outputs]
upper = { equals = "h1", unit = "cm" }
lower = { equals = "h2", unit = "cm" }
"#,
    known: &[],
    rows: 3000,
    step: 1.0,
    drive: |d| {
        vec![
            ("pump", "l/min", d.waves(6.0, 1.6, 12.0..240.0)),
            ("side", "l/min", d.steps(2.0, 0.8, 40.0)),
            ("water", "degC", d.waves(18.0, 3.0, 600.0..3000.0)),
        ]
    },
};
