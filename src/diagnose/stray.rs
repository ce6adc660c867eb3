//! Samples that stand apart from the rest of a noise.
//!
//! # Purpose
//! A residual of small noise and a few wild samples is no noise of one kind, though it has no colour and no law.
//!
//! # Method
//! Of the innovations beyond x robust deviations, those beyond rx are counted, r = 2 or 3/2. Least squares supposes a noise whose
//! variance exists; the heaviest tail that just does not have one is that of Student's t with two degrees of freedom,
//! of which a share q = P(|t| > rx)/P(|t| > x) ≈ 1/r² lies beyond r times any far point. So many of so many by
//! luck: the binomial distribution, times the number of points x that are tried.
//!
//! # References
//! V. Barnett, T. Lewis, Outliers in Statistical Data, 3rd ed., Wiley 1994, chapter 6, on tests against heavy tails.
//!
//! # Numerical aspects
//! The deviation never falls below the resolution of the channel or the error of the simulation.

use statrs::distribution::{Binomial, ContinuousCDF, DiscreteCDF, StudentsT};

/// Points tried, in robust deviations: beyond all that normal noise reaches in any recording.
const BEYOND: [f64; 8] = [6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0, 64.0];
/// The same with what lies one and a half times as far, for outliers of about one size.
const NEARER: [f64; 4] = [4.0, 5.0, 6.0, 8.0];
/// Robust deviations of a sample that may stand apart by itself, how many may, and the chance of as many nearer ones by luck from
/// which on the tails are none.
const LONE: f64 = 20.0;
const FEW: usize = 2;
const LIGHT: f64 = 0.5;
/// Φ⁻¹(3/4) and that of Student's t with two degrees of freedom, √(2/3): what both call a robust deviation.
const MIDDLES: (f64, f64) = (0.674_489_750_196_081_7, 0.816_496_580_927_726);

/// Samples that stand apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stray {
    /// How many.
    pub count: usize,
    /// Robust deviations beyond which they were looked for.
    pub beyond: f64,
    /// Chance of so many among innovations with heavy tails.
    pub p_value: f64,
}

/// What of innovations stands apart, by their robust deviation.
pub fn stray(innovations: &[f64], deviation: f64) -> Option<Stray> {
    let sizes: Vec<(f64, bool)> = innovations.iter().map(|e| (e.abs() / deviation, true)).collect();
    apart(&sizes, 0)
}

/// What of some sizes, in robust deviations, stands apart, beside samples already known to lie farther off than all;
/// those marked false are no strays whatever their size.
pub fn apart(sizes: &[(f64, bool)], known: usize) -> Option<Stray> {
    let tail = StudentsT::new(0.0, 1.0, 2.0).ok()?;
    let tried = BEYOND.iter().map(|x| (*x, 2.0)).chain(NEARER.iter().map(|x| (*x, 1.5)));
    let judged = tried.filter_map(|(beyond, ratio)| {
        let near = known + sizes.iter().filter(|s| s.0 > beyond).count();
        let far = known + sizes.iter().filter(|s| s.0 > ratio * beyond && s.1).count();
        // the same point of t₂
        let at = beyond * MIDDLES.1 / MIDDLES.0;
        let share = tail.sf(ratio * at) / tail.sf(at);
        let by_luck = Binomial::new(share, near as u64).ok()?;
        // P(at least so many)
        let p_value = if far == known { 1.0 } else { by_luck.sf(far as u64 - 1) };
        let tries = (BEYOND.len() + NEARER.len()) as f64;
        Some(Stray { count: far - known, beyond, p_value: (tries * p_value).min(1.0) })
    });
    judged.min_by(|a, b| a.p_value.total_cmp(&b.p_value))
}

