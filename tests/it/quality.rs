//! Faults of recordings: made ones are found where they are, honest signals have none.

use gyrospec::record::quality::{self, Fault, FaultKind};
use gyrospec::record::{Channel, Recording, Span};
use gyrospec::units::Unit;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, StandardNormal};

const STEP: f64 = 0.1;

fn channel(unit: &str, values: Vec<f64>) -> Channel {
    let time: Vec<f64> = (0..values.len()).map(|i| i as f64 * STEP).collect();
    Channel::new("x", Unit::parse(unit).unwrap(), time, values)
}

fn faults(c: Channel) -> Vec<Fault> {
    quality::faults(&Recording::from_channels("made", vec![c]).unwrap())
}

fn normal(rng: &mut ChaCha12Rng) -> f64 {
    StandardNormal.sample(rng)
}

/// x_i = a x_(i-1) + e_i
fn autoregressive(rng: &mut ChaCha12Rng, n: usize, a: f64) -> Vec<f64> {
    let mut x = 0.0;
    (0..n)
        .map(|_| {
            x = a * x + normal(rng);
            x
        })
        .collect()
}

/// Honest signals of many sorts.
fn honest(rng: &mut ChaCha12Rng, sort: usize, n: usize) -> Vec<f64> {
    let noise = 10f64.powf(rng.random_range(-4.0..-1.0));
    let quantum = 10f64.powf(rng.random_range(-4.0..-1.5));
    let rate: f64 = rng.random_range(0.002..0.3);
    let rounded = |x: f64| (x / quantum).round() * quantum;
    match sort {
        0 => autoregressive(rng, n, 0.0),
        1 => autoregressive(rng, n, 0.98),
        2 => (0..n).map(|i| (rate * i as f64).sin() + noise * normal(rng)).collect(),
        3 => (0..n).map(|i| rounded((rate * i as f64).sin() + noise * normal(rng))).collect(),
        // Switched between two levels at random.
        4 => {
            let mut level = 3.41;
            (0..n)
                .map(|_| {
                    if rng.random_bool(0.1) {
                        level = 9.82 - level;
                    }
                    level
                })
                .collect()
        }
        // A motion that dies away under its own resolution.
        5 => (0..n).map(|i| rounded((-(i as f64) / 300.0).exp() * (rate * i as f64).cos())).collect(),
        // At rest, then a step, then at rest.
        6 => {
            (0..n).map(|i| if i < n / 3 { 0.0 } else { 1.0 - (-((i - n / 3) as f64) / 50.0).exp() }).collect()
        }
        // Trapezoids with dwells on several levels, as of a positioning axis.
        7 => {
            let corners: Vec<f64> = (0..12).map(|_| f64::from(rng.random_range(0..5))).collect();
            (0..n)
                .map(|i| {
                    let (k, s) = ((i / 200) % 11, ((i % 200) as f64 / 120.0).min(1.0));
                    corners[k] + (corners[k + 1] - corners[k]) * s
                })
                .collect()
        }
        // Heavy tails: squares of a motion, and rare pulses several samples long.
        8 => autoregressive(rng, n, 0.9).into_iter().map(|x| x * x.abs()).collect(),
        _ => (0..n).map(|i| if i % 400 > 390 { 5.0 } else { 0.0 }).collect(),
    }
}

#[test]
fn honest_signals_have_no_sure_faults() {
    let mut rng = ChaCha12Rng::seed_from_u64(11);
    let (mut sure, mut suspected, mut total) = (Vec::new(), 0, 0);
    for case in 0..600 {
        let sort = case % 10;
        let n = rng.random_range(600..4000);
        let found = faults(channel("m", honest(&mut rng, sort, n)));
        // Coarse resolution of a slow signal is what it is, not a false alarm.
        let wrong = found.into_iter().filter(|f| f.kind != FaultKind::Quantisation);
        for fault in wrong {
            if fault.sure { sure.push((sort, fault)) } else { suspected += 1 }
        }
        total += 1;
    }
    assert!(sure.len() * 200 <= total, "{} of {total}: {sure:?}", sure.len());
    // Rests of commanded motions are looked at by people.
    assert!(suspected * 3 <= total, "{suspected} suspicions in {total}");
}

