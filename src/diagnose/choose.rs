//! The choice between extensions that were fitted.
//!
//! # Purpose
//! Say which extension a round takes, and which others fit as well.
//!
//! # Method
//! An extension stands if its likelihood ratio stands after Holm's correction and its gain over parts
//! left out is above the floor. Of those near the largest gain the likeliest is taken, or one of less gain
//! that is the likelier for it: what hides behind another effect lowers the error little and is yet sure.
//! Others within the tolerance of the likelihood are ties. Parts that commute in a linear model have a wider
//! tolerance, because they differ only by what the recording began with. The same change of one parameter or
//! of another is two laws: as likely, they are ties.
//!
//! # References
//! S. Holm, Scand. J. Statist. 6 (1979) 65; G. Schwarz, Ann. Statist. 6 (1978) 461.

use super::catalogue::{self, Proposal, SiteKind};
use super::measure::Measure;
use super::propose::Screened;
use super::search::{Refitted, Round, Taken};
use crate::model::Input;

/// Share of all gains before that a further one must reach.
const FURTHER: f64 = 0.2;
/// Chance, after correction, above which nothing is added.
pub const CHANCE: f64 = 0.01;
/// Chance, corrected for all that was tried, from which on something is surely missing though nothing has a
/// name for it.
pub const SURE: f64 = 1e-3;
/// Gain from which on a mechanism counts as seen by the free run.
pub const MUCH: f64 = 0.2;
/// Relative fall of the left-out root mean square below which nothing is added.
pub const FLOOR: f64 = 0.02;
/// Difference in log-likelihood up to which two extensions fit as well: odds of 20 to 1.
pub const TIE: f64 = 3.0;
/// Gain in log-likelihood from which on one is plainly likelier.
pub const PLAINLY: f64 = 20.0;
/// Share of the largest free-run gain that a likelier rival must reach.
pub const RIVAL: f64 = 0.75;
/// Share of it that is enough for one whose gains of both, multiplied, are larger.
const ENOUGH: f64 = 0.25;
/// Share of its gain by which an extension that commutes with another may differ from it.
const COMMUTES: f64 = 0.2;
/// Share of the free-run gain by which parts that commute may differ for what they began with alone.
const STARTS: f64 = 0.05;
/// Share of its gain by which a wave may beat a recorded channel that goes as the wave does, and has noise of its own.
const RECORDED: f64 = 0.05;

/// ln of the fall of the left-out sum of squares.
pub fn gain(now: &Measure, new: &Measure) -> f64 {
    (now.left_out / new.left_out).ln()
}

/// The gain that an extension must reach after gains before it.
pub fn floor(before: f64) -> f64 {
    (-2.0 * (1.0 - FLOOR).ln()).max(FURTHER * before)
}

fn worth(r: &Refitted) -> f64 {
    worth_of(&r.proposal, &r.measure)
}

/// Likelihood less the price of what a proposal adds.
pub fn worth_of(p: &Proposal, measure: &Measure) -> f64 {
    measure.likelihood - price(p, measure.samples)
}

/// What the parameters of a proposal cost in log-likelihood, by Schwarz's criterion.
pub fn price(p: &Proposal, samples: f64) -> f64 {
    0.5 * p.added.len() as f64 * samples.max(2.0).ln()
}

/// Whether a mechanism is tied to moments of one recording, so that another cannot confirm it.
pub fn is_anchored(p: &Proposal) -> bool {
    let codes = ["parameter-change", "clock-jump", "clock-drift"];
    p.alone.is_none() && (codes.contains(&p.code) || is_drift(p) || is_timed_wave(p) || is_step(p))
}

/// Whether its name tells that something goes with time, not in which form.
pub fn is_drift(p: &Proposal) -> bool {
    ["drift-force", "output-drift", "parameter-drift"].contains(&p.code)
}

/// Whether a recording that begins anew may show a law again that is tied to moments of another: it goes on from every
/// beginning, or lasts from its moment on.
pub fn may_return(p: &Proposal) -> bool {
    !is_timed_wave(p)
}

/// Whether it is a wave, whose free frequency makes it look like much else.
pub fn is_wave(p: &Proposal) -> bool {
    p.code == "periodic-force"
}

