//! What the command line says of the instrument, the motion and the rows wanted.

use super::part::PartOptions;
use crate::cli::quantity::{angle, frequency, latitude, listed, quantities, quantity};
use crate::gyro::elastic::{Elastic, Lag, together};
use crate::gyro::range::{self, Range};
use crate::gyro::seed::Regular;
use crate::gyro::{Axis, seed};
use crate::rolling::{Against as Rows, Compass, Days, Excitation, Source, Waves};
use crate::spectrum::{Hull, Roll, Sea};
use crate::{Error, Result};
use clap::{Args, ValueEnum};

#[derive(Args)]
pub struct InstrumentOptions {
    #[command(flatten)]
    part: PartOptions,
    /// Latitude, in degrees or as 60°12'N; less than 90, and the error grows as 1/cos towards the pole.
    #[arg(long, allow_hyphen_values = true)]
    pub latitude: Option<String>,
    /// Height of the compass above the roll axis.
    #[arg(long, allow_hyphen_values = true)]
    pub lever: Option<String>,
    /// Speed of the ship over the ground; in a sea, through the waves too.
    #[arg(long, allow_hyphen_values = true)]
    pub speed: Option<String>,
}

impl InstrumentOptions {
    /// Whether nothing was said.
    pub fn plain(&self) -> bool {
        self.part.is_empty() && self.latitude.is_none() && self.lever.is_none() && self.speed.is_none()
    }

