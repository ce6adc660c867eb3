//! Every option is used or refused: each pair of them is called, from the parser's own list.

use clap::CommandFactory;
use rayon::prelude::*;
use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;

/// An argument of a subcommand with words that make a difference; `%` stands for a new file.
struct Given {
    id: String,
    words: Vec<String>,
    /// The file that it writes.
    file: Option<String>,
}

/// All arguments of a subcommand, each with the words of the list; one that the list lacks fails.
fn arguments(name: &str, list: &[(&str, &str)]) -> Vec<Given> {
    let program = gyrospec::cli::Cli::command();
    let command = program.find_subcommand(name).unwrap();
    let ids = command.get_arguments().map(|a| a.get_id().as_str()).filter(|i| *i != "help");
    ids.map(|id| {
        let (_, words) =
            list.iter().find(|(i, _)| *i == id).unwrap_or_else(|| panic!("{name}: give {id} a value here"));
        let words: Vec<String> = words.split(' ').map(|w| w.replace('%', &format!("{id}.out"))).collect();
        let file = words.iter().find(|w| w.contains(".out")).cloned();
        Given { id: id.to_owned(), words, file }
    })
    .collect()
}

/// Exit code, answer and whether each file that was to be written is there.
fn called(name: &str, folder: &Path, parts: &[&Given], before: &[&str]) -> (i32, String) {
    let own = tempfile::tempdir_in(folder).unwrap();
    for file in ["compass.toml", "gimbal.toml", "roll.csv", "trials.csv"] {
        std::fs::copy(folder.join(file), own.path().join(file)).unwrap();
    }
    let words = parts.iter().flat_map(|p| &p.words);
    let out = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .current_dir(own.path())
        .arg(name)
        .args(words)
        .args(before)
        .output()
        .unwrap();
    let code = out.status.code().unwrap();
    let missing = parts.iter().filter_map(|p| p.file.as_ref()).find(|f| !own.path().join(f).exists());
    if let (0, Some(file)) = (code, missing) {
        panic!("{name} {:?}: wrote no {file}", parts.iter().map(|p| &p.id).collect::<Vec<_>>());
    }
    (code, String::from_utf8_lossy(&out.stdout).into_owned())
}

/// Words beside those of a call; the free motion, the Scorsby table and the list take none.
fn beside<'a>(parts: &[&Given], before: &[&'a str]) -> Vec<&'a str> {
    if parts.iter().any(|g| ["free", "scorsby", "list"].contains(&g.id.as_str())) {
        Vec::new()
    } else {
        before.to_vec()
    }
}

/// What an argument alone gives: as text, and as JSON where that is asked for.
struct Alone<'a> {
    given: &'a Given,
    text: (i32, String),
    json: OnceLock<(i32, String)>,
}

/// What is wrong with a pair: neither refused nor seen in the answer, as text or JSON, beside each alone.
fn dropped(name: &str, folder: &Path, pair: [&Alone; 2], before: &[&str]) -> Option<String> {
    let parts = pair.map(|p| p.given);
    let ids = format!("{} {}", parts[0].id, parts[1].id);
    let both = called(name, folder, &parts, &beside(&parts, before));
    match both.0 {
        2 => return None,
        0 => {}
        code => return Some(format!("{ids}: ends with {code}")),
    }
    let in_json = |parts: &[&Given]| {
        let words: Vec<&str> = beside(parts, before).into_iter().chain(["--json"]).collect();
        called(name, folder, parts, &words)
    };
    for (left, stays) in [(pair[0], pair[1]), (pair[1], pair[0])] {
        // what wrote its file was used
        if left.given.file.is_some() || stays.text != both {
            continue;
        }
        let json = || stays.json.get_or_init(|| in_json(&[stays.given]));
        if parts.iter().any(|g| g.id == "json") || *json() == in_json(&parts) {
            return Some(format!("{ids}: {} is dropped", left.given.id));
        }
    }
    None
}

