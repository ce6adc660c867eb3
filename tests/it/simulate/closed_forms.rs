use super::{channel, outputs, recording, simulator, times, worst};
use gyrospec::model::Model;
use gyrospec::simulate::{Options, Simulator, Solver};

const OSCILLATOR: &str = r#"
    name = "oscillator"
    [parameters]
    w = { value = 2, unit = "rad/s" }
    d = { value = 0.1, unit = "1/s" }
    [states]
    x = { rate = "v", unit = "m", initial = 1 }
    v = { rate = "-w^2*x - 2*d*v", unit = "m/s", initial = 0 }
    [outputs]
    y = { equals = "x", unit = "m" }
"#;

fn decay(t: f64) -> f64 {
    let (w, d) = (2.0f64, 0.1f64);
    let wd = (w * w - d * d).sqrt();
    (-d * t).exp() * ((wd * t).cos() + d / wd * (wd * t).sin())
}

#[test]
fn a_damped_oscillator_swings_as_it_should() {
    for step in [0.01, 0.1, 0.5] {
        let time = times(20.0, step);
        let r = recording(vec![channel("y", "m", &time, |_| 0.0)]);
        let got = outputs(&simulator(OSCILLATOR, &r));
        assert!(worst(&time, &got, decay) < 2e-6, "{step}: {}", worst(&time, &got, decay));
    }
}

#[test]
fn methods_are_of_their_orders() {
    let time = times(20.0, 0.1);
    let r = recording(vec![channel("y", "m", &time, |_| 0.0)]);
    let model = Model::parse(OSCILLATOR).unwrap();
    for (method, wanted) in [(Solver::Explicit, 4.0), (Solver::Stiff, 4.0), (Solver::Heun, 2.0)] {
        let error = |n: usize| {
            let options = Options { fixed: Some((method, n)), ..Options::default() };
            worst(&time, &outputs(&Simulator::new(&model, &r, &options).unwrap()), decay)
        };
        let order = (error(1) / error(2)).log2();
        assert!((order - wanted).abs() < 0.3, "{method:?}: order {order}");
    }
}

#[test]
fn what_is_sampled_finely_takes_two_evaluations_a_step_until_it_moves_faster() {
    let time = times(20.0, 2e-4);
    let r = recording(vec![channel("y", "m", &time, |_| 0.0)]);
    let s = Simulator::new(&Model::parse(OSCILLATOR).unwrap(), &r, &Options::default()).unwrap();
    assert_eq!(s.steps().0, Solver::Heun);
    assert!(worst(&time, &outputs(&s), decay) < 2e-5);
    let fast = s.run(&[600.0, 0.1], &[1.0, 0.0]).unwrap();
    let wd = (3.6e5f64 - 0.01).sqrt();
    let exact = |t: f64| (-0.1 * t).exp() * ((wd * t).cos() + 0.1 / wd * (wd * t).sin());
    assert!(worst(&time, &fast.outputs[0], exact) < 2e-4, "{}", worst(&time, &fast.outputs[0], exact));
    assert!(fast.solver_error < 4.1e-5, "{}", fast.solver_error);
}

#[test]
fn an_output_of_small_numbers_is_kept_as_exact_as_one_of_large_numbers() {
    let model = r#"
        name = "a quick current beside a large angle"
        [parameters]
        I = { value = 1, unit = "A" }
        w = { value = 9, unit = "rad/s" }
        T = { value = 0.05, unit = "s" }
        W = { value = 1e6, unit = "rad/s" }
        [states]
        i = { rate = "(I*sin(w*t) - i)/T", unit = "A", initial = 0 }
        a = { rate = "W", unit = "rad", initial = 0 }
        [outputs]
        current = { equals = "i", unit = "A" }
        angle = { equals = "a", unit = "rad" }
    "#;
    let time = times(20.0, 0.04);
    let r = recording(vec![channel("current", "A", &time, |_| 0.0), channel("angle", "rad", &time, |t| t)]);
    let s = Simulator::new(&Model::parse(model).unwrap(), &r, &Options::default()).unwrap();
    let run = s.run(&s.parameters(), &s.initials()).unwrap();
    // i' = (sin ωt − i)/T from rest
    let (w, t1) = (9.0, 0.05f64);
    let exact =
        |t: f64| ((w * t).sin() - w * t1 * ((w * t).cos() - (-t / t1).exp())) / (1.0 + (w * t1).powi(2));
    assert!(worst(&time, &run.outputs[0], exact) < 1e-4, "{}", worst(&time, &run.outputs[0], exact));
}

