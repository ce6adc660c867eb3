//! A closer look at a long series, where it is largest.

/// Points below which a series is looked at whole.
const MANY: usize = 240;
/// The part of the whole span that is shown closer.
const PART: f64 = 1.0 / 15.0;

/// The span around the largest size of a long series of residuals, inside its ends; none for a short one.
pub fn span(residual: &[[f64; 2]]) -> Option<[f64; 2]> {
    let known = || residual.iter().filter(|p| p[1].is_finite());
    if residual.len() < MANY {
        return None;
    }
    let (from, to) = (known().next()?[0], known().next_back()?[0]);
    let worst = known().max_by(|a, b| a[1].abs().total_cmp(&b[1].abs()))?[0];
    let width = PART * (to - from);
    let start = (worst - 0.5 * width).clamp(from, to - width);
    Some([start, start + width])
}

/// The points inside a span.
pub fn within(points: &[[f64; 2]], [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
    points.iter().filter(|p| (from..=to).contains(&p[0])).copied().collect()
}

#[cfg(test)]
mod tests {
    use super::{span, within};

    #[test]
    fn the_worst_stands_inside_and_the_ends_hold() {
        let peak = |at: usize| -> Vec<[f64; 2]> {
            (0..1501).map(|i| [i as f64, if i == at { -7.0 } else { 1.0 }]).collect()
        };
        assert_eq!(span(&peak(750)), Some([700.0, 800.0]));
        assert_eq!(span(&peak(1500)), Some([1400.0, 1500.0]));
        assert_eq!(within(&peak(3), [2.0, 4.0]).len(), 3);
        assert_eq!(span(&peak(3)[..100]), None);
    }
}
