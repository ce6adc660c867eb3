//! A combination in symbols.

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
    let order = if s.tilt.is_some() { format!("{order} lP q tau zeta omega") } else { order.into() };
    Some(Letters { shift: format!("-h*cos(K)*({give})").into(), order: order.into() })
}

/// (m/C₀)(1/(T s + 1) + κ/(T₂ s + 1)) + μ L + N.
fn massless(s: &Suspension) -> String {
    let flow = if s.flow.is_some() { " + kappa/(T_2*s + 1)" } else { "" };
    let slosh = if s.swing.is_some() { format!(" + mu_s/{LIQUID}") } else { String::new() };
    let tilt = tilt(s).map_or_else(String::new, |(above, below)| format!(" + {above}/{below}"));
    format!("P/(g*C0)*(1/(T*s + 1){flow}){slosh}{tilt}")
}

const LIQUID: &str = "(s^2 + 2*zeta*omega*s + omega^2)";

/// N = (l/g) ω² (1 + τ s)/[…], l = lP/P, above and below; in symbols of its own where liquid swings too.
fn tilt(s: &Suspension) -> Option<(String, String)> {
    s.tilt?;
    let n = if s.swing.is_some() { "_n" } else { "" };
    let free = format!("((1 - q)*s^2 + 2*zeta{n}*omega{n}*s + omega{n}^2)");
    Some((format!("lP*omega{n}^2*(tau*s + 1)"), format!("(P*g*({free}*(tau*s + 1) + q*s^2))")))
}

/// A = μ L + N, above and below.
fn inside(s: &Suspension) -> Option<(String, String)> {
    let slosh = s.swing.map(|_| ("mu_s".to_owned(), LIQUID.to_owned()));
    match (slosh, tilt(s)) {
        (Some((a, b)), Some((c, d))) => Some((format!("({a}*{d} + {c}*{b})"), format!("({b}*{d})"))),
        (one, other) => one.or(other),
    }
}

/// x_v = M J/(1 + M J s²) W₁, x = x_v + A (W₁ − s² x_v) and M = m(1 − s² A): with J = j/i and A = a/b
/// x = [m j (b − s² a) + i a]/[i b + m j (b − s² a) s²] W₁.
fn heavy(s: &Suspension) -> String {
    let (j, i) = match s.flow {
        Some(_) => ("(C0*(T_2*s + 1) + kappa*(r*s + C0))", "(C0*(T_2*s + 1)*(r*s + C0))"),
        None => ("1", "(r*s + C0)"),
    };
    match inside(s) {
        Some((a, b)) => {
            let fixed = format!("m*{j}*({b} - s^2*{a})");
            format!("({fixed} + {i}*{a})/({i}*{b} + {fixed}*s^2)")
        }
        None => format!("m*{j}/({i} + m*{j}*s^2)"),
    }
}
