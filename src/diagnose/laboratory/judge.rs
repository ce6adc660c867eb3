//! What was said of a case, held against what was concealed in it.

use super::maker::{Case, Hidden, Kind};
use super::{Named, Said};
use crate::diagnose::answer::Verdict;

/// Names that a tie may have to be an answer; more are said to be the truth among many.
const FEW: usize = 3;

/// How what was said stands to what was concealed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Judged {
    /// All of it named, each alone or in a tie of at most three names, and nothing else; where nothing that the catalogue
    /// has is concealed, nothing named.
    Right,
    /// All of it named, one in a tie of more.
    Wide,
    /// All of it named, and something beside it.
    AndMore,
    /// One of two named, and nothing else.
    Half,
    /// Something else named.
    Wrong,
    /// `unknown`, and it resembles what is concealed.
    Resembling,
    /// Nothing named.
    Untold,
}

/// How one case went.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The verdict.
    pub verdict: Verdict,
    /// How it stands to the truth.
    pub judged: Judged,
    /// How many findings are claimed.
    pub findings: usize,
    /// How many of them are none of what was concealed.
    pub spurious: usize,
    /// For each claimed finding with the very code of what was concealed whether it stands at its place.
    pub placed: Vec<bool>,
    /// For each interval of those, in the very form of what was concealed, whether it holds the truth.
    pub covered: Vec<bool>,
}

/// Compares what was said with the truth.
pub fn judge(case: &Case, said: &Said) -> Outcome {
    let claims = said.verdict.has_names();
    let named: Vec<&Named> = said.findings.iter().filter(|f| claims && !f.resembles).collect();
    let spurious = named.iter().filter(|f| !case.hidden.iter().any(|h| f.is_of(&h.code))).count();
    let own = || case.hidden.iter().filter_map(|h| Some((h, *named.iter().find(|f| f.code == h.code)?)));
    Outcome {
        verdict: said.verdict,
        judged: if claims { claimed(case, &named, spurious) } else { unclaimed(case, said) },
        findings: named.len(),
        spurious,
        placed: own().map(|(h, f)| h.place == f.place).collect(),
        covered: own().filter(|(h, f)| is_same_law(h, f)).flat_map(|(h, f)| covered(h, f)).collect(),
    }
}

fn unclaimed(case: &Case, said: &Said) -> Judged {
    let resembles = |h: &Hidden| said.findings.iter().any(|f| f.is_of(&h.code));
    match case.kind {
        Kind::None | Kind::Outside => Judged::Right,
        _ if said.verdict == Verdict::Unknown && case.hidden.iter().any(resembles) => Judged::Resembling,
        _ => Judged::Untold,
    }
}

fn claimed(case: &Case, named: &[&Named], spurious: usize) -> Judged {
    let few: Vec<&Named> = named.iter().copied().filter(|f| f.ties.len() < FEW).collect();
    match (case.hidden.is_empty(), tells(&case.hidden, named), spurious) {
        (false, true, 0) if tells(&case.hidden, &few) => Judged::Right,
        (false, true, 0) => Judged::Wide,
        (false, true, _) => Judged::AndMore,
        (false, false, 0) => Judged::Half,
        _ => Judged::Wrong,
    }
}

/// Whether each effect has a finding of its own that is of its code.
fn tells(hidden: &[Hidden], named: &[&Named]) -> bool {
    let Some((first, others)) = hidden.split_first() else { return true };
    (0..named.len())
        .any(|i| named[i].is_of(&first.code) && tells(others, &[&named[..i], &named[i + 1..]].concat()))
}

/// Whether a finding has the form and the place of what was concealed: in another form a parameter of the same name is
/// another.
fn is_same_law(hidden: &Hidden, found: &Named) -> bool {
    hidden.place == found.place && bare(&hidden.term) == bare(&found.term)
}

/// A text without the numbers of names: a second law's `a` is `a_2`.
fn bare(text: &str) -> String {
    let is_of_name = |c: char| c.is_alphanumeric() || c == '_';
    let names = text.split_inclusive(|c| !is_of_name(c));
    let one = |part: &str| {
        let end = part.trim_end_matches(|c| !is_of_name(c));
        match end.rsplit_once('_') {
            Some((name, number)) if number.parse::<u8>().is_ok() => name.to_owned() + &part[end.len()..],
            _ => part.to_owned(),
        }
    };
    names.map(one).collect()
}

/// For each interval of a finding whether it holds the true value.
fn covered(hidden: &Hidden, found: &Named) -> Vec<bool> {
    let of = |(name, truth): &(String, f64)| {
        let own = found.intervals.iter().find(|(n, ..)| bare(n) == bare(name))?;
        Some((own.1..=own.2).contains(truth))
    };
    hidden.values.iter().filter_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(kind: Kind, hidden: &[&str], verdict: Verdict, findings: &[&[&str]]) -> Judged {
        let hide = |c: &&str| Hidden {
            code: (*c).into(),
            place: "x".into(),
            term: String::new(),
            values: Vec::new(),
        };
        let name = |names: &&[&str]| Named {
            code: names[0].into(),
            place: "x".into(),
            term: String::new(),
            ties: names[1..].iter().map(ToString::to_string).collect(),
            resembles: false,
            intervals: Vec::new(),
        };
        let case = Case {
            number: 0,
            plant: String::new(),
            kind,
            hidden: hidden.iter().map(hide).collect(),
            size: 3.0,
            correlation: 0.0,
        };
        judge(&case, &Said { verdict, findings: findings.iter().map(name).collect() }).judged
    }

    #[test]
    fn the_numbers_of_names_make_no_other_law() {
        assert_eq!(bare("-(k*exp(a_2*(t - t_mid_2)))/M1"), "-(k*exp(a*(t - t_mid)))/M1");
        assert_ne!(bare("(k*(1 + a*(t - t_mid)))"), bare("(k/(1 + a*(t - t_mid)))"));
    }

    #[test]
    fn what_is_said_is_held_against_the_truth() {
        let one = |verdict, findings: &[&[&str]]| judged(Kind::One, &["lag"], verdict, findings);
        assert_eq!(one(Verdict::Named, &[&["lag"]]), Judged::Right);
        assert_eq!(one(Verdict::Tie, &[&["delay", "lag", "store"]]), Judged::Right);
        assert_eq!(one(Verdict::Tie, &[&["delay", "lag", "store", "memory"]]), Judged::Wide);
        assert_eq!(one(Verdict::Named, &[&["lag"], &["backlash"]]), Judged::AndMore);
        assert_eq!(one(Verdict::Named, &[&["backlash"]]), Judged::Wrong);
        assert_eq!(one(Verdict::Unknown, &[&["lag"]]), Judged::Resembling);
        assert_eq!(one(Verdict::NothingMissing, &[]), Judged::Untold);
        let two = |findings: &[&[&str]]| judged(Kind::Two, &["lag", "stop"], Verdict::Named, findings);
        assert_eq!(two(&[&["stop"], &["lag"]]), Judged::Right);
        assert_eq!(two(&[&["stop", "lag"], &["lag"]]), Judged::Right);
        assert_eq!(two(&[&["stop", "lag"]]), Judged::Half);
        assert_eq!(two(&[&["stop"], &["backlash"]]), Judged::Wrong);
        assert_eq!(judged(Kind::Outside, &[], Verdict::Unknown, &[&["lag"]]), Judged::Right);
        assert_eq!(judged(Kind::None, &[], Verdict::Tie, &[&["lag", "stop"]]), Judged::Wrong);
    }
}
