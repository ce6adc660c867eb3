//! From the outcome of the search to the answer.

use super::answer::{
    Answer, DataFault, Detection, InputFile, Made, ParameterChange, Proof, SCHEMA, Verdict, Visible,
};
use super::bench::Bench;
use super::carried::{PARTED, carries, settled, together};
use super::choose::{SURE, floor};
use super::faults::{self, Spoiled};
use super::feedback;
use super::few::Few;
use super::innovations::Unlike;
use super::located::{Mismatch, site_name};
use super::nameless::Nameless;
use super::paragraph::Paragraph;
use super::propose::Screened;
use super::prove::{self, Held};
use super::rest::{self, Rest};
use super::search::Found;
use super::verdict::{
    Evidence, Proven, carried_over, in_a_loop, missed, settle, with_faults, with_noise, with_patches,
};
use super::view::View;
use super::{Diagnosis, Request, answer, inert, innovations, locate, moments, next, pictures, wandering};
use crate::Result;
use crate::estimate::Fit;
use crate::estimate::noise::NoiseModel;
use crate::record::Recording;
use crate::simulate::Early;
use std::sync::OnceLock;

/// Share of what a mechanism moves up to which the fitted parameters take it up: what is left of it then is that of runs.
const TAKEN_UP: f64 = 0.01;
/// Mechanisms whose smallest visible size is told.
const VISIBLE: usize = 12;
/// Standard deviations from which on an effect would have been named.
const SEEN: f64 = 4.5;
/// Sizes of so many times the term that an effect stands beside are told: what is larger is no such thing any more, and what
/// is smaller has run away in a form that grows without bounds.
const TOLD: std::ops::Range<f64> = 1e-9..3.0;

/// Everything that the answer is made of.
pub struct Assembly<'a> {
    /// The request.
    pub request: &'a Request<'a>,
    /// The fitted recordings.
    pub bench: Bench,
    /// Held-out records, faults masked.
    pub separate: Vec<Recording>,
    /// What the search found.
    pub found: Found,
    /// Faults of the data.
    pub faults: Vec<DataFault>,
    /// Those of them that lie in samples.
    pub spoiled: Vec<Spoiled>,
    /// Whether they leave anything to compare.
    pub is_left: bool,
    /// Whether too few samples are left for any test, and why.
    pub few: Option<Few>,
    /// Whether they leave too little to tell anything.
    pub is_open: bool,
    /// What a reader should know.
    pub notes: Vec<String>,
    /// What ended the search before it was through.
    pub ended_early: Option<Early>,
    /// What is held out, once it is asked for, of the model as given fitted to all.
    pub joint: OnceLock<Option<Vec<Held>>>,
}

/// The size from which on an effect of one direction d would have been named: it stands out of the noise, and it makes so much of
/// the error that leaving it out counts, a² |d|² = (e^floor − 1) |r|².
fn shows_from(s: &Screened) -> f64 {
    let deviation = s.score.weights[0].abs() / s.score.chi2.sqrt();
    let (weight, share) = match s.weights.first() {
        Some(w) if s.explained > 0.0 => (*w, s.explained),
        _ => (s.score.weights[0], s.visible),
    };
    let counts = weight.abs() * (floor(0.0).exp_m1() / share).sqrt();
    (SEEN * deviation).max(counts)
}

