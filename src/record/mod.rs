//! Recordings: CSV, NMEA 0183, gaps, rates, angle wrapping, clocks.
//!
//! A [`Recording`] holds [`Channel`]s: named rows of numbers in SI and radians, each with the
//! times at which they were taken. Tables of different rates lie side by side on one clock; a
//! gap is a NaN. A recording of steady trials has row numbers for times.

mod apart;
mod csv;
mod file;
mod foreign;
mod form;
#[cfg(feature = "diagnose")]
mod held;
mod input;
mod label;
mod mat;
mod nmea;
mod packed;
#[cfg(feature = "parquet")]
mod parquet;
pub mod quality;
mod recording;
mod request;
mod slower;
mod spans;
mod stream;
mod summary;
mod turned;
mod wrap;
mod zero;

pub use apart::keep_apart;
#[cfg(feature = "diagnose")]
pub(crate) use csv::of_raw as clocks_of;
pub use csv::{Raw, columns};
#[cfg(feature = "diagnose")]
pub(crate) use held::{looks_held, may_be_held};
pub(crate) use input::Input;
#[cfg(feature = "cli")]
pub(crate) use label::label;
#[cfg(feature = "cli")]
pub(crate) use nmea::{Contents, Listed};
pub use recording::{Channel, Constant, Hold, Kind, LeftOut, Note, Origin, Recording, Source};
pub use slower::at_its_pace;
pub use spans::{DEFAULT_FIT_SHARE, Span, Spans};
#[cfg(feature = "cli")]
pub(crate) use stream::{is_stream, read_once};
pub use summary::{Peak, Summary, summaries, summary};
pub use wrap::{principal, unwrap};
#[cfg(feature = "diagnose")]
pub(crate) use zero::Zero;

use crate::Result;
use crate::text::in_line;
use std::path::Path;

impl Recording {
    /// Reads a recording: a TOML file that names its tables, one CSV file (plain or gzip) whose
    /// header carries units and whose first column is time, or an NMEA 0183 log by itself, whose
    /// first stamp (or ZDA sentence, where lines have no stamp) is then the zero of time. What a file
    /// is, its first bytes tell; `-` is standard input. A pipe is read once; files that a TOML
    /// recording from a pipe names are relative to the working folder. A column with blanks at a pace
    /// of two rows or more becomes a slower channel ([`at_its_pace`]). A second column of time, with channels before and
    /// behind it, is the clock of those behind it where it rises and does not go with the first.
    ///
    /// # Errors
    /// `BadInput` or `Units` with file, line and column and what to do; `Io`.
    ///
    /// ```
    /// use gyrospec::record::Recording;
    /// let folder = tempfile::tempdir().unwrap();
    /// let file = folder.path().join("roll.csv");
    /// std::fs::write(&file, "t [s],roll [deg]\n0,1.5\n1,\n2,-1.5\n").unwrap();
    /// let r = Recording::read(&file)?;
    /// assert_eq!(r.channel("roll")?.values[0], 1.5_f64.to_radians());
    /// assert!(r.channel("roll")?.values[1].is_nan());
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn read(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let input = Input::open(path)?;
        if input.is_toml() {
            let (text, source) = input.text()?;
            return file::parse(&text, source);
        }
        let name = stem(path);
        let table = if nmea::looks_like_log(input.start()) {
            nmea::read(input, &nmea::Request { zero: None, wanted: Vec::new(), table: 0 })?
        } else {
            let clock = request::Clock::FirstColumn;
            let wanted = Vec::new();
            let request = request::Request { clock, wanted, rows: None, table: 0, zero: None, comma: None };
            csv::read(input, &request)?
        };
        let (sources, origins) = (vec![table.origin.source.clone()], table.origins());
        let (notes, left_out, zero) = (table.notes, table.left_out, table.zero);
        Ok(Self {
            name,
            channels: table.channels,
            sources,
            origins,
            notes,
            left_out,
            zero,
            time_unit: table.time_unit,
            is_piece: false,
            ..Self::default()
        })
    }

    /// Reads the recording that the text of a TOML recording describes; `path` is where the text is to
    /// stand, and the files that it names are relative to its folder.
    ///
    /// # Errors
    /// As [`Recording::read`].
    pub fn parse(text: &str, path: impl AsRef<Path>) -> Result<Self> {
        file::parse(text, Source::of(path.as_ref(), text.as_bytes()))
    }
}

/// The whole text of a file, or of standard input for `-`, and the hash of its bytes.
#[cfg(feature = "diagnose")]
pub(crate) fn read_text(path: &Path) -> Result<(String, Source)> {
    Input::open(path)?.text()
}

/// The name of a file without its folder and endings, in one line, for reports.
fn stem(path: &Path) -> String {
    if path == Path::new("-") {
        return "standard input".into();
    }
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    in_line(name.split('.').next().unwrap_or_default()).into_owned()
}

/// What an NMEA 0183 log holds.
///
/// # Errors
/// As [`Recording::read`].
#[cfg(feature = "cli")]
pub(crate) fn contents_of_log(path: &Path) -> Result<Contents> {
    nmea::contents(Input::open(path)?)
}

/// Whether a file is an NMEA 0183 log.
///
/// # Errors
/// `Io`.
pub fn is_log(path: &Path) -> Result<bool> {
    Ok(nmea::looks_like_log(Input::open(path)?.start()))
}
