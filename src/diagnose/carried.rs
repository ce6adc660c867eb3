//! What is held out, less what the uncertainty of a fit alone does to it.
//!
//! # Purpose
//! A fit knows its unknowns no better than its covariance says, and what it does not know runs on into what is
//! held out: a level there that drifts away may be no more than a parameter that is a little off. Before such a
//! residual is asked whether it is noise, the unknowns may follow it as far as the fit leaves them free.
//!
//! # Method
//! With the covariance C = L Lᵀ of the unknowns and the whitened held-out residual e and sensitivities S, the
//! unknowns move by the δ that minimises ‖e − S δ‖² + ‖L⁻¹ δ‖²: the estimate from both parts, the fitted one
//! standing in by its covariance.
//!
//! Where that is not near enough, as where a parameter lies at its bound and moves nothing to first order, the same
//! model is fitted to both parts: what is held out belongs to it if the fitted part loses no more likelihood than as
//! many unknowns lose by chance. Names do not carry over where the fitted part loses more than that, and more than the
//! least that a name must explain: n samples lose n ln((1 − f)⁻²), with the floor f of the error. Where the innovations of
//! what was held out are louder than those of the fit, by the differences of neighbours, the loss counts in their squares:
//! unknowns follow louder noise. A fitted part that loses more all the same may do so for a sensor that wanders where it was
//! held out: then what was held out is asked alone (`later`).
//!
//! # References
//! A. Gelman et al., Bayesian Data Analysis, 3rd ed., 2013, sec. 14.8.
//!
//! # Numerical aspects
//! Unknowns are counted in their own standard deviations.

use super::bench::Bench;
use super::choose::{SURE, floor, is_drift};
use super::later::agrees;
use super::moments;
use super::prove::Held;
use super::screen::log_chance;
use super::search::Found;
use crate::estimate::Fit;
use crate::estimate::fit::{self, Effort, FitOptions, HeldOut, Series, carried_on, setup};
use crate::estimate::triangle::Triangle;
use crate::model::Model;
use crate::record::Recording;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::{Mat, Par, Side};

/// Residuals over what is held out, by output, after the unknowns have followed them as far as the fit leaves
/// them free; None where the model cannot be run there.
pub fn settled(bench: &Bench, fit: &Fit, separate: &[Recording]) -> Option<Vec<Held>> {
    let fit = &moments::placed(bench, fit, separate);
    let all = carried_on(fit, &bench.recordings, separate, &bench.options(Effort::Near, 40)).ok()?;
    let moved = moved(fit, &all).unwrap_or_default();

    let mut held = vec![Held::default(); fit.model.outputs.len()];
    for (h, series) in all.iter().flat_map(|h| h.series.iter().map(move |s| (h, s))) {
        let rest = rest(series, &moved);
        for r in &series.stretches {
            held[h.output].residual.push(rest[r.clone()].to_vec());
            held[h.output].time.push(series.time[r.clone()].to_vec());
        }
    }
    Some(held)
}

/// Residuals over what is held out of the same model fitted to both parts, by output; None where the fitted part
/// does not bear that, or where whole recordings are held out.
pub fn together(bench: &Bench, model: &Model, fit: &Fit) -> Option<Vec<Held>> {
    if bench.separate {
        return None;
    }
    let joint = both(bench, model, &[]).full_fit(model).ok()?;
    let joint = Joint::of(fit, &joint)?;
    joint.is_borne(fit).then_some(joint.held)
}

/// What to know where names do not carry over.
pub const PARTED: &str = "the fitted part and what was held out do not agree on what was found: fitted to both at once, the model with it leaves more of the fitted part than chance would, as where a law only resembles what is missing, or something else is missing too";

/// Whether a fitted model with names can be fitted to both parts, so that the earlier loses by that no more than chance
/// or the floor; also where that cannot be told, as of how a drift goes on.
pub fn carries(bench: &Bench, found: &Found, separate: &[Recording]) -> bool {
    let fit = &found.last;
    let drifts = found.taken.iter().any(|t| is_drift(&t.proposal));
    if bench.is_trials() || drifts || !separate.is_empty() && moments::has_any(bench, &fit.model) {
        return true;
    }
    let both = both(bench, &fit.model, separate);
    let options = FitOptions { initials: fit.starts(), ..both.options(Effort::Near, 40) };
    let Ok(joint) = fit::fit(&fit.model, &both.recordings, &options) else { return true };
    if joint.ended_early.is_some() {
        return true;
    }
    let is_small = |joint: &Joint| joint.lost <= floor(0.0) * joint.samples as f64;
    let joint = Joint::of(fit, &joint).map(|joint| joint.beside_noise(fit));
    joint.is_none_or(|joint| is_small(&joint) || joint.is_borne(fit) || agrees(bench, found, separate))
}

