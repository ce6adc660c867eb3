//! What a user should know about a fit, although it went on.

use super::assemble::Assembly;
use super::harness::Record;
use super::outcome::Warning;
use crate::estimate::coordinates::Side;
use crate::estimate::least_squares::End;
use crate::units::figure;

impl Assembly<'_> {
    /// All warnings about a minimum that was fitted to so many samples.
    pub(super) fn all_warnings(&self, samples: usize) -> Vec<Warning> {
        let mut found = at_bounds(self);
        found.extend(astray(self));
        let unknowns = self.minimum.x.len();
        if samples <= unknowns && unknowns > 0 {
            found.push(Warning {
                message: format!(
                    "{samples} samples for {unknowns} unknowns: the model can follow anything, and no interval can be \
                     given; fit a longer stretch"
                ),
            });
        }
        found.extend(too_short(self));
        let cautions = self.problem.records.iter().flat_map(|r| &r.cautions);
        found.extend(cautions.map(|text| Warning { message: text.clone() }));
        found.extend(self.problem.records.iter().filter(|r| worth_telling(r)).map(|r| Warning {
            message: format!("{} samples of '{}' are not compared: they lie {}", r.lost, r.name, r.lie),
        }));
        if let Some(early) = self.ended_early {
            found.push(Warning {
                message: format!("the fit ended early, with the best so far: {}", early.words()),
            });
        } else if self.minimum.end != End::Converged {
            found.push(Warning {
                message: "the fit ended before it came to rest: take its values with care, or start nearer"
                    .into(),
            });
        }
        found
    }
}

/// A sample or two at the ends are not.
fn worth_telling(r: &Record) -> bool {
    let compared: usize = r.tracks.iter().map(|t| t.time.len()).sum();
    200 * r.lost > compared
}

fn at_bounds(fit: &Assembly<'_>) -> Vec<Warning> {
    let free = fit.problem.free.iter().zip(&fit.minimum.at_bound).zip(&fit.minimum.is_level);
    free.filter_map(|((k, side), is_level)| {
        let p = &fit.model.parameters[*k];
        let (which, bound) = match (*side)? {
            Side::Lower => ("lower", p.min?),
            Side::Upper => ("upper", p.max?),
        };
        let (name, unit, bound) = (&p.name, &p.unit, p.unit.decimal_from_si(bound));
        let message = if *is_level {
            format!(
                "{name} rests at its {which} bound {bound} {unit}, where its effect has no slope: these data ask for \
                 no other value, and a wider bound changes nothing"
            )
        } else if bound == 0.0 && p.unit.to_si(0.0) == 0.0 {
            format!(
                "{name} is pressed against its {which} bound 0 {unit}: these data ask for none of it; leave {name} \
                 out, or ask which other part of the model takes its place"
            )
        } else {
            format!(
                "{name} is pressed against its {which} bound {bound} {unit}: widen the bound, or ask whether the \
                 model needs {name} at all"
            )
        };
        Some(Warning { message })
    })
    .collect()
}

/// Initial states that ended at the bound of what is allowed them.
fn astray(fit: &Assembly<'_>) -> Vec<Warning> {
    let records = fit.problem.records;
    let states = records.iter().flat_map(|r| r.free_initials.iter().map(move |s| (r, *s)));
    let places = fit.problem.free.len()..fit.minimum.x.len();
    let pressed = states.zip(places).filter(|(_, at)| fit.minimum.at_bound[*at].is_some());
    pressed
        .map(|((record, state), at)| {
            let state = &fit.model.states[state];
            Warning {
                message: format!(
                    "{} starts at {} {} in '{}', as far off as it may: the recording hardly shows it; start it steady \
                     or from a number",
                    state.name,
                    state.unit.decimal_from_si(fit.minimum.x[at]),
                    state.unit,
                    record.name
                ),
            }
        })
        .collect()
}

/// A recording shorter than the longest time constant of the model.
fn too_short(fit: &Assembly<'_>) -> Option<Warning> {
    let (parameters, initials) = fit.problem.spread(&fit.minimum.x);
    let mut worst: Option<(f64, f64, &str)> = None;
    for (record, initials) in fit.problem.records.iter().zip(&initials) {
        let last = record.tracks.iter().filter_map(|t| t.time.last()).fold(record.start, |a, b| a.max(*b));
        let length = last - record.start;
        let slowest = record.harness.slowest_time(&record.parameters(&parameters), initials);
        let longest = slowest.unwrap_or(0.0);
        if longest > length && worst.is_none_or(|w| longest > w.0) {
            worst = Some((longest, length, &record.name));
        }
    }
    let (longest, length, name) = worst?;
    Some(Warning {
        message: format!(
            "the fitted part of '{name}' lasts {} s, less than the longest time constant of the \
             model, {} s: what acts so slowly is hardly seen",
            figure(length),
            figure(longest)
        ),
    })
}
