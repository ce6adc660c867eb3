//! NMEA 0183 logs whose lines have no time stamps: the ZDA sentences are the clock, or it is refused; and the recording
//! files that `new recording` writes for logs.

use gyrospec::record::{Channel, Recording};
use gyrospec::{Error, Result};
use std::path::Path;
use std::process::Command;

fn sentence(body: &str) -> String {
    let sum = body.bytes().fold(0, |x, b| x ^ b);
    format!("${body}*{sum:02X}\n")
}

/// ZDA so many seconds after 23:59:50 on the last day of 2019.
fn zda(second: u32) -> String {
    let (clock, day) = clock(second, 0);
    sentence(&format!("GPZDA,{clock},{day},,"))
}

/// hhmmss.ss, and `dd,mm,yyyy`.
fn clock(second: u32, hundredths: u32) -> (String, &'static str) {
    let s = 86_390 + second;
    let (s, day) = if s < 86_400 { (s, "31,12,2019") } else { (s - 86_400, "01,01,2020") };
    (format!("{:02}{:02}{:02}.{hundredths:02}", s / 3600, s / 60 % 60, s % 60), day)
}

fn heading(second: u32, fifth: u32) -> String {
    sentence(&format!("HEHDT,{}.{},T", 100 + second, 2 * fifth))
}

/// Each second ZDA, five headings, a rate of turn and a position of 0.4 s later.
fn second(k: u32) -> String {
    let turn = sentence(&format!("TIROT,{k}.0,A"));
    let at = clock(k, 40).0;
    let place = sentence(&format!("GPGGA,{at},4812.300000,S,12330.600000,W,2,08,1.1,{k}.5,M,-18.40,M,,"));
    let headings: Vec<String> = (0..5).map(|j| heading(k, j)).collect();
    [zda(k), headings[..3].concat(), turn, place, headings[3..].concat()].concat()
}

fn log(seconds: std::ops::Range<u32>) -> String {
    seconds.map(second).collect()
}

fn read(text: &str) -> Result<Recording, Error> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.nmea"), text).unwrap();
    Recording::read(folder.path().join("a.nmea"))
}

fn notes(r: &Recording) -> String {
    r.notes.iter().map(|n| format!("{}: {}\n", n.line.unwrap_or_default(), n.message)).collect()
}

/// That the times of headings are those at which they were made, and that they are these seconds.
fn are_headings_of(r: &Recording, seconds: &[u32]) {
    let c = r.channel("HEHDT_heading").unwrap();
    let made = seconds.iter().flat_map(|k| (0..5).map(move |j| f64::from(*k) + 0.2 * f64::from(j)));
    let made: Vec<f64> = made.collect();
    assert_eq!(c.len(), made.len());
    for ((t, v), made) in c.time.iter().zip(&c.values).zip(made) {
        assert!((t - made).abs() < 1e-9, "{t} {made}");
        assert!((v.to_degrees() - 100.0 - made).abs() < 1e-9, "{v} {made}");
    }
}

#[test]
fn zda_is_the_clock_of_a_log_without_stamps_over_midnight() {
    for text in [log(0..20), log(0..20).replace('\n', "\r\n")] {
        let r = read(&text).unwrap();
        // the last ZDA has none after it
        are_headings_of(&r, &(0..19).collect::<Vec<u32>>());
        let seconds = |name: &str, after: f64, count: u32| {
            let c = r.channel(name).unwrap();
            let made: Vec<f64> = (0..count).map(|k| f64::from(k) + after).collect();
            assert_eq!(c.time.to_vec(), made, "{name}");
            c.values.clone()
        };
        assert_eq!(seconds("TIROT_rate_of_turn", 0.0, 19)[18], (18.0_f64 / 60.0).to_radians());
        // what carries its own time needs no ZDA after it
        assert_eq!(seconds("GPGGA_antenna_height", 0.4, 20)[19], 19.5);
        assert_eq!(seconds("GPZDA_time_of_day", 0.0, 20)[11], 1.0);
        let told = notes(&r);
        assert!(told.contains("GPZDA sentences are the clock") && told.contains("over their 1 s"), "{told}");
        assert!(told.contains("154: 6 of 160 lines stand where no ZDA"), "{told}");
    }
}

#[test]
fn where_the_clock_stays_away_nothing_has_a_time() {
    // half a minute without ZDA, then one with a wrong checksum
    let text: String = (0..60)
        .map(|k| match k {
            10..40 => second(k).replace(&zda(k), ""),
            50 => second(k).replace(&zda(k), &zda(k).replace("ZDA,", "ZDA,1")),
            _ => second(k),
        })
        .collect();
    let r = read(&text).unwrap();
    let there: Vec<u32> = (0..59).filter(|k| !(9..40).contains(k) && !(49..51).contains(k)).collect();
    are_headings_of(&r, &there);
    let told = notes(&r);
    // six sentences a second without a time of their own
    assert!(told.contains(&format!("{} of", 6 * (60 - there.len()))), "{told}");
    assert!(told.contains("1 of 450 lines have a wrong checksum"), "{told}");
    let places = r.channel("GPGGA_antenna_height").unwrap();
    assert_eq!((places.len(), places.time[30]), (60, 30.4));
}

