//! A driven axis on a spring, beside it a temperature.

use super::Plant;
use rand::RngExt;

pub(super) const PLANT: Plant = Plant {
    name: "axis",
    model: r#"
name = "axis of the laboratory"
[inputs]
force = { unit = "N" }
[parameters]
M = { value = 4.0, unit = "kg", fit = true, min = 0.1, max = 100 }
Fv = { value = 6.0, unit = "N*s/m", fit = true, min = 0, max = 1000 }
k = { value = 150.0, unit = "N/m", fit = true, min = 0, max = 1e5 }
[states]
q = { rate = "v", unit = "m", initial = 0.0 }
v = { rate = "(force - Fv*v - k*q)/M", unit = "m/s", initial = 0.0 }
[outputs]
position = { equals = "q", unit = "m" }
"#,
    known: &[],
    rows: 5000,
    step: 0.01,
    drive: |d| {
        let force = d.sines(0.0, 7, 1.0..14.0, 1.0..5.0);
        let slow: f64 = d.rng.random_range(0.1..0.3);
        let warm = d.time.iter().map(|t| 22.0 + 3.0 * (slow * t).sin()).collect();
        vec![("force", "N", force), ("temp", "K", warm)]
    },
};
