//! # What it is
//! A flow from one store to another that neither balance knows: heat through a wall, a liquid through a pipe, gas
//! through a leak, a substance between two compartments. What leaves one enters the other, or surroundings whose level
//! is recorded and which do not feel it.
//!
//! # Signature in a recording
//! Both residuals follow the difference of the two, with opposite signs; to surroundings, the one that there is.
//!
//! # Equation
//! ```text
//!     A x' = … - c (x - y)      B y' = … + c (x - y)
//!     or with c (x - y)/sqrt(|x - y|/r) in place of c (x - y), where the flow goes with a root;  r is only a scale
//!     or with c (max(x, e) - max(y, e)), where it flows through an opening at the level e
//!     x' = … - c (x - y)        y' = … + cy (x - y)     where the balances do not show their capacities
//!     A x' = … - c (x - u),  straight or with the root,  to surroundings u that are recorded
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
//! Two rooms with a wall between them, modelled each for itself; a cabinet that leaks to a room whose humidity is logged.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, draft::POSITIVE, edit};
use crate::expression::{BinaryOp, Expr};
use crate::units::Dimension;

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
        let is_level = |x: &Motion| scene.unit(&x.state).dimension();
        for n in motions[i + 1..].iter().filter(|n| is_level(n) == is_level(m)) {
            let is_one_flow = n.force.dimension() == m.force.dimension();
            let forms = FORMS.into_iter().filter(|f| match f {
                Form::Shared => !is_one_flow || hides_capacity(scene, m),
                _ => is_one_flow,
            });
            all.extend(forms.filter_map(|form| at(scene, [m, n], form)));
        }
    }
    // an angle is no store
    for m in motions.iter().filter(|m| m.speed.is_none() && !scene.is_angle(&m.state)) {
        let around = scene.moving(&[SignalKind::Channel, SignalKind::Input]);
        let alike = around.filter(|u| u.unit.dimension() == scene.unit(&m.state).dimension());
        // the size of a flow that the model has is a parameter's value, and a root of it a power
        let others = alike.filter(|u| !has_flow(scene, m, u));
        all.extend(others.flat_map(|u| [false, true].map(|root| surroundings(scene, m, u, root))).flatten());
    }
    all
}

/// Whether a balance has a flow with its difference from a signal, or from a share of that.
fn has_flow(scene: &Scene, m: &Motion, u: &Signal) -> bool {
    let x = Expr::name(&m.state);
    let is_apart = |e: &Expr| match e {
        Expr::Binary(BinaryOp::Sub, a, b) => {
            (**a == x && b.mentions(&u.name)) || (**b == x && a.mentions(&u.name))
        }
        _ => false,
    };
    let own = scene.model.states.iter().filter(|s| s.name == m.state).map(|s| &s.rate);
    let mut places = own.chain(scene.model.definitions.iter().map(|d| &d.equals));
    places.any(|e| edit::find(e, &is_apart).is_some())
}

/// A flow to surroundings that are recorded.
fn surroundings(scene: &Scene, m: &Motion, u: &Signal, root: bool) -> Option<Proposal> {
    let (x, y) = (&m.state, &u.name);
    let mut d = Draft::at(scene, "exchange", m);
    let c = d.amplitude("c", &m.force.over(&scene.unit(x)), POSITIVE, "flow for a unit of the difference");
    let apart = apart([scene.signal(x)?, u]);
    let flow = if root { rooted(scene, &mut d, &c, [x, y], apart) } else { format!("{c}*({x} - {y})") };
    d.uses(x);
    d.uses(y);
    d.force(x, &format!("-{flow}"));
    d.start(&[m.size / apart]);
    let how = if root { "with the root of" } else { "in proportion to" };
    d.done(&format!("a flow from {} to {} {how} their difference, {{0}}", scene.words(x), scene.words(y)))
}

/// Root mean square of what two levels differ by, if they move apart.
fn apart([a, b]: [&Signal; 2]) -> f64 {
    (a.mean - b.mean).hypot(a.spread).hypot(b.spread)
}

/// A flow with the root of a difference.
fn rooted(scene: &Scene, d: &mut Draft, c: &str, [x, y]: [&str; 2], apart: f64) -> String {
    let scale =
        d.constant(&format!("{x}_{y}_ref"), &scene.unit(x), apart, "scale of the difference, not fitted");
    format!("{c}*({x} - {y})/sqrt(abs({x} - {y})/{scale} + {ROUND})")
}

/// How a flow goes with the two levels.
#[derive(Clone, Copy)]
enum Form {
    Proportional,
    Root,
    Above,
    /// In proportion, where a balance does not show its capacity.
    Shared,
}

const FORMS: [Form; 4] = [Form::Proportional, Form::Root, Form::Above, Form::Shared];

/// Whether the sum in a balance is a level or its rate, as with a time constant, so that a flow into it is unknown.
fn hides_capacity(scene: &Scene, m: &Motion) -> bool {
    let (level, sum) = (scene.unit(&m.state).dimension(), m.force.dimension());
    sum == level || sum == level.over(Dimension::TIME)
}

/// Share of the levels' range that an opening lies above the lowest, at least.
const INSIDE: f64 = 0.15;
/// Shares of that range at which openings are tried.
const TRIED: [f64; 3] = [0.3, 0.5, 0.75];

fn at(scene: &Scene, [m, n]: [&Motion; 2], form: Form) -> Option<Proposal> {
    let (x, y) = (&m.state, &n.state);
    let unit = scene.unit(x);
    let mut d = Draft::at(scene, "exchange", m);
    let c = d.amplitude("c", &m.force.over(&unit), POSITIVE, "flow for a unit of the difference");
    let (a, b) = (scene.signal(x)?, scene.signal(y)?);
    let apart = apart([a, b]);
    let (low, high) = (a.min.min(b.min), a.max.max(b.max));
    let flow = match form {
        Form::Proportional | Form::Shared => format!("{c}*({x} - {y})"),
        Form::Root => rooted(scene, &mut d, &c, [x, y], apart),
        Form::Above => {
            let limits = (low + INSIDE * (high - low), high);
            let edge = d.parameter("e", &a.unit, limits, "level of the opening");
            format!("{c}*(max({x}, {edge}) - max({y}, {edge}))")
        }
    };
    d.uses(x);
    d.uses(y);
    d.force(x, &format!("-{flow}"));
    let size = m.size.max(n.size) / apart;
    if let Form::Shared = form {
        let unit = n.force.over(&unit);
        let own = d.amplitude("cy", &unit, POSITIVE, "what the flow makes of the difference in the second");
        d.force(y, &format!("{own}*({x} - {y})"));
        d.start(&[m.size / apart, n.size / apart]);
    } else {
        d.force(y, &flow);
    }
    match form {
        Form::Shared => {}
        Form::Above => TRIED.iter().for_each(|share| d.start(&[size, low + share * (high - low)])),
        _ => d.start(&[size]),
    }
    let how = match form {
        Form::Proportional => "in proportion to their difference",
        Form::Shared => "in proportion to their difference, {1} in the second balance",
        Form::Root => "with the root of their difference",
        Form::Above => "through an opening at {1}",
    };
    d.done(&format!("a flow from {} to {} {how}, {{0}}", scene.words(x), scene.words(y)))
}
