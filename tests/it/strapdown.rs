//! What vibration leaves in the mean, beside simulations, quadratures and sines that share no code with it.

use approx::assert_relative_eq;
use gyrospec::gyro::strapdown::{
    Anisoelasticity, Anisoinertia, NorthSeeking, Seaway, Shaken, TunedRotor, Vibration, aligned,
    by_gyrocompassing, coning, sculling, square_term,
};
use gyrospec::lti::Discrete;
use gyrospec::spectrum::Roll;
use num_complex::Complex64;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

type V = [f64; 3];

fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// A quaternion: scalar, vector.
type Q = (f64, V);

fn times(p: Q, q: Q) -> Q {
    let turned = cross(p.1, q.1);
    let dot: f64 = (0..3).map(|i| p.1[i] * q.1[i]).sum();
    (p.0 * q.0 - dot, [0, 1, 2].map(|i| p.0 * q.1[i] + q.0 * p.1[i] + turned[i]))
}

fn of_rotation(phi: V) -> Q {
    let half = 0.5 * phi.iter().map(|x| x * x).sum::<f64>().sqrt();
    let by = if half < 1e-12 { 0.5 } else { half.sin() / (2.0 * half) };
    (half.cos(), phi.map(|x| by * x))
}

fn rotation_of(q: Q) -> V {
    let sin = q.1.iter().map(|x| x * x).sum::<f64>().sqrt();
    let by = if sin < 1e-12 { 2.0 } else { 2.0 * sin.atan2(q.0) / sin };
    q.1.map(|x| by * x)
}

/// The mean of what gyros read of an attitude given at equal steps: the sum of the body's small turns over the time.
fn read_rates(attitude: impl Iterator<Item = V>, step: f64) -> V {
    let (mut sum, mut count, mut before) = ([0.0; 3], 0.0, None);
    for phi in attitude {
        let q = of_rotation(phi);
        if let Some((scalar, vector)) = before.replace(q) {
            let turn = rotation_of(times((scalar, (vector as V).map(|x| -x)), q));
            (0..3).for_each(|i| sum[i] += turn[i]);
            count += 1.0;
        }
    }
    sum.map(|s| s / (count * step))
}

/// A vibration of an axis, which has one or none.
#[allow(clippy::unnecessary_wraps)]
fn vibration(deviation: f64, phase: f64, frequency: f64, damping: f64) -> Option<Vibration> {
    Some(Vibration { deviation, phase, frequency, damping })
}

/// The shaping written out: σ√(4ζω³)/(ω₀² − ω² + 2jζω₀ω) turned by an all-pass whose phase at ω₀ is ψ.
fn response(v: Option<Vibration>, w: f64) -> Complex64 {
    let Some(v) = v else { return Complex64::ZERO };
    let (w0, z) = (v.frequency, v.damping);
    let gain = v.deviation * (4.0 * z * w0.powi(3)).sqrt();
    let resonance = gain / Complex64::new(w0 * w0 - w * w, 2.0 * z * w0 * w);
    // −2 atan(w/c) for a lag; π − 2 atan(w/c) for a lead
    let turn = if v.phase < 0.0 {
        -2.0 * (w / w0 * (-0.5 * v.phase).tan()).atan()
    } else if v.phase > 0.0 {
        PI - 2.0 * (w / w0 / (0.5 * v.phase).tan()).atan()
    } else {
        0.0
    };
    resonance * Complex64::from_polar(1.0, turn)
}

/// (1/2π)∫ f dω of an even f by the rule of the midpoint over tan-spaced points.
fn over_all(f: impl Fn(f64) -> f64, around: f64) -> f64 {
    let count = 400_000;
    let each = (0..count).map(|k| {
        let x = (f64::from(k) + 0.5) / f64::from(count) * FRAC_PI_2;
        let w = around * x.tan();
        f(w) * around / x.cos().powi(2)
    });
    each.sum::<f64>() * FRAC_PI_2 / f64::from(count) / PI
}

