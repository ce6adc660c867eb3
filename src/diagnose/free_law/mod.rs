//! A model of what has no name.
//!
//! # Purpose
//! Where something is surely missing and no name stands for it, the law itself is put into the model, as a curve of one
//! signal at the place where it explains most.
//!
//! # Method
//! Curves through few and through many knots are screened as the catalogue is, at every place and for every signal; the
//! best of the number of knots that scores surest are fitted with everything else. The likeliest of those that lower the
//! error of left-out blocks most is then tried through more knots, which it keeps only where those blocks fall again; and a
//! surface over its signal and another, there or at one of the likeliest places, takes its place where that predicts them
//! clearly better, or stands where no curve does. A second law may follow on the same terms. What is offered must also lower the error of what was held out. The
//! fit of a law may spend a tenth of a share of the steps that the search for names has spent, and no further law is begun
//! once that share is gone.
//!
//! # References
//! Leave-block-out as in `measure`; S. N. Wood, Generalized Additive Models, 2nd ed. (2017), ch. 4, on curves by knots.

mod looks;

use super::answer::{Answer, Finding, Verdict};
use super::bench::Bench;
use super::catalogue::Proposal;
use super::catalogue::free_law::{CODE, laws, surfaces};
use super::catalogue::{Site, edit};
use super::choose::{CHANCE, SURE, floor, gain};
use super::compared::{patiently, same_samples};
use super::measure::{Measure, Scale};
use super::propose::{Screened, explaining};
use super::race::{self, Against, By};
use super::search::{Found, Taken, is_over};
use super::view::View;
use super::{Diagnosis, prove};
use crate::Result;
use crate::estimate::Fit;
use crate::estimate::fit::Progress;
use crate::expression::{Expr, Function};
use crate::record::Recording;
use std::cell::Cell;

/// Knots of a curve: first, and where it is looked at again.
const KNOTS: [usize; 3] = [5, 9, 15];
/// Knots of a surface along either signal.
const ALONG: usize = 4;
/// Places where surfaces are looked for, beside that of a curve that stands.
const PLACES: usize = 2;
/// Times that a surface must lower the error of left-out blocks further than a curve.
const BETTER: f64 = 1.3;
/// Laws that are fitted.
const FITTED: usize = 6;
/// Those of one signal among them.
const OF_SIGNAL: usize = 3;
/// Share of the free-run residual's square that a law must explain at first sight.
const LEAST: f64 = 0.03;
/// Steps that were spent before, for each of the laws' share, where no name stands and where one does: one of theirs
/// costs several of a plain model's.
const STEPS: [u64; 2] = [3, 6];
/// Times that a law must lower the error of left-out blocks, and of what was held out, further than names that stand.
const TWICE: f64 = 2.0;
/// Laws that are added at most.
const MOST: usize = 2;

/// A law fitted inside the model.
struct Lawful {
    proposal: Proposal,
    fit: Fit,
    measure: Measure,
    p_value: f64,
    tried: f64,
}

/// How many of the laws were tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tried {
    /// None was looked for.
    None,
    /// The steps or the time ended the search, or the fit of one.
    Some,
    /// All of them.
    All,
}

