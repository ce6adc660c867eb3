//! # What it is
//! Beyond a certain deflection a stiff stop carries the part.
//!
//! # Signature in a recording
//! The motion is cut at one level, with a kick back; nothing is wrong at small amplitude.
//!
//! # Equation
//! ```text
//!     M v' = … - ks max(q - qs, 0) + ks max(-qs - q, 0)
//! ```
//!
//! # What else looks like this
//! cubic-stiffness, input-saturation, output-saturation (the sensor clips, the motion does not).
//!
//! # Reference
//! S. W. Shaw, P. J. Holmes, A periodically forced piecewise linear oscillator, J. Sound Vib. 90
//! (1983) 129.
//!
//! # Example
//! A gyroscope's gimbal that reaches its stop in heavy roll.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::ANY, draft::POSITIVE};

/// An end stop.
pub(super) const MECHANISM: Mechanism =
    Mechanism::new("end-stop", "an end stop", Group::Force, include_str!("end_stop.rs"), propose);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let motions = scene.motions();
    let sides = |m: &Motion| [at(scene, m, 0), at(scene, m, 1), at(scene, m, -1)];
    motions.iter().filter(|m| m.speed.is_some()).flat_map(sides).flatten().collect()
}

fn at(scene: &Scene, m: &Motion, side: i8) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    let signal = scene.signal(q)?;
    let mut d = Draft::at(scene, "end-stop", m);
    let k = d.amplitude("ks", &m.force.over(&signal.unit), POSITIVE, "stiffness of the stop");
    let qs = d.parameter("qs", &signal.unit, ANY, "where the stop is");
    if side >= 0 {
        d.force(&m.state, &format!("-{k}*max({q} - {qs}, 0*{qs})"));
    }
    match side {
        0 => d.force(&m.state, &format!("{k}*max(-{qs} - {q}, 0*{qs})")),
        -1 => d.force(&m.state, &format!("{k}*max({qs} - {q}, 0*{qs})")),
        _ => {}
    }
    for fraction in [0.6, 0.85] {
        let level = match side {
            0 => fraction * signal.max.abs().max(signal.min.abs()),
            1 => signal.mean + fraction * (signal.max - signal.mean),
            _ => signal.mean + fraction * (signal.min - signal.mean),
        };
        d.start(&[10.0 * m.size / signal.size(), level]);
    }
    d.done(&format!("a stop of stiffness {{0}} stands at {} = {{1}}", scene.words(q)))
}
