//! `gyrospec pendulous`: its figures beside simulations of the equations that share no code with it, and what it
//! refuses.

use approx::assert_relative_eq;
use serde_json::Value;
use std::process::Command;

fn called(words: &str) -> (i32, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gyrospec"));
    let out = command.arg("pendulous").args(words.split(' ')).output().unwrap();
    let said = String::from_utf8_lossy(&out.stdout) + String::from_utf8_lossy(&out.stderr);
    (out.status.code().unwrap(), said.into_owned())
}

fn said(words: &str) -> Value {
    let (code, said) = called(&format!("{words} --json"));
    assert_eq!(code, 0, "{words}: {said}");
    serde_json::from_str(&said).unwrap()
}

fn number(of: &Value, at: &str) -> f64 {
    of.pointer(at).and_then(Value::as_f64).unwrap_or_else(|| panic!("{at} in {of}"))
}

const RADIUS: f64 = 6.371e6;
const KNOT: f64 = 1852.0 / 3600.0;

/// The compass of an answer: B/H, ε, τ, φ (rad), g, U.
fn compass(told: &Value) -> [f64; 6] {
    let at = |name: &str| number(told, &format!("/compass/{name}"));
    let latitude = at("lat_deg").to_radians();
    [at("B_Nm") / at("H_Nms"), at("offset_rad"), at("flow_s"), latitude, at("g_m_per_s2"), at("U_rad_per_s")]
}

/// One step of Runge and Kutta's method of fourth order.
fn stepped<const N: usize>(y: &[f64; N], h: f64, rates: &dyn Fn(&[f64; N]) -> [f64; N]) -> [f64; N] {
    let plus = |k: &[f64; N], h: f64| -> [f64; N] { std::array::from_fn(|i| y[i] + h * k[i]) };
    let k1 = rates(y);
    let k2 = rates(&plus(&k1, 0.5 * h));
    let k3 = rates(&plus(&k2, 0.5 * h));
    let k4 = rates(&plus(&k3, h));
    std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]))
}

/// α after sixty hours of steady speed (north, east), degrees.
fn settled(told: &Value, [north, east]: [f64; 2]) -> f64 {
    let [b, offset, flow, latitude, _, earth] = compass(told);
    let rates = |y: &[f64; 3]| {
        let vertical = earth * latitude.sin() + east * latitude.tan() / RADIUS;
        let level = earth * latitude.cos() + east / RADIUS;
        [b * y[2] - vertical, north / RADIUS - level * y[0] - b * offset * y[2], (y[1] - y[2]) / flow]
    };
    let mut y = [0.1, 0.0, 0.0];
    for _ in 0..60 * 360 {
        y = stepped(&y, 10.0, &rates);
    }
    y[0].to_degrees()
}

#[test]
fn it_settles_where_a_simulation_does_and_a_corrector_takes_off_what_it_is_set_to() {
    for words in [
        "--latitude 50 --speed 15kn",
        "--latitude 33°30'S --offset 2deg --flow 90s --speed -8kn --ballistic 0.4",
    ] {
        let told = said(&format!("{words} --corrector 45,12kn"));
        let set = said(&words.replace("--latitude 50", "--latitude 45").replace("33°30'S", "45N"));
        // the corrector's own figures are those of a compass at what is set
        let rows = told["rows"].as_array().unwrap();
        assert_eq!(rows.len(), 12);
        for row in rows.iter().step_by(2) {
            let heading = number(row, "/heading_deg").to_radians();
            let speed = number(&told, "/speed_m_per_s");
            let truth = settled(&told, [speed * heading.cos(), speed * heading.sin()]);
            assert_relative_eq!(number(row, "/settled_deg"), truth, epsilon = 1e-6);
            let parts = number(row, "/by_speed_deg") + number(row, "/by_damping_deg");
            assert_relative_eq!(parts, truth, epsilon = 1e-6);
            let mut there = set.clone();
            for name in ["B_Nm", "H_Nms"] {
                there["compass"][name] = told["compass"][name].clone();
            }
            let taken = settled(&there, [12.0 * KNOT * heading.cos(), 12.0 * KNOT * heading.sin()]);
            assert_relative_eq!(number(row, "/corrected_deg"), truth - taken, epsilon = 1e-6);
        }
    }
    // set right it leaves nothing; at rest the damping's error goes as tan φ, on both sides of the equator
    let right = said("--latitude 60 --speed 10kn --corrector 60,10kn --heading 20");
    assert_eq!(number(&right, "/rows/0/corrected_deg"), 0.0);
    let rest = said("--latitude 60S --offset 0.02");
    assert_relative_eq!(
        number(&rest, "/rows/0/settled_deg"),
        (0.02 * 3f64.sqrt()).to_degrees(),
        max_relative = 1e-9
    );
    assert_eq!(rest["rows"].as_array().unwrap().len(), 1);
    assert_relative_eq!(
        number(&rest, "/by_latitude/3/by_damping_deg"),
        (0.02 / 3f64.sqrt()).to_degrees(),
        max_relative = 1e-9
    );
}

