//! The force balance along the parallel with inertia, as a linear system between the events of friction and free play.
//!
//! States: v = ẋ_v; x₁; x₂ of a flow; those of what swings [`inside`](super::inside). Behind them W₁, its rate, and a steady force K in the
//! element of x₁, so that a row speaks of all that a quantity depends on.

use super::inside::Inside;
use crate::gyro::Gyrosphere;
use crate::gyro::elastic::part::positive;
use crate::gyro::elastic::suspension::{Flow, Suspension};
use crate::lti::StateSpace;
use crate::lti::poles;
use crate::{Error, Result};
use faer::Mat;

const SPEED: usize = 0;
/// Place of x₂, where there is a flow.
const FLOW: usize = 2;
/// Place of x₁ among the states.
pub(super) const GIVE: usize = 1;

/// A quantity over the states, W₁, Ẇ₁ and K.
pub(super) type Row = Vec<f64>;

/// r, c and what stands in series and inside.
#[derive(Debug, Clone, Copy)]
pub(super) struct Balance {
    /// m, kg.
    pub mass: f64,
    /// r, N·s/m, of the element of x₁.
    pub viscous: f64,
    /// c, N/m, of the element of x₁.
    pub spring: f64,
    /// C₀, N/m.
    pub stiffness: f64,
    pub flow: Option<Flow>,
    pub inside: Inside,
}

/// The balance between two events: rates of all that a [`Row`] runs over, ẋ₁ and f.
#[derive(Debug, Clone)]
pub(super) struct Mode {
    pub rates: Vec<Row>,
    pub speed: Row,
    pub force: Row,
}

impl Balance {
    /// # Errors
    /// `BadInput` for numbers that describe no such suspension.
    pub fn new(s: &Gyrosphere, suspension: &Suspension) -> Result<Self> {
        let (m, c) = (s.weight / s.gravity, s.stiffness);
        positive(&[("m", m), ("T", s.lag), ("C0", c)])?;
        sound(suspension)?;
        // what gives nothing is not there
        let flow = suspension.flow.filter(|f| f.share != 0.0);
        let inside = Inside::new(s, suspension)?;
        let balance = Self { mass: m, viscous: s.lag * c, spring: c, stiffness: c, flow, inside };
        balance.check(suspension.friction.is_some_and(|f| f > 0.0))?;
        Ok(balance)
    }

    /// A liquid that runs against the force hands it on to friction, or drives itself.
    fn check(&self, rubs: bool) -> Result<()> {
        let Some(flow) = self.flow.filter(|f| f.share < 0.0) else { return Ok(()) };
        if rubs {
            return Err(Error::bad_input(
                "liquid that runs against the force, of a negative share, cannot stand in series with dry friction: \
                 while the friction holds, the liquid alone would carry the force and drive itself",
            )
            .with_hint("take a positive share, or leave the friction away"));
        }
        let part = self.moving_part()?;
        let poles = poles(&part.a, "suspension")?;
        // T₂ + κ T > 0: at high frequencies the suspension still holds
        if flow.time + flow.share * self.viscous / self.stiffness > 0.0 && poles.iter().all(|p| p.re < 0.0) {
            return Ok(());
        }
        Err(Error::bad_input(format!(
            "liquid of the share {} runs against the force so much that with inertia the suspension drives itself",
            flow.share
        ))
        .with_hint("take a share nearer to 0, or leave the inertia away"))
    }

    /// Number of states.
    pub fn order(&self) -> usize {
        self.inside_at() + self.inside.order()
    }

    /// Place of W₁ in a row; its rate and K follow.
    pub fn driven(&self) -> usize {
        self.order()
    }

    /// Whether a flow lets the vessel give way while friction holds x₁.
    pub fn flows(&self) -> bool {
        self.flow.is_some()
    }

    /// Place of the first state of what swings inside.
    fn inside_at(&self) -> usize {
        2 + usize::from(self.flow.is_some())
    }

    fn row(&self, entries: &[(usize, f64)]) -> Row {
        let mut row = vec![0.0; self.order() + 3];
        for (at, value) in entries {
            row[*at] += value;
        }
        row
    }

    /// x = x₁ + x₂ + what swings inside.
    pub fn give(&self) -> Row {
        let mut row = self.row(&self.inside.give(self.inside_at()));
        row[GIVE] = 1.0;
        if self.flow.is_some() {
            row[FLOW] = 1.0;
        }
        row
    }

    /// What springs and dashpots inside pull the vessel with, a unit of m.
    fn pull(&self) -> Row {
        self.row(&self.inside.pull(self.inside_at()))
    }

