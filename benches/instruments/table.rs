//! The tables.

use gyrospec::Result;
use gyrospec::gyro::elastic::{
    Backlash, Compliance, Elastic, Friction, Inertia, Lag, Pendulum, Relaxing, Slosh, together,
};
use gyrospec::gyro::seed::Regular;
use gyrospec::gyro::strapdown::{Shaken, Vibration, coning, sculling};
use gyrospec::gyro::{Drive, Gyrosphere, HeadingError, Instrument, MonteCarlo, Motion};
use gyrospec::spectrum::Roll;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// All tables.
pub fn printed() -> Result<()> {
    println!(
        "instrument, motion: mean, spread (±99 % of a simulation of days, relative difference), density of α at ω = 0"
    );
    for part in parts()? {
        instrument(part.as_ref())?;
    }
    vibration()
}

fn parts() -> Result<Vec<Box<dyn Elastic>>> {
    let flow = Relaxing { time: 4.0, share: 0.3 };
    let swing = Pendulum { period: 20.0, damping: 0.3, coupling: 0.8, lag: 1.0 };
    let slosh = Slosh { frequency: 1.5, damping: 0.2, share: 2e-5 };
    let meridian = Compliance { meridian: Some((2e5, 1.0)), vertical: None };
    let all = together(&[Box::new(Inertia), Box::new(flow), Box::new(swing), Box::new(slosh)])?;
    let rubbed = together(&[Box::new(Friction { force: 0.3 }), Box::new(flow)])?;
    Ok(vec![
        Box::new(Lag),
        Box::new(Inertia),
        Box::new(flow),
        Box::new(slosh),
        Box::new(meridian),
        Box::new(swing),
        all,
        Box::new(Friction { force: 0.3 }),
        Box::new(Backlash { gap: 3e-6 }),
        rubbed,
    ])
}

/// One instrument on regular and on irregular roll, on north-east.
fn instrument(part: &dyn Elastic) -> Result<()> {
    // soft against roll, so that its modest angles tell
    let sphere = Gyrosphere { lever: 3.0, ..Gyrosphere::seed() };
    let compass = Instrument::new(sphere, part.boxed());
    let sine = Regular { amplitude: 0.05, frequency: 0.7 };
    let motion = Motion::roll(&Roll::new(2e-3, 0.1, 0.8)?).band_limited(2.5, 2)?;
    let drive = Drive::regular(&sine)?;
    line(part.name(), "regular roll", &compass, (&drive, compass.regular_error(&sine, FRAC_PI_4)?), None)?;
    let density = compass.system(&motion, FRAC_PI_4)?.densities(0, &[0.0])?[0];
    let drive = Drive::irregular(&motion);
    let error = compass.error(&motion, FRAC_PI_4)?;
    line(part.name(), "irregular roll", &compass, (&drive, error), Some(density.0 + density.1))
}

fn line(
    name: &str,
    motion: &str,
    compass: &Instrument,
    (drive, error): (&Drive, HeadingError),
    density: Option<f64>,
) -> Result<()> {
    let plan = MonteCarlo { step: drive.step()?, duration: 43_200.0, settle: 21_600.0, runs: 6, seed: 3 };
    let days = plan.run(compass, drive, FRAC_PI_4)?;
    let degrees = |x: f64| x.to_degrees();
    let off = |a: f64, b: f64| 100.0 * (a / b - 1.0);
    let spread = days.variance.max(0.0).sqrt();
    println!(
        "{name}, {motion}: mean {:.5}° (within {:.5}°) {:.5}° ± {:.5}° {:+.2} %; spread {:.5}° {:.5}° ± {:.5}° {:+.1} %; {}",
        degrees(error.mean()),
        degrees(error.rectified_margin),
        degrees(days.mean),
        degrees(days.mean_margin),
        off(error.mean(), days.mean),
        degrees(error.deviation),
        degrees(spread),
        degrees(0.5 * days.variance_margin / spread.max(1e-12)),
        off(error.deviation, spread),
        density.map_or("no spectrum of a sine".into(), |d| format!("{d:.4e} rad²·s")),
    );
    Ok(())
}

