//! A recording of a ship's motion, with or without units in its header.

use super::Arguments;
use super::options::{Against, RowOptions};
use crate::cli::input::Held;
use crate::model::Model;
use crate::record::quality;
use crate::record::{Input, Recording};
use crate::rolling::{Compass, Recorded, analyse};
use crate::units::{counted, figure};
use crate::{Error, Result};
use std::path::Path;

/// The rolling error on a recorded roll, as it is asked for.
pub fn asked(compass: &Compass, recording: &Recording, a: &Arguments, rows: &RowOptions) -> Result<Recorded> {
    if a.motion.is_named() || rows.against != Against::Heading {
        return Err(Error::usage("a recording is the motion, and its rows run over headings")
            .with_hint("leave the options of the motion but --band, and --against, away"));
    }
    let name = roll_name(recording, a.roll.as_deref())?;
    let recording = &without_faults(recording, &name)?;
    let mut compass = compass.clone();
    if let (Some(latitude), None) = (recording.constant("lat"), &a.instrument.latitude) {
        compass.sphere.latitude = latitude;
        compass.sphere.check()?;
    }
    let analysis = analyse(recording, &name)?;
    let (band, headings, days) = (a.motion.band()?, rows.headings()?, rows.days()?);
    Ok(Recorded { compass, analysis, band, headings, days })
}

/// The recording without samples of a channel that nothing honest makes; what was left out is told.
fn without_faults(recording: &Recording, name: &str) -> Result<Recording> {
    let faults = quality::channel_faults(recording.channel(name)?, recording.kind);
    for fault in faults.iter().filter(|f| f.sure && f.kind.spoils()) {
        let ends = (fault.spans.first(), fault.spans.last());
        let (first, last) = (ends.0.map_or(0.0, |s| s.from), ends.1.map_or(0.0, |s| s.to));
        let place = if first == last {
            format!("at {} s", figure(first))
        } else {
            format!("from {} to {} s", figure(first), figure(last))
        };
        let (samples, are) =
            (counted(fault.samples, "sample"), if fault.samples == 1 { "is" } else { "are" });
        let kind = fault.kind.code();
        crate::cli::warn(&format!(
            "{name}: {samples} {are} left out, {place} ({kind}); `gyrospec record` shows what is there"
        ));
    }
    Ok(quality::masked(recording, &faults))
}

/// Reads a recording. For a bare CSV whose header has no units, `roll` as NAME:UNIT says what
/// the roll column is; its first column is then time in seconds.
pub fn read(held: &Held, roll: Option<&str>) -> Result<Recording> {
    let path = held.path();
    let toml = Input::open(path).is_ok_and(|input| input.is_toml());
    let recording = match roll.and_then(|r| r.split_once(':')) {
        Some((name, unit)) if !toml => with_units(path, name, unit).map(|r| held.named(r)),
        _ => held.recording().map_err(|e| if toml { no_tables(path, e) } else { hinted(path, e) }),
    };
    recording.map_err(|e| held.place(e))
}

/// A TOML file that is neither a recording nor a compass.
fn no_tables(path: &Path, e: Error) -> Error {
    let readable = std::fs::read_to_string(path).ok().and_then(|t| t.parse::<toml::Table>().ok());
    match readable {
        Some(t) if !t.contains_key("tables") => {
            Error::bad_input("neither a compass nor a recording").with_file(path).with_hint(
                "a compass has its numbers under [parameters], a recording its files under [[tables]]",
            )
        }
        _ => e,
    }
}

fn hinted(path: &Path, e: Error) -> Error {
    if !path.exists() {
        // what is no file may be a built-in model's name with a slip in it
        let unknown = Model::builtin(&path.to_string_lossy()).err();
        let near = unknown.as_ref().and_then(|e| e.hint()).filter(|hint| hint.contains("nearest"));
        return e.with_hint(near.unwrap_or(
            "give a recording, a file with [parameters], or the name of a built-in model (gyrospec models)",
        ));
    }
    match e.hint() {
        Some(hint) => {
            let all = format!(
                "{hint}; or, if the first column is time in seconds, say which column is the roll: \
                 --roll NAME:UNIT, such as --roll roll_deg:deg"
            );
            e.with_hint(all)
        }
        None => e.with_hint("say which column is the roll: --roll NAME:UNIT, such as --roll roll_deg:deg"),
    }
}

/// The roll channel: the one asked for, else `roll`, else the only one whose name starts so.
fn roll_name(recording: &Recording, asked: Option<&str>) -> Result<String> {
    if let Some(name) = asked {
        return Ok(name.split_once(':').map_or(name, |(n, _)| n).to_owned());
    }
    if recording.find("roll").is_some() {
        return Ok("roll".into());
    }
    let mut rolls = recording.channels.iter().filter(|c| c.name.to_lowercase().starts_with("roll"));
    if let (Some(only), None) = (rolls.next(), rolls.next()) {
        return Ok(only.name.clone());
    }
    let names: Vec<&str> = recording.channels.iter().map(|c| c.name.as_str()).collect();
    Err(Error::usage("which channel is the roll angle?")
        .with_hint(format!("say --roll NAME; the recording has {}", names.join(", "))))
}

fn with_units(path: &Path, name: &str, unit: &str) -> Result<Recording> {
    crate::units::Unit::parse(unit)?;
    let first = first_column(path)?;
    if first == name {
        return Err(Error::bad_input(format!(
            "the roll `{name}` is the first column, which must be time: the recording has no column of time"
        ))
        .with_file(path)
        .with_hint(
            "put the time in s into the first column, or describe the file in a TOML recording with \
             time = { start = 0.0, step = 0.1, unit = \"s\" }",
        ));
    }
    let quoted = |t: &str| toml::Value::String(t.to_owned()).to_string();
    let form = format!(
        "name = {}\n[[tables]]\nfile = {}\ntime = {{ column = {}, unit = \"s\" }}\n[tables.channels]\n{} = {{ column = {}, unit = {} }}\n",
        quoted(&path.file_stem().unwrap_or_default().to_string_lossy()),
        quoted(&path.to_string_lossy()),
        quoted(&first),
        quoted(name),
        quoted(name),
        quoted(unit)
    );
    let mut recording = Recording::parse(&form, "")?;
    // The first source is the text above, which is no file.
    recording.sources.remove(0);
    Ok(recording)
}

/// The name of the first column, as the header has it.
fn first_column(path: &Path) -> Result<String> {
    let input = Input::open(path)?;
    let start = String::from_utf8_lossy(input.start()).into_owned();
    let line = start.split(['\n', '\r']).next().unwrap_or_default();
    Ok(line.split(',').next().unwrap_or_default().trim().trim_matches('"').to_owned())
}
