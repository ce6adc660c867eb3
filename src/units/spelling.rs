//! Units in the spelling of people: `°C`, `m/s²`, `m³/h`, `kΩ`, `N·m` in the names of the closed list.

/// The same text in the plain spelling that the parser reads; other texts are left as they are.
pub(super) fn plain(text: &str) -> String {
    let joined = text
        .trim()
        .replace('℃', "degC")
        .replace('℉', "degF")
        .replace(['°', 'º'], "deg")
        .replace(['·', '⋅', '×'], "*");
    let mut out = String::with_capacity(joined.len());
    for word in joined.split_inclusive(|c: char| !c.is_alphabetic()) {
        let name = word.trim_end_matches(|c: char| !c.is_alphabetic());
        out += &known(name);
        raised(&word[name.len()..], &mut out);
    }
    out
}

/// A name in the spelling of the list.
fn known(name: &str) -> String {
    // U+2126 is the sign of the unit, U+03A9 the letter; likewise the micro sign and the letter mu
    let name = name
        .replace(['\u{2126}', '\u{3a9}'], "ohm")
        .replace("Ohm", "ohm")
        .replace(['\u{b5}', '\u{3bc}'], "u");
    match name.as_str() {
        "knots" => "kn".into(),
        "L" | "mL" | "cL" | "dL" => name.replace('L', "l"),
        _ => name,
    }
}

/// What follows a name, with a raised power as `^` and plain digits.
fn raised(rest: &str, out: &mut String) {
    const DIGITS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    for c in rest.chars() {
        let after = out.chars().last();
        let plain = match DIGITS.chars().position(|d| d == c) {
            Some(digit) => char::from_digit(digit as u32, 10),
            None => (c == '⁻').then_some('-'),
        };
        match plain {
            Some(plain) => {
                if !after.is_some_and(|a| a == '^' || a == '-' || a.is_ascii_digit()) {
                    out.push('^');
                }
                out.push(plain);
            }
            None => out.push(c),
        }
    }
}
