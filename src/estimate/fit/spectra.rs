//! The spectra of what a fit leaves over.

use super::Fit;
use crate::spectrum::welch;

/// The spectrum of what an output leaves over.
pub struct ResidualSpectrum {
    pub output: String,
    /// Unit of the density.
    pub unit: String,
    /// rad/s and density.
    pub points: Vec<[f64; 2]>,
}

/// Spectra of the residuals over their longest stretches without a gap; none for steady trials or short stretches.
pub fn residual_spectra(fit: &Fit) -> Vec<ResidualSpectrum> {
    let of = |(k, output): (usize, &crate::model::Output)| {
        let own = fit.records.iter().flat_map(|r| &r.series).filter(|s| s.output == k);
        let stretches = own.flat_map(|s| s.stretches.iter().map(move |r| (s, r.clone())));
        let (series, range) = stretches.max_by_key(|(_, r)| r.len()).filter(|(_, r)| r.len() >= 64)?;
        let (from, to) = (series.time[range.start], series.time[range.end - 1]);
        let step = (to - from) / (range.len() - 1) as f64;
        let unit = output.unit.of_differences();
        let values: Vec<f64> =
            series.residual[range.clone()].iter().map(|e| unit.difference_from_si(*e)).collect();
        let measured = welch(&values, step, (range.len() / 6).clamp(32, 4096)).ok()?;
        let points = measured.omega.iter().zip(&measured.density).skip(1);
        Some(ResidualSpectrum {
            output: output.name.clone(),
            unit: if unit.text() == "1" { "s".into() } else { format!("({})²·s", unit.text()) },
            points: points.map(|(w, s)| [*w, *s]).collect(),
        })
    };
    if fit.model.states.is_empty() && fit.records.iter().all(|r| r.series.iter().all(|s| s.time.len() < 64)) {
        return Vec::new();
    }
    fit.model.outputs.iter().enumerate().filter_map(of).collect()
}
