//! What a model file claims and a recording denies: rest at the beginning, bounds, known values.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const STEP: f64 = 0.05;

/// A cart of mass m driven by two waves of force, m v' = F − 8 v, by the exact solution between samples of a straight F; it begins
/// at a speed.
fn cart(mass: f64, begins: f64) -> Recording {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let time: Vec<f64> = (0..1600).map(|i| STEP * f64::from(i)).collect();
    let force: Vec<f64> =
        time.iter().map(|t| 30.0 * (0.7 * t).sin() + 20.0 * (2.3 * t + 1.0).cos()).collect();
    let (lag, decay) = (mass / 8.0, (-STEP * 8.0 / mass).exp());
    let mut v = begins;
    let mut speed = vec![v];
    for pair in force.windows(2) {
        // v(h) = (v − F₀/d + s T/d) e^(−h/T) + F₀/d + s (h − T)/d for F = F₀ + s t, T = m/d
        let slope = (pair[1] - pair[0]) / STEP;
        let settled = |t: f64| (pair[0] + slope * (t - lag)) / 8.0;
        v = (v - settled(0.0)) * decay + settled(STEP);
        speed.push(v);
    }
    for v in &mut speed {
        let error: f64 = StandardNormal.sample(&mut rng);
        *v += 0.003 * error;
    }
    let unit = |text: &str| Unit::parse(text).unwrap();
    let channels = vec![
        Channel::new("F", unit("N"), time.clone(), force),
        Channel::new("speed", unit("m/s"), time, speed),
    ];
    Recording::from_channels("cart", channels).unwrap()
}

fn model(mass: &str, damping: &str, initial: &str) -> Model {
    Model::parse(&format!(
        "name = \"cart\"\n[inputs]\nF = {{ unit = \"N\" }}\n[parameters]\n\
         m = {{ unit = \"kg\", {mass} }}\nd = {{ unit = \"N*s/m\", fit = true, {damping} }}\n\
         [states]\nv = {{ rate = \"(F - d*v)/m\", unit = \"m/s\", initial = {initial} }}\n\
         [outputs]\nspeed = {{ equals = \"v\", unit = \"m/s\" }}\n"
    ))
    .unwrap()
}

fn parameter(a: &Answer, name: &str) -> f64 {
    a.parameters.iter().find(|p| p.name == name).unwrap().after
}

#[test]
fn a_recording_that_does_not_begin_at_rest_is_told_and_leads_to_no_name() {
    let at_rest = |mass: &str| model(mass, "value = 6.0", "\"steady\"");
    let free = at_rest("value = 15.0, fit = true, min = 1");
    let told = diagnosed(&free, cart(20.0, 9.0)).answer;
    assert_eq!(told.verdict, Verdict::NothingMissing, "{}", told.says);
    assert!(told.notes.iter().any(|n| n.contains("does not begin at rest")), "{:?}", told.notes);
    assert!((parameter(&told, "m") - 20.0).abs() < 0.05 && (parameter(&told, "d") - 8.0).abs() < 0.02);
    // F(0)/8 = 20·cos(1)/8 is where it rests
    let rests = diagnosed(&free, cart(20.0, 20.0 * f64::cos(1.0) / 8.0)).answer;
    assert_eq!(rests.verdict, Verdict::NothingMissing, "{}", rests.says);
    assert!(!rests.notes.iter().any(|n| n.contains("rest")), "{:?}", rests.notes);
    let recordings = [cart(20.0, 9.0)];
    let fitted = gyrospec::fit(&free, &recordings).run().unwrap();
    assert!(fitted.warnings().any(|w| w.contains("does not begin at rest")));
    // of several each has its beginning
    let mut several = [cart(20.0, 20.0 * f64::cos(1.0) / 8.0), cart(20.0, 9.0)];
    several[1].name = "second".into();
    // what is compared is not the same twice
    several[1].channels.iter_mut().for_each(|c| c.values.iter_mut().for_each(|v| *v *= 0.5));
    let fitted = gyrospec::fit(&free, &several).run().unwrap();
    let told = fitted.warnings().find(|w| w.starts_with("not every recording begins at rest")).unwrap();
    assert!(told.contains("in 'cart'") && told.contains("in 'second'"), "{told}");
}

#[test]
fn a_bound_that_is_too_narrow_is_no_wrong_unit() {
    let narrow = model("value = 15.0, fit = true, min = 1", "value = 6.0, min = 0.1, max = 7.0", "\"fit\"");
    let told = diagnosed(&narrow, cart(20.0, 0.0)).answer;
    // of a cart, all that is seen of less damping is a speed that reads too little
    let codes = std::iter::once(&told.findings[0].code).chain(&told.findings[0].ties);
    assert!(codes.into_iter().any(|c| c == "parameter-value"), "{}", told.says);
    assert!(told.faults.is_empty(), "{}", told.says);
}

#[test]
fn a_known_mass_that_is_another_is_no_wrong_unit() {
    for mass in [35.0, 40.0] {
        let known = model("value = 20.0", "value = 6.0", "\"fit\"");
        let told = diagnosed(&known, cart(mass, 0.0)).answer;
        assert!(told.faults.is_empty(), "{mass}: {}", told.says);
        let codes = std::iter::once(&told.findings[0].code).chain(&told.findings[0].ties);
        assert!(codes.into_iter().any(|c| c == "parameter-value"), "{mass}: {}", told.says);
    }
    // knots where metres a second are meant
    let mut wrong = cart(20.0, 0.0);
    let speed = wrong.channels.iter_mut().find(|c| c.name == "speed").unwrap();
    speed.values.iter_mut().for_each(|v| *v *= 3600.0 / 1852.0);
    let told = diagnosed(&model("value = 20.0", "value = 6.0", "\"fit\""), wrong).answer;
    assert!(told.faults.iter().any(|f| f.finding.code == "wrong-unit"), "{}", told.says);
}

/// What a recording knows of a parameter is shown, and what it knows of none is told.
#[test]
fn constants_of_recordings_are_shown_as_they_are() {
    let constant = |value: f64, name: &str| {
        let mut recording = cart(value, 0.0);
        let unit = Unit::parse("kg").unwrap();
        recording.constants.push(gyrospec::record::Constant { name: name.into(), value, unit });
        recording
    };
    let known = model("value = 20.0", "value = 6.0", "\"fit\"");
    let one = [constant(35.0, "m")];
    let fitted = gyrospec::fit(&known, &one).run().unwrap();
    assert_eq!(fitted.parameter("m").unwrap().value, 35.0);
    assert!((fitted.parameter("d").unwrap().value - 8.0).abs() < 0.02);
    let several = [constant(35.0, "m"), constant(20.0, "m")];
    let text = gyrospec::fit(&known, &several).run().unwrap().text();
    let row = text.lines().find(|l| l.trim_start().starts_with("m ")).unwrap();
    assert!(row.contains("several") && row.contains("given by the recording"), "{row}");
    let unknown = [constant(20.0, "mass")];
    let fitted = gyrospec::fit(&known, &unknown).run().unwrap();
    assert!(fitted.warnings().any(|w| w.contains("`mass`") && w.contains("no parameter of the model")));
}
