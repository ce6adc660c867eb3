//! Texts that a call names: a file, or standard input for `-`.

use crate::{Error, Result};
use std::io::Read;
use std::path::Path;

/// The whole text of a file; `-` is standard input.
pub fn text(path: &Path) -> Result<String> {
    if path != Path::new("-") {
        return std::fs::read_to_string(path).map_err(|e| Error::io(path, &e));
    }
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).map_err(|e| Error::io(Path::new("standard input"), &e))?;
    Ok(text)
}
