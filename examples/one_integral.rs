//! One spectral integral: the variance of a roll behind a lag. Run with `cargo run --release --no-default-features
//! --example one_integral`.
#![allow(clippy::print_stdout)]

use gyrospec::{Integrand, Result, evaluate};

fn main() -> Result<()> {
    // G/(H(jω)H(−jω)) with H = (s² + 0.2 s + 1)(2 s + 1), highest power first; G in powers of s²: 0·s⁴ + 0·s² + 1
    let h = [2.0, 1.4, 2.2, 1.0];
    let variance = evaluate(&Integrand::new(&h, &[0.0, 0.0, 1.0])?)?;
    println!("{} ± {:.1e}", variance.value, variance.error_bound);
    Ok(())
}
