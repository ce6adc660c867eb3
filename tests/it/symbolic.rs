//! The tables of I_n: exact at rational points, free of common factors, and as code in three languages.

use dashu_ratio::RBig;
use gyrospec::integral::exact::rational as rational_engine;
use gyrospec::integral::{Integrand, evaluate};
use gyrospec::symbolic::{Polynomial, Program, Table, folder, print_tables};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::path::{Path, PathBuf};
use std::process::Command;

fn rational(numerator: i64, denominator: i64) -> RBig {
    RBig::from_parts(numerator.into(), (denominator as u64).into())
}

/// A stable H with distinct rational roots and a random G, with I_n by residues: an exact value that
/// knows nothing of determinants. I = Σ G(−r) / (H'(−r) H(r)) over the roots −r of H.
struct Point {
    a: Vec<RBig>,
    b: Vec<RBig>,
    value: RBig,
}

impl Point {
    fn random(n: usize, random: &mut ChaCha8Rng) -> Self {
        let mut roots: Vec<RBig> = Vec::new();
        while roots.len() < n {
            let root = rational(random.random_range(1..30), random.random_range(1..6));
            if !roots.contains(&root) {
                roots.push(root);
            }
        }
        let lead = rational(random.random_range(1..9), 7);
        let b: Vec<RBig> = (0..n).map(|_| rational(random.random_range(-20..20), 3)).collect();
        Self::new(&lead, &roots, b)
    }

    fn new(lead: &RBig, roots: &[RBig], b: Vec<RBig>) -> Self {
        let mut a = vec![lead.clone()];
        for root in roots {
            a.push(RBig::ZERO);
            for k in (1..a.len()).rev() {
                a[k] = &a[k] + root * &a[k - 1];
            }
        }
        let horner = |c: &[RBig], x: &RBig| c.iter().fold(RBig::ZERO, |sum, c| sum * x + c);
        let residue = |r: &RBig| {
            let slope = roots.iter().filter(|other| *other != r).map(|other| other - r);
            horner(&b, &(r * r)) / (slope.fold(lead.clone(), |product, x| product * x) * horner(&a, r))
        };
        let value = roots.iter().map(residue).fold(RBig::ZERO, |sum, x| sum + x);
        Self { a, b, value }
    }
}

fn exact_value(polynomial: &Polynomial, at: &[RBig]) -> RBig {
    let ring = polynomial.ring();
    let term = |(monomial, coefficient): &(_, gyrospec::symbolic::Integer)| {
        ring.powers(*monomial)
            .fold(RBig::from(coefficient.to_big()), |product, (k, e)| product * at[k].pow(e as isize))
    };
    polynomial.terms().iter().map(term).fold(RBig::ZERO, |sum, x| sum + x)
}

#[test]
fn every_printed_order_is_exact_at_random_rational_points() {
    let mut random = ChaCha8Rng::seed_from_u64(1947);
    for n in 1..=12 {
        let (table, program) = (Table::new(n).unwrap(), Program::new(n).unwrap());
        for _ in 0..if n <= 9 { 12 } else { 2 } {
            let point = Point::random(n, &mut random);
            let (above, below) = program.evaluate(&point.a, &point.b);
            assert_eq!(&above / &below, point.value, "shared minors, n = {n}");
            assert_eq!(rational_engine(&point.a, &point.b).unwrap(), point.value, "the engine, n = {n}");
            let at = [point.a.as_slice(), point.b.as_slice()].concat();
            assert_eq!(exact_value(&table.numerator, &at), above, "numerator, n = {n}");
            assert_eq!(exact_value(&table.denominator, &at), below, "denominator, n = {n}");
        }
    }
    for n in 13..=14 {
        let point = Point::random(n, &mut random);
        let (above, below) = Program::new(n).unwrap().evaluate(&point.a, &point.b);
        assert_eq!(above / below, point.value, "shared minors, n = {n}");
    }
}

