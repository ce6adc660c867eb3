//! Damaged input: whatever bytes come, the readers answer with numbers that keep their promises
//! or with an error, never with a panic.
//!
//! GYROSPEC_FUZZ sets the number of cases of each reader (500 by default). Run long once before
//! the first release, without a finding: 1 500 000 expressions, 520 000 TOML recordings, 400 000
//! models, 400 000 tables, 100 000 logs.

use gyrospec::expression::Expr;
use gyrospec::model::Model;
use gyrospec::record::{Recording, quality};
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::fs;

const TOKENS: [&str; 44] = [
    ",",
    "\n",
    "\r\n",
    "\r",
    ";",
    "\t",
    "\"",
    "'",
    "\u{feff}",
    "\0",
    "é",
    "NaN",
    "nan",
    "inf",
    "1e308",
    "-1e-400",
    "-",
    "+",
    ".",
    "0",
    "99999999999999999999",
    "0x1f",
    "[",
    "]",
    "{",
    "}",
    "=",
    "[[tables]]",
    "[spans]",
    "$",
    "*",
    "!",
    "2020-01-01T00:00:00Z",
    "(",
    ")",
    "^",
    "*-",
    "/0",
    "t",
    "sin(",
    "delay(",
    "kg",
    "\u{1f}\u{8b}",
    "#",
];

/// One way to damage a text.
#[derive(Debug, Clone)]
enum Damage {
    Byte(Index, u8),
    Insert(Index, usize),
    Delete(Index, usize),
    Repeat(Index, usize),
    Cut(Index),
}

fn damage() -> impl Strategy<Value = Damage> {
    prop_oneof![
        4 => (any::<Index>(), any::<u8>()).prop_map(|(i, b)| Damage::Byte(i, b)),
        6 => (any::<Index>(), 0..TOKENS.len()).prop_map(|(i, t)| Damage::Insert(i, t)),
        3 => (any::<Index>(), 1..20_usize).prop_map(|(i, n)| Damage::Delete(i, n)),
        2 => (any::<Index>(), 1..40_usize).prop_map(|(i, n)| Damage::Repeat(i, n)),
        1 => any::<Index>().prop_map(Damage::Cut),
    ]
}

fn damaged(text: &str, all: &[Damage]) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for one in all {
        let n = bytes.len();
        let range = |i: &Index, k: usize| (i.index(n), (i.index(n) + k).min(n));
        match one {
            _ if n == 0 => {}
            Damage::Byte(i, b) => bytes[i.index(n)] = *b,
            Damage::Insert(i, t) => drop(bytes.splice(i.index(n)..i.index(n), TOKENS[*t].bytes())),
            Damage::Delete(i, k) => drop(bytes.drain(range(i, *k).0..range(i, *k).1)),
            Damage::Repeat(i, k) => {
                let part = bytes[range(i, *k).0..range(i, *k).1].to_vec();
                bytes.splice(i.index(n)..i.index(n), part);
            }
            Damage::Cut(i) => bytes.truncate(i.index(n)),
        }
    }
    bytes
}

fn cases() -> u32 {
    std::env::var("GYROSPEC_FUZZ").ok().and_then(|n| n.parse().ok()).unwrap_or(500)
}

/// Runs a reader on damaged copies of some texts.
fn fuzz(seeds: &[&str], check: impl Fn(&[u8])) {
    let config = Config { cases: cases(), failure_persistence: None, ..Config::default() };
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]);
    let strategy = (0..seeds.len(), proptest::collection::vec(damage(), 0..6));
    let mut runner = TestRunner::new_with_rng(config, rng);
    let result = runner.run(&strategy, |(seed, all)| {
        check(&damaged(seeds[seed], &all));
        Ok(())
    });
    result.unwrap_or_else(|e| panic!("{e}"));
}

/// What every recording promises.
fn keeps_promises(result: gyrospec::Result<Recording>) {
    match result {
        Ok(r) => {
            for c in &r.channels {
                assert_eq!(c.time.len(), c.values.len());
                assert!(c.time.windows(2).all(|w| w[0] < w[1]), "times rise");
                assert!(c.time.iter().all(|t| t.is_finite()));
                assert!(c.values.iter().all(|v| !v.is_infinite()));
                assert_eq!(r.channels.iter().filter(|o| o.name == c.name).count(), 1);
            }
            let found = quality::faults(&r);
            let _ = quality::masked(&r, &found);
        }
        Err(e) => assert!(e.file().is_some() && !e.to_string().is_empty(), "{e}"),
    }
}

const TABLE: &str = "t [s],roll [deg],x [m]\n0.0,1.5,10\n0.5,,11\n1.0,\"2.5\",12\n1.5,NaN,-1e-3\n2,3,14\n";
const TABLE_OF_OTHER_LINE_ENDS: &str = "t [ms],x [1]\r\n0,1\r\n1,2\r\n2,2\r\n";

#[test]
fn damaged_tables() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.csv");
    fuzz(&[TABLE, TABLE_OF_OTHER_LINE_ENDS, "t [s]\n1\n2\n"], |bytes| {
        fs::write(&path, bytes).unwrap();
        keeps_promises(Recording::read(&path));
    });
}

