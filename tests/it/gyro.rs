//! The gyrosphere family and the rotating gimbal, against simulation and closed forms.

use approx::assert_relative_eq;
use gyrospec::ErrorKind;
use gyrospec::gyro::elastic::{Compliance, Elastic, Inertia, Lag, Relaxing};
use gyrospec::gyro::gimbal::{Demodulator, Gimbal, Noise, Run, State};
use gyrospec::gyro::{Axis, Drive, Gyrosphere, Instrument, MonteCarlo, Motion, Trial, identify, seed, sweep};
use gyrospec::lti::TransferFunction;
use gyrospec::spectrum::{Hull, Roll, Sea, fit_rational};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const NORTHEAST: f64 = std::f64::consts::FRAC_PI_4;

/// A sea from 45° to starboard of the bow.
const BOW_QUARTER: f64 = std::f64::consts::FRAC_PI_4;

/// A quick compass, so that a short simulation holds many of its periods: the theory is the same.
fn quick() -> Gyrosphere {
    Gyrosphere { pendulous: 40.0, damper: 16.0, flow: 0.02, stiffness: 1e6, ..Gyrosphere::seed() }
}

fn roll() -> Roll {
    Roll::new(0.02, 0.1, 0.8).unwrap()
}

fn sea() -> Motion {
    let sea = Sea::Jonswap { height: 3.0, peak: 0.8, gamma: 3.3 };
    let omega: Vec<f64> = (1..=200).map(|k| 0.016 * f64::from(k)).collect();
    let density: Vec<f64> = omega.iter().map(|w| sea.density(*w)).collect();
    let fit = fit_rational(&omega, &density, &[1.0; 200], &[0, 1, 3]).unwrap();
    let hull = Hull::default();
    let responses = [
        (Axis::Roll, hull.roll_response(BOW_QUARTER).unwrap()),
        (Axis::Pitch, hull.pitch_response(BOW_QUARTER).unwrap()),
        (Axis::Heave, hull.heave_response(BOW_QUARTER).unwrap()),
    ];
    Motion::in_sea(&fit.shaping, &responses).unwrap()
}

fn agrees(name: &str, instrument: &Instrument, motion: &Motion) {
    let plan = MonteCarlo { step: 0.0, duration: 6.0 * 3600.0, settle: 2000.0, runs: 24, seed: 5 };
    agrees_by(name, instrument, motion, plan);
}