/// Beyond so many pairs one of so many is tried, unless GYROSPEC_LONG is set.
const MANY: usize = 150;
const EACH: usize = 8;

/// Goes through all pairs of a subcommand's arguments beside other words.
fn each_pair(name: &str, list: &[(&str, &str)], before: &[&str]) {
    each_pair_with(&|_| true, name, list, before);
}

/// Goes through the pairs of which one is wanted.
fn each_pair_with(is_wanted: &dyn Fn(&str) -> bool, name: &str, list: &[(&str, &str)], before: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let put = |file: &str, text: &str| std::fs::write(folder.path().join(file), text).unwrap();
    put("compass.toml", "[parameters]\nT = { value = 0.6, unit = \"s\" }\nP = 90.0\n");
    put("gimbal.toml", "[parameters]\nomega0 = 120.0\n");
    put(
        "trials.csv",
        "heading [deg],amplitude [deg],period [s],error [deg]\n45,5,5,-0.5\n45,5,7,-0.2\n60,5,9,-0.06\n",
    );
    let roll =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/roll.csv")).unwrap();
    // a second channel of roll, so that a name makes a difference
    let rows = roll.lines().take(1500).enumerate().map(|(k, row)| match row.rsplit_once(',') {
        Some((_, x)) if k > 0 => format!("{row},{}\n", 0.5 * x.parse::<f64>().unwrap_or(0.0)),
        _ => format!("{row},starboard [deg]\n"),
    });
    put("roll.csv", &rows.collect::<String>());
    let all = arguments(name, list);
    let alone = |given| {
        let text = called(name, folder.path(), &[given], &beside(&[given], before));
        Alone { given, text, json: OnceLock::new() }
    };
    let alone: Vec<Alone> = all.par_iter().map(alone).collect();
    let wanted: Vec<bool> = all.iter().map(|g| is_wanted(&g.id)).collect();
    let pairs = (0..all.len()).flat_map(|i| (i + 1..all.len()).map(move |j| (i, j)));
    let pairs: Vec<(usize, usize)> = pairs.filter(|(i, j)| wanted[*i] || wanted[*j]).collect();
    let is_long = pairs.len() > MANY && std::env::var_os("GYROSPEC_LONG").is_none();
    let pairs: Vec<(usize, usize)> = pairs.into_iter().step_by(if is_long { EACH } else { 1 }).collect();
    let check = |&(i, j): &(usize, usize)| dropped(name, folder.path(), [&alone[i], &alone[j]], before);
    let wrong: Vec<String> = pairs.par_iter().filter_map(check).collect();
    assert!(wrong.is_empty(), "{name} {before:?}, {} of {}:\n{}", wrong.len(), pairs.len(), wrong.join("\n"));
}

/// Values that no argument has by default.
const ROLL_ERROR: [(&str, &str); 39] = [
    ("model_or_parameters", "compass.toml"),
    ("recording", "compass.toml roll.csv"),
    ("roll", "--roll starboard"),
    ("inertia", "--inertia"),
    ("flow", "--flow 4s,0.2"),
    ("slosh", "--slosh 6,0.1,1e-5"),
    ("swing", "--swing 20s,0.2,0.8,1s"),
    ("meridian", "--meridian 2e5N/m,1s"),
    ("vertical", "--vertical 1e4N/m,0.5s"),
    ("friction", "--friction 0.5N"),
    ("free-play", "--free-play 1um"),
    ("latitude", "--latitude 55"),
    ("lever", "--lever 4m"),
    ("speed", "--speed 12kn"),
    ("irregular", "--irregular 4deg,0.06,0.65"),
    ("regular", "--regular 5deg,0.7"),
    ("sea", "--sea jonswap"),
    ("height", "--height 2m"),
    ("period", "--period 7s"),
    ("gamma", "--gamma 2"),
    ("sea_from", "--sea-from 60"),
    ("ship", "--ship 10s,0.1,0.8,12m"),
    ("ship_length", "--ship-length 70m"),
    ("spread", "--spread 4"),
    ("roll_damping", "--roll-damping 0.3,0.1"),
    ("also", "--also heave"),
    ("band", "--band 2.5"),
    ("against", "--against latitude"),
    ("headings", "--heading 30"),
    ("simulate", "--simulate 2"),
    ("seed", "--seed 7"),
    ("free", "--free"),
    ("scorsby", "--scorsby"),
    ("formula", "--formula"),
    ("list", "--list"),
    ("card", "--card"),
    ("csv", "--csv %"),
    ("spectrum", "--spectrum"),
    ("svg", "--svg %"),
];

