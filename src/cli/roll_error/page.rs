//! The same as one page with pictures.

use super::measured::{self, Analysis};
use super::options::Against;
use super::parameters::Part;
use super::table::{Plan, Row, plain};
use super::{Arguments, formulas};
use crate::Result;
use crate::report::rolling::{self, Recorded, Rolling};
use std::path::Path;

/// The page of rows that were computed: all of them for the card, some of them for the table.
pub fn html(plan: &Plan, (all, some): (&[Row], &[&Row]), part: Part, a: &Arguments) -> Result<String> {
    let says = plan.recorded.as_ref().map(measured::words).unwrap_or_default();
    let sources = plan.recorded.iter().flat_map(|r| &r.sources);
    Ok(rolling::page(&Rolling {
        instrument: &plan.compass.instrument_name,
        compass: &plan.compass.says,
        motion: &plan.motion_says,
        against: match plan.against {
            Against::Heading => "heading, °",
            Against::Latitude => "latitude, °",
            Against::Height => "significant height, m",
        },
        rows: some.iter().map(|r| row(r)).collect(),
        card: plan.goes_round().then(|| plan.polar(all)).transpose()?,
        recorded: plan.recorded.as_ref().map(|r| recorded(r, &says)),
        beyond: &plan.beyond(),
        trust: &plan.after,
        by_spectrum: plan.by_spectrum,
        formula: formulas::derived(part).ok().filter(|_| !a.motion.is_sea()).map(|d| d.formula.text()),
        inputs: sources.map(|s| (Path::new(&s.file), s.sha256.as_str())).collect(),
        seed: a.rows.seed,
    }))
}

fn row(r: &Row) -> rolling::Row {
    rolling::Row {
        value: r.value,
        mean: plain(r.error.mean().to_degrees()),
        spread: r.error.spread.to_degrees(),
        swing: r.error.spread_linear.to_degrees(),
        products: r.error.spread_quadratic.to_degrees(),
        margin: (!r.is_exact()).then(|| r.error.rectified_margin.to_degrees()),
        measured: r.measured.map(|m| plain(m.to_degrees())),
    }
}

fn recorded<'a>(a: &'a Analysis, says: &'a str) -> Recorded<'a> {
    let to2 = |x: f64| x.to_degrees().to_degrees();
    let step = a.samples.step;
    let at_lags = |k: &[f64]| k.iter().enumerate().map(|(i, v)| [i as f64 * step, to2(*v)]).collect();
    let spectrum = || a.spectrum.omega.iter().zip(&a.spectrum.density).skip(1);
    let rolled = a.samples.values.iter().enumerate();
    Recorded {
        name: &a.name,
        roll: rolled.map(|(i, v)| [a.start + i as f64 * step, v.to_degrees()]).collect(),
        correlation: at_lags(&a.fit.measured),
        correlation_fit: at_lags(&a.fit.fitted),
        spectrum: spectrum().map(|(w, s)| [*w, to2(*s)]).collect(),
        spectrum_fit: spectrum().map(|(w, _)| [*w, to2(a.fit.roll.density(*w))]).collect(),
        says,
    }
}
