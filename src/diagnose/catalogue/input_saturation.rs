//! # What it is
//! Beyond a level no more of what is recorded, or of what the model makes of it, acts on the system: a full-open valve, a
//! current limit, a controller that can heat and cannot cool.
//!
//! # Signature in a recording
//! The residual appears at large inputs alone, and follows their tops.
//!
//! # Equation
//! ```text
//!     u -> clamp(u, -L, L)    or    min(u, L)    or    max(u, L)      u an input or a definition
//! ```
//!
//! # What else looks like this
//! output-saturation, end-stop, input-square (softly).
//!
//! # Reference
//! T. Hu, Z. Lin, Control Systems with Actuator Saturation (2001).
//!
//! # Example
//! A rudder machine commanded to forty degrees that stops at thirty-five.

use super::{Draft, Group, Mechanism, Proposal, Scene, Signal};

/// An input that saturates.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "input-saturation",
    "an input that saturates",
    Group::Input,
    include_str!("input_saturation.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    let felt = scene.commands().filter(|u| !u.is_heading() && u.levels > 2);
    let sides = |u| [0, 1, -1].into_iter().filter_map(move |side| at(scene, u, side));
    felt.flat_map(sides).collect()
}

fn at(scene: &Scene, u: &Signal, side: i8) -> Option<Proposal> {
    let mut d = Draft::new(scene, "input-saturation", u.site(), &u.name);
    let (top, name) = (u.max.abs().max(u.min.abs()), &u.name);
    let limits = if side == 0 { (0.02 * top, top) } else { (u.min, u.max) };
    let level = d.parameter("L", &u.unit, limits, "level beyond which nothing more acts");
    let text = match side {
        0 => format!("clamp({name}, -{level}, {level})"),
        1 => format!("min({name}, {level})"),
        _ => format!("max({name}, {level})"),
    };
    d.replace(name, &text, |_| true);
    for fraction in [0.35, 0.6, 0.85] {
        d.start(&[match side {
            0 => fraction * top,
            1 => u.mean + fraction * (u.max - u.mean),
            _ => u.mean + fraction * (u.min - u.mean),
        }]);
    }
    d.done(&format!("beyond {{0}} no more of {} acts on the system", scene.words(name)))
}
