//! The page of a diagnosis: every section has its content, the file is small, asks nothing from
//! outside, and a real browser opens it.

use gyrospec::diagnose::answer::{
    Answer, Band, DataFault, Detection, Finding, InputFile, Located, Made, ParameterChange, Proof, SCHEMA,
    SignalChance, SiteName, Spell, Stretch, Unexplained, Value, Verdict, Visible,
};
use gyrospec::diagnose::pictures::{Clock, Close, Course, Faulty, Law, Pictures, Spectrum, Standing, Tried};
use gyrospec::estimate::{Correlation, Direction, Lags};
use gyrospec::report::diagnosis::page;
use std::path::Path;
use std::process::Command;

const VERDICTS: [Verdict; 6] = [
    Verdict::Named,
    Verdict::NothingMissing,
    Verdict::Tie,
    Verdict::Unknown,
    Verdict::DataFault,
    Verdict::NotIdentifiable,
];

fn site() -> SiteName {
    SiteName { kind: "state".into(), name: "v".into() }
}

fn finding(verdict: Verdict) -> Option<Finding> {
    let (code, ties) = match verdict {
        Verdict::Named => ("dry-friction", vec![]),
        Verdict::Tie => ("dry-friction", vec!["stribeck-friction".to_string()]),
        Verdict::DataFault => ("frozen-channel", vec![]),
        _ => return None,
    };
    Some(Finding {
        code: code.into(),
        site: site(),
        term: "-Fc*sign(v)/M".into(),
        says: "20 N act against v < 0 & v > 0".into(),
        parameters: vec![Value { name: "Fc".into(), value: 20.0, low: 19.0, high: 21.0, unit: "N".into() }],
        p_value: 1e-30,
        share: 1.0,
        ties,
        resembles: false,
        evidence: None,
    })
}

fn faults(verdict: Verdict) -> Vec<DataFault> {
    let fault = finding(verdict).filter(Finding::is_fault);
    fault.map(|finding| DataFault { finding, masked: true }).into_iter().collect()
}

fn answer(verdict: Verdict) -> Answer {
    Answer {
        schema: SCHEMA,
        verdict,
        says: "The <model> leaves out \"something\" & more.".into(),
        detection: Detection {
            p_value: 0.3,
            smallest_visible: vec![Visible {
                code: "dry-friction".into(),
                site: site(),
                parameter: "Fc".into(),
                value: 0.1,
                unit: "N".into(),
            }],
        },
        located: Located {
            sites: vec![site()],
            time: vec![Spell { from: 10.0, to: 12.0, recording: None }],
            bands: vec![Band { from: 1.0, to: 3.0, share: 0.7 }],
            signals: vec![SignalChance { name: "v".into(), p_value: 1e-9 }],
            separating_measurement: None,
        },
        findings: finding(verdict).into_iter().collect(),
        faults: faults(verdict),
        unexplained: (verdict == Verdict::Unknown).then(|| Unexplained {
            p_value: 1e-5,
            signal: "v".into(),
            shape: vec![[-1.0, -2.0, -2.5, -1.5], [1.0, 2.0, 1.5, 2.5]],
        }),
        proof: vec![Proof {
            output: "position".into(),
            unit: "m".into(),
            metric: "rmse",
            mode: "free-run",
            fit_before: 0.2,
            fit_after: 0.1,
            holdout_before: 0.25,
            holdout_after: f64::NAN,
            improvement_low: 0.1,
            improvement_high: 0.2,
            noise_floor: 0.05,
        }],
        next_experiment: Some("Repeat it at a third of the amplitude.".into()),
        parameters: vec![ParameterChange {
            name: "M".into(),
            before: 90.0,
            after: 95.0,
            low: 94.0,
            high: 96.0,
            unit: "kg".into(),
        }],
        notes: Vec::new(),
        made: Made {
            program: "gyrospec 0".into(),
            seed: 7,
            ended_early: None,
            inputs: vec![InputFile { file: "rec.csv".into(), sha256: "ab12".into() }],
        },
    }
}

fn left(size: f64) -> Correlation {
    let lags = Lags { first: -2, values: vec![0.0, size, 0.0, -size, 0.0], band: vec![0.2; 5] };
    Correlation { output: "position".into(), input: Some("force".into()), step: Some(0.05), lags }
}

