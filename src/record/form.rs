//! The TOML form of a recording, as written; `file.rs` gives it its meaning.

use serde::Deserialize;
use std::collections::HashMap;
use toml::Spanned;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RecordingForm {
    pub name: Option<String>,
    #[serde(default)]
    pub kind: KindForm,
    pub tables: Vec<Spanned<TableForm>>,
    pub spans: Option<SpansForm>,
    #[serde(default)]
    pub constants: HashMap<String, Spanned<QuantityForm>>,
}

#[derive(Debug, Default, Clone, Copy, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(super) enum KindForm {
    #[default]
    Time,
    Trials,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TableForm {
    pub file: Spanned<String>,
    pub format: Option<FormatForm>,
    pub time: Option<Spanned<TimeForm>>,
    pub rows: Option<Spanned<[i64; 2]>>,
    /// The decimal sign, `.` or `,`.
    pub decimal: Option<Spanned<String>>,
    #[serde(default)]
    pub channels: HashMap<String, Spanned<ChannelForm>>,
}

#[derive(Debug, Clone, Copy, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(super) enum FormatForm {
    Csv,
    Nmea0183,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TimeForm {
    pub column: Option<String>,
    pub unit: Option<Spanned<String>>,
    pub start: Option<StartForm>,
    pub step: Option<f64>,
}

/// The zero of a log is a date, the first row of a table a number.
#[derive(Debug, Deserialize)]
#[serde(untagged)]
pub(super) enum StartForm {
    Number(f64),
    Text(String),
    Date(toml::value::Datetime),
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ChannelForm {
    pub column: Option<String>,
    pub unit: Option<Spanned<String>>,
    #[serde(default)]
    pub wraps: bool,
    #[serde(default)]
    pub hold: HoldForm,
    pub sentence: Option<String>,
    pub field: Option<usize>,
    pub id: Option<u32>,
    #[allow(dead_code, reason = "words for the reader of the file")]
    pub meaning: Option<String>,
}

#[derive(Debug, Default, Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum HoldForm {
    #[default]
    Linear,
    Previous,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SpansForm {
    #[serde(default)]
    pub fit: Vec<Spanned<[f64; 2]>>,
    #[serde(default)]
    pub holdout: Vec<Spanned<[f64; 2]>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a value with its unit, as in { value = 35.0, unit = \"kg\" }")]
pub(super) struct QuantityForm {
    pub value: f64,
    pub unit: Spanned<String>,
}
