//! Whether a signal looks held between its samples.

/// Share of its steps that a held signal stays.
const STAYS: f64 = 0.6;
/// Sizes of the usual leap, in the smallest leap and in the whole range, from which on it is more than a count of a
/// coarse reading that runs on.
const LEAPS: (f64, f64) = (3.0, 0.2);

/// Whether a signal stays where it is for several samples and then leaps, as a command does.
pub(crate) fn looks_held(values: &[f64]) -> bool {
    stays_and_leaps(values, 3)
}

/// Whether a signal stays where it is but for leaps, be it one alone, as a dose does that ends: too little to tell by its
/// looks, so something else must show it held.
pub(crate) fn may_be_held(values: &[f64]) -> bool {
    stays_and_leaps(values, 1)
}

/// Whether a signal stays for several samples and leaps that often or more.
fn stays_and_leaps(values: &[f64], least_often: usize) -> bool {
    let known: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    let steps = known.windows(2).map(|w| (w[1] - w[0]).abs());
    let mut leaps: Vec<f64> = steps.filter(|s| *s > 0.0).collect();
    if leaps.len() < least_often || ((known.len() - leaps.len()) as f64) < STAYS * known.len() as f64 {
        return false;
    }
    leaps.sort_unstable_by(f64::total_cmp);
    let (least, usual) = (leaps[0], leaps[leaps.len() / 2]);
    let (low, high) = known.iter().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(*v), h.max(*v)));
    usual >= LEAPS.0 * least || usual >= LEAPS.1 * (high - low)
}