/// Series as long as the pictures ever have.
fn pictures(verdict: Verdict) -> Pictures {
    let wave = |size: f64| -> Vec<[f64; 2]> {
        (0..1200).map(|i| [f64::from(i) * 0.05, size * (f64::from(i) * 0.1).sin()]).collect()
    };
    let course = |output: &str| Course {
        output: output.into(),
        unit: "m".into(),
        difference_unit: "m".into(),
        recording: "trial <7>".into(),
        held: vec![Stretch { from: 40.0, to: 60.0 }],
        percent_before: [80.0, 79.0],
        percent_after: [99.0, f64::NAN],
        measured: wave(1.0),
        before: wave(0.8),
        after: wave(0.99),
        residual_before: wave(0.2),
        residual_after: wave(0.01),
        close: Some(Close { measured: wave(1.0), before: wave(0.8), after: wave(0.99) }),
    };
    let law = Law {
        code: "dry-friction".into(),
        term: "-Fc*sign(v)/M".into(),
        formula: "-Fc*sign(v)".into(),
        signal: "v".into(),
        signal_unit: "m/s".into(),
        effect: "what is missing at v".into(),
        effect_unit: "N".into(),
        samples: wave(20.0),
        means: vec![[-1.0, 20.0, 19.0, 21.0], [1.0, -20.0, -21.0, -19.0]],
        curve: vec![[-1.0, 20.0, 19.0, 21.0], [1.0, -20.0, -21.0, -19.0]],
    };
    let has_law = matches!(verdict, Verdict::Named | Verdict::Tie);
    let power = |x: f64| (1..200).map(|i| [f64::from(i) * 0.1, x / f64::from(i)]).collect();
    Pictures {
        trials: false,
        clock: Clock::default(),
        courses: (0..8).map(|i| course(&format!("position{i}"))).collect(),
        spectra: vec![Spectrum {
            output: "position".into(),
            bands: vec![Band { from: 1.0, to: 3.0, share: 0.7 }],
            before: power(1.0),
            after: power(0.1),
        }],
        left_before: vec![left(0.5)],
        left_after: vec![left(0.1)],
        laws: has_law.then_some(law).into_iter().collect(),
        tried: vec![Tried {
            code: "dry-friction".into(),
            site: site(),
            score: 80.0,
            standing: Standing::Found,
        }],
        faults: (verdict == Verdict::DataFault)
            .then(|| Faulty {
                code: "frozen-channel".into(),
                channel: "position".into(),
                unit: "m".into(),
                recorded: wave(1.0),
                spans: vec![Stretch { from: 5.0, to: 6.0 }],
            })
            .into_iter()
            .collect(),
    }
}

fn made(verdict: Verdict) -> String {
    page("axis <1>", &answer(verdict), &pictures(verdict), &[])
}

/// The sections of a page and what stands in each.
fn sections(page: &str) -> Vec<(String, String)> {
    let parts = page.split("<section id=\"").skip(1);
    parts
        .map(|p| {
            let (name, rest) = p.split_once('"').unwrap();
            (name.to_string(), rest.split("</section>").next().unwrap().to_string())
        })
        .collect()
}

fn expected(verdict: Verdict) -> Vec<&'static str> {
    let mut names = vec![
        "findings",
        "courses",
        "residuals",
        "spectra",
        "correlations",
        "proof",
        "sites",
        "parameters",
        "next",
        "made",
    ];
    match verdict {
        Verdict::Named | Verdict::Tie => names.push("laws"),
        Verdict::NothingMissing => names.push("visible"),
        Verdict::Unknown => names.push("unexplained"),
        Verdict::DataFault => names.push("faults"),
        Verdict::NotIdentifiable => {}
    }
    names
}

#[test]
fn every_section_has_its_content() {
    for verdict in VERDICTS {
        let page = made(verdict);
        let sections = sections(&page);
        for name in expected(verdict) {
            let content =
                &sections.iter().find(|s| s.0 == name).unwrap_or_else(|| panic!("{verdict:?}: {name}")).1;
            let drawn = ["courses", "residuals", "spectra", "laws", "unexplained", "faults"].contains(&name);
            let wanted = if drawn { "<svg viewBox" } else { "</" };
            assert!(content.contains(wanted), "{verdict:?}: {name} is empty");
        }
        assert_eq!(sections.len(), expected(verdict).len(), "{verdict:?}");
        assert_eq!(page.matches("class=\"held\"").count() % 2, 0);
        assert!(page.contains("class=\"held\"") && page.contains("class=\"shade\""));
        assert!(!page.contains("NaN"), "{verdict:?}");
    }
}

#[test]
fn a_page_is_small_and_asks_nothing_from_outside() {
    for verdict in VERDICTS {
        let page = made(verdict);
        assert!(page.len() < 3_000_000, "{} bytes", page.len());
        for foreign in ["http:", "https:", "<script ", "src=", "@import", "url("] {
            assert!(!page.contains(foreign), "{verdict:?}: {foreign}");
        }
        assert!(page.contains("axis &lt;1&gt;") && page.contains("&lt;model&gt;"));
        assert!(!page.contains("<model>") && !page.contains("<7>"));
    }
}

