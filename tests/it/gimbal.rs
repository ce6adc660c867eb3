//! What a gimbal reads of a base that moves at random: the integral, a quadrature, and two simulations.

use approx::assert_relative_eq;
use gyrospec::gyro::gimbal::{Demodulator, Gimbal, Noise, Run, State};
use gyrospec::lti::Discrete;
use num_complex::Complex64;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

const J: Complex64 = Complex64::I;

/// The coefficients of (1), written out from the bodies: inertia, stiffness, gyroscopic, drive.
fn coefficients(g: &Gimbal) -> ([f64; 2], [f64; 2], f64, [f64; 2]) {
    let [one, two, three] = g.bodies;
    let (x, y, z) = (one.x + two.x + three.x, one.y + two.y + three.y, one.z + two.z + three.z);
    let (h, w) = (g.momentum, g.speed);
    let first = g.springs[0] + h * w + (z - y - two.z + two.y) * w * w;
    let second = g.springs[1] + h * w + (z - x) * w * w;
    let turning = h + (z - y - x - two.z + two.y + two.x) * w;
    let drive = [h + (z - y + x - two.z + two.y - two.x) * w, h + (z + y - x) * w];
    ([x - two.x, y], [first, second], turning, drive)
}

/// a(ν): α = Re(a(ν) r̂ e^{j(Ω + ν)t}) for base rates Θ′ + jΨ′ = r̂ e^{jνt}, by Cramer's rule on (1).
fn scale(g: &Gimbal, nu: f64) -> Complex64 {
    let (inertia, stiffness, turning, drive) = coefficients(g);
    let s = J * (g.speed + nu);
    let [m11, m22] = [0, 1].map(|k| s * s * inertia[k] + s * g.damping[k] + stiffness[k]);
    let m12 = s * turning;
    // −A(Θ″ sin Ωt + Ψ″ cos Ωt) − E₁(Θ′ cos Ωt − Ψ′ sin Ωt) = Re((jA ṙ − E₁ r) e^{jΩt}), and β alike
    let up = J * inertia[0] * J * nu - drive[0];
    let side = -(inertia[1] * J * nu) - J * drive[1];
    (m22 * up - m12 * side) / (m11 * m22 + m12 * m12)
}

/// Both rates of the base and their derivatives every `step`: r″ + 2ζω₀r′ + ω₀²r = white noise.
fn random_base([sigma, w0, zeta]: [f64; 3], step: f64, count: usize) -> Vec<[f64; 4]> {
    let rate = faer::mat![[0.0, 1.0], [-w0 * w0, -2.0 * zeta * w0]];
    let kick = faer::mat![[0.0], [sigma * (4.0 * zeta * w0.powi(3)).sqrt()]];
    let mut both =
        [1u64, 2].map(|seed| (Discrete::new(&rate, &kick, step), ChaCha8Rng::seed_from_u64(seed), [0.0; 2]));
    let mut out = Vec::with_capacity(count);
    for _ in 0..count {
        for (discrete, rng, z) in &mut both {
            discrete.advance(z, rng);
        }
        out.push([both[0].2[0], both[1].2[0], both[0].2[1], both[1].2[1]]);
    }
    out
}

/// Half the mean square of |reading|, behind the first tenth.
fn deviation(read: &[(f64, f64)]) -> f64 {
    let kept = &read[read.len() / 10..];
    (kept.iter().map(|r| 0.5 * (r.0 * r.0 + r.1 * r.1)).sum::<f64>() / kept.len() as f64).sqrt()
}

/// (1) by the explicit midpoint rule, demodulated and low-passed twice by steps held constant.
fn apart(g: &Gimbal, base: &[[f64; 4]], half: f64, corner: f64) -> Vec<(f64, f64)> {
    let (inertia, stiffness, turning, drive) = coefficients(g);
    let rates = |y: [f64; 4], t: f64, [theta, psi, theta2, psi2]: [f64; 4]| {
        let (sin, cos) = (g.speed * t).sin_cos();
        let torque = [
            -inertia[0] * (theta2 * sin + psi2 * cos) - drive[0] * (theta * cos - psi * sin),
            -inertia[1] * (theta2 * cos - psi2 * sin) + drive[1] * (theta * sin + psi * cos),
        ];
        let alpha = (torque[0] - g.damping[0] * y[2] - stiffness[0] * y[0] - turning * y[3]) / inertia[0];
        let beta = (torque[1] - g.damping[1] * y[3] - stiffness[1] * y[1] + turning * y[2]) / inertia[1];
        [y[2], y[3], alpha, beta]
    };
    let still = scale(g, 0.0);
    let share = 1.0 - (-2.0 * half * corner).exp();
    let (mut y, mut first, mut second) = ([0.0; 4], Complex64::ZERO, Complex64::ZERO);
    let mut out = Vec::new();
    for k in 0..(base.len() - 2) / 2 {
        let t = 2.0 * k as f64 * half;
        let slope = rates(y, t, base[2 * k]);
        let middle = rates([0, 1, 2, 3].map(|i| y[i] + half * slope[i]), t + half, base[2 * k + 1]);
        y = [0, 1, 2, 3].map(|i| y[i] + 2.0 * half * middle[i]);
        let turned = 2.0 * y[0] * Complex64::from_polar(1.0, -g.speed * (t + 2.0 * half)) / still;
        first += share * (turned - first);
        second += share * (first - second);
        out.push((second.re, second.im));
    }
    out
}

