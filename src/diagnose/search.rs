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

use super::bench::{self, Bench, Stand, Track};
use super::catalogue::{self, Proposal, Scene};
use super::measure::{Measure, Scale};
use super::screen::{Score, Screen, log_chance};
use crate::Result;
use crate::estimate::fit::{Effort, Progress};
use crate::estimate::{Fit, fit};
use rayon::prelude::*;

/// Mechanisms that are added at most.
const MOST: usize = 3;
/// Share of all gains before that a further one must reach.
const FURTHER: f64 = 0.2;
/// Weight of the gain of a mechanism that is tied to moments of this recording.
const ANCHORED: f64 = 0.6;
/// Steps of a fit.
const STEPS: usize = 10;
/// Chance, after correction, above which nothing is added.
const CHANCE: f64 = 0.01;
/// Relative fall of the left-out root mean square below which nothing is added.
const FLOOR: f64 = 0.02;
/// Difference in log-likelihood up to which two extensions fit as well.
const TIE: f64 = 2.0;
/// Share of the largest free-run gain that a likelier rival must reach.
const RIVAL: f64 = 0.75;
/// Share of its gain by which an extension that commutes with another may differ from it.
const COMMUTES: f64 = 0.2;

/// A proposal with its score.
#[derive(Clone)]
pub struct Screened {
    /// The proposal.
    pub proposal: Proposal,
    /// The start that scored best.
    pub start: Vec<f64>,
    /// Its score.
    pub score: Score,
}

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
}

/// A mechanism that was taken into the model.
#[derive(Clone)]
pub struct Taken {
    /// The proposal.
    pub proposal: Proposal,
    /// Chance, corrected.
    pub p_value: f64,
    /// Others that fit as well.
    pub ties: Vec<Proposal>,
    /// The same mechanism at other sites that fit as well.
    pub elsewhere: Vec<Proposal>,
}

/// Outcome of one screening.
pub struct Screening {
    /// All that could be scored, best first.
    pub screened: Vec<Screened>,
    /// Chance that the largest score is noise.
    pub p_value: f64,
}

/// Where the search ended.
pub struct Found {
    /// The model as given, fitted.
    pub base: Fit,
    /// The model with all that was taken, fitted.
    pub last: Fit,
    /// What was taken, in order.
    pub taken: Vec<Taken>,
    /// The first screening.
    pub first: Screening,
    /// Screening of what the last model leaves.
    pub rest: Screening,
    /// The scale of comparison.
    pub scale: Scale,
    /// Measures of base and last.
    pub measures: (Measure, Measure),
}

impl Found {
    /// ln of the fall of the left-out sum of squares from the given model to the last.
    pub fn gain(&self) -> f64 {
        gain(&self.measures.0, &self.measures.1)
    }
}

/// The whitened residual of a fitted model on the screened parts, with its records' tracks.
pub struct View {
    /// Screening space.
    pub screen: Screen,
    /// Where the model stands.
    pub stand: Stand,
    /// Tracks of the model itself.
    pub tracks: Vec<Track>,
}

impl View {
    /// Looks at a fitted model.
    pub fn of(bench: &Bench, fit: &Fit) -> Result<Self> {
        let stand = Stand::of(fit);
        let records = bench.ready(&fit.model)?;
        let plain = bench::run(&records, &stand, &[])?;
        let mut noise = fit.noise.clone();
        if bench.is_trials() {
            for n in &mut noise {
                n.decimation = 1;
                n.autoregression = n.autoregression.truncated(0);
            }
        }
        let own = own_tracks(fit, &plain);
        Ok(Self { screen: Screen::new(&own, &noise, bench.seed), stand, tracks: plain })
    }
}

/// The fit's residuals and sensitivities, cut to the screened parts.
fn own_tracks(fit: &Fit, plain: &[Track]) -> Vec<Track> {
    let series = fit.records.iter().flat_map(|r| &r.series);
    series
        .zip(plain)
        .map(|(s, t)| {
            let n = t.residual.len();
            Track {
                output: s.output,
                stretches: t.stretches.clone(),
                time: s.time[..n].to_vec(),
                residual: s.residual[..n].to_vec(),
                sensitivities: s.sensitivities.iter().map(|c| c[..n].to_vec()).collect(),
            }
        })
        .collect()
}