/// The standard deviation of α − v/(R U cos φ), degrees, by the equation of the covariance Ṗ = A P + P Aᵀ + Q followed
/// in time. With c = b − v/(g τ) no white noise enters but in v̇ = −v/T + σ√(2/T) w.
fn spread(told: &Value) -> f64 {
    let [b, offset, flow, latitude, g, earth] = compass(told);
    let (sigma, time) = (number(told, "/manoeuvres/deviation_m_per_s"), number(told, "/manoeuvres/time_s"));
    let (north, throw) = (earth * latitude.cos(), 1.0 / (g * flow));
    // y = (α, β, c, v)
    let a = [
        [0.0, 0.0, b, b * throw],
        [-north, 0.0, -b * offset, 1.0 / RADIUS - b * offset * throw],
        [0.0, 1.0 / flow, -1.0 / flow, -throw / flow],
        [0.0, 0.0, 0.0, -1.0 / time],
    ];
    let rates = |p: &[f64; 16]| -> [f64; 16] {
        std::array::from_fn(|at| {
            let (i, j) = (at / 4, at % 4);
            let each = (0..4).map(|k| a[i][k] * p[4 * k + j] + p[4 * i + k] * a[j][k]);
            each.sum::<f64>() + if at == 15 { 2.0 * sigma * sigma / time } else { 0.0 }
        })
    };
    let mut p = [0.0; 16];
    p[15] = sigma * sigma;
    for _ in 0..40 * 3600 / 5 {
        p = stepped(&p, 5.0, &rates);
    }
    let per_v = 1.0 / (RADIUS * north);
    (p[0] - 2.0 * per_v * p[3] + per_v * per_v * p[15]).sqrt().to_degrees()
}

#[test]
fn manoeuvres_spread_it_as_its_covariance_in_time_says() {
    for words in [
        "--latitude 55 --manoeuvres 15kn,10min",
        "--latitude 60 --tuned-at 45 --manoeuvres 4m/s,2h",
        "--latitude -20 --offset 4deg --flow 150s --manoeuvres 8kn,100s",
    ] {
        let told = said(words);
        assert_relative_eq!(number(&told, "/spread_deg"), spread(&told), max_relative = 1e-5);
        // at another latitude it is that of the same compass there
        let there = said(&format!(
            "--latitude 70 --manoeuvres {} --offset {} --flow {} --ballistic {}",
            words.rsplit(' ').next().unwrap(),
            number(&told, "/compass/offset_rad"),
            number(&told, "/compass/flow_s"),
            number(&told, "/compass/B_Nm"),
        ));
        let at = if number(&told, "/compass/lat_deg") < 0.0 { -70.0 } else { 70.0 };
        assert_relative_eq!(number(&told, "/by_latitude/7/lat_deg"), at, max_relative = 1e-12);
        assert_relative_eq!(
            number(&told, "/by_latitude/7/spread_deg"),
            number(&there, "/spread_deg"),
            max_relative = 1e-9
        );
    }
}

