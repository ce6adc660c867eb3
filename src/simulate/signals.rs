//! The outputs of a model beside the channels that measured them.

use super::gaps::{inside, stretches};
use super::mesh::Samples;
use super::probe::Clock;
use crate::model::Model;
use crate::model::program::{Program, Register};
use crate::record::{Channel, Kind, Recording};
use crate::units::{Unit, significant};
use crate::{Error, ErrorKind, Result};
use std::sync::Arc;

/// An output of the model and the channel that measured it.
#[derive(Debug, Clone)]
pub struct OutputSignal {
    /// Name of the output and of the channel.
    pub name: String,
    /// Number of the output in the model.
    pub output: usize,
    /// The model's unit of the output.
    pub unit: Unit,
    /// s of the recording's clock; row numbers of trials.
    pub time: Arc<[f64]>,
    /// Measured values in SI; NaN = gap.
    pub measured: Arc<[f64]>,
    /// Whether the angle counts modulo a turn.
    pub wraps: bool,
    /// Which samples the model can predict: inside the simulated span and outside input gaps.
    pub covered: Vec<bool>,
}

/// The channel of an input or output, with the dimension that the model expects.
fn channel<'a>(
    model: &Model,
    recording: &'a Recording,
    (what, name): (&str, &str),
    unit: &Unit,
) -> Result<&'a Channel> {
    let channel = recording.channel(name).map_err(|e| e.about(&format!("{what} {name}")))?;
    if model.is_free {
        return Ok(channel);
    }
    if channel.unit.dimension() != unit.dimension() {
        let message =
            format!("{what} {name} has the unit {unit} in the model, but {} in the recording", channel.unit);
        let hint =
            "the unit of a channel stands in the header of its column, or in the recording's TOML file";
        return Err(Error::new(ErrorKind::Units, message).with_hint(hint));
    }
    let taken = model.takes_unit(&format!("{what}s"), name, &channel.unit);
    taken.map_err(|e| e.about(&format!("{what} {name}")))?;
    Ok(channel)
}

/// What a user should know of the model's beginnings and of the recording's channels.
pub(super) fn cautions(model: &Model, recording: &Recording) -> Vec<String> {
    let mut all = model.cautions();
    let is_unknown = |name: &str| model.parameters.iter().all(|p| p.name != name);
    let unknown = recording.constants.iter().filter(|c| is_unknown(&c.name));
    all.extend(unknown.map(|c| {
        format!(
            "the constant `{}` of '{}' is no parameter of the model, and does nothing",
            c.name, recording.name
        )
    }));
    all.extend(beyond_bounds(model, recording));
    all.extend(model.caution_of(recording));
    all.extend(taken_as_radians(model, recording));
    all
}

/// What is said of constants that lie where the model says that their parameter is not.
fn beyond_bounds(model: &Model, recording: &Recording) -> Vec<String> {
    let pairs = recording
        .constants
        .iter()
        .filter_map(|c| Some((c, model.parameters.iter().find(|p| p.name == c.name)?)));
    let beyond = pairs.filter_map(|(c, p)| {
        let bound = p.min.filter(|b| c.value < *b).or(p.max.filter(|b| c.value > *b))?;
        let [value, bound] = [c.value, bound].map(|x| significant(p.unit.from_si(x), 4));
        Some(format!(
            "the constant `{}` of '{}', {value} {unit}, lies beyond the bound of {bound} {unit} that the model gives it",
            c.name, recording.name, unit = p.unit
        ))
    });
    beyond.collect()
}

/// What is said of channels whose unit says nothing of an angle where the model means an angular speed.
fn taken_as_radians(model: &Model, recording: &Recording) -> Vec<String> {
    let inputs = model.inputs.iter().map(|i| (&i.name, &i.unit));
    let signals = inputs.chain(model.outputs.iter().map(|o| (&o.name, &o.unit)));
    let channels = signals.filter_map(|(name, unit)| Some((name, unit, &recording.channel(name).ok()?.unit)));
    channels
        .filter(|(_, unit, given)| unit.takes_as_radians(given))
        .map(|(name, unit, given)| {
            format!(
                "{name} is in {given} in '{}' and in {unit} in the model: its values are taken as radians; if they \
                 are turns a second, give them times 60 in rpm",
                recording.name
            )
        })
        .collect()
}

/// The inputs' samples.
pub(super) fn inputs(model: &Model, recording: &Recording) -> Result<Vec<Samples>> {
    model
        .inputs
        .iter()
        .map(|input| {
            let samples = Samples::of(channel(model, recording, ("input", &input.name), &input.unit)?);
            if samples.time.is_empty() {
                let message = format!("the input {} has no samples in `{}`", input.name, recording.name);
                return Err(Error::bad_input(message).with_hint("its column is empty, or NaN throughout"));
            }
            Ok(samples)
        })
        .collect()
}

/// The outputs that the recording measured.
pub(super) fn outputs(model: &Model, recording: &Recording) -> Result<Vec<OutputSignal>> {
    let mut found = Vec::new();
    for (i, output) in model.outputs.iter().enumerate() {
        let c = channel(model, recording, ("output", &output.name), &output.unit)?;
        found.push(OutputSignal {
            name: output.name.clone(),
            output: i,
            unit: output.unit.clone(),
            time: c.time.clone(),
            measured: c.values.as_slice().into(),
            wraps: c.wraps,
            covered: Vec::new(),
        });
    }
    Ok(found)
}

