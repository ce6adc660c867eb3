//! The coordinates in which a fit walks.
//!
//! # Purpose
//! Parameters that are positive by their bounds walk as logarithms, all others as they stand, so that
//! a step means the same for a stiffness of 10⁸ and a time of 10⁻².
//!
//! # Method
//! z = ln x where 0 < min, else z = x; bounds become a box in z.

use crate::model::Parameter;

/// What a fit may do with one unknown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Smallest allowed value, −∞ for none.
    pub min: f64,
    /// Largest allowed value, +∞ for none.
    pub max: f64,
}

impl Range {
    /// No bounds.
    pub const FREE: Self = Self { min: f64::NEG_INFINITY, max: f64::INFINITY };

    /// The bounds of a parameter.
    pub fn of(p: &Parameter) -> Self {
        Self { min: p.min.unwrap_or(Self::FREE.min), max: p.max.unwrap_or(Self::FREE.max) }
    }

    /// Whether the unknown walks as its logarithm.
    pub fn is_logarithmic(self) -> bool {
        self.min > 0.0
    }

    /// The value moved inside the bounds.
    pub fn clamp(self, x: f64) -> f64 {
        x.max(self.min).min(self.max)
    }

    /// z from x.
    pub fn inward(self, x: f64) -> f64 {
        if self.is_logarithmic() { self.clamp(x).ln() } else { self.clamp(x) }
    }

    /// x from z.
    pub fn outward(self, z: f64) -> f64 {
        self.clamp(if self.is_logarithmic() { z.exp() } else { z })
    }

    /// dx/dz at x.
    pub fn slope(self, x: f64) -> f64 {
        if self.is_logarithmic() { x } else { 1.0 }
    }

    /// The box in z.
    pub fn inner(self) -> (f64, f64) {
        if self.is_logarithmic() { (self.min.ln(), self.max.ln()) } else { (self.min, self.max) }
    }

    /// The bound that x sits at, within a part in 10⁹ of its size or of the range.
    pub fn at_bound(self, x: f64) -> Option<Side> {
        let near = |bound: f64| {
            let span = self.max - self.min;
            let size = if span.is_finite() { span } else { bound.abs().max(x.abs()) };
            bound.is_finite() && (x - bound).abs() <= 1e-9 * size.max(bound.abs())
        };
        if near(self.min) {
            Some(Side::Lower)
        } else if near(self.max) {
            Some(Side::Upper)
        } else {
            None
        }
    }
}

/// One end of a range.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The smallest allowed value.
    Lower,
    /// The largest allowed value.
    Upper,
}
