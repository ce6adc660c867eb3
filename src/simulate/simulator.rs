//! The simulator: built once from a model and a recording, run as often as wanted.

use super::absent;
use super::budget::{Allowance, Budget};
use super::course::Course;
use super::did::Did;
use super::gaps;
use super::machine::registers;
use super::mesh::{Mesh, Samples, Shifted};
use super::native::Natives;
use super::plan::{self, Plan, Planned, Search};
use super::probe::Clock;
use super::request::{Case, Options, Trajectory, Unknown};
use super::signals::{self, OutputSignal};
use super::steps::Solver;
use crate::model::program::Program;
use crate::model::{Dual, Model, Scalar};
use crate::record::{Kind, Recording};
use crate::{Error, Result};
use std::sync::Arc;

/// A model on a recording, ready to run; shared freely between threads.
///
/// ```
/// use gyrospec::model::Model;
/// use gyrospec::record::{Channel, Recording};
/// use gyrospec::simulate::{Options, Simulator, Unknown};
/// use gyrospec::units::Unit;
/// let model = Model::parse(r#"
///     name = "cooling"
///     [parameters]
///     T = { value = 2, unit = "s" }
///     [states]
///     y = { rate = "-y/T", unit = "K", initial = 1 }
///     [outputs]
///     temperature = { equals = "y", unit = "K" }
/// "#)?;
/// let time: Vec<f64> = (0..41).map(|i| 0.1 * f64::from(i)).collect();
/// let measured = Channel::new("temperature", Unit::parse("K")?, time, vec![0.0; 41]);
/// let recording = Recording::from_channels("made", vec![measured])?;
/// let simulator = Simulator::new(&model, &recording, &Options::default())?;
/// let (p, x0) = (simulator.parameters(), simulator.initials());
/// let run = simulator.run_with_sensitivities(&p, &x0, &[Unknown::Parameter(0)])?;
/// assert!((run.outputs[0][40] - (-2.0f64).exp()).abs() < 1e-6);
/// assert!((run.sensitivities[0][0][40] - (-2.0f64).exp()).abs() < 1e-6);
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Simulator {
    pub(super) model: Arc<Model>,
    pub(super) program: Arc<Program>,
    pub(super) natives: Arc<Natives>,
    pub(super) samples: Arc<[Samples]>,
    outputs: Vec<OutputSignal>,
    pub(super) clocks: Vec<Clock>,
    places: Vec<(usize, usize)>,
    pub(super) constants: Vec<(usize, f64)>,
    span: (f64, f64),
    /// Where nothing can be predicted for gaps in the inputs, s.
    blanks: Vec<(f64, f64)>,
    /// The mesh of models without delayed inputs.
    mesh: Option<Arc<Mesh>>,
    pub(super) plan: Plan,
    /// What to take where the plan of order 2 does not do.
    pub(super) careful: Option<Plan>,
    /// What did at the last point, and the stiff steps that do at its own.
    pub(super) did: Did,
    pub(super) tolerance: f64,
    pub(super) budget: Budget,
    /// What a user should know of the recording's channels.
    pub(crate) cautions: Vec<String>,
}

impl Simulator {
    /// Compiles the model for a recording and chooses the steps.
    ///
    /// # Errors
    /// Missing channels, units that do not fit, inputs and outputs without common time; a rate
    /// that is no number at the first step.
    pub fn new(model: &Model, recording: &Recording, options: &Options) -> Result<Self> {
        let program = model.compile()?;
        let recording = &*model.joined(recording)?;
        absent::inputs_present(model, recording)?;
        let samples = signals::inputs(model, recording)?;
        let mut outputs = signals::outputs(model, recording)?;
        let span = signals::span(&samples, &outputs, options.window)?;
        let blanks = gaps::stretches(&samples);
        match recording.kind {
            Kind::Time => signals::cover(&mut outputs, span, &blanks),
            Kind::Trials => signals::cover_trials(&mut outputs, &samples, span),
        }
        let (clocks, places) = signals::clocks(&outputs, &program);
        let mut simulator = Self {
            constants: signals::constants(model, recording)?,
            model: Arc::new(model.clone()),
            program: Arc::new(program),
            natives: Arc::default(),
            samples: samples.into(),
            outputs,
            clocks,
            places,
            span,
            blanks,
            mesh: None,
            plan: Plan { method: Solver::Explicit, substeps: 1, error: 0.0, roughness: 0.0, blew_up: false },
            careful: None,
            did: Did::default(),
            tolerance: options.tolerance,
            budget: options.budget.clone(),
            cautions: signals::cautions(model, recording),
        };
        if simulator.is_dynamic() {
            if recording.kind == Kind::Trials {
                return Err(Error::bad_input(
                    "the recording is a table of steady trials, but the model has states or memory",
                )
                .with_hint("write the steady outputs as expressions of the inputs"));
            }
            signals::lasting(span)?;
            simulator.prepare(options)?;
            if options.waits {
                simulator.wait_after_gaps();
            }
        }
        Ok(simulator)
    }

