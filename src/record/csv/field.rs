//! Fields of a line and the numbers in them.

use super::figures;

/// A field as it stands, without its quotes, and the byte at which it begins.
pub(super) struct Field {
    pub at: usize,
    pub text: Vec<u8>,
}

impl Field {
    /// For messages; bytes that are no UTF-8 become �, long texts are cut.
    pub(super) fn shown(&self) -> String {
        let text = String::from_utf8_lossy(self.text.trim_ascii()).into_owned();
        match text.char_indices().nth(40) {
            Some((at, _)) => format!("{}…", &text[..at]),
            None => text,
        }
    }
}

/// The fields of a line between separators, of which those inside double quotes are none; between blanks, any number
/// of them separates. A quote inside a field that does not begin with one is a sign like others (12" pipe). `None` where
/// a quote is not closed.
pub(super) fn split(line: &[u8], separator: u8) -> Option<Vec<Field>> {
    let mut fields = vec![Field { at: 0, text: Vec::new() }];
    let (mut quoted, mut is_open, mut is_begun) = (false, false, separator != b' ');
    for (at, byte) in line.iter().copied().enumerate() {
        match byte {
            b'"' if quoted || is_open || fields.last()?.text.trim_ascii().is_empty() => {
                (quoted, is_open, is_begun) = (!quoted, true, true);
            }
            _ if byte == separator && !quoted && is_begun => {
                fields.push(Field { at: at + 1, text: Vec::new() });
                (is_open, is_begun) = (false, separator != b' ');
            }
            b' ' if separator == b' ' && !quoted => fields.last_mut()?.at = at + 1,
            _ => {
                is_begun = true;
                fields.last_mut()?.text.push(byte);
            }
        }
    }
    if !is_begun && fields.len() > 1 {
        fields.pop();
    }
    (!quoted).then_some(fields)
}

/// The number in a field; NaN for an empty field and for a mark of what is missing; `None` for text and for what is
/// too large for a double.
#[inline]
pub(super) fn number(field: &[u8]) -> Option<f64> {
    if let Some(value) = short_decimal(field) {
        return Some(value);
    }
    let field = field.trim_ascii();
    if field.is_empty() {
        return Some(f64::NAN);
    }
    let text = std::str::from_utf8(field).ok()?;
    match text.parse::<f64>() {
        Ok(value) => (!value.is_infinite()).then_some(value),
        Err(_) if figures::is_missing(text) => Some(f64::NAN),
        Err(_) => figures::logical(text).and_then(|d| d.parse().ok()).or_else(|| figures::grouped(text)),
    }
}

/// A plain decimal of at most 15 digits. Both the digits and the power of ten are doubles without
/// rounding, so their quotient is the nearest double (W. D. Clinger, How to read floating point
/// numbers accurately, PLDI 1990).
#[inline]
fn short_decimal(field: &[u8]) -> Option<f64> {
    const POWERS: [f64; 16] =
        [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];
    let (negative, digits) = match field {
        [b'-', rest @ ..] => (true, rest),
        _ => (false, field),
    };
    if digits.is_empty() || digits.len() > 16 {
        return None;
    }
    let (mut whole, mut count, mut decimals) = (0u64, 0, None);
    for byte in digits {
        let digit = byte.wrapping_sub(b'0');
        if digit < 10 {
            whole = 10 * whole + u64::from(digit);
            count += 1;
        } else if *byte == b'.' && decimals.is_none() {
            decimals = Some(count);
        } else {
            return None;
        }
    }
    if count == 0 || count > 15 {
        return None;
    }
    let size = whole as f64 / POWERS[decimals.map_or(0, |before| count - before)];
    Some(if negative { -size } else { size })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn any_number_of_blanks_separates() {
        let texts = |line: &str, separator: u8| -> Vec<String> {
            split(line.as_bytes(), separator).unwrap().iter().map(Field::shown).collect()
        };
        assert_eq!(texts("  0.5   1.5 \"a b\"  ", b' '), ["0.5", "1.5", "a b"]);
        assert_eq!(texts("a;\"b;c\";", b';'), ["a", "b;c", ""]);
        assert_eq!(texts("a;12\" pipe;\"c;\"", b';'), ["a", "12\" pipe", "c;"]);
        assert!(split(b"a;\"b", b';').is_none());
        assert_eq!(split(b"  a  bc", b' ').unwrap().iter().map(|f| f.at).collect::<Vec<_>>(), [2, 5]);
        assert_eq!(texts("", b' '), [""]);
    }

    proptest! {
        #[test]
        fn short_decimals_are_read_as_the_standard_library_does(text in "-?[0-9]{0,9}\\.?[0-9]{0,9}") {
            let wanted = text.parse::<f64>().ok().map(f64::to_bits);
            let got = number(text.as_bytes()).filter(|x| !x.is_nan()).map(f64::to_bits);
            prop_assert_eq!(got, wanted);
        }
    }
}
