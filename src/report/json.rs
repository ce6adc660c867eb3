//! JSON as people read it.

use crate::{Error, Result};
use serde_json::Value;

/// A value over many lines, the last one ended.
///
/// # Errors
/// `NotComputed` where it cannot be written.
pub fn object(value: &Value) -> Result<String> {
    let mut text = serde_json::to_string_pretty(value).map_err(|e| Error::not_computed(e.to_string()))?;
    text.push('\n');
    Ok(text)
}
