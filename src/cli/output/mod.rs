//! Where results go. This place alone decides what may be written: nothing that was read is written over, two
//! results never go to one place, and what is put in place is there whole, all of it or none.

mod place;
mod put;

pub use place::{Place, open, spare};
pub use put::put;

use super::progress::aside;
use crate::text::{in_quotes, shown};
use crate::{Error, ErrorKind, Result};
use std::io::Write;
use std::path::Path;

/// Prints words: what in them would steer a terminal is shown as an escape.
pub fn words(text: &str) -> Result<()> {
    print(shown(text).as_bytes())
}

/// Prints JSON, or TOML whose strings stand in double quotes: the same, in that language's own escapes.
pub fn quoted(text: &str) -> Result<()> {
    print(in_quotes(text).as_bytes())
}

/// Writes to standard output as it is. Where the reader went away there is nobody to tell, and the work goes on: files
/// that were asked for are still written.
pub fn print(text: &[u8]) -> Result<()> {
    let mut out = std::io::stdout().lock();
    let said = aside(|| out.write_all(text).and_then(|()| out.flush()));
    match said.map_err(|e| Error::io(Path::new("standard output"), &e)) {
        Err(e) if e.kind() == ErrorKind::ClosedPipe => Ok(()),
        said => said,
    }
}
