//! Several elastic parts together, against the force balance solved in other ways: by hand at one frequency, by I_n of
//! polynomials multiplied out here, by quadrature, by Runge and Kutta.

use crate::roll_error::{asked, asked_json, command};
use approx::assert_relative_eq;
use gyrospec::gyro::elastic::{
    Backlash, Compliance, Elastic, Friction, Inertia, Lag, Relaxing, Slosh, together,
};
use gyrospec::gyro::{Gyrosphere, Instrument, Motion};
use gyrospec::lti::StateSpace;
use gyrospec::spectrum::Roll;
use gyrospec::{Complex64, ErrorKind};
use std::f64::consts::{FRAC_PI_4, PI};

pub const CORNER: f64 = 2.5;

/// A light and springy suspension, whose parts all count at the frequencies of roll.
pub fn soft() -> Gyrosphere {
    Gyrosphere { stiffness: 60.0, lag: 0.2, ..Gyrosphere::seed() }
}

pub fn roll() -> Roll {
    Roll::new(0.03, 0.1, 0.8).unwrap()
}

pub fn banded() -> Motion {
    Motion::roll(&roll()).band_limited(CORNER, 2).unwrap()
}

pub const FLOW: Relaxing = Relaxing { time: 1.5, share: 0.4 };
pub const SLOSH: Slosh = Slosh { frequency: 1.3, damping: 0.15, share: 0.2 };
pub const MERIDIAN: Compliance = Compliance { meridian: Some((90.0, 0.3)), vertical: None };
pub const VERTICAL: Compliance = Compliance { meridian: None, vertical: Some((80.0, 0.4)) };

pub fn boxed<T: Elastic + Clone + 'static>(part: &T) -> Box<dyn Elastic> {
    Box::new(part.clone())
}

pub fn all(parts: &[Box<dyn Elastic>]) -> Box<dyn Elastic> {
    together(parts).unwrap()
}

/// The noise and the accelerations on 45°.
fn accelerations(sphere: &Gyrosphere) -> StateSpace {
    let w = banded().derivative(gyrospec::Axis::Roll, 2).unwrap();
    let base = banded();
    let (base, h) = (base.system().clone(), sphere.lever * FRAC_PI_4.sin());
    let c = [-h, h, 0.0].map(|f| w.state.iter().map(|x| f * x).collect::<Vec<_>>());
    let rows = |m: &faer::Mat<f64>| -> Vec<Vec<f64>> {
        (0..m.nrows()).map(|i| (0..m.ncols()).map(|j| m[(i, j)]).collect()).collect()
    };
    StateSpace::from_rows(&rows(&base.a), &rows(&base.b), &c, &vec![vec![0.0; base.inputs()]; 3]).unwrap()
}

/// From (W₁, W₂, W₃) to (x, y, z) at jω.
pub fn transfer(part: &dyn Elastic, sphere: &Gyrosphere, omega: f64) -> [[Complex64; 3]; 3] {
    let system = part.system(sphere, &accelerations(sphere)).unwrap();
    let at = system.at(Complex64::new(0.0, omega));
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| Complex64::new(at[(i, j)].re, at[(i, j)].im)))
}

/// x a unit of W₁, from Newton's laws of the whole and of the liquid, and the chain of gives, by elimination.
fn by_hand(
    s: &Gyrosphere,
    heavy: bool,
    flow: Option<Relaxing>,
    slosh: Option<Slosh>,
    p: Complex64,
) -> Complex64 {
    let (m, c) = (s.weight / s.gravity, s.stiffness);
    let compliance =
        (flow.map_or(Complex64::ZERO, |f| f.share / (p * f.time + 1.0)) + 1.0 / (p * s.lag + 1.0)) / c;
    let (mu, swing) = slosh.map_or((0.0, Complex64::ONE), |l| {
        (l.share, p * p + 2.0 * l.damping * l.frequency * p + l.frequency * l.frequency)
    });
    if !heavy {
        return m * compliance + mu / swing;
    }
    // unknown x_v and ξ: (1/J + m p²) x_v + m μ p² ξ = m, p² x_v + swing ξ = 1
    let (a, b) = (1.0 / compliance + m * p * p, m * mu * p * p);
    let determinant = a * swing - b * p * p;
    let vessel = (m * swing - b) / determinant;
    let liquid = (a - m * p * p) / determinant;
    vessel + mu * liquid
}

