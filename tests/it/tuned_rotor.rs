//! A dry-tuned rotor whose case vibrates at twice its speed, beside Lagrange's equations with nothing taken for small.

use approx::assert_relative_eq;
use gyrospec::gyro::gimbal::{Gimbal, Inertia};
use gyrospec::gyro::strapdown::TunedRotor;
use std::f64::consts::{FRAC_PI_2, TAU};

type V = [f64; 3];

/// A rotor (A = 0.6, C = 1) on a gimbal on a shaft that turns with 1 rad/s, whose case vibrates: Lagrange's equations
/// with differences in place of derivatives, nothing taken for small.
struct Joint {
    gimbal: V,
    spring: f64,
    amplitude: f64,
    phase: f64,
}

impl Joint {
    /// Angular velocities of the gimbal and the rotor in their own axes; q = (about the shaft's y, about the gimbal's x).
    fn velocities(&self, q: [f64; 2], dq: [f64; 2], t: f64) -> [V; 2] {
        // the case turns about its own X with θ′ = 2θ₀ cos(2t + ψ)
        let rate = 2.0 * self.amplitude * (2.0 * t + self.phase).cos();
        let ((s, c), (sb, cb), (sa, ca)) = (t.sin_cos(), q[0].sin_cos(), q[1].sin_cos());
        let shaft = [rate * c, -rate * s, 1.0];
        let g = [cb * shaft[0] - sb * shaft[2], shaft[1] + dq[0], sb * shaft[0] + cb * shaft[2]];
        [g, [g[0] + dq[1], ca * g[1] + sa * g[2], -sa * g[1] + ca * g[2]]]
    }

    fn energy(&self, q: [f64; 2], dq: [f64; 2], t: f64) -> f64 {
        let [g, r] = self.velocities(q, dq, t);
        let rotor = [0.6, 0.6, 1.0];
        0.5 * (0..3).map(|i| self.gimbal[i] * g[i] * g[i] + rotor[i] * r[i] * r[i]).sum::<f64>()
    }

    /// ∂T/∂q̇, exact for what is quadratic.
    fn momenta(&self, q: [f64; 2], dq: [f64; 2], t: f64) -> [f64; 2] {
        let at = |a: f64, b: f64| self.energy(q, [dq[0] + a, dq[1] + b], t);
        [0.5 * (at(1.0, 0.0) - at(-1.0, 0.0)), 0.5 * (at(0.0, 1.0) - at(0.0, -1.0))]
    }

    /// (q̇, ṗ) of (q, p).
    fn slope(&self, y: [f64; 4], t: f64) -> [f64; 4] {
        let q = [y[0], y[1]];
        let still = self.momenta(q, [0.0; 2], t);
        let column = |dq: [f64; 2]| {
            let p = self.momenta(q, dq, t);
            [p[0] - still[0], p[1] - still[1]]
        };
        let (m, n) = (column([1.0, 0.0]), column([0.0, 1.0]));
        let (r, det) = ([y[2] - still[0], y[3] - still[1]], m[0] * n[1] - n[0] * m[1]);
        let dq = [(r[0] * n[1] - n[0] * r[1]) / det, (m[0] * r[1] - m[1] * r[0]) / det];
        let h = 1e-4;
        let down = |a: f64, b: f64| {
            (self.energy([q[0] + a, q[1] + b], dq, t) - self.energy([q[0] - a, q[1] - b], dq, t)) / (2.0 * h)
        };
        [dq[0], dq[1], down(h, 0.0) - self.spring * q[0], down(0.0, h) - self.spring * q[1]]
    }

    /// How fast the rotor's axis leaves its place among the stars, over `turns` of the shaft.
    fn drift(&self, turns: usize) -> f64 {
        let per_turn = 200;
        let step = TAU / f64::from(per_turn);
        let start = self.momenta([0.0; 2], [0.0; 2], 0.0);
        let mut y = [0.0, 0.0, start[0], start[1]];
        let (mut sums, mut at) = (Vec::new(), 0.0);
        for _ in 0..turns {
            let mut sum = [0.0; 2];
            for _ in 0..per_turn {
                let add = |k: [f64; 4], h: f64| [0, 1, 2, 3].map(|i| y[i] + h * k[i]);
                let k1 = self.slope(y, at);
                let k2 = self.slope(add(k1, 0.5 * step), at + 0.5 * step);
                let k3 = self.slope(add(k2, 0.5 * step), at + 0.5 * step);
                let k4 = self.slope(add(k3, step), at + step);
                y = [0, 1, 2, 3].map(|i| y[i] + step / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
                at += step;
                // the rotor's axis in the shaft is (sin b cos a, −sin a, cos b cos a); turned back by t into the case,
                // and with the case by θ about X
                let (x, yy) = (y[0].sin() * y[1].cos(), -y[1].sin());
                let theta = self.amplitude * ((2.0 * at + self.phase).sin() - self.phase.sin());
                let (s, c) = at.sin_cos();
                sum[0] += c * x - s * yy;
                sum[1] += s * x + c * yy - theta;
            }
            sums.push(sum.map(|s| s / f64::from(per_turn)));
        }
        // means over 30 turns, 50 nutations
        let mean = |part: &[[f64; 2]]| [0, 1].map(|i| part.iter().map(|s| s[i]).sum::<f64>() / 30.0);
        let (first, last) = (mean(&sums[..30]), mean(&sums[turns - 30..]));
        (last[0] - first[0]).hypot(last[1] - first[1]) / (TAU * (turns - 30) as f64)
    }
}

#[test]
fn a_tuned_rotor_drifts_by_two_turns_a_revolution() {
    for (gimbal, near) in [([1e-3, 1.1e-3, 1.2e-3], 5e-3), ([1e-2, 1.1e-2, 1.2e-2], 5e-2)] {
        let rotor =
            TunedRotor { speed: 1.0, spin_inertia: 1.0, gimbal_inertia: gimbal[0] + gimbal[1] - gimbal[2] };
        let joint = Joint { gimbal, spring: rotor.tuned_spring(), amplitude: 1e-4, phase: FRAC_PI_2 };
        let (said, apart) = (rotor.drift(1e-4), joint.drift(150));
        let quiet = Joint { amplitude: 0.0, ..joint }.drift(150);
        println!("two a turn: {said:.5e}, Lagrange's equations {apart:.5e}, without vibration {quiet:.1e}");
        assert_relative_eq!(apart, said, max_relative = near);
        assert!(quiet < 1e-3 * said);
        // the gyroscope in a rotating gimbal, with the rotor and its gimbal for bodies, a little damped
        let body = |v: V| Inertia { x: v[0], y: v[1], z: v[2] };
        let spring = rotor.tuned_spring();
        let same = Gimbal {
            bodies: [body([0.6, 0.6, 1.0]), body(gimbal), body([0.0; 3])],
            momentum: 0.0,
            speed: 1.0,
            springs: [spring; 2],
            damping: [0.0; 2],
        };
        let tuned = same.tuned_springs().into_iter().find(|c| (c / spring - 1.0).abs() < 0.1).unwrap();
        let same = Gimbal { springs: [tuned * (1.0 + 1e-6); 2], ..same };
        let part = same.scale_factor(-2.0).conj() / same.scale_factor(0.0);
        assert_relative_eq!(part.norm(), rotor.fold(), max_relative = near);
    }
}