#[test]
fn inputs_are_straight_between_their_samples() {
    // y' = (u - y)/T with u a ramp: y = t - T + T exp(-t/T)
    let model = r#"
        name = "lag"
        [inputs]
        u = { unit = "V" }
        [parameters]
        T = { value = 0.7, unit = "s" }
        [states]
        y = { rate = "(u - y)/T", unit = "V", initial = 0 }
        [outputs]
        out = { equals = "y", unit = "mV" }
    "#;
    let coarse = times(5.0, 1.0);
    let fine: Vec<f64> = times(4.9, 0.07).iter().map(|t| t + 0.01).collect();
    let r = recording(vec![channel("u", "V", &coarse, |t| t), channel("out", "V", &fine, |_| 0.0)]);
    let got = outputs(&simulator(model, &r));
    let off = worst(&fine, &got, |t| t - 0.7 + 0.7 * (-t / 0.7).exp());
    assert!(off < 5e-6, "{off}");
}

#[test]
fn a_fast_lag_beside_a_slow_swing_takes_the_stiff_path() {
    // y' = (x - y)/e beside x'' = -x: y = (x - e v)/(1 + e^2) after the first moments.
    let model = r#"
        name = "stiff"
        [parameters]
        e = { value = 1e-5, unit = "s" }
        w = { value = 1, unit = "rad/s" }
        [states]
        x = { rate = "v", unit = "m", initial = 1 }
        v = { rate = "-w^2*x", unit = "m/s", initial = 0 }
        y = { rate = "(x - y)/e", unit = "m", initial = "steady" }
        [outputs]
        out = { equals = "y", unit = "m" }
    "#;
    let time = times(60.0, 0.05);
    let r = recording(vec![channel("out", "m", &time, |_| 0.0)]);
    let s = simulator(model, &r);
    assert_eq!(s.steps().0, Solver::Stiff);
    assert!(worst(&time, &outputs(&s), |t| t.cos() + 1e-5 * t.sin()) < 1e-5);
}

#[test]
fn dry_friction_truly_sticks() {
    // m x'' = -k x - F sign(v): each half swing loses 2F/k and the last one sticks.
    let model = r#"
        name = "stick"
        [parameters]
        M = { value = 1, unit = "kg" }
        k = { value = 100, unit = "N/m" }
        Fc = { value = 7, unit = "N" }
        [states]
        x = { rate = "v", unit = "m", initial = 0.5 }
        v = { rate = "(-k*x - Fc*sign(v))/M", unit = "m/s", initial = 0 }
        [outputs]
        y = { equals = "x", unit = "m" }
    "#;
    let (w, f) = (10.0f64, 0.07f64);
    let exact = |t: f64| {
        let half = std::f64::consts::PI / w;
        let (n, mut start) = ((t / half).floor() as i32, 0.5f64);
        for _ in 0..n {
            if start.abs() <= f {
                return start;
            }
            start = -(start.abs() - 2.0 * f) * start.signum();
        }
        if start.abs() <= f {
            return start;
        }
        let centre = f * start.signum();
        centre + (start - centre) * (w * (t - f64::from(n) * half)).cos()
    };
    for step in [0.002, 0.013] {
        let time = times(3.0, step);
        let r = recording(vec![channel("y", "m", &time, |_| 0.0)]);
        let got = outputs(&simulator(model, &r));
        assert!(worst(&time, &got, exact) < 1e-6, "{step}: {}", worst(&time, &got, exact));
    }
}

