//! The search: add one mechanism, look again, drop what became needless.
//!
//! # Purpose
//! From a fitted model and the catalogue to the few mechanisms that the recordings call for.
//!
//! # Method
//! Every round screens and fits extensions. One is taken if its likelihood ratio stands after Holm's
//! correction for all that was tried, if it lowers the free-run error over blocks left out in turn by
//! more than a floor, and if none of like gain is likelier. Alternatives that fit as well are kept as
//! ties. When no more can be added, those that the others make needless are dropped.
//!
//! Of two effects the one may hide the other from the likelihood: what the second leaves has a colour that would
//! follow the first as well. So where something is missing for sure, nothing stands by itself, and one extension takes
//! most of the error of blocks left out and is no less likely, it is added on trial. If a second then stands beside it,
//! and both together against the model without either, both are taken; else it is as if there had been no trial. Beside
//! findings that gain much an extension that gains little is added so too; what is found with it must leave nothing, for
//! beside a law that is not quite the right one any law gains a little.
//!
//! # References
//! N. R. Kristensen, H. Madsen, S. B. Jorgensen, Computers & Chemical Engineering 28 (2004) 1431;
//! S. Holm, Scand. J. Statist. 6 (1979) 65.

use super::bench::Bench;
use super::catalogue::Proposal;
use super::choose::{self, Choice, choose, gain, is_elsewhere};
use super::compared::patiently;
use super::measure::{Measure, Scale};
use super::propose::Screening;
use super::prove;
use super::search::{Found, Refitted, Round, State, Taken, ahead, is_over, round, trace};
use super::view::View;
use super::{anew, minimum, small};

use crate::Result;
use crate::estimate::Fit;
use crate::estimate::fit::Progress;
use crate::record::Recording;

/// Mechanisms that are added at most.
const MOST: usize = 3;
/// Gain from which on an extension is added on trial: the error of blocks left out falls to six tenths.
const TRIAL: f64 = 1.0;

/// A search on its way.
struct Walk<'a> {
    bench: &'a Bench,
    separate: &'a [Recording],
    base: Fit,
    start: Measure,
    current: Fit,
    view: View,
    given: Vec<f64>,
    gains: f64,
    taken: Vec<Taken>,
    first: Option<Screening>,
    trial: Option<Trial>,
    /// Where the search stood when it took what gains little.
    before_small: Option<Trial>,
    /// A law that it does not begin with, nor with its look-alikes.
    avoids: Option<&'a Proposal>,
}

/// Where the search stood when it added an extension on trial.
struct Trial {
    round: Round,
    now: Measure,
    scale: Scale,
    current: Fit,
    /// How many were taken before.
    taken: usize,
    /// Whether what is tried gains less than a further finding must.
    is_small: bool,
}

/// How a search begins and ends.
pub struct Bounds<'a> {
    /// The values that the model was given.
    pub given: &'a [f64],
    /// A law that it does not begin with, nor with its look-alikes.
    pub avoids: Option<&'a Proposal>,
    /// Of which model it goes no further.
    pub is_over: &'a dyn Fn(&Fit) -> bool,
    /// Whether it may begin anew from a better fit of its first model.
    pub may_begin_anew: bool,
}

/// Searches from a fitted model.
///
/// # Errors
/// Where the fitted model itself cannot be run.
pub fn search(
    bench: &Bench,
    separate: &[Recording],
    base: Fit,
    bounds: &Bounds<'_>,
    progress: &dyn Progress,
) -> Result<Found> {
    let mut walk = Walk::from(bench, separate, base, bounds)?;
    loop {
        let (mut round, now) = walk.round(progress)?;
        let standing = standing(bench, separate, &mut round, &now);
        if let Some((choice, next)) = standing.filter(|(choice, _)| walk.bears(&round.fitted[choice.best])) {
            walk.takes(round, choice, next, &now);
            let better = if bounds.may_begin_anew { walk.better() } else { None };
            if let Some(base) = better {
                return search(bench, separate, base, &Bounds { may_begin_anew: false, ..*bounds }, progress);
            }
            if (bounds.is_over)(&walk.current) {
                return Ok(walk.ends(Round::nothing(), &now));
            }
        } else if let Some(trial) = walk.trial.take() {
            let leaves_nothing = round.screening.p_value >= choose::CHANCE;
            return Ok(if trial.is_small && leaves_nothing {
                walk.ends(round, &now)
            } else {
                walk.returns(trial)
            });
        } else if let Some((i, next)) = walk.hopeful(&round, &now) {
            walk.tries(round, i, next, now);
        } else {
            return Ok(walk.ends(round, &now));
        }
    }
}

