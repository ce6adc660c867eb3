//! A unit for model exchange as a function: rates and outputs from time, states, inputs and parameters.
//!
//! # Method
//! Each thread has instances of its own: one for each set of parameters that is asked for in turn, so that a derivative
//! by a parameter, a difference of two instances, starts none anew. Derivatives by states and inputs are the unit's own
//! where it has them, central differences where not.
//!
//! # Numerical aspects
//! A step of a central difference is the cube root of the rounding, about the size of its argument.

use super::Fmu;
use super::seat::{Place, Seat, get};
use crate::expression::foreign::Compute;
use crate::units::Unit;
use gyrospec_fmi::Refused;
use std::cell::RefCell;
use std::sync::{Arc, PoisonError};

/// Share of an argument that a difference steps, ∛ε.
const STEP: f64 = 6e-6;

/// A number of a unit as the model sees it.
#[derive(Debug, Clone)]
pub(crate) struct Scalar {
    pub place: Place,
    /// The unit in which the foreign code counts it.
    pub unit: Unit,
    /// Size below which a difference takes no smaller step, in that unit.
    pub size: f64,
}

/// A unit with the arguments that a model gives it.
pub(crate) struct Exchange {
    pub fmu: Arc<Fmu>,
    pub key: String,
    pub states: Vec<Scalar>,
    pub inputs: Vec<Scalar>,
    pub parameters: Vec<Scalar>,
    pub outputs: Vec<Scalar>,
    /// The units of the results, of rates and then of outputs.
    pub units: Vec<Unit>,
}

/// What was computed last at a place, with what is known of its derivatives.
struct Known {
    arguments: Vec<f64>,
    results: Vec<f64>,
    slopes: Vec<Option<Vec<f64>>>,
}

struct Bench {
    seats: Vec<Seat>,
    known: Option<Known>,
}

thread_local! {
    static BENCHES: RefCell<Vec<(String, Bench)>> = const { RefCell::new(Vec::new()) };
}

impl Exchange {
    /// The scale of each argument or result: its SI value by its value in the unit of the foreign code.
    fn scale(unit: &Unit) -> f64 {
        unit.of_differences().to_si(1.0)
    }

    fn scalars(&self) -> impl Iterator<Item = &Scalar> {
        self.states.iter().chain(&self.inputs).chain(&self.parameters)
    }

    /// Arguments in the units of the foreign code.
    fn own(&self, si: &[f64]) -> Vec<f64> {
        let rest = self.scalars().zip(&si[1..]).map(|(s, v)| s.unit.from_si(*v));
        std::iter::once(si[0]).chain(rest).collect()
    }

    fn counts(&self) -> (usize, usize) {
        (1 + self.states.len(), 1 + self.states.len() + self.inputs.len())
    }

    /// Rates and outputs, in the units of the foreign code.
    fn run(&self, bench: &mut Bench, a: &[f64]) -> Result<Vec<f64>, String> {
        let (n, m) = self.counts();
        let (t, x, u, p) = (a[0], &a[1..n], &a[n..m], &a[m..]);
        let input: Vec<Place> = self.inputs.iter().map(|s| s.place).collect();
        let seat = self.seat(bench, (t, &input, u), p)?;
        let say = |e: Refused| e.to_string();
        seat.feed(&self.fmu, &input, u).map_err(say)?;
        seat.move_to(t, x).map_err(say)?;
        let mut results = vec![0.0; self.states.len() + self.outputs.len()];
        let (rates, outputs) = results.split_at_mut(self.states.len());
        if !rates.is_empty() {
            seat.instance.rates(rates).map_err(say)?;
        }
        let places: Vec<Place> = self.outputs.iter().map(|s| s.place).collect();
        get(&self.fmu, &mut seat.instance, &places, outputs).map_err(say)?;
        Ok(results)
    }

