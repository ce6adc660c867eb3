//! A gyrosphere on a ship that rolls in swell and changes its course, beside it the acceleration of the pitch.

use super::Plant;

pub(super) const PLANT: Plant = Plant {
    name: "gyrosphere",
    model: include_str!("../../../model/builtin/gyrosphere.toml"),
    known: &["x"],
    rows: 3600,
    step: 0.5,
    drive: |d| {
        vec![
            ("roll_acc", "rad/s^2", d.waves(0.0, 0.05, 8.0..14.0)),
            ("heading", "deg", d.steps(180.0, 100.0, 80.0)),
            ("pitch_acc", "rad/s^2", d.waves(0.0, 0.02, 5.0..8.0)),
        ]
    },
};
