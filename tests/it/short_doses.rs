//! A drug of two compartments over a day of 97 rows: intervals beyond the starts, and a dose that ends once.

use faer::linalg::solvers::DenseSolveCore;
use gyrospec::diagnose::answer::Answer;
use gyrospec::diagnose::{Request, diagnose};
use gyrospec::estimate::fit::Silent;
use gyrospec::model::Model;
use gyrospec::record::{Channel, Hold, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::fmt::Write;
use std::process::Command;

const ONE: &str = "name = \"one compartment\"\n[inputs]\ninfusion = { unit = \"mg/h\" }\n[parameters]\n\
    V = { value = 30, unit = \"l\", fit = true, min = 1, max = 300 }\n\
    CL = { value = 3, unit = \"l/h\", fit = true, min = 0.01, max = 100 }\n\
    [states]\nA = { rate = \"infusion - CL*A/V\", unit = \"mg\", initial = 0 }\n\
    [outputs]\nconc = { equals = \"A/V\", unit = \"mg/l\" }\n";
/// l, l/h, 1/h, h: volume, clearance, coupling to the second store and its time.
const TRUE: [f64; 4] = [20.0, 5.0, 0.2, 7.5];
/// Rows a quarter of an hour apart, and steps of the reckoning between them.
const ROWS: usize = 97;
const FINE: usize = 60;
/// mg/h, h: doses of three patients.
const DOSES: [[f64; 2]; 3] = [[100.0, 2.0], [200.0, 1.0], [60.0, 6.0]];
const NOISE: f64 = 0.1;

fn infused([rate, until]: [f64; 2], row: usize) -> f64 {
    if 0.25 * (row as f64) < until { rate } else { 0.0 }
}

/// A' = u − CL A/V − c (A − B), B' = (A − B)/τ by steps of the midpoint rule, mg/l at each row.
fn course(dose: [f64; 2], [v, cl, c, tau]: [f64; 4]) -> Vec<f64> {
    let (mut a, mut b, mut rows) = (0.0, 0.0, Vec::new());
    let h = 0.25 / FINE as f64;
    for row in 0..ROWS {
        rows.push(a / v);
        let u = infused(dose, row);
        let rates = |a: f64, b: f64| (u - cl * a / v - c * (a - b), (a - b) / tau);
        for _ in 0..FINE {
            let (da, db) = rates(a, b);
            let (da, db) = rates(a + 0.5 * h * da, b + 0.5 * h * db);
            (a, b) = (a + h * da, b + h * db);
        }
    }
    rows
}

fn measured(dose: [f64; 2], seed: u64) -> Vec<f64> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let noise = |c: f64| -> f64 {
        let e: f64 = StandardNormal.sample(&mut rng);
        c + NOISE * e
    };
    course(dose, TRUE).into_iter().map(noise).collect()
}

fn patient(dose: [f64; 2], seed: u64) -> Recording {
    let time: Vec<f64> = (0..ROWS).map(|k| 900.0 * k as f64).collect();
    let channel = |name: &str, unit: &str, values: Vec<f64>, hold| {
        let unit = Unit::parse(unit).unwrap();
        let values = values.into_iter().map(|x| unit.to_si(x)).collect();
        Channel { hold, ..Channel::new(name, unit, time.clone(), values) }
    };
    let infusion = (0..ROWS).map(|k| infused(dose, k)).collect();
    let channels = vec![
        channel("infusion", "mg/h", infusion, Hold::Previous),
        channel("conc", "mg/l", measured(dose, seed), Hold::Linear),
    ];
    Recording::from_channels("patient", channels).unwrap()
}

