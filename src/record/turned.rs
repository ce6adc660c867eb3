//! Columns that were no text, as a table of text.

use crate::{Error, Result};
use std::fmt::Write;

/// First words of names that mean the time.
const TIMES: [&str; 6] = ["t", "time", "tout", "timestamp", "seconds", "clock"];
/// Names of left-out variables that are told.
const TOLD: usize = 12;

/// A table turned into text, and what is to be said of that.
pub(super) struct Turned {
    pub(super) text: Vec<u8>,
    pub(super) note: String,
}

/// Named columns of numbers, and what was not taken.
#[derive(Default)]
pub(super) struct Columns {
    found: Vec<(String, Vec<f64>)>,
    left_out: Vec<String>,
}

impl Columns {
    pub(super) fn add(&mut self, name: String, values: Vec<f64>) {
        self.found.push((name, values));
    }

    pub(super) fn leave_out(&mut self, name: &str, why: &str) {
        let name = if name.is_empty() { "a variable" } else { name };
        self.left_out.push(format!("{name} {why}"));
    }

    /// The columns that are as long as the time, or as most, as a table of text; the time stands first.
    ///
    /// # Errors
    /// Where there are none.
    pub(super) fn table(mut self, what: &str) -> Result<Turned> {
        let time = self.found.iter().position(|(name, values)| is_time(name) && values.len() > 1);
        let length = time.map_or_else(|| self.commonest(), |at| self.found[at].1.len());
        if let Some(at) = time {
            self.found[..=at].rotate_right(1);
        }
        let (used, other): (Vec<_>, Vec<_>) = self.found.into_iter().partition(|(_, v)| v.len() == length);
        self.left_out
            .extend(other.iter().map(|(n, v)| format!("{n} has {} values instead of {length}", v.len())));
        if used.is_empty() {
            return Err(Error::bad_input(format!(
                "{what} without a row or column of numbers{}",
                listed(&self.left_out)
            ))
            .with_hint("a table is one variable a signal and one of time, all equally long"));
        }
        let names: Vec<String> = used.iter().map(|(n, _)| plain(n)).collect();
        let mut text = names.join(",") + "\n";
        for row in 0..length {
            for (k, (_, values)) in used.iter().enumerate() {
                let value = values[row];
                text.push_str(if k > 0 { "," } else { "" });
                if !value.is_nan() {
                    let _ = write!(text, "{value}");
                }
            }
            text.push('\n');
        }
        let note = format!("{what}: {} columns of {length} rows{}", used.len(), listed(&self.left_out));
        Ok(Turned { text: text.into_bytes(), note })
    }

    /// The length that most columns have; of several the greatest.
    fn commonest(&self) -> usize {
        let count = |n: usize| self.found.iter().filter(|(_, v)| v.len() == n).count();
        self.found.iter().map(|(_, v)| v.len()).max_by_key(|n| (count(*n), *n)).unwrap_or(0)
    }
}

/// Whether the last word of a name means the time: `t`, `log.time`, `t_s`.
fn is_time(name: &str) -> bool {
    let last = name.rsplit('.').next().unwrap_or(name).to_lowercase();
    TIMES.contains(&last.split('_').next().unwrap_or(&last))
}

/// A name without the signs of a table.
fn plain(name: &str) -> String {
    name.chars().map(|c| if matches!(c, ',' | ';' | '"' | '\n' | '\r' | '\t') { '_' } else { c }).collect()
}

/// What was left out, in words.
fn listed(left_out: &[String]) -> String {
    if left_out.is_empty() {
        return String::new();
    }
    let more = left_out.len().saturating_sub(TOLD);
    let more = if more > 0 { format!(", and {more} more") } else { String::new() };
    format!("; left out: {}{more}", left_out[..left_out.len().min(TOLD)].join(", "))
}
