//! The compass left alone, in words.

use super::words;
use crate::gyro::{FreeMotion, side};
use crate::rolling::{Compass, LeftAlone};
use std::fmt::Write;

/// Periods and settling by latitude, and what a sudden change of speed does.
pub fn free_text(compass: &Compass, alone: &LeftAlone) -> String {
    let mut out = format!(
        "Free motion of the gyrosphere ({})\n\n\
         latitude   undamped   damped     falls to 1/e   within 0.5°, from 10° off\n",
        words::origin(&compass.origin)
    );
    for (latitude, motion) in &alone.by_latitude {
        line(&mut out, *latitude, motion);
    }
    out.push_str("\nhere:\n");
    line(&mut out, compass.sphere.latitude, &alone.here);
    let _ = writeln!(
        out,
        "\nA sudden change of northward speed by {:.0} kn throws it by {:.2}° at once ({}); the largest deviation from the new\n\
         steady error is {:.2}° after {:.0} min, and after {:.0} min it stays within 0.1°.",
        alone.change * 3600.0 / 1852.0,
        alone.thrown.to_degrees(),
        side(alone.change),
        alone.largest.1.to_degrees(),
        alone.largest.0 / 60.0,
        alone.settled / 60.0
    );
    out
}

fn line(out: &mut String, latitude: f64, f: &FreeMotion) {
    let minutes = |s: f64| if s.is_finite() { format!("{:.1} min", s / 60.0) } else { "none".into() };
    let _ = writeln!(
        out,
        "{:>7.1}°  {:>9}  {:>9}  {:>13}   {:>9}",
        latitude.to_degrees(),
        minutes(f.undamped_period),
        minutes(f.damped_period),
        minutes(f.decay),
        minutes(f.settling)
    );
}
