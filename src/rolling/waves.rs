//! # Purpose
//! The motions of a ship in a sea, from white noises through rational filters.
//!
//! # Method
//! All motions follow from the two slopes that she meets, athwart and along. Turned to the axes on which the two are
//! uncorrelated over all, each slope is white noise behind a filter of its own (one alone, where the crests are long);
//! roll is the slope athwart behind her resonance, pitch the slope along, and s² of sway and surge are g times the
//! slopes. Heave, which moves no mean, is the noise of the larger slope behind a filter of its own.
//!
//! # References
//! The shaping filter: H. W. Bode, C. E. Shannon, Proc. IRE 38 (1950) 417–425; the motions: see
//! [`Hull`].
//!
//! # Numerical aspects
//! The filters are fitted where the ship answers, by the power that each frequency brings to the acceleration of a
//! compass. What they miss, and the correlation that is left between the axes at single frequencies, is in the noises'
//! true spectral matrix, which stands beside the motion.

use crate::gyro::{Axis, Motion, NoiseDensity, range};
use crate::lti::{StateSpace, TransferFunction};
use crate::spectrum::{Encounter, GRAVITY, Hull, RationalFit, Sea, Search, Shape, SlopeSpectrum, fit_shapes};
use crate::{Error, Result};
use faer::Mat;
use num_complex::Complex64;
use std::sync::Arc;

/// A sea and the ship in it.
#[derive(Debug, Clone)]
pub struct Waves {
    /// The sea.
    pub sea: Sea,
    /// The bearing from which it comes, rad, clockwise off the bow: 0 ahead, π/2 from abeam to starboard.
    pub from: f64,
    /// Speed of the ship through the waves, m/s.
    pub speed: f64,
    /// n, where the waves come from many directions: cosⁿ about the main one. `None` for long crests.
    pub spread: Option<f64>,
    /// The ship.
    pub hull: Hull,
    /// Motions beside roll: pitch, heave, sway, surge, yaw.
    pub also: Vec<Axis>,
}

/// What becomes of a sea.
#[derive(Debug, Clone)]
pub struct SeaMotion {
    /// ∫|S_fit − S| w dω / ∫ S w dω of the slopes, w the power that each frequency brings.
    pub error: f64,
    /// The damping ratio of her roll in this sea.
    pub damping: f64,
    /// The standard deviation of her rate of roll, rad/s.
    pub roll_rate: f64,
    /// The filter that makes her roll of white noise, where it is one alone.
    pub roll: Option<TransferFunction>,
    /// The true spectral matrix of the noises behind the motion.
    pub noise: Arc<[NoiseDensity]>,
    /// The same where the waves are averaged over a rectangle with its zeros.
    pub rectangle: Arc<[NoiseDensity]>,
}

/// Sections and zeros of the filters that are tried.
const SHAPES: [Shape; 3] = [(3, 3), (4, 4), (5, 6)];
/// The same where waves keep pace with the ship.
const SLOW_SHAPES: [Shape; 6] = [(3, 3), (3, 1), (4, 4), (4, 1), (5, 5), (5, 2)];
/// Squared error of the amplitude, a part of the power, that needs no further section: 0.3 % of the amplitude.
const ENOUGH: f64 = 1e-5;
/// Where their sections start: close to each other, as the peaks of seas are narrow.
const STARTS: [(f64, f64); 2] = [(0.1, 0.15), (0.2, 0.15)];
/// The same where waves keep pace with the ship: also far from each other.
const SLOW_STARTS: [(f64, f64); 4] = [(0.1, 0.15), (0.2, 0.15), (0.15, 0.3), (0.4, 0.3)];
/// Bins of the spectrum that is fitted, and of the true one, with the part of the slope's rate that they hold.
const FITTED: (usize, f64) = (300, 0.9995);
const TRUE: (usize, f64) = (3000, 0.999_999);
/// Misfit from which on there is no answer.
const FARTHEST: f64 = 0.2;
/// Part of the highest density from which on waves that are met at hardly any frequency count.
const KEEPS_PACE: f64 = 1e-3;
/// Part of the power below which there is no second slope.
const NO_SLOPE: f64 = 1e-9;

