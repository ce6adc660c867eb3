//! The sum of squares about a fitted minimum, and where it hardly rises.
//!
//! # Purpose
//! Tell which parameters a fit cannot hold apart, although each alone is held fast, and how far each may
//! go when the others follow.
//!
//! # Method
//! Singular values of the sensitivities with columns of length one, unknowns at bounds included: along a
//! small one the unknowns trade. The unknowns that trade, and those whose interval is as large as
//! themselves, are moved outwards one at a time, all others fitted anew from where the last point leads,
//! until the sum has risen by what the noise allows. Several starts must agree that it has; where a walk ends
//! for any other reason, that end is not determined.
//!
//! # References
//! D. M. Bates, D. G. Watts, Nonlinear Regression Analysis and Its Applications, 1988, ch. 6 (profiles);
//! A. Raue and others, Bioinformatics 25 (2009) 1923 (structural and practical identifiability).
//!
//! # Numerical aspects
//! The noise of a coloured residual counts with its slow part, N times its variance over the samples that
//! are worth an independent one: the intervals are rather too wide than too narrow.

use super::problem::FreeRun;
use crate::estimate::coordinates::Range;
use crate::estimate::least_squares::{End, Minimum, Stopping, minimise};
use crate::estimate::triangle::Triangle;

/// Singular value of columns of length one below which unknowns trade whatever the noise.
const NULL: f64 = 1e-6;
/// Deviation of a parameter, as a share of itself, from which on the sum is no parabola about it.
const BENT: f64 = 0.25;
/// Part in a trade, against the largest, that counts.
const PART: f64 = 0.05;
/// Farthest that a parameter is followed by factors, as a logarithm: a hundredfold.
const FAR: f64 = 4.605_170_185_988_092;
/// Steps outwards at most.
const STEPS: usize = 12;
/// Refits that close in on the end of an interval.
const CLOSER: usize = 8;
/// A rise so little above the allowed one is near enough.
const NEAR: f64 = 1.1;

/// The neighbourhood of a minimum.
pub struct Valley<'a> {
    /// The problem that was solved.
    pub problem: &'a FreeRun<'a>,
    /// The ranges of the unknowns.
    pub ranges: &'a [Range],
    pub x: &'a [f64],
    /// The sum of squares there.
    pub sum: f64,
    /// [∂r/∂x | r] there.
    pub triangle: &'a Triangle,
    /// What an independent sample of noise adds to the sum.
    pub noise: f64,
    /// Half the width of a 95 % interval, in standard deviations.
    pub reach: f64,
}

/// How far one unknown may go.
pub struct Profile {
    /// Lower end; None where the sum is not seen to rise.
    pub low: Option<f64>,
    /// Upper end; None where the sum is not seen to rise.
    pub high: Option<f64>,
    /// Points that the data allow, each with all unknowns.
    pub points: Vec<Vec<f64>>,
}

/// One unknown on its way outwards.
struct Walk {
    j: usize,
    /// 1 upwards, -1 downwards.
    side: f64,
    /// The points that the data allow so far, the minimum first.
    trail: Vec<Vec<f64>>,
}

/// What the others make of a value.
struct Tried {
    /// √(rise of the sum over the noise).
    rise: f64,
    /// Whether the sum may not be lower.
    is_sure: bool,
    /// All unknowns there; None where nothing can be computed.
    point: Option<Vec<f64>>,
}

/// Singular values and vectors of the columns of length one.
pub struct Directions {
    /// 1 over the length of each column; 0 where it vanishes.
    pub scale: Vec<f64>,
    /// Singular values with their vectors.
    pub all: Vec<(f64, Vec<f64>)>,
    /// How many of the last are weak: along them a parameter may go as far as its own size.
    pub weak: usize,
}

impl Directions {
    /// Unknowns that take part in a weak direction.
    pub fn trading(&self) -> Vec<usize> {
        let weak = &self.all[self.all.len() - self.weak..];
        let takes_part = |j: &usize| {
            weak.iter().any(|(_, v)| {
                let most = v.iter().fold(0.0, |m: f64, w| m.max(w.abs()));
                v[*j].abs() >= PART * most
            })
        };
        (0..self.scale.len()).filter(takes_part).collect()
    }

    /// Variance of one unknown when all others move, in units of the noise; 0 of one that nothing shows.
    pub fn variance_along(&self, j: usize) -> f64 {
        self.all.iter().map(|(s, v)| (v[j] * self.scale[j] / s).powi(2)).sum()
    }

    /// Variance of a linear form in the unknowns, weak directions left out, in units of the noise.
    pub fn variance_of(&self, gradient: &[f64]) -> f64 {
        let firm = &self.all[..self.all.len() - self.weak];
        let along = |v: &[f64]| -> f64 { (0..v.len()).map(|j| gradient[j] * self.scale[j] * v[j]).sum() };
        firm.iter().map(|(s, v)| (along(v) / s).powi(2)).sum()
    }
}

