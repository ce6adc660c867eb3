//! Obstacles in the words of the options.

use crate::Error;
use crate::gyro::{BUDGET, Effort, FEWEST};
use crate::rolling::Obstacle;
use crate::units::{figure, significant};

/// Why there are no figures, and which option helps.
pub fn worded(obstacle: &Obstacle) -> Error {
    obstacle.error().with_hint(match obstacle {
        Obstacle::WhiteTail(_) => {
            "say --band with the frequency above which this ship does not move, such as --band 2.5rad/s".into()
        }
        Obstacle::BeyondSimulation => {
            "limit the motion: say --band with the frequency above which this ship does not move".into()
        }
        Obstacle::TooLong { effort, band: Some((band, narrower)), .. } => format!(
            "--band sets the length of a step, {} s here; with --band {band}rad/s it takes {} steps or more, some seconds",
            significant(effort.step, 3),
            figure(2.0 * FEWEST as f64 * narrower.steps())
        ),
        Obstacle::TooLong { effort, band: None, .. } => lengthy(effort),
    })
}

/// What to change where no band helps.
fn lengthy(effort: &Effort) -> String {
    let over = FEWEST as f64 * effort.steps() / BUDGET;
    if effort.memory > (10.0 * effort.lag).max(10.0) {
        return format!(
            "the roll's memory of {} s, 1/mu, makes it long: with {} times the decay it takes some seconds; \
             a roll as regular as this is --regular",
            significant(effort.memory, 3),
            figure(over.ceil())
        );
    }
    if effort.parts > 1 {
        return format!(
            "the part rings, so that each step is solved in {} parts: a longer T damps it; without friction or play it is --inertia",
            effort.parts
        );
    }
    format!(
        "the lag T of {} s makes it long: with a {}th of it it takes some seconds",
        figure(effort.lag),
        figure(over.ceil())
    )
}
