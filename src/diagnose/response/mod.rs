//! The response of a fitted model to small forces, without simulating it again.
//!
//! # Purpose
//! The directions in which hundreds of proposals at rest move the predictions. A simulation for each is
//! what a screening would spend its time in; this takes one pass over the proposal's own terms.
//!
//! # Method
//! Along the run of the fitted model, x′ = f(x, t), y = c(x, t), a proposal of small amplitude a adds
//! a·g(t) to the rates and a·e(t) to the outputs. The states' own courses stand as inputs, so g and e
//! cost one look at each sample. Then δx′ = A(t) δx + g, δy = C(t) δx + e with A = ∂f/∂x, C = ∂c/∂x,
//! stepped by the trapezoidal rule on the samples of the finest output, a finer mesh, or a coarser one where all
//! signals are slow beside them.
//!
//! # References
//! A. E. Bryson, Y.-C. Ho, Applied Optimal Control (1975), 1.4 and A4 (perturbations about a nominal
//! path); E. Hairer, G. Wanner, Solving Ordinary Differential Equations II (1996), IV.3 (A-stability).
//!
//! # Numerical aspects
//! The rule is stable at any step; its error is (ωh)²/12 of a motion of angular frequency ω. Models that
//! remember their own states (lags, gaps) have more states than they name and are not treated here.

mod adjoint;
mod along;
mod driven;
mod probe;
mod thin;

use super::bench::{Bench, Stand, Track};
use super::catalogue::{Proposal, edit};
use crate::estimate::fit::harness::Record;
use crate::expression::Expr;
use crate::model::{Model, State};
use crate::record::{Channel, Recording};
use along::{Along, Site};
pub use driven::{Drive, Driven};
use faer::Mat;
use probe::{frozen, look, mesh, nudged, output, remembers_states, rows};
use std::sync::Arc;

/// States at most.
const STATES: usize = 12;

/// Changes of rates and outputs: site by site, amplitude by amplitude, in time.
type Changes = Vec<Vec<Vec<f64>>>;

/// A fitted model along its own run on the screened parts of all recordings.
pub struct Response {
    model: Model,
    stand: Stand,
    tolerance: f64,
    runs: Vec<Along>,
    /// Whether the whole mesh was kept, and no state is measured as it is.
    pub is_fine: bool,
}

/// At what places the terms of a proposal are looked at.
#[derive(Clone, Copy)]
pub enum Places<'t> {
    /// Where the model's own run takes its states, on a mesh as coarse as that allows.
    Simulated,
    /// Where the outputs saw those states that are outputs themselves, at all samples: a force that is faster than the
    /// states is met in another phase where the run is a little off. Takes the run's tracks.
    Measured(&'t [Track]),
}

/// A proposal's own rates and outputs along a run, of which the states are inputs.
pub struct Terms<'p> {
    proposal: &'p Proposal,
    sites: Vec<Site>,
    records: Vec<Record>,
    /// States that it adds.
    states: usize,
}

impl Response {
    /// Linearises a model along its run; `None` where it cannot be treated so.
    pub fn of(
        bench: &Bench,
        model: &Model,
        stand: &Stand,
        tolerance: f64,
        records: &[Record],
        places: Places<'_>,
    ) -> Option<Self> {
        let n = model.states.len();
        if bench.is_trials() || n == 0 || n > STATES || remembers_states(model) {
            return None;
        }
        let mut response =
            Self { model: model.clone(), stand: stand.clone(), tolerance, runs: Vec::new(), is_fine: true };
        let shown = |state: &State| model.outputs.iter().any(|o| o.equals == Expr::name(&state.name));
        response.is_fine = !model.states.iter().any(shown);
        let mut first = 0;
        for record in records {
            let (run, stride) = match places {
                Places::Simulated => response.along(bench, record, thin::LONGEST)?,
                Places::Measured(tracks) => {
                    let own = tracks.get(first..first + record.tracks.len())?;
                    let (mut run, stride) = response.along(bench, record, 1)?;
                    run.take_places(model, own);
                    (run, stride)
                }
            };
            first += record.tracks.len();
            response.runs.push(run);
            response.is_fine &= stride == 1;
        }
        Some(response)
    }

    /// The same response on all samples and at the places that the run's tracks measured.
    pub fn measured(&self, bench: &Bench, tracks: &[Track]) -> Option<Self> {
        let records =
            bench.ready(&self.model, self.stand.initials.clone(), (self.tolerance, Vec::new())).ok()?;
        Self::of(bench, &self.model, &self.stand, self.tolerance, &records, Places::Measured(tracks))
    }

