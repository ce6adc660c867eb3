//! The first lines of a table, cut by one separator: what each field holds, how wide the rows are, and where the names
//! stand.

use super::clock::duration;
use super::field::{self, Field};
use super::figures::{self, Form};
use super::stamp::stamp;
use crate::record::label;

/// Beginnings of lines that are words to the reader, and of fields that say that a value is missing.
const COMMENTS: [&str; 3] = ["#", "%", "//"];
const MISSING: [&str; 3] = ["#N/A", "#NV", "#NA"];

/// Whether a line is for people.
pub(super) fn is_comment(line: &[u8]) -> bool {
    let line = line.trim_ascii_start();
    let begins = |marks: &[&str]| marks.iter().any(|m| line.starts_with(m.as_bytes()));
    begins(&COMMENTS) && !begins(&MISSING)
}

/// A line of the sample, cut.
pub(super) struct Line {
    pub(super) number: usize,
    pub(super) fields: Vec<(usize, String)>,
    /// Whether empty fields at its end were taken off.
    pub(super) is_cut: bool,
}

impl Line {
    /// The line between separators; one with an open quote has no fields, and is told of when it is read.
    pub(super) fn of(number: usize, line: &str, separator: u8) -> Self {
        let fields = field::split(line.as_bytes(), separator).unwrap_or_default();
        let text = |f: &Field| String::from_utf8_lossy(f.text.trim_ascii()).into_owned();
        let fields = fields.iter().map(|f| (f.at, text(f))).collect();
        Self { number, fields: if separator == b' ' { rejoined(fields) } else { fields }, is_cut: false }
    }

    pub(super) fn forms(&self) -> impl Iterator<Item = Kind> + '_ {
        self.fields.iter().map(|(_, text)| Kind::of(text))
    }
}

/// What a field holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Missing,
    Number(Form),
    Time,
    Words,
}

impl Kind {
    pub(super) fn of(text: &str) -> Self {
        match figures::form(text) {
            Form::Missing => Self::Missing,
            // `20250403120000`, which nobody counts to
            Form::Whole if text.len() == 14 && stamp(text).is_some() => Self::Time,
            Form::Text if stamp(text).is_some() || duration(text).is_some() => Self::Time,
            Form::Text => Self::Words,
            form => Self::Number(form),
        }
    }

    pub(super) fn is_datum(self) -> bool {
        matches!(self, Self::Number(_) | Self::Time)
    }
}

/// The number of fields that most lines with numbers have.
pub(super) fn width(lines: &[Line]) -> Option<usize> {
    let with_data: Vec<&Line> = lines.iter().filter(|l| l.forms().any(Kind::is_datum)).collect();
    let count = |n: usize| with_data.iter().filter(|l| l.fields.len() == n).count();
    let usual = with_data.iter().map(|l| l.fields.len()).max_by_key(|n| (count(*n), *n))?;
    // a separator at the end of each line makes no column
    let of_width = || lines.iter().filter(|l| l.fields.len() == usual);
    let empty_end = usual > 2 && of_width().all(|l| l.fields.last().is_some_and(|f| f.1.is_empty()));
    Some(if empty_end { usual - 1 } else { usual })
}

/// What each column usually holds, by the second half of the lines.
pub(super) fn kinds(lines: &[Line], width: usize) -> Vec<Kind> {
    let rows: Vec<&Line> = lines.iter().filter(|l| l.fields.len() == width).collect();
    let later = &rows[rows.len() / 2..];
    let usual = |c: usize| {
        let of = |wanted: fn(Kind) -> bool| later.iter().filter(|l| wanted(Kind::of(&l.fields[c].1))).count();
        let (numbers, times) = (of(|k| matches!(k, Kind::Number(_))), of(|k| k == Kind::Time));
        let words = of(|k| k == Kind::Words);
        if words > numbers.max(times) {
            Kind::Words
        } else if times > numbers {
            Kind::Time
        } else if numbers > 0 {
            Kind::Number(Form::Whole)
        } else {
            Kind::Missing
        }
    };
    (0..width).map(usual).collect()
}

/// The line of names, the units below it, and the last line of these.
pub(super) struct Names {
    /// Which of the lines.
    pub at: usize,
    /// Units that stand in a row of their own, or nothing.
    pub units: Vec<String>,
    /// Number of the last line of labels.
    pub last: usize,
}