#[test]
fn a_pure_cone_turns_at_half_the_product_of_its_amplitudes() {
    let (a, b, w) = (0.01, 0.006, 200.0);
    let narrow = |s: f64, phase| vibration(s / 2f64.sqrt(), phase, w, 1e-7);
    let shaken = Shaken {
        angular: [narrow(a, 0.3), narrow(b, 0.3 - FRAC_PI_2), None],
        linear: [None; 3],
        coherence: 1.0,
    };
    let rate = coning(&shaken).unwrap();
    assert_relative_eq!(rate[2], 0.5 * a * b * w, max_relative = 1e-6);
    // quaternions over a hundred whole turns
    let per_turn = 1000;
    let step = TAU / w / f64::from(per_turn);
    let cone = (0..=100 * per_turn).map(|k| {
        let x = f64::from(k) * TAU / f64::from(per_turn);
        [a * x.cos(), b * x.sin(), 0.0]
    });
    let read = read_rates(cone, step);
    println!("pure cone: spectrum {:.6e}, closed {:.6e}, read {:.6e}", rate[2], 0.5 * a * b * w, read[2]);
    assert_relative_eq!(read[2], -rate[2], max_relative = 5e-5);
    assert!(read[0].abs() < 1e-9 && read[1].abs() < 1e-9);
}

#[test]
fn a_random_cone_is_read_as_its_spectrum_says() {
    // φ_x″ + 2ζω φ_x′ + ω²φ_x = white; φ_y = (ω − s)/(ω + s) φ_x = 2 x₃ − φ_x with x₃′ = ω(φ_x − x₃)
    let (sigma, w, zeta, step) = (5e-3, 100.0, 0.3, 5e-4);
    let shaken = Shaken {
        angular: [vibration(sigma, 0.0, w, zeta), vibration(sigma, -FRAC_PI_2, w, zeta), None],
        linear: [None; 3],
        coherence: 1.0,
    };
    let said = coning(&shaken).unwrap()[2];
    let a = faer::mat![[0.0, 1.0, 0.0], [-w * w, -2.0 * zeta * w, 0.0], [w, 0.0, -w]];
    let kick = faer::mat![[0.0], [sigma * (4.0 * zeta * w * w * w).sqrt()], [0.0]];
    let (mut discrete, mut rng) = (Discrete::new(&a, &kick, step), ChaCha8Rng::seed_from_u64(5));
    let mut z = [0.0; 3];
    let attitude = (0..4_000_000).map(|_| {
        discrete.advance(&mut z, &mut rng);
        [z[0], 2.0 * z[2] - z[0], 0.0]
    });
    let read = read_rates(attitude, step)[2];
    let by_quadrature = over_all(
        |w| {
            let cross = response(shaken.angular[0], w) * response(shaken.angular[1], w).conj();
            (cross * Complex64::new(0.0, -w)).re
        },
        w,
    );
    println!("random cone: spectrum {said:.5e}, quadrature {by_quadrature:.5e}, read {read:.5e}");
    assert_relative_eq!(said, by_quadrature, max_relative = 1e-7);
    // 2000 s of some 60 swings a second that forget in 1/30 s: one deviation is about 1 %
    assert_relative_eq!(read, -said, max_relative = 0.03);
}

#[test]
fn mounts_of_unlike_resonance_cone_and_scull_by_their_cross_spectrum() {
    let shaken = Shaken {
        angular: [
            vibration(1e-3, 0.4, 180.0, 0.04),
            vibration(2e-3, -0.9, 260.0, 0.1),
            vibration(5e-4, 2.5, 90.0, 0.2),
        ],
        linear: [
            vibration(3.0, 0.2, 200.0, 0.05),
            vibration(1.0, 0.0, 260.0, 0.1),
            vibration(2.0, -2.0, 120.0, 0.07),
        ],
        coherence: 0.6,
    };
    let mean = |p: Option<Vibration>, q: Option<Vibration>, rate: bool| {
        let by = |w: f64| if rate { Complex64::new(0.0, -w) } else { Complex64::ONE };
        0.6 * over_all(|w| (response(p, w) * response(q, w).conj() * by(w)).re, 200.0)
    };
    let (cone, scull) = (coning(&shaken).unwrap(), sculling(&shaken).unwrap());
    let (phi, a) = (shaken.angular, shaken.linear);
    for (i, (j, k)) in [(1, 2), (2, 0), (0, 1)].into_iter().enumerate() {
        let turned = 0.5 * (mean(phi[j], phi[k], true) - mean(phi[k], phi[j], true));
        assert_relative_eq!(cone[i], turned, max_relative = 1e-6);
        assert_relative_eq!(
            scull[i],
            mean(phi[j], a[k], false) - mean(phi[k], a[j], false),
            max_relative = 1e-6
        );
    }
    assert_relative_eq!(shaken.mean_squares().unwrap()[2], 4.0, max_relative = 1e-12);
    // what has one axis or no coherence does neither
    let alone = Shaken { coherence: 0.0, ..shaken };
    assert_eq!((coning(&alone).unwrap(), sculling(&alone).unwrap()), ([0.0; 3], [0.0; 3]));
    assert_eq!(square_term(0.5, &alone).unwrap()[1], 0.5 * alone.mean_squares().unwrap()[1]);
}

