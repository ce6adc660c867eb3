//! What a gimbal reads of a base that moves at random: the integral, a quadrature, and two simulations.

use approx::assert_relative_eq;
use gyrospec::gyro::gimbal::{Demodulator, Gimbal, Noise, Run, State};
use gyrospec::lti::Discrete;
use num_complex::Complex64;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

const J: Complex64 = Complex64::I;

/// The coefficients of (1), written out from the bodies: inertia, stiffness, gyroscopic, drive.
fn coefficients(g: &Gimbal) -> ([f64; 2], [f64; 2], f64, [f64; 2]) {
    let [one, two, three] = g.bodies;
    let (x, y, z) = (one.x + two.x + three.x, one.y + two.y + three.y, one.z + two.z + three.z);
    let (h, w) = (g.momentum, g.speed);
    let first = g.springs[0] + h * w + (z - y - two.z + two.y) * w * w;
    let second = g.springs[1] + h * w + (z - x) * w * w;
    let turning = h + (z - y - x - two.z + two.y + two.x) * w;
    let drive = [h + (z - y + x - two.z + two.y - two.x) * w, h + (z + y - x) * w];
    ([x - two.x, y], [first, second], turning, drive)
}

/// a(ν): α = Re(a(ν) r̂ e^{j(Ω + ν)t}) for base rates Θ′ + jΨ′ = r̂ e^{jνt}, by Cramer's rule on (1).
fn scale(g: &Gimbal, nu: f64) -> Complex64 {
    let (inertia, stiffness, turning, drive) = coefficients(g);
    let s = J * (g.speed + nu);
    let [m11, m22] = [0, 1].map(|k| s * s * inertia[k] + s * g.damping[k] + stiffness[k]);
    let m12 = s * turning;
    // −A(Θ″ sin Ωt + Ψ″ cos Ωt) − E₁(Θ′ cos Ωt − Ψ′ sin Ωt) = Re((jA ṙ − E₁ r) e^{jΩt}), and β alike
    let up = J * inertia[0] * J * nu - drive[0];
    let side = -(inertia[1] * J * nu) - J * drive[1];
    (m22 * up - m12 * side) / (m11 * m22 + m12 * m12)
}

/// Both rates of the base and their derivatives every `step`: r″ + 2ζω₀r′ + ω₀²r = white noise.
fn random_base([sigma, w0, zeta]: [f64; 3], step: f64, count: usize) -> Vec<[f64; 4]> {
    let rate = faer::mat![[0.0, 1.0], [-w0 * w0, -2.0 * zeta * w0]];
    let kick = faer::mat![[0.0], [sigma * (4.0 * zeta * w0.powi(3)).sqrt()]];
    let mut both =
        [1u64, 2].map(|seed| (Discrete::new(&rate, &kick, step), ChaCha8Rng::seed_from_u64(seed), [0.0; 2]));
    let mut out = Vec::with_capacity(count);
    for _ in 0..count {
        for (discrete, rng, z) in &mut both {
            discrete.advance(z, rng);
        }
        out.push([both[0].2[0], both[1].2[0], both[0].2[1], both[1].2[1]]);
    }
    out
}

/// Half the mean square of |reading|, behind the first tenth.
fn deviation(read: &[(f64, f64)]) -> f64 {
    let kept = &read[read.len() / 10..];
    (kept.iter().map(|r| 0.5 * (r.0 * r.0 + r.1 * r.1)).sum::<f64>() / kept.len() as f64).sqrt()
}

/// (1) by the explicit midpoint rule, demodulated and low-passed twice by steps held constant.
fn apart(g: &Gimbal, base: &[[f64; 4]], half: f64, corner: f64) -> Vec<(f64, f64)> {
    let (inertia, stiffness, turning, drive) = coefficients(g);
    let rates = |y: [f64; 4], t: f64, [theta, psi, theta2, psi2]: [f64; 4]| {
        let (sin, cos) = (g.speed * t).sin_cos();
        let torque = [
            -inertia[0] * (theta2 * sin + psi2 * cos) - drive[0] * (theta * cos - psi * sin),
            -inertia[1] * (theta2 * cos - psi2 * sin) + drive[1] * (theta * sin + psi * cos),
        ];
        let alpha = (torque[0] - g.damping[0] * y[2] - stiffness[0] * y[0] - turning * y[3]) / inertia[0];
        let beta = (torque[1] - g.damping[1] * y[3] - stiffness[1] * y[1] + turning * y[2]) / inertia[1];
        [y[2], y[3], alpha, beta]
    };
    let still = scale(g, 0.0);
    let share = 1.0 - (-2.0 * half * corner).exp();
    let (mut y, mut first, mut second) = ([0.0; 4], Complex64::ZERO, Complex64::ZERO);
    let mut out = Vec::new();
    for k in 0..(base.len() - 2) / 2 {
        let t = 2.0 * k as f64 * half;
        let slope = rates(y, t, base[2 * k]);
        let middle = rates([0, 1, 2, 3].map(|i| y[i] + half * slope[i]), t + half, base[2 * k + 1]);
        y = [0, 1, 2, 3].map(|i| y[i] + 2.0 * half * middle[i]);
        let turned = 2.0 * y[0] * Complex64::from_polar(1.0, -g.speed * (t + 2.0 * half)) / still;
        first += share * (turned - first);
        second += share * (first - second);
        out.push((second.re, second.im));
    }
    out
}