#[test]
fn the_reading_of_a_shaken_base_is_the_integral_the_quadrature_and_both_simulations() {
    let gimbal = Gimbal::example();
    let (base, corner) = ([1e-3, 120.0, 0.05], 2.0);
    let said = gimbal.noise_equivalent(&Noise { torque: [0.0; 2], base: Some(base) }, corner).unwrap();

    // (1/2π) ∫ (|F(jν)|² + |F(j(ν + 2Ω))|²) |a(ν)/a(0)|² S(ν) dν by the rule of the midpoint
    let [sigma, w0, zeta] = base;
    let low = |w: f64| 1.0 / (1.0 + (w / corner).powi(2)).powi(2);
    let density = |nu: f64| {
        let shape = (w0 * w0 - nu * nu).powi(2) + (2.0 * zeta * w0 * nu).powi(2);
        sigma.powi(2) * 4.0 * zeta * w0.powi(3) / shape
            * (scale(&gimbal, nu) / scale(&gimbal, 0.0)).norm_sqr()
    };
    let step = 0.01;
    let (mut passed, mut folded) = (0.0, 0.0);
    for k in -300_000..300_000 {
        let nu = (f64::from(k) + 0.5) * step;
        let d = density(nu) * step / std::f64::consts::TAU;
        passed += d * low(nu);
        folded += d * low(2.0 * gimbal.speed + nu);
    }
    assert_relative_eq!(said.base_passed, passed.sqrt(), max_relative = 1e-4);
    assert_relative_eq!(said.base_folded, folded.sqrt(), max_relative = 1e-4);
    assert_relative_eq!(
        said.base.powi(2),
        said.base_passed.powi(2) + said.base_folded.powi(2),
        max_relative = 1e-12
    );

    let half = 1e-4;
    let duration = 300.0;
    let motion = random_base(base, half, (duration / half) as usize + 4);
    let run = Run { step: 2.0 * half, duration, noise: [0.0; 2], seed: 0 };
    let samples = gimbal
        .simulate(State::default(), &run, |t| {
            let [theta, psi, theta2, psi2] = motion[(t / half).round() as usize];
            ([theta, psi], [theta2, psi2])
        })
        .unwrap();
    let read = deviation(&Demodulator::new(&gimbal, corner).unwrap().rates(&samples));
    let alone = deviation(&apart(&gimbal, &motion, half, corner));
    println!(
        "base motion: integral {:.4e} (folded {:.3e}), simulated {read:.4e}, apart {alone:.4e}",
        said.base, said.base_folded
    );
    // some 300 s × 2 rad/s on two axes: one deviation is 2 to 3 %
    assert_relative_eq!(read, said.base, max_relative = 0.08);
    assert_relative_eq!(alone, said.base, max_relative = 0.08);
    assert_relative_eq!(alone, read, max_relative = 0.02);
}

#[test]
fn a_quiet_base_and_a_slow_one_are_told_apart() {
    let gimbal = Gimbal::example();
    let quiet = gimbal.noise_equivalent(&Noise { torque: [1e-18; 2], base: None }, 2.0).unwrap();
    assert_eq!((quiet.base, quiet.base_passed, quiet.base_folded), (0.0, 0.0, 0.0));
    // rates far below the corner are read as they are
    let slow = Noise { torque: [0.0; 2], base: Some([1e-3, 0.01, 0.7]) };
    let said = gimbal.noise_equivalent(&slow, 2.0).unwrap();
    assert_relative_eq!(said.base_passed, 1e-3, max_relative = 5e-3);
    assert!(said.base_folded < 1e-3 * said.base_passed);
}

/// Exit code and both outputs of `gyrospec gimbal` on a file of the given text.
fn called(file: &str, options: &[&str]) -> (i32, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("gimbal.toml");
    std::fs::write(&path, file).unwrap();
    let out = std::process::Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .arg("gimbal")
        .arg(&path)
        .args(options)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&out.stdout) + String::from_utf8_lossy(&out.stderr);
    (out.status.code().unwrap(), said.into_owned())
}

