//! Dimensions: powers of metre, kilogram, second, ampere, kelvin and mole, with rational exponents.

use std::fmt;

/// Derived SI units used to spell a dimension.
const DERIVED: [(&str, [i32; 6]); 4] = [
    ("N", [1, 1, -2, 0, 0, 0]),
    ("Pa", [-1, 1, -2, 0, 0, 0]),
    ("W", [2, 1, -3, 0, 0, 0]),
    ("V", [2, 1, -3, -1, 0, 0]),
];

/// A small rational number, in lowest terms with a positive denominator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Ratio {
    numerator: i32,
    denominator: i32,
}

impl Ratio {
    /// The exponent of a base unit that does not stand in a unit.
    pub const ZERO: Self = Self { numerator: 0, denominator: 1 };
    /// The exponent of a base unit itself.
    pub const ONE: Self = Self { numerator: 1, denominator: 1 };

    /// n/d in lowest terms; `None` for d = 0.
    pub fn new(numerator: i32, denominator: i32) -> Option<Self> {
        Self::reduced(i64::from(numerator), i64::from(denominator))
    }

    fn reduced(numerator: i64, denominator: i64) -> Option<Self> {
        let (mut a, mut b) = (numerator.abs(), denominator.abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        let g = a.max(1) * denominator.signum();
        (denominator != 0).then_some(())?;
        Some(Self {
            numerator: i32::try_from(numerator / g).ok()?,
            denominator: i32::try_from(denominator / g).ok()?,
        })
    }

    /// The fraction with a denominator up to 12 that equals x to rounding.
    ///
    /// ```
    /// use gyrospec::units::Ratio;
    /// assert_eq!(Ratio::from_f64(1.5), Ratio::new(3, 2));
    /// assert_eq!(Ratio::from_f64(0.1234), None);
    /// ```
    pub fn from_f64(x: f64) -> Option<Self> {
        (1..=12i32).find_map(|d| {
            let n = (x * f64::from(d)).round();
            let near = (n / f64::from(d) - x).abs() <= 1e-12 * x.abs().max(1.0);
            (near && n.abs() < 1e6).then(|| Self::new(n as i32, d)).flatten()
        })
    }

    /// The ratio as the nearest double.
    pub fn to_f64(self) -> f64 {
        f64::from(self.numerator) / f64::from(self.denominator)
    }

    /// The numerator in lowest terms.
    pub fn numerator(self) -> i32 {
        self.numerator
    }

    /// The denominator, positive.
    pub fn denominator(self) -> i32 {
        self.denominator
    }

    /// The sum; 0 where it does not fit.
    #[must_use]
    pub(crate) fn plus(self, other: Self) -> Self {
        let (a, b) = (i64::from(self.numerator), i64::from(self.denominator));
        let (c, d) = (i64::from(other.numerator), i64::from(other.denominator));
        Self::reduced(a * d + c * b, b * d).unwrap_or(Self::ZERO)
    }

    /// The product; 0 where it does not fit.
    #[must_use]
    pub(crate) fn times(self, other: Self) -> Self {
        let n = i64::from(self.numerator) * i64::from(other.numerator);
        let d = i64::from(self.denominator) * i64::from(other.denominator);
        Self::reduced(n, d).unwrap_or(Self::ZERO)
    }

    /// The same with the other sign.
    #[must_use]
    pub(crate) fn negative(self) -> Self {
        Self { numerator: -self.numerator, ..self }
    }
}

impl fmt::Display for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.denominator {
            1 => write!(f, "{}", self.numerator),
            2 => write!(f, "{}", self.to_f64()),
            d => write!(f, "({}/{d})", self.numerator),
        }
    }
}

/// The base units, in the order of the exponents.
const BASE: [&str; 6] = ["m", "kg", "s", "A", "K", "mol"];

/// Powers of m, kg, s, A, K, mol; angles count as 1.
///
/// ```
/// use gyrospec::units::Unit;
/// let force = Unit::parse("kg*m/s^2")?.dimension();
/// assert_eq!(force, Unit::parse("dyn")?.dimension());
/// assert_eq!(force.to_string(), "N");
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Dimension([Ratio; 6]);

impl Dimension {
    /// No dimension: pure numbers and angles.
    pub const NONE: Self = Self([Ratio::ZERO; 6]);
    /// Time, s.
    pub const TIME: Self = Self::base(2);
    /// Thermodynamic temperature, K.
    pub const TEMPERATURE: Self = Self::base(4);

    const fn base(i: usize) -> Self {
        let mut exponents = [Ratio::ZERO; 6];
        exponents[i] = Ratio::ONE;
        Self(exponents)
    }

    /// Whole powers of m, kg, s, A, K, mol.
    pub(super) fn whole(powers: [i32; 6]) -> Self {
        Self(powers.map(|numerator| Ratio { numerator, denominator: 1 }))
    }

    /// Whether this is the dimension of pure numbers.
    pub fn is_none(self) -> bool {
        self == Self::NONE
    }

    /// The dimension of a product.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        let mut out = self.0;
        for (a, b) in out.iter_mut().zip(other.0) {
            *a = a.plus(b);
        }
        Self(out)
    }

    /// The dimension of a quotient.
    #[must_use]
    pub fn over(self, other: Self) -> Self {
        self.times(Self(other.0.map(Ratio::negative)))
    }

    /// The dimension of a power.
    #[must_use]
    pub fn power(self, exponent: Ratio) -> Self {
        Self(self.0.map(|e| e.times(exponent)))
    }

    /// The text in base units after one derived unit has been taken out, and its length: the sum of all powers.
    fn spelled(self, derived: &str) -> (f64, String) {
        let mut over = Vec::new();
        let mut under = Vec::new();
        let mut length = 0.0;
        if !derived.is_empty() {
            over.push(derived.to_string());
            length += 1.0;
        }
        for (name, e) in BASE.iter().zip(self.0) {
            let list = if e.numerator < 0 { &mut under } else { &mut over };
            let size = if e.numerator < 0 { e.negative() } else { e };
            length += size.to_f64();
            match size {
                Ratio::ZERO => {}
                Ratio::ONE => list.push((*name).to_string()),
                _ => list.push(format!("{name}^{size}")),
            }
        }
        let head = if over.is_empty() { "1".to_string() } else { over.join("*") };
        (length, [vec![head], under].concat().join("/"))
    }

    /// The powers of m, kg, s, A, K and mol.
    pub fn powers(self) -> [f64; 6] {
        self.0.map(Ratio::to_f64)
    }

    /// Whether a power of mass is in it; nobody writes N/kg or W*kg.
    fn has_mass(self) -> bool {
        self.0[1] != Ratio::ZERO
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plain = self.spelled("");
        let best = DERIVED
            .iter()
            .map(|(name, powers)| (name, self.over(Self::whole(*powers))))
            .filter(|(_, rest)| !rest.has_mass())
            .map(|(name, rest)| rest.spelled(name))
            .fold(plain, |best, other| if other.0 < best.0 { other } else { best });
        f.write_str(&best.1)
    }
}