/// The line of names above the rows, the nearest whose labels all differ, and the units that stand below it.
pub(super) fn names(above: &[Line], width: usize) -> Option<Names> {
    // what has no unit may stand as 1 in a row of units
    let is_label = |f: &(usize, String)| matches!(Kind::of(&f.1), Kind::Words | Kind::Missing) || f.1 == "1";
    let has_words = |l: &Line| l.forms().any(|k| k == Kind::Words) || l.forms().all(|k| k == Kind::Missing);
    let fits = |l: &Line| l.fields.len() == width && l.fields.iter().all(is_label) && has_words(l);
    let nearest = (0..above.len()).rev().find(|at| fits(&above[*at]))?;
    let block = (0..=nearest).rev().take_while(|at| fits(&above[*at]));
    let labels = |at: usize| above[at].fields.iter().map(|f| f.1.as_str());
    let differ = |at: usize| {
        let mut seen: Vec<&str> = labels(at).collect();
        seen.sort_unstable();
        seen.windows(2).all(|w| w[0] != w[1])
    };
    let of_units = |at: usize| {
        // time stamp and record number, as loggers of the form TOA5 write them
        let known = |t: &str| ["TS", "RN"].contains(&t) || label::unit(bare(t)).is_some();
        let some = labels(at).filter(|t| !t.is_empty()).count();
        let units = labels(at).filter(|t| !t.is_empty() && known(t)).count();
        (units > 0 && 2 * units >= some).then(|| labels(at).map(|t| bare(t).to_owned()).collect::<Vec<_>>())
    };
    let mut units = Vec::new();
    let block: Vec<usize> = block.collect();
    for (k, at) in block.iter().copied().enumerate() {
        let is_last = k + 1 == block.len();
        match of_units(at) {
            Some(found) if block[k + 1..].iter().any(|above| differ(*above)) => units = found,
            // an oscilloscope numbers its channels
            Some(units) if is_last && at > 0 && above[at - 1].fields.len() == width && differ(at - 1) => {
                return Some(Names { at: at - 1, units, last: above[nearest].number });
            }
            _ if differ(at) || is_last => return Some(Names { at, units, last: above[nearest].number }),
            _ => {}
        }
    }
    None
}

/// Labels between blanks, with the units in brackets that belong to them.
fn rejoined(fields: Vec<(usize, String)>) -> Vec<(usize, String)> {
    let mut out: Vec<(usize, String)> = Vec::new();
    for (at, text) in fields {
        match out.last_mut().filter(|_| text.starts_with(['[', '('])) {
            Some((_, name)) => *name = format!("{name} {text}"),
            None => out.push((at, text)),
        }
    }
    out
}

/// Names right above the rows, one fewer than columns: the first column holds the names of the rows, as R writes them.
/// Where it could be a signal like the others, a name is missing instead, and nobody knows which.
pub(super) fn short(
    above: &mut Vec<Line>,
    rows: &[Line],
    lines: &[(usize, &str)],
    width: usize,
) -> Option<Line> {
    let names = above.last().filter(|l| l.fields.len() + 1 == width && l.forms().all(|k| k == Kind::Words));
    // a label that holds what separates columns elsewhere is several
    let is_torn = |l: &&Line| l.fields.iter().any(|f| f.1.contains([',', ';', '\t', '|']));
    names.filter(|l| !l.fields.is_empty() && !is_torn(l))?;
    let as_it_stands = |l: &Line| lines.get(l.number - 1).map_or("", |line| line.1.trim_start());
    let is_quoted = |l: &Line| {
        let text = as_it_stands(l);
        text.starts_with('"') && text.matches('"').count() == 2
    };
    let is_word = |l: &Line| l.forms().next() == Some(Kind::Words);
    if !rows.iter().filter(|l| l.fields.len() == width).all(|l| is_quoted(l) || is_word(l)) {
        return None;
    }
    let mut line = above.pop()?;
    line.fields.insert(0, (0, String::new()));
    Some(line)
}

/// Names in the last comment above the rows, or in the last but one where the last holds units only; the units, and the
/// number of the last.
pub(super) fn in_comment(
    lines: &[(usize, &str)],
    before: usize,
    separator: u8,
    width: usize,
) -> Option<(Line, Vec<String>, usize)> {
    let mut above = lines.iter().rev().filter(|l| l.0 < before && is_comment(l.1.as_bytes()));
    let mut next = || above.next().map(|(number, line)| uncommented(*number, line, separator));
    let fits =
        |l: &Line, other: Kind| l.fields.len() == width && l.forms().all(|k| k == Kind::Words || k == other);
    let last = next()?;
    let number = last.number;
    let units: Option<Vec<String>> = last.fields.iter().map(|f| label::unit(bare(&f.1))).collect();
    let differ = |l: &Line| (1..width).all(|i| l.fields[..i].iter().all(|f| f.1 != l.fields[i].1));
    let is_named = |l: &Line| l.number + 1 == number && fits(l, Kind::Words) && differ(l);
    if let Some(units) = units.filter(|_| fits(&last, Kind::Missing))
        && let Some(names) = next().filter(is_named)
    {
        return Some((names, units, number));
    }
    fits(&last, Kind::Words).then_some((last, Vec::new(), number))
}

/// The fields of a comment.
fn uncommented(number: usize, line: &str, separator: u8) -> Line {
    let bare = line.trim_start().trim_start_matches(['#', '%', '/']);
    let skipped = line.len() - bare.len();
    let mut line = Line::of(number, bare, separator);
    line.fields.iter_mut().for_each(|(at, _)| *at += skipped);
    line
}

/// A unit without brackets around it.
fn bare(text: &str) -> &str {
    text.trim_matches(['[', ']', '(', ')']).trim()
}
