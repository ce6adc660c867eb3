//! Lines of a log gathered into one series for each sort of sentence.

use super::super::input::Sink;
use super::clock::{Clock, Moment};
use super::group::{Count, Group, selection};
use super::known;
use super::request::Request;
use super::sentence::{self, Fault, Sentence};
use super::stamp::why_no_stamp;
use crate::error::nearest;
use crate::{Error, Result};
use std::collections::BTreeMap;

/// First line and words of what was noticed.
type Notes = Vec<(Option<usize>, String)>;

pub(super) struct Collector {
    clock: Clock,
    zero: Option<i128>,
    /// The first moment in words of the log.
    first: Option<String>,
    /// Whether every known field is wanted.
    all: bool,
    groups: Vec<Group>,
    line: usize,
    sentences: usize,
    faults: [Count; Fault::ALL.len()],
    seen: BTreeMap<String, usize>,
}

impl Sink for Collector {
    fn take(&mut self, block: &[u8]) -> Result<()> {
        for line in block.strip_suffix(b"\n").unwrap_or(block).split(|b| *b == b'\n') {
            self.line += 1;
            let text = String::from_utf8_lossy(line);
            if !text.trim().is_empty() {
                self.take_line(&text)?;
            }
        }
        Ok(())
    }

    fn lines(&self) -> usize {
        self.line
    }
}

impl Collector {
    pub(super) fn new(request: &Request, clock: Clock) -> Self {
        let mut groups: Vec<Group> = Vec::new();
        for selection in &request.wanted {
            let (name, id) = (&selection.wanted.column, selection.id);
            let at = groups.iter().position(|g| g.sentence == *name && g.id == id).unwrap_or_else(|| {
                groups.push(Group::new(name.clone(), id));
                groups.len() - 1
            });
            groups[at].add(selection.clone());
        }
        Self {
            clock,
            zero: request.zero,
            first: None,
            all: request.wanted.is_empty(),
            groups,
            line: 0,
            sentences: 0,
            faults: Default::default(),
            seen: BTreeMap::new(),
        }
    }

    /// Nanoseconds since 1970 of the zero, once a sentence was read.
    pub(super) fn zero(&self) -> Option<i128> {
        self.zero
    }

    /// The first moment in words of the log, once a sentence was read.
    #[cfg(feature = "cli")]
    pub(super) fn first(&self) -> Option<&str> {
        self.first.as_deref()
    }

    fn take_line(&mut self, line: &str) -> Result<()> {
        let (sentence, moment) = match self.timed(line)? {
            Ok(timed) => timed,
            Err(fault) => {
                self.faults[fault as usize].add(self.line, line);
                return Ok(());
            }
        };
        self.sentences += 1;
        *self.seen.entry(sentence.address.to_owned()).or_default() += 1;
        if let (Moment::At(nano, text), None) = (&moment, &self.first) {
            self.zero.get_or_insert(*nano);
            self.first = Some(text.clone().into_owned());
        }
        if self.all {
            self.discover(&sentence)?;
        }
        let zero = self.zero.unwrap_or_default();
        for group in self.groups.iter_mut().filter(|g| sentence.is(&g.sentence, g.id)) {
            match moment {
                Moment::At(nano, _) => group.take(&sentence, (nano - zero) as f64 / 1e9, self.line)?,
                Moment::After(tick) => {
                    group.after.push(tick);
                    group.take(&sentence, f64::NAN, self.line)?;
                }
            }
        }
        Ok(())
    }

