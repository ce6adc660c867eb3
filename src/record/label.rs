//! What a column's label says: a name, and a unit in one of the ways in which people write it there.

use crate::units::Unit;

/// A column's label.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Label {
    /// The name, without its unit.
    pub name: String,
    /// The unit, in a spelling that the list of units reads if it is there; as it stands if in square brackets.
    pub unit: Option<String>,
    /// Whether the unit is only the last word of the name.
    pub is_guessed: bool,
}

/// Reads `roll [deg]`, `roll (deg)`, `roll / deg`, `roll_deg` and `roll deg`.
pub(crate) fn label(text: &str) -> Label {
    let text = text.trim();
    let of = |name: &str, unit: Option<String>, is_guessed: bool| Label {
        name: if is_guessed { bare(name) } else { name.trim_end() }.to_owned(),
        unit,
        is_guessed,
    };
    if let Some((name, unit)) = text.strip_suffix(']').and_then(|t| t.rsplit_once('[')) {
        let unit = unit.trim();
        return of(name, Some(self::unit(unit).unwrap_or_else(|| unit.to_owned())), false);
    }
    let last = text.strip_suffix(')').and_then(|t| t.rsplit_once('('));
    // `x(1)` is the first of several
    if let Some((name, unit)) =
        last.and_then(|(name, unit)| Some((name, self::unit(unit).filter(|u| u != "1")?)))
        && !name.trim_end().ends_with('/')
    {
        return of(name, Some(unit), false);
    }
    // a temperature whose unit is told to be unknown, under its whole name, since the same in degC may stand beside it
    if last.is_some_and(|(_, unit)| is_fahrenheit(unit)) {
        return of(text, Some("degF".to_owned()), false);
    }
    // `Q in m³/h`, `v / m/s` and `v_m/s`: the unit is the last word, stroke and all
    let stroked = text.rsplit_once([' ', '_']).filter(|(_, w)| w.contains('/') && !w.starts_with('/'));
    if let Some((name, unit)) = stroked.and_then(|(name, word)| Some((name, self::unit(word)?))) {
        let (name, is_guessed) = name.trim_end().strip_suffix('/').map_or((name, true), |n| (n, false));
        return of(name, Some(unit), is_guessed);
    }
    let is_unit = self::unit(text).is_some();
    for (at, _) in text.match_indices('/').filter(|_| !is_unit) {
        let (name, unit) = (&text[..at], text[at + 1..].trim());
        let unit = unit.strip_prefix('(').and_then(|u| u.strip_suffix(')')).unwrap_or(unit);
        if let Some(unit) = self::unit(unit).filter(|u| u != "1" && !name.trim().is_empty()) {
            return of(name, Some(unit), false);
        }
    }
    if let Some((name, unit)) = quotient(text) {
        let is_guessed = unit.is_some();
        return of(name, unit, is_guessed);
    }
    match text.rsplit_once(['_', ' ']) {
        Some((name, word)) if !name.trim().is_empty() => match last_word(name, word) {
            Some(unit) => of(name, Some(unit), true),
            None => of(text, None, false),
        },
        _ if text.eq_ignore_ascii_case("rpm") => of(text, Some("rpm".into()), true),
        _ => of(text, None, false),
    }
}

/// Whether a text says degrees Fahrenheit, which the list of units does not have.
fn is_fahrenheit(text: &str) -> bool {
    let word: String = text.to_lowercase().chars().filter(|c| !c.is_whitespace()).collect();
    ["°f", "ºf", "℉", "degf", "fahrenheit"].contains(&word.as_str())
}

/// The unit of a name that ends with two of them, `v_m_s`, `rate_deg_s`, `rate_deg_per_s`: a length or an angle over a
/// time; of other pairs none can be told.
fn quotient(text: &str) -> Option<(&str, Option<String>)> {
    let (rest, last) = text.rsplit_once('_')?;
    let (name, top) = rest.strip_suffix("_per").unwrap_or(rest).rsplit_once('_')?;
    last_word(name, last)?;
    let is_speed =
        ["m", "mm", "cm", "km", "ft", "rad", "deg"].contains(&top) && ["s", "min", "h"].contains(&last);
    if is_speed {
        return Some((name, Some(format!("{top}/{last}"))));
    }
    last_word(name, top).map(|_| (text, None))
}

/// A name without the word or sign between it and its unit: `roll in deg`, `roll, deg`.
fn bare(name: &str) -> &str {
    let name = name.trim_end();
    name.strip_suffix(" in").unwrap_or(name).trim_end_matches([',', ':']).trim_end()
}

