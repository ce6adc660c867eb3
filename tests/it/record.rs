//! Recordings as they are read: numbers, gaps, times, and what is said about bad input.

use flate2::{Compression, write::GzEncoder};
use gyrospec::record::{Hold, Kind, Recording, Span};
use gyrospec::{Error, ErrorKind};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn write(&self, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.path().join(name);
        fs::write(&path, bytes).unwrap();
        path
    }
}

fn read(name: &str, text: impl AsRef<[u8]>) -> Result<Recording, Error> {
    let folder = Folder::new();
    Recording::read(folder.write(name, text))
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// Reads a table that must be refused, and checks the place and words of the error.
#[track_caller]
fn refused(name: &str, text: impl AsRef<[u8]>, line: usize, words: &[&str]) {
    let e = read(name, text).expect_err("this is no recording");
    let says = e.to_string();
    assert_eq!(e.line(), Some(line), "{says}");
    assert!(e.file().is_some() && e.hint().is_some(), "{says}");
    assert!(matches!(e.kind(), ErrorKind::BadInput | ErrorKind::Units), "{says}");
    for word in words {
        assert!(says.contains(word), "`{word}` is not in: {says}");
    }
}

#[test]
fn a_table_reads_to_its_numbers() {
    let text = "t [ms],roll [deg], temp [degC] \r\n0,1.5, 20\r\n500,,NaN\r\n1000,-1e1,\"25\"\r\n";
    for bytes in [text.as_bytes().to_vec(), gzip(text.as_bytes())] {
        let r = read("a.csv", bytes).unwrap();
        assert_eq!(&*r.channels[0].time, [0.0, 0.5, 1.0]);
        let roll = &r.channel("roll").unwrap().values;
        assert_eq!((roll[0], roll[2]), (1.5_f64.to_radians(), (-10.0_f64).to_radians()));
        assert!(roll[1].is_nan() && r.channel("temp").unwrap().values[1].is_nan());
        assert_eq!(r.channel("temp").unwrap().values[2], 298.15);
        assert_eq!(r.sources[0].sha256.len(), 64);
        assert!(r.notes.is_empty());
    }
}

#[test]
fn bad_tables_are_refused_with_place_and_remedy() {
    let head = "t [s],roll [deg]\n";
    let with = |rows: &str| format!("{head}{rows}");
    refused("a.csv", with("0,1\n1,2\n1,3\n"), 4, &["twice", "column 1 `t`"]);
    refused("a.csv", with("0,1\n2,2\n1,3\n"), 4, &["backwards, from 2 to 1"]);
    refused("a.csv", with("0,1\n,2\n"), 3, &["time is empty"]);
    refused("a.csv", with("0,1\n1,abc\n"), 3, &["a.csv:3:3:", "column 2 `roll`", "`abc`"]);
    refused("a.csv", with("0,1\n1,1e999\n"), 3, &["no finite number"]);
    refused("a.csv", with("0,1\n1\n2,3\n"), 3, &["1 fields", "header 2"]);
    refused("a.csv", with("0,0,1,5\n"), 2, &["decimal comma"]);
    refused("a.csv", with("0,\"1,5\"\n"), 2, &["1.5, not 1,5"]);
    refused("a.csv", with("0,1\n\n1,2\n"), 3, &["empty"]);
    refused("a.csv", with("0,1\n1"), 3, &["mid-line", "cut short"]);
    refused("a.csv", with("0,1\n1,-"), 3, &["cut short"]);
    refused("a.csv", "t [s];x [m]\n0,1\n", 1, &["semicolons"]);
    refused("a.csv", "t [s]\tx [m]\n0,1\n", 1, &["tabs"]);
    refused("a.csv", "t [s],x [m],x [m]\n0,1,2\n", 1, &["both named `x`"]);
    refused("a.csv", "t [s],y [degg]\n0,1\n", 1, &["deg"]);
    refused("a.csv", "t [s],x\n0,1\n", 1, &["column 2 `x` has no unit"]);
    refused("a.csv", "x [m],t [s]\n0,1\n", 1, &["no column of time"]);
    refused("a.csv", "0,1\n1,2\n", 1, &["header"]);
}

#[test]
fn a_file_cut_at_any_byte_is_an_error_or_a_whole_beginning() {
    let mut text = String::from("t [s],x [m]\n");
    for i in 0..80 {
        text += &format!("{i},{:.6}\n", f64::from(i).sin());
    }
    let whole = read("a.csv", &text).unwrap();
    for cut in text.len() - 30..text.len() {
        if let Ok(r) = read("a.csv", &text[..cut]) {
            let n = r.channels[0].len();
            assert_eq!(r.channels[0].values, whole.channels[0].values[..n], "cut at {cut}");
        }
    }
    let packed = gzip(text.as_bytes());
    for cut in [packed.len() / 2, packed.len() - 1] {
        let e = read("a.csv.gz", &packed[..cut]).unwrap_err();
        assert!(e.to_string().contains("cut short") && e.line().is_some(), "{e}");
    }
}

#[test]
fn a_toml_recording_joins_tables() {
    let folder = Folder::new();
    folder.write("a.csv", "n,x_m,heading\n0,10,359\n1,11,2\n2,12,\n3,13,358\n");
    folder.write("b.csv.gz", gzip(b"time_ms,comment,y\n0,\"a, b\",1\n40,c,2\n"));
    let toml = folder.write(
        "r.toml",
        r#"
        name = "two tables"
        [[tables]]
        file = "a.csv"
        time = { start = 5.0, step = 10, unit = "ms" }
        rows = [1, 3]
        [tables.channels]
        z = { column = "x_m", unit = "cm", hold = "previous" }
        a = { column = "heading", unit = "deg", wraps = true }
        [[tables]]
        file = "b.csv.gz"
        time = { column = "time_ms", unit = "ms" }
        channels.y = { column = "y", unit = "1" }
        [spans]
        fit = [[0.0, 0.02]]
        holdout = [[0.02, 0.04]]
        [constants]
        lat = { value = 46.5, unit = "deg" }
        "#,
    );
    let r = Recording::read(&toml).unwrap();
    let names: Vec<&str> = r.channels.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["z", "a", "y"]);
    assert_eq!(r.channels[0].values, [0.11, 0.12, 0.13]);
    assert_eq!(r.channels[0].hold, Hold::Previous);
    assert_eq!(&*r.channels[0].time, [0.005, 0.005 + 0.01, 0.005 + 0.02]);
    assert_eq!(r.channels[0].value_at(0.0149), Some(0.11));
    let a = &r.channels[1];
    assert!(a.wraps && a.values[1].is_nan());
    assert!((a.values[2] - a.values[0] + 4.0_f64.to_radians()).abs() < 1e-12);
    assert_eq!(&*r.channels[2].time, [0.0, 0.04]);
    assert_eq!((r.channels[0].table, r.channels[2].table), (0, 1));
    assert_eq!(r.constant("lat"), Some(46.5_f64.to_radians()));
    assert_eq!(r.sources.len(), 3);
    assert!(r.spans.given && r.spans.fits(0.02) && !r.spans.holds_out(0.02) && r.spans.holds_out(0.03));
}