/// Where the search ended without a name that stands, or with one that leaves much, with a law in place of what is
/// missing; none where no law lowers the error of left-out blocks.
///
/// # Errors
/// Where a fitted model cannot be run.
pub fn instead(
    bench: &Bench,
    separate: &[Recording],
    (found, stands): (&Found, bool),
    given: &[f64],
    progress: &dyn Progress,
) -> Result<(Option<Found>, Tried)> {
    if bench.is_trials() || is_over(bench) {
        return Ok((None, Tried::None));
    }
    progress.report("no name explains all: looking for the law itself", None);
    let scale = Scale::of(&found.base, false);
    let mut current = found.base.clone();
    let mut now = Measure::of(&current, &scale);
    let start = now;
    let mut taken: Vec<Taken> = Vec::new();
    let all: u64 = bench.budget.stages().iter().map(|stage| stage.steps).sum();
    let bench = &Bench { budget: bench.budget.at_most(all / STEPS[usize::from(stands)]), ..bench.clone() };
    // names that only resemble it may do better together; one that stands gives way to a law twice as good
    let resembling = Measure::of(&found.last, &scale);
    let named = stands.then_some(&resembling);
    let cut = Cell::new(false);
    while taken.len() < MOST && !is_over(bench) {
        // a second law must halve what the first left: curves bend to much
        let least = if taken.is_empty() { floor(0.0) } else { TWICE.ln() };
        let ground =
            Ground { bench, separate, scale: &scale, given, taken: &taken, named, cut: &cut, progress };
        let Some(law) = one(&ground, &current, &now, least)? else { break };
        taken.push(Taken {
            proposal: law.proposal,
            p_value: law.p_value,
            tried: law.tried,
            ties: Vec::new(),
            elsewhere: Vec::new(),
            others: Vec::new(),
            rivals: None,
        });
        (current, now) = (law.fit, law.measure);
    }
    let tried = if cut.get() || is_over(bench) { Tried::Some } else { Tried::All };
    if taken.is_empty() || gain(&resembling, &now) < if stands { TWICE.ln() } else { 0.0 } {
        return Ok((None, tried));
    }
    say_as_one(&mut current, &taken);
    for t in &mut taken {
        if let Some(like) = looks::likeness(&t.proposal, &current) {
            t.proposal.says += &format!("; it looks like {like}");
        }
    }
    let without = vec![None; taken.len()];
    let mut new = found.clone();
    (new.last, new.taken, new.without, new.measures) = (current, taken, without, (start, now));
    (new.fallen, new.is_trace) = (None, false);
    Ok((Some(new), tried))
}

/// The heights of a law trade with each other, and its band says how sure they are: where the model's own parameters
/// trade with them, they count as one.
fn say_as_one(fit: &mut Fit, taken: &[Taken]) {
    let is_own = |name: &String| !taken.iter().any(|t| t.proposal.added.iter().any(|a| a.name == *name));
    for direction in &mut fit.unseen {
        let all = direction.weights.len();
        direction.weights.retain(|w| is_own(&w.0));
        if !direction.weights.is_empty() && direction.weights.len() < all {
            direction.weights.push(("the law".into(), 1.0));
        }
    }
    fit.unseen.retain(|d| !d.weights.is_empty());
}

/// What a law is looked for in.
struct Ground<'a> {
    bench: &'a Bench,
    separate: &'a [Recording],
    scale: &'a Scale,
    given: &'a [f64],
    taken: &'a [Taken],
    /// How good the model is with the names that stand, if some do.
    named: Option<&'a Measure>,
    /// Whether the fit of a law was ended before it was through.
    cut: &'a Cell<bool>,
    progress: &'a dyn Progress,
}

/// The next law, if one stands.
fn one(ground: &Ground<'_>, current: &Fit, now: &Measure, least: f64) -> Result<Option<Lawful>> {
    let bench = ground.bench;
    let view = patiently(bench, || View::of(bench, current))?;
    let scene = bench.scene(&current.model, &view.stand)?;
    let is_new = |p: &Proposal| {
        !ground.taken.iter().any(|t| t.proposal.site == p.site || t.proposal.depends == p.depends)
    };
    let of =
        |knots: usize| explaining(bench, &view, laws(&scene, knots).into_iter().filter(is_new).collect());
    let levels = KNOTS.map(of);
    // a law that turns often is not seen through few knots
    let surest = |k: &usize| levels[*k].iter().map(|s| s.score.statistic).fold(0.0, f64::max);
    let likely = (0..KNOTS.len()).rev().max_by(|a, b| surest(a).total_cmp(&surest(b))).unwrap_or(0);
    let over = (current, now);
    let runs = |l: &Lawful| prove::runs(bench, &l.fit, ground.separate);
    let through = |k: usize| Some((best_of(ground, &view, &levels[k], over, least)?, k));
    let coarse = || if likely > 0 { through(0) } else { None };
    // a curve that predicts no better than names that stand is none
    let better = |l: &Lawful| ground.named.is_none_or(|named| gain(named, &l.measure) > 0.0);
    let Some((mut best, level)) = through(likely).or_else(coarse).filter(|(l, _)| better(l)) else {
        let screened = &levels[likely];
        let sites = likeliest_sites(screened);
        let both = surfaces(&scene, &sites, None, ALONG).into_iter().filter(is_new).collect();
        return Ok(best_of(ground, &view, &explaining(bench, &view, both), over, least));
    };
    for knots in &KNOTS[level + 1..] {
        if is_over(bench) {
            break;
        }
        let same = |p: &Proposal| p.site == best.proposal.site && p.depends == best.proposal.depends;
        let finer =
            laws(&scene, *knots).into_iter().find(same).and_then(|p| through_more(ground, &view, &best, p));
        match finer.filter(|l| gain(&best.measure, &l.measure) > floor(0.0) && runs(l)) {
            Some(law) => best = law,
            None => break,
        }
    }
    if !is_over(bench) {
        let of = best.proposal.depends.first().map(String::as_str);
        let mut sites = likeliest_sites(&levels[level]);
        if !sites.contains(&best.proposal.site) {
            sites.push(best.proposal.site.clone());
        }
        let both = surfaces(&scene, &sites, of, ALONG);
        let screened = explaining(bench, &view, both.into_iter().filter(is_new).collect());
        let law = best_of(ground, &view, &screened, over, least);
        best = law.filter(|l| gain(&best.measure, &l.measure) > BETTER.ln()).unwrap_or(best);
    }
    Ok(Some(best))
}