/// A slope with a noise of its own: its direction (athwart, along) and its filter.
struct Source {
    axis: [f64; 2],
    fit: RationalFit,
    power: f64,
}

impl Waves {
    /// The parts of its slope athwart and along the ship.
    pub fn slopes(&self) -> (f64, f64) {
        Hull::slopes(self.from)
    }

    /// Whether the waves meet the ship at another frequency than their own.
    pub fn is_shifted(&self) -> bool {
        self.speed != 0.0 && (self.slopes().1 != 0.0 || self.spread.is_some())
    }

    fn moves(&self, axis: Axis) -> bool {
        self.also.contains(&axis)
    }

    /// The axes that move: roll, where a slope is athwart, and what was asked for beside it.
    fn axes(&self) -> Result<Vec<Axis>> {
        let (athwart, along) = self.slopes();
        let [across, ahead] = [athwart, along].map(|x| x != 0.0 || self.spread.is_some());
        for axis in &self.also {
            let says = match axis {
                Axis::Roll => "roll is in every sea; the others stand beside it",
                Axis::Pitch | Axis::Surge if !ahead => "a sea from there has no slope along the ship",
                Axis::Sway if !across => "a sea from there has no slope athwart",
                Axis::Yaw if self.spread.is_some() => "yaw is that of a sea whose crests are long",
                Axis::Yaw if !(across && ahead) => "a sea from there turns no ship",
                _ => continue,
            };
            return Err(Error::bad_input(says));
        }
        let all: Vec<Axis> =
            across.then_some(Axis::Roll).into_iter().chain(self.also.iter().copied()).collect();
        if all.is_empty() { Err(Error::bad_input("a sea from there excites nothing")) } else { Ok(all) }
    }

    /// The motion, and what became of the sea.
    pub(super) fn motion(&self) -> Result<(Motion, SeaMotion)> {
        range::SEA_FROM.check(self.from)?;
        range::SPEED.check(self.speed)?;
        let axes = self.axes()?;
        let met = Encounter { sea: self.sea, from: self.from, speed: self.speed, spread: self.spread };
        let [binned, whole] = [FITTED, TRUE].map(|(bins, part)| met.slopes(&self.hull, bins, part));
        let (binned, whole) = (binned?, whole?);
        let (damping, roll_rate) = self.hull.equivalent_damping(&whole);
        let slow = binned.at_rest() > KEEPS_PACE;
        if slow && (self.moves(Axis::Sway) || self.moves(Axis::Surge)) {
            return Err(Error::bad_input(
                "some of these waves keep pace with the ship, and her sway and surge in them have no bound",
            )
            .with_hint("leave sway and surge away, or take another speed or direction"));
        }
        let search = if slow {
            Search { shapes: &SLOW_SHAPES, starts: &SLOW_STARTS, enough: ENOUGH }
        } else {
            Search { shapes: &SHAPES, starts: &STARTS, enough: ENOUGH }
        };
        let resonance = self.hull.resonance(damping)?;
        let sources = self.sources(&binned, &resonance, &search)?;
        let heave = self.moves(Axis::Heave).then(|| fitted_heave(&binned, &search)).transpose()?;
        let motion = self.driven(&axes, &sources, heave.as_ref(), &resonance)?;
        let whole_power: f64 = sources.iter().map(|s| s.power).sum();
        let error = sources.iter().map(|s| s.fit.error * s.power).sum::<f64>() / whole_power;
        if error > FARTHEST {
            return Err(Error::not_computed(format!(
                "no rational spectrum comes near the one that the ship meets: {:.0} % of its power are missed",
                100.0 * error
            ))
            .with_hint("in long crests from astern too many waves are met at one frequency: say --spread, or another speed or direction"));
        }
        let rectangle = met.slopes_of_rectangle(&self.hull, TRUE.0, TRUE.1)?;
        let [noise, rectangle] =
            [&whole, &rectangle].map(|met| noise(met, &sources, (self.hull.frequency, damping)));
        let one = |s: &Source| s.fit.shaping.scaled(s.axis[0]).then(&resonance);
        let roll = sources.first().filter(|_| sources.len() == 1 && axes[0] == Axis::Roll).map(one);
        Ok((motion, SeaMotion { error, damping, roll_rate, roll, noise, rectangle }))
    }

