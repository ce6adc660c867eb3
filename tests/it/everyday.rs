//! What stands in files as people have them: headings that pass north unmarked, degrees Fahrenheit, codes for what was not
//! measured, capital letters, names that a language has taken.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::Verdict;
use gyrospec::diagnose::{Request, diagnose};
use gyrospec::estimate::fit::Silent;
use gyrospec::record::Span;
use gyrospec::record::quality::{self, FaultKind};
use gyrospec::{Model, Recording, fit, simulate};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::fmt::Write as _;

fn recording(table: &str) -> gyrospec::Result<Recording> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("table.csv");
    std::fs::write(&file, table).unwrap();
    Recording::read(&file)
}

const RECKONING: &str = "name = \"dead reckoning\"\n[inputs]\nheading = { unit = \"deg\" }\n[parameters]\n\
    v = { value = 4.5, unit = \"m/s\", fit = true }\n[states]\n\
    n = { rate = \"v*cos(heading)\", unit = \"m\", initial = 0 }\n[outputs]\nnorth = { equals = \"n\", unit = \"m\" }\n";

/// A heading that passes north runs back through south between two samples: simulated and fitted, that is told, and it is
/// not taken for a held input.
#[test]
fn a_heading_that_passes_north_unmarked_is_told() {
    let mut table = String::from("t [s],heading [deg],north [m]\n");
    let (mut north, mut last) = (0.0, 0.0);
    for i in 0..120 {
        let heading: f64 = 340.0 + 0.35 * f64::from(i);
        // sine and cosine of a straight heading, integrated exactly
        let turned = |h: f64| h.to_radians().sin() / 0.035_f64.to_radians();
        north += if i > 0 { 5.0 * (turned(heading) - turned(last)) } else { 0.0 };
        last = heading;
        let _ = writeln!(table, "{},{},{}", 10 * i, heading % 360.0, north + 0.1 * f64::from(i % 3 - 1));
    }
    let (model, recording) = (Model::parse(RECKONING).unwrap(), recording(&table).unwrap());
    let ran = simulate(&model, &recording).run().unwrap().warnings().join("; ");
    assert!(ran.contains("jumps by a turn"), "{ran}");
    let fitted = fit(&model, std::slice::from_ref(&recording)).run().unwrap();
    let told: Vec<&str> = fitted.warnings().collect();
    assert!(told.iter().any(|w| w.contains("jumps by a turn")), "{told:?}");
    assert!(!told.iter().any(|w| w.contains("is held")), "{told:?}");
}

#[test]
fn a_unit_that_the_list_does_not_have_is_told_as_such() {
    for table in [
        "t [s],Temp (°F)\n0,70\n1,71\n2,72\n",
        "t;Temp\ns;°F\n0;70\n1;71\n2;72\n",
        "t,p,x\ns,inHg,m\n0,30,1\n1,30.1,2\n2,30.2,3\n",
    ] {
        let told = match recording(table) {
            Ok(r) => r.left_out.iter().map(|l| l.why.clone()).collect::<Vec<_>>().join("; "),
            Err(e) => format!("{e}; {}", e.hint().unwrap_or_default()),
        };
        assert!(told.contains("unknown unit"), "{table}{told}");
    }
}

#[test]
fn degrees_fahrenheit_beside_celsius_are_left_out_alone() {
    let told = recording("t [s],Temp (°C),Temp (°F)\n0,20,68\n1,21,69.8\n2,22,71.6\n").unwrap();
    let names: Vec<&str> = told.channels.iter().map(|c| c.name.as_str()).collect();
    assert_eq!((&names[..], told.left_out.len()), (&["Temp"][..], 1));
}

/// A code for what was not measured is found at any share, and a signal that really goes there is none.
#[test]
fn a_code_for_what_was_not_measured_is_found_at_any_share() {
    for (every, codes) in [(7, 58), (2, 200), (400, 1)] {
        let mut table = String::from("t [s],x [deg]\n");
        for i in 0..400 {
            let x = if i % every == 0 { -9999.0 } else { (0.1 * f64::from(i)).sin() };
            let _ = writeln!(table, "{i},{x}");
        }
        let found = quality::faults(&recording(&table).unwrap());
        let fault = found.iter().find(|f| f.kind == FaultKind::Outliers).expect("outliers");
        assert_eq!(fault.samples, codes);
    }
    let mut table = String::from("t [s],x [N]\n");
    (0..400).for_each(|i| {
        let _ = writeln!(table, "{i},{}", -9999.0 + 20.0 * f64::from(i % 50));
    });
    assert!(quality::faults(&recording(&table).unwrap()).iter().all(|f| f.kind != FaultKind::Outliers));
}

