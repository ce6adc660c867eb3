//! FMI 3.0.1: the functions that are used, by the names and types of its headers.

use super::number::{Held, filled, held};
use super::{Event, Kind, Number, Refused, counted, symbol};
use std::ffi::{CStr, c_char, c_int, c_uint, c_void};

type Component = *mut c_void;
type Logger = extern "C" fn(*mut c_void, c_int, *const c_char, *const c_char);

type ForExchange = unsafe extern "C" fn(
    *const c_char,
    *const c_char,
    *const c_char,
    bool,
    bool,
    *mut c_void,
    Option<Logger>,
) -> Component;
type ForSimulation = unsafe extern "C" fn(
    *const c_char,
    *const c_char,
    *const c_char,
    bool,
    bool,
    bool,
    bool,
    *const c_uint,
    usize,
    *mut c_void,
    Option<Logger>,
    *const c_void,
) -> Component;
type One = unsafe extern "C" fn(Component) -> c_int;
/// The functions of all types of numbers differ in what the pointer points at.
type Get = unsafe extern "C" fn(Component, *const c_uint, usize, *mut c_void, usize) -> c_int;
type Set = unsafe extern "C" fn(Component, *const c_uint, usize, *const c_void, usize) -> c_int;
type Slopes = unsafe extern "C" fn(
    Component,
    *const c_uint,
    usize,
    *const c_uint,
    usize,
    *const f64,
    usize,
    *mut f64,
    usize,
) -> c_int;
type Read = unsafe extern "C" fn(Component, *mut f64, usize) -> c_int;
type Discrete =
    unsafe extern "C" fn(Component, *mut bool, *mut bool, *mut bool, *mut bool, *mut bool, *mut f64) -> c_int;
type Step =
    unsafe extern "C" fn(Component, f64, f64, bool, *mut bool, *mut bool, *mut bool, *mut f64) -> c_int;

#[derive(Debug)]
pub(super) struct Calls {
    free: unsafe extern "C" fn(Component),
    enter_initialisation: unsafe extern "C" fn(Component, bool, f64, f64, bool, f64) -> c_int,
    exit_initialisation: One,
    reset: One,
    /// In the order of `Number::ALL`.
    get: Vec<Get>,
    set: Vec<Set>,
    slopes: Slopes,
    enter_events: One,
    discrete: Discrete,
    exchange: Option<Exchange>,
    simulation: Option<(ForSimulation, Step)>,
}

