//! Laws of heat, flow, reactions and rotation, each beside a look-alike and beside nothing; and a law without a name.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// A plant of some states, solved by Runge and Kutta's method at a quarter of a sample.
pub(crate) struct Plant<'a> {
    pub(crate) step: f64,
    pub(crate) start: &'a [f64],
    /// Names and units of inputs and states.
    pub(crate) inputs: &'a [(&'a str, &'a str)],
    pub(crate) states: &'a [(&'a str, &'a str)],
    /// An input's mean and size.
    pub(crate) sizes: &'a [(f64, f64)],
    /// Noise, as a share of an output's spread.
    pub(crate) noise: f64,
    /// States that are measured: the first so many.
    pub(crate) measured: usize,
}

const COUNT: usize = 1500;

impl Plant<'_> {
    /// An input: five sines of periods from a fifteenth of the recording to some ten samples, straight between samples.
    fn input(&self, k: usize, t: f64) -> f64 {
        let (mean, size) = self.sizes[k];
        let at = |i: f64| {
            let whole = COUNT as f64 / 15.0;
            let sine = |j: i32| {
                let turns = f64::from(1 << j) * (1.0 + 0.07 * k as f64) / whole;
                (std::f64::consts::TAU * turns * i + 1.7 * f64::from(j) * (1.0 + k as f64)).sin()
            };
            mean + size * (0..4).map(sine).sum::<f64>() / 2.0
        };
        let (sample, rest) = ((t / self.step + 1e-9).floor(), (t / self.step + 1e-9).fract());
        at(sample) + rest * (at(sample + 1.0) - at(sample))
    }

    pub(crate) fn recorded(&self, rates: impl Fn(&[f64], &[f64]) -> Vec<f64>) -> Recording {
        let h = self.step / 4.0;
        let of = |x: &[f64], t: f64| {
            let u: Vec<f64> = (0..self.inputs.len()).map(|k| self.input(k, t)).collect();
            rates(x, &u)
        };
        let add =
            |x: &[f64], h: f64, d: &[f64]| -> Vec<f64> { x.iter().zip(d).map(|(x, d)| x + h * d).collect() };
        let (mut x, mut states) = (self.start.to_vec(), vec![Vec::new(); self.start.len()]);
        for i in 0..4 * COUNT {
            if i % 4 == 0 {
                states.iter_mut().zip(&x).for_each(|(s, x)| s.push(*x));
            }
            let t = h * i as f64;
            let a = of(&x, t);
            let b = of(&add(&x, h / 2.0, &a), t + h / 2.0);
            let c = of(&add(&x, h / 2.0, &b), t + h / 2.0);
            let d = of(&add(&x, h, &c), t + h);
            let mean: Vec<f64> =
                (0..x.len()).map(|k| (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]) / 6.0).collect();
            x = add(&x, h, &mean);
        }
        let time: Vec<f64> = (0..COUNT).map(|i| self.step * i as f64).collect();
        let unit = |text: &str| Unit::parse(text).unwrap();
        let mut channels: Vec<Channel> = Vec::new();
        for (k, (name, of)) in self.inputs.iter().enumerate() {
            let values = time.iter().map(|t| self.input(k, *t)).collect();
            channels.push(Channel::new(*name, unit(of), time.clone(), values));
        }
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        for ((name, of), values) in self.states.iter().zip(states).take(self.measured) {
            let mean = values.iter().sum::<f64>() / COUNT as f64;
            let spread = (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / COUNT as f64).sqrt();
            let mut noise = || -> f64 { Distribution::<f64>::sample(&StandardNormal, &mut rng) };
            let values = values.iter().map(|v| v + self.noise * spread * noise()).collect();
            channels.push(Channel::new(format!("{name}_meas"), unit(of), time.clone(), values));
        }
        Recording::from_channels("made", channels).unwrap()
    }

    pub(crate) fn diagnosed(&self, model: &str, rates: impl Fn(&[f64], &[f64]) -> Vec<f64>) -> Answer {
        diagnosed(&Model::parse(model).unwrap(), self.recorded(rates)).answer
    }
}

/// The first finding's code, or the verdict where there is none.
pub(crate) fn first(a: &Answer) -> &str {
    a.findings.first().map_or("nothing", |f| &f.code)
}

