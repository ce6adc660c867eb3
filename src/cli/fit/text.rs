//! The result of a fit in words and a table.

use super::Told;
use crate::estimate::fit::{Estimate, Status};
use crate::units::Unit;
use std::fmt::Write;

pub fn render(told: &Told<'_>) -> String {
    let mut text = String::new();
    let fit = told.fit;
    let names: Vec<&str> = told.recordings.iter().map(|r| r.name.as_str()).collect();
    let _ = writeln!(text, "{}, fitted to {}\n", fit.model.name, names.join(", "));
    let _ = writeln!(text, "  {:<16} {:>14}   {:<28} unit", "parameter", "value", "95 % interval");
    for p in &fit.parameters {
        text.push_str(&parameter(p));
    }
    for i in &fit.initials {
        let several = told.recordings.len() > 1;
        let of = if several { format!(" of {}", told.recordings[i.recording].name) } else { String::new() };
        text.push_str(&row(&format!("{}(0){of}", i.state), [i.value, i.low, i.high], &i.unit, None));
    }
    text.push_str("\nRoot mean square of measured less simulated, free run:\n");
    for (at, output) in fit.model.outputs.iter().enumerate() {
        let unit = |x: f64| rounded(output.unit.difference_from_si(x), 4);
        let _ = write!(text, "  {:<16} {} {} fitted", output.name, unit(fit.rmse[at]), output.unit.text());
        match told.held_out.get(at).map(|h| h.rmse) {
            Some(rmse) if rmse.is_finite() => {
                let _ = writeln!(text, ", {} {} held out", unit(rmse), output.unit.text());
            }
            _ => text.push_str(", nothing held out\n"),
        }
    }
    text.push_str(&unseen(told));
    text
}

fn parameter(p: &Estimate) -> String {
    let remark = match p.status {
        Status::Fitted => None,
        Status::AtBound(_) => Some("at its bound"),
        Status::Fixed => Some("fixed"),
        Status::Constant => Some("given by the recording"),
    };
    row(&p.name, [p.value, p.low, p.high], &p.unit, remark)
}

fn row(name: &str, values: [f64; 3], unit: &Unit, remark: Option<&str>) -> String {
    let [value, low, high] = values.map(|x| unit.from_si(x));
    let width = high - low;
    let digits = if width.is_finite() && width > 0.0 {
        ((value.abs().max(width) / width).log10().ceil() as i32 + 2).clamp(2, 12) as usize
    } else {
        6
    };
    let interval = match remark {
        Some(remark) => remark.to_owned(),
        None if width.is_finite() => format!("{} to {}", rounded(low, digits), rounded(high, digits)),
        None => "cannot be told from this data".to_owned(),
    };
    let shown = if remark == Some("fixed") { format!("{value}") } else { rounded(value, digits) };
    format!("  {name:<16} {shown:>14}   {interval:<28} {}\n", unit.text())
}

/// A number with so many significant digits, without a power of ten where it is of a common size.
fn rounded(x: f64, digits: usize) -> String {
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

fn unseen(told: &Told<'_>) -> String {
    if told.fit.unseen.is_empty() {
        return String::new();
    }
    let mut text = String::from("\nNot identifiable: these data do not tell\n");
    for direction in &told.fit.unseen {
        let names: Vec<&str> = direction.weights.iter().map(|(name, _)| name.as_str()).collect();
        let _ = match names.as_slice() {
            [one] => writeln!(text, "  {one}"),
            several => {
                writeln!(
                    text,
                    "  {} apart: changes in them cancel in what is measured",
                    several.join(" and ")
                )
            }
        };
    }
    text
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn numbers_keep_their_significant_digits() {
        assert_eq!(rounded(95.108_9, 4), "95.11");
        assert_eq!(rounded(1.35e8, 3), "1.35e8");
        assert_eq!(rounded(-0.012_34, 2), "-0.012");
    }
}
