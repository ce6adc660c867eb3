//! Purpose: find out which file a name means before anything is written to it.
//!
//! Method: a file that is there is known by its device and number (by its full path where the system has no such
//! numbers), whatever it is called: by another path, a link, a hard link, in other letters. A file that is not
//! there yet is known by the full path of its folder and its own name.

use crate::{Error, Result};
use std::fs::{File, Metadata, OpenOptions};
use std::path::{Path, PathBuf};

/// As many links are followed one after the other as Linux follows.
const LINKS: usize = 40;

/// What a file is known by, whatever it is called.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Identity {
    /// Device and number on it.
    #[cfg(unix)]
    Node(u64, u64),
    /// Full path without links.
    Path(PathBuf),
}

/// A place for one result: standard output for `-`, else a file. Links are followed, and what is no file (a
/// device, a pipe) is written to as it stands.
#[derive(Debug)]
pub struct Place {
    given: PathBuf,
    identity: Option<Identity>,
    /// The file that was read and may be replaced nevertheless.
    replaces: Option<Identity>,
    pub(super) way: Way,
}

#[derive(Debug)]
pub(super) enum Way {
    StandardOutput,
    /// A file that is replaced whole, by its full path.
    File(PathBuf),
    AsItStands(File),
}

/// Opens places before the work starts, so that a wrong path costs no time.
///
/// # Errors
/// A folder, a folder that is not there or cannot be written into, a file that is write-protected, two results
/// for one place.
pub fn open<const N: usize>(paths: [Option<&Path>; N]) -> Result<[Option<Place>; N]> {
    let mut places = [const { None }; N];
    for (at, path) in paths.into_iter().enumerate() {
        let Some(path) = path else { continue };
        let place = Place::open(path)?;
        if places[..at].iter().flatten().any(|earlier| place.is_same(earlier)) {
            return Err(Error::usage("two results would be written to this place")
                .with_file(place.given())
                .with_hint("name a file for each"));
        }
        places[at] = Some(place);
    }
    Ok(places)
}

/// Refuses places where something lies that was read; `-` among what was read is standard input.
pub fn spare<'a>(
    places: impl IntoIterator<Item = &'a Place>,
    read: impl IntoIterator<Item = impl AsRef<Path>>,
) -> Result<()> {
    let read: Vec<Identity> = read.into_iter().filter_map(|path| of_source(path.as_ref())).collect();
    for place in places {
        if place
            .identity
            .as_ref()
            .is_some_and(|own| read.contains(own) && place.replaces.as_ref() != Some(own))
        {
            return Err(Error::usage("this file is read: the result would destroy it")
                .with_file(&place.given)
                .with_hint("name another file for the result"));
        }
    }
    Ok(())
}

impl Place {
    /// Opens one place.
    pub fn open(path: &Path) -> Result<Self> {
        if path == Path::new("-") {
            return Ok(Self::standard_output(path));
        }
        // asked by the name as it is given: a pipe behind `/dev/stdout` has no name of its own that could be resolved
        let way = match std::fs::metadata(path) {
            Ok(there) if there.is_dir() => {
                return Err(Error::usage("this is a folder; name a file").with_file(path));
            }
            Ok(there) if is_standard_output(&there) => return Ok(Self::standard_output(path)),
            Ok(there) if there.is_file() => {
                let real = resolved(path)?;
                writable(path, &real, &there)?;
                Way::File(real)
            }
            Ok(_) => {
                let opened = OpenOptions::new().write(true).open(path);
                Way::AsItStands(opened.map_err(|e| Error::io(path, &e))?)
            }
            Err(_) => Way::File(resolved(path)?),
        };
        let mut identity = if let Way::AsItStands(file) = &way { of_pipe(file) } else { None };
        if let Way::File(real) = &way {
            let folder = real.parent().unwrap_or(Path::new("."));
            // tried and taken away again: nothing is left by a program that is killed while it computes
            tempfile::Builder::new()
                .prefix(".gyrospec-")
                .tempfile_in(folder)
                .map_err(|e| Error::io(path, &e))?;
            identity = Some(of_file(real).unwrap_or_else(|| Identity::Path(folded(real))));
        }
        Ok(Self { given: path.to_owned(), identity, replaces: None, way })
    }

