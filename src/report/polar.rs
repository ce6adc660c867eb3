//! The heading error on a compass card, as SVG.

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
    /// The errors, by rising heading.
    pub points: Vec<Point>,
}

const SIZE: f64 = 640.0;
const CENTRE: (f64, f64) = (320.0, 350.0);
const ZERO: f64 = 150.0;
const REACH: f64 = 100.0;

/// Draws the picture; one SVG document without scripts or outside parts.
///
/// ```
/// use gyrospec::report::polar::{Point, Polar, svg};
/// let points = (0..24).map(|k| Point { heading: f64::from(k) * 0.2618, mean: 1.0, spread: 0.1 });
/// let picture = svg(&Polar { title: "a".into(), subtitle: "b".into(), points: points.collect() });
/// assert!(picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"));
/// ```
pub fn svg(picture: &Polar) -> String {
    let largest = picture.points.iter().map(|p| p.mean.abs() + p.spread).fold(0.0, f64::max);
    let step = round_step(largest.max(1e-9) / 3.0);
    let scale = REACH / (3.0 * step).max(largest);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {SIZE} {:.0}\" font-family=\"sans-serif\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
         <text x=\"320\" y=\"28\" font-size=\"18\" text-anchor=\"middle\" fill=\"#1a1a2e\">{}</text>\n\
         {}",
        SIZE + 40.0,
        escaped(&picture.title),
        subtitle(&picture.subtitle)
    );
    card(&mut out, step, scale);
    if goes_round(&picture.points) {
        band(&mut out, &picture.points, scale);
        curve(&mut out, &picture.points, scale);
    }
    marks(&mut out, &picture.points, scale);
    labels(&mut out, step, scale);
    let _ = writeln!(
        out,
        "<text x=\"320\" y=\"665\" font-size=\"12\" text-anchor=\"middle\" fill=\"#555555\">\
         bold ring: no error; outside: positive, inside: negative; shade and strokes: ± one standard deviation</text>\n</svg>"
    );
    out
}

/// The second line, broken behind semicolons.
fn subtitle(text: &str) -> String {
    let line = |(k, part): (usize, &str)| {
        format!(
            "<text x=\"320\" y=\"{}\" font-size=\"12\" text-anchor=\"middle\" fill=\"#555555\">{}</text>\n",
            48 + 16 * k,
            escaped(part)
        )
    };
    text.split("; ").enumerate().map(line).collect()
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
        let (colour, width) = if ring == 0 { ("#1a1a2e", 1.8) } else { ("#cccccc", 0.8) };
        let _ = writeln!(
            out,
            "<circle cx=\"{}\" cy=\"{}\" r=\"{radius:.1}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"/>",
            CENTRE.0, CENTRE.1
        );
    }
    for k in 0..12 {
        let heading = f64::from(k) * TAU / 12.0;
        let ((x1, y1), (x2, y2)) = (place(heading, ZERO - REACH), place(heading, ZERO + REACH));
        let (x, y) = place(heading, ZERO + REACH + 18.0);
        let _ = writeln!(
            out,
            "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" stroke=\"#e4e4e4\" stroke-width=\"0.8\"/>\n\
             <text x=\"{x:.1}\" y=\"{:.1}\" font-size=\"13\" text-anchor=\"middle\" fill=\"#333333\">{:03}°</text>",
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
        for rim in [" stroke=\"#ffffff\" stroke-width=\"3\"", ""] {
            let _ = writeln!(
                out,
                "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"11\" text-anchor=\"middle\" fill=\"#555555\"{rim}>{text}°</text>"
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
        "<path d=\"{outer}Z {inner}Z\" fill=\"#4477aa\" fill-opacity=\"0.25\" fill-rule=\"evenodd\" stroke=\"none\"/>"
    );
}

fn curve(out: &mut String, points: &[Point], scale: f64) {
    let d = path(points.iter().map(|p| place(p.heading, ZERO + scale * p.mean)));
    let _ = writeln!(out, "<path d=\"{d}Z\" fill=\"none\" stroke=\"#cc3311\" stroke-width=\"2\"/>");
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
                "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" stroke=\"#4477aa\" stroke-width=\"1.5\"/>"
            );
        }
        let radius = if dense { 1.2 } else { 2.5 };
        let _ = writeln!(
            out,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"#cc3311\"><title>{:.0}°: {:.4}° ± {:.4}°</title></circle>",
            p.heading.to_degrees(),
            p.mean,
            p.spread
        );
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
