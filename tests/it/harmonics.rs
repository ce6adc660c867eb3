//! The deviation of a magnetic compass has parts of one and of two turns to a turn of the ship: two harmonics are two laws.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::Verdict;
use gyrospec::model::Model;
use gyrospec::record::Recording;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::fmt::Write as _;

#[test]
fn two_harmonics_of_a_heading_are_two_laws() {
    let mut text = "true [deg],magnetic [deg]\n".to_owned();
    let mut rng = ChaCha8Rng::seed_from_u64(8);
    for k in 0..36 {
        let (psi, error): (f64, f64) = (10.0 * f64::from(k), StandardNormal.sample(&mut rng));
        let (one, two) = (psi.to_radians(), 2.0 * psi.to_radians());
        // Archibald Smith's coefficients A to E
        let deviation = 2.0 + 3.0 * one.sin() - 2.0 * one.cos() + 1.5 * two.sin() + 0.5 * two.cos();
        let _ = writeln!(text, "{psi},{:.3}", psi + deviation + 0.1 * error);
    }
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name);
    std::fs::write(file("d.csv"), text).unwrap();
    std::fs::write(file("d.toml"), "name = \"d\"\nkind = \"trials\"\n[[tables]]\nfile = \"d.csv\"\n")
        .unwrap();
    let model = Model::parse(
        "name = \"compass\"\n[inputs]\ntrue = { unit = \"deg\" }\n[parameters]\nA = { value = 0, unit = \"deg\", fit = true }\n\
         [outputs]\nmagnetic = { equals = \"true + A\", unit = \"deg\" }\n",
    )
    .unwrap();
    let told = diagnosed(&model, Recording::read(file("d.toml")).unwrap()).answer;
    assert_eq!((told.verdict, told.findings.len()), (Verdict::Named, 2), "{}", told.says);
    assert!(told.findings.iter().all(|f| f.code == "cross-coupling"), "{}", told.says);
    let parts = |order: &str| told.findings.iter().find(|f| f.term.contains(order)).unwrap();
    for (term, truths) in [("sin(true)", [3.0, -2.0]), ("sin(2*true)", [1.5, 0.5])] {
        for (v, truth) in parts(term).parameters.iter().zip(truths) {
            assert!(
                (v.value - truth).abs() < 0.1 && v.low < truth && v.high > truth,
                "{term}: {}",
                told.says
            );
        }
    }
}
