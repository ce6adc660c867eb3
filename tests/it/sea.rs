//! A compass in a sea beside quadrature over the sea's own spectrum, with formulas written out here; and a ship's roll
//! beside her equation stepped in time.

use crate::roll_error::{asked, asked_json};
use gyrospec::estimate::fit::Silent;
use gyrospec::gyro::{Axis, Gyrosphere};
use gyrospec::rolling::{Against, Compass, Excitation, Request, Source, Table, Waves};
use gyrospec::spectrum::{Encounter, Hull, Sea};
use num_complex::Complex64;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Mutex;

const G: f64 = 9.81;
const J: Complex64 = Complex64::I;

/// What a peakedness raises the height's square by.
static HEIGHTS: Mutex<BTreeMap<u64, f64>> = Mutex::new(BTreeMap::new());

/// Two-sided density of the surface, from height and peak, as printed: π (5/16) H² ω_p⁴ ω⁻⁵ exp(−5/4 (ω_p/ω)⁴), times
/// γ^exp(−(ω − ω_p)²/(2σ²ω_p²)) and what keeps the height H, by sums over ω/ω_p.
fn surface(sea: &Sea, w: f64) -> f64 {
    let (h, p) = match *sea {
        // α = 0.0081: ω_p⁴ = 16αg²/(5H²)
        Sea::PiersonMoskowitz { height } => {
            (height, (16.0 * 0.0081 * G * G / (5.0 * height * height)).powf(0.25))
        }
        Sea::Bretschneider { height, peak } | Sea::Jonswap { height, peak, .. } => (height, peak),
    };
    let plain = PI * 5.0 / 16.0 * h * h * p.powi(4) / w.powi(5) * (-1.25 * (p / w).powi(4)).exp();
    let Sea::Jonswap { gamma, .. } = *sea else { return plain };
    let raised = *HEIGHTS.lock().unwrap().entry(gamma.to_bits()).or_insert_with(|| {
        // ∫ 5 x⁻⁵ exp(−5/4 x⁻⁴) γ^bump dx, which is 1 for γ = 1
        let at = |x: f64| 5.0 / x.powi(5) * (-1.25 / x.powi(4)).exp() * gamma.powf(bump(x));
        (0..200_000).map(|k| at((f64::from(k) + 0.5) * 2e-4) * 2e-4).sum()
    });
    plain / raised * gamma.powf(bump(w / p))
}

fn bump(x: f64) -> f64 {
    let sigma = if x <= 1.0 { 0.07 } else { 0.09 };
    (-(x - 1.0).powi(2) / (2.0 * sigma * sigma)).exp()
}

/// What a wave of unit height and frequency w from the bearing `from` does: W₂ and x of a compass with the lag.
fn answer(s: &Gyrosphere, waves: &Waves, from: f64, w: f64, heading: f64) -> [Complex64; 2] {
    let hull = &waves.hull;
    let [a, b] = [hull.length * from.cos(), hull.beam * from.sin()].map(|x| (0.5 * x / G).powi(2));
    let keeps = 1.0 / (1.0 + (a + b) / 3.0 * w.powi(4) + ((a * a + b * b) / 15.0 + a * b / 9.0) * w.powi(8));
    answer_of(s, waves, (from, keeps.sqrt()), w, heading)
}

/// The same where the waterplane leaves a part of the slope.
fn answer_of(
    s: &Gyrosphere,
    waves: &Waves,
    (from, keeps): (f64, f64),
    w: f64,
    heading: f64,
) -> [Complex64; 2] {
    let hull = &waves.hull;
    let met = w + w * w * waves.speed * from.cos() / G;
    let slope = w * w / G * keeps;
    let w0 = hull.frequency;
    let roll = -from.sin() * slope * w0 * w0 * hull.slope
        / (w0 * w0 - met * met + J * 2.0 * hull.damping * w0 * met);
    let pitch = if waves.also.contains(&Axis::Pitch) { from.cos() * slope } else { 0.0 };
    let [athwart, forward] = [roll, pitch.into()].map(|angle: Complex64| -met * met * s.lever * angle);
    let first = -athwart * heading.cos() + forward * heading.sin();
    let second = athwart * heading.sin() + forward * heading.cos();
    let x = first * s.weight / (s.gravity * s.stiffness) / (1.0 + J * met * s.lag);
    [second, x]
}

