//! # What it is
//! Physics that no page here describes: a force on a state, a change of a parameter or an error of a sensor that
//! goes with one signal, as a curve through knots whose heights are fitted.
//!
//! # Signature in a recording
//! Something is surely missing, no name stands, and what is left follows a signal.
//!
//! # Equation
//! ```text
//!     M v' = … + curve(z, -2, f1, …, 2, fn)      z = (s - mean s)/spread s
//!     p -> p (1 + curve(z, …))
//!     y  = … + curve(z, …)
//! ```
//! The curve is a monotone cubic between its knots and goes on straight beyond them; the data end at some two
//! spreads, and what stands beyond is no more than that.
//!
//! # What else looks like this
//! Everything: it is offered only where no name stands, and only where it lowers the error of blocks that its fit has
//! not seen, and of what was held out. Whatever of it the model has already (a slope, a constant) trades with the model's own
//! parameters, so that the curve counts, not each of its heights.
//!
//! # Reference
//! F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300 for the curve; P. C. Young, P. McKenna, J. Bruun,
//! Int. J. Control 74 (2001) 1837 for laws that are read from data.
//!
//! # Example
//! An axis that passes over a magnet.

use super::{
    Draft, Group, Mechanism, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY, no_proposals,
};
use crate::units::Unit;

/// A law without a name.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    CODE,
    "a law without a name, as a curve of one signal",
    Group::Unnamed,
    include_str!("free_law.rs"),
    no_proposals,
);

/// Its code.
pub const CODE: &str = "free-law";

/// Spreads about the mean up to which knots are set, where the data reach so far.
const REACH: f64 = 2.2;

/// The laws of one signal, each through so many knots, at every place that admits one.
pub fn laws(scene: &Scene, knots: usize) -> Vec<Proposal> {
    let kinds = [SignalKind::State, SignalKind::Input, SignalKind::Channel, SignalKind::Definition];
    let signals: Vec<&Signal> =
        scene.moving(&kinds).filter(|s| s.levels > knots && !s.is_heading()).collect();
    let mut all = Vec::new();
    for s in signals {
        for m in scene.motions() {
            let at =
                Place { kind: SiteKind::State, name: m.state.clone(), unit: m.force.clone(), size: m.size };
            all.extend(law(scene, &at, s, knots));
        }
        for p in scene.acting_parameters() {
            let at = Place { kind: SiteKind::Parameter, name: p, unit: Unit::one(), size: 0.3 };
            all.extend(law(scene, &at, s, knots));
        }
        for o in &scene.model.outputs {
            let size = 0.3 * scene.signal(&o.name).map_or(1.0, |s| s.spread);
            let at = Place { kind: SiteKind::Output, name: o.name.clone(), unit: o.unit.clone(), size };
            all.extend(law(scene, &at, s, knots));
        }
    }
    all
}

/// Where a law acts, the unit of its heights, and their size.
struct Place {
    kind: SiteKind,
    name: String,
    unit: Unit,
    size: f64,
}

fn law(scene: &Scene, at: &Place, signal: &Signal, knots: usize) -> Option<Proposal> {
    let s = &signal.name;
    let mut d = Draft::new(scene, CODE, at.kind, &at.name);
    d.uses(s);
    let mean = d.constant(&format!("{s}_mean"), &signal.unit, signal.mean, "mean of the recording");
    let spread = d.constant(&format!("{s}_spread"), &signal.unit, signal.spread, "spread of the recording");
    let low = ((signal.min - signal.mean) / signal.spread).max(-REACH);
    let high = ((signal.max - signal.mean) / signal.spread).min(REACH);
    let mut text = format!("curve(({s} - {mean})/{spread}");
    for k in 0..knots {
        let place = low + (high - low) * k as f64 / (knots - 1) as f64;
        // hundredths of a spread are as good, and read better
        let place = (place * 100.0).round() / 100.0;
        let height = d.amplitude(&format!("f{}", k + 1), &at.unit, ANY, "height of the law at a knot");
        text += &format!(", {place}, {height}");
    }
    text.push(')');
    let words = match at.kind {
        SiteKind::State => {
            d.force(&at.name, &text);
            format!("what moves {} has a part that goes with {}", scene.words(&at.name), scene.words(s))
        }
        SiteKind::Parameter => {
            d.replace(&at.name, &format!("({}*(1 + {text}))", at.name), |_| true);
            format!("{} varies with {}", scene.words(&at.name), scene.words(s))
        }
        _ => {
            d.output(&at.name, &format!("{{}} + {text}"));
            format!("{} is off by something that goes with {}", scene.words(&at.name), scene.words(s))
        }
    };
    d.start(&vec![at.size; knots]);
    d.done(&words)
}
