//! The shape of a fitted mechanism, looked for again over its whole range.
//!
//! # Purpose
//! Where a mechanism begins at a moment or at a level, the sum of squares has a minimum beside nearly every start:
//! moving the moment of a jump changes nothing where what jumps is multiplied by a speed that passes through zero. A
//! few starts before the fit find one of these, not the lowest.
//!
//! # Method
//! From the fit, one such parameter is set to each place of a fine grid, the others stay; a run with sensitivities to
//! the amplitudes, beside those of all other unknowns at the fit, gives the least sum of squares that they promise
//! there. The lowest places are fitted from anew, and the best of all fits is kept.
//!
//! # References
//! G. H. Golub, V. Pereyra, SIAM J. Numer. Anal. 10 (1973) 413 (variable projection); J. Bai, Econometrica 65 (1997)
//! 315 (moments of change).

use super::bench::{self, Bench, Stand, Track};
use super::catalogue::Proposal;
use super::measure::Scale;
use super::propose::places;
use super::race::{to_the_end, walk};
use super::search::Taken;
use super::view::{View, own_tracks};
use crate::estimate::fit::harness::Record;
use crate::estimate::noise::NoiseModel;
use crate::estimate::{Fit, Triangle};
use rayon::prelude::*;
use std::ops::Range;

/// Lowest places that are fitted from.
const FITTED: usize = 3;
/// Steps of the fits that are compared.
const STEPS: usize = 8;
/// Share of the sum of squares that a place must promise to save.
const SAVED: f64 = 0.01;

/// Half the likelihood ratio that a place within a 95 % interval may lose: χ²₁ = 3.84.
const LOST: f64 = 1.92;
/// Places over the neighbours of an interval's ends.
const FINER: usize = 60;

/// In what a place is measured.
enum Metric<'a> {
    /// The free run, every output with its weight.
    Free(&'a Scale),
    /// The innovations of each output.
    Whitened(&'a [NoiseModel]),
}

impl Metric<'_> {
    /// Rows of an output over its stretches.
    fn of(&self, output: usize, stretches: &[Range<usize>], values: &[f64], sign: f64) -> Vec<f64> {
        match self {
            Self::Free(scale) => {
                let root = sign * scale.weights[output].sqrt();
                values.iter().map(|x| root * x).collect()
            }
            Self::Whitened(noise) => {
                let each = stretches.iter().flat_map(|r| noise[output].whiten(&values[r.clone()]));
                each.map(|x| sign * x).collect()
            }
        }
    }
}

/// Intervals of the moments and levels that were looked for over a whole range, in place of those of the curvature:
/// all places that lose less than a likelihood ratio allows, others free to follow. The likelihood has many maxima
/// there, and its curvature at one says nothing of the next.
pub fn intervals(bench: &Bench, taken: &[Taken], fit: &mut Fit) {
    let shapes = |p: &Proposal| -> Vec<usize> {
        (0..p.added.len()).filter(|k| !p.amplitudes.contains(k) && !places(p, *k).is_empty()).collect()
    };
    let wanted: Vec<(&Proposal, usize)> =
        taken.iter().flat_map(|t| shapes(&t.proposal).into_iter().map(|k| (&t.proposal, k))).collect();
    if wanted.is_empty() {
        return;
    }
    let Ok(view) = View::of(bench, fit) else { return };
    for (p, k) in wanted {
        let name = &p.added[k].name;
        let found = interval(bench, &view, (p, k), fit);
        if let (Some(found), Some(own)) = (found, fit.parameters.iter_mut().find(|e| e.name == *name)) {
            (own.low, own.high) = found;
        }
    }
}

