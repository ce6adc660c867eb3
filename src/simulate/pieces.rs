//! The pieces of an interval of the mesh, each a step of the solver.

/// Steps in an interval: a long one gets more.
pub(super) fn substeps(usual_steps: usize, length: f64, usual: f64) -> usize {
    let wanted = usual_steps as f64 * length / usual - 1e-6;
    (wanted.ceil() as usize).max(usual_steps.min(1)).clamp(1, 1_000_000)
}

/// Begin and end of one of the pieces of an interval, each h long.
pub(super) fn piece((from, to): (f64, f64), (s, pieces): (usize, usize), h: f64) -> (f64, f64) {
    let end = if s + 1 == pieces { to } else { from + (s + 1) as f64 * h };
    (from + s as f64 * h, end)
}
