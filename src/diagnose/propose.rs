//! Proposals: scored, and the best fitted inside the model.
//!
//! # Purpose
//! From all extensions that the catalogue proposes to a few that are fitted by simulation.
//!
//! # Method
//! One free run a start gives the direction in which a proposal moves the predictions, at no effect
//! where an amplitude scales it, else over the whole start. The best are fitted from several sizes
//! of their effect, from the parameters as given and as fitted.
//!
//! # References
//! C. R. Rao, Proc. Cambridge Phil. Soc. 44 (1948) 50.
//!
//! # Numerical aspects
//! Coefficients start at a third and at the whole of the term that they stand beside, never near zero.

use super::bench::{self, Bench, Stand, Track};
use super::catalogue::{self, Proposal, Scene, SiteKind};
use super::choose::{CHANCE, is_wave};
use super::compared::same_tracks;
use super::foretold::Foretold;
use super::measure::Scale;
use super::screen::{Score, Screen, log_chance};
use super::search::Taken;
use super::view::View;
use crate::estimate::fit::Progress;
use rayon::prelude::*;

/// Starts of one proposal, beside the best, from which it is tried.
const FURTHER: usize = 2;

/// How strong a law that divides a parameter is at its usual level in one of its starts: the parameter is divided by 1 and this.
const STRONG: f64 = 4.0;

/// Factor on the sum of squares of the best start up to which another one is walked from too.
const NEAR: f64 = 3.0;

/// Statistic from which on a proposal is worth a fit; the least that a corrected chance of it could pass.
const LIKELY: f64 = 5.0;

/// Times that a fit may lower ln Σe² by more than its direction foretells: shapes adapt in the fit.
const HOPE: f64 = 4.0;

/// Proposals that may be the last, at most.
const LAST: usize = 8;

/// Proposals of one code that are fitted, and those with the same signals among them.
const OF_CODE: usize = 5;
const OF_SIGNALS: usize = 2;

/// Cosine of directions from which on two laws of a code move the outputs alike.
const ALIKE: f64 = 0.999;

/// Values among the starts of a proposal from which on a parameter of it has a range to look over.
const SEVERAL: usize = 5;
/// Ratio of the largest to the smallest of them from which on they are sizes, which walks find from any start.
const GRADUAL: f64 = 20.0;
/// Places of the grid over such a range.
const PLACES: usize = 120;

/// A proposal with its score.
#[derive(Clone)]
pub struct Screened {
    /// The proposal.
    pub proposal: Proposal,
    /// The start that scored best.
    pub start: Vec<f64>,
    /// Its score.
    pub score: Score,
    /// Share of the free-run residual's square that it explains.
    pub explained: f64,
    /// Share of the whitened residual's square that it explains.
    pub visible: f64,
    /// Weights of its directions in the free run.
    pub weights: Vec<f64>,
    /// Further starts that scored well, each with its own weights.
    pub further: Vec<Screened>,
}

/// Outcome of one screening.
#[derive(Clone)]
pub struct Screening {
    /// All that could be scored, best first.
    pub screened: Vec<Screened>,
    /// The same, by what they explain of the free run.
    pub free: Vec<Screened>,
    /// Chance that the largest score is noise.
    pub p_value: f64,
}

/// Every proposal of the catalogue that was not taken before and that another recording could confirm: of laws that are tied to
/// moments of one, those that may show in one that begins anew, where such is held out apart.
pub fn proposals(bench: &Bench, scene: &Scene, taken: &[Taken]) -> Vec<Proposal> {
    let mut proposals: Vec<Proposal> = catalogue::ALL.iter().flat_map(|m| (m.propose)(scene)).collect();
    let shares_a_clock = bench.recordings.len() == 1 || bench.recordings.iter().all(|r| r.is_piece);
    if bench.separate || !shares_a_clock {
        let may_return = |p: &Proposal| shares_a_clock && super::choose::may_return(p);
        proposals.retain(|p| !super::choose::is_anchored(p) || may_return(p));
    }
    proposals.retain(|p| !p.refines && !super::choose::is_repeated(p, taken));
    proposals
}