/// A minute's wave: 0 to 60 s are 0 to 1 min.
#[test]
fn a_page_counts_time_as_the_recording_does() {
    let verdict = Verdict::DataFault;
    let drawn = |clock: Clock| {
        let page = page("axis", &answer(verdict), &Pictures { clock, ..pictures(verdict) }, &[]);
        sections(&page)
    };
    let (seconds, minutes) = (Clock::default(), Clock { unit: "min".into(), seconds: 60.0 });
    let [seconds, minutes] = [seconds, minutes].map(drawn);
    for name in ["courses", "residuals", "faults"] {
        let of = |all: &[(String, String)]| all.iter().find(|s| s.0 == name).unwrap().1.clone();
        let has = |text: &str, word: &str| text.contains(&format!(">{word}</text>"));
        let (s, min) = (of(&seconds), of(&minutes));
        assert!(has(&s, "time, s") && has(&s, "20") && !has(&s, "0.6"), "{name}");
        assert!(has(&min, "time, min") && has(&min, "0.6") && !has(&min, "20"), "{name}");
    }
}

#[test]
fn the_verdict_is_one_sentence() {
    let heading = |v: Verdict| {
        let page = made(v);
        let from = page.find("<h1").unwrap();
        page[from..page.find("</h1>").unwrap()].split_once('>').unwrap().1.to_string()
    };
    assert_eq!(heading(Verdict::Named), "The model leaves out dry (Coulomb) friction (state v).");
    assert!(heading(Verdict::Tie).contains("would fit as well"));
    assert_eq!(heading(Verdict::NothingMissing), "Nothing is missing.");
    assert_eq!(heading(Verdict::DataFault), "The data are at fault: a channel that is stuck (state v).");
    assert!(VERDICTS.iter().all(|v| heading(*v).ends_with('.')));
}

fn browser() -> Option<String> {
    let names = ["chromium", "chromium-browser", "google-chrome"];
    let runs = |n: &&&str| Command::new(n).arg("--version").output().is_ok_and(|o| o.status.success());
    names.iter().find(runs).map(|n| (*n).to_string())
}

/// The page as the browser has it after loading, and what the browser logged.
fn opened(browser: &str, file: &Path, profile: &Path) -> (String, String) {
    let flags = [
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--enable-logging=stderr",
        "--dump-dom",
    ];
    let run = Command::new(browser)
        .args(flags)
        .arg(format!("--user-data-dir={}", profile.display()))
        .arg(format!("file://{}", file.display()))
        .output()
        .unwrap();
    (String::from_utf8_lossy(&run.stdout).into(), String::from_utf8_lossy(&run.stderr).into())
}

#[test]
fn a_browser_opens_the_page() {
    let Some(browser) = browser() else {
        crate::skipped::skipped(format_args!(
            "no Chromium on this machine, pages were not opened in a browser"
        ));
        return;
    };
    let verdicts =
        [Verdict::Named, Verdict::NothingMissing, Verdict::Tie, Verdict::Unknown, Verdict::DataFault];
    for verdict in verdicts {
        opens(&browser, &format!("{verdict:?}"), &made(verdict));
    }
    let mut long = pictures(Verdict::Named);
    long.laws[0].formula = format!("curve((v - v_mean)/v_spread{})", ", -1.23, f1".repeat(30));
    opens(&browser, "long formula", &page("axis", &answer(Verdict::Named), &long, &[]));
    long.laws[0].formula = "x".repeat(400);
    opens(&browser, "long name", &page("axis", &answer(Verdict::Named), &long, &[]));
    opens(&browser, "roll-error", &page_of(&["roll-error", "examples/roll.csv"]));
    opens(&browser, "fit", &page_of(&["fit", "examples/clinometer.toml", "examples/clinometer.csv"]));
}

/// Opens a page and looks for script errors, requests, flat pictures, overflow and every section.
fn opens(browser: &str, name: &str, page: &str) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("page.html");
    // A witness that only this test adds: it writes into the page what went wrong while loading.
    let witness = "<script>window.onerror=m=>document.title='WRONG '+m;addEventListener('load',()=>{\
        const asked=performance.getEntriesByType('resource').length;\
        const flat=[...document.querySelectorAll('figure>svg')].filter(s=>s.getBoundingClientRect().height<60).length;\
        document.body.dataset.seen=`asked ${asked} flat ${flat} wide ${document.documentElement.scrollWidth>innerWidth}`})</script>";
    std::fs::write(&file, page.replace("<head>", &format!("<head>{witness}"))).unwrap();
    let (dom, log) = opened(browser, &file, &folder.path().join("profile"));
    assert!(dom.contains("data-seen=\"asked 0 flat 0 wide false\""), "{name}: {log}\n{dom:.2000}");
    assert!(!dom.contains("<title>WRONG") && !log.contains("CONSOLE"), "{name}: {log}");
    for (section, _) in sections(page) {
        assert!(dom.contains(&format!("<section id=\"{section}\"")), "{name}: {section}");
    }
}

