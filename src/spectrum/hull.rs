//! A ship's motion in a sea, by the slope of the waves averaged over her waterplane.

use super::sea::GRAVITY;
use crate::lti::TransferFunction;
use crate::{Error, Result};

/// How a ship moves in a long-crested sea: its slope athwart drives a damped resonance of roll, its slope along the
/// ship drives pitch, each averaged over the waterplane.
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `frequency` | ω_φ, natural roll frequency | rad/s |
/// | `damping` | ζ_φ, ratio of critical damping | 1 |
/// | `slope` | χ, effective part of the wave slope | 1 |
/// | `beam` | B, width of the waterplane | m |
/// | `length` | L, length of the waterplane | m |
/// | `quadratic` | d of d\|φ̇\|φ̇, more damping of roll | 1/rad |
/// | `cubic` | c of cφ̇³, more damping of roll | s/rad² |
///
/// A sea from the bearing ν off the bow (clockwise: 0 ahead, π/2 from abeam to starboard) has the slope
/// σ = (−s²/g)ζ along its travel, of which −σ sin ν acts athwart and +σ cos ν along the ship; positive turns carry the
/// mast to port and forward. Heave is given the phase of the slope. These are the answers of a ship without way; what
/// she meets under way is [`Encounter`](super::Encounter), and what damps her roll more than in proportion to its rate is
/// in [`Hull::equivalent_damping`].
///
/// A plane wave of the number k = ω²/g (deep water) has, averaged over a rectangle of L by B, its slope and its height
/// times
///
/// ```text
/// S = (1/LB) ∫∫ cos(k(x cos ν + y sin ν)) dx dy = sinc(½kL cos ν) · sinc(½kB sin ν),   sinc u = sin u/u,
/// ```
///
/// which is even and of second order about abeam and about ahead. With α = (L cos ν/2g)², β = (B sin ν/2g)² the series
///
/// ```text
/// 1/S² = 1 + (α + β)/3 · ω⁴ + ((α² + β²)/15 + αβ/9) · ω⁸ + …
/// ```
///
/// is cut there, so that a filter of order four has the power S². It is within 1 % of S² up to ½k√(L²cos²ν + B²sin²ν)
/// = 1, that is for waves longer than three times the ship's extent along their travel; of shorter ones, which hardly
/// move her, it leaves more than the rectangle does and has not its zeros, as a pointed waterplane has none. Where such
/// waves count, the form of the ship decides: a table of errors tells the mean by the rectangle beside its own.
///
/// References: M. St. Denis, W. J. Pierson, Trans. SNAME 61 (1953) 280–357; E. V. Lewis (ed.), Principles of Naval
/// Architecture III (SNAME 1989), ch. VIII; the average of a plane wave over a rectangle is its Fourier transform
/// (R. N. Bracewell, The Fourier Transform and Its Applications).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hull {
    /// ω_φ, rad/s.
    pub frequency: f64,
    /// Damping ratio ζ_φ of her free roll.
    pub damping: f64,
    /// Effective part χ of the wave's slope that rolls her.
    pub slope: f64,
    /// B, m.
    pub beam: f64,
    /// L, m.
    pub length: f64,
    /// d, 1/rad.
    pub quadratic: f64,
    /// c, s/rad².
    pub cubic: f64,
}

impl Default for Hull {
    /// A freighter of 15 m beam and 90 m length that rolls with a period of 9 s.
    fn default() -> Self {
        Self {
            frequency: 0.7,
            damping: 0.08,
            slope: 0.7,
            beam: 15.0,
            length: Self::BEAMS * 15.0,
            quadratic: 0.0,
            cubic: 0.0,
        }
    }
}

impl Hull {
    /// L/B of a ship of whose length nothing is said.
    pub const BEAMS: f64 = 6.0;

    /// The parts of a wave's slope athwart and along the ship, (−sin ν, cos ν); no part is a rounding error of 0.
    pub fn slopes(from: f64) -> (f64, f64) {
        let clean = |x: f64| if x.abs() < 1e-9 { 0.0 } else { x };
        (clean(-from.sin()), clean(from.cos()))
    }

    /// θ/ζ: φ̈ + 2ζ_φω_φφ̇ + ω_φ²φ = ω_φ² χ (−sin ν)(−s²/g) S ζ, rad/m, in a sea from the bearing ν (rad, clockwise off
    /// the bow).
    ///
    /// # Errors
    /// `BadInput` when a number is not positive, or nothing of the slope lies athwart.
    pub fn roll_response(&self, from: f64) -> Result<TransferFunction> {
        let athwart = excited(Self::slopes(from).0, "roll")?;
        let slope =
            TransferFunction::new(&[-athwart / GRAVITY, 0.0, 0.0], self.averaged(from)?.denominator())?;
        Ok(slope.then(&self.resonance(self.damping)?))
    }

    /// θ/σ for the mean slope σ athwart and a damping ratio ζ: ω_φ² χ/(s² + 2ζω_φ s + ω_φ²), rad/rad.
    ///
    /// # Errors
    /// `BadInput` when a number is not positive.
    pub fn resonance(&self, damping: f64) -> Result<TransferFunction> {
        self.check()?;
        let w2 = self.frequency * self.frequency;
        TransferFunction::new(&[w2 * self.slope], &[1.0, 2.0 * damping * self.frequency, w2])
    }

