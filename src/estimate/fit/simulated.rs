//! The simulator as a rig.

use super::options::FitOptions;
use super::rig::{Rig, Track};
use crate::model::Model;
use crate::record::{Recording, Span};
use crate::{Error, Result};

/// A model on the window of a recording, ready to run.
pub fn rig(
    _model: &Model,
    _recording: &Recording,
    _tracks: &[Track],
    _window: Span,
    _options: &FitOptions<'_>,
) -> Result<Box<dyn Rig>> {
    Err(Error::not_computed("fitting needs the simulator"))
}
