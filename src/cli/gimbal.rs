//! `gyrospec gimbal`: the gyroscope in a rotating gimbal as a sensor of slow rates.

use super::quantity::quantity;
use super::{Outcome, input, output};
use crate::gyro::gimbal::{Demodulator, Gimbal, Noise, Run, Sample, State};
use crate::gyro::range;
use crate::model::{Number, Numbers};
use crate::report::json::object;
use crate::report::terminal::{Trace, picture};
use crate::units::figure;
use crate::{Error, Result};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Scale factor, band and noise of a gyroscope in a rotating gimbal, and its reading of a manoeuvre.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct GimbalCall {
    /// Parameters: a TOML file with [parameters], - is standard input; what it leaves out is a made example.
    parameters: Option<PathBuf>,
    /// Corner of the demodulator's low-pass, rad/s.
    #[arg(long, default_value = "2", allow_hyphen_values = true)]
    corner: String,
    /// One JSON object instead of text.
    #[arg(long)]
    json: bool,
}

const HELP: &str = "\
Names in [parameters], as { value = …, unit = \"…\" }: Ix1 … Iz3 (moments of inertia of bodies 1 to 3), H, Omega,
cx, cy (springs), dx, dy (damping), Qx, Qy (white torque noise, N^2*m^2*s), sigma, omega0, zeta (random base rates:
standard deviation, prevailing frequency, damping ratio).
Examples:
  gyrospec gimbal
  gyrospec gimbal --corner 5 --json";

/// What the file says.
struct Given {
    gimbal: Gimbal,
    noise: Noise,
}

/// Runs the subcommand.
pub fn run(call: &GimbalCall) -> Result<Outcome> {
    let given = read(call.parameters.as_deref())?;
    let corner = quantity("corner", &call.corner, &range::CORNER)?;
    // a corner that does not suit the gimbal
    Demodulator::new(&given.gimbal, corner).map_err(|e| e.about("--corner"))?;
    if !given.gimbal.damping.iter().any(|d| *d > 0.0) {
        return Err(Error::bad_input("without damping the gimbal swings on for ever and reads no rates")
            .with_hint("give dx or dy a positive value"));
    }
    if call.json { output::quoted(&json(&given, corner)?) } else { output::words(&text(&given, corner)?) }?;
    Ok(Outcome::Done)
}

fn read(path: Option<&Path>) -> Result<Given> {
    let mut given = Given {
        gimbal: Gimbal::example(),
        noise: Noise { torque: [1e-18, 1e-18], base: Some([1e-3, 10.0, 0.5]) },
    };
    let Some(path) = path else { return Ok(given) };
    let text = input::text(path)?;
    let file = Numbers::alone(&text).map_err(|e| e.with_file(path))?;
    for number in &file.list {
        put(&mut given, number).map_err(|e| number.place(e).with_file(path))?;
    }
    given.gimbal.check().map_err(|e| e.with_file(path))?;
    Ok(given)
}

fn put(given: &mut Given, number: &Number) -> Result<()> {
    let name = number.name.as_str();
    let names = || Gimbal::NAMES.into_iter().chain(Noise::NAMES);
    let place = match given.gimbal.named(name) {
        Some(place) => place,
        None => given.noise.named(name).ok_or_else(|| {
            let near = crate::error::nearest(&name.replace('_', ""), names());
            let near = near.map(|n| format!("did you mean {n}? ")).unwrap_or_default();
            Error::bad_input(format!("a gimbal has no parameter `{name}`"))
                .with_hint(format!("{near}it has {}", names().collect::<Vec<_>>().join(", ")))
        })?,
    };
    let (value, unit) = (number.value()?, number.unit.as_deref());
    let range = range::of_gimbal(name);
    *place = range.map_or(Ok(value), |r| r.read(value, unit)).map_err(|e| e.about(name))?;
    Ok(())
}

/// The largest rate of the manoeuvre, rad/s.
const LARGEST_RATE: f64 = 0.01;

/// Rates of the manoeuvre, rad/s and rad/s²: a smooth turn about one axis, then about the other.
fn manoeuvre(t: f64, unit: f64) -> ([f64; 2], [f64; 2]) {
    let bump = |from: f64| -> (f64, f64) {
        let x = (t - from) / (12.0 * unit);
        if !(0.0..=1.0).contains(&x) {
            return (0.0, 0.0);
        }
        let (sin, cos) = (std::f64::consts::PI * x).sin_cos();
        (sin * sin, 2.0 * sin * cos * std::f64::consts::PI / (12.0 * unit))
    };
    let ((a, da), (b, db)) = (bump(2.0 * unit), bump(10.0 * unit));
    ([LARGEST_RATE * a, -0.006 * b], [LARGEST_RATE * da, -0.006 * db])
}

/// The manoeuvre simulated: the true rates and those read, at the samples of α.
struct Shown {
    samples: Vec<Sample>,
    read: Vec<(f64, f64)>,
    unit: f64,
}

/// Steps of a picture: some tenths of a second, and 100 MB.
const DRAWN: f64 = 4e6;

