//! The linear stand-in of friction and free play together: the Gaussian closure of each, with the deviations of the
//! whole suspension.

use super::balance::Balance;
use crate::gyro::elastic::part::fixed_point;
use crate::gyro::elastic::suspension::Suspension;
use crate::lti::StateSpace;
use crate::{Error, Result};
use faer::Mat;
use std::f64::consts::{PI, SQRT_2};

/// Turns of the two closures at most.
const TURNS: usize = 200;
/// How still both stand at the end.
const STILL: f64 = 1e-9;

/// The suspension with the spring and the dashpot that serve a motion best; `None` where friction holds it for good.
pub(super) fn stand_in(
    tight: Balance,
    suspension: &Suspension,
    acceleration: &StateSpace,
) -> Result<Option<Balance>> {
    let positive = |x: Option<f64>| x.filter(|v| *v > 0.0);
    let (friction, gap) = (positive(suspension.friction), positive(suspension.gap));
    let mut now = tight;
    for _ in 0..TURNS {
        let before = now;
        if let Some(gap) = gap {
            now.spring = by_play(&now, gap, acceleration)?;
        }
        if let Some(force) = friction {
            let Some(viscous) = by_friction(&now, (tight.viscous, force), acceleration)? else {
                return Ok(None);
            };
            now.viscous = viscous;
        }
        let moved = (now.spring / before.spring - 1.0).abs().max((now.viscous / before.viscous - 1.0).abs());
        if moved < STILL || friction.is_none() || gap.is_none() {
            return Ok(Some(now));
        }
    }
    Err(Error::not_computed("friction and free play have no common linear stand-in on this motion"))
}

/// The standard deviations of x₁ and ẋ₁.
fn deviations(balance: &Balance, acceleration: &StateSpace) -> Result<[f64; 2]> {
    let element = balance.element()?;
    // of W₁ alone
    let inputs = Mat::from_fn(element.order(), 3, |i, j| if j == 0 { element.b[(i, 0)] } else { 0.0 });
    let wide = StateSpace::new(element.a, inputs, element.c, Mat::zeros(2, 3))?;
    let k = acceleration.then(&wide)?.output_covariance()?;
    Ok([0, 1].map(|i| k[(i, i)].max(0.0).sqrt()))
}

/// c = C₀ erfc(δ/(√2 σ)), σ of x₁.
fn by_play(now: &Balance, gap: f64, acceleration: &StateSpace) -> Result<f64> {
    let of = |sigma: f64| {
        let held = statrs::function::erf::erfc(gap / (SQRT_2 * sigma)).max(1e-12);
        Balance { spring: now.stiffness * held, ..*now }
    };
    let tight = deviations(&Balance { spring: now.stiffness, ..*now }, acceleration)?[0];
    if tight == 0.0 {
        return Ok(now.stiffness);
    }
    let wider = |sigma: f64| Ok(deviations(&of(sigma), acceleration)?[0] > sigma);
    Ok(of(fixed_point([tight, 1e3 * (tight + gap)], wider)?).spring)
}

/// r + F_c √(2/π)/σ, σ of ẋ₁; `None` where no σ keeps itself up.
fn by_friction(
    now: &Balance,
    (viscous, force): (f64, f64),
    acceleration: &StateSpace,
) -> Result<Option<f64>> {
    let of = |sigma: f64| Balance { viscous: viscous + force * (2.0 / PI).sqrt() / sigma, ..*now };
    let free = deviations(&Balance { viscous, ..*now }, acceleration)?[1];
    if free == 0.0 {
        return Ok(Some(viscous));
    }
    let low = free * 1e-6;
    let moves = |sigma: f64| Ok(deviations(&of(sigma), acceleration)?[1] > sigma);
    if !moves(low)? {
        return Ok(None);
    }
    Ok(Some(of(fixed_point([low, free], moves)?).viscous))
}
