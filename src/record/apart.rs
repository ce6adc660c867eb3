//! Purpose: recordings that are used together hold different data.
//!
//! Method: what is held out of the fit proves something only where nothing of it was fitted, and what is
//! fitted twice makes intervals too narrow. Rows of one file are compared by their numbers, so that disjoint
//! parts of it stay legal; files that differ in bytes are compared by the values that were read of them: a
//! packed, renamed or newly written copy is the same data. Of two recordings on one clock a run of equal
//! samples counts that moves some tens of times, which no noise repeats; on different clocks one must hold
//! the whole of the other.
//!
//! Numerical aspects: values agree within a millionth of the channel's range, since units and digits may
//! differ; on different clocks to the last bit.

use super::{Channel, Kind, Recording, Span};
use crate::{Error, Result};
use std::collections::HashMap;

/// A share of a channel's range up to which two values are one.
const SAME: f64 = 1e-6;
/// A share of the step up to which two times are one.
const SAME_TIME: f64 = 1e-3;
/// Moves in a run of equal samples from which on it is no coincidence.
const MOVES: usize = 30;
/// Fewest moves of a whole recording that repeats another.
const FEWEST: usize = 3;

/// What a part of a recording serves for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Use {
    Fit,
    HeldOut,
}

/// A part of a recording and its use.
struct Part<'a> {
    recording: &'a Recording,
    number: usize,
    used: Use,
    spans: Vec<Span>,
    /// Spans that the samples must not lie in besides.
    but: Vec<Span>,
}

impl Part<'_> {
    fn holds(&self, time: f64) -> bool {
        let inside = |spans: &[Span]| spans.iter().any(|s| s.contains(time));
        inside(&self.spans) && !inside(&self.but)
    }

    fn ends(&self, time: f64) -> bool {
        self.recording.spans.given && self.spans.iter().any(|s| s.from == time || s.to == time)
    }
}

/// Refuses recordings, fitted and `separate` ones that are held out whole, that share data in the named
/// `outputs` of a model; `inputs` tell trials apart.
///
/// # Errors
/// `BadInput` that says which rows or times of which recordings are the same.
pub fn keep_apart(
    inputs: &[&str],
    outputs: &[&str],
    recordings: &[Recording],
    separate: &[Recording],
) -> Result<()> {
    let names = [inputs, outputs].concat();
    let parts = parts(&names, recordings, separate);
    for (i, a) in parts.iter().enumerate() {
        for b in parts[i + 1..].iter().filter(|b| b.number != a.number) {
            if let Some(place) = outputs.iter().find_map(|o| shared(a, b, inputs, o)) {
                return Err(refused(a, b, &place));
            }
        }
    }
    Ok(())
}

fn parts<'a>(names: &[&str], recordings: &'a [Recording], separate: &'a [Recording]) -> Vec<Part<'a>> {
    let mut parts = Vec::new();
    for (number, recording) in recordings.iter().chain(separate).enumerate() {
        let held = number >= recordings.len();
        let spans = recording.spans_for(names, held || !separate.is_empty());
        let part = |used: Use, spans: Vec<Span>, but: Vec<Span>| Part { recording, number, used, spans, but };
        if held {
            let own = if spans.holdout.is_empty() { spans.fit } else { spans.holdout };
            parts.push(part(Use::HeldOut, own, Vec::new()));
            continue;
        }
        parts.push(part(Use::Fit, spans.fit.clone(), Vec::new()));
        if !spans.holdout.is_empty() {
            parts.push(part(Use::HeldOut, spans.holdout, spans.fit));
        }
    }
    parts
}

fn refused(a: &Part<'_>, b: &Part<'_>, place: &str) -> Error {
    let (first, second) = (&a.recording.name, &b.recording.name);
    let (twice, hint) = match (a.used, b.used) {
        (Use::Fit, Use::Fit) => (
            "fitted twice",
            "it tells nothing new the second time, and intervals come out too narrow: give it once",
        ),
        (Use::HeldOut, Use::HeldOut) => {
            ("held out twice", "it proves nothing new the second time: give it once")
        }
        _ => (
            "both fitted and held out",
            "what is held out proves something only where nothing was fitted: give another recording, or \
             other rows or [spans] of this one",
        ),
    };
    Error::bad_input(format!("'{first}' and '{second}' hold the same data: {place} would be {twice}"))
        .with_hint(hint)
}

