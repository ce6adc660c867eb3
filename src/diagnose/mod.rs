//! Locate the mismatch, name what was left out, prove it.
//!
//! [`diagnose`] fits a model to recordings, looks for faults of the data, searches the catalogue for
//! what the model leaves out, and proves what it finds on what was held out.

mod alone;
mod anew;
mod another;
pub mod answer;
mod apart;
mod as_given;
mod assemble;
mod at_rest;
mod backward;
pub(crate) mod bench;
mod beside;
mod carried;
pub mod catalogue;
mod choose;
mod coloured;
mod company;
mod compared;
mod cut;
mod exchanged;
mod faults;
mod feedback;
mod few;
mod filled;
mod findings;
mod foretold;
mod forgotten;
mod free_law;
mod gathered;
mod hold;
mod inert;
mod innovations;
mod input_noise;
#[doc(hidden)]
pub mod laboratory;
mod later;
mod lines;
mod locate;
mod located;
mod lost;
mod measure;
mod minimum;
mod moments;
mod nameless;
mod namesakes;
mod next;
mod onward;
mod paragraph;
#[doc(hidden)]
pub mod pictures;
mod pieces;
mod propose;
pub(crate) mod prove;
mod race;
mod reading;
mod repeated;
mod response;
mod rest;
mod scan;
mod screen;
mod search;
mod single;
mod small;
mod stray;
mod twins;
mod verdict;
mod view;
mod walk;
mod wandering;
mod watch;
mod words;

pub(crate) use at_rest::begins_in_motion;
pub(crate) use hold::{held_inputs, read_held, says as says_held};
pub(crate) use watch::spread_of;

use crate::estimate::Fit;
use crate::estimate::fit::{FitOptions, Progress, begun, setup};
use crate::model::Model;
use crate::record::{Recording, Source};
use crate::simulate::{Budget, Early, Stage};
use crate::{Error, Result};
use answer::{Answer, DataFault, Verdict};
use assemble::Assembly;
use bench::Bench;
use compared::Cut;
use faults::{Cleaned, Left, Spoiled};
use measure::Measure;
use namesakes::Namesakes;
use pieces::Pieces;
use prove::Held;
use search::Found;
use std::time::{Duration, Instant};

/// What is to be diagnosed.
pub struct Request<'a> {
    /// The model.
    pub model: &'a Model,
    /// The model's file, for the list of inputs.
    pub source: Option<&'a Source>,
    /// Recordings that are fitted.
    pub recordings: &'a [Recording],
    /// Recordings that are held out whole.
    pub separate: &'a [Recording],
    /// Seed of everything random.
    pub seed: u64,
    /// Wall time after which the search ends with the best so far; the proof is made all the same.
    pub time_limit: Option<Duration>,
    /// Who hears the progress.
    pub progress: &'a dyn Progress,
}

/// A diagnosis with all that a report draws.
pub struct Diagnosis {
    /// The answer.
    pub answer: Answer,
    /// The model as given, fitted.
    pub before: Fit,
    /// The model with the findings, fitted.
    pub after: Fit,
    /// Residuals before and after on what was held out, by output.
    pub held: (Vec<Held>, Vec<Held>),
    /// The recordings as they were fitted, faults masked.
    pub recordings: Vec<Recording>,
    /// The series behind the pictures.
    pub pictures: pictures::Pictures,
}

