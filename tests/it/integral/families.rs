//! Seeded families of stable polynomials.

use gyrospec::poly::product;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The families of the accuracy table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Family {
    /// Time constants and damping ratios of order one.
    Well,
    /// Time constants spread over eight decades.
    Stiff,
    /// One pair with damping 1e-6 among well-damped ones.
    OnePair,
    /// All pairs with damping between 1e-3 and 1e-2.
    AllLight,
}

pub const FAMILIES: [Family; 4] = [Family::Well, Family::Stiff, Family::OnePair, Family::AllLight];

pub fn generator(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

/// A polynomial of order n as a product of real and complex factors.
pub fn polynomial(family: Family, n: usize, rng: &mut ChaCha8Rng) -> Vec<f64> {
    let mut h = vec![1.0];
    let mut left = n;
    while left > 0 {
        let frequency = match family {
            Family::Stiff => 10f64.powf(rng.random_range(-4.0..4.0)),
            _ => rng.random_range(0.3..3.0),
        };
        let damping = match family {
            Family::OnePair if left == n => 1e-6,
            Family::AllLight => 10f64.powf(rng.random_range(-3.0..-2.0)),
            _ => rng.random_range(0.2..1.5),
        };
        if left >= 2 && (damping < 0.1 || rng.random_bool(0.6)) {
            h = product(&h, &[1.0, 2.0 * damping * frequency, frequency * frequency]);
            left -= 2;
        } else {
            h = product(&h, &[1.0, frequency]);
            left -= 1;
        }
    }
    h
}

pub fn coefficients(n: usize, rng: &mut impl Rng) -> Vec<f64> {
    (0..n).map(|_| rng.random_range(-1.0..1.0)).collect()
}