#[test]
fn stuck_it_waits_for_the_force_to_break_away() {
    // At rest under F(t) = t; friction 1 N: it moves from t = 1 on, v = (t - 1)^2/2.
    let model = r#"
        name = "breakaway"
        [inputs]
        force = { unit = "N" }
        [parameters]
        M = { value = 1, unit = "kg" }
        Fc = { value = 1, unit = "N" }
        [states]
        v = { rate = "(force - Fc*sign(v))/M", unit = "m/s", initial = 0 }
        [outputs]
        speed = { equals = "v", unit = "m/s" }
    "#;
    let time = times(3.0, 0.07);
    let r = recording(vec![channel("force", "N", &time, |t| t), channel("speed", "m/s", &time, |_| 0.0)]);
    let got = outputs(&simulator(model, &r));
    assert!(worst(&time, &got, |t| 0.5 * (t - 1.0).max(0.0).powi(2)) < 1e-9);
}

#[test]
fn kinks_of_inputs_and_states_are_events() {
    // x' = |u| with u = t - 1 from two samples: x = integral of |t - 1|.
    let model = r#"
        name = "kink"
        [inputs]
        u = { unit = "m/s" }
        [parameters]
        L = { value = 0.8, unit = "m" }
        [states]
        x = { rate = "abs(u)", unit = "m", initial = 0 }
        [outputs]
        y = { equals = "min(x, L)", unit = "m" }
    "#;
    let time = times(2.0, 0.1);
    let u = channel("u", "m/s", &[0.0, 2.0], |t| t - 1.0);
    let r = recording(vec![u, channel("y", "m", &time, |_| 0.0)]);
    let got = outputs(&simulator(model, &r));
    let exact = |t: f64| if t < 1.0 { t - t * t / 2.0 } else { 0.5 + (t - 1.0).powi(2) / 2.0 };
    assert!(worst(&time, &got, |t| exact(t).min(0.8)) < 1e-9);
}

#[test]
fn the_gyrosphere_agrees_with_another_integrator() {
    let model = Model::builtin("gyrosphere").unwrap();
    let time = times(120.0, 0.1);
    let roll = |t: f64| 0.1 * (0.9 * t).sin() + 0.03 * (1.7 * t).cos();
    let heading = |t: f64| 0.8 + 0.001 * t;
    let r = recording(vec![
        channel("roll_acc", "rad/s^2", &time, roll),
        channel("heading", "rad", &time, heading),
        channel("alpha", "deg", &time, |_| 0.0),
    ]);
    let s = Simulator::new(&model, &r, &Options::default()).unwrap();
    let got = s.run(&s.parameters(), &[1e-4, 2e-3, -1e-4, 0.0]).unwrap().outputs.remove(0);
    // The midpoint rule with 40 steps a sample, equations typed anew, in CGS.
    let (c0, tt, p, h, g, u, lat) = (1.35e8, 0.44, 8.5e6, 1.55e8, 981.0, 7.2921e-5, 46.5f64.to_radians());
    let (lp, c, f, lever) = (4.757e6, 1.9028e6, 1.5e-3, 300.0);
    let line = |t: f64, fun: &dyn Fn(f64) -> f64| {
        let i = ((t / 0.1).floor() as usize).min(time.len() - 2);
        fun(time[i]) + (fun(time[i + 1]) - fun(time[i])) * (t - time[i]) / (time[i + 1] - time[i])
    };
    let rates = |t: f64, x: [f64; 4]| {
        let (acc, k) = (line(t, &roll), line(t, &heading));
        let (w1, w2) = (-lever * acc * k.cos(), lever * acc * k.sin());
        [
            -u * lat.cos() * x[1] + p / g * w2 * x[3] / h,
            -u * lat.sin() + lp / h * x[0] + c / h * x[2] + lp * w2 / (h * g),
            -f * x[0] - f * x[2] - f / g * w2,
            (p * w1 / (g * c0) - x[3]) / tt,
        ]
    };
    let (mut x, steps) = ([1e-4, 2e-3, -1e-4, 0.0], 40);
    let mut worst = 0.0f64;
    for i in 0..time.len() - 1 {
        let dt = (time[i + 1] - time[i]) / f64::from(steps);
        for s in 0..steps {
            let t = time[i] + f64::from(s) * dt;
            let k = rates(t, x);
            let middle = std::array::from_fn(|j| x[j] + 0.5 * dt * k[j]);
            let k = rates(t + 0.5 * dt, middle);
            x = std::array::from_fn(|j| x[j] + dt * k[j]);
        }
        worst = worst.max((x[1] - got[i + 1]).abs());
    }
    assert!(worst < 1e-8, "{worst}");
}

