//! Writes a model as a file that reads back to the same model.

use super::{Definition, Initial, Input, Model, Parameter};
use crate::text::toml_string;
use crate::units::Unit;
use std::fmt::Write;

impl Model {
    /// The text of the model's file; reading it gives the same model.
    ///
    /// ```
    /// use gyrospec::Model;
    /// let model = Model::builtin("gyrosphere")?;
    /// assert_eq!(Model::parse(&model.to_toml())?, model);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn to_toml(&self) -> String {
        let mut out = format!("name = {}\n{}", toml_string(&self.name), self.begun_line());
        let is_free = self.is_free;
        let unit = |own: &Unit| (!is_free).then(|| own.text().to_owned());
        let measured: Vec<&Input> = self.inputs.iter().filter(|i| !self.is_simulated(&i.name)).collect();
        section(&mut out, "inputs", &measured, |x| {
            let (key, channel) = self.key_of("inputs", &x.name);
            line(&key, vec![], unit(&x.unit), by(channel), x.meaning.as_ref())
        });
        section(&mut out, "parameters", &self.parameters, |p| parameter(p, unit(&p.unit)));
        let own: Vec<&Definition> = self.definitions.iter().filter(|d| !self.is_simulated(&d.name)).collect();
        section(&mut out, "definitions", &own, |x| {
            line(
                &x.name,
                vec![("equals", toml_string(&x.equals.to_string()))],
                unit(&x.unit),
                vec![],
                x.meaning.as_ref(),
            )
        });
        section(&mut out, "states", &self.states, |x| {
            let initial = match x.initial {
                Initial::Number(value) if is_free => number(&Unit::one(), value),
                Initial::Number(value) => number(&x.unit, value),
                Initial::Fit => "\"fit\"".into(),
                Initial::Steady => "\"steady\"".into(),
            };
            let rate = vec![("rate", toml_string(&x.rate.to_string()))];
            line(&x.name, rate, unit(&x.unit), vec![("initial", initial)], x.meaning.as_ref())
        });
        section(&mut out, "outputs", &self.outputs, |x| {
            let (key, channel) = self.key_of("outputs", &x.name);
            line(
                &key,
                vec![("equals", toml_string(&x.equals.to_string()))],
                unit(&x.unit),
                by(channel),
                x.meaning.as_ref(),
            )
        });
        out
    }
}

type Fields = Vec<(&'static str, String)>;

fn section<T>(out: &mut String, name: &str, list: &[T], spell: impl Fn(&T) -> String) {
    if !list.is_empty() {
        let _ = writeln!(out, "\n[{name}]");
        for entry in list {
            out.push_str(&spell(entry));
        }
    }
}

/// The channel that holds a signal under another name.
fn by(channel: Option<String>) -> Fields {
    channel.map(|c| ("channel", toml_string(&c))).into_iter().collect()
}

fn line(name: &str, before: Fields, unit: Option<String>, after: Fields, meaning: Option<&String>) -> String {
    let unit = unit.map(|u| ("unit", toml_string(&u)));
    let meaning = meaning.map(|m| ("meaning", toml_string(m)));
    let all = before.into_iter().chain(unit).chain(after).chain(meaning);
    let fields: Vec<String> = all.map(|(key, value)| format!("{key} = {value}")).collect();
    let key = if name.is_ascii() { name.to_string() } else { toml_string(name) };
    format!("{key} = {{ {} }}\n", fields.join(", "))
}

fn parameter(p: &Parameter, unit: Option<String>) -> String {
    let own = unit.as_ref().map_or_else(Unit::one, |_| p.unit.clone());
    let mut after = Fields::new();
    if p.fit {
        after.push(("fit", "true".into()));
    }
    for (key, bound) in [("min", p.min), ("max", p.max)] {
        after.extend(bound.map(|b| (key, number(&own, b))));
    }
    line(&p.name, vec![("value", number(&own, p.value))], unit, after, p.meaning.as_ref())
}

/// A TOML float that reads back to the same SI value.
fn number(unit: &Unit, si: f64) -> String {
    let value = unit.decimal_from_si(si);
    let plain = value == 0.0 || (1e-4..1e7).contains(&value.abs());
    if plain { format!("{value:?}") } else { format!("{value:e}") }
}
