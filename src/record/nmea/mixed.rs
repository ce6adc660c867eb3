//! Whether one series holds the sentences of two instruments.

/// Who sent the sentences of a series, one after the other.
#[derive(Debug, Default)]
pub(super) struct Talkers {
    last: String,
    changes: usize,
}

impl Talkers {
    /// Takes the address of the next sentence; whether the one before came from another talker.
    pub fn take(&mut self, address: &str) -> bool {
        if self.last == address {
            return false;
        }
        let other = !self.last.is_empty();
        self.changes += usize::from(other);
        address.clone_into(&mut self.last);
        other
    }

    /// Whether talkers that sent so many each speak in turn, as two instruments in one log do, and not one after the
    /// other, as one that changes its name or its stand-in does: the rarer is hardly ever heard twice running.
    pub fn are_in_turn(&self, counts: &[usize]) -> bool {
        self.changes > 1 && counts.iter().min().is_some_and(|rarer| self.changes >= *rarer)
    }
}

/// Fewest samples from which two instruments are told.
const FEWEST: usize = 20;
/// Part of the samples that return to the one before the last. Of noise between two steps of resolution it is a quarter.
const RETURNING: f64 = 0.7;

/// How far apart two instruments are whose values stand in turn in one series: each value lies nearer by far to the one
/// before the last than to the last. `turn` is what the values wrap at.
pub(super) fn in_turn(values: &[f64], turn: Option<f64>) -> Option<f64> {
    let apart = |a: f64, b: f64| {
        let d = b - a;
        turn.map_or(d, |t| d - t * (d / t).round()).abs()
    };
    let triples = values.windows(3).filter(|v| v.iter().all(|x| x.is_finite()));
    let (mut steps, mut returns) = (Vec::new(), 0usize);
    for v in triples {
        let step = apart(v[0], v[1]);
        returns += usize::from(apart(v[0], v[2]) < 0.25 * step);
        steps.push(step);
    }
    if steps.len() < FEWEST || (returns as f64) < RETURNING * steps.len() as f64 {
        return None;
    }
    steps.sort_by(f64::total_cmp);
    Some(steps[steps.len() / 2])
}
