//! Unpacks the archive of a unit into a folder of our own: nothing lands outside, nothing grows without bound.

use crate::{Error, Result};
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;
use tempfile::TempDir;
use zip::ZipArchive;

/// Entries that an archive may have.
const ENTRIES: usize = 20_000;
/// Bytes that it may unpack to.
const BYTES: u64 = 1 << 30;

/// Unpacks an archive.
pub(super) fn unpack(path: &Path) -> Result<TempDir> {
    let wrong = |e: &dyn std::fmt::Display| {
        Error::bad_input(format!("this is no archive of a Functional Mock-up Unit: {e}"))
            .with_hint("an FMU is a ZIP file with modelDescription.xml in it; export it once more")
    };
    let file = File::open(path).map_err(|e| Error::io(path, &e))?;
    let mut archive = ZipArchive::new(file).map_err(|e| wrong(&e))?;
    if archive.len() > ENTRIES {
        return Err(wrong(&format!("it has {} entries, more than {ENTRIES}", archive.len())));
    }
    let folder = match std::env::var_os(super::FOLDER) {
        Some(place) => TempDir::new_in(place),
        None => TempDir::new(),
    };
    let folder = folder.map_err(|e| Error::io(Path::new("a temporary folder"), &e))?;
    let mut left = BYTES;
    for i in 0..archive.len() {
        let entry = archive.by_index(i).map_err(|e| wrong(&e))?;
        let name = entry.name().map_err(|e| wrong(&e))?.into_owned();
        let is_folder = entry.is_dir();
        let Some(inside) = entry.enclosed_name() else {
            return Err(wrong(&format!("its entry {name:?} lies outside of it")));
        };
        if entry.is_symlink() {
            return Err(wrong(&format!("its entry {name:?} is a link")));
        }
        let to = folder.path().join(inside);
        if is_folder {
            fs::create_dir_all(&to).map_err(|e| Error::io(&to, &e))?;
            continue;
        }
        if let Some(parent) = to.parent() {
            fs::create_dir_all(parent).map_err(|e| Error::io(parent, &e))?;
        }
        let mut out = File::create(&to).map_err(|e| Error::io(&to, &e))?;
        let copied = io::copy(&mut entry.take(left + 1), &mut out)
            .map_err(|e| wrong(&format!("its entry {name:?} is damaged: {e}")))?;
        left = left.checked_sub(copied).ok_or_else(|| wrong(&"it unpacks to more than 1 GiB"))?;
    }
    Ok(folder)
}