/// The moments against the equations of motion stepped as they stand, with which they share nothing.
fn agrees_by(name: &str, instrument: &Instrument, motion: &Motion, plan: MonteCarlo) {
    let error = instrument.error(motion, NORTHEAST).unwrap();
    let drive = Drive::irregular(motion);
    let plan = MonteCarlo { step: drive.step().unwrap(), ..plan };
    let got = plan.run(instrument, &drive, NORTHEAST).unwrap();
    println!(
        "{name}: mean {:.5}° formula {:.5}° ± {:.5}°; variance {:.4e} formula {:.4e} ± {:.1e}",
        got.mean.to_degrees(),
        error.mean().to_degrees(),
        got.mean_margin.to_degrees(),
        got.variance,
        error.deviation.powi(2),
        got.variance_margin
    );
    assert!((got.mean - error.mean()).abs() < got.mean_margin, "{name}: mean");
    assert!((got.variance - error.deviation.powi(2)).abs() < got.variance_margin, "{name}: variance");
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn every_exact_member_agrees_with_simulation() {
    let white = Motion::roll(&roll());
    let banded = white.band_limited(2.5, 2).unwrap();
    let with = |part: Box<dyn Elastic>| Instrument::new(quick(), part);
    agrees("lag, white tail", &with(Box::new(Lag)), &white);
    agrees("lag, band-limited", &with(Box::new(Lag)), &banded);
    let soft = Gyrosphere { stiffness: 60.0, lag: 0.3, lever: 0.05, ..quick() };
    agrees("inertia", &Instrument::new(soft, Box::new(Inertia)), &white);
    agrees("liquid flow", &with(Box::new(Relaxing { time: 3.0, share: 0.5 })), &white);
    let two = Compliance { meridian: Some((2e6, 1.0)), vertical: None };
    agrees("two axes", &with(Box::new(two)), &banded);
    let three = Compliance { meridian: Some((2e6, 1.0)), vertical: Some((1e4, 0.5)) };
    agrees("roll, pitch, heave; three axes", &with(Box::new(three)), &sea());
    let mut under_way = with(Box::new(Lag));
    under_way.speed = 10.0;
    agrees("under way", &under_way, &banded);
}

#[test]
fn a_simulation_starts_as_it_goes_on() {
    // a roll that would take hours to swing up from rest
    let motion = Motion::roll(&Roll::new(0.02, 1e-4, 0.8).unwrap()).band_limited(2.5, 2).unwrap();
    let plan = MonteCarlo { step: 0.0, duration: 1000.0, settle: 2000.0, runs: 150, seed: 7 };
    agrees_by("narrow roll", &Instrument::new(quick(), Box::new(Lag)), &motion, plan);
}

#[test]
fn the_seed_compass_itself_agrees_with_simulation() {
    let (sphere, roll, heading) = seed::example_3_1();
    let compass = Instrument::new(sphere, Box::new(Lag));
    let motion = Motion::roll(&roll);
    let error = compass.error(&motion, heading).unwrap();
    assert_relative_eq!(
        error.rectified,
        seed::irregular_error(&sphere, &roll, heading).unwrap(),
        max_relative = 1e-9
    );
    let plan = MonteCarlo { step: 0.0, duration: 86400.0, settle: 20000.0, runs: 12, seed: 3 };
    agrees_by("the seed", &compass, &motion, plan);
}

#[test]
fn the_spectrum_of_the_error_adds_up_to_its_variance() {
    let compass = Instrument::new(quick(), Box::new(Lag));
    let motion = Motion::roll(&roll()).band_limited(2.5, 2).unwrap();
    let error = compass.error(&motion, NORTHEAST).unwrap();
    let omega: Vec<f64> = (0..6000).map(|k| 1e-6 * 10f64.powf(8.0 * f64::from(k) / 5999.0)).collect();
    let density = compass.error_spectrum(&motion, NORTHEAST, &omega).unwrap();
    let area = |part: &dyn Fn(&(f64, f64)) -> f64| {
        let inner: f64 = (1..omega.len())
            .map(|k| 0.5 * (part(&density[k]) + part(&density[k - 1])) * (omega[k] - omega[k - 1]))
            .sum();
        (inner + part(&density[0]) * omega[0]) / std::f64::consts::PI
    };
    assert_relative_eq!(area(&|d| d.0), error.deviation_linear.powi(2), max_relative = 1e-3);
    assert_relative_eq!(area(&|d| d.1), error.deviation_quadratic.powi(2), max_relative = 1e-3);
}

#[test]
fn equal_compliance_along_both_axes_cancels_and_pitch_opposes_roll() {
    let sphere = Gyrosphere::seed();
    let motion = Motion::roll(&roll());
    let both = Compliance { meridian: Some((sphere.stiffness, sphere.lag)), vertical: None };
    let one = Instrument::new(sphere, Box::new(Lag)).rectified_error(&motion, NORTHEAST).unwrap();
    let none = Instrument::new(sphere, Box::new(both)).rectified_error(&motion, NORTHEAST).unwrap();
    assert!(none.abs() < 1e-12 * one.abs());
    let pitching = Motion::filtered(Axis::Pitch, &roll().shaping()).unwrap();
    let opposite = Instrument::new(sphere, Box::new(Lag)).rectified_error(&pitching, NORTHEAST).unwrap();
    assert_relative_eq!(opposite, -one, max_relative = 1e-12);
}

#[test]
fn inertia_and_small_parts_have_their_limits() {
    let sphere = Gyrosphere::seed();
    let motion = Motion::roll(&roll()).band_limited(2.5, 2).unwrap();
    let mean =
        |part: Box<dyn Elastic>| Instrument::new(sphere, part).rectified_error(&motion, NORTHEAST).unwrap();
    let lag = mean(Box::new(Lag));
    assert_relative_eq!(mean(Box::new(Inertia)), lag, max_relative = 1e-3);
    assert_relative_eq!(mean(Box::new(Relaxing { time: 3.0, share: 1e-9 })), lag, max_relative = 1e-8);
}

#[test]
fn infinite_means_are_refused() {
    let sphere = Gyrosphere { lag: 0.0, ..Gyrosphere::seed() };
    assert_eq!(seed::rectified_moment(&roll(), sphere.lag).unwrap_err().kind(), ErrorKind::OutOfRange);
    let first_order = TransferFunction::new(&[1.0], &[1.0, 1.0]).unwrap();
    let rough = Motion::filtered(Axis::Roll, &first_order).unwrap();
    let compass = Instrument::new(Gyrosphere::seed(), Box::new(Lag));
    assert_eq!(compass.error(&rough, 0.7).unwrap_err().kind(), ErrorKind::OutOfRange);
}

#[test]
fn a_sweep_says_what_each_case_says_alone() {
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    let cases: Vec<_> = (0..5000)
        .map(|_| {
            let sphere = Gyrosphere { lag: rng.random_range(0.05..5.0), ..Gyrosphere::seed() };
            let roll = Roll::new(
                rng.random_range(1e-4..0.1),
                rng.random_range(0.01..0.5),
                rng.random_range(0.2..2.0),
            );
            (sphere, roll.unwrap(), rng.random_range(0.0..6.2))
        })
        .collect();
    for ((sphere, roll, heading), swept) in cases.iter().zip(sweep(&cases).unwrap()) {
        let closed = seed::irregular_error_closed(sphere, roll, *heading);
        // beyond 45° the linear theory gives no number
        match swept {
            Ok(e) => assert_relative_eq!(e, closed, max_relative = 1e-11),
            Err(e) => assert!(closed.abs() > NORTHEAST && e.kind() == ErrorKind::OutOfRange, "{e}"),
        }
    }
}

fn made_trials(count: usize, noise: f64, seed_number: u64) -> Vec<Trial> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed_number);
    (0..count)
        .map(|_| {
            let heading = rng.random_range(0.0..std::f64::consts::TAU);
            let (amplitude, frequency) = (rng.random_range(0.1..0.4), rng.random_range(0.4..1.6));
            let latitude: f64 = rng.random_range(0.0..1.1);
            let sphere = Gyrosphere { lever: amplitude, latitude, ..Gyrosphere::seed() };
            let exact = seed::regular_error(&sphere, &seed::Regular { amplitude: 1.0, frequency }, heading);
            let xi: f64 = StandardNormal.sample(&mut rng);
            Trial { heading, amplitude, frequency, latitude, error: exact + noise * xi }
        })
        .collect()
}