const PRIME: i128 = 2_147_483_647;

/// The coefficients in one symbol, all others set to numbers, modulo a prime.
fn image(polynomial: &Polynomial, symbol: usize, at: &[i128]) -> Vec<i128> {
    let ring = polynomial.ring();
    let mut image = vec![0; polynomial.degree(symbol) as usize + 1];
    for (monomial, coefficient) in polynomial.terms() {
        let mut value: i128 = coefficient.to_string().parse().unwrap();
        for (k, e) in ring.powers(*monomial).filter(|(k, _)| *k != symbol) {
            value = (0..e).fold(value, |v, _| v * at[k] % PRIME);
        }
        let place = &mut image[ring.exponent(*monomial, symbol) as usize];
        *place = (*place + value).rem_euclid(PRIME);
    }
    image
}

fn gcd_degree(mut x: Vec<i128>, mut y: Vec<i128>) -> usize {
    let trim = |p: &mut Vec<i128>| {
        while p.last() == Some(&0) {
            p.pop();
        }
    };
    trim(&mut x);
    trim(&mut y);
    while !y.is_empty() {
        let inverse = (0..31).fold((1, *y.last().unwrap(), PRIME - 2), |(r, base, e), _| {
            (if e & 1 == 1 { r * base % PRIME } else { r }, base * base % PRIME, e >> 1)
        });
        while x.len() >= y.len() {
            let (factor, shift) = (x.last().unwrap() * inverse.0 % PRIME, x.len() - y.len());
            for (k, c) in y.iter().enumerate() {
                x[k + shift] = (x[k + shift] - factor * c).rem_euclid(PRIME);
            }
            x.pop();
            trim(&mut x);
        }
        std::mem::swap(&mut x, &mut y);
    }
    x.len() - 1
}

/// A common factor would show in the image of at least one of its symbols; lead coefficients do not vanish there.
#[test]
fn no_common_factor_is_left() {
    let mut random = ChaCha8Rng::seed_from_u64(3);
    for n in 1..=10 {
        let table = Table::new(n).unwrap();
        let content = table.numerator.content().gcd(&table.denominator.content());
        assert_eq!(content.to_string(), "1", "n = {n}");
        let at: Vec<i128> = (0..=2 * n).map(|_| random.random_range(1..PRIME)).collect();
        for symbol in 0..=n {
            let images = (image(&table.numerator, symbol, &at), image(&table.denominator, symbol, &at));
            assert!(images.1.last() != Some(&0));
            assert_eq!(gcd_degree(images.0, images.1), 0, "a{symbol}, n = {n}");
        }
    }
}

#[test]
fn the_folder_of_tables_is_what_the_program_writes() {
    let place = Path::new(env!("CARGO_MANIFEST_DIR")).join("tables");
    let files = folder().unwrap();
    let mut total = 0;
    for file in &files {
        let kept = std::fs::read_to_string(place.join(file.name)).unwrap();
        assert!(kept == file.text, "{} differs: run `gyrospec table --folder tables`", file.name);
        total += kept.len();
    }
    assert_eq!(std::fs::read_dir(&place).unwrap().count(), files.len());
    assert!(total < 3_000_000, "{total} bytes");
}

#[test]
fn the_json_form_has_the_fixed_names() {
    let text = print_tables(2..=3, "json".parse().unwrap()).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["schema"], "gyrospec.table/1");
    assert_eq!(json["orders"].as_array().unwrap().len(), 2);
    let expected = serde_json::json!({"n": 2,
        "numerator": [{"coefficient": 1, "powers": {"a0": 1, "b1": 1}}, {"coefficient": -1, "powers": {"a2": 1, "b0": 1}}],
        "denominator": [{"coefficient": 2, "powers": {"a0": 1, "a1": 1, "a2": 1}}]});
    assert_eq!(json["orders"][0], expected);
}

