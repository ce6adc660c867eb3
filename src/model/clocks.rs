//! What was simulated beside what was measured, where either has dates: one clock for both.

use super::begun::Simulated;
use crate::record::{Channel, Recording};
use crate::{Error, Result};

/// Seconds by which the zero of the simulation's times is later than the recording's.
///
/// # Errors
/// `BadInput` where the simulation has dates or clocks that the recording's cannot be counted to.
pub(super) fn seconds_later(simulated: &Simulated, recording: &Recording) -> Result<f64> {
    let Some(own) = &simulated.zero else { return Ok(0.0) };
    let shift = recording.zero.as_ref().and_then(|zero| own.seconds_after(zero));
    shift.ok_or_else(|| {
        let those = match &recording.zero {
            Some(zero) => format!("those of '{}' from `{}`", recording.name, zero.text),
            None => format!("those of '{}' are numbers", recording.name),
        };
        let file = simulated.file.display();
        Error::bad_input(format!(
            "the times of '{file}' count from `{}`, {those}: they have no zero in common",
            own.text
        ))
        .with_hint("write both with date and zone as 2025-04-03T12:00:00Z, or the simulation's in seconds from the recording's first sample")
    })
}

/// A column of the simulation on the recording's clock, as its own table there.
pub(super) fn moved(channel: &Channel, table: usize, later: f64) -> Channel {
    if later == 0.0 {
        return Channel { table, ..channel.clone() };
    }
    Channel { table, time: channel.time.iter().map(|t| t + later).collect(), ..channel.clone() }
}

/// What is said where the simulation's times are numbers beside dates or clocks.
pub(super) fn caution(simulated: &Simulated, recording: &Recording) -> Option<String> {
    let zero = recording.zero.as_ref().filter(|_| simulated.zero.is_none())?;
    let file = simulated.file.display();
    Some(format!("the times of '{file}' are numbers: they are taken as seconds from `{}`", zero.text))
}
