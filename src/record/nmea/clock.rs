//! Where the times of a log come from: the stamp before each sentence or, in a log without stamps, its ZDA sentences.
//!
//! What stands between two ZDA sentences was sent between their times: the sentences of one kind are spread evenly
//! over them, the first at the first, so that none is off by more than the time from one ZDA to the next. GGA, RMC and
//! PASHR carry a time of day; the day is the one that brings it nearest to the last time that was told. Nothing is told
//! of the time before the first ZDA, after the last, and where ZDA stays away for longer than it is used to.
//!
//! Reference: IEC 61162-1, ZDA: hhmmss.ss, day, month and year, in UTC.

use super::known;
use super::sentence::{Fault, Sentence};
use super::stamp;
use crate::{Error, Result};
use jiff::civil::Date;
use std::borrow::Cow;

/// Longest time between two ZDA sentences that gives times to what stands between them, in the usual time between two.
const LONGEST: f64 = 1.5;
const NANO: f64 = 1e9;

pub(super) enum Clock {
    Stamps,
    Ticks(Ticks),
}

/// When a sentence was sent.
pub(super) enum Moment<'a> {
    /// Nanoseconds since 1970, and in words of the log.
    At(i128, Cow<'a, str>),
    /// Between the tick of this number and the next.
    After(usize),
}

impl Clock {
    /// The moment of a sentence, or why it has none.
    ///
    /// # Errors
    /// `BadInput` where the clock runs backwards.
    pub fn moment<'a>(
        &mut self,
        sentence: &Sentence<'a>,
        line: usize,
    ) -> Result<std::result::Result<Moment<'a>, Fault>> {
        match self {
            Self::Stamps => {
                let text = sentence.stamp();
                let nano = stamp(text).ok_or(Fault::NoStamp);
                Ok(nano.map(|nano| Moment::At(nano, text.into())))
            }
            Self::Ticks(ticks) => Ok(ticks.moment(sentence, line)?.ok_or(Fault::NoClock)),
        }
    }
}

/// The ZDA sentences of one talker.
#[derive(Default)]
pub(super) struct Ticks {
    /// Who sends them.
    address: String,
    all: Vec<Tick>,
    /// The last moment that a sentence told, and its day.
    last: Option<(i128, Date)>,
}

struct Tick {
    nano: i128,
    line: usize,
    /// Sentences after it that have its time alone.
    sentences: usize,
}

impl Ticks {
    fn moment<'a>(&mut self, sentence: &Sentence<'a>, line: usize) -> Result<Option<Moment<'a>>> {
        if sentence.is("ZDA", None) {
            return self.tick(sentence, line);
        }
        let (Some(tick), Some((last, date))) = (self.all.last_mut(), self.last) else { return Ok(None) };
        let Some(clock) = known::time_of_day(sentence) else {
            tick.sentences += 1;
            return Ok(Some(Moment::After(self.all.len() - 1)));
        };
        if known::marked_invalid(sentence) {
            return Ok(None);
        }
        let days = [date.yesterday().ok(), Some(date), date.tomorrow().ok()].into_iter().flatten();
        let moments = days.filter_map(|day| Some((day, at(day, clock)?)));
        let nearest = moments.min_by_key(|(_, (nano, _))| nano.abs_diff(last));
        self.last = nearest.as_ref().map(|(day, (nano, _))| (*nano, *day)).or(self.last);
        Ok(nearest.map(|(_, (nano, text))| Moment::At(nano, text.into())))
    }

    fn tick<'a>(&mut self, sentence: &Sentence<'a>, line: usize) -> Result<Option<Moment<'a>>> {
        let number = |field: usize| sentence.field(field).parse::<i8>().ok();
        let year = Some(sentence.field(4)).filter(|y| y.len() == 4).and_then(|y| y.parse().ok());
        let date = year.zip(number(3)).zip(number(2)).and_then(|((y, m), d)| Date::new(y, m, d).ok());
        let Some((date, (nano, text))) = date.and_then(|d| Some((d, at(d, sentence.field(1))?))) else {
            return Ok(None);
        };
        if self.all.is_empty() {
            sentence.address.clone_into(&mut self.address);
        }
        if self.address != sentence.address {
            return Ok(Some(Moment::At(nano, text.into())));
        }
        if let Some(last) = self.all.last().filter(|last| nano <= last.nano) {
            if nano == last.nano {
                return Ok(None);
            }
            return Err(Error::bad_input(format!(
                "the clock of the log runs backwards: {} tells {text}, after a later time in line {}",
                self.address, last.line
            ))
            .with_line(line)
            .with_column(1)
            .with_hint("split the log where its clock was set"));
        }
        self.all.push(Tick { nano, line, sentences: 0 });
        self.last = Some((nano, date));
        Ok(Some(Moment::At(nano, text.into())))
    }

    /// The usual time from one tick to the next, s.
    fn usual(&self) -> Option<f64> {
        let mut steps: Vec<f64> = self.steps().collect();
        steps.sort_unstable_by(f64::total_cmp);
        steps.get(steps.len() / 2).copied()
    }

    fn steps(&self) -> impl Iterator<Item = f64> {
        self.all.windows(2).map(|t| (t[1].nano - t[0].nano) as f64 / NANO)
    }

    /// Whether what stands after each tick has a time.
    fn tell(&self) -> Vec<bool> {
        let longest = self.usual().unwrap_or_default() * LONGEST;
        self.steps().map(|s| s <= longest).chain([false]).collect()
    }

    /// How many sentences have no time, as none is told after the tick before them, and the line of the first.
    pub fn silent(&self) -> (usize, usize) {
        let told = self.tell();
        let silent = || self.all.iter().zip(&told).filter(|(t, tells)| !**tells && t.sentences > 0);
        let first = silent().next().map_or(0, |(t, _)| t.line + 1);
        (silent().map(|(t, _)| t.sentences).sum(), first)
    }

    /// Seconds since a zero of sentences of one kind, from the ticks before them; none where no time is told.
    pub fn times(&self, after: &[usize], zero: i128) -> Vec<Option<f64>> {
        let tells = self.tell();
        let mut times = Vec::with_capacity(after.len());
        for run in after.chunk_by(|a, b| a == b) {
            let step = self.all.get(run[0]..run[0] + 2).filter(|_| tells[run[0]]);
            times.extend((0..run.len()).map(|j| {
                let [from, to] = step? else { return None };
                let share = j as f64 / run.len() as f64;
                Some(((from.nano - zero) as f64 + share * (to.nano - from.nano) as f64) / NANO)
            }));
        }
        times
    }

    /// What is to be said of times that ticks give.
    pub fn note(&self) -> Option<String> {
        Some(format!(
            "no line has a time stamp: the {} sentences are the clock, and what stands between two of them is spread evenly \
             over their {} s, so that its time may be off by as much",
            self.address,
            crate::units::figure(self.usual()?)
        ))
    }
}

/// The moment of a day at hhmmss.ss, and its words.
fn at(day: Date, clock: &str) -> Option<(i128, String)> {
    let (hours, minutes, seconds) = (clock.get(..2)?, clock.get(2..4)?, clock.get(4..)?);
    let text = format!("{day}T{hours}:{minutes}:{seconds}Z");
    Some((stamp(&text)?, text))
}
