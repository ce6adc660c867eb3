//! Pictures as SVG: axes, lines, dots and shaded bands, coloured by classes of the page's style.
//!
//! ```
//! use gyrospec::report::svg::{Layer, Picture};
//! let picture = Picture::new("roll of the ship", "time, s", "roll, deg")
//!     .with(Layer::line("measured", "measured", vec![[0.0, 1.0], [1.0, -1.0]]));
//! assert!(picture.draw().contains("<polyline class=\"measured\""));
//! ```

mod axis;
mod layer;
mod thin;

pub use axis::{Scale, tick_text, ticks};
pub use layer::Layer;

use crate::text::shown as visible;
use crate::units::significant;
use axis::Axis;
use std::fmt::Write;

/// Width and height of a picture in its own units.
const SIZE: (f64, f64) = (720.0, 320.0);
/// Room left (at least), top, right and bottom of the frame.
const MARGIN: [f64; 4] = [78.0, 32.0, 14.0, 56.0];
/// Room between a tick's text and its axis.
const GAP: f64 = 6.0;
/// Width of a digit in the widest common face at the size that texts have on a phone, 21; a minus sign is
/// wider by a third.
const DIGIT: f64 = 13.4;

/// A picture in the making.
#[derive(Debug, Clone)]
pub struct Picture {
    title: String,
    x: (String, Scale),
    y: (String, Scale),
    /// What the ticks of x are told in beside, times this.
    beside: Option<f64>,
    /// What x of the layers is divided by.
    x_size: f64,
    layers: Vec<Layer>,
}

impl Picture {
    /// A picture with linear axes; the words are plain text.
    pub fn new(title: &str, x: &str, y: &str) -> Self {
        let axis = |words: &str| (words.to_string(), Scale::Linear);
        Self { title: title.into(), x: axis(x), y: axis(y), beside: None, x_size: 1.0, layers: Vec::new() }
    }

    /// The same with both axes logarithmic.
    #[must_use]
    pub fn logarithmic(mut self) -> Self {
        self.x.1 = Scale::Logarithmic;
        self.y.1 = Scale::Logarithmic;
        self
    }

    /// The same with each tick of x told in another unit too, in brackets: the value times a factor.
    #[must_use]
    pub fn beside(mut self, factor: f64) -> Self {
        self.beside = Some(factor);
        self
    }

    /// The same with x in another unit than that of the layers to come, so many times as large.
    #[must_use]
    pub fn in_units_of(mut self, size: f64) -> Self {
        self.x_size = size;
        self
    }

    /// The same with one layer more, above the others.
    #[must_use]
    pub fn with(mut self, layer: Layer) -> Self {
        self.layers.push(if self.x_size == 1.0 { layer } else { layer.in_units_of(self.x_size) });
        self
    }

    /// The figure with caption and legend; empty where there is nothing to draw.
    pub fn draw(&self) -> String {
        let corners: Vec<[f64; 2]> = self.layers.iter().flat_map(Layer::corners).collect();
        let [room, top, right, bottom] = MARGIN;
        let (w, h) = SIZE;
        let along = |k: usize| corners.iter().map(move |c| c[k]);
        let Some(y) = Axis::over(along(1), self.y.1, (h - bottom, top), true) else { return String::new() };
        let left = y.ticks(5).iter().map(|t| width(&t.1) + 2.0 * GAP).fold(room, f64::max).min(0.4 * w);
        let Some(x) = Axis::over(along(0), self.x.1, (left, w - right), false) else { return String::new() };
        let title = escaped(&self.title);
        let mut svg = format!(
            "<figure><figcaption>{title}</figcaption><svg viewBox=\"0 0 {w} {h}\" role=\"img\" aria-label=\"{title}\" data-x=\"{}\" data-y=\"{}\" data-beside=\"{}\">",
            x.told(),
            y.told(),
            self.beside.unwrap_or(0.0)
        );
        // what is drawn stands in a window of its own, which cuts at the frame when a script looks closer
        let window = format!(
            "<svg class=\"plot\" x=\"{left:.1}\" y=\"{top}\" width=\"{0:.1}\" height=\"{1}\" viewBox=\"{left:.1} {top} {0:.1} {1}\" preserveAspectRatio=\"none\">",
            w - right - left,
            h - top - bottom
        );
        let layers = |svg: &mut String, below: bool| {
            svg.push_str(&window);
            for l in &self.layers {
                if matches!(l, Layer::Span { .. }) == below {
                    layer(svg, l, &x, &y);
                }
            }
            svg.push_str("</svg>");
        };
        layers(&mut svg, true);
        self.frame(&mut svg, &x, &y, left);
        layers(&mut svg, false);
        svg.push_str("</svg>");
        self.legend(&mut svg, &x);
        svg + "</figure>\n"
    }

