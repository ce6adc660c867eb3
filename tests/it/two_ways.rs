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

/// The values of the last channel, with a decimal sign that a recording file states or none.
fn last(text: &str, decimal: Option<char>) -> Result<Vec<f64>> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.csv"), text).unwrap();
    let line = decimal.map_or_else(String::new, |sign| format!("decimal = \"{sign}\"\n"));
    std::fs::write(folder.path().join("a.toml"), format!("[[tables]]\nfile = \"a.csv\"\n{line}")).unwrap();
    Ok(Recording::read(folder.path().join("a.toml"))?.channels.pop().unwrap().values)
}

#[test]
fn three_digits_behind_a_sign_are_settled_or_asked() {
    // decimal for sure in another column: the same sign is decimal in this one
    assert_eq!(last("t [s];x [m]\n0.0;1.012\n0.1;950\n", None).unwrap(), [1.012, 950.0]);
    assert_eq!(last("t [s];x [m]\n0,0;1,012\n0,1;1,013\n", None).unwrap(), [1.012, 1.013]);
    // 1.050 beside 950, where commas are decimal: no writer of decimals drops zeros in one row only
    for text in [
        "t [s];x [m]\n0,0;950\n0,1;1.050\n0,2;1.051\n",
        "t [s];x [m]\n0.0;950\n0.1;1,050\n0.2;1,051\n",
        "t [s],x [m]\n0.0,950\n0.1,\"1,050\"\n0.2,\"1,051\"\n",
    ] {
        assert_eq!(last(text, None).unwrap(), [950.0, 1050.0, 1051.0], "{text}");
        assert!(notes(&read(text).unwrap()).contains("between thousands"), "{text}");
    }
    // what nothing settles, with how to state it
    for (text, column, as_points, as_commas) in [
        ("t [s];x [m]\n0;1.900\n1;2.480\n", 3, Some([1.9, 2.48]), [1900.0, 2480.0]),
        ("t [s]\tx [m]\n0\t1,900\n1\t2,480\n", 3, Some([1900.0, 2480.0]), [1.9, 2.48]),
        ("t [s];x [m]\n0;950\n1;1.050\n", 3, Some([950.0, 1.05]), [950.0, 1050.0]),
        // commas are decimal, but a part of a table may come from a program of another country
        ("t [s];x [m]\n0,0000;1.012\n0,1000;1.013\n", 8, None, [1012.0, 1013.0]),
    ] {
        let error = last(text, None).unwrap_err();
        assert!(error.to_string().contains("read in two ways"), "{error}");
        assert!(error.column() == Some(column) && error.hint().unwrap().contains("decimal = "), "{error}");
        assert_eq!(last(text, Some(',')).unwrap(), as_commas, "{text}");
        match as_points {
            Some(values) => assert_eq!(last(text, Some('.')).unwrap(), values, "{text}"),
            None => {
                assert!(last(text, Some('.')).unwrap_err().to_string().contains("decimal sign"), "{text}");
            }
        }
    }
    let error = last("t [s],x [m]\n0,1\n1,2\n", Some(';')).unwrap_err();
    assert_eq!((error.line(), error.column()), (Some(3), Some(11)), "{error}");
}

#[test]
fn a_separator_that_only_the_rows_end_with_is_passed_over_and_said() {
    for text in
        ["t [s],x [m]\n0,1.5,\n1,2.5,\n", "t [s];x [m]\n0;1,5;\n1;2,5;\n", "t [s],x [m]\n0,1.5,\n1,2.5\n"]
    {
        let r = read(text).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!(
            (&*r.channels[0].time, &r.channels[0].values[..]),
            (&[0.0, 1.0][..], &[1.5, 2.5][..]),
            "{text}"
        );
        assert!(notes(&r).contains("behind the last separator"), "{text}: {}", notes(&r));
    }
}

/// A name too few: no column is moved to the left or right.
#[test]
fn rows_longer_than_the_header_are_refused_unless_they_have_names() {
    for (text, line) in [
        ("t [s],x [m]\n0,1.5,7\n1,2.5,8\n2,3.5,9\n", 2),
        ("t [s],x [m]\n0,1.5,\n1,2.5,8\n2,3.5,9\n", 2),
        ("t [s],x [m]\n1,1.5,7\n2,2.5,8\n3,3.5,9\n", 2),
        ("t_s x_m\n1 0 1.5\n2 1 2.5\n", 1),
    ] {
        let error = read(text).map(|_| ()).expect_err(text);
        assert_eq!(error.line(), Some(line), "{text}: {error}");
    }
    let r = read("t_s x_m\nfirst 0 1.5\nsecond 1 2.5\n").unwrap();
    assert_eq!((&*r.channels[0].time, &r.channels[0].values[..]), (&[0.0, 1.0][..], &[1.5, 2.5][..]));
}

#[test]
fn names_and_units_in_two_comments_are_read() {
    for text in [
        "# t x\n# s mm\n0 1500\n1 2500\n",
        "# made by hand\n# t,x\n# [s],[mm]\n0,1500\n1,2500\n",
        "% t;x\n% s;mm\n0;1500\n1;2500\n",
        "# t [s]\tx [mm]\n0\t1500\n1\t2500\n",
    ] {
        let r = read(text).unwrap_or_else(|e| panic!("{text}: {e}"));
        let x = r.channel("x").unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!((&*x.time, &x.values[..]), (&[0.0, 1.0][..], &[1.5, 2.5][..]), "{text}");
    }
    // one line of units has no names above it; another word is no unit
    for text in ["# s mm\n0 1500\n1 2500\n", "# t x\n# s about\n0 1500\n1 2500\n"] {
        assert!(read(text).map(|_| ()).unwrap_err().to_string().contains("has no unit"), "{text}");
    }
}

#[test]
fn days_of_a_spreadsheet_are_no_seconds() {
    for header in ["Datum [s]", "Date", "Datum", "date_s", "Time"] {
        let error =
            read(&format!("{header};x [m]\n45600,5;1\n45600,50001;2\n")).map(|_| ()).expect_err(header);
        assert_eq!((error.line(), error.column()), (Some(1), Some(1)), "{error}");
        assert!(error.to_string().contains("days of a spreadsheet"), "{error}");
        assert!(error.hint().unwrap().contains("[d]"), "{error}");
    }
    let r = read("Datum [d];x [m]\n45600,5;1\n45600,75;2\n").unwrap();
    assert_eq!(r.channels[0].time[1] - r.channels[0].time[0], 21_600.0);
    // a time in seconds may have this size
    assert_eq!(read("Time [s];x [m]\n45600,5;1\n45600,75;2\n").unwrap().channels[0].time[0], 45600.5);
}

#[test]
fn cells_of_several_numbers_are_refused_with_what_to_do() {
    for cells in ["1 2 3", "[1.5; 2]"] {
        let error = read(&format!("t [s],y [1]\n0,{cells}\n1,{cells}\n")).map(|_| ()).expect_err(cells);
        assert_eq!((error.line(), error.column()), (Some(1), Some(7)), "{error}");
        assert!(error.hint().unwrap().contains("a column of its own"), "{error}");
    }
}