/// Scores every proposal of the catalogue.
pub fn screen(bench: &Bench, scene: &Scene, view: &View) -> Screening {
    let mut proposals: Vec<Proposal> = catalogue::ALL.iter().flat_map(|m| (m.propose)(scene)).collect();
    if bench.separate || bench.recordings.len() > 1 {
        proposals.retain(|p| !is_anchored(p));
    }
    let scored: Vec<Vec<Screened>> =
        proposals.into_par_iter().map(|p| score_starts(bench, &p, view)).collect();
    let all: Vec<&Score> = scored.iter().flatten().map(|s| &s.score).collect();
    let p_value = Screen::p_value(&all);
    let best =
        |list: Vec<Screened>| list.into_iter().max_by(|a, b| a.score.statistic.total_cmp(&b.score.statistic));
    let mut screened: Vec<Screened> = scored.into_iter().filter_map(best).collect();
    screened.sort_by(|a, b| b.score.statistic.total_cmp(&a.score.statistic));
    Screening { screened, p_value }
}

fn score_starts(bench: &Bench, proposal: &Proposal, view: &View) -> Vec<Screened> {
    let Ok(records) = bench.ready(&proposal.model) else { return Vec::new() };
    let first = proposal.model.parameters.len();
    let place = |k: usize| {
        let name = &proposal.added[k].name;
        proposal.model.parameters.iter().position(|p| p.name == *name).unwrap_or(first)
    };
    let wanted: Vec<usize> = proposal.amplitudes.iter().map(|k| place(*k)).collect();
    let mut scored = Vec::new();
    for start in &proposal.starts {
        let quiet = if wanted.is_empty() {
            start.clone()
        } else {
            proposal.with_amplitudes(start, &vec![0.0; wanted.len()])
        };
        let stand = view.stand.extended(&proposal.model, &quiet);
        let Ok(tracks) = bench::run(&records, &stand, &wanted) else { continue };
        let directions = if wanted.is_empty() {
            vec![view.screen.whitened(&difference(&view.tracks, &tracks), |t| &t.residual)]
        } else {
            (0..wanted.len()).map(|j| view.screen.whitened(&tracks, |t| &t.sensitivities[j])).collect()
        };
        if let Some(mut score) = view.screen.score(directions, proposal.is_one_sided()) {
            if is_timed_wave(proposal) {
                // Its frequency is the best of all that the recording resolves.
                let frequencies = 0.5 * view.screen.residual.len() as f64;
                score.statistic = (score.statistic - frequencies.max(1.0).ln()).max(0.0);
            }
            scored.push(Screened { proposal: proposal.clone(), start: start.clone(), score });
        }
    }
    scored
}

