//! One opaque error for the whole crate: what is wrong, where, and what to do.

use crate::text::{in_line, shown};
use std::fmt;
use std::io::BufRead;
use std::path::{Path, PathBuf};

/// The result of everything that can fail here.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// What sort of failure an [`Error`] is; it decides the program's exit code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ErrorKind {
    /// The call is wrong: an argument, an option.
    Usage,
    /// The input is wrong: numbers, lengths, text that cannot be read.
    BadInput,
    /// A unit is unknown or two dimensions do not agree.
    Units,
    /// A file cannot be read or written.
    Io,
    /// The polynomial H has roots in the right half plane.
    Unstable,
    /// The polynomial H has a root on the imaginary axis.
    ImaginaryAxis,
    /// The value is no finite normal double.
    OutOfRange,
    /// It could not be computed to the promised accuracy.
    NotComputed,
    /// The reader of the output went away; not a fault.
    ClosedPipe,
}

/// An error with data: file, line, column, a shown excerpt and a hint.
///
/// ```
/// use gyrospec::{Error, ErrorKind};
/// let e = Error::bad_input("the list is empty").with_hint("give a0 a1 … an");
/// assert_eq!(e.kind(), ErrorKind::BadInput);
/// assert!(e.to_string().contains("give a0"));
/// ```
#[derive(Clone)]
pub struct Error(Box<Inner>);

#[derive(Debug, Clone)]
struct Inner {
    kind: ErrorKind,
    message: String,
    file: Option<PathBuf>,
    line: Option<usize>,
    column: Option<usize>,
    excerpt: Option<(String, usize, usize)>,
    hint: Option<String>,
    count: Option<usize>,
    decimal: Option<String>,
}

impl Error {
    /// An error of a kind, with its message.
    pub fn new(kind: ErrorKind, message: impl Into<String>) -> Self {
        Self(Box::new(Inner {
            kind,
            message: message.into(),
            file: None,
            line: None,
            column: None,
            excerpt: None,
            hint: None,
            count: None,
            decimal: None,
        }))
    }

    /// Wrong input.
    pub fn bad_input(message: impl Into<String>) -> Self {
        Self::new(ErrorKind::BadInput, message)
    }

    /// A wrong call.
    pub fn usage(message: impl Into<String>) -> Self {
        Self::new(ErrorKind::Usage, message)
    }

    /// Something that could not be computed.
    pub fn not_computed(message: impl Into<String>) -> Self {
        Self::new(ErrorKind::NotComputed, message)
    }

    /// A failure to read or write a file.
    pub fn io(path: &Path, source: &std::io::Error) -> Self {
        let kind = match source.kind() {
            std::io::ErrorKind::BrokenPipe => ErrorKind::ClosedPipe,
            _ => ErrorKind::Io,
        };
        Self::new(kind, source.to_string()).with_file(path)
    }

    /// Names the file.
    #[must_use]
    pub fn with_file(mut self, path: &Path) -> Self {
        self.0.file = Some(path.to_owned());
        self
    }

    /// Says before the message what it is about: `states.v.rate`.
    #[must_use]
    pub fn about(mut self, what: &str) -> Self {
        self.0.message = format!("{what}: {}", self.0.message);
        self
    }

    /// Names the line, counted from 1.
    #[must_use]
    pub fn with_line(mut self, line: usize) -> Self {
        self.0.line = Some(line);
        self
    }

    /// Names the column, counted from 1.
    #[must_use]
    pub fn with_column(mut self, column: usize) -> Self {
        self.0.column = Some(column);
        self
    }

    /// Shows a text with `length` characters from `start` (from 0) underlined.
    #[must_use]
    pub fn with_excerpt(mut self, text: impl Into<String>, start: usize, length: usize) -> Self {
        self.0.excerpt = Some((text.into(), start, length.max(1)));
        self
    }

    /// Shows the line of the file that the error names, with the word at its column underlined; the error as
    /// it is where it shows something already, or where the line is no text.
    #[must_use]
    pub fn with_line_of_file(self) -> Self {
        let (Some(file), Some(line), Some(column)) = (self.file(), self.line(), self.column()) else {
            return self;
        };
        // A pipe is read once, and `-` is no file of that name.
        let there = file != Path::new("-") && std::fs::metadata(file).is_ok_and(|m| m.is_file());
        let text = there.then(|| std::fs::File::open(file).ok()).flatten().and_then(|f| {
            let mut lines = std::io::BufReader::new(f).lines();
            let text = lines.nth(line.checked_sub(1)?)?.ok()?;
            Some(text.trim_start_matches('\u{feff}').to_owned())
        });
        let Some(text) = text.filter(|_| self.0.excerpt.is_none()) else { return self };
        let start = column.saturating_sub(1);
        let rest = text.chars().skip(start);
        let word = rest.take_while(|c| c.is_alphanumeric() || "_.-".contains(*c)).count();
        self.with_excerpt(text, start, word)
    }

    /// Says what to do.
    #[must_use]
    pub fn with_hint(mut self, hint: impl Into<String>) -> Self {
        self.0.hint = Some(hint.into());
        self
    }

    /// Gives the number of right-half-plane roots.
    #[must_use]
    pub fn with_count(mut self, count: usize) -> Self {
        self.0.count = Some(count);
        self
    }

