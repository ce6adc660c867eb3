//! Made recordings with something concealed in them.

use super::stepper::Stepper;
use crate::diagnose::bench::{Bench, Stand};
use crate::diagnose::catalogue::{self, Proposal, Scene};
use crate::expression::Expr;
use crate::model::{Initial, Model};
use crate::record::{Channel, Recording};
use crate::units::Unit;
use crate::{Error, Result};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use serde::{Deserialize, Serialize};
use std::fmt::Write;
use std::path::Path;

/// Codes that are drawn: those that one output and one input can show apart from the fitted parameters.
const DRAWN: [&str; 12] = [
    "dry-friction",
    "asymmetric-friction",
    "quadratic-damping",
    "cubic-damping",
    "constant-force",
    "cubic-stiffness",
    "quadratic-stiffness",
    "cross-coupling",
    "parameter-dependence",
    "parameter-change",
    "input-delay",
    "output-lag",
];

/// The model of the laboratory where none is given: a driven axis on a spring.
const AXIS: &str = r#"
name = "axis of the laboratory"
[inputs]
force = { unit = "N" }
[parameters]
M = { value = 4.0, unit = "kg", fit = true, min = 0.1, max = 100 }
Fv = { value = 6.0, unit = "N*s/m", fit = true, min = 0, max = 1000 }
k = { value = 150.0, unit = "N/m", fit = true, min = 0, max = 1e5 }
[states]
q = { rate = "v", unit = "m", initial = 0.0 }
v = { rate = "(force - Fv*v - k*q)/M", unit = "m/s", initial = 0.0 }
[outputs]
position = { equals = "q", unit = "m" }
"#;

/// What is concealed in one case.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Case {
    /// Number.
    pub number: usize,
    /// none, one, two or outside.
    pub kind: String,
    /// Codes of what is concealed.
    pub codes: Vec<String>,
    /// Values of its parameters in their units.
    pub values: Vec<(String, f64)>,
    /// Effect on the output over the noise, root mean squares.
    pub size: f64,
    /// Lag-one correlation of the noise.
    pub correlation: f64,
}

/// Lag-one correlations of the noise.
pub(super) const CORRELATIONS: [f64; 3] = [0.0, 0.9, 0.98];

/// What is concealed in ten cases in turn, where all kinds are made.
const MIXED: [&str; 10] = ["none", "one", "one", "one", "outside", "none", "one", "one", "two", "outside"];

/// What a case conceals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Nothing.
    None,
    /// One mechanism of the catalogue.
    One,
    /// Two.
    Two,
    /// A law that the catalogue does not have.
    Outside,
}

impl Kind {
    /// Its word in the truth and on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::One => "one",
            Self::Two => "two",
            Self::Outside => "outside",
        }
    }
}

/// What is drawn.
#[derive(Debug, Clone, Copy)]
pub struct Draw {
    /// How many recordings.
    pub cases: usize,
    /// Seed.
    pub seed: u64,
    /// Only this kind; all kinds where `None`.
    pub only: Option<Kind>,
}

/// A model with a recording whose inputs are used.
pub struct Scenario {
    /// The model, at its true values.
    pub model: Model,
    /// The recording.
    pub recording: Recording,
}

impl Scenario {
    /// The laboratory's own axis, driven by a drawn force.
    ///
    /// # Errors
    /// Never, unless the built-in model is broken.
    pub fn axis(seed: u64) -> Result<Self> {
        let model = Model::parse(AXIS)?;
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let time: Vec<f64> = (0..5000).map(|i| 0.01 * f64::from(i)).collect();
        let waves: Vec<(f64, f64, f64)> = (0..7)
            .map(|_| (rng.random_range(1.0..14.0), rng.random_range(0.0..6.3), rng.random_range(1.0..5.0)))
            .collect();
        let force = time.iter().map(|t| waves.iter().map(|(w, p, a)| a * (w * t + p).sin()).sum::<f64>());
        let slow: f64 = rng.random_range(0.1..0.3);
        let warm = time.iter().map(|t| 22.0 + 3.0 * (slow * t).sin());
        let channel = |name: &str, unit: &str, v: Vec<f64>| {
            Ok::<_, Error>(Channel::new(name, Unit::parse(unit)?, time.clone(), v))
        };
        let channels = vec![
            channel("force", "N", force.collect())?,
            channel("temp", "K", warm.collect())?,
            channel("position", "m", vec![0.0; time.len()])?,
        ];
        Ok(Self { model, recording: Recording::from_channels("laboratory", channels)? })
    }

