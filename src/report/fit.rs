//! A fit as one page with pictures.

mod json;
mod text;

pub use json::render as json;
pub use text::render as text;

use crate::diagnose::pictures::closer;
use crate::estimate::fit::{
    Beside, Combination, Fit, HeldOut, InitialEstimate, ParameterEstimate, ResidualSpectrum, Series, Status,
};
use crate::estimate::{Correlation, Direction, fit_percent};
use crate::model::Output;
use crate::record::{Kind, Recording, Source};
use crate::report::correlation;
use crate::report::page::{self, Page, Section, head, percent, table, with_unit};
use crate::report::svg::{Layer, Picture, escaped};
use crate::units::{Unit, figure};
use std::f64::consts::TAU;
use std::path::Path;

/// Recordings that are drawn, at most, of the fitted and of the separate ones each.
const DRAWN: usize = 3;

/// A fit with all that a report of it says.
pub struct FitReport<'a> {
    /// The fitted model.
    pub fit: &'a Fit,
    /// The file of the model as given.
    pub source: &'a Source,
    /// What it does where it was not fitted.
    pub held_out: &'a [HeldOut],
    /// The recordings that were fitted.
    pub recordings: &'a [Recording],
    /// Recordings that were held out whole.
    pub separate: &'a [Recording],
    /// Spectra of the residuals, by output.
    pub spectra: &'a [ResidualSpectrum],
    /// What the residuals do against themselves and against the inputs.
    pub correlations: &'a [Correlation],
    pub seed: u64,
}

impl FitReport<'_> {
    /// The files that it rests on: the model, then the recordings.
    pub fn inputs(&self) -> impl Iterator<Item = &Source> {
        let recordings = self.recordings.iter().chain(self.separate).flat_map(|r| &r.sources);
        std::iter::once(self.source).chain(recordings)
    }
}

/// One output on one recording, fitted and held-out parts together, in order of time.
struct Course<'a> {
    output: &'a Output,
    title: String,
    trials: bool,
    /// The unit in which the recording counts time.
    time_unit: Unit,
    held: Vec<[f64; 2]>,
    samples: Vec<Beside>,
}

/// The page of a fit.
pub fn page(r: &FitReport<'_>) -> String {
    let courses = courses(r);
    let drawn = |draw: fn(&Course<'_>) -> String| courses.iter().map(draw).collect::<String>();
    let program = concat!("gyrospec ", env!("CARGO_PKG_VERSION"));
    let page = Page {
        kind: format!("Fit of the model “{}”", r.fit.model.name),
        title: format!("{}: fit", r.fit.model.name),
        verdict: sentence(r),
        lead: lead(r),
        sections: vec![
            Section::new("courses", "Recording and model", drawn(course)),
            Section::new("residuals", "What the model leaves over time", drawn(residual)),
            Section::new("spectra", "What it leaves in frequency", r.spectra.iter().map(spectrum).collect()),
            Section::new(
                "correlations",
                "What it leaves, against itself and its inputs",
                correlation::section(&[], r.correlations),
            ),
            Section::new("parameters", "Parameters", parameters(r)),
            Section::new("errors", "Free-run error", errors(r)),
            Section::new("unseen", "What these data do not tell", unseen(&r.fit.unseen, &r.fit.determined)),
            Section::new("warnings", "Warnings", warnings(r.fit)),
            page::made(program, r.seed, r.inputs().map(|s| (Path::new(&s.file), s.sha256.as_str()))),
        ],
    };
    page.html()
}

fn difference(output: &Output, si: f64) -> String {
    let unit = output.unit.of_differences();
    page::quantity(unit.difference_from_si(si), unit.text())
}

fn sentence(r: &FitReport<'_>) -> String {
    let follows = |(k, output): (usize, &Output)| {
        let held = r.held_out.get(k).map(|h| h.rmse).filter(|e| e.is_finite());
        let held = held.map_or(String::new(), |e| format!(" (held out: {})", difference(output, e)));
        format!("{} to {}{held}", output.name, difference(output, r.fit.rmse[k]))
    };
    let all: Vec<String> = r.fit.model.outputs.iter().enumerate().map(follows).collect();
    format!("The fitted model follows {}.", all.join(", "))
}

fn lead(r: &FitReport<'_>) -> String {
    let names: Vec<&str> = r.recordings.iter().map(|r| r.name.as_str()).collect();
    let mut text = format!(
        "Root mean square of measured less simulated, the model running free on its inputs alone. Fitted to {}.",
        names.join(", ")
    );
    if !r.fit.unseen.is_empty() {
        text += " Not all parameters can be told from these data: see below.";
    }
    text
}

fn courses<'a>(r: &FitReport<'a>) -> Vec<Course<'a>> {
    let fitted = r.recordings.iter().enumerate().take(DRAWN);
    let separate = r.separate.iter().enumerate().map(|(k, s)| (r.recordings.len() + k, s)).take(DRAWN);
    let mut all = Vec::new();
    for (number, recording) in fitted.chain(separate) {
        for (k, output) in r.fit.model.outputs.iter().enumerate() {
            all.extend(joined(r, (number, recording), (k, output)));
        }
    }
    all
}

