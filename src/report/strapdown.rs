//! What vibration and noise do to a strapdown system, as text and as JSON.

use crate::Result;
use crate::gyro::SIGN;
use crate::gyro::strapdown::{Effect, Findings, GRAVITY, RotorReads, Spread, System, Vector, Vibration};
use crate::report::json::object;
use crate::units::{figure, significant};
use serde_json::{Value, json};
use std::f64::consts::TAU;
use std::fmt::Write;

const AXES: [&str; 3] = ["x", "y", "z"];

/// Four digits with their sign.
fn signed(x: f64) -> String {
    // no zero has a sign
    let x = x + 0.0;
    format!("{}{}", if x < 0.0 { "" } else { "+" }, significant(x, 4))
}

/// A cause as it is called in words.
fn called(name: &str) -> &str {
    if name == "together" { "all together" } else { name }
}

/// The findings in words.
pub fn text(system: &System, found: &Findings) -> String {
    let mut out = "Body axes: x forward, y to starboard, z down\n".to_owned();
    let sorts = [
        ("angle about", "rad", &system.shaken.angular),
        ("acceleration along", "m/s²", &system.shaken.linear),
    ];
    for (sort, unit, axes) in sorts {
        for (axis, v) in AXES.iter().zip(axes) {
            if let Some(v) = v {
                let _ = writeln!(out, "  {sort} {axis}: {}", vibration(v, unit));
            }
        }
    }
    if system.shaken.coherence < 1.0 {
        let _ = writeln!(out, "  coherence of each two: {}", figure(system.shaken.coherence));
    }
    if !found.effects.is_empty() {
        out.push_str(
            "\nRead in the mean more than there is, without corrections (each adds the opposite):\n",
        );
        found.effects.iter().for_each(|e| effect(&mut out, e));
    }
    if let Some(rotor) = &found.rotor {
        out.push_str(&tuned(system, rotor));
    }
    out.push_str(&heading(system, found));
    out
}

fn vibration(v: &Vibration, unit: &str) -> String {
    format!(
        "standard deviation {} {unit} about {} Hz, damping ratio {}, phase {}°",
        figure(v.deviation),
        figure(v.frequency / TAU),
        figure(v.damping),
        figure(v.phase.to_degrees())
    )
}

/// What stands behind a name.
fn says(name: &str) -> &'static str {
    match name {
        "coning" => "−½⟨φ × φ̇⟩",
        "sculling" => "−⟨φ × a⟩",
        "anisoinertia" => "(I_s − I_i)⟨φ̇_i φ̇_s⟩/H",
        "anisoelasticity" => "(m/H)(⟨a_i d_s⟩ − ⟨a_s d_i⟩)",
        "square-term" => "k₂⟨a²⟩",
        _ => "",
    }
}

fn effect(out: &mut String, e: &Effect) {
    let _ = writeln!(out, "{}", format!("  {:<16} {}", called(e.name), says(e.name)).trim_end());
    let mut part = |v: Vector, word: &str, unit: &str, by: f64, shown: &str| {
        for (axis, x) in AXES.iter().zip(v).filter(|(_, x)| *x != 0.0) {
            let _ = writeln!(out, "    {word} {axis}: {} {unit} = {} {shown}", signed(x), signed(x * by));
        }
    };
    part(e.drift, "drift about", "rad/s", 3600f64.to_degrees(), "°/h");
    part(e.bias, "bias along", "m/s²", 1e6 / GRAVITY, "µg");
    if e.drift.iter().chain(&e.bias).all(|x| *x == 0.0) {
        out.push_str("    nothing: the vibrations are not in the phase for it\n");
    }
}

