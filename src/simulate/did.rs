//! The plan that did where a run was made last.
//!
//! # Purpose
//! A fit runs twice at each point that it goes on from: for the sum of squares, then for the sensitivities. What the
//! first found out of the steps holds for the second, whose values are the same bit for bit.
//!
//! # Numerical aspects
//! It is known for exactly the same numbers alone, so that no result hangs on what was run before.

use super::plan::Plan;
use super::request::Case;
use std::sync::{Mutex, OnceLock, PoisonError};

/// The last point and its plan.
#[derive(Debug, Default)]
pub(super) struct Did {
    last: Mutex<Option<(Vec<u64>, Plan)>>,
    /// The plan of the stiff method at the model's own parameters, where it was asked for; none where it does not do.
    pub own_stiff: OnceLock<Option<Plan>>,
}

impl Clone for Did {
    /// Knows nothing: a clone may run over another part of the recording.
    fn clone(&self) -> Self {
        Self::default()
    }
}

fn point(case: &Case<'_>) -> Vec<u64> {
    case.parameters.iter().chain(case.initials).map(|x| x.to_bits()).collect()
}

impl Did {
    /// The plan that did at the very same parameters and initial states.
    pub fn at(&self, case: &Case<'_>) -> Option<Plan> {
        let known = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        known.as_ref().filter(|k| k.0 == point(case)).map(|k| k.1)
    }

    /// Remembers a plan.
    pub fn remember(&self, case: &Case<'_>, plan: Plan) {
        *self.last.lock().unwrap_or_else(PoisonError::into_inner) = Some((point(case), plan));
    }
}

#[cfg(test)]
mod tests {
    use crate::model::Model;
    use crate::record::{Channel, Recording};
    use crate::simulate::{Options, Simulator, Unknown};
    use crate::units::Unit;

    #[test]
    fn sensitivities_hang_on_no_run_before() {
        let text = "name = \"lag\"\n[inputs]\nu = { unit = \"V\" }\n\
            [parameters]\nT = { value = 1, unit = \"s\" }\nK = { value = 2, unit = \"1\" }\n\
            [states]\nx = { rate = \"(K*u - x)/T\", unit = \"V\", initial = 0 }\n\
            [outputs]\ny = { equals = \"x\", unit = \"V\" }\n";
        let time: Vec<f64> = (0..800).map(|i| 0.05 * f64::from(i)).collect();
        let channel = |name: &str, f: fn(f64) -> f64| {
            Channel::new(
                name,
                Unit::parse("V").unwrap(),
                time.clone(),
                time.iter().map(|t| f(*t)).collect::<Vec<_>>(),
            )
        };
        let channels = vec![channel("u", |t| (0.9 * t).sin() + (3.1 * t).cos()), channel("y", |_| 0.0)];
        let recording = Recording::from_channels("made", channels).unwrap();
        let fresh = Simulator::new(&Model::parse(text).unwrap(), &recording, &Options::default()).unwrap();
        let asked = [Unknown::Parameter(0), Unknown::Parameter(1)];
        let slopes = |s: &Simulator, p: [f64; 2]| s.run_with_sensitivities(&p, &[0.0], &asked).unwrap();
        // what the steps were planned for, what asks for more of them, and what is stiff
        let points = [[1.0, 2.0], [0.02, 2.0], [1e-5, 2.0]];
        let used = fresh.clone();
        for p in points.into_iter().chain(points) {
            let wanted = slopes(&fresh.clone(), p);
            let ran = used.run(&p, &[0.0]).unwrap();
            let found = slopes(&used, p);
            assert_eq!((&ran.outputs, ran.solver_error), (&wanted.outputs, wanted.solver_error), "{p:?}");
            assert_eq!((&found.outputs, found.solver_error), (&wanted.outputs, wanted.solver_error), "{p:?}");
            assert_eq!(found.sensitivities, wanted.sensitivities, "{p:?}");
        }
    }
}
