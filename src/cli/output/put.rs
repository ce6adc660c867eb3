//! Purpose: put results in place whole, all of them or none.
//!
//! Method: each is written beside its place first, then what is no file gets its share, and only then all are
//! moved into place. Where a move fails, those before it are undone from second names of the old files.
#![allow(clippy::exit)]

use super::place::{Place, Way, spare};
use super::print;
use crate::text::{in_quotes, shown};
use crate::{Error, Result};
use std::fs::Metadata;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};
use tempfile::{NamedTempFile, TempPath};

const PREFIX: &str = ".gyrospec-";

/// Files under way, to be taken away when the program is interrupted.
static UNDER_WAY: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// A result that is written and not yet in its place.
struct Fresh {
    file: NamedTempFile,
    /// Full path of its place.
    path: PathBuf,
    given: PathBuf,
}

/// A result with its place, as it may be shown.
pub struct Ready {
    place: Place,
    bytes: Vec<u8>,
}

impl Place {
    /// Words for here: what in them would steer a terminal is shown as an escape.
    pub fn words(self, text: &str) -> Ready {
        Ready { place: self, bytes: shown(text).into_owned().into_bytes() }
    }

    /// JSON for here, or TOML whose strings stand in double quotes: the same, in that language's own escapes.
    pub fn quoted(self, text: &str) -> Ready {
        Ready { place: self, bytes: in_quotes(text).into_owned().into_bytes() }
    }

    /// Data for here as they are, or a page whose texts are escaped already.
    pub fn data(self, data: impl Into<Vec<u8>>) -> Ready {
        Ready { place: self, bytes: data.into() }
    }
}

/// Puts results in place, and refuses to where something lies that was read.
///
/// # Errors
/// What could not be written; then no file is replaced.
pub fn put(results: &[Ready], read: impl IntoIterator<Item = impl AsRef<Path>>) -> Result<()> {
    spare(results.iter().map(|r| &r.place), read)?;
    clean_up_when_interrupted();
    let mut written = Vec::new();
    for Ready { place, bytes } in results {
        if let Way::File(path) = &place.way {
            let file = beside(path, bytes).map_err(|e| Error::io(place.given(), &e))?;
            written.push(Fresh { file, path: path.clone(), given: place.given().to_owned() });
        }
    }
    for Ready { place, bytes } in results {
        match &place.way {
            Way::StandardOutput => print(bytes)?,
            Way::AsItStands(file) => {
                (&*file).write_all(bytes).map_err(|e| Error::io(place.given(), &e))?;
            }
            Way::File(_) => {}
        }
    }
    move_all(written)
}

/// Writes a file beside its place, with the mode and the owner of the one that it replaces.
fn beside(path: &Path, bytes: &[u8]) -> std::io::Result<NamedTempFile> {
    let old = std::fs::metadata(path).ok();
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX);
    #[cfg(unix)]
    if old.is_none() {
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(path.parent().unwrap_or(Path::new(".")))?;
    under_way().push(file.path().to_owned());
    if let Some(old) = old {
        inherit(&file, &old)?;
    }
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    Ok(file)
}

/// Gives a new file the owner (where the user may give files away) and the mode of the old one.
fn inherit(new: &NamedTempFile, old: &Metadata) -> std::io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        let own = new.as_file().metadata()?;
        if (own.uid(), own.gid()) != (old.uid(), old.gid()) {
            // a user who may not give files away may still keep the group
            let _ = fchown(new.as_file(), Some(old.uid()), Some(old.gid()))
                .or_else(|_| fchown(new.as_file(), None, Some(old.gid())));
        }
    }
    new.as_file().set_permissions(old.permissions())
}

/// Moves files into place: all of them, or none. An interrupt waits till then.
fn move_all(written: Vec<Fresh>) -> Result<()> {
    let mut under_way = under_way();
    let mut done: Vec<(PathBuf, Option<TempPath>)> = Vec::new();
    let count = written.len();
    for (at, Fresh { file, path, given }) in written.into_iter().enumerate() {
        // after the last there is nothing left that may fail
        let old = if at + 1 < count { second_name(&path) } else { Ok(None) };
        let moved = old.and_then(|old| file.persist(&path).map(|_| old).map_err(|e| e.error));
        match moved {
            Ok(old) => done.push((path, old)),
            Err(e) => {
                undo(done);
                return Err(Error::io(&given, &e));
            }
        }
    }
    under_way.clear();
    Ok(())
}

