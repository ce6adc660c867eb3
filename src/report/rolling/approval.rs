//! The test on a Scorsby table, in words and as JSON.

use super::words;
use crate::Result;
use crate::gyro::SIGN;
use crate::report::json::object;
use crate::report::page::{Page, Section, table};
use crate::report::svg::escaped;
use crate::rolling::{Approval, Compass, TableError, TableMotion};
use crate::units::figure;
use serde_json::{Value, json};
use std::fmt::Write;

/// The largest errors, the limit and the margin.
pub fn approval_text(compass: &Compass, a: &Approval) -> String {
    let t = &a.table;
    let mut out = format!(
        "Scorsby table: roll {:.0}°, pitch {:.0}° and yaw, by sines of {} to {} s, at most {} m/s² at the compass\n\
         (IMO resolution A.424(XI), 5.2; the lever h = {} m makes the acceleration)\n\
         compass: {}, elastic part: {}; latitude {}°\n\n\
         motion           period   heading   pitch leads   acceleration   largest mean error\n",
        t.roll.to_degrees(),
        t.pitch.to_degrees(),
        figure(t.periods[0]),
        figure(t.periods[1]),
        figure(t.acceleration),
        figure(compass.sphere.lever),
        words::origin(&compass.origin),
        words::part(compass.part.name()),
        figure(compass.sphere.latitude.to_degrees()),
    );
    a.worst.iter().for_each(|e| line(&mut out, e));
    out.push_str("yaw              none: it tilts the sphere and turns no heading\n");
    let (word, more) = if a.passes() { ("PASSES with", " to spare") } else { ("FAILS by", "") };
    let _ = writeln!(
        out,
        "\nlimit 1° sec φ = {:.2}°: {word} {:.2}°{more}; what costs most: {}.\nsign: {SIGN}",
        a.limit.to_degrees(),
        a.margin().abs().to_degrees(),
        motion(a.largest().motion),
    );
    if a.followed {
        out.push_str(
            "The elastic part is not linear: it is followed in time until it repeats, in sines of many periods and\n\
             amplitudes, and the worst of each motion once more by itself; one between them may be some percent worse.\n",
        );
    }
    out.push_str(
        "The theory is linear in the angles: at 20° it is off by some percent. Motions of different periods add no\n\
         more than each alone.\n",
    );
    out
}

/// The test as one page.
pub fn approval_page(compass: &Compass, a: &Approval) -> String {
    let cells = |e: &TableError| {
        let degrees = |x: f64| format!("{:+.2}", x.to_degrees());
        vec![
            motion(e.motion).to_owned(),
            figure(e.period),
            format!("{:.1}", e.heading.to_degrees()),
            degrees(e.error),
            degrees(a.limit - e.error.abs()),
        ]
    };
    let heads = ["motion", "#period, s", "#heading, °", "#largest mean error, °", "#limit less it, °"];
    let rows: Vec<Vec<String>> = a.worst.iter().map(cells).collect();
    let word = if a.passes() { "passes" } else { "fails" };
    let page = Page {
        kind: "A Scorsby table".into(),
        title: "A compass on a Scorsby table".into(),
        verdict: format!(
            "The compass {word}: its largest mean error is {:.2}°, by {}, where {:.2}° are allowed.",
            a.largest().error.abs().to_degrees(),
            motion(a.largest().motion),
            a.limit.to_degrees()
        ),
        lead: String::new(),
        sections: vec![
            Section::new("worst", "The worst of each motion", table(&heads, &rows)),
            Section::new(
                "numbers",
                "The numbers",
                format!("<pre class=\"scroll\">{}</pre>", escaped(&approval_text(compass, a))),
            ),
        ],
    };
    page.html()
}

fn line(out: &mut String, e: &TableError) {
    let phase =
        if e.motion == TableMotion::Both { format!("{:.0}°", e.phase.to_degrees()) } else { String::new() };
    let _ = writeln!(
        out,
        "{:<15}  {:>4} s   {:>6.1}°   {phase:>11}   {:>7.2} m/s²   {:>+17.2}°",
        motion(e.motion),
        figure(e.period),
        e.heading.to_degrees(),
        e.acceleration,
        e.error.to_degrees(),
    );
}

fn motion(m: TableMotion) -> &'static str {
    match m {
        TableMotion::Roll => "roll alone",
        TableMotion::Pitch => "pitch alone",
        TableMotion::Both => "roll and pitch",
    }
}

/// The test as JSON, by `docs/schemas/scorsby.json`.
///
/// # Errors
/// `NotComputed` for what JSON cannot hold.
pub fn approval_json(compass: &Compass, a: &Approval) -> Result<String> {
    let value = json!({
        "schema": "gyrospec.scorsby/1",
        "instrument": compass.part.name(),
        "lat_deg": compass.sphere.latitude.to_degrees(),
        "h_m": compass.sphere.lever,
        "sign": SIGN,
        "limit_deg": a.limit.to_degrees(),
        "margin_deg": a.margin().to_degrees(),
        "passes": a.passes(),
        "worst": a.worst.iter().map(worst).collect::<Vec<_>>(),
    });
    object(&value)
}

fn worst(e: &TableError) -> Value {
    json!({
        "motion": motion(e.motion),
        "period_s": e.period,
        "heading_deg": e.heading.to_degrees(),
        "phase_deg": e.phase.to_degrees(),
        "acceleration_m_per_s2": e.acceleration,
        "error_deg": e.error.to_degrees(),
    })
}