/// Scores every proposal of the catalogue that was not taken before.
pub fn screen(
    bench: &Bench,
    scene: &Scene,
    view: &View,
    taken: &[Taken],
    progress: &dyn Progress,
) -> Screening {
    let proposals = proposals(bench, scene, taken);
    let runs = proposals.iter().map(|p| p.starts.len()).sum();
    let stage = format!("looking at {} laws, {} found", proposals.len(), taken.len());
    let foretold = Foretold::begin(bench, progress, &stage, runs);
    let score = |p: Proposal| {
        let scored = score_starts(bench, &p, view);
        foretold.done(p.starts.len());
        scored
    };
    let scored: Vec<Vec<Screened>> = proposals.into_par_iter().with_max_len(1).map(score).collect();
    let all: Vec<&Score> = scored.iter().flatten().map(|s| &s.score).collect();
    let p_value = view.screen.p_value(&all);
    let mut screened: Vec<Screened> = scored.iter().filter_map(|l| best(l, &|s| s.score.statistic)).collect();
    screened.sort_by(|a, b| b.score.statistic.total_cmp(&a.score.statistic));
    let mut free: Vec<Screened> = scored.iter().filter_map(|l| best(l, &|s| s.explained)).collect();
    free.sort_by(|a, b| b.explained.total_cmp(&a.explained));
    Screening { screened, free, p_value }
}

/// Share of the score of what was taken from which on another law was as steep.
const AS_STEEP: f64 = 0.95;
/// How many of these are remembered.
const REMEMBERED: usize = 3;

impl Screening {
    /// Other laws whose first steps promised as much as one that is taken, the best first: what is still missing bends the
    /// fits of some more than those of others.
    pub fn as_steep(&self, taken: &Proposal) -> Vec<Proposal> {
        let is = |s: &&Screened| s.proposal.code == taken.code && s.proposal.site == taken.site;
        let own = self.screened.iter().find(is).map_or(f64::INFINITY, |s| s.score.statistic);
        let others = self.screened.iter().filter(|s| s.proposal.code != taken.code);
        let steep = others.filter(|s| s.score.statistic > AS_STEEP * own);
        steep.take(REMEMBERED).map(|s| s.proposal.clone()).collect()
    }

    /// One of nothing.
    pub fn nothing() -> Self {
        Self { screened: Vec::new(), free: Vec::new(), p_value: 1.0 }
    }

    /// Whether one of the best proposals alone would leave nothing that another one sees, to first order,
    /// and nothing that follows from sample to sample, as in trials in a row: chances are too small then.
    pub fn ends_with_one(&self, view: &View) -> bool {
        let leaves_nothing = |best: &Screened| {
            let along = |d: &[f32], e: &[f64]| d.iter().zip(e).map(|(d, e)| f64::from(*d) * e).sum::<f64>();
            let own = &best.score.direction;
            let mut rest = view.screen.residual.clone();
            let size = along(own, &rest);
            rest.iter_mut().zip(own).for_each(|(e, d)| *e -= size * f64::from(*d));
            let largest = self.screened.iter().map(|s| along(&s.score.direction, &rest).powi(2));
            let largest = largest.fold(0.0, f64::max);
            let next = rest.windows(2).map(|w| w[0] * w[1]).sum::<f64>().abs();
            next < 3.0 * (rest.len() as f64).sqrt()
                && self.screened.len() as f64 * log_chance(largest, 1).exp() > CHANCE
        };
        self.p_value < CHANCE && self.screened.iter().take(LAST).any(leaves_nothing)
    }
}

/// Proposals by what their directions explain of the free run, the largest first, none that moves the outputs as a better
/// one does.
pub fn explaining(bench: &Bench, view: &View, proposals: Vec<Proposal>) -> Vec<Screened> {
    let scored = proposals.into_par_iter().with_max_len(1).map(|p| score_starts(bench, &p, view));
    let scored: Vec<Vec<Screened>> = scored.collect();
    let mut all: Vec<Screened> = scored.iter().filter_map(|l| best(l, &|s| s.explained)).collect();
    all.sort_by(|a, b| b.explained.total_cmp(&a.explained));
    all
}

/// The start that is best by some figure, with the next ones.
fn best(list: &[Screened], by: &dyn Fn(&Screened) -> f64) -> Option<Screened> {
    let mut sorted: Vec<&Screened> = list.iter().collect();
    sorted.sort_by(|a, b| by(b).total_cmp(&by(a)));
    let mut first = (*sorted.first()?).clone();
    first.further = sorted[1..].iter().take(FURTHER).map(|s| (*s).clone()).collect();
    Some(first)
}

