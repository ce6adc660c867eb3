//! The audit finds every slip of the two papers, and none where there is none.

use gyrospec::symbolic::{AuditRequest, Check, CheckKind, Examined, audit, seed_audit};

fn seed() -> Vec<Examined> {
    audit(&seed_audit().unwrap()).unwrap()
}

fn check<'a>(examined: &'a [Examined], name: &str, kind: CheckKind) -> &'a Check {
    let one = examined.iter().find(|one| one.name == name).unwrap();
    one.checks.iter().find(|check| check.kind == kind).unwrap()
}

/// Slip by slip: the formula, the check that finds it, and what it must say.
#[test]
fn every_slip_of_the_papers_is_found_and_placed() {
    let examined = seed();
    for (name, kind, says) in [
        ("Example 2.1", CheckKind::Dimensions, "unit"),
        ("(3.1), line 1", CheckKind::Dimensions, "U*x1*cos(phi)"),
        ("(3.1), line 1", CheckKind::Value, "printed x2, must be x2_d"),
        ("(3.1), line 1", CheckKind::Value, "printed −"),
        ("(3.1), line 2", CheckKind::Dimensions, "^"),
        ("(3.1), line 2", CheckKind::Value, "printed x1, must be x1_d"),
        ("(2.4), index", CheckKind::Value, "printed H_1, must be H"),
        ("(3.1), line 3", CheckKind::Dimensions, "^"),
        ("(3.1), line 3", CheckKind::Value, "printed x3, must be x3_d"),
        ("(3.1), line 4", CheckKind::Dimensions, "^"),
        ("(3.1), line 4", CheckKind::Value, "printed x4, must be x4_d"),
        ("(3.2), line 1", CheckKind::Value, "printed m2, must be m2_d"),
        ("text after (3.2)", CheckKind::Dimensions, "^"),
        ("text after (3.2)", CheckKind::Value, "printed m4, must be m1"),
        ("(3.4)", CheckKind::Dimensions, "b^2"),
        ("(3.4)", CheckKind::Value, "printed b², must be b⁴"),
        ("(3.5)", CheckKind::Dimensions, "^"),
        ("(3.5)", CheckKind::Value, "theta_dd"),
        ("(3.6)", CheckKind::Dimensions, "b^2"),
        ("(3.6)", CheckKind::Value, "printed b², must be b⁴"),
        ("result after (3.13)", CheckKind::Value, "right/printed = 2π"),
        ("result after (3.13)", CheckKind::Limit, "wanted/printed = 2π"),
        ("result after (3.13)", CheckKind::Example, "-1.2492e-2 rad, -0.0131 is printed"),
        ("gimbal (1), gyroscopic coefficient of line 1", CheckKind::Value, "−I_x is missing"),
        ("gimbal (1), gyroscopic coefficient of line 1", CheckKind::Identity, "do no work"),
        ("gimbal (1), line 1", CheckKind::Dimensions, "^"),
        ("gimbal (1), line 1", CheckKind::Value, "printed β, must be β_d"),
        ("gimbal (1), line 1", CheckKind::Value, "−I_x is missing"),
        ("gimbal (1), line 2", CheckKind::Dimensions, "^"),
        ("gimbal (1), line 2", CheckKind::Value, "printed α, must be α_d"),
        ("gimbal (1), line 2", CheckKind::Value, "printed Θ_d, must be Θ_dd"),
        ("gimbal (1), line 2", CheckKind::Value, "printed Ψ_d, must be Ψ_dd"),
    ] {
        let found = check(&examined, name, kind);
        assert!(!found.holds, "{name}: {}", found.message);
        let text = found.message.replace("θ_dd", "theta_dd");
        assert!(text.contains(says), "{name}: {}", found.message);
    }
}

#[test]
fn what_is_printed_right_passes() {
    let examined = seed();
    let sound: Vec<&str> = examined.iter().filter(|one| one.holds()).map(|one| one.name.as_str()).collect();
    assert_eq!(sound, ["(2.4)", "(3.13)"]);
    // a right dimension beside a wrong constant
    assert!(check(&examined, "result after (3.13)", CheckKind::Dimensions).holds);
}

#[test]
fn the_constant_is_recognised() {
    let ratio = |printed: &str, right: &str| {
        let request = format!(
            "relations = ['c^2 = a^2 + d^2']\n[[formulas]]\nname = 'x'\nprinted = '{printed}'\nright = '{right}'\n"
        );
        let examined = audit(&AuditRequest::parse(&request).unwrap()).unwrap();
        examined[0].checks[0].message.clone()
    };
    for (printed, right, says) in [
        ("a*sin(K)*3", "a*sin(K)", "1/3"),
        ("a/pi^2", "a", "π²"),
        ("a*c^2", "-(a^3 + a*d^2)/(4*pi)", "-1/(4π)"),
        ("1000*a", "a", "10^-3"),
        ("a", "a", "equal"),
        ("a*c^2", "a^3 + a*d^2", "equal"),
        ("a + d", "a - d", "printed d, must be −d"),
        ("a*exp(-d*K)", "a*exp(-2*d*K)", "2 is missing"),
    ] {
        assert!(ratio(printed, right).contains(says), "{printed}: {}", ratio(printed, right));
    }
}

#[test]
fn a_request_that_cannot_be_read_says_where() {
    let error = AuditRequest::parse("[[formulas]]\nname = 'x'\nprintd = 'a'\n").unwrap_err();
    assert!(error.to_string().contains("printd"), "{error}");
    let request = AuditRequest::parse("[[formulas]]\nname = 'x'\nprinted = 'a +'\n").unwrap();
    assert!(audit(&request).unwrap_err().to_string().contains("formula x"));
}

