//! The rolling error of a compass, and what a model leaves out of a recording. Run with `cargo run --release --example
//! roll_and_diagnosis`.
#![allow(clippy::print_stdout)]

use gyrospec::{Compass, Model, Recording, Result, Roll, diagnose, roll_error};

fn main() -> Result<()> {
    let roll = Roll::new(0.02, 0.06, 0.65)?; // variance rad², decay and frequency rad/s
    let errors = roll_error(&Compass::paper()).roll(roll).headings(&[45f64.to_radians()]).run()?;
    for row in errors.rows() {
        println!("{:.0}°: {:+.2}°", row.heading.to_degrees(), errors.mean(row).to_degrees());
    }
    let model = Model::read("examples/clinometer.toml")?;
    let found = diagnose(&model, &[Recording::read("examples/clinometer.csv")?]).run()?;
    println!("{}", found.summary());
    Ok(())
}
