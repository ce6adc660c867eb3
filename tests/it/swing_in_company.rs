//! The sphere's own swing beside other parts, against the equations of the Lagrangian of sphere, liquid and rotors solved
//! in another way: at one frequency by elimination, in time by Runge and Kutta with the friction as a steep curve.

use crate::parts::{FLOW, SLOSH, all, boxed, driven, soft, transfer};
use approx::assert_relative_eq;
use gyrospec::Complex64;
use gyrospec::gyro::Gyrosphere;
use gyrospec::gyro::elastic::{Elastic, Friction, Inertia, Pendulum, Relaxing, Slosh};
use std::f64::consts::{PI, TAU};

/// A sphere so pendulous, and a swing so fast, that the swing shakes the suspension: m l²/J = 0.31.
fn pendulous() -> Gyrosphere {
    Gyrosphere { pendulous: 85.0 * 0.9, ..soft() }
}

const SWINGS: [Pendulum; 3] = [
    Pendulum { period: 3.5, damping: 0.1, coupling: 0.0, lag: 0.0 },
    Pendulum { period: 3.5, damping: 0.1, coupling: 0.4, lag: 0.7 },
    Pendulum { period: 4.5, damping: 0.2, coupling: 0.6, lag: 0.0 },
];

/// J, d, Γ, k and c of a swing, with k = 1 N·m/rad: only Γ²/k and c/k matter.
fn constants(s: &Gyrosphere, p: &Pendulum) -> [f64; 5] {
    let w = TAU / p.period;
    let inertia = s.pendulous / (w * w);
    [(1.0 - p.coupling) * inertia, 2.0 * p.damping * w * inertia, (p.coupling * inertia).sqrt(), 1.0, p.lag]
}

/// Solves a linear system by elimination with pivots.
fn solved<const N: usize>(mut a: [[Complex64; N]; N], mut b: [Complex64; N]) -> [Complex64; N] {
    for i in 0..N {
        let pivot = (i..N).max_by(|x, y| a[*x][i].norm().total_cmp(&a[*y][i].norm())).unwrap();
        a.swap(i, pivot);
        b.swap(i, pivot);
        for k in i + 1..N {
            let (by, row, right) = (a[k][i] / a[i][i], a[i], b[i]);
            (0..N).for_each(|j| a[k][j] -= by * row[j]);
            b[k] -= by * right;
        }
    }
    for i in (0..N).rev() {
        let known: Complex64 = (i + 1..N).map(|j| a[i][j] * b[j]).sum();
        b[i] = (b[i] - known) / a[i][i];
    }
    b
}

/// x a unit of W₁: the unknowns f, x₁, x₂, ξ, γ and δ.
fn by_hand(s: &Gyrosphere, swing: &Pendulum, flow: Relaxing, slosh: Slosh, p: Complex64) -> Complex64 {
    let (m, c0, l, zero, one) =
        (s.weight / s.gravity, s.stiffness, s.pendulous / s.weight, Complex64::ZERO, Complex64::ONE);
    let [j, d, turn, k, c] = constants(s, swing);
    let (mu, pull) =
        (slosh.share, p * p + 2.0 * slosh.damping * slosh.frequency * p + slosh.frequency.powi(2));
    let ml = m * l * p * p;
    let rows = [
        // m s²(x₁ + x₂ + μ ξ + l γ) + f = m
        [one, m * p * p, m * p * p, m * mu * p * p, ml, zero],
        [-one, c0 * (p * s.lag + 1.0), zero, zero, zero, zero],
        [Complex64::from(-flow.share / c0), zero, p * flow.time + 1.0, zero, zero, zero],
        [zero, p * p, p * p, pull, zero, zero],
        // J s² γ + d s γ + lP γ + Γ s δ = m l (1 − s² x_v)
        [zero, ml, ml, zero, p * p * j + p * d + s.pendulous, p * turn],
        [zero, zero, zero, zero, -p * turn, p * c + k],
    ];
    let right = [Complex64::from(m), zero, zero, one, Complex64::from(m * l), zero];
    let [_, x1, x2, xi, gamma, _] = solved(rows, right);
    x1 + x2 + mu * xi + l * gamma
}

#[test]
fn the_swing_is_in_one_balance_with_the_other_parts() {
    let sphere = pendulous();
    let (dry, rigid) = (Slosh { share: 0.0, ..SLOSH }, Relaxing { share: 0.0, ..FLOW });
    for swing in SWINGS {
        for (flow, slosh) in [(rigid, dry), (FLOW, dry), (rigid, SLOSH), (FLOW, SLOSH)] {
            let parts = all(&[Box::new(Inertia), boxed(&swing), boxed(&flow), boxed(&slosh)]);
            for omega in [0.2, 0.8, 1.4, 2.2, 5.0] {
                let got = transfer(parts.as_ref(), &sphere, omega)[0][0];
                let wanted = by_hand(&sphere, &swing, flow, slosh, Complex64::new(0.0, omega));
                assert!((got / wanted - 1.0).norm() < 1e-9, "{swing:?} {omega}: {got} and {wanted}");
            }
        }
        // without inertia the gives stand side by side
        let parts = [boxed(&swing), boxed(&FLOW)];
        let got = transfer(all(&parts).as_ref(), &sphere, 0.9)[0][0];
        let [alone, flow, lag] = [boxed(&swing), boxed(&FLOW), Box::new(gyrospec::gyro::elastic::Lag)]
            .map(|p| transfer(p.as_ref(), &sphere, 0.9)[0][0]);
        assert!((got / (alone + flow - lag) - 1.0).norm() < 1e-10);
    }
}

