//! Formulas in letters: derived, simplified, rendered, run as code.

use gyrospec::ErrorKind;
use gyrospec::symbolic::{
    CodeLanguage, Derived, FormulaRequest, Simplifier, Values, completed, formula, irregular_roll,
};
use std::process::Command;

#[test]
fn the_formula_for_irregular_roll_comes_out_as_a_person_writes_it() {
    let request = irregular_roll();
    let simplifier = request.simplifier().unwrap();
    let derived = formula(&request.derivation().unwrap(), &simplifier).unwrap();
    assert_eq!(
        derived.formula.text(),
        "α = −P²h²A b²(2μ + b²T) sin 2K / (2 H U C0 g² T [T²ε² + (1+μT)²] cos φ)"
    );
    assert_eq!((derived.order, derived.points), (3, 32));
    let printed = request.printed().unwrap().unwrap();
    assert_eq!(derived.formula.ratio_to(&printed, &simplifier).unwrap().text(), "ratio = 2π");
}

fn written(h: &str, g: &str, relations: &[&str]) -> String {
    let request = FormulaRequest {
        h: Some(h.into()),
        g: Some(g.into()),
        relations: relations.iter().map(ToString::to_string).collect(),
        ..FormulaRequest::default()
    };
    derived(&request).unwrap().formula.text()
}

fn derived(request: &FormulaRequest) -> gyrospec::Result<Derived> {
    formula(&request.derivation()?, &request.simplifier()?)
}

/// Closed forms that are in every book: a lag, an oscillator, its rate, two lags; w is the natural frequency.
#[test]
fn known_closed_forms_come_out() {
    for (h, g, relations, wanted) in [
        ("T*s + 1", "N", vec![], "I = N / (2T)"),
        ("m*s^2 + r*s + c", "N", vec![], "I = N / (2 r c)"),
        ("m*s^2 + r*s + c", "-N*s^2", vec![], "I = N / (2 m r)"),
        ("s^2 + 2*z*w*s + w^2", "w^4", vec![], "I = w / (4z)"),
        ("(T*s + 1)*(s + a)", "1", vec![], "I = 1 / (2a(1 + Ta))"),
        ("m*s^2 + r*s + c", "c^2", vec!["c = m*w^2", "r = 2*z*m*w"], "I = w / (4z)"),
        ("m*s^2 + sqrt(c*m)*s + c", "1", vec![], "I = 1 / (2c √(cm))"),
        ("a*s^3 + b*s^2 + c*s + d", "s^4", vec![], "I = c / (2a(bc − ad))"),
        ("T*s + 1", "sqrt(y)*y^2.5", vec![], "I = y³ / (2T)"),
    ] {
        assert_eq!(written(h, g, &relations), wanted);
    }
}

/// With several lags every pair of time constants gives its own factor below the line.
#[test]
fn factors_of_h_keep_the_denominator_factored() {
    let text = written("(A*s + 1)*(B*s + 1)*(C*s + 1)", "1", &[]);
    for factor in ["(A + B)", "(A + C)", "(B + C)"] {
        assert!(text.split('/').nth(1).unwrap().contains(factor), "{text}");
    }
}

#[test]
fn what_cannot_be_derived_says_why() {
    let ask = |h: &str, g: &str, relation: &str| {
        let relations = if relation.is_empty() { Vec::new() } else { vec![relation.to_owned()] };
        let request =
            FormulaRequest { h: Some(h.into()), g: Some(g.into()), relations, ..FormulaRequest::default() };
        derived(&request).unwrap_err()
    };
    for (h, g, relation, kind, says) in [
        ("s^2 - 2*mu*s + w^2", "1", "", ErrorKind::NotComputed, "stable"),
        ("T*s + 1", "s^2", "", ErrorKind::OutOfRange, "infinite"),
        ("T*s^2 + s", "1", "", ErrorKind::ImaginaryAxis, "imaginary axis"),
        ("T + 1", "1", "", ErrorKind::BadInput, "order 0"),
        ("T*s + sin(s)", "1", "", ErrorKind::BadInput, "under a function"),
        ("T*s + 1", "1/s", "", ErrorKind::BadInput, "polynomials in s"),
        ("T*s + 1", "sin(K)*cos(K)", "sin(K)*cos(K) = sin(2*K)", ErrorKind::BadInput, "does not hold"),
        ("T*s + 1", "a", "a + b = c", ErrorKind::BadInput, "is a sum"),
        ("T*s + 1", "a", "a = a^2", ErrorKind::NotComputed, "without end"),
        ("T*s + 1", "a^b", "", ErrorKind::NotComputed, "power"),
    ] {
        let error = ask(h, g, relation);
        assert!(error.to_string().contains(says), "{h}, {g}: {error}");
        assert_eq!(error.kind(), kind, "{h}, {g}: {error}");
    }
}