/// A second name for a file that is to be replaced; a copy where the file system has no such names, or where a name
/// of another's file could not be taken away again. It is taken away when it is dropped.
fn second_name(path: &Path) -> std::io::Result<Option<TempPath>> {
    if !path.exists() {
        return Ok(None);
    }
    let folder = path.parent().unwrap_or(Path::new("."));
    let linked = tempfile::Builder::new().prefix(PREFIX).make_in(folder, |name| {
        let named = if is_sticky(folder) { None } else { std::fs::hard_link(path, name).ok() };
        named.map_or_else(|| std::fs::copy(path, name).map(|_| ()), Ok)
    })?;
    Ok(Some(linked.into_temp_path()))
}

/// Whether only the owner of a file may take it out of this folder, as in `/tmp`.
#[cfg(unix)]
fn is_sticky(folder: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    std::fs::metadata(folder).is_ok_and(|own| own.mode() & 0o1000 != 0)
}

#[cfg(not(unix))]
fn is_sticky(_: &Path) -> bool {
    false
}

/// Puts back what stood where files were moved to.
fn undo(done: Vec<(PathBuf, Option<TempPath>)>) {
    for (path, old) in done.into_iter().rev() {
        // where even this fails, the error that is told already is the one that matters
        let _ = match old {
            Some(old) => old.persist(&path).map_err(|e| e.error),
            None => std::fs::remove_file(&path),
        };
    }
}

fn under_way() -> MutexGuard<'static, Vec<PathBuf>> {
    UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner)
}

fn clean_up_when_interrupted() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // where no handler can be set, an interrupt leaves a hidden file at worst
        let _ = ctrlc::set_handler(|| {
            for path in under_way().drain(..) {
                let _ = std::fs::remove_file(path);
            }
            std::process::exit(130);
        });
    });
}

#[cfg(test)]
mod tests {
    use super::super::open;
    use super::*;

    /// A second name of another's file could not be taken out of a sticky folder: a copy of one's own can.
    #[cfg(unix)]
    #[test]
    fn in_a_sticky_folder_no_second_name_is_left() {
        use std::os::unix::fs::{MetadataExt, PermissionsExt};
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("old");
        std::fs::write(&path, "old").unwrap();
        for (mode, names) in [(0o700, 2), (0o1700, 1)] {
            std::fs::set_permissions(folder.path(), PermissionsExt::from_mode(mode)).unwrap();
            let second = second_name(&path).unwrap().unwrap();
            assert_eq!(std::fs::read_to_string(&second).unwrap(), "old");
            assert_eq!(std::fs::metadata(&path).unwrap().nlink(), names, "{mode:o}");
        }
    }

    /// A place that turns into a folder during the work cannot be written: the two others stay as they are.
    #[test]
    fn where_one_move_fails_none_is_made() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        std::fs::write(path("old"), "old").unwrap();
        std::fs::write(path("last"), "last").unwrap();
        let names = [path("old"), path("new"), path("last")];
        let places = open([Some(&*names[0]), Some(&*names[1]), Some(&*names[2])]).unwrap();
        let results: Vec<_> = places.into_iter().flatten().map(|p| p.words("result")).collect();
        std::fs::remove_file(path("last")).unwrap();
        std::fs::create_dir(path("last")).unwrap();
        std::fs::write(path("last/inside"), "").unwrap();
        let refused = put(&results, [&names[0]; 0]).unwrap_err();
        assert_eq!(refused.file(), Some(&*names[2]));
        assert_eq!(std::fs::read_to_string(path("old")).unwrap(), "old");
        assert!(!path("new").exists());
        let left: Vec<_> =
            std::fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
        assert_eq!(left.len(), 2, "something is left over: {left:?}");
    }
}
