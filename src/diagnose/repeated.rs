//! Outputs that were recorded more slowly than their table, and repeated in between.
//!
//! # Purpose
//! A row that repeats the last value of a slower instrument says nothing of its own time. Compared as it stands the output is
//! late by half of its own step, which would be taken for a sensor's lag.
//!
//! # Method
//! Where an output changes on a grid of several rows, the rows at which it does, and those of the grid at which it might have,
//! are compared alone. Coarse steps of what rises evenly come on a grid as well: there most changes are one step.

use crate::model::Model;
use crate::record::{Channel, Kind, Recording, at_its_pace};
use crate::units::figure;
use std::borrow::Cow;

/// Changes that show a grid.
const FEWEST: usize = 20;
/// Share of the times between changes that are one step of the grid, and that are whole ones.
const ON_GRID: (f64, f64) = (0.5, 0.9);
/// Share of the changes that are the smallest of them from which on they are the steps of a coarse reading alone.
const COARSE: f64 = 0.8;
/// Two changes that agree to this share are the same.
const SAME: f64 = 1e-6;

/// Recordings whose outputs hold the rows alone in which they were read, with what a reader should know.
pub fn fresh<'r>(model: &Model, recordings: &'r [Recording]) -> (Cow<'r, [Recording]>, Vec<String>) {
    let (mut all, mut notes) = (Cow::Borrowed(recordings), Vec::new());
    let is_output = |c: &Channel| model.outputs.iter().any(|o| o.name == c.name);
    for (k, recording) in recordings.iter().enumerate().filter(|(_, r)| r.kind != Kind::Trials) {
        for (i, c) in recording.channels.iter().enumerate().filter(|(_, c)| is_output(c)) {
            let Some(step) = grid(c).filter(|_| !is_coarse(c)) else { continue };
            all.to_mut()[k].channels[i] = at_its_pace(once(c, step));
            let note = c.median_step().map(|usual| note(&c.name, usual * step as f64));
            notes.extend(note.filter(|n| !notes.contains(n)));
        }
    }
    (all, notes)
}

/// The rows in which a channel takes another value than in the row before.
fn changes(c: &Channel) -> impl Iterator<Item = usize> {
    let is_known = |i: usize| c.values[i].is_finite() && c.values[i - 1].is_finite();
    (1..c.len()).filter(move |i| is_known(*i) && c.values[*i] != c.values[i - 1])
}

/// Rows between changes of a channel that was repeated in between.
pub fn grid(channel: &Channel) -> Option<usize> {
    let changes: Vec<usize> = changes(channel).collect();
    let mut between: Vec<usize> = changes.windows(2).map(|w| w[1] - w[0]).collect();
    if between.len() < FEWEST {
        return None;
    }
    between.sort_unstable();
    let step = between[between.len() / 2];
    let share =
        |is: &dyn Fn(usize) -> bool| between.iter().filter(|n| is(**n)).count() as f64 / between.len() as f64;
    // a step that is no whole number of samples is one sooner or later
    let one = share(&|n| n.abs_diff(step) <= 1);
    let whole = share(&|n| (n + 1) % step <= 2);
    (step > 2 && one >= ON_GRID.0 && whole >= ON_GRID.1).then_some(step)
}

/// Whether the changes of a channel are the steps of a coarse reading.
fn is_coarse(c: &Channel) -> bool {
    let sizes: Vec<f64> = changes(c).map(|i| (c.values[i] - c.values[i - 1]).abs()).collect();
    let least = sizes.iter().copied().fold(f64::INFINITY, f64::min);
    let same = sizes.iter().filter(|s| **s <= least * (1.0 + SAME)).count();
    same as f64 >= COARSE * sizes.len() as f64
}

/// The channel with each value in the row in which it was read; what stays longer than a step was read as the same again.
fn once(c: &Channel, step: usize) -> Channel {
    let mut read = c.clone();
    let mut last = 0;
    for i in 1..c.len() {
        if c.values[i] == c.values[i - 1] && i - last < step {
            read.values[i] = f64::NAN;
        } else {
            last = i;
        }
    }
    read
}

fn note(name: &str, step: f64) -> String {
    format!("{name} was read every {} s and repeated in between: each value is compared once", figure(step))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Unit;

    fn channel(value: impl Fn(usize) -> f64) -> Channel {
        let time: Vec<f64> = (0..600).map(|i| 0.5 * f64::from(i)).collect();
        Channel::new("room", Unit::parse("K").unwrap(), time, (0..600).map(value).collect())
    }

    fn wave(i: usize) -> f64 {
        (0.05 * i as f64).sin() + 0.3 * (0.31 * i as f64).sin()
    }

    #[test]
    fn what_is_repeated_is_kept_once() {
        let held = channel(|i| wave(i - i % 8));
        let kept = at_its_pace(once(&held, grid(&held).unwrap()));
        assert_eq!((kept.len(), kept.time[1], kept.values[1]), (75, 4.0, wave(8)));
        assert!(!is_coarse(&held));
    }

    #[test]
    fn a_value_that_stays_is_read_as_the_same_again() {
        let stays = channel(|i| if (200..264).contains(&i) { 7.0 } else { wave(i - i % 8) });
        let kept = once(&stays, grid(&stays).unwrap());
        let read = |from: usize, to: usize| (from..to).filter(|i| kept.values[*i] == 7.0).count();
        assert_eq!(read(200, 264), 8);
    }

    #[test]
    fn rows_that_are_lost_hide_no_grid() {
        let lost = channel(|i| if (100..131).contains(&i) { f64::NAN } else { wave(i - i % 8) });
        assert_eq!(grid(&lost), Some(8));
    }

    #[test]
    fn what_moves_in_each_row_and_coarse_steps_of_a_rise_are_no_grid() {
        assert_eq!(grid(&channel(wave)), None);
        let rise = channel(|i| (0.125 * i as f64).floor());
        assert!(grid(&rise).is_some() && is_coarse(&rise));
    }

    #[test]
    fn a_coarse_instrument_may_be_slow_as_well() {
        let both = channel(|i| (wave(i - i % 8) / 0.4).round() * 0.4);
        assert!(grid(&both) == Some(8) && !is_coarse(&both));
    }
}
