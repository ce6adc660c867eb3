//! FMI 2.0.4: the functions that are used, by the names and types of its headers.

use super::number::{filled, held};
use super::{Event, Kind, Number, Refused, counted, symbol};
use std::ffi::{CStr, c_char, c_int, c_uint, c_void};

type Component = *mut c_void;

unsafe extern "C" {
    fn calloc(count: usize, size: usize) -> *mut c_void;
    fn free(memory: *mut c_void);
}

/// fmi2CallbackFunctions
#[repr(C)]
#[derive(Debug)]
pub(super) struct Callbacks {
    logger: extern "C" fn(*mut c_void, *const c_char, c_int, *const c_char, *const c_char),
    allocate: unsafe extern "C" fn(usize, usize) -> *mut c_void,
    release: unsafe extern "C" fn(*mut c_void),
    finished: *const c_void,
    environment: *mut c_void,
}

impl Callbacks {
    pub fn new() -> Self {
        Self {
            logger: super::silent_two,
            allocate: calloc,
            release: free,
            finished: std::ptr::null(),
            environment: std::ptr::null_mut(),
        }
    }
}

/// fmi2EventInfo
#[repr(C)]
#[derive(Default)]
struct Info {
    again: c_int,
    ends: c_int,
    nominals: c_int,
    resets: c_int,
    is_next: c_int,
    next: f64,
}

type Instantiate = unsafe extern "C" fn(
    *const c_char,
    c_int,
    *const c_char,
    *const c_char,
    *const Callbacks,
    c_int,
    c_int,
) -> Component;
type One = unsafe extern "C" fn(Component) -> c_int;
type Setup = unsafe extern "C" fn(Component, c_int, f64, f64, c_int, f64) -> c_int;
type Get = unsafe extern "C" fn(Component, *const c_uint, usize, *mut f64) -> c_int;
type Set = unsafe extern "C" fn(Component, *const c_uint, usize, *const f64) -> c_int;
type GetInt = unsafe extern "C" fn(Component, *const c_uint, usize, *mut c_int) -> c_int;
type SetInt = unsafe extern "C" fn(Component, *const c_uint, usize, *const c_int) -> c_int;
type InputSlopes = unsafe extern "C" fn(Component, *const c_uint, usize, *const c_int, *const f64) -> c_int;
type Slopes = unsafe extern "C" fn(
    Component,
    *const c_uint,
    usize,
    *const c_uint,
    usize,
    *const f64,
    *mut f64,
) -> c_int;
type Read = unsafe extern "C" fn(Component, *mut f64, usize) -> c_int;

#[derive(Debug)]
pub(super) struct Calls {
    instantiate: Instantiate,
    free: unsafe extern "C" fn(Component),
    setup: Setup,
    enter_initialisation: One,
    exit_initialisation: One,
    reset: One,
    get: Get,
    set: Set,
    /// Integers, then booleans, which are integers too.
    get_whole: [Option<GetInt>; 2],
    set_whole: [Option<SetInt>; 2],
    slopes: Option<Slopes>,
    exchange: Option<Exchange>,
    step: Option<unsafe extern "C" fn(Component, f64, f64, c_int) -> c_int>,
    input_slopes: Option<InputSlopes>,
}

#[derive(Debug)]
struct Exchange {
    enter_events: One,
    discrete: unsafe extern "C" fn(Component, *mut Info) -> c_int,
    enter_continuous: One,
    completed: unsafe extern "C" fn(Component, c_int, *mut c_int, *mut c_int) -> c_int,
    set_time: unsafe extern "C" fn(Component, f64) -> c_int,
    set_states: unsafe extern "C" fn(Component, *const f64, usize) -> c_int,
    rates: Read,
    indicators: Read,
    states: Read,
}

