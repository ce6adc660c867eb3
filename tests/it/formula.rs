//! Formulas in letters: derived, simplified, rendered, run as code.

use gyrospec::ErrorKind;
use gyrospec::integral::{Integrand, evaluate};
use gyrospec::symbolic::{
    CodeLanguage, Derived, Formula, FormulaRequest, Simplifier, Values, completed, formula, irregular_roll,
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
        ("s + sqrt(b)", "1", vec![], "I = 1 / (2 √b)"),
        ("s^2 + sqrt(2)*w*s + w^2", "1", vec![], "I = 1 / (2w³ √2)"),
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

/// H and G with a letter for every coefficient.
fn lettered(n: usize) -> FormulaRequest {
    let sum = |letter: &str, top: usize, step: usize| {
        let term = |k: usize| format!("{letter}{k}*s^{}", top - step * k);
        (0..=top / step).map(term).collect::<Vec<_>>().join(" + ")
    };
    FormulaRequest { h: Some(sum("a", n, 1)), g: Some(sum("b", 2 * n - 2, 2)), ..FormulaRequest::default() }
}

/// With letters for coefficients the formula is the table; at a Butterworth H it has the engine's value.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn coefficients_may_all_be_letters() {
    // the eighth order takes half a minute
    let orders = if std::env::var_os("GYROSPEC_LONG").is_some() { vec![1, 4, 6, 8] } else { vec![1, 4, 6] };
    for n in orders {
        let derived = derived(&lettered(n)).unwrap();
        assert_eq!((derived.order, derived.points), (n, 32));
        // a(k)/a(k−1) = cos((k−1)π/2n)/sin(kπ/2n)
        let ratio = |k: usize| {
            let part = std::f64::consts::PI / (2 * n) as f64;
            ((k - 1) as f64 * part).cos() / (k as f64 * part).sin()
        };
        let mut a = vec![1.0];
        (1..=n).for_each(|k| a.push(a[k - 1] * ratio(k)));
        let b: Vec<f64> = (0..n).map(|k| if (n - k) % 2 == 1 { 1.5 } else { -0.5 }).collect();
        let of = |letter: &str, list: &[f64]| {
            let named = |(k, x): (usize, &f64)| (format!("{letter}{k}"), *x);
            list.iter().enumerate().map(named).collect::<Values>()
        };
        let values: Values = of("a", &a).into_iter().chain(of("b", &b)).collect();
        let wanted = evaluate(&Integrand::new(&a, &b).unwrap()).unwrap().value;
        approx::assert_relative_eq!(derived.formula.evaluate(&values).unwrap(), wanted, max_relative = 1e-11);
    }
    for (n, says) in [(11, "terms"), (13, "powers up to 15")] {
        let error = derived(&lettered(n)).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::NotComputed);
        assert!(error.to_string().contains(says), "{error}");
        assert!(error.hint().unwrap().contains("gyrospec table"), "{error}");
    }
}

