//! Correlations of residuals: against sums written out, and how often their bands hold.

use gyrospec::estimate::{Pair, autocorrelation, cross_correlation};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

fn white(rng: &mut ChaCha8Rng, n: usize) -> Vec<f64> {
    (0..n).map(|_| StandardNormal.sample(rng)).collect()
}

/// Noise of one memory, begun long before.
fn slow(rng: &mut ChaCha8Rng, n: usize, pole: f64) -> Vec<f64> {
    let mut x = 0.0;
    let all = white(rng, n + 2000).into_iter().map(|e| {
        x = pole * x + e;
        x
    });
    all.skip(2000).collect()
}

#[test]
fn correlations_are_the_sums_that_define_them() {
    let rng = &mut ChaCha8Rng::seed_from_u64(5);
    let lengths = [130, 77, 3];
    let e: Vec<Vec<f64>> = lengths.iter().map(|n| slow(rng, *n, 0.7)).collect();
    let u: Vec<Vec<f64>> = lengths.iter().map(|n| white(rng, *n).iter().map(|x| x + 5.0).collect()).collect();
    let count = lengths.iter().sum::<usize>() as f64;
    let mean = u.iter().flatten().sum::<f64>() / count;
    let sum = |a: &[Vec<f64>], b: &[Vec<f64>], m: f64, lag: isize| -> f64 {
        let one = |(a, b): (&Vec<f64>, &Vec<f64>)| -> f64 {
            let at = |t: usize| t.checked_add_signed(-lag).and_then(|s| b.get(s)).map_or(0.0, |x| x - m);
            (0..a.len()).map(|t| a[t] * at(t)).sum()
        };
        a.iter().zip(b).map(one).sum()
    };
    let views: Vec<&[f64]> = e.iter().map(Vec::as_slice).collect();
    let own = autocorrelation(&views, 20).unwrap();
    let mut square = 1.0;
    for (k, (r, b)) in (1..).zip(own.values.iter().zip(&own.band)) {
        let wanted = sum(&e, &e, 0.0, k) / sum(&e, &e, 0.0, 0);
        assert!((r - wanted).abs() < 1e-12, "{k}: {r} {wanted}");
        assert!((b - 2.5758 * f64::sqrt(square / count)).abs() < 1e-12);
        square += 2.0 * wanted * wanted;
    }
    let pairs: Vec<Pair> = e.iter().zip(&u).map(|(residual, other)| Pair { residual, other }).collect();
    let cross = cross_correlation(&pairs, 20).unwrap();
    let centred: Vec<Vec<f64>> = u.iter().map(|u| u.iter().map(|x| x - mean).collect()).collect();
    let size = (sum(&e, &e, 0.0, 0) * sum(&centred, &centred, 0.0, 0)).sqrt();
    for (i, r) in cross.values.iter().enumerate() {
        let wanted = sum(&e, &u, mean, i as isize - 20) / size;
        assert!((r - wanted).abs() < 1e-12, "{i}: {r} {wanted}");
    }
    assert!(autocorrelation(&[&[0.0; 90]], 9).is_none());
    assert!(cross_correlation(&[Pair { residual: &[1.0; 90], other: &[3.0; 90] }], 9).is_none());
}

type Maker = fn(&mut ChaCha8Rng, usize) -> Vec<f64>;

/// What knows nothing of the input stays in its band, whatever its colour; a white band would not hold it.
#[test]
fn bands_hold_for_coloured_residuals() {
    let rng = &mut ChaCha8Rng::seed_from_u64(11);
    let (n, lags, runs) = (800, 60, 60);
    let residuals: [(&str, Maker); 3] =
        [("white", white), ("slow", |r, n| slow(r, n, 0.95)), ("slower", |r, n| slow(r, n, 0.99))];
    let inputs: [(&str, Maker); 4] = [
        ("white", white),
        ("slow", |r, n| slow(r, n, 0.98)),
        ("steps", |r, n| white(r, n / 40 + 1).iter().flat_map(|x| [x.signum(); 40]).take(n).collect()),
        ("sine", |_, n| (0..n).map(|i| (0.11 * i as f64).sin()).collect()),
    ];
    let mut naive = 0.0_f64;
    for (residual, make) in residuals {
        for (input, drive) in inputs {
            let (mut outside, mut beyond_white, mut all) = (0, 0, 0);
            for _ in 0..runs {
                let (e, u) = (make(rng, n), drive(rng, n));
                let c = cross_correlation(&[Pair { residual: &e, other: &u }], lags).unwrap();
                outside += c.values.iter().zip(&c.band).filter(|(v, b)| v.abs() > **b).count();
                beyond_white += c.values.iter().filter(|v| v.abs() > 2.5758 / (n as f64).sqrt()).count();
                all += c.values.len();
            }
            let share = outside as f64 / all as f64;
            // neighbouring lags are alike, so that the share of 60 runs scatters
            assert!(share < 0.03, "{residual} residual, {input} input: {share}");
            naive = naive.max(beyond_white as f64 / all as f64);
        }
    }
    assert!(naive > 0.3, "{naive}");
    // noise whose memory ends after two samples leaves the band at those alone
    let (mut beyond, mut inside) = (0, 0);
    for _ in 0..200 {
        let e = white(rng, n + 2);
        let e: Vec<f64> = e.windows(3).map(|w| w[0] + w[1] + w[2]).collect();
        let c = autocorrelation(&[&e], 40).unwrap();
        inside += usize::from(c.values[1].abs() < c.band[1]);
        beyond += c.values.iter().zip(&c.band).skip(2).filter(|(v, b)| v.abs() > **b).count();
    }
    // 1 % of 200·38 lags is 76
    assert!(inside == 0 && (30..=130).contains(&beyond), "{inside} {beyond}");
}

/// An input that acts three samples late through something unmodelled stands at lag 3, in slow noise.
#[test]
fn what_an_input_does_is_seen_at_its_lag() {
    let rng = &mut ChaCha8Rng::seed_from_u64(2);
    let n = 3000;
    let (noise, u) = (slow(rng, n, 0.95), white(rng, n));
    let e: Vec<f64> = (0..n).map(|t| noise[t] + if t >= 3 { 0.8 * u[t - 3] } else { 0.0 }).collect();
    let c = cross_correlation(&[Pair { residual: &e, other: &u }], 25).unwrap();
    let largest = (0..51).max_by(|a, b| c.values[*a].abs().total_cmp(&c.values[*b].abs())).unwrap();
    assert!(largest == 28 && c.reach() > 2.0 && c.first == -25, "{largest} {}", c.reach());
}