    fn frame(&self, svg: &mut String, x: &Axis, y: &Axis, left: f64) {
        let [_, top, right, bottom] = MARGIN;
        let (w, h) = SIZE;
        svg.push_str("<g class=\"ticks\">");
        for (at, text) in y.ticks(5) {
            let _ = write!(
                svg,
                "<path class=\"grid\" d=\"M{left:.1} {at:.1}H{:.1}\"/><text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{text}</text>",
                w - right,
                left - GAP,
                at + 5.0
            );
        }
        for (at, text) in self.ticks_with_room(x, left) {
            let inside = at.min(w - 0.5 * width(&text));
            let _ = write!(
                svg,
                "<path class=\"tick\" d=\"M{at:.1} {:.1}v5\"/><text x=\"{inside:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{text}</text>",
                h - bottom,
                h - bottom + 20.0
            );
        }
        let _ = write!(
            svg,
            "</g><path class=\"frame\" d=\"M{left:.1} {top}V{:.1}H{:.1}\"/><text class=\"words\" x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text><text class=\"words\" x=\"4\" y=\"18\">{}</text>",
            h - bottom,
            w - right,
            0.5 * (left + w - right),
            h - 12.0,
            escaped(&self.x.0),
            escaped(&self.y.0)
        );
    }

    /// As many ticks as have room for their texts.
    fn ticks_with_room(&self, x: &Axis, left: f64) -> Vec<(f64, String)> {
        let ticks = |about: usize| -> Vec<(f64, String)> {
            let plain = x.ticks(about);
            let Some(factor) = self.beside else { return plain };
            plain
                .into_iter()
                .map(|(at, text)| (at, format!("{text} ({})", significant(factor * x.value(at), 3))))
                .collect()
        };
        let fits = |ticks: &[(f64, String)]| {
            let needed: f64 = ticks.iter().map(|t| width(&t.1) + DIGIT).sum();
            needed <= SIZE.0 - left
        };
        (2..=7).rev().map(ticks).find(|t| fits(t)).unwrap_or_else(|| ticks(2))
    }

    fn legend(&self, svg: &mut String, x: &Axis) {
        let seen = |l: &&Layer| match l {
            Layer::Span { spans, .. } => spans.iter().any(|s| x.clipped(*s).is_some()),
            _ => true,
        };
        let named: Vec<_> =
            self.layers.iter().filter(seen).map(Layer::legend).filter(|l| !l.1.is_empty()).collect();
        if named.is_empty() {
            return;
        }
        svg.push_str("<p class=\"legend\">");
        for (class, name, kind) in named {
            let mark = match kind {
                "line" => format!("<polyline class=\"{class}\" points=\"0,7 30,7\"/>"),
                "dot" => format!("<circle class=\"{class}\" cx=\"15\" cy=\"7\" r=\"3.5\"/>"),
                _ => format!("<rect class=\"{class}\" width=\"30\" height=\"14\"/>"),
            };
            let _ = write!(
                svg,
                "<span><svg viewBox=\"0 0 30 14\" aria-hidden=\"true\">{mark}</svg> {}</span> ",
                escaped(name)
            );
        }
        svg.push_str("</p>");
    }
}

/// Width of a tick's text on a phone, where texts are largest in the picture's own units.
fn width(text: &str) -> f64 {
    text.chars().map(|c| if c == '−' { 1.34 * DIGIT } else { DIGIT }).sum()
}