/// Where two parts share samples of an output, in words.
fn shared(a: &Part<'_>, b: &Part<'_>, inputs: &[&str], output: &str) -> Option<String> {
    let (x, y) = (a.recording.find(output)?, b.recording.find(output)?);
    if a.recording.kind != b.recording.kind {
        return None;
    }
    let origin = |p: &Part<'_>, c: &Channel| p.recording.origins.get(c.table).cloned();
    if let (Some(one), Some(other)) = (origin(a, x), origin(b, y))
        && one.source.sha256 == other.source.sha256
    {
        let pairs = same_rows((x, one.first_row), (y, other.first_row));
        let place = rows(a, b, (x, y), &pairs)?;
        let first = one.first_row;
        return Some(if one.is_table {
            let (from, to) = (first + place.0, first + place.1);
            format!("{} of {}", counted(from, to), one.source.file.display())
        } else {
            times(x, place)
        });
    }
    if a.recording.kind == Kind::Trials { trials(a, b, inputs, output) } else { values(a, b, x, y) }
}

fn counted(from: usize, to: usize) -> String {
    if from == to { format!("row {from}") } else { format!("rows {from} to {to}") }
}

fn times(c: &Channel, (from, to): (usize, usize)) -> String {
    format!("{} s to {} s", c.time[from], c.time[to])
}

/// Pairs of samples that come from one row of a file.
fn same_rows((x, first): (&Channel, usize), (y, second): (&Channel, usize)) -> Vec<(usize, usize)> {
    let (from, to) = (first.max(second), (first + x.len()).min(second + y.len()));
    (from..to).map(|row| (row - first, row - second)).collect()
}

/// The first and the last shared row, as samples of the first; none where the values differ, as those of
/// two columns do, and none where two given spans only touch.
fn rows(
    a: &Part<'_>,
    b: &Part<'_>,
    (x, y): (&Channel, &Channel),
    pairs: &[(usize, usize)],
) -> Option<(usize, usize)> {
    let used = |(i, j): &&(usize, usize)| a.holds(x.time[*i]) && b.holds(y.time[*j]);
    let both: Vec<&(usize, usize)> = pairs.iter().filter(used).collect();
    let near = near(x);
    let (first, last) = (both.first()?, both.last()?);
    let touch = both.len() == 1 && (a.ends(x.time[first.0]) || b.ends(y.time[first.1]));
    let alike = both.iter().all(|(i, j)| near(x.values[*i], y.values[*j]));
    (alike && !touch).then_some((first.0, last.0))
}

/// Whether two values of a channel are one; gaps are alike.
fn near(c: &Channel) -> impl Fn(f64, f64) -> bool {
    let ends = c.samples().fold((f64::INFINITY, f64::NEG_INFINITY), |e, (_, v)| (e.0.min(v), e.1.max(v)));
    let size = ends.0.abs().max(ends.1.abs());
    let allowed = (SAME * (ends.1 - ends.0)).max(1e-14 * size);
    move |a, b| a == b || a.is_nan() && b.is_nan() || (a - b).abs() <= allowed
}

/// Where two recordings of different files agree in time and value, or one holds the other at another time.
fn values(a: &Part<'_>, b: &Part<'_>, x: &Channel, y: &Channel) -> Option<String> {
    let run = longest(&on_one_clock(a, b, x, y), x, y);
    let few = known(a, x).len().min(known(b, y).len());
    let whole = run.as_ref().is_some_and(|r| r.samples >= few && r.moves >= FEWEST);
    let seen = run.filter(|r| whole || r.moves >= MOVES);
    seen.map(|r| times(x, (r.from, r.to))).or_else(|| contained(a, b, x, y))
}

/// Samples of a part that are no gaps.
fn known(p: &Part<'_>, c: &Channel) -> Vec<usize> {
    (0..c.len()).filter(|i| c.values[*i].is_finite() && p.holds(c.time[*i])).collect()
}