    /// The sentence of a line and its moment, or why there is none.
    fn timed<'a>(&mut self, line: &'a str) -> Result<std::result::Result<(Sentence<'a>, Moment<'a>), Fault>> {
        let sentence = match sentence::parse(line) {
            Ok(sentence) => sentence,
            Err(fault) => return Ok(Err(fault)),
        };
        let moment = self.clock.moment(&sentence, self.line)?;
        Ok(moment.map(|moment| (sentence, moment)))
    }

    /// Makes a group of a known sentence that comes for the first time.
    fn discover(&mut self, sentence: &Sentence) -> Result<()> {
        let Some((id, fields)) = known::fields(sentence) else { return Ok(()) };
        if self.groups.iter().any(|g| g.sentence == sentence.address && g.id == id) {
            return Ok(());
        }
        let mut group = Group::new(sentence.address.to_owned(), id);
        for field in fields {
            group.add(selection(sentence.address, id, field)?);
        }
        self.groups.push(group);
        Ok(())
    }

    /// The groups and what was noticed.
    pub(super) fn finish(mut self) -> Result<(Vec<Group>, Notes)> {
        if let Clock::Ticks(ticks) = &self.clock {
            self.faults[Fault::NoClock as usize].add_all(ticks.silent());
        }
        let mut notes = Vec::new();
        for (fault, count) in Fault::ALL.iter().zip(&self.faults).filter(|(_, c)| c.number > 0) {
            let why = if *fault == Fault::NoStamp { why_no_stamp(&count.text) } else { None };
            let why = why.map_or_else(String::new, |why| format!(" ({why})"));
            let says =
                format!("{} of {} lines {}{why}; they are left out", count.number, self.line, fault.says());
            notes.push((Some(count.first), says));
        }
        if self.sentences == 0 {
            return Err(self.no_sentence(&notes));
        }
        for group in &self.groups {
            self.judge(group, &mut notes)?;
        }
        if self.all && !self.groups.is_empty() {
            notes.extend(self.left_out());
        }
        if self.groups.is_empty() {
            return Err(Error::bad_input("no sentence is known here").with_hint(self.there()));
        }
        self.set_times(&mut notes)?;
        Ok((self.groups, notes))
    }

    fn no_sentence(&self, notes: &Notes) -> Error {
        if let Clock::Ticks(_) = self.clock {
            return Error::bad_input(
                "this is a log of NMEA 0183 without time stamps, and no \
                 ZDA sentence in it tells a date and a time",
            )
            .with_hint("log ZDA beside the rest, or write a time stamp and a space before each sentence");
        }
        let why = notes.first().map_or("the file is empty".to_owned(), |n| n.1.clone());
        Error::bad_input(format!("there is no sentence of a log in the file: {why}"))
            .with_hint("each line is a time stamp, a space, and a sentence with its checksum")
    }

    /// Gives times to what stands between the ticks of the log's clock, and leaves out what has none.
    fn set_times(&mut self, notes: &mut Notes) -> Result<()> {
        let Clock::Ticks(ticks) = &self.clock else { return Ok(()) };
        notes.extend(ticks.note().map(|says| (None, says)));
        let zero = self.zero.unwrap_or_default();
        self.groups.iter_mut().try_for_each(|group| group.set_times(ticks, zero))
    }

    /// The sentences that nothing is known of.
    pub(super) fn left_out(&self) -> Option<(Option<usize>, String)> {
        let known = |a: &str| self.groups.iter().any(|g| g.sentence == a || g.sentence == sentence::kind(a));
        let others: Vec<(&String, &usize)> = self.seen.iter().filter(|(a, _)| !known(a)).collect();
        let (first, _) = others.first()?;
        let list: Vec<String> = others.iter().map(|(a, n)| format!("{a} ({n})")).collect();
        let says = format!(
            "{} left out: their fields are not known; a recording file in TOML takes one by its number, such as {{ sentence = \"{first}\", field = 2, unit = \"deg\" }}",
            list.join(", ")
        );
        Some((None, says))
    }

    fn judge(&self, group: &Group, notes: &mut Notes) -> Result<()> {
        let name = group.label();
        if group.time.is_empty() {
            let kinds = self.seen.keys().map(|a| sentence::kind(a));
            let meant = nearest(&group.sentence, kinds).map(|n| format!("did you mean {n}? "));
            return Err(Error::bad_input(format!("the log has no {name} sentence"))
                .with_hint(meant.unwrap_or_default() + &self.there()));
        }
        for (selection, count) in group.selections.iter().zip(&group.texts).filter(|(_, c)| c.number > 0) {
            let what = format!("field {} of {name} holds `{}`", selection.field, count.text);
            let what = format!("{what}, which is no {}", selection.form.wanted());
            if count.number == group.time.len() {
                return Err(Error::bad_input(what)
                    .with_line(count.first)
                    .with_hint(known::listing(&group.sentence, group.id)));
            }
            notes.push((Some(count.first), format!("{what}; {} such fields are gaps", count.number)));
        }
        if group.invalid.number > 0 {
            let says = format!(
                "{} of {} {name} sentences are marked as not valid by the instrument; they are gaps",
                group.invalid.number,
                group.time.len()
            );
            notes.push((Some(group.invalid.first), says));
        }
        notes.extend(self.one_instrument(group)?.map(|says| (None, says)));
        Ok(())
    }

    /// Refuses a channel of two instruments, or says what looks like one.
    fn one_instrument(&self, group: &Group) -> Result<Option<String>> {
        let name = group.label();
        let talkers: Vec<(&String, &usize)> = self.seen.iter().filter(|(a, _)| group.mixes(a)).collect();
        let list: Vec<String> = talkers.iter().map(|(a, n)| format!("{a} ({n})")).collect();
        let counts: Vec<usize> = talkers.iter().map(|t| *t.1).collect();
        if talkers.len() > 1 && group.talkers.are_in_turn(&counts) {
            let first = talkers[0].0;
            return Err(Error::bad_input(format!(
                "{name} comes from several talkers in turn, {}: these are several instruments, and one channel of all \
                 would be none of them",
                list.join(", ")
            ))
            .with_hint(format!("give each a channel by its whole address, such as sentence = \"{first}\"")));
        }
        if talkers.len() > 1 {
            return Ok(Some(format!(
                "{name} comes from several talkers, one after the other ({}); name one of them",
                list.join(", ")
            )));
        }
        let apart = group.apart();
        Ok(apart.map(|apart| {
            format!(
                "{name} looks like two instruments in turn, {apart} apart, that one talker sends: read as one they are \
                 neither; give one of them another talker, or log each in a file of its own"
            )
        }))
    }

    fn there(&self) -> String {
        let list = self.seen.iter().map(|(address, n)| format!("{address} ({n})"));
        format!("the log holds {}", list.take(20).collect::<Vec<_>>().join(", "))
    }
}
