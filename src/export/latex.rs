//! Stub.
use crate::model::Model;
pub(super) fn text(_: &Model) -> String { String::new() }
