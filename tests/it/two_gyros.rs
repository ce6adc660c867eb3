//! A log into which two gyrocompasses speak: two channels, or a word, never one of both.

use gyrospec::record::Recording;

/// Headings of two gyros on a ship that yaws, the second half a degree off and 0.4 s later; the talkers as given.
fn log(talkers: [&str; 2], seconds: i32) -> String {
    let line = |t: f64, talker: &str, heading: f64| {
        let body = format!("{talker}HDT,{:.1},T", heading.rem_euclid(360.0));
        let sum = body.bytes().fold(0, |x, b| x ^ b);
        format!("2020-01-01T00:{:02}:{:06.3}Z ${body}*{sum:02X}\n", (t / 60.0) as i32, t % 60.0)
    };
    let at = |t: f64| 359.8 + 0.3 * (0.5 * t).sin();
    (0..seconds)
        .map(|k| {
            let t = f64::from(k);
            line(t, talkers[0], at(t)) + &line(t + 0.4, talkers[1], at(t + 0.4) + 1.0)
        })
        .collect()
}

fn read(text: &str, channels: &str) -> gyrospec::Result<Recording> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.nmea"), text).unwrap();
    let form = "[[tables]]\nfile = \"a.nmea\"\nformat = \"nmea0183\"\n\
                time = { start = \"2020-01-01T00:00:00Z\" }\n[tables.channels]\n";
    std::fs::write(folder.path().join("r.toml"), format!("{form}{channels}")).unwrap();
    Recording::read(folder.path().join(if channels.is_empty() { "a.nmea" } else { "r.toml" }))
}

fn channel(name: &str, sentence: &str) -> String {
    format!("{name} = {{ sentence = \"{sentence}\", field = 1, unit = \"deg\", wraps = true }}\n")
}

#[test]
fn two_talkers_are_two_channels() {
    let text = log(["HE", "HC"], 120);
    // as it lies, and by whole addresses
    let named = channel("one", "HEHDT") + &channel("two", "HCHDT");
    for (channels, names) in [("", ["HEHDT_heading", "HCHDT_heading"]), (&named, ["one", "two"])] {
        let r = read(&text, channels).unwrap();
        assert_eq!(r.channels.len(), 2);
        let [one, two] = names.map(|n| r.channel(n).unwrap());
        assert_eq!((one.len(), two.len()), (120, 120));
        // the yaw and half a step of resolution: nothing of the other gyro
        let off = |c: &gyrospec::record::Channel, from: f64| {
            c.values.iter().map(|v| (v.to_degrees() - from).rem_euclid(360.0)).fold(0.0, f64::max)
        };
        assert!(off(one, 359.4) < 0.75 && off(two, 0.4) < 0.75, "{} {}", off(one, 359.4), off(two, 0.4));
        assert!(r.notes.is_empty(), "{:?}", r.notes);
    }
    // by the kind alone they would be one
    let e = read(&text, &channel("h", "HDT")).unwrap_err().to_string();
    assert!(e.contains("several instruments") && e.contains("HCHDT (120), HEHDT (120)"), "{e}");
    assert!(e.contains("sentence = \"HCHDT\""), "{e}");
}

#[test]
fn one_after_the_other_they_are_read_with_a_word() {
    let both = log(["HE", "HE"], 60);
    let half = both.lines().count() / 2;
    let text: String = both
        .lines()
        .step_by(2)
        .enumerate()
        .map(|(k, l)| if k < half / 2 { format!("{l}\n") } else { renamed(l) })
        .collect();
    let r = read(&text, &channel("h", "HDT")).unwrap();
    assert_eq!(r.channels[0].len(), 60);
    assert!(r.notes.iter().any(|n| n.to_string().contains("one after the other")), "{:?}", r.notes);
}

/// A line of another talker, with its own checksum.
fn renamed(line: &str) -> String {
    let (before, body) = line.split_once('$').unwrap();
    let body = body.split('*').next().unwrap().replace("HEHDT", "GPHDT");
    let sum = body.bytes().fold(0, |x, b| x ^ b);
    format!("{before}${body}*{sum:02X}\n")
}

#[test]
fn one_talker_for_two_is_said_and_one_gyro_is_not_accused() {
    let r = read(&log(["HE", "HE"], 120), &channel("h", "HDT")).unwrap();
    assert!(r.notes.iter().any(|n| n.to_string().contains("two instruments in turn, 1")), "{:?}", r.notes);
    // one gyro alone, whatever its noise between two steps of resolution
    let mut state = 1u64;
    let mut dice = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        state >> 63
    };
    let text: String = (0..240)
        .map(|k| {
            let body = format!("HEHDT,{:.1},T", if dice() == 0 { 45.1 } else { 45.2 });
            let sum = body.bytes().fold(0, |x, b| x ^ b);
            format!("2020-01-01T00:{:02}:{:02}Z ${body}*{sum:02X}\n", k / 60, k % 60)
        })
        .collect();
    let r = read(&text, &channel("h", "HDT")).unwrap();
    assert!(r.notes.is_empty(), "{:?}", r.notes);
    // at one and the same time: refused, with what to do
    let twice = log(["HE", "HE"], 30).replace(".400Z", ".000Z");
    let e = read(&twice, &channel("h", "HDT")).unwrap_err().to_string();
    assert!(e.contains("occurs twice") && e.contains("give one of them another talker"), "{e}");
}