/// The bench with what is held out fitted as well.
fn both(bench: &Bench, model: &Model, separate: &[Recording]) -> Bench {
    let options = bench.options(Effort::Near, 40);
    let whole = |r: &Recording| {
        let spans = setup::spans(model, r, &options);
        let mut all = [spans.fit, spans.holdout].concat();
        all.sort_by(|a, b| a.from.total_cmp(&b.from));
        r.clone().with_spans(all, Vec::new())
    };
    Bench { recordings: bench.recordings.iter().chain(separate).map(whole).collect(), ..bench.clone() }
}

/// A model fitted to both parts, beside its fit to the first.
struct Joint {
    /// Residuals over what is held out, by output.
    held: Vec<Held>,
    /// By how much the whitened squares of the fitted part rise.
    lost: f64,
    /// Samples of the fitted part.
    samples: usize,
}

impl Joint {
    /// None where both do not compare the same samples.
    fn of(fit: &Fit, joint: &Fit) -> Option<Self> {
        let mut held = vec![Held::default(); fit.model.outputs.len()];
        let (mut lost, mut of_joint, mut samples) = (0.0, 0, 0);
        for (own, joint) in fit.records.iter().zip(&joint.records) {
            for (own, joint) in own.series.iter().zip(&joint.series) {
                let noise = &fit.noise[own.output];
                let square = |e: &[f64]| noise.whiten(e).iter().map(|x| x * x).sum::<f64>();
                let ends = own.time.last()?;
                for r in &joint.stretches {
                    let (times, residual) = (&joint.time[r.clone()], &joint.residual[r.clone()]);
                    let fitted = times.partition_point(|t| t <= ends);
                    lost += square(&residual[..fitted]);
                    of_joint += fitted;
                    if fitted < times.len() {
                        held[own.output].residual.push(residual[fitted..].to_vec());
                        held[own.output].time.push(times[fitted..].to_vec());
                    }
                }
                lost -= own.residual_stretches().into_iter().map(square).sum::<f64>();
                samples += own.residual.len();
            }
        }
        for series in joint.records.iter().skip(fit.records.len()).flat_map(|r| &r.series) {
            held[series.output].residual.extend(series.residual_stretches().into_iter().map(<[f64]>::to_vec));
        }
        (of_joint == samples).then_some(Self { held, lost, samples })
    }

    /// The same where what was held out is noisier: unknowns follow it by as much more.
    fn beside_noise(self, fit: &Fit) -> Self {
        let whitened = self.held.iter().zip(&fit.noise).map(|(h, n)| h.whitened(n));
        let louder = whitened.filter_map(|h| h.loudness()).fold(1.0, f64::max);
        Self { lost: self.lost / louder, ..self }
    }

    /// Whether the fitted part loses no more than as many unknowns lose by chance.
    fn is_borne(&self, fit: &Fit) -> bool {
        self.lost <= 0.0 || log_chance(self.lost, fit.values.len()) > SURE.ln()
    }
}

/// e − S δ.
fn rest(series: &Series, moved: &[f64]) -> Vec<f64> {
    let mut rest = series.residual.clone();
    for (column, by) in series.sensitivities.iter().zip(moved).filter(|(_, by)| **by != 0.0) {
        rest.iter_mut().zip(column).for_each(|(e, s)| *e -= by * s);
    }
    rest
}