/// The best of the likeliest of some proposals, fitted, that stands and runs over what was held out.
fn best_of(
    ground: &Ground<'_>,
    view: &View,
    screened: &[Screened],
    (current, now): (&Fit, &Measure),
    least: f64,
) -> Option<Lawful> {
    let bench = ground.bench;
    let tried = screened.len() as f64;
    let chosen = likeliest(screened);
    // a curve is chosen by what it lowers in blocks left out
    let most = ground.named.map_or(now.left_out, |named| named.left_out);
    let against =
        Against { squares: ground.scale.squares(current), by: By::LeftOut(most), scale: ground.scale };
    let fitted = race::run(bench, view, ground.given, &chosen, against, ground.progress);
    ground.cut.set(ground.cut.get() || fitted.iter().any(|f| f.is_cut));
    let measured = fitted.into_iter().filter(|f| same_samples(current, &f.fit)).map(|f| {
        let measure = Measure::of(&f.fit, ground.scale);
        let p_value = (tried * measure.chance_over(now.likelihood, f.proposal.added.len())).min(1.0);
        Lawful { proposal: f.proposal, fit: f.fit, measure, p_value, tried }
    });
    let stands = |l: &Lawful| l.p_value < CHANCE && gain(now, &l.measure) > least;
    let mut standing: Vec<Lawful> = measured.filter(stands).collect();
    standing.sort_by(|a, b| a.measure.left_out.total_cmp(&b.measure.left_out));
    standing.into_iter().find(|l| prove::runs(bench, &l.fit, ground.separate))
}

/// The places at which curves explain most, though none stands.
fn likeliest_sites(screened: &[Screened]) -> Vec<Site> {
    let mut sites: Vec<Site> = Vec::new();
    for s in screened {
        if sites.len() < PLACES && !sites.contains(&s.proposal.site) {
            sites.push(s.proposal.site.clone());
        }
    }
    sites
}

/// In turn those that explain most and those that score surest, a few of each signal: what the start of the search is far
/// from explains little at first sight.
fn likeliest(screened: &[Screened]) -> Vec<&Screened> {
    let most: Vec<&Screened> = screened.iter().filter(|s| s.explained > LEAST).collect();
    let mut surest = most.clone();
    surest.sort_by(|a, b| b.score.statistic.total_cmp(&a.score.statistic));
    let mut chosen: Vec<&Screened> = Vec::new();
    for s in most.into_iter().zip(surest).flat_map(|(a, b)| [a, b]) {
        let same = chosen.iter().filter(|c| c.proposal.depends == s.proposal.depends).count();
        let is_there = chosen.iter().any(|c| std::ptr::eq(*c, s));
        if same < OF_SIGNAL && chosen.len() < FITTED && !is_there {
            chosen.push(s);
        }
    }
    chosen
}

