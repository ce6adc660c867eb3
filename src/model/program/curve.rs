//! The monotone cubic through knots as nodes of the graph; `expression::curve` has its values.

use super::build::Builder;
use super::graph::{Id, Level};
use crate::{Error, Result};

/// A piece: where it is counted from, and its value, slope and two more coefficients there.
type Piece = [Id; 5];

impl Builder<'_> {
    /// curve(x, x₁, y₁, x₂, y₂, …). Its value and slope are continuous, so that its pieces need no event.
    pub(super) fn curve(&mut self, x: Id, knots: &[Id]) -> Result<Id> {
        let (at, y): (Vec<Id>, Vec<Id>) = knots.chunks(2).map(|k| (k[0], k[1])).unzip();
        if knots.iter().any(|k| self.graph.levels[*k] > Level::Run) {
            return Err(Error::bad_input("the knots of curve(x, x1, y1, …) must not change during a run")
                .with_hint("make them numbers, parameters or expressions of parameters"));
        }
        let pieces = self.pieces(&at, &y);
        let mut piece = pieces[0];
        for (k, next) in pieces.iter().enumerate().skip(1) {
            let ahead = self.graph.difference(x, at[k - 1]);
            let side = self.graph.side(ahead);
            for (now, next) in piece.iter_mut().zip(next) {
                *now = self.graph.select(side, *next, *now);
            }
        }
        let [from, value, slope, second, third] = piece;
        // y + r (m + r (c + r e)),  r = x − x₁
        let g = &mut self.graph;
        let r = g.difference(x, from);
        let mut sum = third;
        for coefficient in [second, slope, value] {
            let part = g.product(r, sum);
            sum = g.sum(coefficient, part);
        }
        Ok(sum)
    }

    /// The straight piece before the knots, those between them, and the straight one behind.
    fn pieces(&mut self, at: &[Id], y: &[Id]) -> Vec<Piece> {
        let n = at.len();
        let zero = self.graph.constant(0.0);
        let g = &mut self.graph;
        let widths: Vec<Id> = at.windows(2).map(|w| g.difference(w[1], w[0])).collect();
        let rises: Vec<Id> = y.windows(2).map(|w| g.difference(w[1], w[0])).collect();
        let chords: Vec<Id> = rises.iter().zip(&widths).map(|(d, h)| g.quotient(*d, *h)).collect();
        let mut slopes = vec![chords[0]];
        for k in 1..n - 1 {
            slopes.push(self.slope([widths[k - 1], widths[k]], [chords[k - 1], chords[k]]));
        }
        slopes.push(chords[n - 2]);
        let mut all = vec![[at[0], y[0], slopes[0], zero, zero]];
        for k in 0..n - 1 {
            let (second, third) = self.bends(widths[k], chords[k], [slopes[k], slopes[k + 1]]);
            all.push([at[k], y[k], slopes[k], second, third]);
        }
        all.push([at[n - 1], y[n - 1], slopes[n - 1], zero, zero]);
        all
    }

    /// m = 3 (h₁ + h₂) d₁ d₂/((2h₂ + h₁) d₂ + (h₂ + 2h₁) d₁) where d₁ d₂ > 0, else 0.
    fn slope(&mut self, [before, after]: [Id; 2], [a, b]: [Id; 2]) -> Id {
        let g = &mut self.graph;
        let product = g.product(a, b);
        let rising = g.side(product);
        let both = g.sum(before, after);
        let (first, second) = (g.sum(both, after), g.sum(both, before));
        let (first, second) = (g.product(first, b), g.product(second, a));
        let below = g.sum(first, second);
        let three = g.constant(3.0);
        let above = g.product(three, both);
        let above = g.product(above, product);
        let mean = g.quotient(above, below);
        let zero = g.constant(0.0);
        g.select(rising, mean, zero)
    }

    /// (3d − 2m₁ − m₂)/h and (m₁ + m₂ − 2d)/h².
    fn bends(&mut self, h: Id, chord: Id, [first, last]: [Id; 2]) -> (Id, Id) {
        let g = &mut self.graph;
        let (from_first, from_last) = (g.difference(chord, first), g.difference(chord, last));
        let both = g.sum(from_first, from_last);
        let second = g.sum(both, from_first);
        let (second, bend) = (g.quotient(second, h), g.quotient(both, h));
        let bend = g.negative(bend);
        (second, g.quotient(bend, h))
    }
}
