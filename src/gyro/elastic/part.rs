//! What an elastic part is, and what all of them need.

use super::in_time::InTime;
use super::suspension::Suspension;
use crate::gyro::Gyrosphere;
use crate::lti::StateSpace;
use crate::{Error, Result};
use faer::Mat;
use std::borrow::Cow;

/// A part of the gyrosphere that gives way to the accelerations (W₁, W₂, W₃), m/s², along the
/// parallel, the meridian and the vertical.
pub trait Elastic: Boxed + std::fmt::Debug + Send + Sync {
    /// A short name for tables.
    fn name(&self) -> &str;

    /// The linear system from (W₁, W₂, W₃) to the shift (x, y, z) of the centre of mass, m.
    /// `acceleration` is the motion's system from its white noises to (W₁, W₂, W₃) on the
    /// heading asked for: a part that is not linear gives its best linear stand-in for it, whose
    /// error nothing bounds, and has its own law [`in_time`](Elastic::in_time).
    ///
    /// # Errors
    /// `BadInput` for numbers that describe no such part.
    fn system(&self, sphere: &Gyrosphere, acceleration: &StateSpace) -> Result<StateSpace>;

    /// A part that is not linear, in steps of `step` seconds; `None` for a linear one, which
    /// [`system`](Elastic::system) describes whole.
    ///
    /// # Errors
    /// `BadInput` for numbers that describe no such part.
    fn in_time(&self, _sphere: &Gyrosphere, _step: f64) -> Result<Option<Box<dyn InTime>>> {
        Ok(None)
    }

    /// Enters itself into the force balance of several parts together; a part that does not is a suspension of its
    /// own.
    ///
    /// # Errors
    /// `Usage` for a part that stands alone, and for one that is there already.
    fn enters(&self, _suspension: &mut Suspension) -> Result<()> {
        Err(Error::usage(format!("{} is a suspension of its own and goes with no other part", self.name())))
    }

    /// Beside a part that is followed in time along the parallel: the linear system from (W₁, W₂, W₃) to what gives
    /// way along the meridian and the vertical; `None` where nothing does.
    ///
    /// # Errors
    /// `BadInput` for numbers that describe no such part.
    fn across(&self, _sphere: &Gyrosphere) -> Result<Option<StateSpace>> {
        Ok(None)
    }

    /// What a part that is not linear becomes where its friction and its play are zero: a part whose
    /// [`system`](Elastic::system) is exact and which is followed [`in_time`](Elastic::in_time) like this one. `None`
    /// where that is the lag with inertia (2.2).
    fn tightened(&self) -> Option<Box<dyn Elastic>> {
        None
    }

    /// How W₁ moves x, in symbols; `None` where the mean error has no closed form.
    fn letters(&self) -> Option<Letters> {
        None
    }

    /// Which of its directions change no mean; empty where there is none.
    fn idle(&self) -> &'static str {
        ""
    }
}

/// The centre of mass in symbols.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Letters {
    /// x/θ̈ as an expression in s, with the letters of docs/symbols.md; where the mass gives way along the meridian
    /// too, less what y takes of M_y.
    pub shift: Cow<'static, str>,
    /// The letters in the order in which a formula shows them.
    pub order: Cow<'static, str>,
}

impl Letters {
    pub(super) const fn of(shift: &'static str, order: &'static str) -> Self {
        Self { shift: Cow::Borrowed(shift), order: Cow::Borrowed(order) }
    }
}

/// A part that can be copied behind its trait; every part that is `Clone` can.
pub trait Boxed {
    /// A copy.
    fn boxed(&self) -> Box<dyn Elastic>;
}

impl<T: Elastic + Clone + 'static> Boxed for T {
    fn boxed(&self) -> Box<dyn Elastic> {
        Box::new(self.clone())
    }
}

impl Clone for Box<dyn Elastic> {
    fn clone(&self) -> Self {
        self.as_ref().boxed()
    }
}

/// Single-input parts side by side: each from one acceleration to one shift.
pub(super) fn along(parts: &[(usize, StateSpace)]) -> Result<StateSpace> {
    let order = parts.iter().map(|(_, p)| p.order()).sum();
    let (mut a, mut b, mut c) = (Mat::zeros(order, order), Mat::zeros(order, 3), Mat::zeros(3, order));
    let mut at = 0;
    for (axis, part) in parts {
        for i in 0..part.order() {
            (0..part.order()).for_each(|j| a[(at + i, at + j)] = part.a[(i, j)]);
            b[(at + i, *axis)] = part.b[(i, 0)];
            c[(*axis, at + i)] = part.c[(0, i)];
        }
        at += part.order();
    }
    StateSpace::new(a, b, c, Mat::zeros(3, 3))
}

pub(super) fn positive(values: &[(&str, f64)]) -> Result<()> {
    for (name, value) in values {
        if !(value.is_finite() && *value > 0.0) {
            return Err(Error::bad_input(format!("{name} must be positive, not {value}")));
        }
    }
    Ok(())
}

/// The σ, m or m/s, that a linear stand-in gives itself, between two bounds: by bisection where `exceeds` tells whether
/// the stand-in for σ moves more than σ.
pub(super) fn fixed_point(
    [mut low, mut high]: [f64; 2],
    exceeds: impl Fn(f64) -> Result<bool>,
) -> Result<f64> {
    for _ in 0..60 {
        let middle = (low * high).sqrt();
        *(if exceeds(middle)? { &mut low } else { &mut high }) = middle;
    }
    Ok((low * high).sqrt())
}

/// The standard deviations of x and ẋ of m ẍ + r ẋ + c x = m W₁ under an acceleration.
pub(super) fn deviations(part: &StateSpace, acceleration: &StateSpace) -> Result<(f64, f64)> {
    let joint = acceleration.then(&along(&[(0, part.clone())])?)?;
    let x = joint.state_covariance()?.matrix;
    let at = acceleration.order();
    Ok((x[(at, at)].max(0.0).sqrt(), x[(at + 1, at + 1)].max(0.0).sqrt()))
}