fn joined<'a>(
    r: &FitReport<'a>,
    (number, recording): (usize, &Recording),
    (k, output): (usize, &'a Output),
) -> Option<Course<'a>> {
    let channel = recording.find(&output.name)?;
    let own = r.fit.records.get(number).filter(|_| number < r.recordings.len());
    let fitted = own.into_iter().flat_map(|f| &f.series).filter(|s| s.output == k);
    let held = r.held_out.get(k).into_iter().flat_map(|h| h.series.iter().zip(&h.recordings));
    let held: Vec<&Series> = held.filter(|(_, of)| **of == number).map(|(s, _)| s).collect();
    let mut samples: Vec<Beside> =
        fitted.chain(held.iter().copied()).flat_map(|s| s.beside(channel)).collect();
    samples.sort_by(|a, b| a.time.total_cmp(&b.time));
    let samples = without_seams(&samples);
    let ends = |s: &Series| -> Vec<[f64; 2]> {
        s.stretches.iter().map(|r| [s.time[r.start], s.time[r.end - 1]]).collect()
    };
    (!samples.is_empty()).then(|| Course {
        output,
        title: format!("{} in “{}”", output.name, recording.name),
        trials: recording.kind == Kind::Trials,
        time_unit: recording.time_unit(),
        held: held.into_iter().flat_map(ends).collect(),
        samples,
    })
}

/// A gap between neighbours is only the seam of a fitted and a held-out part: the line goes on.
fn without_seams(samples: &[Beside]) -> Vec<Beside> {
    let is_seam = |i: usize| -> bool {
        let [before, last, gap, next] =
            [i.wrapping_sub(2), i.wrapping_sub(1), i, i + 1].map(|k| samples.get(k));
        let (Some(b), Some(l), Some(g), Some(n)) = (before, last, gap, next) else { return false };
        !g.measured.is_finite() && n.time - l.time <= 1.5 * (l.time - b.time)
    };
    (0..samples.len()).filter(|i| !is_seam(*i)).map(|i| samples[i]).collect()
}

impl Course<'_> {
    fn picture(&self, title: &str, y: &str) -> Picture {
        let picture = if self.trials {
            Picture::new(title, "trial (row)", y)
        } else {
            let unit = &self.time_unit;
            Picture::new(title, &with_unit("time", unit.text()), y).in_units_of(unit.to_si(1.0))
        };
        picture.with(Layer::span("held", "held out", self.held.clone()))
    }

    fn points(&self, of: impl Fn(&Beside) -> f64) -> Vec<[f64; 2]> {
        self.samples.iter().map(|s| [s.time, of(s)]).collect()
    }

    fn layer(&self, class: &'static str, name: &str, points: Vec<[f64; 2]>) -> Layer {
        if self.trials { Layer::dots(class, name, points) } else { Layer::line(class, name, points) }
    }

    /// How much of the movement the model follows on what was fitted and on what was held out.
    fn percent(&self) -> String {
        let is_held = |s: &&Beside| self.held.iter().any(|h| (h[0]..=h[1]).contains(&s.time));
        let of = |wanted: bool| {
            let own = self.samples.iter().filter(|s| is_held(s) == wanted);
            fit_percent(own.map(|s| [s.measured, s.residual]))
        };
        percent(of(false), of(true))
    }

    /// The measurement on top of the model.
    fn drawn(&self, title: &str, name: &str, part: impl Fn(Vec<[f64; 2]>) -> Vec<[f64; 2]>) -> String {
        let unit = &self.output.unit;
        let measured = part(self.points(|s| unit.from_si(s.measured)));
        let fitted = part(self.points(|s| unit.from_si(s.predicted)));
        self.picture(title, &with_unit(&self.output.name, unit.text()))
            .with(self.layer("after", name, fitted))
            .with(self.layer("measured", "measured", measured))
            .draw()
    }
}

/// The whole, and where measurement and model part most.
fn course(c: &Course<'_>) -> String {
    let whole = c.drawn(&c.title, &format!("fitted model{}", c.percent()), |points| points);
    match closer::span(&c.points(|s| s.residual)).filter(|_| !c.trials) {
        None => whole,
        Some(span) => {
            let title = format!("{}: a closer look, where they part most", c.title);
            whole + &c.drawn(&title, "fitted model", |points| closer::within(&points, span))
        }
    }
}

