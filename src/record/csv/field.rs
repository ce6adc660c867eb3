//! Fields of a line and the numbers in them.

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

/// The fields of a line, commas inside double quotes included in their field. `None` where a
/// quote is not closed.
pub(super) fn split(line: &[u8]) -> Option<Vec<Field>> {
    let mut fields = vec![Field { at: 0, text: Vec::new() }];
    let mut quoted = false;
    for (at, byte) in line.iter().copied().enumerate() {
        match byte {
            b'"' => quoted = !quoted,
            b',' if !quoted => fields.push(Field { at: at + 1, text: Vec::new() }),
            _ => fields.last_mut()?.text.push(byte),
        }
    }
    (!quoted).then_some(fields)
}

/// The number in a field; NaN for an empty field and for `NaN`; `None` for text and for what is
/// too large for a double.
pub(super) fn number(field: &[u8]) -> Option<f64> {
    let field = field.trim_ascii();
    if field.is_empty() {
        return Some(f64::NAN);
    }
    let value: f64 = std::str::from_utf8(field).ok()?.parse().ok()?;
    (!value.is_infinite()).then_some(value)
}
