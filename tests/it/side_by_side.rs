//! Tables whose signals stand behind times of their own: `t1,F,t2,x`.

use gyrospec::record::Recording;
use std::fmt::Write as _;

/// A force each 0.1 s and a place each 0.25 s from 0.03 s on, in one table; `behind` is what each clock is called.
fn table(behind: [&str; 2]) -> String {
    let mut text = format!("{} [s],F [N],{} [s],x [mm]\n", behind[0], behind[1]);
    for i in 0..100 {
        let t = 0.1 * f64::from(i);
        let place = if i < 40 { format!("{},{}", 0.03 + 0.25 * f64::from(i), 2 * i) } else { ",".into() };
        writeln!(text, "{t},{i},{place}").unwrap();
    }
    text
}

fn read(name: &str, text: &str) -> gyrospec::Result<Recording> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(name);
    std::fs::write(&file, text).unwrap();
    Recording::read(&file)
}

#[test]
fn each_signal_is_read_on_the_clock_before_it() {
    for behind in [["t1", "t2"], ["time", "time"], ["t_force", "scope"]] {
        let r = read("log.csv", &table(behind)).unwrap_or_else(|e| panic!("{behind:?}: {e}"));
        let (force, place) = (r.channel("F").unwrap(), r.channel("x").unwrap());
        assert_eq!((force.len(), place.len(), r.channels.len(), r.origins.len()), (100, 40, 2, 2));
        assert_eq!((place.time[4], place.values[4]), (0.03 + 0.25 * 4.0, 0.008));
        assert_eq!((force.time[70], force.values[70]), (0.1 * 70.0, 70.0));
        assert!(force.table != place.table);
        let told = format!("column 3, `{}`, is the clock of `x`", behind[1]);
        assert!(r.notes.iter().any(|n| n.message == told), "{:?}", r.notes);
    }
}

#[test]
fn the_longer_clock_may_be_the_second() {
    let text = table(["t1", "t2"]);
    let turned: String = text
        .lines()
        .map(|l| l.split(',').collect::<Vec<_>>())
        .map(|f| format!("{},{},{},{}\n", f[2], f[3], f[0], f[1]))
        .collect();
    let r = read("turned.csv", &turned).unwrap();
    assert_eq!((r.channel("F").unwrap().len(), r.channel("x").unwrap().len()), (100, 40));
    // a value without a time is no sample
    let untimed = turned.replace("\n,,9.9,99\n", "\n,7,9.9,99\n");
    let e = read("untimed.csv", &untimed).unwrap_err();
    assert!(untimed != turned && e.to_string().contains("row 100"), "{e}");
}

#[test]
fn times_of_the_same_rows_stay_channels() {
    // the same moments from another zero, a time that falls, and one behind which nothing stands
    let with = |name: &str, of: fn(i32) -> f64| {
        let rows: String =
            (0..50).map(|i| format!("{},{i},{},{}\n", 0.1 * f64::from(i), of(i), 3 * i)).collect();
        read("log.csv", &format!("t [s],F [N],{name} [s],x [mm]\n{rows}")).unwrap()
    };
    for (name, of) in
        [("stamp", (|i| 17.0 + 0.1 * f64::from(i)) as fn(i32) -> f64), ("left", |i| 9.0 - f64::from(i))]
    {
        let r = with(name, of);
        assert_eq!((r.channels.len(), r.origins.len()), (3, 1), "{name}");
        assert_eq!(r.channel("x").unwrap().time[10], 0.1 * 10.0);
    }
}

#[test]
fn a_recording_file_may_name_a_clock_that_ends_before_the_table() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("log.csv"), table(["t1", "t2"])).unwrap();
    let one = |time: &str, channel: &str| {
        format!(
            "[[tables]]\nfile = \"log.csv\"\ntime = {{ column = \"{time}\" }}\n[tables.channels]\n{channel} = {{ column = \"{channel}\" }}\n"
        )
    };
    let text = format!("name = \"two\"\n{}{}", one("t1", "F"), one("t2", "x"));
    let r = Recording::parse(&text, folder.path().join("log.toml")).unwrap();
    assert_eq!((r.channel("F").unwrap().len(), r.channel("x").unwrap().len()), (100, 40));
    // so it may where it stands behind its values
    let behind: String = table(["t1", "t2"])
        .lines()
        .map(|l| l.split(',').collect::<Vec<_>>())
        .fold(String::new(), |text, f| text + &format!("{},{},{},{}\n", f[0], f[1], f[3], f[2]));
    std::fs::write(folder.path().join("log.csv"), behind).unwrap();
    let r = Recording::parse(&text, folder.path().join("log.toml")).unwrap();
    let place = r.channel("x").unwrap();
    assert!(place.len() == 40 && place.time.iter().all(|t| t.is_finite()));
    // a time that is missing beside a value is told, with its line
    let broken = table(["t1", "t2"]).replacen("0.28,2", ",2", 1);
    std::fs::write(folder.path().join("log.csv"), broken).unwrap();
    let e = Recording::parse(&text, folder.path().join("log.toml")).unwrap_err();
    assert!(e.to_string().contains("the time is empty") && e.line() == Some(3), "{e}");
}
