//! Colour, on a terminal alone.

use std::io::IsTerminal;

/// A text in an ANSI style where it goes to a terminal that is not told to do without (`NO_COLOR`).
pub fn paint(text: &str, style: &str, to: &impl IsTerminal) -> String {
    if to.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty()) {
        format!("\x1b[{style}m{text}\x1b[0m")
    } else {
        text.to_string()
    }
}