    fn prepare(&mut self, options: &Options) -> Result<()> {
        let parameters = self.parameters();
        if !self.program.columns.iter().any(|c| c.delay.is_some()) {
            self.mesh = Some(Arc::new(self.new_mesh(&parameters)));
        }
        if let Some((method, substeps)) = options.fixed {
            self.plan =
                Plan { method, substeps: substeps.max(1), error: f64::NAN, roughness: 0.0, blew_up: false };
            return Ok(());
        }
        let mesh = self.mesh_at(&parameters);
        self.check_first_step(&mesh, &parameters)?;
        if let Some(known) = options.planned.filter(|p| p.mesh == (mesh.intervals(), mesh.usual)) {
            (self.plan, self.careful) = (known.plan, known.careful);
            return Ok(());
        }
        let (given, steady) = self.starts(&self.initials());
        let allowance = self.budget.one_run();
        let course = self.course(&mesh, self.plan, &steady, &allowance);
        let search =
            Search { course: &course, parameters: &parameters, given: &given, tolerance: self.tolerance };
        (self.plan, self.careful) = plan::plan(&search)?;
        Ok(())
    }

    /// Leaves out what follows a gap of an input until the model has forgotten it.
    fn wait_after_gaps(&mut self) {
        if self.blanks.is_empty() {
            return;
        }
        let Some(memory) = self.memory(&self.parameters(), &self.initials()) else { return };
        let gaps = gaps::gaps(&self.samples, memory);
        let covered = |o: &OutputSignal| -> Vec<f64> {
            o.time.iter().zip(&o.covered).filter(|(_, c)| **c).map(|(t, _)| *t).collect()
        };
        match gaps::with_waits(&gaps, self.outputs.iter().flat_map(covered), memory) {
            Some(longer) => {
                self.blanks = longer;
                signals::cover(&mut self.outputs, self.span, &self.blanks);
            }
            None => self.cautions.extend(gaps::lasting(&gaps, &self.model)),
        }
    }

    /// The same model and steps on another part of the recording; the initial states then stand at
    /// the start of the window.
    ///
    /// # Errors
    /// A window without common time of inputs and outputs.
    pub fn on_window(&self, from: f64, to: f64) -> Result<Self> {
        let mut part = self.clone();
        part.span = signals::span(&self.samples, &self.outputs, Some((from, to)))?;
        if part.is_dynamic() {
            signals::lasting(part.span)?;
        }
        signals::cover(&mut part.outputs, part.span, &part.blanks);
        if self.mesh.is_some() {
            part.mesh = Some(Arc::new(part.new_mesh(&self.parameters())));
        }
        Ok(part)
    }

    /// Whether the model has states or memory.
    pub fn is_dynamic(&self) -> bool {
        !self.program.rates.is_empty() || self.program.has_memory
    }

    /// The model that is run.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The outputs with their channels, in the model's order.
    pub fn outputs(&self) -> &[OutputSignal] {
        &self.outputs
    }

    /// First and last simulated time, s.
    pub fn span(&self) -> (f64, f64) {
        self.span
    }

    /// The method, and the steps in a usual interval of the inputs.
    pub fn steps(&self) -> (Solver, usize) {
        (self.plan.method, self.plan.substeps)
    }

    /// How it runs, for a model much like this one; none where that depends on the parameters, or did not do.
    pub(crate) fn planned(&self) -> Option<Planned> {
        let mesh = self.mesh.as_ref()?;
        let does = !self.plan.blew_up && self.plan.error <= self.tolerance;
        does.then_some(Planned {
            plan: self.plan,
            careful: self.careful,
            mesh: (mesh.intervals(), mesh.usual),
        })
    }

    /// Parameters that the recording knows itself: (number, SI value).
    pub fn constants(&self) -> &[(usize, f64)] {
        &self.constants
    }

    /// The model's parameters in SI, the recording's constants in place.
    pub fn parameters(&self) -> Vec<f64> {
        self.with_constants(&self.model.parameters.iter().map(|p| p.value).collect::<Vec<_>>())
    }

    pub(super) fn with_constants(&self, parameters: &[f64]) -> Vec<f64> {
        let mut own = parameters.to_vec();
        for (k, value) in &self.constants {
            own[*k] = *value;
        }
        own
    }

    /// The start of every state, the model's own where NaN is given, and the states that start steady.
    pub(super) fn starts(&self, initials: &[f64]) -> (Vec<f64>, Vec<usize>) {
        let mut starts = initials.to_vec();
        if starts.iter().any(|x| x.is_nan()) {
            let own = self.initials();
            starts.iter_mut().zip(own).filter(|(x, _)| x.is_nan()).for_each(|(x, own)| *x = own);
        }
        let steady = (0..starts.len()).filter(|i| starts[*i].is_nan()).collect();
        (starts, steady)
    }