/// A law through more knots, fitted from where it stands through fewer.
fn through_more(ground: &Ground<'_>, view: &View, coarse: &Lawful, finer: Proposal) -> Option<Lawful> {
    let known = |n: &str| coarse.fit.model.parameters.iter().find(|p| p.name == n).map(|p| p.value);
    let term = Expr::parse(&finer.term).ok()?;
    let places: Vec<f64> = arguments(&term)?[1..].iter().step_by(2).filter_map(Expr::constant).collect();
    let old = Expr::parse(&coarse.proposal.term).ok()?;
    let knots: Option<Vec<f64>> = arguments(&old)?[1..].iter().map(|e| e.value(&known)).collect();
    let knots = knots?;
    let mut model = finer.model.clone();
    for p in &mut model.parameters {
        p.value = known(&p.name).unwrap_or(p.value);
    }
    for (added, z) in finer.added.iter().zip(&places) {
        let height = Function::Curve.of(&[&[*z], &knots[..]].concat());
        model.parameters.iter_mut().filter(|p| p.name == added.name).for_each(|p| p.value = height);
    }
    let heat = race::walk(ground.bench, &model, coarse.fit.starts(), 2, view)?;
    let fit = race::to_the_end(ground.bench, &finer, &heat, &ground.bench.part())?;
    let measure = Measure::of(&fit, ground.scale);
    same_samples(&coarse.fit, &fit).then(|| Lawful {
        proposal: finer,
        fit,
        measure,
        p_value: coarse.p_value,
        tried: coarse.tried,
    })
}

/// The arguments of the curve in a term.
fn arguments(term: &Expr) -> Option<&[Expr]> {
    match edit::find(term, &|e| matches!(e, Expr::Call(Function::Curve, _)))? {
        Expr::Call(_, arguments) => Some(arguments),
        _ => None,
    }
}

/// Whether a law lowers what was held out: below names that resemble what is missing, and to half the squares of names that
/// stand.
fn is_proven(with: &Answer, without: &Answer) -> bool {
    let rises: Vec<f64> = with
        .proof
        .iter()
        .map(|p| {
            let named = without.proof.iter().find(|n| n.output == p.output).map(|n| n.holdout_after);
            (p.holdout_after / named.filter(|n| n.is_finite()).unwrap_or(p.holdout_before)).ln()
        })
        .filter(|r| !r.is_nan())
        .collect();
    let mean = rises.iter().sum::<f64>() / rises.len() as f64;
    let most = if stands(without) { -0.5 * TWICE.ln() } else { 0.0 };
    with.proof.iter().any(|p| p.improvement_low > 0.0) && mean < most
}

/// Whether names explain the recording.
fn stands(a: &Answer) -> bool {
    a.verdict != Verdict::Unknown
}

/// The answer with the law in the model, if one stands and lowers what was held out; else the one without, which says
/// where something is missing whether all laws were tried.
pub fn beside(mut without: Diagnosis, with: Option<Diagnosis>, tried: Tried) -> Diagnosis {
    let Some(mut with) = with.filter(|w| is_proven(&w.answer, &without.answer)) else {
        if !stands(&without.answer) {
            without.answer.says += match tried {
                Tried::None => "",
                Tried::Some => {
                    " The search for a law of one or two signals ended before all were tried: its share of the steps, or the time, was spent."
                }
                Tried::All => " No law of one or two signals, put into the model, predicts better.",
            };
        }
        return without;
    };
    if !stands(&without.answer) {
        // where it is missing was told before a law was tried; the law's own place stands in its finding
        with.answer.located = without.answer.located;
    }
    let resembling: Vec<Finding> =
        without.answer.findings.into_iter().map(|f| Finding { resembles: true, ..f }).collect();
    if !resembling.is_empty() {
        let all: Vec<&str> = resembling.iter().map(|f| f.says.as_str()).collect();
        with.answer.says += &format!(" It resembles: {}.", all.join("; "));
    }
    with.answer.findings.extend(resembling);
    with
}

/// Whether a law is left for sure.
pub fn surely_leaves(a: &Answer) -> bool {
    a.unexplained.as_ref().is_some_and(|u| u.p_value < SURE)
}

/// Whether names that stand may yet be patches of something else: a law is surely left, or a wave had to help.
pub fn may_be_better(a: &Answer) -> bool {
    let helped = a.findings.len() > 1 && a.findings.iter().any(|f| f.code == "periodic-force");
    a.verdict.has_names() && (surely_leaves(a) || helped)
}

