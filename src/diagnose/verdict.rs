//! From what was found to one verdict: first on the physics, by the data without their faults, then on both.

use super::answer::{DataFault, Finding, Proof, Value, Verdict};
use super::catalogue::Proposal;
use super::choose::{CHANCE, SURE, is_wave};
use super::few::agree_by_luck;
use super::free_law::is_in;
use super::innovations::Unlike;
use super::rest::Rest;
use super::search::{Found, is_pressed};

/// Share of all that names and a law could explain together from which on, left to the law, the names
/// only resemble.
const RESEMBLES: f64 = 0.1;
/// The same in a table of trials, whose rows are independent, where the law's chance is below the second.
const IN_TRIALS: (f64, f64) = (0.005, 1e-4);

/// What decides on the physics.
pub struct Evidence<'a> {
    /// The search's outcome.
    pub found: &'a Found,
    /// What is left after it.
    pub rest: &'a Rest,
    /// Why the fitted part cannot tell, if so.
    pub blind: Option<&'a str>,
    /// Whether the model as given, fitted, misses an output by more than that moves.
    pub is_adrift: bool,
}

impl Evidence<'_> {
    /// Whether the names leave too much to a law that no name has. With ρ the share of the squared error
    /// that the names leave and λ the part of it that the law takes away, the law has λρ/(1 − ρ + λρ) of
    /// all that is explained.
    fn outweighs(&self) -> bool {
        let named = 1.0 - (-self.found.gain()).exp();
        let left = self.rest.laws.first().map_or(0.0, |l| l.lowers) * (1.0 - named);
        let sure = self.found.scale.trials && self.rest.p_value < IN_TRIALS.1;
        let most = if sure { IN_TRIALS.0 } else { RESEMBLES };
        self.rest.is_left() && left > most * (named + left)
    }

    /// Whether the model as given misses more than a constant would, and a law is left for sure: any law that holds
    /// such a model back lowers the error.
    fn ran_away(&self) -> bool {
        self.is_adrift && self.rest.is_left() && self.rest.p_value < SURE
    }

    /// Whether an own parameter of a name has run into its bound, where it is something else.
    fn is_pressed(&self) -> bool {
        self.found.taken.iter().any(|t| is_pressed(&t.proposal, &self.found.last))
    }

    /// Whether one finding acts on a hidden state that another brought in: what only goes on like that is a filter of high
    /// order, which follows any response, and no law of the instrument.
    fn is_nested(&self) -> bool {
        let taken = &self.found.taken;
        let is_hidden = |name: &String| taken.iter().any(|t| t.proposal.states.contains(name));
        taken.iter().any(|t| is_hidden(&t.proposal.site.name))
    }

    /// The verdict.
    pub fn verdict(&self) -> Verdict {
        if self.blind.is_some() {
            return Verdict::NotIdentifiable;
        }
        let Some(first) = self.found.taken.first() else {
            let found = self.found;
            let sure = found.first.p_value < SURE && !found.is_trace;
            let left = self.rest.is_left() && self.rest.p_value < SURE;
            let something = left || sure || found.fallen.is_some();
            return if something { Verdict::Unknown } else { Verdict::NothingMissing };
        };
        if is_in(&self.found.taken) {
            return Verdict::Unknown;
        }
        if self.outweighs()
            || self.ran_away()
            || self.is_pressed()
            || self.is_nested()
            || self.rest.is_left() && is_wave(&first.proposal)
        {
            Verdict::Unknown
        } else if first.ties.is_empty() {
            Verdict::Named
        } else {
            Verdict::Tie
        }
    }
}

/// Nothing is missing only where what is left is noise: where it steps, or what drives it was not recorded, something is,
/// and where it is too slow nobody can tell.
pub fn with_noise(verdict: Verdict, unlike: Option<&Unlike>, is_driven: bool) -> Verdict {
    match (verdict, unlike) {
        (Verdict::NothingMissing, None) if is_driven => Verdict::Unknown,
        (Verdict::NothingMissing, Some(Unlike::Steps(..) | Unlike::Strays(..))) => Verdict::Unknown,
        (Verdict::NothingMissing, Some(Unlike::Slow(..))) => Verdict::NotIdentifiable,
        _ => verdict,
    }
}