pub(crate) fn value(a: &Answer, name: &str) -> [f64; 3] {
    let v = a.findings[0].parameters.iter().find(|v| v.name == name).unwrap();
    [v.low, v.value, v.high]
}

const FURNACE: Plant<'_> = Plant {
    step: 30.0,
    start: &[600.0],
    inputs: &[("P", "W"), ("Ta", "K")],
    states: &[("T", "K")],
    sizes: &[(3000.0, 2000.0), (293.0, 4.0)],
    noise: 0.01,
    measured: 1,
};
const FURNACE_MODEL: &str = r#"
    name = "furnace"
    [inputs]
    P = { unit = "W" }
    Ta = { unit = "K" }
    [parameters]
    C = { value = 2000, unit = "J/K", fit = true, min = 10 }
    h = { value = 8, unit = "W/K", fit = true, min = 0 }
    [states]
    T = { rate = "(P - h*(T - Ta))/C", unit = "K", initial = "fit" }
    [outputs]
    T_meas = { equals = "T", unit = "K" }
"#;

#[test]
fn a_furnace_radiates_or_loses_more_in_a_draught_or_nothing_is_missing() {
    let of = |radiation: f64, power: f64| {
        FURNACE.diagnosed(FURNACE_MODEL, |x, u| {
            let over = x[0] - u[1];
            let loss = 6.0 * over * (over.abs() / 300.0).powf(power);
            vec![(u[0] - loss - radiation * (x[0].powi(4) - u[1].powi(4))) / 2500.0]
        })
    };
    let radiating = of(1e-8, 0.0);
    assert_eq!((radiating.verdict, first(&radiating)), (Verdict::Named, "radiation"), "{}", radiating.says);
    let [low, _, high] = value(&radiating, "c4");
    assert!(low < 1e-8 && 1e-8 < high, "{low} to {high}");
    assert!(radiating.says.contains("heat of T leaves as radiation") && !radiating.says.contains("force"));
    let powered = of(0.0, 0.25);
    assert_eq!(first(&powered), "power-law", "{}", powered.says);
    let [low, _, high] = value(&powered, "p");
    assert!(low < 0.25 && 0.25 < high, "{low} to {high}");
    assert_eq!(of(0.0, 0.0).verdict, Verdict::NothingMissing);
}

const ROOMS: Plant<'_> = Plant {
    step: 300.0,
    start: &[290.0, 294.0],
    inputs: &[("P1", "W"), ("P2", "W"), ("Ta", "K")],
    states: &[("T1", "K"), ("T2", "K")],
    sizes: &[(800.0, 700.0), (500.0, 600.0), (280.0, 4.0)],
    noise: 0.01,
    measured: 2,
};
const ROOMS_MODEL: &str = r#"
    name = "rooms"
    [inputs]
    P1 = { unit = "W" }
    P2 = { unit = "W" }
    Ta = { unit = "K" }
    [parameters]
    C1 = { value = 1.5e5, unit = "J/K", fit = true, min = 1 }
    C2 = { value = 2.5e5, unit = "J/K", fit = true, min = 1 }
    h1 = { value = 50, unit = "W/K", fit = true, min = 0 }
    h2 = { value = 35, unit = "W/K", fit = true, min = 0 }
    [states]
    T1 = { rate = "(P1 - h1*(T1 - Ta))/C1", unit = "K", initial = "fit" }
    T2 = { rate = "(P2 - h2*(T2 - Ta))/C2", unit = "K", initial = "fit" }
    [outputs]
    T1_meas = { equals = "T1", unit = "K" }
    T2_meas = { equals = "T2", unit = "K" }
"#;

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_leaves_one_room_enters_the_other() {
    let of = |wall: f64, one_way: f64| {
        ROOMS.diagnosed(ROOMS_MODEL, |x, u| {
            let through = wall * (x[0] - x[1]);
            vec![
                (u[0] - 40.0 * (x[0] - u[2]) - through) / 2e5,
                (u[1] - 30.0 * (x[1] - u[2]) + through + one_way * (x[0] - 295.0)) / 3e5,
            ]
        })
    };
    let walled = of(12.0, 0.0);
    assert_eq!((walled.verdict, first(&walled)), (Verdict::Named, "exchange"), "{}", walled.says);
    let [low, _, high] = value(&walled, "c");
    assert!(low < 12.0 && 12.0 < high, "{low} to {high}");
    let coupled = of(0.0, 12.0);
    assert_ne!(first(&coupled), "exchange", "{}", coupled.says);
}

