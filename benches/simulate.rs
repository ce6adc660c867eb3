//! Times of simulations: 25 000 samples of 2 states, 100 000 samples of the gyrosphere's 4 states,
//! each without and with sensitivities.

use criterion::{Criterion, criterion_group, criterion_main};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::simulate::{Options, Simulator, Unknown};
use gyrospec::units::Unit;
use std::hint::black_box;

const AXIS: &str = r#"
    name = "axis"
    [inputs]
    force = { unit = "N" }
    [parameters]
    M = { value = 90, unit = "kg", fit = true }
    Fv = { value = 200, unit = "N*s/m", fit = true }
    [states]
    q = { rate = "v", unit = "m", initial = "fit" }
    v = { rate = "(force - Fv*v)/M", unit = "m/s", initial = 0 }
    [outputs]
    position = { equals = "q", unit = "m" }
"#;

fn channel(name: &str, unit: &str, time: &[f64], f: impl Fn(f64) -> f64) -> Channel {
    let unit = Unit::parse(unit).expect("a unit of the list");
    Channel::new(name, unit, time.to_vec(), time.iter().map(|t| f(*t)).collect())
}

fn simulator(model: &Model, channels: Vec<Channel>) -> Simulator {
    let recording = Recording::from_channels("made", channels).expect("rising times");
    Simulator::new(model, &recording, &Options::default()).expect("a model that fits")
}

fn times(n: u32, step: f64) -> Vec<f64> {
    (0..n).map(|i| step * f64::from(i)).collect()
}

fn axis() -> Simulator {
    let t = times(25_000, 0.001);
    let model = Model::parse(AXIS).expect("a model");
    let force = channel("force", "N", &t, |t| 100.0 * (3.0 * t).sin());
    simulator(&model, vec![force, channel("position", "m", &t, |_| 0.0)])
}

fn gyrosphere() -> Simulator {
    let t = times(100_000, 0.1);
    let model = Model::builtin("gyrosphere").expect("built in");
    let roll = channel("roll_acc", "rad/s^2", &t, |t| 0.1 * (0.9 * t).sin());
    let heading = channel("heading", "rad", &t, |t| 0.7 + 1e-5 * t);
    simulator(&model, vec![roll, heading, channel("alpha", "deg", &t, |_| 0.0)])
}

fn bench(c: &mut Criterion) {
    let mut group = c.benchmark_group("simulate");
    group.sample_size(10);
    for (name, s) in [("axis, 25 000 x 2", axis()), ("gyrosphere, 100 000 x 4", gyrosphere())] {
        let (p, x) = (s.parameters(), s.initials());
        group.bench_function(name, |b| b.iter(|| s.run(black_box(&p), &x)));
        let unknowns =
            [Unknown::Parameter(0), Unknown::Parameter(1), Unknown::Initial(0), Unknown::Initial(1)];
        group.bench_function(format!("{name}, 4 sensitivities"), |b| {
            b.iter(|| s.run_with_sensitivities(black_box(&p), &x, &unknowns));
        });
    }
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
