//! `gyrospec simulate`: a model on a recording.

use super::Outcome;
use super::output;
use crate::model::Model;
use crate::record::{Channel, Kind, Recording, read_once};
use crate::simulate::{Options, OutputSignal, Simulator, Trajectory};
use crate::{Error, Result};
use std::fmt::Write;
use std::path::PathBuf;
const HELP: &str = "\
Examples:
  gyrospec simulate model.toml log.toml
  gyrospec simulate model.toml log.toml --out predicted.csv
  gyrospec simulate model.toml examples/roll.csv --out -       # an output that nobody measured is predicted";

/// Arguments of `gyrospec simulate`.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    /// The model file; - is standard input.
    model: PathBuf,
    /// The recording: a CSV file or a TOML file; - is standard input.
    recording: PathBuf,
    /// Where the predictions go as CSV: time, then measured and predicted for every output.
    #[arg(long, value_name = "CSV")]
    out: Option<PathBuf>,
    /// How far halving the step may move an output, as a share of its spread.
    #[arg(long, default_value_t = Options::default().tolerance)]
    tolerance: f64,
}

pub fn run(call: &Call) -> Result<Outcome> {
    if !(call.tolerance > 0.0 && call.tolerance < 1.0) {
        return Err(Error::usage(format!("--tolerance {}: this is no share of a spread", call.tolerance))
            .with_hint("give a number between 0 and 1, such as 1e-5"));
    }
    read_once([call.model.as_path(), &call.recording])?;
    let [place] = output::open([call.out.as_deref()])?;
    output::spare(&place, [&call.model, &call.recording])?;
    let model = Model::read(&call.model)?;
    let mut recording = Recording::read(&call.recording)?;
    let read: Vec<PathBuf> =
        recording.sources.iter().map(|s| s.file.clone()).chain([call.model.clone()]).collect();
    output::spare(&place, &read)?;
    predict_what_is_not_measured(&model, &mut recording);
    let options = Options { tolerance: call.tolerance, ..Options::default() };
    let simulator = Simulator::new(&model, &recording, &options).map_err(|e| match e.file() {
        None => e.with_file(&call.model),
        Some(_) => e,
    })?;
    let ran = simulator.run(&simulator.parameters(), &simulator.initials())?;
    super::record::tell_notes([&recording]);
    for warning in warnings(&simulator, &ran) {
        super::warn(&warning);
    }
    let to_stdout = place.as_ref().is_some_and(output::Place::is_standard_output);
    if let Some(place) = place {
        output::put(&[place.data(csv(&simulator, &ran, recording.kind))], read)?;
    }
    if !to_stdout {
        output::words(&summary(&simulator, &ran))?;
    }
    Ok(Outcome::Done)
}

/// Outputs that nobody measured are predicted at the times of the first input: their channel is a gap.
fn predict_what_is_not_measured(model: &Model, recording: &mut Recording) {
    let Some(first) = model.inputs.first().and_then(|i| recording.find(&i.name)) else { return };
    let (time, table) = (first.time.clone(), first.table);
    for o in &model.outputs {
        if recording.find(&o.name).is_none() {
            let gaps = vec![f64::NAN; time.len()];
            let channel =
                Channel { table, ..Channel::new(o.name.clone(), o.unit.clone(), time.clone(), gaps) };
            recording.channels.push(channel);
            super::warn(&format!(
                "the recording has no channel `{}`: it is predicted at the times of `{}`, and compared with nothing",
                o.name, model.inputs[0].name
            ));
        }
    }
}

