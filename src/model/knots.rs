//! The knots of a `curve` or `surface`: their places rise, and none is fitted.

use super::Model;
use crate::expression::{Expr, Function};
use crate::{Error, Result};

impl Model {
    /// Checks the places of the knots of every curve in an expression.
    ///
    /// # Errors
    /// The first place that does not rise, or that a fit would move.
    pub(super) fn rising_knots(&self, e: &Expr) -> Result<()> {
        let mut fault = None;
        e.visit(&mut |part| {
            if let Expr::Call(Function::Curve, arguments) = part {
                let places: Vec<&Expr> = arguments[1..].iter().step_by(2).collect();
                fault = fault.take().or_else(|| self.fault_of(&places));
            }
            if let Expr::Call(Function::Surface(n, m), arguments) = part {
                let (along, rest) = arguments[2..].split_at(usize::from(*n));
                for places in [along, &rest[..usize::from(*m)]] {
                    let places: Vec<&Expr> = places.iter().collect();
                    fault = fault.take().or_else(|| self.fault_of(&places));
                }
            }
        });
        fault.map_or(Ok(()), Err)
    }

    fn fault_of(&self, places: &[&Expr]) -> Option<Error> {
        let fitted =
            self.parameters.iter().filter(|p| p.fit).find(|p| places.iter().any(|e| e.mentions(&p.name)));
        if let Some(p) = fitted {
            let message = format!("a knot of a curve or surface stands at {}, which is fitted", p.name);
            return Some(
                Error::bad_input(message).with_hint("fit the values at the knots, and fix their places"),
            );
        }
        let lookup = |name: &str| self.parameters.iter().find(|p| p.name == name).map(|p| p.value);
        let value = |e: &Expr| e.value(&lookup);
        places
            .windows(2)
            .find(|w| value(w[0]).zip(value(w[1])).is_some_and(|(a, b)| a >= b || b.is_nan()))
            .map(|w| {
                Error::bad_input(format!(
                    "the knots of a curve or surface must rise, but {} stands before {}",
                    w[0], w[1]
                ))
                .with_hint("curve(x, x1, y1, x2, y2, …): x1 < x2 < …")
            })
    }
}