/// Whether a law without a name stands in a model.
pub fn is_in(taken: &[Taken]) -> bool {
    taken.first().is_some_and(|t| t.proposal.code == CODE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::fit::Silent;
    use crate::model::Model;
    use crate::record::Channel;
    use crate::simulate::Budget;
    use crate::units::Unit;

    /// A lag whose rate has a bump that the model lacks, stepped by Euler's rule.
    fn bench() -> (Bench, Model) {
        let text = "name = \"lag\"\n[inputs]\nu = { unit = \"1\" }\n[parameters]\n\
                    k = { value = 2.5, unit = \"1/s\", fit = true, min = 0.1, max = 10 }\n[states]\n\
                    x = { rate = \"k*(u - x)\", unit = \"1\", initial = 0 }\n[outputs]\n\
                    y = { equals = \"x\", unit = \"1\" }\n";
        let model = Model::parse(text).unwrap();
        let time: Vec<f64> = (0..200).map(|i| 0.05 * f64::from(i)).collect();
        let u: Vec<f64> = time.iter().map(|t| (1.1 * t).sin() + 0.7 * (4.3 * t).cos()).collect();
        let mut x = 0.0;
        let step = |u: &f64| {
            let before = x;
            x += 0.05 * ((u - x) / 0.5 + (-((x - 0.3) / 0.2f64).powi(2)).exp());
            before
        };
        let y: Vec<f64> = u.iter().map(step).collect();
        let one = |name: &str, values: Vec<f64>| Channel::new(name, Unit::one(), time.clone(), values);
        let recording = Recording::from_channels("lag", vec![one("u", u), one("y", y)]).unwrap();
        (Bench::new(&model, vec![recording], false, 1), model)
    }

    #[test]
    fn a_search_that_its_steps_end_has_not_tried_all_laws() {
        let (mut bench, model) = bench();
        let found = Found::nothing(bench.full_fit(&model).unwrap(), false);
        let given: Vec<f64> = model.parameters.iter().map(|p| p.value).collect();
        let look = |bench: &Bench| instead(bench, &[], (&found, false), &given, &Silent).unwrap();
        // one fit was all that was spent, and a third of its steps end the fits of laws
        assert_eq!(look(&bench).1, Tried::Some);
        for _ in 0..500 {
            bench.full_fit(&model).unwrap();
        }
        assert_eq!(look(&bench).1, Tried::All);
        bench.budget = Budget::new(0, None);
        assert_eq!(look(&bench).1, Tried::None);
    }

    /// A pendulum that is driven to some amplitude, rad, as if it were recorded there.
    fn pendulum(amplitude: f64) -> (Bench, Model) {
        let text = "name = \"pendulum\"\n[inputs]\nu = { unit = \"1/s^2\" }\n[parameters]\n\
                    k = { value = 1, unit = \"1/s^2\", fit = true, min = 0.1, max = 10 }\n[states]\n\
                    th = { rate = \"w\", unit = \"rad\", initial = 0 }\n\
                    w = { rate = \"u - k*sin(th)\", unit = \"rad/s\", initial = 0 }\n[outputs]\n\
                    y = { equals = \"th\", unit = \"rad\" }\n";
        let model = Model::parse(text).unwrap();
        let time: Vec<f64> = (0..200).map(|i| 0.05 * f64::from(i)).collect();
        // th = A (1 - cos 2t)/2 needs u = th'' + sin th
        let th = |t: &f64| 0.5 * amplitude * (1.0 - (2.0 * t).cos());
        let u = time.iter().map(|t| 2.0 * amplitude * (2.0 * t).cos() + th(t).sin()).collect();
        let one = |name: &str, values: Vec<f64>, unit: &str| {
            Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values)
        };
        let channels = vec![one("u", u, "1/s^2"), one("y", time.iter().map(th).collect(), "rad")];
        let recording = Recording::from_channels("pendulum", channels).unwrap();
        (Bench::new(&model, vec![recording], false, 1), model)
    }

    #[test]
    fn an_angle_whose_sine_acts_has_laws_while_it_does_not_go_round() {
        let of_angle = |amplitude: f64| {
            let (bench, model) = pendulum(amplitude);
            let fit = bench.full_fit(&model).unwrap();
            let view = View::of(&bench, &fit).unwrap();
            let scene = bench.scene(&fit.model, &view.stand).unwrap();
            laws(&scene, KNOTS[0]).iter().any(|p| p.depends == ["th"] && p.site.name == "w")
        };
        assert!(of_angle(1.2) && !of_angle(3.0));
    }
}
