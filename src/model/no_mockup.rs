//! What stands for Functional Mock-up Units where they are not built in.
// the forms are those of the room that is left out
#![allow(clippy::unnecessary_wraps, clippy::unused_self)]

use super::Model;
use super::form::Form;
use crate::record::{Recording, Source};
use crate::{Error, Result};
use std::path::{Path, PathBuf};

fn refused() -> Error {
    Error::bad_input("this build reads no Functional Mock-up Units")
        .with_hint("build it with its feature fmu")
}

pub(super) fn is_unit(path: &Path) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case("fmu"))
}

pub(super) fn read_whole(path: &Path) -> Result<(Model, Source)> {
    Err(refused().with_file(path))
}

pub(super) fn begun(root: &Form<'_>, _: Option<&Path>) -> Result<Option<Model>> {
    if root.field("fmu").is_some() { Err(root.error("fmu", refused())) } else { Ok(None) }
}

/// Nothing is spoken of.
pub(super) struct Speaking;

pub(super) fn speaking(_: &Model) -> Speaking {
    Speaking
}

pub(super) fn has_units(_: &Model) -> bool {
    false
}

pub(super) fn has(_: &Model) -> bool {
    false
}

pub(super) fn name_of(_: &Model, key: &str) -> String {
    key.to_owned()
}

pub(super) fn finish(_: &mut Model, _: &Form<'_>) -> Result<()> {
    Ok(())
}

/// What a unit gave; see the room for units.
pub(crate) struct Ran {
    pub times: Vec<f64>,
    pub outputs: Vec<Vec<f64>>,
}

impl Model {
    pub(super) fn steps(&self, _: &str) -> bool {
        false
    }

    pub(crate) fn stepping(&self) -> Vec<usize> {
        Vec::new()
    }

    pub(crate) fn stepped_as(&self) -> Vec<Option<usize>> {
        Vec::new()
    }

    pub(crate) fn step(&self, _: &Recording) -> Result<Ran> {
        Err(refused())
    }

    pub(crate) fn slopes_by(&self, _: &Recording, _: usize) -> Result<(usize, Vec<Vec<f64>>)> {
        Err(refused())
    }

    pub(crate) fn refusal(&self) -> Option<Error> {
        None
    }

    pub(super) fn unit_source(&self) -> Option<&Source> {
        None
    }

    pub(super) fn unit_notes(&self) -> Vec<String> {
        Vec::new()
    }

    pub(super) fn unit_file_mut(&mut self) -> Option<&mut PathBuf> {
        None
    }

    pub(super) fn unit_line(&self) -> String {
        String::new()
    }

    pub(super) fn key_of(&self, _: &str, name: &str) -> (String, Option<String>) {
        (name.to_owned(), None)
    }

    pub(super) fn stepped(&self, _: &Recording) -> Result<Option<Recording>> {
        Ok(None)
    }
}
