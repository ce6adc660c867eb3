//! Reading recordings: rows a second for tables (plain, gzip) and logs, and the look for faults.
//!
//! With GYROSPEC_BENCH_FILE a file of one's own is read once and timed instead.

#![allow(clippy::print_stdout)]

use criterion::{Criterion, Throughput};
use flate2::{Compression, write::GzEncoder};
use gyrospec::record::{Recording, quality, summaries};
use std::fmt::Write as _;
use std::hint::black_box;
use std::io::Write;
use std::path::Path;
use std::time::Instant;

const ROWS: u32 = 200_000;

fn table() -> String {
    let mut text = String::from("t [s],roll [deg],heading [deg],x [m]\n");
    for i in 0..ROWS {
        let t = 0.01 * f64::from(i);
        let _ = writeln!(
            text,
            "{t:.2},{:.6},{:.4},{:.9}",
            10.0 * t.sin(),
            180.0 + 170.0 * (0.01 * t).sin(),
            t.cos()
        );
    }
    text
}

fn log() -> String {
    let mut text = String::new();
    for i in 0..ROWS {
        let body = format!("HEHDT,{:.2},T", f64::from(i) * 0.001);
        let sum = body.bytes().fold(0, |x, b| x ^ b);
        let (s, ms) = (i / 10, i % 10);
        let _ = writeln!(
            text,
            "2020-01-01T{:02}:{:02}:{:02}.{ms}Z ${body}*{sum:02X}",
            s / 3600,
            s / 60 % 60,
            s % 60
        );
    }
    text
}

fn time_once(file: &Path) {
    let start = Instant::now();
    let recording = Recording::read(file).expect("a recording");
    let rows: usize = recording.channels.first().map_or(0, gyrospec::record::Channel::len);
    let read = start.elapsed().as_secs_f64();
    println!("{rows} rows read in {read:.2} s: {:.0} rows/s", rows as f64 / read);
    let start = Instant::now();
    black_box(quality::faults(&recording));
    println!("faults looked for in {:.2} s", start.elapsed().as_secs_f64());
    let start = Instant::now();
    black_box(summaries(&recording));
    println!("figures in {:.2} s", start.elapsed().as_secs_f64());
}

fn main() {
    if let Some(file) = std::env::var_os("GYROSPEC_BENCH_FILE") {
        return time_once(Path::new(&file));
    }
    let folder = tempfile::tempdir().expect("a folder");
    let mut packed = GzEncoder::new(Vec::new(), Compression::default());
    packed.write_all(table().as_bytes()).expect("room");
    let files = [
        ("table.csv", table().into_bytes()),
        ("table.csv.gz", packed.finish().expect("room")),
        ("log.nmea", log().into_bytes()),
    ];
    let mut criterion = Criterion::default().sample_size(10).configure_from_args();
    let mut group = criterion.benchmark_group("record");
    group.throughput(Throughput::Elements(u64::from(ROWS)));
    for (name, bytes) in files {
        let file = folder.path().join(name);
        std::fs::write(&file, bytes).expect("room");
        group.bench_function(name, |b| b.iter(|| Recording::read(&file).expect("a recording")));
    }
    let recording = Recording::read(folder.path().join("table.csv")).expect("a recording");
    group.bench_function("faults", |b| b.iter(|| quality::faults(&recording)));
    group.finish();
    criterion.final_summary();
}
