//! The sentences of one sort: times and values.

use super::clock::Ticks;
use super::known::{self, Known};
use super::mixed::{self, Talkers};
use super::request::Selection;
use super::sentence::{self, Sentence};
use crate::record::Hold;
use crate::record::request::Wanted;
use crate::units::{Unit, figure};
use crate::{Error, Result};
use std::f64::consts::TAU;

/// The sentences of one name and number.
pub(super) struct Group {
    pub sentence: String,
    pub id: Option<u32>,
    pub selections: Vec<Selection>,
    /// NaN where a tick of the log's clock is to give it.
    pub time: Vec<f64>,
    /// The ticks before those.
    pub after: Vec<usize>,
    pub values: Vec<Vec<f64>>,
    /// For each selection, the fields that held text, and the first of them.
    pub texts: Vec<Count>,
    pub invalid: Count,
    pub talkers: Talkers,
}

/// How often, and the first line and its text.
#[derive(Default, Clone)]
pub(super) struct Count {
    pub number: usize,
    pub first: usize,
    pub text: String,
}

impl Count {
    pub fn add_all(&mut self, (number, first): (usize, usize)) {
        if number > 0 {
            self.first = if self.number == 0 { first } else { self.first.min(first) };
            self.number += number;
        }
    }

    pub fn add(&mut self, line: usize, text: &str) {
        if self.number == 0 {
            (self.first, self.text) = (line, text.chars().take(40).collect());
        }
        self.number += 1;
    }
}

impl Group {
    pub fn new(sentence: String, id: Option<u32>) -> Self {
        let (selections, time, values) = (Vec::new(), Vec::new(), Vec::new());
        Self {
            sentence,
            id,
            selections,
            time,
            after: Vec::new(),
            values,
            texts: Vec::new(),
            invalid: Count::default(),
            talkers: Talkers::default(),
        }
    }

    pub fn add(&mut self, selection: Selection) {
        self.selections.push(selection);
        self.values.push(Vec::new());
        self.texts.push(Count::default());
    }

    pub fn label(&self) -> String {
        self.id.map_or_else(|| self.sentence.clone(), |id| format!("{} {id}", self.sentence))
    }

    /// Whether an address counts as this sentence by its kind alone.
    pub fn mixes(&self, address: &str) -> bool {
        address != self.sentence && sentence::kind(address) == self.sentence
    }

    /// How far apart two instruments are that one talker sends in turn, with its unit; angles alone are asked.
    pub fn apart(&self) -> Option<String> {
        let mut angles = self.selections.iter().zip(&self.values).filter(|(s, _)| s.wanted.wraps);
        angles.find_map(|(s, values)| {
            let apart = mixed::in_turn(values, Some(s.unit.from_si(TAU)))?;
            Some(format!("{} {}", figure(apart), s.unit))
        })
    }

    /// Puts in the times that the ticks of a clock give; what has none goes.
    pub fn set_times(&mut self, ticks: &Ticks, zero: i128) -> Result<()> {
        if self.after.is_empty() {
            return Ok(());
        }
        let mut told = ticks.times(&self.after, zero).into_iter();
        let times = self.time.iter().map(|t| if t.is_nan() { told.next().flatten() } else { Some(*t) });
        let times: Vec<Option<f64>> = times.collect();
        for values in &mut self.values {
            let mut has_time = times.iter().map(Option::is_some);
            values.retain(|_| has_time.next().unwrap_or_default());
        }
        self.time = times.into_iter().flatten().collect();
        if self.time.is_empty() {
            return Err(Error::bad_input(format!(
                "no {} sentence stands between two ZDA sentences in their usual succession",
                self.label()
            ))
            .with_hint(
                "without them it has no time: leave it out, or write a time stamp before each sentence",
            ));
        }
        if self.time.windows(2).any(|t| t[0] >= t[1]) {
            return Err(Error::bad_input(format!(
                "the times of the {} sentences do not rise: too many stand between two ZDA sentences",
                self.label()
            )));
        }
        Ok(())
    }

    pub fn take(&mut self, sentence: &Sentence, time: f64, line: usize) -> Result<()> {
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
pub(super) fn selection(address: &str, id: Option<u32>, known: &Known) -> Result<Selection> {
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
