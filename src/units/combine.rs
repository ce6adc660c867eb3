//! Products and quotients of units, with a readable text: `N` over `m/s` is `N*s/m`.

use super::{Dimension, Unit, names};

/// What stands in the sums of balances.
const USUAL: [&str; 9] = ["N", "N*m", "W", "V", "A", "kg/s", "m^3/s", "mol/s", "Pa"];

impl Unit {
    /// The unit of a product of a value in this unit and one in the other.
    ///
    /// ```
    /// use gyrospec::units::Unit;
    /// let force = Unit::parse("N")?;
    /// let speed = Unit::parse("m/s")?;
    /// assert_eq!(force.over(&speed).text(), "N*s/m");
    /// assert_eq!(speed.times(&Unit::parse("s")?).text(), "m");
    /// assert_eq!(Unit::parse("s")?.times(&Unit::parse("A*V")?).text(), "V*A*s");
    /// let rate = Unit::parse("kg/(m^3*s)")?;
    /// assert_eq!(rate.times(&Unit::one()).text(), "kg/m^3/s");
    /// assert_eq!(rate.over(&Unit::parse("kg/m^3")?).text(), "1/s");
    /// assert_eq!(Unit::parse("deg*rad/s^2")?.over(&Unit::parse("rad^3")?).text(), "1/s^2/rad");
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        self.joined(other, 1.0)
    }

    /// The unit of a quotient.
    #[must_use]
    pub fn over(&self, other: &Self) -> Self {
        self.joined(other, -1.0)
    }

    /// The unit to a whole or half power.
    #[must_use]
    pub fn power(&self, exponent: f64) -> Self {
        Self::one().joined(self, exponent)
    }

    /// The same unit as people write it of a force, a flow or a rate, where that is shorter.
    ///
    /// ```
    /// use gyrospec::units::Unit;
    /// assert_eq!(Unit::parse("V*s*A/rad")?.usual().text(), "N*m");
    /// assert_eq!(Unit::parse("J/K*K/s")?.usual().text(), "W");
    /// assert_eq!(Unit::parse("Pa*cm^2")?.usual().text(), "N");
    /// assert_eq!(Unit::parse("kN*m")?.usual().text(), "kN*m");
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    #[must_use]
    pub fn usual(&self) -> Self {
        let joints = |text: &str| text.matches(['*', '/']).count();
        let mut known = USUAL.iter().filter_map(|text| Self::parse(text).ok());
        let shorter = |u: &Self| u.dimension == self.dimension && joints(u.text()) < joints(&self.text);
        known.find(shorter).unwrap_or_else(|| self.clone())
    }

    fn joined(&self, other: &Self, sign: f64) -> Self {
        let mut factors = factors(&self.of_differences().text);
        for (name, power) in self::factors(&other.of_differences().text) {
            match factors.iter_mut().find(|(n, _)| *n == name) {
                Some((_, p)) => *p += sign * power,
                None => factors.push((name, sign * power)),
            }
        }
        let factors = in_radians(factors);
        Self::parse(&text(&factors)).unwrap_or_else(|_| {
            let d = other.dimension.power(super::Ratio::from_f64(sign).unwrap_or(super::Ratio::ONE));
            Self::of(self.dimension.times(d))
        })
    }
}

/// A text without its parentheses: `kg/(m^3*s)` is `kg/m^3/s`. `None` where they stand in each other or under a power.
fn opened(text: &str) -> Option<String> {
    let (mut out, mut before) = (String::new(), '*');
    let mut inside: Option<bool> = None;
    for c in text.chars().filter(|c| !c.is_whitespace()) {
        match (c, inside) {
            ('(', None) if before == '*' || before == '/' => inside = Some(before == '/'),
            (')', Some(_)) => inside = None,
            ('(' | ')', _) => return None,
            ('*' | '/', Some(true)) => out.push(if c == '*' { '/' } else { '*' }),
            ('^', _) if before == ')' => return None,
            _ => out.push(c),
        }
        before = c;
    }
    inside.is_none().then_some(out)
}

/// Degrees beside radians are told as radians: of `deg/rad^2` nobody reads how much it is.
fn in_radians(factors: Vec<(String, f64)>) -> Vec<(String, f64)> {
    let powers = |angle: &str| factors.iter().find(|(name, p)| name == angle && *p != 0.0).map(|(_, p)| *p);
    let (Some(degrees), Some(radians)) = (powers("deg"), powers("rad")) else { return factors };
    let others = factors.into_iter().filter(|(name, _)| name != "deg" && name != "rad");
    others.chain([("rad".to_string(), degrees + radians)]).collect()
}

/// The factors of a text, each with its power; one whose parentheses cannot be opened is spelled in SI.
fn factors(text: &str) -> Vec<(String, f64)> {
    let mut out: Vec<(String, f64)> = Vec::new();
    let mut sign = 1.0;
    let plain = if text.contains('(') {
        opened(text).unwrap_or_else(|| Unit::parse(text).map(|u| u.dimension.to_string()).unwrap_or_default())
    } else {
        text.to_string()
    };
    for piece in plain.split_inclusive(['*', '/']) {
        let factor = piece.trim_end_matches(['*', '/']).trim();
        let (name, power) = factor.split_once('^').unwrap_or((factor, "1"));
        let power = sign * power.trim().parse::<f64>().unwrap_or(1.0);
        if name.trim() != "1" {
            out.push((name.trim().to_string(), power));
        }
        sign = if piece.ends_with('/') { -1.0 } else { 1.0 };
    }
    out
}

/// The place of a factor in a product: derived units as V and N first, then lengths, masses, amounts and angles, then A and K,
/// then times: `V*A*s`, `N*m*s`.
fn rank(name: &str) -> usize {
    const PLACES: [&[[i32; 6]]; 3] = [
        &[[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 0, 0, 0, 1], [0; 6]],
        &[[0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0]],
        &[[0, 0, 1, 0, 0, 0]],
    ];
    let Some(own) = names::find(name).map(|n| n.dimension) else { return 0 };
    let holds = |all: &&[[i32; 6]]| all.iter().any(|powers| Dimension::whole(*powers) == own);
    PLACES.iter().position(holds).map_or(0, |i| i + 1)
}

fn text(factors: &[(String, f64)]) -> String {
    let spell =
        |(name, p): &(String, f64)| if p.abs() == 1.0 { name.clone() } else { format!("{name}^{}", p.abs()) };
    let mut above: Vec<&(String, f64)> = factors.iter().filter(|f| f.1 > 0.0).collect();
    above.sort_by_key(|f| rank(&f.0));
    let over: Vec<String> = above.into_iter().map(spell).collect();
    let under: Vec<String> = factors.iter().filter(|f| f.1 < 0.0).map(spell).collect();
    let head = if over.is_empty() { "1".to_string() } else { over.join("*") };
    [vec![head], under].concat().join("/")
}
