//! A model run on a recording.

use crate::Result;
use crate::model::Model;
use crate::record::{Kind, Recording};
use crate::report::simulated;
use crate::simulate::{Options, Simulator, Trajectory, warnings};
use crate::{Error, ErrorKind};

/// Asks for a run of a model on the inputs of a recording, at the values of the model file.
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
/// assert!((y.predicted[1] - (1.0 - (-1.0_f64).exp())).abs() < 1e-4); // x(t) = 1 − exp(−t/T)
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
        if !(self.tolerance > 0.0 && self.tolerance < 1.0) {
            let says = format!("the tolerance {} is no share of a standard deviation", self.tolerance);
            return Err(
                Error::new(ErrorKind::Usage, says).with_hint("give a number between 0 and 1, such as 1e-5")
            );
        }
        let options = Options { tolerance: self.tolerance, ..Options::default() };
        let simulator = Simulator::new(self.model, self.recording, &options)?;
        let ran = simulator.run(&simulator.parameters(), &simulator.initials())?;
        Ok(Simulated { simulator, ran, kind: self.recording.kind })
    }
}

/// A run of a model; see [`simulate`].
pub struct Simulated {
    simulator: Simulator,
    ran: Trajectory,
    kind: Kind,
}

/// One output of a run, in the unit of the model file.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SimulatedOutput {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Times of its samples, s; row numbers of steady trials.
    pub time: Vec<f64>,
    /// What was measured; NaN where nothing was.
    pub measured: Vec<f64>,
    /// What the model predicts; NaN where its inputs are missing.
    pub predicted: Vec<f64>,
    /// Root mean square of measured less predicted.
    pub rms_error: f64,
    /// The largest of measured less predicted.
    pub worst_error: f64,
}

impl Simulated {
    /// Every output that the recording measured.
    pub fn outputs(&self) -> impl Iterator<Item = SimulatedOutput> {
        self.simulator.outputs().iter().zip(&self.ran.outputs).map(|(o, predicted)| {
            let (_, rms_error, worst_error) = o.errors(predicted);
            let in_unit = |si: &[f64]| si.iter().map(|v| o.unit.from_si(*v)).collect();
            SimulatedOutput {
                name: o.name.clone(),
                unit: o.unit.text().to_owned(),
                time: o.time.to_vec(),
                measured: in_unit(&o.measured),
                predicted: in_unit(predicted),
                rms_error,
                worst_error,
            }
        })
    }

    /// The output of a name.
    pub fn output(&self, name: &str) -> Option<SimulatedOutput> {
        self.outputs().find(|o| o.name == name)
    }

    /// The solver's error as a share of an output's standard deviation, by halving the step; NaN where not known.
    pub fn solver_error(&self) -> f64 {
        self.ran.solver_error
    }

    /// What should be known about the run though it went on.
    pub fn warnings(&self) -> Vec<String> {
        warnings(&self.simulator, &self.ran)
    }

    /// The run in words.
    pub fn text(&self) -> String {
        simulated::summary(&self.simulator, &self.ran)
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