    /// Runs from initial states (one a state of the model; NaN for the model's own start).
    ///
    /// # Errors
    /// Wrong lengths; a rate that is no number at the first step; no steady state.
    pub fn run(&self, parameters: &[f64], initials: &[f64]) -> Result<Trajectory> {
        self.run_with_sensitivities(parameters, initials, &[])
    }

    /// Runs, and differentiates every output with respect to unknowns.
    ///
    /// # Errors
    /// As [`Simulator::run`].
    pub fn run_with_sensitivities(
        &self,
        parameters: &[f64],
        initials: &[f64],
        unknowns: &[Unknown],
    ) -> Result<Trajectory> {
        if parameters.len() != self.model.parameters.len() || initials.len() != self.model.states.len() {
            return Err(Error::usage("as many parameters and initial states are needed as the model has"));
        }
        let case = Case {
            parameters: self.with_constants(parameters),
            initials,
            unknowns: &[],
            clocks: &self.clocks,
        };
        let mut out = Trajectory {
            outputs: Vec::new(),
            sensitivities: vec![Vec::new(); self.outputs.len()],
            solver_error: self.plan.error,
            blew_up: None,
            events: 0,
        };
        if unknowns.is_empty() {
            self.add::<f64>(&case, &mut out)?;
        }
        for chunk in unknowns.chunks(8) {
            let case = Case { unknowns: chunk, ..case.clone() };
            match chunk.len() {
                0..=2 => self.add::<Dual<2>>(&case, &mut out)?,
                3..=4 => self.add::<Dual<4>>(&case, &mut out)?,
                _ => self.add::<Dual<8>>(&case, &mut out)?,
            }
        }
        Ok(out)
    }

    /// How far each state moves in a run, from its lowest to its highest value; none where the run does not
    /// go to its end, or the model has no states.
    ///
    /// # Errors
    /// As [`Simulator::run`].
    pub fn swings(&self, parameters: &[f64], initials: &[f64]) -> Result<Option<Vec<(f64, f64)>>> {
        let parameters = self.with_constants(parameters);
        let case = Case { parameters, initials, unknowns: &[], clocks: &self.clocks };
        let (ran, _) = self.ran::<f64>(&case)?;
        Ok(Some(ran.swings).filter(|_| ran.blew_up.is_none()))
    }

    /// Runs one chunk of unknowns and adds what it gives.
    fn add<T: Scalar>(&self, case: &Case<'_>, out: &mut Trajectory) -> Result<()> {
        let (ran, plan) = self.ran::<T>(case)?;
        (out.blew_up, out.events) = (ran.blew_up, ran.events);
        // towards a pole no step is short enough
        out.solver_error = if ran.blew_up.is_some() { f64::NAN } else { plan.foretold(ran.roughness) };
        let take = |o: usize, f: &dyn Fn(T) -> f64| -> Vec<f64> {
            let (clock, column) = self.places[o];
            let width = self.clocks[clock].registers.len();
            let values = ran.values[clock].iter().skip(column).step_by(width);
            values.zip(&self.outputs[o].covered).map(|(v, c)| if *c { f(*v) } else { f64::NAN }).collect()
        };
        if out.outputs.is_empty() {
            out.outputs = (0..self.outputs.len()).map(|o| take(o, &Scalar::value)).collect();
        }
        for o in 0..self.outputs.len() {
            out.sensitivities[o].extend((0..case.unknowns.len()).map(|d| take(o, &|v: T| v.tangent(d))));
        }
        Ok(())
    }

    pub(super) fn mesh_at(&self, parameters: &[f64]) -> Arc<Mesh> {
        self.mesh.clone().unwrap_or_else(|| Arc::new(self.new_mesh(parameters)))
    }

    fn new_mesh(&self, parameters: &[f64]) -> Mesh {
        let r = registers(&self.program, parameters);
        let columns = self.program.columns.iter();
        let columns: Vec<Shifted> = columns
            .map(|c| Shifted { input: c.input, delay: c.delay.map_or(0.0, |d| r[usize::from(d)]) })
            .collect();
        let alone = columns.is_empty();
        let times = self.clocks.iter().filter(|_| alone).flat_map(|c| c.time.iter().copied());
        let mut others: Vec<f64> = times.collect();
        others.sort_unstable_by(f64::total_cmp);
        Mesh::new(&self.samples, &columns, self.span, &others)
    }

    pub(super) fn course<'a>(
        &'a self,
        mesh: &'a Mesh,
        plan: Plan,
        steady: &'a [usize],
        allowance: &'a Allowance<'a>,
    ) -> Course<'a> {
        Course {
            program: &self.program,
            natives: &self.natives,
            mesh,
            clocks: &self.clocks,
            steady,
            method: plan.method,
            substeps: plan.substeps,
            allowance,
        }
    }
}