#[test]
fn six_thousand_trials_leave_the_noise_and_intervals_cover() {
    let noise = 0.02f64.to_radians();
    let sphere = Gyrosphere::seed();
    let found = identify(&made_trials(6000, noise, 1), &sphere).unwrap();
    assert_relative_eq!(found.residual, noise, max_relative = 0.03);
    let (mut lag, mut stiffness) = (0, 0);
    for table in 0..1000 {
        let f = identify(&made_trials(60, noise, 100 + table), &sphere).unwrap();
        lag += i32::from(f.lag.low <= sphere.lag && sphere.lag <= f.lag.high);
        stiffness += i32::from(f.stiffness.low <= sphere.stiffness && sphere.stiffness <= f.stiffness.high);
    }
    println!("coverage of 95 % intervals over 1000 tables: T {lag}, C0 {stiffness}");
    // 95 % of 1000 within three standard deviations, 0.7 % each
    assert!((930..=970).contains(&lag) && (930..=970).contains(&stiffness), "{lag} {stiffness}");
}

#[test]
fn one_frequency_does_not_tell_the_lag() {
    let mut trials = made_trials(100, 1e-5, 2);
    let sphere = Gyrosphere::seed();
    for t in &mut trials {
        t.frequency = 0.9;
        let here = Gyrosphere { lever: t.amplitude, latitude: t.latitude, ..sphere };
        t.error = seed::regular_error(&here, &seed::Regular { amplitude: 1.0, frequency: 0.9 }, t.heading);
    }
    if let Ok(found) = identify(&trials, &sphere) {
        assert!(found.lag.high - found.lag.low > 1.0, "{found:?}");
    }
}

