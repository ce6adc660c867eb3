//! Results that appear whole or not at all.
#![allow(clippy::exit)]

use crate::{Error, Result};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, Once, PoisonError};

/// Files under way, to be taken away when the program is interrupted.
static UNDER_WAY: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// A place for a result: standard output for `-`, else a file that is written beside its
/// final name and moved there by [`Sink::finish`]; an interrupt leaves nothing behind. Links are
/// followed, and what is no file (a device, a pipe) is written to as it stands.
pub struct Sink {
    path: PathBuf,
    place: Place,
}

enum Place {
    StandardOutput,
    Beside(tempfile::NamedTempFile),
    AsItStands(std::fs::File),
}

impl Sink {
    /// Opens the place before the work starts, so that a wrong path costs no time.
    pub fn open(path: &Path) -> Result<Self> {
        if path == Path::new("-") {
            return Ok(Self { path: path.to_owned(), place: Place::StandardOutput });
        }
        let path = &path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let folder = match path.parent() {
            Some(p) if !p.as_os_str().is_empty() => p,
            _ => Path::new("."),
        };
        if path.is_dir() {
            return Err(Error::usage("this is a folder; name a file").with_file(path));
        }
        if !folder.is_dir() {
            return Err(Error::usage("there is no such folder to write into")
                .with_file(path)
                .with_hint("make the folder first"));
        }
        if path.exists() && !path.is_file() {
            let file = std::fs::OpenOptions::new().write(true).open(path).map_err(|e| Error::io(path, &e))?;
            return Ok(Self { path: path.to_owned(), place: Place::AsItStands(file) });
        }
        clean_up_when_interrupted();
        let mut builder = tempfile::Builder::new();
        builder.prefix(".gyrospec-");
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let file = builder.tempfile_in(folder).map_err(|e| Error::io(path, &e))?;
        under_way().push(file.path().to_owned());
        Ok(Self { path: path.to_owned(), place: Place::Beside(file) })
    }

    /// Writes the whole result and puts it in place.
    pub fn finish(self, text: &[u8]) -> Result<()> {
        let path = self.path;
        let broken = |e: std::io::Error| Error::io(&path, &e);
        match self.place {
            Place::StandardOutput => print(text),
            Place::AsItStands(mut file) => file.write_all(text).map_err(broken),
            Place::Beside(mut file) => {
                file.write_all(text).map_err(broken)?;
                file.persist(&path).map(|_| ()).map_err(|e| broken(e.error))
            }
        }
    }
}

/// Refuses results that would be written over each other or over what is read.
pub fn keep_apart<'a>(
    results: impl IntoIterator<Item = Option<&'a PathBuf>>,
    read: impl IntoIterator<Item = &'a PathBuf>,
) -> Result<()> {
    let real = |p: &PathBuf| p.canonicalize().unwrap_or_else(|_| p.clone());
    let read: Vec<PathBuf> = read.into_iter().map(real).collect();
    let mut written: Vec<PathBuf> = Vec::new();
    for path in results.into_iter().flatten() {
        let own = real(path);
        if read.contains(&own) {
            return Err(Error::usage("this file is read: the result would destroy it")
                .with_file(path)
                .with_hint("name another file for the result"));
        }
        if written.contains(&own) && (!own.exists() || own.is_file()) {
            return Err(Error::usage("two results would be written to this place")
                .with_file(path)
                .with_hint("name a file for each"));
        }
        written.push(own);
    }
    Ok(())
}

fn under_way() -> std::sync::MutexGuard<'static, Vec<PathBuf>> {
    UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner)
}

fn clean_up_when_interrupted() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // where no handler can be set, an interrupt leaves an empty hidden file at worst
        let _ = ctrlc::set_handler(|| {
            for path in under_way().drain(..) {
                let _ = std::fs::remove_file(path);
            }
            std::process::exit(130);
        });
    });
}

/// Writes to standard output; a reader that went away ends the program quietly.
pub fn print(text: &[u8]) -> Result<()> {
    let mut out = std::io::stdout().lock();
    out.write_all(text).and_then(|()| out.flush()).map_err(|e| Error::io(Path::new("standard output"), &e))
}
