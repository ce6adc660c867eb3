//! Long sums broken into lines.

/// One signed item of a sum: its text without the sign and how much room it takes.
pub struct Item {
    /// Whether it is subtracted.
    pub negative: bool,
    pub text: String,
    /// Its width, in the unit of the line's width.
    pub width: f64,
}

impl Item {
    /// An item of plain text, as wide as it has characters.
    pub fn plain(negative: bool, text: String) -> Self {
        let width = text.chars().count() as f64;
        Self { negative, text, width }
    }
}

/// The room of a sign and the blanks around it, and the room of a line.
pub struct Measure {
    /// Width of a sign.
    pub sign: f64,
    /// Width of a line.
    pub line: f64,
}

/// The sum in lines no wider than the measure, broken before signs.
pub fn lines(items: &[Item], measure: &Measure) -> Vec<String> {
    let mut lines = Vec::new();
    let (mut line, mut used) = (String::new(), 0.0);
    for (place, item) in items.iter().enumerate() {
        let width = item.width + measure.sign;
        if used > 0.0 && used + width > measure.line {
            lines.push(std::mem::take(&mut line));
            used = 0.0;
        }
        let sign = match (item.negative, place, line.is_empty()) {
            (true, 0, _) => "-",
            (false, 0, _) => "",
            (true, _, true) => "- ",
            (false, _, true) => "+ ",
            (true, ..) => " - ",
            (false, ..) => " + ",
        };
        line.push_str(sign);
        line.push_str(&item.text);
        used += width;
    }
    lines.push(line);
    lines
}