/// Well-conditioned points as doubles, of every order: roots −1/2, −1, −3/2 … keep every coefficient a short binary
/// number, and all terms of G(jω) have one sign; then H of random pairs of roots with damping ratios above 0.2.
fn double_points() -> Vec<(Vec<f64>, Vec<f64>, f64)> {
    let mut random = ChaCha8Rng::seed_from_u64(11);
    let doubles = |exact: &[RBig]| exact.iter().map(|x| x.to_f64().value()).collect::<Vec<_>>();
    let mut points: Vec<_> = (1..=14)
        .map(|n| {
            let roots: Vec<RBig> = (1..=n).map(|k| rational(k as i64, 2)).collect();
            let sign = |k: usize| if (n - 1 - k).is_multiple_of(2) { 1 } else { -1 };
            let b = (0..n).map(|k| rational(sign(k) * random.random_range(1..9), 1)).collect();
            let point = Point::new(&RBig::ONE, &roots, b);
            let (a, b) = (doubles(&point.a), doubles(&point.b));
            let engine = evaluate(&Integrand::new(&a, &b).unwrap()).unwrap().value;
            approx::assert_relative_eq!(engine, point.value.to_f64().value(), max_relative = 1e-15);
            (a, b, engine)
        })
        .collect();
    for n in (1..=14).chain(1..=14) {
        let mut a = vec![1.0];
        for _ in 0..n / 2 {
            let w: f64 = random.random_range(0.3..3.0);
            a = gyrospec::poly::product(&a, &[1.0, 2.0 * random.random_range(0.2..1.2) * w, w * w]);
        }
        if n % 2 == 1 {
            a = gyrospec::poly::product(&a, &[1.0, random.random_range(0.3..3.0)]);
        }
        let sign = |k: usize| if (n - 1 - k).is_multiple_of(2) { 1.0 } else { -1.0 };
        let b: Vec<f64> = (0..n).map(|k| sign(k) * random.random_range(0.1..3.0)).collect();
        let engine = evaluate(&Integrand::new(&a, &b).unwrap()).unwrap().value;
        points.push((a, b, engine));
    }
    points
}

fn list(numbers: &[f64]) -> String {
    numbers.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", ")
}

fn has(tool: &str, language: &str) -> bool {
    let there = Command::new(tool).arg("--version").output().is_ok_and(|run| run.status.success());
    if !there {
        crate::skipped::skipped(format_args!("no {tool}, so the generated {language} is not run"));
    }
    there
}

fn printed(command: &mut Command) -> Vec<f64> {
    let run = command.output().unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    String::from_utf8(run.stdout).unwrap().lines().map(|line| line.trim().parse().unwrap()).collect()
}

fn agrees(language: &str, values: &[f64], points: &[(Vec<f64>, Vec<f64>, f64)]) {
    assert_eq!(values.len(), points.len());
    for (value, (a, _, exact)) in values.iter().zip(points) {
        let off = ((value - exact) / exact).abs();
        assert!(off < 1e-13, "{language}, n = {}: {value} against {exact}, off by {off:e}", a.len() - 1);
    }
}

fn written(folder: &Path, name: &str, format: &str, calls: &str) -> PathBuf {
    let path = folder.join(name);
    std::fs::write(&path, print_tables(1..=14, format.parse().unwrap()).unwrap() + calls).unwrap();
    path
}

#[test]
fn generated_rust_compiles_and_agrees() {
    if !has("rustc", "Rust") {
        return;
    }
    let (folder, points) = (tempfile::tempdir().unwrap(), double_points());
    let calls = points.iter().map(|(a, b, _)| {
        format!("    println!(\"{{:?}}\", i{}(&[{}], &[{}]));\n", b.len(), list(a), list(b))
    });
    let main = format!("fn main() {{\n{}}}\n", calls.collect::<String>());
    let source = written(folder.path(), "tables.rs", "rust", &main);
    let binary = folder.path().join("tables");
    let rustc = Command::new("rustc")
        .args(["--edition=2021", "-A", "dead_code", "-D", "warnings", "-o"])
        .arg(&binary)
        .arg(source)
        .output();
    let rustc = rustc.unwrap();
    assert!(rustc.status.success(), "{}", String::from_utf8_lossy(&rustc.stderr));
    agrees("Rust", &printed(&mut Command::new(binary)), &points);
}

