//! Pictures of what a model leaves, against itself and against its inputs.

use crate::estimate::Correlation;
use crate::report::svg::{Layer, Picture, escaped};

/// Pictures at most.
const MOST: usize = 12;

/// The correlations after, and before where those differ, with what their bands mean; empty where there are none.
pub fn section(before: &[Correlation], after: &[Correlation]) -> String {
    if after.is_empty() {
        return String::new();
    }
    let mut out = String::from(
        "<p class=\"note\">On the fitted part. Each lag by itself lies in the 99 % band by chance, so that one in a \
         hundred lies outside. The residual of a free run is coloured by the sensor and by whatever drives the system, so \
         the bands are not those of white noise: against itself, noise that remembers no longer than up to that lag; \
         against an input, noise of the residual's own spectrum that knows nothing of the input. At positive lags the \
         input comes first; what is outside at negative lags is feedback, or a clock that is off.</p>",
    );
    for (k, own) in after.iter().enumerate().take(MOST) {
        out += &picture(before.get(k).filter(|b| *b != own), own);
        out += &format!("<p class=\"note\">{}</p>", escaped(&reach(own)));
    }
    if after.len() > MOST {
        out += &format!("<p class=\"note\">{} more are not drawn.</p>", after.len() - MOST);
    }
    out
}

fn picture(before: Option<&Correlation>, after: &Correlation) -> String {
    let step = after.step.unwrap_or(1.0);
    let lag = |c: &Correlation, i: usize| step * (c.lags.first + i as isize) as f64;
    let points = |c: &Correlation| -> Vec<[f64; 2]> {
        c.lags.values.iter().enumerate().map(|(i, r)| [lag(c, i), *r]).collect()
    };
    let band = after.lags.band.iter().enumerate().map(|(i, b)| [lag(after, i), -b, *b]).collect();
    let title = match &after.input {
        None => format!("{}: the residual against itself", after.output),
        Some(input) => format!("{}: the residual against {input}", after.output),
    };
    let x = if after.step.is_some() { "lag, s" } else { "lag, samples (they follow each other unevenly)" };
    Picture::new(&title, x, "correlation")
        .with(Layer::Ribbon { class: "band", name: "99 % by chance".into(), points: band })
        .with(Layer::line("before whole thin", "model as given", before.map_or_else(Vec::new, points)))
        .with(Layer::line(
            "after",
            if before.is_some() { "with what was found" } else { "residual" },
            points(after),
        ))
        .draw()
}

/// How far it leaves its band, in words.
fn reach(c: &Correlation) -> String {
    let outside = c.lags.values.iter().zip(&c.lags.band).filter(|(v, b)| v.abs() > **b).count();
    let all = c.lags.values.len();
    format!(
        "{outside} of {all} lags lie outside the band{}.",
        if outside > 0 {
            format!(", at most {:.1} times its half width", c.lags.reach())
        } else {
            String::new()
        }
    )
}
