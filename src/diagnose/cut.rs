//! Proposals whose own fits were ended by their steps.
//!
//! # Purpose
//! A proposal that alone turned stiff and spent its share is no early end of the search, unless it may be
//! what is missing.
//!
//! # Method
//! Such a fit is judged by the best that it reached, with all that its own sensitivities promise from there:
//! its likelihood is already that of the linear problem, and so is the least sum of squares. One that would
//! not stand even so has fallen out, and one that would stand plainly behind another that came to its end can neither be
//! chosen nor tie with it. One that might is fitted on with a share of all that is left; where that does not bring it to its
//! end either, the search is told to have ended early.

use super::bench::Bench;
use super::catalogue::Proposal;
use super::choose::{CHANCE, PLAINLY, alike, gain, worth_of};
use super::measure::{Measure, Scale, promised};
use super::race::to_the_end;
use super::search::Refitted;
use crate::estimate::Fit;
use crate::simulate::Early;
use rayon::prelude::*;

/// Times the squares of the model as it is from which on sensitivities promise nothing.
const BLOWN_UP: f64 = 10.0;
/// Share of what is left that the retried may spend together: one part in so many.
const RETRIES: u64 = 2;

/// Fits those on that were cut and might stand, and tells the budget of those that might still; with what a
/// reader should know. `now` is the model as it is, and what it leaves, weighed by the scale.
pub fn retry(
    bench: &Bench,
    fitted: &mut Vec<Refitted>,
    (now, scale): ((&Measure, f64), &Scale),
    judged: &(dyn Fn(Proposal, Fit, bool) -> Refitted + Sync),
) -> Vec<String> {
    if bench.budget.cut() == Some(Early::Time) {
        return Vec::new();
    }
    let stands = |r: &&Refitted| {
        !r.is_cut && r.p_value < CHANCE && gain(now.0, &r.measure) > r.floor && !r.is_pressed()
    };
    let ahead: Vec<(Proposal, Measure)> =
        fitted.iter().filter(stands).map(|r| (r.proposal.clone(), r.measure)).collect();
    let promises = |r: &Refitted| {
        let is_near = r.p_value < CHANCE && scale.squares(&r.fit) < BLOWN_UP * now.1;
        let gain = if is_near { (now.1 / promised(&r.fit, scale)).ln() } else { 0.0 };
        (gain > r.floor).then_some(gain)
    };
    let is_beaten = |r: &Refitted, gain: f64| ahead.iter().any(|a| is_behind((r, gain), a, now.0));
    let may_stand = |r: &Refitted| r.is_cut && promises(r).is_some_and(|gain| !is_beaten(r, gain));
    let count = fitted.iter().filter(|r| may_stand(r)).count() as u64;
    let share = bench.budget.rest().part(RETRIES * count.max(1));
    fitted.par_iter_mut().with_max_len(1).filter(|r| may_stand(r)).for_each(|r| {
        // As much for each, whatever the others spend beside it.
        if let Some(fit) = to_the_end(bench, &r.proposal, &r.fit, &share.part(1)) {
            let is_cut = fit.ended_early.is_some();
            let on = judged(r.proposal.clone(), fit, is_cut);
            if scale.squares(&on.fit) <= scale.squares(&r.fit) {
                *r = on;
            }
        }
    });
    let open: Vec<&Refitted> = fitted.iter().filter(|r| may_stand(r)).collect();
    for r in &open {
        bench.budget.tell(r.fit.ended_early);
    }
    let told = |r: &&Refitted| format!("{} ({})", r.proposal.code, r.proposal.site.name);
    let list = |all: &[&Refitted]| all.iter().map(told).collect::<Vec<_>>().join(", ");
    let fallen: Vec<&Refitted> = fitted.iter().filter(|r| r.is_cut && promises(r).is_none()).collect();
    let mut notes = Vec::new();
    if !open.is_empty() {
        notes.push(format!("what may be missing was not fitted to the end: {}", list(&open)));
    }
    if !fallen.is_empty() {
        notes.push(format!(
            "each of these was given up once its simulated steps were spent, and nothing foretells that it would have \
             lowered the error by what counts: {}",
            list(&fallen)
        ));
    }
    notes
}

