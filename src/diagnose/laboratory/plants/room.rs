//! A heated room with its walls under the sun, beside it the wind.

use super::Plant;

pub(super) const PLANT: Plant = Plant {
    name: "room",
    model: r#"
name = "heated room"
[inputs]
heating = { unit = "W" }
outdoor = { unit = "degC" }
sun = { unit = "W/m^2" }
[parameters]
C = { value = 400, unit = "kJ/K", fit = true, min = 1, max = 1e5 }
Cw = { value = 4000, unit = "kJ/K", fit = true, min = 10, max = 1e6 }
G = { value = 45, unit = "W/K", fit = true, min = 0, max = 1e4 }
Gw = { value = 90, unit = "W/K", fit = true, min = 0, max = 1e4 }
s = { value = 1.5, unit = "m^2", fit = true, min = 0, max = 100 }
[states]
T = { rate = "(heating - G*(T - outdoor) - Gw*(T - Tw) + s*sun)/C", unit = "degC", initial = 20.0 }
Tw = { rate = "Gw*(T - Tw)/Cw", unit = "degC", initial = 19.0 }
[outputs]
air = { equals = "T", unit = "degC" }
"#,
    known: &[],
    rows: 3000,
    step: 120.0,
    drive: |d| {
        vec![
            ("heating", "W", d.steps(700.0, 400.0, 3600.0)),
            ("outdoor", "degC", d.waves(5.0, 3.5, 1e4..1.5e5)),
            ("sun", "W/m^2", d.waves(130.0, 60.0, 7e3..9e4)),
            ("wind", "m/s", d.waves(4.0, 1.4, 5e3..4e4)),
        ]
    },
};
