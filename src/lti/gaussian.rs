//! Draws of a Gaussian vector whose covariance may be singular.

use faer::Mat;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// A Gaussian vector of mean zero, ready to be drawn: L ξ with LLᵀ its covariance.
///
/// Directions without variance are zero columns of the Cholesky factor L.
#[derive(Debug, Clone)]
pub struct Gaussian {
    /// The columns of L that are not zero, each from its own row on: (first row, values).
    columns: Vec<(usize, Vec<f64>)>,
}

impl Gaussian {
    /// The vector of covariance `q`, n × n, symmetric and not negative; pivots below `blur` of
    /// their variance count as zero.
    pub fn new(q: &Mat<f64>, blur: f64) -> Self {
        let n = q.nrows();
        let mut l = Mat::<f64>::zeros(n, n);
        let mut columns = Vec::new();
        for j in 0..n {
            let left = q[(j, j)] - (0..j).map(|k| l[(j, k)] * l[(j, k)]).sum::<f64>();
            if left <= blur * q[(j, j)] || left <= 0.0 {
                continue;
            }
            let root = left.sqrt();
            for i in j..n {
                let rest = q[(i, j)] - (0..j).map(|k| l[(i, k)] * l[(j, k)]).sum::<f64>();
                l[(i, j)] = rest / root;
            }
            columns.push((j, (j..n).map(|i| l[(i, j)]).collect()));
        }
        Self { columns }
    }

    /// Adds one draw to `z`, of n numbers.
    pub fn add(&self, z: &mut [f64], rng: &mut ChaCha8Rng) {
        for (first, column) in &self.columns {
            let xi: f64 = StandardNormal.sample(rng);
            z[*first..].iter_mut().zip(column).for_each(|(s, l)| *s += l * xi);
        }
    }
}