/// Whether it is a wave in time, whose frequency was read from the residual.
pub fn is_timed_wave(p: &Proposal) -> bool {
    is_wave(p) && p.term.contains("*t)")
}

/// Whether it is a constant from a moment on.
fn is_step(p: &Proposal) -> bool {
    ["constant-force", "output-offset"].contains(&p.code) && p.term.contains("step(")
}

/// Whether it is an offset of a sensor from a moment on, which was read from the residual.
fn is_jump_of_zero(p: &Proposal) -> bool {
    p.code == "output-offset" && is_step(p)
}

/// Starts of a wave whose frequency was read from the residual, at most.
const FEW: usize = 4;

/// Whether it is a wave whose frequency was read from the residual: it starts from there alone.
fn is_line(p: &Proposal) -> bool {
    is_wave(p) && p.starts.len() <= FEW && p.amplitudes.len() < p.added.len()
}

/// Out of how many a proposal was chosen before it was tried: the frequency of a wave that was read from the residual
/// is the best of all that the samples resolve, the moment of a sensor's jump of all samples.
pub fn chosen_from(p: &Proposal, samples: f64) -> f64 {
    match p {
        _ if is_jump_of_zero(p) => samples.max(1.0),
        _ if is_line(p) => (0.5 * samples).max(1.0),
        _ => 1.0,
    }
}

/// Whether a proposal is the same mechanism as another at another place.
pub fn is_elsewhere(p: &Proposal, other: &Proposal) -> bool {
    p.code == other.code && p.site != other.site
}

/// Whether a law was taken before at the same site on the same signals: twice, it is another law. Another harmonic of an angle
/// is no repetition.
pub fn is_repeated(p: &Proposal, taken: &[Taken]) -> bool {
    let own = p.harmonics();
    let is_new = |t: &Proposal| {
        let theirs = t.harmonics();
        theirs.is_empty() != own.is_empty() || !own.is_empty() && theirs.iter().all(|h| !own.contains(h))
    };
    let same = |t: &Proposal| {
        t.code == p.code && t.site == p.site && t.depends == p.depends && t.alone == p.alone && !is_new(t)
    };
    !is_anchored(p) && taken.iter().any(|t| same(&t.proposal))
}

/// Whether a law bends one that was taken before: both are laws of a same signal at the moment.
pub fn mends(p: &Proposal, taken: &[Taken]) -> bool {
    let own = p.law_of();
    taken.iter().any(|t| t.proposal.law_of().iter().any(|s| own.contains(s)))
}

/// Families whose members are the same thing in a linear model with one input and one output.
const LATE: [&[&str]; 2] = [&["input-delay", "output-delay"], &["input-lag", "output-lag"]];
/// Families whose members are the same thing in a linear model, whatever else acts on it.
const STEADY: [&[&str]; 2] =
    [&["constant-force", "input-offset", "output-offset"], &["drift-force", "output-drift"]];

/// Whether both are of one family.
fn are_of_one(families: &[&[&str]], p: &Proposal, q: &Proposal) -> bool {
    families.iter().any(|f| f.contains(&p.code) && f.contains(&q.code))
}

/// Whether both delay something, or both let something lag.
pub fn are_late(p: &Proposal, q: &Proposal) -> bool {
    are_of_one(&LATE, p, q)
}

/// Whether two mechanisms commute where the model is linear.
fn commute(p: &Proposal, q: &Proposal) -> bool {
    // what stands in a loop acts before and behind itself
    let is_inside = [p, q].iter().any(|p| p.site.kind == SiteKind::Definition);
    let is_one_way = !is_inside && p.model.inputs.len() == 1 && p.model.outputs.len() == 1;
    // a wave of one frequency on a linear model is one at its sensor, but for what the recording begins with
    let are_waves = is_timed_wave(p) && is_timed_wave(q) && p.site.kind != q.site.kind;
    // a force that sets in is followed by and by, an offset at once
    let are_steady = are_of_one(&STEADY, p, q) && p.alone == q.alone && ![p, q].iter().any(|p| is_step(p));
    are_waves || p.code != q.code && (are_steady || is_one_way && are_late(p, q))
}

