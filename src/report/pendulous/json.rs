//! The voyage as one JSON object.

use crate::Result;
use crate::gyro::SIGN;
use crate::gyro::pendulous::{SettledVoyage, Voyage};
use crate::report::json::object;
use serde_json::json;

/// The findings as JSON, by `docs/schemas/pendulous.json`.
///
/// # Errors
/// `NotComputed` for what JSON cannot hold.
pub fn json(voyage: &Voyage, told: &SettledVoyage) -> Result<String> {
    let degrees = |x: Option<f64>| x.map(f64::to_degrees);
    let c = &voyage.compass;
    let value = json!({
        "schema": "gyrospec.pendulous/1",
        "compass": {
            "H_Nms": c.momentum, "B_Nm": c.ballistic, "offset_rad": c.offset, "flow_s": c.flow,
            "lat_deg": c.latitude.to_degrees(), "g_m_per_s2": c.gravity, "U_rad_per_s": c.earth_rate,
        },
        "speed_m_per_s": voyage.speed,
        "corrector": voyage.corrector.map(|s| json!({
            "lat_deg": s.latitude.to_degrees(), "speed_m_per_s": s.speed,
        })),
        "manoeuvres": voyage.manoeuvres.map(|m| json!({
            "deviation_m_per_s": m.deviation, "time_s": m.time,
        })),
        "undamped_period_s": c.undamped_period(),
        "damped_period_s": Some(told.damped_period).filter(|p| p.is_finite()),
        "decay_s": told.decay,
        "rows": told.rows.iter().map(|r| json!({
            "heading_deg": r.heading.to_degrees(), "settled_deg": r.settled().to_degrees(),
            "by_speed_deg": r.by_speed.to_degrees(), "by_damping_deg": r.by_damping.to_degrees(),
            "corrected_deg": degrees(r.corrected),
        })).collect::<Vec<_>>(),
        "spread_deg": degrees(told.spread),
        "by_latitude": told.by_latitude.iter().map(|a| json!({
            "lat_deg": a.latitude.to_degrees(), "undamped_period_s": a.undamped_period,
            "by_damping_deg": degrees(a.by_damping), "spread_deg": degrees(a.spread),
        })).collect::<Vec<_>>(),
        "linear_theory_holds": told.is_linear(),
        "sign": SIGN,
    });
    object(&value)
}
