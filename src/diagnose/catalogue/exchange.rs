//! # What it is
//! A flow from one store to another that neither balance knows: heat through a wall, a liquid through a pipe, gas
//! through a leak, a substance between two compartments. What leaves one enters the other.
//!
//! # Signature in a recording
//! Both residuals follow the difference of the two, with opposite signs.
//!
//! # Equation
//! ```text
//!     A x' = … - c (x - y)      B y' = … + c (x - y)
//!     or with c (x - y)/sqrt(|x - y|/r) in place of c (x - y), where the flow goes with a root;  r is only a scale
//! ```
//!
//! # What else looks like this
//! linear-damping of one of the two while the other hardly moves; cross-coupling (acts on one alone); overflow (one
//! way, from a level on).
//!
//! # Reference
//! B. W. Bequette, Process Control (2003), ch. 2; F. P. Incropera, D. P. DeWitt, Fundamentals of Heat and Mass Transfer,
//! 6th ed. (2006), ch. 3.
//!
//! # Example
//! Two rooms with a wall between them, modelled each for itself.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE};

/// What leaves one balance and enters another.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "exchange",
    "a flow from one balance into another",
    Group::Flow,
    include_str!("exchange.rs"),
    propose,
);

/// Share of the scale below which a flow with a root goes straight through 0.
const ROUND: &str = "0.001";

fn propose(scene: &Scene) -> Vec<Proposal> {
    let motions = scene.motions();
    let mut all = Vec::new();
    for (i, m) in motions.iter().enumerate() {
        let fits = |n: &&Motion| {
            let dimension = |x: &Motion| (x.force.dimension(), scene.unit(&x.state).dimension());
            dimension(n) == dimension(m)
        };
        for n in motions[i + 1..].iter().filter(fits) {
            all.extend([false, true].into_iter().filter_map(|root| at(scene, [m, n], root)));
        }
    }
    all
}

fn at(scene: &Scene, [m, n]: [&Motion; 2], root: bool) -> Option<Proposal> {
    let (x, y) = (&m.state, &n.state);
    let unit = scene.unit(x);
    let mut d = Draft::at(scene, "exchange", m);
    let c = d.amplitude("c", &m.force.over(&unit), POSITIVE, "flow for a unit of the difference");
    let (a, b) = (scene.signal(x)?, scene.signal(y)?);
    let apart = (a.mean - b.mean).hypot(a.spread).hypot(b.spread);
    let flow = if root {
        let scale = d.constant(&format!("{x}_{y}_ref"), &unit, apart, "scale of the difference, not fitted");
        format!("{c}*({x} - {y})/sqrt(abs({x} - {y})/{scale} + {ROUND})")
    } else {
        format!("{c}*({x} - {y})")
    };
    d.uses(x);
    d.uses(y);
    d.force(x, &format!("-{flow}"));
    d.force(y, &flow);
    d.start(&[m.size.max(n.size) / apart]);
    let how =
        if root { ", with the root of their difference" } else { ", in proportion to their difference" };
    d.done(&format!("{} and {} exchange a flow of {{0}}{how}", scene.words(x), scene.words(y)))
}
