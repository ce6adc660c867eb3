//! The numbers of a file that need not be a whole model: its `[parameters]`, with or without units.

use super::form::{Form, toml};
use super::places::Text;
use crate::error::nearest;
use crate::{Error, Result};

/// One entry of `[parameters]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Number {
    /// Its name under `[parameters]`.
    pub name: String,
    /// The number as written; `None` where only other keys are given.
    pub value: Option<f64>,
    /// Its unit as written.
    pub unit: Option<String>,
    /// Whether it is written as `{ value = …, unit = … }`, not as a bare number.
    pub full: bool,
    line: usize,
    column: usize,
}

impl Number {
    /// The error with the place of the entry in its file.
    #[must_use]
    pub fn place(&self, e: Error) -> Error {
        e.with_line(self.line).with_column(self.column)
    }

    /// The number, which must be there.
    ///
    /// # Errors
    /// `BadInput` with its place.
    pub fn value(&self) -> Result<f64> {
        self.value.ok_or_else(|| {
            let e = Error::bad_input(format!("parameters.{} has no value", self.name));
            self.place(e.with_hint("add value = …"))
        })
    }
}

/// A file with numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Numbers {
    /// The built-in model that it extends.
    pub extends: Option<String>,
    /// The names of the states that it has of its own.
    pub states: Vec<String>,
    /// Whether it has states or definitions of its own.
    pub own: bool,
    /// Whether it has outputs of its own.
    pub outputs: bool,
    /// `[parameters]`, in the order of the file.
    pub list: Vec<Number>,
}

/// What a model's parameter may say.
const KEYS: [&str; 6] = ["value", "unit", "fit", "min", "max", "meaning"];

impl Numbers {
    /// Reads the numbers of a model file, or of a file that holds nothing else.
    ///
    /// ```
    /// use gyrospec::model::Numbers;
    /// let file = Numbers::of_model("[parameters]\nT = 0.6\nh = { value = 20, unit = \"cm\" }").unwrap();
    /// assert_eq!((file.list[0].value, file.list[1].unit.as_deref()), (Some(0.6), Some("cm")));
    /// ```
    ///
    /// # Errors
    /// `BadInput` with the place of what is wrong.
    pub fn of_model(text: &str) -> Result<Self> {
        let known = ["name", "extends", "inputs", "parameters", "definitions", "states", "outputs"];
        Self::read(text, &known, &KEYS)
    }

    /// Reads the numbers of a file that holds nothing else.
    ///
    /// # Errors
    /// `BadInput` with the place of what is wrong.
    pub fn alone(text: &str) -> Result<Self> {
        Self::read(text, &["name", "parameters"], &["value", "unit", "meaning"])
    }

    fn read(text: &str, sections: &[&str], keys: &[&str]) -> Result<Self> {
        let text = Text(text);
        let table = toml(&text)?;
        let root = Form::root(&table, &text);
        known(&root, sections)?;
        root.string("name")?;
        let names = |section: &str| -> Result<Vec<String>> {
            let form = root.table(section)?;
            Ok(form.map_or_else(Vec::new, |f| f.fields.iter().map(|x| x.key.to_owned()).collect()))
        };
        let states = names("states")?;
        let own = !(states.is_empty() && names("definitions")?.is_empty());
        let section = root.table("parameters")?;
        let list = section.map_or_else(|| Ok(Vec::new()), |s| entries(&s, keys, &text))?;
        Ok(Self {
            extends: root.string("extends")?.map(str::to_owned),
            states,
            own,
            outputs: !names("outputs")?.is_empty(),
            list,
        })
    }
}

/// Refuses what stands outside the sections that are known; a number there is meant as a parameter.
fn known(root: &Form<'_>, sections: &[&str]) -> Result<()> {
    let Some(stray) = root.fields.iter().find(|f| !sections.contains(&f.key)) else { return Ok(()) };
    let e = Error::bad_input(format!("the file has no section or key `{}`", stray.key));
    let near = nearest(stray.key, sections.iter().copied());
    let hint = near.map_or_else(
        || "its numbers stand under [parameters], such as H = { value = …, unit = \"…\" }".to_owned(),
        |near| format!("the nearest known one is {near}; numbers stand under [parameters]"),
    );
    Err(root.error(stray.key, e.with_hint(hint)))
}

fn entries(section: &Form<'_>, keys: &[&str], text: &Text<'_>) -> Result<Vec<Number>> {
    let entry = |key: &str| -> Result<Number> {
        let full = section.is_table(key);
        let (value, unit) = if full {
            let Some(form) = section.table(key)? else { return Err(section.missing(key, "a number")) };
            form.allow(keys)?;
            (form.number("value")?, form.string("unit")?.map(str::to_owned))
        } else {
            (section.number(key)?, None)
        };
        let (line, column) = section.field(key).map_or((1, 1), |f| text.line_column(f.span.start));
        Ok(Number { name: key.to_owned(), value, unit, full, line, column })
    };
    section.fields.iter().map(|f| entry(f.key)).collect()
}
