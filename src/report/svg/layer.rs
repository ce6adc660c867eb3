//! What a picture is made of.

/// What a picture is made of; classes give the colours.
#[derive(Debug, Clone)]
pub enum Layer {
    /// A line through points.
    Line {
        class: &'static str,
        /// Name in the legend; empty for none.
        name: String,
        /// Points, in order.
        points: Vec<[f64; 2]>,
    },
    /// A dot at each point.
    Dots {
        class: &'static str,
        /// Name in the legend; empty for none.
        name: String,
        points: Vec<[f64; 2]>,
    },
    /// A band between two values along x: x, low, high.
    Ribbon {
        class: &'static str,
        /// Name in the legend; empty for none.
        name: String,
        /// x, low and high, in order.
        points: Vec<[f64; 3]>,
    },
    /// A dot with a bar from low to high: x, y, low, high.
    Bars {
        class: &'static str,
        /// Name in the legend; empty for none.
        name: String,
        /// x, y, low and high.
        points: Vec<[f64; 4]>,
    },
    /// A span of x over the whole height; a span of no width is drawn as a thin mark.
    Span {
        class: &'static str,
        /// Name in the legend; empty for none.
        name: String,
        /// From and to.
        spans: Vec<[f64; 2]>,
    },
}

impl Layer {
    /// A line.
    pub fn line(class: &'static str, name: &str, points: Vec<[f64; 2]>) -> Self {
        Self::Line { class, name: name.into(), points }
    }

    pub fn dots(class: &'static str, name: &str, points: Vec<[f64; 2]>) -> Self {
        Self::Dots { class, name: name.into(), points }
    }

    /// Spans of x.
    pub fn span(class: &'static str, name: &str, spans: Vec<[f64; 2]>) -> Self {
        Self::Span { class, name: name.into(), spans }
    }

    pub(super) fn legend(&self) -> (&'static str, &str, &'static str) {
        match self {
            Self::Line { class, name, points } => (class, shown(name, points.is_empty()), "line"),
            Self::Dots { class, name, points } => (class, shown(name, points.is_empty()), "dot"),
            Self::Bars { class, name, points } => (class, shown(name, points.is_empty()), "dot"),
            Self::Ribbon { class, name, points } => (class, shown(name, points.is_empty()), "patch"),
            Self::Span { class, name, spans } => (class, shown(name, spans.is_empty()), "patch"),
        }
    }

    /// The same layer with x counted in another unit, so many times as large.
    pub(super) fn in_units_of(mut self, size: f64) -> Self {
        fn each<const N: usize>(points: &mut [[f64; N]], size: f64) {
            for p in points {
                p[0] /= size;
            }
        }
        match &mut self {
            Self::Line { points, .. } | Self::Dots { points, .. } => each(points, size),
            Self::Ribbon { points, .. } => each(points, size),
            Self::Bars { points, .. } => each(points, size),
            Self::Span { spans, .. } => spans.iter_mut().flatten().for_each(|x| *x /= size),
        }
        self
    }

    /// Corners that the frame must hold; spans of x ask for nothing.
    pub(super) fn corners(&self) -> Vec<[f64; 2]> {
        match self {
            Self::Line { points, .. } | Self::Dots { points, .. } => points.clone(),
            Self::Ribbon { points, .. } => points.iter().flat_map(|p| [[p[0], p[1]], [p[0], p[2]]]).collect(),
            Self::Bars { points, .. } => points.iter().flat_map(|p| [[p[0], p[2]], [p[0], p[3]]]).collect(),
            Self::Span { .. } => Vec::new(),
        }
    }
}

fn shown(name: &str, empty: bool) -> &str {
    if empty { "" } else { name }
}
