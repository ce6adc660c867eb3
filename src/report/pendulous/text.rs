//! The voyage in words.

use crate::gyro::pendulous::{AtLatitude, OnHeading, SettledVoyage, Voyage};
use crate::gyro::{SIGN, side};
use crate::units::{figure, significant};
use std::fmt::Write;

/// Degrees with their sign and four decimals; no zero has a sign.
pub(super) fn signed(x: f64) -> String {
    let degrees = (x.to_degrees() * 1e4).round() / 1e4;
    format!("{:+.4}°", degrees + 0.0)
}

/// The findings in words.
pub fn text(voyage: &Voyage, told: &SettledVoyage) -> String {
    let c = &voyage.compass;
    let mut out = format!(
        "Compass with a liquid ballistic: H = {} N·m·s, B = {} N·m, offset {} rad ({}°), lag of the flow {} s\n\
         at latitude {}°: undamped period {:.1} min, {}, falls to 1/e in {:.1} min\n",
        figure(c.momentum),
        significant(c.ballistic, 6),
        figure(c.offset),
        figure(c.offset.to_degrees()),
        figure(c.flow),
        figure(c.latitude.to_degrees()),
        c.undamped_period() / 60.0,
        if told.damped_period.is_finite() {
            format!("damped {:.1} min", told.damped_period / 60.0)
        } else {
            "damped without a swing".into()
        },
        told.decay / 60.0
    );
    out.push_str(&rows(voyage, told));
    if let (Some(m), Some(spread)) = (&voyage.manoeuvres, told.spread) {
        let _ = writeln!(
            out,
            "\nUnder manoeuvres (northward velocity ±{} m/s, forgotten in {} s) the heading spreads by ±{}°\n\
             about the error of its speed at each moment",
            figure(m.deviation),
            figure(m.time),
            significant(spread.to_degrees(), 4)
        );
    }
    out.push_str(&elsewhere(voyage, told));
    if !told.is_linear() {
        out.push_str("BEYOND THE LINEAR THEORY: the heading is off by more than the 10° to which it holds\n");
    }
    let _ = writeln!(out, "sign: {SIGN}");
    out
}

fn rows(voyage: &Voyage, told: &SettledVoyage) -> String {
    let mut out = format!("\nSettled error at a speed of {} m/s", figure(voyage.speed));
    if let Some(set) = &voyage.corrector {
        let (latitude, speed) = (figure(set.latitude.to_degrees()), figure(set.speed));
        let _ = write!(out, ", and with a corrector set to latitude {latitude}° and {speed} m/s");
    }
    out.push_str("\n heading     by speed   by damping      settled");
    out.push_str(if voyage.corrector.is_some() { "    corrected\n" } else { "\n" });
    for r in &told.rows {
        let _ = writeln!(out, "{}", row(r));
    }
    out
}

fn row(r: &OnHeading) -> String {
    let last = r.corrected.unwrap_or(r.settled());
    let corrected = r.corrected.map_or(String::new(), |c| format!(" {:>12}", signed(c)));
    format!(
        "{:>7}° {:>12} {:>12} {:>12}{corrected}  {}",
        figure(r.heading.to_degrees()),
        signed(r.by_speed),
        signed(r.by_damping),
        signed(r.settled()),
        if signed(last) == signed(0.0) { "none" } else { side(last) }
    )
}

fn elsewhere(voyage: &Voyage, told: &SettledVoyage) -> String {
    let spread = voyage.manoeuvres.is_some();
    let mut out = format!(
        "\nThe same compass elsewhere, at rest\nlatitude   undamped    by damping{}\n",
        if spread { "   spread under manoeuvres" } else { "" }
    );
    for AtLatitude { latitude, undamped_period, by_damping, spread: here } in &told.by_latitude {
        let settled = by_damping.map_or("does not settle".into(), signed);
        let about = here.map_or(String::new(), |s| format!(" {:>12}", format!("±{:.4}°", s.to_degrees())));
        let (latitude, minutes) = (figure(latitude.to_degrees().round()), undamped_period / 60.0);
        let _ = writeln!(out, "{latitude:>7}°  {minutes:>5.1} min {settled:>13}{about}");
    }
    out
}
