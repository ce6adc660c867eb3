//! The voyage as one page with pictures.

use super::text;
use crate::gyro::pendulous::{AtLatitude, OnHeading, SettledVoyage, Voyage};
use crate::gyro::{SIGN, side};
use crate::report::page::{Page, Section, table};
use crate::report::svg::{Layer, Picture, escaped};
use crate::units::{figure, significant};

/// The page.
pub fn page(voyage: &Voyage, told: &SettledVoyage) -> String {
    let program = concat!("gyrospec ", env!("CARGO_PKG_VERSION"));
    let page = Page {
        kind: "A gyrocompass with a liquid ballistic".into(),
        title: "Errors of a compass with a liquid ballistic".into(),
        verdict: sentence(voyage, told),
        lead: if told.is_linear() {
            String::new()
        } else {
            "Beyond the linear theory: the heading is off by more than the 10° to which it holds.".into()
        },
        sections: vec![
            Section::new("heading", "By heading", by_heading(told)),
            Section::new("latitude", "By latitude", by_latitude(voyage)),
            Section::new("numbers", "The numbers", numbers(voyage, told)),
            Section::new(
                "made",
                "How this was made",
                format!("<p>{program}. The same options give the same bytes.</p>"),
            ),
        ],
    };
    page.html()
}

/// The error that the navigator meets: what the corrector leaves, where there is one.
fn met(r: &OnHeading) -> f64 {
    r.corrected.unwrap_or(r.settled())
}

fn sentence(voyage: &Voyage, told: &SettledVoyage) -> String {
    let worst = told.rows.iter().max_by(|a, b| met(a).abs().total_cmp(&met(b).abs()));
    let Some(worst) = worst else { return "There is nothing to compute.".into() };
    let on = match told.rows.len() {
        1 => String::new(),
        _ => format!(" at heading {}°", figure(worst.heading.to_degrees())),
    };
    let spread = told.spread.map_or(String::new(), |s| {
        format!(
            ", and manoeuvres spread it by ±{}° about the error of the speed at each moment",
            significant(s.to_degrees(), 3)
        )
    });
    format!(
        "At latitude {}° the compass settles {}° off ({}){on}{}{spread}.",
        figure(voyage.compass.latitude.to_degrees()),
        significant(met(worst).to_degrees().abs(), 3),
        side(met(worst)),
        if worst.corrected.is_some() { " behind its corrector" } else { "" },
    )
}

fn by_heading(told: &SettledVoyage) -> String {
    if told.rows.len() < 3 {
        return String::new();
    }
    let of = |f: &dyn Fn(&OnHeading) -> f64| -> Vec<[f64; 2]> {
        told.rows.iter().map(|r| [r.heading.to_degrees(), f(r).to_degrees()]).collect()
    };
    let mut picture = Picture::new("settled error", "heading, °", "error, °").with(Layer::line(
        "before",
        "without a corrector",
        of(&OnHeading::settled),
    ));
    if told.rows.iter().all(|r| r.corrected.is_some()) {
        picture = picture.with(Layer::line("after", "left by the corrector", of(&met)));
    }
    picture.draw()
}

/// Every two degrees, to 80° on both sides of the equator.
fn by_latitude(voyage: &Voyage) -> String {
    let all: Vec<AtLatitude> = (-40..=40).map(|k| voyage.at((2.0 * f64::from(k)).to_radians())).collect();
    let of = |f: fn(&AtLatitude) -> Option<f64>| -> Vec<[f64; 2]> {
        all.iter().filter_map(|a| Some([a.latitude.to_degrees(), f(a)?.to_degrees()])).collect()
    };
    let error = Picture::new("error by the damping, at rest", "latitude, °", "error, °").with(Layer::line(
        "after",
        "−ε tan φ",
        of(|a| a.by_damping),
    ));
    let spread = of(|a| a.spread);
    if spread.is_empty() {
        return error.draw();
    }
    let spread =
        Picture::new("spread of the heading under manoeuvres", "latitude, °", "standard deviation, °")
            .with(Layer::line("after", "", spread));
    error.draw() + &spread.draw()
}

fn numbers(voyage: &Voyage, told: &SettledVoyage) -> String {
    let cells = |r: &OnHeading| {
        let degrees = |x: f64| text::signed(x);
        let corrected = r.corrected.map_or("–".into(), degrees);
        vec![
            figure(r.heading.to_degrees()),
            degrees(r.by_speed),
            degrees(r.by_damping),
            degrees(r.settled()),
            corrected,
        ]
    };
    let heads = ["#heading, °", "#by speed", "#by damping", "#settled", "#behind the corrector"];
    let all = told.rows.iter().map(cells).collect::<Vec<_>>();
    format!(
        "{}<p class=\"note\">{SIGN}</p><p class=\"note\">Where H, ε or the lag of the flow were not given they are round numbers \
         of the size of such compasses, and of no maker’s.</p><pre class=\"scroll\">{}</pre>",
        table(&heads, &all),
        escaped(&text::text(voyage, told))
    )
}