/// 1.96 times the standard deviation of τ, h, from the products of differences in the four parameters.
fn half_width() -> f64 {
    let mut products = faer::Mat::<f64>::zeros(4, 4);
    for dose in DOSES {
        let moved = |k: usize, by: f64| {
            let mut p = TRUE;
            p[k] *= 1.0 + by;
            course(dose, p)
        };
        let slope = |k: usize| -> Vec<f64> {
            moved(k, 1e-4).iter().zip(moved(k, -1e-4)).map(|(a, b)| (a - b) / 2e-4).collect()
        };
        let slopes: Vec<Vec<f64>> = (0..4).map(slope).collect();
        for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
            products[(i, j)] += slopes[i].iter().zip(&slopes[j]).map(|(a, b)| a * b).sum::<f64>();
        }
    }
    let inverse = products.partial_piv_lu().inverse();
    1.96 * NOISE * TRUE[3] * inverse[(3, 3)].sqrt()
}

fn found() -> Answer {
    let model = Model::parse(ONE).unwrap();
    let all: Vec<Recording> = DOSES.iter().zip(1..).map(|(d, seed)| patient(*d, seed)).collect();
    let separate = [patient([400.0, 0.5], 9)];
    let request = Request {
        model: &model,
        source: None,
        recordings: &all,
        separate: &separate,
        time_limit: None,
        seed: 1,
        progress: &Silent,
    };
    diagnose(&request).unwrap().answer
}

#[test]
fn the_interval_of_a_time_beyond_all_starts_is_that_of_its_curvature() {
    let answer = found();
    let [store] = &answer.findings[..] else { panic!("{}", answer.says) };
    assert_eq!((store.code.as_str(), store.site.name.as_str()), ("extra-lag", "A"), "{}", answer.says);
    let tau = store.parameters.iter().find(|p| p.name.starts_with("tau")).unwrap();
    let (low, high) = (tau.low / 3600.0, tau.high / 3600.0);
    assert!(low < TRUE[3] && TRUE[3] < high, "{low} to {high} h");
    let (wide, wanted) = (0.5 * (high - low), half_width());
    assert!((0.6..1.7).contains(&(wide / wanted)), "± {wide} h for {wanted}");
}

/// The infusion of one file leaps once: read as straight lines it goes on for a quarter of an hour, falling.
#[test]
fn a_dose_that_ends_once_is_read_as_held_by_a_fit_and_told_of_by_a_simulation() {
    let folder = tempfile::tempdir().unwrap();
    let two = ONE
        .replace("infusion - CL*A/V", "infusion - CL*A/V - c*(A - B)")
        .replace("value = 30", "value = 20")
        .replace("value = 3,", "value = 5,")
        .replace("[states]\n", "c = { value = 0.2, unit = \"1/h\" }\ntau = { value = 7.5, unit = \"h\" }\n[states]\nB = { rate = \"(A - B)/tau\", unit = \"mg\", initial = 0 }\n");
    std::fs::write(folder.path().join("m.toml"), two).unwrap();
    let (dose, mut rows) = (DOSES[1], String::from("time [h],infusion [mg/h],conc [mg/l]\n"));
    for (k, c) in measured(dose, 3).iter().enumerate() {
        let _ = writeln!(rows, "{},{},{c:.4}", 0.25 * k as f64, infused(dose, k));
    }
    std::fs::write(folder.path().join("r.csv"), rows).unwrap();
    let run = |command: &str| {
        let mut program = Command::new(env!("CARGO_BIN_EXE_gyrospec"));
        let out = program.args([command, "m.toml", "r.csv"]).current_dir(folder.path()).output().unwrap();
        assert_eq!(out.status.code(), Some(0), "{out:?}");
        (String::from_utf8(out.stdout).unwrap(), String::from_utf8(out.stderr).unwrap())
    };
    let (said, warned) = run("fit");
    assert!(warned.contains("infusion is held between its samples, and was read so"), "{warned}");
    let left = said.lines().find(|l| l.trim_start().starts_with("conc")).unwrap();
    let left: f64 = left.split_whitespace().nth(1).unwrap().parse().unwrap();
    assert!((left / NOISE - 1.0).abs() < 0.2, "{said}");
    let warned = run("simulate").1;
    assert!(warned.contains("held, the run comes nearer to what was measured"), "{warned}");
}
