//! `gyrospec roll-error --spectrum`.

use super::Arguments;
use crate::cli::output::{self, Place};
use crate::report::rolling::{spectrum_json, spectrum_page, spectrum_text};
use crate::rolling::{Compass, error_spectrum};
use crate::{Error, Result};
use std::path::PathBuf;

/// Tells the spectrum of the error on one heading.
pub fn told(compass: &Compass, a: &Arguments, html: Option<Place>, read: &[PathBuf]) -> Result<()> {
    let heading = match (a.rows.has_headings(), &a.rows.headings()?[..]) {
        (false, _) => 45f64.to_radians(),
        (_, [one]) => *one,
        _ => return Err(Error::usage("--spectrum is that of one --heading")),
    };
    let excitation = a.motion.excitation(compass.roll)?.under_way(compass.speed);
    let found = error_spectrum(compass, &excitation, heading)?;
    let to_stdout = html.as_ref().is_some_and(Place::is_standard_output);
    let text = if a.json {
        spectrum_json(compass, &excitation, &found)?
    } else {
        spectrum_text(compass, &excitation, &found)
    };
    if let Some(place) = html {
        output::put(&[place.data(spectrum_page(compass, &excitation, &found))], read)?;
    }
    if to_stdout { Ok(()) } else { super::told(&text, a.json) }
}
