//! NMEA 0183 logs: whatever stands in them, times rise, or there is an error.
#![no_main]

use gyrospec::record::Recording;

const RECORDING: &str = r#"
    [[tables]]
    file = "log.txt"
    format = "nmea0183"
    time = { start = "2020-01-01T00:00:00Z" }
    [tables.channels]
    heading = { sentence = "HDT", field = 1, unit = "deg", wraps = true }
    roll = { sentence = "PSXN", id = 23, field = 2, unit = "deg" }
"#;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let folder = tempfile::tempdir().expect("a folder to write into");
    let file = folder.path().join("log.toml");
    std::fs::write(&file, RECORDING).expect("a file to write to");
    std::fs::write(folder.path().join("log.txt"), bytes).expect("a file to write to");
    if let Ok(recording) = Recording::read(&file) {
        for channel in &recording.channels {
            assert!(channel.time.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }
});
