//! A combination with letters.

use crate::gyro::elastic::part::Letters;
use crate::gyro::elastic::suspension::Suspension;

/// W₁ to x less W₂ to y, since M_y = (P/g)(W₂ x − W₁ y) and roll drives both by one angle; `None` where a part is not
/// linear.
pub(super) fn letters(s: &Suspension) -> Option<Letters> {
    if !s.is_linear() {
        return None;
    }
    let mut give = if s.inertia { heavy(s) } else { massless(s) };
    if s.meridian.is_some() {
        give.push_str(if s.inertia {
            // m ÿ + C₁ T₁ ẏ + C₁ y = m W₂
            " - m/(m*s^2 + C_1*T_1*s + C_1)"
        } else {
            " - P/(g*C_1*(T_1*s + 1))"
        });
    }
    let order = if s.inertia { "P m h A mu b H U g r C0" } else { "P h A mu b H U C0 g T" };
    // W₁ = −h θ̈ cos K
    Some(Letters { shift: format!("-h*cos(K)*({give})").into(), order: order.into() })
}

/// (m/C₀)(1/(T s + 1) + κ/(T₂ s + 1)) + μ L
fn massless(s: &Suspension) -> String {
    let flow = if s.flow.is_some() { " + kappa/(T_2*s + 1)" } else { "" };
    let slosh = if s.swing.is_some() { format!(" + mu_s*{L}") } else { String::new() };
    format!("P/(g*C0)*(1/(T*s + 1){flow}){slosh}")
}

const L: &str = "1/(s^2 + 2*zeta*omega*s + omega^2)";

/// x_v = M J/(1 + M J s²) W₁ and x = x_v + μ L (W₁ − s² x_v).
fn heavy(s: &Suspension) -> String {
    let flow = if s.flow.is_some() { " + kappa/(C0*(T_2*s + 1))" } else { "" };
    let compliance = format!("(1/(r*s + C0){flow})");
    if s.swing.is_none() {
        return format!("m*{compliance}/(1 + m*{compliance}*s^2)");
    }
    let fixed = format!("(1 - mu_s*s^2*{L})");
    let give = format!("m*{fixed}*{compliance}/(1 + m*{fixed}*{compliance}*s^2)");
    format!("{give}*{fixed} + mu_s*{L}")
}