/// How far the prediction moves from one run to another.
fn difference(from: &[Track], to: &[Track]) -> Vec<Track> {
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

/// The proposals worth a fit: the best, not more than a few of one code.
fn worth_fitting(screening: &Screening, most: usize) -> Vec<&Screened> {
    let mut chosen: Vec<&Screened> = Vec::new();
    for s in &screening.screened {
        let same = chosen.iter().filter(|c| c.proposal.code == s.proposal.code).count();
        let alike = chosen.iter().any(|c| {
            c.proposal.code == s.proposal.code
                && c.score.degrees == s.score.degrees
                && cosine(&c.score, &s.score) > 0.999
        });
        if same < 3 && !alike && s.score.statistic > 3.0 {
            chosen.push(s);
        }
        if chosen.len() >= most {
            break;
        }
    }
    chosen
}

fn cosine(a: &Score, b: &Score) -> f64 {
    a.direction.iter().zip(&b.direction).map(|(x, y)| f64::from(*x) * f64::from(*y)).sum::<f64>().abs()
}

/// Fits a screened proposal inside the model, from several sizes of its effect.
pub fn refit(bench: &Bench, base: &Stand, given: &[f64], s: &Screened) -> Option<Fit> {
    let p = &s.proposal;
    let records = bench.ready(&p.model).ok()?;
    let squares = |stand: &Stand| {
        let tracks = bench::run(&records, stand, &[]).ok();
        tracks.map_or(f64::INFINITY, |t| t.iter().flat_map(|t| &t.residual).map(|e| e * e).sum())
    };
    let mut from_given = base.clone();
    from_given.parameters[..given.len()].copy_from_slice(given);
    let mut stands: Vec<(f64, Stand)> = Vec::new();
    for added in sizes(s) {
        for from in [base, &from_given] {
            let stand = from.extended(&p.model, &added);
            stands.push((squares(&stand), stand));
        }
    }
    stands.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut best: Option<Fit> = None;
    let now = stands.first().map_or(0.0, |s| s.0);
    for (value, stand) in stands.into_iter().take(2) {
        let enough = best.is_some() && value > 1.2 * now;
        if !value.is_finite() || enough {
            continue;
        }
        let mut options = bench.options(Effort::Near, STEPS);
        options.initials = stand.initials.clone();
        if let Ok(f) = fit(&stand.placed(&p.model), &bench.recordings, &options) {
            if best.as_ref().is_none_or(|b| f.sum_of_squares < b.sum_of_squares) {
                best = Some(f);
            }
        }
    }
    best
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
    let part =
        |f: f64| -> Vec<f64> { scored.iter().zip(&natural).map(|(w, n)| f * n.abs() * w.signum()).collect() };
    [scored.clone(), part(0.3), part(1.0)].iter().map(|a| p.with_amplitudes(&s.start, a)).collect()
}

/// One round: screens, fits the best, and judges them.
struct Round {
    screening: Screening,
    fitted: Vec<Refitted>,
}

fn round(bench: &Bench, current: &Fit, now: &Measure, scale: &Scale, given: &[f64]) -> Result<Round> {
    let view = View::of(bench, current)?;
    let mut scene = bench.scene(&current.model, &view.stand)?;
    scene.peaks = super::locate::peaks(current);
    let screening = screen(bench, &scene, &view);
    let tried = screening.screened.len().max(1) as f64;
    let chosen: Vec<Screened> = worth_fitting(&screening, bench.patience(&current.model)).into_iter().cloned().collect();
    let mut fitted: Vec<Refitted> = chosen
        .into_par_iter()
        .filter_map(|s| {
            let fit = refit(bench, &view.stand, given, &s)?;
            let measure = Measure::of(&fit, scale);
            let ratio = 2.0 * (measure.likelihood - now.likelihood);
            let p_value = (tried * log_chance(ratio, s.proposal.added.len()).exp()).min(1.0);
            Some(Refitted { proposal: s.proposal, fit, measure, p_value })
        })
        .collect();
    fitted.sort_by(|a, b| a.measure.left_out.total_cmp(&b.measure.left_out));
    Ok(Round { screening, fitted })
}

/// ln of the fall of the left-out sum of squares.
fn gain(now: &Measure, new: &Measure) -> f64 {
    (now.left_out / new.left_out).ln()
}

/// Likelihood less the price of its parameters.
fn worth(r: &Refitted) -> f64 {
    r.measure.likelihood - 0.5 * r.proposal.added.len() as f64 * r.measure.samples.max(2.0).ln()
}

/// Whether a mechanism is tied to moments of one recording, so that another cannot confirm it.
fn is_anchored(p: &Proposal) -> bool {
    let codes =
        ["drift-force", "output-drift", "parameter-change", "parameter-drift", "clock-jump", "clock-drift"];
    codes.contains(&p.code) || is_timed_wave(p)
}

/// Whether it is a wave in time, whose frequency was read from the residual.
fn is_timed_wave(p: &Proposal) -> bool {
    p.code == "periodic-force" && p.term.contains("*t)")
}

/// Families whose members are the same thing in a linear model with one input and one output.
const FAMILIES: [&[&str]; 4] = [
    &["input-delay", "output-delay"],
    &["input-lag", "output-lag"],
    &["constant-force", "input-offset", "output-offset"],
    &["drift-force", "output-drift"],
];

/// Whether two mechanisms commute where the model is linear.
fn commute(a: &str, b: &str) -> bool {
    a != b && FAMILIES.iter().any(|f| f.contains(&a) && f.contains(&b))
}

/// What a round takes.
struct Choice {
    best: usize,
    ties: Vec<Proposal>,
    elsewhere: Vec<Proposal>,
}

/// Takes the likeliest of those whose gain is near the largest; with its ties.
fn choose(round: &Round, now: &Measure, before: f64) -> Option<Choice> {
    let floor = (-2.0 * (1.0 - FLOOR).ln()).max(FURTHER * before);
    let gain = |now: &Measure, r: &Refitted| {
        gain(now, &r.measure) * if is_anchored(&r.proposal) { ANCHORED } else { 1.0 }
    };
    let passes = |r: &Refitted| r.p_value < CHANCE && gain(now, r) > floor;
    let largest = round.fitted.iter().filter(|r| passes(r)).map(|r| gain(now, r)).fold(0.0, f64::max);
    let rivals: Vec<usize> = (0..round.fitted.len())
        .filter(|i| passes(&round.fitted[*i]) && gain(now, &round.fitted[*i]) >= RIVAL * largest)
        .collect();
    let likeliest = rivals
        .iter()
        .copied()
        .max_by(|a, b| worth(&round.fitted[*a]).total_cmp(&worth(&round.fitted[*b])))?;
    let alike = |i: usize, to: usize| {
        let (r, t) = (&round.fitted[i], &round.fitted[to]);
        let gain = t.measure.likelihood - now.likelihood;
        let same = commute(r.proposal.code, t.proposal.code) || r.proposal.code == t.proposal.code;
        let tolerance = if same { TIE.max(COMMUTES * gain) } else { TIE };
        worth(r) > worth(t) - tolerance && r.proposal.added.len() <= t.proposal.added.len()
    };
    // Of parts that commute, the thing stands before its sensor.
    let place = |i: usize| catalogue::ALL.iter().position(|m| m.code == round.fitted[i].proposal.code);
    let commuting =
        |i: &usize| commute(round.fitted[*i].proposal.code, round.fitted[likeliest].proposal.code);
    let first =
        rivals.iter().copied().filter(|i| commuting(i) && alike(*i, likeliest)).min_by_key(|i| place(*i));
    // Among those that fit alike the one with the fewest parameters stands first.
    let fewest = |i: &usize| round.fitted[*i].proposal.added.len();
    let simpler = rivals.iter().copied().filter(|i| alike(*i, likeliest) && fewest(i) < fewest(&likeliest));
    let simplest = simpler.min_by_key(|i| fewest(i));
    let best = simplest.or(first.filter(|i| place(*i) < place(likeliest))).unwrap_or(likeliest);
    let chosen = &round.fitted[best].proposal;
    let mut ties: Vec<Proposal> = Vec::new();
    let mut elsewhere: Vec<Proposal> = Vec::new();
    for i in rivals.into_iter().filter(|i| *i != best && alike(*i, likeliest)) {
        let p = &round.fitted[i].proposal;
        if p.code == chosen.code {
            elsewhere.push(p.clone());
        } else if ties.iter().all(|t| t.code != p.code) {
            ties.push(p.clone());
        }
    }
    Some(Choice { best, ties, elsewhere })
}

/// Searches from a fitted model.
///
/// # Errors
/// Where the fitted model itself cannot be run.
pub fn search(bench: &Bench, base: Fit, given: &[f64], progress: &dyn Progress) -> Result<Found> {
    let start = Measure::of(&base, &Scale::of(&base, bench.is_trials()));
    let mut current = base.clone();
    let mut taken: Vec<Taken> = Vec::new();
    let mut gains = 0.0;
    let mut first: Option<Screening> = None;
    let mut given = given.to_vec();
    loop {
        progress.says(&format!("trying the catalogue, {} found", taken.len()), None);
        let scale = Scale::of(&current, bench.is_trials());
        let now = Measure::of(&current, &scale);
        let mut round = round(bench, &current, &now, &scale, &given)?;
        trace(&round, &now);
        let chosen = if taken.len() < MOST { choose(&round, &now, gains) } else { None };
        let Some(Choice { best, ties, elsewhere }) = chosen else {
            let rest = round.screening;
            let (first, rest) = match first {
                Some(f) => (f, rest),
                None => (Screening { screened: rest.screened.clone(), p_value: rest.p_value }, rest),
            };
            let scale = Scale::of(&base, bench.is_trials());
            let measures = (start, Measure::of(&current, &scale));
            let mut found = Found { base, last: current, taken, first, rest, scale, measures };
            drop_needless(bench, &mut found);
            return Ok(found);
        };
        let r = round.fitted.swap_remove(best);
        gains += gain(&now, &r.measure);
        let names = r.proposal.model.parameters.len();
        given.extend(r.fit.model.parameters[given.len()..names].iter().map(|p| p.value));
        current = r.fit;
        taken.push(Taken { proposal: r.proposal, p_value: r.p_value, ties, elsewhere });
        first.get_or_insert(round.screening);
    }
}

/// The model of a fit with one taken mechanism at rest, refitted; `None` where it has no rest.
pub fn without(bench: &Bench, last: &Fit, p: &Proposal) -> Option<Fit> {
    let neutral = p.neutral.as_ref()?;
    let mut model = last.model.clone();
    for (a, value) in p.added.iter().zip(neutral) {
        let parameter = model.parameters.iter_mut().find(|q| q.name == a.name)?;
        parameter.fit = false;
        parameter.value = *value;
    }
    let mut options = bench.options(Effort::Near, STEPS);
    options.initials = last.records.iter().map(|r| r.initials.clone()).collect();
    fit(&model, &bench.recordings, &options).ok()
}

/// Drops what the others made needless.
fn drop_needless(bench: &Bench, found: &mut Found) {
    let scale = Scale::of(&found.last, bench.is_trials());
    let mut last = Measure::of(&found.last, &scale);
    let mut i = 0;
    while found.taken.len() > 1 && i + 1 < found.taken.len() {
        let p = &found.taken[i].proposal;
        let smaller = without(bench, &found.last, p).map(|f| (Measure::of(&f, &scale), f));
        let needless = smaller.as_ref().is_some_and(|(m, _)| {
            let price = 0.5 * p.added.len() as f64 * m.samples.max(2.0).ln();
            gain(m, &last) < -2.0 * (1.0 - 0.5 * FLOOR).ln() || last.likelihood - m.likelihood < price
        });
        match smaller {
            Some((m, f)) if needless => {
                found.taken.remove(i);
                found.last = f;
                last = m;
                found.measures.1 = Measure::of(&found.last, &found.scale);
            }
            _ => i += 1,
        }
    }
}

/// Tells the developer what a round saw, where GYROSPEC_TRACE is set.
fn trace(round: &Round, now: &Measure) {
    if std::env::var_os("GYROSPEC_TRACE").is_none() {
        return;
    }
    let mut text = format!(
        "{:?} screened {} p {:.3} | now left-out {:.6} ln L {:.1}\n",
        std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).map(|d| d.as_secs() % 10_000),
        round.screening.screened.len(),
        round.screening.p_value,
        now.left_out,
        now.likelihood
    );
    for s in round.screening.screened.iter().take(25) {
        text += &format!(
            "  s {:>9.2} {:<22} {:<12} {}\n",
            s.score.statistic, s.proposal.code, s.proposal.site.name, s.proposal.term
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
            "  f gain {:.4} dlnL {:>9.2} p {:.2e} {:<20} {:<10} {} rmse {:?}\n",
            gain(now, &r.measure),
            r.measure.likelihood - now.likelihood,
            r.p_value,
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
