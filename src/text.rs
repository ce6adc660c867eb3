//! Texts of others as they may be shown: names, units and paths come from files and calls, and what in them would
//! steer a terminal, turn the order of writing, or stand there unseen is shown as an escape.

use std::borrow::Cow;

/// Whether a character steers what shows it, or is not seen there: a control character other than a line end or a
/// tab (an escape sequence begins with one), a line end of Unicode's own, one that turns the order of writing, or
/// one that Unicode lets be left out of what is shown (its `Default_Ignorable_Code_Point`).
///
/// ```
/// use gyrospec::text::steers;
/// assert!(['\u{1b}', '\u{202e}', '\u{200b}', '\u{feff}', '\u{e0041}'].into_iter().all(steers));
/// assert!(!['\n', 'é', '°', '\u{a0}'].into_iter().any(steers));
/// ```
pub fn steers(c: char) -> bool {
    is_ignorable(c) || matches!(c, '\u{2028}' | '\u{2029}') || (c.is_control() && !matches!(c, '\n' | '\t'))
}

/// Unicode's `Default_Ignorable_Code_Point` (DerivedCoreProperties of version 16), with the marks of annotations.
fn is_ignorable(c: char) -> bool {
    matches!(
        u32::from(c),
        0xad | 0x34f
            | 0x61c
            | 0x115f..=0x1160
            | 0x17b4..=0x17b5
            | 0x180b..=0x180f
            | 0x200b..=0x200f
            | 0x202a..=0x202e
            | 0x2060..=0x206f
            | 0x3164
            | 0xfe00..=0xfe0f
            | 0xfeff
            | 0xffa0
            | 0xfff0..=0xfffb
            | 0x1bca0..=0x1bca3
            | 0x1d173..=0x1d17a
            | 0xe0000..=0xe0fff
    )
}

/// Whether a written number is read as 0 and is none: it is smaller than the smallest double.
///
/// ```
/// use gyrospec::text::is_lost;
/// assert!(is_lost("1e-400") && is_lost("-0.002E-330"));
/// assert!(!is_lost("0e-400") && !is_lost("-0.0") && !is_lost("5e-324") && !is_lost("1e"));
/// ```
pub fn is_lost(number: &str) -> bool {
    let digits = number.split(['e', 'E']).next().unwrap_or_default();
    digits.contains(|c| ('1'..='9').contains(&c)) && number.parse() == Ok(0.0)
}

/// A text of one or more lines as it may be shown.
///
/// ```
/// use gyrospec::text::shown;
/// assert_eq!(shown("a\n\u{1b}[31mb"), "a\n\\u{1b}[31mb");
/// assert_eq!(shown("1 m·s⁻¹"), "1 m·s⁻¹");
/// ```
pub fn shown(text: &str) -> Cow<'_, str> {
    replaced(text, steers, |c| format!("\\u{{{:x}}}", u32::from(c)))
}

/// A name or a path as it may be shown inside a line: line ends and tabs are shown as escapes too.
///
/// ```
/// assert_eq!(gyrospec::text::in_line("a\nb"), "a\\u{a}b");
/// ```
pub fn in_line(text: &str) -> Cow<'_, str> {
    replaced(text, |c| steers(c) || matches!(c, '\n' | '\t'), |c| format!("\\u{{{:x}}}", u32::from(c)))
}

/// A text in JSON, or in TOML whose strings are made by [`toml_string`], as it may be shown: it reads back the same.
///
/// ```
/// use gyrospec::text::in_quotes;
/// let text = in_quotes("{\"name\": \"\u{9b}31m\u{202e}\"}");
/// assert_eq!(text, r#"{"name": "\u009b31m\u202e"}"#);
/// ```
pub fn in_quotes(text: &str) -> Cow<'_, str> {
    let halves = |c: char| c.encode_utf16(&mut [0; 2]).iter().map(|half| format!("\\u{half:04x}")).collect();
    replaced(text, steers, halves)
}

/// A text as a string of TOML in one line, as it may be shown: what in it would steer a terminal, and line ends, are
/// escapes.
///
/// ```
/// use gyrospec::text::toml_string;
/// assert_eq!(toml_string("a b"), "\"a b\"");
/// assert_eq!(toml_string("a\nb\u{e0041}"), r#""a\nb\U000e0041""#);
/// ```
#[cfg(feature = "diagnose")]
pub fn toml_string(text: &str) -> String {
    if !text.contains(|c| steers(c) || c == '\n') {
        return toml::Value::String(text.to_owned()).to_string();
    }
    // of what JSON writes in a string, TOML reads everything but halves of characters
    let json = serde_json::Value::from(text).to_string();
    replaced(&json, steers, |c| format!("\\U{:08x}", u32::from(c))).into_owned()
}

/// A title of several lines as one line.
///
/// ```
/// assert_eq!(gyrospec::text::one_line("of the\n  gyrosphere"), "of the gyrosphere");
/// ```
pub fn one_line(title: &str) -> String {
    if title.contains(['\n', '\r', '\t']) {
        return title.split_whitespace().collect::<Vec<_>>().join(" ");
    }
    title.to_owned()
}

fn replaced(text: &str, which: impl Fn(char) -> bool, by: impl Fn(char) -> String) -> Cow<'_, str> {
    if !text.contains(&which) {
        return Cow::Borrowed(text);
    }
    let each = text.chars().map(|c| if which(c) { by(c) } else { c.to_string() });
    Cow::Owned(each.collect())
}