#[test]
fn an_angle_and_an_acceleration_in_phase_scull() {
    let (angle, amplitude, w, lag) = (2e-3, 5.0, 150.0, 0.7);
    let narrow = |x: f64, phase| vibration(x / 2f64.sqrt(), phase, w, 1e-7);
    let shaken = Shaken {
        angular: [narrow(angle, 0.0), None, None],
        linear: [None, narrow(amplitude, -lag), None],
        coherence: 1.0,
    };
    let said = sculling(&shaken).unwrap();
    assert_relative_eq!(said[2], 0.5 * angle * amplitude * lag.cos(), max_relative = 1e-6);
    // v̇ = C a, with C turned by the whole rotation, over whole turns
    let count = 100_000;
    let mut v = [0.0; 3];
    for k in 0..count {
        let x = 50.0 * TAU * (f64::from(k) + 0.5) / f64::from(count);
        let q = of_rotation([angle * x.sin(), 0.0, 0.0]);
        let a = (0.0, [0.0, amplitude * (x - lag).sin(), 0.0]);
        let turned = times(times(q, a), (q.0, q.1.map(|y| -y))).1;
        (0..3).for_each(|i| v[i] += turned[i] / f64::from(count));
    }
    println!("sculling: spectrum {:.6e}, simulated {:.6e}", said[2], v[2]);
    assert_relative_eq!(v[2], said[2], max_relative = 5e-6);
    assert!(v[1].abs() < 1e-9 && said[1] == 0.0);
}

#[test]
fn a_float_of_unlike_inertia_reads_the_product_of_two_rates() {
    let float = Anisoinertia { axes: [0, 2], difference: 3e-7, momentum: 2e-3 };
    let (p, q, w, phase) = (0.4, 0.25, 90.0, 0.5);
    let narrow = |rate: f64, phase| vibration(rate / w / 2f64.sqrt(), phase, w, 1e-7);
    let shaken =
        Shaken { angular: [narrow(p, 0.0), None, narrow(q, phase)], linear: [None; 3], coherence: 1.0 };
    let said = float.drift(&shaken).unwrap();
    assert_relative_eq!(said[0], 0.5 * 3e-7 * p * q * phase.cos() / 2e-3, max_relative = 1e-6);
    // the moment about y that holds a float of momentum Iω + H e_z: M = ḣ + ω × h
    let inertia = [4e-7, 5e-7, 7e-7];
    let momentum = |rate: V| [inertia[0] * rate[0], inertia[1] * rate[1], inertia[2] * rate[2] + 2e-3];
    let count = 10_000;
    let mut moment = 0.0;
    for k in 0..count {
        let x = TAU * 10.0 * f64::from(k) / f64::from(count);
        let rate = [p * x.cos(), 0.0, q * (x + phase).cos()];
        let gyroscopic = cross(rate, momentum(rate));
        moment += gyroscopic[1] / f64::from(count);
    }
    println!("anisoinertia: {:.6e}, Euler's equations {:.6e}", said[0], -moment / 2e-3);
    assert_relative_eq!(-moment / 2e-3, said[0], max_relative = 1e-6);
    assert!(Anisoinertia { axes: [1, 1], ..float }.drift(&shaken).is_err());
    assert!(Anisoinertia { momentum: 0.0, ..float }.drift(&shaken).is_err());
}

