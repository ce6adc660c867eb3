//! Inputs that can be read only once.

use crate::{Error, Result};
use std::path::{Path, PathBuf};

/// Whether a path is no file of bytes that lie there, but a pipe or a device, which is read once.
pub(crate) fn is_stream(path: &Path) -> bool {
    path == Path::new("-") || std::fs::metadata(path).is_ok_and(|m| !m.is_file() && !m.is_dir())
}

/// Refuses a pipe or device that would be read twice.
///
/// # Errors
/// `Usage`, with the path.
pub(crate) fn read_once<'a>(paths: impl IntoIterator<Item = &'a Path>) -> Result<()> {
    let mut seen = Vec::new();
    for path in paths.into_iter().filter(|p| is_stream(p)) {
        let own = identity(path);
        if seen.contains(&own) {
            return Err(Error::usage("it is named twice as an input, and a pipe can be read only once")
                .with_file(path)
                .with_hint("write what comes into a file, and name the file"));
        }
        seen.push(own);
    }
    Ok(())
}

/// What makes a stream the same under several names.
#[cfg(unix)]
fn identity(path: &Path) -> (PathBuf, u64, u64) {
    use std::os::unix::fs::MetadataExt;
    let real = if path == Path::new("-") { Path::new("/dev/stdin") } else { path };
    match std::fs::metadata(real) {
        Ok(m) if !m.is_file() => (PathBuf::new(), m.dev(), m.ino()),
        _ => (path.to_owned(), 0, 0),
    }
}

#[cfg(not(unix))]
fn identity(path: &Path) -> PathBuf {
    path.to_owned()
}