fn layer(svg: &mut String, layer: &Layer, x: &Axis, y: &Axis) {
    let at = |p: [f64; 2]| Some((x.place(p[0])?, y.place(p[1])?));
    match layer {
        Layer::Line { class, points, .. } => {
            // A point that is no number ends a stretch of the line.
            for stretch in points.split(|p| !p[1].is_finite()).filter(|s| !s.is_empty()) {
                let _ = write!(svg, "<polyline class=\"{class}\" points=\"");
                for (a, b) in thin::thinned(stretch.iter().filter_map(|p| at(*p)).collect()) {
                    let _ = write!(svg, "{a:.2},{b:.2} ");
                }
                svg.push_str("\"/>");
            }
        }
        Layer::Dots { class, points, .. } => {
            // One path of dots without length: round caps make them dots, and the file stays small.
            let _ = write!(svg, "<path class=\"dots {class}\" d=\"");
            for (a, b) in points.iter().filter_map(|p| at(*p)) {
                let _ = write!(svg, "M{a:.1} {b:.1}h0");
            }
            svg.push_str("\"/>");
        }
        Layer::Ribbon { class, points, .. } => {
            let low = points.iter().filter_map(|p| at([p[0], p[1]]));
            let high = points.iter().rev().filter_map(|p| at([p[0], p[2]]));
            let _ = write!(svg, "<polygon class=\"{class}\" points=\"");
            for (a, b) in low.chain(high) {
                let _ = write!(svg, "{a:.1},{b:.1} ");
            }
            svg.push_str("\"/>");
        }
        Layer::Bars { class, points, .. } => {
            for p in points {
                let (Some((a, b)), Some(low), Some(high)) = (at([p[0], p[1]]), y.place(p[2]), y.place(p[3]))
                else {
                    continue;
                };
                let _ = write!(
                    svg,
                    "<path class=\"bar {class}\" d=\"M{a:.1} {low:.1}V{high:.1}\"/><path class=\"dots {class}\" d=\"M{a:.1} {b:.1}h0\"/>"
                );
            }
        }
        Layer::Span { class, spans, .. } => {
            let height = SIZE.1 - MARGIN[1] - MARGIN[3];
            for s in spans {
                let Some((a, b)) = x.clipped(*s) else { continue };
                let _ = write!(
                    svg,
                    "<rect class=\"{class}\" x=\"{a:.1}\" y=\"{}\" width=\"{:.1}\" height=\"{height}\"/>",
                    MARGIN[1],
                    (b - a).max(1.5)
                );
            }
        }
    }
}

/// Text with the signs of HTML made harmless.
pub fn escaped(text: &str) -> String {
    visible(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_stands_where_its_axes_say() {
        let drawn = Picture::new("a & b", "x", "y")
            .with(Layer::line("after", "line", vec![[0.0, 0.0], [10.0, 1.0]]))
            .with(Layer::span("held", "held out", vec![[5.0, 99.0]]))
            .draw();
        assert!(drawn.contains("a &amp; b"));
        // x runs from 78 to 706, and a span beyond the frame ends at it
        assert!(drawn.contains("x=\"392.0\"") && drawn.contains("width=\"314.0\""), "{drawn}");
        assert!(drawn.find("held").unwrap() < drawn.find("polyline").unwrap());
    }

    #[test]
    fn long_texts_of_an_axis_have_room_and_the_legend_names_what_is_seen() {
        let line = |y: f64| Layer::line("after", "line", vec![[0.0, -y], [1.0, y]]);
        let drawn = Picture::new("", "x", "y")
            .with(line(0.00123))
            .with(Layer::span("held", "held out", vec![[2.0, 3.0]]))
            .draw();
        // a minus sign and five characters end before the axis, and begin inside the picture
        assert!(drawn.contains(">−0.001</text>"), "{drawn}");
        let at = drawn.split("<text x=\"").nth(1).and_then(|t| t.split('"').next()).unwrap();
        assert!(at.parse::<f64>().unwrap() > 6.0 * DIGIT, "{at}");
        assert!(drawn.contains("> line</span>") && !drawn.contains("held out"));
    }

    #[test]
    fn an_axis_counts_in_its_own_unit() {
        let of = |size: f64| {
            Picture::new("", "time", "y")
                .in_units_of(size)
                .with(Layer::span("held", "held out", vec![[3600.0 * size, 99.0 * size]]))
                .with(Layer::line("after", "line", vec![[0.0, 0.0], [7200.0 * size, 1.0]]))
                .draw()
        };
        assert!(of(60.0).contains(">6000</text>") && !of(60.0).contains(">400000</text>"));
        assert_eq!(of(60.0), of(1.0));
    }

    #[test]
    fn nothing_to_draw_is_no_figure() {
        assert!(Picture::new("", "", "").with(Layer::line("after", "", vec![])).draw().is_empty());
        let wrong = Layer::dots("after", "", vec![[f64::NAN, 1.0]]);
        assert!(Picture::new("", "", "").with(wrong).draw().is_empty());
    }
}