/// Diagnoses a model against recordings. Where the fitted part is explained, with or without a finding, what was held out is
/// not, and the spans are the default's, fit and proof change places once.
///
/// # Errors
/// Where a channel is missing, recordings hold the same data, or the model cannot be simulated or fitted at all.
pub fn diagnose(request: &Request<'_>) -> Result<Diagnosis> {
    let options = FitOptions {
        separate_holdout: !request.separate.is_empty(),
        progress: request.progress,
        ..FitOptions::default()
    };
    let model = gathered::gathered(&*begun(request.model, request.recordings, &options)?);
    let request = &Request { model: &model, ..*request };
    let (recordings, separate) =
        (request.model.all_joined(request.recordings)?, request.model.all_joined(request.separate)?);
    let namesakes = Namesakes::of(request.model, recordings.iter().chain(&*separate));
    let (recordings, separate) = (namesakes.apart(&recordings), namesakes.apart(&separate));
    let recordings = alone::marked(request.model, &recordings);
    setup::keep_apart(request.model, &recordings, &separate)?;
    let (recordings, repeated) = repeated::fresh(request.model, &recordings);
    let (separate, _) = repeated::fresh(request.model, &separate);
    let request = &Request { recordings: &recordings, separate: &separate, ..*request };
    let mut diagnosis = in_pieces(request)?;
    diagnosis.answer.notes.extend(namesakes.notes.into_iter().chain(repeated));
    Ok(diagnosis)
}

/// The diagnosis of recordings cut where they remember a gap for long; of what is whole where that alone has a name, one that
/// goes with time if the pieces miss nothing: a moment of change is looked for in the first of them.
fn in_pieces(request: &Request<'_>) -> Result<Diagnosis> {
    let begin = Instant::now();
    let in_time = |request: &Request<'_>, gaps: &[DataFault]| {
        let time_limit = request.time_limit.map(|t| t.saturating_sub(begin.elapsed()));
        both_ways(&Request { time_limit, ..*request }, gaps)
    };
    let cut = pieces::cut(request).and_then(|Pieces { model, recordings, notes, told }| {
        let mut cut = in_time(&Request { model: &model, recordings: &recordings, ..*request }, &told).ok()?;
        cut.answer.notes.extend(notes);
        Some(cut)
    });
    let Some(cut) = cut else { return in_time(request, &[]) };
    let is_named = |d: &Diagnosis| d.answer.verdict.has_names();
    if is_named(&cut) {
        return Ok(cut);
    }
    let misses_nothing = matches!(cut.answer.verdict, Verdict::NothingMissing | Verdict::DataFault);
    let is_more = |whole: &Diagnosis| {
        is_named(whole) && (!misses_nothing || whole.answer.findings.iter().any(pieces::goes_with_time))
    };
    Ok(in_time(request, &[]).ok().filter(is_more).unwrap_or(cut))
}

/// The diagnosis as fit and proof stand, or with both exchanged.
fn both_ways(request: &Request<'_>, gaps: &[DataFault]) -> Result<Diagnosis> {
    let begin = Instant::now();
    let first = as_it_stands(request, gaps)?;
    let Some((model, recordings)) = exchanged::asked(request, &first) else { return Ok(first) };
    request.progress.report("once more, with fit and proof in each other's place", None);
    let time_limit = request.time_limit.map(|t| t.saturating_sub(begin.elapsed()));
    let second =
        as_it_stands(&Request { model: &model, recordings: &recordings, time_limit, ..*request }, gaps);
    Ok(second.ok().and_then(|second| exchanged::proven(&first.answer, second)).unwrap_or(first))
}

/// The diagnosis with fit and proof where they stand, beside gaps of what these recordings were cut from.
fn as_it_stands(request: &Request<'_>, gaps: &[DataFault]) -> Result<Diagnosis> {
    request.progress.report("looking for faults in the data", None);
    let Cleaned { spoiled, mut told, recordings, separate } = faults::clean(request);
    let of_whole = |f: &DataFault| {
        gaps.iter().any(|g| g.finding.code == f.finding.code && g.finding.site.name == f.finding.site.name)
    };
    told.retain(|f| !of_whole(f));
    told.extend(gaps.iter().cloned());
    let (left, recordings, separate) = Left::of(request, recordings, separate);
    let asked = Request { model: &left.model, ..*request };
    let Cut { fitted, separate, notes } =
        compared::cut(asked.model, &recordings, (&separate, !request.separate.is_empty()));
    let mut bench = Bench::new(asked.model, fitted, !request.separate.is_empty(), request.seed);
    bench.budget = Budget::new(bench.budget.most(), request.time_limit);
    let budget = bench.budget.clone();
    let model = asked.model.clone();
    let case = Case { request: &asked, model, bench, separate, told, spoiled, notes };
    let mut diagnosis = case.diagnosed(left.is_any)?;
    trace(&budget);
    left.restore(request.model, &mut diagnosis);
    Ok(diagnosis)
}

