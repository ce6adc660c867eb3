//! One round of the search: every proposal is screened by a score test, and the most promising are fitted inside the
//! model by simulation.

use super::bench::Bench;
use super::catalogue::Proposal;
use super::choose::{self, floor, gain, mends};
use super::compared::same_samples;
use super::measure::{Measure, SURELY, Scale, stands_on_few};
use super::propose::{Screened, Screening, screen, worth_fitting};
use super::race::{self, Against, By};
use super::twins::{finer, twins};
use super::view::View;
use super::{cut, lost, prove, scan};
use crate::Result;
use crate::estimate::Fit;
use crate::estimate::fit::Progress;
use crate::record::Recording;
use crate::simulate::Early;
use rayon::prelude::*;

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
    /// Others that lowered the error nearly as much when it was taken, and fitted less well.
    pub others: Vec<Proposal>,
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
    /// What is left for sure and too small to be named.
    pub small: Option<String>,
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
        let (fallen, is_trace, small) = (None, false, None);
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
            small,
            fallen,
            is_trace,
        }
    }

    /// Whether what is left is no noise for sure, though nothing that was tried lowers it by the floor.
    pub fn is_sure_trace(&self) -> bool {
        self.is_trace && self.first.p_value < choose::SURE
    }

    /// Puts another finding in the place of one, with the model fitted with it.
    pub fn replaces(&mut self, i: usize, taken: Taken, fit: Fit) {
        self.taken[i] = taken;
        self.last = fit;
        self.measures.1 = Measure::of(&self.last, &self.scale);
    }

    /// Likelihood of the last model less the price of all that was taken.
    pub fn worth(&self, scale: &Scale) -> f64 {
        let last = Measure::of(&self.last, scale);
        last.likelihood - self.taken.iter().map(|t| choose::price(&t.proposal, last.samples)).sum::<f64>()
    }

    /// Whether another search than the first found what is surely worth more. One that is over before its findings were asked
    /// whether they stand is no answer.
    pub fn is_surely_better(&self, bench: &Bench, first: &Found) -> bool {
        !is_over(bench) && self.worth(&first.scale) > first.worth(&first.scale) + SURELY
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
    /// One that looked at nothing.
    pub fn nothing() -> Self {
        Self { screening: Screening::nothing(), fitted: Vec::new(), notes: Vec::new(), fallen: None }
    }
}

/// What a round is judged against.
pub struct State<'a> {
    /// How good the model is so far.
    pub now: &'a Measure,
    /// The scale of comparison.
    pub scale: &'a Scale,
    /// Gains of what was taken before.
    pub gains: f64,
    /// What was taken before.
    pub taken: &'a [Taken],
    /// Whether no more may be added, so that it only looks.
    pub is_last: bool,
    /// A law whose look-alikes are not fitted.
    pub avoids: Option<&'a Proposal>,
}

/// Screens, fits the best, and judges them.
///
/// # Errors
/// Where the model cannot be run.
pub fn round(
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
    let State { now, scale, gains, taken, is_last, avoids } = state;
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
    let may = |s: &&Screened| avoids.is_none_or(|a| !is_alike(a, &s.proposal));
    let mut chosen: Vec<&Screened> = worth_fitting(&screening, most, least).into_iter().filter(may).collect();
    if taken.is_empty() && most > 0 {
        chosen.extend(lost::simple(bench, current, &screening, &chosen).into_iter().filter(may));
    }
    let squares = scale.squares(current);
    let judged = |p: Proposal, fit: Fit, is_cut: bool| {
        let measure = Measure::of(&fit, scale);
        let tried = tried * choose::chosen_from(&p, measure.samples);
        let chance = measure.chance_over(now.likelihood, p.added.len());
        let is_none = race::begins_alone(&p, &fit, (squares, scale)) || stands_on_few(current, &fit, scale);
        let p_value = if is_none { 1.0 } else { (tried * chance).min(1.0) };
        let floor = if mends(&p, taken) { floor(*gains) } else { least };
        Refitted { proposal: p, fit, measure, p_value, tried, floor, is_cut }
    };
    let refit = |chosen: &[&Screened]| -> Vec<Refitted> {
        let against = Against { squares, by: By::Likelihood(now.likelihood), scale };
        let finished = race::run(bench, view, given, chosen, against, progress).into_par_iter();
        let same = finished.filter(|f| same_samples(current, &f.fit));
        same.map(|f| judged(f.proposal, f.fit, f.is_cut)).collect()
    };
    let mut fitted = refit(&chosen);
    let others: Vec<&Screened> = twins(&screening, &fitted).into_iter().filter(may).collect();
    fitted.extend(refit(&others));
    for finer in finer(bench, &scene, view, &fitted) {
        let one = refit(&[&finer]);
        let is_beyond = one.iter().any(Refitted::is_pressed);
        fitted.extend(one);
        if !is_beyond {
            break;
        }
    }
    fitted.sort_by(|a, b| scale.squares(&a.fit).total_cmp(&scale.squares(&b.fit)));
    for r in fitted.iter_mut().take(SCANNED) {
        let better = scan::again(bench, view, &r.proposal, &r.fit, scale);
        if let Some(fit) = better.filter(|f| same_samples(current, f)) {
            let is_cut = fit.ended_early.is_some();
            *r = judged(r.proposal.clone(), fit, is_cut);
        }
    }
    bench.budget.begin("last fits");
    let notes = cut::retry(bench, &mut fitted, ((now, squares), scale), &judged);
    fitted.sort_by(|a, b| a.measure.left_out.total_cmp(&b.measure.left_out));
    Ok(Round { screening, fitted, notes, fallen: None })
}

/// Whether a proposal is a law of a signal that another is a law of too, or stands for the same at the same site.
fn is_alike(a: &Proposal, b: &Proposal) -> bool {
    let own = b.law_of();
    a.code == b.code && a.site == b.site || a.law_of().iter().any(|s| own.contains(s))
}

/// Whether the search must end with the best so far.
pub fn is_over(bench: &Bench) -> bool {
    bench.budget.over().is_some() || bench.budget.cut() == Some(Early::Time)
}

/// What a next round would see of a fitted model; none where it cannot be run there, or over what is held out.
pub fn ahead(bench: &Bench, separate: &[Recording], fit: &Fit) -> Option<View> {
    // the time that is up ends the search, and is no reason against what it found
    if bench.budget.over() == Some(Early::Time) {
        bench.budget.lift_time();
    }
    let view = View::of(bench, fit).ok()?;
    bench.scene(&fit.model, &view.stand).ok()?;
    prove::runs(bench, fit, separate).then_some(view)
}

/// Tells the developer what a round saw, where GYROSPEC_TRACE is set.
pub fn trace(bench: &Bench, round: &Round, now: &Measure) {
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
    for s in round.screening.free.iter().take(8) {
        let p = &s.proposal;
        let _ = std::fmt::Write::write_fmt(
            &mut text,
            format_args!(
                "  e {:>9.2} {:.3} {:<22} {:<12} {}\n",
                s.score.statistic, s.explained, p.code, p.site.name, p.term
            ),
        );
    }
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
