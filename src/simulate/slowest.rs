//! # Purpose
//! The slowest time of a model, to tell when a recording is too short, and the fastest, to tell why a run takes too
//! long.
//!
//! # Method
//! The characteristic polynomial of the Jacobian by the Faddeev-LeVerrier recursion; its roots.
//! Pure integrations (roots at 0) have no time and are left out.
//!
//! # References
//! F. R. Gantmacher, The Theory of Matrices, vol. 1, Chelsea 1959, chapter IV §5.
//!
//! # Numerical aspects
//! The recursion loses digits for large or badly scaled matrices; for a warning it is good enough.

use super::machine::Machine;
use super::simulator::Simulator;
use super::start::start;
use crate::Result;
use crate::poly;
use num_complex::Complex64;

/// A coefficient below this share of its natural size counts as 0.
const NONE: f64 = 1e-10;

impl Simulator {
    /// The longest time constant near the start, 1/|λ| of the slowest root, s; where the run is shorter than that, the
    /// shortest of it and those at the ends of what the states went through (a law of a power may have none at rest).
    /// None where the model has no dynamics.
    ///
    /// # Errors
    /// No steady state.
    pub fn slowest_time(&self, parameters: &[f64], initials: &[f64]) -> Result<Option<f64>> {
        let longest = |roots: &[Complex64]| {
            let slowest = roots.iter().map(|r| r.norm()).fold(f64::INFINITY, f64::min);
            (slowest.is_finite() && slowest > 0.0).then(|| 1.0 / slowest)
        };
        let (roots, _) = self.roots(parameters, initials, None)?;
        let (from, to) = self.span();
        let Some(at_rest) = longest(&roots).filter(|t| *t > to - from) else { return Ok(longest(&roots)) };
        let went = self.swings(parameters, initials).ok().flatten().unwrap_or_default();
        let ends = [went.iter().map(|s| s.0).collect::<Vec<f64>>(), went.iter().map(|s| s.1).collect()];
        let roots = |x: &Vec<f64>| Some(self.roots(parameters, initials, Some(x)).ok()?.0);
        let moving = ends.iter().filter_map(roots).filter_map(|r| longest(&r));
        Ok(Some(moving.fold(at_rest, f64::min)))
    }

    /// How long the model remembers, near the start of the run: the longest 1/|Re λ|, s; infinite where it never
    /// forgets, none where it has no dynamics.
    pub(super) fn memory(&self, parameters: &[f64], initials: &[f64]) -> Option<f64> {
        let (roots, states) = self.roots(parameters, initials, None).ok()?;
        let fading = |r: &Complex64| if r.re < -NONE * r.norm() { -1.0 / r.re } else { f64::INFINITY };
        let integrates = roots.len() < states;
        let longest = roots.iter().map(fading).fold(0.0, f64::max);
        (states > 0).then_some(if integrates { f64::INFINITY } else { longest })
    }

    /// The shortest time constant near the start, s; none where the model has no dynamics.
    pub(super) fn fastest_time(&self, parameters: &[f64], initials: &[f64]) -> Option<f64> {
        let (roots, _) = self.roots(parameters, initials, None).ok()?;
        let fastest = roots.iter().map(|r| r.norm()).fold(0.0, f64::max);
        (fastest.is_finite() && fastest > 0.0).then(|| 1.0 / fastest)
    }

    /// The eigenvalues that are not 0 at the start, or with the states at `moved` and all else as there, 1/s; and the
    /// number of all.
    fn roots(
        &self,
        parameters: &[f64],
        initials: &[f64],
        moved: Option<&[f64]>,
    ) -> Result<(Vec<Complex64>, usize)> {
        let parameters = self.with_constants(parameters);
        let mesh = self.mesh_at(&parameters);
        let mut m = Machine::<f64>::new(&self.program, &mesh, &parameters);
        let (given, steady) = self.starts(initials);
        let x = start(&mut m, mesh.time[0], &given, &steady)?;
        let n = x.len();
        let (mut jacobian, mut explicit) = (vec![0.0; n * n], vec![0.0; n]);
        m.load(mesh.time[0], moved.unwrap_or(&x));
        m.slopes(&mut jacobian, &mut explicit);
        Ok((roots(&jacobian, n), n))
    }
}

/// The eigenvalues that are not 0.
fn roots(a: &[f64], n: usize) -> Vec<Complex64> {
    let size = a.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    if n == 0 || size == 0.0 || !size.is_finite() {
        return Vec::new();
    }
    // c₀ = 1, Mₖ = A·Mₖ₋₁ + cₖ₋₁·1, cₖ = −tr(A·Mₖ)/k
    let (mut c, mut product) = (vec![1.0], vec![0.0; n * n]);
    for k in 1..=n {
        let mut m = product.clone();
        for i in 0..n {
            m[i * n + i] += c[k - 1];
        }
        product = times(a, &m, n);
        let trace: f64 = (0..n).map(|i| product[i * n + i]).sum();
        c.push(-trace / k as f64);
    }
    while c.len() > 1 && c[c.len() - 1].abs() <= NONE * size.powi(c.len() as i32 - 1) {
        c.pop();
    }
    if c.len() == 1 { Vec::new() } else { poly::roots::roots(&c) }
}

fn times(a: &[f64], b: &[f64], n: usize) -> Vec<f64> {
    let mut out = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..n {
            out[i * n + j] = (0..n).map(|k| a[i * n + k] * b[k * n + j]).sum();
        }
    }
    out
}
