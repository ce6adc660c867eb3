//! The registers of a run: loads times and states, gives rates, lets switches slide.

use super::history::History;
use super::mesh::Mesh;
use super::table::Table;
use crate::model::Scalar;
use crate::model::program::{Program, Remembered, Switching, execute};
use gyrospec_native::Steps;

/// The registers of one run and what they were last loaded with.
pub(super) struct Machine<'a, T> {
    pub program: &'a Program,
    pub r: Vec<T>,
    pub mesh: &'a Mesh,
    pub switching: Switching,
    /// Numbers of the watched switches that slide.
    pub sliding: Vec<usize>,
    pub pasts: Vec<History<T>>,
    interval: usize,
    /// −(T − value of T) of every column: no value, but the tangents of its delay.
    lead: Vec<Option<T>>,
    /// What a column that jumps had before, where it is held back at that.
    back: Vec<Option<f64>>,
    loaded: f64,
    /// What the inputs alone make, where it is known beforehand.
    pub table: Option<&'a Table>,
    /// What was made machine code.
    pub native: Option<&'a Steps>,
    scratch: Vec<T>,
}

#[inline(always)]
fn at(register: u16) -> usize {
    usize::from(register)
}

impl<'a, T: Scalar> Machine<'a, T> {
    /// Registers with constants and parameters, and what depends on these alone.
    pub fn new(program: &'a Program, mesh: &'a Mesh, parameters: &[T]) -> Self {
        let r = registers(program, parameters);
        let lead: Vec<_> =
            program.columns.iter().map(|c| c.delay.map(|d| tangents_only(-r[at(d)]))).collect();
        let is_past = |m: &&Remembered| matches!(m, Remembered::Past { .. });
        let pasts = program.remembered.iter().filter(is_past).map(|_| History::default()).collect();
        let switches = program.watches.len();
        Self {
            program,
            r,
            mesh,
            switching: Switching::Hold,
            sliding: Vec::with_capacity(switches),
            pasts,
            interval: 0,
            back: vec![None; lead.len()],
            lead,
            loaded: f64::NAN,
            table: None,
            native: None,
            scratch: Vec::with_capacity(switches * (switches + 1)),
        }
    }

    /// Moves to an interval of the mesh.
    pub fn enter(&mut self, interval: usize) {
        self.interval = interval;
        for (c, column) in self.program.columns.iter().enumerate() {
            self.r[at(column.slope)] = T::constant(self.mesh.slope[interval * self.mesh.columns + c]);
        }
        if self.jumps(interval) || self.tangents_bend() {
            self.loaded = f64::NAN;
        }
    }

    /// Loads the end of the last interval as what is measured then sees it, with the switches where that puts them.
    pub fn load_last(&mut self, x: &[T]) {
        self.sliding.clear();
        self.switching = Switching::Follow;
        self.back = self.mesh.last.iter().copied().map(Some).collect();
        self.loaded = f64::NAN;
        self.load(self.mesh.time[self.mesh.intervals()], x);
    }

    /// Whether a held input jumps at the start of an interval.
    pub fn jumps(&self, interval: usize) -> bool {
        self.mesh.jumps.get(interval).is_some_and(|jumps| *jumps)
    }

    /// Whether what is measured at a time sees a held input jump, where that is the end of the interval.
    pub fn shows_after(&self, t: f64) -> bool {
        let is_seen = || self.mesh.shows.get(self.interval + 1).is_some_and(|s| *s);
        t == self.mesh.time[self.interval + 1] && is_seen()
    }

    /// Holds the inputs that are set after what is measured at the start of the interval back at what they were, or lets
    /// them go.
    pub fn hold_late_back(&mut self, is_held: bool) {
        for c in (0..self.mesh.columns).filter(|c| self.mesh.late[*c]) {
            self.hold_back(c, is_held);
        }
    }

    /// Whether the tangents of an input jump where it bends, because its delay has some.
    pub fn tangents_bend(&self) -> bool {
        T::TANGENTS > 0 && self.lead.iter().any(Option::is_some)
    }

    /// The held inputs that jump at the start of the interval, with the tangents of their delays.
    pub fn jumping_columns(&self) -> Vec<(usize, Option<T>)> {
        let first = self.interval * self.mesh.columns;
        let jumps = |c: &usize| self.mesh.end[first - self.mesh.columns + c] != self.mesh.start[first + c];
        (0..self.mesh.columns).filter(jumps).map(|c| (c, self.lead[c].map(|lead| -lead))).collect()
    }

