//! What a table can mean in two ways: its rows settle it, a note says what was taken, or it is asked.

use gyrospec::Result;
use gyrospec::record::Recording;

fn read(text: &str) -> Result<Recording> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.csv");
    std::fs::write(&file, text).unwrap();
    Recording::read(&file)
}

/// A table of dates with a channel of metres.
fn dated(rows: &[&str]) -> Result<Recording> {
    let rows: String = rows.iter().enumerate().map(|(i, row)| format!("{row};{i}\n")).collect();
    read(&format!("Zeit;x [m]\n{rows}"))
}

fn notes(r: &Recording) -> String {
    r.notes.iter().map(|n| format!("{n}\n")).collect()
}

#[test]
fn days_with_points_say_how_they_were_read() {
    for (rows, last, says) in [
        // one day, whatever its order
        (["03.04.2025 12:00:00", "03.04.2025 12:00:01", "03.04.2025 12:00:02"], 2.0, "day.month.year"),
        // 1 to 3 March, or the first three months: the days are taken, and said
        (["01.03.2025", "02.03.2025", "03.03.2025"], 2.0 * 86400.0, "day.month.year"),
        // the month can only stand first: 4 March to 23 April is 50 days
        (
            ["03.04.2025 12:00:00", "04.22.2025 12:00:00", "04.23.2025 12:00:00"],
            50.0 * 86400.0,
            "month.day.year",
        ),
        (["04.22.2025 12:00:00", "04.22.2025 12:00:01", "04.22.2025 12:00:03"], 3.0, "month.day.year"),
    ] {
        let r = dated(&rows).unwrap();
        assert_eq!(r.channels[0].time[2], last, "{rows:?}");
        assert!(notes(&r).contains(says), "{rows:?}: {}", notes(&r));
    }
    let sure = dated(&["22.04.2025 12:00:00", "22.04.2025 12:00:01"]).unwrap();
    assert!(!notes(&sure).contains("day.month"), "{}", notes(&sure));
}

#[test]
fn days_of_both_orders_are_refused_where_they_change() {
    let error = dated(&["03.04.2025 12:00:00", "22.04.2025 12:00:00", "04.23.2025 12:00:00"]).unwrap_err();
    assert_eq!((error.line(), error.column()), (Some(4), Some(1)), "{error}");
    assert!(
        error.to_string().contains("another order") && error.hint().unwrap().contains("2025-04-03"),
        "{error}"
    );
    // the same with strokes
    let error = dated(&["22/04/2025 12:00:00", "04/23/2025 12:00:00"]).unwrap_err();
    assert_eq!((error.line(), error.column()), (Some(3), Some(1)), "{error}");
    // beyond the lines that are looked at before
    let rows: Vec<String> = (0..2000).map(|i| format!("03.04.2025 12:{:02}:{:02}", i / 60, i % 60)).collect();
    let mut rows: Vec<&str> = rows.iter().map(String::as_str).collect();
    rows.extend(["04.04.2025 12:00:00", "04.13.2025 12:00:00"]);
    let error = dated(&rows).unwrap_err();
    assert_eq!((error.line(), error.column()), (Some(2003), Some(1)), "{error}");
}