    /// A user's model and recording: the model is fitted first.
    ///
    /// # Errors
    /// Where it cannot be fitted.
    pub fn of(model: &Model, recording: &Recording, seed: u64) -> Result<Self> {
        let bench = Bench::new(model, vec![recording.clone()], false, seed);
        let f = bench.full_fit(model)?;
        let mut model = f.model.clone();
        for (s, x) in model.states.iter_mut().zip(&f.records[0].initials) {
            if x.is_finite() {
                s.initial = Initial::Number(*x);
            }
        }
        Ok(Self { model, recording: recording.clone() })
    }
}

/// Makes the cases, writes their files to a folder and returns the truth.
///
/// # Errors
/// Where the scenario cannot be simulated or files cannot be written.
pub fn make(scenario: &Scenario, folder: &Path, draw: &Draw) -> Result<Vec<Case>> {
    let seed = draw.seed;
    let bench = Bench::new(&scenario.model, vec![scenario.recording.clone()], false, seed);
    let records = &scenario.recording;
    let initials: Vec<f64> = scenario
        .model
        .states
        .iter()
        .map(|s| if let Initial::Number(x) = s.initial { x } else { 0.0 })
        .collect();
    let stand = Stand {
        parameters: scenario.model.parameters.iter().map(|p| p.value).collect(),
        initials: vec![initials],
    };
    let scene = bench.scene(&scenario.model, &stand)?;
    let plain = simulated(&scenario.model, records)?;
    (0..draw.cases).map(|i| one(scenario, &scene, &plain, folder, (i, draw))).collect()
}

fn times(model: &Model, recording: &Recording) -> Result<Vec<f64>> {
    let name = model.outputs.first().map_or("", |o| o.name.as_str());
    Ok(recording.channel(name)?.time.to_vec())
}

fn simulated(model: &Model, recording: &Recording) -> Result<Vec<Vec<f64>>> {
    let mut stepper = Stepper::new(model, recording)
        .ok_or_else(|| Error::bad_input("the recording lacks an input of the model"))?;
    Ok(stepper.outputs(&times(model, recording)?))
}

fn one(
    scenario: &Scenario,
    scene: &Scene,
    plain: &[Vec<f64>],
    folder: &Path,
    (number, draw): (usize, &Draw),
) -> Result<Case> {
    let mut rng = ChaCha8Rng::seed_from_u64(draw.seed.wrapping_mul(1_000_003).wrapping_add(number as u64));
    let kind = draw.only.map_or(MIXED[number % 10], Kind::word);
    let mut case = Case {
        number,
        kind: kind.into(),
        codes: Vec::new(),
        values: Vec::new(),
        size: [1.0, 3.0, 10.0][rng.random_range(0..3)],
        correlation: CORRELATIONS[rng.random_range(0..3)],
    };
    let mut y = plain.to_vec();
    for _ in 0..20 {
        case.codes.clear();
        case.values.clear();
        let mut model = scenario.model.clone();
        match kind {
            "one" | "two" => {
                for _ in 0..if kind == "two" { 2 } else { 1 } {
                    model = conceal(&model, scene, &mut case, &mut rng);
                }
            }
            "outside" => model = outside(&model, scene),
            _ => {}
        }
        y = simulated(&model, &scenario.recording)?;
        if y.iter().flatten().all(|v| v.is_finite()) {
            break;
        }
    }
    cover(&mut y, plain, &case, &mut rng);
    write(scenario, &y, folder, number)?;
    Ok(case)
}

/// Puts a drawn mechanism into the model.
fn conceal(model: &Model, scene: &Scene, case: &mut Case, rng: &mut ChaCha8Rng) -> Model {
    let here = Scene { model, ..copy(scene) };
    let code = DRAWN[rng.random_range(0..DRAWN.len())];
    let proposals: Vec<Proposal> = catalogue::find(code)
        .map(|m| (m.propose)(&here))
        .unwrap_or_default()
        .into_iter()
        .filter(|p| !p.starts.is_empty())
        .collect();
    if proposals.is_empty() || case.codes.iter().any(|c| c == code) {
        return model.clone();
    }
    let p = &proposals[rng.random_range(0..proposals.len())];
    let start = &p.starts[rng.random_range(0..p.starts.len().min(3))];
    let scale: f64 = rng.random_range(0.1..0.4);
    let mut made = p.model.clone();
    let first_is_larger: bool = rng.random();
    for (i, a) in p.added.iter().enumerate() {
        let factor = match p.amplitudes.iter().position(|k| *k == i) {
            // Two amplitudes differ by half at least, so that it is not a simpler mechanism in disguise.
            Some(k) if (k % 2 == 0) == first_is_larger => scale * rng.random_range(1.2..1.5),
            Some(_) => scale * rng.random_range(0.5..0.8),
            None => rng.random_range(0.9..1.1),
        };
        let value = start[i] * factor;
        case.values.push((a.name.clone(), a.unit.difference_from_si(value)));
        if let Some(q) = made.parameters.iter_mut().find(|q| q.name == a.name) {
            q.value = value;
        }
    }
    case.codes.push(code.to_string());
    made
}

