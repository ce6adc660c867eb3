//! Purpose: start the threads that share work, in one place, so that a system that gives none is no surprise later.
//!
//! Method: threads are started first and counted, and the pool is made of those that did start. Where none does,
//! the work goes on in the one thread that there is.

use crate::{Error, Result};
use rayon::ThreadPoolBuilder;
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Mutex, PoisonError};

/// More threads than this quicken nothing here, and could use up what the system gives to all.
const MOST: usize = 256;

type Work = Receiver<rayon::ThreadBuilder>;

/// Starts as many threads as the machine has cores, or as `RAYON_NUM_THREADS` says.
///
/// # Errors
/// `NotComputed` where the work cannot be shared, not even with the thread that is there.
pub fn start() -> Result<()> {
    let (give, work) = channel();
    let work = Arc::new(Mutex::new(work));
    let started = (0..wanted()).take_while(|_| begin(&work)).count();
    let pool = ThreadPoolBuilder::new().num_threads(started.max(1));
    let built = if started == 0 {
        super::warn("the system gives no threads: the work goes on in one");
        pool.use_current_thread().build_global()
    } else {
        let hand_over =
            |thread| give.send(thread).map_err(|_| std::io::Error::other("a thread ended at once"));
        pool.spawn_handler(hand_over).build_global()
    };
    built.map_err(|e| Error::not_computed(format!("the work cannot be shared among threads: {e}")))
}

fn wanted() -> usize {
    let said = std::env::var("RAYON_NUM_THREADS").ok().and_then(|n| n.parse().ok()).filter(|n| *n > 0);
    let cores = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    said.unwrap_or_else(cores).min(MOST)
}

/// Starts a thread that waits for its part in the pool; whether it did start.
fn begin(work: &Arc<Mutex<Work>>) -> bool {
    let work = Arc::clone(work);
    let run = move || {
        let part = work.lock().unwrap_or_else(PoisonError::into_inner).recv();
        if let Ok(part) = part {
            part.run();
        }
    };
    std::thread::Builder::new().spawn(run).is_ok()
}