/// ∫ f from 0.3 to 12 times the peak, by the double exponential rule on short pieces.
fn over(sea: &Sea, cuts: &[f64], f: impl Fn(f64) -> f64) -> f64 {
    let p = sea.peak();
    let mut ends: Vec<f64> = (0..=60).map(|k| p * 0.3 * 40f64.powf(f64::from(k) / 60.0)).collect();
    ends.extend(cuts.iter().copied().filter(|c| *c > 0.3 * p && *c < 12.0 * p));
    ends.push(p);
    ends.sort_by(f64::total_cmp);
    let piece = |e: &[f64]| {
        let out = quadrature::integrate(&f, e[0], e[1], 1e-14);
        assert!(out.error_estimate < 1e-6, "{}", out.error_estimate);
        out.integral
    };
    ends.windows(2).filter(|e| e[1] > e[0]).map(piece).sum()
}

/// Bearings with their share: cosⁿ within 90° of the main one, by the midpoints of degrees.
fn bearings(waves: &Waves) -> Vec<(f64, f64)> {
    let Some(n) = waves.spread else { return vec![(waves.from, 1.0)] };
    let away = |k: i32| (f64::from(k) - 89.5).to_radians();
    let all: f64 = (0..180).map(|k| away(k).cos().powf(n)).sum();
    (0..180).map(|k| (waves.from + away(k), away(k).cos().powf(n) / all)).collect()
}

fn northing(s: &Gyrosphere, waves: &Waves, heading: f64) -> f64 {
    s.earth_rate * s.latitude.cos() + waves.speed * heading.sin() / 6.371e6
}

/// α a unit of ⟨W₂x⟩.
fn gain(s: &Gyrosphere, waves: &Waves, heading: f64) -> f64 {
    s.weight / (s.gravity * s.momentum * northing(s, waves, heading))
}

/// The mean: (1/π) ∫∫ S D Re W₂x* dω dθ over the waves' own frequencies, where nothing is singular.
fn mean(s: &Gyrosphere, waves: &Waves, heading: f64) -> f64 {
    let of = |(from, share): (f64, f64)| {
        // where roll resonates: ω_e = ±ω_φ
        let (a, w0) = (waves.speed * from.cos() / G, waves.hull.frequency);
        let root = |sign: f64| (sign * (1.0 + 4.0 * a * w0).max(0.0).sqrt() - 1.0) / (2.0 * a);
        let cuts = if a.abs() < 1e-9 { vec![w0] } else { vec![root(1.0), root(-1.0)] };
        let density = |w: f64| {
            let [second, x] = answer(s, waves, from, w, heading);
            surface(&waves.sea, w) * (second * x.conj()).re
        };
        share * over(&waves.sea, &cuts, density)
    };
    gain(s, waves, heading) / PI * bearings(waves).into_iter().map(of).sum::<f64>()
}

/// (jΩ − A_s)⁻¹ of the compass (2.1) applied to a push of the rows of α, β and λ: α.
fn compass(s: &Gyrosphere, northing: f64, omega: f64, push: [f64; 3]) -> Complex64 {
    let (l, c, f) = (s.pendulous / s.momentum, s.damper / s.momentum, s.flow);
    let jw = J * omega;
    // jΩα = lβ + cλ + p₁;  jΩβ = −nα + p₂;  jΩλ = −fβ − fλ + p₃
    let beta = |alpha: Complex64| (push[1] - northing * alpha) / jw;
    let lambda = |alpha: Complex64| (push[2] - f * beta(alpha)) / (jw + f);
    let rest = |alpha: Complex64| jw * alpha - l * beta(alpha) - c * lambda(alpha) - push[0];
    // linear in α
    let (at0, at1) = (rest(0.0.into()), rest(1.0.into()));
    -at0 / (at1 - at0)
}