#[test]
fn stuck_spans_are_found_where_they_are() {
    let mut rng = ChaCha12Rng::seed_from_u64(12);
    let mut missed = 0;
    for case in 0..60 {
        // Noisy ones, smooth slow ones, and noise alone; one or two stuck spans.
        let sort = [2, 1, 0][case % 3];
        let mut values = honest(&mut rng, sort, 3000);
        let length = rng.random_range(80..250);
        let starts = if case % 2 == 0 { vec![1000] } else { vec![700, 2000] };
        for start in &starts {
            let held = values[*start];
            values[*start..start + length].fill(held);
        }
        let found = faults(channel("m", values));
        let Some(fault) = found.iter().find(|f| f.kind == FaultKind::Frozen && f.sure) else {
            // A smooth motion may come back to where it was held.
            missed += 1;
            continue;
        };
        assert_eq!(fault.spans.len(), starts.len(), "case {case}: {fault:?}");
        for (span, start) in fault.spans.iter().zip(&starts) {
            assert!((span.from - *start as f64 * STEP).abs() < 1.5 * STEP);
            assert!((span.to - (start + length - 1) as f64 * STEP).abs() < 1.5 * STEP);
        }
    }
    assert!(missed <= 3, "{missed} of 60 missed");
}

#[test]
fn a_channel_stuck_to_its_end_is_found() {
    let mut rng = ChaCha12Rng::seed_from_u64(13);
    let mut values = honest(&mut rng, 1, 3000);
    let held = values[1800];
    values[1800..].fill(held);
    let found = faults(channel("m", values));
    assert!(found.iter().any(|f| f.kind == FaultKind::Frozen && f.sure && f.samples >= 1199), "{found:?}");
}

/// What drives a thing rests or holds, and with it all but the noise of a sensor beside it.
#[test]
fn what_has_noise_and_repeats_is_stuck_though_all_rests_beside_it() {
    let mut rng = ChaCha12Rng::seed_from_u64(17);
    for noise in [0.002, 0.02] {
        let motion = |i: usize| if i < 1000 { (0.02 * i as f64).sin() } else { (20.0_f64).sin() };
        let rests: Vec<f64> = (0..2000).map(|i| motion(i) + noise * normal(&mut rng)).collect();
        assert_eq!(faults(channel("m", rests.clone())), []);
        let mut stuck = rests;
        let held = stuck[1300];
        stuck[1300..1500].fill(held);
        let found = faults(channel("m", stuck));
        assert_eq!((found.len(), found[0].kind, found[0].samples), (1, FaultKind::Frozen, 200), "{found:?}");
        assert!(found[0].is_sure_of_any(), "{found:?}");
    }
}

/// Noise that comes with the motion alone, as of a toothed wheel, may rest with it.
#[test]
fn what_is_noisy_only_where_it_moves_may_rest() {
    let mut rng = ChaCha12Rng::seed_from_u64(18);
    for case in 0..20 {
        let mut x = 0.0;
        let turns =
            |i: usize| if (900..1200).contains(&i) { 0.0 } else { (0.01 * i as f64 + f64::from(case)).sin() };
        let values = (0..3000).map(|i| {
            x += turns(i) * (1.0 + 0.3 * normal(&mut rng));
            x
        });
        let found = faults(channel("m", values.collect()));
        assert!(found.iter().all(|f| !f.sure), "case {case}: {found:?}");
    }
}

/// Without a model nobody knows whether a channel without noise is a command that is held.
#[test]
fn a_command_that_holds_and_leaps_is_for_people_to_look_at() {
    let command = |i: usize| if (300..650).contains(&i) { -3.0 } else { 4.0 * (0.025 * i as f64).sin() };
    let found = faults(channel("V", (0..1000).map(command).collect()));
    assert!(found.iter().any(|f| f.kind == FaultKind::Frozen), "{found:?}");
    assert!(found.iter().all(|f| !f.is_sure_of_any()), "{found:?}");
}

#[test]
fn outliers_are_found_and_masked() {
    let mut rng = ChaCha12Rng::seed_from_u64(14);
    for sort in [0, 1, 2, 3] {
        let mut values = honest(&mut rng, sort, 2000);
        let mut spread: Vec<f64> = values.windows(2).map(|w| (w[1] - w[0]).abs()).collect();
        spread.sort_by(f64::total_cmp);
        let places = [100, 555, 1400];
        for at in places {
            values[at] += 30.0 * spread[1900].max(0.1);
        }
        let c = channel("m", values);
        let r = Recording::from_channels("made", vec![c]).unwrap();
        let found = quality::faults(&r);
        let fault = found.iter().find(|f| f.kind == FaultKind::Outliers).expect("outliers");
        let at: Vec<usize> = fault.spans.iter().map(|s| (s.from / STEP).round() as usize).collect();
        assert_eq!(at, places, "sort {sort}");
        let clean = quality::masked(&r, &found);
        assert!(places.iter().all(|p| clean.channels[0].values[*p].is_nan()));
        assert!(clean.channels[0].samples().count() == 1997 || sort == 3);
    }
}

