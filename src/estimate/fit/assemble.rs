//! From a minimum to a [`Fit`]: residuals, noise, intervals, what is not seen.

use super::outcome::{Fit, InitialEstimate, ParameterEstimate, RecordFit, Series, Status, Warning};
use super::problem::FreeRun;
use crate::Result;
use crate::estimate::coordinates::Range;
use crate::estimate::covariance::{Stretch, coloured_covariance, half_width, independent_samples};
use crate::estimate::identify::{Direction, told_once, unseen};
use crate::estimate::least_squares::Minimum;
use crate::estimate::noise::NoiseModel;
use crate::estimate::triangle::Triangle;
use crate::model::Model;
use crate::simulate::Early;
use faer::Mat;

/// Everything about a minimum that the report needs.
pub struct Assembly<'a> {
    /// What ended the search before it was through.
    pub ended_early: Option<Early>,
    /// The model as given.
    pub model: &'a Model,
    /// The problem that was solved.
    pub problem: &'a FreeRun<'a>,
    pub minimum: &'a Minimum,
    /// The ranges of the unknowns.
    pub ranges: &'a [Range],
    /// Where the unknowns started.
    pub start: &'a [f64],
    /// Simulations done on the way.
    pub simulations: usize,
    /// Warnings gathered on the way.
    pub warnings: Vec<Warning>,
    /// The solver's tolerance.
    pub tolerance: f64,
    /// Samples of each output in a period of the slowest input.
    pub periods: Vec<usize>,
}