fn copy<'a>(scene: &Scene<'a>) -> Scene<'a> {
    Scene {
        model: scene.model,
        trials: scene.trials,
        signals: scene.signals.clone(),
        sizes: scene.sizes.clone(),
        arguments: scene.arguments.clone(),
        step: scene.step,
        from: scene.from,
        to: scene.to,
        whole: scene.whole,
        tables: scene.tables.clone(),
        measured: scene.measured.clone(),
        peaks: scene.peaks.clone(),
        lines: scene.lines.clone(),
        shifts: scene.shifts.clone(),
        own_parameters: scene.own_parameters,
        own_states: scene.own_states,
        companions: scene.companions.clone(),
    }
}

/// A force that no catalogue has: it goes with the speed within a window of positions.
fn outside(model: &Model, scene: &Scene) -> Model {
    let mut made = model.clone();
    let Some(m) = scene.motions().into_iter().find(|m| m.speed.is_some() && m.position.is_some()) else {
        return made;
    };
    let (Some(q), Some(v)) = (m.position.as_ref(), m.speed.as_ref()) else { return made };
    let (a, b) = (scene.size(q), scene.size(v));
    let text = format!("-{}*sin(3*{q}/{a})*({v}/{b})^2", 0.5 * m.size);
    let Ok(term) = Expr::parse(&text) else { return made };
    if let Some(s) = made.states.iter_mut().find(|s| s.name == m.state) {
        s.rate = catalogue::edit::with_sum(model, &s.rate, &|sum| catalogue::edit::plus(sum, &term));
    }
    made
}

/// Adds noise so that the concealed effect is `size` times as large; none: a hundredth of the output.
fn cover(y: &mut [Vec<f64>], plain: &[Vec<f64>], case: &Case, rng: &mut ChaCha8Rng) {
    for (y, plain) in y.iter_mut().zip(plain) {
        let n = y.len().max(1) as f64;
        let effect = (y.iter().zip(plain).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / n).sqrt();
        let whole = (plain.iter().map(|b| b * b).sum::<f64>() / n).sqrt();
        let level = if effect > 0.0 { effect / case.size } else { 0.01 * whole };
        let r = case.correlation;
        let fresh = level * (1.0 - r * r).sqrt();
        let first: f64 = StandardNormal.sample(rng);
        let mut e = level * first;
        for v in y.iter_mut() {
            let draw: f64 = StandardNormal.sample(rng);
            e = r * e + fresh * draw;
            *v += e;
        }
    }
}

fn write(scenario: &Scenario, y: &[Vec<f64>], folder: &Path, number: usize) -> Result<()> {
    let model = &scenario.model;
    let mut start = model.clone();
    for s in &mut start.states {
        s.initial = Initial::Fit;
    }
    let times = times(model, &scenario.recording)?;
    let others: Vec<&Channel> = scenario
        .recording
        .channels
        .iter()
        .filter(|c| model.outputs.iter().all(|o| o.name != c.name))
        .collect();
    let mut text = String::from("t [s]");
    for c in &others {
        let _ = write!(text, ",{} [{}]", c.name, c.unit);
    }
    for o in &model.outputs {
        let _ = write!(text, ",{} [{}]", o.name, o.unit);
    }
    text.push('\n');
    for (k, t) in times.iter().enumerate() {
        let _ = write!(text, "{t:.6}");
        for c in &others {
            let _ = write!(
                text,
                ",{}",
                c.value_at(*t).map_or(String::new(), |v| format!("{:.9e}", c.unit.from_si(v)))
            );
        }
        for (o, y) in model.outputs.iter().zip(y) {
            let _ = write!(text, ",{:.9e}", o.unit.from_si(y[k]));
        }
        text.push('\n');
    }
    let save = |name: String, text: &str| {
        let path = folder.join(name);
        std::fs::write(&path, text).map_err(|e| Error::io(&path, &e))
    };
    save(format!("case-{number}.csv"), &text)?;
    save(format!("model-{number}.toml"), &start.to_toml())
}