/// Spread by the swing, and by products as a compass far slower than the waves feels them; crests are long, no way.
fn spreads(s: &Gyrosphere, waves: &Waves, heading: f64) -> [f64; 2] {
    let n = northing(s, waves, heading);
    let cuts = [waves.hull.frequency];
    let swing = |w: f64| {
        let [second, _] = answer(s, waves, waves.from, w, heading);
        let push = [s.pendulous / s.momentum / s.gravity, 0.0, -s.flow / s.gravity];
        surface(&waves.sea, w) * (second * compass(s, n, w, push)).norm_sqr()
    };
    // S(0) of W₂x = (2/π) ∫ (S Re W₂x*)² dω
    let square = |w: f64| {
        let [second, x] = answer(s, waves, waves.from, w, heading);
        (surface(&waves.sea, w) * (second * x.conj()).re).powi(2)
    };
    let low = 2.0 / PI * over(&waves.sea, &cuts, square);
    let step = 2e-7;
    let push = [0.0, s.weight / (s.gravity * s.momentum), 0.0];
    let power = |k: u32| compass(s, n, (f64::from(k) + 0.5) * step, push).norm_sqr();
    let felt = (0..200_000).map(power).sum::<f64>() * step / PI;
    [(over(&waves.sea, &cuts, swing) / PI).sqrt(), (low * felt).sqrt()]
}

