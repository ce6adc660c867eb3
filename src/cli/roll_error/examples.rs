//! The examples of the rolling-error paper, as derived and as printed.

use crate::Result;
use crate::gyro::{Gyrosphere, SIGN, seed};
use crate::spectrum::Roll;
use std::fmt::Write;

pub fn text() -> Result<String> {
    let mut out = String::new();
    let (sphere, regular, heading) = seed::example_2_1();
    let error = seed::regular_error(&sphere, &regular, heading);
    let _ = writeln!(
        out,
        "Rolling error of the paper's gyrocompass (U = 7.3e-5 1/s as printed, g = 981 cm/s²)\n\
         sign: {SIGN}\n\n\
         Example 2.1, regular roll: heading 200°, θ₀h = 23.5 cm, p = 0.98 1/s, latitude 46°30′\n\
         \x20 by (2.4)                          {:>9.4}°   (printed −0.28°, measured −0.3°)\n",
        error.to_degrees()
    );
    irregular(&mut out)?;
    limit(&mut out)?;
    out.push_str(
        "\nErrata behind the difference: (3.4) is the density for K(τ) = ∫ S e^{jωτ} dω, yet (3.7), (3.9)\n\
         and (3.12) divide by 2π: the printed factor P²/(4πHUC₀g²) should be P²/(2HUC₀g²). The last term\n\
         of the denominators of (3.4), (3.6) is b⁴, not b². Example 3.1 prints 9.81² for 981², and its\n\
         −0.75° does not follow from its own formula.\n\n\
         More: gyrospec roll-error [PARAMETERS] [RECORDING], gyrospec roll-error --help\n",
    );
    Ok(out)
}

fn irregular(out: &mut String) -> Result<()> {
    let (sphere, roll, heading) = seed::example_3_1();
    let derived = seed::irregular_error(&sphere, &roll, heading)?;
    let printed = seed::irregular_error_as_printed(&sphere, &roll, heading);
    let _ = writeln!(
        out,
        "Example 3.1, irregular roll: heading 45°, h = 3 m, A = 0.03 rad², μ = 0.1 1/s, ε = 0.8 rad/s, latitude 60°\n\
         \x20 as derived (I₃)                   {:>9.3}°\n\
         \x20 by the printed formula            {:>9.4}°   (too small by exactly 2π = {:.6})\n\
         \x20 the number in print               {:>9.2}°   (not what its own formula gives)\n",
        derived.to_degrees(),
        printed.to_degrees(),
        derived / printed,
        seed::EXAMPLE_3_1_IN_PRINT
    );
    Ok(())
}

/// For μ → 0 irregular roll becomes a sine with θ₀² = 2A, and its error (2.4).
fn limit(out: &mut String) -> Result<()> {
    let (sphere, roll, heading) = seed::example_3_1();
    out.push_str(
        "The test that needs no convention: for μ → 0 the roll becomes a sine, θ₀² = 2A, p = ε, and its error (2.4)\n\
         \x20       μ, 1/s      derived      printed     (2.4)\n",
    );
    let amplitude = (2.0 * roll.variance).sqrt();
    let regular = seed::Regular { amplitude, frequency: roll.frequency };
    let wanted = regular_degrees(&sphere, &regular, heading);
    for decay in [0.1, 1e-2, 1e-3, 1e-4, 1e-6] {
        let roll = Roll { decay, ..roll };
        let derived = seed::irregular_error(&sphere, &roll, heading)?.to_degrees();
        let printed = seed::irregular_error_as_printed(&sphere, &roll, heading).to_degrees();
        let _ = writeln!(out, "  {decay:>12e}   {derived:>9.4}°   {printed:>9.4}°  {wanted:>9.4}°");
    }
    Ok(())
}

fn regular_degrees(sphere: &Gyrosphere, roll: &seed::Regular, heading: f64) -> f64 {
    seed::regular_error(sphere, roll, heading).to_degrees()
}
