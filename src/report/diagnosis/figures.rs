//! The pictures of the page.

use super::html::title;
use crate::diagnose::answer::{Answer, Stretch};
use crate::diagnose::pictures::{Course, Pictures};
use crate::report::page::with_unit;
use crate::report::svg::{Layer, Picture, escaped};

fn pairs(spans: &[Stretch]) -> Vec<[f64; 2]> {
    spans.iter().map(|s| [s.from, s.to]).collect()
}

fn clock(p: &Pictures) -> &'static str {
    if p.trials { "trial (row)" } else { "time, s" }
}

/// A series over time: a line, or dots where each row is a trial of its own.
fn series(p: &Pictures, class: &'static str, name: &str, points: &[[f64; 2]]) -> Layer {
    if p.trials {
        Layer::dots(class, name, points.to_vec())
    } else {
        Layer::line(class, name, points.to_vec())
    }
}

fn heading(c: &Course) -> String {
    if c.recording.is_empty() { c.output.clone() } else { format!("{} in “{}”", c.output, c.recording) }
}

/// Recording against model, before and after.
pub fn courses(p: &Pictures) -> String {
    let picture = |c: &Course| {
        Picture::new(&heading(c), clock(p), &with_unit(&c.output, &c.unit))
            .with(Layer::span("held", "held out", pairs(&c.held)))
            .with(series(p, "measured", "measured", &c.measured))
            .with(series(p, "before", "model as given", &c.before))
            .with(series(p, "after", "with what was found", if changed(c) { &c.after } else { &[] }))
            .draw()
    };
    p.courses.iter().map(picture).collect()
}

/// Whether the findings moved the prediction at all.
fn changed(c: &Course) -> bool {
    let differs = |(b, a): (&[f64; 2], &[f64; 2])| b[1].is_finite() && b != a;
    c.residual_before.iter().zip(&c.residual_after).any(differs)
}

/// Residuals over time, with the located spans.
pub fn residuals(p: &Pictures, a: &Answer) -> String {
    let picture = |c: &Course| {
        let after: &[[f64; 2]] = if changed(c) { &c.residual_after } else { &[] };
        let fitted = c.held.len() != 1 || c.measured.first().is_some_and(|m| m[0] < c.held[0].from);
        let located = if fitted { pairs(&a.located.time) } else { Vec::new() };
        Picture::new(
            &format!("{}: measured less model", heading(c)),
            clock(p),
            &with_unit("residual", &c.difference_unit),
        )
        .with(Layer::span("held", "held out", pairs(&c.held)))
        .with(Layer::span("shade", "where the mismatch sits", located))
        .with(series(p, "before whole", "model as given", &c.residual_before))
        .with(series(p, "after", "with what was found", after))
        .draw()
    };
    p.courses.iter().map(picture).collect()
}

/// Residuals in frequency, with the located bands.
pub fn spectra(p: &Pictures, a: &Answer) -> String {
    if p.trials {
        return String::new();
    }
    let pictures = p.spectra.iter().map(|s| {
        let located = if a.located.bands.is_empty() { &[][..] } else { &s.bands };
        let bands: Vec<[f64; 2]> = located.iter().map(|b| [b.from, b.to]).collect();
        let after = if s.before == s.after { Vec::new() } else { s.after.clone() };
        Picture::new(
            &format!("{}: power of the residual, fitted part", s.output),
            "angular frequency, rad/s",
            "relative power",
        )
        .logarithmic()
        .with(Layer::span("shade", "bands that hold most of the mismatch", bands))
        .with(Layer::line("before whole", "model as given", s.before.clone()))
        .with(Layer::line("after", "with what was found", after))
        .draw()
    });
    pictures.collect()
}

/// The residual against the accused signal, with the fitted law and its band.
pub fn laws(p: &Pictures, a: &Answer) -> String {
    let mut out = String::new();
    for l in &p.laws {
        let curve: Vec<[f64; 2]> = l.curve.iter().map(|c| [c[0], c[1]]).collect();
        let band: Vec<[f64; 3]> = l.curve.iter().map(|c| [c[0], c[2], c[3]]).collect();
        let says = a.findings.iter().find(|f| f.code == l.code && f.term == l.term).map(|f| f.says.as_str());
        out += &Picture::new(
            &format!("{} against {}", title(&l.code), if l.signal == "t" { "time" } else { &l.signal }),
            &with_unit(&l.signal, &l.signal_unit),
            &with_unit(&l.effect, &l.effect_unit),
        )
        .with(Layer::dots("measured", "from the recording", l.samples.clone()))
        .with(Layer::Ribbon { class: "band", name: "its 95 % band".into(), points: band })
        .with(Layer::line("after", &format!("fitted: {}", l.term), curve))
        .with(Layer::Bars { class: "mean", name: "means with 95 %".into(), points: l.means.clone() })
        .draw();
        if let Some(says) = says {
            out += &format!("<p class=\"note\">{}.</p>", escaped(says.trim_end_matches('.')));
        }
    }
    out
}

/// Channels with faults, and where they sit.
pub fn faults(p: &Pictures) -> String {
    let pictures = p.faults.iter().map(|f| {
        Picture::new(&format!("{}: {}", f.channel, title(&f.code)), clock(p), &with_unit(&f.channel, &f.unit))
            .with(Layer::span("fault", "faulty", pairs(&f.spans)))
            .with(series(p, "after", "as recorded", &f.recorded))
            .draw()
    });
    pictures.collect()
}

/// The law that no name explains, along its signal.
pub fn unexplained(a: &Answer) -> String {
    let Some(u) = &a.unexplained else { return String::new() };
    let line: Vec<[f64; 2]> = u.shape.iter().map(|s| [s[0], s[1]]).collect();
    let picture = Picture::new(
        &format!("what is left, against {}", u.signal),
        &format!("{}, SI", u.signal),
        "effect, SI",
    )
    .with(Layer::line("after", "", line))
    .with(Layer::Bars { class: "mean", name: "effect with 95 %".into(), points: u.shape.clone() })
    .draw();
    format!(
        "<p>It goes with {}; the chance that it is noise is {:.2e}.</p>{picture}",
        escaped(&u.signal),
        u.p_value
    )
}
