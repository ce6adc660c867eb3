//! Whether a signal looks held between its samples.

/// Share of its steps that a held signal stays.
const STAYS: f64 = 0.6;
/// Sizes of the usual leap, in the smallest leap and in the whole range, from which on it is more than a count of a
/// coarse reading that runs on.
const LEAPS: (f64, f64) = (3.0, 0.2);

/// Share of its leaps that may go on in the next step: what moves to where it stays, as a rudder does, is held nowhere.
const GOES_ON: f64 = 0.2;

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
    let steps: Vec<f64> = known.windows(2).map(|w| w[1] - w[0]).collect();
    let mut leaps: Vec<f64> = steps.iter().map(|s| s.abs()).filter(|s| *s > 0.0).collect();
    let going_on = steps.windows(2).filter(|w| w[0] * w[1] > 0.0).count();
    if leaps.len() < least_often || ((known.len() - leaps.len()) as f64) < STAYS * known.len() as f64 {
        return false;
    }
    if going_on as f64 > GOES_ON * leaps.len() as f64 {
        return false;
    }
    leaps.sort_unstable_by(f64::total_cmp);
    let (least, usual) = (leaps[0], leaps[leaps.len() / 2]);
    let (low, high) = known.iter().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(*v), h.max(*v)));
    usual >= LEAPS.0 * least || usual >= LEAPS.1 * (high - low)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rudder that moves by so much a sample to an order given every 20 samples.
    fn rudder(quickest: f64) -> Vec<f64> {
        let orders = [0.0, 10.0, -5.0, 15.0, 2.0, -12.0, 4.0, -8.0, 11.0, 0.0];
        let mut at = 0.0;
        let moved = (0..200).map(|i: usize| {
            at += f64::clamp(orders[i / 20] - at, -quickest, quickest);
            at
        });
        moved.collect()
    }

    #[test]
    fn what_moves_to_where_it_stays_is_not_held() {
        assert!(looks_held(&rudder(f64::INFINITY)) && may_be_held(&rudder(f64::INFINITY)));
        assert!(!looks_held(&rudder(4.0)) && !may_be_held(&rudder(4.0)));
    }
}