const DRUG: Plant<'_> = Plant {
    step: 0.1,
    start: &[1.5],
    inputs: &[("dose", "kg/(m^3*s)")],
    states: &[("c", "kg/m^3")],
    sizes: &[(0.7, 0.6)],
    noise: 0.01,
    measured: 1,
};
const DRUG_MODEL: &str = r#"
    name = "drug"
    [inputs]
    dose = { unit = "kg/(m^3*s)" }
    [parameters]
    g = { value = 0.8, unit = "1", fit = true, min = 0.01 }
    ke = { value = 0.3, unit = "1/s", fit = true, min = 0 }
    [states]
    c = { rate = "g*dose - ke*c", unit = "kg/m^3", initial = "fit" }
    [outputs]
    c_meas = { equals = "c", unit = "kg/m^3" }
"#;

#[test]
fn an_elimination_saturates() {
    let saturating = DRUG.diagnosed(DRUG_MODEL, |x, u| vec![u[0] - x[0] / (1.0 + 0.5 * x[0])]);
    let codes: Vec<&str> =
        saturating.findings.iter().flat_map(|f| f.ties.iter().chain([&f.code])).map(String::as_str).collect();
    assert!(codes.contains(&"saturable-rate"), "{}", saturating.says);
    let plain = DRUG.diagnosed(DRUG_MODEL, |x, u| vec![u[0] - 0.5 * x[0]]);
    assert_eq!(plain.verdict, Verdict::NothingMissing, "{}", plain.says);
}

const BESIDE: Plant<'_> = Plant {
    step: 0.1,
    start: &[2.0],
    inputs: &[("dose", "kg/s"), ("other", "kg/m^3")],
    states: &[("C", "kg/m^3")],
    sizes: &[(30.0, 12.0), (8.0, 4.0)],
    noise: 0.02,
    measured: 1,
};

const BESIDE_MODEL: &str = r#"
name = "elimination beside another drug"
[inputs]
dose = { unit = "kg/s" }
[parameters]
V = { value = 15, unit = "m^3", fit = true, min = 1 }
ke = { value = 0.4, unit = "1/s", fit = true, min = 0.01 }
[states]
C = { rate = "dose/V - ke*C", unit = "kg/m^3", initial = "fit" }
[outputs]
C_meas = { equals = "C", unit = "kg/m^3" }
"#;

#[test]
fn another_drug_hinders_an_elimination() {
    let model = Model::parse(BESIDE_MODEL).unwrap();
    let rates = |x: &[f64], u: &[f64]| vec![u[0] / 12.0 - 0.8 * x[0] / (1.0 + u[1] / 4.0)];
    let a = diagnosed(&model, BESIDE.recorded(rates)).answer;
    assert_eq!(names(&a), ["parameter-dependence"], "{}", a.says);
    assert!(a.says.contains("falls off with other"), "{}", a.says);
    // 1 + u/(4 kg/m³)
    let size = &a.findings[0].parameters[0];
    assert!(size.low < 0.25 && 0.25 < size.high && size.high - size.low < 0.1, "{size:?}");
}

const DRONE: Plant<'_> = Plant {
    step: 0.05,
    start: &[0.0, 0.0],
    inputs: &[("Mx", "N*m"), ("My", "N*m"), ("r", "rad/s")],
    states: &[("p", "rad/s"), ("q", "rad/s")],
    sizes: &[(0.0, 0.06), (0.0, 0.06), (0.0, 2.0)],
    noise: 0.01,
    measured: 2,
};
const DRONE_MODEL: &str = r#"
    name = "drone"
    [inputs]
    Mx = { unit = "N*m" }
    My = { unit = "N*m" }
    r = { unit = "rad/s" }
    [parameters]
    Ix = { value = 0.015, unit = "kg*m^2", fit = true, min = 1e-4 }
    Iy = { value = 0.03, unit = "kg*m^2", fit = true, min = 1e-4 }
    d1 = { value = 0.01, unit = "N*m*s", fit = true, min = 0 }
    d2 = { value = 0.01, unit = "N*m*s", fit = true, min = 0 }
    [states]
    p = { rate = "(Mx - d1*p)/Ix", unit = "rad/s", initial = "fit" }
    q = { rate = "(My - d2*q)/Iy", unit = "rad/s", initial = "fit" }
    [outputs]
    p_meas = { equals = "p", unit = "rad/s" }
    q_meas = { equals = "q", unit = "rad/s" }
