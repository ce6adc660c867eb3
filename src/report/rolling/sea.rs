//! What is said of a sea.

use crate::gyro::{Axis, OffBy};
use crate::rolling::{SeaMotion, Table, Waves};
use crate::spectrum::{Hull, Sea};
use crate::units::{figure, significant};
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// A sea and the ship in it, and how far its rational spectrum is off; of each height in turn, or of its own.
pub fn words(waves: &Waves, motion: Option<&SeaMotion>, in_turn: bool) -> String {
    let sea = &waves.sea;
    let (name, grown) = match sea {
        Sea::PiersonMoskowitz { .. } => ("Pierson-Moskowitz", true),
        Sea::Bretschneider { .. } => ("Bretschneider", false),
        Sea::Jonswap { .. } => ("JONSWAP", false),
    };
    let period = format!("peak period {:.1} s", TAU / sea.peak());
    let size = match (in_turn, grown) {
        (false, _) => format!("significant height {:.2} m, {period}", sea.height()),
        (true, true) => "of each significant height in turn, with the peak period that goes with it".into(),
        (true, false) => format!("of each significant height in turn, {period}"),
    };
    let crests =
        waves.spread.map_or_else(String::new, |n| format!(", spread as cosⁿ with n = {}", figure(n)));
    let met = if waves.is_shifted() {
        format!(", met at {} m/s", significant(waves.speed, 3))
    } else {
        String::new()
    };
    let off = motion.map_or_else(String::new, |m| {
        format!("; rational spectrum within {:.1} % where the ship answers", 100.0 * m.error)
    });
    let hull = hull(&waves.hull, motion);
    format!("{name} sea from {:03.0}° off the bow{crests}{met}, {size}; {hull}{off}", waves.from.to_degrees())
}

/// The waterplane over which the waves are averaged, and what damps her roll.
fn hull(hull: &Hull, motion: Option<&SeaMotion>) -> String {
    let [length, beam] = [hull.length, hull.beam].map(figure);
    let assumed = if hull.length == Hull::BEAMS * hull.beam { " (six beams)" } else { "" };
    let mut text = format!("slope averaged over a ship of {length} m{assumed} by {beam} m");
    if hull.quadratic != 0.0 || hull.cubic != 0.0 {
        let [linear, square, cube] = [hull.damping, hull.quadratic, hull.cubic].map(figure);
        text.push_str(&format!(
            ", whose roll is damped by the ratio {linear} and, a unit of inertia, {square}·|rate|·rate and {cube}·rate³"
        ));
        if let Some(m) = motion {
            let ratio = significant(m.damping, 3);
            text.push_str(&format!(": by the ratio {ratio} in this sea (equivalent linear damping)"));
        }
    }
    text
}

/// What the rational spectrum changes of the figures, and what the form of the ship may; empty where nothing is known.
pub fn off_by(table: &Table) -> String {
    let Some(off) = table.off_by else { return String::new() };
    fitted(&off) + &table.by_rectangle.map(|mean| formed(&off, mean)).unwrap_or_default()
}

/// A word on the sway that the sea brings and nobody asked for.
pub fn left_out(table: &Table) -> String {
    let waves = table.excitation.as_ref().and_then(|e| e.waves());
    match waves {
        Some(w) if !w.also.contains(&Axis::Sway) && Hull::slopes(w.from).0 != 0.0 => {
            "Sway is left out, and it may do more than rolling: --also sway counts it.\n".into()
        }
        _ => String::new(),
    }
}

/// A word on waves about as short as the ship, where they count.
fn formed(off: &OffBy, by_rectangle: f64) -> String {
    let change = by_rectangle / off.exact - 1.0;
    if change.abs() < OffBy::MUCH {
        return String::new();
    }
    format!(
        "Waves about as short as the ship count here, and her form decides what they do: averaged over a rectangle of\n\
         her length and beam they make the mean {:.5}°, {:.0} % {}.\n",
        by_rectangle.to_degrees(),
        100.0 * change.abs(),
        if change < 0.0 { "less" } else { "more" }
    )
}

/// What the rational spectrum changes.
fn fitted(off: &OffBy) -> String {
    let part = |x: f64| {
        let percent = 100.0 * x.abs();
        let size = if percent < 0.1 { "less than 0.1".to_owned() } else { format!("{percent:.1}") };
        format!("{size} % too {}", if x < 0.0 { "small" } else { "large" })
    };
    let trust = if off.is_much() { "; trust the sums more: they stand in the last column" } else { "" };
    format!(
        "By sums over the sea's own spectrum the mean by the motion is {:.5}° on heading {:.0}°: the rational spectrum\n\
         makes it {} and the spread by products {}{trust}.\n",
        off.exact.to_degrees(),
        off.heading.to_degrees(),
        part(off.mean),
        part(off.spread)
    )
}

/// What became of a sea of one height, as JSON.
pub fn as_json(table: &Table) -> Option<Value> {
    let (sea, waves) = (table.sea.as_ref()?, table.excitation.as_ref()?.waves()?);
    let off = table.off_by.map(
        |o| json!({
            "mean": o.mean, "spread_quadratic": o.spread, "heading_deg": o.heading.to_degrees(),
            "exact_mean_deg": o.exact.to_degrees(), "mean_by_rectangle_deg": table.by_rectangle.map(f64::to_degrees),
        }),
    );
    Some(json!({
        "met_at_m_per_s": waves.speed,
        "spread": waves.spread,
        "rational_error": sea.error,
        "roll_damping": sea.damping,
        "roll_rate_deg_per_s": sea.roll_rate.to_degrees(),
        "off_by": off,
    }))
}
