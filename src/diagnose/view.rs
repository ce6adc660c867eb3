//! What a screening sees of a fitted model: its residual, and how a proposal at rest would move it.

use super::bench::{self, Bench, Stand, Track};
use super::catalogue::Proposal;
use super::compared::same_tracks;
use super::response::{Places, Response, Terms};
use super::screen::Screen;
use crate::estimate::Fit;
use crate::estimate::fit::harness::Record;
use crate::estimate::noise::{Autoregression, NoiseModel};
use crate::model::Model;
use crate::simulate::Planned;
use crate::{Error, Result};
use std::cell::OnceCell;
use std::sync::OnceLock;

/// Samples to which the free run is shortened for its own screening.
const FREE: usize = 3000;

/// The whitened residual of a fitted model on the screened parts, with its records' tracks.
pub struct View {
    /// Screening space.
    pub screen: Screen,
    /// The same for the free run as it stands, whatever its colour.
    pub free: Screen,
    /// Where the model stands.
    pub stand: Stand,
    /// The simulator's tolerance.
    pub tolerance: f64,
    /// How the model is run to it, one a recording.
    pub planned: Vec<Option<Planned>>,
    /// Tracks of the model itself.
    pub tracks: Vec<Track>,
    /// Number of the recording of each.
    pub recordings: Vec<usize>,
    /// Its response to small forces, where it can be found without simulations.
    pub response: Option<Response>,
    /// The same on all samples and at the measured places, once it is asked for.
    fine: OnceLock<Option<Response>>,
}

impl View {
    /// Looks at a fitted model.
    pub fn of(bench: &Bench, fit: &Fit) -> Result<Self> {
        let stand = Stand::of(fit);
        let tolerance = bench.rough(fit);
        let records = bench.ready(&fit.model, fit.starts(), (tolerance, Vec::new()))?;
        let planned = records.iter().map(|r| r.harness.planned()).collect();
        let plain = bench::run(&records, &stand, &[])?;
        let recordings = records.iter().flat_map(|r| r.tracks.iter().map(|_| r.recording)).collect();
        let mut noise = fit.noise.clone();
        if bench.is_trials() {
            for n in &mut noise {
                n.decimation = 1;
                n.autoregression = n.autoregression.truncated(0);
            }
        }
        let own = own_tracks(fit, &plain)?;
        let samples: usize = own.iter().map(|t| t.residual.len()).sum();
        let plain_noise: Vec<NoiseModel> = fit
            .rmse
            .iter()
            .map(|r| NoiseModel {
                decimation: (samples / FREE).max(1),
                autoregression: Autoregression::white((r * r).max(f64::MIN_POSITIVE)),
            })
            .collect();
        let free = Screen::new(&own, &plain_noise, None);
        let response = Response::of(bench, &fit.model, &stand, tolerance, &records, Places::Simulated);
        let screen = Screen::new(&own, &noise, Some(bench.seed));
        let fine = OnceLock::new();
        Ok(Self { screen, free, stand, tolerance, planned, tracks: plain, recordings, response, fine })
    }

    /// The response on all samples and at the measured places, for what is faster than the model's own signals.
    pub fn fine(&self, bench: &Bench) -> Option<&Response> {
        let response = self.response.as_ref()?;
        if response.is_fine {
            return Some(response);
        }
        self.fine.get_or_init(|| response.measured(bench, &self.tracks)).as_ref().or(Some(response))
    }

    /// A model that extends it, ready to run over the screened parts.
    pub fn ready(&self, bench: &Bench, model: &Model) -> Result<Vec<Record>> {
        bench.ready(model, self.stand.extended(model, &[]).initials, (self.tolerance, self.planned.clone()))
    }

    /// A proposal at rest, to be looked at from its starts.
    pub fn at_rest<'v>(&'v self, bench: &'v Bench, proposal: &'v Proposal) -> AtRest<'v> {
        let response = if proposal.turns() { self.fine(bench) } else { self.response.as_ref() };
        let terms = response.and_then(|r| Some((r, r.terms(bench, proposal)?)));
        AtRest { view: self, bench, proposal, terms, records: OnceCell::new() }
    }
}

/// A proposal at rest inside a fitted model.
pub struct AtRest<'v> {
    view: &'v View,
    bench: &'v Bench,
    proposal: &'v Proposal,
    terms: Option<(&'v Response, Terms<'v>)>,
    /// The whole model, where its own terms do not do.
    records: OnceCell<Option<Vec<Record>>>,
}

impl AtRest<'_> {
    /// Tracks with sensitivities to its amplitudes.
    pub fn tracks(&self, start: &[f64]) -> Option<Vec<Track>> {
        let swift = self.terms.as_ref().and_then(|(response, terms)| response.tracks(terms, start));
        swift.or_else(|| {
            let (view, p) = (self.view, self.proposal);
            let ready = || view.ready(self.bench, &p.at_rest());
            let records = self.records.get_or_init(|| ready().ok());
            let stand = view.stand.extended(&p.model, &p.quiet(start));
            let tracks = bench::run(records.as_ref()?, &stand, &p.amplitude_numbers()).ok()?;
            same_tracks(&tracks, &view.tracks).then_some(tracks)
        })
    }
}

/// The fit's residuals and its sensitivities to what is inside its bounds, cut to the screened parts, with which it
/// begins. What is pressed against a bound cannot make up for anything.
pub fn own_tracks(fit: &Fit, plain: &[Track]) -> Result<Vec<Track>> {
    let free: Vec<bool> = fit.unknowns.iter().map(|name| !fit.is_at_bound(name)).collect();
    let series = fit.records.iter().flat_map(|r| &r.series);
    series
        .zip(plain)
        .map(|(s, t)| {
            let n = t.residual.len();
            if s.time.get(..n) != Some(&t.time[..]) {
                return Err(Error::not_computed(
                    "the model was not screened on the samples that it was fitted to",
                ));
            }
            Ok(Track {
                output: s.output,
                stretches: t.stretches.clone(),
                time: t.time.clone(),
                residual: s.residual[..n].to_vec(),
                sensitivities: s
                    .sensitivities
                    .iter()
                    .zip(&free)
                    .filter(|(_, free)| **free)
                    .map(|(c, _)| c[..n].to_vec())
                    .collect(),
            })
        })
        .collect()
}