/// Whether an extension puts a recorded channel that the model did not read in the place of a wave in time, and lowers the
/// error as far but for what the channel's own noise adds: a cause that was recorded goes before one that only may be.
fn is_recorded_wave(r: &Refitted, wave: &Refitted, now: &Measure) -> bool {
    let read = |i: &Input| wave.proposal.model.inputs.iter().any(|own| own.name == i.name);
    is_timed_wave(&wave.proposal)
        && !r.proposal.model.inputs.iter().all(read)
        && r.proposal.added.len() <= wave.proposal.added.len()
        && gain(now, &r.measure) > (1.0 - RECORDED) * gain(now, &wave.measure)
}

/// Whether an extension may stand for a better one that has fallen out: it gains nearly as much.
pub fn rivals(r: &Refitted, fallen: &Refitted, now: &Measure) -> bool {
    gain(now, &r.measure) >= RIVAL * gain(now, &fallen.measure)
}

/// Whether all that a round fitted, and all that it only scored, lowers neither the squares of the free run nor
/// those of the innovations by the floor. So small a thing may be sure and yet no physics: noise of an input or its
/// rounding leaves as much.
pub fn is_trace(round: &Round, now: &Measure) -> bool {
    let least = floor(0.0);
    let fitted = |r: &Refitted| {
        let likelier = 2.0 * (r.measure.likelihood - now.likelihood) / r.measure.samples.max(1.0);
        gain(now, &r.measure).max(likelier) < least
    };
    let was_fitted = |s: &Screened| {
        let same = |p: &Proposal| {
            (p.code, &p.term) == (s.proposal.code, &s.proposal.term) && p.site == s.proposal.site
        };
        round.fitted.iter().any(|r| same(&r.proposal))
    };
    let scored = |s: &Screened| -(1.0 - s.explained.max(s.visible).min(1.0)).ln() < least || was_fitted(s);
    let all = || round.screening.screened.iter().chain(&round.screening.free);
    round.fitted.iter().all(fitted) && all().all(scored)
}

/// What a round takes.
pub struct Choice {
    /// Number of the extension among those fitted.
    pub best: usize,
    /// Others that fit as well.
    pub ties: Vec<Proposal>,
    /// The same mechanism elsewhere that fits as well.
    pub elsewhere: Vec<Proposal>,
    /// Number of the first of the others.
    pub rival: Option<usize>,
    /// Numbers of all that fit as well.
    pub near: Vec<usize>,
    /// Those that lower the error nearly as much and fit less well.
    pub others: Vec<Proposal>,
}

/// Whether an extension fits as well as another, with no more parameters; both with how good they are, against the model
/// without either.
pub fn alike((p, m): (&Proposal, &Measure), (to, best): (&Proposal, &Measure), now: &Measure) -> bool {
    let likelier = best.likelihood - now.likelihood;
    let same = commute(p, to) || is_elsewhere(p, to);
    let tolerance = if same { TIE.max(COMMUTES * likelier) } else { TIE };
    let by_start_alone = commute(p, to) && gain(now, m) > (1.0 - STARTS) * gain(now, best);
    (by_start_alone || worth_of(p, m) > worth_of(to, best) - tolerance) && p.added.len() <= to.added.len()
}