    /// The instance with these parameters.
    fn seat<'b>(
        &self,
        bench: &'b mut Bench,
        (t, inputs, u): (f64, &[Place], &[f64]),
        p: &[f64],
    ) -> Result<&'b mut Seat, String> {
        let most = self.parameters.len() * 2 + 2;
        bench.seats.retain(|s| s.parameters != p || !s.is_behind(t));
        if let Some(k) = bench.seats.iter().position(|s| s.parameters == p) {
            let last = bench.seats.len() - 1;
            bench.seats[k..=last].rotate_left(1);
        } else {
            let places: Vec<Place> = self.parameters.iter().map(|s| s.place).collect();
            if bench.seats.len() >= most {
                bench.seats.remove(0);
            }
            bench.seats.push(Seat::start(&self.fmu, (t, inputs, u), (&places, p))?);
        }
        bench.seats.last_mut().ok_or_else(|| "no instance".into())
    }

    fn with<R>(&self, take: impl FnOnce(&mut Bench) -> R) -> R {
        BENCHES.with_borrow_mut(|all| {
            let k = all.iter().position(|b| b.0 == self.key).unwrap_or_else(|| {
                all.push((self.key.clone(), Bench { seats: Vec::new(), known: None }));
                all.len() - 1
            });
            take(&mut all[k].1)
        })
    }

    /// Computes what is not known at these arguments.
    fn know<'b>(&self, bench: &'b mut Bench, a: &[f64]) -> &'b mut Known {
        let same = |k: &Known| k.arguments.iter().zip(a).all(|(x, y)| x.to_bits() == y.to_bits());
        if !bench.known.as_ref().is_some_and(same) {
            let results = self.run(bench, a).unwrap_or_else(|why| {
                self.fmu.refused(&why);
                vec![f64::NAN; self.units.len()]
            });
            bench.known = Some(Known { arguments: a.to_vec(), results, slopes: vec![None; a.len()] });
        }
        bench.known.get_or_insert_with(|| Known {
            arguments: Vec::new(),
            results: Vec::new(),
            slopes: Vec::new(),
        })
    }

    /// The derivatives of all results by an argument, in the units of the foreign code.
    fn slopes(&self, bench: &mut Bench, a: &[f64], j: usize) -> Vec<f64> {
        let (_, m) = self.counts();
        let has = self.fmu.description.exchange.as_ref().is_some_and(|e| e.has_slopes);
        if has
            && (1..m).contains(&j)
            && self.is_plain()
            && let Ok(own) = self.own_slopes(bench, a, j)
        {
            return own;
        }
        let size = self.scalars().nth(j.wrapping_sub(1)).map_or(1.0, |s| s.size);
        let h = STEP * a[j].abs().max(size);
        let mut at = |sign: f64| {
            let mut moved = a.to_vec();
            moved[j] = a[j] + sign * h;
            let results = self.run(bench, &moved);
            (moved[j], results.unwrap_or_else(|_| vec![f64::NAN; self.units.len()]))
        };
        // (f(a + h) − f(a − h))/2h
        let ((high, above), (low, below)) = (at(1.0), at(-1.0));
        above.iter().zip(&below).map(|(b, c)| (b - c) / (high - low)).collect()
    }

    /// Whether each of its variables is one number: the unit's own derivatives are asked by variables.
    fn is_plain(&self) -> bool {
        let one = |s: &Scalar| self.fmu.description.variables[s.place.variable].start.len() == 1;
        self.scalars().chain(&self.outputs).all(one)
    }

    fn own_slopes(&self, bench: &mut Bench, a: &[f64], j: usize) -> Result<Vec<f64>, String> {
        self.run(bench, a)?;
        let d = &self.fmu.description;
        let of = |s: &Scalar| d.variables[s.place.variable].reference;
        let rates = d.states.iter().map(|s| d.variables[s.1].reference);
        let unknowns: Vec<u32> = rates.chain(self.outputs.iter().map(of)).collect();
        let by = self.scalars().nth(j - 1).map(of).ok_or("no such argument")?;
        let mut slopes = vec![0.0; unknowns.len()];
        let seat = bench.seats.last_mut().ok_or("no instance")?;
        seat.instance.slopes(&unknowns, by, &mut slopes).map_err(|e| e.to_string())?;
        Ok(slopes)
    }
}

impl Exchange {
    /// The inputs of its description and 1 more, in its units; none where they are not wanted.
    fn described(&self, is_wanted: bool) -> Vec<f64> {
        let start =
            |s: &Scalar| self.fmu.description.variables[s.place.variable].start[s.place.element] + 1.0;
        self.inputs.iter().filter(|_| is_wanted).map(start).collect()
    }
}

impl Compute for Exchange {
    fn arguments(&self) -> usize {
        1 + self.scalars().count()
    }

    fn units(&self) -> &[Unit] {
        &self.units
    }

    fn value(&self, arguments: &[f64], result: usize) -> f64 {
        let a = self.own(arguments);
        self.with(|bench| {
            let value = self.know(bench, &a).results[result];
            match self.states.get(result) {
                Some(state) => value * Self::scale(&state.unit),
                None => self.outputs[result - self.states.len()].unit.to_si(value),
            }
        })
    }

    fn slope(&self, arguments: &[f64], result: usize, argument: usize) -> f64 {
        let a = self.own(arguments);
        self.with(|bench| {
            if self.know(bench, &a).slopes[argument].is_none() {
                let slopes = self.slopes(bench, &a, argument);
                self.know(bench, &a).slopes[argument] = Some(slopes);
            }
            let slope = self.know(bench, &a).slopes[argument].as_ref().map_or(0.0, |s| s[result]);
            let of = self.states.get(result).unwrap_or_else(|| &self.outputs[result - self.states.len()]);
            let by = self.scalars().nth(argument.wrapping_sub(1)).map_or(1.0, |s| Self::scale(&s.unit));
            slope * Self::scale(&of.unit) / by
        })
    }

    fn starts(&self, parameters: &[f64], is_moved: bool) -> Result<Vec<f64>, String> {
        let p: Vec<f64> = self.parameters.iter().zip(parameters).map(|(s, v)| s.unit.from_si(*v)).collect();
        let places: Vec<Place> = self.parameters.iter().map(|s| s.place).collect();
        let inputs: Vec<Place> = self.inputs.iter().filter(|_| is_moved).map(|s| s.place).collect();
        let mut seat = Seat::start(&self.fmu, (0.0, &inputs, &self.described(is_moved)), (&places, &p))?;
        let mut x = vec![0.0; self.states.len()];
        seat.instance.states(&mut x).map_err(|e| e.to_string())?;
        Ok(self.states.iter().zip(x).map(|(s, v)| s.unit.to_si(v)).collect())
    }

    fn rates(&self, states: &[f64], parameters: &[f64], is_moved: bool) -> Vec<f64> {
        let inputs =
            self.inputs.iter().zip(self.described(true)).map(|(s, v)| s.unit.to_si(v - f64::from(!is_moved)));
        let arguments: Vec<f64> = std::iter::once(0.0)
            .chain(states.iter().copied())
            .chain(inputs)
            .chain(parameters.iter().copied())
            .collect();
        (0..self.states.len()).map(|k| self.value(&arguments, k)).collect()
    }

    fn refusal(&self) -> Option<String> {
        self.fmu.refusal.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    fn is(&self, key: &str) -> bool {
        self.key == key
    }
}