/// The finding with the largest share decides: by its ties between named and tie, and it only resembles what is
/// missing if it does not stand by its likelihood ratio. An interval of an amplitude may hold 0 where a shape trades
/// with it, and asks only where there is no such ratio.
pub fn settle(verdict: Verdict, findings: &[Finding], found: &Found) -> Verdict {
    let Some(first) = findings.first().filter(|_| verdict.has_names()) else {
        return verdict;
    };
    let doubtful = match &first.evidence {
        Some(e) => e.p_value >= CHANCE,
        None => may_be_nothing(first, found),
    };
    if doubtful {
        Verdict::Unknown
    } else if first.ties.is_empty() {
        Verdict::Named
    } else {
        Verdict::Tie
    }
}

/// Whether the intervals of all amplitudes of a finding hold 0.
fn may_be_nothing(finding: &Finding, found: &Found) -> bool {
    let own = |p: &&Proposal| p.code == finding.code && p.term == finding.term;
    let proposal = found.taken.iter().map(|t| &t.proposal).find(own);
    let amplitudes: Vec<&Value> =
        proposal.iter().flat_map(|p| &p.amplitudes).filter_map(|k| finding.parameters.get(*k)).collect();
    !amplitudes.is_empty() && amplitudes.iter().all(|v| v.low <= 0.0 && v.high >= 0.0)
}

/// Share of the fall of the held-out error from which on one of several names explains most of it.
const MOST: f64 = 0.5;

/// Several names of which none explains most of the fall, while a law is left for sure, patch something that has
/// another name: they only resemble it.
pub fn with_patches(verdict: Verdict, findings: &[Finding], rest: &Rest) -> Verdict {
    let patched = findings.len() > 1 && findings.iter().all(|f| f.share < MOST);
    if verdict.has_names() && patched && rest.p_value < SURE { Verdict::Unknown } else { verdict }
}

/// Error at levels held out over the error of the fit, in a table of trials that still holds a law, from
/// which on the names do not reach beyond the levels that they were fitted to.
const BEYOND: f64 = 1.5;

/// Times its noise from which on a held-out error is more than that, and share of what lies above the noise that names
/// must take away there: what leaves more is in large part something else.
const MORE_THAN_NOISE: f64 = 2.0;
const ENOUGH: f64 = 0.75;

/// Share of the fitted error that names leave, and times its innovations that it is then, from which on they are a splinter
/// of what is missing: the colour of the noise has swallowed the rest.
const SPLINTER: f64 = 0.8;
const FAR_ABOVE: f64 = 10.0;

/// What was held out says of names.
pub struct Proven<'a> {
    /// Held-out errors before and after, an output each.
    pub proof: &'a [Proof],
    /// Held-out samples of all outputs.
    pub samples: usize,
    /// Whether the held-out innovations fall for sure: slow noise may hide in the error what they show.
    pub falls_whitened: bool,
    /// Square of the noise of what was held out over that of the fitted part, of each output, at least 1.
    pub louder: &'a [f64],
    /// Deviation of what is left of each output over that of its innovations.
    pub coloured: &'a [f64],
    /// Whether a law is left for sure; in tables of trials, at all.
    pub is_left: bool,
    /// Whether the recordings are tables of trials.
    pub trials: bool,
}

