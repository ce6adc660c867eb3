//! `curve` and `surface` in a running model: against energy, against a straight law, and its slopes against differences.

use super::{channel, outputs, recording, sensitivities, simulator, times};
use gyrospec::expression::Expr;
use gyrospec::model::Model;

/// x″ = −f(x) with f a curve, from x0.
fn swing(knots: &str, x0: f64) -> String {
    format!(
        r#"
        name = "swing"
        [parameters]
        one = {{ value = 1, unit = "m" }}
        a = {{ value = 3, unit = "m/s^2" }}
        b = {{ value = 5, unit = "m/s^2" }}
        [states]
        x = {{ rate = "v", unit = "m", initial = {x0} }}
        v = {{ rate = "-curve(x/one, {knots})", unit = "m/s", initial = 0 }}
        [outputs]
        y = {{ equals = "x", unit = "m" }}
        speed = {{ equals = "v", unit = "m/s" }}
        "#
    )
}

#[test]
fn energy_is_kept_across_the_knots() {
    let knots = "-1, -a, -0.2, -0.1*a, 0.3, 0.2*b, 1.2, b";
    let time = times(20.0, 0.01);
    let r = recording(vec![channel("y", "m", &time, |_| 0.0), channel("speed", "m/s", &time, |_| 0.0)]);
    let s = simulator(&swing(knots, 1.5), &r);
    let run = s.run(&s.parameters(), &s.initials()).unwrap();
    let force = Expr::parse(&format!("curve(x, {})", knots.replace('a', "3").replace('b', "5"))).unwrap();
    let at = |x: f64| force.value(&|n| (n == "x").then_some(x)).unwrap();
    // the potential by Simpson's rule, fine beside the pieces
    let potential = |x: f64| {
        let n = 4000;
        let h = x / f64::from(n);
        let ends = at(0.0) + at(x);
        let inner: f64 = (1..n).map(|i| (2.0 + 2.0 * f64::from(i % 2)) * at(h * f64::from(i))).sum();
        h / 3.0 * (ends + inner)
    };
    let whole = potential(1.5);
    for i in (0..time.len()).step_by(97) {
        let (x, v) = (run.outputs[0][i], run.outputs[1][i]);
        let energy = 0.5 * v * v + potential(x);
        assert!((energy - whole).abs() < 2e-5 * whole, "{energy} of {whole} at {}", time[i]);
    }
}

#[test]
fn knots_on_a_line_are_a_spring() {
    let time = times(20.0, 0.05);
    let r = recording(vec![channel("y", "m", &time, |_| 0.0), channel("speed", "m/s", &time, |_| 0.0)]);
    let got = outputs(&simulator(&swing("-1, -a, 0.5, 0.5*a, 1, a", 2.0), &r));
    for (t, x) in time.iter().zip(&got) {
        assert!((x - 2.0 * (3.0f64.sqrt() * t).cos()).abs() < 1e-5);
    }
}

/// x″ = −z with z a surface over x and v.
fn over_both(lists: &str) -> String {
    swing("0, a, 1, b", 1.5)
        .replace("curve(x/one, 0, a, 1, b)", &format!("surface(x/one, v/fast, {lists})"))
        .replace("one =", "fast = { value = 1, unit = \"m/s\" }\n        one =")
}

#[test]
fn a_surface_whose_knots_lie_on_a_damped_spring_is_one() {
    // z = 3x + 0.4v at the places x = −1, 0.5, 2 and v = −2, 1
    let z = |x: f64, v: f64| format!("{:?}*a/3", 3.0 * x + 0.4 * v);
    let values: Vec<String> = [-1.0, 0.5, 2.0].iter().flat_map(|x| [z(*x, -2.0), z(*x, 1.0)]).collect();
    let text = over_both(&format!("[-1, 0.5, 2], [-2, 1], [{}]", values.join(", ")));
    let time = times(10.0, 0.05);
    let r = recording(vec![channel("y", "m", &time, |_| 0.0), channel("speed", "m/s", &time, |_| 0.0)]);
    let s = simulator(&text, &r);
    let got = outputs(&s);
    // x″ + 0.4x′ + 3x = 0 from 1.5 at rest
    let (d, w) = (0.2, (3.0f64 - 0.04).sqrt());
    for (t, x) in time.iter().zip(&got) {
        let exact = 1.5 * (-d * t).exp() * ((w * t).cos() + d / w * (w * t).sin());
        assert!((x - exact).abs() < 1e-5, "{t}: {x} {exact}");
    }
    sensitivities::check(&s, 1e-5, 1e-4);
    let model = Model::parse(&text).unwrap();
    assert_eq!(Model::parse(&model.to_toml()).unwrap(), model);
}

