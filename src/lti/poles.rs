//! Poles of a system matrix.

use crate::{Error, Result};
use faer::Mat;
use num_complex::Complex64;

/// The eigenvalues of A, 1/s, in no order; what it is the matrix of is told where they are not found.
pub(crate) fn poles(a: &Mat<f64>, of: &str) -> Result<Vec<Complex64>> {
    let found = a.eigenvalues();
    let found = found.map_err(|_| Error::not_computed(format!("the poles of the {of} are not found")))?;
    Ok(found.into_iter().map(|z| Complex64::new(z.re, z.im)).collect())
}
