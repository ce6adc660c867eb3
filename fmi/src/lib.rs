//! The C interface of Functional Mock-up Units (FMI 2.0.4 and 3.0.1) behind safe calls.
//!
//! A unit's library is foreign code: whatever it does to this process it does, and no check here can stop it. Run it in
//! a process of its own. All of the unsafe code of that interface stands in this package.
//!
//! # References
//! Functional Mock-up Interface Specification 2.0.4 and 3.0.1, Modelica Association.

mod number;
mod three;
mod two;

pub use number::Number;

use std::ffi::{CString, c_char, c_int, c_void};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Which version of the interface a unit speaks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version {
    /// FMI 2.0
    Two,
    /// FMI 3.0
    Three,
}

/// What an instance is made for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Somebody else's solver integrates its states.
    ModelExchange,
    /// It integrates itself.
    CoSimulation,
}

/// What an event leaves behind.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Event {
    /// Whether it must be asked again before time goes on.
    pub again: bool,
    /// Whether it wants to end.
    pub ends: bool,
    /// Whether it moved its continuous states.
    pub resets: bool,
    /// When the next event comes by the clock, s.
    pub next: Option<f64>,
}

/// A call that the unit did not carry out, with its name and the status that it gave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refused {
    /// Name of the C function.
    pub call: &'static str,
    /// The status: 2 discard, 3 error, 4 fatal; -1 where there is no such function.
    pub status: i32,
}

impl std::fmt::Display for Refused {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let status = match self.status {
            2 => "discard",
            3 => "error",
            4 => "fatal",
            -1 => "no such function",
            _ => "an unknown status",
        };
        write!(f, "{} gave {status}", self.call)
    }
}

impl std::error::Error for Refused {}

static BEGUN: AtomicU64 = AtomicU64::new(0);
static ENDED: AtomicU64 = AtomicU64::new(0);

/// Calls into units that were begun, and those that came back: a watch sees by them whether one hangs.
pub fn calls() -> (u64, u64) {
    (BEGUN.load(Relaxed), ENDED.load(Relaxed))
}

unsafe extern "C" {
    fn atexit(run: extern "C" fn()) -> c_int;
}

/// Runs that when the process ends in order; false where the system takes no more of these.
pub fn at_exit(run: extern "C" fn()) -> bool {
    // SAFETY: the function takes and gives nothing, and lives as long as the process.
    unsafe { atexit(run) == 0 }
}

/// A call that is counted; status 0 and 1 (warning) are well.
fn counted(call: &'static str, run: impl FnOnce() -> c_int) -> Result<(), Refused> {
    BEGUN.fetch_add(1, Relaxed);
    let status = run();
    ENDED.fetch_add(1, Relaxed);
    if status == 0 || status == 1 { Ok(()) } else { Err(Refused { call, status }) }
}

/// The loaded library of a unit.
#[derive(Debug)]
pub struct Library {
    calls: Calls,
    // dropped after the pointers into it
    _library: libloading::Library,
}

#[derive(Debug)]
enum Calls {
    Two(two::Calls),
    Three(three::Calls),
}

impl Library {
    /// Loads the library of a unit.
    ///
    /// # Errors
    /// What the system says where it cannot be loaded; the name of the function that it lacks.
    pub fn load(file: &Path, version: Version, kind: Kind) -> Result<Arc<Self>, String> {
        // SAFETY: what the library does on loading is its own; the caller was told.
        let library = unsafe { libloading::Library::new(file) }.map_err(|e| whole(&e))?;
        let calls = match version {
            Version::Two => Calls::Two(two::Calls::of(&library, kind)?),
            Version::Three => Calls::Three(three::Calls::of(&library, kind)?),
        };
        Ok(Arc::new(Self { calls, _library: library }))
    }
}

/// An error with what lies behind it: the words of the system's loader.
fn whole(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    let mut inner = error.source();
    while let Some(e) = inner {
        text += &format!(": {e}");
        inner = e.source();
    }
    text
}

/// A function of the library.
fn symbol<T: Copy>(library: &libloading::Library, name: &str) -> Result<T, String> {
    // SAFETY: the type is that of the standard; the pointer lives as long as `Library`, which keeps the library open.
    unsafe { library.get::<T>(name.as_bytes()) }.map(|s| *s).map_err(|_| format!("it has no function {name}"))
}

