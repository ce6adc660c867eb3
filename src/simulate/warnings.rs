//! What the user should know about a run though it went on.

use super::machine::registers;
use super::{OutputSignal, Simulator, Trajectory};
use crate::model::program::{InputColumn, Remembered};
use crate::record::principal;
use crate::units::figure;

/// What the user should know about the run though it went on.
pub fn warnings(s: &Simulator, ran: &Trajectory) -> Vec<String> {
    let mut out = s.cautions.clone();
    if let Some((t, state)) = ran.blew_up {
        let states = &s.model().states;
        let name = states.get(state).map_or("a lag or another hidden state", |x| x.name.as_str());
        out.push(format!(
            "the model blows up: {name} is beyond all bounds, or no number, at t = {t} s; there are no predictions \
             from there on. Start it from other values, look at its signs, and at roots and logarithms of what may \
             become negative"
        ));
    }
    let (from, to) = s.span();
    if let Ok(Some(slowest)) = s.slowest_time(&s.parameters(), &s.initials())
        && s.is_dynamic()
        && to - from < slowest
    {
        out.push(format!(
            "the recording ({} s) is shorter than the model's longest time constant ({} s): what is slow in it \
             cannot be seen",
            figure(to - from),
            figure(slowest)
        ));
    }
    out.extend(looks_ahead(s));
    if ran.solver_error > 1e-3 && ran.blew_up.is_none() {
        out.push(format!(
            "the solver's error is {:.1e} of an output's spread; --tolerance cannot be met",
            ran.solver_error
        ));
    }
    out.extend(
        s.outputs().iter().zip(&ran.outputs).filter_map(|(o, y)| no_number(o, y, ran.blew_up.map(|b| b.0))),
    );
    for o in s.outputs() {
        let lost = o.covered.iter().zip(o.measured.iter()).filter(|(c, y)| !**c && y.is_finite()).count();
        if lost > 0 {
            let n = o.measured.len();
            out.push(format!("{lost} of {n} samples of {} lie {}", o.name, s.model().uncompared()));
        }
    }
    out
}

/// What a user should know of delays below 0: beyond the end of an input its last value stands, and nothing of a state
/// is known ahead.
fn looks_ahead(s: &Simulator) -> Vec<String> {
    let r = registers(&s.program, &s.parameters());
    let beyond = |c: &InputColumn| {
        let (delay, input) = (r[usize::from(c.delay?)], &s.samples[c.input]);
        let lacks = s.span().1 - delay - input.time.last()?;
        (delay < 0.0 && lacks > 0.0).then(|| {
            format!(
                "{} is asked for {} s ahead: over the last {} s, for which it was not recorded, its last value stands",
                s.model.inputs[c.input].name,
                figure(-delay),
                figure(lacks)
            )
        })
    };
    let of_states = |m: &Remembered| match m {
        Remembered::Past { delay, .. } if r[usize::from(*delay)] < 0.0 => Some(format!(
            "a delay of {} s looks ahead of a state, which nothing can: what it gives means nothing",
            figure(r[usize::from(*delay)])
        )),
        _ => None,
    };
    let inputs = s.program.columns.iter().filter_map(beyond);
    inputs.chain(s.program.remembered.iter().filter_map(of_states)).collect()
}

/// Samples of an output for which its formula gives no number though the states are finite.
fn no_number(o: &OutputSignal, predicted: &[f64], until: Option<f64>) -> Option<String> {
    let reached = |t: f64| until.is_none_or(|end| t < end);
    let asked: Vec<usize> = (0..predicted.len())
        .filter(|i| o.covered[*i] && o.measured[*i].is_finite() && reached(o.time[*i]))
        .collect();
    let none: Vec<usize> = asked.iter().copied().filter(|i| !predicted[*i].is_finite()).collect();
    let first = o.time[*none.first()?];
    Some(format!(
        "{} has no finite value at {} of {} samples, first at t = {first} s: they are compared with nothing. Look at \
         roots, logarithms and quotients in its formula",
        o.name,
        none.len(),
        asked.len()
    ))
}

impl OutputSignal {
    /// The number of samples that can be compared with what is predicted for them, and the root mean square and the
    /// largest of measured less predicted, in the output's unit.
    pub fn errors(&self, predicted: &[f64]) -> (usize, f64, f64) {
        let pairs = self.measured.iter().zip(predicted).filter(|(y, f)| y.is_finite() && f.is_finite());
        let residual = |(y, f): (&f64, &f64)| if self.wraps { principal(y - f) } else { y - f };
        let errors: Vec<f64> = pairs.map(|pair| self.unit.difference_from_si(residual(pair))).collect();
        let rms = (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt();
        (errors.len(), rms, errors.iter().fold(f64::NAN, |m, e| m.max(e.abs())))
    }
}
