//! Outputs that are slower than the rows of their table.

use crate::diagnose::diagnosed;
use gyrospec::model::Model;
use gyrospec::record::{Recording, quality};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::fmt::Write as _;
use std::path::Path;

const ROWS: usize = 3000;
const STEP: f64 = 0.5;

const ROOM: &str = r#"
name = "room"
[inputs]
heating = { unit = "W" }
[parameters]
C = { value = 2000, unit = "J/K", fit = true, min = 200, max = 20000 }
H = { value = 30, unit = "W/K", fit = true, min = 3, max = 300 }
[states]
T = { rate = "(heating - H*T)/C", unit = "K", initial = "fit" }
[outputs]
room = { equals = "T", unit = "K" }
"#;

/// Rows of the time, the heating that the row begins, and the room with noise that remembers the last sample for a
/// half, both s and W and K. The heating is on or off for stretches of their own, so that the room is exact:
/// T(t + h) = T∞ + (T − T∞)·e^{−hH/C} with C = 1500 J/K, H = 20 W/K.
fn course() -> Vec<(f64, f64, f64)> {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let mut normal = || -> f64 { StandardNormal.sample(&mut rng) };
    let (mut room, mut noise, mut on) = (8.0, 0.0, false);
    let mut rows = Vec::new();
    for row in 0..ROWS {
        if row.is_multiple_of(3) {
            noise = 0.5 * noise + 0.05 * normal();
            on ^= row % 24 == 0 && normal() > 0.3;
        }
        let heating = if on { 400.0 } else { 0.0 };
        rows.push((STEP * row as f64, heating, room + noise));
        room = heating / 20.0 + (room - heating / 20.0) * (-STEP * 20.0 / 1500.0_f64).exp();
    }
    rows
}

/// Writes tables of the course and a recording of them; `shown` tells which rows hold the room's value.
fn recorded(folder: &Path, own_table: bool, shown: impl Fn(usize) -> bool) -> Recording {
    let (mut common, mut own) = (String::from("t,heating,room\n"), String::from("t,room\n"));
    for (row, (t, heating, room)) in course().into_iter().enumerate() {
        let cell = if shown(row) && !own_table { room.to_string() } else { String::new() };
        writeln!(common, "{t},{heating},{cell}").unwrap();
        if shown(row) {
            writeln!(own, "{t},{room}").unwrap();
        }
    }
    std::fs::write(folder.join("common.csv"), common).unwrap();
    std::fs::write(folder.join("own.csv"), own).unwrap();
    let time = "time = { column = \"t\", unit = \"s\" }\n[tables.channels]\n";
    let room = "room = { column = \"room\", unit = \"K\" }\n";
    let apart = if own_table { format!("[[tables]]\nfile = \"own.csv\"\n{time}") } else { String::new() };
    let heating = "heating = { column = \"heating\", unit = \"W\", hold = \"previous\" }\n";
    let text = format!("name = \"room\"\n[[tables]]\nfile = \"common.csv\"\n{time}{heating}{apart}{room}");
    std::fs::write(folder.join("room.toml"), text).unwrap();
    Recording::read(folder.join("room.toml")).unwrap()
}

fn told(recording: Recording) -> String {
    diagnosed(&Model::parse(ROOM).unwrap(), recording).answer.says
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn blanks_between_the_samples_of_a_slower_output_are_no_gap() {
    let folder = tempfile::tempdir().unwrap();
    let third = |row: usize| row.is_multiple_of(3);
    let common = recorded(folder.path(), false, third);
    let own = recorded(folder.path(), true, third);
    let (a, b) = (common.channel("room").unwrap(), own.channel("room").unwrap());
    assert_eq!((&a.time, &a.values), (&b.time, &b.values));
    let (common, own) = (told(common), told(own));
    assert_eq!(common, own);
    assert!(common.starts_with("Nothing is missing"), "{}", common);
}

#[test]
fn what_a_slower_output_lacks_beyond_its_pace_is_a_gap() {
    let folder = tempfile::tempdir().unwrap();
    let lost = recorded(folder.path(), false, |row| row.is_multiple_of(3) && !(900..1500).contains(&row));
    let faults = quality::faults(&lost);
    let gap = faults.iter().find(|f| f.kind.code() == "gap").expect("a gap");
    // row 897 is the last before, row 1500 the first after: 201 steps, 200 samples lost
    assert_eq!((gap.samples, gap.spans[0].from, gap.spans[0].to), (200, 897.0 * STEP, 1500.0 * STEP));
}

#[test]
fn samples_lost_at_random_are_gaps() {
    let folder = tempfile::tempdir().unwrap();
    // two rows of five have a value, no pace between them
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let kept: Vec<bool> = (0..ROWS)
        .map(|_| {
            let x: f64 = StandardNormal.sample(&mut rng);
            x > 0.25
        })
        .collect();
    let random = recorded(folder.path(), false, |row| kept[row]);
    assert_eq!(random.channel("room").unwrap().len(), ROWS);
    assert!(quality::faults(&random).iter().any(|f| f.kind.code() == "gap" && f.sure));
}

/// The room of a slow instrument, whose rows repeat it until it reads anew: late by half of its step as it stands.
#[test]
fn an_output_that_is_repeated_between_its_readings_has_no_lag() {
    let folder = tempfile::tempdir().unwrap();
    let mut every = recorded(folder.path(), false, |_| true);
    let room = every.channels.iter_mut().find(|c| c.name == "room").unwrap();
    for row in 0..room.values.len() {
        room.values[row] = room.values[row - row % 24];
    }
    let answer = diagnosed(&Model::parse(ROOM).unwrap(), every).answer;
    assert!(answer.says.starts_with("Nothing is missing"), "{}", answer.says);
    let told = "room was read every 12 s and repeated in between";
    assert!(answer.notes.iter().any(|n| n.starts_with(told)), "{:?}", answer.notes);
}
