//! How each input runs between its samples, settled before anything is named.
//!
//! # Purpose
//! A command that a computer holds, read as straight lines between its samples, comes half a sample too early. A
//! diagnosis that takes the reading for granted names a delay, a lag, a resonance.
//!
//! # Method
//! One run with each input held, at the fitted parameters, gives the direction d in which the reading moves the
//! predictions. The residual is projected on the directions of all inputs together, orthogonal to the fitted
//! sensitivities and whitened: a weight of 1 is an input that is held, 0 one that runs straight, and any other
//! something else that shifts or smooths it, which is left to the search. What stands so is read as held, and stays so
//! where the refitted model is likelier. So does an input that looks held by itself, since it stays and leaps, unless its
//! weight is nearer to 0: beside something large a weight is far off. An input that answers a reading in its own row is asked
//! at any weight. A wrong reading may lead a fit far off, so that it begins anew from the values as given. It is asked once
//! more beside what was found. Where something larger is missing that hides the reading, the search finds what resembles
//! it beside that, a delay or a resonance: held inputs take its place if they fit as well, with fewer unknowns.
//!
//! # References
//! G. F. Franklin, J. D. Powell, M. Workman, Digital Control of Dynamic Systems, 3rd ed. (1998), 4.3 (a hold delays by
//! half a sample).

use super::answer::{DataFault, Evidence, Finding, INPUT_HOLD, SiteName};
use super::backward::without;
use super::bench::{self, Bench, Stand};
use super::catalogue::{self, Proposal, SiteKind};
use super::choose::{CHANCE, TIE, worth_of};
use super::compared::{anew, same_tracks};
use super::feedback;
use super::measure::{Measure, Scale};
use super::propose::difference;
use super::screen::Screen;
use super::search::{Found, Taken};
use super::view::own_tracks;
use crate::Result;
use crate::estimate::Fit;
use crate::model::Model;
use crate::record::quality::wrapped_angle;
use crate::record::{Channel, Hold, Recording, looks_held, may_be_held};

/// How far a weight may lie from 1, and its standard deviation: a delay has any weight, and what leaves it so open
/// that it may be 1 by luck settles nothing.
const FROM_ONE: (f64, f64) = (0.15, 0.06);
/// How far a weight, or a delay or a lag over half a sample, may lie from 1 beside something large: the likelihood
/// decides then.
const ABOUT: f64 = 0.5;
/// From which weight on an input is nearer to one that is held.
const NEARER: f64 = 0.5;
/// Standard deviations up to which a weight may be 1, which is told.
const OPEN: f64 = 3.0;
/// Standard deviations from which on a weight is not 0.
const SURELY: f64 = 5.0;
/// A standard deviation beyond which the reading makes no difference.
const BLIND: f64 = 0.5;

/// What was settled.
pub struct Settled {
    /// The model fitted with the inputs as they are read.
    pub fit: Fit,
    /// Inputs that are held.
    pub held: Vec<DataFault>,
    /// Straight inputs that may be held.
    pub open: Vec<String>,
    /// How they were read before, where the look of an input decided: what is missing may have deceived it.
    pub before: Option<Box<Before>>,
}

/// Recordings, fitted and separate, with inputs as they were read, and the model fitted to that.
pub struct Before {
    recordings: Vec<Recording>,
    separate: Vec<Recording>,
    fit: Fit,
}

impl Before {
    /// Whether a model that something was found for is likelier with inputs as they were read before.
    pub fn is_likelier(&self, bench: &Bench, last: &Fit) -> bool {
        let other = Bench { recordings: self.recordings.clone(), ..bench.clone() };
        gain(&other, last).is_some_and(|gain| gain > 0.0)
    }

    /// Reads inputs as before, where that fits better beside what was found, or as well where that shifts something in time,
    /// as half a sample would: the model as given, fitted so.
    pub fn returns(self, bench: &mut Bench, separate: &mut Vec<Recording>, found: &Found) -> Option<Fit> {
        let other = Bench { recordings: self.recordings, ..bench.clone() };
        let least = if may_stand_for_a_hold(found) { -TIE } else { 0.0 };
        (gain(&other, &found.last)? > least).then(|| {
            bench.recordings = other.recordings;
            *separate = self.separate;
            self.fit
        })
    }
}

