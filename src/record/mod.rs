//! Recordings: CSV, NMEA 0183, gaps, rates, angle wrapping, clocks.
//!
//! A [`Recording`] holds [`Channel`]s: named rows of numbers in SI and radians, each with the
//! times at which they were taken. Tables of different rates lie side by side on one clock; a
//! gap is a NaN. A recording of steady trials has row numbers for times.

mod csv;
mod file;
mod form;
mod input;
mod nmea;
pub mod quality;
mod recording;
mod request;
mod spans;
mod summary;
mod wrap;

pub use csv::{Raw, columns};
pub use recording::{Channel, Constant, Hold, Kind, Note, Recording, Source};
pub use spans::{DEFAULT_FIT_SHARE, Span, Spans};
pub use summary::{Peak, Summary, summaries, summary};
pub use wrap::unwrap;

use crate::{Error, Result};
use std::io::Read;
use std::path::Path;

impl Recording {
    /// Reads a recording: a TOML file that names its tables, one CSV file (plain or gzip) whose
    /// header carries units and whose first column is time, or an NMEA 0183 log by itself, whose
    /// first stamp is then the zero of time.
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
        if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml")) {
            return file::read(path);
        }
        let stem = path.file_name().unwrap_or_default().to_string_lossy();
        let name = stem.split('.').next().unwrap_or_default().to_owned();
        let table = if is_log(path)? {
            nmea::read(path, &nmea::Request { zero: None, wanted: Vec::new(), table: 0 })?
        } else {
            let clock = request::Clock::FirstColumn;
            csv::read(path, &request::Request { clock, wanted: Vec::new(), rows: None, table: 0 })?
        };
        let (channels, sources, notes) = (table.channels, vec![table.source], table.notes);
        Ok(Self { name, channels, sources, notes, ..Self::default() })
    }

    /// Reads the recording that the text of a TOML recording describes; `path` is where the text is to
    /// stand, and the files that it names are relative to its folder.
    ///
    /// # Errors
    /// As [`Recording::read`].
    pub fn parse(text: &str, path: impl AsRef<Path>) -> Result<Self> {
        file::parse(text, path.as_ref())
    }
}

/// Whether a file is an NMEA 0183 log.
///
/// # Errors
/// `Io`.
pub fn is_log(path: &Path) -> Result<bool> {
    Ok(nmea::looks_like_log(&start_of(path)?))
}

fn start_of(path: &Path) -> Result<Vec<u8>> {
    let mut start = Vec::new();
    let file = std::fs::File::open(path).map_err(|e| Error::io(path, &e))?;
    file.take(4096).read_to_end(&mut start).map_err(|e| Error::io(path, &e))?;
    Ok(start)
}
