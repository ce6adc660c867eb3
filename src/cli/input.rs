//! Inputs that a call names: a file, a pipe, or standard input for `-`.

use crate::record::{Input, Recording, is_stream, read_text};
use crate::{Error, Result};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

/// The whole text of a file; `-` is standard input.
pub fn text(path: &Path) -> Result<String> {
    Ok(read_text(path)?.0)
}

/// An input that may be read again and again: a file where it lies, or what a pipe brought, kept in a file of its
/// own while this lives.
pub struct Held {
    given: PathBuf,
    kept: Option<(tempfile::TempDir, PathBuf)>,
}

impl Held {
    /// Holds an input; a pipe is read to its end.
    pub fn of(given: &Path) -> Result<Self> {
        let kept = if is_stream(given) { Some(kept(given).map_err(|e| Error::io(given, &e))?) } else { None };
        Ok(Self { given: given.to_owned(), kept })
    }

    /// Where it can be read.
    pub fn path(&self) -> &Path {
        self.kept.as_ref().map_or(&self.given, |(_, path)| path)
    }

    /// As the call names it.
    pub fn given(&self) -> &Path {
        &self.given
    }

    /// The recording in it, in which everything bears the name of the call.
    pub fn recording(&self) -> Result<Recording> {
        let Some((_, path)) = &self.kept else { return Recording::read(&self.given) };
        let input = Input::open(path)?;
        if input.is_toml() {
            return Recording::parse(&input.text()?.0, &self.given);
        }
        let recording = Recording::read(path).map_err(|e| self.place(e))?;
        Ok(self.named(recording))
    }

    /// A recording whose sources and notes name the input as the call does.
    pub fn named(&self, mut recording: Recording) -> Recording {
        let sources = recording.sources.iter_mut().map(|s| &mut s.file);
        let notes = recording.notes.iter_mut().map(|n| &mut n.file);
        for file in sources.chain(notes).filter(|file| **file == self.path()) {
            file.clone_from(&self.given);
        }
        recording
    }

    /// An error that names the input as the call does.
    pub fn place(&self, e: Error) -> Error {
        if e.file() == Some(self.path()) { e.with_file(&self.given) } else { e }
    }
}

/// Bytes without the end of a line from which on what comes is no text.
const LONGEST_LINE: usize = 16 << 20;
/// Most bytes that a pipe may bring.
const MOST: usize = 8 << 30;

fn kept(given: &Path) -> std::io::Result<(tempfile::TempDir, PathBuf)> {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("standard input");
    let file = std::fs::File::create(&path)?;
    if given == Path::new("-") {
        copied(std::io::stdin().lock(), file)?;
    } else {
        copied(std::fs::File::open(given)?, file)?;
    }
    Ok((folder, path))
}

/// Copies to the end; what has none, as a device that brings zeros for ever, is refused.
fn copied(mut from: impl Read, mut to: impl Write) -> std::io::Result<()> {
    let (mut block, mut all, mut ended, mut packed) = (vec![0; 1 << 20], 0, false, false);
    loop {
        let count = match from.read(&mut block) {
            Err(e) if e.kind() == std::io::ErrorKind::Interrupted => continue,
            other => other?,
        };
        let got = &block[..count];
        if got.is_empty() {
            return Ok(());
        }
        packed |= all == 0 && got.starts_with(&[0x1f, 0x8b]);
        ended |= packed || got.iter().any(|b| matches!(b, b'\n' | b'\r'));
        all += got.len();
        if !ended && all >= LONGEST_LINE {
            return Err(std::io::Error::other("16 MiB without the end of a line: this is no text"));
        }
        if all > MOST {
            return Err(std::io::Error::other("more than 8 GiB, and no end: give a file"));
        }
        to.write_all(got)?;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_never_ends_is_refused_and_all_else_copied() {
        let e = copied(std::io::repeat(0), std::io::sink()).unwrap_err();
        assert!(e.to_string().contains("without the end of a line"), "{e}");
        let text = "t,roll\n".repeat(1 << 20);
        let mut to = Vec::new();
        copied(text.as_bytes(), &mut to).unwrap();
        assert!(to == text.as_bytes());
    }
}
