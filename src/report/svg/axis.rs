//! Axes with round ticks.

/// How values lie along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    Linear,
    /// Evenly in their logarithm; what is not above zero is left out.
    Logarithmic,
}

/// Decades that a logarithmic axis shows at most.
const DECADES: f64 = 8.0;

/// An axis over a range of values, from one place to another.
pub struct Axis {
    scale: Scale,
    low: f64,
    high: f64,
    places: (f64, f64),
}

impl Axis {
    /// An axis that holds all finite values; `wider` leaves some room at both ends.
    pub fn over(
        values: impl Iterator<Item = f64>,
        scale: Scale,
        places: (f64, f64),
        wider: bool,
    ) -> Option<Self> {
        let usable = values.filter(|v| v.is_finite() && (scale == Scale::Linear || *v > 0.0));
        let inner = |v: f64| if scale == Scale::Linear { v } else { v.log10() };
        let range = usable
            .map(inner)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |r: (f64, f64), v| (r.0.min(v), r.1.max(v)));
        let (mut low, mut high) = range;
        if low > high {
            return None;
        }
        if scale == Scale::Logarithmic {
            low = low.max(high - DECADES);
        }
        let size = high - low;
        if size <= 1e-12 * low.abs().max(high.abs()) || size <= 0.0 {
            let room = if low == 0.0 { 1.0 } else { 0.5 * low.abs() };
            (low, high) = (low - room, high + room);
        } else if wider {
            (low, high) = (low - 0.04 * size, high + 0.04 * size);
        }
        Some(Self { scale, low, high, places })
    }

    /// The value at a place.
    pub fn value(&self, place: f64) -> f64 {
        let share = (place - self.places.0) / (self.places.1 - self.places.0);
        let inner = self.low + share * (self.high - self.low);
        if self.scale == Scale::Linear { inner } else { 10f64.powf(inner) }
    }

    /// What a script needs to draw it anew: both ends (their logarithms), both places, and whether it is logarithmic.
    pub fn told(&self) -> String {
        let is_log = u8::from(self.scale == Scale::Logarithmic);
        format!("{:e} {:e} {:.1} {:.1} {is_log}", self.low, self.high, self.places.0, self.places.1)
    }

    fn inner(&self, value: f64) -> f64 {
        if self.scale == Scale::Linear { value } else { value.log10() }
    }

    fn at(&self, inner: f64) -> f64 {
        let share = (inner - self.low) / (self.high - self.low);
        self.places.0 + share * (self.places.1 - self.places.0)
    }

    /// Where a value stands, held inside the frame; none for what is no number here.
    pub fn place(&self, value: f64) -> Option<f64> {
        let inner = self.inner(value);
        let low_end = self.scale == Scale::Logarithmic && value <= 0.0;
        (inner.is_finite() || low_end).then(|| self.at(inner.clamp(self.low, self.high)))
    }

    /// The part of a span that lies inside the frame, as places.
    pub fn clipped(&self, span: [f64; 2]) -> Option<(f64, f64)> {
        let (a, b) = (self.inner(span[0].min(span[1])), self.inner(span[0].max(span[1])));
        if a.is_nan() || b.is_nan() || b < self.low || a > self.high {
            return None;
        }
        Some((self.at(a.max(self.low)), self.at(b.min(self.high))))
    }

    /// About so many ticks: their places and texts.
    pub fn ticks(&self, about: usize) -> Vec<(f64, String)> {
        if self.scale == Scale::Linear {
            let (values, step) = ticks(self.low, self.high, about);
            return values.into_iter().map(|v| (self.at(v), tick_text(v, step))).collect();
        }
        let decades = ((self.high - self.low) / about as f64).ceil().max(1.0) as i32;
        let (from, to) = (self.low.ceil() as i32, self.high.floor() as i32);
        let marks = (from..=to).filter(|k| k.rem_euclid(decades) == 0);
        marks.map(|k| (self.at(f64::from(k)), power_text(k))).collect()
    }
}

/// Round values between two ends, in steps of 1, 2 or 5 times a power of ten, and that step.
///
/// ```
/// use gyrospec::report::svg::ticks;
/// assert_eq!(ticks(0.3, 9.7, 5), (vec![2.0, 4.0, 6.0, 8.0], 2.0));
/// ```
pub fn ticks(low: f64, high: f64, about: usize) -> (Vec<f64>, f64) {
    let raw = (high - low) / about.max(1) as f64;
    if !(raw > 0.0 && raw.is_finite()) {
        return (Vec::new(), 1.0);
    }
    let power = 10f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].iter().map(|m| m * power).find(|s| *s >= 0.999 * raw).unwrap_or(raw);
    let (from, to) = ((low / step - 1e-9).ceil() as i64, (high / step + 1e-9).floor() as i64);
    ((from..=to).map(|k| k as f64 * step).collect(), step)
}

/// A tick's value with the decimals that its step needs.
pub fn tick_text(value: f64, step: f64) -> String {
    let size = value.abs().max(step);
    if !(1e-4..1e6).contains(&size) {
        let digits = (size.log10().floor() - step.log10().floor()).clamp(0.0, 6.0) as usize;
        let text = format!("{value:.digits$e}");
        return if value == 0.0 { "0".into() } else { text.replace('-', "−") };
    }
    let decimals = (-step.log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{value:.decimals$}").replace('-', "−")
}

fn power_text(k: i32) -> String {
    match k {
        -3..=4 => tick_text(10f64.powi(k), 10f64.powi(k)),
        _ => format!("1e{k}").replace('-', "−"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        for (low, high) in [(0.0, 1.0), (-3e-7, 4e-7), (1e5, 1.2e5), (-20.0, 13.0)] {
            let (values, step) = ticks(low, high, 5);
            assert!((3..=8).contains(&values.len()), "{low} {high}: {values:?}");
            assert!(values.iter().all(|v| *v >= low - 1e-9 * step && *v <= high + 1e-9 * step));
        }
        assert_eq!(tick_text(-0.25, 0.05), "−0.25");
        assert_eq!(tick_text(2e-7, 1e-7), "2e−7");
    }

    #[test]
    fn a_logarithmic_axis_has_decades() {
        let axis = Axis::over([0.02, 30.0].into_iter(), Scale::Logarithmic, (0.0, 100.0), false).unwrap();
        let texts: Vec<String> = axis.ticks(6).into_iter().map(|t| t.1).collect();
        assert_eq!(texts, ["0.1", "1", "10"]);
        assert_eq!(axis.place(30.0).unwrap(), 100.0);
        assert_eq!(axis.clipped([0.0, 1e9]), Some((0.0, 100.0)));
    }
}