const LOG: &str = "2020-01-01T00:00:00.5Z $HEHDT,359.5,T*2B\n2020-01-01T00:00:01Z $PSXN,20,0,0,0,0*3B\n\
    2020-01-01T00:00:02Z $HEHDT,092.34,T*13\n2020-01-01T00:00:03Z $GPVTG,94.34,T,78.47,M,8.7,N,16.1,K,D*19\n\
    2020-01-01T00:00:04Z $GPGGA,000000.69,4812.030845,N,12307.411216,W,2,08,1.1,-1.44,M,-18.40,M,1.2,0001*59\n\
    2020-01-01T00:00:05Z $TIROT,-0003.0,A*25\n2020-01-01T00:00:06Z $GPZDA,000000.69,06,12,2018,,*67\n";

const LOG_WITHOUT_STAMPS: &str = "$GPZDA,235959.00,31,12,2019,,*6C\n\
    $HEHDT,359.5,T*25\n\
    $HEHDT,0.5,T*2A\n\
    $GPGGA,235959.50,4812.300000,S,12330.600000,W,2,08,1.1,-1.44,M,-18.40,M,1.2,0001*45\n\
    $GPZDA,000000.00,01,01,2020,,*66\n\
    $HEHDT,1.5,T*2B\n\
    $TIROT,-0003.0,A*25\n\
    $GPZDA,000001.00,01,01,2020,,*67\n";

#[test]
fn damaged_logs() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.nmea");
    fuzz(&[LOG, LOG_WITHOUT_STAMPS], |bytes| {
        fs::write(&path, bytes).unwrap();
        keeps_promises(Recording::read(&path));
    });
}

const RECORDING: &str = "name = \"r\"\n[[tables]]\nfile = \"a.csv\"\ntime = { column = \"t\", unit = \"s\" }\n\
    rows = [1, 3]\n[tables.channels]\nroll = { column = \"roll\", unit = \"deg\", wraps = true }\n\
    x = { column = \"x\", unit = \"cm\", hold = \"previous\" }\n[spans]\nfit = [[0.0, 1.0]]\n\
    holdout = [[1.0, 2.0]]\n[constants]\nlat = { value = 46.5, unit = \"deg\" }\n";
const RECORDING_OF_A_LOG: &str = "[[tables]]\nfile = \"a.nmea\"\nformat = \"nmea0183\"\n\
    time = { start = \"2020-01-01T00:00:00Z\" }\n[tables.channels]\n\
    h = { sentence = \"HDT\", field = 1, unit = \"deg\", wraps = true }\n\
    q = { sentence = \"PSXN\", id = 20, field = 2, unit = \"1\" }\n";
const TRIALS: &str = "kind = \"trials\"\n[[tables]]\nfile = \"a.csv\"\n[spans]\nfit = [[0, 2]]\n";

#[test]
fn damaged_toml_recordings() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.csv"), TABLE).unwrap();
    fs::write(folder.path().join("a.nmea"), LOG).unwrap();
    let path = folder.path().join("r.toml");
    fuzz(&[RECORDING, RECORDING_OF_A_LOG, TRIALS], |bytes| {
        fs::write(&path, bytes).unwrap();
        keeps_promises(Recording::read(&path));
    });
}

const MODEL: &str = "name = \"axis\"\n[inputs]\nforce = { unit = \"N\" }\n[parameters]\n\
    M = { value = 90.0, unit = \"kg\", fit = true, min = 1.0, max = 1e3 }\nFv = { value = 2e2, unit = \"N*s/m\" }\n\
    [definitions]\ndrive = { equals = \"force - Fv*v\", unit = \"N\" }\n[states]\n\
    q = { rate = \"v\", unit = \"m\", initial = \"fit\" }\nv = { rate = \"drive/M\", unit = \"m/s\", initial = 0.0 }\n\
    [outputs]\nposition = { equals = \"q\", unit = \"m\" }\n";
const MODEL_THAT_EXTENDS: &str =
    "extends = \"gyrosphere\"\n[parameters]\nT = { value = 0.5, unit = \"s\" }\n";

#[test]
fn damaged_models() {
    fuzz(&[MODEL, MODEL_THAT_EXTENDS], |bytes| {
        let text = String::from_utf8_lossy(bytes);
        if let Ok(model) = Model::parse(&text) {
            let again = Model::parse(&model.to_toml()).map(|m| m.to_toml());
            assert_eq!(again.ok(), Some(model.to_toml()), "what is written reads back");
        }
    });
}

#[test]
fn damaged_expressions() {
    let seeds = [
        "-P^2*amplitude^2*frequency^4*sin(2*heading)/(4*H*U*cos(lat)*g^2*C0*(1 + frequency^2*T^2))",
        "lP/H*beta + C/H*lambda - -U^-2^0.5",
        "clamp(x, -1e-3, min(a, 2)) + step(t - 5)*delay(u, 0.2) - backlash(q, gap)",
        "((((((1))))))",
    ];
    fuzz(&seeds, |bytes| {
        let text = String::from_utf8_lossy(bytes);
        if let Ok(tree) = Expr::parse(&text) {
            let printed = tree.to_string();
            assert_eq!(Expr::parse(&printed).ok(), Some(tree), "{text} prints as {printed}");
        }
    });
}

#[test]
fn expressions_of_any_depth_do_not_overflow_the_stack() {
    for deep in
        ["(".repeat(100_000), "-".repeat(100_000) + "1", "sin(".repeat(50_000), "1^".repeat(100_000) + "1"]
    {
        let _ = Expr::parse(&deep);
    }
    let long = "1+".repeat(50_000) + "1";
    let _ = Expr::parse(&long).map(|e| e.to_string());
}
