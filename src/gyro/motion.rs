//! The motion of the ship that carries the compass, driven by white noise through filters.

use crate::lti::{StateSpace, TransferFunction};
use crate::spectrum::Roll;
use crate::{Error, ErrorKind, Result};
use faer::Mat;

/// A motion of the ship.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// θ, rad.
    Roll,
    /// rad, positive when it carries the compass forward.
    Pitch,
    /// rad, adds to the heading.
    Yaw,
    /// m.
    Heave,
    /// m, along the roll's horizontal motion.
    Sway,
    /// m, forward.
    Surge,
}

/// Motions of a ship with all their spectra and cross-spectra: unit white noises through one
/// linear system, whose outputs are the displacements along [`Axis`].
///
/// ```
/// use gyrospec::gyro::{Axis, Motion};
/// use gyrospec::spectrum::Roll;
/// let motion = Motion::roll(&Roll::new(0.03, 0.1, 0.8).unwrap());
/// assert_eq!(motion.axes(), [Axis::Roll]);
/// assert!(motion.has_white_acceleration());        // (3.3): its variance is infinite
/// ```
#[derive(Debug, Clone)]
pub struct Motion {
    system: StateSpace,
    axes: Vec<Axis>,
}

/// A signal c·z + d·w over the states and the white noises of a linear system.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearSignal {
    /// Its part of each state.
    pub state: Vec<f64>,
    /// Its part of each white noise.
    pub noise: Vec<f64>,
}

impl LinearSignal {
    /// Whether it holds white noise, so that its variance is infinite.
    pub fn is_white(&self) -> bool {
        self.noise.iter().any(|d| *d != 0.0)
    }
}

impl Motion {
    /// Displacements from one system: its outputs in the order of `axes`.
    ///
    /// # Errors
    /// `BadInput` when outputs and axes differ in number or an axis comes twice.
    pub fn new(system: StateSpace, axes: &[Axis]) -> Result<Self> {
        let twice = axes.iter().enumerate().any(|(i, a)| axes[..i].contains(a));
        if system.outputs() != axes.len() || axes.is_empty() || twice {
            return Err(Error::bad_input("a motion needs one output for each of its axes"));
        }
        Ok(Self { system, axes: axes.to_vec() })
    }

    /// The paper's irregular roll alone.
    pub fn roll(roll: &Roll) -> Self {
        Self { system: StateSpace::from_transfer(&roll.shaping()), axes: vec![Axis::Roll] }
    }

    /// One motion that is white noise of unit intensity through a filter.
    ///
    /// # Errors
    /// `BadInput` for a filter without poles.
    pub fn filtered(axis: Axis, shaping: &TransferFunction) -> Result<Self> {
        Self::new(StateSpace::from_transfer(shaping), &[axis])
    }

    /// Several motions that answer one sea: white noise through `sea`, then through each
    /// response; all are fully correlated.
    ///
    /// # Errors
    /// As [`Motion::new`].
    pub fn in_sea(sea: &TransferFunction, responses: &[(Axis, TransferFunction)]) -> Result<Self> {
        let parts: Vec<StateSpace> = responses.iter().map(|(_, w)| StateSpace::from_transfer(w)).collect();
        let side_by_side = abreast(&parts, true)?;
        let axes: Vec<Axis> = responses.iter().map(|(a, _)| *a).collect();
        Self::new(StateSpace::from_transfer(sea).then(&side_by_side)?, &axes)
    }

    /// Motions that know nothing of each other, side by side.
    ///
    /// # Errors
    /// `BadInput` when an axis comes twice.
    pub fn independent(motions: &[Self]) -> Result<Self> {
        let parts: Vec<StateSpace> = motions.iter().map(|m| m.system.clone()).collect();
        let axes: Vec<Axis> = motions.iter().flat_map(|m| m.axes.clone()).collect();
        Self::new(abreast(&parts, false)?, &axes)
    }

    /// The same with each displacement behind `times` first-order low-passes at `corner`, rad/s.
    ///
    /// # Errors
    /// `BadInput` for a corner that is not positive.
    pub fn band_limited(&self, corner: f64, times: usize) -> Result<Self> {
        if !(corner.is_finite() && corner > 0.0) {
            return Err(Error::bad_input("the corner of a low-pass must be positive"));
        }
        let low = StateSpace::from_transfer(&TransferFunction::new(&[1.0], &[1.0 / corner, 1.0])?);
        let mut system = self.system.clone();
        for _ in 0..times {
            system = system.then(&abreast(&vec![low.clone(); self.axes.len()], false)?)?;
        }
        Self::new(system, &self.axes)
    }

