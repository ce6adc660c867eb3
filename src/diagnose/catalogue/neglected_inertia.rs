//! # What it is
//! A part that the model lets follow at once has a mass: its equation is of one order more.
//!
//! # Signature in a recording
//! At higher frequencies the motion lags and shrinks further than a lag explains; ringing after
//! jumps.
//!
//! # Equation
//! ```text
//!     x' = r,  tau r' = f(x) - r    in place of x' = f(x);  with m x'' + r x' + C0 x: tau = m/r
//! ```
//!
//! # What else looks like this
//! extra-lag, input-delay, output-lag: they part only near and above 1/tau.
//!
//! # Reference
//! W. Potemkin (1978), (2.2) against (2.3): the gyrosphere's suspension with and without inertia.
//!
//! # Example
//! The centre of mass of a gyrosphere on its elastic suspension, taken as a pure lag.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE};
use crate::model::Initial;
use crate::units::Unit;

/// An inertia that the model neglects.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "neglected-inertia",
    "an inertia that the model neglects",
    Group::Dynamics,
    include_str!("neglected_inertia.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let mut all: Vec<Proposal> = scene.motions().iter().filter_map(|m| at(scene, m)).collect();
    all.extend(scene.richer_lag("neglected-inertia").and_then(|(mut d, lag)| {
        let w = &lag.frequency;
        let tau = d.parameter("Tm", &Unit::parse("s").ok()?, POSITIVE, "root of mass over stiffness");
        d.lag_factor(&format!("((1 - ({w}*{tau})^2)^2 + {})/(1 - ({w}*{tau})^2)", lag.square));
        let top = scene.signal(w)?.max;
        for phase in [0.25, 0.5, 0.8] {
            d.start(&[phase / top]);
        }
        d.done("the giving part has an inertia: root of mass over stiffness {0}")
    }));
    all
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    if m.speed.is_some() {
        return None;
    }
    let second = Unit::parse("s").ok()?;
    let mut d = Draft::at(scene, "neglected-inertia", m);
    let tau =
        d.parameter("tau_m", &second, (1e-3 * scene.step, 0.3 * scene.length()), "inertia over damping");
    let rate = scene.model.states.iter().find(|s| s.name == m.state)?.rate.to_string();
    let r = d.state(
        &format!("rate_of_{}", m.state),
        &scene.unit(&m.state).over(&second),
        Initial::Number(0.0),
        "rate",
    );
    d.rate(&r, &format!("(({rate}) - {r})/{tau}"));
    d.rate(&m.state, &r);
    d.term(&format!("{tau}*{}'' + {}' = {rate}", m.state, m.state));
    for time in scene.times() {
        d.start(&[time]);
    }
    d.done(&format!("{} has an inertia: inertia over damping is {{0}}", scene.words(&m.state)))
}