impl Calls {
    pub fn of(l: &libloading::Library, kind: Kind) -> Result<Self, String> {
        let exchange = || -> Result<Exchange, String> {
            Ok(Exchange {
                enter_events: symbol(l, "fmi2EnterEventMode")?,
                discrete: symbol(l, "fmi2NewDiscreteStates")?,
                enter_continuous: symbol(l, "fmi2EnterContinuousTimeMode")?,
                completed: symbol(l, "fmi2CompletedIntegratorStep")?,
                set_time: symbol(l, "fmi2SetTime")?,
                set_states: symbol(l, "fmi2SetContinuousStates")?,
                rates: symbol(l, "fmi2GetDerivatives")?,
                indicators: symbol(l, "fmi2GetEventIndicators")?,
                states: symbol(l, "fmi2GetContinuousStates")?,
            })
        };
        let is_exchange = kind == Kind::ModelExchange;
        Ok(Self {
            instantiate: symbol(l, "fmi2Instantiate")?,
            free: symbol(l, "fmi2FreeInstance")?,
            setup: symbol(l, "fmi2SetupExperiment")?,
            enter_initialisation: symbol(l, "fmi2EnterInitializationMode")?,
            exit_initialisation: symbol(l, "fmi2ExitInitializationMode")?,
            reset: symbol(l, "fmi2Reset")?,
            get: symbol(l, "fmi2GetReal")?,
            set: symbol(l, "fmi2SetReal")?,
            get_whole: [symbol(l, "fmi2GetInteger").ok(), symbol(l, "fmi2GetBoolean").ok()],
            set_whole: [symbol(l, "fmi2SetInteger").ok(), symbol(l, "fmi2SetBoolean").ok()],
            slopes: symbol(l, "fmi2GetDirectionalDerivative").ok(),
            exchange: is_exchange.then(exchange).transpose()?,
            step: (!is_exchange).then(|| symbol(l, "fmi2DoStep")).transpose()?,
            input_slopes: symbol(l, "fmi2SetRealInputDerivatives").ok(),
        })
    }

    pub fn instantiate(
        &self,
        kind: Kind,
        name: &CStr,
        token: &CStr,
        resources: &CStr,
        callbacks: &Callbacks,
    ) -> Component {
        let kind = c_int::from(kind == Kind::CoSimulation);
        // SAFETY: the strings and the callbacks outlive the component: `Instance` keeps them.
        unsafe {
            (self.instantiate)(name.as_ptr(), kind, token.as_ptr(), resources.as_ptr(), callbacks, 0, 0)
        }
    }

    pub fn free(&self, c: Component) {
        // SAFETY: here and below, `c` came from `instantiate` of this library, and slices are as long as is said.
        unsafe { (self.free)(c) }
    }

    fn exchange(&self) -> Result<&Exchange, Refused> {
        self.exchange.as_ref().ok_or(Refused { call: "a call for model exchange", status: -1 })
    }

    pub fn begin_initialisation(&self, c: Component, start: f64, stop: Option<f64>) -> Result<(), Refused> {
        let (is_stop, stop) = (c_int::from(stop.is_some()), stop.unwrap_or(0.0));
        counted("fmi2SetupExperiment", || unsafe { (self.setup)(c, 0, 0.0, start, is_stop, stop) })?;
        counted("fmi2EnterInitializationMode", || unsafe { (self.enter_initialisation)(c) })
    }

    pub fn end_initialisation(&self, c: Component) -> Result<(), Refused> {
        counted("fmi2ExitInitializationMode", || unsafe { (self.exit_initialisation)(c) })
    }

    pub fn reset(&self, c: Component) -> Result<(), Refused> {
        counted("fmi2Reset", || unsafe { (self.reset)(c) })
    }

    pub fn set(&self, c: Component, number: Number, r: &[u32], v: &[f64]) -> Result<(), Refused> {
        assert!(r.len() <= v.len(), "a value for each reference");
        if number != Number::Float64 {
            let call = "fmi2SetInteger";
            let set = self.set_whole[usize::from(number == Number::Boolean)];
            let set = set.ok_or(Refused { call, status: -1 })?;
            let whole: Vec<c_int> = held(v);
            return counted(call, || unsafe { set(c, r.as_ptr(), r.len(), whole.as_ptr()) });
        }
        counted("fmi2SetReal", || unsafe { (self.set)(c, r.as_ptr(), r.len(), v.as_ptr()) })
    }