/// The slowest time of a model with one output y that is recorded for so long, s.
fn slowest_time(model: &str, unit: &str, length: f64) -> f64 {
    let r = recording(vec![channel("y", unit, &times(length, 0.1), |_| 0.0)]);
    let s = simulator(model, &r);
    s.slowest_time(&s.parameters(), &s.initials()).unwrap().unwrap()
}

#[test]
fn the_slowest_time_is_that_of_the_slowest_root() {
    // Roots: a double 0 of the position, -0.5 of a lag of 2 s, -10 of one of 0.1 s.
    let model = r#"
        name = "chain"
        [parameters]
        T1 = { value = 2, unit = "s" }
        T2 = { value = 0.1, unit = "s" }
        [states]
        x = { rate = "v", unit = "m", initial = 0 }
        v = { rate = "a", unit = "m/s", initial = 0 }
        a = { rate = "(b - a)/T1", unit = "m/s^2", initial = 1 }
        b = { rate = "-b/T2", unit = "m/s^2", initial = 1 }
        [outputs]
        y = { equals = "x", unit = "m" }
    "#;
    let slowest = slowest_time(model, "m", 1.0);
    assert!((slowest - 2.0).abs() < 1e-6, "{slowest}");
}

#[test]
fn the_slowest_time_of_what_starts_at_rest_is_that_of_its_run() {
    // v' = F - c v |v| from v = 0.001: the slope there gives 1/(2 c v) = 500 s, and v = tanh t ends at 1, where it is 0.5 s.
    let model = r#"
        name = "drag"
        [parameters]
        F = { value = 1, unit = "m/s^2" }
        c = { value = 1, unit = "1/m" }
        [states]
        v = { rate = "F - c*v*abs(v)", unit = "m/s", initial = 0.001 }
        [outputs]
        y = { equals = "v", unit = "m/s" }
    "#;
    let slowest = slowest_time(model, "m/s", 10.0);
    assert!((slowest - 0.5).abs() < 1e-4, "{slowest}");
}

#[test]
fn parameters_may_move_to_where_only_the_stiff_path_goes() {
    let model = r#"
        name = "lag"
        [inputs]
        u = { unit = "V" }
        [parameters]
        T = { value = 0.7, unit = "s" }
        [states]
        y = { rate = "(u - y)/T", unit = "V", initial = 0 }
        [outputs]
        out = { equals = "y", unit = "V" }
    "#;
    let time = times(20.0, 0.1);
    let r = recording(vec![channel("u", "V", &time, |t| t), channel("out", "V", &time, |_| 0.0)]);
    let s = simulator(model, &r);
    assert_eq!(s.steps().0, Solver::Explicit);
    for lag in [0.02, 1e-3, 1e-6] {
        let got = s.run(&[lag], &[0.0]).unwrap().outputs.remove(0);
        let off = worst(&time, &got, |t| t - lag + lag * (-t / lag).exp());
        // The tolerance, with its slack of 4, may all be spent on the one sample after the start.
        let spread = 20.0 / 12.0f64.sqrt();
        assert!(off < 4.0 * 1e-7 * spread * 201.0f64.sqrt(), "{lag}: {off}");
    }
}

