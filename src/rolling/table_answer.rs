//! What a compass's part makes of the accelerations on a Scorsby table.

use crate::Result;
use crate::gyro::{Gyrosphere, Instrument};
use crate::lti::StateSpace;
use faer::Mat;
use num_complex::Complex64;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Amplitudes at which a part that is not linear is followed.
const AMPLITUDES: usize = 32;
/// Points of a period, where many are followed and where one is.
const POINTS: [usize; 2] = [100, 400];

/// x and y a unit of W₁ and W₂ by their frequency and, where the part is not linear, by the amplitude of W₁.
pub(super) enum TableAnswer {
    /// A linear part.
    Linear(StateSpace),
    /// A part that is followed in time along the parallel.
    Followed {
        instrument: Box<Instrument>,
        /// The elastic part along the meridian.
        across: Option<StateSpace>,
        /// The largest amplitude, m/s².
        most: f64,
    },
}

/// The same at one frequency.
pub(super) enum Gives {
    Linear(Mat<faer::c64>),
    /// x a unit of W₁ at the amplitudes most·i/n, i = 1 … n; `most`; y a unit of W₂.
    Followed(Vec<Complex64>, f64, Complex64),
}

impl TableAnswer {
    /// Of a compass under accelerations up to `most`, m/s².
    pub fn of(instrument: Instrument, most: f64) -> Result<Self> {
        if !instrument.is_linear()? {
            let across = instrument.elastic.across(&instrument.sphere)?;
            return Ok(Self::Followed { instrument: Box::new(instrument), across, most });
        }
        // what moves the compass matters to parts that are not linear alone
        let still = StateSpace::new(Mat::zeros(0, 0), Mat::zeros(0, 3), Mat::zeros(3, 0), Mat::zeros(3, 3))?;
        instrument.elastic.system(&instrument.sphere, &still).map(Self::Linear)
    }

    /// Whether the part is followed in time.
    pub fn is_followed(&self) -> bool {
        matches!(self, Self::Followed { .. })
    }

    /// At a period, s.
    pub fn at(&self, period: f64) -> Result<Gives> {
        let p = TAU / period;
        match self {
            Self::Linear(system) => Ok(Gives::Linear(system.at(Complex64::new(0.0, p)))),
            Self::Followed { instrument, across, most } => {
                let gain = |i: usize| instrument.answer(most * i as f64 / AMPLITUDES as f64, p, POINTS[0]);
                let gains = (1..=AMPLITUDES).into_par_iter().map(gain).collect::<Result<_>>()?;
                Ok(Gives::Followed(gains, *most, meridian(across.as_ref(), p)))
            }
        }
    }

    /// At a period, for one acceleration along the parallel (m/s²) as exactly as can be.
    pub fn of_one(&self, period: f64, w1: Complex64) -> Result<Gives> {
        let p = TAU / period;
        match self {
            Self::Linear(_) => self.at(period),
            Self::Followed { instrument, across, most } => {
                let gain = if w1.norm() > 0.0 {
                    instrument.answer(w1.norm(), p, POINTS[1])?
                } else {
                    Complex64::ZERO
                };
                Ok(Gives::Followed(vec![gain], *most, meridian(across.as_ref(), p)))
            }
        }
    }
}

/// y a unit of W₂.
fn meridian(across: Option<&StateSpace>, p: f64) -> Complex64 {
    across.map_or(Complex64::ZERO, |system| {
        let y = system.at(Complex64::new(0.0, p))[(1, 1)];
        Complex64::new(y.re, y.im)
    })
}

impl Gives {
    /// (x, y) under the complex amplitudes (W₁, W₂).
    pub fn shift(&self, w: [Complex64; 2]) -> [Complex64; 2] {
        match self {
            Self::Linear(m) => [0, 1].map(|row| m[(row, 0)] * w[0] + m[(row, 1)] * w[1]),
            Self::Followed(gains, most, across) => {
                [by_amplitude(gains, w[0].norm() / most) * w[0], across * w[1]]
            }
        }
    }
}

/// The gain at a part of the largest amplitude, straight between those known.
fn by_amplitude(gains: &[Complex64], part: f64) -> Complex64 {
    let at = (part * gains.len() as f64 - 1.0).clamp(0.0, (gains.len() - 1) as f64);
    let (below, over) = (at.floor() as usize, at.fract());
    let above = (below + 1).min(gains.len() - 1);
    gains[below] * (1.0 - over) + gains[above] * over
}

/// α = (P/(2 g H U cos φ)) Re(W₂ x* − W₁ y*), with W₁ and W₂ on a heading.
pub(super) fn mean_error(s: &Gyrosphere, gives: &Gives, rq: [Complex64; 2], heading: f64) -> f64 {
    let w = along(rq, heading);
    let [x, y] = gives.shift(w);
    let product = (w[1] * x.conj() - w[0] * y.conj()).re;
    s.weight * product / (2.0 * s.gravity * s.momentum * s.earth_rate * s.latitude.cos())
}

/// W₁ and W₂ of accelerations athwart and forward, on a heading.
pub(super) fn along([r, q]: [Complex64; 2], heading: f64) -> [Complex64; 2] {
    let (sin, cos) = heading.sin_cos();
    [-r * cos + q * sin, r * sin + q * cos]
}
