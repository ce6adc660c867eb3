//! What is known of the fields of sentences.

use super::sentence::{Sentence, kind};

/// How a field is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// A decimal number.
    Number,
    /// ddmm.mmmm or dddmm.mmmm, the next field telling N, S, E or W: read in signed degrees.
    Position,
    /// A number, the next field telling E or W: read with W negative.
    Signed,
    /// hhmmss.ss: read in seconds of the day.
    TimeOfDay,
}

impl Form {
    /// The unit into which a converted field is read.
    pub(super) fn unit(self) -> Option<&'static str> {
        match self {
            Self::Number | Self::Signed => None,
            Self::Position => Some("deg"),
            Self::TimeOfDay => Some("s"),
        }
    }

    /// What a field of this form holds, for a sentence that says what is not.
    pub(super) fn wanted(self) -> &'static str {
        match self {
            Self::Number | Self::TimeOfDay => "number",
            Self::Signed => "number with E or W in the next field",
            Self::Position => "latitude or longitude with N, S, E or W in the next field",
        }
    }

    /// The number in a field; NaN where it is empty, `None` where it is none.
    pub(super) fn read(self, sentence: &Sentence, field: usize) -> Option<f64> {
        let text = sentence.field(field);
        if text.is_empty() {
            return Some(f64::NAN);
        }
        let number = text.parse().ok().filter(|v: &f64| v.is_finite())?;
        // sign and largest number of degrees
        let side = || match sentence.field(field + 1) {
            "N" | "n" => Some((1.0, 90.0)),
            "S" | "s" => Some((-1.0, 90.0)),
            "E" | "e" => Some((1.0, 180.0)),
            "W" | "w" => Some((-1.0, 180.0)),
            _ => None,
        };
        match self {
            Self::Number => Some(number),
            Self::Signed => Some(side()?.0 * number),
            Self::Position => {
                let ((sign, most), minutes) = (side()?, minutes(text)?);
                let degrees = (number / 100.0).trunc() + minutes / 60.0;
                (minutes < 60.0 && degrees <= most).then_some(sign * degrees)
            }
            Self::TimeOfDay => {
                let (hours, minutes) = ((number / 1e4).trunc(), (number / 100.0).trunc() % 100.0);
                Some(hours * 3600.0 + minutes * 60.0 + self::minutes(text)?)
            }
        }
    }
}

/// The last two digits before the point and all after it, as a number of their own, so that no
/// digit is lost to the rest.
fn minutes(text: &str) -> Option<f64> {
    let point = text.find('.').unwrap_or(text.len());
    text.get(point.checked_sub(2)?..)?.parse().ok()
}

/// A field by name, unit and form.
#[derive(Debug, Clone, Copy)]
pub(super) struct Known {
    pub field: usize,
    pub name: &'static str,
    pub unit: &'static str,
    pub form: Form,
    pub wraps: bool,
}

const fn number(field: usize, name: &'static str, unit: &'static str) -> Known {
    Known { field, name, unit, form: Form::Number, wraps: false }
}

const fn angle(field: usize, name: &'static str) -> Known {
    Known { field, name, unit: "deg", form: Form::Number, wraps: true }
}

const fn of_form(field: usize, name: &'static str, unit: &'static str, form: Form) -> Known {
    Known { field, name, unit, form, wraps: false }
}

const CLOCK: Known = of_form(1, "time_of_day", "s", Form::TimeOfDay);

/// Sentence, number, fields; then the field that tells whether the instrument holds its own data
/// for valid, and what it says if not.
type Entry = (&'static str, Option<u32>, &'static [Known], Option<(usize, &'static [&'static str])>);