/// δ, the step of all unknowns; one whose covariance is unknown, as that of one at its bound, is free.
fn moved(fit: &Fit, all: &[HeldOut]) -> Option<Vec<f64>> {
    let (known, free): (Vec<usize>, Vec<usize>) =
        (0..fit.values.len()).partition(|j| fit.covariance[(*j, *j)] > 0.0);
    let deviation = |j: &usize| fit.covariance[(*j, *j)].sqrt();
    let even = |i: usize, j: usize| fit.covariance[(i, j)] / (deviation(&i) * deviation(&j));
    let correlation = Mat::from_fn(known.len(), known.len(), |i, j| even(known[i], known[j]));
    let mut before = Mat::<f64>::identity(known.len(), known.len());
    solve_lower_triangular_in_place(correlation.llt(Side::Lower).ok()?.L(), before.as_mut(), Par::Seq);
    let order: Vec<(usize, f64)> =
        known.iter().map(|j| (*j, deviation(j))).chain(free.iter().map(|j| (*j, 1.0))).collect();
    let mut triangle = Triangle::new(order.len());
    let none = vec![0.0; known.len()];
    let columns: Vec<&[f64]> =
        (0..order.len()).map(|j| if j < known.len() { before.col_as_slice(j) } else { &none[..] }).collect();
    triangle.push(&columns, &none);
    for series in all.iter().flat_map(|h| &h.series).filter(|s| !s.sensitivities.is_empty()) {
        for r in &series.stretches {
            let of = |(j, by): &(usize, f64)| -> Vec<f64> {
                series.sensitivities[*j][r.clone()].iter().map(|s| -by * s).collect()
            };
            let columns: Vec<Vec<f64>> = order.iter().map(of).collect();
            let views: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
            let rows = fit.noise[series.output].whiten_rows(&series.residual[r.clone()], &views);
            triangle.push(&rows.columns.iter().map(Vec::as_slice).collect::<Vec<_>>(), &rows.residual);
        }
    }
    let damping: Vec<f64> = triangle.column_norms().iter().map(|n| 1e-6 * n + f64::MIN_POSITIVE).collect();
    let mut moved = vec![0.0; fit.values.len()];
    for ((j, by), step) in order.iter().zip(triangle.solve(&damping)) {
        moved[*j] = by * step;
    }
    Some(moved)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Channel;
    use crate::units::Unit;

    /// Whether a lag carries over whose rate is 2/s till some sample and another from there on, with noise of one size
    /// till there and another from there on, where the sensor begins to wander too.
    fn lag_carries(later: f64, noise: (f64, f64), wander: f64) -> bool {
        let text = "name = \"lag\"\n[inputs]\nu = { unit = \"1\" }\n[parameters]\n\
                    k = { value = 2.5, unit = \"1/s\", fit = true, min = 0.1, max = 10 }\n[states]\n\
                    x = { rate = \"k*(u - x)\", unit = \"1\", initial = 0 }\n[outputs]\n\
                    y = { equals = \"x\", unit = \"1\" }\n";
        let model = Model::parse(text).unwrap();
        let count = 600;
        let time: Vec<f64> = (0..count).map(|i| 0.05 * f64::from(i)).collect();
        let u: Vec<f64> = time.iter().map(|t| f64::from(u8::from((1.1 * t).sin() > 0.2))).collect();
        let mut state = 9_u64;
        let mut drawn = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let (mut x, mut y, mut off) = (0.0, Vec::new(), 0.0);
        for i in 0..count as usize {
            let (k, size) = if i < 360 { (2.0, noise.0) } else { (later, noise.1) };
            if i >= 360 {
                off = 0.98 * off + wander * 0.2 * 12f64.sqrt() * drawn();
            }
            y.push(x + size * 12f64.sqrt() * drawn() + off);
            // exact between rows where the input is held, which it nearly is
            let next = u.get(i + 1).unwrap_or(&u[i]);
            let mean = 0.5 * (u[i] + next);
            x = mean + (x - mean) * f64::exp(-0.05 * k);
        }
        let one = |name: &str, values: Vec<f64>| Channel::new(name, Unit::one(), time.clone(), values);
        let recording = Recording::from_channels("lag", vec![one("u", u), one("y", y)]).unwrap();
        let bench = Bench::new(&model, vec![recording], false, 1);
        let found = Found::nothing(bench.full_fit(&model).unwrap(), false);
        carries(&bench, &found, &[])
    }

    #[test]
    fn another_rate_does_not_carry_over_and_louder_noise_does() {
        assert!(lag_carries(2.0, (0.01, 0.01), 0.0));
        assert!(!lag_carries(3.0, (0.01, 0.01), 0.0));
        assert!(lag_carries(2.0, (0.01, 0.3), 0.0));
    }

    #[test]
    fn what_wanders_only_where_it_is_held_out_hides_no_name_and_no_other_rate() {
        assert!(lag_carries(2.0, (0.01, 0.01), 0.15));
        assert!(!lag_carries(3.0, (0.01, 0.01), 0.15));
    }
}