fn tuned(system: &System, r: &RotorReads) -> String {
    let mut out = String::from("\nTuned rotor\n");
    if let Some(mounted) = system.rotor {
        let _ = writeln!(
            out,
            "  figure of merit  {}; springs that tune it {} N·m/rad\n  \
             angle of {} rad at twice its speed, in step: drift {} rad/s = {} °/h",
            figure(mounted.rotor.figure_of_merit()),
            significant(mounted.rotor.tuned_spring(), 4),
            figure(mounted.amplitude),
            significant(r.drift, 4),
            significant(r.drift * 3600f64.to_degrees(), 4)
        );
    }
    for (axis, walk) in &r.walks {
        let _ = writeln!(
            out,
            "  vibration about {} near twice its speed: random walk {} rad/√s = {} °/√h",
            AXES[*axis],
            significant(*walk, 4),
            significant(walk.to_degrees() * 60.0, 4)
        );
    }
    out
}

fn heading(system: &System, found: &Findings) -> String {
    let Some(place) = system.place else { return String::new() };
    let mut out = format!(
        "\nHeading found by gyrocompassing at latitude {}°, x axis on heading {}°\n",
        figure(place.latitude.to_degrees()),
        figure(place.heading.to_degrees())
    );
    for e in &found.effects {
        if let Some(f) = e.found {
            let _ = writeln!(out, "  error by {}: {}°", called(e.name), signed(f.error.to_degrees()));
        }
    }
    if let Some(error) = found.rotor.as_ref().and_then(|r| r.heading) {
        let _ = writeln!(out, "  error by the tuned rotor: up to {}°", significant(error.to_degrees(), 4));
    }
    let Spread { by_walk, by_sea, aligned } = found.spread;
    let spreads = [
        ("spread of the loop by the gyros' random walk", by_walk),
        ("spread of the loop by the sea", by_sea),
        ("spread after averaging at rest", aligned),
    ];
    for (name, value) in spreads {
        if let Some(value) = value {
            let _ = writeln!(out, "  {name}: {}°", significant(value.to_degrees(), 4));
        }
    }
    if !found.is_linear() {
        out.push_str("BEYOND THE LINEAR THEORY: the heading is off by more than the 10° to which it holds\n");
    }
    if !found.effects.is_empty() {
        let _ = writeln!(out, "sign: {SIGN}");
    }
    out
}

/// The findings as JSON, by `docs/schemas/strapdown.json`.
///
/// # Errors
/// `NotComputed` for what JSON cannot hold.
pub fn json(system: &System, found: &Findings) -> Result<String> {
    let degrees = |x: Option<f64>| x.map(f64::to_degrees);
    let value = json!({
        "schema": "gyrospec.strapdown/1",
        "angular": vibrations(&system.shaken.angular, "deviation_rad"),
        "linear": vibrations(&system.shaken.linear, "deviation_m_per_s2"),
        "coherence": system.shaken.coherence,
        "effects": found.effects.iter().map(|e| json!({
            "effect": e.name, "drift_rad_per_s": e.drift, "bias_m_per_s2": e.bias,
            "heading_error_deg": degrees(e.found.map(|f| f.error)),
        })).collect::<Vec<_>>(),
        "tuned_rotor": found.rotor.as_ref().map(|r| json!({
            "drift_rad_per_s": r.drift,
            "largest_heading_error_deg": degrees(r.heading),
            "walks": r.walks.iter().map(|(axis, w)| json!({ "axis": AXES[*axis], "walk_rad_per_sqrt_s": w })).collect::<Vec<_>>(),
        })),
        "place": system.place.map(|p| json!({
            "latitude_deg": p.latitude.to_degrees(), "heading_deg": p.heading.to_degrees(),
        })),
        "spread": {
            "by_walk_deg": degrees(found.spread.by_walk),
            "by_sea_deg": degrees(found.spread.by_sea),
            "aligned_deg": degrees(found.spread.aligned),
        },
        "linear_theory_holds": found.is_linear(),
        "sign": SIGN,
    });
    object(&value)
}

fn vibrations(axes: &[Option<Vibration>; 3], deviation: &str) -> Vec<Value> {
    let one = |(axis, v): (&str, &Option<Vibration>)| {
        v.map(|v| {
            json!({
                "axis": axis, deviation: v.deviation, "phase_deg": v.phase.to_degrees(),
                "frequency_Hz": v.frequency / TAU, "damping_ratio": v.damping,
            })
        })
    };
    AXES.into_iter().zip(axes).filter_map(one).collect()
}
