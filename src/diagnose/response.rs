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
//! stepped by the trapezoidal rule on the samples of the finest output or a finer mesh.
//!
//! # References
//! A. E. Bryson, Y.-C. Ho, Applied Optimal Control (1975), 1.4 and A4 (perturbations about a nominal
//! path); E. Hairer, G. Wanner, Solving Ordinary Differential Equations II (1996), IV.3 (A-stability).
//!
//! # Numerical aspects
//! The rule is stable at any step; its error is (ωh)²/12 of a motion of angular frequency ω. Models that
//! remember their own states (lags, gaps) have more states than they name and are not treated here.

use super::bench::{Bench, Stand, Track};
use super::catalogue::{Proposal, edit};
use crate::estimate::FitOptions;
use crate::estimate::fit::Effort;
use crate::estimate::fit::rig::{Record, Run, Unknown};
use crate::estimate::fit::setup;
use crate::expression::{BinaryOp, Expr};
use crate::model::{Initial, Input, Model, Output, Parameter};
use crate::record::{Channel, Recording};
use faer::Mat;
use faer::linalg::solvers::Solve;
use std::ops::Range;
use std::sync::Arc;

/// States at most.
const STATES: usize = 12;
/// Points of a mesh that short recordings are refined to, and the finest refinement.
const POINTS: usize = 20_000;
const FINEST: usize = 8;
/// A longer stretch than so many usual steps is divided.
const USUAL: f64 = 1.5;

/// A fitted model along its own run on the screened parts of all recordings.
pub struct Response {
    model: Model,
    stand: Stand,
    tolerance: f64,
    runs: Vec<Along>,
}

/// One recording.
struct Along {
    /// Inputs, with the courses of the states beside them.
    recording: Recording,
    number: usize,
    time: Arc<[f64]>,
    /// F of every step, n × n row by row: δx₊ = F δx + G (g + g₊).
    forward: Vec<f64>,
    /// G of every step.
    force: Vec<f64>,
    /// C at every time, outputs × n.
    shown: Vec<f64>,
    /// A at the first time.
    first: Vec<f64>,
    tracks: Vec<(usize, Vec<Range<usize>>, Vec<f64>)>,
}

impl Response {
    /// Linearises a model along its run; `None` where it cannot be treated so.
    pub fn of(
        bench: &Bench,
        model: &Model,
        stand: &Stand,
        tolerance: f64,
        records: &[Record],
    ) -> Option<Self> {
        let n = model.states.len();
        if bench.is_trials() || n == 0 || n > STATES || remembers_states(model) {
            return None;
        }
        let mut response = Self { model: model.clone(), stand: stand.clone(), tolerance, runs: Vec::new() };
        for record in records {
            let run = response.along(bench, record)?;
            response.runs.push(run);
        }
        Some(response)
    }

    /// The tracks of the screened parts with sensitivities to a proposal's amplitudes at rest.
    pub fn tracks(&self, bench: &Bench, proposal: &Proposal, start: &[f64]) -> Option<Vec<Track>> {
        let n = self.model.states.len();
        let p = &proposal.model;
        let same = p.states.len() >= n
            && p.outputs.len() == self.model.outputs.len()
            && p.states
                .iter()
                .zip(&self.model.states)
                .all(|(a, b)| a.name == b.name && a.initial == b.initial);
        let place = |k: &usize| p.parameters.iter().position(|q| q.name == proposal.added[*k].name);
        let wanted: Vec<usize> = proposal.amplitudes.iter().filter_map(place).collect();
        if !same || wanted.len() != proposal.amplitudes.len() {
            return None;
        }
        let (terms, sites) = self.terms(proposal)?;
        let quiet = proposal.with_amplitudes(start, &vec![0.0; wanted.len()]);
        let stand = self.stand.extended(p, &quiet);
        let mut all = Vec::new();
        for along in &self.runs {
            let initials = vec![f64::NAN; terms.states.len()];
            let place = (&stand.parameters[..], &initials[..]);
            let run = look(
                bench,
                (&terms, &along.recording, along.number),
                &along.time,
                self.tolerance,
                place,
                &wanted,
            )?;
            let moved: Vec<Vec<f64>> = (0..wanted.len())
                .map(|a| {
                    let column: Vec<(Site, &[f64])> =
                        sites.iter().zip(&run.sensitivities).map(|(s, c)| (*s, &c[a][..])).collect();
                    along.propagate(&self.model, &column)
                })
                .collect();
            all.extend(along.on_tracks(self.model.outputs.len(), &moved));
        }
        Some(all)
    }