/// Settles how the inputs of a fitted model are read: by their looks too, for less where that is asked once more later.
///
/// # Errors
/// Where the model cannot be fitted to what was settled.
pub fn settle(
    bench: &mut Bench,
    separate: &mut [Recording],
    base: Fit,
    given: Option<&Model>,
) -> Result<Settled> {
    let is_asked_again = given.is_some();
    let weights = straight_ones(bench, &base).unwrap_or_default();
    let answering = feedback::answering(&bench.recordings, &base, Hold::Linear);
    let answers = |name: &String| answering.iter().any(|a| a.0 == *name);
    // where nothing is searched for that could show it later, a leap or two are enough to ask the likelihood
    let stays = if is_asked_again { looks_held } else { may_be_held };
    let looks = |w: &Weight| {
        w.held > NEARER && (w.is_not_straight() || is_so_everywhere(bench, &w.name, stays))
            || answers(&w.name)
    };
    let (shown, open): (Vec<Weight>, Vec<Weight>) =
        weights.into_iter().partition(|w| w.is_sure() || looks(w));
    let open: Vec<String> = open.into_iter().filter(Weight::may_be).map(|w| w.name).collect();
    let least = if shown.iter().any(Weight::is_sure) || !is_asked_again { TIE } else { 0.0 };
    let is_doubtful = !shown.iter().all(Weight::is_sure);
    let held: Vec<String> = shown.into_iter().map(|w| w.name).collect();
    if held.is_empty() {
        return Ok(Settled { fit: base, held: Vec::new(), open, before: None });
    }
    let straight = bench.recordings.clone();
    read_held(&mut bench.recordings, &held);
    let scale = Scale::of(&base, false);
    let fit = refitted(bench, &base, given)?;
    let (before, after) = (Measure::of(&base, &scale), Measure::of(&fit, &scale));
    if after.likelihood - before.likelihood < least {
        bench.recordings = straight;
        return Ok(Settled { fit: base, held: Vec::new(), open, before: None });
    }
    let before_all = || Before { recordings: straight, separate: separate.to_vec(), fit: base };
    let settled_by_looks = is_doubtful.then(|| Box::new(before_all()));
    read_held(separate, &held);
    let held = faults(held, (&after, &before));
    Ok(Settled { fit, held, open, before: settled_by_looks })
}

/// The base fitted anew, or the model as given where that ends at a better place: a wrong reading may have led far off.
fn refitted(bench: &Bench, base: &Fit, given: Option<&Model>) -> Result<Fit> {
    let near = anew(bench, base)?;
    let Some(far) = given.and_then(|model| bench.full_fit(model).ok()) else { return Ok(near) };
    let scale = Scale::of(&near, false);
    Ok(if scale.squares(&far) < scale.squares(&near) { far } else { near })
}

/// The inputs of a fitted model that the recordings show to be held between their samples though they are read as straight
/// lines.
pub fn held_inputs(fit: &Fit, recordings: &[Recording], separate_holdout: bool, seed: u64) -> Vec<String> {
    let mut bench = Bench::new(&fit.model, recordings.to_vec(), separate_holdout, seed);
    let settled = settle(&mut bench, &mut [], fit.clone(), None).ok();
    // an angle that jumps by a turn runs straight through all of it, which looks like nothing
    let jumps = |n: &String| recordings.iter().filter_map(|r| r.find(n)).any(|c| wrapped_angle(c).is_some());
    let held = settled.into_iter().flat_map(|s| s.held).map(|h| h.finding.site.name);
    held.filter(|name| !jumps(name)).collect()
}

/// Inputs that are held, by how good the model is with them and with straight ones.
fn faults(names: Vec<String>, (held, straight): (&Measure, &Measure)) -> Vec<DataFault> {
    let evidence = evidence(held, straight, names.len());
    names.into_iter().map(|name| told(name, &evidence, &[])).collect()
}

/// Whether something was found that half a sample would look like, or is left.
pub fn may_hide_a_hold(found: &Found) -> bool {
    may_stand_for_a_hold(found) || found.rest.p_value < CHANCE
}

/// Whether something was found that half a sample would look like.
fn may_stand_for_a_hold(found: &Found) -> bool {
    let alike = ["extra-resonance", "extra-lag", "neglected-inertia"];
    let is = |t: &Taken| {
        alike.contains(&t.proposal.code) || catalogue::find(t.proposal.code).is_ok_and(|m| m.shifts_time)
    };
    found.taken.iter().any(is)
}

/// The inputs that what is left beside findings shows to be held.
pub fn shown_beside(bench: &Bench, found: &Found) -> Vec<String> {
    if found.taken.is_empty() || found.rest.p_value >= CHANCE {
        return Vec::new();
    }
    let weights = straight_ones(bench, &found.last).unwrap_or_default();
    let shows = |w: &Weight| w.is_sure() || w.held > NEARER && w.is_not_straight();
    weights.into_iter().filter(shows).map(|w| w.name).collect()
}

/// Whether what was found fits as well with inputs as a bench reads them.
pub fn fits_as_well(bench: &Bench, found: &Found) -> bool {
    gain(bench, &found.last).is_some_and(|gain| gain > -TIE)
}

