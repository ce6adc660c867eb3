//! How recordings begin and end: byte-order marks, line ends, gzip members, files cut short, leap seconds.

use flate2::{Compression, write::GzEncoder};
use gyrospec::record::Recording;
use gyrospec::{Error, ErrorKind};
use std::io::Write;
use std::process::Command;

fn read(name: &str, bytes: impl AsRef<[u8]>) -> Result<Recording, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).unwrap();
    Recording::read(path)
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn values(text: impl AsRef<[u8]>) -> Vec<f64> {
    read("a.csv", text).unwrap().channels[0].values.clone()
}

#[test]
fn a_last_number_cut_short_is_refused() {
    let head = "t [s],x [m]\n0,10.5\n1,11.5\n";
    for (last, says) in [
        ("2,1", "fewer decimals"),
        ("2,12", "fewer decimals"),
        ("2,12.", "fewer decimals"),
        ("2,", "missing"),
        ("2", "1 of 2 fields"),
        ("2,\"12.", "quote"),
        ("2,-", "no number"),
    ] {
        for bytes in [format!("{head}{last}").into_bytes(), gzip(format!("{head}{last}").as_bytes())] {
            let e = read("a.csv", bytes).expect_err(last);
            assert_eq!((e.kind(), e.line()), (ErrorKind::BadInput, Some(4)), "{e}");
            assert!(
                e.file().is_some() && e.column().is_some() && e.hint().unwrap().contains("cut short"),
                "{e}"
            );
            assert!(e.to_string().contains(says), "{last}: {e}");
        }
        // the same with its line end is whole, or wrong for another reason
        if let Err(e) = read("a.csv", format!("{head}{last}\n")) {
            assert!(!e.to_string().contains("cut short"), "{e}");
        }
    }
    let powers = "t [s],x [m]\n0,1.25e-03\n1,1.50e-03\n2,1.75e-0";
    assert!(read("a.csv", powers).unwrap_err().to_string().contains("fewer decimals"));
    let quoted = "t [s],x [m]\n0,\"1.25\"\n1,\"1.50\"\n2,1.7";
    assert!(read("a.csv", quoted).unwrap_err().to_string().contains("fewer decimals"));
}

#[test]
fn a_whole_file_without_a_last_line_end_reads() {
    for (rows, last) in [
        ("0,1.5\n1,2.5\n2,3.5", 3.5),
        ("0,1.5\n1,2.25\n2,3", 3.0),
        ("0,1\n1,2\n2,3", 3.0),
        ("0,1\n1,2\n2,3.75", 3.75),
        ("0,1.5\n1,2", 2.0),
        ("0,1.50\n1,\n2,3.50", 3.5),
        ("0,0.10\n1,-1.00\n2,-0.25", -0.25),
        ("0,1e-3\n1,2e-3\n2,3e-3", 3e-3),
    ] {
        let r = read("a.csv", format!("t [s],x [m]\n{rows}")).unwrap();
        assert_eq!(r.channels[0].values.last(), Some(&last), "{rows}");
        assert!(r.notes.iter().any(|n| n.message.contains("no line end")), "{rows}");
    }
    // a gap where there were gaps before
    assert!(values("t [s],x [m]\n0,1.5\n1,\n2,2.5\n3,").last().unwrap().is_nan());
    // integers of any width may be whole: it is said
    let r = read("a.csv", "t [s],x [m]\n0,1012\n1,1013\n2,10").unwrap();
    assert!(r.notes[0].message.contains("`10`, has fewer digits"), "{}", r.notes[0]);
    let r = read("a.csv", "t [s],x [m]\n0,8\n1,11\n2,9").unwrap();
    assert!(!r.notes[0].message.contains("fewer digits"), "{}", r.notes[0]);
}