fn seas() -> [(&'static str, Sea); 5] {
    let peak = |period: f64| TAU / period;
    [
        ("Pierson-Moskowitz 3 m", Sea::PiersonMoskowitz { height: 3.0 }),
        ("Bretschneider 3 m 8 s", Sea::Bretschneider { height: 3.0, peak: peak(8.0) }),
        ("Bretschneider 2 m 5 s", Sea::Bretschneider { height: 2.0, peak: peak(5.0) }),
        ("JONSWAP 3.3, 3 m 8 s", Sea::Jonswap { height: 3.0, peak: peak(8.0), gamma: 3.3 }),
        ("JONSWAP 7, 1 m 5 s", Sea::Jonswap { height: 1.0, peak: peak(5.0), gamma: 7.0 }),
    ]
}

fn hulls() -> [(&'static str, Hull); 3] {
    let freighter = Hull::default();
    let boat = Hull { frequency: TAU / 4.0, damping: 0.12, slope: 0.9, beam: 4.0, length: 14.0, ..freighter };
    let liner =
        Hull { frequency: TAU / 15.0, damping: 0.04, slope: 0.6, beam: 32.0, length: 220.0, ..freighter };
    [("freighter", freighter), ("boat", boat), ("liner", liner)]
}

fn table(waves: &Waves, heading: f64) -> Table {
    // low in the ship, so that no mean is beyond the linear theory
    let sphere = Gyrosphere { lever: 0.5, ..Gyrosphere::seed() };
    let compass = Compass { speed: waves.speed, sphere, ..Compass::paper() };
    let excitation = Excitation { source: Source::Sea(waves.clone()), band: None };
    Request { compass, excitation, against: Against::Heading(vec![heading]), days: None }
        .table(&Silent)
        .unwrap()
}

fn waves(sea: Sea, degrees: f64, speed: f64, spread: Option<f64>, hull: Hull) -> Waves {
    let also = if degrees == 90.0 && spread.is_none() { vec![] } else { vec![Axis::Pitch] };
    Waves { sea, from: degrees.to_radians(), speed, spread, hull, also }
}

/// The rational mean beside the true one: within `bound` of the mean by roll alone, since that by pitch may cancel it,
/// and off by what the answer says it is off by, to a part `sure` of that.
fn beside(name: &str, w: &Waves, bound: f64, sure: f64) -> Table {
    let heading = 0.6;
    let table = table(w, heading);
    let (row, told) = (&table.rows[0], table.off_by.unwrap());
    let sphere = &table.compass.sphere;
    let exact = mean(sphere, w, heading);
    let (mut rolls, mut pitches) = (w.clone(), w.clone());
    rolls.also.clear();
    pitches.hull.slope = 1e-6;
    let scale = mean(sphere, &rolls, heading).abs().max(mean(sphere, &pitches, heading).abs());
    let off = (row.error.rectified - exact) / scale;
    println!(
        "{name}: mean {:.6}° exact {:.6}°, off {:+.3} % of the larger of roll's and pitch's, told {:+.3} % of the mean, misfit {:.2} %",
        row.error.rectified.to_degrees(),
        exact.to_degrees(),
        100.0 * off,
        100.0 * told.mean,
        100.0 * table.sea.as_ref().unwrap().error
    );
    assert!((told.exact - exact).abs() < sure * scale, "{name}: {} told {}", exact, told.exact);
    assert!((told.mean * told.exact - row.error.rectified + exact).abs() < sure * scale, "{name}");
    assert!(off.abs() < bound, "{name}: {off}");
    table
}

#[test]
fn mean_and_spread_in_each_sea_are_those_of_its_own_spectrum() {
    for (sea_name, sea) in seas() {
        for (ship, hull) in hulls() {
            for from in [90.0, 60.0] {
                let w = waves(sea, from, 0.0, None, hull);
                let name = format!("{sea_name}, {ship}, {from}°");
                let table = beside(&name, &w, 0.01, 5e-4);
                let (e, told) = (&table.rows[0].error, table.off_by.unwrap());
                let [swing, products] = spreads(&table.compass.sphere, &w, 0.6);
                let off = [e.deviation_linear / swing - 1.0, e.deviation_quadratic / products - 1.0];
                println!(
                    "    swing {:+.3} %, products {:+.3} % told {:+.3} %",
                    100.0 * off[0],
                    100.0 * off[1],
                    100.0 * told.spread
                );
                assert!(off[0].abs() < 0.02 && off[1].abs() < 0.02, "{name}: {off:?}");
                assert!((off[1] - told.spread).abs() < 2e-3, "{name}: {} told {}", off[1], told.spread);
            }
        }
    }
}

#[test]
fn waves_are_met_at_the_frequency_of_encounter() {
    for (sea_name, sea) in [seas()[0], seas()[3]] {
        for (from, speed) in [(0.0, 10.0), (45.0, 8.0), (120.0, 4.0), (180.0, 12.0), (30.0, -3.0)] {
            let w = waves(sea, from, speed, None, Hull::default());
            // from astern the spectrum that is met has a singularity, which no rational one has: it is told what is missed
            let follows = speed * w.from.cos() < -1e-9;
            let (bound, sure) = if follows { (0.25, 5e-3) } else { (0.02, 1e-3) };
            beside(&format!("{sea_name} from {from}° at {speed} m/s"), &w, bound, sure);
        }
    }
    // from astern at their own speed nearly all of them are met at one frequency: no answer goes without a word
    let call = ["--sea=jonswap", "--sea-from=150", "--speed=8", "--also=pitch", "--heading=45"];
    let (code, out, message) = asked(&call);
    let refused = code == 3 && out.is_empty() && message.contains("no rational spectrum comes near");
    assert!(refused || (code == 0 && out.contains("trust the sums more")), "{out} {message}");
    // with no way, and abeam, nothing is shifted
    let still = table(&waves(seas()[3].1, 60.0, 0.0, None, Hull::default()), 0.6).rows[0].error.rectified;
    let slow = table(&waves(seas()[3].1, 60.0, 1e-6, None, Hull::default()), 0.6).rows[0].error.rectified;
    assert!((slow / still - 1.0).abs() < 1e-4);
}

#[test]
fn a_sea_from_many_directions_is_the_sum_of_them() {
    for (sea_name, sea) in [seas()[1], seas()[3]] {
        for (from, speed, n) in
            [(90.0, 0.0, 2.0), (0.0, 0.0, 2.0), (60.0, 0.0, 4.0), (45.0, 7.0, 2.0), (135.0, 7.0, 8.0)]
        {
            let w = waves(sea, from, speed, Some(n), Hull::default());
            // under way the two slopes go together otherwise at each frequency, which their two filters leave out
            let (bound, sure) = if speed == 0.0 { (0.02, 1e-3) } else { (0.1, 5e-3) };
            beside(&format!("{sea_name} from {from}° cos^{n} at {speed} m/s"), &w, bound, sure);
        }
    }
    // ever narrower it is the sea whose crests are long
    let of =
        |spread| table(&waves(seas()[3].1, 60.0, 0.0, spread, Hull::default()), 0.6).rows[0].error.rectified;
    let (long, narrow) = (of(None), of(Some(100.0)));
    assert!((narrow / long - 1.0).abs() < 0.05, "{long} {narrow}");
}

#[test]
fn the_mean_by_a_rectangle_is_told_where_short_waves_count() {
    let hull = Hull { beam: 20.0, length: 120.0, frequency: TAU / 12.0, damping: 0.05, ..Hull::default() };
    for (height, period, from) in [(4.0, 7.0, 60.0), (2.0, 6.0, 90.0), (4.0, 10.0, 30.0)] {
        let sea = Sea::Bretschneider { height, peak: TAU / period };
        let w = Waves { also: Vec::new(), ..waves(sea, from, 0.0, None, hull) };
        let (table, heading) = (table(&w, 0.6), 0.6);
        let s = &table.compass.sphere;
        let product = |omega: f64| {
            let side = |x: f64| {
                if x.abs() < 1e-9 {
                    1.0
                } else {
                    (0.5 * omega * omega / G * x).sin() / (0.5 * omega * omega / G * x)
                }
            };
            let keeps = side(hull.length * w.from.cos()) * side(hull.beam * w.from.sin());
            let [second, x] = answer_of(s, &w, (w.from, keeps), omega, heading);
            surface(&sea, omega) * (second * x.conj()).re
        };
        let exact = gain(s, &w, heading) / PI * over(&sea, &[hull.frequency], product);
        let told = table.by_rectangle.unwrap();
        println!(
            "{period} s from {from}°: by a rectangle {:.6}°, told {:.6}°",
            exact.to_degrees(),
            told.to_degrees()
        );
        assert!((told / exact - 1.0).abs() < 1e-3, "{told} {exact}");
        assert!((table.off_by.unwrap().exact / exact - 1.0).abs() > 0.1, "short waves count");
    }
    let (code, text, _) = asked(&[
        "--sea=bretschneider",
        "--height=4m",
        "--period=7s",
        "--sea-from=60",
        "--ship=12s,0.05,0.8,20m",
        "--heading=45",
    ]);
    assert!(code == 0 && text.contains("her form decides"), "{text}");
    let (_, text, _) = asked(&["--sea=jonswap", "--heading=45"]);
    assert!(!text.contains("her form decides"), "{text}");
}

#[test]
fn what_keeps_pace_with_the_ship_is_refused_where_it_has_no_bound() {
    let call = |words: &str| asked(&words.split_whitespace().chain(["--heading", "45"]).collect::<Vec<_>>());
    let (code, _, message) = call("--sea=jonswap --sea-from=180 --speed=12 --also=surge");
    assert!(code == 2 && message.contains("keep pace"), "{message}");
    assert_eq!(call("--sea=jonswap --sea-from=180 --speed=12 --also=pitch").0, 0);
    let (code, _, message) = call("--sea=jonswap --sea-from=60 --spread=2 --also=yaw");
    assert!(code == 2 && message.contains("crests are long"), "{message}");
    for words in
        ["--sea=pm --spread=0.5", "--sea=pm --spread=1000", "--sea=pm --roll-damping=-1", "--spread=2"]
    {
        assert_eq!(call(words).0, 2, "{words}");
    }
    let told =
        asked_json(&["--sea=pm", "--sea-from=30", "--speed=15kn", "--spread=2", "--roll-damping=0.2,0.1"]);
    assert!(told["sea"]["met_at_m_per_s"].as_f64().unwrap() > 7.7);
    assert!(told["sea"]["roll_damping"].as_f64().unwrap() > 0.08);
    assert!(told["motion"].as_str().unwrap().contains("met at 7.72 m/s"), "{}", told["motion"]);
}

/// Time between steps of the ship's equation, s.
const STEP: f64 = 0.1;

/// The slope of waves of random phases as a ship feels it, at the ends and in the middles of steps.
fn random_slope(beam: f64, sea: &Sea, seed: u64, steps: usize) -> Vec<f64> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (count, p) = (300, sea.peak());
    // frequencies at random within their cells, so that nothing repeats
    let mut parts: Vec<[Complex64; 2]> = (0..count)
        .map(|k| {
            let cell = 4.0 * p / f64::from(count);
            let w = 0.4 * p + cell * (f64::from(k) + rng.random_range(0.0..1.0));
            let b = (0.5 * beam / G).powi(2);
            let keeps = 1.0 / (1.0 + b / 3.0 * w.powi(4) + b * b / 15.0 * w.powi(8));
            let slope = surface(sea, w) * keeps * (w * w / G).powi(2);
            let amplitude = (2.0 * slope * cell / PI).sqrt();
            let turn = Complex64::from_polar(1.0, 0.5 * STEP * w);
            [Complex64::from_polar(amplitude, rng.random_range(0.0..TAU)), turn]
        })
        .collect();
    let mut next = || {
        let slope = parts.iter().map(|[z, _]| z.re).sum();
        for [z, turn] in &mut parts {
            *z *= *turn;
        }
        slope
    };
    (0..=2 * steps).map(|_| next()).collect()
}

/// θ̈ + 2ζω_φθ̇ + d|θ̇|θ̇ + cθ̇³ + ω_φ²θ = ω_φ²χσ on a slope, by the rule of Runge and Kutta: the mean square of θ̇.
fn stepped(hull: &Hull, slope: &[f64], settle: usize) -> f64 {
    let w0 = hull.frequency;
    let bend = |force: f64, [angle, rate]: [f64; 2]| {
        let damping =
            2.0 * hull.damping * w0 * rate + hull.quadratic * rate.abs() * rate + hull.cubic * rate.powi(3);
        [rate, w0 * w0 * (hull.slope * force - angle) - damping]
    };
    let (mut y, mut sum, mut kept) = ([0.0, 0.0], 0.0, 0);
    for (k, at) in slope.windows(3).step_by(2).enumerate() {
        let [at, half, next] = [at[0], at[1], at[2]];
        let go = |y: [f64; 2], d: [f64; 2], h: f64| [y[0] + h * d[0], y[1] + h * d[1]];
        let k1 = bend(at, y);
        let k2 = bend(half, go(y, k1, 0.5 * STEP));
        let k3 = bend(half, go(y, k2, 0.5 * STEP));
        let k4 = bend(next, go(y, k3, STEP));
        y = [0, 1].map(|i| y[i] + STEP / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        if k >= settle {
            sum += y[1] * y[1];
            kept += 1;
        }
    }
    sum / f64::from(kept)
}

#[test]
fn more_damping_of_roll_is_that_of_her_equation_stepped_in_time() {
    let sea = seas()[3].1;
    let (settle, beam) = (3000, Hull::default().beam);
    let slopes: Vec<_> = (0..24).map(|seed| random_slope(beam, &sea, seed, settle + 30_000)).collect();
    for (quadratic, cubic, bound) in
        [(0.0, 0.0, 0.02), (0.3, 0.0, 0.04), (1.0, 0.0, 0.05), (0.0, 3.0, 0.08), (0.3, 1.0, 0.06)]
    {
        let hull = Hull { damping: 0.03, quadratic, cubic, ..Hull::default() };
        let met = Encounter { sea, from: FRAC_PI_2, speed: 0.0, spread: None }
            .slopes(&hull, 3000, 0.999_999)
            .unwrap();
        let (damping, rate) = hull.equivalent_damping(&met);
        let runs: Vec<f64> = slopes.iter().map(|slope| stepped(&hull, slope, settle)).collect();
        let n = runs.len() as f64;
        let square = runs.iter().sum::<f64>() / n;
        let error = (runs.iter().map(|r| (r - square).powi(2)).sum::<f64>() / (n - 1.0) / n).sqrt();
        let off = rate / square.sqrt() - 1.0;
        println!(
            "d = {quadratic}, c = {cubic}: ratio {damping:.4}, rate {:.3}°/s, stepped {:.3}°/s (±{:.1} %), off {:+.2} %",
            rate.to_degrees(),
            square.sqrt().to_degrees(),
            2.8 * 50.0 * error / square,
            100.0 * off
        );
        assert!(off.abs() < bound + 2.8 * 0.5 * error / square, "{off}");
    }
}
