//! What the command line says of the instrument, the motion and the rows wanted.

use super::described::{Described, rational_sea, regular};
use super::parameters::Part;
use crate::cli::quantity::{angle, quantities, quantity};
use crate::gyro::elastic::{Backlash, Compliance, Elastic, Friction, Inertia, Lag, Relaxing};
use crate::gyro::range::{self, Range};
use crate::gyro::{Axis, Motion};
use crate::lti::TransferFunction;
use crate::spectrum::{Hull, Roll, Sea};
use crate::{Error, Result};
use clap::{Args, ValueEnum};

#[derive(Args)]
pub struct InstrumentOptions {
    /// The elastic part with its inertia, (2.2) in place of (2.3).
    #[arg(long, group = "part")]
    inertia: bool,
    /// A second relaxing part, liquid flow: its time and its give as a part of the spring's.
    #[arg(long, group = "part", value_name = "TIME,SHARE", allow_hyphen_values = true)]
    flow: Option<String>,
    /// Compliance along the meridian too: stiffness and time.
    #[arg(long, group = "part", value_name = "STIFFNESS,TIME")]
    meridian: Option<String>,
    /// Compliance along the vertical: stiffness and time; it changes the spread alone, not the mean.
    #[arg(long, conflicts_with_all = ["inertia", "flow", "friction", "free_play"], value_name = "STIFFNESS,TIME")]
    vertical: Option<String>,
    /// Dry friction in the suspension: its errors are simulated.
    #[arg(long, group = "part", value_name = "FORCE", allow_hyphen_values = true)]
    friction: Option<String>,
    /// Free play (half-width) in the suspension: its errors are simulated.
    #[arg(long, group = "part", value_name = "GAP", allow_hyphen_values = true)]
    free_play: Option<String>,
    /// Latitude; a bare number is in degrees; less than 90, and the error grows as 1/cos towards the pole.
    #[arg(long, allow_hyphen_values = true)]
    pub latitude: Option<String>,
    /// Height of the compass above the roll axis.
    #[arg(long, allow_hyphen_values = true)]
    pub lever: Option<String>,
    /// Speed of the ship over the ground.
    #[arg(long, allow_hyphen_values = true)]
    pub speed: Option<String>,
}

impl InstrumentOptions {
    /// Whether nothing was said.
    pub fn plain(&self) -> bool {
        self.is_lag() && self.latitude.is_none() && self.lever.is_none() && self.speed.is_none()
    }

    /// Whether a part is asked for that moves no mean.
    pub fn has_idle(&self) -> bool {
        self.vertical.is_some()
    }

    /// Whether the part is the paper's lag.
    pub fn is_lag(&self) -> bool {
        !self.inertia
            && [&self.flow, &self.meridian, &self.vertical, &self.friction, &self.free_play]
                .iter()
                .all(|o| o.is_none())
    }

    /// The kind of part asked for; `None` when nothing was said.
    pub fn kind(&self) -> Result<Option<Part>> {
        Ok(match &self.flow {
            _ if self.is_lag() => None,
            _ if self.inertia => Some(Part::Inertia),
            Some(text) => {
                let v = quantities("flow", text, &[&range::RELAXATION, &range::SHARE])?;
                Some(Part::Flow(Relaxing { time: v[0], share: v[1] }))
            }
            None => Some(Part::Other),
        })
    }