/// One instance of a unit; it stays on the thread that made it.
#[derive(Debug)]
pub struct Instance {
    library: Arc<Library>,
    component: *mut c_void,
    // The unit may keep pointers to these.
    _name: CString,
    _token: CString,
    _resources: CString,
    _callbacks: Option<Box<two::Callbacks>>,
}

impl Instance {
    /// Makes an instance.
    ///
    /// # Errors
    /// Where the unit refuses to be made.
    pub fn new(library: &Arc<Library>, kind: Kind, token: &str, resources: &Path) -> Result<Self, String> {
        let text = |t: &str| CString::new(t).map_err(|_| "a name holds a zero byte".to_owned());
        let (name, token) = (text("unit")?, text(token)?);
        let (component, resources, callbacks) = match &library.calls {
            Calls::Two(calls) => {
                let uri = text(&uri(resources))?;
                let callbacks = Box::new(two::Callbacks::new());
                (calls.instantiate(kind, &name, &token, &uri, &callbacks), uri, Some(callbacks))
            }
            Calls::Three(calls) => {
                let folder = resources.to_string_lossy();
                let folder =
                    text(&if folder.ends_with('/') { folder.into_owned() } else { format!("{folder}/") })?;
                (calls.instantiate(kind, &name, &token, &folder), folder, None)
            }
        };
        if component.is_null() {
            let key = match &library.calls {
                Calls::Two(_) => "guid",
                Calls::Three(_) => "instantiationToken",
            };
            return Err(format!(
                "its library refuses to be instantiated, as a rule because the {key} {} of modelDescription.xml is not its \
                 own: export the FMU once more, description and library together",
                token.to_string_lossy()
            ));
        }
        Ok(Self {
            library: library.clone(),
            component,
            _name: name,
            _token: token,
            _resources: resources,
            _callbacks: callbacks,
        })
    }
}

/// A file URI of a folder.
fn uri(folder: &Path) -> String {
    let mut text = String::from("file:///");
    for byte in folder.to_string_lossy().trim_start_matches('/').bytes() {
        match byte {
            b'\\' => text.push('/'),
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'/' | b'.' | b'_' | b'-' | b'~' | b':' => {
                text.push(char::from(byte));
            }
            _ => text.push_str(&format!("%{byte:02X}")),
        }
    }
    text
}

macro_rules! both {
    ($self:ident, $calls:ident => $two:expr, $three:expr) => {
        match &$self.library.calls {
            Calls::Two($calls) => $two,
            Calls::Three($calls) => $three,
        }
    };
}

impl Instance {
    /// Begins the initialisation; values may then be set.
    ///
    /// # Errors
    /// Where the unit refuses, here and below.
    pub fn begin_initialisation(&mut self, start: f64, stop: Option<f64>) -> Result<(), Refused> {
        let c = self.component;
        both!(self, calls => calls.begin_initialisation(c, start, stop), calls.begin_initialisation(c, start, stop))
    }

    /// Ends the initialisation: a unit for model exchange is then in event mode.
    ///
    /// # Errors
    /// As above.
    pub fn end_initialisation(&mut self) -> Result<(), Refused> {
        let c = self.component;
        both!(self, calls => calls.end_initialisation(c), calls.end_initialisation(c))
    }

    /// Puts it back to where it was when it was made.
    ///
    /// # Errors
    /// As above.
    pub fn reset(&mut self) -> Result<(), Refused> {
        let c = self.component;
        both!(self, calls => calls.reset(c), calls.reset(c))
    }

    /// Sets numbers; an array of FMI 3.0 takes as many values as it has.
    ///
    /// # Errors
    /// As above.
    pub fn set(&mut self, number: Number, references: &[u32], values: &[f64]) -> Result<(), Refused> {
        if references.is_empty() {
            return Ok(());
        }
        let c = self.component;
        both!(self, calls => calls.set(c, number, references, values), calls.set(c, number, references, values))
    }

    /// Reads numbers into a place that is large enough for all.
    ///
    /// # Errors
    /// As above.
    pub fn get(&mut self, number: Number, references: &[u32], values: &mut [f64]) -> Result<(), Refused> {
        if references.is_empty() {
            return Ok(());
        }
        let c = self.component;
        both!(self, calls => calls.get(c, number, references, values), calls.get(c, number, references, values))
    }