/// Tells the developer what was spent for what, where GYROSPEC_TRACE is set.
fn trace(budget: &Budget) {
    if std::env::var_os("GYROSPEC_TRACE").is_none() {
        return;
    }
    let line = |s: Stage| {
        format!(
            "{:<22} {:>7} runs {:>10.3e} steps {:>7.2} s\n",
            s.name,
            s.runs,
            s.steps as f64,
            s.time.as_secs_f64()
        )
    };
    let text: String = budget.stages().into_iter().map(line).collect();
    #[allow(clippy::print_stderr)]
    {
        eprintln!("{text}");
    }
}

/// Share of the squares that a last walk left up to which another end is another place.
const ENDED: f64 = 0.99;

/// Times that strays are looked for: where many are taken out, others come to stand apart.
const PASSES: usize = 2;

/// What is compared, once faults are masked.
struct Case<'a> {
    request: &'a Request<'a>,
    /// The model as given, signs of its own mended.
    model: Model,
    bench: Bench,
    separate: Vec<Recording>,
    told: Vec<DataFault>,
    spoiled: Vec<Spoiled>,
    /// What a reader should know.
    notes: Vec<String>,
}

/// Refuses an output whose error has no square that is a number.
fn beyond_squares(model: &Model, base: &Fit) -> Result<()> {
    let Some((o, _)) = model.outputs.iter().zip(&base.rmse).find(|(_, e)| **e == f64::INFINITY) else {
        return Ok(());
    };
    let message =
        format!("the squares of what the model leaves of “{}” are beyond the largest number", o.name);
    Err(Error::not_computed(message).with_hint("look at its values with `gyrospec record`, and at its unit"))
}