impl<'a> Walk<'a> {
    fn from(bench: &'a Bench, separate: &'a [Recording], base: Fit, bounds: &Bounds<'a>) -> Result<Self> {
        Ok(Self {
            bench,
            separate,
            start: Measure::of(&base, &Scale::of(&base, bench.is_trials())),
            current: base.clone(),
            view: patiently(bench, || View::of(bench, &base))?,
            base,
            given: bounds.given.to_vec(),
            gains: 0.0,
            taken: Vec::new(),
            first: None,
            trial: None,
            before_small: None,
            avoids: bounds.avoids,
        })
    }

    /// A better fit of the model as given, which a first finding led to.
    fn better(&self) -> Option<Fit> {
        let is_first = self.taken.len() == 1 && !is_over(self.bench);
        if is_first { minimum::better(self.bench, &self.base, &self.current) } else { None }
    }

    fn round(&self, progress: &dyn Progress) -> Result<(Round, Measure)> {
        let bench = self.bench;
        let scale = Scale::of(&self.current, bench.is_trials());
        let now = Measure::of(&self.current, &scale);
        let mut found = patiently(bench, || {
            let ends = self.taken.len() >= MOST || self.taken.iter().any(|t| t.proposal.ends);
            let is_last = ends || is_over(bench);
            let avoids = self.avoids.filter(|_| self.taken.is_empty());
            let state =
                State { now: &now, scale: &scale, gains: self.gains, taken: &self.taken, is_last, avoids };
            round(bench, (&self.current, &self.view), &state, &self.given, progress)
        })?;
        trace(bench, &found, &now);
        bench.budget.begin("choice");
        anew::keep_confirmed(bench, self.separate, &self.current, &mut found);
        Ok((found, now))
    }

    /// The chance of an extension together with the one on trial.
    fn joint(&self, r: &Refitted) -> Option<f64> {
        let (trial, first) = (self.trial.as_ref()?, self.taken.last()?);
        let added = first.proposal.added.len() + r.proposal.added.len();
        let chance = Measure::of(&r.fit, &trial.scale).chance_over(trial.now.likelihood, added);
        Some((first.tried * r.tried * chance).min(1.0))
    }

    /// Whether an extension that stands beside one on trial bears it too.
    fn bears(&self, r: &Refitted) -> bool {
        self.joint(r).is_none_or(|chance| chance < choose::CHANCE)
    }

    fn takes(&mut self, mut round: Round, choice: Choice, next: View, now: &Measure) {
        let Choice { best, ties, elsewhere, rival, mut others, .. } = choice;
        others.extend(round.screening.as_steep(&round.fitted[best].proposal));
        let fits = |i: usize| (round.fitted[best].fit.clone(), round.fitted[i].fit.clone());
        let rivals = rival.map(|i| Box::new(fits(i)));
        let joint = self.joint(&round.fitted[best]);
        let r = round.fitted.swap_remove(best);
        if let (Some(chance), Some(first)) = (joint, self.taken.last_mut()) {
            first.p_value = chance;
        }
        match self.trial.take() {
            Some(trial) if trial.is_small => self.before_small = Some(trial),
            Some(trial) => drop(self.first.get_or_insert(trial.round.screening)),
            None => {}
        }
        self.adds(r, next, now);
        if let Some(last) = self.taken.last_mut() {
            (last.ties, last.elsewhere, last.others, last.rivals) = (ties, elsewhere, others, rivals);
        }
        self.first.get_or_insert(round.screening);
    }

    fn adds(&mut self, r: Refitted, next: View, now: &Measure) {
        self.gains += gain(now, &r.measure);
        let names = r.proposal.model.parameters.len();
        self.given.extend(r.fit.model.parameters[self.given.len()..names].iter().map(|p| p.value));
        (self.current, self.view) = (r.fit, next);
        self.taken.push(Taken {
            proposal: r.proposal,
            p_value: r.p_value,
            tried: r.tried,
            ties: Vec::new(),
            elsewhere: Vec::new(),
            others: Vec::new(),
            rivals: None,
        });
    }

    /// An extension that is worth a trial, with what the next round would see of it.
    fn hopeful(&self, round: &Round, now: &Measure) -> Option<(usize, View)> {
        let is_sure = round.screening.p_value < choose::CHANCE && round.fallen.is_none();
        if !is_sure || self.bench.is_trials() || self.taken.len() + 1 >= MOST || is_over(self.bench) {
            return None;
        }
        let is_hopeful = |r: &Refitted| {
            let as_likely = r.measure.likelihood > now.likelihood - choose::TIE;
            let is_large = gain(now, &r.measure) > TRIAL && as_likely;
            (is_large || self.is_small(r, now)) && !r.is_pressed() && !r.is_cut
        };
        let little = || if self.taken.is_empty() { surest(round, now) } else { None };
        let i = round.fitted.iter().position(is_hopeful).or_else(little)?;
        Some((i, ahead(self.bench, self.separate, &round.fitted[i].fit)?))
    }

