//! The laboratory's tables.

use super::judge::{Judged, Outcome};
use super::maker::{CORRELATIONS, Case, Kind, SIZES};
use crate::diagnose::answer::Verdict;
use std::collections::BTreeMap;
use std::fmt::Write;

type Pair<'a> = (&'a Case, &'a Outcome);

fn share(part: usize, whole: usize) -> String {
    if whole == 0 {
        "-".into()
    } else {
        format!("{part}/{whole} ({:.0} %)", 100.0 * part as f64 / whole as f64)
    }
}

/// The tables as text.
pub fn tabulate(cases: &[Case], outcomes: &[Outcome]) -> String {
    let pairs: Vec<Pair> = cases.iter().zip(outcomes).collect();
    nothing(&pairs)
        + &effects("one concealed, over the noise", &of(&pairs, Kind::One))
        + &effects("two concealed, the lesser", &of(&pairs, Kind::Two))
        + &outside(&of(&pairs, Kind::Outside))
        + &findings(&pairs)
        + &rows("plant, one concealed right", &pairs, |c| &c.plant)
        + &rows("law, concealed alone", &pairs, |c| &c.hidden[0].code)
}

fn of<'a>(pairs: &[Pair<'a>], kind: Kind) -> Vec<Pair<'a>> {
    pairs.iter().filter(|(c, _)| c.kind == kind).copied().collect()
}

fn nothing(pairs: &[Pair]) -> String {
    let own = of(pairs, Kind::None);
    if own.is_empty() {
        return String::new();
    }
    let count = |verdict: Verdict| own.iter().filter(|(_, o)| o.verdict == verdict).count();
    let alarms = |all: &[Pair]| all.iter().filter(|(_, o)| o.judged == Judged::Wrong).count();
    let mut text = String::new();
    let mut line = |name: &str, value: String| text += &format!("{name:<35}{value}\n");
    line("nothing concealed: false alarms", share(alarms(&own), own.len()));
    for r in CORRELATIONS {
        let with: Vec<Pair> = own.iter().filter(|(c, _)| c.correlation == r).copied().collect();
        line(&format!("    noise of {r}"), share(alarms(&with), with.len()));
    }
    line("    not identifiable", share(count(Verdict::NotIdentifiable), own.len()));
    line("    unknown", share(count(Verdict::Unknown), own.len()));
    text
}

/// How cases of one kind went, a line an outcome, by their size.
fn effects(title: &str, own: &[Pair]) -> String {
    let lines = [
        (Judged::Right, "named, alone or among three"),
        (Judged::Wide, "among more names"),
        (Judged::AndMore, "named, and one more"),
        (Judged::Half, "one of both"),
        (Judged::Wrong, "wrong name"),
        (Judged::Resembling, "unknown that resembles it"),
        (Judged::Untold, "nothing named"),
    ];
    if own.is_empty() {
        return String::new();
    }
    let mut text = format!("\n{title:<35}");
    text.extend(SIZES.map(|size| format!("{:<14}", format!("{size} times"))));
    text += "all\n";
    for (judged, name) in lines {
        let cell = |of: &dyn Fn(&Case) -> bool| {
            let all = own.iter().filter(|(c, _)| of(c));
            share(all.clone().filter(|(_, o)| o.judged == judged).count(), all.count())
        };
        let by_size: String =
            SIZES.iter().map(|size| format!("{:<14}", cell(&|c: &Case| c.size == *size))).collect();
        let _ = writeln!(text, "    {name:<31}{by_size}{}", cell(&|_: &Case| true));
    }
    text
}

fn outside(own: &[Pair]) -> String {
    if own.is_empty() {
        return String::new();
    }
    let count = |of: &dyn Fn(&Outcome) -> bool| share(own.iter().filter(|(_, o)| of(o)).count(), own.len());
    let unknown = count(&|o: &Outcome| o.verdict == Verdict::Unknown);
    let wrong = count(&|o: &Outcome| o.judged == Judged::Wrong);
    format!("\n{:<35}{unknown}\n{:<35}{wrong}\n", "outside: unknown", "    wrong name")
}

fn findings(pairs: &[Pair]) -> String {
    let own: Vec<&Outcome> = pairs.iter().filter(|(c, _)| !c.hidden.is_empty()).map(|(_, o)| *o).collect();
    let sum = |of: fn(&Outcome) -> usize| own.iter().map(|o| of(o)).sum::<usize>();
    let hold = |of: fn(&Outcome) -> &Vec<bool>| {
        let all: Vec<bool> = own.iter().flat_map(|o| of(o).iter().copied()).collect();
        share(all.iter().filter(|x| **x).count(), all.len())
    };
    let lines = [
        ("findings of nothing hidden", share(sum(|o| o.spurious), sum(|o| o.findings))),
        ("    at their very place", hold(|o| &o.placed)),
        ("    95 % intervals hold the truth", hold(|o| &o.covered)),
    ];
    let mut text = String::from("\n");
    text.extend(lines.map(|(name, value)| format!("{name:<35}{value}\n")));
    text
}

/// How many cases with one effect were named right, a line a name, by their size.
fn rows(title: &str, pairs: &[Pair], name: fn(&Case) -> &str) -> String {
    let own = of(pairs, Kind::One);
    if own.is_empty() {
        return String::new();
    }
    let mut text = format!("\n{title:<35}");
    text.extend(SIZES.map(|size| format!("{:<10}", format!("{size} times"))));
    text.truncate(text.trim_end().len());
    text.push('\n');
    let mut by_name: BTreeMap<&str, [(usize, usize); SIZES.len()]> = BTreeMap::new();
    for (c, o) in own {
        let column = SIZES.iter().position(|s| *s == c.size).unwrap_or(0);
        let cell = &mut by_name.entry(name(c)).or_default()[column];
        cell.1 += 1;
        cell.0 += usize::from(o.judged == Judged::Right);
    }
    for (name, cells) in by_name {
        let shown: String = cells.iter().map(|(a, n)| format!("{:<10}", format!("{a}/{n}"))).collect();
        let _ = writeln!(text, "    {name:<31}{}", shown.trim_end());
    }
    text
}
