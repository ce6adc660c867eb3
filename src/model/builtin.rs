//! The built-in models.

use crate::error::nearest;
use crate::{Error, Result};

/// Name and TOML text of every built-in model.
pub const BUILTIN: [(&str, &str); 5] = [
    ("gyrosphere", include_str!("builtin/gyrosphere.toml")),
    ("gyrosphere-flow", include_str!("builtin/gyrosphere-flow.toml")),
    ("gyrosphere-inertia", include_str!("builtin/gyrosphere-inertia.toml")),
    ("gyrosphere-precession", include_str!("builtin/gyrosphere-precession.toml")),
    ("gyrosphere-under-way", include_str!("builtin/gyrosphere-under-way.toml")),
];

/// The text of a built-in model.
pub(super) fn text(name: &str) -> Result<&'static str> {
    BUILTIN.iter().find(|(n, _)| *n == name).map(|(_, text)| *text).ok_or_else(|| {
        let e = Error::bad_input(format!("there is no built-in model {name:?}"));
        match near(name) {
            Some(near) => e.with_hint(format!("the nearest is {near}; `gyrospec models` lists them all")),
            None => e.with_hint("`gyrospec models` lists them all"),
        }
    })
}

/// The name of the built-in model that is nearest to a word, if one is near.
pub(super) fn near(word: &str) -> Option<&'static str> {
    nearest(word, BUILTIN.iter().map(|(name, _)| *name))
}