#[test]
fn a_heading_with_a_wrong_checksum_is_left_out_and_the_log_may_begin_anywhere() {
    let bad = heading(3, 2).replace("HDT,", "HDT,1");
    let text = log(0..10).replace(&heading(3, 2), &bad);
    // cut within a line, and without ZDA at first
    let text = format!("4,T*1A\n{}{}", heading(0, 1).repeat(7), text);
    let r = read(&text).unwrap();
    let c = r.channel("HEHDT_heading").unwrap();
    assert_eq!(c.len(), 9 * 5 - 1);
    // the four that are left lie within their second, in order
    assert_eq!(c.time[15..20], [3.0, 3.25, 3.5, 3.75, 4.0]);
    let told = notes(&r);
    assert!(told.contains("1 of 88 lines have a wrong checksum"), "{told}");
    assert!(told.contains("2: 13 of 88 lines stand where no ZDA"), "{told}");
}

#[test]
fn a_log_without_any_clock_is_refused() {
    let without: String =
        log(0..5).lines().filter(|l| !l.contains("ZDA")).map(|l| format!("{l}\n")).collect();
    let empty = without.clone() + &sentence("GPZDA,,,,,,") + &without;
    let never = without.clone() + &sentence("GPZDA,120000.00,30,02,2020,,") + &without;
    for text in [&without, &empty, &never] {
        let e = read(text).unwrap_err().to_string();
        assert!(
            e.contains("without time stamps, and no ZDA sentence") && e.contains("log ZDA beside"),
            "{e}"
        );
    }
    let e = read(&(zda(5) + &heading(5, 0))).unwrap_err().to_string();
    assert!(e.contains("no HEHDT sentence stands between two ZDA sentences"), "{e}");
    let e = read(&[log(5..8), log(2..4)].concat()).unwrap_err();
    assert!(
        e.to_string().contains("the clock of the log runs backwards: GPZDA tells 2019-12-31T23:59:52.00Z"),
        "{e}"
    );
    assert_eq!((e.line(), e.column()), (Some(25), Some(1)));
}

#[test]
fn a_second_clock_and_a_position_that_is_not_valid_tell_nothing() {
    // another talker's ZDA half a second off, and one position that repeats its time and says that it has no fix
    let text: String = (0..10)
        .map(|k| {
            let (at, day) = clock(k, 50);
            let stale = sentence("GPGGA,235950.40,,,,,0,00,,,M,,M,,");
            second(k) + &sentence(&format!("INZDA,{at},{day},,")) + &stale
        })
        .collect();
    let r = read(&text).unwrap();
    are_headings_of(&r, &(0..9).collect::<Vec<u32>>());
    assert_eq!(r.channel("INZDA_day").unwrap().time[9], 9.5);
    assert_eq!(r.channel("GPGGA_latitude").unwrap().len(), 10);
}

/// What `new recording` prints for a log, and what it says on the other stream.
fn written(folder: &Path, name: &str) -> (String, String) {
    let mut call = Command::new(env!("CARGO_BIN_EXE_gyrospec"));
    let out = call.current_dir(folder).args(["new", "recording", name]).output().unwrap();
    let said = String::from_utf8(out.stderr).unwrap();
    assert!(out.status.success(), "{said}");
    (String::from_utf8(out.stdout).unwrap(), said)
}