#[test]
fn steps_that_blow_up_at_a_sudden_turn_are_not_taken_for_the_model() {
    // Van der Pol's relaxation oscillation: slow on its branches, of period (3 - 2 ln 2) mu + ... .
    let model = r#"
        name = "relaxation"
        [parameters]
        m = { value = 50, unit = "1" }
        w = { value = 1, unit = "1/s" }
        [states]
        x = { rate = "v", unit = "1", initial = 2 }
        v = { rate = "m*w*(1 - x^2)*v - w^2*x", unit = "1/s", initial = 0 }
        [outputs]
        y = { equals = "x", unit = "1" }
    "#;
    let time = times(200.0, 0.25);
    let r = recording(vec![channel("y", "1", &time, |_| 0.0)]);
    let s = Simulator::new(&Model::parse(model).unwrap(), &r, &Options::default()).unwrap();
    let run = s.run(&s.parameters(), &s.initials()).unwrap();
    assert!(run.blew_up.is_none() && run.solver_error <= 1e-5);
    let y = &run.outputs[0];
    let falls: Vec<f64> = (1..y.len()).filter(|i| y[i - 1] > 0.0 && y[*i] <= 0.0).map(|i| time[i]).collect();
    // T = (3 - 2 ln 2) mu + 3*2.33811 mu^(-1/3) - 2 ln(mu)/(3 mu) - 1.3233/mu (Dorodnicyn)
    let mu = 50.0f64;
    let period = (3.0 - 2.0 * 2.0f64.ln()) * mu + 7.01432 * mu.powf(-1.0 / 3.0)
        - 2.0 / 3.0 * mu.ln() / mu
        - 1.3233 / mu;
    assert!(falls.len() >= 2 && (falls[1] - falls[0] - period).abs() < 0.3, "{falls:?} {period}");
}

#[test]
fn every_built_in_model_runs_in_irregular_roll_at_ten_hertz() {
    let time = times(300.0, 0.1);
    let roll = |t: f64| 0.12 * (0.71 * t).sin() + 0.07 * (0.93 * t + 1.0).cos() + 0.02 * (2.3 * t).sin();
    for (name, _) in gyrospec::model::BUILTIN {
        let model = Model::builtin(name).unwrap();
        let channel_of = |name: &str, unit: &str| {
            let value = |t: f64| match name {
                "roll_acc" => roll(t),
                "heading" => 0.8 + 0.01 * (0.05 * t).sin(),
                "speed" => 5.0,
                _ => 0.0,
            };
            channel(name, unit, &time, value)
        };
        let inputs = model.inputs.iter().map(|i| channel_of(&i.name, &i.unit.to_string()));
        let outputs = model.outputs.iter().map(|o| channel_of(&o.name, &o.unit.to_string()));
        let r = recording(inputs.chain(outputs).collect());
        let s = Simulator::new(&model, &r, &Options::default()).unwrap();
        let run = s.run(&s.parameters(), &s.initials()).unwrap();
        assert!(run.blew_up.is_none() && run.solver_error <= 1e-5, "{name}: {:?}", run.blew_up);
        let fine = Options { fixed: Some((Solver::Stiff, 32)), ..Options::default() };
        let fine = Simulator::new(&model, &r, &fine).unwrap();
        let fine = fine.run(&s.parameters(), &s.initials()).unwrap();
        for (a, b) in run.outputs.iter().zip(&fine.outputs) {
            let size = b.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            let off = a.iter().zip(b).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            assert!(size > 0.0 && off <= 1e-4 * size, "{name}: {off} of {size}");
        }
    }
}

#[test]
fn outputs_and_inputs_whose_clocks_differ_by_rounding_are_predicted_to_the_end() {
    let model = r#"
        name = "integrator"
        [inputs]
        u = { unit = "m/s" }
        [states]
        x = { rate = "u", unit = "m", initial = 0 }
        [outputs]
        y = { equals = "x", unit = "m" }
    "#;
    let coarse = times(20.0, 0.05);
    for share in [0.0, 1e-15, 1e-14, 3e-14, 1e-13] {
        let fine: Vec<f64> = coarse.iter().take(240).map(|t| t * (1.0 + share)).collect();
        let r = recording(vec![channel("u", "m/s", &coarse, |t| t), channel("y", "m", &fine, |_| 0.0)]);
        let got = outputs(&simulator(model, &r));
        assert_eq!(got.len(), fine.len());
        assert!(worst(&fine, &got, |t| 0.5 * t * t) < 1e-9, "{share}");
    }
}