    /// Holds an input that jumps at the start of the interval back at what it was before, or lets it go.
    pub fn hold_back(&mut self, column: usize, is_held: bool) {
        let before = (self.interval - 1) * self.mesh.columns + column;
        self.back[column] = is_held.then(|| self.mesh.end[before]);
        self.loaded = f64::NAN;
    }

    /// Whether a whole step can be taken without a look at the registers between: no switch slides or follows, and
    /// no past is asked for.
    pub fn is_smooth(&self) -> bool {
        self.switching == Switching::Hold && self.sliding.is_empty() && self.pasts.is_empty()
    }

    /// Forgets which time the registers hold, after a switch has changed.
    pub fn forget_time(&mut self) {
        self.loaded = f64::NAN;
    }

    /// Loads a time: inputs, and what depends on them alone.
    #[inline]
    pub fn load_time(&mut self, t: f64) {
        if t != self.loaded {
            self.load_new_time(t);
        }
    }

    fn load_new_time(&mut self, t: f64) {
        self.load_data(t);
        self.load_made();
    }

    /// Loads the time of a stage of a piece of the interval; a table may know what the inputs alone make there.
    pub fn load_stage(&mut self, t: f64, piece: Option<usize>, stage: usize) {
        let (Some(table), Some(piece)) = (self.table, piece) else { return self.load_time(t) };
        if t == self.loaded {
            return;
        }
        self.load_inputs(t);
        for (r, value) in table.made(self.interval, piece, stage) {
            self.r[at(r)] = T::constant(value);
        }
        self.load_made();
    }

