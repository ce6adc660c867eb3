//! # Purpose
//! What of the outputs cannot be predicted because an input has a gap.
//!
//! # Method
//! Over a gap the run goes on with a straight input, which nobody measured. Nothing in the gap is
//! compared, nor what follows until the model has forgotten the gap: five of its slowest time
//! constants, but no longer than three times the gap, since a model that is much slower than the
//! gap hardly notices it. Where that would cost too many samples the gaps alone are left out.
//!
//! # Numerical aspects
//! The slowest time constant is that at the start of the run, at the model's own parameters.

use super::mesh::Samples;

/// Slowest time constants after which 0.7 % is left.
const FORGOTTEN: f64 = 5.0;
/// The longest wait, in lengths of the gap.
const LONGEST_WAIT: f64 = 3.0;
/// The share of the samples that may be given up to wait.
const WORTH: f64 = 0.5;

/// The gaps of all inputs, s.
pub(super) fn gaps(inputs: &[Samples]) -> Vec<(f64, f64)> {
    inputs.iter().flat_map(|s| s.gaps.iter().copied()).collect()
}

/// The gaps with the wait after each, if that leaves enough of the times that are compared now.
pub(super) fn with_waits(
    gaps: &[(f64, f64)],
    compared: impl Iterator<Item = f64>,
    slowest: f64,
) -> Vec<(f64, f64)> {
    let wait = |g: &(f64, f64)| (FORGOTTEN * slowest).min(LONGEST_WAIT * (g.1 - g.0));
    let longer: Vec<(f64, f64)> = gaps.iter().map(|g| (g.0, g.1 + wait(g))).collect();
    let (mut all, mut lost) = (0_usize, 0_usize);
    for t in compared {
        all += 1;
        lost += usize::from(inside(&longer, t));
    }
    if lost as f64 <= WORTH * all as f64 { longer } else { gaps.to_vec() }
}

/// Whether a time lies in one of some stretches.
pub(super) fn inside(stretches: &[(f64, f64)], t: f64) -> bool {
    stretches.iter().any(|g| t > g.0 && t < g.1)
}
