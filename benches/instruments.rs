//! Instrument by motion: mean and spread by formula beside a simulation with its 99 % interval, and the spectrum at ω = 0;
//! coning and sculling beside closed forms and simulation; then the speed of each: the sweep of roll errors by the batch
//! path, the exact spread, and identification.

#![allow(clippy::print_stdout, clippy::print_stderr)] // a bench tells its figures

#[path = "instruments/table.rs"]
mod table;

use criterion::{Criterion, criterion_group};
use gyrospec::gyro::{
    Drive, Gyrosphere, Instrument, MonteCarlo, Motion, Trial, elastic, identify, seed, sweep,
};
use gyrospec::spectrum::Roll;
use std::hint::black_box;

fn cases(count: usize) -> Vec<(Gyrosphere, Roll, f64)> {
    (0..count)
        .map(|k| {
            let x = k as f64 / count as f64;
            let sphere = Gyrosphere { lag: 0.1 + x, ..Gyrosphere::seed() };
            (sphere, Roll::new(0.01 + 0.02 * x, 0.05 + 0.1 * x, 0.5 + 0.5 * x).expect("positive"), 6.0 * x)
        })
        .collect()
}

fn trials(count: usize) -> Vec<Trial> {
    let sphere = Gyrosphere::seed();
    (0..count)
        .map(|k| {
            let (heading, frequency) = (0.7 * k as f64, 0.5 + 1e-4 * k as f64);
            let here = Gyrosphere { lever: 0.25, ..sphere };
            let error = seed::regular_error(&here, &seed::Regular { amplitude: 1.0, frequency }, heading);
            // a made scatter without a generator
            let scatter = 3e-4 * (1e4 * heading).sin();
            Trial { heading, amplitude: 0.25, frequency, latitude: sphere.latitude, error: error + scatter }
        })
        .collect()
}

fn instruments(c: &mut Criterion) {
    let million = cases(1_000_000);
    c.bench_function("sweep of 10^6 parameter sets", |b| b.iter(|| sweep(black_box(&million))));
    let (sphere, roll, heading) = seed::example_3_1();
    let compass = Instrument::new(sphere, Box::new(elastic::Lag));
    let motion = Motion::roll(&roll);
    c.bench_function("mean and spread of one compass", |b| {
        b.iter(|| compass.error(black_box(&motion), black_box(heading)));
    });
    let table = trials(6000);
    c.bench_function("identification from 6000 trials", |b| b.iter(|| identify(black_box(&table), &sphere)));
    let drive = Drive::irregular(&motion);
    let day = MonteCarlo { step: 0.1, duration: 86400.0, settle: 0.0, runs: 2, seed: 1 };
    c.bench_function("two days at 10 Hz", |b| b.iter(|| day.run(black_box(&compass), &drive, heading)));
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = instruments
}

fn main() {
    match table::printed() {
        Ok(()) => benches(),
        Err(e) => eprintln!("{e}"),
    }
    Criterion::default().configure_from_args().final_summary();
}
