//! What the command line says of the vibration, the instruments and the place.

use crate::cli::quantity::{angle, latitude as latitude_of, quantities, quantity};
use crate::gyro::range::{self, Range};
use crate::gyro::strapdown::{
    Anisoelasticity, Anisoinertia, Disturbance, MountedRotor, Place, Shaken, System, TunedRotor, Vibration,
};
use crate::spectrum::Roll;
use crate::{Error, Result};
use std::f64::consts::TAU;

#[derive(clap::Args)]
pub struct Options {
    /// Angular vibration about an axis; once an axis.
    #[arg(long, value_name = "AXIS=DEVIATION[,PHASE[,FREQUENCY,DAMPING]]")]
    angular: Vec<String>,
    /// Linear vibration along an axis, an acceleration; once an axis.
    #[arg(long, value_name = "AXIS=DEVIATION[,PHASE[,FREQUENCY,DAMPING]]")]
    linear: Vec<String>,
    /// Resonance of the vibrations that give none of their own.
    #[arg(long, value_name = "FREQUENCY,DAMPING", allow_hyphen_values = true)]
    resonance: Option<String>,
    /// The part of each two vibrations that goes together, 0 to 1.
    #[arg(long, allow_hyphen_values = true)]
    coherence: Option<String>,
    /// A gyro with a float: input and spin axis (as xz), I_s - I_i, angular momentum.
    #[arg(long, value_name = "AXES,DIFFERENCE,MOMENTUM")]
    anisoinertia: Option<String>,
    /// A gyro with a float: input and spin axis, mass, angular momentum, frequencies along the two axes, damping ratio.
    #[arg(long, value_name = "AXES,MASS,MOMENTUM,FREQUENCY,FREQUENCY,DAMPING")]
    anisoelasticity: Option<String>,
    /// Accelerometers with a square term: k2 of a + k2*a^2 (1e-6 s^2/m is 9.8 ug/g^2).
    #[arg(long, value_name = "K2", allow_hyphen_values = true)]
    square: Option<String>,
    /// A dry-tuned rotor: spin axis, speed, C of the rotor, A + B - C of its gimbal, angle at twice its speed.
    #[arg(long, value_name = "AXIS,SPEED,INERTIA,GIMBAL,ANGLE")]
    tuned_rotor: Option<String>,
    /// Latitude of a heading found by gyrocompassing; a bare number is in degrees.
    #[arg(long, allow_hyphen_values = true)]
    latitude: Option<String>,
    /// Heading of the x axis; a bare number is in degrees; north if absent.
    #[arg(long, allow_hyphen_values = true)]
    heading: Option<String>,
    /// Angle random walk of the gyros.
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    walk: Option<String>,
    /// Loop that seeks north: undamped period, damping ratio.
    #[arg(long = "loop", value_name = "PERIOD,DAMPING", allow_hyphen_values = true)]
    seeking: Option<String>,
    /// Time of averaging on a base at rest.
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    align: Option<String>,
    /// Irregular roll of the ship that carries the loop: standard deviation, decay mu, frequency eps.
    #[arg(long, value_name = "SIGMA,MU,EPS", allow_hyphen_values = true)]
    irregular: Option<String>,
    /// Height of the loop above the roll axis.
    #[arg(long, allow_hyphen_values = true)]
    lever: Option<String>,
}

/// An axis by its letter.
fn axis(option: &str, text: &str) -> Result<usize> {
    ["x", "y", "z"]
        .iter()
        .position(|a| *a == text.trim())
        .ok_or_else(|| Error::usage(format!("--{option}: `{}` is no axis; axes are x, y and z", text.trim())))
}

/// A list whose first item is its axes, one letter each, and the numbers behind it.
fn led<'a>(option: &str, text: &'a str, letters: usize) -> Result<(Vec<usize>, &'a str)> {
    let (head, rest) = text.split_once(',').unwrap_or((text, ""));
    let names: Vec<String> = head.trim().chars().map(String::from).collect();
    if names.len() != letters {
        let wanted = if letters == 1 { "an axis, x, y or z" } else { "input and spin axis, such as xz" };
        return Err(Error::usage(format!("--{option}: `{}` where {wanted}, is meant", head.trim())));
    }
    let axes = names.iter().map(|n| axis(option, n)).collect::<Result<Vec<_>>>()?;
    if letters == 2 && axes[0] == axes[1] {
        return Err(Error::usage(format!("--{option}: input and spin axis are one, {}", head.trim())));
    }
    Ok((axes, rest))
}

fn refused(wrong: bool, says: &str, hint: &str) -> Result<()> {
    if wrong { Err(Error::usage(says).with_hint(hint)) } else { Ok(()) }
}

impl Options {
    /// What is asked; an option that would be of no use is refused.
    pub fn system(&self) -> Result<System> {
        let system = System {
            shaken: self.shaken()?,
            anisoinertia: self.inertia()?,
            anisoelasticity: self.suspension()?,
            square: self.square.as_ref().map(|t| quantity("square", t, &range::SQUARE_TERM)).transpose()?,
            rotor: self.rotor()?,
            place: self.place()?,
            disturbance: self.disturbance()?,
        };
        Self::vibrations_serve(&system)?;
        self.place_serves(&system)?;
        Ok(system)
    }