#[test]
fn the_top_of_a_quick_transient_is_no_outlier() {
    let mut rng = ChaCha12Rng::seed_from_u64(16);
    let mut values: Vec<f64> = (0..2000).map(|_| rng.random_range(-0.001..0.001)).collect();
    // The current after steps of a voltage: e^(−t/T₁) − e^(−t/T₂)
    for (at, quick) in [(200, 1.1), (600, 1.3), (1000, 1.7), (1400, 2.3)] {
        for k in 0..400 {
            let t = k as f64;
            values[at + k] += 10.0 * ((-t / 60.0).exp() - (-t / quick).exp());
        }
    }
    let found = faults(channel("m", values));
    assert!(found.iter().all(|f| f.kind != FaultKind::Outliers), "{found:?}");
}

#[test]
fn gaps_are_holes_in_values_or_times() {
    let mut c = channel("m", (0..1000).map(|i| f64::from(i).sin()).collect());
    c.values[100..110].fill(f64::NAN);
    let time: Vec<f64> = c.time.iter().map(|t| if *t > 50.0 { t + 5.0 } else { *t }).collect();
    c.time = time.into();
    let gaps = quality::gaps(&c).unwrap();
    assert_eq!(gaps.samples, 10 + 50);
    assert!((gaps.spans[0].from - 9.9).abs() < 1e-9 && (gaps.spans[0].to - 11.0).abs() < 1e-9);
    assert!((gaps.size - 5.1).abs() < 1e-9 && gaps.sure);
    let mut rng = ChaCha12Rng::seed_from_u64(15);
    let mut t = 0.0;
    let time: Vec<f64> = (0..1000)
        .map(|_| {
            t += rng.random_range(0.2..2.0);
            t
        })
        .collect();
    assert_eq!(quality::gaps(&Channel::new("x", Unit::one(), time, vec![1.0; 1000])), None);
}

/// Rows two seconds apart and a waiting time beyond: of a hundred such clocks about one has a gap by chance.
#[test]
fn a_clock_that_waits_at_random_has_no_gaps() {
    let gap = |seed: u64, lost: f64| {
        let mut rng = ChaCha12Rng::seed_from_u64(seed);
        let mut t = 0.0;
        let next = |i: usize| {
            t += 2.0 - 11.0 * rng.random::<f64>().ln() + if i == 700 { lost } else { 0.0 };
            t
        };
        let time: Vec<f64> = (0..2000).map(next).collect();
        let values = time.iter().map(|t| (0.01 * t).sin()).collect();
        let found = faults(Channel::new("x", Unit::one(), time, values));
        found.into_iter().find(|f| f.kind == FaultKind::Gap)
    };
    let by_chance = (0..200).filter(|seed| gap(*seed, 0.0).is_some()).count();
    assert!(by_chance <= 8, "{by_chance}");
    for seed in 0..50 {
        let fault = gap(seed, 600.0).unwrap();
        assert!(fault.size > 600.0 && fault.samples > 40, "{fault:?}");
    }
}

#[test]
fn an_angle_that_jumps_by_a_turn_is_found_unless_marked() {
    let heading =
        |i: usize| (350.0 + 0.1 * i as f64 + 3.0 * (0.05 * i as f64).sin()).rem_euclid(360.0).to_radians();
    let mut c = channel("deg", (0..2000).map(heading).collect());
    let fault = quality::wrapped_angle(&c).unwrap();
    assert!(fault.sure && fault.spans.iter().all(|s: &Span| s.length() < 2.0 * STEP));
    assert_eq!(
        quality::faults(&Recording::from_channels("made", vec![c.clone()]).unwrap())[0].kind,
        FaultKind::WrappedAngle
    );
    c.wraps = true;
    assert_eq!(quality::wrapped_angle(&c), None);
    // A real leap of less than a turn is none.
    let leap = channel("deg", (0..500).map(|i| if i < 250 { 0.1 } else { 5.0 }).collect());
    assert_eq!(quality::wrapped_angle(&leap), None);
}

