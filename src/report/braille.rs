//! Small pictures for the terminal, in Braille dots.

/// Dots of a Braille cell, column by column from the top.
const DOTS: [[u8; 4]; 2] = [[0x01, 0x02, 0x04, 0x40], [0x08, 0x10, 0x20, 0x80]];

/// Lines of text that show y over x: in each column of dots the range from the smallest to the
/// largest value is filled; columns without points stay empty. Points that are not finite count
/// for nothing.
///
/// ```
/// let lines = gyrospec::report::braille::plot([(0.0, 0.0), (1.0, 1.0)], 1, 1);
/// assert_eq!(lines, ["⡸"]);
/// ```
pub fn plot(
    points: impl IntoIterator<Item = (f64, f64), IntoIter: Clone>,
    columns: usize,
    rows: usize,
) -> Vec<String> {
    let points = points.into_iter().filter(|(x, y)| x.is_finite() && y.is_finite());
    let (x0, x1) = ends(points.clone().map(|p| p.0));
    let (y0, y1) = ends(points.clone().map(|p| p.1));
    let (width, height) = (2 * columns, 4 * rows);
    let mut ranges: Vec<Option<(usize, usize)>> = vec![None; width];
    for (x, y) in points {
        let column = place(x, x0, x1, width);
        let row = height - 1 - place(y, y0, y1, height);
        let (top, bottom) = ranges[column].unwrap_or((row, row));
        ranges[column] = Some((top.min(row), bottom.max(row)));
    }
    join(&mut ranges);
    let mut cells = vec![vec![0_u8; columns]; rows];
    for (column, range) in ranges.iter().enumerate() {
        let Some((top, bottom)) = *range else { continue };
        for row in top..=bottom {
            cells[row / 4][column / 2] |= DOTS[column % 2][row % 4];
        }
    }
    let text = |row: &Vec<u8>| row.iter().filter_map(|c| char::from_u32(0x2800 + u32::from(*c))).collect();
    cells.iter().map(text).collect()
}

fn ends(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)))
}

fn place(value: f64, low: f64, high: f64, places: usize) -> usize {
    if high <= low {
        return places / 2;
    }
    (((value - low) / (high - low) * places as f64) as usize).min(places - 1)
}

/// Lets neighbouring columns touch, so that steep curves do not fall apart.
fn join(ranges: &mut [Option<(usize, usize)>]) {
    for i in 1..ranges.len() {
        if let (Some(left), Some(right)) = (ranges[i - 1], &mut ranges[i]) {
            right.0 = right.0.min(left.1 + 1).min(right.1);
            right.1 = right.1.max(left.0.saturating_sub(1)).max(right.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::plot;

    #[test]
    fn nothing_and_a_constant_have_pictures() {
        assert_eq!(plot([], 3, 1), ["⠀⠀⠀"]);
        assert_eq!(plot([(0.0, 5.0), (1.0, 5.0)], 1, 1), ["⠒"]);
    }

    #[test]
    fn gaps_stay_empty() {
        let points = (0..100).filter(|i| !(40..60).contains(i)).map(|i| (f64::from(i), 0.0));
        let line = &plot(points, 10, 1)[0];
        assert_eq!(line.chars().filter(|c| *c == '\u{2800}').count(), 2);
    }
}
