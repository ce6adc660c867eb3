//! Numbers as programs of many languages write them: decimal commas, signs of thousands, marks of what is missing.

use crate::Error;

/// Marks of a missing value, beside an empty field; capitals do not matter.
const MISSING: [&str; 16] = [
    "nan", "na", "n/a", "n.a.", "n.d.", "k.a.", "k. a.", "null", "none", "#n/a", "#nv", "#na", "-", "--",
    "---", "\u{2013}",
];
/// Words for 1 and 0, as programs and spreadsheets write a logical value; capitals do not matter.
const LOGICAL: [(&str, &str); 6] =
    [("true", "1"), ("wahr", "1"), ("vrai", "1"), ("false", "0"), ("falsch", "0"), ("faux", "0")];
/// Signs between groups of three digits that are neither point nor comma.
const BETWEEN: [char; 5] = ['\'', '\u{2019}', '\u{a0}', '\u{202f}', ' '];

/// The minus sign of typography.
const MINUS: char = '\u{2212}';

/// The form of a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// Nothing, or a mark of what is missing.
    Missing,
    /// Digits alone.
    Whole,
    /// One point, which cannot stand between thousands.
    Point,
    /// One comma, which cannot stand between thousands.
    Comma,
    /// One point with three digits behind it: a decimal point or a sign of thousands.
    EitherPoint,
    /// One comma with three digits behind it.
    EitherComma,
    /// Points between thousands, a decimal comma if any.
    GroupedByPoints,
    /// Commas between thousands, a decimal point if any.
    GroupedByCommas,
    /// No number.
    Text,
}

/// That a number can be read in two ways.
pub(super) fn two_ways(text: &str, at: usize) -> Error {
    Error::bad_input(format!("`{text}` can be read in two ways: is this sign decimal, or between thousands?"))
        .with_column(at + 1)
        .with_hint(
            "say it in a TOML recording, by decimal = \".\" or decimal = \",\" below its `file`; or save the table with one \
             sign for decimals, and none between thousands",
        )
}

/// What to do about decimal signs.
pub(super) const ONE_WAY: &str = "save the table with one sign for decimals, and none between thousands";

/// Whether a field says that its value is missing.
pub(super) fn is_missing(text: &str) -> bool {
    let text = text.trim();
    text.is_empty() || MISSING.iter().any(|m| text.eq_ignore_ascii_case(m))
}

/// 1 or 0, where a field says that something is true or false.
pub(super) fn logical(text: &str) -> Option<&'static str> {
    let text = text.trim();
    LOGICAL.iter().find(|(word, _)| text.eq_ignore_ascii_case(word)).map(|(_, digit)| *digit)
}

/// The form of a field.
pub(super) fn form(text: &str) -> Form {
    let text = text.trim();
    if is_missing(text) {
        return Form::Missing;
    }
    if logical(text).is_some() {
        return Form::Whole;
    }
    let Some((whole, exponent)) = parts(text) else {
        // an infinity is a number that has no place here, which the rows say
        return if text.parse::<f64>().is_ok() { Form::Whole } else { Form::Text };
    };
    let places = |c: char| whole.matches(c).count();
    let three = |c: char| {
        let (before, after) = whole.split_once(c).unwrap_or_default();
        let is_group = (1..=3).contains(&before.len()) && !before.starts_with('0') && after.len() == 3;
        is_group && exponent.is_empty()
    };
    let last = whole.rfind(['.', ',']).map(|at| whole.as_bytes()[at]);
    match (places('.'), places(','), last) {
        (0, 0, _) => Form::Whole,
        (1, 0, _) if three('.') => Form::EitherPoint,
        (0, 1, _) if three(',') => Form::EitherComma,
        (1, 0, _) => Form::Point,
        (0, 1, _) => Form::Comma,
        (_, 0, _) | (_, 1, Some(b',')) if is_grouped(&whole, '.', ',') => Form::GroupedByPoints,
        (0, _, _) | (1, _, Some(b'.')) if is_grouped(&whole, ',', '.') => Form::GroupedByCommas,
        _ => Form::Text,
    }
}

/// The same number with a decimal point and no signs of thousands, where it is one; `comma` says that commas are
/// decimal.
pub(super) fn plain(text: &str, comma: bool) -> Option<String> {
    let text = text.trim();
    if let Some(digit) = logical(text) {
        return Some(digit.to_owned());
    }
    let (whole, exponent) = parts(text)?;
    let (decimal, group) = if comma { (',', '.') } else { ('.', ',') };
    if whole.matches(decimal).count() > 1 || whole.contains(group) && !is_grouped(&whole, group, decimal) {
        return None;
    }
    let sign = if text.starts_with(['-', MINUS]) { "-" } else { "" };
    Some(format!("{sign}{}{exponent}", whole.replace(group, "").replace(decimal, ".")))
}