/// The manoeuvre, or why it is not drawn.
fn simulated(given: &Given, corner: f64) -> Result<std::result::Result<Shown, String>> {
    let g = &given.gimbal;
    let fastest = g.free_frequencies().map_or(g.speed, |f| f[1].max(g.speed));
    let unit = 2.0 / corner;
    let run = Run { step: 0.1 / fastest, duration: 26.0 * unit, noise: given.noise.torque, seed: 1 };
    if run.steps() > DRAWN {
        return Ok(Err(format!(
            "No manoeuvre is drawn: one that is slow behind a corner of {} rad/s lasts {} s, and the gimbal's fastest \
             motion, at {} rad/s, would be followed in {} steps.\n",
            figure(corner),
            figure(run.duration),
            figure(fastest),
            figure(run.steps())
        )));
    }
    let samples = g.simulate(State::default(), &run, |t| manoeuvre(t, unit))?;
    let read = Demodulator::new(g, corner)?.rates(&samples);
    Ok(Ok(Shown { samples, read, unit }))
}

fn text(given: &Given, corner: f64) -> Result<String> {
    let g = &given.gimbal;
    let mut out = String::new();
    let [slow, fast] = g.free_frequencies().unwrap_or([f64::NAN; 2]);
    let a = g.scale_factor(0.0);
    let band = g.band();
    let noise = g.noise_equivalent(&given.noise, corner)?;
    let small = g.smallness(&given.noise, LARGEST_RATE)?;
    let springs: Vec<String> = g.tuned_springs().iter().map(|c| format!("{c:.4e}")).collect();
    let _ = writeln!(
        out,
        "Gyroscope in a gimbal that turns with Ω = {} rad/s\n\
         \x20 free frequencies              {slow:.3} and {fast:.3} rad/s (without damping)\n\
         \x20 springs for resonance at Ω    {} N·m/rad (c_x = c_y; a negative one is no spring); now {:.4e}, {:.4e}\n\
         \x20 scale factor                  {:.4e} rad of α at Ω for each rad/s, phase {:.2}°\n\
         \x20 band of slow rates            1 % to {:.3} rad/s, 3 dB to {:.3} rad/s (gimbal alone)\n\
         \x20 demodulator                   two low-passes at {corner} rad/s\n\
         \x20 noise-equivalent rate         {:.3e} rad/s by torque noise\n\
         \x20 random base motion reads      {:.3e} rad/s: {:.3e} where it is (slow rates, and the low-pass's skirt),\n\
         \x20                               {:.3e} folded from near 2Ω\n\
         {}",
        g.speed,
        springs.join(" or "),
        g.springs[0],
        g.springs[1],
        a.norm(),
        a.arg().to_degrees(),
        band.one_percent,
        band.three_decibel,
        noise.torque,
        noise.base,
        noise.base_passed,
        noise.base_folded,
        small
            .iter()
            .filter(|s| !s.holds())
            .map(|s| format!("BEYOND THE LINEAR THEORY: {}.\n", s.told()))
            .collect::<String>()
    );
    match simulated(given, corner)? {
        Ok(shown) => {
            for (name, axis) in [("Θ′", 0), ("Ψ′", 1)] {
                out.push_str(&drawn(&shown, name, axis));
            }
        }
        Err(why) => out.push_str(&why),
    }
    Ok(out)
}

fn drawn(s: &Shown, name: &str, axis: usize) -> String {
    let every = (s.samples.len() / 256).max(1);
    let mrad = |v: f64| 1e3 * v;
    let truth: Vec<f64> =
        s.samples.iter().step_by(every).map(|p| mrad(manoeuvre(p.time, s.unit).0[axis])).collect();
    let read: Vec<f64> =
        s.read.iter().step_by(every).map(|r| mrad(if axis == 0 { r.0 } else { r.1 })).collect();
    let end = format!("{:.1} s", s.samples.last().map_or(0.0, |p| p.time));
    format!(
        "{name}, mrad/s: · the base's rate, o read from α\n{}\n",
        picture(
            &[Trace { mark: '·', values: &truth }, Trace { mark: 'o', values: &read }],
            (64, 11),
            ("0 s", &end)
        )
    )
}

fn json(given: &Given, corner: f64) -> Result<String> {
    let g = &given.gimbal;
    let (a, band, noise) = (g.scale_factor(0.0), g.band(), g.noise_equivalent(&given.noise, corner)?);
    let value = serde_json::json!({
        "schema": "gyrospec.gimbal/1",
        "free_frequencies_rad_per_s": g.free_frequencies(),
        "tuned_springs_Nm_per_rad": g.tuned_springs(),
        "scale_factor": { "magnitude_s": a.norm(), "phase_deg": a.arg().to_degrees() },
        "band": { "one_percent_rad_per_s": band.one_percent, "three_decibel_rad_per_s": band.three_decibel },
        "demodulator_corner_rad_per_s": corner,
        "noise_equivalent_rate_rad_per_s": {
            "torque": noise.torque, "base": noise.base,
            "base_passed": noise.base_passed, "base_folded": noise.base_folded,
        },
        "validity": g.smallness(&given.noise, LARGEST_RATE)?.iter().map(|s| serde_json::json!({
            "figure": s.figure, "says": s.message, "value": s.value, "limit": s.limit, "unit": s.unit, "holds": s.holds(),
        })).collect::<Vec<_>>(),
    });
    object(&value)
}
