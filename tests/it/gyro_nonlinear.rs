//! Dry friction and free play, against a simulation that shares nothing with the library: roll and
//! low-passes by Euler's rule, the part by Moreau's implicit step with a set-valued friction.
//!
//! Reference: V. Acary, B. Brogliato, Numerical Methods for Nonsmooth Dynamical Systems (2008), ch. 10.

use approx::assert_relative_eq;
use gyrospec::ErrorKind;
use gyrospec::gyro::elastic::{Backlash, Elastic, Friction, Inertia};
use gyrospec::gyro::seed::Regular;
use gyrospec::gyro::{Drive, Gyrosphere, HeadingError, Instrument, MonteCarlo, Motion};
use gyrospec::spectrum::Roll;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const NORTHEAST: f64 = std::f64::consts::FRAC_PI_4;
const CORNER: f64 = 2.5;

/// Example 3.1.
fn roll() -> Roll {
    Roll::new(0.03, 0.1, 0.8).unwrap()
}

fn seed() -> Gyrosphere {
    Gyrosphere { latitude: 60f64.to_radians(), ..Gyrosphere::seed() }
}

/// A light and springy suspension, whose inertia counts.
fn soft() -> Gyrosphere {
    Gyrosphere { stiffness: 30.0, lag: 0.05, ..seed() }
}

#[derive(Clone, Copy)]
enum Law {
    Friction(f64),
    Play(f64),
}

impl Law {
    fn part(self) -> Box<dyn Elastic> {
        match self {
            Self::Friction(force) => Box::new(Friction { force }),
            Self::Play(gap) => Box::new(Backlash { gap }),
        }
    }

    /// m(v′ − v)/dt + r v′ + F_c Sgn v′ + C₀ d(x + dt v′) ∋ F, in closed form.
    fn step(self, s: &Gyrosphere, (x, v): (f64, f64), force: f64, dt: f64) -> (f64, f64) {
        let (m, r, c) = (s.weight / s.gravity, s.lag * s.stiffness, s.stiffness);
        let next = match self {
            Self::Friction(most) => {
                let push = m * v / dt + force - c * x;
                push.signum() * (push.abs() - most).max(0.0) / (m / dt + r + dt * c)
            }
            Self::Play(gap) => {
                let push = m * v / dt + force;
                let free = push / (m / dt + r);
                let edge = (x + dt * free).clamp(-gap, gap);
                if edge == x + dt * free { free } else { (push - c * (x - edge)) / (m / dt + r + dt * c) }
            }
        };
        (x + dt * next, next)
    }
}

/// α a unit of ⟨W₂ x⟩.
fn gain(s: &Gyrosphere) -> f64 {
    s.weight / (s.gravity * s.momentum * s.earth_rate * s.latitude.cos())
}

/// The mean error of each case on Example 3.1's roll behind two low-passes, and its standard error, rad.
fn reference(cases: &[(Gyrosphere, Law)]) -> Vec<(f64, f64)> {
    let (dt, blocks, steps) = (0.004, 25, 750_000);
    let mut rng = ChaCha8Rng::seed_from_u64(99);
    let kick = (4.0 * roll().variance * roll().decay * roll().b2() * dt).sqrt();
    let (mut angle, mut rate, mut once, mut twice) = (0.0, 0.0, 0.0, 0.0);
    let mut at = vec![(0.0, 0.0); cases.len()];
    let mut means = vec![Vec::new(); cases.len()];
    for block in 0..=blocks {
        let mut sums = vec![0.0; cases.len()];
        for _ in 0..steps {
            let noise: f64 = StandardNormal.sample(&mut rng);
            let turned = angle + dt * rate;
            rate += dt * (-2.0 * roll().decay * rate - roll().b2() * angle) + kick * noise;
            angle = turned;
            // the roll's speed behind two low-passes, whose rate is its acceleration
            once += dt * CORNER * (rate - once);
            let acceleration = CORNER * (once - twice);
            twice += dt * acceleration;
            for ((s, law), (place, sum)) in cases.iter().zip(at.iter_mut().zip(&mut sums)) {
                let w = s.lever * acceleration * NORTHEAST.cos();
                *place = law.step(s, *place, -s.weight / s.gravity * w, dt);
                *sum += w * place.0;
            }
        }
        if block > 0 {
            means.iter_mut().zip(&sums).for_each(|(m, sum)| m.push(sum / f64::from(steps)));
        }
    }
    let told = |(case, m): (&(Gyrosphere, Law), &Vec<f64>)| {
        let n = m.len() as f64;
        let mean = m.iter().sum::<f64>() / n;
        let variance = m.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
        (gain(&case.0) * mean, gain(&case.0) * (variance / n).sqrt())
    };
    cases.iter().zip(&means).map(told).collect()
}