    pub fn get(&self, c: Component, number: Number, r: &[u32], v: &mut [f64]) -> Result<(), Refused> {
        assert!(r.len() <= v.len(), "a place for each reference");
        if number != Number::Float64 {
            let call = "fmi2GetInteger";
            let get = self.get_whole[usize::from(number == Number::Boolean)];
            let get = get.ok_or(Refused { call, status: -1 })?;
            return filled::<c_int, _>(v, |room| {
                counted(call, || unsafe { get(c, r.as_ptr(), r.len(), room.as_mut_ptr()) })
            });
        }
        counted("fmi2GetReal", || unsafe { (self.get)(c, r.as_ptr(), r.len(), v.as_mut_ptr()) })
    }

    pub fn slopes(&self, c: Component, of: &[u32], by: u32, v: &mut [f64]) -> Result<(), Refused> {
        assert!(of.len() <= v.len(), "a place for each reference");
        let call = "fmi2GetDirectionalDerivative";
        let slopes = self.slopes.ok_or(Refused { call, status: -1 })?;
        counted(call, || unsafe { slopes(c, of.as_ptr(), of.len(), &by, 1, &1.0, v.as_mut_ptr()) })
    }

    pub fn set_time(&self, c: Component, time: f64) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi2SetTime", || unsafe { (e.set_time)(c, time) })
    }

    pub fn set_states(&self, c: Component, x: &[f64]) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi2SetContinuousStates", || unsafe { (e.set_states)(c, x.as_ptr(), x.len()) })
    }

    pub fn states(&self, c: Component, x: &mut [f64]) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi2GetContinuousStates", || unsafe { (e.states)(c, x.as_mut_ptr(), x.len()) })
    }

    pub fn rates(&self, c: Component, x: &mut [f64]) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi2GetDerivatives", || unsafe { (e.rates)(c, x.as_mut_ptr(), x.len()) })
    }

    pub fn indicators(&self, c: Component, x: &mut [f64]) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi2GetEventIndicators", || unsafe { (e.indicators)(c, x.as_mut_ptr(), x.len()) })
    }

    pub fn enter_events(&self, c: Component) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi2EnterEventMode", || unsafe { (e.enter_events)(c) })
    }

    pub fn update_discrete(&self, c: Component) -> Result<Event, Refused> {
        let (e, mut info) = (self.exchange()?, Info::default());
        counted("fmi2NewDiscreteStates", || unsafe { (e.discrete)(c, &mut info) })?;
        Ok(Event {
            again: info.again != 0,
            ends: info.ends != 0,
            resets: info.resets != 0,
            next: (info.is_next != 0).then_some(info.next),
        })
    }

    pub fn enter_continuous(&self, c: Component) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi2EnterContinuousTimeMode", || unsafe { (e.enter_continuous)(c) })
    }

    pub fn completed_step(&self, c: Component) -> Result<bool, Refused> {
        let (e, mut event, mut ends) = (self.exchange()?, 0, 0);
        counted("fmi2CompletedIntegratorStep", || unsafe { (e.completed)(c, 1, &mut event, &mut ends) })?;
        Ok(event != 0)
    }

    pub fn input_slopes(&self, c: Component, r: &[u32], v: &[f64]) -> Result<(), Refused> {
        assert!(r.len() <= v.len(), "a value for each reference");
        let call = "fmi2SetRealInputDerivatives";
        let set = self.input_slopes.ok_or(Refused { call, status: -1 })?;
        let orders: Vec<c_int> = vec![1; r.len()];
        counted(call, || unsafe { set(c, r.as_ptr(), r.len(), orders.as_ptr(), v.as_ptr()) })
    }

    pub fn step(&self, c: Component, from: f64, step: f64) -> Result<bool, Refused> {
        let call = "fmi2DoStep";
        let run = self.step.ok_or(Refused { call, status: -1 })?;
        counted(call, || unsafe { run(c, from, step, 1) }).map(|()| false)
    }
}
