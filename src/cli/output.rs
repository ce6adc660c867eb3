//! Results that appear whole or not at all.

use crate::{Error, Result};
use std::io::Write;
use std::path::{Path, PathBuf};

/// A place for a result: standard output for `-`, else a file that is written beside its
/// final name and moved there by [`Sink::finish`]; an interrupt leaves nothing behind.
pub struct Sink {
    path: PathBuf,
    file: Option<tempfile::NamedTempFile>,
}

impl Sink {
    /// Opens the place before the work starts, so that a wrong path costs no time.
    pub fn open(path: &Path) -> Result<Self> {
        if path == Path::new("-") {
            return Ok(Self { path: path.to_owned(), file: None });
        }
        let folder = match path.parent() {
            Some(p) if !p.as_os_str().is_empty() => p,
            _ => Path::new("."),
        };
        let file = tempfile::Builder::new()
            .prefix(".gyrospec-")
            .tempfile_in(folder)
            .map_err(|e| Error::io(path, &e))?;
        Ok(Self { path: path.to_owned(), file: Some(file) })
    }

    /// Writes the whole result and puts it in place.
    pub fn finish(self, text: &[u8]) -> Result<()> {
        let path = self.path;
        match self.file {
            None => print(text),
            Some(mut file) => {
                file.write_all(text).map_err(|e| Error::io(&path, &e))?;
                file.persist(&path).map_err(|e| Error::io(&path, &e.error))?;
                Ok(())
            }
        }
    }
}

/// Writes to standard output; a reader that went away ends the program quietly.
pub fn print(text: &[u8]) -> Result<()> {
    let mut out = std::io::stdout().lock();
    out.write_all(text).and_then(|()| out.flush()).map_err(|e| Error::io(Path::new("standard output"), &e))
}