/// Pairs of samples of two channels at one time.
fn on_one_clock(a: &Part<'_>, b: &Part<'_>, x: &Channel, y: &Channel) -> Vec<(usize, usize)> {
    let reach = SAME_TIME * x.median_step().unwrap_or(0.0).min(y.median_step().unwrap_or(0.0));
    let (xs, ys) = (known(a, x), known(b, y));
    let mut pairs = Vec::new();
    let mut j = 0;
    for i in xs {
        while j < ys.len() && y.time[ys[j]] < x.time[i] - reach {
            j += 1;
        }
        if j < ys.len() && y.time[ys[j]] <= x.time[i] + reach {
            pairs.push((i, ys[j]));
        }
    }
    pairs
}

/// A run of equal samples.
struct Run {
    from: usize,
    to: usize,
    samples: usize,
    moves: usize,
}

/// The run of equal pairs with the most moves.
fn longest(pairs: &[(usize, usize)], x: &Channel, y: &Channel) -> Option<Run> {
    let near = near(x);
    let equal = |p: &(usize, usize)| near(x.values[p.0], y.values[p.1]);
    let runs = pairs.chunk_by(|p, q| equal(p) && equal(q)).filter(|r| equal(&r[0]));
    let run = |r: &[(usize, usize)]| Run {
        from: r[0].0,
        to: r[r.len() - 1].0,
        samples: r.len(),
        moves: r.windows(2).filter(|w| !near(x.values[w[0].0], x.values[w[1].0])).count(),
    };
    runs.map(run).max_by_key(|r| (r.moves, r.samples))
}

/// Where one part's values stand in a row in the other's, whatever the clocks say.
fn contained(a: &Part<'_>, b: &Part<'_>, x: &Channel, y: &Channel) -> Option<String> {
    let (xs, ys) = (known(a, x), known(b, y));
    let bits =
        |c: &Channel, at: &[usize]| -> Vec<u64> { at.iter().map(|i| c.values[*i].to_bits()).collect() };
    let (p, q) = (bits(x, &xs), bits(y, &ys));
    let (short, long) = if p.len() <= q.len() { (&p, &q) } else { (&q, &p) };
    if short.windows(2).filter(|w| w[0] != w[1]).count() < MOVES {
        return None;
    }
    let at = find(long, short)?;
    let from = if p.len() <= q.len() { 0 } else { at };
    Some(times(x, (xs[from], xs[from + short.len() - 1])))
}

/// Where a row of numbers stands in a longer one, by the table of Knuth, Morris and Pratt.
fn find(long: &[u64], short: &[u64]) -> Option<usize> {
    let mut table = vec![0; short.len()];
    let mut k = 0;
    for i in 1..short.len() {
        while k > 0 && short[i] != short[k] {
            k = table[k - 1];
        }
        k += usize::from(short[i] == short[k]);
        table[i] = k;
    }
    k = 0;
    for (i, value) in long.iter().enumerate() {
        while k > 0 && *value != short[k] {
            k = table[k - 1];
        }
        k += usize::from(*value == short[k]);
        if k == short.len() {
            return Some(i + 1 - k);
        }
    }
    None
}

/// Trials of different files have no order: more than half of the fewer are the same, by all that was set
/// and measured.
fn trials(a: &Part<'_>, b: &Part<'_>, inputs: &[&str], output: &str) -> Option<String> {
    let rows = |p: &Part<'_>| -> Vec<(usize, Vec<String>)> {
        let channels: Vec<&Channel> =
            inputs.iter().chain([&output]).filter_map(|n| p.recording.find(n)).collect();
        let c = channels[channels.len() - 1];
        let row = |i: usize| channels.iter().map(|c| format!("{:.9e}", c.values[i])).collect();
        known(p, c).into_iter().map(|i| (i, row(i))).collect()
    };
    let (mine, others) = (rows(a), rows(b));
    let mut counts: HashMap<&[String], usize> = HashMap::new();
    for (_, row) in &others {
        *counts.entry(row).or_default() += 1;
    }
    let mut both = Vec::new();
    for (i, row) in &mine {
        if let Some(left) = counts.get_mut(row.as_slice()).filter(|n| **n > 0) {
            *left -= 1;
            both.push(*i);
        }
    }
    let many = both.len() >= FEWEST && 2 * both.len() > mine.len().min(others.len());
    many.then(|| format!("{} rows, from row {} on,", both.len(), both[0]))
}
