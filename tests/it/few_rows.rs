//! Recordings of a dozen rows, and what was not held out: where nothing can be told, nothing is.

use crate::diagnose::{diagnosed, recording};
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::diagnose::laboratory::Stepper;
use gyrospec::diagnose::{Request, diagnose};
use gyrospec::estimate::fit::Silent;
use gyrospec::model::{Initial, Model};
use gyrospec::record::{Channel, Recording, Span};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const LAG: &str = r#"
    name = "first order"
    [inputs]
    u = { unit = "V" }
    [parameters]
    T = { value = 1, unit = "s", fit = true, min = 1e-3, max = 1e3 }
    K = { value = 2, unit = "m/V" }
    [states]
    x = { rate = "(K*u - x)/T", unit = "m", initial = "fit" }
    [outputs]
    y = { equals = "x", unit = "m" }
"#;

/// What is done to the columns once they are made.
#[derive(Clone, Copy, Debug)]
enum Spoilt {
    Not,
    Offset,
    Turned,
    InThousandths,
}

/// A lag of 1.3 s on inputs of some shape, with noise of a share of the signal's size.
fn rows(shape: usize, count: usize, noise: f64, spoilt: Spoilt, seed: u64) -> Recording {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut normal = || -> f64 { StandardNormal.sample(&mut rng) };
    let time: Vec<f64> = (0..count).map(|i| 0.5 * i as f64).collect();
    let u: Vec<f64> = (0..count)
        .map(|i| match shape {
            0 => f64::from(u8::from(i >= 2)),
            1 => (0.45 * i as f64 + 1.0).sin(),
            2 => 0.2 * i as f64,
            3 => normal(),
            _ => 1.0,
        })
        .collect();
    let unit = |text: &str| Unit::parse(text).unwrap();
    let channels = vec![
        Channel::new("u", unit("V"), time.clone(), u),
        Channel::new("y", unit("m"), time.clone(), vec![0.0; count]),
    ];
    let mut made = Recording::from_channels("rows", channels).unwrap();
    let mut truth = Model::parse(LAG).unwrap();
    truth.parameters[0].value = 1.3;
    truth.states[0].initial = Initial::Number(0.4);
    let y = Stepper::new(&truth, &made).unwrap().outputs(&time).remove(0);
    let size = (y.iter().map(|y| y * y).sum::<f64>() / count as f64).sqrt();
    made.channels[1].values = y.iter().map(|y| y + noise * size * normal()).collect();
    let spoil = |y: &mut f64| match spoilt {
        Spoilt::Not => {}
        Spoilt::Offset => *y += 1.5,
        Spoilt::Turned => *y = -*y,
        Spoilt::InThousandths => *y *= 1e3,
    };
    made.channels[1].values.iter_mut().for_each(spoil);
    made
}

fn tells_nothing(a: &Answer, case: &str) {
    assert_eq!(a.verdict, Verdict::NotIdentifiable, "{case}: {}", a.says);
    assert!(a.findings.is_empty() && a.faults.is_empty(), "{case}: {}", a.says);
    assert!(a.says.contains("degrees of freedom"), "{case}: {}", a.says);
}

/// Of ten to fifteen rows, with the last of them held out or others, no test could tell anything from noise.
#[test]
fn a_dozen_rows_tell_nothing() {
    let fixed = Model::parse(LAG).unwrap();
    let free = Model::parse(&LAG.replace("unit = \"m/V\"", "unit = \"m/V\", fit = true")).unwrap();
    let spoilt = [Spoilt::Not, Spoilt::Offset, Spoilt::Turned, Spoilt::InThousandths];
    for (k, count) in [10, 12, 15].into_iter().enumerate() {
        for shape in 0..5 {
            for (j, how) in spoilt.into_iter().enumerate() {
                let seed = (100 * k + 10 * shape + j) as u64;
                let noise = [0.01, 0.1, 0.4][(k + shape + j) % 3];
                let case = format!("{count} rows, shape {shape}, {how:?}, noise {noise}");
                let made = rows(shape, count, noise, how, seed);
                let model = if seed.is_multiple_of(2) { &free } else { &fixed };
                tells_nothing(&diagnosed(model, made.clone()).answer, &case);
                let separate = [rows(shape, count, noise, how, seed + 1000)];
                let request = Request {
                    model,
                    source: None,
                    recordings: &[made],
                    separate: &separate,
                    seed: 1,
                    time_limit: None,
                    progress: &Silent,
                };
                tells_nothing(&diagnose(&request).unwrap().answer, &case);
            }
        }
    }
}

/// In a linear model an input turned over is an output turned over.
#[test]
fn a_sign_that_input_and_output_share_is_put_on_neither_alone() {
    let model = Model::parse(LAG).unwrap();
    for how in [Spoilt::Turned, Spoilt::InThousandths] {
        let a = diagnosed(&model, rows(3, 200, 0.05, how, 5)).answer;
        assert_eq!(a.verdict, Verdict::DataFault, "{}", a.says);
        assert_eq!(a.faults.len(), 1, "{}", a.says);
        let says = &a.faults[0].finding.says;
        assert!(
            says.contains("y h") && says.contains("or u h") && says.contains("cannot tell which"),
            "{says}"
        );
    }
}

/// Where nothing was held out, it is said, and no name is proved.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_was_not_held_out_is_said_and_proves_nothing() {
    let whole = |r: Recording| {
        let last = r.channels[0].time[r.channels[0].len() - 1];
        r.with_spans(vec![Span::new(0.0, last)], vec![])
    };
    let (model, complete) = recording(None);
    let a = diagnosed(&model, whole(complete)).answer;
    assert_eq!(a.verdict, Verdict::NothingMissing, "{}", a.says);
    assert!(a.says.contains("Nothing was held out"), "{}", a.says);
    assert!(a.notes.iter().any(|n| n.contains("nothing was held out")), "{:?}", a.notes);
    let (model, lacking) = recording(Some("1.5*sign(v)"));
    let a = diagnosed(&model, whole(lacking)).answer;
    assert_eq!(a.verdict, Verdict::Unknown, "{}", a.says);
    assert_eq!(a.findings[0].code, "dry-friction");
    assert!(a.says.contains("nothing was held out that could prove a name"), "{}", a.says);
}