impl Proven<'_> {
    /// The verdict in the light of the proof. Names without one only resemble what is missing: where too little
    /// is held out to tell; where no held-out error falls for sure, neither as it stands nor by its innovations;
    /// where the errors rise on the whole, or fall by too small a part of what lies above the noise; where held-out
    /// levels are missed while a law is left; where only the innovations fall and nearly all of an error is left that
    /// is many times these; where a law is left for sure, in a good part of what was to be explained.
    pub fn settle(&self, verdict: Verdict) -> Verdict {
        let proof = self.proof;
        let fails =
            !proof.is_empty() && !proof.iter().any(|p| p.improvement_low > 0.0) && !self.falls_whitened;
        let misses =
            self.is_left && self.trials && proof.iter().any(|p| p.holdout_after > BEYOND * p.fit_after);
        let blows_up = proof.iter().any(|p| p.holdout_before.is_finite() && !p.holdout_after.is_finite());
        let falls_short = falls_short(proof, self.louder);
        let unproved =
            agree_by_luck(self.samples) || fails || rise(proof) > 0.0 || misses || blows_up || falls_short;
        let unproved = unproved || self.is_splinter() || self.leaves_much();
        if verdict.has_names() && unproved { Verdict::Unknown } else { verdict }
    }

    /// Whether a law is left in a good part of the squares of the fitted errors: with the error b before, a after and the
    /// innovations e of what is left, (a² − e²)/b², the outputs together.
    fn leaves_much(&self) -> bool {
        let share = |(p, coloured): (&Proof, &f64)| {
            (p.fit_after / p.fit_before).powi(2) * (1.0 - 1.0 / (coloured * coloured).max(1.0))
        };
        let shares: Vec<f64> =
            self.proof.iter().zip(self.coloured).map(share).filter(|s| s.is_finite()).collect();
        self.is_left && shares.iter().sum::<f64>() > RESEMBLES * shares.len() as f64
    }

    fn is_splinter(&self) -> bool {
        let is_left = |(p, coloured): (&Proof, &f64)| {
            p.fit_after > SPLINTER * p.fit_before && p.improvement_low <= 0.0 && *coloured > FAR_ABOVE
        };
        !self.proof.is_empty() && self.proof.iter().zip(self.coloured).all(is_left)
    }
}

/// Names where an input follows a disturbance that nobody recorded only resemble what is missing: it goes round the loop and
/// looks like a law of the input wherever it is tried.
pub fn in_a_loop(verdict: Verdict, is_closed: bool) -> Verdict {
    if verdict.has_names() && is_closed { Verdict::Unknown } else { verdict }
}

/// Names only resemble what is missing where the fitted part does not bear that the same law is fitted to what was held out.
pub fn carried_over(verdict: Verdict, is_carried: bool) -> Verdict {
    if verdict.has_names() && !is_carried { Verdict::Unknown } else { verdict }
}

/// By how much the held-out errors rise, all outputs together, as a logarithm.
fn rise(proof: &[Proof]) -> f64 {
    let rises = proof.iter().map(|p| (p.holdout_after / p.holdout_before).ln());
    rises.filter(|r| !r.is_nan()).sum()
}

/// Whether an error far above its noise is left, and too little of what lay above the noise is gone, all outputs together:
/// Σ(b² − a²)/b² of Σ(b² − n²)/b² with the errors b before and a after and the noise n of what was held out.
fn falls_short(proof: &[Proof], louder: &[f64]) -> bool {
    let noise = |(p, louder): &(&Proof, &f64)| p.noise_floor * louder.sqrt();
    let is_much = |at: (&Proof, &f64)| at.0.holdout_after > MORE_THAN_NOISE * noise(&at);
    let known = proof.iter().zip(louder);
    let known = known.filter(|at| at.0.holdout_before.is_finite() && noise(at).is_finite());
    let parts = |at: (&Proof, &f64)| {
        let square = |x: f64| (x / at.0.holdout_before).powi(2);
        (1.0 - square(at.0.holdout_after), (1.0 - square(noise(&at))).max(0.0))
    };
    let (gone, all) = known.map(parts).fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1));
    proof.iter().zip(louder).any(is_much) && gone < ENOUGH * all
}

/// What to know of a model that nothing is missing from and that yet misses what was held out by more than noise.
pub fn missed(verdict: Verdict, proof: &[Proof]) -> Option<String> {
    let times = |p: &Proof| p.holdout_before / p.noise_floor;
    let is_much = |p: &&Proof| verdict == Verdict::NothingMissing && times(p) > MORE_THAN_NOISE;
    let worst = proof.iter().filter(is_much).max_by(|a, b| times(a).total_cmp(&times(b)))?;
    let (output, often) = (&worst.output, times(worst));
    Some(format!(
        "“{output}” is off by {often:.1} times its noise where it was held out, and no test sees a law in what is left: slow noise looks so, and so does a disturbance that nobody recorded"
    ))
}