/// The simulated span: where all inputs are known, up to the last output wanted.
pub(super) fn span(
    inputs: &[Samples],
    outputs: &[OutputSignal],
    window: Option<(f64, f64)>,
) -> Result<(f64, f64)> {
    let ends = |time: &Arc<[f64]>| Some((*time.first()?, *time.last()?));
    let measured = outputs.iter().filter_map(|o| ends(&o.time));
    let measured = measured.fold((f64::INFINITY, f64::NEG_INFINITY), |a, b| (a.0.min(b.0), a.1.max(b.1)));
    let known = inputs.iter().filter_map(Samples::range);
    let known = known.fold((f64::NEG_INFINITY, f64::INFINITY), |a, b| (a.0.max(b.0), a.1.min(b.1)));
    let from = if known.0.is_finite() { known.0 } else { measured.0 };
    let window = window.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    let span = (from.max(window.0), known.1.min(measured.1).min(window.1));
    if span.0 <= span.1 && span.0.is_finite() && measured.0 <= span.1 {
        Ok(span)
    } else {
        let place = if window.0.is_finite() {
            format!(" from {} to {} s", window.0, window.1)
        } else {
            String::new()
        };
        Err(Error::bad_input(format!("inputs and outputs share no time{place}"))
            .with_hint("the clocks of the tables may differ; `gyrospec record` shows their times"))
    }
}

/// Refuses a span without length: a model with states needs time to move.
pub(super) fn lasting(span: (f64, f64)) -> Result<()> {
    if span.0 < span.1 {
        return Ok(());
    }
    let message = format!("inputs and outputs share one moment only, t = {} s", span.0);
    Err(Error::bad_input(message).with_hint("a model with states needs a stretch of time"))
}

/// The outputs of a model on a recording, and which of their samples it can predict whatever its
/// parameters: those inside the time of all inputs and outside the inputs' gaps.
///
/// # Errors
/// Missing channels, units that do not fit, inputs and outputs without common time.
pub fn coverage(model: &Model, recording: &Recording) -> Result<Vec<OutputSignal>> {
    let samples = inputs(model, recording)?;
    let mut outputs = outputs(model, recording)?;
    let span = span(&samples, &outputs, None)?;
    match recording.kind {
        Kind::Time => cover(&mut outputs, span, &stretches(&samples)),
        Kind::Trials => cover_trials(&mut outputs, &samples, span),
    }
    Ok(outputs)
}

/// Marks what can be predicted: inside the span and outside the blanks.
pub(super) fn cover(outputs: &mut [OutputSignal], span: (f64, f64), blanks: &[(f64, f64)]) {
    for o in outputs {
        let known = |t: &f64| *t >= span.0 && *t <= span.1 && !inside(blanks, *t);
        o.covered = o.time.iter().map(known).collect();
    }
}

/// Marks the trials of which all inputs are known.
pub(super) fn cover_trials(outputs: &mut [OutputSignal], inputs: &[Samples], span: (f64, f64)) {
    for o in outputs {
        let known = |t: &f64| inputs.iter().all(|s| s.time.binary_search_by(|x| x.total_cmp(t)).is_ok());
        o.covered = o.time.iter().map(|t| *t >= span.0 && *t <= span.1 && known(t)).collect();
    }
}

/// One clock for all outputs that share their times; gives the place of each output: clock and column.
pub(super) fn clocks(outputs: &[OutputSignal], program: &Program) -> (Vec<Clock>, Vec<(usize, usize)>) {
    let mut clocks: Vec<Clock> = Vec::new();
    let mut places = Vec::new();
    for o in outputs {
        let register: Register = program.outputs[o.output];
        let same = |c: &Clock| Arc::ptr_eq(&c.time, &o.time) || c.time == o.time;
        let k = clocks.iter().position(same).unwrap_or_else(|| {
            clocks.push(Clock { time: o.time.clone(), registers: Vec::new() });
            clocks.len() - 1
        });
        places.push((k, clocks[k].registers.len()));
        clocks[k].registers.push(register);
    }
    (clocks, places)
}

/// Parameters that the recording knows itself: (number, SI value).
pub(super) fn constants(model: &Model, recording: &Recording) -> Result<Vec<(usize, f64)>> {
    let number = |name: &str| model.parameters.iter().position(|p| p.name == name);
    let mut found: Vec<(usize, f64)> =
        recording.mark.as_deref().and_then(number).map(|k| (k, 1.0)).into_iter().collect();
    for c in &recording.constants {
        if let Some(k) = number(&c.name) {
            let wanted = &model.parameters[k].unit;
            if wanted.dimension() != c.unit.dimension() {
                let message = format!(
                    "the constant {} has the unit {} in the recording, but {wanted} in the model",
                    c.name, c.unit
                );
                return Err(Error::new(ErrorKind::Units, message));
            }
            let taken = model.takes_unit("parameters", &c.name, &c.unit);
            taken.map_err(|e| e.about(&format!("the constant {}", c.name)))?;
            found.push((k, c.value));
        }
    }
    Ok(found)
}