impl Assembly<'_> {
    pub fn finish(self) -> Result<Fit> {
        let records = self.records()?;
        let names = self.names();
        let noise = self.noise(&records);
        let whitened = self.whitened(&records, &noise);
        let (unseen, blind) = self.unseen(&whitened, &names);
        let seen: Vec<usize> =
            (0..names.len()).filter(|j| self.minimum.at_bound[*j].is_none() && !blind[*j]).collect();
        let covariance = if samples(&records) > names.len() {
            self.covariance(&records, &noise, &seen)
        } else {
            Mat::from_fn(names.len(), names.len(), |_, _| f64::NAN)
        };
        let reach = reach(&records, &noise, seen.len());
        let fitted = samples(&records);
        let (parameters, _) = self.problem.spread(&self.minimum.x);
        let mut model = self.model.clone();
        for (p, value) in model.parameters.iter_mut().zip(&parameters) {
            p.value = *value;
        }
        Ok(Fit {
            parameters: self.estimates(&parameters, &covariance, reach),
            initials: self.initials(&covariance, reach),
            unknowns: names,
            values: self.minimum.x.clone(),
            covariance,
            rmse: self.rmse(&records),
            records,
            noise,
            unseen,
            profiled: Vec::new(),
            determined: Vec::new(),
            warnings: [self.warnings.clone(), self.all_warnings(fitted)].concat(),
            tolerance: self.tolerance,
            ended_early: self.ended_early,
            end: self.minimum.end,
            simulations: self.simulations,
            model,
        })
    }

    fn records(&self) -> Result<Vec<RecordFit>> {
        let x = &self.minimum.x;
        let linear = self.problem.linear(x)?;
        let (_, initials) = self.problem.spread(x);
        let mut records = Vec::new();
        for ((record, l), initials) in self.problem.records.iter().zip(linear).zip(initials) {
            let mut series = Vec::new();
            for (k, track) in record.tracks.iter().enumerate() {
                let mut sensitivities = vec![vec![0.0; track.time.len()]; x.len()];
                for (place, column) in l.places.iter().zip(&l.run.sensitivities[k]) {
                    sensitivities[*place].clone_from(column);
                }
                series.push(Series {
                    output: track.output,
                    time: track.time.clone(),
                    residual: track.residual(&l.run.predictions[k]),
                    sensitivities,
                    stretches: track.stretches.clone(),
                });
            }
            records.push(RecordFit { name: record.name.clone(), start: record.start, initials, series });
        }
        Ok(records)
    }

    /// Names of the unknowns.
    fn names(&self) -> Vec<String> {
        let several = self.problem.records.len() > 1;
        let parameters = self.problem.free.iter().map(|k| self.model.parameters[*k].name.clone());
        let initials = self.problem.records.iter().flat_map(|r| {
            r.free_initials.iter().map(move |s| {
                let state = &self.model.states[*s].name;
                if several { format!("{state}(0) of {}", r.name) } else { format!("{state}(0)") }
            })
        });
        parameters.chain(initials).collect()
    }

    /// The noise of every output, its level corrected for what the unknowns took away.
    fn noise(&self, records: &[RecordFit]) -> Vec<NoiseModel> {
        let unknowns = self.minimum.x.len();
        (0..self.model.outputs.len())
            .map(|output| {
                let own: Vec<&Series> =
                    records.iter().flat_map(|r| &r.series).filter(|s| s.output == output).collect();
                let stretches: Vec<&[f64]> = own.iter().flat_map(|s| s.residual_stretches()).collect();
                let columns: Vec<Vec<&[f64]>> = (0..unknowns)
                    .map(|j| own.iter().flat_map(|s| s.sensitivity_stretches(j)).collect())
                    .collect();
                let mut noise = NoiseModel::estimate_below(&stretches, &columns, self.periods[output]);
                let samples = stretches.iter().map(|s| s.len()).sum();
                let worth = independent_samples(&noise, samples);
                let factor = worth / (worth - unknowns as f64).max(0.25 * worth);
                if factor.is_finite() {
                    noise.autoregression = noise.autoregression.rescaled(factor);
                }
                noise
            })
            .collect()
    }

    /// The whitened problem at the minimum.
    fn whitened(&self, records: &[RecordFit], noise: &[NoiseModel]) -> Triangle {
        let mut triangle = Triangle::new(self.minimum.x.len());
        for series in records.iter().flat_map(|r| &r.series) {
            for stretch in &series.stretches {
                let columns: Vec<&[f64]> = series.sensitivities.iter().map(|c| &c[stretch.clone()]).collect();
                let rows = noise[series.output].whiten_rows(&series.residual[stretch.clone()], &columns);
                let views: Vec<&[f64]> = rows.columns.iter().map(Vec::as_slice).collect();
                triangle.push(&views, &rows.residual);
            }
        }
        triangle
    }

    /// The unseen directions that parameters take part in, and the unknowns of which nothing is seen.
    fn unseen(&self, whitened: &Triangle, names: &[String]) -> (Vec<Direction>, Vec<bool>) {
        let norms = whitened.column_norms();
        let signal = (whitened.rows() as f64).sqrt();
        let sizes: Vec<f64> = self
            .minimum
            .x
            .iter()
            .zip(self.start)
            .zip(&norms)
            .enumerate()
            .map(|(j, ((x, start), norm))| {
                // what nobody gave a size has at least the one that moves the predictions by their noise
                let is_given = j < self.problem.free.len() && *start != 0.0;
                let least = if !is_given && *norm > 0.0 { signal / norm } else { 0.0 };
                let size = x.abs().max(start.abs()).max(least);
                if size > 0.0 { size } else { 1.0 }
            })
            .collect();
        let all = unseen(whitened, names, &sizes);
        let parameters = &names[..self.problem.free.len()];
        let mut blind: Vec<bool> = norms.iter().map(|n| n.is_nan() || *n <= 0.0).collect();
        for direction in all.iter().filter(|d| d.deviation.is_infinite()) {
            for (name, _) in &direction.weights {
                if let Some(j) = names.iter().position(|n| n == name) {
                    blind[j] = true;
                }
            }
        }
        let named = all.into_iter().filter(|d| d.weights.iter().any(|w| parameters.contains(&w.0)));
        (told_once(named.collect()), blind)
    }

    fn covariance(&self, records: &[RecordFit], noise: &[NoiseModel], seen: &[usize]) -> Mat<f64> {
        let p = self.minimum.x.len();
        let whitened = self.problem.whitening.is_some();
        let mut stretches = Vec::new();
        for series in records.iter().flat_map(|r| &r.series) {
            for s in &series.stretches {
                stretches.push(Stretch {
                    weight: if whitened { 1.0 } else { self.problem.weights[series.output] },
                    noise: &noise[series.output],
                    columns: seen.iter().map(|j| &series.sensitivities[*j][s.clone()]).collect(),
                });
            }
        }
        let small = if whitened {
            let mut whole = self.whitened(records, noise);
            whole = whole.restricted(seen, &vec![0.0; whole.unknowns()]);
            crate::estimate::covariance::inverse_square(&whole)
        } else {
            coloured_covariance(seen.len(), &stretches)
        };
        let mut full = Mat::from_fn(p, p, |_, _| f64::NAN);
        if let Some(small) = small {
            for (i, a) in seen.iter().enumerate() {
                for (j, b) in seen.iter().enumerate() {
                    full[(*a, *b)] = small[(i, j)];
                }
            }
        }
        full
    }

    /// The 95 % interval of one unknown: even about its logarithm where it walks as one.
    fn interval(&self, at: usize, covariance: &Mat<f64>, reach: f64) -> (f64, f64) {
        let (x, range) = (self.minimum.x[at], self.ranges[at]);
        let half = reach * covariance[(at, at)].sqrt();
        if !half.is_finite() {
            return (f64::NAN, f64::NAN);
        }
        if range.is_logarithmic() {
            let factor = (half / x).exp();
            (range.clamp(x / factor), range.clamp(x * factor))
        } else {
            (range.clamp(x - half), range.clamp(x + half))
        }
    }

    fn estimates(&self, values: &[f64], covariance: &Mat<f64>, reach: f64) -> Vec<ParameterEstimate> {
        let parameters = self.model.parameters.iter().enumerate();
        parameters
            .map(|(k, p)| {
                let at = self.problem.free.iter().position(|f| *f == k);
                let constants =
                    self.problem.records.iter().map(|r| r.constants.iter().find(|c| c.0 == k).map(|c| c.1));
                let known: Option<Vec<f64>> =
                    constants.collect::<Option<_>>().filter(|c: &Vec<f64>| !c.is_empty());
                let status = match at {
                    Some(at) => match self.minimum.at_bound[at] {
                        Some(side) => Status::AtBound(side),
                        None => Status::Fitted,
                    },
                    None if known.is_some() => Status::Constant,
                    None => Status::Fixed,
                };
                let (low, high) = at.map_or((f64::NAN, f64::NAN), |at| self.interval(at, covariance, reach));
                let same = |c: &Vec<f64>| c.iter().all(|x| *x == c[0]).then_some(c[0]);
                ParameterEstimate {
                    name: p.name.clone(),
                    value: known.as_ref().filter(|_| at.is_none()).and_then(same).unwrap_or(values[k]),
                    low,
                    high,
                    unit: p.unit.clone(),
                    status,
                }
            })
            .collect()
    }

    fn initials(&self, covariance: &Mat<f64>, reach: f64) -> Vec<InitialEstimate> {
        let mut found = Vec::new();
        for record in self.problem.records {
            for s in &record.free_initials {
                let at = self.problem.free.len() + found.len();
                let state = &self.model.states[*s];
                let (low, high) = self.interval(at, covariance, reach);
                found.push(InitialEstimate {
                    recording: record.recording,
                    state: state.name.clone(),
                    value: self.minimum.x[at],
                    low,
                    high,
                    unit: state.unit.clone(),
                });
            }
        }
        found
    }

    fn rmse(&self, records: &[RecordFit]) -> Vec<f64> {
        (0..self.model.outputs.len())
            .map(|o| {
                let own = records.iter().flat_map(|r| &r.series).filter(|s| s.output == o);
                root_mean_square(own)
            })
            .collect()
    }
}

/// Number of samples that were fitted.
pub fn samples(records: &[RecordFit]) -> usize {
    records.iter().flat_map(|r| &r.series).flat_map(|s| &s.stretches).map(ExactSizeIterator::len).sum()
}

/// Half the width of the 95 % intervals in standard deviations.
pub fn reach(records: &[RecordFit], noise: &[NoiseModel], seen: usize) -> f64 {
    let series = records.iter().flat_map(|r| &r.series);
    let worth: f64 = series.map(|s| independent_samples(&noise[s.output], s.time.len())).sum();
    half_width(worth - seen as f64)
}

/// Root mean square over some series; NaN without samples.
pub fn root_mean_square<'a>(series: impl Iterator<Item = &'a Series>) -> f64 {
    let (sum, count) = series.map(Series::energy).fold((0.0, 0), |a, b| (a.0 + b.0, a.1 + b.1));
    (sum / count as f64).sqrt()
}