/// The places of one parameter that the likelihood allows. The last place looked at on a side is no end where it is
/// allowed: the parameter's limit stands for it, where it has one.
fn interval(bench: &Bench, view: &View, of: (&Proposal, usize), fit: &Fit) -> Option<(f64, f64)> {
    let rig = Rig::new(bench, view, of, fit, Metric::Whitened(&fit.noise))?;
    let coarse = places(of.0, of.1);
    let (begin, end) = (*coarse.first()?, *coarse.last()?);
    let step = coarse.get(1)? - begin;
    let own = rig.stand.parameters[rig.shape];
    let width =
        fit.parameters.iter().find(|p| p.name == of.0.added[of.1].name).map_or(step, |p| p.high - p.low);
    let limits = of.0.limits[of.1];
    let width = if width.is_finite() { width.min(limits.1 - limits.0).max(0.01 * step) } else { step };
    // a fit beyond all starts lies beyond the coarse places, and nothing would be looked at between
    let between = Some((own - begin).max(end - own)).filter(|_| own < begin || own > end);
    // a valley beside its own may be as deep and as narrow
    let near =
        |width: f64| (0..FINER).map(move |i| own + width * ((i as f64 + 0.5) / FINER as f64 - 0.5) * 2.0);
    let within = |at: &f64| (limits.0..=limits.1).contains(at);
    let nearer = [width, step].into_iter().chain(between).flat_map(near);
    let all: Vec<f64> = coarse.iter().copied().chain(nearer).filter(within).chain([own]).collect();
    let promised: Vec<(f64, f64)> = all.par_iter().map(|at| (*at, rig.promise(*at).0)).collect();
    let least = promised.iter().map(|p| p.1).fold(f64::INFINITY, f64::min);
    let allowed = promised.iter().filter(|p| 0.5 * (p.1 - least) <= LOST).map(|p| p.0);
    let ends = |(low, high): (f64, f64), at: f64| (low.min(at), high.max(at));
    let (low, high) = allowed.fold((own, own), ends);
    let (first, last) = all.iter().copied().fold((own, own), ends);
    let open = |limit: f64| if limit.is_finite() { limit } else { f64::NAN };
    Some((if low > first { low } else { open(limits.0) }, if high < last { high } else { open(limits.1) }))
}

/// A better fit of a proposal than the one given, where its shape has one elsewhere.
pub fn again(bench: &Bench, view: &View, p: &Proposal, fit: &Fit, scale: &Scale) -> Option<Fit> {
    let shapes: Vec<usize> = (0..p.added.len()).filter(|k| !p.amplitudes.contains(k)).collect();
    let starts: Vec<Fit> = shapes.into_iter().flat_map(|k| lowest(bench, view, (p, k), fit, scale)).collect();
    let best = starts.into_iter().min_by(|a, b| scale.squares(a).total_cmp(&scale.squares(b)))?;
    let better = |f: &Fit| scale.squares(f) < (1.0 - SAVED) * scale.squares(fit);
    let best = Some(best).filter(better)?;
    to_the_end(bench, p, &best, &bench.part()).filter(better)
}

/// Short fits from the lowest places of one parameter.
fn lowest(bench: &Bench, view: &View, of: (&Proposal, usize), fit: &Fit, scale: &Scale) -> Vec<Fit> {
    let places = places(of.0, of.1);
    if places.is_empty() {
        return Vec::new();
    }
    let Some(rig) = Rig::new(bench, view, of, fit, Metric::Free(scale)) else { return Vec::new() };
    let promised: Vec<(f64, Stand)> = places.par_iter().map(|at| rig.promise(*at)).collect();
    let least = |i: usize| promised.get(i).map_or(f64::INFINITY, |p| p.0);
    let valley = |i: &usize| least(*i) < rig.now && least(*i) <= least(i.wrapping_sub(1)).min(least(i + 1));
    let mut valleys: Vec<usize> = (0..places.len()).filter(valley).collect();
    valleys.sort_by(|a, b| least(*a).total_cmp(&least(*b)));
    let short = |i: &usize| {
        let stand = &promised[*i].1;
        walk(bench, &stand.placed(&fit.model), stand.initials.clone(), STEPS, view)
    };
    valleys.par_iter().take(FITTED).filter_map(short).collect()
}

/// What is the same at every place.
struct Rig<'a> {
    /// The fitted model, ready to run.
    records: Vec<Record>,
    /// The fit's own tracks, with sensitivities to the unknowns that stay.
    own: Vec<Track>,
    stand: Stand,
    /// Numbers of the parameter and of the amplitudes in the model.
    shape: usize,
    amplitudes: Vec<usize>,
    metric: Metric<'a>,
    /// The sum of squares at the fit.
    now: f64,
}

impl<'a> Rig<'a> {
    fn new(
        bench: &Bench,
        view: &View,
        (p, shape): (&Proposal, usize),
        fit: &Fit,
        metric: Metric<'a>,
    ) -> Option<Self> {
        let records = view.ready(bench, &fit.model).ok()?;
        let stand = Stand::of(fit);
        let plain = bench::run(&records, &stand, &[]).ok()?;
        let mut own = own_tracks(fit, &plain).ok()?;
        let moves = |name: &String| {
            p.added
                .iter()
                .enumerate()
                .any(|(k, a)| a.name == *name && (k == shape || p.amplitudes.contains(&k)))
        };
        for t in &mut own {
            let mut keep = fit.unknowns.iter().filter(|n| !fit.is_at_bound(n)).map(|n| !moves(n));
            t.sensitivities.retain(|_| keep.next().unwrap_or(true));
        }
        let name = &p.added[shape].name;
        let shape = fit.model.parameters.iter().position(|m| m.name == *name)?;
        let (amplitudes, now) = (p.amplitude_numbers_in(&fit.model), 0.0);
        let mut rig = Self { records, own, stand, shape, amplitudes, metric, now };
        rig.now = (1.0 - SAVED) * rig.promise(rig.stand.parameters[shape]).0;
        Some(rig)
    }