/// The scored starts of a proposal.
fn score_starts(bench: &Bench, proposal: &Proposal, view: &View) -> Vec<Screened> {
    if proposal.amplitudes.is_empty() {
        return score_moves(bench, proposal, view);
    }
    let count = proposal.amplitudes.len();
    let at_rest = view.at_rest(bench, proposal);
    let one = |start: &Vec<f64>| {
        let tracks = at_rest.tracks(start)?;
        scored(view, proposal, start, &|space| {
            (0..count).map(|j| space.whitened(&tracks, |t| &t.sensitivities[j])).collect()
        })
    };
    proposal.starts.iter().filter_map(one).collect()
}

/// The scored starts of a proposal that has no amplitude: how far it moves the predictions from there.
fn score_moves(bench: &Bench, proposal: &Proposal, view: &View) -> Vec<Screened> {
    let Ok(records) = view.ready(bench, &proposal.model) else { return Vec::new() };
    let one = |start: &Vec<f64>| {
        let stand = view.stand.extended(&proposal.model, start);
        let tracks = bench::run(&records, &stand, &[]).ok()?;
        let moved = same_tracks(&tracks, &view.tracks).then(|| difference(&view.tracks, &tracks))?;
        scored(view, proposal, start, &|space| vec![space.whitened(&moved, |t| &t.residual)])
    };
    proposal.starts.iter().filter_map(one).collect()
}

/// A start with its score from the directions in a screening space.
fn scored(
    view: &View,
    proposal: &Proposal,
    start: &[f64],
    directions: &dyn Fn(&Screen) -> Vec<Vec<f64>>,
) -> Option<Screened> {
    let one_sided = proposal.is_one_sided();
    let free = view.free.score(&directions(&view.free), one_sided);
    let explained =
        free.as_ref().filter(|f| f.statistic > 0.0).map_or(0.0, |f| f.chi2 / view.free.residual.len() as f64);
    let weights = free.map(|f| f.weights).unwrap_or_default();
    let mut score = view.screen.score(&directions(&view.screen), one_sided)?;
    let visible = score.chi2 / view.screen.residual.len().max(1) as f64;
    let chosen = super::choose::chosen_from(proposal, view.screen.residual.len() as f64);
    score.statistic = (score.statistic - chosen.ln()).max(0.0);
    Some(Screened {
        proposal: proposal.clone(),
        start: start.to_vec(),
        score,
        explained,
        visible,
        weights,
        further: Vec::new(),
    })
}

/// How far the prediction moves from one run to another.
pub fn difference(from: &[Track], to: &[Track]) -> Vec<Track> {
    from.iter()
        .zip(to)
        .map(|(a, b)| Track {
            output: a.output,
            stretches: a.stretches.clone(),
            time: Vec::new(),
            residual: a.residual.iter().zip(&b.residual).map(|(x, y)| x - y).collect(),
            sensitivities: Vec::new(),
        })
        .collect()
}

impl Screened {
    /// Whether its fall of ln Σe², foretold from its direction alone, may reach a floor once it is fitted.
    fn may_reach(&self, floor: f64) -> bool {
        -HOPE * (1.0 - self.explained.max(self.visible).clamp(0.0, 0.999)).ln() > floor
    }
}

/// The proposals worth a fit: in turn the best by likelihood and by the free run, a few of one code,
/// of those that may lower ln Σe² by a floor.
pub fn worth_fitting(screening: &Screening, most: usize, floor: f64) -> Vec<&Screened> {
    let likely = screening.screened.iter().filter(|s| s.score.statistic > LIKELY && s.may_reach(floor));
    let free = screening.free.iter().filter(|s| s.explained > 0.03 && s.may_reach(floor));
    let mut lists = [likely.collect::<Vec<_>>().into_iter(), free.collect::<Vec<_>>().into_iter()];
    let mut chosen: Vec<&Screened> = Vec::new();
    let mut turn = 0;
    let mut idle = 0;
    while chosen.len() < most && idle < 2 {
        let next = lists[turn].by_ref().find(|s| is_new(&chosen, s));
        idle = if next.is_some() { 0 } else { idle + 1 };
        chosen.extend(next);
        turn = 1 - turn;
    }
    let mut forms: Vec<&Screened> = Vec::new();
    for c in &chosen {
        let is_there = |s: &Screened| chosen.iter().any(|c| c.proposal.term == s.proposal.term);
        forms.extend(screening.screened.iter().filter(|s| is_form(c, s) && !is_there(s)));
    }
    chosen.extend(forms);
    chosen
}

