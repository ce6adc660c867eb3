//! Calls of other people's code from a program.

use crate::expression::foreign::Compute;
use crate::model::scalar::Scalar;
use std::cell::RefCell;
use std::sync::Arc;

/// A call with the registers of its arguments.
#[derive(Clone)]
pub(crate) struct Call {
    pub code: Arc<dyn Compute>,
    /// Their registers.
    pub arguments: Vec<u16>,
}

impl std::fmt::Debug for Call {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Call").field("arguments", &self.arguments).finish_non_exhaustive()
    }
}

thread_local! {
    static ROOM: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
}

impl Call {
    /// A result, or its derivative by an argument. A result has the tangents Σ ∂f/∂aⱼ·ȧⱼ; a derivative has none.
    pub fn result<T: Scalar>(&self, which: usize, by: Option<usize>, r: &[T]) -> T {
        let mut room = ROOM.take();
        room.clear();
        room.extend(self.arguments.iter().map(|a| r[usize::from(*a)].value()));
        let result = match by {
            Some(by) => T::constant(self.code.slope(&room, which, by)),
            None => self.with_tangents(&room, which, r),
        };
        ROOM.replace(room);
        result
    }

    fn with_tangents<T: Scalar>(&self, at: &[f64], which: usize, r: &[T]) -> T {
        let mut sum = T::constant(self.code.value(at, which));
        for (j, a) in self.arguments.iter().enumerate() {
            let a = r[usize::from(*a)];
            if (0..T::TANGENTS).any(|k| a.tangent(k) != 0.0) {
                sum += a.chain(0.0, self.code.slope(at, which, j));
            }
        }
        sum
    }
}
