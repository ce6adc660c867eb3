//! The search: add one mechanism, look again, drop what became needless.
//!
//! # Purpose
//! From a fitted model and the catalogue to the few mechanisms that the recordings call for.
//!
//! # Method
//! Every proposal is screened by a score test; the most promising are fitted inside the model by
//! simulation. One is taken if its likelihood ratio stands after Holm's correction for all that was
//! tried, if it lowers the free-run error over blocks left out in turn by more than a floor, and if
//! none of like gain is likelier. Alternatives that fit as well are kept as ties. When no more can be
//! added, those that the others make needless are dropped.
//!
//! # References
//! N. R. Kristensen, H. Madsen, S. B. Jorgensen, Computers & Chemical Engineering 28 (2004) 1431;
//! S. Holm, Scand. J. Statist. 6 (1979) 65.

use super::bench::Bench;
use super::catalogue::Proposal;
use super::choose::{self, Choice, choose, floor, gain, mends};
use super::compared::{patiently, same_samples};
use super::measure::{Measure, Scale};
use super::propose::{Screened, Screening, screen, worth_fitting};
use super::twins::twins;
use super::view::View;
use super::{cut, prove, race, scan};
use crate::Result;
use crate::estimate::Fit;
use crate::estimate::fit::Progress;
use crate::record::Recording;
use crate::simulate::Early;
use rayon::prelude::*;

/// Mechanisms that are added at most.
const MOST: usize = 3;

/// The best of a round whose shapes are looked for again.
const SCANNED: usize = 4;

/// A proposal fitted inside the model.
#[derive(Clone)]
pub struct Refitted {
    /// The proposal.
    pub proposal: Proposal,
    /// The fit.
    pub fit: Fit,
    /// How good it is.
    pub measure: Measure,
    /// Chance of its likelihood ratio after correction.
    pub p_value: f64,
    /// How many were tried beside it.
    pub tried: f64,
    /// The gain that it must reach.
    pub floor: f64,
    /// Whether its fit was ended before it was through.
    pub is_cut: bool,
}

impl Refitted {
    /// Whether one of its own parameters lies at its bound, where it is something simpler.
    pub fn is_pressed(&self) -> bool {
        is_pressed(&self.proposal, &self.fit)
    }
}

/// Whether an own parameter of a proposal ended at its bound in a fit.
pub fn is_pressed(p: &Proposal, fit: &Fit) -> bool {
    p.added.iter().any(|a| fit.is_at_bound(&a.name))
}

/// A mechanism that was taken into the model.
#[derive(Clone)]
pub struct Taken {
    /// The proposal.
    pub proposal: Proposal,
    /// Chance, corrected.
    pub p_value: f64,
    /// How many were tried beside it.
    pub tried: f64,
    /// Others that fit as well.
    pub ties: Vec<Proposal>,
    /// The same mechanism at other sites that fit as well.
    pub elsewhere: Vec<Proposal>,
    /// The model fitted with it, and with the first of those that fit as well, when it was taken.
    pub rivals: Option<Box<(Fit, Fit)>>,
}

/// Where the search ended.
#[derive(Clone)]
pub struct Found {
    /// The model as given, fitted.
    pub base: Fit,
    /// The model with all that was taken, fitted.
    pub last: Fit,
    /// What was taken, in order.
    pub taken: Vec<Taken>,
    /// The last model without each of them, where it could be fitted.
    pub without: Vec<Option<(Fit, Measure)>>,
    /// The first screening.
    pub first: Screening,
    /// Screening of what the last model leaves.
    pub rest: Screening,
    /// The scale of comparison.
    pub scale: Scale,
    /// Measures of base and last.
    pub measures: (Measure, Measure),
    /// What a reader should know of fits that were ended early.
    pub notes: Vec<String>,
    /// What would have been taken and cannot be run over what is held out, where nothing else was taken.
    pub fallen: Option<Box<Refitted>>,
    /// Whether nothing that was tried reaches the floor, where nothing was taken.
    pub is_trace: bool,
}

impl Found {
    /// A model that nothing was looked for in.
    pub fn nothing(base: Fit, trials: bool) -> Self {
        let scale = Scale::of(&base, trials);
        let measure = Measure::of(&base, &scale);
        let (first, rest, measures) = (Screening::nothing(), Screening::nothing(), (measure, measure));
        let (taken, notes) = (Vec::new(), Vec::new());
        let without = Vec::new();
        let (fallen, is_trace) = (None, false);
        Self {
            last: base.clone(),
            base,
            taken,
            without,
            first,
            rest,
            scale,
            measures,
            notes,
            fallen,
            is_trace,
        }
    }

    /// ln of the fall of the left-out sum of squares from the given model to the last.
    pub fn gain(&self) -> f64 {
        gain(&self.measures.0, &self.measures.1)
    }
}