#[test]
fn bad_toml_recordings_are_refused_with_place_and_remedy() {
    let table = |rest: &str| {
        let folder = Folder::new();
        folder.write("a.csv", "t_s,x_m,n\n0,1,1\n1,2,1\n");
        Recording::read(folder.write("r.toml", format!("[[tables]]\nfile = \"a.csv\"\n{rest}\n")))
            .expect_err("this is no recording")
            .to_string()
    };
    let time = "time = { column = \"t_s\", unit = \"s\" }";
    let channel = |c: &str| table(&format!("{time}\n[tables.channels]\nx = {{ {c} }}"));
    for (says, words) in [
        (channel("column = \"x_mm\", unit = \"m\""), "a.csv:1:1: the file has no column `x_mm`"),
        (channel("column = \"x_mm\", unit = \"m\""), "did you mean `x_m`?"),
        (channel("column = \"x_m\", unit = \"metre\""), "r.toml:5:31:"),
        (channel("colum = \"x_m\", unit = \"m\""), "unknown field `colum`"),
        (channel("column = \"x_m\", unit = \"m\", wraps = true"), "cannot wrap"),
        (channel("column = \"n\""), "has no unit"),
        (table("time = { column = \"t_s\", unit = \"m\" }"), "no unit of time"),
        (table("time = { start = 0.0, step = 0.0, unit = \"s\" }"), "positive"),
        (table(&format!("{time}\nrows = [3, 2]")), "no range of rows"),
        (
            channel("column = \"x_m\", unit = \"m\" }\n[spans]\nfit = [[0, 1]]\nholdout = [[0.5, 2]]\n#"),
            "both fitted",
        ),
        (
            channel(
                "column = \"x_m\", unit = \"m\" }\n[[tables]]\nfile = \"a.csv\"\ntime = { column = \"t_s\", unit = \"s\" }\nchannels.x = { column = \"x_m\", unit = \"m\" }\n#",
            ),
            "two tables have a channel `x`",
        ),
        (table("time = 5"), "r.toml:3:"),
    ] {
        assert!(says.contains(words), "`{words}` is not in: {says}");
    }
}

