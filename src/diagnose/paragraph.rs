//! The paragraph that says it all.

use super::answer::{DataFault, Finding, Proof, Verdict, at_fault, told};
use super::catalogue::Proposal;
use super::choose::SURE;
use super::free_law::is_in;
use super::rest::Rest;
use super::search::{Found, Taken};
use super::words;
use crate::model::Model;

/// What it is made of.
pub struct Paragraph<'a> {
    /// The model.
    pub model: &'a Model,
    /// The outcome of the search.
    pub found: &'a Found,
    /// The verdict on the physics, and that on physics and data.
    pub verdicts: (Verdict, Verdict),
    /// The physics, largest share first.
    pub findings: &'a [Finding],
    /// What is wrong with the data.
    pub faults: &'a [DataFault],
    /// Before and after.
    pub proof: &'a [Proof],
    /// Why the recording cannot tell, if so.
    pub blind: Option<&'a str>,
    /// Whether anything was held out.
    pub is_held_out: bool,
    /// Why what is left is no noise, where nothing else tells that something is missing.
    pub odd: Option<&'a str>,
    /// Whether the search ended before it was through.
    pub is_cut: bool,
    /// What is left, if a law is.
    pub rest: Option<&'a Rest>,
    /// Whether what is left wanders by more than its quick noise.
    pub wanders: bool,
}

