//! Long work: in a thread of its own, while the calling one answers to Ctrl-C.

use super::fault::PyResult;
use gyrospec::Progress;
use gyrospec::{Error, Result};
use pyo3::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

/// Between two looks at the keyboard.
const PATIENCE: Duration = Duration::from_millis(50);

/// As much stack as a program's main thread has.
const STACK: usize = 8 << 20;

/// Breaks the work off at its next step once nobody waits for it.
struct Listener(Arc<AtomicBool>);

/// What the thread of abandoned work ends with.
struct Abandoned;

impl Progress for Listener {
    fn report(&self, _stage: &str, _share: Option<f64>) {
        if self.0.load(Ordering::Relaxed) {
            resume_unwind(Box::new(Abandoned));
        }
    }
}

/// Does the work without Python's lock. An interrupt is answered at once; the work itself ends at
/// its next step.
pub fn patiently<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&dyn Progress) -> Result<T> + Send + 'static,
) -> PyResult<T> {
    let stop = Arc::new(AtomicBool::new(false));
    let (sender, mut receiver) = channel();
    let listener = Listener(Arc::clone(&stop));
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(move || {
        let done = catch_unwind(AssertUnwindSafe(|| work(&listener)));
        // nobody listens any more after an interrupt
        let _ = sender.send(done.unwrap_or_else(|_| Err(broken())));
    });
    thread.map_err(PyErr::from)?;
    loop {
        let waiting = &mut receiver;
        match py.detach(move || waiting.recv_timeout(PATIENCE)) {
            Ok(done) => return Ok(done?),
            Err(RecvTimeoutError::Disconnected) => return Err(broken().into()),
            Err(RecvTimeoutError::Timeout) => {
                if let Err(interrupt) = py.check_signals() {
                    stop.store(true, Ordering::Relaxed);
                    return Err(interrupt.into());
                }
            }
        }
    }
}

fn broken() -> Error {
    Error::not_computed("the computation broke off: a fault of the program; please report the input")
}
