//! A run of a model in words, and its predictions as a table.

use crate::record::Kind;
use crate::simulate::{Simulator, Trajectory};
use std::fmt::Write;

/// What was run, how its fitted states begin (name, value, unit), and how far its outputs lie from what was measured, in
/// words.
pub fn summary(s: &Simulator, ran: &Trajectory, begins: &[(String, f64, String)]) -> String {
    let mut out = format!("{}\n", s.model().name);
    let (from, to) = s.span();
    if s.is_dynamic() {
        let (method, n) = s.steps();
        let _ = writeln!(
            out,
            "simulated from {from} to {to} s, {method:?} steps, {n} in an interval of the inputs, {} events",
            ran.events
        );
        out.push_str(&match ran.solver_error {
            e if e.is_finite() => format!("solver error {e:.1e} of the spread (by halving the step)\n"),
            _ => "solver error not known\n".to_string(),
        });
    } else if !s.model().stepped_as().is_empty() {
        out.push_str("the FMU steps itself; its solver error is not known\n");
    }
    for (state, value, unit) in begins {
        let _ = writeln!(out, "{state} begins at {value:.6} {unit}");
    }
    let _ =
        writeln!(out, "{:<20} {:>8} {:>14} {:>14}  unit", "output", "samples", "rms error", "worst error");
    for (o, predicted) in s.outputs().iter().zip(&ran.outputs) {
        let (count, rms, worst) = o.errors(predicted);
        let unit = o.unit.of_differences();
        let [rms, worst] = [rms, worst].map(cell);
        let _ = writeln!(out, "{:<20} {count:>8} {rms:>14} {worst:>14}  {unit}", o.name);
    }
    out
}

/// A dash for no number; six decimals, or six digits and an exponent for what is very small or large.
fn cell(x: f64) -> String {
    if !x.is_finite() {
        "-".into()
    } else if x != 0.0 && !(1e-3..1e7).contains(&x) {
        format!("{x:.5e}")
    } else {
        format!("{x:.6}")
    }
}

/// The predictions as CSV: one row a time of any output: empty cells where an output has no sample.
pub fn csv(s: &Simulator, ran: &Trajectory, kind: Kind) -> String {
    let mut times: Vec<f64> = s.outputs().iter().flat_map(|o| o.time.iter().copied()).collect();
    times.sort_unstable_by(f64::total_cmp);
    times.dedup();
    let mut out = String::from(if kind == Kind::Trials { "row [1]" } else { "time [s]" });
    for o in s.outputs() {
        let _ = write!(out, ",{0}_measured [{1}],{0} [{1}]", o.name, o.unit);
    }
    out.push('\n');
    let mut next = vec![0; s.outputs().len()];
    for t in times {
        let _ = write!(out, "{t}");
        for (k, o) in s.outputs().iter().enumerate() {
            let here = o.time.get(next[k]) == Some(&t);
            for values in [&o.measured[..], &ran.outputs[k][..]] {
                let value = if here { values[next[k]] } else { f64::NAN };
                out.push(',');
                if value.is_finite() {
                    let _ = write!(out, "{}", o.unit.from_si(value));
                }
            }
            next[k] += usize::from(here);
        }
        out.push('\n');
    }
    out
}