    /// The least sum of squares that a place promises, and the amplitudes for it.
    fn promise(&self, at: f64) -> (f64, Stand) {
        let mut stand = self.stand.clone();
        stand.parameters[self.shape] = at;
        let Ok(tracks) = bench::run(&self.records, &stand, &self.amplitudes) else {
            return (f64::INFINITY, stand);
        };
        let amplitudes = self.amplitudes.len();
        let others = self.own.first().map_or(0, |t| t.sensitivities.len());
        let mut triangle = Triangle::new(amplitudes + others);
        for (t, own) in tracks.iter().zip(&self.own) {
            let rows = |v: &[f64], sign: f64| self.metric.of(t.output, &t.stretches, v, sign);
            let columns: Vec<Vec<f64>> =
                t.sensitivities.iter().chain(&own.sensitivities).map(|v| rows(v, 1.0)).collect();
            let minus = rows(&t.residual, -1.0);
            triangle.push(&columns.iter().map(Vec::as_slice).collect::<Vec<_>>(), &minus);
        }
        let damping: Vec<f64> =
            triangle.column_norms().iter().map(|n| 1e-6 * n + f64::MIN_POSITIVE).collect();
        let step = triangle.solve(&damping);
        let least = triangle.predicted(&step);
        for (k, by) in self.amplitudes.iter().zip(&step) {
            stand.parameters[*k] += by;
        }
        (if least.is_finite() { least } else { f64::INFINITY }, stand)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::catalogue;
    use crate::estimate::fit::Effort;
    use crate::model::Model;
    use crate::record::{Channel, Recording};
    use crate::units::Unit;

    /// An axis with a further unknown, as the finding had that was taken first.
    const MODEL: &str = r#"
        name = "axis"
        [inputs]
        force = { unit = "N" }
        [parameters]
        M = { value = 4, unit = "kg", fit = true, min = 1, max = 10 }
        Fv = { value = 6, unit = "N*s/m", fit = true, min = 1, max = 100 }
        gone = { value = 0, unit = "N" }
        [states]
        q = { rate = "v", unit = "m", initial = 0 }
        v = { rate = "(force - Fv*v)/M", unit = "m/s", initial = 0 }
        [outputs]
        position = { equals = "q", unit = "m" }
    "#;

    fn recording() -> Recording {
        let time: Vec<f64> = (0..600).map(|i| 0.02 * f64::from(i)).collect();
        let made = |name: &str, unit: &str, f: &dyn Fn(f64) -> f64| {
            let values = time.iter().map(|t| f(*t)).collect();
            Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values)
        };
        let channels = vec![
            made("force", "N", &|t| 5.0 * (2.0 * t).sin()),
            made("position", "m", &|t| 0.2 * (2.0 * t + 3.3).sin() + 0.01 * (31.0 * t).cos()),
        ];
        Recording::from_channels("made", channels).unwrap()
    }

    /// What was taken first has gone from the model that a later one stands in.
    #[test]
    fn a_finding_that_went_moves_no_other() {
        let model = Model::parse(MODEL).unwrap();
        let bench = Bench::new(&model, vec![recording()], false, 1);
        let stand = Stand { parameters: vec![4.0, 6.0, 0.0], initials: vec![vec![0.0, 0.0]] };
        let scene = bench.scene(&model, &stand).unwrap();
        let mut all = catalogue::ALL.iter().flat_map(|m| (m.propose)(&scene));
        let stop = all.find(|p| p.code == "end-stop").unwrap();
        let mut fitted = stand.extended(&stop.model, &stop.starts[0]).placed(&stop.model);
        fitted.parameters.retain(|p| p.name != "gone");
        let fit = crate::estimate::fit(&fitted, &bench.recordings, &bench.options(Effort::Near, 3)).unwrap();
        let view = View::of(&bench, &fit).unwrap();
        let shape = (0..stop.added.len()).find(|k| !stop.amplitudes.contains(k)).unwrap();
        let rig = Rig::new(&bench, &view, (&stop, shape), &fit, Metric::Whitened(&fit.noise)).unwrap();
        let name = |i: &usize| fit.model.parameters[*i].name.as_str();
        let sizes: Vec<&str> = stop.amplitudes.iter().map(|k| stop.added[*k].name.as_str()).collect();
        assert_eq!(rig.amplitudes.iter().map(name).collect::<Vec<_>>(), sizes);
        assert_eq!(name(&rig.shape), stop.added[shape].name);
    }
}