/// What the user should know about the run though it went on.
pub fn warnings(s: &Simulator, ran: &Trajectory) -> Vec<String> {
    let mut out = Vec::new();
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
            "the recording ({:.4} s) is shorter than the model's longest time constant ({slowest:.4} s): \
             what is slow in it cannot be seen",
            to - from
        ));
    }
    if ran.solver_error > 1e-3 && ran.blew_up.is_none() {
        out.push(format!(
            "the solver's error is {:.1e} of an output's spread; --tolerance cannot be met",
            ran.solver_error
        ));
    }
    for o in s.outputs() {
        let lost = o.covered.iter().zip(o.measured.iter()).filter(|(c, y)| !**c && y.is_finite()).count();
        if lost > 0 {
            let n = o.measured.len();
            out.push(format!("{lost} of {n} samples of {} lie outside the inputs, in a gap of theirs, or too soon after one", o.name));
        }
    }
    out
}

/// Measured less predicted, modulo a turn where the angle wraps.
fn residual(measured: f64, predicted: f64, wraps: bool) -> f64 {
    let e = measured - predicted;
    if wraps { e - std::f64::consts::TAU * (e / std::f64::consts::TAU).round() } else { e }
}

pub fn summary(s: &Simulator, ran: &Trajectory) -> String {
    let mut out = format!("{}\n", s.model().name);
    let (from, to) = s.span();
    if s.is_dynamic() {
        let (method, n) = s.steps();
        let _ = writeln!(
            out,
            "simulated from {from} to {to} s, {method:?} steps, {n} in an interval of the inputs, {} events",
            ran.events
        );
        out.push_str(&match ran.solver_error {
            e if e.is_finite() => format!("solver error {e:.1e} of the spread (by halving the step)\n"),
            _ => "solver error not known\n".to_string(),
        });
    }
    let _ =
        writeln!(out, "{:<20} {:>8} {:>14} {:>14}  unit", "output", "samples", "rms error", "worst error");
    for (o, predicted) in s.outputs().iter().zip(&ran.outputs) {
        let (count, rms, worst) = errors(o, predicted);
        let unit = o.unit.of_differences();
        let [rms, worst] = [rms, worst].map(cell);
        let _ = writeln!(out, "{:<20} {count:>8} {rms:>14} {worst:>14}  {unit}", o.name);
    }
    out
}

/// The number of compared samples, and the rms and worst error in the output's unit.
pub fn errors(o: &OutputSignal, predicted: &[f64]) -> (usize, f64, f64) {
    let pairs = o.measured.iter().zip(predicted).filter(|(y, f)| y.is_finite() && f.is_finite());
    let errors: Vec<f64> = pairs.map(|(y, f)| o.unit.difference_from_si(residual(*y, *f, o.wraps))).collect();
    let rms = (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt();
    (errors.len(), rms, errors.iter().fold(f64::NAN, |m, e| m.max(e.abs())))
}

/// A dash for no number; six decimals, or six digits and an exponent for what is very small or large.
fn cell(x: f64) -> String {
    if !x.is_finite() {
        "-".into()
    } else if x != 0.0 && !(1e-3..1e7).contains(&x) {
        format!("{x:.5e}")
    } else {
        format!("{x:.6}")
    }
}

/// One row a time of any output: empty cells where an output has no sample.
fn csv(s: &Simulator, ran: &Trajectory, kind: Kind) -> String {
    let mut times: Vec<f64> = s.outputs().iter().flat_map(|o| o.time.iter().copied()).collect();
    times.sort_unstable_by(f64::total_cmp);
    times.dedup();
    let mut out = String::from(if kind == Kind::Trials { "row [1]" } else { "time [s]" });
    for o in s.outputs() {
        let _ = write!(out, ",{0}_measured [{1}],{0} [{1}]", o.name, o.unit);
    }
    out.push('\n');
    let mut next = vec![0; s.outputs().len()];
    for t in times {
        let _ = write!(out, "{t}");
        for (k, o) in s.outputs().iter().enumerate() {
            let here = o.time.get(next[k]) == Some(&t);
            for values in [&o.measured[..], &ran.outputs[k][..]] {
                let value = if here { values[next[k]] } else { f64::NAN };
                out.push(',');
                if value.is_finite() {
                    let _ = write!(out, "{}", o.unit.from_si(value));
                }
            }
            next[k] += usize::from(here);
        }
        out.push('\n');
    }
    out
}
