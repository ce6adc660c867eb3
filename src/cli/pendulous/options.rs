//! What the command line says of the compass, the ship, and the corrector.

use crate::cli::quantity::{angle, latitude, listed, quantities, quantity};
use crate::gyro::pendulous::{Corrector, PendulousCompass, Voyage};
use crate::gyro::{Manoeuvres, range};
use crate::{Error, Result};

/// Headings of a table without any, degrees apart.
const STEP: usize = 30;
/// As [`PendulousCompass::tuned`] shows it.
const COMMON: (&str, &str, &str) = ("15N*m*s", "0.03", "60s");

#[derive(clap::Args)]
pub struct Options {
    /// Latitude of the ship, in degrees or as 60°12'N.
    #[arg(long, allow_hyphen_values = true)]
    latitude: String,
    /// Speed of the ship; at rest if absent.
    #[arg(long, allow_hyphen_values = true)]
    speed: Option<String>,
    /// Heading; may be given often; a bare number is in degrees.
    #[arg(long = "heading", allow_hyphen_values = true)]
    headings: Vec<String>,
    /// What is set on the corrector: latitude and speed.
    #[arg(long, value_name = "LATITUDE,SPEED", allow_hyphen_values = true)]
    corrector: Option<String>,
    /// Random manoeuvres: standard deviation of the northward velocity, time in which it is forgotten.
    #[arg(long, value_name = "DEVIATION,TIME", allow_hyphen_values = true)]
    manoeuvres: Option<String>,
    /// Angular momentum H of the rotor.
    #[arg(long, default_value = COMMON.0, allow_hyphen_values = true)]
    momentum: String,
    /// Angle eps by which the ballistic's point of action stands aside.
    #[arg(long, default_value = COMMON.1, allow_hyphen_values = true)]
    offset: String,
    /// Lag of the liquid's flow.
    #[arg(long, default_value = COMMON.2, allow_hyphen_values = true)]
    flow: String,
    /// Moment B of the ballistic for a radian of tilt; without it the period is 84.4 min.
    #[arg(long, value_name = "MOMENT", allow_hyphen_values = true)]
    ballistic: Option<String>,
    /// Latitude at which the period is 84.4 min; the ship's if absent.
    #[arg(long, value_name = "LATITUDE", conflicts_with = "ballistic", allow_hyphen_values = true)]
    tuned_at: Option<String>,
}

impl Options {
    /// What is asked; an option that would be of no use is refused.
    pub fn voyage(&self) -> Result<Voyage> {
        let compass = self.compass()?;
        let speed = self.speed.as_ref().map(|t| quantity("speed", t, &range::SPEED)).transpose()?;
        let corrector = self.corrector()?;
        let moving = speed.unwrap_or(0.0) != 0.0 || corrector.is_some_and(|c| c.speed != 0.0);
        if !moving && !self.headings.is_empty() {
            return Err(Error::usage("--heading is of no use without --speed")
                .with_hint("at rest the error is the same on each heading"));
        }
        let read = |text: &String| angle("heading", text, &range::HEADING);
        let headings = match (self.headings.is_empty(), moving) {
            (false, _) => self.headings.iter().map(read).collect::<Result<_>>()?,
            (true, true) => (0..360).step_by(STEP).map(|k| f64::from(k).to_radians()).collect(),
            (true, false) => vec![0.0],
        };
        let manoeuvres = self.manoeuvres()?;
        Ok(Voyage { compass, speed: speed.unwrap_or(0.0), headings, corrector, manoeuvres })
    }

    fn compass(&self) -> Result<PendulousCompass> {
        let here = latitude("latitude", &self.latitude, &range::LATITUDE)?;
        let momentum = quantity("momentum", &self.momentum, &range::MOMENTUM)?;
        let offset = quantity("offset", &self.offset, &range::OFFSET)?;
        let flow = quantity("flow", &self.flow, &range::FLOW_LAG)?;
        let tuned = self.tuned_at.as_ref().map(|t| latitude("tuned-at", t, &range::LATITUDE)).transpose()?;
        let mut compass = PendulousCompass::tuned(momentum, offset, flow, tuned.unwrap_or(here));
        if let Some(text) = &self.ballistic {
            compass.ballistic = quantity("ballistic", text, &range::BALLISTIC)?;
        }
        compass.latitude = here;
        Ok(compass)
    }

    fn corrector(&self) -> Result<Option<Corrector>> {
        let Some(text) = &self.corrector else { return Ok(None) };
        let [there, speed] = listed("corrector", text)?;
        Ok(Some(Corrector {
            latitude: latitude("corrector", there, &range::LATITUDE)?,
            speed: quantity("corrector", speed, &range::SPEED)?,
        }))
    }

    fn manoeuvres(&self) -> Result<Option<Manoeuvres>> {
        let Some(text) = &self.manoeuvres else { return Ok(None) };
        let n = quantities("manoeuvres", text, &[&range::MANOEUVRE_SPEED, &range::MANOEUVRE_TIME])?;
        Ok(Some(Manoeuvres { deviation: n[0], time: n[1] }))
    }
}