#[derive(Debug)]
struct Exchange {
    instantiate: ForExchange,
    enter_continuous: One,
    completed: unsafe extern "C" fn(Component, bool, *mut bool, *mut bool) -> c_int,
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
                instantiate: symbol(l, "fmi3InstantiateModelExchange")?,
                enter_continuous: symbol(l, "fmi3EnterContinuousTimeMode")?,
                completed: symbol(l, "fmi3CompletedIntegratorStep")?,
                set_time: symbol(l, "fmi3SetTime")?,
                set_states: symbol(l, "fmi3SetContinuousStates")?,
                rates: symbol(l, "fmi3GetContinuousStateDerivatives")?,
                indicators: symbol(l, "fmi3GetEventIndicators")?,
                states: symbol(l, "fmi3GetContinuousStates")?,
            })
        };
        let is_exchange = kind == Kind::ModelExchange;
        let simulation = || -> Result<(ForSimulation, Step), String> {
            Ok((symbol(l, "fmi3InstantiateCoSimulation")?, symbol(l, "fmi3DoStep")?))
        };
        fn all<T: Copy>(l: &libloading::Library, verb: &str) -> Result<Vec<T>, String> {
            Number::ALL.iter().map(|n| symbol(l, &format!("fmi3{verb}{}", n.name()))).collect()
        }
        Ok(Self {
            free: symbol(l, "fmi3FreeInstance")?,
            enter_initialisation: symbol(l, "fmi3EnterInitializationMode")?,
            exit_initialisation: symbol(l, "fmi3ExitInitializationMode")?,
            reset: symbol(l, "fmi3Reset")?,
            get: all(l, "Get")?,
            set: all(l, "Set")?,
            slopes: symbol(l, "fmi3GetDirectionalDerivative")?,
            enter_events: symbol(l, "fmi3EnterEventMode")?,
            discrete: symbol(l, "fmi3UpdateDiscreteStates")?,
            exchange: is_exchange.then(exchange).transpose()?,
            simulation: (!is_exchange).then(simulation).transpose()?,
        })
    }

    pub fn instantiate(&self, _: Kind, name: &CStr, token: &CStr, resources: &CStr) -> Component {
        let (name, token, resources) = (name.as_ptr(), token.as_ptr(), resources.as_ptr());
        let (nothing, logger) = (std::ptr::null_mut(), Some(super::silent_three as Logger));
        // SAFETY: the strings outlive the component: `Instance` keeps them.
        match (&self.exchange, &self.simulation) {
            (Some(e), _) => unsafe { (e.instantiate)(name, token, resources, false, false, nothing, logger) },
            (None, Some((instantiate, _))) => unsafe {
                instantiate(
                    name,
                    token,
                    resources,
                    false,
                    false,
                    false,
                    false,
                    std::ptr::null(),
                    0,
                    nothing,
                    logger,
                    std::ptr::null(),
                )
            },
            (None, None) => std::ptr::null_mut(),
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
        let (is_stop, stop) = (stop.is_some(), stop.unwrap_or(0.0));
        counted("fmi3EnterInitializationMode", || unsafe {
            (self.enter_initialisation)(c, false, 0.0, start, is_stop, stop)
        })
    }

    pub fn end_initialisation(&self, c: Component) -> Result<(), Refused> {
        counted("fmi3ExitInitializationMode", || unsafe { (self.exit_initialisation)(c) })
    }

    pub fn reset(&self, c: Component) -> Result<(), Refused> {
        counted("fmi3Reset", || unsafe { (self.reset)(c) })
    }

    pub fn set(&self, c: Component, number: Number, r: &[u32], v: &[f64]) -> Result<(), Refused> {
        match number {
            Number::Float64 => self.put(c, number, r, v),
            Number::Float32 => self.put::<f32>(c, number, r, &held(v)),
            Number::Int8 => self.put::<i8>(c, number, r, &held(v)),
            Number::UInt8 => self.put::<u8>(c, number, r, &held(v)),
            Number::Boolean => {
                let bytes: Vec<u8> = v.iter().map(|v| u8::from(*v != 0.0)).collect();
                self.put(c, number, r, &bytes)
            }
            Number::Int16 => self.put::<i16>(c, number, r, &held(v)),
            Number::UInt16 => self.put::<u16>(c, number, r, &held(v)),
            Number::Int32 => self.put::<i32>(c, number, r, &held(v)),
            Number::UInt32 => self.put::<u32>(c, number, r, &held(v)),
            Number::Int64 => self.put::<i64>(c, number, r, &held(v)),
            Number::UInt64 => self.put::<u64>(c, number, r, &held(v)),
        }
    }

    /// Values of the type of that number: `u8` for a boolean, whose bytes are 0 and 1.
    fn put<T>(&self, c: Component, number: Number, r: &[u32], v: &[T]) -> Result<(), Refused> {
        let set = self.set[number as usize];
        counted("fmi3Set", || unsafe { set(c, r.as_ptr(), r.len(), v.as_ptr().cast(), v.len()) })
    }

    pub fn get(&self, c: Component, number: Number, r: &[u32], v: &mut [f64]) -> Result<(), Refused> {
        match number {
            Number::Float64 => self.take(c, number, r, v),
            Number::Float32 => self.taken::<f32>(c, number, r, v),
            Number::Int8 => self.taken::<i8>(c, number, r, v),
            Number::UInt8 | Number::Boolean => self.taken::<u8>(c, number, r, v),
            Number::Int16 => self.taken::<i16>(c, number, r, v),
            Number::UInt16 => self.taken::<u16>(c, number, r, v),
            Number::Int32 => self.taken::<i32>(c, number, r, v),
            Number::UInt32 => self.taken::<u32>(c, number, r, v),
            Number::Int64 => self.taken::<i64>(c, number, r, v),
            Number::UInt64 => self.taken::<u64>(c, number, r, v),
        }
    }

    fn taken<T: Held>(&self, c: Component, number: Number, r: &[u32], v: &mut [f64]) -> Result<(), Refused> {
        filled::<T, _>(v, |room| self.take(c, number, r, room))
    }

    fn take<T>(&self, c: Component, number: Number, r: &[u32], v: &mut [T]) -> Result<(), Refused> {
        let get = self.get[number as usize];
        counted("fmi3Get", || unsafe { get(c, r.as_ptr(), r.len(), v.as_mut_ptr().cast(), v.len()) })
    }

    pub fn slopes(&self, c: Component, of: &[u32], by: u32, v: &mut [f64]) -> Result<(), Refused> {
        counted("fmi3GetDirectionalDerivative", || unsafe {
            (self.slopes)(c, of.as_ptr(), of.len(), &by, 1, &1.0, 1, v.as_mut_ptr(), v.len())
        })
    }

    pub fn set_time(&self, c: Component, time: f64) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi3SetTime", || unsafe { (e.set_time)(c, time) })
    }

    pub fn set_states(&self, c: Component, x: &[f64]) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi3SetContinuousStates", || unsafe { (e.set_states)(c, x.as_ptr(), x.len()) })
    }

    pub fn states(&self, c: Component, x: &mut [f64]) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi3GetContinuousStates", || unsafe { (e.states)(c, x.as_mut_ptr(), x.len()) })
    }

    pub fn rates(&self, c: Component, x: &mut [f64]) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi3GetContinuousStateDerivatives", || unsafe { (e.rates)(c, x.as_mut_ptr(), x.len()) })
    }

    pub fn indicators(&self, c: Component, x: &mut [f64]) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi3GetEventIndicators", || unsafe { (e.indicators)(c, x.as_mut_ptr(), x.len()) })
    }

    pub fn enter_events(&self, c: Component) -> Result<(), Refused> {
        counted("fmi3EnterEventMode", || unsafe { (self.enter_events)(c) })
    }

    pub fn update_discrete(&self, c: Component) -> Result<Event, Refused> {
        let (mut again, mut ends, mut nominals, mut resets) = (false, false, false, false);
        let (mut is_next, mut next) = (false, 0.0);
        counted("fmi3UpdateDiscreteStates", || unsafe {
            (self.discrete)(c, &mut again, &mut ends, &mut nominals, &mut resets, &mut is_next, &mut next)
        })?;
        Ok(Event { again, ends, resets, next: is_next.then_some(next) })
    }

    pub fn enter_continuous(&self, c: Component) -> Result<(), Refused> {
        let e = self.exchange()?;
        counted("fmi3EnterContinuousTimeMode", || unsafe { (e.enter_continuous)(c) })
    }

    pub fn completed_step(&self, c: Component) -> Result<bool, Refused> {
        let (e, mut event, mut ends) = (self.exchange()?, false, false);
        counted("fmi3CompletedIntegratorStep", || unsafe { (e.completed)(c, true, &mut event, &mut ends) })?;
        Ok(event)
    }

    pub fn step(&self, c: Component, from: f64, step: f64) -> Result<bool, Refused> {
        let call = "fmi3DoStep";
        let (_, run) = self.simulation.ok_or(Refused { call, status: -1 })?;
        let (mut event, mut ends, mut early, mut last) = (false, false, false, 0.0);
        counted(call, || unsafe { run(c, from, step, true, &mut event, &mut ends, &mut early, &mut last) })?;
        Ok(ends)
    }
}
