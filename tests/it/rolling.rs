//! What programs call and what the command prints are the same figures.

use crate::roll_error::{asked_json, command};
use gyrospec::estimate::fit::Silent;
use gyrospec::gyro::elastic::{Compliance, Friction, Inertia};
use gyrospec::gyro::{Axis, seed};
use gyrospec::record::Recording;
use gyrospec::report::rolling::json;
use gyrospec::rolling::{
    Against, Compass, Days, Excitation, Obstacle, Recorded, Request, Source, Waves, analyse,
};
use gyrospec::spectrum::{Hull, Roll, Sea};
use serde_json::Value;

const NORTHEAST: f64 = std::f64::consts::FRAC_PI_4;

fn told(request: &Request) -> Value {
    serde_json::from_str(&json(&request.table(&Silent).unwrap()).unwrap()).unwrap()
}

fn example() -> Request {
    Request {
        compass: Compass::paper(),
        excitation: Excitation::irregular(seed::example_3_1().1),
        against: Against::Heading(vec![NORTHEAST]),
        days: None,
    }
}

#[test]
fn a_request_tells_what_the_command_tells() {
    let mut compass = Compass::parse("[parameters]\nT = 0.6\n").unwrap();
    let meridian = Some((2e5, 1.0));
    compass.part = Box::new(Compliance { meridian, vertical: Some((1e4, 0.5)) });
    compass.speed = 6.0;
    let sea = Sea::Jonswap { height: 3.0, peak: std::f64::consts::TAU / 8.0, gamma: 3.3 };
    let waves = Waves {
        sea,
        from: 60f64.to_radians(),
        speed: 6.0,
        spread: None,
        hull: Hull::default(),
        also: vec![Axis::Pitch, Axis::Heave],
    };
    let excitation = Excitation { source: Source::Sea(waves), band: Some(4.0) };
    let request = Request { compass, excitation, ..example() };
    let words = [
        "--meridian=2e5,1",
        "--vertical=1e4,0.5",
        "--speed=6",
        "--sea=jonswap",
        "--sea-from=60",
        "--also=pitch,heave",
        "--band=4",
    ];
    let (code, text, message) = command(
        "compass.toml",
        "[parameters]\nT = 0.6\n",
        &[&words[..], &["--heading=45", "--json"]].concat(),
    );
    assert_eq!(code, 0, "{message}");
    assert_eq!(told(&request), serde_json::from_str::<Value>(&text).unwrap());
    let days = Some(Days { count: 2, seed: 9 });
    let excitation = Excitation { band: Some(2.5), ..example().excitation };
    let request = Request { excitation, days, ..example() };
    assert_eq!(told(&request), asked_json(&["--band=2.5", "--simulate=2", "--seed=9"]));
}

#[test]
fn a_recorded_roll_tells_what_the_command_tells() {
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/roll.csv");
    let analysis = analyse(&Recording::read(&file).unwrap(), "roll").unwrap();
    let compass = Compass { part: Box::new(Inertia), ..Compass::paper() };
    let recorded =
        Recorded { compass: compass.clone(), analysis, band: None, headings: vec![NORTHEAST], days: None };
    let table = recorded.table(&Silent).unwrap();
    assert!(table.is_by_spectrum() && table.rows[0].measured == Some(table.mean(&table.rows[0])));
    let told: Value = serde_json::from_str(&json(&table).unwrap()).unwrap();
    assert_eq!(told, asked_json(&[file.to_str().unwrap(), "--inertia"]));
    assert!(analyse(&Recording::read(&file).unwrap(), "pitch").is_err());
    let rubbed = Compass { part: Box::new(Friction { force: 1.0 }), ..compass };
    let followed = Recorded { compass: rubbed, ..recorded }.table(&Silent).unwrap();
    assert!(followed.rows[0].error.rectified_margin > 0.0 && !followed.is_by_spectrum());
}

#[test]
fn what_stands_against_a_request_is_told_before_the_work() {
    let rubbed = Compass { part: Box::new(Friction { force: 1.0 }), ..Compass::paper() };
    let white = Request { compass: rubbed.clone(), ..example() };
    assert_eq!(
        white.prepare().unwrap().obstacle().unwrap(),
        Some(Obstacle::WhiteTail("dry friction".into()))
    );
    assert!(white.table(&Silent).unwrap_err().hint().unwrap().contains("limit the band"));
    let far = Excitation { band: Some(9000.0), ..example().excitation };
    let long = Request { compass: rubbed, excitation: far, ..example() };
    let Some(Obstacle::TooLong { band: Some((band, effort)), .. }) =
        long.prepare().unwrap().obstacle().unwrap()
    else {
        panic!("9000 rad/s are affordable")
    };
    assert!(band < 9000.0 && effort.check("friction").is_ok());
    let compass = Compass { part: Box::new(Inertia), ..Compass::paper() };
    let beyond = Request { compass, days: Some(Days { count: 2, seed: 1 }), ..example() };
    assert_eq!(beyond.prepare().unwrap().obstacle().unwrap(), Some(Obstacle::BeyondSimulation));
    let heights = Request { against: Against::Height { heading: 0.0 }, ..example() };
    assert!(heights.table(&Silent).is_err());
    let flat = Excitation::irregular(Roll { variance: -1.0, ..seed::example_3_1().1 });
    assert!(Request { excitation: flat, ..example() }.prepare().is_err());
}
