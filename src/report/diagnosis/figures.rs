//! The pictures of the page.

use super::text::{chance, title};
use crate::diagnose::answer::{Answer, Band, Spell, Stretch};
use crate::diagnose::pictures::{Course, Law, Pictures, Point};
use crate::report::page::{percent, with_unit};
use crate::report::svg::{Layer, Picture, escaped};
use crate::units::figure;
use std::f64::consts::TAU;

fn pairs(spans: &[Stretch]) -> Vec<[f64; 2]> {
    spans.iter().map(|s| [s.from, s.to]).collect()
}

/// A picture over time, in the unit in which the first recording counts it, or over the rows of trials.
fn over_time(p: &Pictures, title: &str, y: &str) -> Picture {
    if p.trials {
        return Picture::new(title, "trial (row)", y);
    }
    Picture::new(title, &with_unit("time", &p.clock.unit), y).in_units_of(p.clock.seconds)
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

/// Recording against model, before and after: the whole, and where they part most.
pub fn courses(p: &Pictures) -> String {
    let mut out = String::new();
    for c in &p.courses {
        out += &course(p, c, (&heading(c), true), [&c.measured, &c.before, &c.after]);
        if let Some(near) = c.close.as_ref().filter(|_| !p.trials) {
            let title = format!("{}: a closer look, where they part most", heading(c));
            out += &course(p, c, (&title, false), [&near.measured, &near.before, &near.after]);
        }
    }
    out
}

/// The measurement lies on top of both models.
fn course(
    p: &Pictures,
    c: &Course,
    (title, whole): (&str, bool),
    [measured, before, after]: [&[Point]; 3],
) -> String {
    let after = if changed(c) { after } else { &[] };
    let named = |name: &str, [fitted, held]: [f64; 2]| {
        if whole { format!("{name}{}", percent(fitted, held)) } else { name.to_owned() }
    };
    over_time(p, title, &with_unit(&c.output, &c.unit))
        .with(Layer::span("held", "held out", pairs(&c.held)))
        .with(series(p, "before", &named("model as given", c.percent_before), before))
        .with(series(p, "after", &named("with what was found", c.percent_after), after))
        .with(series(p, "measured", "measured", measured))
        .draw()
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
        let here = |s: &&Spell| fitted && s.recording.as_ref().is_none_or(|r| *r == c.recording);
        let located: Vec<[f64; 2]> = a.located.time.iter().filter(here).map(|s| [s.from, s.to]).collect();
        over_time(
            p,
            &format!("{}: measured less model", heading(c)),
            &with_unit("residual", &c.difference_unit),
        )
        .with(Layer::span("held", "held out", pairs(&c.held)))
        .with(Layer::span("shade", "where the mismatch sits", located))
        .with(series(p, "before whole thin", "model as given", &c.residual_before))
        .with(series(p, "after thin", "with what was found", after))
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
        let drawn = Picture::new(
            &format!("{}: power of the residual, fitted part", s.output),
            "angular frequency, rad/s (frequency, Hz)",
            "relative power",
        )
        .logarithmic()
        .beside(1.0 / TAU)
        .with(Layer::span("shade", "bands that hold most of the mismatch", bands))
        .with(Layer::line("before whole", "model as given", s.before.clone()))
        .with(Layer::line("after", "with what was found", after))
        .draw();
        drawn + &located.iter().map(band).collect::<String>()
    });
    pictures.collect()
}

/// A band of the mismatch in words, in both units of frequency.
fn band(b: &Band) -> String {
    let [from, to] = [b.from, b.to].map(figure);
    let [from_hz, to_hz] = [b.from, b.to].map(|w| figure(w / TAU));
    let share = figure((1000.0 * b.share).round() / 10.0);
    format!(
        "<p class=\"note\">{from} to {to} rad/s ({from_hz} to {to_hz} Hz): {share} % of the mismatch.</p>"
    )
}