/// The rates of (x_v, γ, v, γ̇, δ) under an acceleration, with friction F tanh(v/u) beside the spring.
fn rates(s: &Gyrosphere, p: &Pendulum, (force, steep): (f64, f64), w: f64, z: [f64; 5]) -> [f64; 5] {
    let (m, c0, l) = (s.weight / s.gravity, s.stiffness, s.pendulous / s.weight);
    let [j, d, turn, k, c] = constants(s, p);
    let [x, gamma, v, rate, delta] = z;
    // without damping δ = Γ γ̇/k, and its rate belongs to the inertia
    let (turning, j) = if c > 0.0 { ((turn * rate - k * delta) / c, j) } else { (0.0, j + turn * turn / k) };
    let f = c0 * s.lag * v + c0 * x + force * (v / steep).tanh();
    // m(v̇ + l γ̈) = m W₁ − f,  m l v̇ + J γ̈ = m l W₁ − d γ̇ − lP γ − Γ δ̇
    let (a, b) = (m * w - f, m * l * w - d * rate - s.pendulous * gamma - turn * turning);
    let determinant = m * j - (m * l).powi(2);
    [v, rate, (j * a - m * l * b) / determinant, (m * b - m * l * a) / determinant, turning]
}

/// ⟨W₁ x⟩ over the last repeat of the force.
fn simulated(s: &Gyrosphere, p: &Pendulum, force: f64, (count, steep): (u32, f64)) -> f64 {
    let (dt, periods) = (20.0 * PI / f64::from(count), 5);
    let (mut z, mut mean) = ([0.0; 5], 0.0);
    for k in 0..count * periods {
        let t = f64::from(k) * dt;
        let at = |z: [f64; 5], t: f64| rates(s, p, (force, steep), driven(t), z);
        let step = |r: [f64; 5], h: f64| std::array::from_fn(|i| z[i] + h * r[i]);
        let k1 = at(z, t);
        let k2 = at(step(k1, 0.5 * dt), t + 0.5 * dt);
        let k3 = at(step(k2, 0.5 * dt), t + 0.5 * dt);
        let k4 = at(step(k3, dt), t + dt);
        z = std::array::from_fn(|i| z[i] + dt / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        if k >= count * (periods - 1) {
            mean += driven(t + dt) * (z[0] + s.pendulous / s.weight * z[1]) / f64::from(count);
        }
    }
    mean
}

/// The same by the part in time.
fn followed(s: &Gyrosphere, part: &dyn Elastic, count: usize) -> f64 {
    let (dt, periods) = (20.0 * PI / count as f64, 5);
    let mut law = part.in_time(s, dt).unwrap().unwrap();
    let force = |k: usize| s.weight / s.gravity * driven(k as f64 * dt);
    let mut mean = 0.0;
    for k in 0..count * periods {
        law.advance(force(k), force(k + 1));
        if k >= count * (periods - 1) {
            mean += driven((k + 1) as f64 * dt) * law.shift() / count as f64;
        }
    }
    mean
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn rubbed_and_swinging_it_is_as_simulated() {
    let sphere = pendulous();
    for swing in SWINGS {
        let means: Vec<f64> = [0.0, 3.0, 8.0]
            .map(|force| {
                let part = all(&[boxed(&swing), Box::new(Friction { force })]);
                let mine = followed(&sphere, part.as_ref(), 20_000);
                let [coarse, fine] = [2e-3, 1e-3].map(|u| simulated(&sphere, &swing, force, (400_000, u)));
                // the steepness errs in proportion to itself
                let other = 2.0 * fine - coarse;
                assert_relative_eq!(mine, other, max_relative = 2e-3);
                mine
            })
            .to_vec();
        assert!((means[1] / means[0] - 1.0).abs() > 0.03, "friction counts: {means:?}");
    }
}

#[test]
fn a_swing_lighter_than_its_own_mass_is_refused_with_inertia() {
    let swing = Pendulum { period: 1.0, damping: 0.1, coupling: 0.0, lag: 0.0 };
    let parts = all(&[boxed(&swing), Box::new(Inertia)]);
    let still = gyrospec::gyro::Motion::roll(&crate::parts::roll()).band_limited(2.5, 2).unwrap();
    let e = gyrospec::gyro::Instrument::new(pendulous(), parts).error(&still, 0.7).unwrap_err();
    assert!(e.to_string().contains("no sphere is left"), "{e}");
}