fn roll_error() -> Vec<(&'static str, &'static str)> {
    ROLL_ERROR.iter().copied().chain([("html", "--html %"), ("json", "--json")]).collect()
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn each_pair_of_options_of_the_rolling_error_is_used_or_refused() {
    each_pair("roll-error", &roll_error(), &["--heading", "45"]);
}

/// What is asked of the sea and of the ship in it.
const OF_A_SEA: [&str; 11] = [
    "speed",
    "sea",
    "height",
    "period",
    "gamma",
    "sea_from",
    "ship",
    "ship_length",
    "spread",
    "roll_damping",
    "also",
];

/// Pairs without an option of the sea, and what is followed in time, are tried on irregular roll.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn the_same_in_a_sea() {
    let cheap = |id, words| match id {
        "simulate" => "--seed 7",
        "friction" | "free-play" => "--flow 3s,0.1",
        "card" => "--card 3m",
        _ => words,
    };
    let list: Vec<_> = roll_error().into_iter().map(|(id, words)| (id, cheap(id, words))).collect();
    let is_of_a_sea = |id: &str| OF_A_SEA.contains(&id);
    each_pair_with(&is_of_a_sea, "roll-error", &list, &["--heading", "45", "--sea", "jonswap"]);
}

#[test]
fn each_pair_of_options_of_the_gimbal_is_used_or_refused() {
    each_pair("gimbal", &[("parameters", "gimbal.toml"), ("corner", "--corner 3"), ("json", "--json")], &[]);
}

const STRAPDOWN: [(&str, &str); 16] = [
    ("angular", "--angular z=0.05mrad,40,50Hz,0.1"),
    ("linear", "--linear x=2m/s^2,10,40Hz,0.1"),
    ("resonance", "--resonance 35Hz,0.2"),
    ("coherence", "--coherence 0.5"),
    ("anisoinertia", "--anisoinertia xy,1g*cm^2,2e-3"),
    ("anisoelasticity", "--anisoelasticity xy,0.1,2e-3,900Hz,1200Hz,0.1"),
    ("square", "--square 1e-6"),
    ("tuned_rotor", "--tuned-rotor z,6000rpm,60g*cm^2,1g*cm^2,1arcsec"),
    ("latitude", "--latitude 55"),
    ("heading", "--heading 30"),
    ("walk", "--walk 0.01deg/h^0.5"),
    ("seeking", "--loop 10min,0.7"),
    ("align", "--align 300s"),
    ("irregular", "--irregular 4deg,0.06,0.65"),
    ("lever", "--lever 3m"),
    ("json", "--json"),
];

#[test]
fn each_pair_of_options_of_a_strapdown_system_is_used_or_refused() {
    let cone = ["--angular", "x=0.1mrad,0,30Hz,0.1", "--angular", "y=0.1mrad,-90,30Hz,0.1"];
    each_pair("strapdown", &STRAPDOWN, &cone);
    // what needs a place or a walk, beside both
    let place = ["--latitude", "60", "--heading", "20", "--walk", "1e-6", "--align", "100s"];
    each_pair("strapdown", &STRAPDOWN, &[&cone[..], &place].concat());
    let sea = ["--loop", "20min,0.6", "--irregular", "3deg,0.1,0.7", "--lever", "2m"];
    each_pair("strapdown", &STRAPDOWN, &[&place[..], &sea].concat());
}

