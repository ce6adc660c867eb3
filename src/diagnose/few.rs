//! Whether a recording has samples enough for any test to speak.
//!
//! # Purpose
//! Of a dozen samples a model and a mechanism can follow anything. Then nothing is told: no name, no fault of
//! sign or unit, and not that nothing is missing.
//!
//! # Method
//! N whitened samples less p unknowns leave ν = N − p degrees of freedom. A score test measures a direction in
//! units of what the model leaves over in all of them: even a direction that holds all of it has χ² = ν. The
//! largest among m forms of mechanisms, counted with their starts, can thus never be less likely than
//! m·P(χ²₁ > ν). Where that is not below the level
//! of the test, no effect of whatever size could be told from noise.

use super::bench::{Bench, Stand};
use super::choose::CHANCE;
use super::screen::log_chance;
use super::{innovations, locate, propose};
use crate::estimate::Fit;

/// Chance up to which held-out samples may agree by luck: that of one end of a 95 % interval.
const LUCK: f64 = 0.025;

/// Why there are too few samples.
#[derive(Clone)]
pub struct Few {
    /// In words.
    pub says: String,
    /// Whether they would be too few even with those that faults took.
    pub is_anyway: bool,
}

/// Whether a fitted model leaves too few samples to tell anything by, beside some that faults took.
pub fn too_few(bench: &Bench, base: &Fit, taken_by_faults: usize) -> Option<Few> {
    let samples: usize = base.records.iter().flat_map(|r| &r.series).map(|s| s.residual.len()).sum();
    let unknowns = base.values.len();
    let tried = tried(bench, base);
    let least = least_degrees(tried);
    let degrees = independent(base).saturating_sub(unknowns);
    (degrees < least).then(|| Few {
        says: format!(
            "its fitted part has {samples} samples for {unknowns} unknowns and leaves {degrees} degrees of freedom; \
             with less than {least} of them no effect, however large, could be told from noise among the {tried} \
             forms of mechanisms that would be tried"
        ),
        is_anyway: degrees + taken_by_faults < least,
    })
}

/// Whitened samples of a fit.
fn independent(fit: &Fit) -> usize {
    let series = fit.records.iter().flat_map(|r| &r.series);
    let of = |s: &crate::estimate::fit::Series| {
        s.stretches.iter().map(|r| r.len() / fit.noise[s.output].decimation).sum::<usize>()
    };
    series.map(of).sum()
}

/// How many forms of mechanisms would be tried on a fitted model; at least one.
fn tried(bench: &Bench, base: &Fit) -> usize {
    let scene = bench.scene(&base.model, &Stand::of(base));
    let count = scene.map(|mut scene| {
        scene.peaks = locate::peaks(base);
        scene.shifts = innovations::shifts(bench, base);
        propose::proposals(bench, &scene, &[]).iter().map(|p| p.starts.len()).sum::<usize>()
    });
    count.unwrap_or(0).max(1)
}

/// The fewest degrees of freedom at which the best of some mechanisms can pass at all.
fn least_degrees(tried: usize) -> usize {
    let passes = |degrees: &usize| tried as f64 * log_chance(*degrees as f64, 1).exp() < CHANCE;
    (1..10_000).find(passes).unwrap_or(10_000)
}

/// Whether so few samples are held out that all of them may agree better by luck: 2⁻ⁿ.
pub fn agree_by_luck(held_out: usize) -> bool {
    0.5f64.powf(held_out as f64) > LUCK
}

#[cfg(test)]
mod tests {
    use super::*;

    /// P(χ²₁ > x) = erfc √(x/2): 1.0e-4 at 15.1, 1.0e-2 at 6.63 (tables).
    #[test]
    fn the_least_degrees_are_those_of_a_table_of_chi_squared() {
        assert_eq!(least_degrees(1), 7);
        assert_eq!(least_degrees(100), 16);
    }

    #[test]
    fn five_samples_agree_by_luck_once_in_32_times() {
        assert!(agree_by_luck(5) && !agree_by_luck(6));
    }
}
