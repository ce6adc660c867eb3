//! Functions that other people's code computes: several results of one list of arguments.
//!
//! In text such a result is `fmu(k, t, x, …)`: result k of the unit that the model names, at the time, the states, the
//! inputs and the parameters. Its code is loaded once a process; a number stands for it in expressions.

use crate::units::Unit;
use std::cell::Cell;
use std::sync::{Arc, PoisonError, RwLock};

/// The name under which a result stands in text.
pub(crate) const NAME: &str = "fmu";

/// One result of code that is loaded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Foreign {
    code: u16,
    /// Number of the result.
    pub(crate) result: u16,
}

/// What can be asked of such code; everything in SI.
pub(crate) trait Compute: Send + Sync {
    /// How many arguments it takes.
    fn arguments(&self) -> usize;
    /// The unit of each result.
    fn units(&self) -> &[Unit];
    /// A result; NaN where the code refuses.
    fn value(&self, arguments: &[f64], result: usize) -> f64;
    /// The derivative of a result by an argument.
    fn slope(&self, arguments: &[f64], result: usize, argument: usize) -> f64;
    /// The states that it starts with at parameters, its inputs as they are described or all of them 1 more; why not,
    /// where it refuses.
    fn starts(&self, parameters: &[f64], is_moved: bool) -> std::result::Result<Vec<f64>, String>;
    /// The rates there at t = 0, the inputs likewise.
    fn rates(&self, states: &[f64], parameters: &[f64], is_moved: bool) -> Vec<f64>;
    /// Why it refused a value, since this was asked last.
    fn refusal(&self) -> Option<String>;
    /// Whether it is the same code with the same arguments.
    fn is(&self, key: &str) -> bool;
}

static LOADED: RwLock<Vec<Arc<dyn Compute>>> = RwLock::new(Vec::new());

thread_local! {
    static SPOKEN_OF: Cell<Option<u16>> = const { Cell::new(None) };
}

/// The code of a key, made where it is not loaded yet.
pub(crate) fn loaded(key: &str, make: impl FnOnce() -> Arc<dyn Compute>) -> u16 {
    let mut all = LOADED.write().unwrap_or_else(PoisonError::into_inner);
    let at = all.iter().position(|c| c.is(key)).unwrap_or_else(|| {
        all.push(make());
        all.len() - 1
    });
    u16::try_from(at).unwrap_or(u16::MAX)
}

/// While it lives, text on this thread speaks of the results of some code.
pub(crate) struct Speaking(Option<u16>);

impl Speaking {
    pub(crate) fn of(code: Option<u16>) -> Self {
        Self(SPOKEN_OF.replace(code))
    }
}

impl Drop for Speaking {
    fn drop(&mut self) {
        SPOKEN_OF.set(self.0);
    }
}

impl Foreign {
    /// A result of the code that text on this thread speaks of.
    pub(super) fn spoken_of(result: u16) -> Option<Self> {
        let found = Self { code: SPOKEN_OF.get()?, result };
        (usize::from(result) < found.compute()?.units().len()).then_some(found)
    }

    /// A result of loaded code.
    pub(crate) fn of(code: u16, result: u16) -> Self {
        Self { code, result }
    }

    /// The number of its code.
    pub(crate) fn code(self) -> u16 {
        self.code
    }

    /// The code.
    pub(crate) fn compute(self) -> Option<Arc<dyn Compute>> {
        LOADED.read().unwrap_or_else(PoisonError::into_inner).get(usize::from(self.code)).cloned()
    }

    /// The unit of the result.
    pub(crate) fn unit(self) -> Unit {
        let unit = self.compute().and_then(|c| c.units().get(usize::from(self.result)).cloned());
        unit.unwrap_or_else(Unit::one)
    }

    /// How many arguments it takes.
    pub(super) fn arity(self) -> usize {
        self.compute().map_or(0, |c| c.arguments())
    }
}
