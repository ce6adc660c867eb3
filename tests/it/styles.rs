//! The same laws in models that are written in another way, at a level in the middle of what is recorded, and beside
//! another effect that hides which law it is.

use crate::laws_met::{inputs, named, run, told};

/// A tank with a weir in the middle of its range: above it the outflow is three times as steep.
#[test]
fn an_edge_in_the_middle_of_what_a_level_does() {
    let model = r#"
        name = "tank"
        [inputs]
        q = { unit = "m^3/s" }
        [parameters]
        A = { value = 1, unit = "m^2", fit = true, min = 0.01 }
        k = { value = 1, unit = "m^2/s", fit = true, min = 0 }
        [states]
        h = { rate = "(q - k*h)/A", unit = "m", initial = "fit" }
        [outputs]
        level = { equals = "h", unit = "m" }
    "#;
    // from its mean level of 2 m without the weir; the edge lies at 1.7 m
    let flow = |u: f64| 1.6 + 0.5 * u;
    let states = run(|[h], u| [(flow(u) - 0.8 * h - 1.6 * (h - 1.7).max(0.0)) / 0.4]);
    let level = states.iter().map(|x| x[0]).collect();
    let given = inputs().into_iter().map(flow).collect();
    let answer = told(model, &[("q", "m^3/s", given, 0.0), ("level", "m", level, 0.005)]);
    let found = named(&answer);
    assert!(matches!(found[..], [("overflow", "h", k)] if (k - 1.6).abs() < 0.08), "{}", answer.says);
    assert!((answer.findings[0].parameters[1].value - 1.7).abs() < 0.02, "{}", answer.says);
}

/// A seat on a shaken floor; spring and damper stand together over the mass.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_damper_harder_one_way_in_a_sum_over_the_mass() {
    let model = r#"
        name = "seat"
        [inputs]
        shaking = { unit = "m/s^2" }
        [parameters]
        m = { value = 2, unit = "kg" }
        k = { value = 10, unit = "N/m", fit = true, min = 0 }
        c = { value = 1, unit = "N*s/m", fit = true, min = 0 }
        [states]
        x = { rate = "v", unit = "m", initial = 0 }
        v = { rate = "-shaking - (k*x + c*v)/m", unit = "m/s", initial = 0 }
        [outputs]
        stroke = { equals = "x", unit = "m" }
    "#;
    let states = run(|[x, v], u| [v, -u - (14.0 * x + 3.0 * v + 1.5 * v.abs()) / 2.0]);
    let stroke = states.iter().map(|x| x[0]).collect();
    let answer = told(model, &[("shaking", "m/s^2", inputs(), 0.0), ("stroke", "m", stroke, 0.003)]);
    let found = named(&answer);
    assert!(
        matches!(found[..], [("parameter-dependence", "c", a)] if (a - 0.5).abs() < 0.03),
        "{}",
        answer.says
    );
}

/// A lock chamber that fills with the root of the difference of both levels; the model has a time constant.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_root_of_a_difference_over_a_time() {
    let model = r#"
        name = "lock"
        [inputs]
        outside = { unit = "m" }
        [parameters]
        T = { value = 1, unit = "s", fit = true, min = 0.01 }
        [states]
        h = { rate = "(outside - h)/T", unit = "m", initial = "fit" }
        [outputs]
        inside = { equals = "h", unit = "m" }
    "#;
    let states = run(|[h], u| {
        let d = u - h;
        [0.9 * d / (d.abs() + 1e-4).sqrt()]
    });
    let inside: Vec<f64> = states.iter().map(|x| x[0]).collect();
    let definition = "[definitions]\nhead = { equals = \"outside - h\", unit = \"m\" }\n[states]";
    let gain = "[parameters]\nK = { value = 1.2, unit = \"1\", fit = true }";
    let forms = [
        ("(outside - h)/T", "[states]", "[parameters]"),
        ("outside/T - h/T", "[states]", "[parameters]"),
        ("-h/T + outside/T", "[states]", "[parameters]"),
        ("head/T", definition, "[parameters]"),
        ("(K*outside - h)/T", "[states]", gain),
    ];
    for (rate, states, parameters) in forms {
        let model = model.replace("(outside - h)/T", rate);
        let model = model.replace("[states]", states).replace("[parameters]", parameters);
        let answer = told(&model, &[("outside", "m", inputs(), 0.0), ("inside", "m", inside.clone(), 0.01)]);
        let found = named(&answer);
        assert!(
            matches!(found[..], [("power-law", "h", p)] if (p + 0.5).abs() < 0.02),
            "{rate}: {}",
            answer.says
        );
    }
}