    /// Whether an extension surely gains beside what was found, though less than a further finding must.
    fn is_small(&self, r: &Refitted, now: &Measure) -> bool {
        let fall = gain(now, &r.measure);
        !self.taken.is_empty() && r.p_value < choose::CHANCE && (choose::MUCH..r.floor).contains(&fall)
    }

    fn tries(&mut self, round: Round, i: usize, next: View, now: Measure) {
        let (current, taken) = (self.current.clone(), self.taken.len());
        let r = round.fitted[i].clone();
        let least = choose::RIVAL * gain(&now, &r.measure);
        let is_small = self.is_small(&r, &now);
        self.adds(r, next, &now);
        let rivals =
            round.fitted.iter().enumerate().filter(|(k, r)| *k != i && gain(&now, &r.measure) > least);
        if let Some(last) = self.taken.last_mut().filter(|_| is_small) {
            last.others = rivals.map(|(_, r)| r.proposal.clone()).collect();
        }
        let scale = Scale::of(&current, self.bench.is_trials());
        self.trial = Some(Trial { round, now, scale, current, taken, is_small });
    }

    /// Ends where the trial began.
    fn returns(mut self, trial: Trial) -> Found {
        self.taken.truncate(trial.taken);
        self.current = trial.current;
        self.ends(trial.round, &trial.now)
    }

    /// What still gains beside a finding of its code elsewhere may be the better place of it.
    fn keeps_places(&mut self, round: &Round, now: &Measure) {
        let gains = |r: &&Refitted| r.p_value < choose::CHANCE && gain(now, &r.measure) > choose::floor(0.0);
        for r in round.fitted.iter().filter(gains) {
            let others = self.taken.iter_mut().filter(|t| is_elsewhere(&t.proposal, &r.proposal));
            others.for_each(|t| t.others.push(r.proposal.clone()));
        }
    }

    fn ends(mut self, round: Round, now: &Measure) -> Found {
        let leaves_more = round.screening.p_value < choose::CHANCE;
        if let Some(before) = self.before_small.take().filter(|_| leaves_more) {
            return self.returns(before);
        }
        self.keeps_places(&round, now);
        let is_trace = self.taken.is_empty() && choose::is_trace(&round, now);
        let small = if self.taken.is_empty() { None } else { small::told(&round, now) };
        let rest = round.screening;
        let (first, rest) = match self.first {
            Some(f) => (f, rest),
            None => {
                (Screening { screened: rest.screened.clone(), free: Vec::new(), p_value: rest.p_value }, rest)
            }
        };
        let scale = Scale::of(&self.base, self.bench.is_trials());
        let measures = (self.start, Measure::of(&self.current, &scale));
        let fallen = round.fallen.filter(|_| self.taken.is_empty());
        Found {
            base: self.base,
            last: self.current,
            taken: self.taken,
            without: Vec::new(),
            first,
            rest,
            scale,
            measures,
            notes: round.notes,
            small,
            fallen,
            is_trace,
        }
    }
}

/// The likeliest extension of a round that surely lowers the error, though by too little to be one: what makes it larger may be
/// hidden in another output, whose large error has another reason.
fn surest(round: &Round, now: &Measure) -> Option<usize> {
    let likelier = |i: &usize| round.fitted[*i].measure.likelihood;
    let is_sure = |i: &usize| {
        let r = &round.fitted[*i];
        let gains = gain(now, &r.measure) > 0.0 && likelier(i) > now.likelihood + choose::PLAINLY;
        gains && r.p_value < choose::SURE && !r.is_pressed() && !r.is_cut
    };
    (0..round.fitted.len()).filter(is_sure).max_by(|a, b| likelier(a).total_cmp(&likelier(b)))
}

/// The best extension of a round, with what the next one sees of it. Those that cannot be run, there or over
/// what is held out, fall out, and so do those that fit as well as it; then nothing that gains far less may
/// stand for them.
fn standing(
    bench: &Bench,
    separate: &[Recording],
    round: &mut Round,
    now: &Measure,
) -> Option<(Choice, View)> {
    loop {
        let choice = choose(round, now)?;
        let best = &round.fitted[choice.best];
        if round.fallen.as_ref().is_some_and(|fallen| !choose::rivals(best, fallen, now)) {
            return None;
        }
        let runs = |i: &usize| prove::runs(bench, &round.fitted[*i].fit, separate);
        let ahead = ahead(bench, separate, &round.fitted[choice.best].fit);
        let fallen =
            if ahead.is_none() { Some(choice.best) } else { choice.near.iter().copied().find(|i| !runs(i)) };
        match (fallen, ahead) {
            (Some(i), None) => {
                let best = round.fitted.remove(i);
                round.fallen.get_or_insert_with(|| Box::new(best));
            }
            (Some(i), _) => drop(round.fitted.remove(i)),
            (None, ahead) => return ahead.map(|view| (choice, view)),
        }
    }
}
