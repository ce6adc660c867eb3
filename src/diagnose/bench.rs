//! The recordings on the bench: free runs of any model on their fitted parts.

use super::catalogue::Scene;
use super::foretold;
use super::measure::after_beginning;
use super::watch::{LOOKS, Looks, Watched, spread, spread_of};
use crate::estimate::fit::harness::{Record, Unknown};
use crate::estimate::fit::setup;
use crate::estimate::fit::{Effort, ascertain};
use crate::estimate::noise::robust_deviation;
use crate::estimate::{Fit, FitOptions, Stopping, fit};
use crate::model::{Initial, Model};
use crate::record::{Channel, Hold, Kind, Recording, Span};
use crate::simulate::{Budget, Planned};
use crate::{Error, Result};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Longest stretch, in samples over all recordings, that the screening runs over.
const SCREENED: usize = 40_000;

/// Recordings with what of them is fitted.
#[derive(Clone)]
pub struct Bench {
    /// The recordings, faults masked.
    pub recordings: Vec<Recording>,
    /// Whether separate records are held out.
    pub separate: bool,
    /// Seed of everything random.
    pub seed: u64,
    /// Number of the given model's own parameters.
    pub own_parameters: usize,
    /// The same of states.
    pub own_states: usize,
    /// Number of its own inputs; the other inputs are channels that mechanisms use.
    pub own_inputs: usize,
    /// The simulator's tolerance, as a share of an output's spread.
    pub tolerance: f64,
    /// Whether each model decides how long it waits after a gap of an input; once the samples that are
    /// compared are settled, none does.
    pub waits: bool,
    /// What all fits and runs may spend.
    pub budget: Budget,
    /// Steps that one fit of a race may spend at most.
    pub most: u64,
}

/// One series of a run: an output on a recording.
pub struct Track {
    /// Number of the output.
    pub output: usize,
    /// Contiguous stretches.
    pub stretches: Vec<std::ops::Range<usize>>,
    /// Times, s.
    pub time: Vec<f64>,
    /// Measured less predicted.
    pub residual: Vec<f64>,
    /// Sensitivities of the prediction.
    pub sensitivities: Vec<Vec<f64>>,
}

/// Where a model stands: all parameters, and the initial states of each recording.
#[derive(Debug, Clone)]
pub struct Stand {
    /// Values in the model's order, SI.
    pub parameters: Vec<f64>,
    /// One list a recording.
    pub initials: Vec<Vec<f64>>,
}

impl Stand {
    /// Where a fit ended.
    pub fn of(fit: &Fit) -> Self {
        Self { parameters: fit.model.parameters.iter().map(|p| p.value).collect(), initials: fit.starts() }
    }

    /// The same for a model with parameters and states added at the end.
    #[must_use]
    pub fn extended(&self, model: &Model, added: &[f64]) -> Self {
        let mut parameters = self.parameters.clone();
        let mut rest = added.iter();
        for p in &model.parameters[parameters.len()..] {
            parameters.push(if p.fit { rest.next().copied().unwrap_or(p.value) } else { p.value });
        }
        let start = |s: &crate::model::State| match s.initial {
            crate::model::Initial::Number(x) => x,
            _ => 0.0,
        };
        let grow = |old: &Vec<f64>| {
            let mut all = old.clone();
            all.extend(model.states[old.len().min(model.states.len())..].iter().map(start));
            all
        };
        Self { parameters, initials: self.initials.iter().map(grow).collect() }
    }

    /// The model with these values in place.
    pub fn placed(&self, model: &Model) -> Model {
        let mut placed = model.clone();
        for (p, v) in placed.parameters.iter_mut().zip(&self.parameters) {
            p.value = *v;
        }
        placed
    }
}

/// Samples times states from which on a simulation is long.
const LONG: usize = 40_000;
/// Share of the white part of the noise that the simulator's error may have.
const SOLVER: f64 = 0.05;
/// Share of the misfit that the simulator's error may have in fits that are only ranked.
const ROUGH: f64 = 0.01;
/// Bounds of the simulator's tolerance, as a share of an output's spread.
const TOLERANCES: (f64, f64) = (1e-6, 1e-3);