    /// Gives a value that no double holds.
    #[must_use]
    pub fn with_decimal(mut self, decimal: impl Into<String>) -> Self {
        self.0.decimal = Some(decimal.into());
        self
    }

    /// The number of right-half-plane roots, of an `Unstable` error.
    pub fn right_half_plane_roots(&self) -> Option<usize> {
        self.0.count
    }

    /// The value in decimal, of an `OutOfRange` error.
    pub fn decimal(&self) -> Option<&str> {
        self.0.decimal.as_deref()
    }

    /// What sort of error it is, which decides the program's exit code.
    pub fn kind(&self) -> ErrorKind {
        self.0.kind
    }

    /// The message alone, without place and hint.
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// The file that the error is in.
    pub fn file(&self) -> Option<&Path> {
        self.0.file.as_deref()
    }

    /// The line, counted from 1.
    pub fn line(&self) -> Option<usize> {
        self.0.line
    }

    /// The column, counted from 1.
    pub fn column(&self) -> Option<usize> {
        self.0.column
    }

    /// What to do about it.
    pub fn hint(&self) -> Option<&str> {
        self.0.hint.as_deref()
    }
}

/// What a program shows that ends with `fn main() -> gyrospec::Result<()>`: the text for people, hint included.
impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let e = &*self.0;
        if let Some(file) = &e.file {
            write!(f, "{}:", in_line(&named(file)))?;
            for number in [e.line, e.column].into_iter().flatten() {
                write!(f, "{number}:")?;
            }
            write!(f, " ")?;
        } else if let Some(line) = e.line {
            write!(f, "line {line}: ")?;
        }
        write!(f, "{}", e.message)?;
        if let Some((text, start, length)) = &e.excerpt {
            let (text, start, length) = widened(excerpt(text, *start, *length));
            write!(f, "\n  {text}\n  {}{}", " ".repeat(start), "^".repeat(length))?;
        }
        if let Some(hint) = &e.hint {
            write!(f, "\nhelp: {hint}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Error {}

/// The same with what would steer a terminal as escapes, which are wider than what they stand for.
fn widened((text, start, length): (String, usize, usize)) -> (String, usize, usize) {
    let wider_by = |from: usize, count: usize| {
        let part: String = text.chars().skip(from).take(count).collect();
        shown(&part).chars().count() - part.chars().count()
    };
    let (start, length) = (start + wider_by(0, start), length + wider_by(start, length));
    (shown(&text).into_owned(), start, length)
}

/// A file as messages name it: `-` is standard input, or standard output.
pub(crate) fn named(file: &Path) -> std::borrow::Cow<'_, str> {
    if file == Path::new("-") { "standard input".into() } else { file.to_string_lossy() }
}

/// The part of a text that is worth showing: all of a short one, the surroundings of what is
/// underlined of a long one, with … for what is left out.
fn excerpt(text: &str, start: usize, length: usize) -> (String, usize, usize) {
    const LONG: usize = 120;
    const AROUND: usize = 40;
    let count = text.chars().count();
    if count <= LONG {
        return (text.to_string(), start, length);
    }
    let length = length.min(AROUND);
    let from = start.min(count).saturating_sub(AROUND);
    let to = (start + length + AROUND).min(count);
    let part: String = text.chars().skip(from).take(to - from).collect();
    let (before, after) = (if from > 0 { "…" } else { "" }, if to < count { "…" } else { "" });
    (format!("{before}{part}{after}"), start - from + before.chars().count(), length)
}

/// The known name nearest to an unknown one, if one is near enough to be meant.
///
/// ```
/// assert_eq!(gyrospec::error::nearest("rol", ["roll", "pitch"]), Some("roll"));
/// assert_eq!(gyrospec::error::nearest("dge", ["degC", "deg"]), Some("deg"));
/// assert_eq!(gyrospec::error::nearest("yy1", ["u", "y1"]), Some("y1"));
/// assert_eq!(gyrospec::error::nearest("Roll", ["roll", "roll2"]), Some("roll"));
/// assert_eq!(gyrospec::error::nearest("xyzzy", ["roll", "pitch"]), None);
/// ```
#[cfg(any(feature = "symbolic", feature = "instruments"))]
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    known
        .into_iter()
        .map(|k| (likeness(&name.to_lowercase(), &k.to_lowercase()), k))
        .filter(|(score, _)| *score >= 0.7)
        .max_by(|a, b| a.0.total_cmp(&b.0).then_with(|| capitals(name, a.1).cmp(&capitals(name, b.1))))
        .map(|(_, k)| k)
}

/// How many letters stand alike in both, capitals and all.
#[cfg(any(feature = "symbolic", feature = "instruments"))]
fn capitals(name: &str, known: &str) -> usize {
    name.chars().zip(known.chars()).filter(|(a, b)| a == b).count()
}

/// 0 to 1, and 1 more where they are the same but for capitals, or differ by one slip of the keyboard, which is
/// nearest even in a short name.
#[cfg(any(feature = "symbolic", feature = "instruments"))]
fn likeness(name: &str, known: &str) -> f64 {
    let slip = name.len().min(known.len()) > 1 && strsim::damerau_levenshtein(name, known) <= 1;
    strsim::jaro_winkler(name, known) + if slip { 1.0 } else { 0.0 }
}