#[test]
fn a_surface_that_bends_follows_fine_steps_of_its_own_law() {
    let lists = "[-1, 0.2, 2], [-1, 0, 2], [-a, -2*a/3, -a, 0.1*a, 0, 0.3*a, b, 0.7*b, 1.2*b]";
    let time = times(8.0, 0.05);
    let r = recording(vec![channel("y", "m", &time, |_| 0.0), channel("speed", "m/s", &time, |_| 0.0)]);
    let got = outputs(&simulator(&over_both(lists), &r));
    let law = Expr::parse(&format!("surface(x, v, {})", lists.replace('a', "3").replace('b', "5"))).unwrap();
    let rate = |[x, v]: [f64; 2]| [v, -law.value(&|n| Some(if n == "x" { x } else { v })).unwrap()];
    let (mut y, h) = ([1.5, 0.0], 1e-4);
    for (i, x) in got.iter().enumerate() {
        assert!((x - y[0]).abs() < 1e-4, "{}: {x} {}", time[i], y[0]);
        for _ in 0..500 {
            let a = rate(y);
            let b = rate([y[0] + h / 2.0 * a[0], y[1] + h / 2.0 * a[1]]);
            y = [y[0] + h * b[0], y[1] + h * b[1]];
        }
    }
}

#[test]
fn surfaces_that_are_none_are_refused() {
    for (lists, why) in [
        ("[0, 1], [0, 1], [a, a, b]", "4 values"),
        ("[0], [0, 1], [a, b]", "two or more knots"),
        ("[0, 1], [1, 0], [a, a, b, b]", "must rise"),
        ("[0, 1], [0, 1], [a, a, b, 1]", "unit"),
        ("[0, one], [0, 1], [a, a, b, b]", "unit"),
        ("0, 1, a", "expected '['"),
        ("[0, 1], [0, 1], [a, a, b, b", "expected ']'"),
    ] {
        let e = Model::parse(&over_both(lists)).unwrap_err().to_string();
        assert!(e.contains(why), "{lists}: {e}");
    }
}

#[test]
fn slopes_agree_with_differences() {
    let time = times(5.0, 0.05);
    let r = recording(vec![channel("y", "m", &time, |_| 0.0), channel("speed", "m/s", &time, |_| 0.0)]);
    let s = simulator(&swing("-1, -a, -0.2, -0.1*a, 0.3, 0.2*b, 1.2, b", 1.5), &r);
    sensitivities::check(&s, 1e-5, 1e-4);
}

#[test]
fn knots_that_do_not_rise_or_would_be_fitted_are_refused() {
    for knots in ["0, a, 0, b", "1, a, 0, b", "0, a, 2*w, b, 1, b"] {
        let text = swing(knots, 1.0).replace("[states]", "w = { value = 0.7, unit = \"1\" }\n[states]");
        let e = Model::parse(&text).unwrap_err().to_string();
        assert!(e.contains("must rise"), "{e}");
    }
    let text =
        swing("0, a, w, b", 1.0).replace("[states]", "w = { value = 2, unit = \"1\", fit = true }\n[states]");
    assert!(Model::parse(&text).unwrap_err().to_string().contains("which is fitted"));
    for (bad, why) in [("0, a, 1", "two or more knots"), ("0, a, 1, x", "unit"), ("0, a, one, b", "unit")] {
        let e = Model::parse(&swing(bad, 1.0)).unwrap_err().to_string();
        assert!(e.contains(why), "{bad}: {e}");
    }
    let e = Model::parse(&swing("0, a, 1, v*v/one", 1.0)).unwrap();
    let time = times(1.0, 0.1);
    let r = recording(vec![channel("y", "m", &time, |_| 0.0), channel("speed", "m/s", &time, |_| 0.0)]);
    let e = gyrospec::simulate::Simulator::new(&e, &r, &gyrospec::simulate::Options::default());
    assert!(e.map(|_| ()).unwrap_err().to_string().contains("must not change during a run"));
}
