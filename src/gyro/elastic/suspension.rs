//! What the parts of a suspension enter into its force balance.

use crate::{Error, Result};

/// A second relaxation, T₂ ẋ₂ + x₂ = κ f/C₀ under the force f.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flow {
    /// T₂, s.
    pub time: f64,
    /// κ.
    pub share: f64,
}

/// A mass that swings on a spring of its own, ξ̈ + 2ζω ξ̇ + ω² ξ = W.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing {
    /// ω, rad/s.
    pub frequency: f64,
    /// ζ.
    pub damping: f64,
    /// μ, its part of the whole mass.
    pub share: f64,
}

/// The sphere's swing about its north-south axis with the rotors that it turns, as [`Pendulum`](super::Pendulum) has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tilt {
    /// ω with the rotors, rad/s.
    pub frequency: f64,
    /// ζ.
    pub damping: f64,
    /// q, the part of the rotors in its inertia.
    pub coupling: f64,
    /// τ of the rotors, s.
    pub lag: f64,
}

/// What yields beside the spring C₀ and the dashpot T C₀ of the gyrosphere; each part once.
///
/// A part enters itself by [`Elastic::enters`](super::Elastic::enters); what the entries mean together stands with
/// [`Assembly`](super::Assembly).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Suspension {
    /// Whether the acceleration of the give counts beside W: (2.2) in place of (2.3).
    pub inertia: bool,
    /// In series with the spring.
    pub flow: Option<Flow>,
    /// Inside the mass.
    pub swing: Option<Swing>,
    /// Of the mass about the point that the spring holds.
    pub tilt: Option<Tilt>,
    /// F_c, N, beside the spring.
    pub friction: Option<f64>,
    /// δ, m, between the spring and what it holds.
    pub gap: Option<f64>,
    /// Stiffness N/m and time s along the meridian.
    pub meridian: Option<(f64, f64)>,
    /// Stiffness N/m and time s along the vertical.
    pub vertical: Option<(f64, f64)>,
}

impl Suspension {
    /// Puts an entry into its empty place.
    ///
    /// # Errors
    /// `Usage` where there is one already.
    pub fn once<T>(place: &mut Option<T>, entry: T, what: &str) -> Result<()> {
        if place.replace(entry).is_none() {
            return Ok(());
        }
        Err(Error::usage(format!("this compass has {what} of its own, and another is asked for"))
            .with_hint("a suspension takes each part once"))
    }

    /// Whether the part along the parallel is linear.
    pub fn is_linear(&self) -> bool {
        self.friction.is_none() && self.gap.is_none()
    }

    /// The elastic part, in words.
    pub fn name(&self) -> String {
        let base = if self.inertia { "lag with inertia (2.2)" } else { "lag (2.3)" };
        let more = [
            (self.flow.is_some(), "liquid flow"),
            (self.swing.is_some(), "sloshing liquid"),
            (self.tilt.is_some(), "the sphere's own swing"),
            (self.meridian.is_some(), "compliance along the meridian"),
            (self.vertical.is_some(), "compliance along the vertical"),
            (self.friction.is_some(), "dry friction"),
            (self.gap.is_some(), "free play"),
        ];
        let mut words = vec![base];
        words.extend(more.iter().filter(|m| m.0).map(|m| m.1));
        match words.split_last() {
            Some((last, [])) => (*last).to_owned(),
            Some((last, others)) => format!("{} and {last}", others.join(", ")),
            None => String::new(),
        }
    }
}