/// A heater whose loss goes with the 5/4th power of the difference; the model has a gain and a time constant.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_power_of_what_a_lag_settles_to() {
    let model = r#"
        name = "heater"
        [inputs]
        heat = { unit = "W" }
        [parameters]
        Ta = { value = 20, unit = "degC" }
        R = { value = 1, unit = "K/W", fit = true, min = 0 }
        tau = { value = 1, unit = "s", fit = true, min = 0.01 }
        [states]
        T = { rate = "(R*heat - (T - Ta))/tau", unit = "degC", initial = "fit" }
        [outputs]
        shown = { equals = "T", unit = "degC" }
    "#;
    let heat = |u: f64| 10.0 + 4.0 * u;
    let states = run(|[above], u| [(heat(u) - 0.5 * above * above.abs().powf(0.25)) / 0.8]);
    let shown: Vec<f64> = states.iter().map(|x| 20.0 + x[0]).collect();
    let given: Vec<f64> = inputs().into_iter().map(heat).collect();
    for (rate, unit, start) in [("R*heat - (T - Ta)", "degC", 20.0), ("R*heat - T", "K", 0.0)] {
        let model = model.replace("R*heat - (T - Ta)", rate).replace("degC", unit);
        let shown = shown.iter().map(|x| x - 20.0 + start).collect();
        let answer = told(&model, &[("heat", "W", given.clone(), 0.0), ("shown", unit, shown, 0.02)]);
        let found = named(&answer);
        assert!(
            matches!(found[..], [("power-law", "T", p)] if (p - 0.25).abs() < 0.02),
            "{rate}: {}",
            answer.says
        );
    }
}

/// A boat that turns, seen by its heading and its rate: the rudder acts late, and while that is not known another law
/// than the cubic damping seems likelier.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_cubic_damping_beside_a_late_rudder() {
    let model = r#"
        name = "boat"
        [inputs]
        rudder = { unit = "rad" }
        [parameters]
        T = { value = 1, unit = "s", fit = true, min = 0.01 }
        K = { value = 1, unit = "1/s", fit = true, min = 0 }
        [states]
        a = { rate = "r", unit = "rad", initial = "fit" }
        r = { rate = "(K*rudder - r)/T", unit = "rad/s", initial = "fit" }
        [outputs]
        heading = { equals = "a", unit = "rad" }
        turning = { equals = "r", unit = "rad/s" }
    "#;
    let step = 0.02;
    let given = inputs();
    let late = 8;
    let rudder: Vec<f64> = (0..given.len()).map(|i| given[i.saturating_sub(late)]).collect();
    let (mut a, mut r) = (0.0, 0.0);
    let (mut heading, mut turning) = (Vec::new(), Vec::new());
    for i in 0..given.len() {
        heading.push(a);
        turning.push(r);
        let next = rudder[(i + 1).min(given.len() - 1)];
        let fine = 50;
        for s in 0..fine {
            let u = rudder[i] + (next - rudder[i]) * (f64::from(s) + 0.5) / f64::from(fine);
            let rate = |r: f64| (1.2 * u - r - 0.6 * r.powi(3)) / 0.7;
            let h = step / f64::from(fine);
            let middle = r + 0.5 * h * rate(r);
            a += h * middle;
            r += h * rate(middle);
        }
    }
    let answer = told(
        model,
        &[
            ("rudder", "rad", given, 0.0),
            ("heading", "rad", heading, 0.01),
            ("turning", "rad/s", turning, 0.01),
        ],
    );
    let found = named(&answer);
    let of = |code: &str| found.iter().find(|f| f.0 == code).map_or(f64::NAN, |f| f.2);
    assert!((of("cubic-damping") - 0.6).abs() < 0.03, "{}", answer.says);
    assert!((of("input-delay") - 0.16).abs() < 0.01 && found.len() == 2, "{}", answer.says);
}

