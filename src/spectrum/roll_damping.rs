//! # Purpose
//! The damping ratio of a ship whose roll is damped by more than a term in proportion to its rate.
//!
//! # Method
//! Of the damping 2ζω_φθ̇ + d|θ̇|θ̇ + cθ̇³ the linear law 2ζ_eω_φθ̇ that leaves the least mean square is, for a Gaussian
//! rate of deviation σ with ⟨|θ̇|³⟩ = √(8/π) σ³ and ⟨θ̇⁴⟩ = 3σ⁴,
//!
//! 2ζ_eω_φ = 2ζω_φ + d √(8/π) σ + 3c σ²,
//!
//! where σ is that of the roll so damped: σ falls with ζ_e, and the right side with it, so that there is one fixed
//! point, found by halving.
//!
//! # References
//! T. K. Caughey, Equivalent linearization techniques, J. Acoust. Soc. Am. 35 (1963) 1706–1711; Y. Himeno, Prediction
//! of ship roll damping – state of the art, University of Michigan, Dept. of Naval Architecture, Report 239 (1981).
//!
//! # Numerical aspects
//! σ is summed over the sea's own spectrum, not over a rational one.

use super::{Hull, SlopeSpectrum};
use std::f64::consts::{FRAC_2_PI, PI};

impl Hull {
    /// ζ_e in a sea of these slopes, and σ of θ̇ in it, rad/s.
    ///
    /// ```
    /// use gyrospec::spectrum::{Encounter, Hull, Sea};
    /// let sea = Sea::Bretschneider { height: 4.0, peak: 0.7 };
    /// let met = Encounter { sea, from: 1.5, speed: 0.0, spread: None }.slopes(&Hull::default(), 3000, 0.99999)?;
    /// let hull = Hull { quadratic: 0.3, ..Hull::default() };
    /// let (damping, rate) = hull.equivalent_damping(&met);
    /// let added = 0.3 * (8.0 / std::f64::consts::PI).sqrt() * rate / (2.0 * hull.frequency);
    /// assert!((damping - hull.damping - added).abs() < 1e-9);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn equivalent_damping(&self, slopes: &SlopeSpectrum) -> (f64, f64) {
        if self.quadratic == 0.0 && self.cubic == 0.0 {
            return (self.damping, self.roll_rate(slopes, self.damping));
        }
        let wanted = |damping: f64| {
            let sigma = self.roll_rate(slopes, damping);
            // √(8/π) = 2 √(2/π)
            let more = self.quadratic * 2.0 * FRAC_2_PI.sqrt() * sigma + 3.0 * self.cubic * sigma * sigma;
            self.damping + more / (2.0 * self.frequency)
        };
        let (mut low, mut high) = (self.damping, wanted(self.damping));
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if wanted(middle) > middle { low = middle } else { high = middle }
        }
        (low, self.roll_rate(slopes, low))
    }

    /// σ of θ̇ with a damping ratio ζ: σ² = (1/π) ∫₀^∞ ω² |θ/σ_athwart|² S dω.
    fn roll_rate(&self, slopes: &SlopeSpectrum, damping: f64) -> f64 {
        let w0 = self.frequency;
        let power = |w: f64| {
            (w0 * w0 * self.slope).powi(2) / ((w0 * w0 - w * w).powi(2) + (2.0 * damping * w0 * w).powi(2))
        };
        let points = slopes.points(w0, damping);
        let sum: f64 = points.iter().map(|(w, dw, k)| w * w * power(*w) * slopes.bins[*k][0] * dw).sum();
        (sum / PI).sqrt()
    }
}