impl Assembly<'_> {
    /// The diagnosis.
    pub fn finish(mut self) -> Result<Diagnosis> {
        let budget = self.bench.budget.clone();
        budget.begin("each finding left out");
        let smaller = self.smaller();
        self.ended_early = self.bench.budget.cut();
        self.bench.budget.lift_time();
        budget.begin("what is left");
        let (first_rest, rest) = self.rests()?;
        budget.begin("proof");
        let (before, after) = prove::both(&self.bench, &self.found, &self.separate);
        let blind = self.blind(&after);
        let evidence = Evidence {
            found: &self.found,
            rest: &rest,
            blind: blind.as_deref(),
            is_adrift: self.is_adrift(),
        };
        let left = rest.is_left();
        let mut findings = self.findings(smaller, &before, &after);
        findings.sort_by(|a, b| b.share.total_cmp(&a.share));
        let proof = self.proof(&before, &after);
        let nameless = self.nameless(evidence.verdict());
        let odd = nameless.says(&self.request.model.outputs, &self.found.last.rmse);
        let physics = with_noise(evidence.verdict(), nameless.unlike.as_ref(), nameless.driven().is_some());
        let physics = settle(physics, &findings, &self.found);
        let held_out: usize = before.iter().map(Held::samples).sum();
        let coloured =
            |n: &NoiseModel| (n.autoregression.variance() / n.autoregression.innovation_variance()).sqrt();
        let coloured: Vec<f64> = self.found.last.noise.iter().map(coloured).collect();
        // rows of a table of trials are no neighbours
        let loudness = |h: Held| h.loudness().filter(|_| !self.bench.is_trials());
        let louder = |(h, n): (&Held, &NoiseModel)| loudness(h.whitened(n)).map_or(1.0, |l| l.max(1.0));
        let louder: Vec<f64> = after.iter().zip(&self.found.last.noise).map(louder).collect();
        let proven = Proven {
            proof: &proof,
            louder: &louder,
            samples: held_out,
            falls_whitened: self.falls_whitened(&before, &after),
            coloured: &coloured,
            is_left: left && (rest.p_value < SURE || self.bench.is_trials()),
            trials: self.bench.is_trials(),
        };
        let physics = proven.settle(with_patches(physics, &findings, &rest));
        let is_carried = !physics.has_names() || carries(&self.bench, &self.found, &self.separate);
        let physics = carried_over(physics, is_carried);
        // a law that is left goes with the input as well
        let closed = (!left && !self.bench.is_trials())
            .then(|| feedback::of(&self.bench.recordings, &self.found.last))
            .flatten();
        let physics = in_a_loop(physics, closed.is_some());
        let unfinished = self.ended_early.filter(|_| physics == Verdict::NothingMissing).map(unfinished);
        let physics = if unfinished.is_some() { Verdict::NotIdentifiable } else { physics };
        let reason = unfinished.as_deref().or(blind.as_deref()).or(odd.as_deref());
        let verdict = with_faults(physics, &self.faults, self.is_open(physics, &proof));
        let next = || next::experiment(self.request.model, &self.bench, &self.found, verdict, reason);
        let next_experiment = match (&nameless.unlike, &self.found.fallen) {
            _ if unfinished.is_some() => Some(next::PATIENCE.to_string()),
            (None, None) if nameless.driven().is_some() => nameless.driven().map(next::still),
            (_, Some(fallen)) if verdict == Verdict::Unknown => Some(next::wider(fallen)),
            (Some(Unlike::Steps(k, _) | Unlike::Strays(k, _)), _) => {
                Some(next::second_sensor(&self.request.model.outputs[*k].name))
            }
            _ => next(),
        };
        let paragraph = Paragraph {
            model: self.request.model,
            found: &self.found,
            verdicts: (physics, verdict),
            findings: &findings,
            faults: &self.faults,
            proof: &proof,
            blind: reason,
            is_held_out: held_out > 0,
            odd: odd.as_deref(),
            is_cut: self.ended_early.is_some(),
            rest: Some(&rest).filter(|_| left),
            wanders: nameless.wanders.is_some(),
        };
        let says = paragraph.text();
        let mismatch = Mismatch {
            model: self.request.model,
            found: &self.found,
            rest: first_rest.as_ref().unwrap_or(&rest),
            left: Some(&rest).filter(|_| left),
            stepping: nameless.unlike.as_ref().and_then(Unlike::output),
            faults: &self.faults,
            spoiled: &self.spoiled,
            recordings: self.given(),
        };
        let mut located = mismatch.located(physics, verdict);
        if let Some(state) = nameless.driven() {
            located.sites = vec![answer::SiteName { kind: "state".into(), name: state.into() }];
        }
        if verdict == Verdict::DataFault {
            findings = self.faults.iter().map(|f| f.finding.clone()).chain(findings).collect();
        }
        let answer = Answer {
            schema: SCHEMA,
            verdict,
            says,
            detection: self.detection(nameless.unlike.as_ref().map_or(1.0, Unlike::p_value)),
            located,
            findings,
            faults: self.faults.clone(),
            unexplained: if left { rest.unexplained() } else { None },
            notes: self.notes(
                held_out,
                missed(verdict, &proof)
                    .into_iter()
                    .chain(nameless.beside())
                    .chain(closed.map(|l| l.says()))
                    .chain((!is_carried).then(|| PARTED.to_string())),
            ),
            proof,
            next_experiment,
            parameters: self.parameters(),
            made: self.made(),
        };
        budget.begin("pictures");
        let pictures = pictures::gather(&self);
        let tidy = inert::tidied(self.found.last.model.clone(), self.request.model.parameters.len());
        Ok(Diagnosis {
            answer,
            pictures,
            before: self.found.base,
            after: Fit { model: inert::settled(tidy, &self.found.taken), ..self.found.last },
            held: (before, after),
            recordings: self.bench.recordings,
        })
    }

    /// What of what is left no law explains, for the verdict of the laws alone.
    fn nameless(&self, verdict: Verdict) -> Nameless {
        let found = &self.found;
        // Without a name a sure step in time leads farther than a signal that follows it.
        let unlike = match verdict {
            Verdict::NothingMissing => self.unlike_noise(),
            Verdict::Unknown if found.taken.is_empty() && found.fallen.is_none() => {
                self.unlike_noise().filter(Unlike::is_step)
            }
            _ => None,
        };
        let is_bare = found.taken.is_empty() && self.is_left && self.few.is_none();
        let wanders = is_bare.then(|| wandering::told(&self.bench, &found.last)).flatten();
        let is_all = verdict == Verdict::NothingMissing && found.is_sure_trace() && unlike.is_none();
        let is_clean = self.faults.iter().all(DataFault::is_reading) && self.ended_early.is_none();
        Nameless { unlike, wanders, is_all: is_all && is_clean }
    }

    /// Whether the model as given, fitted, misses an output by more than that moves.
    fn is_adrift(&self) -> bool {
        let base = &self.found.base;
        let mut misses = base.model.outputs.iter().zip(&base.rmse);
        misses.any(|(o, rmse)| *rmse > self.bench.spread(&o.name))
    }

    /// Whether what the last model leaves is no noise.
    fn unlike_noise(&self) -> Option<Unlike> {
        let of = |held: &[Held]| innovations::unlike_noise(&self.bench, &self.found.last, held);
        let near = settled(&self.bench, &self.found.last, &self.separate).unwrap_or_default();
        let joint = || self.joint().map(|held| of(held));
        match of(&near) {
            Some(odd) if odd.is_step() => joint().unwrap_or(Some(odd)),
            seen => seen,
        }
    }

    /// What is held out by the model as given fitted to all, where the fitted part bears that.
    fn joint(&self) -> Option<&Vec<Held>> {
        let asks = self.found.taken.is_empty() && self.found.base.ended_early.is_none();
        let found = || together(&self.bench, self.request.model, &self.found.base);
        self.joint.get_or_init(|| if asks { found() } else { None }).as_ref()
    }

    /// The recordings as they were given, fitted and separate.
    fn given(&self) -> Vec<&Recording> {
        self.request.recordings.iter().chain(self.request.separate).collect()
    }

    /// Whether the faults leave the question open: nothing is left to compare, or what is left cannot tell
    /// because they took much of it.
    fn is_open(&self, physics: Verdict, proof: &[Proof]) -> bool {
        let given = self.given();
        let is_few = self.few.as_ref().is_some_and(|f| f.is_anyway);
        let heavy = || !is_few && self.spoiled.iter().any(|s| faults::is_heavy(&given, s));
        let unproved = proof.iter().all(|p| !p.holdout_after.is_finite());
        self.is_open || heavy() && (physics == Verdict::NotIdentifiable || unproved)
    }

    /// Why the recording cannot tell, if so.
    fn blind(&self, after: &[Held]) -> Option<String> {
        if !self.is_left {
            return Some("no sample is left to compare".into());
        }
        if let Some(few) = &self.few {
            return Some(few.says.clone());
        }
        let (model, base) = (self.request.model, &self.found.base);
        let alone = || {
            let unseen = || locate::unseen(model, base);
            let apart = || self.joint().is_none_or(|held| locate::astray(base, held).is_some());
            let astray = || locate::astray(base, after).filter(|_| apart());
            // What fits where it is fitted and cannot be run beyond says why what is held out is not explained.
            let astray = || astray().filter(|_| self.found.fallen.is_none());
            let reason = locate::mute(model, &self.bench, base).or_else(unseen).or_else(astray);
            reason.filter(|_| self.found.taken.is_empty())
        };
        locate::poor(model, &self.bench)
            .or_else(|| locate::starved(model, &self.bench, &self.found.last, &self.separate, after))
            .or_else(alone)
    }

    /// Flexible laws in what the first model leaves, where something was added to it, and the last; none where
    /// nothing is left to compare, or the time was up before anything was found.
    fn rests(&self) -> Result<(Option<Rest>, Rest)> {
        let is_over = self.ended_early == Some(Early::Time);
        if !self.is_left || self.few.is_some() || self.found.taken.is_empty() && is_over {
            return Ok((None, Rest { laws: Vec::new(), p_value: 1.0 }));
        }
        let look = |fit: &Fit, when: &str| -> Result<Rest> {
            let view = View::of(&self.bench, fit)?;
            let scene = self.bench.scene(&fit.model, &view.stand)?;
            let rest = rest::look(&self.bench, &scene, &view);
            rest.trace(when);
            Ok(rest)
        };
        if self.found.taken.is_empty() {
            return Ok((None, look(&self.found.base, "before")?));
        }
        let (first, last) =
            rayon::join(|| look(&self.found.base, "before"), || look(&self.found.last, "after"));
        Ok((Some(first?), last?))
    }

    fn proof(&self, before: &[Held], after: &[Held]) -> Vec<Proof> {
        let (base, last) = (&self.found.base, &self.found.last);
        let outputs = self.request.model.outputs.iter().enumerate();
        outputs
            .map(|(k, o)| {
                let unit = o.unit.of_differences();
                let shown = |x: f64| unit.difference_from_si(x);
                let (low, high) = before[k].fall(&after[k], self.request.seed);
                Proof {
                    output: o.name.clone(),
                    unit: unit.text().to_string(),
                    metric: "rmse",
                    mode: "free-run",
                    fit_before: shown(base.rmse[k]),
                    fit_after: shown(last.rmse[k]),
                    holdout_before: shown(before[k].rmse()),
                    holdout_after: shown(after[k].rmse()),
                    improvement_low: shown(low),
                    improvement_high: shown(high),
                    noise_floor: shown(last.noise[k].autoregression.variance().sqrt()),
                }
            })
            .collect()
    }

    /// Whether the held-out innovations of an output fall for sure, by the noise of the last fit.
    fn falls_whitened(&self, before: &[Held], after: &[Held]) -> bool {
        let noise = &self.found.last.noise;
        let falls = |k: usize| {
            let whitened = |held: &[Held]| held[k].whitened(&noise[k]);
            whitened(before).fall(&whitened(after), self.request.seed).0 > 0.0
        };
        !self.bench.is_trials() && (0..noise.len()).any(falls)
    }

    /// What was detected, beside a residual that is no noise by some chance.
    fn detection(&self, unlike: f64) -> Detection {
        let found = self.found.taken.iter().map(|t| t.p_value).fold(unlike, f64::min);
        let found = self.found.fallen.as_ref().map_or(found, |f| f.p_value.min(found));
        let mut visible: Vec<Visible> = Vec::new();
        for s in &self.found.rest.screened {
            let p = &s.proposal;
            let single = p.amplitudes.len() == 1 && s.score.degrees == 1 && s.score.chi2 > 0.0;
            let is_apart = s.score.apart > TAKEN_UP;
            if !single || !is_apart || visible.iter().any(|v| v.code == p.code) || visible.len() >= VISIBLE {
                continue;
            }
            let a = &p.added[p.amplitudes[0]];
            let size = shows_from(s);
            if !TOLD.contains(&(size / s.start[p.amplitudes[0]].abs())) {
                continue;
            }
            visible.push(Visible {
                code: p.code.to_string(),
                site: site_name(&p.site),
                parameter: a.name.clone(),
                value: a.unit.difference_from_si(size),
                unit: a.unit.text().to_string(),
            });
        }
        Detection { p_value: self.found.first.p_value.min(found), smallest_visible: visible }
    }

    fn parameters(&self) -> Vec<ParameterChange> {
        let before = &self.found.base.parameters;
        let after = &self.found.last.parameters;
        let moved = before.iter().zip(&self.request.model.parameters).filter(|(_, p)| p.fit);
        moved
            .filter_map(|(b, _)| {
                let a = after.iter().find(|a| a.name == b.name)?;
                let shown = |x: f64| a.unit.from_si(x);
                Some(ParameterChange {
                    name: b.name.clone(),
                    before: shown(b.value),
                    after: shown(a.value),
                    low: shown(a.low),
                    high: shown(a.high),
                    unit: a.unit.text().to_string(),
                })
            })
            .collect()
    }

    /// What a reader should know: what was not compared, what ended at a bound, what was left unfinished.
    fn notes(&self, held_out: usize, told: impl Iterator<Item = String>) -> Vec<String> {
        // what was found explains how the model without it was fitted
        let fit = if self.found.taken.is_empty() { &self.found.base } else { &self.found.last };
        let warnings = fit.warnings.iter().map(|w| w.message.clone());
        let mut all: Vec<String> = self.ended_early.map(unfinished).into_iter().chain(told).collect();
        if self.is_left && held_out == 0 {
            all.push(NOT_HELD_OUT.into());
        }
        let anew = moments::note(&self.bench, &self.found.last, &self.separate);
        let told = self.notes.iter().chain(&self.found.notes).chain(&self.found.small).cloned().chain(anew);
        for note in told.chain(warnings) {
            if !all.contains(&note) {
                all.push(note);
            }
        }
        all
    }

    fn made(&self) -> Made {
        let recordings = self.request.recordings.iter().chain(self.request.separate);
        let files = self.request.source.into_iter().chain(recordings.flat_map(|r| &r.sources));
        Made {
            program: concat!("gyrospec ", env!("CARGO_PKG_VERSION")).to_string(),
            seed: self.request.seed,
            ended_early: self.ended_early,
            inputs: files
                .map(|s| InputFile { file: s.file.display().to_string(), sha256: s.sha256.clone() })
                .collect(),
        }
    }
}

/// That nothing could be held out.
const NOT_HELD_OUT: &str = "nothing was held out, so that all this is the word of the fitted part alone: give spans to hold out, or another recording by --holdout";

/// That the search was not through, and why.
fn unfinished(early: Early) -> String {
    format!("the search ended early, with the best so far: {}", early.words())
}