fn error(sphere: Gyrosphere, law: Law) -> HeadingError {
    let motion = Motion::roll(&roll()).band_limited(CORNER, 2).unwrap();
    Instrument::new(sphere, law.part()).error(&motion, NORTHEAST).unwrap()
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn friction_and_free_play_are_within_their_margins_of_the_true_law() {
    // σ of x without play: 1.3e-5 m of the seed's suspension, 4 cm of the soft one
    let cases = [
        (seed(), Law::Friction(1.0)),
        (seed(), Law::Friction(2.0)),
        (seed(), Law::Friction(4.0)),
        (seed(), Law::Play(1e-5)),
        (seed(), Law::Play(2.6e-5)),
        (soft(), Law::Friction(0.5)),
        (soft(), Law::Play(0.05)),
    ];
    for ((sphere, law), (mean, spread)) in cases.iter().zip(reference(&cases)) {
        let said = error(*sphere, *law);
        let degrees = |x: f64| x.to_degrees();
        println!(
            "{:?}: {:.4}° ± {:.4}°, reference {:.4}° ± {:.4}°, linearised {:.4}°",
            law.part(),
            degrees(said.rectified),
            degrees(said.rectified_margin),
            degrees(mean),
            degrees(2.6 * spread),
            degrees(said.linearised.unwrap())
        );
        // Euler's step of 4 ms errs by a three-hundredth
        let within = said.rectified_margin + 2.6 * spread + 3e-3 * mean.abs();
        assert!((said.rectified - mean).abs() < within, "{:?}", law.part());
        assert!(said.rectified_margin > 0.0 && said.rectified_margin < 0.06 * mean.abs().max(2e-3));
    }
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn without_friction_or_play_the_part_is_linear() {
    let motion = Motion::roll(&roll()).band_limited(CORNER, 2).unwrap();
    for sphere in [seed(), soft()] {
        let exact = Instrument::new(sphere, Box::new(Inertia)).error(&motion, NORTHEAST).unwrap();
        for law in [Law::Friction(0.0), Law::Play(0.0)] {
            let said = error(sphere, law);
            assert!((said.rectified - exact.rectified).abs() < said.rectified_margin, "{:?}", law.part());
            assert!((said.deviation - exact.deviation).abs() < said.deviation_margin, "{:?}", law.part());
            assert!(said.deviation_margin < 0.25 * said.deviation);
        }
    }
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_part_that_always_sticks_has_no_error_within_a_margin_that_is_not_zero() {
    let said = error(seed(), Law::Friction(1e6));
    assert!(said.rectified == 0.0 && said.rectified_margin > 0.0);
    assert!(said.rectified_margin < 1e-3 * error(seed(), Law::Friction(0.0)).rectified.abs());
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn the_error_about_the_card_follows_from_its_first_quarter() {
    let motion = Motion::roll(&roll()).band_limited(CORNER, 2).unwrap();
    let compass = Instrument::new(seed(), Box::new(Friction { force: 2.0 }));
    let on = |degrees: f64| compass.error(&motion, degrees.to_radians()).unwrap().rectified;
    let (quarter, half) = (on(30.0), on(210.0));
    assert_relative_eq!(quarter, half, max_relative = 1e-9);
    assert_relative_eq!(on(150.0), -quarter, max_relative = 1e-9);
    // 30° and 60° are alike for a linear part, not for this one: friction weighs less on the greater force
    assert!(quarter < 1.3 * on(60.0));
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn along_the_parallel_nothing_pushes_and_the_part_rests() {
    let motion = Motion::roll(&roll()).band_limited(CORNER, 2).unwrap();
    for force in [0.5, 2.0, 50.0] {
        let compass = Instrument::new(seed(), Box::new(Friction { force }));
        let across = compass.error(&motion, 90f64.to_radians()).unwrap();
        assert!(across.rectified.abs() < 1e-12 && across.linearised == Some(0.0), "{across:?}");
    }
}

#[test]
fn on_regular_roll_the_part_is_followed_over_its_period() {
    let roll = Regular { amplitude: 10f64.to_radians(), frequency: 0.8 };
    for (sphere, law) in [
        (seed(), Law::Friction(1.0)),
        (seed(), Law::Friction(1.8)),
        (seed(), Law::Play(6e-6)),
        (soft(), Law::Friction(0.5)),
        (soft(), Law::Play(0.03)),
    ] {
        let said = Instrument::new(sphere, law.part()).regular_error(&roll, NORTHEAST).unwrap();
        let (points, mut at, mut sum) = (40_000, (0.0, 0.0), 0.0);
        let dt = std::f64::consts::TAU / roll.frequency / f64::from(points);
        for k in 0..80 * points {
            let phase = roll.frequency * dt * f64::from(k % points);
            let w = -sphere.lever * roll.amplitude * roll.frequency.powi(2) * phase.sin() * NORTHEAST.cos();
            at = law.step(&sphere, at, -sphere.weight / sphere.gravity * w, dt);
            sum += if k < 79 * points { 0.0 } else { w * at.0 };
        }
        let mean = gain(&sphere) * sum / f64::from(points);
        println!("{:?}: {:.6e}, reference {mean:.6e}", law.part(), said.rectified);
        assert!(
            (said.rectified - mean).abs() < said.rectified_margin + 1e-3 * mean.abs(),
            "{:?}: {} {mean}",
            law.part(),
            said.rectified
        );
        assert!(said.rectified_margin < 5e-3 * mean.abs() && said.deviation_quadratic == 0.0);
    }
    // friction above the force's amplitude, m h θ₀ p² cos K: it sticks
    let stuck = Instrument::new(seed(), Box::new(Friction { force: 2.1 }));
    assert_eq!(stuck.regular_error(&roll, NORTHEAST).unwrap().rectified, 0.0);
    let free = Instrument::new(seed(), Box::new(Inertia)).regular_error(&roll, NORTHEAST).unwrap();
    assert_relative_eq!(
        free.rectified,
        gyrospec::gyro::seed::regular_error(&seed(), &roll, NORTHEAST),
        max_relative = 1e-3
    );
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn the_whole_compass_agrees_with_the_mean_of_its_moment() {
    let motion = Motion::roll(&roll()).band_limited(CORNER, 2).unwrap();
    let quick = Gyrosphere { pendulous: 40.0, damper: 16.0, flow: 0.02, stiffness: 1e6, ..seed() };
    let compass = Instrument::new(quick, Box::new(Friction { force: 2.0 }));
    let said = compass.error(&motion, NORTHEAST).unwrap();
    let drive = Drive::irregular(&motion);
    let step = drive.step().unwrap();
    let plan = MonteCarlo { step, duration: 6.0 * 3600.0, settle: 2000.0, runs: 16, seed: 5 };
    let got = plan.run(&compass, &drive, NORTHEAST).unwrap();
    println!("mean {} ± {}, {} ± {}", said.rectified, said.rectified_margin, got.mean, got.mean_margin);
    println!("spread {} ± {}, {}", said.deviation, said.deviation_margin, got.variance.sqrt());
    assert!((got.mean - said.mean()).abs() < got.mean_margin + said.rectified_margin);
    let margin = got.variance_margin + 2.0 * said.deviation * said.deviation_margin;
    assert!((got.variance - said.deviation.powi(2)).abs() < margin);
}

#[test]
fn infinite_accelerations_and_endless_memories_are_refused() {
    let compass = Instrument::new(seed(), Box::new(Friction { force: 2.0 }));
    let white = compass.error(&Motion::roll(&roll()), NORTHEAST).unwrap_err();
    assert!(white.kind() == ErrorKind::OutOfRange && white.hint().unwrap().contains("band"));
    let narrow = Motion::roll(&Roll { decay: 1e-7, ..roll() }).band_limited(CORNER, 2).unwrap();
    assert_eq!(compass.error(&narrow, NORTHEAST).unwrap_err().kind(), ErrorKind::OutOfRange);
    assert!(compass.error_spectrum(&narrow, NORTHEAST, &[1.0]).is_err());
}
