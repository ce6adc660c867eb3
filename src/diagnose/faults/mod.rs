//! Faulty data: found first, masked or mended, and never turned into physics.

mod left;
mod misread;
mod odd;
mod strays;
mod tell;

pub use left::Left;
pub use misread::{Misread, fits_badly, misread};
pub use odd::odd;
pub use strays::strays;

use super::Request;
use super::answer::DataFault;
use crate::model::Model;
use crate::record::quality::{self, Fault, FaultKind};
use crate::record::{Channel, Hold, Kind, Recording, unwrap};
use crate::units::significant;

/// A fault where it was found.
#[derive(Clone)]
pub struct Spoiled {
    /// Number of the recording: the fitted ones, then the separate ones.
    pub recording: usize,
    /// The fault.
    pub fault: Fault,
}

/// Faults of the channels that a model uses, and the recordings without them.
pub struct Cleaned {
    /// Faults that nothing honest looks like, in channels that the model uses.
    pub spoiled: Vec<Spoiled>,
    /// The same in words.
    pub told: Vec<DataFault>,
    /// The fitted recordings with the spoiled samples made gaps.
    pub recordings: Vec<Recording>,
    /// The same of the separate ones.
    pub separate: Vec<Recording>,
}

/// Takes further outliers out of recordings, the fitted and the separate ones, and adds them to what is told.
pub fn take(
    model: &Model,
    found: Vec<Spoiled>,
    (fitted, separate): (&mut [Recording], &mut [Recording]),
    (spoiled, told): (&mut Vec<Spoiled>, &mut Vec<DataFault>),
) {
    let mut all: Vec<&mut Recording> = fitted.iter_mut().chain(separate).collect();
    let several = all.len() > 1;
    for new in found {
        let Some(recording) = all.get_mut(new.recording) else { continue };
        **recording = quality::masked(recording, std::slice::from_ref(&new.fault));
        let place = if several { recording.name.clone() } else { String::new() };
        let of = |s: &Spoiled| {
            (s.recording, &s.fault.channel, s.fault.kind)
                == (new.recording, &new.fault.channel, new.fault.kind)
        };
        let tell = |f: &Fault| tell::told(model, recording, f, &place);
        if let Some((s, t)) = spoiled.iter_mut().zip(told.iter_mut()).find(|(s, _)| of(s)) {
            let f = &mut s.fault;
            f.spans.extend(new.fault.spans);
            f.spans.sort_by(|a, b| a.from.total_cmp(&b.from));
            (f.samples, f.size) = (f.samples + new.fault.samples, f.size.max(new.fault.size));
            *t = tell(f);
        } else {
            // Faults that lie in samples stand first, one told for each.
            told.insert(spoiled.len(), tell(&new.fault));
            spoiled.push(new);
        }
    }
}

/// A misfit of up to so many times q/√12 is that of the steps alone.
const STEPS_ALONE: f64 = 1.3;
/// Up to so many times, the steps make a quarter of its mean square and more, and are told beside it.
const STEPS_IN_PART: f64 = 2.0;
/// Samples of an input that are bridged at most where they are missing.
const BRIDGED: usize = 12;

/// Looks for faults and masks them.
pub fn clean(request: &Request<'_>) -> Cleaned {
    let mut cleaned =
        Cleaned { spoiled: Vec::new(), told: Vec::new(), recordings: Vec::new(), separate: Vec::new() };
    let all: Vec<&Recording> = request.recordings.iter().chain(request.separate).collect();
    for (number, recording) in all.iter().enumerate() {
        let found = faults_of(request.model, recording);
        let mended = mended(request.model, recording, &found);
        let own =
            if number < request.recordings.len() { &mut cleaned.recordings } else { &mut cleaned.separate };
        own.push(mended);
        for fault in found {
            let place = if all.len() > 1 { &recording.name } else { "" };
            cleaned.told.push(tell::told(request.model, recording, &fault, place));
            cleaned.spoiled.push(Spoiled { recording: number, fault });
        }
    }
    cleaned
}

/// Faults that are sure, of the channels that a model uses.
fn faults_of(model: &Model, recording: &Recording) -> Vec<Fault> {
    let channels = recording.channels.iter();
    let used = channels.filter_map(|c| Some((c, is_input(model, &c.name)?)));
    used.flat_map(|(c, input)| if input { of_input(c, recording.kind) } else { of_output(c, recording.kind) })
        .collect()
}

/// Whether a channel is an input of the model, or an output; `None` where it is neither.
fn is_input(model: &Model, name: &str) -> Option<bool> {
    if model.outputs.iter().any(|o| o.name == name) {
        return Some(false);
    }
    model.inputs.iter().any(|i| i.name == name).then_some(true)
}

