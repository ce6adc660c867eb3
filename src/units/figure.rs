//! Numbers as people write them.

/// A number with four significant digits and no needless zeros; `–` where there is none.
///
/// ```
/// use gyrospec::units::figure;
/// assert_eq!([figure(25.0), figure(0.0123456), figure(1.35e8)], ["25", "0.01235", "1.35e8"]);
/// assert_eq!(figure(f64::NAN), "–");
/// ```
pub fn figure(x: f64) -> String {
    figure_of(x, 4)
}

/// A number with so many significant digits and no needless zeros; `–` where there is none.
///
/// ```
/// use gyrospec::units::figure_of;
/// assert_eq!([figure_of(1.2, 6), figure_of(0.1234567, 6), figure_of(2.5e-7, 6)], ["1.2", "0.123457", "2.5e-7"]);
/// ```
pub fn figure_of(x: f64, digits: usize) -> String {
    if !x.is_finite() {
        return "–".into();
    }
    let size = x.abs();
    if size != 0.0 && !(1e-3..1e6).contains(&size) {
        let text = format!("{x:.*e}", digits.saturating_sub(1));
        let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{power}", without_zeros(mantissa));
    }
    let decimals =
        if size == 0.0 { 0 } else { (digits as i32 - 1 - size.log10().floor() as i32).max(0) as usize };
    without_zeros(&format!("{x:.decimals$}")).to_string()
}

/// A number of things: `1 sample`, `2 samples`.
///
/// ```
/// use gyrospec::units::counted;
/// assert_eq!([counted(1, "sample"), counted(0, "sample")], ["1 sample", "0 samples"]);
/// ```
pub fn counted(number: usize, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 { "" } else { "s" })
}

fn without_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// A number with so many significant digits, without a power of ten where it is of a common size.
///
/// ```
/// use gyrospec::units::significant;
/// assert_eq!([significant(95.108_9, 4), significant(1.35e8, 3)], ["95.11", "1.35e8"]);
/// ```
pub fn significant(x: f64, digits: usize) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    let decade = x.abs().log10().floor() as i32;
    if (-4..7).contains(&decade) {
        let places = (digits as i32 - 1 - decade).max(0) as usize;
        format!("{x:.places$}")
    } else {
        format!("{x:.*e}", digits.saturating_sub(1))
    }
}

/// The significant digits that a value deserves whose 95 % interval is so wide: two of the interval,
/// and six without one.
pub fn digits_within(value: f64, width: f64) -> usize {
    if width.is_finite() && width > 0.0 {
        ((value.abs().max(width) / width).log10().ceil() as i32 + 2).clamp(2, 12) as usize
    } else {
        6
    }
}

/// A sentence whose numbers have lost the zeros that a fixed count of decimals left behind.
///
/// ```
/// use gyrospec::units::without_needless_zeros;
/// assert_eq!(without_needless_zeros("from 25.000000 s to 249.250000 s."), "from 25 s to 249.25 s.");
/// assert_eq!(without_needless_zeros("version 1.10.0, 4.00 kg"), "version 1.10.0, 4.00 kg");
/// assert_eq!(without_needless_zeros("radiation, 1.985e-10 W"), "radiation, 1.985e-10 W");
/// ```
pub fn without_needless_zeros(sentence: &str) -> String {
    let shorter = |word: &str| -> Option<String> {
        let number = word.trim_end_matches([',', '.', ';', ')']);
        let (_, decimals) = number.split_once('.')?;
        let is_plain = decimals.len() > 4 && decimals.bytes().all(|b| b.is_ascii_digit());
        number.parse::<f64>().ok().filter(|_| is_plain && decimals.ends_with('0'))?;
        Some(format!("{}{}", without_zeros(number), &word[number.len()..]))
    };
    let words = sentence.split(' ').map(|w| shorter(w).unwrap_or_else(|| w.to_string()));
    words.collect::<Vec<_>>().join(" ")
}
