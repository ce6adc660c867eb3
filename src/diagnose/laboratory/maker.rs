//! Made recordings with something concealed in them.

use super::conceal::{conceal, outside};
use super::scenario::Scenario;
use super::stepper::Stepper;
use crate::diagnose::bench::{Bench, Stand};
use crate::diagnose::catalogue::Scene;
use crate::diagnose::inert::Inert;
use crate::estimate::fit::Progress;
use crate::model::{Initial, Model};
use crate::record::{Channel, Recording};
use crate::{Error, Result};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::fmt::Write;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

/// One effect that is concealed.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Hidden {
    /// Its code.
    pub code: String,
    /// Name of what it acts on.
    pub place: String,
    /// The term in the equation.
    pub term: String,
    /// Values of its parameters in their units.
    pub values: Vec<(String, f64)>,
}

/// What is concealed in one case.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Case {
    /// Number.
    pub number: usize,
    /// The plant, or the user's model.
    pub plant: String,
    /// What kind of thing is concealed.
    pub kind: Kind,
    /// The effects of the catalogue.
    pub hidden: Vec<Hidden>,
    /// What is left of the effect, of two the lesser one, when the model without it is fitted, over the noise; root mean
    /// squares. 0 where nothing is concealed.
    pub size: f64,
    /// Lag-one correlation of the noise.
    pub correlation: f64,
}

/// Lag-one correlations of the noise.
pub(super) const CORRELATIONS: [f64; 3] = [0.0, 0.9, 0.98];

/// What is concealed in ten cases in turn, where all kinds are made.
const MIXED: [Kind; 10] = {
    use Kind::{None, One, Outside, Two};
    [None, One, One, Two, Outside, None, One, One, Two, Outside]
};

/// Bounds of the noise of an output over its spread. What leaves less is lost in the fitted parameters; what leaves more is
/// no model of the plant.
const LEAST: f64 = 1e-4;
const MOST: f64 = 0.5;

/// Sizes of an effect over the noise.
pub(super) const SIZES: [f64; 3] = [1.0, 3.0, 10.0];

/// How often a case is drawn anew until its effect can be seen.
const TRIES: usize = 60;

/// What a case conceals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
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

/// Makes the cases, writes their files to a folder and returns the truth. `scenario` draws the plant of a case.
///
/// # Errors
/// Where a scenario cannot be simulated, nothing can be concealed in it, or files cannot be written.
pub fn make(
    scenario: &(dyn Fn(&mut ChaCha8Rng) -> Result<Scenario> + Sync),
    folder: &Path,
    draw: &Draw,
    progress: &dyn Progress,
) -> Result<Vec<Case>> {
    let made = AtomicUsize::new(0);
    let one = |number: usize| {
        let mut rng =
            ChaCha8Rng::seed_from_u64(draw.seed.wrapping_mul(1_000_003).wrapping_add(number as u64));
        let scenario = scenario(&mut rng)?;
        let kind = draw.only.unwrap_or(MIXED[number % MIXED.len()]);
        let size = SIZES[rng.random_range(0..SIZES.len())];
        let mut case = Case {
            number,
            plant: scenario.name.clone(),
            kind,
            hidden: Vec::new(),
            size: if kind == Kind::None { 0.0 } else { size },
            correlation: CORRELATIONS[rng.random_range(0..CORRELATIONS.len())],
        };
        let start = scenario.start(&mut rng);
        let (y, level) = concealed(&scenario, &start, &mut case, &mut rng)?;
        let y = covered(y, level, case.correlation, &mut rng);
        write(&start, &scenario.recording, &y, (folder, number))?;
        let made = 1 + made.fetch_add(1, Ordering::Relaxed);
        progress.report("making recordings", Some(made as f64 / draw.cases as f64));
        Ok(case)
    };
    (0..draw.cases).into_par_iter().map(one).collect()
}

fn simulated(model: &Model, recording: &Recording) -> Result<Vec<Vec<f64>>> {
    let mut stepper = Stepper::new(model, recording)
        .ok_or_else(|| Error::bad_input("the recording lacks an input of the model"))?;
    Ok(stepper.outputs(clock(model, recording)?))
}

/// The times of the outputs, which are sampled together.
fn clock<'a>(model: &Model, recording: &'a Recording) -> Result<&'a [f64]> {
    let name = model.outputs.first().map_or("", |o| o.name.as_str());
    Ok(&recording.channel(name)?.time)
}

/// The recording with the outputs y.
fn with_outputs(model: &Model, recording: &Recording, y: &[Vec<f64>]) -> Result<Recording> {
    let place = |c: &Channel| {
        let k = model.outputs.iter().position(|o| o.name == c.name);
        k.map_or_else(|| c.clone(), |k| Channel::new(&*c.name, c.unit.clone(), c.time.to_vec(), y[k].clone()))
    };
    Recording::from_channels(&*recording.name, recording.channels.iter().map(place).collect())
}