    /// The machine code, which knows no switches that follow.
    fn held_native(&self) -> Option<&'a Steps> {
        self.native.filter(|_| self.switching == Switching::Hold)
    }

    /// What a new time asks for beyond what was measured.
    fn load_made(&mut self) {
        match self.held_native() {
            Some(native) => native.time(&mut self.r),
            None => execute(self.program, &self.program.per_time, &mut self.r, self.switching),
        }
    }

    /// The outputs; states and time must be loaded.
    pub fn outputs(&mut self) {
        match self.held_native() {
            Some(native) => native.output(&mut self.r),
            None => execute(self.program, &self.program.output_code, &mut self.r, self.switching),
        }
    }

    /// What the states make; states and time must be loaded.
    fn run_states(&mut self) {
        match self.held_native() {
            Some(native) => native.state(&mut self.r),
            None => execute(self.program, &self.program.per_state, &mut self.r, self.switching),
        }
    }

    /// Loads a time, and computes what the inputs and the time alone make.
    pub fn load_data(&mut self, t: f64) {
        self.load_inputs(t);
        execute(self.program, &self.program.per_data, &mut self.r, self.switching);
    }

    fn load_inputs(&mut self, t: f64) {
        self.loaded = t;
        let into = t - self.mesh.time[self.interval];
        let at_end = t == self.mesh.time[self.interval + 1];
        let first = self.interval * self.mesh.columns;
        for (c, column) in self.program.columns.iter().enumerate() {
            let slope = self.mesh.slope[first + c];
            let loaded = || {
                if at_end { self.mesh.end[first + c] } else { self.mesh.start[first + c] + slope * into }
            };
            let value = T::constant(self.back[c].unwrap_or_else(loaded));
            self.r[at(column.value)] = match self.lead[c] {
                Some(lead) => value + lead.scale(slope),
                None => value,
            };
        }
        self.r[at(self.program.time)] = T::constant(t);
    }

    /// Loads a time and a state.
    #[inline]
    pub fn load(&mut self, t: f64, x: &[T]) {
        self.load_time(t);
        for (register, value) in self.program.states.iter().zip(x) {
            self.r[at(*register)] = *value;
        }
        if !self.pasts.is_empty() {
            self.load_pasts(t);
        }
        if self.sliding.is_empty() {
            self.run_states();
        } else {
            self.slide();
        }
    }

    /// The rates at a time and a state.
    #[inline]
    pub fn rates(&mut self, t: f64, x: &[T], out: &mut [T]) {
        self.load(t, x);
        for (o, register) in out.iter_mut().zip(&self.program.rates) {
            *o = self.r[at(*register)];
        }
    }

    fn load_pasts(&mut self, t: f64) {
        let mut slot = 0;
        for m in &self.program.remembered {
            if let Remembered::Past { delay, value, slope, .. } = *m {
                let when = T::constant(t) - self.r[at(delay)];
                let (v, s) = self.pasts[slot].at(when);
                self.r[at(value)] = v;
                self.r[at(slope)] = s;
                slot += 1;
            }
        }
    }

    /// The motion of the guards; states and time must be loaded.
    pub fn motions(&mut self) {
        match self.held_native() {
            Some(native) => native.motion(&mut self.r),
            None => execute(self.program, &self.program.motion_code, &mut self.r, self.switching),
        }
    }

    fn try_signs(&mut self, signs: impl Fn(usize) -> f64) {
        for (j, k) in self.sliding.iter().enumerate() {
            self.r[at(self.program.watches[*k].sign)] = T::constant(signs(j));
        }
        self.run_states();
        self.motions();
    }

    /// Finds the signs u of the sliding switches for which their guards stand still.
    ///
    /// The guards' motion is affine in u: ġ(u) = ġ(0) + Σ uⱼ·(ġ(eⱼ) − ġ(0)) = 0.
    fn slide(&mut self) {
        let n = self.sliding.len();
        let mut table = std::mem::take(&mut self.scratch);
        table.clear();
        table.resize(n * (n + 1), T::constant(0.0));
        self.try_signs(|_| 0.0);
        for i in 0..n {
            table[i * (n + 1) + n] = -self.guard_motion(i);
        }
        for j in 0..n {
            self.try_signs(|other| f64::from(u8::from(other == j)));
            for i in 0..n {
                table[i * (n + 1) + j] = self.guard_motion(i) + table[i * (n + 1) + n];
            }
        }
        super::linear::solve_table(&mut table, n);
        for (i, k) in self.sliding.iter().enumerate() {
            self.r[at(self.program.watches[*k].sign)] = table[i * (n + 1) + n];
        }
        self.scratch = table;
        self.run_states();
    }

    fn guard_motion(&self, sliding: usize) -> T {
        self.r[at(self.program.watches[self.sliding[sliding]].motion)]
    }

    /// Ends a step at a loaded time and state: held values move on, pasts are kept.
    pub fn commit(&mut self, t: f64) {
        if self.program.remembered.is_empty() {
            return;
        }
        if !self.pasts.is_empty() {
            self.motions();
        }
        let mut slot = 0;
        for m in &self.program.remembered {
            match *m {
                Remembered::Hidden { .. } => {}
                Remembered::Held { held, next, .. } => self.r[at(held)] = self.r[at(next)],
                Remembered::Past { signal, motion, .. } => {
                    self.pasts[slot].push(t, self.r[at(signal)], self.r[at(motion)]);
                    slot += 1;
                }
            }
        }
    }

    /// The Jacobian ∂f/∂x row by row and ∂f/∂t at the loaded time and state.
    pub fn slopes(&mut self, jacobian: &mut [T], explicit_time: &mut [T]) {
        match self.held_native() {
            Some(native) if native.has_slopes() => native.slopes(&mut self.r),
            _ => execute(self.program, &self.program.jacobian_code, &mut self.r, self.switching),
        }
        for (o, register) in jacobian.iter_mut().zip(&self.program.jacobian) {
            *o = self.r[at(*register)];
        }
        for (o, register) in explicit_time.iter_mut().zip(&self.program.explicit_time) {
            *o = self.r[at(*register)];
        }
    }
}

/// Fresh registers: constants, parameters, and what depends on these alone.
pub(super) fn registers<T: Scalar>(program: &Program, parameters: &[T]) -> Vec<T> {
    let mut r = vec![T::constant(0.0); program.registers];
    for (register, value) in &program.constants {
        r[at(*register)] = T::constant(*value);
    }
    for (register, value) in program.parameters.iter().zip(parameters) {
        r[at(*register)] = *value;
    }
    execute(program, &program.once, &mut r, Switching::Follow);
    r
}

/// The same tangents with the value 0.
pub(super) fn tangents_only<T: Scalar>(x: T) -> T {
    x - T::constant(x.value())
}