    /// Pitch/ζ = cos ν (−s²/g) S: the mean slope along the ship, rad/m.
    ///
    /// # Errors
    /// `BadInput` when a number is not positive, or nothing of the slope lies along the ship.
    pub fn pitch_response(&self, from: f64) -> Result<TransferFunction> {
        let along = excited(Self::slopes(from).1, "pitch")?;
        TransferFunction::new(&[-along / GRAVITY, 0.0, 0.0], self.averaged(from)?.denominator())
    }

    /// Heave/ζ = S: the mean height of the wave, m/m.
    ///
    /// # Errors
    /// `BadInput` when a number is not positive.
    pub fn heave_response(&self, from: f64) -> Result<TransferFunction> {
        self.averaged(from)
    }

    /// Sway/ζ = sin ν S, m/m: a ship that is small beside the waves goes with the water, which is accelerated down the
    /// slope by g of it, as the slope's part athwart would turn her mast.
    ///
    /// # Errors
    /// `BadInput` when a number is not positive, or nothing of the slope lies athwart.
    pub fn sway_response(&self, from: f64) -> Result<TransferFunction> {
        // s² sway = g (−sin ν)(−s²/g) S ζ
        Ok(self.averaged(from)?.scaled(-excited(Self::slopes(from).0, "sway")?))
    }

    /// Surge/ζ = −cos ν S, m/m, forward: likewise along the ship.
    ///
    /// # Errors
    /// `BadInput` when a number is not positive, or nothing of the slope lies along the ship.
    pub fn surge_response(&self, from: f64) -> Result<TransferFunction> {
        Ok(self.averaged(from)?.scaled(-excited(Self::slopes(from).1, "surge")?))
    }

    /// Yaw/ζ = −sin ν cos ν (−s²/g) S, rad/m: she lies along the water of her length, whose sway differs from bow to
    /// stern; like heave it is given the phase of the slope.
    ///
    /// # Errors
    /// `BadInput` when a number is not positive, or the sea comes along the ship or from abeam.
    pub fn yaw_response(&self, from: f64) -> Result<TransferFunction> {
        let (athwart, along) = Self::slopes(from);
        let both = excited(athwart, "yaw")? * excited(along, "yaw")?;
        TransferFunction::new(&[-both / GRAVITY, 0.0, 0.0], self.averaged(from)?.denominator())
    }

    /// S, by a filter of order four whose power is 1/(1 + pω⁴ + qω⁸).
    fn averaged(&self, from: f64) -> Result<TransferFunction> {
        self.check()?;
        let [p, q] = self.series(from);
        // ρ = q^(−1/8), cos 4η = −p/(2√q), u = s/ρ:  H = (1 + 2 sin η u + u²)(1 + 2 cos η u + u²)
        let (corner, eta) = (q.powf(-0.125), 0.25 * (-0.5 * p / q.sqrt()).acos());
        let pair = |damping: f64| [1.0 / (corner * corner), 2.0 * damping / corner, 1.0];
        let first = TransferFunction::new(&[1.0], &pair(eta.sin()))?;
        Ok(first.then(&TransferFunction::new(&[1.0], &pair(eta.cos()))?))
    }

    /// p and q of 1/S² = 1 + pω⁴ + qω⁸ in waves from ν, s⁴ and s⁸.
    fn series(&self, from: f64) -> [f64; 2] {
        let (athwart, along) = Self::slopes(from);
        // α = (L cos ν/2g)², β = (B sin ν/2g)², s⁴
        let [a, b] = [self.length * along, self.beam * athwart].map(|x| (0.5 * x / GRAVITY).powi(2));
        [(a + b) / 3.0, (a * a + b * b) / 15.0 + a * b / 9.0]
    }

    /// S² over ω⁴ in waves from ν: what the waterplane leaves of a wave's power.
    pub(super) fn keeps(&self, from: f64) -> impl Fn(f64) -> f64 + use<> {
        let [p, q] = self.series(from);
        move |fourth| 1.0 / (1.0 + fourth * (p + q * fourth))
    }

    /// S² over ω⁴ in waves from ν, without the cut: that of the rectangle with its zeros.
    pub(super) fn keeps_of_rectangle(&self, from: f64) -> impl Fn(f64) -> f64 + use<> {
        let (athwart, along) = Self::slopes(from);
        let (length, beam) = (self.length * along, self.beam * athwart);
        // sinc(½kL cos ν) sinc(½kB sin ν), k = ω²/g
        move |fourth| {
            let half = 0.5 * fourth.sqrt() / GRAVITY;
            (sinc(half * length) * sinc(half * beam)).powi(2)
        }
    }

    pub(super) fn check(&self) -> Result<()> {
        let values = [self.frequency, self.damping, self.slope, self.beam, self.length];
        let more = [self.quadratic, self.cubic];
        if values.iter().all(|v| v.is_finite() && *v > 0.0) && more.iter().all(|v| v.is_finite() && *v >= 0.0)
        {
            return Ok(());
        }
        Err(Error::bad_input(
            "frequency, damping, slope, beam and length of a ship must be positive, and what damps her more not negative",
        ))
    }
}

/// sin u/u
fn sinc(u: f64) -> f64 {
    if u.abs() < 1e-4 { 1.0 - u * u / 6.0 } else { u.sin() / u }
}

/// A part of the slope that is there.
fn excited(part: f64, what: &str) -> Result<f64> {
    if part != 0.0 {
        return Ok(part);
    }
    Err(Error::bad_input(format!("a sea from there has no slope that excites {what}")))
}
