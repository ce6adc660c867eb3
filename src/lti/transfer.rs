//! Rational transfer functions C(s)/H(s).

use crate::poly::{self, product};
use crate::{Error, Result};
use num_complex::Complex64;

/// A transfer function C(s)/H(s) with real coefficients in descending powers of s.
///
/// ```
/// use gyrospec::lti::TransferFunction;
/// use num_complex::Complex64;
/// let lag = TransferFunction::new(&[1.0], &[0.44, 1.0]).unwrap();   // 1/(T s + 1)
/// let w = lag.at(Complex64::new(0.0, 0.98));                        // s = jω, rad/s
/// assert!((w.norm() - 1.0 / (1.0f64 + (0.44f64 * 0.98).powi(2)).sqrt()).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TransferFunction {
    numerator: Vec<f64>,
    denominator: Vec<f64>,
}

impl TransferFunction {
    /// C/H from descending coefficients; leading zeros are dropped.
    ///
    /// # Errors
    /// `BadInput` for an empty list, a number that is not finite, H = 0, or more zeros than poles.
    pub fn new(numerator: &[f64], denominator: &[f64]) -> Result<Self> {
        if numerator.is_empty() || denominator.is_empty() {
            return Err(Error::bad_input("a transfer function needs a numerator and a denominator"));
        }
        if numerator.iter().chain(denominator).any(|c| !c.is_finite()) {
            return Err(Error::bad_input("a coefficient of a transfer function is not finite"));
        }
        let (numerator, denominator) = (trimmed(numerator), trimmed(denominator));
        if denominator[0] == 0.0 {
            return Err(Error::bad_input("the denominator of a transfer function is zero"));
        }
        if numerator.len() > denominator.len() {
            let (zeros, poles) = (numerator.len() - 1, denominator.len() - 1);
            let text = format!("a transfer function has more zeros ({zeros}) than poles ({poles})");
            return Err(
                Error::bad_input(text).with_hint("coefficients stand from the highest power of s down")
            );
        }
        Ok(Self { numerator, denominator })
    }

    /// The number `k`.
    pub fn constant(k: f64) -> Self {
        Self { numerator: vec![k], denominator: vec![1.0] }
    }

    /// C, descending.
    pub fn numerator(&self) -> &[f64] {
        &self.numerator
    }

    /// H, descending.
    pub fn denominator(&self) -> &[f64] {
        &self.denominator
    }

    /// The number of poles.
    pub fn order(&self) -> usize {
        self.denominator.len() - 1
    }

    /// Poles less zeros.
    pub fn relative_degree(&self) -> usize {
        self.denominator.len() - self.numerator.len()
    }

    /// The value at a complex frequency s, 1/s.
    pub fn at(&self, s: Complex64) -> Complex64 {
        poly::at(&self.numerator, s) / poly::at(&self.denominator, s)
    }

    /// |W(jω)|², ω in rad/s.
    pub fn power(&self, omega: f64) -> f64 {
        self.at(Complex64::new(0.0, omega)).norm_sqr()
    }

    /// One after the other: the product. Nothing is cancelled.
    ///
    /// ```
    /// use gyrospec::TransferFunction;
    /// let lag = TransferFunction::new(&[1.0], &[2.0, 1.0])?;
    /// assert_eq!(lag.then(&lag).denominator(), [4.0, 4.0, 1.0]);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        Self {
            numerator: trimmed(&product(&self.numerator, &next.numerator)),
            denominator: product(&self.denominator, &next.denominator),
        }
    }

    /// Side by side: the sum; a common denominator is kept once.
    ///
    /// ```
    /// use gyrospec::TransferFunction;
    /// let (slow, quick) = (TransferFunction::new(&[1.0], &[2.0, 1.0])?, TransferFunction::new(&[1.0], &[1.0, 1.0])?);
    /// assert_eq!(slow.beside(&quick).numerator(), [3.0, 2.0]);       // (s + 1) + (2 s + 1)
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    #[must_use]
    pub fn beside(&self, other: &Self) -> Self {
        if self.denominator == other.denominator {
            let numerator = trimmed(&sum(&self.numerator, &other.numerator));
            return Self { numerator, denominator: self.denominator.clone() };
        }
        let crossed =
            sum(&product(&self.numerator, &other.denominator), &product(&other.numerator, &self.denominator));
        Self { numerator: trimmed(&crossed), denominator: product(&self.denominator, &other.denominator) }
    }

    /// `k` times this.
    #[must_use]
    pub fn scaled(&self, k: f64) -> Self {
        let numerator = trimmed(&self.numerator.iter().map(|c| k * c).collect::<Vec<_>>());
        Self { numerator, denominator: self.denominator.clone() }
    }

    /// s times this: the derivative of the signal.
    ///
    /// # Errors
    /// `BadInput` when the result would have more zeros than poles.
    pub fn differentiated(&self) -> Result<Self> {
        let mut numerator = self.numerator.clone();
        numerator.push(0.0);
        Self::new(&numerator, &self.denominator)
    }
}

/// p + q, the constant terms aligned.
fn sum(p: &[f64], q: &[f64]) -> Vec<f64> {
    let n = p.len().max(q.len());
    let at = |c: &[f64], i: usize| (i + c.len()).checked_sub(n).map_or(0.0, |k| c[k]);
    (0..n).map(|i| at(p, i) + at(q, i)).collect()
}

/// Without its leading zeros; the zero polynomial is `[0]`.
fn trimmed(p: &[f64]) -> Vec<f64> {
    let first = p.iter().position(|c| *c != 0.0).unwrap_or(p.len().saturating_sub(1));
    p[first..].to_vec()
}
