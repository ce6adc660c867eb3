//! A request for a formula, as a TOML file or from options.
//!
//! ```toml
//! name = "alpha"                        # left side of the result
//! h = "(T*s + 1)*(s^2 + 2*mu*s + b^2)"  # either H and G …
//! g = "4*A*mu*b^2*s^4"
//! first = "h*sin(K)"                    # … or two signals driven by one noise:
//! second = "1/(T*s + 1)"                #   transfer functions from the shaped noise (second = first if absent)
//! shaping = "s^2/(s^2 + 2*mu*s + b^2)"  #   from white noise to the shaped noise (1 if absent)
//! density = "4*A*mu*b^2"                #   of the white noise, two-sided: mean square = (1/2π) ∫ … dω (1 if absent)
//! times = "P/(g*H*U*cos(phi))"          # stands before the integral (1 if absent)
//! relations = ["b^2 = mu^2 + eps^2"]    # solved for a product of powers
//! keep = ["T^2*eps^2 + (1 + mu*T)^2"]   # factors printed as they are written
//! order = "P h A b H U C0 g T"          # symbols are printed in this order
//! printed = "…"                         # optional: a printed formula to set beside the result
//! ```

use super::{Derivation, Formula, Relation, Simplifier, Source};
use crate::expression::Expr;
use crate::{Error, Result};
use serde::Deserialize;

/// What a formula is derived from, in text.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FormulaRequest {
    /// Left side of the result.
    pub name: Option<String>,
    /// H(s).
    pub h: Option<String>,
    /// G(s).
    pub g: Option<String>,
    /// Transfer function to the first signal.
    pub first: Option<String>,
    /// Transfer function to the second signal.
    pub second: Option<String>,
    /// Shaping filter of the noise.
    pub shaping: Option<String>,
    /// Density of the white noise.
    pub density: Option<String>,
    /// What stands before the integral.
    pub times: Option<String>,
    /// Relations between symbols.
    #[serde(default)]
    pub relations: Vec<String>,
    /// Factors to keep together.
    #[serde(default)]
    pub keep: Vec<String>,
    /// Order of the symbols in print.
    #[serde(default)]
    pub order: String,
    /// A printed formula to compare with.
    pub printed: Option<String>,
}

impl FormulaRequest {
    /// Reads the TOML form.
    ///
    /// # Errors
    /// Bad input, with the place in the text.
    pub fn parse(text: &str) -> Result<Self> {
        toml::from_str(text).map_err(|e| Error::bad_input(e.to_string().trim_end().to_owned()))
    }

    /// What is to be derived.
    ///
    /// # Errors
    /// Bad input, where neither H and G nor transfer functions are given, or both.
    pub fn derivation(&self) -> Result<Derivation> {
        let read = |text: &Option<String>| text.as_deref().map_or(Ok(Expr::Number(1.0)), Expr::parse);
        let source = match (&self.h, &self.first) {
            (Some(_), Some(_)) => return Err(self.neither("both H and a transfer function are given")),
            (None, None) => return Err(self.neither("nothing is given to derive a formula from")),
            (Some(h), None) => {
                if let Some(other) = [&self.second, &self.shaping, &self.density].into_iter().flatten().next()
                {
                    return Err(self.neither(&format!("'{other}' does not go with H")));
                }
                Source::Ratio { h: Expr::parse(h)?, g: read(&self.g)? }
            }
            (None, Some(first)) => {
                if self.g.is_some() {
                    return Err(self.neither("G does not go with transfer functions"));
                }
                let second = self.second.as_ref().unwrap_or(first);
                Source::MeanProduct {
                    first: Expr::parse(first)?,
                    second: Expr::parse(second)?,
                    shaping: read(&self.shaping)?,
                    density: read(&self.density)?,
                }
            }
        };
        Ok(Derivation { name: self.left(), source, times: read(&self.times)? })
    }

    #[allow(clippy::unused_self)] // reads as a sentence where it is used
    fn neither(&self, why: &str) -> Error {
        Error::bad_input(why).with_hint(
            "give H (h) with G (g), or a transfer function (first, and second for a product of two)",
        )
    }

    fn left(&self) -> String {
        self.name.clone().unwrap_or_else(|| "I".into())
    }

    /// How it is to be written.
    ///
    /// # Errors
    /// Bad input, where a relation or a factor cannot be read.
    pub fn simplifier(&self) -> Result<Simplifier> {
        Ok(Simplifier {
            relations: self.relations.iter().map(|text| Relation::parse(text)).collect::<Result<_>>()?,
            keep: self.keep.iter().map(|text| Expr::parse(text)).collect::<Result<_>>()?,
            order: self.order.split([' ', ',']).filter(|name| !name.is_empty()).map(String::from).collect(),
        })
    }

    /// The printed formula, if one is given.
    ///
    /// # Errors
    /// Bad input, where it cannot be read.
    pub fn printed(&self) -> Result<Option<Formula>> {
        self.printed.as_ref().map(|text| Formula::parse(&self.left(), text)).transpose()
    }
}
