//! What is concealed: mechanisms of the catalogue, and a law that it does not have.

use super::maker::Hidden;
use crate::diagnose::catalogue::{self, Group, Mechanism, Proposal, Scene};
use crate::expression::Expr;
use crate::model::Model;
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;
use std::ops::Range;

/// Whether a mechanism is a law that a term of the model can be: a fault of the data is none, nor what has no name, nor a
/// value of the model's own.
fn is_law(m: &Mechanism) -> bool {
    !matches!(m.group, Group::Fault | Group::Unnamed) && m.code != "parameter-value"
}

/// Sizes of an effect over that of what it stands beside, drawn evenly in their logarithm.
const SCALES: Range<f64> = 0.01..0.4;

/// A drawn mechanism of the catalogue that `model` admits, at a drawn place in a drawn size, in the model, with what it is;
/// none where the draw admits none, or has the code of `other`.
pub fn conceal(
    model: &Model,
    scene: &Scene,
    other: Option<&Hidden>,
    rng: &mut ChaCha8Rng,
) -> Option<(Proposal, Hidden)> {
    let here = Scene { model, ..scene.clone() };
    let laws: Vec<&Mechanism> = catalogue::ALL.iter().filter(|m| is_law(m)).collect();
    let law = laws.choose(rng)?;
    let proposals: Vec<Proposal> = (law.propose)(&here)
        .into_iter()
        .filter(|p| !p.starts.is_empty() && !p.added.is_empty() && !p.refines)
        .collect();
    let mut p = proposals.choose(rng).filter(|_| other.is_none_or(|o| o.code != law.code))?.clone();
    let start = &p.starts[rng.random_range(0..p.starts.len().min(3))];
    let scale = rng.random_range(f64::ln(SCALES.start)..f64::ln(SCALES.end)).exp();
    let first_is_larger: bool = rng.random();
    let (code, place, term) = (law.code.into(), p.site.name.clone(), p.term.clone());
    let mut hidden = Hidden { code, place, term, values: Vec::new() };
    for (i, a) in p.added.iter().enumerate() {
        let factor = match p.amplitudes.iter().position(|k| *k == i) {
            // Two amplitudes differ by half at least, so that it is not a simpler mechanism in disguise.
            Some(k) if (k % 2 == 0) == first_is_larger => scale * rng.random_range(1.2..1.5),
            Some(_) => scale * rng.random_range(0.5..0.8),
            None => rng.random_range(0.9..1.1),
        };
        let value = (start[i] * factor).clamp(p.limits[i].0, p.limits[i].1);
        hidden.values.push((a.name.clone(), a.unit.difference_from_si(value)));
        if let Some(q) = p.model.parameters.iter_mut().find(|q| q.name == a.name) {
            q.value = value;
        }
    }
    Some((p, hidden))
}

/// A law that no catalogue has, of two signals: s the position of a motion, or a state; r its speed, or an input,
///
/// ```text
///     ± F sin(3 (s - mean)/spread) (r - mean)^2/spread^2
/// ```
pub fn outside(scene: &Scene, rng: &mut ChaCha8Rng) -> Option<Model> {
    let motions = scene.motions();
    let m = motions.choose(rng)?;
    let of = m.position.as_ref().unwrap_or(&m.state);
    let inputs: Vec<&str> = scene.model.inputs.iter().map(|i| i.name.as_str()).collect();
    let by = m.speed.as_deref().filter(|v| *v != of).or_else(|| inputs.choose(rng).copied())?;
    let about = |name: &str| {
        let s = scene.signal(name).filter(|s| s.spread > 0.0)?;
        Some(format!("(({name} - {:e})/{:e})", s.mean, s.spread))
    };
    let size = m.size * rng.random_range(f64::ln(SCALES.start)..f64::ln(SCALES.end)).exp();
    let sign = if rng.random() { "" } else { "-" };
    let text = format!("{sign}{size:e}*sin(3*{})*{}^2", about(of)?, about(by)?);
    let term = Expr::parse(&text).ok()?;
    let mut made = scene.model.clone();
    let s = made.states.iter_mut().find(|s| s.name == m.state)?;
    s.rate = catalogue::edit::with_sum(scene.model, &s.rate, &|sum| catalogue::edit::plus(sum, &term));
    Some(made)
}
