//! The laboratory's tables.

use super::maker::{CORRELATIONS, Case};
use crate::diagnose::answer::Verdict;
use std::collections::BTreeMap;
use std::fmt::Write;

/// How one case went.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The verdict.
    pub verdict: Verdict,
    /// Whether all that was concealed was named, alone or among ties.
    pub right: bool,
    /// Whether that holds only for ties of more than three names.
    pub is_wide: bool,
    /// Whether anything was claimed by name.
    pub claims: bool,
    /// How many findings are claimed.
    pub findings: usize,
    /// How many of them are none of what was concealed.
    pub spurious: usize,
    /// For each interval of a rightly named mechanism whether it holds the truth.
    pub covered: Vec<bool>,
}

impl Outcome {
    /// Whether all that was concealed was claimed, each alone or in a tie of at most three names.
    fn is_right(&self) -> bool {
        self.claims && self.right && !self.is_wide
    }
}

fn share(part: usize, whole: usize) -> String {
    if whole == 0 {
        "-".into()
    } else {
        format!("{part}/{whole} ({:.0} %)", 100.0 * part as f64 / whole as f64)
    }
}

/// The tables as text.
pub fn tabulate(cases: &[Case], outcomes: &[Outcome]) -> String {
    let pairs: Vec<(&Case, &Outcome)> = cases.iter().zip(outcomes).collect();
    let count = |kind: &str, holds: &dyn Fn(&Case, &Outcome) -> bool| {
        let own: Vec<_> = pairs.iter().filter(|(c, _)| c.kind == kind).collect();
        share(own.iter().filter(|(c, o)| holds(c, o)).count(), own.len())
    };
    let mut text = String::new();
    let alarm = count("none", &|_, o| o.verdict != Verdict::NothingMissing);
    let _ = writeln!(text, "nothing concealed: false alarms    {alarm}");
    for r in CORRELATIONS {
        let own: Vec<_> = pairs.iter().filter(|(c, _)| c.kind == "none" && c.correlation == r).collect();
        let alarms = own.iter().filter(|(_, o)| o.verdict != Verdict::NothingMissing).count();
        let _ = writeln!(text, "                   noise of {r:<9} {}", share(alarms, own.len()));
    }
    for (kind, named) in [("one", "named"), ("two", "both named")] {
        let right = count(kind, &|_, o| o.is_right());
        let _ = writeln!(text, "{:<19}{named:<16}{right}", format!("{kind} concealed:"));
        let _ = writeln!(
            text,
            "                   among many      {}",
            count(kind, &|_, o| o.claims && o.is_wide)
        );
        let _ = writeln!(
            text,
            "                   wrong name      {}",
            count(kind, &|_, o| o.claims && !o.right)
        );
    }
    let _ = writeln!(
        text,
        "outside:           unknown         {}",
        count("outside", &|_, o| o.verdict == Verdict::Unknown)
    );
    let _ = writeln!(text, "                   wrong name      {}", count("outside", &|_, o| o.claims));
    let sum = |of: fn(&Outcome) -> usize| outcomes.iter().map(of).sum::<usize>();
    let _ = writeln!(
        text,
        "findings:          of nothing hidden {}",
        share(sum(|o| o.spurious), sum(|o| o.findings))
    );
    let covered: Vec<bool> = outcomes.iter().flat_map(|o| o.covered.iter().copied()).collect();
    let _ = writeln!(
        text,
        "95 % intervals that hold the truth {}",
        share(covered.iter().filter(|c| **c).count(), covered.len())
    );
    text + &rows("plant", &pairs, |c| vec![&c.plant])
        + &rows("one concealed", &pairs, |c| c.codes.iter().map(String::as_str).collect())
}

/// How many cases with one effect were named right, a line a name, by their size.
fn rows(title: &str, pairs: &[(&Case, &Outcome)], names: fn(&Case) -> Vec<&str>) -> String {
    let mut text = format!("\n{title:<24} effect over noise: 1        3        10\n");
    let mut by_name: BTreeMap<&str, [(usize, usize); 3]> = BTreeMap::new();
    for (c, o) in pairs.iter().filter(|(c, _)| c.kind == "one") {
        let column = if c.size < 2.0 { 0 } else { usize::from(c.size > 5.0) + 1 };
        for name in names(c) {
            let cell = &mut by_name.entry(name).or_default()[column];
            cell.1 += 1;
            cell.0 += usize::from(o.is_right());
        }
    }
    for (name, cells) in by_name {
        let shown: Vec<String> = cells.iter().map(|(a, n)| format!("{a}/{n}")).collect();
        let _ = writeln!(text, "{name:<43} {:<8} {:<8} {}", shown[0], shown[1], shown[2]);
    }
    text
}
