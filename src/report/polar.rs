//! The heading error on a compass card, as SVG.

use crate::gyro::SIGN;
use crate::report::svg::escaped;
use std::f64::consts::TAU;
use std::fmt::Write;

/// The error on one heading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Heading, rad.
    pub heading: f64,
    /// Mean error, degrees.
    pub mean: f64,
    /// Standard deviation, degrees.
    pub spread: f64,
}

/// A polar picture: the circle of no error, outside it positive errors, inside negative ones.
#[derive(Debug, Clone, PartialEq)]
pub struct Polar {
    /// First line.
    pub title: String,
    /// Second line.
    pub subtitle: String,
    /// What stands below it all, where something is to be warned of.
    pub warning: String,
    /// The errors, by rising heading.
    pub points: Vec<Point>,
}

const SIZE: f64 = 640.0;
const CENTRE: (f64, f64) = (320.0, 350.0);
const ZERO: f64 = 150.0;
const REACH: f64 = 100.0;

/// Colours and sizes of the picture where it stands alone; on a page, the page's own.
const STYLE: &str = "text{font-family:sans-serif;fill:#555555;font-size:12px}\
.title{font-size:18px;fill:#1a1a2e}.point{font-size:13px;fill:#333333}.ring-value{font-size:11px}\
.rim{stroke:#ffffff;stroke-width:3px}circle,line,path{fill:none}\
.ring,.ray{stroke:#cccccc;stroke-width:.8px}.ray{stroke:#e4e4e4}.zero{stroke:#1a1a2e;stroke-width:1.8px}\
path.spread{fill:#4477aa;fill-opacity:.25}line.spread{stroke:#4477aa;stroke-width:1.5px}\
path.mean{stroke:#cc3311;stroke-width:2px}circle.mean{fill:#cc3311}";

/// What the strokes mean.
const KEY: &str = "bold ring: no error; outside: +, inside: −; shade and strokes: ± one standard deviation";

/// Draws the picture; one SVG document without scripts or outside parts.
///
/// ```
/// use gyrospec::report::polar::{Point, Polar, svg};
/// let points = (0..24).map(|k| Point { heading: f64::from(k) * 0.2618, mean: 1.0, spread: 0.1 });
/// let (title, subtitle, warning) = ("a".into(), "b".into(), String::new());
/// let picture = svg(&Polar { title, subtitle, warning, points: points.collect() });
/// assert!(picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"));
/// ```
pub fn svg(picture: &Polar) -> String {
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {SIZE} {:.0}\">\n<style>{STYLE}</style>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
         <text class=\"title\" x=\"320\" y=\"28\" text-anchor=\"middle\">{}</text>\n{}",
        SIZE + 100.0,
        escaped(&picture.title),
        lines(&picture.subtitle, 48)
    );
    drawing(&mut out, &picture.points);
    let warning = picture.warning.replace(", ", "; ");
    out + &lines(&format!("{}; {SIGN}; {warning}", KEY.replace("; ", ", ")), 656) + "</svg>\n"
}

/// The picture as a figure of a page, whose style colours it.
pub fn figure(picture: &Polar) -> String {
    let (side, title) = (2.0 * (ZERO + REACH + 50.0), escaped(&picture.title));
    let mut out = format!(
        "<figure class=\"polar\"><figcaption>{title}</figcaption><svg viewBox=\"{} {} {side} {side}\" role=\"img\" aria-label=\"{title}\">\n",
        CENTRE.0 - 0.5 * side,
        CENTRE.1 - 0.5 * side
    );
    drawing(&mut out, &picture.points);
    out + &format!("</svg><p class=\"legend\">{KEY}; {SIGN}</p></figure>\n")
}

fn drawing(out: &mut String, points: &[Point]) {
    let largest = points.iter().map(|p| p.mean.abs() + p.spread).fold(0.0, f64::max);
    let step = round_step(largest.max(1e-9) / 3.0);
    let scale = REACH / (3.0 * step).max(largest);
    card(out, step, scale);
    if goes_round(points) {
        band(out, points, scale);
        curve(out, points, scale);
    }
    marks(out, points, scale);
    labels(out, step, scale);
}

/// Lines from a height downwards, broken behind semicolons.
fn lines(text: &str, from: usize) -> String {
    let line = |(k, part): (usize, &str)| {
        format!("<text x=\"320\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", from + 16 * k, escaped(part))
    };
    text.split("; ").filter(|t| !t.is_empty()).enumerate().map(line).collect()
}