#[test]
fn a_float_that_gives_way_unlike_reads_the_product_of_two_accelerations() {
    let float = Anisoelasticity {
        axes: [0, 2],
        mass: 0.1,
        momentum: 2e-3,
        frequencies: [900.0, 1300.0],
        damping: 0.1,
    };
    let (p, q, phase) = (20.0, 30.0, 0.4);
    for w in [50.0, 800.0] {
        let narrow = |a: f64, phase| vibration(a / 2f64.sqrt(), phase, w, 1e-7);
        let shaken =
            Shaken { linear: [narrow(p, 0.0), None, narrow(q, phase)], angular: [None; 3], coherence: 1.0 };
        let said = float.drift(&shaken).unwrap()[0];
        // both springs in time by Störmer's rule, and the moment of the force of inertia: r × F
        let (step, settle) = (1e-5, 40_000);
        let count = (100.0 * TAU / w / step).round() as usize;
        let (mut d, mut v, mut moment) = ([0.0f64; 3], [0.0f64; 3], 0.0);
        for k in 0..settle + count {
            let x = w * step * k as f64;
            let a = [p * x.cos(), 0.0, q * (x + phase).cos()];
            for (i, own) in [(0, 900.0), (2, 1300.0)] {
                v[i] += step * (a[i] - 2.0 * 0.1 * own * v[i] - own * own * d[i]);
                d[i] += step * v[i];
            }
            if k >= settle {
                let next = [p * (x + w * step).cos(), 0.0, q * (x + w * step + phase).cos()];
                moment += cross(d.map(|x| -x), next.map(|x| -0.1 * x))[1] / count as f64;
            }
        }
        println!("anisoelasticity at {w} rad/s: {said:.5e}, springs in time {:.5e}", moment / 2e-3);
        assert_relative_eq!(moment / 2e-3, said, max_relative = 1e-2);
        if w < 100.0 {
            let stiff = 0.1 / 2e-3 * (1.0 / 1300f64.powi(2) - 1.0 / 900f64.powi(2));
            assert_relative_eq!(said, stiff * 0.5 * p * q * phase.cos(), max_relative = 2e-2);
        }
    }
}

#[test]
fn a_square_term_reads_half_the_square_of_a_sines_amplitude() {
    let shaken = Shaken {
        linear: [None, vibration(4.0 / 2f64.sqrt(), 0.0, 300.0, 0.02), None],
        angular: [None; 3],
        coherence: 1.0,
    };
    let mean = (0..1000).map(|k| (4.0 * (TAU * f64::from(k) / 1000.0).sin()).powi(2)).sum::<f64>() / 1000.0;
    let said = square_term(2e-6, &shaken).unwrap();
    assert_relative_eq!(said[1], 2e-6 * mean, max_relative = 1e-12);
    assert_eq!([said[0], said[2]], [0.0, 0.0]);
}

#[test]
fn a_random_vibration_at_twice_the_speed_walks() {
    let rotor = TunedRotor { speed: 600.0, spin_inertia: 1e-4, gimbal_inertia: 1e-6 };
    assert_relative_eq!(rotor.figure_of_merit(), 100.0, max_relative = 1e-12);
    let shaking = Vibration { deviation: 1e-4, phase: 0.0, frequency: 1100.0, damping: 0.2 };
    // the rate folded down by κ·2cos(2Nt): its mean square over whole turns of a slow window, by the density at 2N
    let density = (response(Some(shaking), 1200.0) * 1200.0).norm_sqr();
    assert_relative_eq!(rotor.walk(&shaking).unwrap(), (0.5 * density).sqrt() / 400.0, max_relative = 1e-12);
}

#[test]
fn north_is_found_where_the_rate_and_the_vertical_put_it() {
    let (rate, gravity) = (7.292e-5, 9.81);
    for (latitude, heading) in [(0.9f64, 0.4f64), (-0.5, 2.0), (1.2, -2.8), (0.2, 0.0)] {
        let (drift, bias) = ([2e-10, -3e-10, 1e-10], [2e-5, -3e-5, 4e-5]);
        // north, east, down into the body's axes of a level body
        let (s, c) = heading.sin_cos();
        let body = |v: V| [c * v[0] + s * v[1], -s * v[0] + c * v[1], v[2]];
        let add = |a: V, b: V| [0, 1, 2].map(|i| a[i] + b[i]);
        let omega = add(body([rate * latitude.cos(), 0.0, -rate * latitude.sin()]), drift);
        let force = add(body([0.0, 0.0, -gravity]), bias);
        // down by the force, east = down × rate, north = east × down
        let down = force.map(|x| -x);
        let east = cross(down, omega);
        let north = cross(east, down);
        // true north and east in the body's axes
        let (n, e) = ([c, -s, 0.0], [s, c, 0.0]);
        let dot = |a: V, b: V| (0..3).map(|i| a[i] * b[i]).sum::<f64>();
        let west = -dot(north, e).atan2(dot(north, n));
        let said = by_gyrocompassing(drift, bias, [heading, latitude], [rate, gravity]);
        println!("north: {:.6e}, by the vectors {west:.6e}", said.error);
        assert_relative_eq!(said.error, west, max_relative = 1e-4);
    }
}

