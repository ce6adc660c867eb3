//! Stub.
use crate::Result;
use crate::model::Model;
pub(super) fn text(_: &Model) -> Result<String> { Ok(String::new()) }