/// Takes the likeliest of those whose gain is near the largest; with its ties.
pub fn choose(round: &Round, now: &Measure) -> Option<Choice> {
    let gain = |now: &Measure, r: &Refitted| gain(now, &r.measure);
    // What the calibrated screening did not see must stand the more surely by its fit, or gain much.
    let seen = round.screening.p_value < CHANCE;
    let chance = |r: &Refitted| if seen || gain(now, r) > MUCH { CHANCE } else { CHANCE * CHANCE };
    let passes = |r: &Refitted| r.p_value < chance(r) && gain(now, r) > r.floor && !r.is_pressed();
    let largest = round.fitted.iter().filter(|r| passes(r)).map(|r| gain(now, r)).fold(0.0, f64::max);
    // a smaller gain is enough where the likelihood gains the more
    let both = |r: &Refitted| gain(now, r) * (worth(r) - now.likelihood);
    let near = |r: &Refitted| passes(r) && gain(now, r) >= RIVAL * largest;
    let most = round.fitted.iter().filter(|r| near(r)).map(both).fold(0.0, f64::max);
    let is_likelier = |r: &Refitted| passes(r) && gain(now, r) >= ENOUGH * largest && both(r) > most;
    let is_rival = |i: &usize| near(&round.fitted[*i]) || is_likelier(&round.fitted[*i]);
    let rivals: Vec<usize> = (0..round.fitted.len()).filter(is_rival).collect();
    let likelier = |a: &usize, b: &usize| worth(&round.fitted[*a]).total_cmp(&worth(&round.fitted[*b]));
    let likeliest = rivals.iter().copied().max_by(likelier)?;
    let recorded = |i: &usize| is_recorded_wave(&round.fitted[*i], &round.fitted[likeliest], now);
    let likeliest = rivals.iter().copied().filter(recorded).max_by(likelier).unwrap_or(likeliest);
    let fall = |r: &Refitted| gain(now, r);
    let of = |i: usize| (&round.fitted[i].proposal, &round.fitted[i].measure);
    let alike = |i: usize, to: usize| alike(of(i), of(to), now);
    // Of parts that commute, the thing stands before its sensor.
    let place = |i: usize| {
        let p = &round.fitted[i].proposal;
        (catalogue::ALL.iter().position(|m| m.code == p.code), p.site.kind == SiteKind::Output)
    };
    let commuting = |i: &usize| commute(&round.fitted[*i].proposal, &round.fitted[likeliest].proposal);
    let first =
        rivals.iter().copied().filter(|i| commuting(i) && alike(*i, likeliest)).min_by_key(|i| place(*i));
    // Among those that fit alike the one with the fewest parameters stands first.
    let fewest = |i: &usize| round.fitted[*i].proposal.added.len();
    let as_likely = |i: &usize| worth(&round.fitted[*i]) > worth(&round.fitted[likeliest]) - TIE;
    let simpler = rivals.iter().copied().filter(|i| as_likely(i) && fewest(i) < fewest(&likeliest));
    let simplest = simpler.min_by_key(|i| fewest(i));
    // Of several frequencies of one wave the one that blocks left out like best.
    let is_same_wave = |i: &usize| {
        let (p, q) = (&round.fitted[*i].proposal, &round.fitted[likeliest].proposal);
        is_wave(p) && p.site == q.site && p.term == q.term && as_likely(i)
    };
    let fallen = |i: &usize| fall(&round.fitted[*i]);
    let line = rivals.iter().copied().filter(is_same_wave).max_by(|a, b| fallen(a).total_cmp(&fallen(b)));
    let likeliest = line.unwrap_or(likeliest);
    let best = simplest.or(first.filter(|i| place(*i) < place(likeliest))).unwrap_or(likeliest);
    let chosen = &round.fitted[best].proposal;
    let mut ties: Vec<Proposal> = Vec::new();
    let mut elsewhere: Vec<Proposal> = Vec::new();
    let mut rival = None;
    // The same change of another parameter is as good a name though blocks left out may like it less.
    let likely = |i: usize| worth(&round.fitted[i]) > worth(&round.fitted[best]) - TIE;
    let other_parameter = |i: usize| {
        let (r, site) = (&round.fitted[i], &chosen.site);
        let same = r.proposal.code == chosen.code && r.proposal.site.kind == SiteKind::Parameter;
        same && r.proposal.site != *site && r.p_value < chance(r) && !r.is_pressed() && likely(i)
    };
    let rival_too = |i: &usize| rivals.contains(i) && alike(*i, likeliest);
    let all = (0..round.fitted.len()).filter(|i| *i != best);
    let near: Vec<usize> = all.filter(|i| rival_too(i) || other_parameter(*i)).collect();
    for i in near.iter().copied() {
        let p = &round.fitted[i].proposal;
        if p.code == chosen.code && !other_parameter(i) {
            // another form of the law at the same place is the same name
            if p.site != chosen.site {
                elsewhere.push(p.clone());
            }
        } else if ties.iter().all(|t| t.code != p.code || other_parameter(i) && t.site != p.site) {
            ties.push(p.clone());
            rival = rival.or(Some(i));
        }
    }
    let others = rivals.into_iter().filter(|i| *i != best && !near.contains(i));
    let others = others.map(|i| round.fitted[i].proposal.clone()).collect();
    Some(Choice { best, ties, elsewhere, rival, near, others })
}
