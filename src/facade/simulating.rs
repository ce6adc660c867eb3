//! A model run on a recording.

use super::fitting::turns;
use crate::diagnose::read_held;
use crate::estimate::fit::{FitOptions, begun_on};
use crate::model::{Initial, Model};
use crate::record::{Channel, Hold, Kind, Recording, may_be_held};
use crate::report::simulated;
use crate::simulate::{Options, OutputSignal, Simulator, Trajectory, warnings};
use crate::{Error, Result};

/// By how much smaller errors must be, as a logarithm, for another reading of the inputs to be told.
const NEARER: f64 = 0.05;

/// Asks for a run of a model on the inputs of a recording, at the values of the model file. Initial states that the file
/// marks `"fit"` begin where the run lies nearest to what was measured; one that this does not tell stays
/// where the search for it begins.
///
/// ```
/// use gyrospec::{Model, Recording, simulate};
/// let folder = tempfile::tempdir().unwrap();
/// let file = folder.path().join("step.csv");
/// std::fs::write(&file, "t [s],u [1],y [1]\n0,1,0\n1,1,0.6\n2,1,0.9\n3,1,0.95\n").unwrap();
/// let model = Model::parse(
///     "name = \"lag\"\n[parameters]\nT = { value = 1.0, unit = \"s\" }\n[inputs]\nu = { unit = \"1\" }\n\
///      [states]\nx = { unit = \"1\", rate = \"(u - x)/T\", initial = 0.0 }\n[outputs]\ny = { unit = \"1\", equals = \"x\" }\n",
/// )?;
/// let recording = Recording::read(&file)?;
/// let run = simulate(&model, &recording).run()?;
/// let y = run.output("y").unwrap();
/// assert!((y.predicted().nth(1).unwrap() - (1.0 - (-1.0_f64).exp())).abs() < 1e-4); // x(t) = 1 − exp(−t/T)
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn simulate<'a>(model: &'a Model, recording: &'a Recording) -> Simulating<'a> {
    Simulating { model, recording, tolerance: Options::default().tolerance }
}

/// A run that is asked for; see [`simulate`].
#[derive(Debug, Clone, Copy)]
pub struct Simulating<'a> {
    model: &'a Model,
    recording: &'a Recording,
    tolerance: f64,
}

impl Simulating<'_> {
    /// How far halving the step may move an output, as a share of its standard deviation; between 0 and 1.
    #[must_use]
    pub fn tolerance(mut self, share: f64) -> Self {
        self.tolerance = share;
        self
    }

    /// Runs the model.
    ///
    /// # Errors
    /// `Usage` for a tolerance that is no share; `BadInput` where a channel is missing; `NotComputed` where the run
    /// needs more steps than can be taken.
    pub fn run(self) -> Result<Simulated> {
        let mut ran = self.plain()?;
        ran.held = self.held(&ran);
        ran.turned = turns(self.model, std::slice::from_ref(self.recording)).collect();
        Ok(ran)
    }

    /// The run with inputs as they are read.
    fn plain(&self) -> Result<Simulated> {
        let options = Options::default().with_tolerance(self.tolerance)?;
        let refused = |e: Error| self.model.refusal().unwrap_or(e);
        let simulator = Simulator::new(self.model, self.recording, &options).map_err(refused)?;
        let initials = self.initials(&simulator);
        let ran = simulator.run(&simulator.parameters(), &initials).map_err(refused)?;
        let is_lost = ran.outputs.iter().flatten().any(|v| v.is_nan());
        if let Some(e) = self.model.refusal().filter(|_| is_lost) {
            return Err(e);
        }
        let fitted = simulator.model().states.iter().zip(&initials);
        let fitted = fitted.filter(|(s, _)| matches!(s.initial, Initial::Fit));
        let begins = fitted.map(|(s, x)| (s.name.clone(), s.unit.from_si(*x), s.unit.to_string())).collect();
        let (held, turned) = (Vec::new(), Vec::new());
        Ok(Simulated { simulator, ran, kind: self.recording.kind, begins, held, turned })
    }

    /// Inputs that stay and leap and are read as straight lines, where the run comes nearer to what was measured with all of
    /// them held.
    fn held(&self, ran: &Simulated) -> Vec<String> {
        let looks = |c: &&Channel| c.hold == Hold::Linear && self.is_input(&c.name) && may_be_held(&c.values);
        let names: Vec<String> =
            self.recording.channels.iter().filter(looks).map(|c| c.name.clone()).collect();
        let is_compared = ran.outputs().any(|o| o.errors().0.is_finite());
        if names.is_empty() || !is_compared || self.recording.kind == Kind::Trials {
            return Vec::new();
        }
        let mut recording = self.recording.clone();
        read_held(std::slice::from_mut(&mut recording), &names);
        let other = Simulating { recording: &recording, ..*self }.plain().ok();
        let errors =
            |s: &Simulated| -> f64 { s.outputs().map(|o| o.errors().0.ln()).filter(|e| e.is_finite()).sum() };
        if other.is_some_and(|o| errors(&o) < errors(ran) - NEARER) { names } else { Vec::new() }
    }

    fn is_input(&self, name: &str) -> bool {
        self.model.inputs.iter().any(|i| i.name == name)
    }

    /// How the states begin: fitted ones as they fit what was measured, or where an output shows them first if they
    /// cannot be fitted.
    fn initials(&self, simulator: &Simulator) -> Vec<f64> {
        let options = FitOptions { tolerance: self.tolerance, ..FitOptions::default() };
        match begun_on(self.model, self.recording, &options) {
            Ok(Some((start, initials))) if start == simulator.span().0 => initials,
            _ => simulator.initials(),
        }
    }
}

