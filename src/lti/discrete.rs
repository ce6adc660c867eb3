//! # Purpose
//! A linear system driven by white noise, sampled at equal steps without any error.
//!
//! # Method
//! zₖ₊₁ = Φ zₖ + L ξₖ with Φ = e^{Ah} and LLᵀ = ∫₀ʰ e^{As} BBᵀ e^{Aᵀs} ds: both by their series on
//! a small part of the step, then doubled.
//!
//! # References
//! C. F. Van Loan, IEEE Trans. Autom. Control 23 (1978) 395–404, for the integrals; the
//! doubling Q(2h) = Q(h) + Φ Q Φᵀ needs no e^{−Ah} and so bears stiff systems.
//!
//! # Numerical aspects
//! The factor L is a Cholesky factor in which directions without noise are zero columns.

use super::Gaussian;
use faer::Mat;
use rand_chacha::ChaCha8Rng;

/// A sampled system.
#[derive(Debug, Clone)]
pub struct Discrete {
    order: usize,
    /// Φ row by row.
    transition: Vec<f64>,
    noise: Gaussian,
    scratch: Vec<f64>,
}

impl Discrete {
    /// ż = A z + B·(unit white noises) sampled each `step` seconds.
    pub fn new(a: &Mat<f64>, b: &Mat<f64>, step: f64) -> Self {
        let n = a.nrows();
        let (phi, q) = transition_and_noise(a, &(b * b.transpose()), step);
        Self {
            order: n,
            transition: (0..n * n).map(|k| phi[(k / n, k % n)]).collect(),
            noise: Gaussian::new(&q, 1e-13),
            scratch: vec![0.0; n],
        }
    }

    /// Φ.
    pub fn transition(&self) -> Mat<f64> {
        Mat::from_fn(self.order, self.order, |i, j| self.transition[i * self.order + j])
    }

    /// Moves `z` one step on with noise from `rng`.
    pub fn advance(&mut self, z: &mut [f64], rng: &mut ChaCha8Rng) {
        for (i, slot) in self.scratch.iter_mut().enumerate() {
            let row = &self.transition[i * self.order..(i + 1) * self.order];
            *slot = row.iter().zip(&*z).map(|(p, v)| p * v).sum();
        }
        self.noise.add(&mut self.scratch, rng);
        z.copy_from_slice(&self.scratch);
    }
}

/// e^{Ah} and ∫₀ʰ e^{As} Q e^{Aᵀs} ds.
fn transition_and_noise(a: &Mat<f64>, q: &Mat<f64>, step: f64) -> (Mat<f64>, Mat<f64>) {
    let n = a.nrows();
    let doublings = (a.norm_l2() * step * 4.0).max(1.0).log2().ceil() as i32;
    let h = step / f64::from(doublings).exp2();
    let mut phi = Mat::<f64>::identity(n, n);
    let mut power = Mat::<f64>::identity(n, n);
    let mut term = q * faer::Scale(h);
    let mut sum = term.clone();
    for j in 1..20 {
        power = a * &power * faer::Scale(h / f64::from(j));
        phi += &power;
        let at = a * &term;
        term = (&at + at.transpose()) * faer::Scale(h / f64::from(j + 1));
        sum += &term;
    }
    for _ in 0..doublings {
        sum = &sum + &phi * &sum * phi.transpose();
        phi = &phi * &phi;
    }
    (phi, sum)
}