/// By how much a fitted model is likelier, in log-likelihood, with inputs as a bench reads them.
fn gain(bench: &Bench, last: &Fit) -> Option<f64> {
    let scale = Scale::of(last, false);
    let other = anew(bench, last).ok()?;
    let [other, last] = [&other, last].map(|fit| Measure::of(fit, &scale).likelihood);
    Some(other - last)
}

/// The inputs as held, where what is found with them is the likelier for the price of its parameters, and does not make them
/// earlier again.
pub fn likelier(names: &[String], held: &Found, straight: &Found) -> Vec<DataFault> {
    let scale = Scale::of(&straight.last, false);
    let is_early = held.taken.iter().any(|t| t.proposal.code == "clock-offset");
    if is_early || held.worth(&scale) <= straight.worth(&scale) + TIE {
        return Vec::new();
    }
    let [held, straight] = [held, straight].map(|f| Measure::of(&f.last, &scale));
    faults(names.to_vec(), (&held, &straight))
}

/// What speaks for so many held inputs over straight ones.
fn evidence(held: &Measure, straight: &Measure, degrees: usize) -> Evidence {
    Evidence {
        log_likelihood_ratio: held.likelihood - straight.likelihood,
        degrees,
        p_value: held.chance_over(straight.likelihood, degrees),
        holdout_share: f64::NAN,
    }
}

/// Inputs in whose place something was found: the model without it shows them held, or it is late by half a sample;
/// held and without it, they fit as well. Such are read as held from here on.
pub fn in_place_of_findings(bench: &mut Bench, separate: &mut [Recording], found: &Found) -> Vec<DataFault> {
    let scale = Scale::of(&found.last, found.scale.trials);
    let last = Measure::of(&found.last, &scale);
    let steps = bench.steps(&found.last.model);
    for (i, t) in found.taken.iter().enumerate() {
        let without = |bench: &Bench| without(bench, &found.last, &t.proposal, steps);
        let fit = found.without.get(i).and_then(Option::as_ref).map(|w| &w.0);
        let weights = fit.and_then(|fit| straight_ones(bench, fit)).unwrap_or_default();
        let shown = weights.into_iter().filter(|w| (w.held - 1.0).abs() <= ABOUT).map(|w| w.name);
        let shown = Some(shown.collect()).filter(|names: &Vec<String>| !names.is_empty());
        let Some(names) = shown.or_else(|| half_a_sample(bench, &found.last, &t.proposal)) else { continue };
        let mut other = bench.clone();
        read_held(&mut other.recordings, &names);
        let (Some(held), Some(straight)) = (without(&other), without(bench)) else { continue };
        let [held, straight] = [held, straight].map(|fit| Measure::of(&fit, &scale));
        if held.likelihood < worth_of(&t.proposal, &last) - TIE {
            continue;
        }
        read_held(&mut bench.recordings, &names);
        read_held(separate, &names);
        let evidence = evidence(&held, &straight, names.len());
        let alike = held.likelihood < last.likelihood + TIE;
        let ties: Vec<String> = alike.then(|| t.proposal.code.to_owned()).into_iter().collect();
        return names.into_iter().map(|name| told(name, &evidence, &ties)).collect();
    }
    Vec::new()
}

/// The inputs that a delay or a lag of about half their sample may stand for, if they are read straight.
fn half_a_sample(bench: &Bench, last: &Fit, late: &Proposal) -> Option<Vec<String>> {
    let names: Vec<String> = match (late.code, late.site.kind) {
        ("input-delay" | "input-lag", SiteKind::Input) => vec![late.site.name.clone()],
        ("output-delay" | "output-lag", SiteKind::Output) => {
            measured(&last.model).map(String::clone).collect()
        }
        _ => return None,
    };
    let time = last.parameters.iter().find(|e| e.name == late.added[0].name)?.value;
    let half = |name: &String| {
        let mut channels = bench.recordings.iter().map(|r| r.find(name));
        channels.all(|c| {
            let straight = c.filter(|c| c.hold == Hold::Linear);
            let step = straight.and_then(Channel::median_step).unwrap_or(f64::NAN);
            (time / (0.5 * step) - 1.0).abs() <= ABOUT
        })
    };
    (!names.is_empty() && names.iter().all(half)).then_some(names)
}

/// Inputs that somebody recorded; how a simulation runs between its samples is no question of the data.
pub fn measured(model: &Model) -> impl Iterator<Item = &String> {
    model.inputs.iter().map(|i| &i.name).filter(|n| !model.is_simulated(n))
}

/// How far the residual shows an input to be held, from 0 for straight to 1, and the standard deviation.
pub struct Weight {
    /// The input.
    pub name: String,
    held: f64,
    deviation: f64,
}

impl Weight {
    /// Whether it is held for sure.
    fn is_sure(&self) -> bool {
        (self.held - 1.0).abs() <= FROM_ONE.0 && self.deviation <= FROM_ONE.1
    }

