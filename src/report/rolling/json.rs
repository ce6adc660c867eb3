//! The table of errors as one JSON object.

use super::{distribution, sea, words};
use crate::Result;
use crate::gyro::validity::Smallness;
use crate::gyro::{SIGN, Tail};
use crate::report::json::object;
use crate::rolling::{Against, Row, Table};
use serde_json::{Value, json};

/// The table as JSON, by `docs/schemas/roll-error.json`.
///
/// # Errors
/// `NotComputed` for what JSON cannot hold.
pub fn json(table: &Table) -> Result<String> {
    let s = &table.compass.sphere;
    let against = match table.against {
        Against::Heading(_) => "heading_deg",
        Against::Latitude { .. } => "latitude_deg",
        Against::Height { .. } => "significant_height_m",
    };
    let trusted = match (table.is_by_spectrum(), table.is_by_sums()) {
        (true, _) => "measured_spectrum_mean_deg",
        (_, true) => "summed_mean_deg",
        _ => "mean_deg",
    };
    let mut value = json!({
        "schema": "gyrospec.roll-error/1",
        "instrument": table.compass.part.name(),
        "compass": {
            "P_N": s.weight, "H_Nms": s.momentum, "lP_Nm": s.pendulous, "C_Nm": s.damper, "F_per_s": s.flow,
            "C0_N_per_m": s.stiffness, "T_s": s.lag, "h_m": s.lever, "lat_deg": s.latitude.to_degrees(),
            "g_m_per_s2": s.gravity, "U_rad_per_s": s.earth_rate, "speed_m_per_s": table.compass.speed,
        },
        "motion": words::motion(table),
        "roll": roll(table),
        "against": against,
        "sign": SIGN,
        "validity": table.smallness.iter().map(smallness).collect::<Vec<_>>(),
        "trusted_mean": trusted,
        "rows": table.rows.iter().map(|r| row(r, against)).collect::<Vec<_>>(),
        "note": words::note(table).trim_end(),
    });
    if let Some(tail) = &table.tail {
        value["white_tail"] = white_tail(tail);
    }
    if let Some(sea) = sea::as_json(table) {
        value["sea"] = sea;
    }
    object(&value)
}

/// One figure that the linear theory takes for small, where the mean is largest.
pub fn smallness(s: &Smallness) -> Value {
    let holds = s.is_judged().then(|| s.holds());
    json!({ "figure": s.figure, "says": s.message, "value": s.value, "limit": s.limit, "unit": s.unit, "holds": holds })
}

/// The mean on heading 45° by the frequencies up to each, and by what share of the largest ends of the band above
/// each change it.
fn white_tail(tail: &Tail) -> Value {
    let mean = |omega: Option<f64>, mean: f64, share: f64| json!({ "up_to_rad_per_s": omega, "mean_deg": mean.to_degrees(), "share_above": share });
    let told = tail.table().into_iter().map(|(omega, m, share)| mean(Some(omega), m, share));
    let means: Vec<Value> = told.chain([mean(None, tail.whole, 0.0)]).collect();
    json!({ "infinite": tail.white, "above_rad_per_s": tail.from, "share": tail.share(), "means": means })
}

/// A, μ, ε with their 95 % intervals where they were fitted; null for a motion that is no such roll.
fn roll(table: &Table) -> Value {
    let Some(r) = table.roll() else { return Value::Null };
    let mut out = json!({ "A_rad2": r.variance, "mu_per_s": r.decay, "eps_rad_per_s": r.frequency });
    if let Some(i) = table.recorded.as_ref().and_then(|m| m.analysis.intervals.as_ref()) {
        let all = [("A_rad2", Some(i.variance)), ("mu_per_s", i.decay), ("eps_rad_per_s", Some(i.frequency))];
        for (name, i) in all {
            out["intervals"][name] =
                i.map_or(Value::Null, |i| json!({ "bias_removed": i.value, "low": i.low, "high": i.high }));
        }
    }
    out
}

fn row(r: &Row, against: &str) -> Value {
    let e = &r.error;
    let mut out = json!({
        against: r.value,
        "heading_deg": r.heading.to_degrees(),
        "mean_deg": e.mean().to_degrees(),
        "sailing_deg": e.sailing.to_degrees(),
        "rectified_deg": e.rectified.to_degrees(),
        "spread_deg": e.deviation.to_degrees(),
        "spread_linear_deg": e.deviation_linear.to_degrees(),
        "spread_quadratic_deg": e.deviation_quadratic.to_degrees(),
    });
    if let Some(shape) = &r.shape {
        out["percentiles_deg"] = distribution::of(shape.percentiles(e));
        out["skewness"] = json!(shape.skewness);
    }
    if !r.is_exact() {
        out["mean_margin_deg"] = json!(e.rectified_margin.to_degrees());
        out["spread_margin_deg"] = json!(e.deviation_margin.to_degrees());
        out["linearised_mean_deg"] = json!(e.linearised.map(|m| (e.mean() - e.rectified + m).to_degrees()));
    }
    if let Some(measured) = r.measured {
        out["measured_spectrum_mean_deg"] = json!(measured.to_degrees());
    }
    if let Some(summed) = r.summed {
        out["summed_mean_deg"] = json!(summed.to_degrees());
    }
    if let Some(m) = &r.simulated {
        let to2 = 1f64.to_degrees().powi(2);
        out["simulated"] = json!({
            "mean_deg": m.mean.to_degrees(),
            "mean_margin_deg": m.mean_margin.to_degrees(),
            "variance_deg2": m.variance * to2,
            "variance_margin_deg2": m.variance_margin * to2,
            "percentiles_deg": distribution::of(m.percentiles.map(|q| q.value)),
            "percentiles_low_deg": distribution::of(m.percentiles.map(|q| q.low)),
            "percentiles_high_deg": distribution::of(m.percentiles.map(|q| q.high)),
        });
    }
    out
}