#[test]
fn what_is_written_for_a_log_reads_as_the_log() {
    let roll = |k: u32| sentence(&format!("PSXN,23,{k}.5,-0.5,359.6,"));
    let other = |k: u32| sentence(&format!("YXXDR,A,{k}.25,D,ROLL"));
    let bodies = |k: u32| [heading(k, 0), sentence(&format!("HCHDT,{k},T")), roll(k), other(k)];
    let stamped = |stamp: &dyn Fn(u32) -> String| -> String {
        let lines = (0..30).flat_map(|k| bodies(k).map(|b| format!("{} {b}", stamp(k))));
        lines.collect()
    };
    let folder = tempfile::tempdir().unwrap();
    let iso = |k: u32| format!("2019-12-31T23:59:{:02}.25Z", 30 + k);
    for (text, start) in [
        (stamped(&iso), "\"2019-12-31T23:59:30.25Z\""),
        (stamped(&iso).replace('\n', "\r\n"), "\"2019-12-31T23:59:30.25Z\""),
        (stamped(&|k| format!("{}.5", 1_577_836_770 + k)), "\"1577836770.5\""),
        (log(0..20), "\"2019-12-31T23:59:50.00Z\""),
    ] {
        std::fs::write(folder.path().join("ship.nmea"), &text).unwrap();
        let (toml, said) = written(folder.path(), "ship.nmea");
        assert!(toml.contains(&format!("time = {{ start = {start} }}")), "{toml}");
        std::fs::write(folder.path().join("ship.toml"), &toml).unwrap();
        let [by_file, by_itself] =
            ["ship.toml", "ship.nmea"].map(|f| Recording::read(folder.path().join(f)).unwrap());
        let there = |c: &&Channel| c.values.iter().any(|v| !v.is_nan());
        let all: Vec<&Channel> = by_itself.channels.iter().filter(there).collect();
        assert_eq!((by_file.channels.len(), by_file.name.as_str()), (all.len(), "ship"));
        for c in all {
            let same = by_file.channel(&c.name).unwrap();
            assert_eq!((&same.time, same.wraps, same.unit.text()), (&c.time, c.wraps, c.unit.text()));
            let bits = |c: &Channel| c.values.iter().map(|v| v.to_bits()).collect::<Vec<u64>>();
            assert_eq!(bits(same), bits(c), "{}", c.name);
        }
        assert_eq!(said.contains("are the clock"), !text.contains("PSXN"), "{said}");
    }
    std::fs::write(folder.path().join("ship.nmea"), stamped(&iso)).unwrap();
    let (toml, _) = written(folder.path(), "ship.nmea");
    for line in [
        "HEHDT_heading = { sentence = \"HEHDT\", field = 1, unit = \"deg\", wraps = true }",
        "PSXN23_roll = { sentence = \"PSXN\", id = 23, field = 2, unit = \"deg\" }",
        "# PSXN23_heave = { sentence = \"PSXN\", id = 23, field = 5, unit = \"m\" }  # left out, as it holds nothing",
    ] {
        assert!(toml.lines().any(|l| l == line), "{line} is not in\n{toml}");
    }
    assert!(toml.contains("# YXXDR (30) left out: their fields are not known"), "{toml}");
}

#[test]
fn no_file_is_written_for_a_log_that_cannot_be_read() {
    let folder = tempfile::tempdir().unwrap();
    let twice = format!("2020-01-01T00:00:00Z {0}2020-01-01T00:00:00Z {0}", heading(0, 0));
    for (text, says) in [
        (heading(0, 0), "no ZDA sentence"),
        (twice, "occurs twice"),
        (format!("2020-01-01T00:00:00Z {}", sentence("YXXDR,A,1,D,ROLL")), "no sentence is known here"),
    ] {
        std::fs::write(folder.path().join("a.nmea"), text).unwrap();
        let mut call = Command::new(env!("CARGO_BIN_EXE_gyrospec"));
        let out = call.current_dir(folder.path()).args(["new", "recording", "a.nmea"]).output().unwrap();
        let said = String::from_utf8_lossy(&out.stderr);
        assert!(said.contains(says) && said.contains("a.nmea"), "{said}");
        assert_eq!((out.status.code(), out.stdout.len()), (Some(2), 0));
    }
}

/// A real log, its stamps taken away: no sentence is further from its own stamp than the time from one ZDA to the next
/// and what the stamps of ZDA stray by.
#[test]
fn a_real_log_without_its_stamps_is_within_its_clock() {
    let Some(set) = crate::record::recordings("ship_gyrocompass_skq201822s") else { return };
    let stamped = std::fs::read_to_string(set.join("raw_ins_seapath_position.nmea")).unwrap();
    let bare: String = stamped.lines().filter_map(|l| Some(format!("{}\n", l.split_once(' ')?.1))).collect();
    let (by_stamp, by_zda) = (read(&stamped).unwrap(), read(&bare).unwrap());
    // seconds of the day that a ZDA carries, against its stamp, which counts from 0.0549 s after midnight
    let zda = by_stamp.channel("GPZDA_time_of_day").unwrap();
    let late = zda.time.iter().zip(&zda.values).map(|(t, v)| t + 0.0549 - v);
    let late: Vec<f64> = late.collect();
    let (least, most) = late.iter().fold((f64::MAX, f64::MIN), |(l, m), x| (l.min(*x), m.max(*x)));
    assert!(least > 0.0 && most < 1.0, "{least} {most}");
    let zero = zda.values[0];
    for name in ["GPHDT_heading", "PSXN23_roll", "GPVTG_speed"] {
        let [a, b] = [&by_stamp, &by_zda].map(|r| r.channel(name).unwrap());
        // what stands before the first ZDA or after the last is not there
        let skipped = a.values.windows(20).position(|w| w == &b.values[..20]).unwrap();
        assert!(skipped < 3 && a.len() - b.len() - skipped < 3, "{name} {skipped} {} {}", a.len(), b.len());
        for (t, own) in b.time.iter().zip(&a.time[skipped..]) {
            let off = own + 0.0549 - (t + zero);
            assert!(least - 1e-9 < off && off < most + 1.0, "{name} {own} {t}");
        }
    }
}