/// 1, 2 or 5 times a power of ten, at least `x`.
fn round_step(x: f64) -> f64 {
    let power = 10f64.powf(x.log10().floor());
    [1.0, 2.0, 5.0, 10.0]
        .map(|m| m * power)
        .into_iter()
        .find(|s| *s >= x * (1.0 - 1e-9))
        .unwrap_or(10.0 * power)
}

fn place(heading: f64, radius: f64) -> (f64, f64) {
    (CENTRE.0 + radius * heading.sin(), CENTRE.1 - radius * heading.cos())
}

/// Rings of equal error and the rose of headings.
fn card(out: &mut String, step: f64, scale: f64) {
    for ring in -3i32..=3 {
        let value = f64::from(ring) * step;
        let radius = ZERO + value * scale;
        let class = if ring == 0 { "zero" } else { "ring" };
        let _ = writeln!(
            out,
            "<circle class=\"{class}\" cx=\"{}\" cy=\"{}\" r=\"{radius:.1}\"/>",
            CENTRE.0, CENTRE.1
        );
    }
    for k in 0..12 {
        let heading = f64::from(k) * TAU / 12.0;
        let ((x1, y1), (x2, y2)) = (place(heading, ZERO - REACH), place(heading, ZERO + REACH));
        let (x, y) = place(heading, ZERO + REACH + 18.0);
        let _ = writeln!(
            out,
            "<line class=\"ray\" x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\"/>\n\
             <text class=\"point\" x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{:03}°</text>",
            y + 5.0,
            k * 30
        );
    }
}

/// Values of the rings, between the rays of 000° and 030°. A white rim first, then the text: not
/// every viewer paints a stroke beneath.
fn labels(out: &mut String, step: f64, scale: f64) {
    for ring in -3i32..=3 {
        let value = f64::from(ring) * step;
        let (x, y) = place(0.13, ZERO + value * scale);
        let y = y + 4.0;
        let text = if ring == 0 { "0".to_owned() } else { format!("{:+}", (value * 1e6).round() / 1e6) };
        for rim in [" rim", ""] {
            let _ = writeln!(
                out,
                "<text class=\"ring-value{rim}\" x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\">{text}°</text>"
            );
        }
    }
}

/// Whether the points follow each other closely enough around the card for a closed curve.
fn goes_round(points: &[Point]) -> bool {
    let mut at: Vec<f64> = points.iter().map(|p| p.heading.rem_euclid(TAU)).collect();
    at.sort_by(f64::total_cmp);
    let gaps = at.windows(2).map(|p| p[1] - p[0]);
    match (at.first(), at.last()) {
        (Some(first), Some(last)) => gaps.chain([first + TAU - last]).fold(0.0, f64::max) < 0.8,
        _ => false,
    }
}

fn path(points: impl Iterator<Item = (f64, f64)>) -> String {
    points.enumerate().fold(String::new(), |mut d, (k, (x, y))| {
        let _ = write!(d, "{}{x:.1} {y:.1} ", if k == 0 { "M" } else { "L" });
        d
    })
}

fn band(out: &mut String, points: &[Point], scale: f64) {
    let edge =
        |sign: f64| points.iter().map(move |p| place(p.heading, ZERO + scale * (p.mean + sign * p.spread)));
    let (outer, inner) = (path(edge(1.0)), path(edge(-1.0)));
    let _ = writeln!(
        out,
        "<path class=\"spread\" d=\"{outer}Z {inner}Z\" fill-rule=\"evenodd\" stroke=\"none\"/>"
    );
}

fn curve(out: &mut String, points: &[Point], scale: f64) {
    let d = path(points.iter().map(|p| place(p.heading, ZERO + scale * p.mean)));
    let _ = writeln!(out, "<path class=\"mean\" d=\"{d}Z\"/>");
}

/// A dot on each heading with its numbers; where the dots stand apart, a stroke of ± one deviation.
fn marks(out: &mut String, points: &[Point], scale: f64) {
    let dense = points.len() > 40;
    for p in points {
        let (x, y) = place(p.heading, ZERO + scale * p.mean);
        let edge = |sign: f64| place(p.heading, ZERO + scale * (p.mean + sign * p.spread));
        let ((x1, y1), (x2, y2)) = (edge(-1.0), edge(1.0));
        if !dense {
            let _ = writeln!(
                out,
                "<line class=\"spread\" x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\"/>"
            );
        }
        let radius = if dense { 1.2 } else { 2.5 };
        let _ = writeln!(
            out,
            "<circle class=\"mean\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\"><title>{:.0}°: {:.4}° ± {:.4}°</title></circle>",
            p.heading.to_degrees(),
            p.mean,
            p.spread
        );
    }
}
