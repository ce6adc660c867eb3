//! The rolling error of a gyrocompass as one page with pictures.

use super::{card, recorded as told, words};
use crate::gyro::{SIGN, side};
use crate::report::page::{self, Page, Section, table};
use crate::report::polar::{self, Polar};
use crate::report::svg::{Layer, Picture, escaped};
use crate::rolling::{self, Against, Analysis, Table};
use crate::units::{figure, significant};
use std::path::Path;

/// What the page shows.
#[derive(Debug, Clone, Copy)]
pub struct Sheet<'a> {
    /// All rows, for the card.
    pub table: &'a Table,
    /// Take each so many-th row into the numbers; 1: all.
    pub every: usize,
    /// The mean error as a formula, where one is kept.
    pub formula: Option<&'a str>,
    /// Seed of the simulation.
    pub seed: u64,
}

/// Everything that the page says.
struct Rolling<'a> {
    /// Its elastic part.
    part: String,
    /// Where its numbers come from.
    compass: &'a str,
    /// The motion in words.
    motion: &'a str,
    /// What the rows run over, with its unit, such as `heading, °`.
    against: &'a str,
    rows: Vec<Row>,
    /// The compass card, where the rows run around it.
    card: Option<Polar>,
    /// The recorded roll, where there is one.
    recorded: Option<Recorded<'a>>,
    /// What of the linear theory does not hold; empty where all of it does.
    beyond: &'a str,
    /// What of the numbers to trust, in paragraphs.
    trust: &'a str,
    /// Whether the mean to trust is that by the measured spectrum.
    by_spectrum: bool,
    /// The mean error as a formula, where one is kept.
    formula: Option<&'a str>,
    /// Files with their SHA-256.
    inputs: Vec<(&'a Path, &'a str)>,
    /// Seed of the simulation.
    seed: u64,
}

/// One error, degrees.
struct Row {
    /// What the rows run over, in its unit.
    value: f64,
    mean: f64,
    /// Standard deviation.
    spread: f64,
    /// The part of it with each roll.
    quick: f64,
    /// The part of it by products of motions, whose strength comes and goes.
    slow: f64,
    /// Half the 99 % interval of the mean, where a simulation gives it.
    margin: Option<f64>,
    /// The mean by quadrature over the measured spectrum.
    measured: Option<f64>,
}

/// A recorded roll and its fit.
struct Recorded<'a> {
    name: &'a str,
    /// s and degrees.
    roll: Vec<[f64; 2]>,
    /// Lag in s and correlation in square degrees.
    correlation: Vec<[f64; 2]>,
    /// The same by the fit.
    correlation_fit: Vec<[f64; 2]>,
    /// rad/s and density in square degrees times seconds.
    spectrum: Vec<[f64; 2]>,
    /// The same by the fit.
    spectrum_fit: Vec<[f64; 2]>,
    /// The fit in words, a line each.
    says: &'a str,
}

pub fn page(sheet: &Sheet<'_>) -> String {
    let (t, recorded) = (sheet.table, sheet.table.recorded.as_ref().map(|r| &r.analysis));
    let says = sheet.table.recorded.as_ref().map(told::words).unwrap_or_default();
    let sources = recorded.iter().flat_map(|r| &r.sources);
    let round = t.rows.len() > 8;
    drawn(&Rolling {
        part: words::part(t.compass.part.name()),
        compass: &words::origin(&t.compass.origin),
        motion: &words::motion(t),
        against: match t.against {
            Against::Heading(_) => "heading, °",
            Against::Latitude { .. } => "latitude, °",
            Against::Height { .. } => "significant height, m",
        },
        rows: t.rows.iter().step_by(sheet.every.max(1)).map(row).collect(),
        card: card(t).filter(|_| round),
        recorded: recorded.map(|r| pictured(r, &says)),
        beyond: &words::beyond(&t.smallness),
        trust: &words::note(t),
        by_spectrum: t.is_by_spectrum() || t.is_by_sums(),
        formula: sheet.formula,
        inputs: sources.map(|s| (Path::new(&s.file), s.sha256.as_str())).collect(),
        seed: sheet.seed,
    })
}

fn row(r: &rolling::Row) -> Row {
    Row {
        value: r.value,
        mean: words::plain(r.error.mean().to_degrees()),
        spread: r.error.deviation.to_degrees(),
        quick: r.error.deviation_linear.to_degrees(),
        slow: r.error.deviation_quadratic.to_degrees(),
        margin: (!r.is_exact()).then(|| r.error.rectified_margin.to_degrees()),
        measured: r.measured.or(r.summed).map(|m| words::plain(m.to_degrees())),
    }
}

