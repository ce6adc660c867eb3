//! Lines of a log gathered into one series for each sort of sentence.

use super::super::input::Sink;
use super::known::{self, Known};
use super::mixed::{self, Talkers};
use super::request::{Request, Selection};
use super::sentence::{self, Fault, Sentence};
use super::stamp::why_no_stamp;
use crate::error::nearest;
use crate::record::Hold;
use crate::record::request::Wanted;
use crate::units::{Unit, figure};
use crate::{Error, Result};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// First line and words of what was noticed.
type Notes = Vec<(Option<usize>, String)>;

/// The sentences of one name and number.
pub(super) struct Group {
    sentence: String,
    id: Option<u32>,
    pub selections: Vec<Selection>,
    pub time: Vec<f64>,
    pub values: Vec<Vec<f64>>,
    /// For each selection, the fields that held text, and the first of them.
    texts: Vec<Count>,
    invalid: Count,
    talkers: Talkers,
}

/// How often, and the first line and its text.
#[derive(Default, Clone)]
struct Count {
    number: usize,
    first: usize,
    text: String,
}

impl Count {
    fn add(&mut self, line: usize, text: &str) {
        if self.number == 0 {
            (self.first, self.text) = (line, text.chars().take(40).collect());
        }
        self.number += 1;
    }
}

pub(super) struct Collector {
    zero: Option<i128>,
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
    pub(super) fn new(request: &Request) -> Self {
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
            zero: request.zero,
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

    fn take_line(&mut self, line: &str) -> Result<()> {
        let sentence = match sentence::parse(line) {
            Ok(sentence) => sentence,
            Err(fault) => {
                let at = Fault::ALL.iter().position(|f| *f == fault).unwrap_or_default();
                self.faults[at].add(self.line, line);
                return Ok(());
            }
        };
        self.sentences += 1;
        *self.seen.entry(sentence.address.to_owned()).or_default() += 1;
        let zero = *self.zero.get_or_insert(sentence.stamp);
        let time = (sentence.stamp - zero) as f64 / 1e9;
        if self.all {
            self.discover(&sentence)?;
        }
        for group in self.groups.iter_mut().filter(|g| sentence.is(&g.sentence, g.id)) {
            group.take(&sentence, time, self.line)?;
        }
        Ok(())
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
    pub(super) fn finish(self) -> Result<(Vec<Group>, Notes)> {
        let mut notes = Vec::new();
        for (fault, count) in Fault::ALL.iter().zip(&self.faults).filter(|(_, c)| c.number > 0) {
            let why = if *fault == Fault::NoStamp { why_no_stamp(&count.text) } else { None };
            let why = why.map_or_else(String::new, |why| format!(" ({why})"));
            let says =
                format!("{} of {} lines {}{why}; they are left out", count.number, self.line, fault.says());
            notes.push((Some(count.first), says));
        }
        if self.sentences == 0 {
            let why = notes.first().map_or("the file is empty".to_owned(), |n| n.1.clone());
            return Err(Error::bad_input(format!("there is no sentence of a log in the file: {why}"))
                .with_hint("each line is a time stamp, a space, and a sentence with its checksum"));
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
        Ok((self.groups, notes))
    }

    /// The sentences that nothing is known of.
    fn left_out(&self) -> Option<(Option<usize>, String)> {
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
            if count.number == group.time.len() {
                return Err(Error::bad_input(format!("{what}, which is no number"))
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

impl Group {
    fn new(sentence: String, id: Option<u32>) -> Self {
        let (selections, time, values) = (Vec::new(), Vec::new(), Vec::new());
        Self {
            sentence,
            id,
            selections,
            time,
            values,
            texts: Vec::new(),
            invalid: Count::default(),
            talkers: Talkers::default(),
        }
    }

    fn add(&mut self, selection: Selection) {
        self.selections.push(selection);
        self.values.push(Vec::new());
        self.texts.push(Count::default());
    }

    fn label(&self) -> String {
        self.id.map_or_else(|| self.sentence.clone(), |id| format!("{} {id}", self.sentence))
    }

    /// Whether an address counts as this sentence by its kind alone.
    fn mixes(&self, address: &str) -> bool {
        address != self.sentence && sentence::kind(address) == self.sentence
    }

    /// How far apart two instruments are that one talker sends in turn, with its unit; angles alone are asked.
    fn apart(&self) -> Option<String> {
        let mut angles = self.selections.iter().zip(&self.values).filter(|(s, _)| s.wanted.wraps);
        angles.find_map(|(s, values)| {
            let apart = mixed::in_turn(values, Some(s.unit.from_si(TAU)))?;
            Some(format!("{} {}", figure(apart), s.unit))
        })
    }

    fn take(&mut self, sentence: &Sentence, time: f64, line: usize) -> Result<()> {
        let other = self.talkers.take(sentence.address);
        if let Some(previous) = self.time.last().copied().filter(|p| *p >= time) {
            let what = if previous == time { "occurs twice" } else { "runs backwards" };
            let whose = if other {
                format!("where two talkers send it, name one, such as {}", sentence.address)
            } else {
                format!("where two instruments send {}, give one of them another talker", sentence.address)
            };
            return Err(Error::bad_input(format!(
                "the time stamp of {} {what}: {previous} s, then {time} s",
                self.label()
            ))
            .with_line(line)
            .with_column(1)
            .with_hint(format!("split the log where its clock was set; {whose}")));
        }
        self.time.push(time);
        let invalid = known::marked_invalid(sentence);
        if invalid {
            self.invalid.add(line, "");
        }
        for ((s, values), texts) in self.selections.iter().zip(&mut self.values).zip(&mut self.texts) {
            let value = s.form.read(sentence, s.field);
            if value.is_none() {
                texts.add(line, sentence.field(s.field));
            }
            values.push(value.filter(|_| !invalid).unwrap_or(f64::NAN));
        }
        Ok(())
    }
}

/// A known field as a channel of its own, such as `HEHDT_heading` or `PSXN23_roll`.
fn selection(address: &str, id: Option<u32>, known: &Known) -> Result<Selection> {
    let number = id.map_or_else(String::new, |id| id.to_string());
    let wanted = Wanted {
        name: format!("{address}{number}_{}", known.name),
        column: address.to_owned(),
        unit: None,
        wraps: known.wraps,
        hold: Hold::Linear,
    };
    Ok(Selection { wanted, unit: Unit::parse(known.unit)?, field: known.field, id, form: known.form })
}