fn residual(c: &Course<'_>) -> String {
    let unit = c.output.unit.of_differences();
    c.picture(&format!("{}: measured less model", c.title), &with_unit("residual", unit.text()))
        .with(c.layer("after thin", "residual", c.points(|s| unit.difference_from_si(s.residual))))
        .draw()
}

fn spectrum(s: &ResidualSpectrum) -> String {
    let (title, y) =
        (format!("{}: power of the residual, fitted part", s.output), format!("power density, {}", s.unit));
    Picture::new(&title, "angular frequency, rad/s (frequency, Hz)", &y)
        .logarithmic()
        .beside(1.0 / TAU)
        .with(Layer::line("after", "residual", s.points.clone()))
        .draw()
}

fn parameters(r: &FitReport<'_>) -> String {
    let several = r.recordings.len() > 1;
    let initial = |i: &InitialEstimate| {
        let of = if several { format!(" of {}", r.recordings[i.recording].name) } else { String::new() };
        row(&format!("{}(0){of}", i.state), [i.value, i.low, i.high], &i.unit, None)
    };
    let rows: Vec<Vec<String>> =
        r.fit.parameters.iter().map(parameter).chain(r.fit.initials.iter().map(initial)).collect();
    table(&["parameter", "#value", "#95 % interval"], &rows)
}

fn parameter(p: &ParameterEstimate) -> Vec<String> {
    row(&p.name, [p.value, p.low, p.high], &p.unit, remark(p.status))
}

/// What stands beside a value that the fit was not free to choose.
fn remark(status: Status) -> Option<&'static str> {
    match status {
        Status::Fitted => None,
        Status::AtBound(_) => Some("at its bound"),
        Status::Fixed => Some("fixed"),
        Status::Constant => Some("given by the recording"),
    }
}

fn row(name: &str, values: [f64; 3], unit: &Unit, remark: Option<&str>) -> Vec<String> {
    let [value, low, high] = values.map(|x| unit.from_si(x));
    let (mut shown, mut interval) = page::estimate(value, low, high);
    match remark {
        Some("fixed") => (shown, interval) = (format!("{value}"), "fixed".into()),
        Some(remark) if value.is_nan() => (shown, interval) = ("several".into(), remark.into()),
        Some("at its bound") if interval != "–" => interval += ", at its bound",
        Some(remark) => interval = remark.into(),
        None if interval == "–" => interval = "cannot be told from these data".into(),
        None => {}
    }
    vec![head(name, unit.text()), shown, interval]
}

fn errors(r: &FitReport<'_>) -> String {
    let row = |(k, output): (usize, &Output)| {
        let unit = output.unit.of_differences();
        let shown = |si: f64| figure(unit.difference_from_si(si));
        let held = r.held_out.get(k).map_or(f64::NAN, |h| h.rmse);
        vec![head(&output.name, unit.text()), shown(r.fit.rmse[k]), shown(held)]
    };
    let rows: Vec<Vec<String>> = r.fit.model.outputs.iter().enumerate().map(row).collect();
    table(&["output", "#fitted", "#held out"], &rows)
}

/// A direction that the data do not tell, in words that follow "these data do not tell".
fn unseen_words(d: &Direction) -> String {
    let names: Vec<&str> = d.weights.iter().map(|(name, _)| name.as_str()).collect();
    match names.as_slice() {
        [one] if d.deviation.is_finite() => {
            format!("{one}: what is measured allows none of it, and several times as much")
        }
        [one] => format!("{one}: it leaves no trace in what is measured"),
        several => format!("{} apart: changes in them cancel in what is measured", several.join(" and ")),
    }
}

/// The same for a terminal, with its heading; empty where the data tell all.
pub fn untold(directions: &[Direction], determined: &[Combination]) -> String {
    let mut text: String = directions.iter().map(|d| format!("  {}\n", unseen_words(d))).collect();
    if !text.is_empty() {
        text = format!("\nNot identifiable: these data do not tell\n{text}");
    }
    if !determined.is_empty() {
        text += "\nOf parameters that trade these data determine\n";
    }
    text + &determined.iter().map(|c| format!("  {}\n", c.words())).collect::<String>()
}

/// What the data do not tell, and what they determine instead, a paragraph each; empty where they tell all.
pub fn unseen(directions: &[Direction], determined: &[Combination]) -> String {
    let hidden = directions.iter().map(unseen_words);
    let told = determined.iter().map(|c| format!("These data determine {}", c.words()));
    hidden.chain(told).map(|words| format!("<p>{}.</p>", escaped(&words))).collect()
}

fn warnings(fit: &Fit) -> String {
    fit.warnings.iter().map(|w| format!("<p>{}</p>", escaped(&w.message))).collect()
}