#[test]
fn the_gimbal_keeps_its_energy_and_swings_at_its_frequencies() {
    let gimbal = Gimbal { damping: [0.0; 2], ..Gimbal::example() };
    let mut s = State { alpha: 1e-3, beta: -2e-3, alpha_rate: 0.1, beta_rate: 0.0 };
    let before = gimbal.energy(&s);
    for _ in 0..200_000 {
        s = gimbal.free_step(s, 2e-5);
    }
    assert_relative_eq!(gimbal.energy(&s), before, max_relative = 1e-8);
    for w in gimbal.free_frequencies().unwrap() {
        let [a, _, b, _, c] = gimbal.characteristic();
        assert!((a * w.powi(4) - b * w * w + c).abs() < 1e-12 * c);
    }
    // a tuned spring brings one of them to Ω
    for c in gimbal.tuned_springs() {
        let tuned = Gimbal { springs: [c, c], ..gimbal };
        let [a, _, b, _, e] = tuned.characteristic();
        let w = tuned.speed;
        assert!((a * w.powi(4) - b * w * w + e).abs() < 1e-9 * e.abs().max(b * w * w));
    }
}

#[test]
fn constant_rates_come_back_from_the_demodulator() {
    let gimbal = Gimbal::example();
    let run = Run { step: 1e-4, duration: 12.0, noise: [0.0; 2], seed: 0 };
    for (theta, psi) in [(0.01, 0.0), (0.0, 0.01), (-0.004, 0.007)] {
        let samples = gimbal.simulate(State::default(), &run, |_| ([theta, psi], [0.0; 2])).unwrap();
        let read = Demodulator::new(&gimbal, 2.0).unwrap().rates(&samples);
        let last = read[read.len() - 1];
        assert!((last.0 - theta).abs() < 3e-5 && (last.1 - psi).abs() < 3e-5, "{last:?}");
        // the amplitude at Ω is |a|·√(Θ′² + Ψ′²)
        let tail = &samples[samples.len() - 5000..];
        let peak = tail.iter().map(|s| s.alpha.abs()).fold(0.0, f64::max);
        assert_relative_eq!(peak, gimbal.scale_factor(0.0).norm() * theta.hypot(psi), max_relative = 1e-2);
    }
}

#[test]
fn noise_equivalent_rates_agree_with_simulation() {
    let gimbal = Gimbal { damping: [2e-4, 2e-4], ..Gimbal::example() };
    let torque = [1e-16, 2e-16];
    let said = gimbal.noise_equivalent(&Noise { torque, base: None }, 5.0).unwrap();
    let run = Run { step: 4e-4, duration: 600.0, noise: torque, seed: 6 };
    let samples = gimbal.simulate(State::default(), &run, |_| ([0.0; 2], [0.0; 2])).unwrap();
    let read = Demodulator::new(&gimbal, 5.0).unwrap().rates(&samples);
    let kept = &read[read.len() / 50..];
    let square: f64 = kept.iter().map(|r| 0.5 * (r.0 * r.0 + r.1 * r.1)).sum::<f64>() / kept.len() as f64;
    println!("noise-equivalent rate: formula {:.4e}, simulated {:.4e}", said.torque, square.sqrt());
    // 600 s × 5 rad/s of band on two axes: some 3000 independent values, 99 % within 5 % of the deviation
    assert_relative_eq!(square.sqrt(), said.torque, max_relative = 0.06);
}

#[test]
fn the_compass_swings_and_settles_as_its_numbers_say() {
    let sphere = Gyrosphere::seed();
    let free = sphere.free_motion().unwrap();
    assert_relative_eq!(free.undamped_period / 60.0, 84.4, epsilon = 0.1);
    assert_relative_eq!(free.damped_period / 60.0, 97.9, epsilon = 0.1);
    // a tuned compass is thrown by just the change of its steady error
    let tuned = Gyrosphere { damper: 1e-9, ..sphere };
    let stiff = tuned.gravity * tuned.momentum
        / (gyrospec::gyro::EARTH_RADIUS * tuned.earth_rate * tuned.latitude.cos());
    let tuned = Gyrosphere { pendulous: stiff, ..tuned };
    let thrown = tuned.ballistic(5.0, 60.0, 2).unwrap();
    assert!(thrown[0].1.abs() < 1e-12);
    let off = Gyrosphere { pendulous: 0.8 * stiff, ..tuned }.ballistic(5.0, 60.0, 2).unwrap();
    assert!(off[0].1.abs() > 1e-4);
}