fn pictured<'a>(a: &'a Analysis, says: &'a str) -> Recorded<'a> {
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

fn drawn(r: &Rolling<'_>) -> String {
    let program = concat!("gyrospec ", env!("CARGO_PKG_VERSION"));
    let page = Page {
        kind: "Rolling error of a gyrocompass".into(),
        title: "Rolling error of a gyrocompass".into(),
        verdict: sentence(r),
        lead: format!("{} Motion: {}. Compass: {}; elastic part: {}.", r.beyond, r.motion, r.compass, r.part)
            .trim_start()
            .to_owned(),
        sections: vec![
            Section::new("card", "The error", errors(r)),
            Section::new("roll", "The recorded roll", r.recorded.as_ref().map_or(String::new(), recorded)),
            Section::new("table", "The numbers", rows(r)),
            Section::new("trust", "What to trust", paragraphs(r.trust)),
            Section::new("formula", "The mean as a formula", r.formula.map_or(String::new(), formula)),
            page::made(program, r.seed, r.inputs.iter().copied()),
        ],
    };
    page.html()
}

/// Degrees with their sign and four decimals.
fn degrees(x: f64) -> String {
    let sign = if x < 0.0 { "−" } else { "+" };
    if x.abs() < 5e-5 { "0°".into() } else { format!("{sign}{:.4}°", x.abs()) }
}

fn sentence(r: &Rolling<'_>) -> String {
    let mean = |x: &Row| x.measured.filter(|_| r.by_spectrum).unwrap_or(x.mean);
    let worst = r.rows.iter().max_by(|a, b| mean(a).abs().total_cmp(&mean(b).abs()));
    let Some(w) = worst else { return "There is nothing to compute.".into() };
    let (what, unit) = r.against.split_once(", ").unwrap_or((r.against, ""));
    format!(
        "On this roll the compass is off by {}{}° ({}) in the mean{} at {what} {}{}{unit}, and swings by ±{}° about it.",
        if mean(w) < 0.0 { "−" } else { "+" },
        significant(mean(w).abs(), 3),
        side(mean(w)),
        match (r.by_spectrum, r.recorded.is_some()) {
            (true, true) => " (by its measured spectrum)",
            (true, false) => " (by sums over the sea's own spectrum)",
            (false, true) if w.measured.is_some() => " (by its fit)",
            _ => "",
        },
        figure(w.value),
        if unit == "°" { "" } else { " " },
        significant(w.spread, 3)
    )
}

fn errors(r: &Rolling<'_>) -> String {
    if let Some(card) = &r.card {
        return polar::figure(card);
    }
    let of = |f: fn(&Row) -> f64| r.rows.iter().map(|x| [x.value, f(x)]).collect::<Vec<_>>();
    let band = r.rows.iter().map(|x| [x.value, x.mean - x.spread, x.mean + x.spread]).collect();
    let band = Layer::Ribbon { class: "band", name: "± one standard deviation".into(), points: band };
    let mean = of(|x| x.mean);
    let dots = if mean.len() < 30 { mean.clone() } else { Vec::new() };
    Picture::new("mean error of heading", r.against, "error, °")
        .with(band)
        .with(Layer::line("after", "mean", mean))
        .with(Layer::dots("after", "", dots))
        .draw()
}

fn recorded(r: &Recorded<'_>) -> String {
    let name = r.name;
    let roll = Picture::new(&format!("roll in “{name}”"), "time, s", "roll, °").with(Layer::line(
        "after",
        "",
        r.roll.clone(),
    ));
    let correlation = Picture::new("correlation of the roll", "lag, s", "K(τ), (°)²")
        .with(Layer::line("measured", "measured", r.correlation.clone()))
        .with(Layer::line("after", "fit A e^(−μ|τ|)(cos ετ + (μ/ε) sin ε|τ|)", r.correlation_fit.clone()));
    let spectrum = Picture::new("spectrum of the roll", "angular frequency, rad/s", "S(ω), (°)²·s")
        .logarithmic()
        .with(Layer::line("measured", "measured", r.spectrum.clone()))
        .with(Layer::line("after", "fit", r.spectrum_fit.clone()));
    let pictures = roll.draw() + &correlation.draw() + &spectrum.draw();
    pictures + &format!("<p class=\"note\">{}</p>", escaped(r.says).replace('\n', "<br>"))
}

fn rows(r: &Rolling<'_>) -> String {
    let measured = r.rows.iter().any(|x| x.measured.is_some());
    let margin = r.rows.iter().any(|x| x.margin.is_some());
    let cells = |x: &Row| {
        let mut cells = vec![
            figure(x.value),
            degrees(x.mean),
            format!("±{:.4}°", x.spread),
            format!("{:.4}°", x.quick),
            format!("{:.4}°", x.slow),
        ];
        if margin {
            cells.push(x.margin.map_or("–".into(), |m| format!("±{m:.4}°")));
        }
        if measured {
            cells.push(x.measured.map_or("–".into(), degrees));
        }
        cells
    };
    let first = format!("#{}", r.against);
    let mut heads = vec![first.as_str(), "#mean", "#spread", "#of it quick", "#of it slow"];
    if margin {
        heads.push("#mean within (99 %)");
    }
    if measured {
        heads.push(if r.recorded.is_some() { "#mean by measured spectrum" } else { "#mean by sums" });
    }
    table(&heads, &r.rows.iter().map(cells).collect::<Vec<_>>())
        + &format!("<p class=\"note\">{SIGN}<br>{}</p>", words::PARTS_OF_SPREAD)
}

fn paragraphs(text: &str) -> String {
    if text.trim().is_empty() { String::new() } else { format!("<p>{}</p>", escaped(text.trim())) }
}

fn formula(text: &str) -> String {
    format!("<pre class=\"scroll\">{}</pre>", escaped(text.trim()))
}
