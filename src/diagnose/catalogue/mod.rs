//! The catalogue of mechanisms that a model may have left out: one file a mechanism.
//!
//! A new mechanism is one new file and one line in `mechanisms!` below. Its file begins with a
//! doc comment of fixed sections, which `gyrospec explain CODE` prints as it stands, and gives a
//! function that proposes extended models: the mechanism placed at each site that admits it.

pub(crate) mod arguments;
pub(crate) mod between;
mod draft;
pub(crate) mod edit;
mod felt;
mod field;
mod scene;
pub(crate) mod terms;

pub use draft::{ANY, Added, Draft, Limits, POSITIVE, Proposal, Site, SiteKind, is_mark};
pub use scene::{Alone, MasslessLag, Motion, Scene, Shift, Signal, SignalKind};

use crate::error::nearest;
use crate::{Error, Result};

/// The family that a mechanism belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    /// Friction and damping.
    Friction,
    /// Stiffness and force.
    Force,
    /// Missing dynamics.
    Dynamics,
    /// Rectified motion.
    Rectified,
    /// Flow of a liquid or a gas.
    Flow,
    /// A signal that the model ignores.
    Ignored,
    /// What acts between the recorded input and the system.
    Input,
    /// The sensor, not the system.
    Output,
    /// Faulty data.
    Fault,
    /// What has no name.
    Unnamed,
}

impl Group {
    /// The family's name in a list.
    pub fn title(self) -> &'static str {
        match self {
            Self::Friction => "Friction and damping",
            Self::Force => "Stiffness and force",
            Self::Dynamics => "Missing dynamics",
            Self::Rectified => "Rectified motion",
            Self::Flow => "Flow",
            Self::Ignored => "Ignored signal",
            Self::Input => "Input",
            Self::Output => "Output: the sensor, not the system",
            Self::Fault => "Faulty data",
            Self::Unnamed => "Without a name",
        }
    }
}

/// A mechanism of the catalogue.
#[derive(Clone, Copy)]
pub struct Mechanism {
    /// The code in reports; stable.
    pub code: &'static str,
    /// A few plain words.
    pub title: &'static str,
    /// The family.
    pub group: Group,
    /// The source text of its file, whose doc comment is its page.
    source: &'static str,
    /// The extended models, one or several a site.
    pub propose: fn(&Scene) -> Vec<Proposal>,
    /// Whether it shifts a signal in time, so that what is missing goes with the signal's rate.
    pub shifts_time: bool,
}

impl Mechanism {
    /// A mechanism from its parts; `source` is its own file.
    const fn new(
        code: &'static str,
        title: &'static str,
        group: Group,
        source: &'static str,
        propose: fn(&Scene) -> Vec<Proposal>,
    ) -> Self {
        Self { code, title, group, source, propose, shifts_time: false }
    }

    /// The same, which shifts a signal in time.
    const fn shifting_time(self) -> Self {
        Self { shifts_time: true, ..self }
    }

    /// The page: the file's own doc comment without the comment marks.
    pub fn page(&self) -> String {
        let mut page = format!("{}: {}\n", self.code, self.title);
        let fence = |line: &&str| !line.trim_start().starts_with("```");
        for line in self.source.lines().map_while(|l| l.strip_prefix("//!")).filter(fence) {
            let line = line.strip_prefix(' ').unwrap_or(line);
            if line.starts_with("# ") && !page.ends_with("\n\n") {
                page.push('\n');
            }
            page.push_str(line);
            page.push('\n');
        }
        page
    }
}

/// Nothing to try inside a model: faults are looked for in the data themselves.
fn no_proposals(_: &Scene) -> Vec<Proposal> {
    Vec::new()
}

macro_rules! mechanisms {
    ($($file:ident),* $(,)?) => {
        $(pub(super) mod $file;)*
        /// Every mechanism, in the order of the list that `gyrospec explain` prints.
        pub const ALL: &[Mechanism] = &[$($file::MECHANISM),*];
    };
}