/// An input is what was commanded or applied: a value that it holds is no stuck sensor, its steps and
/// spikes are no outliers, but for a number that loggers write where there was none.
fn of_input(channel: &Channel, kind: Kind) -> Vec<Fault> {
    let mut found = quality::channel_faults(channel, kind);
    found.retain(|f| f.sure && !f.kind.spoils());
    if kind == Kind::Time {
        found.extend(quality::coded_outliers(channel));
    }
    found
}

/// An output that never changes measures nothing, whatever else it may have.
fn of_output(channel: &Channel, kind: Kind) -> Vec<Fault> {
    if let Some(still) = quality::still(channel) {
        return vec![still];
    }
    let mut found = quality::channel_faults(channel, kind);
    found.retain(|f| f.sure);
    found
}

/// A recording with faulty samples made gaps, short gaps of inputs bridged and angles unwrapped.
fn mended(model: &Model, recording: &Recording, faults: &[Fault]) -> Recording {
    let mut recording = quality::masked(recording, faults);
    for f in faults.iter().filter(|f| f.kind == FaultKind::WrappedAngle) {
        for c in recording.channels.iter_mut().filter(|c| c.name == f.channel) {
            unwrap(&mut c.values);
            c.wraps = true;
        }
    }
    // Rows of trials have no neighbours.
    if recording.kind == Kind::Time {
        let inputs = recording.channels.iter_mut().filter(|c| is_input(model, &c.name) == Some(true));
        inputs.for_each(bridge);
    }
    recording
}

/// Short gaps of an input are bridged as it runs between its samples, so that the simulation goes on.
fn bridge(c: &mut Channel) {
    let known: Vec<usize> = (0..c.values.len()).filter(|i| c.values[*i].is_finite()).collect();
    for pair in known.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        if b - a > BRIDGED {
            continue;
        }
        for i in a + 1..b {
            let share = match c.hold {
                Hold::Linear => (c.time[i] - c.time[a]) / (c.time[b] - c.time[a]),
                Hold::Previous | Hold::AfterReading => 0.0,
            };
            c.values[i] = c.values[a] + share * (c.values[b] - c.values[a]);
        }
    }
}

/// Outputs whose misfit (root mean square, SI, by output) is no more than their own coarse steps q leave,
/// q/√12: better physics could not be seen in them.
pub fn coarse(model: &Model, recordings: &[Recording], misfit: &[f64]) -> Vec<DataFault> {
    let alone = stepped(model, recordings, misfit).filter(|(_, _, times)| *times < STEPS_ALONE);
    alone.map(|(r, fault, _)| tell::told(model, r, &fault, "")).collect()
}

/// What is said of outputs whose coarse steps make a good part of a misfit that is not theirs alone.
pub fn partly_coarse(model: &Model, recordings: &[Recording], misfit: &[f64]) -> Vec<String> {
    let partly = stepped(model, recordings, misfit)
        .filter(|(_, _, times)| (STEPS_ALONE..STEPS_IN_PART).contains(times));
    let say = |(r, fault, times): (&Recording, Fault, f64)| {
        let says = tell::told(model, r, &fault, "").finding.says;
        format!("{says}: they alone make {:.0} % of the mean square of what is left", 100.0 / (times * times))
    };
    partly.map(say).collect()
}

/// Outputs that move in coarse steps q, and how many times q/√12 their misfit is.
fn stepped<'a>(
    model: &'a Model,
    recordings: &'a [Recording],
    misfit: &'a [f64],
) -> impl Iterator<Item = (&'a Recording, Fault, f64)> {
    let step = |name: &str| {
        let mut with = recordings.iter().filter_map(|r| Some((r, r.find(name)?)));
        with.find_map(|(r, c)| Some((r, quality::coarse_steps(c)?)))
    };
    let outputs = model.outputs.iter().zip(misfit);
    outputs.filter_map(move |(o, rmse)| {
        let (r, fault) = step(&o.name)?;
        let times = rmse / (fault.size / 12_f64.sqrt());
        Some((r, fault, times))
    })
}

/// Whether a fault takes so much of its channel that the rest may be too little: as with a gap, more than
/// a tenth.
pub fn is_heavy(recordings: &[&Recording], spoiled: &Spoiled) -> bool {
    let channel = recordings.get(spoiled.recording).and_then(|r| r.find(&spoiled.fault.channel));
    takes(spoiled) && channel.is_some_and(|c| 10 * spoiled.fault.samples > c.len())
}

/// Whether a fault takes samples.
pub fn takes(spoiled: &Spoiled) -> bool {
    matches!(spoiled.fault.kind, FaultKind::Frozen | FaultKind::Gap | FaultKind::Outliers)
}

/// A number of at most seven digits.
fn short(x: f64) -> String {
    let text = significant(x, 7);
    if text.contains('.') && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        text
    }
}
