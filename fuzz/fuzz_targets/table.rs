//! Tables of text (plain or gzip): channels are as long as their rising times, or there is an error.
#![no_main]

use gyrospec::record::Recording;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let folder = tempfile::tempdir().expect("a folder to write into");
    let file = folder.path().join("table.csv");
    std::fs::write(&file, bytes).expect("a file to write to");
    if let Ok(recording) = Recording::read(&file) {
        for channel in &recording.channels {
            assert_eq!(channel.time.len(), channel.values.len());
            assert!(channel.time.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }
});
