//! # What it is
//! Physics that no page here describes: a force on a state, a change of a parameter or an error of a sensor that
//! goes with one signal, as a curve through knots whose heights are fitted, or with two, as a surface.
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
//! With two signals surface(z1, z2, [-2, …], [-2, …], [f1, …]), bilinear between its knots, stands in the curve's place.
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
    Draft, Group, Mechanism, Proposal, Scene, Signal, SignalKind, Site, SiteKind, draft::ANY, no_proposals,
};
use crate::units::{Unit, figure};

/// A law without a name.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    CODE,
    "a law without a name, as a curve of one signal or a surface of two",
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
    let places = places(scene);
    let at_all = |s| places.iter().filter_map(move |at| law(scene, at, s, knots));
    signals(scene, knots).into_iter().flat_map(at_all).collect()
}

/// The laws of two signals, each through so many knots along either, at some places; one of the two is a given signal,
/// where there is one.
pub fn surfaces(scene: &Scene, sites: &[Site], of: Option<&str>, knots: usize) -> Vec<Proposal> {
    let signals = signals(scene, knots);
    let mut all = Vec::new();
    for at in places(scene).iter().filter(|p| sites.iter().any(|s| s.kind == p.kind && s.name == p.name)) {
        for (k, first) in signals.iter().enumerate() {
            for second in &signals[k + 1..] {
                if of.is_none_or(|of| first.name == of || second.name == of) {
                    all.extend(surface(scene, at, [first, second], knots));
                }
            }
        }
    }
    all
}

/// The signals that a law may go with.
fn signals<'s>(scene: &'s Scene, knots: usize) -> Vec<&'s Signal> {
    const KINDS: [SignalKind; 4] =
        [SignalKind::State, SignalKind::Input, SignalKind::Channel, SignalKind::Definition];
    scene.moving(&KINDS).filter(|s| s.levels > knots && !s.is_far_round()).collect()
}

/// The places that admit a law.
fn places(scene: &Scene) -> Vec<Place> {
    let states = scene.motions().into_iter().map(|m| Place {
        kind: SiteKind::State,
        name: m.state.clone(),
        unit: m.force.clone(),
        size: m.size,
    });
    let parameters = scene.acting_parameters().into_iter().map(|name| Place {
        kind: SiteKind::Parameter,
        name,
        unit: Unit::one(),
        size: 0.3,
    });
    let outputs = scene.model.outputs.iter().map(|o| Place {
        kind: SiteKind::Output,
        name: o.name.clone(),
        unit: o.unit.clone(),
        size: 0.3 * scene.signal(&o.name).map_or(1.0, |s| s.spread),
    });
    states.chain(parameters).chain(outputs).collect()
}

/// Where a law acts, the unit of its heights, and their size.
struct Place {
    kind: SiteKind,
    name: String,
    unit: Unit,
    size: f64,
}

fn law(scene: &Scene, at: &Place, signal: &Signal, knots: usize) -> Option<Proposal> {
    let mut d = Draft::new(scene, CODE, at.kind, &at.name);
    let scaled = scaled(&mut d, signal);
    let heights = heights(&mut d, at, knots);
    let knots = grid(signal, knots).into_iter().zip(heights).map(|(z, f)| format!(", {z}, {f}"));
    let text = format!("curve({scaled}{})", knots.collect::<String>());
    placed(d, scene, at, (&text, &recorded(scene, signal)))
}

/// surface(z₁, z₂, […], […], [f₁, …]), with a height for each place along the second at the first place along the first.
fn surface(scene: &Scene, at: &Place, [first, second]: [&Signal; 2], knots: usize) -> Option<Proposal> {
    let mut d = Draft::new(scene, CODE, at.kind, &at.name);
    let scaled = [scaled(&mut d, first), scaled(&mut d, second)].join(", ");
    let list = |s| grid(s, knots).iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
    let heights = heights(&mut d, at, knots * knots).join(", ");
    let text = format!("surface({scaled}, [{}], [{}], [{heights}])", list(first), list(second));
    let words = format!("{} and {}", recorded(scene, first), recorded(scene, second));
    placed(d, scene, at, (&text, &words))
}

/// A signal in words, with where its data end.
fn recorded(scene: &Scene, signal: &Signal) -> String {
    let shown = |x: f64| figure(signal.unit.from_si(x));
    let unit = if signal.unit.text() == "1" { "" } else { signal.unit.text() };
    let words = format!(
        "{} (data from {} to {} {unit}",
        scene.words(&signal.name),
        shown(signal.min),
        shown(signal.max)
    );
    format!("{})", words.trim_end())
}

/// A signal by its mean and spread.
fn scaled(d: &mut Draft<'_>, signal: &Signal) -> String {
    let s = &signal.name;
    d.uses(s);
    let mean = d.constant(&format!("{s}_mean"), &signal.unit, signal.mean, "mean of the recording");
    let spread = d.constant(&format!("{s}_spread"), &signal.unit, signal.spread, "spread of the recording");
    format!("({s} - {mean})/{spread}")
}

/// Where knots stand along a signal, in spreads.
fn grid(signal: &Signal, knots: usize) -> Vec<f64> {
    let low = ((signal.min - signal.mean) / signal.spread).max(-REACH);
    let high = ((signal.max - signal.mean) / signal.spread).min(REACH);
    let place = |k: usize| low + (high - low) * k as f64 / (knots - 1) as f64;
    // hundredths of a spread are as good, and read better
    (0..knots).map(|k| (place(k) * 100.0).round() / 100.0).collect()
}

/// Names of the heights at knots.
fn heights(d: &mut Draft<'_>, at: &Place, count: usize) -> Vec<String> {
    let mut height = |k: usize| d.amplitude(&format!("f{k}"), &at.unit, ANY, "height of the law at a knot");
    let all: Vec<String> = (1..=count).map(&mut height).collect();
    d.start(&vec![at.size; count]);
    all
}

/// The proposal of a law at its place.
fn placed(mut d: Draft<'_>, scene: &Scene, at: &Place, (text, goes): (&str, &str)) -> Option<Proposal> {
    let own = scene.words(&at.name);
    let words = match at.kind {
        SiteKind::State => {
            d.force(&at.name, text);
            format!("what moves {own} has a part that goes with {goes}")
        }
        SiteKind::Parameter => {
            d.replace(&at.name, &format!("({}*(1 + {text}))", at.name), |_| true);
            format!("{own} varies with {goes}")
        }
        _ => {
            d.output(&at.name, &format!("{{}} + {text}"));
            format!("{own} is off by something that goes with {goes}")
        }
    };
    d.done(&words)
}