#[test]
fn generated_python_runs_and_agrees() {
    if !has("python3", "Python") {
        return;
    }
    let (folder, points) = (tempfile::tempdir().unwrap(), double_points());
    let calls =
        points.iter().map(|(a, b, _)| format!("print(repr(i{}([{}], [{}])))\n", b.len(), list(a), list(b)));
    let source = written(folder.path(), "tables.py", "python", &calls.collect::<String>());
    agrees("Python", &printed(Command::new("python3").arg(source)), &points);
}

#[test]
fn generated_c_compiles_and_agrees() {
    if !has("cc", "C") {
        return;
    }
    let (folder, points) = (tempfile::tempdir().unwrap(), double_points());
    let calls = points.iter().map(|(a, b, _)| {
        format!(
            "    printf(\"%.17g\\n\", gyrospec_i{}((double[]){{{}}}, (double[]){{{}}}));\n",
            b.len(),
            list(a),
            list(b)
        )
    });
    let main =
        format!("#include <stdio.h>\nint main(void)\n{{\n{}    return 0;\n}}\n", calls.collect::<String>());
    let source = written(folder.path(), "tables.c", "c", &main);
    let binary = folder.path().join("tables");
    let cc = Command::new("cc")
        .args(["-std=c99", "-Wall", "-Werror", "-o"])
        .arg(&binary)
        .arg(source)
        .output()
        .unwrap();
    assert!(cc.status.success(), "{}", String::from_utf8_lossy(&cc.stderr));
    agrees("C", &printed(&mut Command::new(binary)), &points);
}

/// An unstable H has no value: the generated code says so.
#[test]
fn generated_code_refuses_an_unstable_h() {
    if !has("python3", "Python") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let calls =
        "print(i2([1, -1, 2], [0, 1]))\nprint(i3([1, 1, 2, 3], [0, 0, 1]))\nprint(i1([-1, -2], [3]))\n";
    let source = written(folder.path(), "tables.py", "python", calls);
    let values = printed(Command::new("python3").arg(source));
    assert!(values[0].is_nan() && values[1].is_nan());
    assert_eq!(values[2], 0.75);
}

/// The program on its command line: output and exit code.
#[test]
fn the_program_prints_and_refuses() {
    let run = |arguments: &[&str]| {
        let out = Command::new(env!("CARGO_BIN_EXE_gyrospec")).args(arguments).output().unwrap();
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        (out.status.code(), text(out.stdout), text(out.stderr))
    };
    let (code, out, _) = run(&["table", "--orders", "1..10"]);
    let json: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, json["orders"].as_array().unwrap().len()), (Some(0), 10));
    for bad in ["0..3", "5..2", "3..99", "x", "1...3"] {
        let (code, out, err) = run(&["table", "--orders", bad]);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{bad}");
        assert!(err.contains("from 1 to 14"), "{bad}: {err}");
    }
    let (code, out, _) = run(&["formula", "--seed"]);
    assert!(code == Some(0) && out.contains("derived/printed = 2π"), "{out}");
    let (code, out, _) = run(&["audit", "--seed"]);
    assert!(code == Some(1) && out.ends_with("15 of 17 formulas are wrong\n"), "{out}");
    assert_eq!(run(&["formula", "--h", "T*s + 1", "--g", "s^2"]).0, Some(3));
    assert_eq!(run(&["formula"]).0, Some(2));
    assert_eq!(run(&["audit", "/nowhere/at/all.toml"]).0, Some(2));
}
