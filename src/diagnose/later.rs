//! What was held out, fitted alone, beside the fit.
//!
//! # Purpose
//! A sensor that wanders where it is held out, and nowhere else, bends a model that is fitted to both parts at once, and the
//! fitted part loses by that as it does by a wrong law. A right name has the same size in either part alone, and nothing that
//! goes with a signal is left beside it.
//!
//! # Method
//! The model with its names is fitted to what was held out. With the parameters θ₁, θ₂ that names brought in, of both fits, and
//! their covariances, each for noise as coloured as its own residual, (θ₁ − θ₂)ᵀ (C₁ + C₂)⁻¹ (θ₁ − θ₂) is χ² of as many
//! degrees of freedom; where names brought none, all parameters are compared.
//!
//! # References
//! A. Wald, Trans. Amer. Math. Soc. 54 (1943) 426 (estimates beside their covariance).

use super::bench::Bench;
use super::choose::SURE;
use super::rest;
use super::screen::log_chance;
use super::search::Found;
use super::view::View;
use crate::Result;
use crate::estimate::Fit;
use crate::estimate::fit::{Effort, setup};
use crate::record::Recording;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::{Mat, Par, Side};

/// Whether names have the same size where what was held out is fitted alone, and nothing is left of it that goes with a
/// signal.
pub fn agrees(bench: &Bench, found: &Found, separate: &[Recording]) -> bool {
    let options = bench.options(Effort::Near, 40);
    let model = &found.last.model;
    let later = |r: &Recording| {
        let spans = setup::spans(model, r, &options).holdout;
        (!spans.is_empty()).then(|| r.clone().with_spans(spans, Vec::new()))
    };
    let recordings = match separate {
        [] => bench.recordings.iter().filter_map(later).collect(),
        _ => separate.to_vec(),
    };
    let bench = Bench { recordings, separate: false, ..bench.clone() };
    compared(&bench, found).unwrap_or(false)
}

fn compared(bench: &Bench, found: &Found) -> Result<bool> {
    let alone = bench.full_fit(&found.last.model)?;
    let Some((apart, unknowns)) = apart(found, &alone) else { return Ok(false) };
    if log_chance(apart, unknowns) <= SURE.ln() {
        return Ok(false);
    }
    let view = View::of(bench, &alone)?;
    let rest = rest::look(bench, &bench.scene(&alone.model, &view.stand)?, &view);
    rest.trace("held out");
    Ok(!rest.is_left() || rest.p_value > SURE)
}

/// (θ₁ − θ₂)ᵀ (C₁ + C₂)⁻¹ (θ₁ − θ₂), and how many parameters it counts; None where there are none that both fits know.
fn apart(found: &Found, alone: &Fit) -> Option<(f64, usize)> {
    let fit = &found.last;
    let brought: Vec<&String> =
        found.taken.iter().flat_map(|t| t.proposal.added.iter().map(|a| &a.name)).collect();
    let known = |fit: &Fit, name: &String| {
        let at = fit.unknowns.iter().position(|u| u == name)?;
        (fit.covariance[(at, at)] > 0.0).then_some(at)
    };
    let asked =
        fit.model.parameters.iter().map(|p| &p.name).filter(|n| brought.is_empty() || brought.contains(n));
    let both: Vec<(usize, usize)> = asked.filter_map(|n| Some((known(fit, n)?, known(alone, n)?))).collect();
    let sum = |i: usize, j: usize| {
        fit.covariance[(both[i].0, both[j].0)] + alone.covariance[(both[i].1, both[j].1)]
    };
    let deviation = |i: usize| sum(i, i).sqrt();
    let correlation = Mat::from_fn(both.len(), both.len(), |i, j| sum(i, j) / (deviation(i) * deviation(j)));
    let step = |i: usize| (fit.values[both[i].0] - alone.values[both[i].1]) / deviation(i);
    let mut steps = Mat::from_fn(both.len(), 1, |i, _| step(i));
    solve_lower_triangular_in_place(correlation.llt(Side::Lower).ok()?.L(), steps.as_mut(), Par::Seq);
    let squares = steps.col_as_slice(0).iter().map(|z| z * z).sum();
    (!both.is_empty()).then_some((squares, both.len()))
}