#[test]
fn trials_have_row_numbers() {
    let folder = Folder::new();
    folder.write("a.csv", "heading [deg],error [deg]\n0,1\n45,2\n45,3\n90,4\n");
    let toml = folder.write("r.toml", "kind = \"trials\"\n[[tables]]\nfile = \"a.csv\"\n");
    let r = Recording::read(&toml).unwrap();
    assert_eq!((r.kind, &*r.channels[1].time), (Kind::Trials, &[0.0, 1.0, 2.0, 3.0][..]));
    assert_eq!(r.channel("heading").unwrap().levels().len(), 3);
    assert!(r.spans_for(&[], false).holdout.is_empty());
}

#[test]
fn spans_follow_the_held_out_rule() {
    let text: String = (0..=100).map(|i| format!("{i},0\n")).collect();
    let mut r = read("a.csv", format!("t [s],x [m]\n{text}")).unwrap();
    assert_eq!(r.spans_for(&[], false).holdout, [Span::new(60.0, 100.0)]);
    assert_eq!(r.spans_for(&[], true).fit, [Span::new(0.0, 100.0)]);
    r = r.with_spans(vec![], vec![Span::new(20.0, 30.0)]);
    assert_eq!(r.spans_for(&[], false).fit, [Span::new(0.0, 20.0), Span::new(30.0, 100.0)]);
}

const LOG: &str = "[[tables]]\nfile = \"a.nmea\"\nformat = \"nmea0183\"\n\
                   time = { start = \"2020-01-01T00:00:00Z\" }\n[tables.channels]\n";

fn sentence(second: f64, body: &str) -> String {
    let sum = body.bytes().fold(0, |x, b| x ^ b);
    format!("2020-01-01T00:00:{second:07.4}Z ${body}*{sum:02X}\n")
}

fn log(text: &str, channels: &str) -> Result<Recording, Error> {
    let folder = Folder::new();
    folder.write("a.nmea", text);
    Recording::read(folder.write("r.toml", format!("{LOG}{channels}")))
}

#[test]
fn a_log_reads_to_its_numbers() {
    let text = [
        sentence(0.5, "HEHDT,359.5,T"),
        sentence(0.6, "PSXN,23,1.5,-0.5,359.6,0.25"),
        sentence(0.7, "PSXN,20,0,0,0,0"),
        sentence(0.8, "GPGGA,120000.50,4812.300000,S,12330.600000,W,2,08,1.1,-1.44,M,-18.40,M,1.2,0001"),
        sentence(1.5, "HEHDT,0.5,T").replace("0.5,T*", "0.4,T*"),
        sentence(2.5, "HEHDT,1.5,T"),
        sentence(2.6, "HEROT,12.0,A"),
        sentence(3.6, "HEROT,13.0,V"),
        "2020-01-01T00:00:04Z $HEHDT,1.".to_owned(),
    ]
    .concat();
    let r = log(
        &text,
        "h = { sentence = \"HDT\", field = 1, unit = \"deg\", wraps = true }\n\
         heave = { sentence = \"PSXN\", id = 23, field = 5, unit = \"m\" }\n\
         turn = { sentence = \"ROT\", field = 1, unit = \"deg/min\" }\n\
         lat = { sentence = \"GGA\", field = 2, unit = \"deg\" }\n\
         lon = { sentence = \"GGA\", field = 4, unit = \"deg\" }\n\
         clock = { sentence = \"GGA\", field = 1, unit = \"s\" }\n",
    )
    .unwrap();
    let value = |name: &str, i: usize| r.channel(name).unwrap().values[i];
    assert_eq!(&*r.channel("h").unwrap().time, [0.5, 2.5]);
    assert!((value("h", 1) - 361.5_f64.to_radians()).abs() < 1e-12);
    assert_eq!(value("heave", 0), 0.25);
    assert!((value("turn", 0) - 0.2_f64.to_radians()).abs() < 1e-15 && value("turn", 1).is_nan());
    assert!((value("lat", 0) + 48.205_f64.to_radians()).abs() < 1e-14);
    assert!((value("lon", 0) + 123.51_f64.to_radians()).abs() < 1e-14);
    assert_eq!(value("clock", 0), 43200.5);
    let notes: Vec<String> = r.notes.iter().map(ToString::to_string).collect();
    assert!(notes.iter().any(|n| n.contains("a.nmea:5: 1 of 9 lines have a wrong checksum")), "{notes:?}");
    assert!(notes.iter().any(|n| n.contains("a.nmea:9: 1 of 9 lines have no checksum")), "{notes:?}");
    assert!(notes.iter().any(|n| n.contains("not valid")), "{notes:?}");
    assert_eq!(notes.len(), 3);
}

