//! Makes `examples/roll.csv`: the roll of no real ship, of the form (3.3) with a standard
//! deviation of 4°, sampled at 4 Hz for ten minutes and rounded to 0.01° as an instrument would.
//!
//! `cargo run --release --example make_roll > examples/roll.csv`
#![allow(clippy::print_stdout)]

use gyrospec::spectrum::Roll;

fn main() {
    let roll = Roll::new(4f64.to_radians().powi(2), 0.06, 0.65).expect("positive numbers");
    println!("time [s],roll [deg]");
    for (k, angle) in roll.samples(0.25, 2400, 1978).iter().enumerate() {
        println!("{},{:.2}", 0.25 * k as f64, angle.to_degrees() + 0.0);
    }
}
