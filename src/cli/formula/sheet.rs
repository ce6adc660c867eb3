//! What `gyrospec formula` shows.

use crate::symbolic::{Derived, Formula, Simplifier, Values};
use crate::{Error, Result};
use std::fmt::Write;

/// Everything that is shown about one derivation.
pub struct Sheet {
    pub derived: Derived,
    pub shown: Vec<Formula>,
    pub printed: Option<Formula>,
    pub simplifier: Simplifier,
    pub values: Option<Values>,
}

impl Sheet {
    /// Every formula in one form, set apart by empty lines.
    pub fn each(&self, write: impl Fn(&Formula) -> Result<String>) -> Result<String> {
        let texts = self.shown.iter().map(|f| Ok(write(f)?.trim_end().to_owned() + "\n"));
        Ok(texts.collect::<Result<Vec<_>>>()?.join("\n"))
    }

    fn ratio(&self) -> Result<Option<Formula>> {
        let printed = self.printed.as_ref();
        printed.map(|printed| self.derived.formula.ratio_to(printed, &self.simplifier)).transpose()
    }

    fn value_of(&self, formula: &Formula) -> Result<Option<f64>> {
        let Some(values) = &self.values else { return Ok(None) };
        let value = formula.evaluate(values)?;
        if value.is_finite() {
            return Ok(Some(value));
        }
        Err(Error::not_computed(format!("{} is not finite at these values", formula.text())))
    }

    /// For reading: formulas, values, how they were checked, the printed one beside.
    pub fn text(&self) -> Result<String> {
        let mut text = String::new();
        for formula in &self.shown {
            let _ = writeln!(text, "{}", formula.text());
            if let Some(value) = self.value_of(formula)? {
                let _ = writeln!(text, "  = {value}");
            }
        }
        let Derived { order, points, .. } = self.derived;
        let _ = writeln!(
            text,
            "\nderived from I_{order}; agrees with the numeric engine at {points} random points"
        );
        if let (Some(printed), Some(ratio)) = (&self.printed, self.ratio()?) {
            let _ = writeln!(text, "\nprinted:\n{}", printed.text());
            if let Some(value) = self.value_of(printed)? {
                let _ = writeln!(text, "  = {value}");
            }
            let ratio = ratio.text();
            let _ = writeln!(text, "derived/printed {}", ratio.strip_prefix("ratio ").unwrap_or(&ratio));
        }
        Ok(text)
    }

    /// Schema `gyrospec.formula/1`.
    pub fn json(&self) -> Result<String> {
        let mut formulas = Vec::new();
        for formula in &self.shown {
            formulas.push(serde_json::json!({
                "name": formula.name,
                "expression": formula.expression.to_string(),
                "text": formula.text(),
                "latex": formula.latex(),
                "value": self.value_of(formula)?,
            }));
        }
        let ratio = self.ratio()?;
        let json = serde_json::json!({
            "schema": "gyrospec.formula/1",
            "formulas": formulas,
            "order": self.derived.order,
            "points_checked": self.derived.points,
            "printed": self.printed.as_ref().map(|f| f.expression.to_string()),
            "ratio": ratio.as_ref().map(|f| f.expression.to_string()),
            "ratio_value": ratio.and_then(|f| f.expression.constant()),
        });
        Ok(format!("{json:#}\n"))
    }
}
