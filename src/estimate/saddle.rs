//! Leaves points of rest that are no minima.
//!
//! # Purpose
//! A parameter that acts evenly (a time constant in 1 + p²T², a damping, a width) leaves no slope at its
//! zero: a walk that comes to T = 0, at a bound or between, rests there though the sum falls to both sides.
//!
//! # Method
//! Of every unknown whose column vanishes, the sum is looked at some way off: at the distance that the walk
//! came from and at shorter ones, or, where no distance is known, at growing ones until something moves.
//! Two unknowns that act only together, such as both factors of a product at zero, are moved together.
//!
//! # References
//! P. E. Gill, W. Murray, M. H. Wright, Practical Optimization, 1981, §4.4.2 (directions of negative
//! curvature).
//!
//! # Numerical aspects
//! At the zero of an even effect the sum has no mixed second derivatives with other unknowns, so that its
//! own axis shows a fall if any direction does.

use super::coordinates::Range;
use super::least_squares::problem::Problem;
use super::triangle::Triangle;

/// A step of its whole size moves the residuals by less than this share of their root mean square, to first
/// order: the slope vanishes.
const LEVEL: f64 = 1e-3;
/// Distances tried, as shares of the one known.
const SHARES: [f64; 5] = [1.0, 0.25, 0.0625, 1.0 / 64.0, 1.0 / 256.0];
/// Distances tried where none is known, SI.
const DISTANCES: [f64; 7] = [1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9];
/// Relative change of the sum that is more than rounding.
const VISIBLE: f64 = 1e-9;

/// A point at which a walk rests.
pub(super) struct Rest<'a, P: ?Sized> {
    pub problem: &'a P,
    pub ranges: &'a [Range],
    pub x: &'a [f64],
    pub sum: f64,
    pub triangle: &'a Triangle,
    /// Where the walk began.
    pub start: &'a [f64],
    /// Relative fall of the sum that is worth a step.
    pub reduction: f64,
}

/// What the sum does some way off.
enum Seen {
    Falls(Vec<f64>),
    Rises,
    Stays,
}

impl<P: Problem + ?Sized> Rest<'_, P> {
    /// A lower point beside this one, and how often the residuals were computed.
    pub fn way_down(&self) -> (Option<Vec<f64>>, usize) {
        let mut evaluations = 0;
        if !(self.sum > 0.0 && self.sum.is_finite()) {
            return (None, evaluations);
        }
        let level: Vec<usize> = (0..self.x.len()).filter(|j| self.is_level(*j)).collect();
        let mut inert = Vec::new();
        for j in &level {
            match self.along(&[(*j, 1.0)], &mut evaluations) {
                Seen::Falls(x) => return (Some(x), evaluations),
                Seen::Stays if self.x[*j] == 0.0 => inert.push(*j),
                Seen::Stays | Seen::Rises => {}
            }
        }
        for (k, i) in inert.iter().enumerate() {
            for j in &inert[k + 1..] {
                for sign in [1.0, -1.0] {
                    if let Seen::Falls(x) = self.along(&[(*i, 1.0), (*j, sign)], &mut evaluations) {
                        return (Some(x), evaluations);
                    }
                }
            }
        }
        (None, evaluations)
    }

    /// Whether the residuals do not move with an unknown, to first order.
    pub fn is_level(&self, j: usize) -> bool {
        let norm = self.triangle.column_norms()[j];
        let size = self.distance(j).unwrap_or(1.0);
        let rms = (self.sum / self.triangle.rows().max(1) as f64).sqrt();
        norm == 0.0 || norm * size < LEVEL * rms
    }

    /// How far away an unknown may reasonably be looked at; None where nothing tells.
    fn distance(&self, j: usize) -> Option<f64> {
        let range = self.ranges[j];
        let came = (self.start[j] - self.x[j]).abs();
        let span = range.max - range.min;
        let known = [came, self.x[j].abs(), if span.is_finite() { 0.5 * span } else { 0.0 }];
        known.into_iter().find(|d| *d > 0.0)
    }

    /// What the sum does along some unknowns, each moved by its own distance with a sign.
    fn along(&self, moved: &[(usize, f64)], evaluations: &mut usize) -> Seen {
        let known: Option<Vec<f64>> = moved.iter().map(|(j, _)| self.distance(*j)).collect();
        let visible =
            |evaluations: &mut usize| Some(vec![self.first_visible(moved, evaluations)?; moved.len()]);
        let Some(distances) = known.or_else(|| visible(evaluations)) else { return Seen::Stays };
        let mut risen = false;
        for share in SHARES {
            for side in [1.0, -1.0] {
                let away: Vec<f64> = distances.iter().map(|d| side * share * d).collect();
                let Some((x, fall)) = self.fall(moved, &away, evaluations) else { continue };
                if fall > self.reduction {
                    return Seen::Falls(x);
                }
                risen |= fall.is_nan() || fall < -VISIBLE;
            }
            if !risen {
                return Seen::Stays;
            }
        }
        Seen::Rises
    }

    /// The first of the growing distances at which the sum is another.
    fn first_visible(&self, moved: &[(usize, f64)], evaluations: &mut usize) -> Option<f64> {
        DISTANCES.into_iter().find(|distance| {
            [1.0, -1.0].into_iter().any(|side| {
                let fall = self.fall(moved, &vec![side * distance; moved.len()], evaluations);
                fall.is_some_and(|(_, fall)| fall.is_nan() || fall.abs() > VISIBLE)
            })
        })
    }

    /// A point some way off and the relative fall of the sum there; None where bounds leave no way.
    fn fall(&self, moved: &[(usize, f64)], away: &[f64], evaluations: &mut usize) -> Option<(Vec<f64>, f64)> {
        let mut x = self.x.to_vec();
        for ((j, sign), away) in moved.iter().zip(away) {
            x[*j] = self.ranges[*j].clamp(x[*j] + sign * away);
            if x[*j] == self.x[*j] {
                return None;
            }
        }
        *evaluations += 1;
        let sum = self.problem.sum_of_squares(&x).unwrap_or(f64::INFINITY);
        Some((x, (self.sum - sum) / self.sum))
    }
}