#[test]
fn together_they_are_one_force_balance() {
    let sphere = soft();
    for (heavy, flow, slosh) in [
        (true, Some(FLOW), None),
        (true, None, Some(SLOSH)),
        (true, Some(FLOW), Some(SLOSH)),
        (false, Some(FLOW), Some(SLOSH)),
    ] {
        let mut parts: Vec<Box<dyn Elastic>> = vec![boxed(&MERIDIAN), boxed(&VERTICAL)];
        parts.extend(flow.iter().map(boxed));
        parts.extend(slosh.iter().map(boxed));
        if heavy {
            parts.push(Box::new(Inertia));
        }
        let m = sphere.weight / sphere.gravity;
        for omega in [0.2, 0.8, 1.3, 2.6, 9.0] {
            let got = transfer(all(&parts).as_ref(), &sphere, omega);
            let p = Complex64::new(0.0, omega);
            let wanted = by_hand(&sphere, heavy, flow, slosh, p);
            assert!(
                (got[0][0] / wanted - 1.0).norm() < 1e-10,
                "{heavy} {flow:?} {slosh:?}: {got:?} {wanted}"
            );
            let inertia = if heavy { m * p * p } else { Complex64::ZERO };
            for (axis, (c, t)) in [(1, (90.0, 0.3)), (2, (80.0, 0.4))] {
                assert!((got[axis][axis] * (inertia + c * t * p + c) / m - 1.0).norm() < 1e-10);
            }
            assert!(got[0][1] == Complex64::ZERO && got[1][0] == Complex64::ZERO);
        }
    }
}

fn times(a: &[f64], b: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; a.len() + b.len() - 1];
    a.iter().enumerate().for_each(|(i, x)| b.iter().enumerate().for_each(|(j, y)| out[i + j] += x * y));
    out
}

fn plus(a: &[f64], b: &[f64]) -> Vec<f64> {
    let n = a.len().max(b.len());
    let at = |p: &[f64], k: usize| if k + p.len() >= n { p[k + p.len() - n] } else { 0.0 };
    (0..n).map(|k| at(a, k) + at(b, k)).collect()
}