impl Case<'_> {
    /// The diagnosis; where nothing is left to compare, no law is looked for.
    fn diagnosed(mut self, is_left: bool) -> Result<Diagnosis> {
        let (model, progress) = (self.request.model, self.request.progress);
        progress.report("fitting the model as it stands", None);
        self.bench.budget.begin(foretold::FIRST_FIT);
        let base = self.bench.full_fit(model).map_err(|e| model.refusal().unwrap_or(e))?;
        beyond_squares(model, &base)?;
        let base = self.begun(base);
        let base = if is_left { self.without_strays(base)? } else { base };
        self.bench.budget.tell(base.ended_early);
        let few = is_left.then(|| few::too_few(&self.bench, &base, self.spoiled_samples())).flatten();
        let is_judged = is_left && few.is_none();
        let (mut found, is_cut) = if is_judged {
            self.searched(base)?
        } else {
            (Found::nothing(base, self.bench.is_trials()), false)
        };
        let mut open = is_cut || !is_left || self.separate.is_empty() && !self.request.separate.is_empty();
        if is_judged {
            let best: Vec<f64> =
                found.base.rmse.iter().zip(&found.last.rmse).map(|(b, l)| b.min(*l)).collect();
            self.told.extend(faults::coarse(model, &self.bench.recordings, &best));
            self.notes.extend(faults::partly_coarse(model, &self.bench.recordings, &best));
            open |=
                faults::coarse(model, &self.bench.recordings, &found.base.rmse).len() == model.outputs.len();
        }
        progress.report("running what was held out", None);
        self.bench.budget.begin("intervals");
        if self.bench.budget.cut() != Some(Early::Time) {
            self.bench.ascertain(&mut found.last)?;
            if found.taken.is_empty() {
                found.base = found.last.clone();
            }
        }
        if self.bench.budget.cut() != Some(Early::Time) {
            scan::intervals(&self.bench, &found.taken, &mut found.last);
        }
        let request = &Request { model: &self.model, ..*self.request };
        let assembled = |found: Found| {
            Assembly {
                request,
                bench: self.bench.clone(),
                separate: self.separate.clone(),
                found,
                faults: self.told.clone(),
                spoiled: self.spoiled.clone(),
                is_left,
                few: few.clone(),
                is_open: open,
                notes: self.notes.clone(),
                ended_early: None,
                joint: std::sync::OnceLock::new(),
            }
            .finish()
        };
        let mut best = assembled(found.clone())?;
        let verdict = best.answer.verdict;
        let given = self.given();
        if verdict == Verdict::Unknown || free_law::may_be_better(&best.answer) {
            let stands = verdict != Verdict::Unknown;
            self.bench.budget.begin("law without a name");
            let (lawful, tried) =
                free_law::instead(&self.bench, &self.separate, (&found, stands), &given, progress)?;
            best = free_law::beside(best, lawful.map(&assembled).transpose()?, tried);
        }
        if best.answer.verdict != Verdict::Unknown && !another::may_be_others(&found, &best.answer) {
            return Ok(best);
        }
        let other = another::beginning(&self.bench, &self.separate, &found, &given, progress);
        let other = other.map(&assembled).transpose()?;
        Ok(other.filter(|o| another::is_better(&best.answer, &o.answer)).unwrap_or(best))
    }

    /// The fit of the model as given with its states where the recordings begin, should they not be at rest there.
    fn begun(&mut self, base: Fit) -> Fit {
        let Some(moving) = at_rest::moving(&self.bench, &base) else { return base };
        for (own, moved) in self.model.states.iter_mut().zip(&moving.model.states) {
            own.initial = moved.initial;
        }
        self.notes.push(moving.says);
        moving.fit
    }

    /// The fit of the model as given once samples are left out that stand apart from all that it leaves over.
    fn without_strays(&mut self, mut base: Fit) -> Result<Fit> {
        for _ in 0..PASSES {
            let found = faults::strays(&self.bench, &base, &self.separate, &self.spoiled);
            if found.is_empty() || base.ended_early.is_some() {
                break;
            }
            let recordings = (&mut self.bench.recordings[..], &mut self.separate[..]);
            faults::take(self.request.model, found, recordings, (&mut self.spoiled, &mut self.told));
            base = compared::anew(&self.bench, &base)?;
        }
        Ok(base)
    }

    /// Samples of fitted outputs that faults took.
    fn spoiled_samples(&self) -> usize {
        let model = self.request.model;
        let is_output = |s: &&Spoiled| model.outputs.iter().any(|o| o.name == s.fault.channel);
        let fitted = self.spoiled.iter().filter(|s| s.recording < self.request.recordings.len());
        fitted.filter(is_output).filter(|s| faults::takes(s)).map(|s| s.fault.samples).sum()
    }

    /// The search, with signs and units mended; with whether gaps of inputs leave too little to tell.
    fn searched(&mut self, mut base: Fit) -> Result<(Found, bool)> {
        self.bench.budget.begin("faults");
        let misread = faults::misread(&self.bench, &self.model, &base);
        let misread = misread.or_else(|| faults::odd(&self.bench, &self.model, &base));
        let is_mended = misread.is_some();
        if let Some(misread) = misread {
            base = self.mended(misread);
        }
        self.bench.budget.begin("gaps");
        let (base, settled, is_cut) = compared::settle(&mut self.bench, &mut self.separate, base)?;
        self.bench.budget.tell(base.ended_early);
        self.notes.extend(settled);
        let (base, filled) = filled::settle(&mut self.bench, &mut self.separate, base);
        self.notes.extend(filled);
        let mut settled = hold::settle(&mut self.bench, &mut self.separate, base, Some(&self.model))?;
        if !is_mended {
            self.mends_again(&mut settled);
        }
        let (base, found) = self.as_read(settled)?;
        let spent = self.bench.budget.cut();
        if spent == Some(Early::Time) {
            return Ok((found, is_cut));
        }
        if spent.is_some() {
            // steps that were spent on a wrong reading are no reason to keep it
            self.bench.budget.renew();
        }
        let held = hold::in_place_of_findings(&mut self.bench, &mut self.separate, &found);
        if held.is_empty() {
            self.bench.budget.tell(spent);
            return Ok((found, is_cut));
        }
        self.notes.retain(|n| !held.iter().any(|h| *n == hold::note(&h.finding.site.name)));
        self.told.extend(held);
        let base = compared::anew(&self.bench, &base)?;
        self.notes.extend(feedback::read_first(&mut self.bench.recordings, &mut self.separate, &base));
        Ok((self.named(&self.bench, &self.separate, base, None)?, is_cut))
    }

    /// Mends a sign or a unit where inputs are read anew: what a wrong reading left had hidden how much that mends.
    fn mends_again(&mut self, settled: &mut hold::Settled) {
        if settled.held.is_empty() || !faults::fits_badly(&self.bench, &settled.fit) {
            return;
        }
        self.bench.budget.begin("faults");
        if let Some(misread) = faults::misread(&self.bench, &self.model, &settled.fit) {
            (settled.fit, settled.before) = (self.mended(misread), None);
        }
    }

    /// The fit with a sign or a unit mended, which is told.
    fn mended(&mut self, misread: faults::Misread) -> Fit {
        misread.mend(&mut self.bench.recordings, &mut self.separate);
        self.told.push(misread.fault);
        self.model = misread.model;
        self.bench.budget.renew();
        misread.fit
    }

    /// The values that the model was given.
    fn given(&self) -> Vec<f64> {
        self.model.parameters.iter().map(|p| p.value).collect()
    }

    /// What the search finds; where something is left, from the fit in the colour of the noise, if that is likelier.
    fn named(
        &self,
        bench: &Bench,
        separate: &[Recording],
        base: Fit,
        before: Option<&hold::Before>,
    ) -> Result<Found> {
        let found = self.found(bench, separate, base, before)?;
        let found = as_given::instead(bench, separate, found, &self.model, self.request.progress);
        let is_open = found.rest.p_value < choose::CHANCE && !search::is_over(bench);
        let other = is_open.then(|| coloured::refitted(bench, &found, &self.model)).flatten();
        other.map_or(Ok(found), |fit| self.found(bench, separate, fit, before))
    }

    /// What the search finds from a fit and what of it stands; what was found first where inputs fit better beside it as
    /// they were read before.
    fn found(
        &self,
        bench: &Bench,
        separate: &[Recording],
        base: Fit,
        before: Option<&hold::Before>,
    ) -> Result<Found> {
        let given = self.given();
        let is_over = |last: &Fit| before.is_some_and(|b| b.is_likelier(bench, last));
        let bounds = walk::Bounds { given: &given, avoids: None, is_over: &is_over, may_begin_anew: true };
        let mut found = walk::search(bench, separate, base, &bounds, self.request.progress)?;
        if is_over(&found.last) {
            return Ok(found);
        }
        backward::stand(bench, separate, &mut found);
        beside::settle(bench, separate, &mut found, self.request.progress);
        single::settle(bench, separate, &mut found, self.request.progress);
        Self::rests(bench, &mut found);
        Ok(found)
    }

    /// Ends the last fit from all reasoned starts where a law with corners was found: a walk may stop at a corner.
    fn rests(bench: &Bench, found: &mut Found) {
        let is_cornered = found.taken.iter().any(|t| t.proposal.has_corners());
        if !is_cornered || search::is_over(bench) {
            return;
        }
        let Ok(fit) = bench.full_fit(&found.last.model) else { return };
        if found.scale.squares(&fit) < ENDED * found.scale.squares(&found.last) {
            found.last = fit;
            found.measures.1 = Measure::of(&found.last, &found.scale);
        }
    }
}
