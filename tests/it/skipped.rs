//! What a test did not do, told past the capture of its output: a test that did nothing never passes in silence.

use std::io::Write;

/// Says on standard error, also of a test that passes, that something was not tested, and why.
pub fn skipped(why: impl std::fmt::Display) {
    // the macros of the standard library would be captured
    let _ = writeln!(std::io::stderr(), "SKIPPED: {why}");
}