/// Towards a pole of the solution there is no figure for the solver's error: x' = x² from 1 is 1/(1 − t).
#[test]
fn a_run_that_blows_up_has_no_solver_error() {
    let model = Model::parse(
        "name = \"pole\"\n[inputs]\nu = { unit = \"1/s\" }\n[states]\nx = { rate = \"u*x^2\", unit = \"1\", initial = 1 }\n\
         [outputs]\ny = { equals = \"x\", unit = \"1\" }\n",
    );
    let mut table = String::from("t [s],u [1/s],y [1]\n");
    (0..40).for_each(|i| {
        let _ = writeln!(table, "{},1,1", 0.05 * f64::from(i));
    });
    let ran = simulate(&model.unwrap(), &recording(&table).unwrap()).run().unwrap();
    assert!(ran.solver_error().is_nan() && ran.warnings().join(" ").contains("blows up"));
    let before = ran.output("y").unwrap().predicted().nth(10).unwrap();
    assert!((before - 2.0).abs() < 1e-3, "{before}");
}

const LAG: &str = "name = \"lag\"\n[inputs]\nu = { unit = \"V\" }\n[parameters]\n\
    T = { value = 1.4, unit = \"s\", fit = true, min = 0.01, max = 100 }\n[states]\n\
    x = { rate = \"(u - x)/T\", unit = \"V\", initial = 0 }\n[outputs]\ny = { equals = \"x\", unit = \"V\" }\n";

/// Rows t, u, y of a lag of 2 s that starts at 0: x' = (u - x)/T with u a sum of a sin wt has
/// x = sum of a (sin wt - wT cos wt + wT e^(-t/T))/(1 + w^2 T^2); beside it noise of 0.005 V.
fn lagging(change: impl Fn(usize, [f64; 3]) -> [f64; 3]) -> String {
    let mut table = String::from("t [s],u [V],y [V]\n");
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    for i in 0..1600 {
        let t = 0.05 * i as f64;
        let (mut u, mut x) = (0.0, 0.0);
        for (a, w) in [(1.0, 0.7), (0.5, 1.9), (0.3, 0.23)] {
            let by: f64 = 2.0 * w;
            u += a * (w * t).sin();
            x += a * ((w * t).sin() - by * (w * t).cos() + by * (-t / 2.0).exp()) / (1.0 + by * by);
        }
        let noise: f64 = StandardNormal.sample(&mut rng);
        let [t, u, y] = change(i, [t, u, x + 0.005 * noise]);
        let _ = writeln!(table, "{t:.2},{u:.6},{y:e}");
    }
    table
}

#[test]
fn a_code_for_nothing_measured_is_no_command_either() {
    let spoiled = |i: usize, [t, u, y]: [f64; 3]| [t, if i % 500 == 200 { -9999.0 } else { u }, y];
    let a = diagnosed(&Model::parse(LAG).unwrap(), recording(&lagging(spoiled)).unwrap()).answer;
    assert!(a.findings.iter().all(|f| f.code == "outliers" && f.site.name == "u"), "{}", a.says);
    assert!(a.faults.iter().any(|f| f.finding.code == "outliers" && f.masked), "{}", a.says);
    let [t] = a.parameters.iter().filter(|p| p.name == "T").collect::<Vec<_>>()[..] else { panic!() };
    assert!((t.after - 2.0).abs() < 0.02, "{}", t.after);
}

/// Where the first part is held out, the state is no longer where the recording began.
#[test]
fn what_is_fitted_may_begin_in_motion() {
    let mut later = recording(&lagging(|_, row| row)).unwrap();
    later = later.with_spans(vec![Span::new(21.2, 80.0)], vec![Span::new(0.0, 21.15)]);
    let a = diagnosed(&Model::parse(LAG).unwrap(), later).answer;
    assert_eq!(a.verdict, Verdict::NothingMissing, "{}", a.says);
    assert!(a.notes.iter().any(|n| n.contains("what is fitted begins later")), "{:?}", a.notes);
}

#[test]
fn what_has_no_square_is_refused() {
    let huge = recording(&lagging(|_, [t, u, y]| [t, u, y * 1e200])).unwrap();
    let request = Request {
        model: &Model::parse(LAG).unwrap(),
        source: None,
        recordings: &[huge],
        separate: &[],
        time_limit: None,
        seed: 1,
        progress: &Silent,
    };
    let told = diagnose(&request).map(|d| d.answer.says).unwrap_err().to_string();
    assert!(told.contains("beyond the largest number"), "{told}");
}