/// Whether one that promises a gain stands plainly behind another that gains as much.
fn is_behind((r, promised): (&Refitted, f64), (p, ahead): &(Proposal, Measure), now: &Measure) -> bool {
    let is_likelier = worth_of(p, ahead) > worth_of(&r.proposal, &r.measure) + PLAINLY;
    gain(now, ahead) >= promised && is_likelier && !alike((&r.proposal, &r.measure), (p, ahead), now)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::catalogue;
    use crate::diagnose::laboratory::Stepper;
    use crate::diagnose::measure::Measure;
    use crate::diagnose::view::View;
    use crate::estimate::fit;
    use crate::estimate::fit::Effort;
    use crate::model::Model;
    use crate::record::{Channel, Recording};
    use crate::simulate::Budget;
    use crate::units::Unit;

    /// A motor and what drives it late, by a lag in s; with noise of 0.1 %.
    fn bench(lag: f64) -> (Bench, Model) {
        let model = |lag: &str, time: f64| {
            let text = format!(
                "name = \"motor\"\n[inputs]\nu = {{ unit = \"V\" }}\n[parameters]\n\
                 T = {{ value = 0.5, unit = \"s\", fit = true, min = 0.01 }}\n\
                 late = {{ value = {time}, unit = \"s\" }}\n[states]\n\
                 w = {{ rate = \"({lag} - w)/T\", unit = \"V\", initial = 0 }}\n\
                 [outputs]\nspeed = {{ equals = \"w\", unit = \"V\" }}\n"
            );
            Model::parse(&text).expect("a model")
        };
        let time: Vec<f64> = (0..500).map(|i| 0.05 * f64::from(i)).collect();
        let u =
            time.iter().map(|t| (1.1 * t).sin() + 0.7 * (4.3 * t).cos() + 0.5 * (9.1 * t).sin()).collect();
        let volt = || Unit::parse("V").expect("a unit");
        let zeros = vec![0.0; time.len()];
        let channels = vec![
            Channel::new("u", volt(), time.clone(), u),
            Channel::new("speed", volt(), time.clone(), zeros),
        ];
        let mut recording = Recording::from_channels("motor", channels).expect("a recording");
        let truth = if lag > 0.0 { model("lag(u, late)", lag) } else { model("u", 1.0) };
        let speed = Stepper::new(&truth, &recording).expect("a run").outputs(&time).remove(0);
        let noise = (0..500).map(|i| 1e-3 * (f64::from(i * i) * 0.7).sin());
        recording.channels[1].values = speed.iter().zip(noise).map(|(y, e)| y + e).collect();
        let model = model("u", 1.0);
        (Bench::new(&model, vec![recording], false, 1), model)
    }

    /// What becomes of a lag of the input whose fit was cut at its start, with so many steps left to all.
    fn retried(lag: f64, left: Option<u64>) -> (Refitted, Option<Early>, Vec<String>) {
        retried_beside(lag, left, None)
    }

    /// The same beside another that came to its end: by how much it is likelier, and which part of the promised squares it
    /// leaves.
    fn retried_beside(
        lag: f64,
        left: Option<u64>,
        beside: Option<(f64, f64)>,
    ) -> (Refitted, Option<Early>, Vec<String>) {
        let (mut bench, model) = bench(lag);
        let base = bench.full_fit(&model).expect("a fit");
        let scale = Scale::of(&base, false);
        let now = Measure::of(&base, &scale);
        let view = View::of(&bench, &base).expect("a view");
        let scene = bench.scene(&base.model, &view.stand).expect("a scene");
        let lags = catalogue::ALL.iter().find(|m| m.code == "input-lag").expect("a mechanism");
        let proposal = (lags.propose)(&scene).remove(0);
        let stand = view.stand.extended(&proposal.model, &proposal.starts[0]);
        let mut options = bench.options(Effort::Near, 40);
        options.budget = Budget::new(200_000, None).part(200_000);
        options.initials = stand.initials.clone();
        let heat = fit(&stand.placed(&proposal.model), &bench.recordings, &options).expect("a fit");
        assert_eq!(heat.ended_early, Some(Early::Steps));
        let judged = |p: Proposal, fit: Fit, is_cut: bool| {
            let measure = Measure::of(&fit, &scale);
            let p_value = measure.chance_over(now.likelihood, p.added.len());
            Refitted { proposal: p, fit, measure, p_value, tried: 1.0, floor: 0.04, is_cut }
        };
        let mut fitted = vec![judged(proposal, heat, true)];
        if let Some((likelier, part)) = beside {
            let mut other = Refitted { is_cut: false, ..fitted[0].clone() };
            other.proposal.code = "input-saturation";
            other.measure.likelihood += likelier;
            other.measure.left_out =
                now.left_out * part * promised(&other.fit, &scale) / scale.squares(&base);
            fitted.push(other);
        }
        if let Some(left) = left {
            bench.budget = Budget::new(left, None);
        }
        let notes = retry(&bench, &mut fitted, ((&now, scale.squares(&base)), &scale), &judged);
        (fitted.remove(0), bench.budget.cut(), notes)
    }

    #[test]
    fn one_that_may_be_missing_is_fitted_on_with_what_is_left() {
        let (lag, cut, notes) = retried(0.1, None);
        assert!(!lag.is_cut && cut.is_none() && notes.is_empty(), "{cut:?} {notes:?}");
        let time = lag.fit.parameters.iter().find(|p| p.name == lag.proposal.added[0].name).expect("a time");
        assert!((time.value - 0.1).abs() < 0.01, "{time:?}");
    }

    #[test]
    fn one_that_is_plainly_behind_another_even_as_promised_is_left() {
        let (lag, cut, notes) = retried_beside(0.1, None, Some((2.0 * PLAINLY, 0.9)));
        assert!(lag.is_cut && cut.is_none() && notes.is_empty(), "{cut:?} {notes:?}");
        for nearly in [(0.5 * PLAINLY, 0.9), (2.0 * PLAINLY, 1.1)] {
            let (lag, cut, _) = retried_beside(0.1, None, Some(nearly));
            assert!(!lag.is_cut && cut.is_none(), "{nearly:?}");
        }
    }

    #[test]
    fn one_that_may_be_missing_and_cannot_be_fitted_on_is_an_early_end() {
        let (lag, cut, notes) = retried(0.1, Some(2000));
        assert!(lag.is_cut && cut == Some(Early::Steps), "{cut:?}");
        assert!(notes.len() == 1 && notes[0].contains("input-lag (u)"), "{notes:?}");
    }

    #[test]
    fn one_that_promises_nothing_has_fallen_out() {
        let (lag, cut, notes) = retried(0.0, Some(2000));
        assert!(lag.is_cut && cut.is_none(), "{cut:?}, chance {}", lag.p_value);
        assert!(notes.len() == 1 && notes[0].contains("given up"), "{notes:?}");
    }
}