/// A floor with a machine that hangs on it by a spring and a damper: both push back, and nothing else is named; where
/// both rest at the beginning, and where both already swing.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_hangs_on_a_floor_pushes_by_its_damper_too() {
    let model = r#"
        name = "floor"
        [inputs]
        push = { unit = "m/s^2" }
        [parameters]
        k = { value = 60, unit = "1/s^2", fit = true, min = 1 }
        d = { value = 1, unit = "1/s", fit = true, min = 0 }
        [states]
        x = { rate = "v", unit = "m", initial = "fit" }
        v = { rate = "push - k*x - d*v", unit = "m/s", initial = "fit" }
        [outputs]
        floor = { equals = "x", unit = "m" }
    "#;
    // a tenth of the mass, 1.1 Hz alone; a tenth of critical damping, and a fiftieth of a part let go at 0.3 m
    let (share, w) = (0.1, 6.9);
    for (damping, shift) in [(0.1, 0.0), (0.02, 0.3)] {
        let rates = |[x, v, z, r]: [f64; 4], u: f64| {
            let pull = w * w * (x - z - shift) + 2.0 * damping * w * (v - r);
            [v, u - 50.0 * x - 1.5 * v - share * pull, r, pull]
        };
        let states = run(rates);
        let floor = states.iter().map(|x| x[0]).collect();
        let answer = told(model, &[("push", "m/s^2", inputs(), 0.0), ("floor", "m", floor, 0.001)]);
        let found = named(&answer);
        let c = share * w * w;
        assert!(
            matches!(found[..], [("extra-resonance", "v", f)] if (f - c).abs() < 0.1 * c),
            "{}",
            answer.says
        );
        let values: Vec<f64> = answer.findings[0].parameters.iter().map(|p| p.value).collect();
        assert!((values[1] - w).abs() < 0.1 && (values[2] - damping).abs() < 0.02, "{}", answer.says);
    }
}

/// A float that rolls with large angles: its damping is quadratic and its restoring softens. Each hides the other.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_softening_spring_beside_a_quadratic_damping() {
    let model = r#"
        name = "float"
        [inputs]
        slope = { unit = "rad" }
        [parameters]
        w0 = { value = 2.4, unit = "rad/s", fit = true, min = 0.1 }
        zeta = { value = 0.1, unit = "1", fit = true, min = 0, max = 1 }
        [states]
        a = { rate = "p", unit = "rad", initial = "fit" }
        p = { rate = "-2*zeta*w0*p - w0^2*a + w0^2*slope", unit = "rad/s", initial = "fit" }
        [outputs]
        roll = { equals = "a", unit = "rad" }
    "#;
    let slope = |u: f64| 0.06 * u;
    let w = 2.1f64;
    let states = run(|[a, p], u| {
        [p, -2.0 * 0.03 * w * p - w * w * (a - 0.5 * a.powi(3)) + w * w * slope(u) - 0.4 * p * p.abs()]
    });
    let roll = states.iter().map(|x| x[0]).collect();
    let given = inputs().into_iter().map(slope).collect();
    let answer = told(model, &[("slope", "rad", given, 0.0), ("roll", "rad", roll, 0.003)]);
    let found = named(&answer);
    let of = |code: &str| found.iter().find(|f| f.0 == code).map_or(f64::NAN, |f| f.2);
    assert!((of("cubic-stiffness") + 0.5 * w * w).abs() < 0.2, "{}", answer.says);
    assert!((of("quadratic-damping") - 0.4).abs() < 0.04 && found.len() == 2, "{}", answer.says);
}