impl Valley<'_> {
    /// The directions about the minimum; None where they cannot be computed.
    pub fn directions(&self) -> Option<Directions> {
        let norms = self.triangle.column_norms();
        let scale: Vec<f64> = norms.iter().map(|n| if *n > 0.0 { 1.0 / n } else { 0.0 }).collect();
        let alive: Vec<usize> = (0..scale.len()).filter(|j| scale[*j] > 0.0).collect();
        if alive.is_empty() || !norms.iter().all(|n| n.is_finite()) {
            return None;
        }
        let small = self.triangle.restricted(&alive, &vec![0.0; scale.len()]);
        let own: Vec<f64> = alive.iter().map(|j| scale[*j]).collect();
        let svd = small.scaled(&own).factor().thin_svd().ok()?;
        let v = svd.V();
        let all: Vec<(f64, Vec<f64>)> = svd
            .S()
            .column_vector()
            .iter()
            .enumerate()
            .map(|(k, s)| {
                let mut whole = vec![0.0; scale.len()];
                alive.iter().enumerate().for_each(|(i, j)| whole[*j] = v[(i, k)]);
                (s.max(1e-12), whole)
            })
            .collect();
        let weak = all.iter().rev().take_while(|(s, v)| self.is_weak(*s, v, &scale)).count();
        Some(Directions { scale, all, weak })
    }

    fn is_weak(&self, s: f64, v: &[f64], scale: &[f64]) -> bool {
        let most = v.iter().fold(0.0, |m: f64, w| m.max(w.abs()));
        let far = |j: usize| {
            let moved = self.noise.sqrt() * v[j].abs() * scale[j] / s;
            v[j].abs() >= PART * most && self.is_something(j) && moved > BENT * self.x[j].abs()
        };
        let trades = v.iter().filter(|w| w.abs() >= PART * most).count() > 1;
        trades && (s < NULL || (0..self.problem.free.len()).any(far))
    }

    /// Whether an unknown of one sign is so uncertain, or so near to nothing, that no parabola serves.
    pub fn is_bent(&self, j: usize, directions: &Directions) -> bool {
        let deviation = (self.noise * directions.variance_along(j)).sqrt();
        let has_one_sign = self.ranges[j].min >= 0.0 && self.x[j] > 0.0;
        has_one_sign && self.is_something(j) && deviation > BENT * self.x[j]
    }

    /// Whether an unknown differs from 0 by more than the noise, were all others known. Such a one is
    /// followed by factors: beyond 0 lies another valley, if any.
    fn is_something(&self, j: usize) -> bool {
        self.x[j].abs() * self.triangle.column_norms()[j] > self.reach * self.noise.sqrt()
    }

    /// The profile of one unknown.
    pub fn profile(&self, j: usize) -> Profile {
        let mut points = vec![self.x.to_vec()];
        let [low, high] = [-1.0, 1.0].map(|side| self.end(j, side, &mut points));
        Profile { low, high, points }
    }

    /// One end of an interval: the unknown's own bound, or a value at which the sum is surely larger than the
    /// noise allows.
    fn end(&self, j: usize, side: f64, points: &mut Vec<Vec<f64>>) -> Option<f64> {
        let mut walk = Walk { j, side, trail: vec![self.x.to_vec()] };
        let (mut inside, mut rise) = (0.0, 0.0);
        let mut step = self.first_step(j);
        for _ in 0..STEPS {
            let u = inside + step;
            let x = self.outward(&walk, u);
            if walk.trail.last().is_some_and(|p| p[j] == x) {
                return Some(x);
            }
            let tried = self.refit(&walk, x);
            let Some(point) = tried.point.filter(|_| tried.rise <= self.reach) else {
                let outside = Tried { point: None, ..tried };
                return self.close_in(&mut walk, ((inside, rise), (u, outside)), points);
            };
            points.push(point.clone());
            walk.trail.push(point);
            (inside, rise) = (u, tried.rise);
            if self.is_something(j) && u >= FAR {
                return None;
            }
            step = if self.is_something(j) { (2.0 * step).min(1.2) } else { 3.0 * step };
        }
        None
    }

    /// The value of the moved unknown so far out.
    fn outward(&self, walk: &Walk, u: f64) -> f64 {
        let (x, u) = (self.x[walk.j], walk.side * u);
        self.ranges[walk.j].clamp(if self.is_something(walk.j) { x * (u * x.signum()).exp() } else { x + u })
    }

    /// Far enough to see a rise where the others stay, near enough for them to follow.
    fn first_step(&self, j: usize) -> f64 {
        let norm = self.triangle.column_norms()[j];
        let alone = 2.0 * self.reach * self.noise.sqrt() / norm;
        if self.is_something(j) { (alone / self.x[j].abs()).clamp(0.02, 0.5) } else { alone }
    }

    /// The lowest minimum with one unknown held at a value, from several starts while it is too high; nothing once the
    /// steps are spent.
    fn refit(&self, walk: &Walk, x: f64) -> Tried {
        let mut ranges = self.ranges.to_vec();
        ranges[walk.j] = Range { min: x, max: x };
        let stopping = Stopping { iterations: 40, reduction: 1e-7, step: 1e-10 };
        let mut best = Tried { rise: f64::INFINITY, is_sure: false, point: None };
        for start in self.starts(walk, x) {
            if self.problem.budget.over().is_some() {
                break;
            }
            let Ok(found) = minimise(self.problem, &start, &ranges, stopping) else { continue };
            let rise = ((found.sum_of_squares - self.sum).max(0.0) / self.noise).sqrt();
            if rise < best.rise {
                best = Tried { rise, is_sure: self.is_sure(&found), point: Some(found.x) };
            }
            if best.rise <= self.reach {
                break;
            }
        }
        best
    }

    /// Whether a sum may not be lower: at rest, and no hidden state held back by what is allowed to it here.
    fn is_sure(&self, found: &Minimum) -> bool {
        let rests = matches!(found.end, End::Converged | End::Stalled);
        rests && found.at_bound.iter().skip(self.problem.free.len()).all(Option::is_none)
    }

    /// Where the others are expected: on the line through the last two points, by factors (along which
    /// products stay the same) and as they stand, or still where they are.
    fn starts(&self, walk: &Walk, x: f64) -> Vec<Vec<f64>> {
        let mut still = walk.trail.last().map_or_else(|| self.x.to_vec(), Clone::clone);
        still[walk.j] = x;
        let [.., before, last] = walk.trail.as_slice() else {
            return vec![self.tangent(walk.j, x), still];
        };
        let lead = |by_factors: bool| {
            let inner = |k: usize, x: f64| {
                let one_sign = before[k] * last[k] > 0.0 && x * last[k] > 0.0;
                if by_factors && one_sign { (x / last[k]).ln() } else { x - last[k] }
            };
            let share = -inner(walk.j, x) / inner(walk.j, before[walk.j]);
            let follow = |k: usize| {
                let moved = share * inner(k, before[k]);
                let by_factor = by_factors && before[k] * last[k] > 0.0;
                let on = if by_factor { last[k] * moved.exp() } else { last[k] + moved };
                self.ranges[k].clamp(if on.is_finite() { on } else { last[k] })
            };
            (0..last.len()).map(|k| if k == walk.j { x } else { follow(k) }).collect()
        };
        vec![lead(true), lead(false), still]
    }

    /// Where the linear problem puts the others.
    fn tangent(&self, j: usize, x: f64) -> Vec<f64> {
        let others: Vec<usize> = (0..self.x.len()).filter(|k| *k != j).collect();
        let mut step = vec![0.0; self.x.len()];
        step[j] = x - self.x[j];
        let norms = self.triangle.column_norms();
        let damping: Vec<f64> = others.iter().map(|k| 1e-6 * norms[*k].max(f64::MIN_POSITIVE)).collect();
        let solved = self.triangle.restricted(&others, &step).solve(&damping);
        let mut start = self.x.to_vec();
        start[j] = x;
        for (k, d) in others.iter().zip(solved) {
            let far = if self.is_something(*k) { 0.5 * self.x[*k].abs() } else { f64::INFINITY };
            start[*k] =
                self.ranges[*k].clamp(self.x[*k] + if d.is_finite() { d.clamp(-far, far) } else { 0.0 });
        }
        start
    }

    /// The end of an interval between a point inside and one outside, by secants and halves: the nearest
    /// value found outside, if that is surely outside.
    fn close_in(
        &self,
        walk: &mut Walk,
        (mut inside, mut outside): ((f64, f64), (f64, Tried)),
        points: &mut Vec<Vec<f64>>,
    ) -> Option<f64> {
        for k in 0..CLOSER {
            let (u, tried) = &outside;
            if tried.rise <= NEAR * self.reach && tried.is_sure {
                break;
            }
            let aim = 0.5 * (1.0 + NEAR) * self.reach;
            let secant = ((aim - inside.1) / (tried.rise - inside.1)).clamp(0.1, 0.9);
            let share = if k % 2 == 0 && tried.rise.is_finite() { secant } else { 0.5 };
            let u = inside.0 + share * (u - inside.0);
            let tried = self.refit(walk, self.outward(walk, u));
            if tried.rise > self.reach {
                outside = (u, tried);
            } else if let Some(found) = tried.point {
                inside = (u, tried.rise);
                points.push(found.clone());
                walk.trail.push(found);
            }
        }
        outside.1.is_sure.then(|| self.outward(walk, outside.0))
    }
}