    /// Whether it may be held and surely does not run straight.
    fn is_not_straight(&self) -> bool {
        self.may_be() && self.held > SURELY * self.deviation
    }

    /// Whether it is rather read otherwise than not, where its looks speak for that too.
    pub fn is_rather(&self) -> bool {
        self.may_be() && self.held > NEARER.max(OPEN * self.deviation)
    }

    /// Whether it may be held.
    fn may_be(&self) -> bool {
        self.deviation < BLIND && (self.held - 1.0).abs() <= OPEN * self.deviation
    }
}

/// What a reader should know of an input that may be held.
pub fn note(name: &str) -> String {
    format!(
        "{name} is read as straight lines between its samples; held, it would fit as well: say `hold = \"previous\"` if it is a command that is held"
    )
}

/// What a reader should know of an input that was read as held by its looks alone.
pub fn looks(name: &str) -> String {
    format!(
        "{name} stays and leaps, and is read as held between its samples; straight lines would fit as well: say `hold = \"previous\"` if it is a command that is held"
    )
}

/// Whether a model is the likelier for an input that is held.
pub fn is_likelier(fault: &DataFault) -> bool {
    fault.finding.evidence.as_ref().is_none_or(|e| e.log_likelihood_ratio > TIE)
}

/// Whether an input stays and leaps in every recording.
fn is_so_everywhere(bench: &Bench, name: &str, stays: fn(&[f64]) -> bool) -> bool {
    bench.recordings.iter().all(|r| r.find(name).is_some_and(|c| stays(&c.values)))
}

/// How far the residual shows each straight input to be held.
fn straight_ones(bench: &Bench, base: &Fit) -> Option<Vec<Weight>> {
    let straight = |name: &&String| {
        let mut channels = bench.recordings.iter().map(|r| r.find(name));
        bench.moves(name) && channels.all(|c| c.is_some_and(|c| c.hold == Hold::Linear))
    };
    weighed(bench, base, measured(&base.model).filter(straight).collect(), read_held)
}

/// How far the residual shows inputs to be read in another way, from 0 for as they are to 1.
pub fn weighed(
    bench: &Bench,
    base: &Fit,
    names: Vec<&String>,
    read: impl Fn(&mut [Recording], &[String]),
) -> Option<Vec<Weight>> {
    if bench.is_trials() || base.model.states.is_empty() || names.is_empty() {
        return None;
    }
    let (stand, tolerance) = (Stand::of(base), bench.rough(base));
    let run = |bench: &Bench| {
        let records = bench.ready(&base.model, base.starts(), (tolerance, Vec::new())).ok()?;
        bench::run(&records, &stand, &[]).ok()
    };
    let plain = run(bench)?;
    let screen = Screen::new(&own_tracks(base, &plain).ok()?, &base.noise, None);
    let mut seen = Vec::new();
    let mut directions = Vec::new();
    for name in names {
        let mut other = bench.clone();
        read(&mut other.recordings, std::slice::from_ref(name));
        let tracks = run(&other).filter(|t| same_tracks(t, &plain))?;
        let direction = screen.whitened(&difference(&plain, &tracks), |t| &t.residual);
        if direction.iter().all(|d| d.is_finite()) && direction.iter().any(|d| *d != 0.0) {
            seen.push(name);
            directions.push(direction);
        }
    }
    let solved = screen.solve(&directions)?;
    let weights = solved.weights.iter().zip(&solved.deviations);
    let of = |(name, (held, deviation)): (&String, (&f64, &f64))| Weight {
        name: name.clone(),
        held: *held,
        deviation: *deviation,
    };
    Some(seen.into_iter().zip(weights).map(of).collect())
}

/// Reads inputs as held.
pub fn read_held(recordings: &mut [Recording], names: &[String]) {
    let channels = recordings.iter_mut().flat_map(|r| &mut r.channels);
    channels.filter(|c| names.contains(&c.name)).for_each(|c| c.hold = Hold::Previous);
}

/// What is said of an input that is held.
pub fn says(name: &str) -> String {
    format!(
        "{name} is held between its samples, and was read so: write `hold = \"previous\"` at its channel in the recording's TOML file"
    )
}

fn told(name: String, evidence: &Evidence, ties: &[String]) -> DataFault {
    let says = says(&name);
    let finding = Finding {
        code: INPUT_HOLD.into(),
        site: SiteName { kind: "input".into(), name },
        term: "held between samples".into(),
        says,
        parameters: Vec::new(),
        p_value: evidence.p_value,
        share: 0.0,
        ties: ties.to_vec(),
        resembles: false,
        evidence: Some(evidence.clone()),
    };
    DataFault { finding, masked: true }
}