"#;

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_gyroscopic_moment_is_a_product() {
    let of = |gyro: f64| {
        DRONE.diagnosed(DRONE_MODEL, |x, u| {
            vec![(u[0] - 0.02 * x[0] - gyro * x[1] * u[2]) / 0.02, (u[1] - 0.02 * x[1]) / 0.025]
        })
    };
    let turning = of(0.012);
    assert_eq!((turning.verdict, first(&turning)), (Verdict::Named, "product-coupling"), "{}", turning.says);
    let [low, _, high] = value(&turning, "c");
    assert!(low < -0.012 && -0.012 < high, "{low} to {high}");
    assert_eq!(of(0.0).verdict, Verdict::NothingMissing);
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_has_no_name_is_put_into_the_model_as_a_curve() {
    // a door that opens by itself about 700 K
    let open =
        |t: f64| 2500.0 / (1.0 + (-(t - 700.0) / 15.0).exp()) * (-((t - 700.0) / 120.0_f64).powi(2)).exp();
    let told =
        FURNACE.diagnosed(FURNACE_MODEL, |x, u| vec![(u[0] - 6.0 * (x[0] - u[1]) - open(x[0])) / 2500.0]);
    assert_eq!((told.verdict, first(&told)), (Verdict::Unknown, "free-law"), "{}", told.says);
    let p = &told.proof[0];
    assert!(p.holdout_after < 0.5 * p.holdout_before && p.improvement_low > 0.0, "{p:?}");
    assert!(told.findings[0].term.contains("curve("), "{}", told.findings[0].term);
    assert!(told.findings.iter().skip(1).all(|f| f.resembles || f.code == "free-law"));
    assert!(told.says.contains("no name") && told.says.contains("straight beyond"), "{}", told.says);
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_law_of_two_signals_is_put_into_the_model_as_a_surface() {
    // a draught through a gap that is widest about 650 K, against the wind on one side of the house
    let plant = Plant {
        inputs: &[("P", "W"), ("Ta", "K"), ("wind", "m/s")],
        sizes: &[(3000.0, 2000.0), (293.0, 4.0), (0.0, 3.0)],
        ..FURNACE
    };
    let draught = |t: f64, wind: f64| 700.0 * (wind / 1.5).tanh() * (-((t - 650.0) / 90.0_f64).powi(2)).exp();
    let told = plant
        .diagnosed(FURNACE_MODEL, |x, u| vec![(u[0] - 6.0 * (x[0] - u[1]) - draught(x[0], u[2])) / 2500.0]);
    assert_eq!((told.verdict, first(&told)), (Verdict::Unknown, "free-law"), "{}", told.says);
    let p = &told.proof[0];
    assert!(p.holdout_after < 0.6 * p.holdout_before && p.improvement_low > 0.0, "{p:?}");
    assert!(told.findings[0].term.contains("surface("), "{}", told.findings[0].term);
}

/// Codes of the first finding and of its ties.
fn names(a: &Answer) -> Vec<&str> {
    let first = a.findings.first();
    first.into_iter().flat_map(|f| f.ties.iter().chain([&f.code])).map(String::as_str).collect()
}

#[test]
fn a_second_store_stands_behind_a_furnace_in_the_words_of_heat() {
    // the wall has its own temperature, which nobody measures: two nodes, written as T' = … − c (T − w), w' = (T − w)/tau
    let plant = Plant { start: &[600.0, 600.0], states: &[("T", "K"), ("wall", "K")], ..FURNACE };
    let told = plant.diagnosed(FURNACE_MODEL, |x, u| {
        let to_wall = 8.0 * (x[0] - x[1]);
        vec![(u[0] - 6.0 * (x[0] - u[1]) - to_wall) / 2500.0, to_wall / 9000.0]
    });
    assert!(names(&told).contains(&"extra-lag"), "{}", told.says);
    assert!(
        told.says.contains("second store of heat behind T") && !told.says.contains("stiffness"),
        "{}",
        told.says
    );
}

#[test]
fn a_second_compartment_stands_behind_the_blood() {
    let plant = Plant { start: &[1.5, 1.0], states: &[("c", "kg/m^3"), ("deep", "kg/m^3")], ..DRUG };
    let told = plant.diagnosed(DRUG_MODEL, |x, u| {
        let between = 0.4 * (x[0] - x[1]);
        vec![u[0] - 0.5 * x[0] - between, 0.5 * between]
    });
    assert!(names(&told).contains(&"extra-lag"), "{}", told.says);
    assert!(told.says.contains("second compartment behind c"), "{}", told.says);
    assert!(told.findings[0].parameters.iter().any(|p| p.unit == "1/s"), "{:?}", told.findings[0].parameters);
}

#[test]
fn a_second_element_of_a_cell_is_in_series_with_the_first() {
    let plant = Plant {
        step: 2.0,
        start: &[3.3, 0.0, 0.0],
        inputs: &[("i", "A")],
        states: &[("u", "V"), ("v1", "V"), ("v2", "V")],
        sizes: &[(0.0, 3.0)],
        noise: 0.01,
        measured: 1,
    };
    // u is what the cell shows: its rate is that of 3.3 V − R i − v1 − v2, R = 0
    let told = plant.diagnosed(CELL_MODEL, |x, u| {
        let fast = u[0] / 800.0 - x[1] / (0.03 * 800.0);
        let slow = u[0] / 9000.0 - x[2] / (0.03 * 9000.0);
        vec![-fast - slow, fast, slow]
    });
    assert_eq!((told.verdict, first(&told)), (Verdict::Named, "extra-lag"), "{}", told.says);
    assert!(told.says.contains("second store of charge in series with v1"), "{}", told.says);
    let [low, _, high] = value(&told, "tau");
    assert!(low < 270.0 && 270.0 < high, "{low} to {high}");
}

const CELL_MODEL: &str = r#"
    name = "cell"
    [inputs]
    i = { unit = "A" }
    [parameters]
    E = { value = 3.2, unit = "V", fit = true }
    R1 = { value = 0.04, unit = "ohm", fit = true, min = 1e-4 }
    C1 = { value = 600, unit = "F", fit = true, min = 1 }
    [states]
    v1 = { rate = "i/C1 - v1/(R1*C1)", unit = "V", initial = 0 }
    [outputs]
    u_meas = { equals = "E - v1", unit = "V" }
"#;

const TANKS: Plant<'_> = Plant {
    step: 10.0,
    start: &[0.8, 0.6],
    inputs: &[("q1", "m^3/s"), ("q2", "m^3/s")],
    states: &[("h1", "m"), ("h2", "m")],
    sizes: &[(0.006, 0.003), (0.005, 0.003)],
    noise: 0.01,
    measured: 2,
};
const TANKS_MODEL: &str = r#"
    name = "tanks"
    [inputs]
    q1 = { unit = "m^3/s" }
    q2 = { unit = "m^3/s" }
    [parameters]
    A1 = { value = 0.4, unit = "m^2", fit = true, min = 0.01 }
    A2 = { value = 0.5, unit = "m^2", fit = true, min = 0.01 }
    k1 = { value = 0.005, unit = "m^2/s", fit = true, min = 0 }
    k2 = { value = 0.01, unit = "m^2/s", fit = true, min = 0 }
    [states]
    h1 = { rate = "(q1 - k1*h1)/A1", unit = "m", initial = "fit" }
    h2 = { rate = "(q2 - k2*h2)/A2", unit = "m", initial = "fit" }
    [outputs]
    h1_meas = { equals = "h1", unit = "m" }
    h2_meas = { equals = "h2", unit = "m" }
"#;

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn tanks_exchange_through_a_pipe_or_one_runs_over_or_nothing_is_missing() {
    let of = |pipe: f64, over: f64| {
        TANKS.diagnosed(TANKS_MODEL, |x, u| {
            let through = pipe * (x[0] - x[1]).signum() * (x[0] - x[1]).abs().sqrt();
            let lost = over * (x[0] - 0.9).max(0.0);
            vec![(u[0] - 0.006 * x[0] - through - lost) / 0.5, (u[1] - 0.008 * x[1] + through) / 0.4]
        })
    };
    let piped = of(0.002, 0.0);
    assert!(names(&piped).contains(&"exchange"), "{}", piped.says);
    assert!(piped.findings[0].term.contains("sqrt"), "{}", piped.findings[0].term);
    let running_over = of(0.0, 0.02);
    assert!(names(&running_over).contains(&"overflow"), "{}", running_over.says);
    assert_eq!(of(0.0, 0.0).verdict, Verdict::NothingMissing);
}

/// The value of a constant that a sentence names, with this unit behind it.
fn told(says: &str, name: &str, unit: &str) -> f64 {
    let behind = says.split(&format!("{name} = ")).nth(1).unwrap_or_else(|| panic!("no {name} in {says}"));
    behind.split(&format!(" {unit}")).next().and_then(|v| v.parse().ok()).unwrap_or_else(|| panic!("{says}"))
}

/// What the sentence says is enough to write the outflow down: k√(h h_ref) is that of the made tank, c√h.
#[test]
fn a_law_can_be_written_down_from_what_is_said_of_it() {
    let tank =
        Plant { start: &[0.8], inputs: &[("q", "m^3/s")], states: &[("h", "m")], measured: 1, ..TANKS };
    let recording = tank.recorded(|x, u| vec![(u[0] - 0.006 * x[0].sqrt()) / 0.5]);
    let found = diagnosed(&Model::parse(TANK_MODEL).unwrap(), recording);
    let said = &found.answer;
    assert_eq!((said.verdict, first(said)), (Verdict::Named, "square-root-flow"), "{}", said.says);
    let k = said.parameters.iter().find(|p| p.name == "k").unwrap();
    let coefficient = |k: f64| k * told(&said.findings[0].says, "h_ref", "m").sqrt();
    assert!(coefficient(k.low) < 0.006 && 0.006 < coefficient(k.high), "{} {k:?}", said.says);
    assert!(coefficient(k.high) < 1.02 * coefficient(k.low), "{k:?}");
    // the picture shows what the root adds to the linear outflow
    let [law] = &found.pictures.laws[..] else { panic!("{:?}", found.pictures.laws) };
    assert_eq!((law.signal.as_str(), law.effect_unit.as_str()), ("h", "m^3/s"));
    assert!(law.curve.len() > 20 && !law.means.is_empty() && !law.samples.is_empty());
    for [h, missing, ..] in &law.curve {
        let made = k.after * h - 0.006 * h.sqrt();
        assert!((missing - made).abs() < 1e-4, "at {h}: {missing} for {made}");
    }
}

/// A lag T of a sensor takes T ẏ from what it shows: the picture is a straight line of that slope.
#[test]
fn the_picture_of_a_lag_is_a_line_against_the_rate() {
    let plant = Plant { start: &[600.0, 600.0], states: &[("shown", "K"), ("T", "K")], ..FURNACE };
    let recording = plant.recorded(|x, u| vec![(x[1] - x[0]) / 240.0, (u[0] - 6.0 * (x[1] - u[1])) / 2500.0]);
    let model = FURNACE_MODEL.replace("T_meas", "shown_meas");
    let found = diagnosed(&Model::parse(&model).unwrap(), recording);
    let code = first(&found.answer);
    assert!(["input-lag", "output-lag"].contains(&code), "{}", found.answer.says);
    let [law] = &found.pictures.laws[..] else { panic!("{:?}", found.answer.says) };
    assert!(law.signal.starts_with("rate of "), "{}", law.signal);
    let (a, b) = (law.curve.first().unwrap(), law.curve.last().unwrap());
    let slope = (b[1] - a[1]) / (b[0] - a[0]);
    assert!((slope + 240.0).abs() < 24.0, "{slope} of {} against {}", law.effect, law.signal);
}

const TANK_MODEL: &str = r#"
    name = "tank"
    [inputs]
    q = { unit = "m^3/s" }
    [parameters]
    A = { value = 0.4, unit = "m^2", fit = true, min = 0.01 }
    k = { value = 0.005, unit = "m^2/s", fit = true, min = 0 }
    [states]
    h = { rate = "(q - k*h)/A", unit = "m", initial = "fit" }
    [outputs]
    h_meas = { equals = "h", unit = "m" }
"#;

const MOTOR: Plant<'_> = Plant {
    step: 0.02,
    start: &[10.0],
    inputs: &[("i", "A"), ("field", "A")],
    states: &[("w", "rad/s")],
    sizes: &[(0.0, 4.0), (1.0, 0.6)],
    noise: 0.01,
    measured: 1,
};
const MOTOR_MODEL: &str = r#"
    name = "motor"
    [inputs]
    i = { unit = "A" }
    [parameters]
    J = { value = 0.02, unit = "kg*m^2", fit = true, min = 1e-4 }
    k = { value = 0.1, unit = "V*s/rad" }
    d = { value = 0.01, unit = "N*m*s", fit = true, min = 0 }
    [states]
    w = { rate = "(k*i - d*w)/J", unit = "rad/s", initial = "fit" }
    [outputs]
    w_meas = { equals = "w", unit = "rad/s" }
