//! Turns or radians, term by term: an angular speed is never added to what counts events, nor given for it.

use super::dimension::{Fault, shown, within};
use super::{BinaryOp, Expr, Function};
use crate::Result;
use crate::units::{Turning, Unit};
use std::collections::BTreeMap;

/// The units of the names that an expression may use.
pub type Units<'a> = BTreeMap<&'a str, &'a Unit>;

/// The unit that a value keeps through sums; `None` where it counts nothing, or where a product hides what it does.
type Kept<'a> = Option<&'a Unit>;

impl Expr {
    /// Checks that the terms of every sum count the same, and the whole what the wanted unit does. A product asks
    /// nothing: `2*pi*f` is how the one becomes the other.
    ///
    /// # Errors
    /// The question whether turns or radians are meant; it shows `text`, which must be what the expression was
    /// read from.
    pub fn expect_turning(&self, wanted: &Unit, units: &Units<'_>, text: &str) -> Result<()> {
        let whole = kept(self, units).and_then(|found| meet(counting(wanted), found));
        whole.map(|_| ()).map_err(|fault| shown(&fault, text))
    }
}

fn counting(unit: &Unit) -> Kept<'_> {
    (unit.turning() != Turning::Open).then_some(unit)
}

fn kept<'a>(e: &Expr, units: &Units<'a>) -> Result<Kept<'a>, Fault> {
    match e {
        Expr::Name(name) => Ok(units.get(name.as_str()).and_then(|unit| counting(unit))),
        Expr::Neg(a) => within(0, kept(a, units)),
        Expr::Binary(op, a, b) => {
            let (left, right) = (within(0, kept(a, units))?, within(1, kept(b, units))?);
            match op {
                BinaryOp::Add | BinaryOp::Sub => within(1, meet(left, right)),
                _ => Ok(None),
            }
        }
        Expr::Call(function, arguments) => {
            let mut all = Vec::with_capacity(arguments.len());
            for (i, a) in arguments.iter().enumerate() {
                all.push(within(i, kept(a, units))?);
            }
            of_call(*function, &all)
        }
        Expr::Number(_) => Ok(None),
    }
}

fn of_call<'a>(function: Function, all: &[Kept<'a>]) -> Result<Kept<'a>, Fault> {
    match function {
        Function::Abs | Function::Delay | Function::Lag | Function::RateLimit => Ok(all[0]),
        Function::Min
        | Function::Max
        | Function::Clamp
        | Function::Backlash
        | Function::Hysteresis
        | Function::Atan2
        | Function::Relay => {
            let mut whole = all[0];
            for (i, other) in all.iter().enumerate().skip(1) {
                whole = within(i, meet(whole, *other))?;
            }
            Ok(whole.filter(|_| !matches!(function, Function::Atan2 | Function::Relay)))
        }
        _ => Ok(None),
    }
}

/// The unit of two terms that stand together. Inside a model a turn is 2π rad without a question.
fn meet<'a>(one: Kept<'a>, other: Kept<'a>) -> Result<Kept<'a>, Fault> {
    let events = |unit: &Unit| unit.turning() == Turning::Events;
    if let (Some(a), Some(b)) = (one, other)
        && events(a) != events(b)
        && let Err(e) = a.turns_or_radians(b)
    {
        let (message, hint) = (e.message().to_owned(), e.hint().map(str::to_owned));
        return Err(Fault { path: Vec::new(), message, hint });
    }
    Ok(one.or(other))
}