/// One round: screens, fits the best, and judges them.
pub struct Round {
    /// All that was scored.
    pub screening: Screening,
    /// The best, fitted.
    pub fitted: Vec<Refitted>,
    /// What a reader should know of fits that were ended early.
    pub notes: Vec<String>,
    /// The best of those that cannot be run over what is held out, if it would have been taken.
    pub fallen: Option<Box<Refitted>>,
}

impl Round {
    fn nothing() -> Self {
        Self { screening: Screening::nothing(), fitted: Vec::new(), notes: Vec::new(), fallen: None }
    }
}

/// What a round is judged against.
struct State<'a> {
    /// How good the model is so far.
    now: &'a Measure,
    /// The scale of comparison.
    scale: &'a Scale,
    /// Gains of what was taken before.
    gains: f64,
    /// What was taken before.
    taken: &'a [Taken],
    /// Whether no more may be added, so that it only looks.
    is_last: bool,
}

fn round(
    bench: &Bench,
    (current, view): (&Fit, &View),
    state: &State<'_>,
    given: &[f64],
    progress: &dyn Progress,
) -> Result<Round> {
    if bench.budget.cut() == Some(Early::Time) {
        return Ok(Round::nothing());
    }
    bench.budget.begin("screening");
    let mut scene = bench.scene(&current.model, &view.stand)?;
    scene.peaks = super::locate::peaks(current);
    scene.lines = super::lines::over_positions(bench, &scene, (current, view));
    scene.shifts = super::innovations::shifts(bench, current);
    let State { now, scale, gains, taken, is_last } = state;
    let screening = screen(bench, &scene, view, taken, progress);
    let tried = screening.screened.len().max(1) as f64;
    let most = if *is_last { 0 } else { bench.patience(&current.model) };
    // A last small one may follow a large one where it would leave nothing else; where the noise's own
    // colour hides what is left, one of some size.
    let least = match screening.p_value < choose::CHANCE {
        true if screening.ends_with_one(view) => floor(0.0),
        true => floor(*gains),
        false => floor(*gains).min(choose::MUCH),
    };
    let chosen = worth_fitting(&screening, most, least);
    let squares = scale.squares(current);
    let judged = |p: Proposal, fit: Fit, is_cut: bool| {
        let measure = Measure::of(&fit, scale);
        let tried = tried * choose::chosen_from(&p, measure.samples);
        let p_value = (tried * measure.chance_over(now.likelihood, p.added.len())).min(1.0);
        let floor = if mends(&p, taken) { floor(*gains) } else { least };
        Refitted { proposal: p, fit, measure, p_value, tried, floor, is_cut }
    };
    let refit = |chosen: &[&Screened]| -> Vec<Refitted> {
        let finished = race::run(bench, view, given, chosen, (squares, scale), progress).into_par_iter();
        let same = finished.filter(|f| same_samples(current, &f.fit));
        same.map(|f| judged(f.proposal, f.fit, f.is_cut)).collect()
    };
    let mut fitted = refit(&chosen);
    let others = twins(&screening, &fitted);
    fitted.extend(refit(&others));
    fitted.sort_by(|a, b| scale.squares(&a.fit).total_cmp(&scale.squares(&b.fit)));
    for r in fitted.iter_mut().take(SCANNED) {
        let better = scan::again(bench, view, &r.proposal, &r.fit, scale);
        if let Some(fit) = better.filter(|f| same_samples(current, f)) {
            let is_cut = fit.ended_early.is_some();
            *r = judged(r.proposal.clone(), fit, is_cut);
        }
    }
    bench.budget.begin("last fits");
    let notes = cut::retry(bench, &mut fitted, (squares, scale), &judged);
    fitted.sort_by(|a, b| a.measure.left_out.total_cmp(&b.measure.left_out));
    Ok(Round { screening, fitted, notes, fallen: None })
}