"#;

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn the_torque_of_a_motor_goes_with_current_times_field_or_friction_brakes_it_in_newton_metres() {
    let of = |bilinear: f64, friction: f64| {
        MOTOR.diagnosed(MOTOR_MODEL, |x, u| {
            let torque = 0.1 * u[0] * (1.0 + bilinear * (u[1] - 1.0));
            vec![(torque - 0.02 * x[0] - friction * (x[0] / 0.01).tanh()) / 0.03]
        })
    };
    let bilinear = of(0.8, 0.0);
    let is_product = |n: &&str| ["product-coupling", "parameter-dependence"].contains(n);
    assert!(names(&bilinear).iter().any(is_product), "{}", bilinear.says);
    let braked = of(0.0, 0.05);
    assert_eq!(first(&braked), "dry-friction", "{}", braked.says);
    assert_eq!(braked.findings[0].parameters[0].unit, "N*m");
    assert_eq!(of(0.0, 0.0).verdict, Verdict::NothingMissing);
}

const PLATFORM: Plant<'_> = Plant {
    step: 0.5,
    start: &[0.0, 0.0],
    inputs: &[("along", "m/s^2"), ("K", "rad"), ("across", "m/s^2")],
    states: &[("a", "m/s^2"), ("b", "m/s^2")],
    sizes: &[(0.0, 0.8), (0.4, 1.0), (0.0, 0.6)],
    noise: 0.01,
    measured: 2,
};
const PLATFORM_MODEL: &str = r#"
    name = "what two sensors on a levelled platform feel of a ship that turns"
    [inputs]
    along = { unit = "m/s^2" }
    K = { unit = "rad" }
    [parameters]
    h = { value = 0.8, unit = "1", fit = true, min = 0.01 }
    T1 = { value = 3, unit = "s", fit = true, min = 0.01 }
    T2 = { value = 4, unit = "s", fit = true, min = 0.01 }
    [definitions]
    W1 = { equals = "-h*along*cos(K)", unit = "m/s^2" }
    W2 = { equals = "h*along*sin(K)", unit = "m/s^2" }
    [states]
    a = { rate = "(W1 - a)/T1", unit = "m/s^2", initial = "fit" }
    b = { rate = "(W2 - b)/T2", unit = "m/s^2", initial = "fit" }
    [outputs]
    a_meas = { equals = "a", unit = "m/s^2" }
    b_meas = { equals = "b", unit = "m/s^2" }
