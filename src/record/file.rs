//! Recordings described by a TOML file: several tables, spans, constants.

use super::form::{ChannelForm, FormatForm, HoldForm, KindForm, QuantityForm, RecordingForm};
use super::form::{SpansForm, StartForm, TableForm, TimeForm};
use super::input::Input;
use super::request::{Clock, Request, Table, Wanted};
use super::stream::{is_stream, read_once};
use super::zero::Zero;
use super::{Channel, Constant, Hold, Kind, Note, Recording, Source, Span, Spans, csv, nmea};
use crate::text::one_line;
use crate::units::{Dimension, Unit};
use crate::{Error, Result};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use toml::Spanned;

/// Reads the recording that a text describes, which stands or is to stand where its source says.
pub(super) fn parse(text: &str, source: Source) -> Result<Recording> {
    let path = source.file.clone();
    let file = File { path: &path, text };
    file.recording(source).map_err(|e| if e.file().is_some() { e } else { e.with_file(&path) })
}

struct File<'a> {
    path: &'a Path,
    text: &'a str,
}

impl File<'_> {
    fn recording(&self, source: Source) -> Result<Recording> {
        let form: RecordingForm = self.parse()?;
        let kind = match form.kind {
            KindForm::Time => Kind::Time,
            KindForm::Trials => Kind::Trials,
        };
        let mut recording = Recording {
            name: form.name.as_deref().map_or_else(|| super::stem(self.path), one_line),
            kind,
            sources: vec![source],
            ..Recording::default()
        };
        if form.tables.is_empty() {
            return Err(Error::bad_input("the recording names no [[tables]]"));
        }
        let logs = self.zero_of_logs(&form)?;
        let (mut zero, mut of_numbers) = (logs.clone(), None);
        for table in &form.tables {
            let number = recording.origins.len();
            let path = self.resolve(&table.get_ref().file, &recording.sources)?;
            let read = self.table(table, (number, zero.clone()), kind, &path)?;
            let origins = read.origins();
            if read.zero.is_none() && counts_numbers(table.get_ref(), kind) {
                of_numbers = Some(table.get_ref().file.span().start);
            }
            zero = zero.or(read.zero);
            recording.time_unit = recording.time_unit.take().or(read.time_unit);
            self.add_channels(&mut recording, read.channels, table)?;
            recording.notes.extend(read.notes);
            if !recording.sources.contains(&read.origin.source) {
                recording.sources.push(read.origin.source.clone());
            }
            recording.origins.extend(origins);
        }
        if let (None, Some(zero), Some(at)) = (&logs, &zero, of_numbers) {
            return Err(self.no_common_zero(zero, at));
        }
        recording.zero = zero;
        recording.constants = self.constants(&form.constants)?;
        if let Some(spans) = &form.spans {
            recording.spans = self.spans(spans)?;
            self.judge_spans(&mut recording);
        }
        Ok(recording)
    }

    fn parse(&self) -> Result<RecordingForm> {
        toml::from_str(self.text).map_err(|e| {
            let error = Error::bad_input(e.message().trim_end().replace('\n', "; "));
            match e.span() {
                Some(span) => self.at(error, span.start),
                None => error,
            }
        })
    }

    /// Puts the line and column of a byte into an error.
    fn at(&self, error: Error, byte: usize) -> Error {
        let before = self.text.get(..byte).unwrap_or(self.text);
        let line = before.matches('\n').count() + 1;
        let column = before.chars().rev().take_while(|c| *c != '\n').count() + 1;
        error.with_file(self.path).with_line(line).with_column(column)
    }

    fn unit(&self, text: &Spanned<String>) -> Result<Unit> {
        // The text begins one byte after its quote.
        Unit::parse(text.get_ref()).map_err(|e| self.at(e, text.span().start + 1))
    }

    fn table(
        &self,
        table: &Spanned<TableForm>,
        (number, zero): (usize, Option<Zero>),
        kind: Kind,
        path: &Path,
    ) -> Result<Table> {
        let form = table.get_ref();
        if let Some(time) = form.time.as_ref().filter(|_| kind == Kind::Trials) {
            return Err(self.at(Error::bad_input("a table of trials has no time"), time.span().start));
        }
        match form.format {
            Some(FormatForm::Nmea0183) => self.log(table, number, path),
            Some(FormatForm::Csv) | None => {
                let request = Request {
                    clock: self.clock(form.time.as_ref(), kind)?,
                    wanted: self.wanted(&form.channels)?,
                    rows: self.rows(form.rows.as_ref())?,
                    table: number,
                    zero,
                    comma: self.comma(form.decimal.as_ref())?,
                };
                csv::read(open(path)?, &request)
            }
        }
    }

    /// Whether commas are decimal, or points.
    fn comma(&self, decimal: Option<&Spanned<String>>) -> Result<Option<bool>> {
        let Some(sign) = decimal else { return Ok(None) };
        match sign.get_ref().as_str() {
            "," => Ok(Some(true)),
            "." => Ok(Some(false)),
            other => {
                let error = Error::bad_input(format!("`{other}` is no decimal sign"));
                Err(self.at(error, sign.span().start).with_hint("write decimal = \".\" or decimal = \",\""))
            }
        }
    }

    /// Where a table lies: beside this file, or from the working folder on where this came through a pipe.
    fn resolve(&self, file: &Spanned<String>, read: &[Source]) -> Result<PathBuf> {
        if file.get_ref() == "-" {
            let error = Error::bad_input("a table cannot come from standard input here");
            return Err(self.at(error, file.span().start).with_hint(
                "name a file (`./-` for one of that name), or give the table itself as the recording: `-`",
            ));
        }
        let folder = if is_stream(self.path) { None } else { self.path.parent() };
        let path = folder.unwrap_or(Path::new("")).join(file.get_ref());
        let before = read.iter().map(|source| source.file.as_path());
        read_once(before.chain([path.as_path()])).map_err(|e| self.at(e, file.span().start))?;
        Ok(path)
    }

    fn log(&self, table: &Spanned<TableForm>, number: usize, path: &Path) -> Result<Table> {
        let form = table.get_ref();
        if let Some(rows) = &form.rows {
            let error = Error::bad_input("rows cannot be picked in a log; use [spans]");
            return Err(self.at(error, rows.span().start));
        }
        if let Some(sign) = &form.decimal {
            return Err(self.at(Error::bad_input("a log has decimal points"), sign.span().start));
        }
        let zero = self.zero(table)?.nano;
        let mut wanted = Vec::new();
        for (name, channel) in in_order(&form.channels) {
            wanted.push(self.selection(name, channel)?);
        }
        nmea::read(open(path)?, &nmea::Request { zero: Some(zero), wanted, table: number })
    }

    fn no_common_zero(&self, zero: &Zero, at: usize) -> Error {
        let error = Error::bad_input(format!(
            "the times of this table are numbers, those of another count from `{}`: they have no zero in common",
            zero.text
        ));
        self.at(error, at).with_hint("write the times of all tables as dates, or of none")
    }

    /// The zero that a log gives, from which dates in other tables count too.
    fn zero_of_logs(&self, form: &RecordingForm) -> Result<Option<Zero>> {
        let mut logs =
            form.tables.iter().filter(|t| matches!(t.get_ref().format, Some(FormatForm::Nmea0183)));
        logs.next().map(|log| self.zero(log)).transpose()
    }

    /// The zero of a log's time.
    fn zero(&self, table: &Spanned<TableForm>) -> Result<Zero> {
        match table.get_ref().time.as_ref().map(|t| (t, t.get_ref())) {
            Some((at, TimeForm { start: Some(start), column: None, step: None, .. })) => {
                let text = match start {
                    StartForm::Text(text) => text.clone(),
                    StartForm::Date(date) => date.to_string(),
                    StartForm::Number(seconds) => seconds.to_string(),
                };
                let nano = nmea::stamp(&text).ok_or_else(|| {
                    let why = nmea::why_no_stamp(&text).map_or_else(String::new, |why| format!(": {why}"));
                    let error = Error::bad_input(format!("`{text}` is no date and time{why}"));
                    self.at(error, at.span().start).with_hint("write start = \"2018-12-06T00:00:00Z\"")
                })?;
                Ok(Zero { nano, is_dated: true, zoned: None, is_open: false, text })
            }
            other => {
                let error = Error::bad_input("a log needs the zero of its time")
                    .with_hint("write time = { start = \"2018-12-06T00:00:00Z\" }, nothing else");
                Err(self.at(error, other.map_or(table.span().start, |o| o.0.span().start)))
            }
        }
    }

    fn selection(&self, name: &str, channel: &Spanned<ChannelForm>) -> Result<nmea::Selection> {
        let form = channel.get_ref();
        let (Some(sentence), Some(field), None) = (&form.sentence, form.field, &form.column) else {
            let error = Error::bad_input(format!("channel `{name}` of a log needs `sentence` and `field`"))
                .with_hint("write { sentence = \"HDT\", field = 1, unit = \"deg\" }");
            return Err(self.at(error, channel.span().start));
        };
        let unit = form.unit.as_ref().map(|u| self.unit(u)).transpose()?;
        let wanted = Wanted {
            name: name.to_owned(),
            column: sentence.clone(),
            unit,
            wraps: form.wraps,
            hold: hold(form.hold),
        };
        nmea::Selection::new(wanted, field, form.id).map_err(|e| self.at(e, channel.span().start))
    }

    fn clock(&self, time: Option<&Spanned<TimeForm>>, kind: Kind) -> Result<Clock> {
        let Some(time) = time else {
            return Ok(if kind == Kind::Trials { Clock::RowNumbers } else { Clock::FirstColumn });
        };
        let form = time.get_ref();
        let unit = form.unit.as_ref().map(|u| self.unit(u)).transpose()?;
        let wrong = |what: &str| {
            Err(self.at(Error::bad_input(what), time.span().start).with_hint(
                "write time = { column = \"t\", unit = \"s\" } or time = { start = 0.0, step = 0.001, unit = \"s\" }",
            ))
        };
        if unit.as_ref().is_some_and(|u| u.dimension() != Dimension::TIME) {
            return wrong("the unit of time is no unit of time");
        }
        match (&form.column, &form.start, form.step) {
            (Some(name), None, None) => Ok(Clock::Column { name: name.clone(), unit }),
            (None, Some(StartForm::Number(start)), Some(step)) => {
                let Some(unit) = unit else { return wrong("start and step need a unit") };
                if !(step.is_finite() && step > 0.0 && start.is_finite()) {
                    return wrong("the step of time must be a positive number");
                }
                Ok(Clock::Regular { start: unit.to_si(*start), step: unit.to_si(step) })
            }
            _ => wrong("time is either a column or a start with a step"),
        }
    }

    fn wanted(&self, channels: &HashMap<String, Spanned<ChannelForm>>) -> Result<Vec<Wanted>> {
        let mut wanted = Vec::new();
        for (name, channel) in in_order(channels) {
            let form = channel.get_ref();
            let (Some(column), None, None, None) = (&form.column, &form.sentence, form.field, form.id) else {
                let error = Error::bad_input(format!("channel `{name}` of a table needs `column` alone"))
                    .with_hint("`sentence`, `field` and `id` belong to format = \"nmea0183\"");
                return Err(self.at(error, channel.span().start));
            };
            wanted.push(Wanted {
                name: name.to_owned(),
                column: column.clone(),
                unit: form.unit.as_ref().map(|u| self.unit(u)).transpose()?,
                wraps: form.wraps,
                hold: hold(form.hold),
            });
        }
        Ok(wanted)
    }

    fn rows(&self, rows: Option<&Spanned<[i64; 2]>>) -> Result<Option<(usize, usize)>> {
        let Some(rows) = rows else { return Ok(None) };
        let [first, last] = *rows.get_ref();
        match (usize::try_from(first), usize::try_from(last)) {
            (Ok(first), Ok(last)) if first <= last && last < usize::MAX => Ok(Some((first, last))),
            _ => {
                let error = Error::bad_input(format!("rows = [{first}, {last}] is no range of rows"));
                Err(self.at(error, rows.span().start).with_hint("first and last row, counted from 0"))
            }
        }
    }

    fn add_channels(
        &self,
        recording: &mut Recording,
        channels: Vec<Channel>,
        table: &Spanned<TableForm>,
    ) -> Result<()> {
        for channel in channels {
            if recording.find(&channel.name).is_some() {
                let error = Error::bad_input(format!("two tables have a channel `{}`", channel.name))
                    .with_hint("give one of them another name under [tables.channels]");
                return Err(self.at(error, table.get_ref().file.span().start));
            }
            let other = recording.channels.first().filter(|c| c.len() != channel.len());
            if let (Kind::Trials, Some(other)) = (recording.kind, other) {
                let error = Error::bad_input(format!(
                    "tables of trials must have equally many rows: `{}` has {}, `{}` {}",
                    other.name,
                    other.len(),
                    channel.name,
                    channel.len()
                ));
                return Err(self.at(error, table.get_ref().file.span().start));
            }
            recording.channels.push(channel);
        }
        Ok(())
    }

    fn constants(&self, constants: &HashMap<String, Spanned<QuantityForm>>) -> Result<Vec<Constant>> {
        in_order(constants)
            .into_iter()
            .map(|(name, quantity)| {
                let form = quantity.get_ref();
                let unit = self.unit(&form.unit)?;
                if !form.value.is_finite() {
                    let error = Error::bad_input(format!("the constant `{name}` is no finite number"));
                    return Err(self.at(error, quantity.span().start));
                }
                Ok(Constant { name: name.to_owned(), value: unit.to_si(form.value), unit })
            })
            .collect()
    }

    fn spans(&self, form: &SpansForm) -> Result<Spans> {
        let list = |spans: &[Spanned<[f64; 2]>], used: &str| -> Result<Vec<Span>> {
            let mut list: Vec<Span> = Vec::new();
            for span in spans {
                let [from, to] = *span.get_ref();
                if !(from.is_finite() && to.is_finite() && from <= to) {
                    let error = Error::bad_input(format!("[{from}, {to}] is no span"));
                    return Err(self
                        .at(error, span.span().start)
                        .with_hint("write [from, to] with from < to"));
                }
                let own = Span::new(from, to);
                if let Some(both) = list.iter().find_map(|s| s.overlap(&own)) {
                    return Err(self.at(both.twice(used), span.span().start));
                }
                list.push(own);
            }
            list.sort_by(|a, b| a.from.total_cmp(&b.from));
            Ok(list)
        };
        let spans =
            Spans { fit: list(&form.fit, "fitted")?, holdout: list(&form.holdout, "held out")?, given: true };
        for held in &form.holdout {
            let [from, to] = *held.get_ref();
            if let Some(both) = spans.fit.iter().find_map(|f| f.overlap(&Span::new(from, to))) {
                let error =
                    Error::bad_input(format!("{} to {} is both fitted and held out", both.from, both.to))
                        .with_hint("what is held out proves something only where nothing was fitted");
                return Err(self.at(error, held.span().start));
            }
        }
        Ok(spans)
    }

    /// Notes spans in which no sample lies.
    fn judge_spans(&self, recording: &mut Recording) {
        for span in recording.spans.fit.iter().chain(&recording.spans.holdout) {
            let empty = recording.channels.iter().all(|c| !c.time.iter().any(|t| span.contains(*t)));
            if empty {
                let message = format!("no sample lies in the span from {} to {}", span.from, span.to);
                recording.notes.push(Note { file: self.path.to_owned(), line: None, message });
            }
        }
    }
}

/// Whether the time of a table is a column of numbers, unless the reader finds dates there.
fn counts_numbers(table: &TableForm, kind: Kind) -> bool {
    let is_column = table.time.as_ref().is_none_or(|t| t.get_ref().column.is_some());
    kind == Kind::Time && is_column && table.format != Some(FormatForm::Nmea0183)
}

/// Opens a table; where it is not there, the error says where it was looked for.
fn open(path: &Path) -> Result<Input> {
    let hint = "a path in a TOML recording is relative to the folder of the TOML file";
    Input::open(path).map_err(|e| if path.exists() { e } else { e.with_hint(hint) })
}

fn hold(form: HoldForm) -> Hold {
    match form {
        HoldForm::Linear => Hold::Linear,
        HoldForm::Previous => Hold::Previous,
    }
}

/// A map of the file in the order in which it stands there.
fn in_order<T>(map: &HashMap<String, Spanned<T>>) -> Vec<(&str, &Spanned<T>)> {
    let mut entries: Vec<(&str, &Spanned<T>)> = map.iter().map(|(k, v)| (k.as_str(), v)).collect();
    entries.sort_by_key(|(_, v)| v.span().start);
    entries
}