#[test]
fn the_reading_of_a_shaken_base_is_the_integral_the_quadrature_and_both_simulations() {
    let gimbal = Gimbal::example();
    let (base, corner) = ([1e-3, 120.0, 0.05], 2.0);
    let said = gimbal.noise_equivalent(&Noise { torque: [0.0; 2], base: Some(base) }, corner).unwrap();

    // (1/2π) ∫ (|F(jν)|² + |F(j(ν + 2Ω))|²) |a(ν)/a(0)|² S(ν) dν by the rule of the midpoint
    let [sigma, w0, zeta] = base;
    let low = |w: f64| 1.0 / (1.0 + (w / corner).powi(2)).powi(2);
    let density = |nu: f64| {
        let shape = (w0 * w0 - nu * nu).powi(2) + (2.0 * zeta * w0 * nu).powi(2);
        sigma.powi(2) * 4.0 * zeta * w0.powi(3) / shape
            * (scale(&gimbal, nu) / scale(&gimbal, 0.0)).norm_sqr()
    };
    let step = 0.01;
    let (mut passed, mut folded) = (0.0, 0.0);
    for k in -300_000..300_000 {
        let nu = (f64::from(k) + 0.5) * step;
        let d = density(nu) * step / std::f64::consts::TAU;
        passed += d * low(nu);
        folded += d * low(2.0 * gimbal.speed + nu);
    }
    assert_relative_eq!(said.base_passed, passed.sqrt(), max_relative = 1e-4);
    assert_relative_eq!(said.base_folded, folded.sqrt(), max_relative = 1e-4);
    assert_relative_eq!(
        said.base.powi(2),
        said.base_passed.powi(2) + said.base_folded.powi(2),
        max_relative = 1e-12
    );

    let half = 1e-4;
    let duration = 300.0;
    let motion = random_base(base, half, (duration / half) as usize + 4);
    let run = Run { step: 2.0 * half, duration, noise: [0.0; 2], seed: 0 };
    let samples = gimbal
        .simulate(State::default(), &run, |t| {
            let [theta, psi, theta2, psi2] = motion[(t / half).round() as usize];
            ([theta, psi], [theta2, psi2])
        })
        .unwrap();
    let read = deviation(&Demodulator::new(&gimbal, corner).unwrap().rates(&samples));
    let alone = deviation(&apart(&gimbal, &motion, half, corner));
    println!(
        "base motion: integral {:.4e} (folded {:.3e}), simulated {read:.4e}, apart {alone:.4e}",
        said.base, said.base_folded
    );
    // some 300 s × 2 rad/s on two axes: one deviation is 2 to 3 %
    assert_relative_eq!(read, said.base, max_relative = 0.08);
    assert_relative_eq!(alone, said.base, max_relative = 0.08);
    assert_relative_eq!(alone, read, max_relative = 0.02);
}

#[test]
fn a_quiet_base_and_a_slow_one_are_told_apart() {
    let gimbal = Gimbal::example();
    let quiet = gimbal.noise_equivalent(&Noise { torque: [1e-18; 2], base: None }, 2.0).unwrap();
    assert_eq!((quiet.base, quiet.base_passed, quiet.base_folded), (0.0, 0.0, 0.0));
    // rates far below the corner are read as they are
    let slow = Noise { torque: [0.0; 2], base: Some([1e-3, 0.01, 0.7]) };
    let said = gimbal.noise_equivalent(&slow, 2.0).unwrap();
    assert_relative_eq!(said.base_passed, 1e-3, max_relative = 5e-3);
    assert!(said.base_folded < 1e-3 * said.base_passed);
}