/// Steps of the solver that a diagnosis may spend for each sample, some ten times what one takes whose model
/// is not stiff; and the fewest steps that any may spend.
const BUDGET: (u64, u64) = (100_000, 50_000_000);
/// One fit may spend one part in so many of them, that of the model as given one in fewer.
const FITS: u64 = 10;
const FIRST_FIT: u64 = 4;

/// The steps that a diagnosis of some recordings may spend.
fn steps(model: &Model, recordings: &[Recording]) -> u64 {
    let own = |c: &&Channel| {
        model.inputs.iter().any(|i| i.name == c.name) || model.outputs.iter().any(|o| o.name == c.name)
    };
    let longest = |r: &Recording| r.channels.iter().filter(own).map(Channel::len).max().unwrap_or(0) as u64;
    let samples: u64 = recordings.iter().map(longest).sum();
    BUDGET.0.saturating_mul(samples).max(BUDGET.1)
}

/// Share of its runs, one in so many, that a fit may spend whatever is left for others.
const SHARED: u64 = 5;
/// Steps that a run counts as at least where it is asked whether runs have become long.
const SHORT: u64 = 25_000;
/// Steps that take some seconds.
const SECONDS: u64 = 40_000_000;

/// The tolerance, a share of an output's spread, that keeps the simulator's error far below the noise.
fn tolerance(model: &Model, recordings: &[Recording]) -> f64 {
    let outputs = recordings.iter().flat_map(|r| model.outputs.iter().filter_map(|o| r.find(&o.name)));
    let shares = outputs.filter_map(|c| {
        let v: Vec<f64> = c.values.iter().copied().filter(|v| v.is_finite()).collect();
        let spread = spread(&v);
        // Third differences of white noise of deviation σ have deviation √20 σ.
        let third: Vec<f64> = v.windows(4).map(|w| w[3] - 3.0 * w[2] + 3.0 * w[1] - w[0]).collect();
        let noise = robust_deviation(&third) / 20f64.sqrt();
        (spread > 0.0).then_some(SOLVER * noise / spread)
    });
    shares.fold(f64::INFINITY, f64::min).clamp(TOLERANCES.0, TOLERANCES.1)
}

impl Bench {
    /// A bench for a model, to the tolerance that its recordings' noise asks for.
    pub fn new(model: &Model, recordings: Vec<Recording>, separate: bool, seed: u64) -> Self {
        Self {
            budget: Budget::new(steps(model, &recordings), None),
            tolerance: tolerance(model, &recordings),
            recordings,
            separate,
            seed,
            own_parameters: model.parameters.len(),
            own_states: model.states.len(),
            own_inputs: model.inputs.len(),
            waits: true,
            most: u64::MAX,
        }
    }

    /// Root mean square of a channel about its mean, over all recordings.
    pub fn spread(&self, name: &str) -> f64 {
        spread_of(&self.recordings, name)
    }

    /// Whether a channel takes more than one value.
    pub fn moves(&self, name: &str) -> bool {
        let channels = self.recordings.iter().filter_map(|r| r.find(name));
        let mut values = channels.flat_map(|c| c.samples().map(|(_, v)| v));
        values.next().is_some_and(|first| values.any(|v| v != first))
    }

    /// What one fit may spend.
    pub fn part(&self) -> Budget {
        self.budget.part(FITS)
    }

    /// What a fit may spend that is a small part of a search: so many runs as long as those of the model
    /// as given, which ends one whose runs have become many times as long.
    pub fn runs(&self, count: u64) -> Budget {
        let usual = self.budget.stages().into_iter().find(|s| s.name == foretold::FIRST_FIT && s.runs > 0);
        let part = self.part();
        let Some(usual) = usual else { return part };
        let one = usual.steps / usual.runs;
        let steps = count * one.max(SHORT);
        part.at_most(steps.min(self.most.max(count * one / SHARED)))
    }

    /// The same bench, on which one fit of a race spends at most one part in so many of what is left, where that is no too small
    /// share of its runs: what is stiff leaves something to the next. To be asked for while nothing runs.
    pub fn sharing(&self, parts: usize) -> Self {
        Self { most: self.budget.rest().most() / parts.max(1) as u64, ..self.clone() }
    }

