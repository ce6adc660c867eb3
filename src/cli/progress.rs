//! Purpose: nobody waits in the dark. Work of more than two seconds says on standard error what it does: on a
//! terminal in a line that moves, elsewhere (a file, another program) in a line every ten seconds.
//!
//! Method: the work writes on a board what it does; a thread of its own looks at the board. So it makes no
//! difference how long the work says nothing.

use crate::estimate::fit::Progress;
use crate::text::in_line;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::sync::{Condvar, Mutex, MutexGuard, OnceLock, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// How long the program may be quiet, and how often it says something then.
#[derive(Clone, Copy)]
struct Pace {
    first: Duration,
    every: Duration,
}

const ON_A_TERMINAL: Pace = Pace { first: Duration::from_secs(2), every: Duration::from_millis(200) };
const ELSEWHERE: Pace = Pace { first: Duration::from_secs(2), every: Duration::from_secs(10) };

/// The thread needs little, also where memory is short.
const STACK: usize = 512 << 10;

/// What is being done.
struct Board {
    state: Mutex<State>,
    ended: Condvar,
}

struct State {
    doing: String,
    rests: bool,
    ended: bool,
}

static BOARD: Board = Board::new();
static BAR: OnceLock<ProgressBar> = OnceLock::new();

impl Board {
    const fn new() -> Self {
        let state = State { doing: String::new(), rests: false, ended: false };
        Self { state: Mutex::new(state), ended: Condvar::new() }
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn report(&self, stage: &str, share: Option<f64>) {
        let share = share.map(|s| format!(" ({:.0} %)", 100.0 * s)).unwrap_or_default();
        let mut state = self.state();
        state.doing = in_line(stage).into_owned() + &share;
        state.rests = false;
    }

    fn end(&self) {
        self.state().ended = true;
        self.ended.notify_all();
    }

    /// Shows at this pace what is done and for how long already, until the work has ended.
    fn watch(&self, pace: Pace, show: impl Fn(&str, Duration)) {
        let since = Instant::now();
        let mut next = pace.first;
        let mut state = self.state();
        while !state.ended {
            let passed = since.elapsed();
            if passed >= next && !state.rests {
                let doing = state.doing.clone();
                drop(state);
                show(&doing, passed);
                next = passed + pace.every;
                state = self.state();
                continue;
            }
            let wait = next.checked_sub(passed).unwrap_or(pace.every);
            state = self.ended.wait_timeout(state, wait).unwrap_or_else(PoisonError::into_inner).0;
        }
    }
}

/// The watch over one call; it ends when this is dropped.
pub struct Watch(Option<JoinHandle<()>>);

/// Begins to watch, unless `GYROSPEC_PROGRESS=never` says otherwise. Where no thread can be started, the work goes
/// on without.
pub fn watch(doing: &str) -> Watch {
    if std::env::var_os("GYROSPEC_PROGRESS").is_some_and(|v| v == "never") {
        return Watch(None);
    }
    BOARD.report(doing, None);
    let look = || {
        if std::io::stderr().is_terminal() {
            BOARD.watch(ON_A_TERMINAL, move_the_line);
        } else {
            BOARD.watch(ELSEWHERE, |doing, passed| eprintln!("progress: {doing}, {} s", passed.as_secs()));
        }
    };
    Watch(std::thread::Builder::new().stack_size(STACK).spawn(look).ok())
}

impl Drop for Watch {
    fn drop(&mut self) {
        BOARD.end();
        if let Some(thread) = self.0.take() {
            // a watch that panicked has said so
            let _ = thread.join();
        }
        if let Some(bar) = BAR.get() {
            bar.finish_and_clear();
        }
    }
}

fn move_the_line(doing: &str, passed: Duration) {
    let bar = BAR.get_or_init(|| {
        let style = ProgressStyle::with_template("{spinner} {msg}");
        let bar = ProgressBar::new_spinner();
        style.map_or(bar.clone(), |s| bar.with_style(s))
    });
    bar.set_message(format!("{doing}, {} s", passed.as_secs()));
    bar.tick();
}

/// Does what writes to the terminal while the line of progress is out of the way.
pub fn aside<T>(write: impl FnOnce() -> T) -> T {
    match BAR.get() {
        Some(bar) => bar.suspend(write),
        None => write(),
    }
}

/// The program waits for others: there is no progress to tell till the work says something again.
pub fn rest() {
    BOARD.state().rests = true;
}

/// What long work tells its progress to.
pub struct Meter;

impl Progress for Meter {
    fn report(&self, stage: &str, share: Option<f64>) {
        BOARD.report(stage, share);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::mpsc::channel;

    /// The work says something once and then nothing for ever; the watch tells it again and again.
    #[test]
    fn work_that_says_nothing_more_is_told_again_and_again() {
        let (board, (line, told)) = (&Board::new(), channel());
        std::thread::scope(|scope| {
            let always = Pace { first: Duration::ZERO, every: Duration::ZERO };
            scope.spawn(move || board.watch(always, move |doing, _| drop(line.send(doing.to_owned()))));
            board.report("fitting\u{1b}[2J", Some(0.4));
            let same = told.iter().filter(|l| l == "fitting\\u{1b}[2J (40 %)").take(3);
            assert_eq!(same.count(), 3);
            board.end();
        });
        assert!(
            told.iter().all(|l| l.is_empty() || l.starts_with("fitting")),
            "the watch ends with the work"
        );
    }

    #[test]
    fn quick_work_and_work_that_rests_say_nothing() {
        let day = Duration::from_secs(86_400);
        for (first, rests) in [(day, false), (Duration::ZERO, true)] {
            let (board, (line, told)) = (&Board::new(), channel());
            board.state().rests = rests;
            std::thread::scope(|scope| {
                scope.spawn(move || {
                    board.watch(Pace { first, every: day }, move |_, _| line.send(()).unwrap());
                });
                board.end();
            });
            assert_eq!(told.iter().count(), 0);
        }
    }
}
