//! What may be told in place of a table of errors, and which options each such answer takes.

use clap::Args;

/// What may be told in place of a table of errors.
#[derive(Args)]
#[group(id = "instead", multiple = false)]
#[allow(clippy::struct_excessive_bools)] // each is a switch of the command line
pub struct Instead {
    /// Free motion instead: periods, damping and settling against latitude.
    #[arg(long, conflicts_with_all = refused_by("free"))]
    pub free: bool,
    /// The largest errors on a Scorsby table instead, beside what type approval allows.
    #[arg(long, conflicts_with_all = refused_by("scorsby"))]
    pub scorsby: bool,
    /// Closed form of the mean error, with its value on each --heading.
    #[arg(long, conflicts_with_all = refused_by("formula"))]
    pub formula: bool,
    /// Spectrum of the error on one --heading instead, 45 degrees if absent.
    #[arg(long, conflicts_with_all = refused_by("spectrum"))]
    pub spectrum: bool,
    /// Which gyrocompasses are known by name, with the sources of their numbers, and what to ask for of any other.
    #[arg(long, conflicts_with_all = refused_by("list"))]
    pub list: bool,
    /// A deviation card for print: the mean by heading and by significant wave height (without SIZES 1, 2, 3, 4 and
    /// 6 m), or by the size of the roll (amplitude of --regular, standard deviation of --irregular). A size said in
    /// another option stands among them.
    #[arg(long, value_name = "SIZES", num_args = 0..=1, default_missing_value = "", conflicts_with_all = refused_by("card"))]
    pub card: Option<String>,
}

impl Instead {
    /// Whether one is asked for.
    pub fn is_given(&self) -> bool {
        self.free || self.scorsby || self.formula || self.spectrum || self.list || self.card.is_some()
    }
}

/// The options that not every answer takes, each with the answers that take it; the table takes all but the last.
const TAKEN_BY: [(&str, &[&str]); 18] = [
    ("model_or_parameters", &["free", "scorsby", "formula", "card", "spectrum"]),
    ("latitude", &["free", "scorsby", "formula", "card", "spectrum"]),
    ("recording", &["card"]),
    ("roll", &["card"]),
    ("part", &["scorsby", "formula", "card", "spectrum"]),
    ("lever", &["scorsby", "formula", "card", "spectrum"]),
    ("speed", &["card", "spectrum"]),
    ("motion", &["formula", "card", "spectrum"]),
    ("waves", &["formula", "card", "spectrum"]),
    ("band", &["formula", "card", "spectrum"]),
    ("against", &[]),
    ("headings", &["formula", "card", "spectrum"]),
    ("simulate", &[]),
    ("seed", &[]),
    ("svg", &[]),
    ("html", &["card", "spectrum", "scorsby"]),
    ("json", &["scorsby", "formula", "spectrum", "card"]),
    ("csv", &["card"]),
];

/// The options that an answer does not take.
fn refused_by(answer: &str) -> Vec<&'static str> {
    TAKEN_BY.iter().filter(|(_, answers)| !answers.contains(&answer)).map(|(option, _)| *option).collect()
}