#[test]
fn an_audit_without_anything_to_check_is_refused() {
    for text in [
        "[[formulas]]\nname = 'x'\nprinted = 'a + b'\n",
        "[[formulas]]\nname = 'x'\nprinted = 'a = b'\n[[formulas]]\nname = 'y'\nprinted = 'c'\n",
        "formulas = []\n",
    ] {
        let error = audit(&AuditRequest::parse(text).unwrap()).unwrap_err();
        assert_eq!(error.kind(), gyrospec::ErrorKind::BadInput);
        assert!(error.hint().unwrap().contains("right, derive, limits"), "{error}");
    }
    let text =
        "[[formulas]]\nname = 'x'\nprinted = 'a'\n[[formulas]]\nname = 'y'\nprinted = 'c'\nright = 'c'\n";
    let examined = audit(&AuditRequest::parse(text).unwrap()).unwrap();
    assert_eq!(examined.iter().map(Examined::checked).collect::<Vec<_>>(), [false, true]);
}

fn first(formula: &str) -> Check {
    let request = format!("[[formulas]]\nname = 'x'\n{formula}");
    audit(&AuditRequest::parse(&request).unwrap()).unwrap()[0].checks[0].clone()
}

/// Names that stand nowhere, and numbers that are none, are slips of the file and not of the book.
#[test]
fn slips_of_the_audit_file_are_refused() {
    for (part, says) in [
        ("[[formulas.limits]]\nsymbol = 'mv'\nto = 0.0\nbecomes = '0'\n", "the nearest is mu"),
        ("[[formulas.limits]]\nsymbol = 'mu'\nto = nan\nbecomes = '0'\n", "no number"),
        (
            "[[formulas.examples]]\nvalues = { mu = 1, zeta = 2 }\nresult = '2'\nunit = '1'\n",
            "'zeta' is no letter",
        ),
        ("[[formulas.examples]]\nvalues = { mu = nan }\nresult = '2'\nunit = '1'\n", "not finite"),
        ("[[formulas.examples]]\nvalues = { mu = 1 }\nresult = 'nan'\nunit = '1'\n", "no number"),
        ("[[formulas.examples]]\nvalues = { }\nresult = '2'\nunit = '1'\n", "mu has no value"),
    ] {
        let text = format!("[[formulas]]\nname = 'x'\nprinted = '2*mu'\n{part}");
        let error = audit(&AuditRequest::parse(&text).unwrap()).unwrap_err();
        assert_eq!(error.kind(), gyrospec::ErrorKind::BadInput);
        assert!(error.to_string().contains(says), "{part}: {error}");
    }
}

/// Limits known from any table, also those that are 0, and what is said where they are not met.
#[test]
fn limits_are_judged_by_the_difference() {
    for (printed, symbol, to, becomes, holds, says) in [
        ("x*y/(1+x)", "x", "0.0", "0", true, "turns into"),
        ("A*sin(2*K)", "K", "0.0", "0", true, "turns into"),
        ("1/(1+x)", "x", "inf", "0", true, "turns into"),
        ("1/(1+x)", "x", "1e9", "0", true, "turns into"),
        ("y*(1-cos(x))/x^2", "x", "0.0", "y/2", true, "turns into"),
        ("y*(1-cos(x))/x^2", "x", "0.0", "0", false, "does not"),
        ("(x^3-8)/(x-2)", "x", "2.0", "12", true, "turns into"),
        ("sqrt(x) + y", "x", "0.0", "y", true, "turns into"),
        ("A*sin(2*K)", "K", "0.0", "2*A*K", true, "turns into"),
        ("A*sin(2*K)", "K", "0.0", "A*K", false, "= 1/2"),
        ("x + 1e-9*y", "x", "0.0", "0", false, "does not"),
        ("1/x", "x", "0.0", "5", false, "diverges"),
        ("ln(x)", "x", "inf", "0", false, "diverges"),
        ("x*y", "x", "0.0", "5", false, "vanishes"),
        ("y + x", "x", "0.0", "2*y", false, "= 2"),
        ("exp(x)/(1+exp(x))", "x", "inf", "1", true, "turns into"),
    ] {
        let found = first(&format!(
            "printed = '{printed}'\n[[formulas.limits]]\nsymbol = '{symbol}'\nto = {to}\nbecomes = '{becomes}'\n"
        ));
        assert!(found.holds == holds && found.message.contains(says), "{printed}: {}", found.message);
    }
}

#[test]
fn what_is_equal_by_identities_or_up_to_a_factor_of_an_equation_passes() {
    for (printed, right, holds, says) in [
        ("sin(2*K)", "2*sin(K)*cos(K)", true, "equal"),
        ("1", "sin(K)^2 + cos(K)^2", true, "equal"),
        ("exp(a)*exp(b)", "exp(a+b)", true, "equal"),
        ("abs(a)", "a", true, "positive"),
        ("2*x = 4*y", "x = 2*y", true, "equal"),
        ("y = x", "x = y", true, "equal"),
        ("y = x", "y = 2*x", false, "2"),
        ("sin(2*K)", "sin(K)*cos(K)", false, "1/2"),
        ("x", "0", false, "must be 0"),
    ] {
        let found = first(&format!("printed = '{printed}'\nright = '{right}'\n"));
        assert!(found.holds == holds && found.message.contains(says), "{printed}: {}", found.message);
    }
}
