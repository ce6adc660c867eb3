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
    /// Whether anything was claimed by name.
    pub claims: bool,
    /// For each interval of a rightly named mechanism whether it holds the truth.
    pub covered: Vec<bool>,
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
    let _ =
        writeln!(text, "one concealed:     named           {}", count("one", &|_, o| o.claims && o.right));
    let _ =
        writeln!(text, "                   wrong name      {}", count("one", &|_, o| o.claims && !o.right));
    let _ =
        writeln!(text, "two concealed:     both named      {}", count("two", &|_, o| o.claims && o.right));
    let _ = writeln!(
        text,
        "outside:           unknown         {}",
        count("outside", &|_, o| o.verdict == Verdict::Unknown)
    );
    let _ = writeln!(text, "                   wrong name      {}", count("outside", &|_, o| o.claims));
    let covered: Vec<bool> = outcomes.iter().flat_map(|o| o.covered.iter().copied()).collect();
    let _ = writeln!(
        text,
        "95 % intervals that hold the truth {}",
        share(covered.iter().filter(|c| **c).count(), covered.len())
    );
    let _ = writeln!(text, "\n{:<24} effect over noise: 1        3        10", "one concealed");
    let mut by_code: BTreeMap<&str, [(usize, usize); 3]> = BTreeMap::new();
    for (c, o) in pairs.iter().filter(|(c, _)| c.kind == "one") {
        let column = if c.size < 2.0 { 0 } else { usize::from(c.size > 5.0) + 1 };
        for code in &c.codes {
            let cell = &mut by_code.entry(code).or_default()[column];
            cell.1 += 1;
            cell.0 += usize::from(o.claims && o.right);
        }
    }
    for (code, cells) in by_code {
        let shown: Vec<String> = cells.iter().map(|(a, n)| format!("{a}/{n}")).collect();
        let _ = writeln!(text, "{code:<43} {:<8} {:<8} {}", shown[0], shown[1], shown[2]);
    }
    text
}