/// A unit of the list, from its own spelling or a word for it.
pub(super) fn unit(text: &str) -> Option<String> {
    let text = text.trim();
    if Unit::parse(text).is_ok() {
        return Some(text.to_owned());
    }
    // `m/s2`, `m3/h`
    let mut raised = String::new();
    for c in text.chars() {
        if c.is_ascii_digit() && raised.ends_with(|c: char| c.is_alphabetic()) {
            raised.push('^');
        }
        raised.push(c);
    }
    if Unit::parse(&raised).is_ok() {
        return Some(raised);
    }
    let word = match text.to_lowercase().as_str() {
        "-" | "\u{2013}" | "none" => "1",
        "sec" | "secs" | "second" | "seconds" | "sek" | "sekunden" => "s",
        "msec" | "millisec" | "milliseconds" => "ms",
        "usec" | "microseconds" => "us",
        "minute" | "minutes" => "min",
        "hr" | "hrs" | "hour" | "hours" => "h",
        "degree" | "degrees" => "deg",
        "deg/sec" | "degrees/s" | "dps" => "deg/s",
        "radian" | "radians" => "rad",
        "metre" | "metres" | "meter" | "meters" => "m",
        "newton" | "newtons" => "N",
        "volt" | "volts" | "vdc" => "V",
        "amp" | "amps" | "ampere" => "A",
        "watt" | "watts" => "W",
        "kt" | "kts" | "knot" => "kn",
        "celsius" | "deg c" | "degrees c" => "degC",
        "percent" | "pct" => "%",
        "rpm" | "u/min" => "rpm",
        _ => return None,
    };
    Some(word.to_owned())
}

/// The unit that the last word of a name means, where it is rather one than a part of the name.
fn last_word(name: &str, word: &str) -> Option<String> {
    let of_temperature = name.to_lowercase().starts_with('t');
    let known = match word {
        "C" | "c" if of_temperature => "degC".to_owned(),
        "degs" => "deg/s".to_owned(),
        "rads" => "rad/s".to_owned(),
        "ms2" | "mss" => "m/s^2".to_owned(),
        "mps" => "m/s".to_owned(),
        // the least of a signal, not its minutes
        "min" if !name.to_lowercase().starts_with('t') => return None,
        // the second power of a name, rather than of a unit
        _ if word.ends_with(|c: char| c.is_ascii_digit()) => return None,
        _ => self::unit(word)?,
    };
    // a letter alone is rather an index than a unit, unless it is one of these
    let doubtful =
        word.len() == 1 && !["s", "m", "N", "V", "A", "K", "W", "J", "C", "c", "%"].contains(&word);
    (!doubtful && known != "1" && word.chars().any(|c| c.is_alphabetic() || "°%".contains(c)))
        .then_some(known)
}

#[cfg(test)]
mod tests {
    use super::label;

    #[test]
    fn units_are_found_where_people_write_them() {
        for (text, name, unit, is_guessed) in [
            ("roll [deg]", "roll", Some("deg"), false),
            ("roll[°]", "roll", Some("°"), false),
            ("odd [dgr]", "odd", Some("dgr"), false),
            ("ratio [-]", "ratio", Some("1"), false),
            ("Load (kg)", "Load", Some("kg"), false),
            ("Temp (°C)", "Temp", Some("°C"), false),
            ("Temp (°F)", "Temp (°F)", Some("degF"), false),
            ("Roll (port)", "Roll (port)", None, false),
            ("Kraft / N", "Kraft", Some("N"), false),
            ("v/(m/s)", "v", Some("m/s"), false),
            ("v / m/s", "v", Some("m/s"), false),
            ("In/Out", "In/Out", None, false),
            ("x(1)", "x(1)", None, false),
            ("Time (sec)", "Time", Some("s"), false),
            ("heading_deg", "heading", Some("deg"), true),
            ("t_s", "t", Some("s"), true),
            ("T_C", "T", Some("degC"), true),
            ("v_c", "v_c", None, false),
            ("x_min", "x_min", None, false),
            ("x_d", "x_d", None, false),
            ("speed knots", "speed", Some("knots"), true),
            ("odd one", "odd one", None, false),
            ("channel 1", "channel 1", None, false),
            ("rpm", "rpm", Some("rpm"), true),
            ("Q in m³/h", "Q", Some("m³/h"), true),
            ("v / m/s", "v", Some("m/s"), false),
            ("Speed m/s", "Speed", Some("m/s"), true),
            ("a in 1/min", "a", Some("1/min"), true),
            ("m/s", "m/s", None, false),
            ("v_m_s", "v", Some("m/s"), true),
            ("speed_m/s", "speed", Some("m/s"), true),
            ("w_motor_rad/s", "w_motor", Some("rad/s"), true),
            ("q_l/min", "q", Some("l/min"), true),
            ("yaw_rate_deg_per_s", "yaw_rate", Some("deg/s"), true),
            ("x_N_s", "x_N_s", None, false),
            ("acc (m/s2)", "acc", Some("m/s^2"), false),
            ("n [RPM]", "n", Some("rpm"), false),
            ("x_m2", "x_m2", None, false),
            ("Kraft in N", "Kraft", Some("N"), true),
            ("Temp, °C", "Temp", Some("°C"), true),
            ("force", "force", None, false),
            ("", "", None, false),
        ] {
            let got = label(text);
            assert_eq!(
                (got.name.as_str(), got.unit.as_deref(), got.is_guessed),
                (name, unit, is_guessed),
                "{text}"
            );
        }
    }
}
