//! # What it is
//! Above a certain level a tank or a buffer runs over; what runs over is lost or enters the next
//! one.
//!
//! # Signature in a recording
//! The level is cut at one height; the next tank may jump there.
//!
//! # Equation
//! ```text
//!     s' = … - ko max(s - so, 0),  n' = … + share ko max(s - so, 0)
//! ```
//!
//! # What else looks like this
//! linear-damping where the edge lies so low that the level is nearly always above it; output-saturation (the sensor
//! clips, the next tank does not notice), input-saturation, end-stop.
//!
//! # Reference
//! M. Schoukens, J. P. Noel, Three benchmarks addressing open challenges in nonlinear system
//! identification, IFAC-PapersOnLine 50 (2017) 446.
//!
//! # Example
//! The upper of two tanks runs over into the lower one.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE};
use crate::units::Unit;

/// An overflow above a level.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "overflow",
    "an overflow above a level",
    Group::Flow,
    include_str!("overflow.rs"),
    propose,
);

/// Share of a level's range above its lowest below which no edge is looked for: there it is a loss in proportion.
const INSIDE: f64 = 0.15;

/// Shares of a level's range at which an edge is looked for.
const EDGES: [f64; 6] = [0.3, 0.45, 0.6, 0.75, 0.87, 0.97];

fn propose(scene: &Scene) -> Vec<Proposal> {
    let motions = scene.motions();
    let levels: Vec<&Motion> = motions.iter().filter(|m| m.speed.is_none()).collect();
    let mut all = Vec::new();
    for m in &levels {
        all.extend(at(scene, m, None));
        let others = levels.iter().filter(|n| n.state != m.state && n.force == m.force);
        all.extend(others.filter_map(|n| at(scene, m, Some(n))));
    }
    all
}

fn at(scene: &Scene, m: &Motion, into: Option<&Motion>) -> Option<Proposal> {
    let s = &m.state;
    let signal = scene.signal(s)?;
    // what swings about zero has no level
    if signal.mean.abs() < 0.5 * signal.spread {
        return None;
    }
    let mut d = Draft::at(scene, "overflow", m);
    d.uses(s);
    let k =
        d.amplitude("ko", &m.force.over(&signal.unit), POSITIVE, "flow over the edge for a unit of level");
    let lowest = signal.min + INSIDE * (signal.max - signal.min);
    let edge = d.parameter("so", &signal.unit, (lowest, signal.max), "level of the edge");
    let flow = format!("max({s} - {edge}, 0*{edge})");
    d.force(s, &format!("-{k}*{flow}"));
    let mut says = format!("{} runs over above {{1}}", scene.words(s));
    if let Some(next) = into {
        let share =
            d.parameter("share", &Unit::one(), (0.0, 1.0), "part of the overflow that enters the next");
        d.force(&next.state, &format!("{share}*{k}*{flow}"));
        says += &format!("; {{2}} of it enters {}", scene.words(&next.state));
    }
    for fraction in EDGES {
        let level = signal.min + fraction * (signal.max - signal.min);
        let mut start = vec![5.0 * m.size / (signal.max - signal.mean), level];
        start.extend(into.map(|_| 0.5));
        d.start(&start);
    }
    d.done(&says)
}
