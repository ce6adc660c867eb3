//! The orders of tables as they are asked for.

use crate::symbolic::minors::HIGHEST_ORDER;
use crate::{Error, Result};
use std::ops::RangeInclusive;

/// The orders that `7` or `1..10` (both ends included) names.
///
/// # Errors
/// Usage, for what is neither, or an order without a table.
///
/// ```
/// assert_eq!(gyrospec::symbolic::read_orders("1..10")?, 1..=10);
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn read_orders(text: &str) -> Result<RangeInclusive<usize>> {
    let wrong = |why: String| {
        Error::usage(format!("--orders {text}: {why}")).with_hint(format!(
            "write one order (7) or a range with both ends (1..10), from 1 to {HIGHEST_ORDER}"
        ))
    };
    let number = |part: &str| {
        let part = part.trim();
        part.parse::<usize>().map_err(|_| wrong(format!("'{part}' is no order")))
    };
    let (first, last) = match text.split_once("..") {
        Some((first, last)) => (number(first)?, number(last.strip_prefix('=').unwrap_or(last))?),
        None => (number(text)?, number(text)?),
    };
    if first > last {
        return Err(wrong("the first order is above the last".into()));
    }
    if let Some(outside) = [first, last].into_iter().find(|n| !(1..=HIGHEST_ORDER).contains(n)) {
        return Err(wrong(format!("there is no table of order {outside}")));
    }
    Ok(first..=last)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_hold_both_ends_and_bad_ones_say_why() {
        assert_eq!(read_orders("1..10").unwrap(), 1..=10);
        assert_eq!(read_orders("7").unwrap(), 7..=7);
        assert_eq!(read_orders("3..=5").unwrap(), 3..=5);
        for (text, says) in [
            ("0..3", "order 0"),
            ("3..99", "order 99"),
            ("5..2", "above the last"),
            ("a..b", "'a' is no order"),
            ("1..", "'' is no order"),
            ("-1..3", "'-1'"),
            ("", "'' is no order"),
        ] {
            let error = read_orders(text).unwrap_err();
            assert_eq!(error.kind(), crate::ErrorKind::Usage);
            assert!(error.message().contains(says), "{text}: {error}");
        }
    }
}
