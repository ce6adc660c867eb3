//! The mean error of many compasses on many rolls at once, by the batch path of the integral.

use super::seed::error_of_moment;
use super::{Gyrosphere, range, validity};
use crate::Result;
use crate::integral::batch;
use crate::spectrum::Roll;

/// The mean error (rad) of each compass on its roll and heading (rad), by I₃ with
/// H = (Ts + 1)(s² + 2μs + b²) and G = 4Aμb² s⁴; each entry fails by itself, as one outside its [range] does, and
/// one beyond what the linear theory gives.
///
/// ```
/// use gyrospec::gyro::{seed, sweep};
/// let errors = sweep(&vec![seed::example_3_1(); 1000]).unwrap();
/// assert!((errors[999].as_ref().unwrap().to_degrees() + 4.497).abs() < 5e-4);
/// ```
///
/// # Errors
/// As the batch itself; an entry that has no error says so in its place.
pub fn sweep(cases: &[(Gyrosphere, Roll, f64)]) -> Result<Vec<Result<f64>>> {
    let mut h = Vec::with_capacity(4 * cases.len());
    let mut g = Vec::with_capacity(3 * cases.len());
    for (sphere, roll, _) in cases {
        let (t, mu, b2) = (sphere.lag, roll.decay, roll.b2());
        // (Ts + 1)(s² + 2μs + b²)
        h.extend([t, 1.0 + 2.0 * mu * t, 2.0 * mu + b2 * t, b2]);
        // S = 4Aμb² ω⁴/|…|² and Re 1/(1 + jωT) = 1/|1 + jωT|²
        g.extend([4.0 * roll.variance * mu * b2, 0.0, 0.0]);
    }
    let moments = batch::evaluate_fast(3, &h, &g)?;
    Ok(cases
        .iter()
        .zip(moments)
        .map(|((sphere, roll, heading), moment)| {
            sphere.check()?;
            range::ROLL_VARIANCE.check(roll.variance)?;
            range::ROLL_DECAY.check(roll.decay)?;
            range::ROLL_FREQUENCY.check(roll.frequency)?;
            range::HEADING.check(*heading)?;
            let error = error_of_moment(sphere, moment?.value, *heading);
            validity::bounded(error)?;
            Ok(error)
        })
        .collect())
}