#[test]
fn noise_about_north_is_no_outlier() {
    let mut rng = ChaCha12Rng::seed_from_u64(31);
    // a ship that starts on a course of 0.4°, and turns away after a minute
    let course = |i: usize| (0.4 + 0.02 * i.saturating_sub(600) as f64).to_radians();
    let values: Vec<f64> =
        (0..3000).map(|i| (course(i) + 0.003 * normal(&mut rng)).rem_euclid(std::f64::consts::TAU)).collect();
    let found = faults(channel("deg", values.clone()));
    let kinds: Vec<FaultKind> = found.iter().map(|f| f.kind).collect();
    assert_eq!(kinds, [FaultKind::WrappedAngle], "{found:?}");
    // and one sample that is off is one still
    let mut off = values;
    off[2000] += 1.0;
    let found = faults(channel("deg", off));
    let kinds: Vec<(FaultKind, usize)> = found.iter().map(|f| (f.kind, f.samples)).collect();
    assert_eq!(kinds[0], (FaultKind::Outliers, 1), "{found:?}");
    assert_eq!(kinds[1].0, FaultKind::WrappedAngle, "{found:?}");
}

#[test]
fn the_quantum_is_the_step_of_the_file() {
    let mut rng = ChaCha12Rng::seed_from_u64(16);
    for quantum in [1.0_f64, 0.1, 0.01, 0.25] {
        let values = (0..3000).map(|i| {
            ((10.0 * (0.01 * f64::from(i)).sin() + 0.3 * normal(&mut rng)) / quantum).round() * quantum
        });
        let c = channel("deg", values.map(f64::to_radians).collect());
        let q = quality::quantum(&c).unwrap().to_degrees();
        assert!((q - quantum).abs() < 1e-9, "{q} for {quantum}");
    }
    assert_eq!(quality::quantum(&channel("m", autoregressive(&mut rng, 1000, 0.5))), None);
    let stairs = (0..3000).map(|i| (5.0 * (0.005 * f64::from(i)).sin()).round()).collect();
    assert!(quality::coarse_steps(&channel("m", stairs)).is_some());
}

#[test]
fn a_rate_that_changes_is_suspected_and_jitter_is_not() {
    let mut rng = ChaCha12Rng::seed_from_u64(17);
    for change in [0.0, 0.01] {
        let mut t = 0.0;
        let time: Vec<f64> = (0..4000)
            .map(|i| {
                t += if i > 2000 { 0.1 * (1.0 + change) } else { 0.1 };
                t + 0.002 * normal(&mut rng)
            })
            .collect();
        let c = Channel::new("x", Unit::one(), time, autoregressive(&mut rng, 4000, 0.5));
        let found = faults(c);
        assert_eq!(found.iter().any(|f| f.kind == FaultKind::ClockDrift), change > 0.0, "{found:?}");
    }
}

/// Real sets: file, time, and columns with their units.
const REAL: [(&str, &str, &str); 7] = [
    ("emps/emps_estimation.csv.gz", "column = \"time_s\"", "qm_meas_m:m vir_V:V"),
    ("emps/emps_validation_pulses.csv.gz", "column = \"time_s\"", "qm_meas_m:m vir_V:V pulses_N:N"),
    ("kvlcc2_roll_decay/model_test_21338.csv.gz", "column = \"time_s\"", "roll_rad:rad pitch_rad:rad"),
    ("silverbox/SNLS80mV.csv.gz", "start = 0, step = 0.0016384", "u_V:V y_V:V"),
    ("cascaded_tanks/cascaded_tanks.csv", "column = \"time_s\"", "u_est_V:V y_est_V:V u_val_V:V y_val_V:V"),
    ("daisy/dryer.csv", "start = 0.0, step = 0.08", "u_heater:V y_air_temp:V"),
    ("daisy/heating_system.csv", "column = \"t_s\"", "u_drive_V:V y_temp_C:degC"),
];

#[test]
fn real_recordings_have_no_sure_faults() {
    let folder = tempfile::tempdir().unwrap();
    for (file, time, columns) in REAL {
        let Some(set) = crate::record::recordings(file.split('/').next().unwrap()) else { continue };
        let path = set.parent().unwrap().join(file);
        let mut toml =
            format!("[[tables]]\nfile = {path:?}\ntime = {{ {time}, unit = \"s\" }}\n[tables.channels]\n");
        for (column, unit) in columns.split(' ').filter_map(|c| c.split_once(':')) {
            toml += &format!("{column} = {{ column = \"{column}\", unit = \"{unit}\" }}\n");
        }
        let toml_file = folder.path().join("r.toml");
        std::fs::write(&toml_file, toml).unwrap();
        let recording = Recording::read(&toml_file).unwrap();
        let sure: Vec<Fault> = quality::faults(&recording).into_iter().filter(|f| f.sure).collect();
        assert!(sure.is_empty(), "{file}: {sure:?}");
    }
}