/// The program's own page of `command`, made from the project's examples.
fn page_of(command: &[&str]) -> String {
    let run = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(command)
        .args(["--html", "-"])
        .output()
        .unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    String::from_utf8(run.stdout).unwrap()
}

#[test]
fn a_page_of_the_rolling_error_has_its_sections() {
    let page = page_of(&["roll-error", "examples/roll.csv"]);
    let sections = sections(&page);
    let names: Vec<&str> = sections.iter().map(|s| s.0.as_str()).collect();
    assert_eq!(names, ["card", "roll", "table", "trust", "formula", "made"]);
    // the card, and roll, correlation and spectrum of the recording
    assert_eq!(sections[0].1.matches("<path class=\"mean\"").count(), 1);
    assert_eq!(sections[1].1.matches("<figure>").count(), 3);
    assert!(page.len() < 300_000 && !page.contains("NaN") && !page.contains("http"));
    // the verdict follows the mean that the page says to trust
    let by_spectrum = sections[3].1.contains("trust the last column");
    let verdict = page.split("</h1>").next().unwrap();
    assert!(verdict.contains(if by_spectrum { "(by its measured spectrum)" } else { "(by its fit)" }));
    let by_latitude = page_of(&["roll-error", "--against", "latitude"]);
    assert!(by_latitude.contains("<polygon class=\"band\"") && by_latitude.contains("latitude, °"));
}

#[test]
fn a_page_of_a_fit_has_its_sections() {
    let page = page_of(&["fit", "examples/clinometer.toml", "examples/clinometer.csv"]);
    let sections = sections(&page);
    let names: Vec<&str> = sections.iter().map(|s| s.0.as_str()).collect();
    assert_eq!(names, ["courses", "residuals", "spectra", "correlations", "parameters", "errors", "made"]);
    // the whole recording, and a closer look; the held-out part is marked in the whole
    assert_eq!(sections[0].1.matches("<figure>").count(), 2);
    assert!(
        sections[0].1.contains("<rect class=\"held\" x=") && page.len() < 300_000 && !page.contains("NaN")
    );
}

#[test]
fn faults_and_physics_are_two_sentences_and_each_page_says_what_would_confirm_it() {
    let mut a = answer(Verdict::DataFault);
    a.findings.extend(finding(Verdict::Named));
    a.next_experiment = None;
    let shown = |a: &Answer| page("axis", a, &pictures(a.verdict), &[]);
    let text = shown(&a);
    let heading = "The data are at fault: a channel that is stuck (state v). The model also leaves out dry (Coulomb) friction (state v).";
    assert!(text.contains(heading), "{text:.3000}");
    assert!(text.contains("Record v again without the fault"));
    let mut a = answer(Verdict::Named);
    a.next_experiment = None;
    assert!(shown(&a).contains("would confirm it"));
    a.faults = faults(Verdict::DataFault);
    let text = shown(&a);
    let heading = "The model leaves out dry (Coulomb) friction (state v). The data have faults too: a channel that is stuck (state v).";
    assert!(text.contains(heading), "{text:.3000}");
    assert!(text.contains("<b>frozen-channel</b>") && text.contains("kept from the fit"));
    a.faults.clear();
    let slight = Value { name: "c".into(), value: 0.1, low: -1.0, high: 1.0, unit: "N".into() };
    a.findings.push(Finding {
        code: "linear-damping".into(),
        share: 0.001,
        parameters: vec![slight],
        ..a.findings[0].clone()
    });
    assert!(shown(&a).contains("The model leaves out dry (Coulomb) friction (state v)."));
    let dark = Direction { weights: vec![("M".into(), 0.9), ("k".into(), 0.4)], deviation: 9.0 };
    let text = page("axis", &a, &pictures(a.verdict), &[dark]);
    assert!(text.contains("M and k apart: changes in them cancel in what is measured."));
}

#[test]
fn sentences_lose_needless_zeros() {
    let mut a = answer(Verdict::DataFault);
    a.says = "needle is stuck at 5.125000 deg from 25.000000 s to 249.250000 s in 3.0.10".into();
    let page = page("axis", &a, &pictures(Verdict::DataFault), &[]);
    assert!(page.contains("needle is stuck at 5.125 deg from 25 s to 249.25 s in 3.0.10"), "{page:.3000}");
}