/// The mean square by transfer functions is that by H and G.
#[test]
fn transfer_functions_multiply_and_cancel() {
    let mut request = FormulaRequest {
        first: Some("1/(T*s + 1)".into()),
        shaping: Some("(T*s + 1)/(s^2 + r*s + c)".into()),
        density: Some("N".into()),
        ..FormulaRequest::default()
    };
    let result = derived(&request).unwrap();
    assert_eq!((result.order, result.formula.text().as_str()), (2, "I = N / (2 r c)"));
    // a signal and its rate are uncorrelated
    request.second = Some("s/(T*s + 1)".into());
    assert_eq!(derived(&request).unwrap().formula.text(), "I = 0");
}

#[test]
fn generated_functions_run_and_agree() {
    let (request, folder) = (irregular_roll(), tempfile::tempdir().unwrap());
    let formula = derived(&request).unwrap().formula;
    let names = formula.expression.names();
    let values: Values =
        names.iter().enumerate().map(|(k, n)| ((*n).to_owned(), 0.5 + 0.25 * k as f64)).collect();
    let wanted = formula.evaluate(&values).unwrap();
    let call = format!("alpha({})", values.values().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", "));
    let runs: [(&str, &str, CodeLanguage, String, &[&str]); 3] = [
        ("python3", "f.py", CodeLanguage::Python, format!("print({call})\n"), &[]),
        (
            "rustc",
            "f.rs",
            CodeLanguage::Rust,
            format!("fn main() {{ println!(\"{{}}\", {call}); }}\n"),
            &["-Dwarnings"],
        ),
        (
            "cc",
            "f.c",
            CodeLanguage::C,
            format!("#include <stdio.h>\nint main(void) {{ printf(\"%.17g\", {call}); return 0; }}\n"),
            &["-Wall", "-Werror", "-lm"],
        ),
    ];
    for (tool, file, language, main, options) in runs {
        if !Command::new(tool).arg("--version").output().is_ok_and(|run| run.status.success()) {
            eprintln!("SKIPPED: no {tool}");
            continue;
        }
        let (source, binary) = (folder.path().join(file), folder.path().join("f"));
        std::fs::write(&source, formula.code(language) + &main).unwrap();
        let mut command = Command::new(tool);
        command.arg(&source);
        if tool != "python3" {
            let built = command.arg("-o").arg(&binary).args(options).output().unwrap();
            assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
            command = Command::new(&binary);
        }
        let out = String::from_utf8(command.output().unwrap().stdout).unwrap();
        approx::assert_relative_eq!(out.trim().parse::<f64>().unwrap(), wanted, max_relative = 1e-14);
    }
}

#[test]
fn slopes_of_the_derived_formula_agree_with_differences() {
    let request = irregular_roll();
    let (formula, simplifier) = (derived(&request).unwrap().formula, request.simplifier().unwrap());
    let mut values: Values = formula.expression.names().iter().map(|n| ((*n).to_owned(), 0.7)).collect();
    for symbol in ["T", "K", "H", "b"] {
        let slope =
            formula.derivative(symbol, &Simplifier { relations: Vec::new(), ..simplifier.clone() }).unwrap();
        let exact = slope.evaluate(&values).unwrap();
        let mut at = |x: f64| {
            values.insert(symbol.into(), x);
            formula.evaluate(&values).unwrap()
        };
        let difference = (at(0.7 + 1e-5) - at(0.7 - 1e-5)) / 2e-5;
        at(0.7);
        approx::assert_relative_eq!(exact, difference, max_relative = 1e-8);
    }
}

/// With b² = μ² + ε² the slope in μ is that of the formula with b moving along.
#[test]
fn slopes_follow_the_relations() {
    let request = irregular_roll();
    let (formula, simplifier) = (derived(&request).unwrap().formula, request.simplifier().unwrap());
    let mut given: Values = formula.expression.names().iter().map(|n| ((*n).to_owned(), 0.7)).collect();
    given.remove("b");
    let mut at = |mu: f64| {
        given.insert("mu".into(), mu);
        completed(&given, &simplifier.relations).unwrap()
    };
    let slope = formula.derivative("mu", &simplifier).unwrap().evaluate(&at(0.7)).unwrap();
    let values = [at(0.7 + 1e-5), at(0.7 - 1e-5)].map(|values| formula.evaluate(&values).unwrap());
    approx::assert_relative_eq!(slope, (values[0] - values[1]) / 2e-5, max_relative = 1e-8);
}