/// The residual against the accused signal, with the fitted law and its band.
pub fn laws(p: &Pictures, a: &Answer) -> String {
    let mut out = String::new();
    for (k, l) in p.laws.iter().enumerate() {
        out += &law(l);
        if p.laws.get(k + 1).is_some_and(|next| (&next.code, &next.term) == (&l.code, &l.term)) {
            continue;
        }
        let says = a.findings.iter().find(|f| f.code == l.code && f.term == l.term).map(|f| f.says.as_str());
        if let Some(says) = says {
            out += &format!("<p class=\"note\">{}.</p>", escaped(says.trim_end_matches('.')));
        }
    }
    out
}

fn law(l: &Law) -> String {
    let curve: Vec<[f64; 2]> = l.curve.iter().map(|c| [c[0], c[1]]).collect();
    let band: Vec<[f64; 3]> = l.curve.iter().map(|c| [c[0], c[2], c[3]]).collect();
    let name = if l.formula.is_empty() { "fitted".into() } else { format!("fitted: {}", l.formula) };
    let picture = Picture::new(
        &format!("{} against {}", title(&l.code), if l.signal == "t" { "time" } else { &l.signal }),
        &with_unit(&l.signal, &l.signal_unit),
        &with_unit(&l.effect, &l.effect_unit),
    )
    .with(Layer::dots("measured", "from the recording", l.samples.clone()));
    // What has a memory is no function of the signal: its values are dots, and have no band.
    let drawn = if zigzags(&curve) {
        picture.with(Layer::dots("after", &name, curve))
    } else {
        let band = Layer::Ribbon { class: "band", name: "its 95 % band".into(), points: band };
        picture.with(band).with(Layer::line("after", &name, curve))
    };
    drawn.with(Layer::Bars { class: "mean", name: "means with 95 %".into(), points: l.means.clone() }).draw()
}

/// Turns smaller than this part of a curve's height are its rounding.
const LEVEL: f64 = 0.02;

/// What rounding moves of a value.
const ROUNDING: f64 = 1e-9;

/// Whether a curve turns at every fifth point and more.
fn zigzags(curve: &[[f64; 2]]) -> bool {
    let ends = |f: fn(f64, f64) -> f64| curve.iter().map(|p| p[1]).filter(|y| y.is_finite()).reduce(f);
    let height = ends(f64::max).zip(ends(f64::min)).map_or(0.0, |(high, low)| high - low);
    // a level that the rounding of its means alone moves is a line
    let size = curve.iter().map(|p| p[1].abs()).filter(|y| y.is_finite()).fold(0.0, f64::max);
    let height = height.max(ROUNDING * size);
    let rises = curve.windows(2).map(|w| w[1][1] - w[0][1]);
    let rises: Vec<f64> = rises.filter(|r| r.abs() > LEVEL * height).collect();
    let turns = rises.windows(2).filter(|r| r[0] * r[1] < 0.0).count();
    turns > 4 && 5 * turns > curve.len()
}

/// Channels with faults, and where they sit.
pub fn faults(p: &Pictures) -> String {
    let pictures = p.faults.iter().map(|f| {
        over_time(p, &format!("{}: {}", f.channel, title(&f.code)), &with_unit(&f.channel, &f.unit))
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
        "<p>It goes with {}; the chance that it is noise is {}.</p>{picture}",
        escaped(&u.signal),
        chance(u.p_value)
    )
}

#[cfg(test)]
mod tests {
    use super::zigzags;

    #[test]
    fn a_step_and_a_wave_are_curves_and_a_comb_is_none() {
        let of = |f: fn(f64) -> f64| -> Vec<[f64; 2]> {
            (0..60).map(|i| f64::from(i) * 0.1).map(|x| [x, f(x)]).collect()
        };
        assert!(!zigzags(&of(|x| (x - 3.0).signum())) && !zigzags(&of(|x| (2.0 * x).sin())));
        // a step whose levels carry the rounding of their means
        assert!(!zigzags(&of(|x| (x - 3.0).signum() + 1e-12 * (31.0 * x).sin())));
        assert!(zigzags(&of(|x| (31.0 * x).sin())));
        assert!(!zigzags(&of(|x| 5.0 + 1e-13 * (31.0 * x).sin())));
    }
}