    /// The axes that move.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// The system behind: white noises in, displacements out.
    pub fn system(&self) -> &StateSpace {
        &self.system
    }

    /// Whether an acceleration holds white noise.
    pub fn has_white_acceleration(&self) -> bool {
        self.axes.iter().any(|a| self.derivative(*a, 2).is_ok_and(|s| s.is_white()))
    }

    /// √(⟨ẋ²⟩/⟨x²⟩) of the fastest axis x, rad/s: b of a roll of the form (3.3).
    ///
    /// # Errors
    /// As the covariance of the motion.
    pub fn own_frequency(&self) -> Result<f64> {
        let sigma = self.system.state_covariance()?.matrix;
        let mut fastest = 0.0f64;
        for axis in &self.axes {
            let [own, rate] =
                [0, 1].map(|order| self.derivative(*axis, order).map(|s| deviation(&sigma, &s.state)));
            let (own, rate) = (own?, rate?);
            fastest = fastest.max(if own > 0.0 { rate / own } else { 0.0 });
        }
        Ok(fastest)
    }

    /// The `order`-th derivative of an axis; zero for an axis that does not move.
    ///
    /// # Errors
    /// `OutOfRange` when it would be the derivative of white noise.
    pub fn derivative(&self, axis: Axis, order: usize) -> Result<LinearSignal> {
        let (a, b) = (&self.system.a, &self.system.b);
        let (n, m) = (self.system.order(), self.system.inputs());
        let Some(row) = self.axes.iter().position(|x| *x == axis) else {
            return Ok(LinearSignal { state: vec![0.0; n], noise: vec![0.0; m] });
        };
        let mut c: Vec<f64> = (0..n).map(|j| self.system.c[(row, j)]).collect();
        let mut d: Vec<f64> = (0..m).map(|j| self.system.d[(row, j)]).collect();
        for _ in 0..order {
            if d.iter().any(|v| *v != 0.0) {
                return Err(Error::new(
                    ErrorKind::OutOfRange,
                    format!("the {axis:?} spectrum falls off too slowly: its acceleration is no process"),
                )
                .with_hint("limit the band of the motion"));
            }
            // (c z)˙ = cA z + cB w
            d = (0..m).map(|k| (0..n).map(|i| c[i] * b[(i, k)]).sum()).collect();
            c = (0..n).map(|k| (0..n).map(|i| c[i] * a[(i, k)]).sum()).collect();
        }
        Ok(LinearSignal { state: c, noise: d })
    }
}

/// √(c Σ cᵀ).
pub(super) fn deviation(sigma: &Mat<f64>, c: &[f64]) -> f64 {
    let products = (0..c.len()).flat_map(|i| (0..c.len()).map(move |j| c[i] * c[j] * sigma[(i, j)]));
    products.sum::<f64>().max(0.0).sqrt()
}

/// Systems side by side, each with its own inputs or all with the same.
fn abreast(parts: &[StateSpace], same_input: bool) -> Result<StateSpace> {
    let order = parts.iter().map(StateSpace::order).sum();
    let outputs = parts.iter().map(StateSpace::outputs).sum();
    let inputs: usize = if same_input {
        parts.first().map_or(0, StateSpace::inputs)
    } else {
        parts.iter().map(StateSpace::inputs).sum()
    };
    let (mut a, mut b) = (Mat::zeros(order, order), Mat::zeros(order, inputs));
    let (mut c, mut d) = (Mat::zeros(outputs, order), Mat::zeros(outputs, inputs));
    let (mut z, mut y, mut u) = (0, 0, 0);
    for p in parts {
        place(&mut a, &p.a, z, z);
        place(&mut b, &p.b, z, u);
        place(&mut c, &p.c, y, z);
        place(&mut d, &p.d, y, u);
        z += p.order();
        y += p.outputs();
        u += if same_input { 0 } else { p.inputs() };
    }
    StateSpace::new(a, b, c, d)
}

fn place(into: &mut Mat<f64>, part: &Mat<f64>, row: usize, column: usize) {
    for i in 0..part.nrows() {
        for j in 0..part.ncols() {
            into[(row + i, column + j)] = part[(i, j)];
        }
    }
}
