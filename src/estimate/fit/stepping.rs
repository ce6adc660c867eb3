//! Parameters of a Functional Mock-up Unit that steps itself: fitted by whole runs, before anything else is.
//!
//! # Method
//! Least squares on the fitted spans, each output by the deviation of its measured signal; slopes are those that the
//! model's own line in these parameters has (central differences of runs). What follows moves along that line.

use super::options::FitOptions;
use super::setup;
use crate::Result;
use crate::estimate::coordinates::Range;
use crate::estimate::least_squares::{Problem, Stopping, minimise};
use crate::estimate::triangle::Triangle;
use crate::model::Model;
use crate::record::{Recording, Span};
use std::borrow::Cow;

/// A model whose FMU stands at the parameters that fit best; the model itself where there is nothing to move.
///
/// # Errors
/// Where the FMU does not run at the values given.
pub fn settle<'m>(
    model: &'m Model,
    recordings: &[Recording],
    options: &FitOptions<'_>,
) -> Result<Cow<'m, Model>> {
    let numbers = model.stepping();
    if numbers.is_empty() || model.stepped_as().iter().all(Option::is_none) {
        return Ok(Cow::Borrowed(model));
    }
    options.progress.report("fitting the FMU by whole runs", None);
    let recordings = recordings.iter().map(|r| Ok((r, setup::spans(model, r, options).fit)));
    let whole = Whole { model, numbers: &numbers, recordings: recordings.collect::<Result<_>>()? };
    let of = |k: &usize| &model.parameters[*k];
    let start: Vec<f64> = numbers.iter().map(|k| of(k).value).collect();
    let ranges: Vec<Range> = numbers.iter().map(|k| Range::of(of(k))).collect();
    let least = minimise(&whole, &start, &ranges, Stopping::default())?;
    Ok(Cow::Owned(whole.at(&least.x)))
}

struct Whole<'a> {
    model: &'a Model,
    numbers: &'a [usize],
    recordings: Vec<(&'a Recording, Vec<Span>)>,
}

/// Residuals of an output of a recording, by the deviation of its signal, and the columns of their slopes.
struct Part {
    residual: Vec<f64>,
    slopes: Vec<Vec<f64>>,
}

impl Whole<'_> {
    fn at(&self, x: &[f64]) -> Model {
        let mut model = self.model.clone();
        self.numbers.iter().zip(x).for_each(|(k, x)| model.parameters[*k].value = *x);
        model
    }

    fn parts(&self, x: &[f64], with_slopes: bool) -> Result<Vec<Part>> {
        let model = self.at(x);
        let mut all = Vec::new();
        for (recording, spans) in &self.recordings {
            let ran = model.step(recording)?;
            let slopes: Vec<Vec<Vec<f64>>> = if with_slopes {
                let by = |k: &usize| model.slopes_by(recording, *k).map(|s| s.1);
                self.numbers.iter().map(by).collect::<Result<_>>()?
            } else {
                Vec::new()
            };
            for (own, output) in model.stepped_as().into_iter().enumerate() {
                let Some(c) = output.and_then(|o| recording.find(&model.outputs[o].name)) else { continue };
                let is_fitted = |t: f64| spans.iter().any(|s| s.from <= t && t <= s.to);
                let rows: Vec<(usize, f64)> = ran
                    .times
                    .iter()
                    .enumerate()
                    .filter(|(_, t)| is_fitted(**t))
                    .filter_map(|(i, t)| Some((i, c.value_at(*t).filter(|v| v.is_finite())?)))
                    .collect();
                let n = rows.len().max(1) as f64;
                let mean = rows.iter().map(|r| r.1).sum::<f64>() / n;
                let spread = (rows.iter().map(|r| (r.1 - mean).powi(2)).sum::<f64>() / n).sqrt();
                let weight = if spread > 0.0 { 1.0 / spread } else { 1.0 };
                all.push(Part {
                    residual: rows.iter().map(|(i, v)| weight * (v - ran.outputs[own][*i])).collect(),
                    slopes: slopes
                        .iter()
                        .map(|s| rows.iter().map(|(i, _)| -weight * s[own][*i]).collect())
                        .collect(),
                });
            }
        }
        Ok(all)
    }
}

impl Problem for Whole<'_> {
    fn unknowns(&self) -> usize {
        self.numbers.len()
    }

    fn sum_of_squares(&self, x: &[f64]) -> Result<f64> {
        // a run that the unit refuses is a bad trial, no end of the fit
        let Ok(parts) = self.parts(x, false) else { return Ok(f64::INFINITY) };
        Ok(parts.iter().flat_map(|p| &p.residual).map(|r| r * r).sum())
    }

    fn linearise(&self, x: &[f64]) -> Result<Triangle> {
        let mut triangle = Triangle::new(self.numbers.len());
        for part in self.parts(x, true)? {
            let columns: Vec<&[f64]> = part.slopes.iter().map(Vec::as_slice).collect();
            triangle.push(&columns, &part.residual);
        }
        Ok(triangle)
    }
}
