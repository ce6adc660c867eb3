//! Why a run takes more steps than it may, and which parameters make it so.

use super::mesh::Mesh;
use super::simulator::Simulator;
use crate::Error;
use crate::units::figure;

/// Change of a parameter by which it is found whether the shortest time constant hangs on it.
const MOVED: f64 = 0.01;
/// Power of a parameter in the shortest time constant from which on it is named; how many are.
const HANGS: f64 = 0.2;
const NAMED: usize = 3;

/// That a run at these parameters, from these initial states, takes more steps than one may.
pub(super) fn too_long(s: &Simulator, mesh: &Mesh, (parameters, initials): (&[f64], &[f64])) -> Error {
    let most = figure(s.budget.one_run().left() as f64);
    let usual = figure(mesh.usual);
    let fastest = s.fastest_time(parameters, initials);
    let Some(fastest) = fastest.filter(|fastest| *fastest < mesh.usual) else {
        let message = format!("one run takes more than {most} steps, with samples mostly {usual} s apart");
        return Error::not_computed(message).with_hint(
            "long gaps between dense samples ask for as many steps as if they were dense throughout",
        );
    };
    let mut powers: Vec<(f64, usize)> = (0..parameters.len())
        .filter_map(|k| {
            let mut moved = parameters.to_vec();
            moved[k] *= 1.0 + MOVED;
            // d ln τ / d ln p
            let power = (s.fastest_time(&moved, initials)? / fastest).ln() / MOVED.ln_1p();
            (power.abs() >= HANGS).then_some((power.abs(), k))
        })
        .collect();
    powers.sort_by(|a, b| b.0.total_cmp(&a.0));
    let named = powers.iter().take(NAMED).map(|(_, k)| {
        let p = &s.model().parameters[*k];
        format!("{} = {} {}", p.name, figure(p.unit.from_si(parameters[*k])), p.unit)
    });
    let named: Vec<String> = named.collect();
    let set_by = if named.is_empty() { String::new() } else { format!(", set by {}", named.join(", ")) };
    let message = format!(
        "one run takes more than {most} steps: the model is stiff, its shortest time constant is {} s{set_by}, while \
         samples stand {usual} s apart",
        figure(fastest)
    );
    Error::not_computed(message).with_hint("start elsewhere, set bounds, or leave out what is so fast")
}
