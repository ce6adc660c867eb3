//! Each finding of the answer: what it is, how large, and what it does to the held-out error.

use super::answer::{Evidence, Finding, Value};
use super::assemble::Assembly;
use super::catalogue::{ANY, Added};
use super::located::site_name;
use super::prove::{self, Held};
use super::search::{Found, Taken};
use super::{backward, words};
use crate::estimate::Fit;
use rayon::prelude::*;

impl Assembly<'_> {
    /// The last model without each finding in turn, where there are several: refitted, or all as they stand where the
    /// time did not do for that.
    pub fn smaller(&self) -> Vec<Option<Fit>> {
        let Found { taken, last, without, .. } = &self.found;
        if taken.len() < 2 {
            return vec![None; taken.len()];
        }
        if !without.is_empty() {
            return without.iter().map(|w| w.as_ref().map(|w| w.0.clone())).collect();
        }
        self.bench.budget.lift_time();
        taken.iter().map(|t| backward::without(&self.bench, last, &t.proposal, 0)).collect()
    }

    /// The findings, with the share that each has of what all lower the held-out error by.
    pub fn findings(&self, smaller: Vec<Option<Fit>>, before: &[Held], after: &[Held]) -> Vec<Finding> {
        let loss = |fit: Option<Fit>| self.loss_without(fit, before, after);
        let gains: Vec<f64> = smaller.into_par_iter().with_max_len(1).map(loss).collect();
        let total: f64 = gains.iter().sum();
        let even = 1.0 / gains.len().max(1) as f64;
        let share = |g: f64| if total > 0.0 { g / total } else { even };
        let told = self.found.taken.iter().zip(backward::evidence(&self.found));
        told.zip(gains).map(|((t, evidence), g)| self.finding(t, evidence, share(g))).collect()
    }

    /// How much the held-out error grows, relative to the error before, when one finding is taken away; at most to that: a run
    /// that goes astray then says no more of it, or the others would bear nothing.
    fn loss_without(&self, smaller: Option<Fit>, before: &[Held], after: &[Held]) -> f64 {
        let held = smaller.and_then(|f| prove::held_out(&self.bench, &f, &self.separate).ok());
        let relative = |held: &[Held]| -> f64 {
            held.iter().zip(before).map(|(h, b)| (h.rmse() / b.rmse()).min(1.0)).sum()
        };
        held.map_or(1.0, |h| (relative(&h) - relative(after)).max(1e-6))
    }

    fn finding(&self, taken: &Taken, evidence: Option<Evidence>, share: f64) -> Finding {
        let fit = &self.found.last;
        let p = &taken.proposal;
        // Without an interval a time or a level lies within its limits all the same.
        let value = |(i, a): (usize, &Added)| {
            let limits = if p.amplitudes.contains(&i) { ANY } else { p.limits[i] };
            let e = fit.parameters.iter().find(|e| e.name == a.name);
            let of = |x: Option<f64>| x.map_or(f64::NAN, |x| a.unit.difference_from_si(x));
            let or = |x: f64, limit: f64| if x.is_nan() && limit.is_finite() { limit } else { x };
            Value {
                name: a.name.clone(),
                value: of(e.map(|e| e.value)),
                low: of(e.map(|e| or(e.low, limits.0))),
                high: of(e.map(|e| or(e.high, limits.1))),
                unit: a.unit.text().to_string(),
            }
        };
        Finding {
            code: p.code.to_string(),
            site: site_name(&p.site),
            term: p.term.clone(),
            says: words::sentence(p, fit),
            parameters: p.added.iter().enumerate().map(value).collect(),
            p_value: taken.p_value,
            share,
            ties: taken.ties.iter().map(|t| t.code.to_string()).collect(),
            resembles: false,
            evidence: evidence.map(|e| Evidence { holdout_share: share, ..e }),
        }
    }
}