const SENTENCES: [Entry; 11] = [
    ("HDT", None, &[angle(1, "heading")], None),
    ("THS", None, &[angle(1, "heading")], Some((2, &["V"]))),
    ("ROT", None, &[number(1, "rate_of_turn", "deg/min")], Some((2, &["V"]))),
    (
        "VTG",
        None,
        &[angle(1, "course"), angle(3, "course_magnetic"), number(5, "speed", "kn")],
        Some((9, &["N"])),
    ),
    (
        "GGA",
        None,
        &[
            CLOCK,
            of_form(2, "latitude", "deg", Form::Position),
            of_form(4, "longitude", "deg", Form::Position),
            number(6, "quality", "1"),
            number(7, "satellites", "1"),
            number(8, "hdop", "1"),
            number(9, "antenna_height", "m"),
            number(11, "geoid_separation", "m"),
        ],
        Some((6, &["0"])),
    ),
    ("ZDA", None, &[CLOCK, number(2, "day", "1"), number(3, "month", "1"), number(4, "year", "1")], None),
    (
        "RMC",
        None,
        &[
            CLOCK,
            of_form(3, "latitude", "deg", Form::Position),
            of_form(5, "longitude", "deg", Form::Position),
            number(7, "speed", "kn"),
            angle(8, "course"),
            of_form(10, "variation", "deg", Form::Signed),
        ],
        Some((2, &["V"])),
    ),
    (
        "PSXN",
        Some(20),
        &[
            number(2, "horizontal_quality", "1"),
            number(3, "height_quality", "1"),
            number(4, "heading_quality", "1"),
            number(5, "roll_pitch_quality", "1"),
        ],
        None,
    ),
    ("PSXN", Some(22), &[number(2, "gyro_calibration", "deg"), number(3, "gyro_offset", "deg")], None),
    (
        "PSXN",
        Some(23),
        &[number(2, "roll", "deg"), number(3, "pitch", "deg"), angle(4, "heading"), number(5, "heave", "m")],
        None,
    ),
    (
        "PASHR",
        None,
        &[
            CLOCK,
            angle(2, "heading"),
            number(4, "roll", "deg"),
            number(5, "pitch", "deg"),
            number(6, "heave", "m"),
        ],
        None,
    ),
];

fn entry(sentence: &str, id: Option<u32>) -> Option<&'static Entry> {
    SENTENCES.iter().find(|e| (e.0 == sentence || e.0 == kind(sentence)) && e.1 == id)
}

/// Whether sentences of this name differ by a number.
pub(super) fn is_numbered(sentence: &str) -> bool {
    SENTENCES.iter().any(|e| e.0 == sentence && e.1.is_some())
}

/// What is known of a field.
pub(super) fn field(sentence: &str, id: Option<u32>, field: usize) -> Option<&'static Known> {
    entry(sentence, id)?.2.iter().find(|k| k.field == field)
}

/// The known fields of a sentence as it came, with its number if it has one.
pub(super) fn fields(sentence: &Sentence) -> Option<(Option<u32>, &'static [Known])> {
    let own = SENTENCES.iter().find(|e| sentence.is(e.0, e.1))?;
    Some((own.1, own.2))
}

/// The time of day (hhmmss.ss) of a sentence that carries one, as it stands there.
pub(super) fn time_of_day<'a>(sentence: &Sentence<'a>) -> Option<&'a str> {
    let clock = fields(sentence)?.1.iter().find(|k| k.form == Form::TimeOfDay)?;
    Some(sentence.field(clock.field))
}

/// Whether the instrument itself says that the sentence is not valid.
pub(super) fn marked_invalid(sentence: &Sentence) -> bool {
    let own = SENTENCES.iter().find(|e| sentence.is(e.0, e.1));
    own.and_then(|e| e.3).is_some_and(|(field, bad)| bad.contains(&sentence.field(field)))
}

/// The fields of a sentence in words, for a hint.
pub(super) fn listing(sentence: &str, id: Option<u32>) -> String {
    let fields = entry(sentence, id).map_or(&[][..], |e| e.2);
    let words = fields.iter().map(|k| format!("{} {} [{}]", k.field, k.name, k.unit));
    format!("its fields: {}", words.collect::<Vec<_>>().join(", "))
}
