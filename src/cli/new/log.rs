//! The recording file of an NMEA 0183 log: a channel for each field that is known.

use super::identifier::identifier;
use crate::record::{Contents, Listed};
use crate::text::{in_line, toml_string};
use std::collections::BTreeSet;

/// The first line of the file.
pub const HEAD: &str =
    "Written from the sentences of the log, in the units of their standard: take out what is not needed.";

/// The lines below the name of the file.
pub fn body(log: &Contents) -> String {
    let mut out = format!(
        "format = \"nmea0183\"\ntime = {{ start = {} }}  # the zero of time: the first in the log\n[tables.channels]\n",
        toml_string(&log.start)
    );
    let mut taken = BTreeSet::new();
    out.extend(log.fields.iter().map(|field| channel(field, &mut taken)));
    if let Some(says) = &log.unknown {
        out += &format!("# {}\n", in_line(says));
    }
    out
}

fn channel(field: &Listed, taken: &mut BTreeSet<String>) -> String {
    let id = field.id.map_or_else(String::new, |id| format!(", id = {id}"));
    let wraps = if field.wraps { ", wraps = true" } else { "" };
    let line = format!(
        "{} = {{ sentence = {}{id}, field = {}, unit = \"{}\"{wraps} }}\n",
        identifier(&field.name, taken),
        toml_string(&field.sentence),
        field.field,
        field.unit
    );
    if field.has_numbers { line } else { format!("# {}  # left out, as it holds nothing\n", line.trim_end()) }
}