#[test]
fn inertia_flow_and_slosh_are_one_integral() {
    // x = N/D with L = 1/l, J = j/(C₀ t₁ t₂): descending coefficients
    let sphere = soft();
    let (m, c0) = (sphere.weight / sphere.gravity, sphere.stiffness);
    let l = [1.0, 2.0 * SLOSH.damping * SLOSH.frequency, SLOSH.frequency.powi(2)];
    let (t1, t2) = ([sphere.lag, 1.0], [FLOW.time, 1.0]);
    let j = plus(&t2, &times(&[FLOW.share], &t1));
    let chain: Vec<f64> = times(&t1, &t2).iter().map(|x| c0 * x).collect();
    // M = m (l − μ s²)/l;  x_v = M j/(chain + M j s²)
    let fixed = plus(&l, &[-SLOSH.share, 0.0, 0.0]);
    let below = plus(&times(&chain, &l), &times(&times(&fixed, &j), &[m, 0.0, 0.0]));
    // x = (m fixed j + μ chain l)/below, since μ L (1 − s² x_v) = μ chain/below
    let above = plus(&times(&times(&fixed, &j), &[m]), &times(&chain, &[SLOSH.share]));
    let (roll, low) = (roll(), [1.0 / CORNER, 1.0]);
    let shaping = times(&times(&low, &low), &[1.0, 2.0 * roll.decay, roll.b2()]);
    let h = times(&below, &shaping);
    // G(s) = 4Aμb² s⁴ · N(s) · D(−s) · low²(s) low²(−s) / …: the two signals share the shaping, so H = D·shaping and the
    // even part of N(s) D(−s) s⁴ stands above
    let mirrored = |p: &[f64]| -> Vec<f64> {
        let n = p.len() - 1;
        p.iter().enumerate().map(|(k, x)| if (n - k).is_multiple_of(2) { *x } else { -x }).collect()
    };
    let product = times(&above, &mirrored(&below));
    let degree = product.len() - 1;
    let even: Vec<f64> =
        product.iter().enumerate().filter(|(k, _)| (degree - k).is_multiple_of(2)).map(|(_, x)| *x).collect();
    let n = h.len() - 1;
    let mut g = vec![0.0; n];
    let scale = 4.0 * roll.variance * roll.decay * roll.b2();
    // s⁴ moves each two places up
    for (k, x) in even.iter().rev().enumerate() {
        g[n - 1 - (k + 2)] = scale * x;
    }
    let mean = gyrospec::evaluate(&gyrospec::Integrand::new(&h, &g).unwrap()).unwrap().value;
    assert_eq!(n, 9);
    let s = &sphere;
    let wanted =
        -s.lever.powi(2) * 0.5 * mean * s.weight / (s.gravity * s.momentum * s.earth_rate * s.latitude.cos());
    let parts = all(&[Box::new(Inertia), boxed(&FLOW), boxed(&SLOSH)]);
    let got = Instrument::new(sphere, parts).rectified_error(&banded(), FRAC_PI_4).unwrap();
    assert_relative_eq!(got, wanted, max_relative = 1e-9);
    // and by trapezoids over the spectrum
    let step = 2e-4;
    let density = |w: f64| roll.density(w) * w.powi(4) / (1.0 + (w / CORNER).powi(2)).powi(2);
    let area: f64 = (1..400_000)
        .map(|k| {
            let w = f64::from(k) * step;
            density(w) * by_hand(s, true, Some(FLOW), Some(SLOSH), Complex64::new(0.0, w)).re
        })
        .sum();
    assert_relative_eq!(area * step / PI, mean, max_relative = 1e-6);
}

/// A neutral limit of each part, and a sphere on which it is neutral.
fn neutral(k: usize) -> Box<dyn Elastic> {
    match k {
        0 => Box::new(Relaxing { time: 1.5, share: 1e-13 }),
        1 => Box::new(Slosh { share: 1e-13, ..SLOSH }),
        2 => Box::new(Compliance { meridian: Some((1e15, 0.3)), vertical: None }),
        3 => Box::new(Compliance { meridian: None, vertical: Some((1e15, 0.3)) }),
        4 => Box::new(Friction { force: 0.0 }),
        _ => Box::new(Backlash { gap: 0.0 }),
    }
}