    /// Options of a fit on this bench.
    pub fn options(&self, effort: Effort, iterations: usize) -> FitOptions<'static> {
        FitOptions {
            effort,
            seed: self.seed,
            separate_holdout: self.separate,
            tolerance: self.tolerance,
            waits: self.waits,
            budget: self.part(),
            drawn_starts: if iterations < 60 { 0 } else { 4 },
            stopping: Stopping { iterations, reduction: 1e-6, step: 1e-6 },
            ..FitOptions::default()
        }
    }

    /// A rougher tolerance, that keeps the simulator's error below what a fitted model leaves.
    pub fn rough(&self, fit: &Fit) -> f64 {
        let outputs = fit.model.outputs.iter().zip(&fit.rmse);
        let shares = outputs.map(|(o, r)| ROUGH * r / self.spread(&o.name));
        let share = shares.filter(|s| s.is_finite()).fold(f64::INFINITY, f64::min);
        share.clamp(self.tolerance, TOLERANCES.1.max(self.tolerance))
    }

    /// Whether the recordings are tables of trials.
    pub fn is_trials(&self) -> bool {
        self.recordings.iter().any(|r| r.kind == Kind::Trials)
    }

    /// The fitted spans of a recording.
    pub fn spans(&self, model: &Model, number: usize) -> Vec<Span> {
        setup::spans(model, &self.recordings[number], &self.options(Effort::Near, 0)).fit
    }

    /// The first part of the fitted spans, short enough for screening.
    fn screened_spans(&self, model: &Model, number: usize) -> Vec<Span> {
        let spans = self.spans(model, number);
        let recording = &self.recordings[number];
        let output = model.outputs.iter().find_map(|o| recording.find(&o.name));
        let Some(step) = output.and_then(Channel::median_step) else { return spans };
        let allowed = SCREENED as f64 / self.recordings.len() as f64 * step;
        let mut left = allowed;
        let mut short = Vec::new();
        for s in spans {
            if left > 0.0 {
                short.push(Span::new(s.from, s.to.min(s.from + left)));
                left -= s.length();
            }
        }
        short
    }

    /// Whether an input is set from what an output shows.
    pub fn is_loop(&self) -> bool {
        self.recordings.iter().flat_map(|r| &r.channels).any(|c| c.hold == Hold::AfterReading)
    }

    /// Fits a model from all starts on the first part, then walks on from there on the whole.
    ///
    /// # Errors
    /// Where the model cannot be fitted at all.
    pub fn full_fit(&self, model: &Model) -> Result<Fit> {
        let spans: Vec<Vec<Span>> = (0..self.recordings.len()).map(|k| self.spans(model, k)).collect();
        let short: Vec<Vec<Span>> =
            (0..self.recordings.len()).map(|k| self.screened_spans(model, k)).collect();
        if self.is_trials() || spans == short {
            return fit(model, &self.recordings, &self.first_options());
        }
        let cut = |(r, spans): (&Recording, &Vec<Span>)| r.clone().with_spans(spans.clone(), Vec::new());
        let recordings: Vec<Recording> = self.recordings.iter().zip(&short).map(cut).collect();
        super::compared::anew(self, &fit(model, &recordings, &self.first_options())?)
    }

    /// Options of the fit of the model as given.
    pub fn first_options(&self) -> FitOptions<'static> {
        FitOptions { budget: self.budget.part(FIRST_FIT), ..self.options(Effort::Full, 60) }
    }

    /// Finds the intervals of parameters that trade, and what is determined of them, where some do.
    ///
    /// # Errors
    /// Where the fitted model cannot be run.
    pub fn ascertain(&self, fit: &mut Fit) -> Result<()> {
        if fit.unseen.is_empty() {
            return Ok(());
        }
        // what a fit may spend, or all where that is a matter of seconds
        let one_in = (self.budget.most() / (2 * SECONDS)).clamp(1, FITS);
        let options = FitOptions { budget: self.budget.part(one_in), ..self.options(Effort::Near, 30) };
        ascertain(fit, &self.recordings, &options)
    }

    /// How many proposals are worth a fit in one round: fewer where one simulation is long.
    pub fn patience(&self, model: &Model) -> usize {
        if self.is_long(model) { 22 } else { 28 }
    }

    /// Steps of a fit from a near start: fewer where one simulation is long.
    pub fn steps(&self, model: &Model) -> usize {
        if self.is_long(model) { 12 } else { 40 }
    }

    fn is_long(&self, model: &Model) -> bool {
        self.load(model) > LONG
    }

    /// Samples times states of one simulation.
    fn load(&self, model: &Model) -> usize {
        let output = |r: &Recording| model.outputs.iter().find_map(|o| r.find(&o.name)).map(Channel::len);
        let samples: usize = self.recordings.iter().filter_map(output).sum();
        samples * model.states.len().max(1)
    }

    /// A model ready to run over the parts that the screening uses, to a tolerance.
    ///
    /// The simulator chooses its steps at the values that the model holds, where no plan for them is given; states that
    /// are fitted start at the initials given, else where they are guessed.
    pub fn ready(
        &self,
        model: &Model,
        initials: Vec<Vec<f64>>,
        (tolerance, planned): (f64, Vec<Option<Planned>>),
    ) -> Result<Vec<Record>> {
        let options = FitOptions { tolerance, initials, planned, ..self.options(Effort::Near, 0) };
        let one = |k: usize| {
            let spans = self.screened_spans(model, k);
            let mut record = setup::record(model, &self.recordings[k], k, &spans, &options)?;
            for t in record.tracks.iter_mut().filter(|_| !self.is_trials()) {
                t.stretches = after_beginning(&t.stretches, t.time.len());
            }
            Ok(record)
        };
        (0..self.recordings.len()).map(one).collect()
    }

    /// Statistics of all signals of a fitted model.
    pub fn scene<'a>(&self, model: &'a Model, stand: &Stand) -> Result<Scene<'a>> {
        let trials = self.is_trials();
        let looks = self.look(model, stand)?;
        let outputs = model.outputs.iter().filter_map(|o| self.recordings[0].find(&o.name));
        let step = outputs.filter_map(Channel::median_step).fold(f64::INFINITY, f64::min);
        let spans = self.spans(model, 0);
        let from = spans.first().map_or(0.0, |s| s.from);
        let to = spans.last().map_or(1.0, |s| s.to);
        Ok(Scene {
            model,
            trials,
            companions: super::company::pairs(&self.recordings[0], &looks.signals),
            signals: looks.signals,
            sizes: looks.sizes,
            arguments: looks.arguments,
            step: if step.is_finite() { step } else { 1.0 },
            from,
            to,
            whole: self.whole((from, to)),
            tables: self.tables(),
            measured: self.measured(model),
            peaks: Vec::new(),
            lines: std::collections::BTreeMap::new(),
            shifts: Vec::new(),
            alone: super::alone::marks(&self.recordings),
            own_parameters: self.own_parameters,
            own_states: self.own_states,
        })
    }

    /// First and last time of the first recording, or what is fitted of it.
    fn whole(&self, fitted: (f64, f64)) -> (f64, f64) {
        let ranges = self.recordings.iter().take(1).flat_map(|r| &r.channels).filter_map(Channel::range);
        ranges.fold(fitted, |(from, to), r| (from.min(r.from), to.max(r.to)))
    }

    /// Names of the channels of each clock: of a table, and of each instrument of a log, whose sentences were stamped
    /// as they came.
    fn tables(&self) -> Vec<Vec<String>> {
        let Some(recording) = self.recordings.first() else { return Vec::new() };
        let is_log = |c: &Channel| recording.origins.get(c.table).is_some_and(|o| !o.is_table);
        let mut clocks: Vec<(&Channel, Vec<String>)> = Vec::new();
        for c in &recording.channels {
            let shared =
                |first: &Channel| first.table == c.table && (!is_log(c) || Arc::ptr_eq(&first.time, &c.time));
            match clocks.iter_mut().find(|(first, _)| shared(first)) {
                Some((_, names)) => names.push(c.name.clone()),
                None => clocks.push((c, vec![c.name.clone()])),
            }
        }
        clocks.into_iter().map(|(_, names)| names).collect()
    }

    fn measured(&self, model: &Model) -> BTreeMap<String, (f64, f64)> {
        let mut found = BTreeMap::new();
        for o in &model.outputs {
            let values = self
                .recordings
                .iter()
                .filter_map(|r| r.find(&o.name))
                .flat_map(|c| c.values.iter().copied().filter(|v| v.is_finite()));
            let range = values.fold((f64::INFINITY, f64::NEG_INFINITY), |r, v| (r.0.min(v), r.1.max(v)));
            if range.0 < range.1 {
                found.insert(o.name.clone(), range);
            }
        }
        found
    }

    /// Runs the model with its states, definitions and terms as outputs.
    fn look(&self, model: &Model, stand: &Stand) -> Result<Looks> {
        let watched = Watched::of(model, self.own_inputs);
        let mut probes = model.clone();
        probes.outputs = watched.outputs(model);
        let mut values: Vec<Vec<f64>> = vec![Vec::new(); probes.outputs.len()];
        let mut pace = 1.0;
        for (k, recording) in self.recordings.iter().enumerate() {
            let spans = self.screened_spans(model, k);
            let times = look_times(recording, &spans);
            pace = times.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
            let mut wider = recording.clone();
            let unused = |c: &Channel| !model.outputs.iter().any(|o| o.name == c.name);
            wider.channels.retain(unused);
            for o in &probes.outputs {
                let zero = vec![0.0; times.len()];
                wider.channels.push(Channel::new(o.name.clone(), o.unit.clone(), times.clone(), zero));
            }
            // what is watched measures nothing from which a state could start
            for (s, start) in probes.states.iter_mut().zip(&stand.initials[k]) {
                s.initial = if start.is_nan() { s.initial } else { Initial::Number(*start) };
            }
            let record = setup::record(&probes, &wider, k, &spans, &self.options(Effort::Near, 0))?;
            let parameters = record.parameters(&stand.parameters);
            let run = record.harness.run(&parameters, &stand.initials[k], &[])?;
            for (track, predicted) in record.tracks.iter().zip(&run.predictions) {
                values[track.output].extend(predicted.iter().filter(|x| x.is_finite()));
            }
        }
        // a term may be steeper somewhere than the outputs for which steps are chosen; what is seen of it does
        if values.iter().any(Vec::is_empty) {
            return Err(Error::not_computed("what the model is made of does not stay finite"));
        }
        Ok(watched.statistics(model, &self.recordings, &values, pace))
    }
}

