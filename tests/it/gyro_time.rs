//! The built-in gyrosphere models simulated in time, against the exact formulas.

use approx::assert_relative_eq;
use gyrospec::gyro::elastic::{Elastic, Lag, Relaxing};
use gyrospec::gyro::{Axis, Gyrosphere, Instrument, Motion};
use gyrospec::lti::Discrete;
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::simulate::{Options, Simulator};
use gyrospec::spectrum::Roll;
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// The numbers of the built-in models.
fn sphere() -> Gyrosphere {
    Gyrosphere { earth_rate: 7.2921e-5, ..Gyrosphere::seed() }
}

fn channel(name: &str, unit: &str, time: Vec<f64>, values: Vec<f64>) -> Channel {
    Channel::new(name, Unit::parse(unit).unwrap(), time, values)
}

/// Runs a built-in model from its rest with a given start of the heading error; α by minutes.
fn run(name: &str, inputs: Vec<Channel>, start: f64) -> Vec<f64> {
    let end = inputs[0].time[inputs[0].time.len() - 1];
    let minutes: Vec<f64> = (0..=(end / 60.0) as usize).map(|k| 60.0 * k as f64).collect();
    let count = minutes.len();
    let mut channels = inputs;
    channels.push(channel("alpha", "deg", minutes, vec![0.0; count]));
    let model = Model::builtin(name).unwrap();
    let recording = Recording::from_channels("made", channels).unwrap();
    let simulator =
        Simulator::new(&model, &recording, &Options { tolerance: 1e-4, ..Options::default() }).unwrap();
    let s = sphere();
    // β* = −λ* = HU sin φ/(lP − C)
    let tilt = s.momentum * s.earth_rate * s.latitude.sin() / (s.pendulous - s.damper);
    let initials: Vec<f64> = model
        .states
        .iter()
        .map(|state| match state.name.as_str() {
            "azimuth" => start,
            "beta" => tilt,
            "lambda" => -tilt,
            _ => 0.0,
        })
        .collect();
    simulator.run(&simulator.parameters(), &initials).unwrap().outputs.remove(0)
}

#[test]
fn a_day_at_ten_hertz_has_the_mean_of_the_formula() {
    let heading = 45f64.to_radians();
    let motion = Motion::roll(&Roll::new(0.03, 0.1, 0.8).unwrap()).band_limited(2.5, 2).unwrap();
    let acceleration = motion.derivative(Axis::Roll, 2).unwrap();
    let (step, count) = (0.1, 864_001);
    let mut discrete = Discrete::new(&motion.system().a, &motion.system().b, step);
    let mut rng = ChaCha8Rng::seed_from_u64(12);
    let mut z = vec![0.0; motion.system().order()];
    let mut signal = Vec::with_capacity(count);
    for _ in 0..2000 {
        discrete.advance(&mut z, &mut rng);
    }
    for _ in 0..count {
        signal.push(acceleration.state.iter().zip(&z).map(|(c, z)| c * z).sum());
        discrete.advance(&mut z, &mut rng);
    }
    let time: Vec<f64> = (0..count).map(|k| step * k as f64).collect();
    let steady = channel("heading", "deg", vec![0.0, 1e5], vec![heading; 2]);
    let members: [(&str, Box<dyn Elastic>); 2] =
        [("gyrosphere", Box::new(Lag)), ("gyrosphere-flow", Box::new(Relaxing { time: 3.0, share: 0.2 }))];
    for (name, part) in members {
        let exact = Instrument::new(sphere(), part);
        let error = exact.error(&motion, heading).unwrap();
        let inputs = vec![channel("roll_acc", "rad/s^2", time.clone(), signal.clone()), steady.clone()];
        let alpha = run(name, inputs, error.mean());
        let mean = alpha.iter().sum::<f64>() / alpha.len() as f64;
        // the variance of a mean over the time T is S(0)/T; straight lines between samples cost 0.2 %
        let (linear, quadratic) = exact.error_spectrum(&motion, heading, &[1e-7]).unwrap()[0];
        let margin = 2.58 * ((linear + quadratic) / 86400.0).sqrt() + 2e-3 * error.mean().abs();
        println!(
            "{name}: simulated {:.4}°, formula {:.4}° ± {:.4}°",
            mean.to_degrees(),
            error.mean().to_degrees(),
            margin.to_degrees()
        );
        assert!((mean - error.mean()).abs() < margin, "{name}");
    }
}

#[test]
fn a_ship_under_way_has_its_steady_error_and_its_ballistic_deviation() {
    let s = sphere();
    let (v0, v1) = (0.0, 10.0);
    let time: Vec<f64> = (0..=8640).map(|k| 10.0 * f64::from(k)).collect();
    let still = |name: &str, unit: &str| channel(name, unit, time.clone(), vec![0.0; time.len()]);
    let values = time.iter().map(|t| if *t <= 3600.0 { v0 } else { v1 }).collect();
    let speed = channel("speed", "kn", time.clone(), values);
    let inputs = vec![speed, still("roll_acc", "rad/s^2"), still("heading", "deg")];
    let alpha = run("gyrosphere-under-way", inputs, 0.0);
    let steady = v1 / (gyrospec::gyro::EARTH_RADIUS * s.earth_rate * s.latitude.cos());
    assert!(alpha[59].abs() < 1e-6);
    assert_relative_eq!(alpha[alpha.len() - 1], steady, max_relative = 1e-3);
    let thrown = s.ballistic(v1 - v0, 60.0, 600).unwrap();
    for k in [2usize, 20, 60, 120] {
        assert!((alpha[60 + k] - steady - thrown[k].1).abs() < 2e-4, "{k}");
    }
}