/// Whether a change of a parameter is another form of one, which moves the outputs alike while both are small, and otherwise
/// when not.
fn is_form(of: &Screened, s: &Screened) -> bool {
    let (p, q) = (&of.proposal, &s.proposal);
    let is_other = p.code == q.code && p.site == q.site && p.term != q.term;
    is_other && p.site.kind == SiteKind::Parameter && is_alike(&of.score, &s.score)
}

/// Whether a proposal differs from those chosen: they hold few of its code, and fewer with its signals.
fn is_new(chosen: &[&Screened], s: &Screened) -> bool {
    let same: Vec<&&Screened> = chosen.iter().filter(|c| c.proposal.code == s.proposal.code).collect();
    let of_signals = same.iter().filter(|c| c.proposal.depends == s.proposal.depends).count();
    let most = if is_wave(&s.proposal) { OF_CODE } else { OF_SIGNALS };
    of_signals < most && same.len() < OF_CODE && !same.iter().any(|c| is_alike(&c.score, &s.score))
}

fn is_alike(a: &Score, b: &Score) -> bool {
    let along = a.direction.iter().zip(&b.direction).map(|(x, y)| f64::from(*x) * f64::from(*y)).sum::<f64>();
    a.degrees == b.degrees && along.abs() > ALIKE
}

/// The best starts of a screened proposal inside the model, from several sizes of its effect.
pub fn starts(bench: &Bench, view: &View, given: &[f64], s: &Screened, scale: &Scale) -> Vec<Stand> {
    let (p, base) = (&s.proposal, &view.stand);
    let likely = sizes(s).into_iter().next().unwrap_or_else(|| s.start.clone());
    let model = base.extended(&p.model, &likely).placed(&p.model);
    let Ok(records) = view.ready(bench, &model) else { return Vec::new() };
    let squares = |stand: &Stand| {
        let tracks = bench::run(&records, stand, &[]).ok();
        let of = |t: &Track| scale.weights[t.output] * t.residual.iter().map(|e| e * e).sum::<f64>();
        tracks.map_or(f64::INFINITY, |t| t.iter().map(of).sum())
    };
    let mut from_given = base.clone();
    from_given.parameters[..given.len()].copy_from_slice(given);
    let mut stands: Vec<(f64, Stand)> = Vec::new();
    // Every size from the fitted parameters; from the given ones, and at further starts, the likely sizes.
    let finer = finer(bench, view, s);
    for (i, start) in std::iter::once(s).chain(&s.further).chain(&finer).enumerate() {
        let sizes = sizes(start);
        let likely = &sizes[..sizes.len().min(2)];
        let own = if i == 0 { &sizes[..] } else { likely };
        let anew = if i == 0 { likely.last() } else { None };
        let tried = own.iter().map(|a| base.extended(&p.model, a));
        let tried = tried.chain(anew.map(|a| from_given.extended(&p.model, a)));
        let scored = tried.map(|stand| (squares(&stand), stand)).filter(|s| s.0.is_finite());
        let best = scored.min_by(|a, b| a.0.total_cmp(&b.0));
        let weak = if i == 0 { weak(s).map(|a| base.extended(&p.model, &a)) } else { None };
        let weak = weak.map(|stand| (squares(&stand), stand));
        let is_far = |w: &(f64, Stand)| best.as_ref().is_none_or(|b| b.0 > FAR_OFF * w.0);
        stands.extend(weak.filter(is_far).or(best));
    }
    stands.sort_by(|a, b| a.0.total_cmp(&b.0));
    let near = stands.first().map_or(0.0, |s| NEAR * s.0);
    let strong = made_up(p, base, s);
    let most = if strong.is_some() { 1 } else { 2 };
    stands.into_iter().take(most).filter(|s| s.0 <= near).map(|s| s.1).chain(strong).collect()
}