/// Pure coning and sculling, and those of a wide resonance, beside the same shaking in time.
fn vibration() -> Result<()> {
    let at = |deviation: f64, phase: f64, damping: f64| {
        Some(Vibration { deviation, phase, frequency: 200.0, damping })
    };
    println!("coning ½⟨φ × φ′⟩ rad/s and sculling ⟨φ × a⟩ m/s²");
    // two sines of amplitudes √2 σ in quadrature: ½ a b ω, and ½ a b in phase
    let narrow = Shaken {
        angular: [at(1e-3, 0.0, 1e-6), at(1e-3, -FRAC_PI_2, 1e-6), None],
        linear: [None; 3],
        coherence: 1.0,
    };
    let (got, pure) = (coning(&narrow)?[2], 0.5 * 2.0 * 1e-6 * 200.0);
    println!("coning, one frequency: {got:.9e}, ½ a b ω {pure:.9e}, {:+.1e}", got / pure - 1.0);
    let along = Shaken {
        angular: [at(1e-3, 0.0, 1e-6), None, None],
        linear: [None, at(2.0, 0.0, 1e-6), None],
        coherence: 1.0,
    };
    let (got, pure) = (sculling(&along)?[2], 0.5 * 2.0 * 1e-3 * 2.0);
    println!("sculling, one frequency: {got:.9e}, ½ a b {pure:.9e}, {:+.1e}", got / pure - 1.0);
    let wide = Shaken {
        angular: [at(1e-3, 0.0, 0.05), at(1e-3, -1.2, 0.05), None],
        linear: [None; 3],
        coherence: 1.0,
    };
    let (mean, margin) = shaken_in_time(-1.2, 0.05);
    let got = coning(&wide)?[2];
    println!(
        "coning, ζ = 0.05: {got:.6e}, in time {mean:.6e} ± {margin:.1e}, {:+.2} %",
        100.0 * (got / mean - 1.0)
    );
    Ok(())
}

/// ½⟨φ_x φ̇_y − φ_y φ̇_x⟩ with its 99 % margin, of one resonance whose φ_y stands behind an all-pass (c − s)/(c + s):
/// ẏ = −c y + c φ − φ̇ follows from it. Heun's rule, blocks of 20 s.
fn shaken_in_time(phase: f64, damping: f64) -> (f64, f64) {
    let (w, dt, steps, blocks) = (200.0f64, 2e-5, 1_000_000, 16);
    let c = w / (0.5 * phase.abs()).tan();
    let kick = 1e-3 * (4.0 * damping * w.powi(3)).sqrt() / f64::sqrt(dt);
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let rates =
        |y: [f64; 3], n: f64| [y[1], n - 2.0 * damping * w * y[1] - w * w * y[0], c * (y[0] - y[2]) - y[1]];
    let (mut y, mut means) = ([0.0; 3], Vec::new());
    for block in 0..=blocks {
        let mut sum = 0.0;
        for _ in 0..steps {
            let n = kick * ((0..12).map(|_| rng.random_range(0.0..1.0)).sum::<f64>() - 6.0);
            let a = rates(y, n);
            let b = rates([0, 1, 2].map(|i| y[i] + dt * a[i]), n);
            y = [0, 1, 2].map(|i| y[i] + 0.5 * dt * (a[i] + b[i]));
            sum += 0.5 * (y[0] * rates(y, 0.0)[2] - y[2] * y[1]);
        }
        if block > 0 {
            means.push(sum / f64::from(steps));
        }
    }
    let n = f64::from(blocks);
    let mean = means.iter().sum::<f64>() / n;
    let variance = means.iter().map(|m| (m - mean).powi(2)).sum::<f64>() / (n - 1.0);
    // Student's t of 15 degrees at 99 %
    (mean, 2.947 * (variance / n).sqrt())
}