#[test]
fn a_pair_with_one_part_neutral_is_the_other_alone() {
    let sphere = soft();
    let parts: [Box<dyn Elastic>; 6] = [
        boxed(&FLOW),
        boxed(&SLOSH),
        boxed(&MERIDIAN),
        boxed(&VERTICAL),
        Box::new(Friction { force: 1.0 }),
        Box::new(Backlash { gap: 0.05 }),
    ];
    for (i, part) in parts.iter().enumerate() {
        for k in (0..6).filter(|k| *k != i) {
            // friction and play hold the inertia in their law
            let heavy = i >= 4 || k >= 4;
            let alone = if heavy && i < 4 { all(&[part.clone(), Box::new(Inertia)]) } else { part.clone() };
            let pair = all(&[part.clone(), neutral(k)]);
            for omega in [0.3, 0.8, 2.0] {
                let [got, wanted] = [&pair, &alone].map(|p| transfer(p.as_ref(), &sphere, omega));
                for axis in 0..3 {
                    let off = (got[axis][axis] - wanted[axis][axis]).norm();
                    assert!(
                        off < 1e-6 * wanted[0][0].norm(),
                        "{} at {omega}: {got:?} {wanted:?}",
                        pair.name()
                    );
                }
            }
        }
        // inertia is neutral where the spring is stiff: what gives then is the lag, and shares of it
        let stiff = Gyrosphere { stiffness: 60e6, ..sphere };
        let small: Box<dyn Elastic> =
            if i == 1 { Box::new(Slosh { share: 2e-7, ..SLOSH }) } else { part.clone() };
        if i < 2 {
            let pair = transfer(all(&[small.clone(), Box::new(Inertia)]).as_ref(), &stiff, 0.8)[0][0];
            let alone = transfer(small.as_ref(), &stiff, 0.8)[0][0];
            assert!((pair / alone - 1.0).norm() < 1e-5, "{}: {pair} {alone}", small.name());
        }
    }
    // inertia is heavy in all directions: an even suspension makes no error
    let even = Compliance { meridian: Some((sphere.stiffness, sphere.lag)), vertical: None };
    let even = Instrument::new(sphere, all(&[Box::new(even), Box::new(Inertia)]));
    assert!(even.rectified_error(&banded(), FRAC_PI_4).unwrap().abs() < 1e-12);
    // the lag is in all of them
    let with_lag = all(&[Box::new(Lag), boxed(&FLOW)]);
    assert_eq!(transfer(with_lag.as_ref(), &sphere, 0.8), transfer(&FLOW, &sphere, 0.8));
}

/// A force that repeats after 20π s.
const LINES: [(f64, f64); 6] = [(0.3, 1.0), (0.6, 0.7), (0.8, 1.2), (1.1, 0.5), (1.5, 0.8), (2.4, 0.3)];

pub fn driven(t: f64) -> f64 {
    LINES.iter().map(|(w, a)| a * (w * t + 0.3 * w).cos()).sum()
}

/// The rates of (x₁, x₂, ẋ_v, ξ, ξ̇): Newton's laws as they stand, solved for the accelerations.
fn rates(s: &Gyrosphere, flow: Relaxing, slosh: Slosh, w: f64, z: [f64; 5]) -> [f64; 5] {
    let (m, c) = (s.weight / s.gravity, s.stiffness);
    let [x1, x2, v, xi, dxi] = z;
    // f = C₀(T ẋ₁ + x₁) = C₀(T₂ ẋ₂ + x₂)/κ and ẋ₁ + ẋ₂ = v: two equations for ẋ₁ and ẋ₂
    let (a, b) = (c * s.lag, c * flow.time / flow.share);
    let dx1 = (c * x2 / flow.share - c * x1 + b * v) / (a + b);
    let f = a * dx1 + c * x1;
    // v̇ + μ ξ̈ = W − f/m;  v̇ + ξ̈ = W − 2ζω ξ̇ − ω² ξ
    let right = [w - f / m, w - 2.0 * slosh.damping * slosh.frequency * dxi - slosh.frequency.powi(2) * xi];
    let ddxi = (right[1] - right[0]) / (1.0 - slosh.share);
    [dx1, v - dx1, right[1] - ddxi, dxi, ddxi]
}