#[test]
fn a_loop_that_seeks_north_spreads_as_its_integrals_say() {
    let (w, zeta, north, walk) = (0.05, 0.6, 4e-5, 1e-6);
    let seeking = NorthSeeking { frequency: w, damping: zeta, north_rate: north };
    let roll = Roll::new(0.004, 0.08, 0.7).unwrap();
    let sea = Seaway { roll, lever: 2.0, heading: 0.6, gravity: 9.81 };
    let (k1, k2, step) = (2.0 * zeta * w, w * w / north, 0.02);
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let a = faer::mat![[0.0, 1.0], [-roll.b2(), -2.0 * roll.decay]];
    let kick = faer::mat![[0.0], [2.0 * (roll.variance * roll.decay * roll.b2()).sqrt()]];
    let mut discrete = Discrete::new(&a, &kick, step);
    let mut theta = [0.0; 2];
    // (α, β) by noise; (α − k₂u, β + k₁u) by the sea, u = h θ̇ sin K/g
    let (mut by_noise, mut by_sea, mut sums, mut count) = ([0.0f64; 2], [0.0f64; 2], [0.0; 2], 0.0);
    for k in 0..8_000_000 {
        let mut draw = || -> f64 {
            let xi: f64 = StandardNormal.sample(&mut rng);
            walk * xi * f64::sqrt(step)
        };
        let (ee, ed) = (draw(), draw());
        let [alpha, beta] = by_noise;
        by_noise = [alpha + step * k2 * beta + ed, beta - step * (north * alpha + k1 * beta) + ee];
        discrete.advance(&mut theta, &mut rng);
        let u = 2.0 * theta[1] * 0.6f64.sin() / 9.81;
        let (alpha, beta) = (by_sea[0] + k2 * u, by_sea[1] - k1 * u);
        by_sea = [by_sea[0] + step * k2 * beta, by_sea[1] - step * (north * alpha + k1 * beta)];
        if k > 50_000 {
            sums[0] += by_noise[0].powi(2);
            sums[1] += (by_sea[0] + k2 * u).powi(2);
            count += 1.0;
        }
    }
    let [noise, swing] = sums.map(|s: f64| (s / count).sqrt());
    let said = (seeking.by_walk(walk).unwrap(), seeking.by_sea(&sea).unwrap());
    println!("loop: walk {:.4e} simulated {noise:.4e}; sea {:.4e} simulated {swing:.4e}", said.0, said.1);
    assert_relative_eq!(noise, said.0, max_relative = 0.03);
    assert_relative_eq!(swing, said.1, max_relative = 0.03);
    // averages of white rates over 100 s
    let mean = |rng: &mut ChaCha8Rng| -> f64 {
        (0..100).map(|_| -> f64 { StandardNormal.sample(rng) }).sum::<f64>() * walk / 100.0
    };
    let found: f64 = (0..20_000).map(|_| (mean(&mut rng) / north).powi(2)).sum::<f64>() / 20_000.0;
    assert_relative_eq!(found.sqrt(), aligned(walk, 100.0, north), max_relative = 0.03);
}

#[test]
fn a_vibration_without_frequency_or_damping_is_refused() {
    for (frequency, damping) in [(0.0, 0.1), (10.0, 0.0), (f64::NAN, 0.1), (10.0, -0.1)] {
        let v = Vibration { deviation: 1.0, phase: 0.0, frequency, damping };
        assert!(v.shaping().is_err());
    }
    // every phase turns as it says and lets amplitudes pass
    for phase in [-3.0, -FRAC_PI_2, -1e-3, 0.0, 1e-3, 1.0, 3.1, PI, 7.0] {
        let plain = Vibration { deviation: 2.0, phase: 0.0, frequency: 30.0, damping: 0.1 };
        let at = |v: &Vibration, w: f64| v.shaping().unwrap().at(Complex64::new(0.0, w));
        let turned = Vibration { phase, ..plain };
        let ratio = at(&turned, 30.0) / at(&plain, 30.0);
        assert!((ratio - Complex64::from_polar(1.0, phase)).norm() < 1e-12, "{phase}: {ratio}");
        assert_relative_eq!(at(&turned, 77.0).norm(), at(&plain, 77.0).norm(), max_relative = 1e-12);
    }
}