/// The shape of the lines above is known wherever the blocks of a long file end.
#[test]
fn a_long_file_cut_anywhere_in_its_last_number_is_refused() {
    let mut text = String::from("t [s],x [m]\n");
    let mut rows = 0;
    for blocks in 1..4_usize {
        while text.len() < blocks * (1 << 18) + 3 {
            text += &format!("{rows},{:.6}\n", f64::from(rows).sin());
            rows += 1;
        }
        let whole = text.trim_end();
        assert_eq!(values(whole).len(), rows as usize);
        for cut in 1..=6 {
            assert!(read("a.csv", &whole[..whole.len() - cut]).is_err(), "{blocks} blocks, cut by {cut}");
        }
    }
}

#[test]
fn marks_and_line_ends_read_to_the_same_numbers() {
    let plain = "t [s],\"x\" [m]\n0,1.5\n1,2.5\n2,-3.5\n";
    let wanted = [1.5, 2.5, -3.5];
    for end in ["\n", "\r\n", "\r"] {
        for mark in ["", "\u{feff}"] {
            let text = format!("{mark}{}", plain.replace('\n', end));
            for bytes in [text.clone().into_bytes(), gzip(text.as_bytes())] {
                assert_eq!(values(bytes), wanted, "{text:?}");
            }
            assert_eq!(values(text.trim_end()), wanted, "{text:?}");
            let e = read("a.csv", text.replace("2.5", "two")).unwrap_err();
            assert_eq!((e.line(), e.column()), (Some(3), Some(3)), "{e}");
        }
    }
    let toml = "\u{feff}name = \"r\"\r[[tables]]\rfile = \"none.csv\"\r";
    let e = read("r.toml", toml).unwrap_err();
    assert!(e.to_string().contains("none.csv"), "{e}");
}

#[test]
fn long_files_of_carriage_returns_read() {
    let mut text = String::from("t [s],x [m]\r");
    for i in 0..60_000 {
        text += &format!("{i},{}.25\r", i % 9);
    }
    assert_eq!(values(&text).len(), 60_000);
}

#[test]
fn other_ends_and_codings_name_the_cause() {
    let utf_16 = |mark: bool, text: &str| -> Vec<u8> {
        let mark = if mark { "\u{feff}" } else { "" };
        format!("{mark}{text}").encode_utf16().flat_map(u16::to_le_bytes).collect()
    };
    let text = "t [s],x [m]\n0,1\n1,2\n";
    let utf_32 = |of: fn(u32) -> [u8; 4]| -> Vec<u8> {
        format!("\u{feff}{text}").chars().flat_map(|c| of(u32::from(c))).collect()
    };
    let cases: [(Vec<u8>, &str); 10] = [
        (utf_32(u32::to_le_bytes), "UTF-32"),
        (utf_32(u32::to_be_bytes), "UTF-32"),
        (b"t [s],x [m]\n0,1\r1,2\r2,3\r".to_vec(), "carriage return"),
        (b"t [s],x [m]\n0,1\n1,\"2\r3\"\n".to_vec(), "carriage return"),
        (utf_16(false, text), "UTF-16"),
        (gzip(&gzip(text.as_bytes())), "packed by gzip twice"),
        (b"PK\x03\x04rest\n".to_vec(), "spreadsheet"),
        (gzip(b""), "empty"),
        (Vec::new(), "empty"),
        (b"\xef\xbb\xbf".to_vec(), "empty"),
    ];
    for (bytes, says) in cases {
        let e = read("a.csv", &bytes).expect_err(says);
        assert!(e.to_string().contains(says) && e.hint().is_some() && e.file().is_some(), "{says}: {e}");
    }
    for coded in [utf_32(u32::to_le_bytes), utf_32(u32::to_be_bytes)] {
        let e = read("a.toml", coded).unwrap_err();
        assert!(e.to_string().contains("UTF-32"), "{e}");
    }
}

