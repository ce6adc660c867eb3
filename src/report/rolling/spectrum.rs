//! The spectrum of the heading error, as text, as JSON and as a page.

use super::words;
use crate::Result;
use crate::gyro::{SIGN, side};
use crate::report::json::object;
use crate::report::page::{Page, Section, table};
use crate::report::svg::{Layer, Picture, escaped};
use crate::rolling::{Compass, Density, ErrorSpectrum, Excitation};
use crate::units::{figure, significant};
use serde_json::json;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Of so many densities one stands in a text.
const SHOWN: usize = 5;

/// rad² in square degrees.
fn square(x: f64) -> f64 {
    x.to_degrees().to_degrees()
}

/// The spectrum in words.
pub fn spectrum_text(compass: &Compass, excitation: &Excitation, told: &ErrorSpectrum) -> String {
    let mut out = heard(compass, excitation, told);
    out.push_str(
        "\nS(ω) of the error, two-sided: its variance is (1/π) ∫₀^∞ S dω\n  \
         ω, rad/s      period      S, (°)²·s   of it by swing   by products\n",
    );
    for d in told.densities.iter().step_by(SHOWN) {
        let [whole, swing, products] = [d.whole(), d.swing, d.products].map(|x| format!("{:.4e}", square(x)));
        let _ = writeln!(
            out,
            "{:>11.4e} {:>11} {whole:>14} {swing:>16} {products:>13}",
            d.omega,
            period(d.omega)
        );
    }
    let _ = writeln!(out, "\n--json has {} frequencies, --html FILE the picture.", told.densities.len());
    out
}

/// 2π/ω as people say it.
fn period(omega: f64) -> String {
    match TAU / omega {
        t if t >= 7200.0 => format!("{} h", significant(t / 3600.0, 3)),
        t if t >= 120.0 => format!("{} min", significant(t / 60.0, 3)),
        t => format!("{} s", significant(t, 3)),
    }
}

fn heard(compass: &Compass, excitation: &Excitation, told: &ErrorSpectrum) -> String {
    let e = &told.error;
    format!(
        "Heading error at heading {}°, {} ({})\nmotion: {}\n\
         mean {}° ({}), standard deviation {}°: {}° by the swing, {}° by products of motions\n",
        figure(told.heading.to_degrees()),
        compass.part.name(),
        words::origin(&compass.origin),
        words::excitation(excitation, None, false),
        significant(words::plain(e.mean().to_degrees()), 4),
        side(e.mean()),
        significant(e.deviation.to_degrees(), 4),
        significant(e.deviation_linear.to_degrees(), 4),
        significant(e.deviation_quadratic.to_degrees(), 4),
    )
}

/// The same as one JSON object, by `docs/schemas/roll-error-spectrum.json`.
///
/// # Errors
/// `NotComputed` for what JSON cannot hold.
pub fn spectrum_json(compass: &Compass, excitation: &Excitation, told: &ErrorSpectrum) -> Result<String> {
    let row = |d: &Density| {
        json!({
            "omega_rad_per_s": d.omega, "density_deg2_s": square(d.whole()),
            "by_swing_deg2_s": square(d.swing), "by_products_deg2_s": square(d.products),
        })
    };
    let e = &told.error;
    let value = json!({
        "schema": "gyrospec.roll-error-spectrum/1",
        "instrument": compass.part.name(),
        "motion": words::excitation(excitation, None, false),
        "heading_deg": told.heading.to_degrees(),
        "mean_deg": words::plain(e.mean().to_degrees()),
        "spread_deg": e.deviation.to_degrees(),
        "spread_by_swing_deg": e.deviation_linear.to_degrees(),
        "spread_by_products_deg": e.deviation_quadratic.to_degrees(),
        "densities": told.densities.iter().map(row).collect::<Vec<_>>(),
        "sign": SIGN,
    });
    object(&value)
}

/// The same as one page.
pub fn spectrum_page(compass: &Compass, excitation: &Excitation, told: &ErrorSpectrum) -> String {
    let line = |part: fn(&Density) -> f64| -> Vec<[f64; 2]> {
        let points = told.densities.iter().map(|d| [d.omega, square(part(d))]);
        points.filter(|p| p[1] > 0.0).collect()
    };
    let picture = Picture::new("spectrum of the heading error", "angular frequency, rad/s", "S(ω), (°)²·s")
        .logarithmic()
        .with(Layer::line("measured", "by the swing", line(|d| d.swing)))
        .with(Layer::line("before", "by products of motions", line(|d| d.products)))
        .with(Layer::line("after", "the whole", line(Density::whole)));
    let cells = |d: &Density| {
        let degrees = |x: f64| format!("{:.4e}", square(x));
        vec![
            format!("{:.4e}", d.omega),
            period(d.omega),
            degrees(d.whole()),
            degrees(d.swing),
            degrees(d.products),
        ]
    };
    let heads = ["#ω, rad/s", "#period", "#S, (°)²·s", "#by swing", "#by products"];
    let rows: Vec<_> = told.densities.iter().step_by(SHOWN).map(cells).collect();
    let e = &told.error;
    let page = Page {
        kind: format!("Spectrum of the heading error: {}", compass.part.name()),
        title: "Spectrum of the heading error".into(),
        verdict: format!(
            "At heading {}° the compass swings by ±{}° about its mean of {}°.",
            figure(told.heading.to_degrees()),
            significant(e.deviation.to_degrees(), 3),
            significant(words::plain(e.mean().to_degrees()), 3)
        ),
        lead: String::new(),
        sections: vec![
            Section::new("spectrum", "The spectrum", picture.draw()),
            Section::new("numbers", "The numbers", table(&heads, &rows)),
            Section::new(
                "made",
                "How this was made",
                format!(
                    "<pre class=\"scroll\">{}</pre><p>gyrospec {}</p>",
                    escaped(&heard(compass, excitation, told)),
                    env!("CARGO_PKG_VERSION")
                ),
            ),
        ],
    };
    page.html()
}
