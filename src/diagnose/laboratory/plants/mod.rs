//! The plants of the laboratory: one file a plant, each of another field.
//!
//! A new plant is one new file and one line in `plants!` below: a model at its true values, how its inputs are drawn,
//! and what is recorded beside them that the model does not use.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;
use std::ops::Range;

/// A plant.
pub struct Plant {
    /// Its name on the command line.
    pub name: &'static str,
    /// The model at its true values, a file of the usual form.
    pub model: &'static str,
    /// States whose start is known; that of the others is fitted.
    pub known: &'static [&'static str],
    /// Samples of a recording.
    pub rows: usize,
    /// Time between them, s.
    pub step: f64,
    /// Draws what is recorded beside the outputs.
    drive: fn(&mut Draws) -> Vec<Driven>,
}

/// Name, unit and values of a channel, one a sample and in its unit.
pub type Driven = (&'static str, &'static str, Vec<f64>);

impl Plant {
    /// Times in s, and the channels drawn for them.
    pub fn draw(&self, rng: &mut ChaCha8Rng) -> (Vec<f64>, Vec<Driven>) {
        let time: Vec<f64> = (0..self.rows).map(|i| self.step * i as f64).collect();
        let driven = (self.drive)(&mut Draws { time: &time, rng });
        (time, driven)
    }
}

/// What the courses of the inputs are drawn from.
struct Draws<'a> {
    time: &'a [f64],
    rng: &'a mut ChaCha8Rng,
}

impl Draws<'_> {
    /// mean + sum of sines with rates from a range, rad/s, and amplitudes from another.
    fn sines(&mut self, mean: f64, count: usize, rates: Range<f64>, amplitudes: Range<f64>) -> Vec<f64> {
        let mut one = || {
            let (w, phase) = (self.rng.random_range(rates.clone()), self.rng.random_range(0.0..6.3));
            (w, phase, self.rng.random_range(amplitudes.clone()))
        };
        let waves: Vec<(f64, f64, f64)> = (0..count).map(|_| one()).collect();
        let at = |t: &f64| mean + waves.iter().map(|(w, p, a)| a * (w * t + p).sin()).sum::<f64>();
        self.time.iter().map(at).collect()
    }

    /// mean + sines with periods from a range, s, of a root mean square of about `size` together.
    fn waves(&mut self, mean: f64, size: f64, periods: Range<f64>) -> Vec<f64> {
        const COUNT: usize = 8;
        let each = size * (2.0 / COUNT as f64).sqrt();
        self.sines(mean, COUNT, TAU / periods.end..TAU / periods.start, 0.6 * each..1.4 * each)
    }

    /// Levels about a mean with a root mean square of `size`, each held for one to three times `hold`, s.
    fn steps(&mut self, mean: f64, size: f64, hold: f64) -> Vec<f64> {
        let (mut level, mut until) = (mean, f64::NEG_INFINITY);
        let half = 3.0_f64.sqrt() * size;
        let mut at = |t: &f64| {
            if *t >= until {
                level = self.rng.random_range(mean - half..mean + half);
                until = t + hold * self.rng.random_range(1.0..3.0);
            }
            level
        };
        self.time.iter().map(&mut at).collect()
    }
}

macro_rules! plants {
    ($($file:ident),* $(,)?) => {
        $(mod $file;)*
        /// Every plant.
        pub const ALL: &[Plant] = &[$($file::PLANT),*];
    };
}

plants! { axis, pendulum, motor, tanks, room, ship, gyrosphere, battery, reactor }

#[cfg(test)]
mod tests {
    use super::super::Scenario;
    use super::ALL;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;

    #[test]
    fn every_plant_reads_and_its_inputs_are_drawn() {
        for plant in ALL {
            let made = Scenario::drawn(plant, &mut ChaCha8Rng::seed_from_u64(1)).unwrap();
            for input in &made.model.inputs {
                let values = &made.recording.channel(&input.name).unwrap().values;
                assert_eq!(values.len(), plant.rows, "{}", plant.name);
                assert!(values.iter().any(|v| *v != values[0]), "{} of {}", input.name, plant.name);
            }
        }
    }
}