    /// The model of a proposal's own rates and outputs with the states as inputs: those that it changes.
    fn terms(&self, proposal: &Proposal) -> Option<(Model, Vec<Site>)> {
        let (base, p) = (&self.model, &proposal.model);
        let everywhere = p.definitions != base.definitions;
        let mut terms = frozen(p, base.states.len());
        let mut sites = Vec::new();
        terms.outputs.clear();
        for (i, (new, old)) in p.states.iter().zip(&base.states).enumerate() {
            if everywhere || new.rate != old.rate {
                terms.outputs.push(output(p, sites.len(), &new.rate));
                sites.push(Site::Rate(i));
            }
        }
        for (i, (new, old)) in p.outputs.iter().zip(&base.outputs).enumerate() {
            if everywhere || new.equals != old.equals {
                terms.outputs.push(output(p, sites.len(), &new.equals));
                sites.push(Site::Output(i));
            }
        }
        (!sites.is_empty()).then_some((terms, sites))
    }

    fn along(&self, bench: &Bench, record: &Record) -> Option<Along> {
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
        let states =
            look(bench, (&probes, &recording, number), &time, self.tolerance, place, &[])?.predictions;
        for (s, values) in model.states.iter().zip(states) {
            recording.channels.push(Channel::new(s.name.clone(), s.unit.clone(), time.clone(), values));
        }
        let (nudged, wanted) = nudged(model);
        let mut parameters = self.stand.parameters.clone();
        parameters.resize(nudged.parameters.len(), 0.0);
        let slopes =
            look(bench, (&nudged, &recording, number), &time, self.tolerance, (&parameters, &[]), &wanted)?;
        let a = |i: usize| Mat::from_fn(n, n, |row, column| slopes.sensitivities[row][column][i]);
        let mut along = Along {
            recording,
            number,
            forward: Vec::with_capacity(n * n * time.len()),
            force: Vec::with_capacity(n * n * time.len()),
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
        along.forward.iter().chain(&along.shown).all(|x| x.is_finite()).then_some(along)
    }
}

/// Where a term enters.
#[derive(Clone, Copy)]
enum Site {
    Rate(usize),
    Output(usize),
}

impl Along {
    /// F = (1 − hA₊/2)⁻¹(1 + hA/2), G = (1 − hA₊/2)⁻¹ h/2
    fn fill(&mut self, a: &dyn Fn(usize) -> Mat<f64>) {
        let mut here = a(0);
        let mut step = 0.0;
        for i in 0..self.time.len().saturating_sub(1) {
            let next = a(i + 1);
            let h = self.time[i + 1] - self.time[i];
            let as_before = i > 0 && (h - step).abs() <= 1e-9 * h && next == here;
            if as_before && next == a(i - 1) {
                let n2 = next.nrows() * next.nrows();
                self.forward.extend_from_within(self.forward.len() - n2..);
                self.force.extend_from_within(self.force.len() - n2..);
            } else {
                let n = next.nrows();
                let unit = Mat::<f64>::identity(n, n);
                let lu = (&unit - &next * faer::Scale(0.5 * h)).partial_piv_lu();
                self.forward.extend(rows(&lu.solve(&unit + &here * faer::Scale(0.5 * h))));
                self.force.extend(rows(&lu.solve(unit * faer::Scale(0.5 * h))));
            }
            here = next;
            step = h;
        }
    }

    /// δy of every output at every time, output by output.
    fn propagate(&self, model: &Model, terms: &[(Site, &[f64])]) -> Vec<f64> {
        let (n, outputs, count) = (model.states.len(), model.outputs.len(), self.time.len());
        let rates: Vec<(usize, &[f64])> = terms
            .iter()
            .filter_map(|(s, g)| if let Site::Rate(j) = s { Some((*j, *g)) } else { None })
            .collect();
        let mut x = self.at_rest(model, &rates);
        let mut next = vec![0.0; n];
        let mut y = vec![0.0; outputs * count];
        for i in 0..count {
            for o in 0..outputs {
                let c = &self.shown[(i * outputs + o) * n..][..n];
                y[o * count + i] = c.iter().zip(&x).map(|(c, x)| c * x).sum();
            }
            if i + 1 == count || rates.is_empty() {
                continue;
            }
            let (f, g) = (&self.forward[i * n * n..][..n * n], &self.force[i * n * n..][..n * n]);
            for (row, out) in next.iter_mut().enumerate() {
                let carried: f64 = f[row * n..][..n].iter().zip(&x).map(|(f, x)| f * x).sum();
                *out = rates.iter().fold(carried, |sum, (j, r)| sum + g[row * n + j] * (r[i] + r[i + 1]));
            }
            std::mem::swap(&mut x, &mut next);
        }
        for (site, e) in terms {
            if let Site::Output(o) = site {
                y[o * count..][..count].iter_mut().zip(*e).for_each(|(y, e)| *y += e);
            }
        }
        y
    }

