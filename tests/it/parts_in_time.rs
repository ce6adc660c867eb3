//! Friction and free play in company, against Newton's laws by Moreau's implicit step, which shares nothing with the
//! library.
//!
//! Reference: V. Acary, B. Brogliato, Numerical Methods for Nonsmooth Dynamical Systems (2008), ch. 10.

use crate::parts::{
    CORNER, FLOW, MERIDIAN, SLOSH, VERTICAL, all, banded, boxed, driven, roll, soft, transfer,
};
use approx::assert_relative_eq;
use gyrospec::Complex64;
use gyrospec::gyro::elastic::{Backlash, Elastic, Friction, Inertia, Relaxing, Slosh};
use gyrospec::gyro::{Drive, Gyrosphere, Instrument, MonteCarlo};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::f64::consts::{FRAC_PI_4, PI};

/// Friction and free play beside whatever else there is.
#[derive(Debug, Clone, Copy)]
struct Case {
    sphere: Gyrosphere,
    friction: f64,
    gap: f64,
    flow: Option<Relaxing>,
    slosh: Option<Slosh>,
}

/// x₁, x₂, ẋ_v, ξ, ξ̇.
type Place = [f64; 5];

impl Case {
    fn part(self) -> Box<dyn Elastic> {
        let mut parts: Vec<Box<dyn Elastic>> = vec![Box::new(Inertia)];
        parts.extend(self.flow.iter().map(boxed));
        parts.extend(self.slosh.iter().map(boxed));
        if self.friction > 0.0 {
            parts.push(Box::new(Friction { force: self.friction }));
        }
        if self.gap > 0.0 {
            parts.push(Box::new(Backlash { gap: self.gap }));
        }
        all(&parts)
    }

    /// What Newton's law of the whole misses where x₁ moves on at the speed u under friction s F_c, and where all is
    /// then: Euler's implicit rule.
    fn missed(self, z: Place, w: f64, dt: f64, (u, s): (f64, f64)) -> (f64, Place) {
        let [x1, x2, v, xi, dxi] = z;
        let (m, c) = (self.sphere.weight / self.sphere.gravity, self.sphere.stiffness);
        let give = x1 + dt * u;
        let f = c * self.sphere.lag * u + c * (give - give.clamp(-self.gap, self.gap)) + s * self.friction;
        let liquid = self.flow.map_or(0.0, |q| (q.time / dt * x2 + q.share * f / c) / (q.time / dt + 1.0));
        let speed = u + (liquid - x2) / dt;
        let l = self.slosh.unwrap_or(Slosh { share: 0.0, ..SLOSH });
        let k = l.frequency.powi(2);
        let swing = (dxi + dt * (w - k * xi) - (speed - v))
            / (1.0 + dt * 2.0 * l.damping * l.frequency + dt * dt * k);
        let missed = m * ((speed - v) + l.share * (swing - dxi)) / dt + f - m * w;
        (missed, [give, liquid, speed, xi + dt * swing, swing])
    }

    /// Moreau's step: the speed u with 0 ∈ missed(u, Sgn u), which rises with u and is straight in pieces.
    fn step(self, z: Place, w: f64, dt: f64) -> Place {
        let [up, down] = [1.0, -1.0].map(|s| self.missed(z, w, dt, (0.0, s)).0);
        if up >= 0.0 && down <= 0.0 {
            // at rest, under the part of the friction that holds it there
            let held = if up > down { -1.0 - 2.0 * down / (up - down) } else { 0.0 };
            return self.missed(z, w, dt, (0.0, held)).1;
        }
        let s = if up < 0.0 { 1.0 } else { -1.0 };
        let of = |u: f64| self.missed(z, w, dt, (u, s)).0;
        let mut u = 0.0;
        for _ in 0..20 {
            let here = of(u);
            let slope = (of(u + 1e-7 * s) - here) * 1e7 * s;
            let next = u - here / slope;
            if (next - u).abs() <= 1e-12 * (u.abs() + 1e-12) {
                break;
            }
            u = next;
        }
        self.missed(z, w, dt, (u, s)).1
    }
}

/// α a unit of ⟨W₂ x⟩.
fn gain(s: &Gyrosphere) -> f64 {
    s.weight / (s.gravity * s.momentum * s.earth_rate * s.latitude.cos())
}

