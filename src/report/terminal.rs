//! Pictures of plain characters for the terminal.

use std::fmt::Write;

/// One row of numbers drawn with one character.
#[derive(Debug, Clone, Copy)]
pub struct Trace<'a> {
    pub mark: char,
    /// Equally spaced values, not finite where there is none.
    pub values: &'a [f64],
}

/// A picture `width` × `height` characters of rows that share their first and last abscissa;
/// later rows cover earlier ones. `from` and `to` stand under the ends of the axis.
///
/// ```
/// use gyrospec::report::terminal::{Trace, picture};
/// let text = picture(&[Trace { mark: '*', values: &[0.0, 1.0] }], (10, 3), ("0 s", "1 s"));
/// assert_eq!(text.lines().count(), 4);
/// ```
pub fn picture(traces: &[Trace<'_>], (width, height): (usize, usize), (from, to): (&str, &str)) -> String {
    let all = || traces.iter().flat_map(|t| t.values).copied().filter(|v| v.is_finite());
    let low = all().fold(f64::INFINITY, f64::min).min(0.0);
    let high = all().fold(f64::NEG_INFINITY, f64::max).max(0.0);
    let span = if high > low { high - low } else { 1.0 };
    let (width, height) = (width.max(2), height.max(2));
    let row = |v: f64| (((high - v) / span) * (height - 1) as f64).round() as usize;
    let mut grid = vec![vec![' '; width]; height];
    grid[row(0.0).min(height - 1)].fill('-');
    for trace in traces {
        let last = trace.values.len().saturating_sub(1);
        #[allow(clippy::needless_range_loop)] // the column is the abscissa, its row is computed
        for column in 0..width {
            let place = column as f64 / (width - 1) as f64 * last as f64;
            let value = trace.values.get(place.round() as usize).copied().unwrap_or(f64::NAN);
            if value.is_finite() {
                grid[row(value).min(height - 1)][column] = trace.mark;
            }
        }
    }
    // three digits of the largest label
    let digits = (2.0 - span.log10().floor()).clamp(0.0, 7.0) as usize;
    let mut out = String::new();
    for (index, line) in grid.iter().enumerate() {
        let label = high - span * index as f64 / (height - 1) as f64;
        let text: String = line.iter().collect();
        let _ = writeln!(out, "{label:>9.digits$} |{}", text.trim_end());
    }
    let gap = width.saturating_sub(from.chars().count() + to.chars().count());
    let _ = writeln!(out, "{:>10} {from}{}{to}", "", " ".repeat(gap));
    out
}