#[test]
fn pairs_and_three_follow_newton_in_time() {
    let sphere = soft();
    let (none, dry) = (Relaxing { time: 1.0, share: 1e-9 }, Slosh { share: 0.0, ..SLOSH });
    for (flow, slosh) in [(FLOW, dry), (none, SLOSH), (FLOW, SLOSH)] {
        let (count, periods) = (20_000, 8);
        let dt = 20.0 * PI / f64::from(count);
        let mut z = [0.0; 5];
        let mut mean = 0.0;
        for k in 0..count * periods {
            let t = f64::from(k) * dt;
            let at = |z: [f64; 5], t: f64| rates(&sphere, flow, slosh, driven(t), z);
            let step = |k: [f64; 5], h: f64| [0, 1, 2, 3, 4].map(|i| z[i] + h * k[i]);
            let k1 = at(z, t);
            let k2 = at(step(k1, 0.5 * dt), t + 0.5 * dt);
            let k3 = at(step(k2, 0.5 * dt), t + 0.5 * dt);
            let k4 = at(step(k3, dt), t + dt);
            z = [0, 1, 2, 3, 4].map(|i| z[i] + dt / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
            if k >= count * (periods - 1) {
                mean += driven(t + dt) * (z[0] + z[1] + slosh.share * z[3]) / f64::from(count);
            }
        }
        let parts = all(&[Box::new(Inertia), boxed(&flow), boxed(&slosh)]);
        // ⟨W x⟩ = ½ Σ a² Re X(jω)
        let wanted: f64 =
            LINES.iter().map(|(w, a)| 0.5 * a * a * transfer(parts.as_ref(), &sphere, *w)[0][0].re).sum();
        assert_relative_eq!(mean, wanted, max_relative = 1e-6);
    }
}

#[test]
fn what_makes_no_sense_together_is_refused_with_the_reason() {
    let sphere = soft();
    let refused = |parts: &[Box<dyn Elastic>]| {
        let instrument = Instrument::new(sphere, all(parts));
        instrument.error(&banded(), FRAC_PI_4).unwrap_err()
    };
    let swings = refused(&[Box::new(Slosh { share: 1.0, ..SLOSH }), Box::new(Inertia)]);
    assert!(swings.to_string().contains("no vessel"), "{swings}");
    let against = Relaxing { share: -0.2, ..FLOW };
    let driven = refused(&[boxed(&against), Box::new(Friction { force: 1.0 })]);
    assert!(driven.to_string().contains("runs against the force"), "{driven}");
    let mad = refused(&[Box::new(Relaxing { time: 0.01, share: -2.0 }), Box::new(Inertia)]);
    assert!(mad.to_string().contains("drives itself") && mad.kind() == ErrorKind::BadInput, "{mad}");
    // a little of it is no harm
    let parts = all(&[boxed(&against), Box::new(Inertia)]);
    assert!(Instrument::new(sphere, parts).error(&banded(), FRAC_PI_4).is_ok());
    let twice = together(&[boxed(&FLOW), boxed(&FLOW)]).unwrap_err();
    assert!(twice.to_string().contains("of its own"), "{twice}");
}

const OPTIONS: [&str; 8] = [
    "--inertia",
    "--flow=4s,0.1",
    "--slosh=1.5,0.1,1e-5",
    "--swing=9s,0.1,0.2,0.5s",
    "--meridian=2e5,1",
    "--vertical=1e5,1",
    "--friction=2N",
    "--free-play=1e-5m",
];

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn each_pair_of_parts_is_computed() {
    for (i, one) in OPTIONS.iter().enumerate() {
        for other in &OPTIONS[i + 1..] {
            let simulated = ["friction", "free-play"].iter().any(|p| one.contains(p) || other.contains(p));
            let (code, text, message) = asked(&[one, other, "--heading=45", "--formula"]);
            if simulated {
                assert!(code == 2 && message.contains("not linear"), "{one} {other}: {message}");
            }
            // free play takes the way of friction; with one part it is followed
            if other.contains("free-play") && !one.contains("swing") {
                continue;
            }
            let told = asked_json(&[one, other, "--band=2.5", "--heading=45"]);
            let name = told["instrument"].as_str().unwrap();
            let row = &told["rows"][0];
            let mean = row["mean_deg"].as_f64().unwrap();
            assert!(mean.is_finite() && mean != 0.0, "{one} {other}: {told}");
            assert_eq!(simulated, row["mean_margin_deg"].is_f64(), "{one} {other}: {told}");
            if !simulated {
                // what would fill pages stands as the integral that it is
                let told = ["agrees with the numeric engine", "written out fills pages"];
                assert!(code == 0 && told.iter().any(|t| text.contains(t)), "{name}: {message}");
                assert_eq!(
                    name.contains(" and "),
                    one != &"--meridian=2e5,1" || other != &"--vertical=1e5,1"
                );
            }
        }
    }
    // three, in text and as a page
    let words = ["--inertia", "--flow=4s,0.1", "--friction=2N", "--band=2.5", "--heading=45"];
    let (code, text, message) = asked(&words);
    assert!(code == 0 && text.contains("liquid flow and dry friction is not linear"), "{text} {message}");
    let (code, page, _) = asked(&[&words[..], &["--html=-"]].concat());
    assert!(code == 0 && page.contains("liquid flow and dry friction"));
}

#[test]
fn a_part_of_a_model_goes_with_those_of_the_options() {
    let rows = |words: &[&str]| asked_json(&[words, &["--band=2.5"]].concat())["rows"].clone();
    assert_eq!(
        rows(&["gyrosphere-inertia", "--flow=4s,0.1"]),
        rows(&["gyrosphere", "--inertia", "--flow=4s,0.1"])
    );
    let mean = |words: &[&str]| rows(words)[0]["mean_deg"].as_f64().unwrap();
    let again = mean(&["gyrosphere-inertia", "--inertia"]);
    assert_relative_eq!(again, mean(&["gyrosphere", "--inertia"]), max_relative = 1e-9);
    let flow = "[parameters]\nT2 = 4.0\nkappa = 0.1\n";
    let (code, told, message) =
        command("c.toml", flow, &["--inertia", "--band=2.5", "--heading=45", "--json"]);
    assert_eq!(code, 0, "{message}");
    let told: serde_json::Value = serde_json::from_str(&told).unwrap();
    assert_eq!(told["rows"], rows(&["--inertia", "--flow=4s,0.1"]));
    let both = format!("extends = \"gyrosphere-inertia\"\n{flow}");
    let (code, _, message) = command("c.toml", &both, &["--heading=45"]);
    assert!(code == 2 && message.contains("gyrosphere-flow"), "{message}");
    for option in ["--flow=10s,0.2", "--flow=4s,0.1"] {
        let (code, _, message) = asked(&["gyrosphere-flow", option, "--heading=45"]);
        assert!(code == 2 && message.contains("of its own"), "{message}");
    }
}

#[test]
fn behind_low_passes_the_formula_is_that_of_the_banded_roll() {
    for (part, order) in [("--lever=3m", 5), ("--inertia", 6), ("--flow=4s,0.1", 6), ("--meridian=2e5,1", 6)]
    {
        let told = asked_json(&[part, "--band=2.5", "--formula"]);
        assert!(told["order"] == order && told["points_checked"] == 32, "{told}");
        assert!(told["formula"].as_str().unwrap().contains("ω_c"), "{told}");
        let row = &asked_json(&[part, "--band=2.5"])["rows"][0]["mean_deg"];
        assert_relative_eq!(
            told["values"][0]["mean_deg"].as_f64().unwrap(),
            row.as_f64().unwrap(),
            max_relative = 1e-9
        );
    }
    // what would fill pages is the integral that it is, and a page of a banded roll has the formula of the band
    let words = ["--inertia", "--flow=4s,0.1", "--slosh=1.5,0.1,1e-5", "--band=2.5"];
    let told = asked_json(&[&words[..], &["--formula"]].concat());
    let formula = told["formula"].as_str().unwrap();
    assert!(told["order"] == 9 && told["points_checked"] == 0 && formula.contains("an I_9"), "{told}");
    assert!(
        ["F(s) = h sin K", "X(s) = ", "W(s) = ", "N = 4"].iter().all(|f| formula.contains(f)),
        "{formula}"
    );
    let (_, page, _) = asked(&["--band=2.5", "--heading=45", "--html=-"]);
    assert!(page.contains("ω_c"));
    let (_, page, _) = asked(&["--regular=5deg,0.7", "--heading=45", "--html=-"]);
    assert!(!page.contains("The mean as a formula"));
    let (_, text, _) = asked(&["--vertical=1e5,1", "--formula"]);
    assert!(text.contains("compliance along the vertical changes no mean"), "{text}");
}

#[test]
fn sway_and_surge_go_with_the_water_and_yaw_moves_no_mean() {
    use gyrospec::{Axis, Hull, TransferFunction};
    let (hull, from, g) = (Hull { length: 40.0, ..Hull::default() }, 1.1, 9.81);
    let at = |w: &TransferFunction, omega: f64| w.at(Complex64::new(0.0, omega));
    let [roll, sway, surge, pitch] = [
        hull.roll_response(from).unwrap(),
        hull.sway_response(from).unwrap(),
        hull.surge_response(from).unwrap(),
        hull.pitch_response(from).unwrap(),
    ];
    // on long waves: the water turns on circles of the wave's height, and is accelerated as the mast is turned
    let w = 0.01;
    assert_relative_eq!(at(&sway, w).re, 1.1f64.sin(), max_relative = 1e-3);
    assert_relative_eq!((-w * w * at(&sway, w) / at(&roll, w)).re, g / hull.slope, max_relative = 1e-3);
    assert_relative_eq!((-w * w * at(&surge, w) / at(&pitch, w)).re, g, max_relative = 1e-9);
    // the mean by quadrature: W athwart = h θ̈ + sway″, forward = surge″, x = m/C₀ (…)/(1 + jωT)
    let sphere = Gyrosphere::seed();
    let sea = TransferFunction::new(&[0.3, 0.0, 0.0], &times(&[1.0, 0.3, 0.6], &[1.0, 0.3, 0.6])).unwrap();
    let motion = Motion::in_sea(
        &sea,
        &[
            (Axis::Roll, roll.clone()),
            (Axis::Sway, sway.clone()),
            (Axis::Surge, surge.clone()),
            (Axis::Yaw, hull.yaw_response(from).unwrap()),
        ],
    )
    .unwrap();
    let heading = 0.6f64;
    let got = Instrument::new(sphere, Box::new(Lag)).rectified_error(&motion, heading).unwrap();
    let step = 1e-3;
    let area: f64 = (1..60_000)
        .map(|k| {
            let w = f64::from(k) * step;
            let athwart = -w * w * (sphere.lever * at(&roll, w) + at(&sway, w));
            let forward = -w * w * at(&surge, w);
            let first = -athwart * heading.cos() + forward * heading.sin();
            let second = athwart * heading.sin() + forward * heading.cos();
            let give = sphere.weight / (sphere.gravity * sphere.stiffness);
            let x = first * give / Complex64::new(1.0, w * sphere.lag);
            at(&sea, w).norm_sqr() * (second * x.conj()).re
        })
        .sum();
    let gain = sphere.weight / (sphere.gravity * sphere.momentum * sphere.earth_rate * sphere.latitude.cos());
    assert_relative_eq!(got, gain * area * step / PI, max_relative = 1e-5);
    // and as options: yaw changes the spread alone
    let asked = |also: &str| {
        let told = asked_json(&["--sea=jonswap", "--sea-from=60", &format!("--also={also}"), "--band=2.5"]);
        let row = &told["rows"][0];
        let number = |name: &str| row[name].as_f64().unwrap();
        ([number("mean_deg"), number("spread_deg")], told["note"].as_str().unwrap().to_owned())
    };
    let (plain, swaying, surging, yawing) = (asked("heave"), asked("sway"), asked("surge"), asked("yaw"));
    assert!((swaying.0[0] / plain.0[0] - 1.0).abs() > 0.1 && (surging.0[0] / plain.0[0] - 1.0).abs() > 0.01);
    assert_relative_eq!(yawing.0[0], plain.0[0], max_relative = 1e-9);
    assert!(yawing.1.contains("yaw changes no mean") && yawing.0[1] != plain.0[1]);
    for (also, from) in [("surge", "90"), ("yaw", "0"), ("sway", "180")] {
        let (code, _, message) =
            crate::roll_error::asked(&["--sea=pm", &format!("--also={also}"), &format!("--sea-from={from}")]);
        assert!(code == 2 && message.contains(&format!("excites {also}")), "{message}");
    }
}
