//! Long lines drawn with few points.

/// Points of a line that are drawn as they are.
const FEW: usize = 1500;

/// In each unit of the abscissa the lowest and the highest point of a long line, in their order; so no
/// peak is lost and the picture looks the same.
pub fn thinned(line: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    if line.len() <= FEW {
        return line;
    }
    let mut kept = Vec::with_capacity(FEW);
    for column in line.chunk_by(|a, b| a.0.floor() == b.0.floor()) {
        let by_height = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
        let ends = column.iter().min_by(by_height).into_iter().chain(column.iter().max_by(by_height));
        let mut ends: Vec<(f64, f64)> = ends.copied().collect();
        ends.sort_by(|a, b| a.0.total_cmp(&b.0));
        ends.dedup();
        kept.extend(ends);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::thinned;

    #[test]
    fn a_lone_peak_stays() {
        let wave = |i: i32| if i == 70_001 { 9.0 } else { (f64::from(i) * 0.3).sin() };
        let line: Vec<(f64, f64)> = (0..100_000).map(|i| (f64::from(i) * 0.006, wave(i))).collect();
        let kept = thinned(line);
        assert!(kept.len() <= 1202 && kept.contains(&(70_001.0 * 0.006, 9.0)), "{}", kept.len());
        assert!(kept.windows(2).all(|w| w[0].0 <= w[1].0));
    }
}