/// The outputs with what is drawn for the case in them, and the noise that makes its size, over an output's spread.
fn concealed(
    scenario: &Scenario,
    start: &Model,
    case: &mut Case,
    rng: &mut ChaCha8Rng,
) -> Result<(Vec<Vec<f64>>, f64)> {
    let model = &scenario.model;
    let plain = simulated(model, &scenario.recording)?;
    if case.kind == Kind::None {
        return Ok((plain, rng.random_range(LEAST.ln()..MOST.ln()).exp()));
    }
    let bench = Bench::new(model, vec![with_outputs(model, &scenario.recording, &plain)?], false, 1);
    let initial = |s: &crate::model::State| if let Initial::Number(x) = s.initial { x } else { 0.0 };
    let stand = Stand {
        parameters: model.parameters.iter().map(|p| p.value).collect(),
        initials: vec![model.states.iter().map(initial).collect()],
    };
    let scene = bench.scene(model, &stand)?;
    for _ in 0..TRIES {
        if let Some(found) = tried(scenario, (&scene, start, &plain), case, rng) {
            return Ok(found);
        }
    }
    Err(Error::not_computed(format!("nothing that can be seen could be concealed in case {}", case.number)))
}

/// One draw, where its effect is neither larger than the output nor lost in the fitted parameters.
fn tried(
    scenario: &Scenario,
    (scene, start, plain): (&Scene, &Model, &[Vec<f64>]),
    case: &mut Case,
    rng: &mut ChaCha8Rng,
) -> Option<(Vec<Vec<f64>>, f64)> {
    let (model, lacking) = drawn(scene, start, case, rng)?;
    let y = simulated(&model, &scenario.recording).ok()?;
    let effect = y.iter().zip(plain).map(|(y, plain)| {
        let squares = y.iter().zip(plain).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
        squares / y.len() as f64 / spread(plain).powi(2)
    });
    if !effect.sum::<f64>().le(&(y.len() as f64)) {
        return None;
    }
    let recording = with_outputs(&scenario.model, &scenario.recording, &y).ok()?;
    // what each of the models that lack something leaves of the outputs' spread when it is fitted
    let left = |model: &Model| {
        let fit = Bench::new(model, vec![recording.clone()], false, 1).full_fit(model).ok()?;
        let apart = fit.rmse.iter().zip(&y).map(|(e, y)| (e / spread(y)).powi(2)).sum::<f64>();
        Some((apart / y.len() as f64).sqrt())
    };
    let all: Vec<f64> = lacking.iter().map(left).collect::<Option<_>>()?;
    let level = all.into_iter().fold(f64::INFINITY, f64::min) / case.size;
    (level > LEAST && level < MOST).then_some((y, level))
}

/// A model with what is drawn for a case in it, and those that lack a part of it: the model as given, and of two effects
/// the models with one of them.
fn drawn(scene: &Scene, start: &Model, case: &mut Case, rng: &mut ChaCha8Rng) -> Option<(Model, Vec<Model>)> {
    case.hidden.clear();
    if case.kind == Kind::Outside {
        return Some((outside(scene, rng)?, vec![start.clone()]));
    }
    let (first, hidden) = conceal(scene.model, scene, None, rng)?;
    case.hidden.push(hidden);
    if case.kind == Kind::One {
        return Some((first.model, vec![start.clone()]));
    }
    let (second, hidden) = conceal(&first.model, scene, case.hidden.first(), rng)?;
    case.hidden.push(hidden);
    let without_first = Inert::of(&first)?.model(&second.model, &first)?;
    Some((second.model, vec![start.clone(), first.model, without_first]))
}

fn spread(y: &[f64]) -> f64 {
    let n = y.len().max(1) as f64;
    let mean = y.iter().sum::<f64>() / n;
    (y.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n).sqrt()
}

/// The outputs under noise of a level over their spread, e_k = r e_(k-1) + sqrt(1 - r^2) n_k.
fn covered(mut y: Vec<Vec<f64>>, level: f64, r: f64, rng: &mut ChaCha8Rng) -> Vec<Vec<f64>> {
    for y in &mut y {
        let level = level * spread(y);
        let fresh = level * (1.0 - r * r).sqrt();
        let first: f64 = StandardNormal.sample(rng);
        let mut e = level * first;
        for v in y.iter_mut() {
            let draw: f64 = StandardNormal.sample(rng);
            e = r * e + fresh * draw;
            *v += e;
        }
    }
    y
}

fn write(
    start: &Model,
    recording: &Recording,
    y: &[Vec<f64>],
    (folder, number): (&Path, usize),
) -> Result<()> {
    let is_output = |c: &&Channel| start.outputs.iter().any(|o| o.name == c.name);
    let others: Vec<&Channel> = recording.channels.iter().filter(|c| !is_output(c)).collect();
    let mut text = String::from("t [s]");
    for c in &others {
        let _ = write!(text, ",{} [{}]", c.name, c.unit);
    }
    for o in &start.outputs {
        let _ = write!(text, ",{} [{}]", o.name, o.unit);
    }
    text.push('\n');
    for (k, t) in clock(start, recording)?.iter().enumerate() {
        let _ = write!(text, "{t}");
        for c in &others {
            let _ = write!(
                text,
                ",{}",
                c.value_at(*t).map_or(String::new(), |v| format!("{:.9e}", c.unit.from_si(v)))
            );
        }
        for (o, y) in start.outputs.iter().zip(y) {
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