/// A strong start of a law that divides a parameter, with that as large as makes up for it on the whole: from a weak one
/// the way along which both grow is long.
fn made_up(p: &Proposal, base: &Stand, s: &Screened) -> Option<Stand> {
    let (name, level) = p.makes_up.as_ref()?;
    let divided = p.model.parameters.iter().position(|own| own.name == *name)?;
    let mut added = p.quiet(&s.start);
    *added.first_mut()? = STRONG / level;
    let mut stand = base.extended(&p.model, &added);
    stand.parameters[divided] *= 1.0 + STRONG;
    Some(stand)
}

/// The places at which a parameter may be, between those of its starts and one beyond; none where its starts are few.
pub fn places(p: &Proposal, shape: usize) -> Vec<f64> {
    let mut starts: Vec<f64> = p.starts.iter().map(|s| s[shape]).collect();
    starts.sort_by(f64::total_cmp);
    starts.dedup();
    if starts.len() < SEVERAL || starts[0] > 0.0 && starts[starts.len() - 1] > GRADUAL * starts[0] {
        return Vec::new();
    }
    let (first, last) = (starts[0], starts[starts.len() - 1]);
    let beyond = (last - first) / (starts.len() - 1) as f64;
    let low = (first - beyond).max(p.limits[shape].0);
    let high = (last + beyond).min(p.limits[shape].1);
    (0..PLACES).map(|i| low + (high - low) * (i as f64 + 0.5) / PLACES as f64).collect()
}

/// The best starts of a screened proposal by likelihood and by the free run over the whole range of its shapes, where
/// these have one.
fn finer(bench: &Bench, view: &View, s: &Screened) -> Vec<Screened> {
    let p = &s.proposal;
    let shapes = (0..p.added.len()).filter(|k| !p.amplitudes.contains(k));
    let all = shapes.flat_map(|k| {
        let at =
            |value: f64| s.start.iter().enumerate().map(|(j, x)| if j == k { value } else { *x }).collect();
        places(p, k).into_iter().map(at).collect::<Vec<Vec<f64>>>()
    });
    let starts: Vec<Vec<f64>> = all.collect();
    if starts.is_empty() {
        return Vec::new();
    }
    let scored = score_starts(bench, &Proposal { starts, ..p.clone() }, view);
    let likeliest = scored.iter().max_by(|a, b| a.score.statistic.total_cmp(&b.score.statistic));
    let largest = scored.iter().max_by(|a, b| a.explained.total_cmp(&b.explained));
    likeliest.into_iter().chain(largest).cloned().collect()
}

/// Share of the scored size at which a start is as good as the model without it, and times what that leaves from which on
/// every larger one is far off: the model's own parameters stay behind, and the first step from a weak one moves all together.
const WEAK: f64 = 0.02;
const FAR_OFF: f64 = 4.0;
/// Share of what is left that it must explain to first order.
const MOST: f64 = 0.8;

/// A weak start of the scored size, where it may explain nearly all.
fn weak(s: &Screened) -> Option<Vec<f64>> {
    let weights: Vec<f64> = s.score.weights.iter().map(|w| WEAK * w).collect();
    (!s.proposal.amplitudes.is_empty() && s.explained > MOST)
        .then(|| s.proposal.with_amplitudes(&s.start, &weights))
}

/// Starts of the added parameters: the scored size, and parts of the term's own size.
fn sizes(s: &Screened) -> Vec<Vec<f64>> {
    let p = &s.proposal;
    if p.amplitudes.is_empty() {
        return p.starts.iter().filter(|x| **x == s.start).cloned().collect();
    }
    let natural: Vec<f64> = p.amplitudes.iter().map(|k| s.start[*k]).collect();
    let scored: Vec<f64> =
        s.score.weights.iter().zip(&natural).map(|(w, n)| w.clamp(-3.0 * n.abs(), 3.0 * n.abs())).collect();
    let in_free_run: Vec<f64> =
        s.weights.iter().zip(&natural).map(|(w, n)| w.clamp(-10.0 * n.abs(), 10.0 * n.abs())).collect();
    let part =
        |f: f64| -> Vec<f64> { scored.iter().zip(&natural).map(|(w, n)| f * n.abs() * w.signum()).collect() };
    [scored.clone(), in_free_run, part(0.3), part(1.0)]
        .iter()
        .map(|a| p.with_amplitudes(&s.start, a))
        .collect()
}