#[test]
fn its_swing_is_that_of_a_simulation_left_alone() {
    let told = said("--latitude 50 --offset 0.05 --flow 60s");
    let [b, offset, flow, latitude, _, earth] = compass(&told);
    let level = earth * latitude.cos();
    let rates = |y: &[f64; 3]| [b * y[2], -level * y[0] - b * offset * y[2], (y[1] - y[2]) / flow];
    // the zeros of α after the liquid has come to rest, and how far it swings between them
    let (mut y, mut zeros, mut swings, mut largest) = ([0.1, 0.0, 0.0], Vec::new(), Vec::new(), 0.0f64);
    for k in 0..40 * 3600 {
        let next = stepped(&y, 1.0, &rates);
        if next[0].signum() != y[0].signum() {
            zeros.push(f64::from(k) + y[0] / (y[0] - next[0]));
            swings.push(std::mem::take(&mut largest));
        }
        largest = largest.max(next[0].abs());
        y = next;
    }
    let period = 2.0 * (zeros[6] - zeros[2]) / 4.0;
    assert_relative_eq!(number(&told, "/damped_period_s"), period, max_relative = 1e-6);
    let decay = (zeros[6] - zeros[2]) / (swings[3] / swings[7]).ln();
    assert_relative_eq!(number(&told, "/decay_s"), decay, max_relative = 1e-5);
    assert_relative_eq!(number(&told, "/undamped_period_s") / 60.0, 84.4, epsilon = 0.1);
}

#[test]
fn words_and_a_page_say_what_and_which_way() {
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("p.html");
    let (code, text) = called(&format!(
        "--latitude 60 --speed 15kn --corrector 55,12kn --manoeuvres 8kn,15min --html {}",
        page.display()
    ));
    assert_eq!(code, 0, "{text}");
    for words in [
        "undamped period 84.4 min",
        "corrected",
        "spreads by ±",
        "reads low",
        "same compass elsewhere",
        "sign: +",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let page = std::fs::read_to_string(page).unwrap();
    assert!(page.contains("behind its corrector") && page.matches("<figure").count() == 3, "{page}");
    // far north the error by the damping is no small angle
    assert!(called("--latitude 82").1.contains("BEYOND THE LINEAR THEORY"));
    assert_eq!(said("--latitude 82")["linear_theory_holds"], Value::Bool(false));
    // a slow flow settles nowhere near the equator, and that is no figure
    let slow = said("--latitude 70 --flow 800s");
    assert!(
        slow["by_latitude"][0]["by_damping_deg"].is_null()
            && slow["by_latitude"][8]["by_damping_deg"].is_number()
    );
}

#[test]
fn what_is_of_no_use_or_out_of_reach_is_refused_with_its_reason() {
    for (words, says) in [
        ("--speed 3kn", "--latitude"),
        ("--latitude 50 --heading 20", "--heading is of no use"),
        ("--latitude 50 --corrector 50", "takes 2 numbers"),
        ("--latitude 50 --corrector 95,3kn", "lies outside"),
        ("--latitude 50 --manoeuvres 8kn", "takes 2 numbers"),
        ("--latitude 50 --manoeuvres 0,600s", "lies outside"),
        ("--latitude 50 --manoeuvres -8kn,600s", "lies outside"),
        ("--latitude 50 --offset 2", "did you mean 2deg?"),
        ("--latitude 50 --offset -0.03", "lies outside"),
        ("--latitude 50 --flow -60s", "lies outside"),
        ("--latitude 50 --flow 800s", "does not settle"),
        ("--latitude 50 --momentum 0", "lies outside"),
        ("--latitude 50 --ballistic 0", "lies outside"),
        ("--latitude 50 --ballistic 0.3 --tuned-at 40", "cannot be used with"),
        ("--latitude 89.9 --speed 40kn --heading 270", "going west"),
        ("--latitude 50 --speed 1kn --corrector 89.9,40kn --heading 270", "going west"),
        ("--latitude 50 --html - --json", "one result"),
    ] {
        let (code, said) = called(words);
        assert!(code == 2 && said.contains(says), "{words}: {said}");
    }
}
