//! The speed error of a gyrocompass beside a reference: what turns with the heading is felt from its own zero.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const CONSTANT: &str = r#"
    name = "reference and a constant"
    [inputs]
    ref = { unit = "deg" }
    [parameters]
    b = { value = 0.0, unit = "deg", fit = true }
    [outputs]
    gyro = { equals = "ref + b", unit = "deg" }
"#;
/// Radius of the earth times its rate, m/s, and the latitude.
const EQUATOR: f64 = 6.371e6 * 7.2921e-5;
const LATITUDE: f64 = 1.047;
/// Seconds between rows, rows on a course, and rows at a speed.
const STEP: f64 = 2.0;
const LEG: usize = 100;
const SPEED: usize = 250;

/// What is said of an hour and 40 minutes of courses between two bounds, deg, at 2 to 9 m/s, the compass 0.3° off
/// and, where it feels the speed, by v cos K/(R U cos φ + v sin K).
fn found(courses: [f64; 2], feels: bool) -> Answer {
    let mut rng = ChaCha8Rng::seed_from_u64(41);
    let (mut heading, mut speed) = (courses[0].to_radians(), 5.0);
    let (mut course, mut ordered) = (heading, speed);
    let (mut shown, mut log, mut compass) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..3000usize {
        if i.is_multiple_of(LEG) {
            course = rng.random_range(courses[0]..courses[1]).to_radians();
        }
        if i.is_multiple_of(SPEED) {
            ordered = rng.random_range(2.0..9.0);
        }
        heading += (course - heading).clamp(-0.03, 0.03);
        speed += 0.05 * (ordered - speed);
        let error = speed * heading.cos() / (EQUATOR * LATITUDE.cos() + speed * heading.sin());
        let noise: f64 = StandardNormal.sample(&mut rng);
        let error = if feels { error } else { 0.0 };
        shown.push(heading);
        log.push(speed);
        compass.push(heading + error + (0.3 + 0.04 * noise).to_radians());
    }
    let time: Vec<f64> = (0..shown.len()).map(|i| STEP * i as f64).collect();
    let channel = |name: &str, unit: &str, values: Vec<f64>| {
        Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values)
    };
    let channels =
        vec![channel("ref", "deg", shown), channel("gyro", "deg", compass), channel("speed", "m/s", log)];
    let recording = Recording::from_channels("voyage", channels).unwrap();
    diagnosed(&Model::parse(CONSTANT).unwrap(), recording).answer
}

/// To first order in v the error is v cos K/(R U cos φ), and the constant stays 0.3°.
fn is_the_speed_error(answer: &Answer) {
    let [error] = &answer.findings[..] else { panic!("{}", answer.says) };
    assert_eq!(
        (error.code.as_str(), error.site.name.as_str()),
        ("output-cross-axis", "gyro"),
        "{}",
        answer.says
    );
    assert!(matches!(answer.verdict, Verdict::Named | Verdict::Tie), "{}", answer.says);
    let factor = error.parameters[0].value;
    let wanted = (1.0 / (EQUATOR * LATITUDE.cos())).to_degrees();
    assert!((factor - wanted).abs() < 0.02 * wanted, "{factor} deg s/m for {wanted}: {}", answer.says);
    let constant = answer.parameters.iter().find(|p| p.name == "b").unwrap();
    assert!((constant.after - 0.3).abs() < 0.02, "{}: {}", constant.after, answer.says);
    let proof = &answer.proof[0];
    assert!(proof.holdout_after < 0.05f64, "{}", answer.says);
}

#[test]
fn on_northerly_courses_it_is_no_scale() {
    is_the_speed_error(&found([30.0, 150.0], true));
}

#[test]
fn on_all_courses_it_is_one_law() {
    is_the_speed_error(&found([0.0, 360.0], true));
}

#[test]
fn a_compass_without_it_lacks_nothing() {
    let answer = found([0.0, 360.0], false);
    assert_eq!(answer.verdict, Verdict::NothingMissing, "{}", answer.says);
}