    /// ẋ₁ ≠ 0.
    pub fn moving(&self) -> Mode {
        // f = r(v − ẋ₂) + c x₁ + K with ẋ₂ = (κ f/C₀ − x₂)/T₂
        let (series, flow) =
            self.flow.map_or((0.0, None), |f| (f.share / (self.stiffness * f.time), Some(f)));
        let scale = 1.0 / (1.0 + self.viscous * series);
        let k = self.driven() + 2;
        let mut force = self.row(&[(SPEED, self.viscous * scale), (GIVE, self.spring * scale), (k, scale)]);
        if let Some(flow) = flow {
            force[FLOW] += self.viscous * scale / flow.time;
        }
        self.mode(force, false)
    }

    /// ẋ₁ = 0, held by friction.
    pub fn stuck(&self) -> Mode {
        let force = if let Some(flow) = self.flow {
            // v = ẋ₂
            let unit = self.stiffness / flow.share;
            self.row(&[(SPEED, unit * flow.time), (FLOW, unit)])
        } else {
            // v̇ = 0
            let mut row = self.row(&[(self.driven(), self.mass * (1.0 - self.inside.share()))]);
            add(&mut row, self.mass, &self.pull());
            row
        };
        self.mode(force, true)
    }

    fn mode(&self, force: Row, sticks: bool) -> Mode {
        let (w, share) = (self.driven(), self.inside.share());
        let mut rates = vec![self.row(&[]); self.order() + 3];
        // (1 − σ) m v̇ = (1 − σ) m W₁ − f + m p
        let held = sticks && self.flow.is_none();
        if !held {
            rates[SPEED][w] = 1.0;
            add(&mut rates[SPEED], -1.0 / ((1.0 - share) * self.mass), &force);
            add(&mut rates[SPEED], 1.0 / (1.0 - share), &self.pull());
        }
        let mut speed = self.row(&[(SPEED, 1.0)]);
        if let Some(flow) = self.flow {
            // T₂ ẋ₂ = κ f/C₀ − x₂
            let mut rate = self.row(&[(FLOW, -1.0 / flow.time)]);
            add(&mut rate, flow.share / (self.stiffness * flow.time), &force);
            add(&mut speed, -1.0, &rate);
            rates[FLOW] = rate;
        }
        if !sticks {
            rates[GIVE].clone_from(&speed);
        }
        // W₁ − v̇ drives what swings inside
        let mut bare = self.row(&[(w, 1.0)]);
        add(&mut bare, -1.0, &rates[SPEED]);
        for (place, drive, own) in self.inside.rates(self.inside_at()) {
            rates[place] = self.row(&own);
            add(&mut rates[place], drive, &bare);
        }
        rates[w][w + 1] = 1.0;
        Mode { rates, speed, force }
    }

    /// From W₁ to rows, over the states kept.
    fn part(&self, mode: &Mode, keep: &[usize], rows: &[&Row]) -> Result<StateSpace> {
        let n = keep.len();
        StateSpace::new(
            Mat::from_fn(n, n, |i, j| mode.rates[keep[i]][keep[j]]),
            Mat::from_fn(n, 1, |i, _| mode.rates[keep[i]][self.driven()]),
            Mat::from_fn(rows.len(), n, |i, j| rows[i][keep[j]]),
            Mat::zeros(rows.len(), 1),
        )
    }

    /// From W₁ to x.
    pub fn moving_part(&self) -> Result<StateSpace> {
        let all: Vec<usize> = (0..self.order()).collect();
        self.part(&self.moving(), &all, &[&self.give()])
    }

    /// From W₁ to x₁ and ẋ₁.
    pub fn element(&self) -> Result<StateSpace> {
        let all: Vec<usize> = (0..self.order()).collect();
        let mode = self.moving();
        self.part(&mode, &all, &[&self.row(&[(GIVE, 1.0)]), &mode.speed])
    }

    /// From W₁ to x while friction holds x₁ = 0.
    pub fn stuck_part(&self) -> Result<StateSpace> {
        let held = if self.flow.is_some() { &[GIVE][..] } else { &[SPEED, GIVE] };
        let keep: Vec<usize> = (0..self.order()).filter(|i| !held.contains(i)).collect();
        if keep.is_empty() {
            let mut part = self.moving_part()?;
            part.c = Mat::zeros(1, part.order());
            return Ok(part);
        }
        self.part(&self.stuck(), &keep, &[&self.give()])
    }
}

/// Refuses numbers of no part.
fn sound(suspension: &Suspension) -> Result<()> {
    if let Some(flow) = &suspension.flow {
        positive(&[("T2", flow.time)])?;
    }
    for (value, what) in [(suspension.friction, "friction force"), (suspension.gap, "free play")] {
        if value.is_some_and(|v| !(v.is_finite() && v >= 0.0)) {
            return Err(Error::bad_input(format!("the {what} must not be negative")));
        }
    }
    Ok(())
}

fn add(to: &mut Row, factor: f64, row: &Row) {
    to.iter_mut().zip(row).for_each(|(a, b)| *a += factor * b);
}