    /// The elastic part asked for.
    pub fn part(&self) -> Result<Box<dyn Elastic>> {
        let pair = |name: &str, text: &Option<String>| -> Result<Option<(f64, f64)>> {
            let Some(text) = text else { return Ok(None) };
            quantities(name, text, &[&range::STIFFNESS, &range::RELAXATION]).map(|v| Some((v[0], v[1])))
        };
        if self.meridian.is_some() || self.vertical.is_some() {
            let meridian = pair("meridian", &self.meridian)?;
            return Ok(Box::new(Compliance { meridian, vertical: pair("vertical", &self.vertical)? }));
        }
        if let Some(text) = &self.friction {
            return Ok(Box::new(Friction { force: quantity("friction", text, &range::FRICTION)? }));
        }
        if let Some(text) = &self.free_play {
            return Ok(Box::new(Backlash { gap: quantity("free-play", text, &range::FREE_PLAY)? }));
        }
        Ok(match self.kind()? {
            Some(Part::Flow(relaxing)) => Box::new(relaxing),
            Some(Part::Inertia) => Box::new(Inertia),
            _ => Box::new(Lag),
        })
    }
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum SeaKind {
    /// Pierson-Moskowitz: fully grown, by its height alone.
    Pm,
    Bretschneider,
    Jonswap,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum Also {
    Pitch,
    Heave,
}

#[derive(Args)]
pub struct MotionOptions {
    /// Irregular roll of the paper's form: standard deviation, decay mu, frequency eps.
    #[arg(long, value_name = "SIGMA,MU,EPS", group = "motion")]
    irregular: Option<String>,
    /// Regular roll: amplitude, frequency.
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
    /// Other motions in the same sea; heave changes the spread alone, not the mean.
    #[arg(long, requires = "sea", value_enum, value_delimiter = ',')]
    also: Vec<Also>,
}

impl MotionOptions {
    /// Whether the motion is irregular roll of the form (3.3), as A, μ, ε say.
    pub fn irregular_roll(&self, default: &Roll) -> Result<Option<Roll>> {
        if self.sea.is_some() || self.regular.is_some() {
            return Ok(None);
        }
        let Some(text) = &self.irregular else { return Ok(Some(*default)) };
        let ranges = [&range::ROLL_DEVIATION, &range::ROLL_DECAY, &range::ROLL_FREQUENCY];
        let v = quantities("irregular", text, &ranges)?;
        Roll::new(v[0] * v[0], v[1], v[2]).map(Some)
    }

    /// Whether a motion was asked for.
    pub fn given(&self) -> bool {
        self.irregular.is_some() || self.regular.is_some() || self.sea.is_some() || self.band.is_some()
    }

    /// Whether the motion is a sea.
    pub fn is_sea(&self) -> bool {
        self.sea.is_some()
    }

    /// Whether the motion is regular roll.
    pub fn is_regular(&self) -> bool {
        self.regular.is_some()
    }

    /// Whether the sea's height is said.
    pub fn has_height(&self) -> bool {
        self.waves.height.is_some()
    }

    /// Whether a motion is asked for that moves no mean.
    pub fn has_idle(&self) -> bool {
        self.waves.also.contains(&Also::Heave)
    }

    /// Whether the waves run along the ship as well, rad.
    pub fn along(&self) -> Result<bool> {
        Ok(self.is_sea() && Hull::slopes(self.waves.from()?).1 != 0.0)
    }

    /// The motion asked for; in a sea of significant height `height` if given.
    pub fn motion(&self, default: &Roll, height: Option<f64>) -> Result<Described> {
        let described = match (self.sea, &self.regular) {
            (Some(kind), _) => self.in_sea(kind, height)?,
            (None, Some(text)) => regular(text)?,
            (None, None) => self.irregular(default)?,
        };
        match &self.band {
            Some(text) => described.banded(quantity("band", text, &range::BAND)?),
            None => Ok(described),
        }
    }

    fn irregular(&self, default: &Roll) -> Result<Described> {
        let roll = self.irregular_roll(default)?.unwrap_or(*default);
        let says = format!(
            "irregular roll, standard deviation {:.2}°, μ = {} 1/s, ε = {} rad/s",
            roll.variance.sqrt().to_degrees(),
            roll.decay,
            roll.frequency
        );
        Ok(Described::new(Motion::roll(&roll), says))
    }

    fn in_sea(&self, kind: SeaKind, height: Option<f64>) -> Result<Described> {
        let sea = self.waves.sea(kind, height)?;
        let fit = rational_sea(&sea)?;
        let (motion, bearing) = (Motion::in_sea(&fit.shaping, &self.waves.responses()?)?, self.waves.from()?);
        let says = |size: &str| {
            format!(
                "{} sea from {:03.0}° off the bow, {size}; rational spectrum within {:.1} % (its slope's power within {:.1} %)",
                ["Pierson-Moskowitz", "Bretschneider", "JONSWAP"][kind as usize],
                bearing.to_degrees(),
                100.0 * fit.error,
                100.0 * fit.power_error.abs()
            )
        };
        let period = format!("peak period {:.1} s", std::f64::consts::TAU / sea.peak());
        let own = says(&format!("significant height {:.2} m, {period}", sea.height()));
        let any = says(&match kind {
            SeaKind::Pm => {
                "of each significant height in turn, with the peak period that goes with it".into()
            }
            _ => format!("of each significant height in turn, {period}"),
        });
        Ok(Described { sea: Some(sea), of_all: Some(any), ..Described::new(motion, own) })
    }
}

impl SeaOptions {
    /// The bearing, rad.
    fn from(&self) -> Result<f64> {
        let from = self.sea_from.as_deref().map(|t| angle("sea-from", t, &range::SEA_FROM)).transpose()?;
        Ok(from.unwrap_or(std::f64::consts::FRAC_PI_2))
    }

    /// The sea; of significant height `height` if given.
    fn sea(&self, kind: SeaKind, height: Option<f64>) -> Result<Sea> {
        let read = |name, text: &Option<String>, range: &Range| {
            text.as_deref().map(|t| quantity(name, t, range)).transpose()
        };
        let asked = read("height", &self.height, &range::WAVE_HEIGHT)?;
        let height = height.or(asked).unwrap_or(3.0);
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
        let Some(text) = &self.ship else { return Ok(Hull::default()) };
        let ranges = [&range::ROLL_PERIOD, &range::ROLL_DAMPING, &range::WAVE_SLOPE, &range::BEAM];
        let v = quantities("ship", text, &ranges)?;
        Ok(Hull { frequency: std::f64::consts::TAU / v[0], damping: v[1], slope: v[2], beam: v[3] })
    }

    fn responses(&self) -> Result<Vec<(Axis, TransferFunction)>> {
        let (hull, from) = (self.hull()?, self.from()?);
        let (athwart, along) = Hull::slopes(from);
        let pitches = self.also.contains(&Also::Pitch);
        if pitches && along == 0.0 {
            return Err(Error::usage("a sea from abeam has no slope along the ship: nothing excites pitch")
                .with_hint("say where it comes from, as --sea-from 60deg (0 is ahead, 90 abeam), or leave pitch away"));
        }
        if !pitches && athwart == 0.0 {
            return Err(Error::usage(
                "a sea from ahead or astern has no slope athwart: nothing excites roll",
            )
            .with_hint("say --also pitch, or another --sea-from"));
        }
        let mut all = Vec::new();
        if athwart != 0.0 {
            all.push((Axis::Roll, hull.roll_response(from)?));
        }
        for also in &self.also {
            all.push(match also {
                Also::Pitch => (Axis::Pitch, hull.pitch_response(from)?),
                Also::Heave => (Axis::Heave, hull.heave_response(from)?),
            });
        }
        Ok(all)
    }
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum Against {
    Heading,
    Latitude,
    /// Significant wave height of the sea.
    Height,
}

#[derive(Args, Clone)]
pub struct RowOptions {
    /// What the rows of the table run over.
    #[arg(long, value_enum, default_value = "heading")]
    pub against: Against,
    /// Heading; may be given often; a bare number is in degrees.
    #[arg(long = "heading", allow_hyphen_values = true)]
    headings: Vec<String>,
    /// Step of the headings when none is given, degrees.
    #[arg(skip = 15usize)]
    pub step: usize,
    /// Simulate this many days beside the formula, two at least.
    #[arg(long, value_name = "DAYS")]
    simulate: Option<usize>,
    /// Seed of the simulation.
    #[arg(long, default_value_t = 1, requires = "simulate")]
    pub seed: u64,
}

impl RowOptions {
    /// Whether headings were given.
    pub fn has_headings(&self) -> bool {
        !self.headings.is_empty()
    }

    /// The number of days to simulate: two at least, since the interval comes from their scatter.
    pub fn days(&self) -> Result<Option<usize>> {
        match self.simulate {
            Some(0 | 1) => Err(Error::usage("--simulate needs two days at least")
                .with_hint("each day is a replicate, and the 99 % interval comes from their scatter")),
            days => Ok(days),
        }
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
}
