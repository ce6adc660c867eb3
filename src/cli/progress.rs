//! Progress on standard error, only where somebody waits.

use crate::estimate::fit::Progress;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// How long a computation may be quiet.
const PATIENCE: Duration = Duration::from_secs(2);

/// A line on standard error that appears after two seconds, on a terminal alone.
pub struct Meter {
    since: Instant,
    shown: bool,
    bar: OnceLock<ProgressBar>,
}

impl Meter {
    /// Starts to wait.
    pub fn new() -> Self {
        Self { since: Instant::now(), shown: std::io::stderr().is_terminal(), bar: OnceLock::new() }
    }

    fn bar(&self) -> &ProgressBar {
        self.bar.get_or_init(|| {
            let style = ProgressStyle::with_template("{spinner} {elapsed} {msg}");
            let bar = ProgressBar::new_spinner();
            bar.enable_steady_tick(Duration::from_millis(200));
            style.map_or(bar.clone(), |s| bar.with_style(s))
        })
    }
}

impl Default for Meter {
    fn default() -> Self {
        Self::new()
    }
}

impl Progress for Meter {
    fn says(&self, what: &str, share: Option<f64>) {
        if self.shown && self.since.elapsed() > PATIENCE {
            let text = share.map_or_else(|| what.to_owned(), |s| format!("{what} ({:.0} %)", 100.0 * s));
            self.bar().set_message(text);
        }
    }
}

impl Drop for Meter {
    fn drop(&mut self) {
        if let Some(bar) = self.bar.get() {
            bar.finish_and_clear();
        }
    }
}