#[test]
fn each_pair_of_options_of_the_identification_is_used_or_refused() {
    let list = [
        ("trials", "trials.csv"),
        ("compass", "--compass compass.toml"),
        ("latitude", "--latitude 50"),
        ("lever", "--lever 2m"),
        ("html", "--html %"),
        ("json", "--json"),
    ];
    // the table stands before each pair, and what its angles turn about, so that naming these again is refused
    each_pair("identify", &list, &["trials.csv", "--lever", "3m"]);
    each_pair("identify", &list, &["trials.csv", "--compass", "compass.toml"]);
}

const PENDULOUS: [(&str, &str); 12] = [
    ("latitude", "--latitude 55"),
    ("speed", "--speed 12kn"),
    ("headings", "--heading 40"),
    ("corrector", "--corrector 48,10kn"),
    ("manoeuvres", "--manoeuvres 6kn,10min"),
    ("momentum", "--momentum 20"),
    ("offset", "--offset 2deg"),
    ("flow", "--flow 90s"),
    ("ballistic", "--ballistic 0.5"),
    ("tuned_at", "--tuned-at 45"),
    ("html", "--html %"),
    ("json", "--json"),
];

#[test]
fn each_pair_of_options_of_a_compass_with_a_ballistic_is_used_or_refused() {
    each_pair("pendulous", &PENDULOUS, &["--latitude", "50"]);
    // where headings differ
    let list: Vec<_> = PENDULOUS.into_iter().map(|(id, words)| (id, words.replace("12kn", "9kn"))).collect();
    let list: Vec<_> = list.iter().map(|(id, words)| (*id, words.as_str())).collect();
    each_pair("pendulous", &list, &["--latitude", "50", "--speed", "10kn"]);
}

/// Exit code and both outputs of a command of roll-error on a model file.
fn on_model(text: &str) -> (i32, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("model.toml");
    std::fs::write(&file, text).unwrap();
    let out = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .arg("roll-error")
        .arg(&file)
        .args(["--heading", "45"])
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&out.stdout) + String::from_utf8_lossy(&out.stderr);
    (out.status.code().unwrap(), said.into_owned())
}

#[test]
fn a_model_with_equations_of_its_own_is_refused_and_one_that_only_looks_so_is_not() {
    let changed = "extends = \"gyrosphere\"\n[definitions]\nW1 = { equals = \"-2*h*roll_acc*cos(heading)\", unit = \"cm/s^2\" }\n";
    let (code, said) = on_model(changed);
    assert!(code == 2 && said.contains("equations of its own") && said.contains("W1"), "{said}");
    // the same, written another way
    let same = changed.replace("-2*h*roll_acc*cos(heading)", "-cos(heading)*roll_acc*h");
    assert_eq!(on_model(&same).0, 0);
    // whole models: each built-in as it prints, and with one sign turned
    for name in ["gyrosphere", "gyrosphere-inertia", "gyrosphere-flow", "gyrosphere-under-way"] {
        let whole = gyrospec::model::Model::builtin(name).unwrap().to_toml();
        let (code, said) = on_model(&whole);
        assert_eq!(code, 0, "{name}: {said}");
        let turned = whole.replacen("-F*beta", "F*beta", 1);
        assert_ne!(turned, whole);
        let (code, said) = on_model(&turned);
        assert!(code == 2 && said.contains("lambda"), "{name}: {said}");
    }
    let output =
        "extends = \"gyrosphere\"\n[outputs]\nalpha = { equals = \"azimuth + 0.01\", unit = \"deg\" }\n";
    let (code, said) = on_model(output);
    assert!(code == 2 && said.contains("alpha"), "{said}");
}
