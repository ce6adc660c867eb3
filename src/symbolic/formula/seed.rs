//! The formula for the error of a two-rotor gyrocompass on irregular roll, derived.
//!
//! Purpose: the mean azimuth error of the seed's compass from its equations and its roll spectrum.
//! Method: from the first line of (3.1) the mean of W₂x moves the meridian; W₁ moves x through 1/(Ts + 1), and
//! both are roll accelerations of density (3.4).
//! References: Potemkin 1978, (2.1), (2.3), (3.1) – (3.13).
//! Numerical aspects: exact. Errata of the source: its (3.4) is a density for K(τ) = ∫ S e^(jωτ) dω, but it is
//! integrated with 1/2π, so that the printed result is too small by 2π.

use super::FormulaRequest;

/// The request for the mean error, with the formula as the source prints it.
///
/// ```
/// use gyrospec::symbolic::{formula, irregular_roll};
/// let request = irregular_roll();
/// let derived = formula(&request.derivation()?, &request.simplifier()?)?;
/// assert_eq!(
///     derived.formula.text(),
///     "α = −P²h²A b²(2μ + b²T) sin 2K / (2 H U C0 g² T [T²ε² + (1+μT)²] cos φ)"
/// );
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn irregular_roll() -> FormulaRequest {
    let text = |text: &str| Some(text.to_owned());
    FormulaRequest {
        name: text("alpha"),
        // W₂ = +h θ″ sin K
        first: text("h*sin(K)"),
        // T x′ + x = P W₁/(g C₀), W₁ = −h θ″ cos K
        second: text("-P/(g*C0)*h*cos(K)/(T*s + 1)"),
        // S_θ″ = (2Aμ/π) b² ω⁴/(ω⁴ + 2aω² + b⁴) for K(τ) = ∫ S e^(jωτ) dω: 2π S = 4Aμb² |s²/(s² + 2μs + b²)|²
        shaping: text("s^2/(s^2 + 2*mu*s + b^2)"),
        density: text("4*A*mu*b^2"),
        // U α cos φ = <M_y>/H, M_y = (P/g) W₂ x
        times: text("P/(g*H*U*cos(phi))"),
        relations: vec!["b^2 = mu^2 + eps^2".into(), "sin(K)*cos(K) = sin(2*K)/2".into()],
        keep: vec!["T^2*eps^2 + (1 + mu*T)^2".into()],
        order: "P h A mu b H U C0 g T".into(),
        // (3.13) and the line after it
        printed: text(
            "-P^2*h^2*A*b^2*(2*mu + b^2*T)*sin(2*K)\
             /(4*pi*H*U*C0*g^2*T*(T^2*eps^2 + (1 + mu*T)^2)*cos(phi))",
        ),
        ..FormulaRequest::default()
    }
}
