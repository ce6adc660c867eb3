//! Where the mismatch sits, as the answer tells it.

use super::answer::{DataFault, Located, SignalChance, SiteName, Spell, Verdict};
use super::catalogue::{Site, SiteKind};
use super::faults::Spoiled;
use super::rest::Rest;
use super::search::Found;
use super::{locate, next};
use crate::model::{Model, Output};
use crate::record::{Recording, Span};

/// Signals that are told.
const SIGNALS: usize = 6;
/// Difference in −ln of the chance up to which two proposals resemble the residual as well: odds of 20 to 1.
const NEAR: f64 = 3.0;
/// Chance of a signal's law below which it is told.
const CHANCE: f64 = 0.05;

/// What is to be located.
pub struct Mismatch<'a> {
    /// The model as given.
    pub model: &'a Model,
    /// The outcome of the search.
    pub found: &'a Found,
    /// Laws in what the model as given leaves.
    pub rest: &'a Rest,
    /// Laws that are left after what was found, where something is.
    pub left: Option<&'a Rest>,
    /// Number of the output whose residual steps, where nothing else tells of it.
    pub stepping: Option<usize>,
    /// What is wrong with the data.
    pub faults: &'a [DataFault],
    /// Where that sits.
    pub spoiled: &'a [Spoiled],
    /// The recordings as they were given, fitted and separate.
    pub recordings: Vec<&'a Recording>,
}

impl Mismatch<'_> {
    /// Where it sits, for the verdict on the physics and that on physics and data.
    pub fn located(&self, physics: Verdict, verdict: Verdict) -> Located {
        let mut sites = self.sites(physics);
        if verdict == Verdict::DataFault {
            let faults = self.faults.iter().filter(|f| !f.is_reading());
            sites.extend(faults.map(|f| f.finding.site.clone()));
        }
        // Where nothing is missing, or nothing could be looked for, it sits nowhere.
        let nothing = physics == Verdict::NothingMissing
            || physics == Verdict::NotIdentifiable && self.found.first.screened.is_empty();
        let (base, last) = (&self.found.base, &self.found.last);
        let output = locate::plainest(base, last);
        let separating =
            self.found.taken.first().and_then(|t| next::separation(self.model, &t.proposal, &t.ties));
        Located {
            sites: different(sites),
            time: if nothing { self.faulty(verdict) } else { locate::times(base) },
            bands: if nothing { Vec::new() } else { locate::bands(base, last, output) },
            signals: self.signals(),
            separating_measurement: separating,
        }
    }

    /// Sites of the physics: where no name says it all, first of the laws in what the model as given leaves; of what was
    /// found and fits as well; of the law that is then left; and where there is neither, of what resembles the residual most, or the output that it
    /// shows in.
    fn sites(&self, physics: Verdict) -> Vec<SiteName> {
        if physics == Verdict::NothingMissing {
            return Vec::new();
        }
        let taken = self.found.taken.iter();
        let all = taken.flat_map(|t| std::iter::once(&t.proposal).chain(&t.ties).chain(&t.elsewhere));
        let mut sites: Vec<SiteName> = all.map(|p| site_name(&p.site)).collect();
        if physics == Verdict::Unknown {
            if !sites.is_empty() {
                sites.splice(..0, self.rest.sites().into_iter().map(site_name));
            }
            sites.extend(self.found.fallen.iter().map(|f| site_name(&f.proposal.site)));
            sites.extend(self.left.iter().flat_map(|rest| rest.sites()).map(site_name));
            if sites.is_empty() {
                sites = self.stepping.map_or_else(|| self.nearest(), |k| self.output(k));
            }
        }
        sites
    }

    /// Sites of the proposals that score about as well as the best of the first round.
    fn nearest(&self) -> Vec<SiteName> {
        let screened = &self.found.first.screened;
        let top = screened.first().map_or(0.0, |s| s.score.statistic);
        let near = screened.iter().filter(|s| s.score.statistic >= top - NEAR);
        let sites: Vec<SiteName> = near.map(|s| site_name(&s.proposal.site)).collect();
        if !sites.is_empty() {
            return sites;
        }
        self.output(locate::plainest(&self.found.base, &self.found.base))
    }

    /// An output, by its number.
    fn output(&self, number: usize) -> Vec<SiteName> {
        let name = |o: &Output| SiteName { kind: SiteKind::Output.word().into(), name: o.name.clone() };
        self.model.outputs.get(number).map(name).into_iter().collect()
    }

    /// Where the faults sit that have taken the verdict; nowhere else.
    fn faulty(&self, verdict: Verdict) -> Vec<Spell> {
        if verdict != Verdict::DataFault {
            return Vec::new();
        }
        let several = self.recordings.len() > 1;
        let of = |(number, given): (usize, &&Recording)| {
            let time = |channel: &str| given.find(channel).map_or(&[][..], |c| &c.time[..]);
            let long = |s: &Spoiled| -> Vec<Span> {
                let spans = s.fault.spans.iter();
                spans.filter_map(|span| locate::long_enough(*span, time(&s.fault.channel))).collect()
            };
            let own = self.spoiled.iter().filter(|s| s.recording == number);
            let spans = locate::merged(own.flat_map(long).collect());
            let recording = several.then(|| given.name.clone());
            spans.into_iter().map(move |s| Spell { from: s.from, to: s.to, recording: recording.clone() })
        };
        self.recordings.iter().enumerate().flat_map(of).collect()
    }

    fn signals(&self) -> Vec<SignalChance> {
        let fallen = self.found.fallen.iter();
        let mut signals: Vec<SignalChance> = fallen
            .flat_map(|f| f.proposal.depends.iter().map(|s| (s.clone(), f.p_value)))
            .map(|(name, p_value)| SignalChance { name, p_value })
            .collect();
        let laws = &self.rest.laws;
        for law in laws.iter().filter(|l| l.signals.len() == 1) {
            let p = (laws.len() as f64 * (-law.score.statistic).exp()).min(1.0);
            let known = signals.iter().any(|s| s.name == law.signals[0]);
            if p < CHANCE && !known && signals.len() < SIGNALS {
                signals.push(SignalChance { name: law.signals[0].clone(), p_value: p });
            }
        }
        signals
    }
}

/// A site in the answer.
pub fn site_name(site: &Site) -> SiteName {
    SiteName { kind: site.kind.word().to_string(), name: site.name.clone() }
}

/// Sites without repetition.
fn different(all: Vec<SiteName>) -> Vec<SiteName> {
    let mut kept: Vec<SiteName> = Vec::new();
    for s in all {
        if !kept.contains(&s) {
            kept.push(s);
        }
    }
    kept
}