    fn shaken(&self) -> Result<Shaken> {
        let resonance =
            self.resonance.as_ref().map(|t| quantities("resonance", t, &RESONANCE)).transpose()?;
        let mut taken = false;
        let mut axes = |option: &str, list: &[String], deviation: &'static Range| {
            let mut found = [None; 3];
            for text in list {
                let (at, numbers, own) = vibration(option, text, deviation)?;
                let shared = || resonance.clone().ok_or_else(|| lone(option, text));
                let [frequency, damping] =
                    if own { [numbers[2], numbers[3]] } else { [shared()?[0], shared()?[1]] };
                taken |= !own;
                let phase = numbers.get(1).copied().unwrap_or(0.0);
                let said = Vibration { deviation: numbers[0], phase, frequency: TAU * frequency, damping };
                let before: Option<Vibration> = found[at].replace(said);
                refused(before.is_some(), &format!("--{option} comes twice for one axis"), "one an axis")?;
            }
            Ok::<_, Error>(found)
        };
        let angular = axes("angular", &self.angular, &range::SHAKEN_ANGLE)?;
        let linear = axes("linear", &self.linear, &range::SHAKEN_ACCELERATION)?;
        let idle = resonance.is_some() && !taken;
        refused(
            idle,
            "--resonance is of no use here",
            "it is that of vibrations that give none of their own",
        )?;
        let coherence =
            self.coherence.as_ref().map(|t| quantity("coherence", t, &range::COHERENCE)).transpose()?;
        let few = coherence.is_some() && angular.iter().chain(&linear).flatten().count() < 2;
        refused(few, "--coherence is of no use here", "it is that of two vibrations")?;
        Ok(Shaken { angular, linear, coherence: coherence.unwrap_or(1.0) })
    }

    fn inertia(&self) -> Result<Option<Anisoinertia>> {
        let Some(text) = &self.anisoinertia else { return Ok(None) };
        let (axes, rest) = led("anisoinertia", text, 2)?;
        let n = quantities("anisoinertia", rest, &[&range::INERTIA_DIFFERENCE, &range::GYRO_MOMENTUM])?;
        Ok(Some(Anisoinertia { axes: [axes[0], axes[1]], difference: n[0], momentum: n[1] }))
    }

    fn suspension(&self) -> Result<Option<Anisoelasticity>> {
        let Some(text) = &self.anisoelasticity else { return Ok(None) };
        let (axes, rest) = led("anisoelasticity", text, 2)?;
        let f = &range::VIBRATION_FREQUENCY;
        let ranges = [&range::FLOAT_MASS, &range::GYRO_MOMENTUM, f, f, &range::VIBRATION_DAMPING];
        let n = quantities("anisoelasticity", rest, &ranges)?;
        let frequencies = [TAU * n[2], TAU * n[3]];
        let (mass, momentum, damping) = (n[0], n[1], n[4]);
        Ok(Some(Anisoelasticity { axes: [axes[0], axes[1]], mass, momentum, frequencies, damping }))
    }

    fn rotor(&self) -> Result<Option<MountedRotor>> {
        let Some(text) = &self.tuned_rotor else { return Ok(None) };
        let (axes, rest) = led("tuned-rotor", text, 1)?;
        let (inertia, angle) = (&range::ROTOR_INERTIA, &range::SHAKEN_ANGLE);
        let n = quantities("tuned-rotor", rest, &[&range::ROTOR_SPEED, inertia, inertia, angle])?;
        let rotor = TunedRotor { speed: n[0], spin_inertia: n[1], gimbal_inertia: n[2] };
        refused(
            n[2] > 0.5 * n[1],
            "--tuned-rotor: the gimbal is not small beside the rotor",
            "INERTIA,GIMBAL",
        )?;
        Ok(Some(MountedRotor { rotor, spin: axes[0], amplitude: n[3] }))
    }

    fn place(&self) -> Result<Option<Place>> {
        let Some(latitude) = &self.latitude else {
            refused(
                self.heading.is_some(),
                "--heading is of no use without --latitude",
                "give --latitude too",
            )?;
            return Ok(None);
        };
        let heading = self.heading.as_ref().map(|t| angle("heading", t, &range::HEADING)).transpose()?;
        let latitude = latitude_of("latitude", latitude, &range::LATITUDE)?;
        Ok(Some(Place { latitude, heading: heading.unwrap_or(0.0) }))
    }

    fn disturbance(&self) -> Result<Disturbance> {
        let one = |name: &str, text: &Option<String>, range: &Range| {
            text.as_ref().map(|t| quantity(name, t, range)).transpose()
        };
        let walk = one("walk", &self.walk, &range::WALK)?;
        let align = one("align", &self.align, &range::AVERAGING)?;
        let lever = one("lever", &self.lever, &range::LEVER)?;
        let seeking = self
            .seeking
            .as_ref()
            .map(|t| quantities("loop", t, &[&range::LOOP_PERIOD, &range::LOOP_DAMPING]));
        let seeking = seeking.transpose()?.map(|n| [TAU / n[0], n[1]]);
        let roll = [&range::ROLL_DEVIATION, &range::ROLL_DECAY, &range::ROLL_FREQUENCY];
        let roll = self.irregular.as_ref().map(|t| quantities("irregular", t, &roll)).transpose()?;
        let sea = match (roll, lever) {
            (Some(n), Some(lever)) => Some((Roll::new(n[0] * n[0], n[1], n[2])?, lever)),
            (None, None) => None,
            _ => return Err(Error::usage("--irregular and --lever go together")),
        };
        let found = Disturbance { walk, seeking, sea, align };
        let heads = [
            (walk.is_some() && seeking.is_none() && align.is_none(), "--walk", "--loop or --align"),
            (seeking.is_some() && walk.is_none() && sea.is_none(), "--loop", "--walk or --irregular"),
            (align.is_some() && walk.is_none(), "--align", "--walk"),
            (sea.is_some() && seeking.is_none(), "--irregular", "--loop"),
            (sea.is_some() && self.heading.is_none(), "--irregular", "--heading"),
            (walk.or(sea.map(|s| s.1)).is_some() && self.latitude.is_none(), "a spread", "--latitude"),
        ];
        for (wrong, what, wanted) in heads {
            refused(wrong, &format!("{what} says nothing without {wanted}"), &format!("give {wanted} too"))?;
        }
        Ok(found)
    }

    /// Every vibration leaves something in a mean, and every instrument meets one.
    fn vibrations_serve(system: &System) -> Result<()> {
        let (angular, linear) = (&system.shaken.angular, &system.shaken.linear);
        let moving = |axes: &[Option<Vibration>; 3]| axes.iter().flatten().count();
        let (angles, accelerations) = (moving(angular), moving(linear));
        let across = |m: &MountedRotor| angular.iter().enumerate().any(|(i, v)| i != m.spin && v.is_some());
        let folded = system.rotor.as_ref().is_some_and(across);
        let still = |axes: [usize; 2], of: &[Option<Vibration>; 3]| axes.iter().any(|a| of[*a].is_none());
        refused(
            system.anisoinertia.is_some_and(|f| still(f.axes, angular)),
            "--anisoinertia needs --angular about its input and its spin axis",
            "a product of two rates pushes the float",
        )?;
        refused(
            system.anisoelasticity.is_some_and(|f| still(f.axes, linear)),
            "--anisoelasticity needs --linear along its input and its spin axis",
            "a product of two accelerations pushes the float",
        )?;
        refused(system.square.is_some() && accelerations == 0, "--square needs --linear", "it takes ⟨a²⟩")?;
        refused(
            angles == 1 && accelerations == 0 && !folded,
            "one --angular alone leaves nothing in the mean",
            "give another --angular for coning, or --linear for sculling",
        )?;
        refused(
            accelerations > 0 && angles == 0 && system.square.is_none() && system.anisoelasticity.is_none(),
            "--linear alone leaves nothing in the mean",
            "give --angular for sculling, or --square or --anisoelasticity",
        )
    }

    /// Something is asked, and a place serves it.
    fn place_serves(&self, system: &System) -> Result<()> {
        let shaken = system.shaken.angular.iter().chain(&system.shaken.linear).any(Option::is_some);
        let spread = system.disturbance != Disturbance::default();
        refused(
            !shaken && !spread && system.rotor.is_none(),
            "nothing is asked",
            "give --angular and --linear, --tuned-rotor, or --walk; `gyrospec strapdown --help` has examples",
        )?;
        refused(
            self.heading.is_some() && !shaken && system.disturbance.sea.is_none(),
            "--heading is of no use here",
            "neither the random walk nor a tuned rotor asks for it",
        )
    }
}