    /// What a slope in a direction brings to the acceleration of a compass some 10 m from the axis of roll, s⁻⁴: and a
    /// tenth of its own wherever the ship does not answer.
    fn weight(&self, [athwart, along]: [f64; 2], resonance: &TransferFunction, w: f64) -> f64 {
        let [a2, l2] = [athwart * athwart, along * along];
        let on = |axis| f64::from(u8::from(self.moves(axis)));
        let turned = a2 * resonance.power(w) + l2 * on(Axis::Pitch) + 0.1;
        // g/10 m ≈ 1 s⁻²
        w.powi(4) * turned + a2 * on(Axis::Sway) + l2 * on(Axis::Surge)
    }

    fn sources(
        &self,
        met: &SlopeSpectrum,
        resonance: &TransferFunction,
        search: &Search<'_>,
    ) -> Result<Vec<Source>> {
        let along_or_athwart = |w: f64| self.weight([1.0, 1.0], resonance, w);
        let omega: Vec<f64> = (0..met.bins.len()).map(|k| met.omega(k)).collect();
        let mut sources: Vec<Source> = Vec::new();
        let (athwart, along) = self.slopes();
        for [a, l] in met.axes(along_or_athwart) {
            // along the travel of the waves, as heave is told
            let axis = if a * athwart + l * along < 0.0 { [-a, -l] } else { [a, l] };
            let density: Vec<f64> = (0..omega.len()).map(|k| met.cross(k, axis, axis).max(0.0)).collect();
            let weight: Vec<f64> = omega.iter().map(|w| self.weight(axis, resonance, *w)).collect();
            let power: f64 = density.iter().zip(&weight).map(|(s, w)| s * w).sum();
            if sources.first().is_none_or(|first| power > NO_SLOPE * first.power) {
                let fit = fit_shapes((&omega, &density, &weight), search)?;
                sources.push(Source { axis, fit, power });
            }
        }
        Ok(sources)
    }

    /// Noises through the filters of the slopes, and on to the axes.
    fn driven(
        &self,
        axes: &[Axis],
        sources: &[Source],
        heave: Option<&TransferFunction>,
        resonance: &TransferFunction,
    ) -> Result<Motion> {
        let mut shaped = Shaped::new(axes.len(), sources.len());
        for (noise, source) in sources.iter().enumerate() {
            let [athwart, along] = source.axis;
            let parts = axes.iter().map(|axis| match axis {
                Axis::Roll => (athwart, false),
                // −sin ν cos ν
                Axis::Yaw => (athwart * self.slopes().1, false),
                Axis::Pitch => (along, false),
                // s² sway = g σ_athwart
                Axis::Sway => (GRAVITY * athwart, true),
                Axis::Surge => (GRAVITY * along, true),
                Axis::Heave => (0.0, false),
            });
            shaped.add(noise, &source.fit.shaping, &parts.collect::<Vec<_>>())?;
        }
        if let Some(filter) = heave {
            let parts = axes.iter().map(|axis| (f64::from(u8::from(*axis == Axis::Heave)), false));
            shaped.add(0, filter, &parts.collect::<Vec<_>>())?;
        }
        let answered = answered(axes, resonance)?;
        Motion::new(shaped.system()?.then(&answered)?, axes)
    }
}

/// Filters side by side, each of one of the noises.
struct Shaped {
    outputs: usize,
    noises: usize,
    filters: Vec<(usize, StateSpace)>,
}

