//! Which compass a call names.

use super::input;
use crate::Result;
use crate::model::Model;
use crate::rolling::Compass;
use std::path::Path;

/// Whether the path is a built-in model, or TOML with parameters or a model's base.
pub fn has_parameters(path: &Path) -> bool {
    if !path.exists() {
        return is_builtin(path);
    }
    let Ok(text) = input::text(path) else { return false };
    text.parse::<toml::Table>().is_ok_and(|t| t.contains_key("parameters") || t.contains_key("extends"))
}

fn is_builtin(path: &Path) -> bool {
    path.to_str().is_some_and(|name| Model::builtin(name).is_ok())
}

/// The compass of a file or a built-in model; without a path it is the paper's.
pub fn named(path: Option<&Path>) -> Result<Compass> {
    let Some(path) = path else { return Ok(Compass::paper()) };
    let read = if !path.exists() && is_builtin(path) {
        Compass::builtin(&path.to_string_lossy())
    } else {
        Compass::parse(&input::text(path)?)
    };
    read.map_err(|e| e.with_file(path))
}