fn look_times(recording: &Recording, spans: &[Span]) -> Vec<f64> {
    if recording.kind == Kind::Trials {
        return recording.channels.first().map(|c| c.time.to_vec()).unwrap_or_default();
    }
    let Some(span) = spans.first() else { return Vec::new() };
    let step = recording.channels.iter().filter_map(Channel::median_step).fold(f64::INFINITY, f64::min);
    let stride = (span.length() / LOOKS as f64).max(step);
    (0..LOOKS).map(|i| span.from + i as f64 * stride).take_while(|t| *t <= span.to).collect()
}

/// Runs records at a stand; sensitivities to some parameters.
///
/// # Errors
/// Where a run fails or does not stay finite.
pub fn run(records: &[Record], stand: &Stand, wanted: &[usize]) -> Result<Vec<Track>> {
    let wanted: Vec<Unknown> = wanted.iter().map(|k| Unknown::Parameter(*k)).collect();
    let mut tracks = Vec::new();
    for record in records {
        let initials = stand.initials.get(record.recording).unwrap_or(&record.initials);
        let run = record.run(&stand.parameters, initials, &wanted)?;
        for ((track, predicted), sensitivities) in record
            .tracks
            .iter()
            .zip(&run.predictions)
            .zip(run.sensitivities.into_iter().chain(std::iter::repeat(Vec::new())))
        {
            if !sensitivities.iter().flatten().all(|s| s.is_finite()) {
                return Err(Error::not_computed("a sensitivity does not stay finite"));
            }
            tracks.push(Track {
                output: track.output,
                stretches: track.stretches.clone(),
                time: track.time.clone(),
                residual: track.residual(predicted),
                sensitivities,
            });
        }
    }
    Ok(tracks)
}