#[test]
fn bad_calls_of_logs_are_refused_with_place_and_remedy() {
    let text = sentence(0.5, "HEHDT,359.5,T") + &sentence(0.6, "PSXN,23,1.5,-0.5,359.6,0.25");
    for (channels, words) in [
        ("h = { sentence = \"THS\", field = 1, unit = \"deg\" }", "no THS sentence"),
        ("h = { sentence = \"HDT\", field = 2, unit = \"1\" }", "`T`, which is no number"),
        ("h = { sentence = \"HDT\", unit = \"deg\" }", "`sentence` and `field`"),
        ("h = { sentence = \"PSXN\", field = 2, unit = \"deg\" }", "write id = 20, 22 or 23"),
        ("h = { sentence = \"PSXN\", id = 23, field = 4, unit = \"m\" }", "is in deg, not in m"),
        ("h = { sentence = \"PSXN\", id = 23, field = 1, unit = \"deg\" }", "field 2"),
    ] {
        let says = log(&text, channels).unwrap_err().to_string();
        assert!(says.contains(words), "`{words}` is not in: {says}");
    }
    let twice = sentence(0.5, "HEHDT,1,T") + &sentence(0.5, "GPHDT,2,T");
    let channel = "h = { sentence = \"HDT\", field = 1, unit = \"deg\" }";
    assert!(log(&twice, channel).unwrap_err().to_string().contains("name one, such as GPHDT"));
    assert_eq!(log(&twice, &channel.replace("HDT", "HEHDT")).unwrap().channels[0].len(), 1);
}

/// The folder of a real recording, or a word that the test is skipped.
pub fn recordings(set: &str) -> Option<PathBuf> {
    let root = std::env::var_os("GYROSPEC_RECORDINGS")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("recordings"), PathBuf::from);
    let folder = root.join(set);
    if folder.is_dir() {
        return Some(folder);
    }
    crate::skipped::skipped(format_args!(
        "the recording {set} is not in {} (set GYROSPEC_RECORDINGS)",
        root.display()
    ));
    None
}

/// Every channel of a log: (name, sentence, field, unit, file and column of the same numbers).
const SAME: [(&str, &str, &str, &str, &str); 4] = [
    ("raw_gyro_1.nmea", "HDT\", field = 1", "deg", "gyro_1_heading.csv", "heading_deg"),
    ("raw_gyro_2.nmea", "HDT\", field = 1", "deg", "gyro_2_heading.csv", "heading_deg"),
    ("raw_gyro_1.nmea", "ROT\", field = 1", "deg/min", "gyro_1_rot.csv", "rot_deg_per_min"),
    ("raw_gyro_2.nmea", "ROT\", field = 1", "deg/min", "gyro_2_rot.csv", "rot_deg_per_min"),
];
const SAME_INS: [(&str, &str, &str, &str); 10] = [
    ("HDT\", field = 1", "deg", "heading", "heading_deg"),
    ("PSXN\", id = 23, field = 2", "deg", "attitude", "roll_deg"),
    ("PSXN\", id = 23, field = 3", "deg", "attitude", "pitch_deg"),
    ("PSXN\", id = 23, field = 4", "deg", "attitude", "heading_deg"),
    ("PSXN\", id = 23, field = 5", "m", "attitude", "heave_m"),
    ("PSXN\", id = 20, field = 4", "1", "quality", "heading"),
    ("GGA\", field = 2", "deg", "position", "lat_deg"),
    ("GGA\", field = 4", "deg", "position", "lon_deg"),
    ("GGA\", field = 9", "m", "position", "antenna_height_m"),
    ("VTG\", field = 5", "kn", "vtg", "speed_kn"),
];

