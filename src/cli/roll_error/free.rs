//! The compass left alone, as a navigator knows it.

use super::parameters::Compass;
use crate::Result;
use crate::gyro::Gyrosphere;
use std::fmt::Write;

pub fn text(compass: &Compass) -> Result<String> {
    let mut out = format!(
        "Free motion of the gyrosphere ({})\n\n\
         latitude   undamped   damped     falls to 1/e   within 0.5°, from 10° off\n",
        compass.says
    );
    for degrees in (0..=80).step_by(10) {
        line(&mut out, compass, f64::from(degrees))?;
    }
    out.push_str("\nhere:\n");
    line(&mut out, compass, compass.sphere.latitude.to_degrees())?;
    let knots = 10.0 * 1852.0 / 3600.0;
    let thrown = compass.sphere.ballistic(knots, 60.0, 24 * 60)?;
    let worst = thrown.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).copied().unwrap_or((0.0, 0.0));
    let last = thrown.iter().rev().find(|p| p.1.abs() > 0.1f64.to_radians()).map_or(0.0, |p| p.0);
    let _ = writeln!(
        out,
        "\nA sudden change of northward speed by 10 kn throws it by {:.2}° at once ({}); the largest deviation from the new\n\
         steady error is {:.2}° after {:.0} min, and after {:.0} min it stays within 0.1°.",
        (compass.sphere.pendulous * knots / (compass.sphere.momentum * compass.sphere.gravity)).to_degrees(),
        crate::gyro::side(knots),
        worst.1.to_degrees(),
        worst.0 / 60.0,
        last / 60.0
    );
    Ok(out)
}

fn line(out: &mut String, compass: &Compass, degrees: f64) -> Result<()> {
    let sphere = Gyrosphere { latitude: degrees.to_radians(), ..compass.sphere };
    let f = sphere.free_motion()?;
    let minutes = |s: f64| if s.is_finite() { format!("{:.1} min", s / 60.0) } else { "none".into() };
    let _ = writeln!(
        out,
        "{degrees:>7.1}°  {:>9}  {:>9}  {:>13}   {:>9}",
        minutes(f.undamped_period),
        minutes(f.damped_period),
        minutes(f.decay),
        minutes(f.settling)
    );
    Ok(())
}
