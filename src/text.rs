//! Texts of others as they may be shown: names, units and paths come from files and calls, and what in them would
//! steer a terminal or turn the order of writing is shown as an escape.

use std::borrow::Cow;

/// Whether a character steers what shows it: a control character other than a line end or a tab (an escape
/// sequence begins with one), a line end of Unicode's own, or one that turns the order of writing.
pub fn steers(c: char) -> bool {
    let turns =
        matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns || (c.is_control() && !matches!(c, '\n' | '\t'))
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

/// A text in JSON, or in TOML whose strings stand in double quotes, as it may be shown: it reads back the same.
///
/// ```
/// use gyrospec::text::in_quotes;
/// let text = in_quotes("{\"name\": \"\u{9b}31m\u{202e}\"}");
/// assert_eq!(text, r#"{"name": "\u009b31m\u202e"}"#);
/// ```
pub fn in_quotes(text: &str) -> Cow<'_, str> {
    replaced(text, steers, |c| format!("\\u{:04x}", u32::from(c)))
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