    /// Sets the time, s.
    ///
    /// # Errors
    /// As above.
    pub fn set_time(&mut self, time: f64) -> Result<(), Refused> {
        let c = self.component;
        both!(self, calls => calls.set_time(c, time), calls.set_time(c, time))
    }

    /// Sets the continuous states.
    ///
    /// # Errors
    /// As above.
    pub fn set_states(&mut self, states: &[f64]) -> Result<(), Refused> {
        let c = self.component;
        both!(self, calls => calls.set_states(c, states), calls.set_states(c, states))
    }

    /// Reads the continuous states.
    ///
    /// # Errors
    /// As above.
    pub fn states(&mut self, states: &mut [f64]) -> Result<(), Refused> {
        let c = self.component;
        both!(self, calls => calls.states(c, states), calls.states(c, states))
    }

    /// Reads the rates of the continuous states.
    ///
    /// # Errors
    /// As above.
    pub fn rates(&mut self, rates: &mut [f64]) -> Result<(), Refused> {
        let c = self.component;
        both!(self, calls => calls.rates(c, rates), calls.rates(c, rates))
    }

    /// Reads the event indicators.
    ///
    /// # Errors
    /// As above.
    pub fn indicators(&mut self, indicators: &mut [f64]) -> Result<(), Refused> {
        if indicators.is_empty() {
            return Ok(());
        }
        let c = self.component;
        both!(self, calls => calls.indicators(c, indicators), calls.indicators(c, indicators))
    }

    /// Enters event mode.
    ///
    /// # Errors
    /// As above.
    pub fn enter_events(&mut self) -> Result<(), Refused> {
        let c = self.component;
        both!(self, calls => calls.enter_events(c), calls.enter_events(c))
    }

    /// Brings the discrete states up to date.
    ///
    /// # Errors
    /// As above.
    pub fn update_discrete(&mut self) -> Result<Event, Refused> {
        let c = self.component;
        both!(self, calls => calls.update_discrete(c), calls.update_discrete(c))
    }

    /// Enters continuous-time mode.
    ///
    /// # Errors
    /// As above.
    pub fn enter_continuous(&mut self) -> Result<(), Refused> {
        let c = self.component;
        both!(self, calls => calls.enter_continuous(c), calls.enter_continuous(c))
    }

    /// Tells that a step was taken; true where the unit asks for an event.
    ///
    /// # Errors
    /// As above.
    pub fn completed_step(&mut self) -> Result<bool, Refused> {
        let c = self.component;
        both!(self, calls => calls.completed_step(c), calls.completed_step(c))
    }

    /// Lets it step by itself; true where it wants to end.
    ///
    /// # Errors
    /// As above.
    pub fn step(&mut self, from: f64, step: f64) -> Result<bool, Refused> {
        let c = self.component;
        both!(self, calls => calls.step(c, from, step), calls.step(c, from, step))
    }

    /// Sets the rates at which real inputs run during the next step; FMI 3.0 has no such call.
    ///
    /// # Errors
    /// As above.
    pub fn input_slopes(&mut self, references: &[u32], slopes: &[f64]) -> Result<(), Refused> {
        if references.is_empty() {
            return Ok(());
        }
        match &self.library.calls {
            Calls::Two(calls) => calls.input_slopes(self.component, references, slopes),
            Calls::Three(_) => Err(Refused { call: "fmi2SetRealInputDerivatives", status: -1 }),
        }
    }

    /// The derivative of some numbers in the direction of one other, at the present values.
    ///
    /// # Errors
    /// As above.
    pub fn slopes(&mut self, of: &[u32], by: u32, slopes: &mut [f64]) -> Result<(), Refused> {
        let c = self.component;
        both!(self, calls => calls.slopes(c, of, by, slopes), calls.slopes(c, of, by, slopes))
    }
}

impl Drop for Instance {
    fn drop(&mut self) {
        both!(self, calls => calls.free(self.component), calls.free(self.component));
    }
}

extern "C" fn silent_two(_: *mut c_void, _: *const c_char, _: c_int, _: *const c_char, _: *const c_char) {}
extern "C" fn silent_three(_: *mut c_void, _: c_int, _: *const c_char, _: *const c_char) {}