    /// δx at the start: A δx + g = 0 in the states that start steady, 0 in the others.
    fn at_rest(&self, model: &Model, rates: &[(usize, &[f64])]) -> Vec<f64> {
        let n = model.states.len();
        let mut x = vec![0.0; n];
        let steady: Vec<usize> = (0..n).filter(|j| model.states[*j].initial == Initial::Steady).collect();
        if !steady.is_empty() && !rates.is_empty() {
            let a = Mat::from_fn(steady.len(), steady.len(), |i, j| self.first[steady[i] * n + steady[j]]);
            let g = |i: usize| rates.iter().filter(|r| r.0 == steady[i]).map(|r| r.1[0]).sum::<f64>();
            let solved = a.partial_piv_lu().solve(Mat::from_fn(steady.len(), 1, |i, _| -g(i)));
            for (i, j) in steady.iter().enumerate() {
                x[*j] = if solved[(i, 0)].is_finite() { solved[(i, 0)] } else { 0.0 };
            }
        }
        x
    }

    /// The moves, amplitude by amplitude, read at the tracks' own times.
    fn on_tracks(&self, outputs: usize, moved: &[Vec<f64>]) -> Vec<Track> {
        let count = self.time.len();
        let one = |(output, stretches, time): &(usize, Vec<Range<usize>>, Vec<f64>)| Track {
            output: *output,
            stretches: stretches.clone(),
            time: Vec::new(),
            residual: Vec::new(),
            sensitivities: moved
                .iter()
                .map(|y| read(&self.time, &y[output * count..][..count], time))
                .collect(),
        };
        debug_assert!(moved.iter().all(|y| y.len() == outputs * count));
        self.tracks.iter().map(one).collect()
    }
}

/// A series on a mesh, straight between its points, at rising times.
fn read(mesh: &[f64], values: &[f64], time: &[f64]) -> Vec<f64> {
    let mut i = 0;
    let one = |t: &f64| {
        while i + 2 < mesh.len() && mesh[i + 1] <= *t {
            i += 1;
        }
        let share = (t - mesh[i]) / (mesh[i + 1] - mesh[i]);
        values[i] + share * (values[i + 1] - values[i])
    };
    time.iter().map(one).collect()
}

/// The samples of the finest output, and points between them where they are few or far apart.
fn mesh(record: &Record) -> Option<Vec<f64>> {
    let finest = record.tracks.iter().max_by_key(|t| t.time.len())?;
    let mut knots = vec![record.start];
    knots.extend(finest.time.iter().copied().filter(|t| *t > record.start));
    let last = record.tracks.iter().filter_map(|t| t.time.last()).fold(f64::NEG_INFINITY, |a, b| a.max(*b));
    if last > *knots.last()? {
        knots.push(last);
    }
    if knots.len() < 3 {
        return None;
    }
    let mut steps: Vec<f64> = knots.windows(2).map(|w| w[1] - w[0]).collect();
    let middle = steps.len() / 2;
    let usual = *steps.select_nth_unstable_by(middle, f64::total_cmp).1;
    let refined = (POINTS / knots.len()).clamp(1, FINEST);
    let mut mesh = vec![knots[0]];
    for w in knots.windows(2) {
        let times = (w[1] - w[0]) / usual;
        let pieces = refined * if times > USUAL { times.round() as usize } else { 1 };
        let h = (w[1] - w[0]) / pieces as f64;
        mesh.extend((1..pieces).map(|k| w[0] + k as f64 * h));
        mesh.push(w[1]);
    }
    (mesh.len() < 4 * POINTS.max(finest.time.len())).then_some(mesh)
}

/// Runs a model over a mesh; `None` where a point of it cannot be predicted.
fn look(
    bench: &Bench,
    (model, recording, number): (&Model, &Recording, usize),
    time: &Arc<[f64]>,
    tolerance: f64,
    (parameters, initials): (&[f64], &[f64]),
    wanted: &[usize],
) -> Option<Run> {
    let mut wider = recording.clone();
    for o in &model.outputs {
        wider.channels.push(Channel::new(
            o.name.clone(),
            o.unit.clone(),
            time.clone(),
            vec![0.0; time.len()],
        ));
    }
    let span = crate::record::Span::new(time[0], *time.last()?);
    let options = FitOptions { tolerance, ..bench.options(Effort::Near, 0) };
    let record = setup::record(model, &wider, number, &[span], &options).ok()?;
    let wanted: Vec<Unknown> = wanted.iter().map(|k| Unknown::Parameter(*k)).collect();
    let run = record.run(parameters, initials, &wanted).ok()?;
    let whole = run.predictions.len() == model.outputs.len()
        && run.predictions.iter().all(|p| p.len() == time.len())
        && run.sensitivities.iter().flatten().flatten().all(|x| x.is_finite());
    whole.then_some(run)
}

/// An output of a probing model.
fn output(model: &Model, number: usize, equals: &Expr) -> Output {
    Output {
        name: format!("seen__{number}"),
        unit: edit::unit_of(equals, &|n| edit::unit_of_name(model, n)),
        equals: equals.clone(),
        meaning: None,
    }
}

/// A model with its first states as inputs.
fn frozen(model: &Model, states: usize) -> Model {
    let mut frozen = model.clone();
    let own = frozen.states.drain(..states);
    frozen.inputs.extend(own.map(|s| Input { name: s.name, unit: s.unit, meaning: None }));
    frozen
}

/// The rates and outputs with the states as inputs, each nudged by a parameter; with those parameters.
fn nudged(model: &Model) -> (Model, Vec<usize>) {
    let mut nudged = frozen(model, model.states.len());
    let rates = model.states.iter().map(|s| &s.rate);
    let seen = rates.chain(model.outputs.iter().map(|o| &o.equals));
    nudged.outputs = seen.enumerate().map(|(i, e)| output(model, i, e)).collect();
    let first = nudged.parameters.len();
    for (i, s) in model.states.iter().enumerate() {
        let name = format!("nudge__{i}");
        let plus = Expr::Binary(BinaryOp::Add, Box::new(Expr::name(&s.name)), Box::new(Expr::name(&name)));
        edit::for_each(&mut nudged, |_, e| *e = e.substitute(&s.name, &plus));
        nudged.parameters.push(Parameter {
            name,
            value: 0.0,
            unit: s.unit.of_differences(),
            fit: false,
            min: None,
            max: None,
            meaning: None,
        });
    }
    (nudged, (first..first + model.states.len()).collect())
}

/// Whether the past of a state, or of time itself, is remembered anywhere in a model.
fn remembers_states(model: &Model) -> bool {
    let touches = |e: &Expr| model.states.iter().any(|s| edit::reaches(model, e, &s.name));
    let memory = |e: &Expr| matches!(e, Expr::Call(f, args) if f.has_memory() && args.iter().any(touches));
    let definitions = model.definitions.iter().map(|d| &d.equals);
    let mut all = definitions
        .chain(model.states.iter().map(|s| &s.rate))
        .chain(model.outputs.iter().map(|o| &o.equals));
    all.any(|e| edit::find(e, &memory).is_some())
}

fn rows(m: &Mat<f64>) -> Vec<f64> {
    (0..m.nrows()).flat_map(|i| (0..m.ncols()).map(move |j| m[(i, j)])).collect()
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

    /// Every proposal at rest: the linearised response against the simulation with dual numbers.
    #[test]
    fn agrees_with_simulated_sensitivities() {
        let model = Model::parse(MODEL).unwrap();
        let bench = Bench::new(&model, vec![recording()], false, 1);
        let records = bench.ready(&model, 1e-5).unwrap();
        let stand = Stand {
            parameters: model.parameters.iter().map(|p| p.value).collect(),
            initials: vec![records[0].initials.clone()],
        };
        let response = Response::of(&bench, &model, &stand, 1e-5, &records).unwrap();
        let scene = bench.scene(&model, &stand).unwrap();
        let proposals = catalogue::ALL.iter().flat_map(|m| (m.propose)(&scene));
        let mut compared = std::collections::BTreeSet::new();
        for p in proposals.filter(|p| !p.amplitudes.is_empty()) {
            let start = p.starts.last().unwrap();
            let Some(swift) = response.tracks(&bench, &p, start) else { continue };
            let records = bench.ready(&p.at_rest(), 1e-5).unwrap();
            let place =
                |k: &usize| p.model.parameters.iter().position(|q| q.name == p.added[*k].name).unwrap();
            let wanted: Vec<usize> = p.amplitudes.iter().map(place).collect();
            let quiet = p.with_amplitudes(start, &vec![0.0; wanted.len()]);
            let slow = bench::run(&records, &stand.extended(&p.model, &quiet), &wanted).unwrap();
            for (a, b) in swift.iter().zip(&slow) {
                for (x, y) in a.sensitivities.iter().zip(&b.sensitivities) {
                    let square = |v: &mut dyn Iterator<Item = f64>| v.map(|d| d * d).sum::<f64>();
                    let off = square(&mut x.iter().zip(y).map(|(x, y)| x - y));
                    let size = square(&mut y.iter().copied());
                    assert!(off <= 4e-4 * size, "{} at {}: {off} of {size}", p.code, p.site.name);
                    compared.insert(p.code);
                }
            }
        }
        assert!(compared.len() > 12, "{compared:?}");
    }
}