/// A vessel that takes up late what is given, and gives it off by a rate that saturates.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_rate_that_saturates_beside_a_late_dose() {
    let model = r#"
        name = "vessel"
        [inputs]
        dose = { unit = "kg/s" }
        [parameters]
        k = { value = 1, unit = "1/s", fit = true, min = 0 }
        h = { value = 4, unit = "1/s", fit = true, min = 0.1 }
        [states]
        first = { rate = "dose - h*first", unit = "kg", initial = "fit" }
        body = { rate = "h*first - k*body", unit = "kg", initial = "fit" }
        [outputs]
        reads = { equals = "body", unit = "kg" }
    "#;
    let dose = |u: f64| 1.2 + 0.25 * u;
    let given: Vec<f64> = inputs().into_iter().map(dose).collect();
    let at = |t: f64| {
        let place = ((t - 0.3) / 0.02).clamp(0.0, given.len() as f64 - 1.0);
        let i = (place as usize).min(given.len() - 2);
        given[i] + (given[i + 1] - given[i]) * (place - i as f64)
    };
    let states = crate::laws_met::runge_kutta(
        (0.02, given.len(), 10),
        |t| [at(t)],
        |[f, b], [u]| [u - 3.0 * f, 3.0 * f - 1.1 * b / (1.0 + b / 4.0)],
    );
    let reads = states.iter().map(|x| x[1]).collect();
    let answer = told(model, &[("dose", "kg/s", given.clone(), 0.0), ("reads", "kg", reads, 0.01)]);
    let says = &answer.says;
    let codes: Vec<&str> = answer.findings.iter().map(|f| f.code.as_str()).collect();
    assert!(codes.len() == 2 && codes.contains(&"saturable-rate"), "{codes:?} {says}");
    let late = answer.findings.iter().find(|f| ["input-delay", "output-delay"].contains(&f.code.as_str()));
    let late = late.unwrap_or_else(|| panic!("{codes:?} {says}")).parameters[0].value;
    assert!((late - 0.3).abs() < 0.03, "{late} {says}");
}

/// Two rooms with a wall between them, whose balances do not show what they hold: one has a time constant, the other is
/// divided term by term.
#[test]
fn a_flow_between_balances_that_do_not_show_their_capacities() {
    let model = r#"
        name = "rooms"
        [inputs]
        heat = { unit = "W" }
        [parameters]
        Ta = { value = 5, unit = "degC" }
        gain = { value = 3, unit = "K/W", fit = true, min = 0 }
        tau = { value = 2, unit = "s", fit = true, min = 0.01 }
        C = { value = 1, unit = "J/K", fit = true, min = 0.01 }
        G = { value = 1, unit = "W/K", fit = true, min = 0 }
        [states]
        first = { rate = "(gain*heat - (first - Ta))/tau", unit = "degC", initial = "fit" }
        second = { rate = "0.3*heat/C - G/C*(second - Ta)", unit = "degC", initial = "fit" }
        [outputs]
        one = { equals = "first", unit = "degC" }
        two = { equals = "second", unit = "degC" }
    "#;
    let heat = |u: f64| 10.0 + 2.0 * u;
    // over 5 degC: capacities 0.8 and 1.4 J/K, losses 0.5 and 0.6 W/K, through the wall 0.4 W/K
    let states = run(|[x, y], u| {
        let flow = 0.4 * (x - y);
        [(heat(u) - 0.5 * x - flow) / 0.8, (0.3 * heat(u) - 0.6 * y + flow) / 1.4]
    });
    let given = inputs().into_iter().map(heat).collect();
    let [one, two] = [0, 1].map(|k| states.iter().map(|x| 5.0 + x[k]).collect());
    let answer =
        told(model, &[("heat", "W", given, 0.0), ("one", "degC", one, 0.05), ("two", "degC", two, 0.05)]);
    let found = named(&answer);
    // times the time constant 1.6 s over the first's 0.8 J/K, and over the second's 1.4 J/K
    assert!(
        matches!(found[..], [("exchange", "first", c)] if (c - 0.4 / 0.8 * 1.6).abs() < 0.03),
        "{}",
        answer.says
    );
    let other = answer.findings[0].parameters[1].value;
    assert!((other - 0.4 / 1.4).abs() < 0.02, "{}", answer.says);
}
