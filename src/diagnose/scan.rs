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
use super::view::{View, own_tracks};
use crate::estimate::fit::harness::Record;
use crate::estimate::{Fit, Triangle};
use rayon::prelude::*;

/// Lowest places that are fitted from.
const FITTED: usize = 3;
/// Steps of the fits that are compared.
const STEPS: usize = 8;
/// Share of the sum of squares that a place must promise to save.
const SAVED: f64 = 0.01;

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
    let Some(rig) = Rig::new(bench, view, of, fit, scale) else { return Vec::new() };
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
    scale: &'a Scale,
    /// The sum of squares at the fit.
    now: f64,
}

impl<'a> Rig<'a> {
    fn new(
        bench: &Bench,
        view: &View,
        (p, shape): (&Proposal, usize),
        fit: &Fit,
        scale: &'a Scale,
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
            let mut keep = fit.unknowns.iter().map(|n| !moves(n));
            t.sensitivities.retain(|_| keep.next().unwrap_or(true));
        }
        let name = &p.added[shape].name;
        let shape = fit.model.parameters.iter().position(|m| m.name == *name)?;
        let (amplitudes, now) = (p.amplitude_numbers(), 0.0);
        let mut rig = Self { records, own, stand, shape, amplitudes, scale, now };
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
            let root = self.scale.weights[t.output].sqrt();
            let weighed = |v: &Vec<f64>| v.iter().map(|x| root * x).collect::<Vec<f64>>();
            let columns: Vec<Vec<f64>> =
                t.sensitivities.iter().chain(&own.sensitivities).map(weighed).collect();
            let minus: Vec<f64> = t.residual.iter().map(|e| -root * e).collect();
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
