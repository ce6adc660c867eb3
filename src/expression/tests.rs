use super::*;
use crate::units::Unit;
use proptest::prelude::*;

fn e(text: &str) -> Expr {
    Expr::parse(text).unwrap()
}

fn scope() -> Scope {
    let names =
        [("x", "m"), ("v", "m/s"), ("F", "N"), ("M", "kg"), ("T", "s"), ("angle", "deg"), ("Fv", "N*s/m")];
    names.iter().map(|(n, u)| ((*n).to_string(), Unit::parse(u).unwrap().dimension())).collect()
}

#[test]
fn precedence() {
    let cases = [
        ("-2^2", -4.0),
        ("2^3^2", 512.0),
        ("2^-1", 0.5),
        ("-2*3", -6.0),
        ("8/4/2", 1.0),
        ("8 - 4 - 2", 2.0),
        ("2*-3", -6.0),
        ("1e3 + .5 + 2.", 1002.5),
        ("clamp(5, 0, 2) + step(0) + sign(-3)", 2.0),
        ("atan2(1, 1)*4 - pi", 0.0),
        ("+3 - -4", 7.0),
    ];
    for (text, value) in cases {
        assert_eq!(e(text).constant(), Some(value), "{text}");
    }
}

#[test]
fn prints_as_little_as_it_must() {
    for text in
        ["a - (b - c)", "a - b - c", "-x^2", "(-x)^2", "a^b^c", "(a^b)^c", "a/(b*c)", "a*b/c", "-(a + b)"]
    {
        assert_eq!(e(text).to_string(), text);
    }
    assert_eq!(e("a*(-b)").to_string(), "a*(-b)");
    assert_eq!(e("min( a,b )").to_string(), "min(a, b)");
    assert_eq!(e("7.2921e-5*x + 1e8").to_string(), "7.2921e-5*x + 1e8");
}

#[test]
fn syntax_errors_point_at_the_column() {
    let cases = [
        ("a + ", 5),
        ("a b", 3),
        ("(a + b", 1),
        ("a)", 2),
        ("sinn(x)", 1),
        ("2 + clamp(x)", 5),
        ("a + $", 5),
        ("a**b", 2),
        ("1e999", 1),
        ("f + (3, 4)", 7),
    ];
    for (text, column) in cases {
        let error = Expr::parse(text).unwrap_err();
        assert_eq!(error.column(), Some(column), "{text}: {error}");
    }
    assert!(Expr::parse("sinn(x)").unwrap_err().hint().unwrap().contains("sin"));
    assert!(Expr::parse(&"(".repeat(100_000)).is_err());
    assert!(Expr::parse(&vec!["a"; 100_000].join("+")).is_err());
    assert!(Expr::parse(" ").is_err());
    // beyond what a double holds, at either end
    assert!(
        Expr::parse("1e400").is_err() && Expr::parse("2*1e-400").is_err() && Expr::parse("0e-400").is_ok()
    );
}

#[test]
fn dimensions_of_right_expressions() {
    let cases = [
        ("(F - Fv*v)/M", "m/s^2"),
        ("sqrt(x)", "m^0.5"),
        ("x^(3/2)*0 + 0", "m^1.5"),
        ("sin(2*angle) + 1", "1"),
        ("abs(x) - 0", "m"),
        ("max(0, x)", "m"),
        ("F*sign(v)", "N"),
        ("delay(x, T) + lag(x, 2*T) + backlash(x, x)", "m"),
        ("rate_limit(x, v)", "m"),
        ("atan2(x, x)/t", "1/s"),
        ("(x/x)^angle", "1"),
    ];
    for (text, unit) in cases {
        assert_eq!(e(text).dimension(&scope()).unwrap(), Unit::parse(unit).unwrap().dimension(), "{text}");
    }
}

#[test]
fn dimension_errors_underline_the_term() {
    let cases = [
        ("x + T*2", 5, 3),
        ("(F - 2*(x + v))/M", 13, 1),
        ("x + 1", 5, 1),
        ("sin(x)", 5, 1),
        ("x^angle", 3, 5),
        ("delay(x, x)", 10, 1),
        ("2^x", 3, 1),
        ("x - F/M", 5, 3),
        ("foo*2", 1, 3),
    ];
    for (text, column, length) in cases {
        let error = e(text).dimension(&scope()).unwrap_err();
        assert_eq!(error.column(), Some(column), "{text}: {error}");
        assert!(
            error.to_string().contains(&format!("\n  {}{}", " ".repeat(column - 1), "^".repeat(length))),
            "{error}"
        );
    }
    assert!(e("angel").dimension(&scope()).unwrap_err().hint().unwrap().ends_with("angle"));
}

fn any_expr() -> impl Strategy<Value = Expr> {
    let names = prop::sample::select(vec!["a", "b_1", "t", "pi"]);
    let leaf = prop_oneof![
        (0.0..1e12f64).prop_map(Expr::Number),
        (0u32..9).prop_map(|n| Expr::Number(f64::from(n))),
        names.prop_map(Expr::name),
    ];
    leaf.prop_recursive(6, 48, 3, |inner| {
        let ops = prop::sample::select(vec![
            BinaryOp::Add,
            BinaryOp::Sub,
            BinaryOp::Mul,
            BinaryOp::Div,
            BinaryOp::Pow,
        ]);
        let functions = prop::sample::select(Function::all().collect::<Vec<_>>());
        prop_oneof![
            inner.clone().prop_map(|a| -a),
            (ops, inner.clone(), inner.clone()).prop_map(|(op, a, b)| Expr::Binary(
                op,
                Box::new(a),
                Box::new(b)
            )),
            functions.prop_flat_map(move |f| {
                prop::collection::vec(inner.clone(), f.arity()).prop_map(move |args| Expr::Call(f, args))
            }),
        ]
    })
}

proptest! {
    #[test]
    fn what_is_printed_reads_back_to_the_same_tree(expr in any_expr()) {
        prop_assert_eq!(Expr::parse(&expr.to_string()).unwrap(), expr);
    }

    #[test]
    fn no_text_makes_it_panic(text in ".{0,40}") {
        let _ = Expr::parse(&text);
        let _ = crate::units::Unit::parse(&text);
    }
}