/// The verdict on physics and data: the faults take it only where nothing physical stands beside them, or
/// where they leave the question `open`. Names that stand by what was held out have answered it.
pub fn with_faults(physics: Verdict, faults: &[DataFault], open: bool) -> Verdict {
    let alone = match physics {
        Verdict::NothingMissing => true,
        Verdict::Named | Verdict::Tie => false,
        _ => open,
    };
    if alone && !faults.iter().all(DataFault::is_reading) { Verdict::DataFault } else { physics }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_misses_what_was_held_out_is_told_beside_nothing_missing() {
        let of = |verdict, before| missed(verdict, &[proof(before, before, 0.0)]);
        assert!(of(Verdict::NothingMissing, 1.2).is_some_and(|s| s.contains("“y” is off by 2.4 times")));
        assert_eq!(of(Verdict::NothingMissing, 0.9), None);
        assert_eq!(of(Verdict::NothingMissing, f64::NAN), None);
        assert_eq!(of(Verdict::Unknown, 1.2), None);
    }

    fn proof(before: f64, after: f64, low: f64) -> Proof {
        Proof {
            output: "y".into(),
            unit: "1".into(),
            metric: "rmse",
            mode: "free-run",
            fit_before: 1.0,
            fit_after: 0.5,
            holdout_before: before,
            holdout_after: after,
            improvement_low: low,
            improvement_high: 1.0,
            noise_floor: 0.5,
        }
    }

    fn settled(proof: &[Proof], samples: usize, falls_whitened: bool) -> Verdict {
        let (is_left, trials) = (false, false);
        let (louder, coloured) = (&[1.0, 1.0], &[1.0, 1.0]);
        Proven { proof, samples, falls_whitened, louder, coloured, is_left, trials }.settle(Verdict::Named)
    }

    fn proven<'a>(proof: &'a [Proof], coloured: &'a [f64], is_left: bool) -> Proven<'a> {
        let louder = &[1.0, 1.0];
        Proven { proof, samples: 100, falls_whitened: true, louder, coloured, is_left, trials: false }
    }

    #[test]
    fn louder_noise_of_what_was_held_out_is_not_asked_to_go() {
        // a dead zone found in white noise of 3, held out beside noise of 15: 21.3² = 15² + 15.1²
        let proofs = [Proof { noise_floor: 3.0, fit_before: 15.4, fit_after: 3.0, ..proof(21.3, 15.0, 4.0) }];
        let verdict = |louder: f64| {
            let louder = &[louder];
            Proven { louder, ..proven(&proofs, &[1.0], false) }.settle(Verdict::Named)
        };
        assert_eq!(verdict(25.0), Verdict::Named);
        assert_eq!(verdict(1.0), Verdict::Unknown);
    }

    #[test]
    fn names_that_leave_a_good_part_to_a_law_only_resemble() {
        let of = |fit_after: f64, coloured: f64, is_left: bool| {
            proven(&[Proof { fit_after, ..proof(1.0, 0.5, 0.4) }], &[coloured], is_left)
                .settle(Verdict::Named)
        };
        // 0.4² (1 − 1/3²) = 0.14 of the squares, 0.3² less than a tenth
        assert_eq!(of(0.4, 3.0, true), Verdict::Unknown);
        assert_eq!(of(0.4, 3.0, false), Verdict::Named);
        assert_eq!(of(0.3, 3.0, true), Verdict::Named);
        // what its past does not foretell is noise
        assert_eq!(of(0.4, 1.0, true), Verdict::Named);
        assert_eq!(of(0.9, 0.9, true), Verdict::Named);
    }

    #[test]
    fn names_that_do_not_carry_over_only_resemble() {
        let of = |verdict| [true, false].map(|is_carried| carried_over(verdict, is_carried));
        assert_eq!(of(Verdict::Tie), [Verdict::Tie, Verdict::Unknown]);
        assert_eq!(of(Verdict::NothingMissing), [Verdict::NothingMissing; 2]);
    }

    #[test]
    fn a_splinter_of_what_is_missing_is_no_name_of_it() {
        let of = |fit_after: f64, low: f64, coloured: f64| {
            let proof = [Proof { fit_after, ..proof(1.0, 0.95, low) }];
            proven(&proof, &[coloured], false).settle(Verdict::Named)
        };
        assert_eq!(of(0.9, -0.1, 40.0), Verdict::Unknown);
        assert_eq!(of(0.9, 0.1, 40.0), Verdict::Named);
        assert_eq!(of(0.9, -0.1, 3.0), Verdict::Named);
        assert_eq!(of(0.5, -0.1, 40.0), Verdict::Named);
    }

    #[test]
    fn a_held_out_error_that_rises_proves_no_name() {
        assert_eq!(settled(&[proof(1.0, 0.5, 0.4)], 100, false), Verdict::Named);
        assert_eq!(settled(&[proof(1.0, 0.9, -0.1)], 100, true), Verdict::Named);
        assert_eq!(settled(&[proof(1.0, 1.2, -0.4)], 100, true), Verdict::Unknown);
        // one output may lose a little where another gains much more, not the other way round
        let noise = Proof { noise_floor: 1.0, ..proof(1.0, 1.05, -0.1) };
        assert_eq!(settled(&[noise, proof(1.0, 0.5, 0.4)], 100, false), Verdict::Named);
        assert_eq!(settled(&[proof(1.0, 2.0, -1.5), proof(1.0, 0.9, 0.05)], 100, false), Verdict::Unknown);
    }

    #[test]
    fn names_that_leave_much_above_the_noise_only_resemble() {
        let of = |after: f64, noise_floor: f64| {
            settled(&[Proof { noise_floor, ..proof(1.0, after, 0.01) }], 100, false)
        };
        assert_eq!(of(0.75, 0.1), Verdict::Unknown);
        assert_eq!(of(0.3, 0.1), Verdict::Named);
        // near the noise a share of it says nothing
        assert_eq!(of(0.95, 0.8), Verdict::Named);
    }

    #[test]
    fn faults_take_the_verdict_where_no_name_stands_and_they_leave_the_question_open() {
        let finding = Finding {
            code: "gap".into(),
            site: crate::diagnose::answer::SiteName { kind: "input".into(), name: "u".into() },
            term: String::new(),
            says: String::new(),
            parameters: Vec::new(),
            p_value: 0.0,
            share: 0.0,
            ties: Vec::new(),
            resembles: false,
            evidence: None,
        };
        let faults = [DataFault { finding, masked: true }];
        let of = |physics, open| with_faults(physics, &faults, open);
        for open in [false, true] {
            assert_eq!(of(Verdict::Named, open), Verdict::Named);
            assert_eq!(of(Verdict::Tie, open), Verdict::Tie);
            assert_eq!(of(Verdict::NothingMissing, open), Verdict::DataFault);
        }
        let mut held = faults.clone();
        held[0].finding.code = crate::diagnose::answer::INPUT_HOLD.into();
        assert_eq!(with_faults(Verdict::NothingMissing, &held, true), Verdict::NothingMissing);
        for physics in [Verdict::Unknown, Verdict::NotIdentifiable] {
            assert_eq!((of(physics, false), of(physics, true)), (physics, Verdict::DataFault));
            assert_eq!(with_faults(physics, &[], true), physics);
        }
    }

    #[test]
    fn several_names_of_which_none_explains_most_only_resemble_what_leaves_a_sure_law() {
        let finding = |share: f64| Finding {
            code: "cubic-stiffness".into(),
            site: crate::diagnose::answer::SiteName { kind: "state".into(), name: "x".into() },
            term: String::new(),
            says: String::new(),
            parameters: Vec::new(),
            p_value: 0.0,
            share,
            ties: Vec::new(),
            resembles: false,
            evidence: None,
        };
        let of = |shares: &[f64], p_value: f64| {
            let findings: Vec<Finding> = shares.iter().map(|s| finding(*s)).collect();
            with_patches(Verdict::Named, &findings, &Rest { laws: Vec::new(), p_value })
        };
        assert_eq!(of(&[0.4, 0.35, 0.25], 1e-6), Verdict::Unknown);
        assert_eq!(of(&[0.4, 0.35, 0.25], 0.2), Verdict::Named);
        assert_eq!(of(&[0.9, 0.1], 1e-6), Verdict::Named);
        assert_eq!(of(&[1.0], 1e-6), Verdict::Named);
    }

    #[test]
    fn nothing_or_next_to_nothing_held_out_proves_no_name() {
        let none = proof(f64::NAN, f64::NAN, f64::NAN);
        assert_eq!(settled(&[none], 0, false), Verdict::Unknown);
        assert_eq!(settled(&[proof(1.0, 0.5, 0.4)], 5, true), Verdict::Unknown);
        assert_eq!(settled(&[proof(1.0, 0.5, 0.4)], 6, false), Verdict::Named);
    }
}