    fn standard_output(path: &Path) -> Self {
        let identity = standard(&std::io::stdout()).and_then(|there| of_metadata(&there));
        // in a message about results, `-` alone would be read as standard input
        let given = if path == Path::new("-") { Path::new("standard output") } else { path };
        Self { given: given.to_owned(), identity, replaces: None, way: Way::StandardOutput }
    }

    /// The same place, where this file may be replaced although it was read: a model that is fitted in place.
    #[must_use]
    pub fn in_place_of(mut self, read: &Path) -> Self {
        self.replaces = of_file(read);
        self
    }

    /// Whether the result replaces the file that was read and may be.
    pub fn is_in_place(&self) -> bool {
        self.replaces.is_some() && self.replaces == self.identity
    }

    /// Whether the result goes to standard output, so that nothing else may.
    pub fn is_standard_output(&self) -> bool {
        matches!(self.way, Way::StandardOutput)
    }

    /// The folder, without links, of a result that is a file.
    pub fn folder(&self) -> Option<&Path> {
        if let Way::File(real) = &self.way { real.parent() } else { None }
    }

    /// The path as it was given, for messages.
    pub(super) fn given(&self) -> &Path {
        &self.given
    }

    fn is_same(&self, other: &Self) -> bool {
        let both = self.is_standard_output() && other.is_standard_output();
        both || (self.identity.is_some() && self.identity == other.identity)
    }
}

/// The full path that a name means, without links; of a file that is not there yet, that of its folder and its name.
fn resolved(path: &Path) -> Result<PathBuf> {
    let mut name = path.to_owned();
    for _ in 0..LINKS {
        match name.canonicalize() {
            Ok(real) => return Ok(real),
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => {}
            Err(e) => return Err(Error::io(path, &e)),
        }
        match name.read_link() {
            // a link to what is not there: its target is what is to be written
            Ok(target) => name = name.parent().unwrap_or(Path::new("")).join(target),
            Err(_) => return new_file(&name).map_err(|e| e.with_file(path)),
        }
    }
    Err(Error::usage("too many links, one after the other").with_file(path))
}

fn new_file(path: &Path) -> Result<PathBuf> {
    let spelt = path.to_string_lossy();
    let ends: &[&str] = if cfg!(windows) { &["/", "/.", "\\", "\\."] } else { &["/", "/."] };
    let Some(name) = path.file_name().filter(|_| !ends.iter().any(|end| spelt.ends_with(end))) else {
        return Err(Error::usage("this names a folder, and there is none; name a file"));
    };
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    match folder.canonicalize() {
        Ok(folder) if folder.is_dir() => Ok(folder.join(name)),
        _ => Err(Error::usage("there is no such folder to write into").with_hint("make the folder first")),
    }
}

/// Refuses a file that must not be written, although its folder would let it be replaced.
fn writable(given: &Path, real: &Path, there: &Metadata) -> Result<()> {
    if there.permissions().readonly() {
        return Err(Error::usage("this file is write-protected")
            .with_file(given)
            .with_hint("name another file, or take the protection away"));
    }
    OpenOptions::new().write(true).open(real).map(|_| ()).map_err(|e| Error::io(given, &e))
}

/// The identity of what was read; `-` is standard input. Only files can be destroyed.
fn of_source(path: &Path) -> Option<Identity> {
    if path == Path::new("-") { of_metadata(&standard(&std::io::stdin())?) } else { of_file(path) }
}

/// The identity of a file that is there.
#[cfg(unix)]
fn of_file(path: &Path) -> Option<Identity> {
    of_metadata(&std::fs::metadata(path).ok()?)
}