"#;

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn an_ignored_motion_acts_as_the_other_component_of_a_vector_or_at_one_place_or_not() {
    let of = |both: f64, one: f64| {
        PLATFORM.diagnosed(PLATFORM_MODEL, |x, u| {
            let (along, k, across) = (u[0], u[1], u[2]);
            let w1 = -along * k.cos() + both * across * k.sin();
            let w2 = along * k.sin() + both * across * k.cos() + one * across;
            vec![(w1 - x[0]) / 4.0, (w2 - x[1]) / 5.0]
        })
    };
    let turned = of(0.7, 0.0);
    assert_eq!((turned.verdict, first(&turned)), (Verdict::Named, "cross-coupling"), "{}", turned.says);
    assert_eq!(turned.findings.len(), 1, "{}", turned.says);
    assert!(turned.says.contains("other component of the same vector"), "{}", turned.says);
    let [low, _, high] = value(&turned, "c");
    assert!(low < 0.7 && 0.7 < high, "{low} to {high}");
    let at_one = of(0.0, 0.5);
    assert_eq!(first(&at_one), "cross-coupling", "{}", at_one.says);
    assert!(!at_one.says.contains("vector"), "{}", at_one.says);
    assert_eq!(of(0.0, 0.0).verdict, Verdict::NothingMissing);
}