const RESONANCE: [&Range; 2] = [&range::VIBRATION_FREQUENCY, &range::VIBRATION_DAMPING];

fn lone(option: &str, text: &str) -> Error {
    Error::usage(format!("--{option} {text}: at which frequency, and how damped?"))
        .with_hint("give --resonance FREQUENCY,DAMPING, or both behind the phase")
}

/// Axis, numbers, and whether the resonance is its own, of AXIS=DEVIATION[,PHASE[,FREQUENCY,DAMPING]].
fn vibration(option: &str, text: &str, deviation: &'static Range) -> Result<(usize, Vec<f64>, bool)> {
    let form =
        || Error::usage(format!("--{option} takes AXIS=DEVIATION[,PHASE[,FREQUENCY,DAMPING]], not `{text}`"));
    let (name, rest) = text.split_once('=').ok_or_else(form)?;
    let at = axis(option, name)?;
    let parts: Vec<&str> = rest.split(',').collect();
    if !matches!(parts.len(), 1 | 2 | 4) {
        return Err(form());
    }
    let mut numbers = vec![quantity(option, parts[0], deviation)?];
    if let Some(phase) = parts.get(1) {
        numbers.push(angle(option, phase, &range::PHASE)?);
    }
    for (part, range) in parts.iter().skip(2).zip(RESONANCE) {
        numbers.push(quantity(option, part, range)?);
    }
    Ok((at, numbers, parts.len() == 4))
}
