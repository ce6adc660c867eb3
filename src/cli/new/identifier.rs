//! Names of channels that expressions can use.

use std::collections::BTreeSet;

/// A name that expressions can use, and that none before has.
pub(super) fn identifier(name: &str, taken: &mut BTreeSet<String>) -> String {
    let plain: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    let plain = plain.trim_matches('_');
    let starts_well = plain.starts_with(|c: char| c.is_ascii_alphabetic());
    let base = if starts_well { plain.to_string() } else { format!("channel_{plain}") };
    let reserved =
        ["t", "pi"].contains(&base.as_str()) || crate::expression::Function::named(&base).is_some();
    let base = if reserved { format!("{base}_signal") } else { base };
    let mut free = base.clone();
    let mut number = 2;
    while !taken.insert(free.clone()) {
        free = format!("{base}_{number}");
        number += 1;
    }
    free
}