#[test]
fn raw_logs_read_to_the_same_numbers_as_their_tables() {
    let Some(set) = recordings("ship_gyrocompass_skq201822s") else { return };
    let folder = Folder::new();
    let ins = SAME_INS.map(|(s, u, f, c)| {
        ("raw_ins_seapath_position.nmea", s, u, format!("ins_seapath_position_{f}.csv"), c)
    });
    let gyros = SAME.map(|(log, s, u, f, c)| (log, s, u, f.to_owned(), c));
    for (log, sentence, unit, file, column) in gyros.into_iter().chain(ins) {
        let toml = format!(
            "[[tables]]\nfile = {:?}\nformat = \"nmea0183\"\ntime = {{ start = \"2018-12-06T00:00:00Z\" }}\n\
             channels.raw = {{ sentence = \"{sentence}, unit = \"{unit}\" }}\n\
             [[tables]]\nfile = {:?}\ntime = {{ column = \"t_s\", unit = \"s\" }}\n\
             channels.table = {{ column = \"{column}\", unit = \"{unit}\" }}\n",
            set.join(log),
            set.join(&file)
        );
        let r = Recording::read(folder.write("r.toml", toml)).unwrap();
        let (raw, table) = (&r.channels[0], &r.channels[1]);
        assert_eq!(raw.time, table.time, "{file} {column}");
        // The tables' positions are rounded to eight decimals of a degree.
        let rounding = if file.contains("position.csv") { 5.1e-9_f64.to_radians() } else { 0.0 };
        for (i, (a, b)) in raw.values.iter().zip(&table.values).enumerate() {
            assert!((a - b).abs() <= rounding, "{file} {column} row {i}: {a} is not {b}");
        }
        assert!(r.notes.is_empty(), "{:?}", r.notes);
    }
}

#[test]
fn a_log_by_itself_shows_all_its_sentences() {
    let Some(set) = recordings("ship_gyrocompass_skq201822s") else { return };
    let r = Recording::read(set.join("raw_ins_seapath_position.nmea")).unwrap();
    assert_eq!(r.channel("PSXN23_roll").unwrap().len(), 500);
    assert!(r.channel("GPGGA_latitude").is_ok() && r.channel("GPVTG_course").unwrap().wraps);
}

/// A last line that may be cut is told by everything that reads a recording.
#[test]
fn a_last_line_that_may_be_cut_is_told_by_all_who_read_it() {
    let folder = tempfile::tempdir().unwrap();
    let rows: String = (0..2400)
        .map(|i| format!("{},{:.0}\n", 0.25 * f64::from(i), 2500.0 + 900.0 * (0.2 * f64::from(i)).sin()))
        .collect();
    let text = format!("time [s],roll [arcmin]\n{rows}600,1");
    fs::write(folder.path().join("cut.csv"), text).unwrap();
    fs::write(folder.path().join("cut.toml"), "[[tables]]\nfile = \"cut.csv\"\n").unwrap();
    let model = "name = \"m\"\n[inputs]\nroll = { unit = \"rad\" }\n[parameters]\na = { value = 1, unit = \"1\" }\n\
                 [outputs]\ny = { equals = \"a*roll\", unit = \"rad\" }\n";
    fs::write(folder.path().join("m.toml"), model).unwrap();
    for call in [
        "record cut.csv",
        "simulate m.toml cut.csv",
        "roll-error cut.csv",
        "roll-error cut.toml",
        "roll-error cut.csv --roll roll:arcmin",
        "new recording cut.csv",
        "laboratory m.toml cut.csv --cases 1",
    ] {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_gyrospec"));
        let said = command.args(call.split(' ')).current_dir(folder.path()).output().unwrap();
        let words = String::from_utf8_lossy(&[said.stdout, said.stderr].concat()).into_owned();
        let note =
            "note: cut.csv:2402: the last line has no line end, and its last number, `1`, has fewer digits";
        assert_eq!(words.matches(note).count(), 1, "{call}: {words}");
    }
}