/// The mean error of each case on the banded roll and its standard error, rad; the linear part of each on the same
/// roll, whose mean is known, takes most of the scatter away.
fn reference(cases: &[Case]) -> Vec<(f64, f64)> {
    let (dt, blocks, steps) = (0.004, 24, 200_000);
    let mut rng = ChaCha8Rng::seed_from_u64(77);
    let kick = (4.0 * roll().variance * roll().decay * roll().b2() * dt).sqrt();
    let (mut angle, mut rate, mut once, mut twice) = (0.0, 0.0, 0.0, 0.0);
    let tight: Vec<Case> = cases.iter().map(|c| Case { friction: 0.0, gap: 0.0, ..*c }).collect();
    let exact: Vec<f64> = tight
        .iter()
        .map(|c| Instrument::new(c.sphere, c.part()).rectified_error(&banded(), FRAC_PI_4).unwrap())
        .collect();
    let mut at = vec![[[0.0; 5]; 2]; cases.len()];
    let mut means = vec![Vec::new(); cases.len()];
    for block in 0..=blocks {
        let mut sums = vec![[0.0; 2]; cases.len()];
        for _ in 0..steps {
            let noise: f64 = StandardNormal.sample(&mut rng);
            let turned = angle + dt * rate;
            rate += dt * (-2.0 * roll().decay * rate - roll().b2() * angle) + kick * noise;
            angle = turned;
            // the roll's speed behind two low-passes, whose rate is its acceleration
            once += dt * CORNER * (rate - once);
            let acceleration = CORNER * (once - twice);
            twice += dt * acceleration;
            for (i, pair) in cases.iter().zip(&tight).enumerate() {
                let w = pair.0.sphere.lever * acceleration * FRAC_PI_4.cos();
                for (k, case) in [pair.0, pair.1].into_iter().enumerate() {
                    let z = case.step(at[i][k], -w, dt);
                    at[i][k] = z;
                    sums[i][k] += w * (z[0] + z[1] + case.slosh.map_or(0.0, |l| l.share) * z[3]);
                }
            }
        }
        for (i, sum) in sums.iter().enumerate().filter(|_| block > 0) {
            let [own, linear] = sum.map(|x| gain(&cases[i].sphere) * x / f64::from(steps));
            means[i].push([own, linear - exact[i]]);
        }
    }
    means.iter().map(|m| regressed(m)).collect()
}