    /// A proposal's own terms, ready to be looked at from any of its starts; `None` where they cannot be.
    pub fn terms<'p>(&self, bench: &Bench, proposal: &'p Proposal) -> Option<Terms<'p>> {
        let p = &proposal.model;
        if !self.has_its_states(p) || proposal.amplitude_numbers().len() != proposal.amplitudes.len() {
            return None;
        }
        if probe::moves_bends(proposal) {
            return None;
        }
        let (terms, sites) = self.own_terms(proposal)?;
        let ready = |along: &Along| {
            probe::ready(bench, (&terms, &along.recording, along.number), &along.time, self.tolerance)
        };
        let records = self.runs.iter().map(ready).collect::<Option<_>>()?;
        Some(Terms { proposal, sites, records, states: terms.states.len() })
    }

    /// The tracks of the screened parts with sensitivities to a proposal's amplitudes at rest.
    pub fn tracks(&self, terms: &Terms<'_>, start: &[f64]) -> Option<Vec<Track>> {
        Some(self.moved(&self.looks(terms, start)?, &terms.sites))
    }

    /// The same for a proposal with one amplitude times each of some shapes, functions of the values of
    /// signals: one sensitivity a shape.
    pub fn shaped(
        &self,
        bench: &Bench,
        push: &Proposal,
        signals: &[&str],
        shapes: &dyn Fn(&[f64]) -> Vec<f64>,
    ) -> Option<Vec<Track>> {
        let terms = self.terms(bench, push)?;
        let looks = self.looks(&terms, push.starts.first()?)?;
        let shaped = |(along, seen): (&Along, &Changes)| {
            let values: Vec<Vec<f64>> = along.values(signals)?.iter().map(|x| shapes(x)).collect();
            let count = values.first()?.len();
            let times = |c: &[f64], k: usize| c.iter().zip(&values).map(|(g, s)| g * s[k]).collect();
            Some(seen.iter().map(|c| (0..count).map(|k| times(&c[0], k)).collect()).collect())
        };
        let changes: Option<Vec<Changes>> = self.runs.iter().zip(&looks).map(shaped).collect();
        Some(self.moved(&changes?, &terms.sites))
    }

    /// The tracks that changes at sites move, a sensitivity for each change.
    fn moved(&self, changes: &[Changes], sites: &[Site]) -> Vec<Track> {
        let one = |(along, seen): (&Along, &Changes)| {
            let column = |a: usize| -> Vec<(Site, &[f64])> {
                sites.iter().zip(seen).map(|(s, c)| (*s, &c[a][..])).collect()
            };
            let count = seen.first().map_or(0, Vec::len);
            let moved: Vec<Vec<f64>> = (0..count).map(|a| along.propagate(&self.model, &column(a))).collect();
            along.on_tracks(&moved)
        };
        self.runs.iter().zip(changes).flat_map(one).collect()
    }

    /// What a proposal's amplitudes at rest change, site by site and amplitude by amplitude, along every run.
    fn looks(&self, terms: &Terms<'_>, start: &[f64]) -> Option<Vec<Changes>> {
        let stand = self.stand.extended(&terms.proposal.model, &terms.proposal.quiet(start));
        let initials = vec![f64::NAN; terms.states];
        let place = (&stand.parameters[..], &initials[..]);
        let wanted = terms.proposal.amplitude_numbers();
        let one = |(along, record): (&Along, &Record)| {
            look(record, along.time.len(), place, &wanted).map(|run| run.sensitivities)
        };
        self.runs.iter().zip(&terms.records).map(one).collect()
    }

    /// Whether a model has the states of this one, and starts them alike.
    fn has_its_states(&self, p: &Model) -> bool {
        let mut pairs = p.states.iter().zip(&self.model.states);
        p.states.len() >= self.model.states.len()
            && p.outputs.len() == self.model.outputs.len()
            && pairs.all(|(a, b)| a.name == b.name && a.initial == b.initial)
    }

    /// The model of a proposal's own rates and outputs with the states as inputs: those that it changes.
    fn own_terms(&self, proposal: &Proposal) -> Option<(Model, Vec<Site>)> {
        let (base, p) = (&self.model, &proposal.model);
        let changed = p.definitions.iter().filter(|d| !base.definitions.contains(d));
        let changed: Vec<&str> = changed.map(|d| d.name.as_str()).collect();
        let is_moved = |e: &Expr| changed.iter().any(|d| edit::reaches(p, e, d));
        let mut terms = frozen(p, base.states.len());
        let mut sites = Vec::new();
        terms.outputs.clear();
        for (i, (new, old)) in p.states.iter().zip(&base.states).enumerate() {
            if new.rate != old.rate || is_moved(&new.rate) {
                terms.outputs.push(output(p, sites.len(), &new.rate));
                sites.push(Site::Rate(i));
            }
        }
        for (i, (new, old)) in p.outputs.iter().zip(&base.outputs).enumerate() {
            if new.equals != old.equals || is_moved(&new.equals) {
                terms.outputs.push(output(p, sites.len(), &new.equals));
                sites.push(Site::Output(i));
            }
        }
        (!sites.is_empty()).then_some((terms, sites))
    }

    fn along(&self, bench: &Bench, record: &Record, longest: usize) -> Option<(Along, usize)> {
        let (model, number) = (&self.model, record.recording);
        let n = model.states.len();
        let time: Arc<[f64]> = mesh(record)?.into();
        let mut recording = bench.recordings[number].clone();
        let own = |c: &Channel| {
            model.outputs.iter().any(|o| o.name == c.name) || model.states.iter().any(|s| s.name == c.name)
        };
        recording.channels.retain(|c| !own(c));
        let mut probes = model.clone();
        probes.outputs =
            model.states.iter().enumerate().map(|(i, s)| output(model, i, &Expr::name(&s.name))).collect();
        let initials = self.stand.initials.get(number)?;
        let place = (&self.stand.parameters[..], &initials[..]);
        let looked = |model: &Model, recording: &Recording, time: &Arc<[f64]>, place, wanted: &[usize]| {
            let record = probe::ready(bench, (model, recording, number), time, self.tolerance)?;
            look(&record, time.len(), place, wanted)
        };
        let states = looked(&probes, &recording, &time, place, &[])?.predictions;
        let signals: Vec<Vec<f64>> = recording.channels.iter().filter_map(|c| thin::on(c, &time)).collect();
        let courses: Vec<&[f64]> = states.iter().chain(&signals).map(Vec::as_slice).collect();
        let stride = thin::stride(&courses, time.len(), longest);
        let time: Arc<[f64]> = thin::every(&time, stride).into();
        thin::read_on(&mut recording, &time);
        for (s, values) in model.states.iter().zip(states) {
            let values = thin::every(&values, stride);
            recording.channels.push(Channel::new(s.name.clone(), s.unit.clone(), time.clone(), values));
        }
        let (nudged, wanted) = nudged(model);
        let mut parameters = self.stand.parameters.clone();
        parameters.resize(nudged.parameters.len(), 0.0);
        let slopes = looked(&nudged, &recording, &time, (&parameters, &[]), &wanted)?;
        let a = |i: usize| Mat::from_fn(n, n, |row, column| slopes.sensitivities[row][column][i]);
        let mut along = Along {
            recording,
            number,
            steps: Vec::with_capacity(time.len()),
            forward: Vec::new(),
            force: Vec::new(),
            shown: Vec::with_capacity(n * model.outputs.len() * time.len()),
            first: rows(&a(0)),
            tracks: record.tracks.iter().map(|t| (t.output, t.stretches.clone(), t.time.clone())).collect(),
            time,
        };
        along.fill(&a);
        for i in 0..along.time.len() {
            let outputs = &slopes.sensitivities[n..];
            along.shown.extend(outputs.iter().flat_map(|o| o.iter().map(move |c| c[i])));
        }
        along.forward.iter().chain(&along.shown).all(|x| x.is_finite()).then_some((along, stride))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::bench;
    use crate::diagnose::catalogue;
    use crate::units::Unit;

    const MODEL: &str = r#"
        name = "axis"
        [inputs]
        force = { unit = "N" }
        [parameters]
        M = { value = 4, unit = "kg", fit = true }
        Fv = { value = 6, unit = "N*s/m" }
        k = { value = 150, unit = "N/m" }
        k3 = { value = 5000, unit = "N/m^3" }
        [definitions]
        push = { equals = "force - k3*q^3", unit = "N" }
        [states]
        q = { rate = "v", unit = "m", initial = 0 }
        v = { rate = "(push - Fv*v - k*q)/M", unit = "m/s", initial = 0 }
        [outputs]
        position = { equals = "q", unit = "m" }
        speed = { equals = "v + k*q/Fv", unit = "m/s" }
    "#;

    fn recording() -> Recording {
        let time = |step: f64, n: i32| -> Vec<f64> { (0..n).map(|i| step * f64::from(i)).collect() };
        let made = |name: &str, unit: &str, step: f64, n: i32, f: &dyn Fn(f64) -> f64| {
            let t = time(step, n);
            let values = t.iter().map(|t| f(*t)).collect();
            Channel::new(name, Unit::parse(unit).unwrap(), t, values)
        };
        let channels = vec![
            made("force", "N", 0.01, 3001, &|t| 5.0 * (2.0 * t).sin() + 4.0 * (7.3 * t).cos()),
            made("temp", "K", 0.5, 61, &|t| 290.0 + (0.2 * t).sin()),
            made("position", "m", 0.01, 3001, &|t| 0.03 * (2.0 * t).sin()),
            made("speed", "m/s", 0.023, 1300, &|t| 0.06 * (2.0 * t).cos()),
        ];
        Recording::from_channels("made", channels).unwrap()
    }

    fn at_given(model: &Model) -> (Bench, Stand, Response) {
        let bench = Bench::new(model, vec![recording()], false, 1);
        let records = bench.ready(model, Vec::new(), (1e-5, Vec::new())).unwrap();
        let stand = Stand {
            parameters: model.parameters.iter().map(|p| p.value).collect(),
            initials: vec![records[0].initials.clone()],
        };
        let response = Response::of(&bench, model, &stand, 1e-5, &records, Places::Simulated).unwrap();
        (bench, stand, response)
    }

    /// Σ w·δy by the moved tracks, and Σ g·∂L/∂g by the pulls: the same for any force and any weights.
    #[test]
    fn read_backwards_it_is_its_own_adjoint() {
        let (_, _, response) = at_given(&Model::parse(MODEL).unwrap());
        let mut seed = 1u64;
        let mut drawn = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as f64 / (1u64 << 31) as f64 - 0.5
        };
        let count = response.course("q").unwrap()[0].len();
        let force: Vec<f64> = (0..count).map(|_| drawn()).collect();
        let moved = response.pushed("v", vec![vec![force.clone()]]).unwrap();
        let weights: Vec<Vec<f64>> =
            moved.iter().map(|t| t.sensitivities[0].iter().map(|_| drawn()).collect()).collect();
        let forwards: f64 = moved
            .iter()
            .zip(&weights)
            .flat_map(|(t, w)| t.sensitivities[0].iter().zip(w))
            .map(|(y, w)| y * w)
            .sum();
        let pulls = response.pulls("v", &weights).unwrap();
        let backwards: f64 = pulls[0].iter().zip(&force).map(|(p, g)| p * g).sum();
        assert!((forwards - backwards).abs() < 1e-9 * forwards.abs(), "{forwards} {backwards}");
        assert!(forwards.abs() > 1e-9);
    }

    /// Where an output is a state, its course is the measured one: 0.03 sin 2t, no noise in it.
    #[test]
    fn takes_the_measured_places() {
        let (bench, stand, simulated) = at_given(&Model::parse(MODEL).unwrap());
        let records = bench.ready(&simulated.model, Vec::new(), (1e-5, Vec::new())).unwrap();
        let tracks = bench::run(&records, &stand, &[]).unwrap();
        let response = simulated.measured(&bench, &tracks).unwrap();
        let places = response.course("q").unwrap();
        let off = |(q, t): (&f64, &f64)| (q - 0.03 * (2.0 * t).sin()).abs();
        let largest = places[0].iter().zip(response.runs[0].time.iter()).map(off).fold(0.0, f64::max);
        assert!(largest < 1e-3, "{largest}");
    }

    /// Every proposal at rest: the linearised response against the simulation with dual numbers.
    #[test]
    fn agrees_with_simulated_sensitivities() {
        let model = Model::parse(MODEL).unwrap();
        let (bench, stand, response) = at_given(&model);
        let scene = bench.scene(&model, &stand).unwrap();
        let proposals = catalogue::ALL.iter().flat_map(|m| (m.propose)(&scene));
        let mut compared = std::collections::BTreeSet::new();
        for p in proposals.filter(|p| !p.amplitudes.is_empty()) {
            // The last resonance swings by a radian a sample, of which the rule makes 8 %; the one before it 1 %.
            let resolved = usize::from(p.code == "extra-resonance");
            let start = p.starts.iter().rev().nth(resolved).unwrap();
            let Some(swift) = response.terms(&bench, &p).and_then(|t| response.tracks(&t, start)) else {
                continue;
            };
            let records = bench.ready(&p.at_rest(), Vec::new(), (1e-5, Vec::new())).unwrap();
            let quiet = stand.extended(&p.model, &p.quiet(start));
            let slow = bench::run(&records, &quiet, &p.amplitude_numbers()).unwrap();
            for (a, b) in swift.iter().zip(&slow) {
                for (x, y) in a.sensitivities.iter().zip(&b.sensitivities) {
                    let square = |v: &mut dyn Iterator<Item = f64>| v.map(|d| d * d).sum::<f64>();
                    let off = square(&mut x.iter().zip(y).map(|(x, y)| x - y));
                    let size = square(&mut y.iter().copied());
                    // What is sharp within a signal is off by more than the signal itself, twice as much at most.
                    let allowed = if p.code == "stribeck-friction" { 2.0 * thin::LEFT } else { 0.02 };
                    assert!(
                        off <= allowed * allowed * size,
                        "{} at {}: {off} of {size}",
                        p.code,
                        p.site.name
                    );
                    compared.insert(p.code);
                }
            }
        }
        assert!(compared.len() > 12, "{compared:?}");
    }
}