/// Six different lags: common factors of many letters are found in time.
#[test]
fn a_chain_of_lags_is_derived() {
    let lags = |names: &str| names.chars().map(|c| format!("({c}*s + 1)")).collect::<Vec<_>>().join("*");
    let text = written(&lags("ABCDE"), "1", &[]);
    assert!(
        text.ends_with("(2(A + B)(A + C)(A + D)(A + E)(B + C)(B + D)(B + E)(C + D)(C + E)(D + E))"),
        "{text}"
    );
    let pairs = written("(m*s^2 + r*s + c)^2*(s^2 + 2*mu*s + b^2)^2", "1", &[]);
    assert!(pairs.contains("/ (") && pairs.contains("r³"), "{pairs}");
    assert_eq!(written("(T*s + 1)^3", "1", &[]), "I = 3 / (16T)");
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
        ("T*s + 1", "a", "2 = a + b", ErrorKind::BadInput, "no letter"),
        ("T*s + 1", "a", "a = a^2", ErrorKind::NotComputed, "without end"),
        ("T*s + 1", "a^b", "", ErrorKind::NotComputed, "power"),
        ("s^201 + 1", "1", "", ErrorKind::NotComputed, "above 200"),
        ("(s + a)*(s - a)", "1", "", ErrorKind::Unstable, "opposite roots"),
        ("s^2 - s + 1", "N", "", ErrorKind::Unstable, "right half plane"),
        ("s + delay(a, T)", "1", "", ErrorKind::BadInput, "memory"),
        ("1e300*s + 1", "1", "", ErrorKind::NotComputed, "301 digits"),
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
    // a root of one filter is one of the mean square, too
    let unstable = FormulaRequest { first: Some("1/(s - 1)".into()), ..FormulaRequest::default() };
    let refused = derived(&unstable).unwrap_err();
    assert_eq!(refused.message(), "H has 1 root in the right half plane");
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
        if let Some(value) =
            ran(tool, &folder.path().join(file), &(formula.code(language).unwrap() + &main), options)
        {
            approx::assert_relative_eq!(value, wanted, max_relative = 1e-14);
        }
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

/// Words of the languages and of their libraries, Greek letters, and bare numbers as the base of a power.
#[test]
fn names_that_a_language_takes_do_not_break_the_code() {
    let words = "lambda*math + y0*sin(class)^2 - abs(pow)*clamp(double, -1, μ)/2^fn + sqrt(2)*sign(if)*pi";
    let formula = Formula::parse("gamma", words).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let names = gyrospec::symbolic::symbols(&formula.expression);
    let values: Values =
        names.iter().enumerate().map(|(k, name)| ((*name).to_owned(), 0.4 + 0.2 * k as f64)).collect();
    let wanted = formula.evaluate(&values).unwrap();
    let call = values.values().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", ");
    let runs: [(&str, &str, CodeLanguage, String, &[&str]); 3] = [
        ("python3", "f.py", CodeLanguage::Python, format!("print(gamma({call}))\n"), &[]),
        (
            "rustc",
            "f.rs",
            CodeLanguage::Rust,
            format!("fn main() {{ println!(\"{{}}\", gamma({call})); }}\n"),
            &["-Dwarnings"],
        ),
        (
            "cc",
            "f.c",
            CodeLanguage::C,
            format!(
                "#include <stdio.h>\nint main(void) {{ printf(\"%.17g\", gamma_({call})); return 0; }}\n"
            ),
            &["-Wall", "-Werror", "-lm"],
        ),
    ];
    for (tool, file, language, main, options) in runs {
        if let Some(value) =
            ran(tool, &folder.path().join(file), &(formula.code(language).unwrap() + &main), options)
        {
            approx::assert_relative_eq!(value, wanted, max_relative = 1e-14);
        }
    }
    for (name, right, says) in [
        ("my result!", "a", "my_result"),
        ("2x", "a", "x"),
        ("f", "mu + μ", "another letter"),
        ("Ж", "a", "result"),
    ] {
        for language in [CodeLanguage::Rust, CodeLanguage::Python, CodeLanguage::C] {
            let error = Formula::parse(name, right).unwrap().code(language).unwrap_err();
            assert_eq!(error.kind(), ErrorKind::BadInput);
            assert!(error.to_string().contains(says), "{name}: {error}");
        }
    }
}

/// What a program prints that is run, or compiled first and then run; none where the tool is not there.
fn ran(tool: &str, source: &std::path::Path, text: &str, options: &[&str]) -> Option<f64> {
    if !Command::new(tool).arg("--version").output().is_ok_and(|run| run.status.success()) {
        crate::skipped::skipped(format_args!("no {tool}"));
        return None;
    }
    std::fs::write(source, text).unwrap();
    let mut command = Command::new(tool);
    command.arg(source);
    if tool != "python3" {
        let binary = source.with_extension("run");
        let built = command.arg("-o").arg(&binary).args(options).output().unwrap();
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        command = Command::new(&binary);
    }
    let out = command.output().unwrap();
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    Some(String::from_utf8(out.stdout).unwrap().trim().parse().unwrap())
}

/// The command line at given values: what it refuses, and with which exit code.
#[test]
fn values_are_given_where_h_is_stable() {
    let run = |values: &str| {
        let out = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
            .args(["formula", "--h", "s^2 + 2*zeta*w*s + w^2", "--g", "N", "--values", values])
            .output()
            .unwrap();
        (out.status.code(), String::from_utf8(out.stdout).unwrap() + &String::from_utf8(out.stderr).unwrap())
    };
    for (values, code, says) in [
        ("zeta=0.25, w=2, N=1", 0, "= 0.125"),
        ("zeta=-0.25, w=2, N=1", 3, "2 roots in the right half plane"),
        ("zeta=0, w=2, N=1", 3, "imaginary axis"),
        ("zeta=nan, w=2, N=1", 2, "not finite"),
        ("zeta=0.25, w=2, N=1, zetta=1", 2, "the nearest is zeta"),
        ("zeta=0.25, w=2", 2, "N has no value"),
        ("zeta=0.25, zeta=0.5, w=2, N=1", 2, "twice"),
        ("zeta=0.25, w=1e200, N=1", 3, "error"),
        ("zeta", 2, "no value"),
    ] {
        let (found, text) = run(values);
        assert_eq!(found, Some(code), "{values}: {text}");
        assert!(text.contains(says), "{values}: {text}");
    }
}

#[test]
fn an_odd_part_of_g_is_refused() {
    for g in ["s", "s + N", "(s + N)^2"] {
        let text = |t: &str| Some(t.to_owned());
        let request = FormulaRequest { h: text("m*s^2 + r*s + c"), g: text(g), ..FormulaRequest::default() };
        let derived = formula(&request.derivation().unwrap(), &request.simplifier().unwrap());
        let e = derived.map(|d| d.formula.text()).unwrap_err();
        assert!(e.kind() == gyrospec::ErrorKind::Usage && e.hint().is_some(), "{g}: {e}");
    }
}