/// One or two samples beyond all that a noise of exponential tails reaches, where the others have no heavier tails: by Laplace's
/// law, whose median of |e| is b ln 2, P(|e| > x) = exp(−x ln 2/Φ⁻¹(3/4)) for x robust deviations.
pub fn lone(sizes: &[(f64, bool)]) -> Option<Stray> {
    let beyond = |x: f64| (-x * std::f64::consts::LN_2 / MIDDLES.0).exp();
    let far = sizes.iter().filter(|s| s.0 > LONE && s.1).count();
    let between = sizes.iter().filter(|s| s.0 > BEYOND[0]).count() - far;
    let by_luck = Binomial::new(beyond(BEYOND[0]), sizes.len() as u64).ok()?;
    // P(at least so many between)
    let is_light = between == 0 || by_luck.sf(between as u64 - 1) > LIGHT;
    let p_value = (sizes.len() as f64 * beyond(LONE)).min(1.0);
    ((1..=FEW).contains(&far) && is_light).then_some(Stray { count: far, beyond: LONE, p_value })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::choose::SURE;
    use crate::estimate::noise::robust_deviation;
    use rand::SeedableRng;
    use rand_distr::{Distribution, Exp1, StandardNormal, StudentT};

    fn draws(n: usize, seed: u64, law: impl Fn(&mut rand_chacha::ChaCha8Rng) -> f64) -> Vec<f64> {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        (0..n).map(|_| law(&mut rng)).collect()
    }

    fn is_seen(e: &[f64]) -> bool {
        stray(e, robust_deviation(e)).is_some_and(|s| s.p_value < SURE)
    }

    #[test]
    fn noise_with_heavy_tails_has_none() {
        let mut seen = [0; 3];
        for seed in 0..200 {
            let heavy = StudentT::new(3.0).unwrap();
            seen[0] += usize::from(is_seen(&draws(2000, seed, |r| StandardNormal.sample(r))));
            seen[1] += usize::from(is_seen(&draws(2000, seed, |r| {
                let (a, b): (f64, f64) = (Exp1.sample(r), Exp1.sample(r));
                a - b
            })));
            seen[2] += usize::from(is_seen(&draws(2000, seed, |r| heavy.sample(r))));
        }
        assert!(seen.iter().all(|n| *n <= 1), "{seen:?} of 200 each");
    }

    /// Of 200 noises each: of Student's t with 3 and 5 degrees of freedom, and of Laplace.
    #[test]
    fn a_sample_stands_apart_alone_where_the_rest_has_no_heavy_tails() {
        let of = |e: &[f64]| {
            let size = robust_deviation(e);
            lone(&e.iter().map(|e| (e.abs() / size, true)).collect::<Vec<_>>()).filter(|s| s.p_value < SURE)
        };
        let mut seen = [0; 3];
        for seed in 0..200 {
            for (seen, degrees) in seen.iter_mut().zip([3.0, 5.0]) {
                let heavy = StudentT::new(degrees).unwrap();
                *seen += usize::from(of(&draws(2000, seed, |r| heavy.sample(r))).is_some());
            }
            let laplace = draws(2000, seed, |r| {
                let (a, b): (f64, f64) = (Exp1.sample(r), Exp1.sample(r));
                a - b
            });
            seen[2] += usize::from(of(&laplace).is_some());
        }
        assert!(seen[0] <= 2 && seen[1] <= 4 && seen[2] == 0, "{seen:?} of 200 each");
        let mut e = draws(2000, 5, |r| StandardNormal.sample(r));
        assert_eq!(of(&e), None);
        e[700] += 40.0;
        assert_eq!(of(&e).unwrap().count, 1);
    }

    #[test]
    fn wild_samples_are_counted() {
        for (count, size) in [(60, 150.0), (30, 50.0), (10, 20.0), (7, 200.0)] {
            let mut e = draws(2000, 5, |r| StandardNormal.sample(r));
            (0..count).for_each(|k| e[2000 / count * k + 3] += if k % 2 == 0 { size } else { -size });
            let s = stray(&e, robust_deviation(&e)).unwrap();
            assert!(s.p_value < SURE && s.count == count, "{count} of {size}: {s:?}");
        }
    }
}