/// Searches from a fitted model.
///
/// # Errors
/// Where the fitted model itself cannot be run.
pub fn search(
    bench: &Bench,
    separate: &[Recording],
    base: Fit,
    given: &[f64],
    progress: &dyn Progress,
) -> Result<Found> {
    let start = Measure::of(&base, &Scale::of(&base, bench.is_trials()));
    let mut current = base.clone();
    let mut taken: Vec<Taken> = Vec::new();
    let mut gains = 0.0;
    let mut first: Option<Screening> = None;
    let mut given = given.to_vec();
    let mut view = patiently(bench, || View::of(bench, &base))?;
    loop {
        let scale = Scale::of(&current, bench.is_trials());
        let now = Measure::of(&current, &scale);
        let mut round = patiently(bench, || {
            let is_last = taken.len() >= MOST || is_over(bench);
            let state = State { now: &now, scale: &scale, gains, taken: &taken, is_last };
            round(bench, (&current, &view), &state, &given, progress)
        })?;
        trace(bench, &round, &now);
        bench.budget.begin("choice");
        let Some((choice, next)) = standing(bench, separate, &mut round, &now) else {
            let is_trace = taken.is_empty() && choose::is_trace(&round, &now);
            let rest = round.screening;
            let (first, rest) = match first {
                Some(f) => (f, rest),
                None => (
                    Screening { screened: rest.screened.clone(), free: Vec::new(), p_value: rest.p_value },
                    rest,
                ),
            };
            let scale = Scale::of(&base, bench.is_trials());
            let measures = (start, Measure::of(&current, &scale));
            let (notes, fallen) = (round.notes, round.fallen.filter(|_| taken.is_empty()));
            let (last, without) = (current, Vec::new());
            return Ok(Found {
                base,
                last,
                taken,
                without,
                first,
                rest,
                scale,
                measures,
                notes,
                fallen,
                is_trace,
            });
        };
        let Choice { best, ties, elsewhere, rival, .. } = choice;
        let fits = |i: usize| (round.fitted[best].fit.clone(), round.fitted[i].fit.clone());
        let rivals = rival.map(|i| Box::new(fits(i)));
        let r = round.fitted.swap_remove(best);
        gains += gain(&now, &r.measure);
        let names = r.proposal.model.parameters.len();
        given.extend(r.fit.model.parameters[given.len()..names].iter().map(|p| p.value));
        (current, view) = (r.fit, next);
        taken.push(Taken {
            proposal: r.proposal,
            p_value: r.p_value,
            tried: r.tried,
            ties,
            elsewhere,
            rivals,
        });
        first.get_or_insert(round.screening);
    }
}

/// Whether the search must end with the best so far.
pub fn is_over(bench: &Bench) -> bool {
    bench.budget.over().is_some() || bench.budget.cut() == Some(Early::Time)
}

/// The best extension of a round, with what the next one sees of it. Those that cannot be run, there or over
/// what is held out, fall out, and so do those that fit as well as it; then nothing that gains far less may
/// stand for them.
fn standing(
    bench: &Bench,
    separate: &[Recording],
    round: &mut Round,
    now: &Measure,
) -> Option<(Choice, View)> {
    loop {
        let choice = choose(round, now)?;
        let best = &round.fitted[choice.best];
        if round.fallen.as_ref().is_some_and(|fallen| !choose::rivals(best, fallen, now)) {
            return None;
        }
        let runs = |i: &usize| prove::runs(bench, &round.fitted[*i].fit, separate);
        let ahead = ahead(bench, separate, &round.fitted[choice.best].fit);
        let fallen =
            if ahead.is_none() { Some(choice.best) } else { choice.near.iter().copied().find(|i| !runs(i)) };
        match (fallen, ahead) {
            (Some(i), None) => {
                let best = round.fitted.remove(i);
                round.fallen.get_or_insert_with(|| Box::new(best));
            }
            (Some(i), _) => drop(round.fitted.remove(i)),
            (None, ahead) => return ahead.map(|view| (choice, view)),
        }
    }
}

/// What a next round would see of a fitted model; none where it cannot be run there, or over what is held out.
pub fn ahead(bench: &Bench, separate: &[Recording], fit: &Fit) -> Option<View> {
    let view = View::of(bench, fit).ok()?;
    bench.scene(&fit.model, &view.stand).ok()?;
    prove::runs(bench, fit, separate).then_some(view)
}

/// Tells the developer what a round saw, where GYROSPEC_TRACE is set.
fn trace(bench: &Bench, round: &Round, now: &Measure) {
    if std::env::var_os("GYROSPEC_TRACE").is_none() {
        return;
    }
    let mut text = format!(
        "{:?} screened {} p {:.3} | now left-out {:.6} ln L {:.1} | {:e} steps of {:e}\n",
        std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).map(|d| d.as_secs() % 10_000),
        round.screening.screened.len(),
        round.screening.p_value,
        now.left_out,
        now.likelihood,
        bench.budget.spent() as f64,
        bench.budget.most() as f64
    );
    for s in round.screening.screened.iter().take(25) {
        text += &format!(
            "  s {:>9.2} {:.3} {:<22} {:<12} {}\n",
            s.score.statistic, s.explained, s.proposal.code, s.proposal.site.name, s.proposal.term
        );
    }
    for r in &round.fitted {
        let values: Vec<String> = r
            .proposal
            .added
            .iter()
            .map(|a| {
                let v = r
                    .fit
                    .model
                    .parameters
                    .iter()
                    .find(|p| p.name == a.name)
                    .map_or(f64::NAN, |p| a.unit.from_si(p.value));
                format!("{}={v:.5}", a.name)
            })
            .collect();
        text += &format!(
            "  f gain {:.4} dlnL {:>9.2} p {:.2e}{} {:<20} {:<10} {} rmse {:?}\n",
            gain(now, &r.measure),
            r.measure.likelihood - now.likelihood,
            r.p_value,
            if r.is_cut { " cut" } else { "" },
            r.proposal.code,
            r.proposal.site.name,
            values.join(" "),
            r.fit.rmse
        );
    }
    #[allow(clippy::print_stderr)]
    {
        eprintln!("{text}");
    }
}
