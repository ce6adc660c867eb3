//! The distribution of the heading's error, against simulation in time, which shares nothing with its theory.

use crate::roll_error::asked_json;
use gyrospec::gyro::elastic::{Compliance, Elastic, Inertia, Lag};
use gyrospec::gyro::{Axis, Drive, Gyrosphere, Instrument, MonteCarlo, Motion, Shape};
use gyrospec::lti::TransferFunction;
use gyrospec::spectrum::Roll;

const NORTHEAST: f64 = std::f64::consts::FRAC_PI_4;

/// A quick and soft compass, still far slower than the roll: skewed, since it adds up few groups of waves, and moved by
/// their products more than by its swing.
fn quick() -> Gyrosphere {
    Gyrosphere { pendulous: 40.0, damper: 16.0, flow: 0.02, stiffness: 2e4, ..Gyrosphere::seed() }
}

/// Percentiles by theory within the 99 % intervals of the simulation's; the skewness that the theory says.
fn agrees(name: &str, compass: &Instrument, motion: &Motion) -> f64 {
    let error = compass.error(motion, NORTHEAST).unwrap();
    let shape = compass.shape(motion, NORTHEAST, &error).unwrap().unwrap();
    let drive = Drive::irregular(motion);
    let plan = MonteCarlo {
        step: drive.step().unwrap(),
        duration: 6.0 * 3600.0,
        settle: 2000.0,
        runs: 40,
        seed: 11,
    };
    let simulated = plan.run(compass, &drive, NORTHEAST).unwrap();
    println!("{name}: skewness {:+.3}, excess {:+.3}", shape.skewness, shape.excess);
    let mut gaussian_fails = false;
    for ((told, (part, z)), q) in shape.percentiles(&error).iter().zip(Shape::TOLD).zip(simulated.percentiles)
    {
        let gaussian = error.mean() + z * error.deviation;
        println!(
            "    P{:.0}: {:.5}°, simulated {:.5}° ({:.5} … {:.5}), a Gaussian's {:.5}°",
            100.0 * part,
            told.to_degrees(),
            q.value.to_degrees(),
            q.low.to_degrees(),
            q.high.to_degrees(),
            gaussian.to_degrees()
        );
        assert!(q.low < *told && *told < q.high, "{name}: P{:.0}", 100.0 * part);
        gaussian_fails |= gaussian < q.low || gaussian > q.high;
    }
    assert!(gaussian_fails || shape.skewness.abs() < 0.15, "{name}: nothing would show");
    shape.skewness
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn percentiles_are_those_of_the_simulation() {
    let white = Motion::roll(&Roll::new(0.02, 0.05, 0.8).unwrap());
    let banded = white.band_limited(2.5, 2).unwrap();
    let with = |part: Box<dyn Elastic>| Instrument::new(quick(), part);
    let skewness = agrees("lag, band-limited", &with(Box::new(Lag)), &banded);
    // the products push one way, that of the mean
    assert!(skewness < -0.05, "{skewness}");
    agrees("lag, white tail", &with(Box::new(Lag)), &white);
    agrees("inertia", &with(Box::new(Inertia)), &banded);
    // heave and a vertical compliance push other rows too
    let heave = TransferFunction::new(&[0.3, 0.0, 0.0], &[1.0, 0.8, 1.6, 0.6, 0.4]).unwrap();
    let both = Motion::independent(&[banded, Motion::filtered(Axis::Heave, &heave).unwrap()]).unwrap();
    let both = both.band_limited(2.5, 2).unwrap();
    let three = Compliance { meridian: Some((2e6, 1.0)), vertical: Some((1e4, 0.5)) };
    agrees("roll and heave, three axes", &with(Box::new(three)), &both);
}

#[test]
fn percentiles_are_told_where_they_are_known() {
    let told = asked_json(&["--irregular=4deg,0.06,0.65", "--simulate=2"]);
    let row = &told["rows"][0];
    let p = |name: &str| row["percentiles_deg"][name].as_f64().unwrap();
    let (mean, spread) = (row["mean_deg"].as_f64().unwrap(), row["spread_deg"].as_f64().unwrap());
    assert!(p("p5") < p("p50") && p("p50") < p("p95") && p("p95") < p("p99"));
    assert!(
        (p("p50") - mean).abs() < 0.1 * spread && (p("p95") - p("p5") - 3.29 * spread).abs() < 0.1 * spread
    );
    assert!(row["simulated"]["percentiles_deg"]["p50"].is_number());
    assert!(told["note"].as_str().unwrap().contains("(P95)"));
    // a steady sine has a steady product, and a part that is not linear no kernel
    for words in [&["--regular=5deg,0.7"][..], &["--friction=2N", "--band=2.5"]] {
        assert!(asked_json(words)["rows"][0]["percentiles_deg"].is_null());
    }
}
