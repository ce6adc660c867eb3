//! The languages.

use crate::Error;
use crate::error::nearest;
use std::str::FromStr;

/// A language that a model can be written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Language {
    /// Python 3, its standard library alone.
    Python,
    /// C99.
    C,
    /// Rust, one file without dependencies.
    Rust,
    /// Modelica 3.
    Modelica,
    /// LaTeX: equations and a table of the parameters.
    Latex,
}

impl Language {
    /// Every language.
    pub fn all() -> [Self; 5] {
        [Self::Python, Self::C, Self::Rust, Self::Modelica, Self::Latex]
    }

    /// Its name, as on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Python => "python",
            Self::C => "c",
            Self::Rust => "rust",
            Self::Modelica => "modelica",
            Self::Latex => "latex",
        }
    }
}

impl FromStr for Language {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        Self::all().into_iter().find(|l| l.name() == text).ok_or_else(|| {
            let e = Error::usage(format!("no language {text:?} is known to export to"));
            let names = Self::all().map(Self::name);
            match nearest(text, names) {
                Some(near) => e.with_hint(format!("the nearest known one is {near}")),
                None => e.with_hint(format!("known are {}", names.join(", "))),
            }
        })
    }
}
