//! From the outcome of the search to the answer.

use super::answer::{
    Answer, Detection, Finding, InputFile, Located, Made, ParameterChange, Proof, SignalChance, SiteName,
    Unexplained, Value, Verdict, Visible, told,
};
use super::bench::Bench;
use super::catalogue::Proposal;
use super::propose::View;
use super::prove::{self, Held};
use super::rest::{self, Rest};
use super::search::{self, Found, Taken};
use super::verdict::{Evidence, proved, settle};
use super::{Diagnosis, Request, locate, next, pictures, words};
use crate::Result;
use crate::estimate::Fit;
use crate::record::Recording;
use crate::record::quality::Fault;

/// Mechanisms whose smallest visible size is told.
const VISIBLE: usize = 12;
/// Standard deviations from which on an effect would have been named.
const SEEN: f64 = 4.5;
/// Sizes beyond so many times the term that an effect stands beside are not told.
const FAR: f64 = 3.0;

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
    pub faults: Vec<Finding>,
}

impl Assembly<'_> {
    /// The diagnosis; `spoiled` are the faults that were masked, for their pictures.
    pub fn finish(self, spoiled: &[Fault]) -> Result<Diagnosis> {
        let (before_rest, rest) = self.rests()?;
        let before = prove::held_out(&self.bench, &self.found.base, &self.separate)?;
        let after = if self.found.taken.is_empty() {
            before.clone()
        } else {
            prove::held_out(&self.bench, &self.found.last, &self.separate)?
        };
        let blind = self.blind(&after);
        let evidence =
            Evidence { faults: &self.faults, found: &self.found, rest: &rest, blind: blind.as_deref() };
        let verdict = evidence.verdict();
        let left = evidence.is_left();
        let mut findings = self.findings(&before, &after);
        findings.sort_by(|a, b| b.share.total_cmp(&a.share));
        let verdict = settle(verdict, &findings, &self.found);
        let mut all = self.faults.clone();
        all.extend(findings);
        let proof = self.proof(&before, &after);
        let verdict =
            proved(verdict, &proof, self.falls_whitened(&before, &after), left && self.bench.is_trials());
        let next_experiment =
            next::experiment(self.request.model, &self.bench, &self.found, verdict, blind.as_deref());
        let answer = Answer {
            schema: "gyrospec.diagnosis/1",
            verdict,
            says: self.says(verdict, &all, &proof, blind.as_deref(), left.then_some(&rest)),
            detection: self.detection(),
            located: self.located(verdict, &before_rest),
            findings: all,
            unexplained: if left { unexplained(&rest) } else { None },
            proof,
            next_experiment,
            parameters: self.parameters(),
            made: self.made(),
        };
        let pictures = pictures::gather(&self, spoiled);
        Ok(Diagnosis {
            answer,
            pictures,
            before: self.found.base,
            after: self.found.last,
            held: (before, after),
            recordings: self.bench.recordings,
        })
    }

    /// Why the recording cannot tell, if so.
    fn blind(&self, after: &[Held]) -> Option<String> {
        let (model, base) = (self.request.model, &self.found.base);
        let alone = || {
            let unseen = || locate::unseen(model, base);
            let astray = || locate::astray(base, after);
            let reason = locate::mute(model, &self.bench, base).or_else(unseen).or_else(astray);
            reason.filter(|_| self.found.taken.is_empty())
        };
        locate::poor(model, &self.bench, base)
            .or_else(|| locate::starved(model, &self.bench, &self.found.last, &self.separate, after))
            .or_else(alone)
    }

    /// Flexible laws in what the first and the last model leave.
    fn rests(&self) -> Result<(Rest, Rest)> {
        let look = |fit: &Fit| -> Result<Rest> {
            let view = View::of(&self.bench, fit)?;
            let scene = self.bench.scene(&fit.model, &view.stand)?;
            Ok(rest::look(&self.bench, &scene, &view))
        };
        let first = look(&self.found.base)?;
        first.trace("before");
        if self.found.taken.is_empty() {
            return Ok((Rest { laws: Vec::new(), p_value: first.p_value }, first));
        }
        let last = look(&self.found.last)?;
        last.trace("after");
        Ok((first, last))
    }

    fn findings(&self, before: &[Held], after: &[Held]) -> Vec<Finding> {
        let gains: Vec<f64> = self.found.taken.iter().map(|t| self.loss_without(t, before, after)).collect();
        let total: f64 = gains.iter().sum();
        let even = 1.0 / gains.len().max(1) as f64;
        let share = |g: f64| if total > 0.0 { g / total } else { even };
        self.found.taken.iter().zip(gains).map(|(t, g)| self.finding(t, share(g))).collect()
    }

    /// How much the held-out error grows, relative to the improvement, when one finding is taken away.
    fn loss_without(&self, taken: &Taken, before: &[Held], after: &[Held]) -> f64 {
        if self.found.taken.len() == 1 {
            return 1.0;
        }
        let smaller = search::without(&self.bench, &self.found.last, &taken.proposal);
        let held = smaller.and_then(|f| prove::held_out(&self.bench, &f, &self.separate).ok());
        let relative = |held: &[Held]| -> f64 {
            held.iter()
                .zip(before)
                .map(|(h, b)| (h.rmse() / b.rmse()).min(1e3))
                .filter(|x| x.is_finite())
                .sum()
        };
        held.map_or(1.0, |h| (relative(&h) - relative(after)).max(1e-6))
    }

    fn finding(&self, taken: &Taken, share: f64) -> Finding {
        let fit = &self.found.last;
        let p = &taken.proposal;
        let value = |name: &str, unit: &crate::units::Unit| {
            let e = fit.parameters.iter().find(|e| e.name == name);
            let of = |x: Option<f64>| x.map_or(f64::NAN, |x| unit.difference_from_si(x));
            Value {
                name: name.to_string(),
                value: of(e.map(|e| e.value)),
                low: of(e.map(|e| e.low)),
                high: of(e.map(|e| e.high)),
                unit: unit.text().to_string(),
            }
        };
        Finding {
            code: p.code.to_string(),
            site: site(p),
            term: p.term.clone(),
            says: words::sentence(p, fit),
            parameters: p.added.iter().map(|a| value(&a.name, &a.unit)).collect(),
            p_value: taken.p_value,
            share,
            ties: taken.ties.iter().map(|t| t.code.to_string()).collect(),
        }
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

    fn detection(&self) -> Detection {
        let found = self.found.taken.iter().map(|t| t.p_value).fold(1.0, f64::min);
        let mut visible: Vec<Visible> = Vec::new();
        for s in &self.found.rest.screened {
            let p = &s.proposal;
            let single = p.amplitudes.len() == 1 && s.score.degrees == 1 && s.score.chi2 > 0.0;
            if !single || visible.iter().any(|v| v.code == p.code) || visible.len() >= VISIBLE {
                continue;
            }
            let a = &p.added[p.amplitudes[0]];
            let deviation = s.score.weights[0].abs() / s.score.chi2.sqrt();
            // Far beyond the size of the term that it stands beside it is no such thing any more.
            if SEEN * deviation > FAR * s.start[p.amplitudes[0]].abs() {
                continue;
            }
            visible.push(Visible {
                code: p.code.to_string(),
                site: site(p),
                parameter: a.name.clone(),
                value: a.unit.difference_from_si(SEEN * deviation),
                unit: a.unit.text().to_string(),
            });
        }
        Detection { p_value: self.found.first.p_value.min(found), smallest_visible: visible }
    }

    fn located(&self, verdict: Verdict, before: &Rest) -> Located {
        let mut sites: Vec<SiteName> = Vec::new();
        for t in self.found.taken.iter().take(if verdict == Verdict::NothingMissing { 0 } else { usize::MAX })
        {
            for p in std::iter::once(&t.proposal).chain(&t.ties).chain(&t.elsewhere) {
                if !sites.contains(&site(p)) {
                    sites.push(site(p));
                }
            }
        }
        for f in &self.faults {
            if !sites.contains(&f.site) {
                sites.push(f.site.clone());
            }
        }
        let mut signals: Vec<SignalChance> = Vec::new();
        for law in before.laws.iter().filter(|l| l.signals.len() == 1) {
            let p = (before.laws.len() as f64 * (-law.score.statistic).exp()).min(1.0);
            if p < 0.05 && !signals.iter().any(|s| s.name == law.signals[0]) && signals.len() < 6 {
                signals.push(SignalChance { name: law.signals[0].clone(), p_value: p });
            }
        }
        let nothing = verdict == Verdict::NothingMissing;
        let separating =
            self.found.taken.first().and_then(|t| next::separation(self.request.model, &t.proposal, &t.ties));
        Located {
            sites,
            time: if nothing { Vec::new() } else { locate::times(&self.found.base, &self.found.last) },
            bands: if nothing { Vec::new() } else { locate::bands(&self.found.base, &self.found.last) },
            signals,
            separating_measurement: separating,
        }
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

    fn made(&self) -> Made {
        let recordings = self.request.recordings.iter().chain(self.request.separate);
        let files = self.request.source.into_iter().chain(recordings.flat_map(|r| &r.sources));
        Made {
            program: concat!("gyrospec ", env!("CARGO_PKG_VERSION")).to_string(),
            seed: self.request.seed,
            inputs: files
                .map(|s| InputFile { file: s.file.display().to_string(), sha256: s.sha256.clone() })
                .collect(),
        }
    }

    fn says(
        &self,
        verdict: Verdict,
        findings: &[Finding],
        proof: &[Proof],
        blind: Option<&str>,
        rest: Option<&Rest>,
    ) -> String {
        let (faults, others) = told(findings);
        let joined = |all: &[&Finding]| all.iter().map(|f| f.says.as_str()).collect::<Vec<_>>().join("; ");
        let list = joined(&others);
        let gains: Vec<String> = proof
            .iter()
            .filter(|p| p.holdout_before.is_finite())
            .map(|p| {
                format!(
                    "On what was held out the error of “{}” is {} before and {} after.",
                    p.output,
                    words::quantity(p.holdout_before, &p.unit),
                    words::quantity(p.holdout_after, &p.unit)
                )
            })
            .collect();
        let named = |s: &String| words::signal(self.request.model, s);
        let signals = |l: &rest::Law| l.signals.iter().map(named).collect::<Vec<_>>().join(" and ");
        let law = rest.and_then(|r| r.laws.first()).map(signals).unwrap_or_default();
        let opening = match verdict {
            Verdict::NothingMissing => {
                return "Nothing is missing: what the model leaves over looks like noise in every test."
                    .into();
            }
            Verdict::Named => format!("The model leaves out: {list}."),
            Verdict::Tie => {
                let ties = findings.first().map(|f| f.ties.join(", ")).unwrap_or_default();
                let of = if others.len() > 1 { "In place of the first, " } else { "" };
                format!("The model leaves out: {list}. {of}{ties} would fit as well.")
            }
            Verdict::Unknown if list.is_empty() && law.is_empty() => {
                let nearest = self.found.first.screened.first().map_or_else(String::new, |s| {
                    format!(" Nearest in shape: {} at {}.", s.proposal.code, s.proposal.site.name)
                });
                format!(
                    "Something is missing, but nothing in the catalogue lowers the error by 2 %, too little for a name.{nearest}"
                )
            }
            Verdict::Unknown if list.is_empty() => {
                format!("Something is missing that the catalogue has no name for; it goes with {law}.")
            }
            Verdict::Unknown if law.is_empty() => format!(
                "Something is missing, but no name for it stands on what was held out. It resembles: {list}."
            ),
            Verdict::Unknown => format!(
                "Something is missing that the catalogue has no name for; it goes with {law}. It resembles: {list}."
            ),
            Verdict::DataFault if list.is_empty() => format!("The data are at fault: {}.", joined(&faults)),
            Verdict::DataFault => format!(
                "The data are at fault: {}. Beside that the model leaves out: {list}.",
                joined(&faults)
            ),
            Verdict::NotIdentifiable => {
                return format!(
                    "This recording cannot tell what is missing: {}.",
                    blind.unwrap_or("it moves too little")
                );
            }
        };
        if self.found.taken.is_empty() { opening } else { format!("{opening} {}", gains.join(" ")) }
    }
}

fn site(p: &Proposal) -> SiteName {
    SiteName { kind: p.site.kind.word().to_string(), name: p.site.name.clone() }
}

fn unexplained(rest: &Rest) -> Option<Unexplained> {
    let best = rest.laws.first()?;
    let shaped = rest.laws.iter().find(|l| !l.places.is_empty());
    let shape = shaped.map(|l| {
        let rows = l.places.iter().zip(&l.weights).zip(&l.deviations).filter(|(_, s)| s.is_finite());
        rows.map(|((x, w), s)| [*x, *w, w - 1.96 * s, w + 1.96 * s]).collect()
    });
    Some(Unexplained {
        p_value: rest.p_value,
        signal: best.signals.join(", "),
        shape: shape.unwrap_or_default(),
    })
}