impl Paragraph<'_> {
    /// The text.
    pub fn text(&self) -> String {
        let (physics, verdict) = self.verdicts;
        if verdict == Verdict::DataFault {
            let all = joined(self.faults.iter().map(|f| &f.finding));
            return format!("{}: {all}. {}", at_fault(self.faults), self.beside(physics));
        }
        format!("{}{}", self.physics(), self.mended())
    }

    /// What stands beside faults that have taken the verdict.
    fn beside(&self, physics: Verdict) -> String {
        match physics {
            Verdict::NothingMissing => {
                format!("Beside that nothing is missing{}", self.noise())
            }
            Verdict::NotIdentifiable => {
                format!("What they leave cannot tell whether anything is missing: {}.", self.reason())
            }
            _ => format!("Beside that, as far as such data can tell: {}", self.physics()),
        }
    }

    /// Faults that leave the verdict to the physics.
    fn mended(&self) -> String {
        let (readings, faults): (Vec<&DataFault>, Vec<&DataFault>) =
            self.faults.iter().partition(|f| f.is_reading());
        let (own, faults): (Vec<&DataFault>, Vec<&DataFault>) =
            faults.into_iter().partition(|f| f.is_of_the_model());
        let all = |masked: bool| joined(faults.iter().filter(|f| f.masked == masked).map(|f| &f.finding));
        let turned = joined(own.iter().map(|f| &f.finding));
        let read: String = readings.iter().map(|f| format!(" {}.", f.finding.says)).collect();
        let said =
            |list: String, words: &str| if list.is_empty() { list } else { format!(" {words}: {list}.") };
        read + &said(turned, "A sign was mended first")
            + &said(all(true), "Faults of the data were left out or mended first")
            + &said(all(false), "The data have a fault that nothing can mend")
    }

    /// That nothing was held out, where it was not.
    fn untried(&self) -> &'static str {
        if self.is_held_out {
            ""
        } else {
            " Nothing was held out: this is the word of the fitted part alone."
        }
    }

    /// What is left, where it is noise.
    fn noise(&self) -> String {
        let left = if self.rest.is_some() {
            " that this recording makes sure of"
        } else if self.wanders {
            " that shows itself as a law: what the model leaves over goes with no signal, but it wanders, by a disturbance that \
             nobody recorded or in the sensor itself (more below)"
        } else {
            ": what the model leaves over looks like noise in every test"
        };
        format!("{left}.{}{}", self.sign(), self.untried())
    }

    /// A law that is seen in what is left and not for sure.
    fn sign(&self) -> String {
        let Some((rest, goes)) = self.rest.zip(self.goes()) else { return String::new() };
        let per_mille = (1e3 * rest.p_value).ceil();
        let sure = 1e3 * SURE;
        format!(
            " There is a sign of something that goes with {goes}: noise alone would leave as much in {per_mille} of 1000 such \
             recordings, and it is told for sure from {sure} of 1000 on. A longer recording, or a second one, would tell."
        )
    }

    /// What the law that is left goes with.
    fn goes(&self) -> Option<String> {
        let law = self.rest?.laws.first()?;
        let goes = joined_by(&law.signals, self.model);
        Some(if law.of_past { format!("what {goes} was before") } else { goes })
    }

    fn reason(&self) -> &str {
        self.blind.unwrap_or("it moves too little")
    }

    fn physics(&self) -> String {
        let (_, others) = told(self.findings);
        let list = joined(others.iter().copied());
        let opening = match self.verdicts.0 {
            Verdict::NothingMissing | Verdict::DataFault => {
                let untried = self.untried();
                if self.found.is_sure_trace() {
                    return format!(
                        "Nothing is missing that would lower the error by 2 %. What the model leaves over is not quite noise: a trace is left in it, as small noise of an input leaves, or its rounding.{untried}"
                    );
                }
                return format!("Nothing is missing{}", self.noise());
            }
            Verdict::NotIdentifiable => {
                return format!("This recording cannot tell what is missing: {}.", self.reason());
            }
            Verdict::Named => format!("The model leaves out: {list}."),
            Verdict::Tie => {
                let ties = self.findings.first().map(|f| self.ties(f)).unwrap_or_default();
                let of = if others.len() > 1 { "In place of the first, " } else { "" };
                format!("The model leaves out: {list}. {of}{ties} would fit as well.")
            }
            Verdict::Unknown => self.unknown(&list),
        };
        if self.found.taken.is_empty() {
            return opening;
        }
        format!("{opening} {}{}", self.gains(), slight(self.findings, &others))
    }

    /// What fits as well as a finding.
    fn ties(&self, first: &Finding) -> String {
        let is = |p: &Proposal| p.code == first.code && p.term == first.term;
        let taken = self.found.taken.iter().find(|t| is(&t.proposal));
        let named = |t: &Taken| t.ties.iter().map(|o| words::beside(&t.proposal, o)).collect::<Vec<_>>();
        taken.map_or_else(|| first.ties.clone(), named).join(", ")
    }

    fn unknown(&self, list: &str) -> String {
        let law = self.goes();
        if is_in(&self.found.taken) {
            let beyond = "It holds where the data are, and goes on straight beyond them.";
            return format!(
                "Something is missing that the catalogue has no name for. As a law without a name it is in the model: {list}. {beyond}"
            );
        }
        if let ("", Some(fallen)) = (list, &self.found.fallen) {
            let goes = joined_by(&fallen.proposal.depends, self.model);
            let goes = if goes.is_empty() { goes } else { format!("; it goes with {goes}") };
            return format!(
                "Something is missing{goes}. Where it is fitted it is as if {}; that cannot be run over what was held out, so that nothing proves the name.",
                words::sentence(&fallen.proposal, &fallen.fit)
            );
        }
        if let ("", Some(odd)) = (list, self.odd) {
            let beside = law.map_or_else(String::new, |l| format!(" What is left also goes with {l}."));
            return format!("Something is missing that the catalogue has no name for: {odd}.{beside}");
        }
        match (list, law) {
            ("", None) => {
                if self.is_cut {
                    return "Something is missing; the search ended before it could say what. Give it more time.".into();
                }
                let nearest = self.found.first.screened.first().map_or_else(String::new, |s| {
                    format!(" Nearest in shape: {} at {}.", s.proposal.code, s.proposal.site.name)
                });
                format!(
                    "Something is missing, but nothing in the catalogue passed every test of a name.{nearest}"
                )
            }
            ("", Some(law)) => {
                format!("Something is missing that the catalogue has no name for; it goes with {law}.")
            }
            (list, None) if self.is_held_out => format!(
                "Something is missing, but no name for it stands on what was held out. It resembles: {list}."
            ),
            (list, None) => format!(
                "Something is missing, but nothing was held out that could prove a name for it. It resembles: {list}."
            ),
            (list, Some(law)) => format!(
                "Something is missing that the catalogue has no name for; it goes with {law}. It resembles: {list}."
            ),
        }
    }

    /// The fall of the held-out errors.
    fn gains(&self) -> String {
        let told = self.proof.iter().filter(|p| p.holdout_before.is_finite()).map(|p| {
            let shown = |x: f64| words::quantity(x, &p.unit);
            let (before, after) = (shown(p.holdout_before), shown(p.holdout_after));
            let proves = match p.holdout_after > p.holdout_before {
                true if before == after => ", which proves nothing",
                true => ", which is worse and proves nothing",
                false => "",
            };
            format!(
                "On what was held out the error of “{}” is {before} before and {after} after{proves}.",
                p.output
            )
        });
        told.collect::<Vec<_>>().join(" ")
    }
}

/// What the sentence leaves to the list, by code and place.
fn slight(findings: &[Finding], told: &[&Finding]) -> String {
    let is_told = |f: &Finding| told.iter().any(|t| std::ptr::eq(*t, f));
    let rest = findings.iter().filter(|f| !is_told(f) && !f.is_fault());
    let names: Vec<String> = rest.map(|f| format!("{} ({} {})", f.code, f.site.kind, f.site.name)).collect();
    if names.is_empty() {
        return String::new();
    }
    format!(" Found in the fitted part too, each with less than 1 % of that fall: {}.", names.join(", "))
}

/// Signals in words, with "and".
fn joined_by(signals: &[String], model: &Model) -> String {
    signals.iter().map(|s| words::signal(model, s)).collect::<Vec<_>>().join(" and ")
}

fn joined<'a>(all: impl Iterator<Item = &'a Finding>) -> String {
    all.map(|f| f.says.as_str()).collect::<Vec<_>>().join("; ")
}