    /// Puts what is said into a compass; parts go together with each other and with that of a model.
    pub fn put(&self, mut compass: Compass) -> Result<Compass> {
        let s = &mut compass.sphere;
        if let Some(text) = &self.latitude {
            s.latitude = latitude("latitude", text, &range::LATITUDE)?;
        }
        let places: [(&str, &Option<String>, &Range, &mut f64); 2] = [
            ("lever", &self.lever, &range::LEVER, &mut s.lever),
            ("speed", &self.speed, &range::SPEED, &mut compass.speed),
        ];
        for (name, option, range, place) in places {
            if let Some(text) = option {
                *place = quantity(name, text, range)?;
            }
        }
        let asked = self.part.parts()?;
        if !asked.is_empty() {
            let own = (compass.part.name() != Lag.name()).then(|| compass.part.clone());
            let all: Vec<_> = own.into_iter().chain(asked).collect();
            compass.part = together(&all)?;
        }
        Ok(compass)
    }
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum SeaKind {
    /// Pierson-Moskowitz: fully grown, by its height alone.
    Pm,
    Bretschneider,
    Jonswap,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
pub enum Also {
    Pitch,
    Heave,
    Sway,
    Surge,
    Yaw,
}

impl Also {
    fn axis(self) -> Axis {
        match self {
            Self::Pitch => Axis::Pitch,
            Self::Heave => Axis::Heave,
            Self::Sway => Axis::Sway,
            Self::Surge => Axis::Surge,
            Self::Yaw => Axis::Yaw,
        }
    }

    /// Whether the slope's part athwart, and that along the ship, excites it.
    fn excited_by(self) -> [bool; 2] {
        match self {
            Self::Heave => [false, false],
            Self::Pitch | Self::Surge => [false, true],
            Self::Sway => [true, false],
            Self::Yaw => [true, true],
        }
    }
}

#[derive(Args)]
pub struct MotionOptions {
    /// Irregular roll of the paper's form: standard deviation, decay mu, frequency eps (rad/s) or its period (12s).
    #[arg(long, value_name = "SIGMA,MU,EPS", group = "motion")]
    irregular: Option<String>,
    /// Regular roll: amplitude, frequency (rad/s) or period (12s).
    #[arg(long, value_name = "AMPLITUDE,FREQUENCY", group = "motion")]
    regular: Option<String>,
    /// Motion in a wind sea.
    #[arg(long, value_enum, group = "motion")]
    sea: Option<SeaKind>,
    #[command(flatten)]
    waves: SeaOptions,
    /// Two first-order low-passes on the motion, at this frequency.
    #[arg(long, value_name = "FREQUENCY")]
    band: Option<String>,
}

#[derive(Args)]
#[group(id = "waves", multiple = true, conflicts_with_all = ["irregular", "regular"])]
struct SeaOptions {
    /// Significant wave height of the sea.
    #[arg(long, requires = "sea", allow_hyphen_values = true)]
    height: Option<String>,
    /// Peak period of the sea.
    #[arg(long, requires = "sea", allow_hyphen_values = true)]
    period: Option<String>,
    /// Peakedness of JONSWAP; 3.3 if absent.
    #[arg(long, requires = "sea")]
    gamma: Option<f64>,
    /// Where the sea comes from, off the bow: 0 ahead, 90 from abeam to starboard (as if absent); a bare number is in degrees.
    #[arg(long, requires = "sea", value_name = "BEARING", allow_hyphen_values = true)]
    sea_from: Option<String>,
    /// The ship: roll period, damping ratio, effective wave slope, beam.
    #[arg(long, requires = "sea", value_name = "PERIOD,DAMPING,SLOPE,BEAM")]
    ship: Option<String>,
    /// Length of the ship's waterline; six beams if absent.
    #[arg(long, requires = "sea", value_name = "LENGTH", allow_hyphen_values = true)]
    ship_length: Option<String>,
    /// Waves from many directions: n of cosⁿ about the main one, 2 to 4 in a wind sea; long crests if absent.
    #[arg(long, requires = "sea", value_name = "N")]
    spread: Option<f64>,
    /// Damping of the ship's roll beyond the ratio: d of d|rate|rate, 1/rad, and c of c rate³, s/rad²; 0 if absent.
    #[arg(long, requires = "sea", value_name = "QUADRATIC[,CUBIC]")]
    roll_damping: Option<String>,
    /// Other motions in the same sea; heave and yaw change the spread alone, not the mean.
    #[arg(long, requires = "sea", value_enum, value_delimiter = ',')]
    also: Vec<Also>,
}

impl MotionOptions {
    /// Whether a motion was asked for.
    pub fn given(&self) -> bool {
        self.is_named() || self.band.is_some()
    }

    /// Whether it says what the motion is, not only where its band ends.
    pub fn is_named(&self) -> bool {
        self.irregular.is_some() || self.regular.is_some() || self.sea.is_some()
    }

    /// Whether the motion is a sea.
    pub fn is_sea(&self) -> bool {
        self.sea.is_some()
    }

    /// Whether the size of the motion was said.
    pub fn is_sized(&self) -> bool {
        self.waves.height.is_some() || self.irregular.is_some() || self.regular.is_some()
    }

    /// What moves the ship; irregular roll is `default`, else the paper's, where nothing is said.
    pub fn excitation(&self, default: Option<Roll>) -> Result<Excitation> {
        let source = match (self.sea, &self.regular, &self.irregular) {
            (Some(kind), _, _) => Source::Sea(self.waves.waves(kind)?),
            (None, Some(text), _) => {
                let [amplitude, swing] = listed("regular", text)?;
                Source::Regular(Regular {
                    amplitude: quantity("regular", amplitude, &range::ROLL_AMPLITUDE)?,
                    frequency: frequency("regular", swing, &range::ROLL_FREQUENCY)?,
                })
            }
            (None, None, Some(text)) => {
                let [sigma, mu, eps] = listed("irregular", text)?;
                let sigma = quantity("irregular", sigma, &range::ROLL_DEVIATION)?;
                let mu = quantity("irregular", mu, &range::ROLL_DECAY)?;
                let eps = frequency("irregular", eps, &range::ROLL_FREQUENCY)?;
                Source::Irregular(Roll::new(sigma * sigma, mu, eps)?)
            }
            (None, None, None) => Source::Irregular(default.unwrap_or_else(|| seed::example_3_1().1)),
        };
        Ok(Excitation { source, band: self.band()? })
    }

    /// The corner of the low-passes, rad/s.
    pub fn band(&self) -> Result<Option<f64>> {
        self.band.as_deref().map(|text| quantity("band", text, &range::BAND)).transpose()
    }
}

impl SeaOptions {
    /// The sea and the ship in it.
    fn waves(&self, kind: SeaKind) -> Result<Waves> {
        let sea = self.sea(kind)?;
        let from = self.sea_from.as_deref().map(|t| angle("sea-from", t, &range::SEA_FROM)).transpose()?;
        let from = from.unwrap_or(std::f64::consts::FRAC_PI_2);
        let hull = self.hull()?;
        let (athwart, along) = Hull::slopes(from);
        if let Some(n) = self.spread {
            range::SEA_SPREAD.check(n).map_err(|e| e.about("--spread"))?;
            if self.also.contains(&Also::Yaw) {
                return Err(Error::usage("yaw is that of a sea whose crests are long")
                    .with_hint("leave --spread or yaw away; yaw changes no mean"));
            }
        }
        let (athwart, along) = if self.spread.is_some() { (1.0, 1.0) } else { (athwart, along) };
        for also in &self.also {
            let (name, [across, ahead]) = (format!("{also:?}").to_lowercase(), also.excited_by());
            let lacks = match (ahead && along == 0.0, across && athwart == 0.0) {
                (true, _) => "a sea from abeam has no slope along the ship",
                (_, true) => "a sea from ahead or astern has no slope athwart",
                _ => continue,
            };
            return Err(Error::usage(format!("{lacks}: nothing excites {name}")).with_hint(format!(
                "say where it comes from, as --sea-from 60deg (0 is ahead, 90 abeam), or leave {name} away"
            )));
        }
        if !self.also.iter().any(|a| a.excited_by()[1]) && athwart == 0.0 {
            return Err(Error::usage(
                "a sea from ahead or astern has no slope athwart: nothing excites roll",
            )
            .with_hint("without roll the mean error by it is 0 on every heading; say --also pitch, or another --sea-from"));
        }
        let also = self.also.iter().map(|a| a.axis()).collect();
        Ok(Waves { sea, from, speed: 0.0, spread: self.spread, hull, also })
    }

    fn sea(&self, kind: SeaKind) -> Result<Sea> {
        let read = |name, text: &Option<String>, range: &Range| {
            text.as_deref().map(|t| quantity(name, t, range)).transpose()
        };
        let height = read("height", &self.height, &range::WAVE_HEIGHT)?.unwrap_or(3.0);
        let period = read("period", &self.period, &range::WAVE_PERIOD)?;
        let peak = std::f64::consts::TAU / period.unwrap_or(8.0);
        if self.gamma.is_some() && kind != SeaKind::Jonswap {
            return Err(Error::usage("only JONSWAP has a peakedness")
                .with_hint("leave --gamma away, or use --sea jonswap"));
        }
        let sea = match kind {
            SeaKind::Pm if period.is_some() => {
                return Err(Error::usage("the sea of Pierson and Moskowitz has the period of its height")
                    .with_hint("leave --period away, or use --sea bretschneider"));
            }
            SeaKind::Pm => Sea::PiersonMoskowitz { height },
            SeaKind::Bretschneider => Sea::Bretschneider { height, peak },
            SeaKind::Jonswap => Sea::Jonswap { height, peak, gamma: self.gamma.unwrap_or(3.3) },
        };
        sea.check()?;
        Ok(sea)
    }

    fn hull(&self) -> Result<Hull> {
        let mut hull = Hull::default();
        if let Some(text) = &self.ship {
            let ranges = [&range::ROLL_PERIOD, &range::ROLL_DAMPING, &range::WAVE_SLOPE, &range::BEAM];
            let v = quantities("ship", text, &ranges)?;
            let frequency = std::f64::consts::TAU / v[0];
            let (beam, length) = (v[3], Hull::BEAMS * v[3]);
            hull = Hull { frequency, damping: v[1], slope: v[2], beam, length, ..hull };
        }
        if let Some(text) = &self.ship_length {
            hull.length = quantity("ship-length", text, &range::SHIP_LENGTH)?;
        }
        if let Some(text) = &self.roll_damping {
            let ranges = [&range::QUADRATIC_DAMPING, &range::CUBIC_DAMPING];
            let v = quantities("roll-damping", text, &ranges[..text.split(',').count().clamp(1, 2)])?;
            (hull.quadratic, hull.cubic) = (v[0], v.get(1).copied().unwrap_or(0.0));
        }
        Ok(hull)
    }
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum Against {
    Heading,
    Latitude,
    /// Significant wave height of the sea.
    Height,
}

/// Days that are simulated at most.
const MOST_DAYS: f64 = 1e4;

/// Step of the headings of a table, degrees.
pub const STEP: usize = 15;

#[derive(Args, Clone)]
pub struct RowOptions {
    /// What the rows of the table run over.
    #[arg(long, value_enum, default_value = "heading")]
    pub against: Against,
    /// Heading; may be given often; a bare number is in degrees.
    #[arg(long = "heading", allow_hyphen_values = true)]
    headings: Vec<String>,
    /// Step of the headings when none is given, degrees.
    #[arg(skip = STEP)]
    pub step: usize,
    /// Simulate this many days beside the formula, 2 to 10000.
    #[arg(long, value_name = "DAYS")]
    simulate: Option<String>,
    /// Seed of the simulation.
    #[arg(long, default_value_t = 1, requires = "simulate")]
    pub seed: u64,
}

impl RowOptions {
    /// Whether headings were given.
    pub fn has_headings(&self) -> bool {
        !self.headings.is_empty()
    }

    /// The days to simulate: two at least, since the interval comes from their scatter.
    pub fn days(&self) -> Result<Option<Days>> {
        let Some(text) = &self.simulate else { return Ok(None) };
        let value: Option<f64> = text.trim().parse().ok().filter(|v: &f64| v.is_finite() && v.fract() == 0.0);
        let Some(value) = value else {
            return Err(Error::usage(format!("--simulate takes a whole number of days, not `{text}`")));
        };
        if value < 2.0 {
            return Err(Error::usage("--simulate needs two days at least")
                .with_hint("each day is a replicate, and the 99 % interval comes from their scatter"));
        }
        if value > MOST_DAYS {
            return Err(Error::usage(format!("--simulate takes {MOST_DAYS} days at most, not {text}"))
                .with_hint(
                    "the interval falls as the root of the days: a hundred times as many for a tenth of it",
                ));
        }
        Ok(Some(Days { count: value as usize, seed: self.seed }))
    }

    /// Whether something was said.
    pub fn given(&self) -> bool {
        self.against != Against::Heading || !self.headings.is_empty() || self.simulate.is_some()
    }

    /// The headings, rad; without any the whole card.
    pub fn headings(&self) -> Result<Vec<f64>> {
        if self.headings.is_empty() {
            return Ok((0..360).step_by(self.step).map(|k| f64::from(k).to_radians()).collect());
        }
        self.headings.iter().map(|text| angle("heading", text, &range::HEADING)).collect()
    }

    /// What the rows run over; it is said in no other option.
    pub fn rows(&self, instrument: &InstrumentOptions, motion: &MotionOptions) -> Result<Rows> {
        let headings = self.headings()?;
        let refused = |says: &str| Err(Error::usage(says));
        match self.against {
            Against::Latitude if instrument.latitude.is_some() => {
                return refused("--against latitude runs over all latitudes; leave --latitude away");
            }
            Against::Height if motion.waves.height.is_some() => {
                return refused("--against height runs over all heights; leave --height away");
            }
            Against::Heading => return Ok(Rows::Heading(headings)),
            _ => {}
        }
        let heading = match headings[..] {
            [one] => one,
            _ if self.has_headings() => {
                return refused("--against latitude and --against height take one --heading");
            }
            _ => 45f64.to_radians(),
        };
        match self.against {
            Against::Height if !motion.is_sea() => Err(Error::usage("--against height needs a sea")
                .with_hint("say --sea pm, bretschneider or jonswap")),
            Against::Height => Ok(Rows::Height { heading }),
            _ => Ok(Rows::Latitude { heading }),
        }
    }
}