/// The mean of the first where the second, which goes with it, has its own mean of 0, and its standard error.
fn regressed(pairs: &[[f64; 2]]) -> (f64, f64) {
    let n = pairs.len() as f64;
    let [own, other] = [0, 1].map(|i| pairs.iter().map(|p| p[i]).sum::<f64>() / n);
    let sum = |f: &dyn Fn(&[f64; 2]) -> f64| pairs.iter().map(f).sum::<f64>();
    let square = sum(&|p| (p[1] - other).powi(2));
    let slope = sum(&|p| (p[0] - own) * (p[1] - other)) / square;
    let rest = sum(&|p| (p[0] - own - slope * (p[1] - other)).powi(2)) / (n - 2.0);
    (own - slope * other, (rest * (1.0 / n + other * other / square)).sqrt())
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn friction_and_play_in_company_are_within_their_margins_of_the_true_law() {
    let sphere = Gyrosphere { lever: 0.05, ..soft() };
    let plain = Case { sphere, friction: 0.0, gap: 0.0, flow: None, slosh: None };
    let cases = [
        Case { friction: 0.03, gap: 5e-4, ..plain },
        Case { friction: 0.03, flow: Some(FLOW), ..plain },
        Case { friction: 0.03, slosh: Some(SLOSH), ..plain },
        Case { gap: 1e-3, flow: Some(FLOW), ..plain },
        Case { friction: 0.02, gap: 5e-4, flow: Some(FLOW), slosh: Some(SLOSH), ..plain },
    ];
    for (case, (mean, spread)) in cases.iter().zip(reference(&cases)) {
        let said = Instrument::new(case.sphere, case.part()).error(&banded(), FRAC_PI_4).unwrap();
        println!(
            "{}: {:.4}° ± {:.4}°, reference {:.4}° ± {:.4}°, linearised {:.4}°",
            case.part().name(),
            said.rectified.to_degrees(),
            said.rectified_margin.to_degrees(),
            mean.to_degrees(),
            (2.82 * spread).to_degrees(),
            said.linearised.unwrap().to_degrees()
        );
        // 99 % of Student's t with 22 degrees; Euler's step of 4 ms errs by less than a hundredth
        let within = said.rectified_margin + 2.82 * spread + 1e-2 * mean.abs();
        assert!((said.rectified - mean).abs() < within, "{case:?}");
        assert!(said.rectified_margin > 0.0 && said.rectified_margin < 0.06 * mean.abs());
    }
}

/// Where a part goes under a force that repeats, in steps of `step`.
fn followed(part: &dyn Elastic, sphere: &Gyrosphere, step: f64, count: usize) -> Vec<f64> {
    let mut law = part.in_time(sphere, step).unwrap().unwrap();
    let force = |k: usize| 6.0 * driven(k as f64 * step);
    (0..count)
        .map(|k| {
            law.advance(if k == 0 { 0.0 } else { force(k) }, force(k + 1));
            law.shift()
        })
        .collect()
}

#[test]
fn followed_in_company_a_law_is_that_of_the_part_alone() {
    for sphere in [soft(), Gyrosphere::seed()] {
        let give = 6.0 / sphere.stiffness;
        let laws: [Box<dyn Elastic>; 4] = [
            Box::new(Friction { force: 1.5 }),
            Box::new(Friction { force: 0.0 }),
            Box::new(Backlash { gap: 0.3 * give }),
            Box::new(Backlash { gap: 0.0 }),
        ];
        for law in &laws {
            let alone = followed(law.as_ref(), &sphere, 0.02, 8000);
            // inertia is in the law already; what gives nothing changes nothing
            let still: [Box<dyn Elastic>; 3] = [
                Box::new(Inertia),
                Box::new(Relaxing { time: 1.5, share: 0.0 }),
                Box::new(Slosh { share: 0.0, ..SLOSH }),
            ];
            for other in &still {
                let pair = followed(all(&[law.clone(), other.clone()]).as_ref(), &sphere, 0.02, 8000);
                let largest = alone.iter().fold(0.0f64, |m, x| m.max(x.abs()));
                let off = alone.iter().zip(&pair).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
                assert!(
                    largest > 0.1 * give && off < 1e-6 * largest,
                    "{law:?} {other:?}: {off} of {largest}"
                );
            }
        }
    }
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_nonlinear_part_keeps_what_gives_way_along_the_meridian() {
    let sphere = Gyrosphere { pendulous: 40.0, damper: 16.0, flow: 0.02, lever: 0.05, ..soft() };
    let parts = all(&[Box::new(Friction { force: 0.03 }), boxed(&MERIDIAN), boxed(&VERTICAL)]);
    let instrument = Instrument::new(sphere, parts);
    let said = instrument.error(&banded(), FRAC_PI_4).unwrap();
    let drive = Drive::irregular(&banded());
    let step = drive.step().unwrap();
    let plan = MonteCarlo { step, duration: 6.0 * 3600.0, settle: 2000.0, runs: 24, seed: 5 };
    let got = plan.run(&instrument, &drive, FRAC_PI_4).unwrap();
    let off = (got.mean - said.mean()).abs();
    assert!(off < got.mean_margin + said.rectified_margin, "{got:?} {said:?}");
    // without the meridian's part it is another figure
    let alone = Instrument::new(sphere, Box::new(Friction { force: 0.03 }));
    let other = alone.error(&banded(), FRAC_PI_4).unwrap();
    assert!((other.rectified - said.rectified).abs() > 5.0 * (got.mean_margin + said.rectified_margin));
    // and with friction of no force it is exact
    let tight = all(&[Box::new(Friction { force: 0.0 }), boxed(&MERIDIAN)]);
    let exact = all(&[Box::new(Inertia), boxed(&MERIDIAN)]);
    let [simulated, exact] =
        [tight, exact].map(|p| Instrument::new(sphere, p).error(&banded(), 1.0).unwrap());
    assert!((simulated.rectified - exact.rectified).abs() <= simulated.rectified_margin + 1e-12);
    assert_relative_eq!(simulated.linearised.unwrap(), exact.rectified, max_relative = 1e-9);
}

#[test]
fn friction_and_play_have_one_joint_stand_in() {
    let sphere = soft();
    let (force, gap) = (1.0, 0.05);
    let part = all(&[Box::new(Friction { force }), Box::new(Backlash { gap }), boxed(&FLOW)]);
    let got = transfer(part.as_ref(), &sphere, 0.9)[0][0];
    // r + F √(2/π)/σ(ẋ₁) and C₀ erfc(δ/√2σ(x₁)), turned until they stand still, with both σ by trapezoids
    let (m, c, r) = (sphere.weight / sphere.gravity, sphere.stiffness, sphere.lag * sphere.stiffness);
    let (mut rr, mut cc) = (r, c);
    let element = |w: f64, rr: f64, cc: f64| -> (Complex64, Complex64) {
        let p = Complex64::new(0.0, w);
        let one = 1.0 / (rr * p + cc);
        let compliance = one + FLOW.share / (c * (p * FLOW.time + 1.0));
        let f = m / (1.0 + m * p * p * compliance);
        (f * one, f * compliance)
    };
    for _ in 0..200 {
        let (mut squares, step) = ([0.0; 2], 2e-3);
        for k in 1..20_000 {
            let w = f64::from(k) * step;
            let low = (1.0 + (w / CORNER).powi(2)).powi(2);
            let power = roll().density(w) * w.powi(4) / low * sphere.lever.powi(2) * 0.5 * step / PI;
            let x = element(w, rr, cc).0.norm_sqr() * power;
            squares[0] += x;
            squares[1] += w * w * x;
        }
        let [x, v] = squares.map(f64::sqrt);
        rr = r + force * (2.0 / PI).sqrt() / v;
        cc = c * statrs::function::erf::erfc(gap / (2f64.sqrt() * x));
    }
    let wanted = element(0.9, rr, cc).1;
    assert!(rr > 1.05 * r && cc < 0.9 * c, "{rr} {cc}");
    assert!((got / wanted - 1.0).norm() < 1e-4, "{got} {wanted}");
}