impl Shaped {
    fn new(outputs: usize, noises: usize) -> Self {
        Self { outputs, noises, filters: Vec::new() }
    }

    /// A filter F with the part of it in each output, of F or of F/s².
    fn add(&mut self, noise: usize, filter: &TransferFunction, parts: &[(f64, bool)]) -> Result<()> {
        let mut system = StateSpace::from_transfer(filter);
        let top = filter.numerator();
        let twice = TransferFunction::new(&top[..top.len().saturating_sub(2).max(1)], filter.denominator())?;
        // the companion form of the same denominator has the same states
        let (own, twice) = (system.c.clone(), StateSpace::from_transfer(&twice).c);
        system.c = Mat::from_fn(self.outputs, system.order(), |i, j| {
            parts[i].0 * if parts[i].1 { twice[(0, j)] } else { own[(0, j)] }
        });
        self.filters.push((noise, system));
        Ok(())
    }

    fn system(&self) -> Result<StateSpace> {
        let order = self.filters.iter().map(|f| f.1.order()).sum();
        let (mut a, mut b) = (Mat::zeros(order, order), Mat::zeros(order, self.noises));
        let mut c = Mat::zeros(self.outputs, order);
        let mut at = 0;
        for (noise, filter) in &self.filters {
            let n = filter.order();
            for i in 0..n {
                (0..n).for_each(|j| a[(at + i, at + j)] = filter.a[(i, j)]);
                b[(at + i, *noise)] = filter.b[(i, 0)];
                (0..self.outputs).for_each(|o| c[(o, at + i)] = filter.c[(o, i)]);
            }
            at += n;
        }
        StateSpace::new(a, b, c, Mat::zeros(self.outputs, self.noises))
    }
}

/// Roll behind its resonance, all else as it comes.
fn answered(axes: &[Axis], resonance: &TransferFunction) -> Result<StateSpace> {
    let k = axes.len();
    let own = StateSpace::from_transfer(resonance);
    let n = if axes[0] == Axis::Roll { own.order() } else { 0 };
    let passes = |i: usize, j: usize| f64::from(u8::from(i == j && (i > 0 || n == 0)));
    StateSpace::new(
        Mat::from_fn(n, n, |i, j| own.a[(i, j)]),
        Mat::from_fn(n, k, |i, j| if j == 0 { own.b[(i, 0)] } else { 0.0 }),
        Mat::from_fn(k, n, |i, j| if i == 0 { own.c[(0, j)] } else { 0.0 }),
        Mat::from_fn(k, k, passes),
    )
}

/// The filter of heave, by the power of its acceleration.
fn fitted_heave(met: &SlopeSpectrum, search: &Search<'_>) -> Result<TransferFunction> {
    let omega: Vec<f64> = (0..met.bins.len()).map(|k| met.omega(k)).collect();
    let density: Vec<f64> = met.bins.iter().map(|bin| bin[3]).collect();
    let weight: Vec<f64> = omega.iter().map(|w| w.powi(4)).collect();
    Ok(fit_shapes((&omega, &density, &weight), search)?.shaping)
}

/// Q = F⁻¹ S F⁻ᴴ on points that resolve her resonance.
fn noise(met: &SlopeSpectrum, sources: &[Source], (frequency, damping): (f64, f64)) -> Arc<[NoiseDensity]> {
    let at = |(omega, width, bin): (f64, f64, usize)| {
        let filters: Vec<Complex64> =
            sources.iter().map(|s| s.fit.shaping.at(Complex64::new(0.0, omega))).collect();
        let entry = |i: usize, j: usize| {
            met.cross(bin, sources[i].axis, sources[j].axis) / (filters[i] * filters[j].conj())
        };
        let matrix = (0..sources.len()).map(|i| (0..sources.len()).map(|j| entry(i, j)).collect()).collect();
        NoiseDensity { omega, width, matrix }
    };
    met.points(frequency, damping).into_iter().map(at).collect()
}