#[test]
fn each_wrong_number_is_named_with_what_is_wrong_about_it() {
    let cases: [(&str, &[&str]); 26] = [
        ("Ix1 = 0", &["Iz1 of 3.5e-6", "Ix1 and Iy1", "no body"]),
        ("Ix1 = 2", &["Ix1 of 2 kg*m^2", "g*cm^2"]),
        ("Ix1 = -1e-6", &["Ix1", "lies outside"]),
        ("Ix1 = nan", &["parameters.Ix1", "finite number"]),
        ("Ix1 = \"2\"", &["parameters.Ix1", "finite number", "string"]),
        ("Ix1 = [1]", &["parameters.Ix1", "finite number", "array"]),
        ("Ix1 = {}", &["parameters.Ix1 has no value", "value = "]),
        ("Ix1 = { unit = \"kg*m^2\" }", &["parameters.Ix1 has no value"]),
        ("Ix1 = { value = 2, units = \"kg*m^2\" }", &["parameters.Ix1", "\"units\"", "unit"]),
        ("Ix1 = { value = 20, unit = \"N\" }", &["Ix1", "N where kg*m^2 is meant"]),
        ("Ix1 = 0\nIy1 = 0\nIz1 = 0\nIx3 = 0\nIy3 = 0\nIz3 = 0", &["Ix1 + Ix3 must be positive"]),
        ("H = -2e-3", &["does not hold", "about α by -0.0", "cx above", "cy above"]),
        ("cx = -1", &["does not hold", "about α", "cx above"]),
        ("cy = -1\ndx = 0\ndy = 0", &["does not hold", "about β", "cy above"]),
        ("cx = { value = 0.02, unit = \"N/m\" }", &["cx", "N/m where N*m is meant"]),
        ("dx = -1", &["dx", "lies outside"]),
        ("dx = 0\ndy = 0", &["without damping", "dx or dy"]),
        ("dx = 1e-300\ndy = 0", &["dx = 1e-300", "too far apart"]),
        ("Omega = 0", &["Omega", "lies outside"]),
        ("Omega = 0.01", &["--corner", "2 rad/s", "0.01 rad/s"]),
        ("Omega = { value = 10, unit = \"Hz\" }", &["Omega", "turns or radians"]),
        ("zeta = 0", &["zeta", "lies outside"]),
        ("omega0 = -1", &["omega0", "lies outside"]),
        ("Qx = -1", &["Qx", "lies outside"]),
        ("omega = 3", &["`omega`", "did you mean Omega?"]),
        ("c_x = 1", &["`c_x`", "did you mean cx?"]),
    ];
    for (entry, words) in cases {
        let (code, said) = called(&format!("[parameters]\n{entry}\n"), &[]);
        assert!(code == 2 || (code == 3 && words.contains(&"too far apart")), "{entry}: {said}");
        assert!(words.iter().all(|w| said.contains(w)), "{entry}: {said}");
        assert!(said.contains("gimbal.toml") || words.contains(&"--corner") || !said.contains("parameters."));
    }
    for (file, words) in [
        ("Ix1 = 1e-6", ["`Ix1`", "[parameters]"]),
        ("[parameter]\nH = 1", ["`parameter`", "parameters"]),
        ("parameters = 3", ["parameters must be a table", "integer"]),
        ("a,b\n1,2", ["no TOML", "gimbal.toml"]),
    ] {
        let (code, said) = called(file, &[]);
        assert!(code == 2 && words.iter().all(|w| said.contains(w)), "{file}: {said}");
    }
}

#[test]
fn a_corner_is_a_rate_below_the_rings() {
    for (corner, words) in [
        ("0", "lies outside"),
        ("-1", "lies outside"),
        ("nan", "no quantity"),
        ("1e-9", "lies outside"),
        ("60", "does not lie below the ring's speed, 60 rad/s"),
        ("5Hz", "turns or radians"),
        ("2m", "m where rad/s is meant"),
        ("", "no quantity"),
    ] {
        let (code, said) = called("", &["--corner", corner]);
        assert!(code == 2 && said.contains("--corner") && said.contains(words), "{corner}: {said}");
    }
    assert_eq!(called("", &["--corner", "2rad/s"]), called("", &["--corner", "2"]));
    assert_eq!(called("", &["--corner", "3", "--json"]).0, 0);
}

#[test]
fn a_manoeuvre_of_too_many_steps_is_not_drawn_and_the_figures_stand() {
    for file in ["[parameters]\ncx = 1e5\n", "[parameters]\nH = 2000\n"] {
        let (code, said) = called(file, &[]);
        assert!(
            code == 0 && said.contains("No manoeuvre is drawn") && said.contains("scale factor"),
            "{said}"
        );
    }
    let (code, said) = called("", &["--corner", "1e-3"]);
    assert!(code == 0 && said.contains("No manoeuvre is drawn"), "{said}");
    let run = Run { step: 1e-6, duration: 1e6, noise: [0.0; 2], seed: 0 };
    assert!(Gimbal::example().simulate(State::default(), &run, |_| ([0.0; 2], [0.0; 2])).is_err());
}
