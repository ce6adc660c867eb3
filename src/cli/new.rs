//! `gyrospec new`: files to start from.

mod identifier;
mod log;
mod recording;

use super::Outcome;
use super::output::{quoted, words};
use crate::Result;
use std::path::PathBuf;

/// A model that simulates as it stands, with a word on every line.
pub const MODEL: &str = include_str!("new/model.toml");
const HELP: &str = "\
Examples:
  gyrospec new model > my.toml
  gyrospec new recording ship.csv > ship.toml
  gyrospec new recording ship.nmea > ship.toml";

/// Prints a file to start from.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    #[command(subcommand)]
    what: What,
}

#[derive(clap::Subcommand)]
enum What {
    /// A commented model file that simulates as it stands.
    Model,
    /// A recording file for a CSV or an NMEA 0183 log; every guess is marked with a comment.
    Recording {
        /// The CSV file (.csv, .csv.gz) or log; - is standard input.
        csv: PathBuf,
    },
}

pub fn run(call: &Call) -> Result<Outcome> {
    match &call.what {
        What::Model => words(MODEL)?,
        What::Recording { csv } => quoted(&recording::guessed(csv)?)?,
    }
    Ok(Outcome::Done)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;
    use crate::record::{Channel, Recording};
    use crate::simulate::{Options, Simulator};
    use crate::units::Unit;

    #[test]
    fn the_template_simulates_as_it_stands() {
        let model = Model::parse(MODEL).unwrap();
        let time: Vec<f64> = (0..200).map(|i| f64::from(i) * 0.05).collect();
        let channel = |name: &str, unit: &str| {
            let values = time.iter().map(|t| t.sin()).collect();
            Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values)
        };
        let recording =
            Recording::from_channels("made", vec![channel("force", "N"), channel("position", "mm")]).unwrap();
        let simulator = Simulator::new(&model, &recording, &Options::default()).unwrap();
        let run = simulator.run(&simulator.parameters(), &simulator.initials()).unwrap();
        assert!(run.outputs[0].iter().all(|y| y.is_finite()));
    }
}
