//! Lines and bands as SVG, thinned so that long recordings stay small.

use std::fmt::Write;

/// Width and height of a picture.
const SIZE: (f64, f64) = (720.0, 220.0);
/// Points of a line at most.
const POINTS: usize = 1200;

/// A line of a picture.
pub struct Line<'a> {
    /// Class, which gives the colour.
    pub class: &'static str,
    /// Name in the legend.
    pub name: &'a str,
    /// Points.
    pub points: Vec<(f64, f64)>,
}

/// Least and greatest of each stretch, in order, so that no peak is lost.
fn thinned(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    if points.len() <= POINTS {
        return points.to_vec();
    }
    let size = points.len().div_ceil(POINTS / 2);
    let mut kept = Vec::new();
    for chunk in points.chunks(size) {
        let low = chunk.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1));
        let high = chunk.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1));
        let mut both: Vec<(f64, f64)> = low.into_iter().chain(high).collect();
        both.sort_by(|a, b| a.0.total_cmp(&b.0));
        kept.extend(both);
    }
    kept
}

/// A picture of some lines over one axis; `shaded` are spans of the axis drawn darker.
pub fn picture(title: &str, axis: &str, lines: &[Line<'_>], shaded: &[(f64, f64)]) -> String {
    let all = || lines.iter().flat_map(|l| &l.points).filter(|p| p.0.is_finite() && p.1.is_finite());
    let range = |of: fn(&(f64, f64)) -> f64| {
        all().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |r, v| (r.0.min(v), r.1.max(v)))
    };
    let ((x0, x1), (y0, y1)) = (range(|p| p.0), range(|p| p.1));
    if !(x0 < x1) {
        return String::new();
    }
    let (y0, y1) = if y0 < y1 { (y0, y1) } else { (y0 - 1.0, y1 + 1.0) };
    let (w, h) = SIZE;
    let (left, top, right, bottom) = (70.0, 10.0, 10.0, 35.0);
    let px = |x: f64| left + (x - x0) / (x1 - x0) * (w - left - right);
    let py = |y: f64| h - bottom - (y - y0) / (y1 - y0) * (h - top - bottom);
    let mut svg = format!(
        "<figure><figcaption>{title}</figcaption><svg viewBox=\"0 0 {w} {h}\" role=\"img\" aria-label=\"{title}\">"
    );
    for (a, b) in shaded {
        let (a, b) = (px(a.max(x0)), px(b.min(x1)));
        if b > a {
            let _ = write!(
                svg,
                "<rect class=\"shade\" x=\"{a:.1}\" y=\"{top}\" width=\"{:.1}\" height=\"{:.1}\"/>",
                b - a,
                h - top - bottom
            );
        }
    }
    for (value, anchor) in [(y0, h - bottom), (y1, top + 10.0)] {
        let _ = write!(
            svg,
            "<text x=\"{:.1}\" y=\"{anchor:.1}\" text-anchor=\"end\">{}</text>",
            left - 6.0,
            super::text::figure(value)
        );
    }
    for (value, anchor, x) in [(x0, "start", left), (x1, "end", w - right)] {
        let _ = write!(
            svg,
            "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"{anchor}\">{}</text>",
            h - 18.0,
            super::text::figure(value)
        );
    }
    let _ = write!(
        svg,
        "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{axis}</text>",
        0.5 * (left + w),
        h - 4.0
    );
    for line in lines {
        let mut path = String::new();
        for (x, y) in thinned(&line.points) {
            let _ = write!(path, "{:.1},{:.1} ", px(x), py(y));
        }
        let _ = write!(svg, "<polyline class=\"{}\" points=\"{}\"/>", line.class, path.trim_end());
    }
    svg.push_str("</svg><p class=\"legend\">");
    for line in lines {
        let _ = write!(svg, "<span class=\"{}\">{}</span> ", line.class, line.name);
    }
    svg + "</p></figure>"
}
