//! Recordings cut where an input was not recorded for long, so that what follows the gap has a start of its own.
//!
//! # Purpose
//! Nobody knows what an input did in its gap, and a model that remembers long shows it for long: a room under a logger that
//! was off for an hour, for a day. What follows was left out then, the part held out for the proof with it.
//!
//! # Method
//! The model as given is fitted, and what a gap leaves in its outputs is measured (`forgotten`). Where that is a tenth of all
//! samples and more, the recording is cut there: parameters are shared, and initial states are each piece's own.

use super::Request;
use super::answer::{DataFault, Finding};
use super::at_rest::starting_anywhere;
use super::bench::Bench;
use super::faults::{Cleaned, clean};
use super::forgotten::traces;
use crate::estimate::Fit;
use crate::expression::Expr;
use crate::model::{Initial, Model};
use crate::record::{Channel, Kind, Recording};
use crate::simulate::{Budget, GAP_STEPS};

/// Share of the samples that a gap must cost beside its own.
const COSTS: f64 = 0.1;
/// Samples that a piece must hold, of the output with most and of each channel of the model.
const FEWEST: (usize, usize) = (100, 10);
/// Gaps of a recording that are looked at: more of them are dropouts.
const MOST: usize = 8;

/// A model and recordings, of which some are pieces.
pub struct Pieces {
    /// The model; its states start anywhere.
    pub model: Model,
    /// The recordings.
    pub recordings: Vec<Recording>,
    /// What was cut.
    pub notes: Vec<String>,
    /// The gaps of the whole as they are told, which no piece shows.
    pub told: Vec<DataFault>,
}

/// Recordings cut at gaps of inputs that a model shows for long; none where there are no such, where the spans are chosen,
/// or where states start in the steady state, which a piece does not.
pub fn cut(request: &Request<'_>) -> Option<Pieces> {
    let model = request.model;
    let may = |r: &Recording| {
        r.kind != Kind::Trials && !r.spans.given && (1..=MOST).contains(&gaps(model, r).len())
    };
    let is_steady = model.states.iter().any(|s| s.initial == Initial::Steady);
    if model.states.is_empty() || is_steady || !request.recordings.iter().any(may) {
        return None;
    }
    let Cleaned { recordings: clean, told, .. } = clean(request);
    let mut bench = Bench::new(model, clean, !request.separate.is_empty(), request.seed);
    bench.budget = Budget::new(bench.budget.most(), request.time_limit);
    let base = bench.full_fit(model).ok()?;
    let (mut recordings, mut notes) = (Vec::new(), Vec::new());
    for (k, own) in request.recordings.iter().enumerate() {
        let places = if may(own) { places(&bench, &base, k) } else { Vec::new() };
        let pieces = pieces(model, own, &places);
        if pieces.len() > 1 {
            notes.push(format!(
                "'{}' is read in {} pieces, cut where the model remembers a gap of an input for long: initial states are each piece's own",
                own.name,
                pieces.len()
            ));
        }
        recordings.extend(pieces);
    }
    for r in &mut recordings {
        r.is_piece = request.recordings.len() == 1;
    }
    let told = told.into_iter().filter(|f| f.finding.code == "gap").collect();
    (!notes.is_empty()).then(|| Pieces { model: starting_anywhere(model), recordings, notes, told })
}

/// Whether a finding goes with the time of one recording.
pub fn goes_with_time(finding: &Finding) -> bool {
    finding.code.starts_with("clock") || Expr::parse(&finding.term).is_ok_and(|e| e.mentions("t"))
}

/// The gaps of a model's inputs, by time; those that overlap are one.
fn gaps(model: &Model, recording: &Recording) -> Vec<(f64, f64)> {
    let inputs = model.inputs.iter().filter_map(|i| recording.find(&i.name));
    let mut all: Vec<(f64, f64)> = inputs.flat_map(|c| c.gaps(GAP_STEPS)).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut joined: Vec<(f64, f64)> = Vec::new();
    for gap in all {
        match joined.last_mut() {
            Some(last) if gap.0 <= last.1 => last.1 = last.1.max(gap.1),
            _ => joined.push(gap),
        }
    }
    joined
}

/// The gaps after which a fitted model shows too long what an input was there.
fn places(bench: &Bench, base: &Fit, k: usize) -> Vec<(f64, f64)> {
    let (model, recording, starts) = (&base.model, &bench.recordings[k], base.starts());
    let Some(from) = bench.spans(model, k).first().map(|s| s.from) else { return Vec::new() };
    let found = traces(bench, model, recording, &starts[k], from).unwrap_or_default();
    let times = |o: usize| recording.find(&model.outputs[o].name).into_iter().flat_map(Channel::samples);
    let all: usize = (0..model.outputs.len()).map(|o| times(o).count()).sum();
    let costs = |gap: &(f64, f64)| {
        let last = |o: usize| {
            let own = found.iter().filter(|t| t.0 == o && t.1 >= gap.0 && t.1 < gap.1);
            own.map(|t| t.2).fold(gap.1, f64::max)
        };
        let lost = |o: usize| times(o).filter(|s| s.0 > gap.1 && s.0 <= last(o)).count();
        (0..model.outputs.len()).map(lost).sum::<usize>()
    };
    let is_dear = |gap: &(f64, f64)| costs(gap) as f64 > COSTS * all as f64;
    gaps(model, recording).into_iter().filter(is_dear).collect()
}

/// A recording cut at some gaps; whole where a piece would hold too little.
fn pieces(model: &Model, recording: &Recording, places: &[(f64, f64)]) -> Vec<Recording> {
    let from = std::iter::once(f64::NEG_INFINITY).chain(places.iter().map(|g| g.1));
    let to = places.iter().map(|g| g.0).chain([f64::INFINITY]);
    let pieces: Vec<Recording> =
        from.zip(to).enumerate().map(|(k, ends)| piece(recording, k, ends)).collect();
    let counts = |r: &Recording, name: &str| r.find(name).map_or(0, |c| c.samples().count());
    let outputs = || model.outputs.iter().map(|o| o.name.as_str());
    let all = || outputs().chain(model.inputs.iter().map(|i| i.name.as_str()));
    let holds = |r: &Recording| {
        outputs().any(|o| counts(r, o) >= FEWEST.0)
            && all().all(|n| counts(r, n) >= FEWEST.1 || recording.find(n).is_none())
    };
    let is_cut = pieces.len() > 1 && pieces.iter().all(holds);
    if is_cut { pieces } else { vec![recording.clone()] }
}

/// What a recording holds between two times, both with it.
fn piece(recording: &Recording, k: usize, (from, to): (f64, f64)) -> Recording {
    let mut own = recording.clone();
    own.name = format!("{}, piece {}", recording.name, k + 1);
    if k > 0 {
        own.sources.clear();
    }
    for c in &mut own.channels {
        let inside = c.time.partition_point(|t| *t < from)..c.time.partition_point(|t| *t <= to);
        c.values = c.values[inside.clone()].to_vec();
        c.time = c.time[inside].into();
    }
    own
}