#[cfg(unix)]
fn of_metadata(there: &Metadata) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    there.is_file().then(|| Identity::Node(there.dev(), there.ino()))
}

#[cfg(not(unix))]
fn of_file(path: &Path) -> Option<Identity> {
    path.canonicalize().ok().filter(|p| p.is_file()).map(|p| Identity::Path(folded(&p)))
}

#[cfg(not(unix))]
fn of_metadata(_: &Metadata) -> Option<Identity> {
    None
}

/// The identity of a pipe, in which two results would be mingled; a terminal or `/dev/null` takes as many as come.
#[cfg(unix)]
fn of_pipe(file: &File) -> Option<Identity> {
    use std::os::unix::fs::{FileTypeExt, MetadataExt};
    let there = file.metadata().ok()?;
    let mingles = there.file_type().is_fifo() || there.file_type().is_socket();
    mingles.then(|| Identity::Node(there.dev(), there.ino()))
}

#[cfg(not(unix))]
fn of_pipe(_: &File) -> Option<Identity> {
    None
}

/// The path in the letters by which the system's usual file systems tell names apart.
fn folded(path: &Path) -> PathBuf {
    let blind = cfg!(any(windows, target_os = "macos"));
    if blind { path.to_string_lossy().to_lowercase().into() } else { path.to_owned() }
}

/// What a standard stream is connected with.
#[cfg(unix)]
fn standard(stream: &impl std::os::fd::AsFd) -> Option<Metadata> {
    File::from(stream.as_fd().try_clone_to_owned().ok()?).metadata().ok()
}

#[cfg(not(unix))]
fn standard<T>(_: &T) -> Option<Metadata> {
    None
}

/// Whether a file or pipe is the one that standard output goes to, as `/dev/stdout` is.
#[cfg(unix)]
fn is_standard_output(there: &Metadata) -> bool {
    use std::os::unix::fs::{FileTypeExt, MetadataExt};
    let named = |m: &Metadata| (m.dev(), m.ino());
    let sort = there.file_type();
    let kept = sort.is_file() || sort.is_fifo() || sort.is_socket();
    kept && standard(&std::io::stdout()).is_some_and(|own| named(&own) == named(there))
}

#[cfg(not(unix))]
fn is_standard_output(_: &Metadata) -> bool {
    false
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn every_spelling_of_a_new_file_is_the_same_place() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        std::fs::create_dir(root.join("a")).unwrap();
        std::os::unix::fs::symlink("new.x", root.join("link")).unwrap();
        std::os::unix::fs::symlink("../link", root.join("a/link")).unwrap();
        std::os::unix::fs::symlink(".", root.join("here")).unwrap();
        for other in ["./new.x", "a/../new.x", "link", "a/link", "here/new.x", ".//new.x"] {
            let both = [root.join("new.x"), root.join(other)];
            let refused = open([Some(&both[0]), None, Some(&both[1])]).unwrap_err();
            assert!(refused.message().contains("two results"), "{other}: {refused}");
        }
        assert!(open([Some(&root.join("new.x")), Some(&root.join("a/new.x"))]).is_ok());
        assert_eq!(
            std::fs::read_dir(root).unwrap().count(),
            3,
            "a place that is opened leaves nothing behind"
        );
    }

    #[test]
    fn what_cannot_become_a_file_is_refused_before_the_work() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        std::os::unix::fs::symlink("round", path("round")).unwrap();
        std::os::unix::fs::symlink("no/such/file", path("lost")).unwrap();
        std::fs::write(path("file"), "").unwrap();
        for (name, says) in [
            ("", "folder"),
            ("new.x/", "names a folder"),
            ("new.x/.", "names a folder"),
            ("no/such", "no such folder"),
            ("lost", "no such folder"),
            ("round", ""),
            ("file/new.x", ""),
        ] {
            let refused = Place::open(&path(name)).unwrap_err().to_string();
            assert!(refused.contains(says), "{name}: {refused}");
        }
    }
}