#[test]
fn gzip_reads_all_members_and_tells_what_follows_them() {
    let (first, second) = ("t [s],x [m]\n0,1.5\n1,2", ".5\n2,3.5\n");
    let both = [gzip(first.as_bytes()), gzip(b""), gzip(second.as_bytes())].concat();
    assert_eq!(values(&both), [1.5, 2.5, 3.5]);
    let padded = [&both[..], &[0; 700]].concat();
    let r = read("a.csv.gz", padded).unwrap();
    assert!(r.notes.is_empty() && r.channels[0].len() == 3);
    for more in [&b"3,4.5\n"[..], b"\x1f", b"\0\0x"] {
        let r = read("a.csv.gz", [&both[..], more].concat()).unwrap();
        assert_eq!(r.channels[0].len(), 3);
        let says = &r.notes[0].message;
        assert!(says.contains(&format!("{} bytes follow", more.len())), "{says}");
    }
    for cut in 2..both.len() {
        match read("a.csv.gz", &both[..cut]) {
            // Behind a whole member: it ends in mid-line, or one byte of what would be the next one follows.
            Ok(r) => assert!(r.notes.iter().any(|n| n.message.contains("no line end")), "{cut}"),
            Err(e) => assert!(e.to_string().contains("cut short") && e.line().is_some(), "{cut}: {e}"),
        }
    }
}

/// The boundary of two members may lie anywhere in what is read at once.
#[test]
fn many_gzip_members_read_wherever_they_end() {
    let noise = |i: u32| format!("{}", f64::from(i.wrapping_mul(2_654_435_761)) / 7.0);
    let mut bytes = gzip(b"t [s],x [m]\n");
    let mut rows = 0;
    while bytes.len() < 3 * (1 << 18) {
        let part: String = (rows..rows + 7).map(|i| format!("{i},{}\n", noise(i))).collect();
        bytes.extend(gzip(part.as_bytes()));
        rows += 7;
    }
    assert_eq!(values(&bytes).len(), rows as usize);
}

#[test]
fn a_leap_second_is_a_second() {
    let stamps =
        ["2016-12-31T23:59:59Z", "2016-12-31T23:59:60Z", "2017-01-01T00:00:00Z", "2017-01-01T00:00:01Z"];
    let log: String = stamps.iter().map(|s| format!("{s} $HEHDT,092.34,T*13\n")).collect();
    let r = read("a.nmea", log).unwrap();
    assert_eq!(*r.channels[0].time, [0.0, 1.0, 2.0, 3.0]);
    assert!(r.notes.is_empty());
    let r =
        read("a.nmea", "2018-06-30T23:59:60Z $HEHDT,092.34,T*13\n2018-07-01T00:00:00Z $HEHDT,092.34,T*13\n")
            .unwrap();
    assert_eq!(r.channels[0].len(), 1);
    assert!(r.notes[0].message.contains("1 of 2 lines have no time stamp"), "{}", r.notes[0]);
    assert!(r.notes[0].message.contains("there was no leap second then"), "{}", r.notes[0]);
    let lost = "2017-02-29T00:00:00Z $HEHDT,092.34,T*13\n2017-03-01T00:00:00Z $HEHDT,092.34,T*13\n";
    let r = read("a.nmea", lost).unwrap();
    assert!(r.notes[0].message.contains("month 2 of 2017 has 28 days"), "{}", r.notes[0]);
    let zero =
        "[[tables]]\nfile = \"a.nmea\"\nformat = \"nmea0183\"\ntime = { start = \"2017-02-29T00:00:00Z\" }\n";
    let e = read("a.toml", zero).unwrap_err();
    assert!(e.to_string().contains("month 2 of 2017 has 28 days"), "{e}");
}

#[test]
fn a_tolerance_is_a_share() {
    for text in ["inf", "nan", "-1", "0", "1", "1e9"] {
        let call = ["simulate", "m.toml", "r.csv", &format!("--tolerance={text}")];
        let out = Command::new(env!("CARGO_BIN_EXE_gyrospec")).args(call).output().unwrap();
        let says = String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(2), "{says}");
        assert!(says.contains("--tolerance"), "{says}");
    }
}
