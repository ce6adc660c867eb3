//! The bilinear surface through knots as nodes of the graph; `expression::surface` has its values.

use super::build::Builder;
use super::graph::{Id, Level};
use crate::{Error, Result};

impl Builder<'_> {
    /// surface(x, y, [x…], [y…], [z…]): along x for each y, and then along y,
    /// z = z₁ + (x − x₁)(z₂ − z₁)/(x₂ − x₁) between the knots around x. Its slope leaps at a knot, which is an event.
    pub(super) fn surface(&mut self, x: Id, y: Id, n: usize, knots: &[Id]) -> Result<Id> {
        if knots.iter().any(|k| self.graph.levels[*k] > Level::Run) {
            return Err(Error::bad_input(
                "the knots of surface(x, y, […], […], […]) must not change during a run",
            )
            .with_hint("make them numbers, parameters or expressions of parameters"));
        }
        let (along, rest) = knots.split_at(n);
        let (across, values) = rest.split_at(rest.len() / (n + 1));
        let m = across.len();
        let rows: Vec<Id> = (0..m)
            .map(|j| {
                let row: Vec<Id> = (0..n).map(|i| values[i * m + j]).collect();
                self.straight(x, along, &row)
            })
            .collect();
        Ok(self.straight(y, across, &rows))
    }

    /// The line from knot to knot, straight beyond them.
    fn straight(&mut self, x: Id, at: &[Id], y: &[Id]) -> Id {
        let g = &mut self.graph;
        let mut piece: Option<[Id; 3]> = None;
        for k in 0..at.len() - 1 {
            let (rise, width) = (g.difference(y[k + 1], y[k]), g.difference(at[k + 1], at[k]));
            let next = [at[k], y[k], g.quotient(rise, width)];
            piece = Some(match piece {
                None => next,
                Some(now) => {
                    let ahead = g.difference(x, at[k]);
                    let side = g.side(ahead);
                    std::array::from_fn(|i| g.select(side, next[i], now[i]))
                }
            });
        }
        let Some([from, value, slope]) = piece else { return x };
        let r = g.difference(x, from);
        let part = g.product(r, slope);
        g.sum(value, part)
    }
}