/// A run of a model; see [`simulate`].
#[derive(Debug, Clone)]
pub struct Simulated {
    simulator: Simulator,
    ran: Trajectory,
    kind: Kind,
    begins: Vec<(String, f64, String)>,
    /// Inputs that should be read as held.
    held: Vec<String>,
    /// What is said of angles that jump by a turn.
    turned: Vec<String>,
}

/// One output of a run, in the unit of the model file.
#[derive(Debug, Clone, Copy)]
pub struct SimulatedOutput<'a> {
    signal: &'a OutputSignal,
    predicted: &'a [f64],
}

impl<'a> SimulatedOutput<'a> {
    /// The output's name in the model.
    pub fn name(&self) -> &'a str {
        &self.signal.name
    }

    /// The unit of the values, as the model gives it.
    pub fn unit(&self) -> &'a str {
        self.signal.unit.text()
    }

    /// Times of its samples, s; row numbers of steady trials.
    pub fn time(&self) -> &'a [f64] {
        &self.signal.time
    }

    /// What was measured; NaN where nothing was.
    pub fn measured(&self) -> impl Iterator<Item = f64> + 'a {
        self.in_unit(&self.signal.measured)
    }

    /// What the model predicts; NaN where its inputs are missing.
    pub fn predicted(&self) -> impl Iterator<Item = f64> + 'a {
        self.in_unit(self.predicted)
    }

    /// Root mean square of measured less predicted, and the largest of them; NaN where nothing can be compared.
    pub fn errors(&self) -> (f64, f64) {
        let (_, rms, worst) = self.signal.errors(self.predicted);
        (rms, worst)
    }

    fn in_unit(&self, si: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        let unit = &self.signal.unit;
        si.iter().map(|v| unit.from_si(*v))
    }
}

impl Simulated {
    /// Every output that the recording measured.
    pub fn outputs(&self) -> impl Iterator<Item = SimulatedOutput<'_>> {
        let pairs = self.simulator.outputs().iter().zip(&self.ran.outputs);
        pairs.map(|(signal, predicted)| SimulatedOutput { signal, predicted })
    }

    /// The output of a name.
    pub fn output(&self, name: &str) -> Option<SimulatedOutput<'_>> {
        self.outputs().find(|o| o.name() == name)
    }

    /// The solver's error as a share of an output's standard deviation, by halving the step; NaN where not known.
    pub fn solver_error(&self) -> f64 {
        self.ran.solver_error
    }

    /// What should be known about the run though it went on.
    pub fn warnings(&self) -> Vec<String> {
        let held = |name: &String| {
            format!(
                "{name} is read as straight lines between its samples; held, the run comes nearer to what was measured: \
                 write `hold = \"previous\"` at its channel in the recording's TOML file"
            )
        };
        let turned = self.turned.iter().cloned();
        turned.chain(self.held.iter().map(held)).chain(warnings(&self.simulator, &self.ran)).collect()
    }

    /// The run in words.
    pub fn text(&self) -> String {
        simulated::summary(&self.simulator, &self.ran, &self.begins)
    }

    /// The predictions as CSV: time, then measured and predicted for every output.
    pub fn csv(&self) -> String {
        simulated::csv(&self.simulator, &self.ran, self.kind)
    }

    /// The simulator behind it.
    #[doc(hidden)]
    pub fn simulator(&self) -> &Simulator {
        &self.simulator
    }
}
