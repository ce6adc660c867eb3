//! Which compass the call names.

use super::options::InstrumentOptions;
use crate::cli::input;
use crate::model::Model;
use crate::rolling::Compass;
use crate::{Error, Result};
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

/// The compass of a file or a built-in model, with what the options say of it; without a path it is the paper's.
pub fn read(path: Option<&Path>, options: &InstrumentOptions) -> Result<Compass> {
    let Some(path) = path else { return with(Compass::paper(), options) };
    let named = |e: Error| e.with_file(path);
    let compass = if !path.exists() && is_builtin(path) {
        Compass::builtin(&path.to_string_lossy()).map_err(named)?
    } else {
        Compass::parse(&input::text(path)?).map_err(named)?
    };
    with(compass, options).map_err(named)
}

/// The compass with what the options say of it.
pub fn with(mut compass: Compass, options: &InstrumentOptions) -> Result<Compass> {
    options.put(&mut compass)?;
    Ok(compass)
}