/// A number with a decimal point and signs between its thousands, where they cannot mean anything else.
pub(super) fn grouped(text: &str) -> Option<f64> {
    let sure = text.contains(BETWEEN) || text.contains(MINUS) || form(text) == Form::GroupedByCommas;
    plain(text, false).filter(|_| sure)?.parse().ok()
}

/// The digits of a number with their points and commas, without its sign and the signs between thousands that are
/// neither, and its power of ten; none where it is no number.
fn parts(text: &str) -> Option<(String, &str)> {
    let unsigned = text.strip_prefix(['-', '+', MINUS]).unwrap_or(text);
    let (mantissa, exponent) = unsigned.split_at(unsigned.find(['e', 'E']).unwrap_or(unsigned.len()));
    let power = exponent.get(1..).map(|p| p.strip_prefix(['-', '+']).unwrap_or(p));
    let digits = |s: &str| !s.is_empty() && s.bytes().all(|b| b.is_ascii_digit());
    if power.is_some_and(|p| !digits(p)) {
        return None;
    }
    let mut whole = mantissa.to_owned();
    for sign in BETWEEN.into_iter().filter(|c| mantissa.contains(*c)) {
        let before = whole.split([',', '.']).next().unwrap_or_default();
        if !is_grouped(before, sign, '.') {
            return None;
        }
        whole = whole.replace(sign, "");
    }
    let figures = whole.bytes().filter(u8::is_ascii_digit).count();
    let is_plain = whole.bytes().all(|b| b.is_ascii_digit() || b == b'.' || b == b',');
    (figures > 0 && is_plain).then_some((whole, exponent))
}

/// Whether a sign stands between groups of three digits, before the decimal sign alone.
fn is_grouped(text: &str, sign: char, decimal: char) -> bool {
    let (before, after) = text.split_once(decimal).unwrap_or((text, ""));
    let digits = |s: &str| s.bytes().all(|b| b.is_ascii_digit());
    let mut groups = before.split(sign);
    let first = groups.next().unwrap_or_default();
    (1..=3).contains(&first.len())
        && digits(first)
        && groups.all(|g| g.len() == 3 && digits(g))
        && digits(after)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn forms_are_told_apart() {
        for (text, wanted) in [
            ("", Form::Missing),
            (" #NV ", Form::Missing),
            ("null", Form::Missing),
            ("-", Form::Missing),
            ("12", Form::Whole),
            ("-1e5", Form::Whole),
            ("0.500", Form::Point),
            ("1.5e-3", Form::Point),
            ("1.234", Form::EitherPoint),
            ("1.234e2", Form::Point),
            ("1234.567", Form::Point),
            ("1,5", Form::Comma),
            ("-,5", Form::Comma),
            ("1,234", Form::EitherComma),
            ("1.234,5", Form::GroupedByPoints),
            ("1.234.567", Form::GroupedByPoints),
            ("1,234.5", Form::GroupedByCommas),
            ("12,345,678", Form::GroupedByCommas),
            ("1'234.5", Form::Point),
            ("1\u{a0}234,5", Form::Comma),
            ("1,2,3", Form::Text),
            ("1.23.4", Form::Text),
            ("1 23", Form::Text),
            ("12:00", Form::Text),
            ("2025-04-03", Form::Text),
            ("calm", Form::Text),
            ("e5", Form::Text),
            (".", Form::Text),
        ] {
            assert_eq!(form(text), wanted, "{text:?}");
        }
    }

    #[test]
    fn numbers_lose_their_dress() {
        for (text, comma, wanted) in [
            ("1,5", true, Some("1.5")),
            ("-1.234.567,25", true, Some("-1234567.25")),
            ("1.5", true, None),
            ("1.234", true, Some("1234")),
            ("1,234.5", false, Some("1234.5")),
            ("1,5", false, None),
            ("+2,5E+3", true, Some("2.5E+3")),
            ("1\u{202f}234,5", true, Some("1234.5")),
            ("12'345", false, Some("12345")),
            ("1,2,3", true, None),
        ] {
            assert_eq!(plain(text, comma).as_deref(), wanted, "{text:?}");
        }
    }

    proptest! {
        /// What a German spreadsheet writes of a number is that number.
        #[test]
        fn a_number_in_its_german_dress_stays_itself(hundredths in -1_000_000_000i64..1_000_000_000) {
            let (whole, rest) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
            let digits = whole.to_string();
            let mut dressed = String::new();
            for (i, d) in digits.chars().enumerate() {
                if i > 0 && (digits.len() - i) % 3 == 0 {
                    dressed.push('.');
                }
                dressed.push(d);
            }
            let sign = if hundredths < 0 { "-" } else { "" };
            let text = plain(&format!("{sign}{dressed},{rest:02}"), true).unwrap();
            prop_assert_eq!(text.parse::<f64>().unwrap(), hundredths as f64 / 100.0);
        }
    }
}