mechanisms! {
    dry_friction, asymmetric_friction, stribeck_friction, load_friction, linear_damping,
    quadratic_damping, cubic_damping, power_law,
    constant_force, linear_stiffness, cubic_stiffness, quadratic_stiffness, gravity_pendulum,
    end_stop, dead_zone, backlash, hysteresis, periodic_force, drift_force,
    neglected_inertia, extra_lag, extra_resonance, memory, product_coupling,
    rectified_motion,
    square_root_flow, overflow, exchange, radiation, saturable_rate,
    cross_coupling, rate_coupling, parameter_dependence, parameter_change, parameter_drift, parameter_value,
    input_delay, input_lag, input_square, input_saturation, input_dead_zone, input_rate_limit,
    input_offset, misalignment,
    output_offset, output_scale, output_square, output_delay, output_lag, output_drift, output_saturation,
    output_cross_axis, clock_offset, clock_drift, clock_jump,
    frozen_channel, outliers, quantisation, gap, wrapped_angle, wrong_sign, wrong_unit, input_hold, free_law,
}

/// Codes that are offered for one that the catalogue does not have, at most.
const MEANT: usize = 4;

/// The mechanism of a code.
///
/// # Errors
/// `BadInput` that names the nearest code.
///
/// ```
/// use gyrospec::diagnose::catalogue;
/// let page = catalogue::find("dry-friction")?.page();
/// assert!(page.contains("# Signature in a recording"));
/// assert!(catalogue::find("dry-frictoin").is_err_and(|e| e.to_string().contains("dry-friction")));
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn find(code: &str) -> Result<&'static Mechanism> {
    ALL.iter().find(|m| m.code == code).ok_or_else(|| {
        let meant = meant(code).map(|m| format!("did you mean {m}? ")).unwrap_or_default();
        Error::bad_input(format!("the catalogue has no mechanism `{code}`"))
            .with_hint(format!("{meant}`gyrospec explain` lists them all"))
    })
}

/// Codes that may be meant by a word: those that hold it, else those whose title does, else the nearest.
fn meant(word: &str) -> Option<String> {
    let word = word.to_lowercase();
    let holding = |text: fn(&Mechanism) -> &str| -> Vec<&str> {
        let holds = |m: &&Mechanism| word.len() > 2 && text(m).to_lowercase().contains(&word);
        ALL.iter().filter(holds).map(|m| m.code).collect()
    };
    let found = [holding(|m| m.code), holding(|m| m.title)].into_iter().find(|all| !all.is_empty());
    let codes = found.unwrap_or_else(|| nearest(&word, ALL.iter().map(|m| m.code)).into_iter().collect());
    let quoted: Vec<String> = codes.iter().take(MEANT).map(|c| format!("`{c}`")).collect();
    (!quoted.is_empty()).then(|| quoted.join(" or "))
}

/// The list of all codes by family.
pub fn list() -> String {
    let mut text = String::new();
    let mut last = None;
    for m in ALL {
        if last != Some(m.group) {
            text.push_str(&format!("{}{}\n", if last.is_some() { "\n" } else { "" }, m.group.title()));
            last = Some(m.group);
        }
        text.push_str(&format!("  {:<22} {}\n", m.code, m.title));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    const SECTIONS: [&str; 6] = [
        "# What it is",
        "# Signature in a recording",
        "# Equation",
        "# What else looks like this",
        "# Reference",
        "# Example",
    ];

    #[test]
    fn a_word_of_a_code_or_a_title_is_told_what_it_may_mean() {
        let told = |word: &str| find(word).err().unwrap().hint().unwrap().to_owned();
        assert!(
            told("delay").starts_with("did you mean `input-delay` or `output-delay`?"),
            "{}",
            told("delay")
        );
        assert!(told("resonance").contains("`extra-resonance`"), "{}", told("resonance"));
        assert!(told("dry-frictoin").contains("`dry-friction`"), "{}", told("dry-frictoin"));
        assert_eq!(told("qq"), "`gyrospec explain` lists them all");
    }

    #[test]
    fn every_page_has_its_sections_in_order() {
        for m in ALL {
            let page = m.page();
            let places: Vec<Option<usize>> = SECTIONS.iter().map(|s| page.find(s)).collect();
            assert!(places.iter().all(Option::is_some), "{}: {places:?}", m.code);
            assert!(places.windows(2).all(|w| w[0] < w[1]), "{}", m.code);
        }
    }

    #[test]
    fn codes_are_distinct_and_their_files_are_named_after_them() {
        for (i, m) in ALL.iter().enumerate() {
            assert!(ALL[..i].iter().all(|other| other.code != m.code), "{}", m.code);
            assert!(m.source.contains(&format!("\"{}\"", m.code)), "{}", m.code);
        }
        assert_eq!(ALL.len(), 64);
    }
}
