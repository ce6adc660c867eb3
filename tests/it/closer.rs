//! The page's one script, run by Node on a picture of the program, and the contrast of its lines.

use crate::skipped::skipped;
use gyrospec::report::page::{Page, Section};
use gyrospec::report::svg::{Layer, Picture};
use std::process::Command;

fn page(picture: &Picture) -> String {
    let sections = vec![Section::new("made", "A picture", picture.draw())];
    let none = String::new;
    Page { kind: none(), title: none(), verdict: none(), lead: none(), sections }.html()
}

/// The text between two marks.
fn between<'a>(text: &'a str, from: &str, to: &str) -> &'a str {
    let rest = text.split_once(from).unwrap_or_else(|| panic!("no {from}")).1;
    rest.split_once(to).unwrap_or_else(|| panic!("no {to}")).0
}

/// As much of a browser as the script asks for, and what to do in it; each line printed is the window and its ticks.
const BROWSER: &str = "
const act = {}, window = {}, ticks = { innerHTML: 'as drawn' };
const plot = { setAttribute: (name, value) => { window[name] = value; } };
const svg = {
  dataset: { x: X, y: Y, beside: BESIDE }, viewBox: { baseVal: { width: 720 } },
  querySelectorAll: () => [plot], querySelector: () => ticks,
  addEventListener: (name, f) => { act[name] = f; }, setAttribute() {}, focus() {}, setPointerCapture() {}, append() {},
  getBoundingClientRect: () => ({ left: 10, top: 20, width: 1440, height: 640 }),
};
const note = {};
globalThis.document = {
  querySelectorAll: () => [svg], getElementById: () => note,
  createElementNS: () => ({ setAttribute() {}, remove() {} }),
};
SCRIPT
const mouse = (x, y) => ({ button: 0, pointerType: 'mouse', pointerId: 1, preventDefault() {}, clientX: 10 + 2 * x, clientY: 20 + 2 * y });
const drag = (a, b) => { act.pointerdown(mouse(...a)); act.pointermove(mouse(...b)); act.pointerup(mouse(...b)); };
const key = k => act.keydown({ key: k, preventDefault() {} });
const texts = () => [...ticks.innerHTML.matchAll(/>([^<>]+)<.text>/g)].map(m => m[1]).join(' ') || ticks.innerHTML;
const say = () => console.log(`${window.viewBox} | ${texts()}`);
ACTS
";

/// What is printed after some acts on a picture; none without Node.
fn played(picture: &Picture, acts: &str) -> Option<String> {
    let page = page(picture);
    let data = |name: &str| format!("'{}'", between(&page, &format!("data-{name}=\""), "\""));
    let code = BROWSER
        .replace("X, y: Y", &format!("{}, y: {}", data("x"), data("y")))
        .replace("BESIDE", &data("beside"))
        .replace("SCRIPT", between(&page, "<script>", "</script>"))
        .replace("ACTS", acts);
    let Ok(run) = Command::new("node").args(["-e", &code]).output() else {
        skipped(format_args!("no Node: the script of the pages was not run"));
        return None;
    };
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    Some(String::from_utf8(run.stdout).unwrap())
}

#[test]
fn a_drag_looks_closer_and_a_double_click_goes_back() {
    // x from 0 to 10 between 78 and 706, y from −0.04 to 1.04 between 264 and 32
    let line = Layer::line("after", "line", vec![[0.0, 0.0], [10.0, 1.0]]);
    let picture = Picture::new("t", "x", "y").with(line);
    let acts = "drag([392, 100], [549, 105]); say(); key('ArrowRight'); say(); key('+'); say(); drag([300, 90], [303, 91]); say(); act.dblclick(); say(); drag([78, 148], [235, 264]); say(); key('0'); say();";
    let Some(said) = played(&picture, acts) else { return };
    let lines: Vec<&str> = said.lines().collect();
    // a flat drag over the third quarter: 5 to 7.5, all of y
    assert_eq!(lines[0], "392 32 157 232 | 0.0 0.5 1.0 5.0 5.5 6.0 6.5 7.0 7.5");
    assert!(lines[1].starts_with("431.25 32 157 232 | ") && lines[2].starts_with("470.5 32 78.5 232 | "));
    // too short a drag does nothing, and what was drawn comes back
    assert_eq!(lines[3], lines[2]);
    assert_eq!(lines[4], "78 32 628 232 | as drawn");
    // the lower half of the first quarter: y from −0.04 to 0.5
    assert_eq!(lines[5], "78 148 157 116 | 0.0 0.2 0.4 0.0 0.5 1.0 1.5 2.0 2.5");
    assert_eq!(lines[6], lines[4]);
}

#[test]
fn a_closer_look_at_frequencies_tells_hertz_too() {
    let line = Layer::line("after", "line", vec![[0.01, 0.1], [100.0, 10.0]]);
    let picture = Picture::new("t", "w", "y").logarithmic().beside(1.0 / std::f64::consts::TAU).with(line);
    // the middle half of four decades: 0.1 to 10 rad/s; then a tenth of a decade
    let acts = "drag([235, 100], [549, 105]); say(); drag([78, 100], [109.4, 105]); say();";
    let Some(said) = played(&picture, acts) else { return };
    let (wide, narrow) = said.trim_end().split_once('\n').unwrap();
    assert!(wide.ends_with("0.1 (0.0159) 1 (0.159) 10 (1.59)"), "{wide}");
    assert!(narrow.ends_with("0.10 (0.0159) 0.11 (0.0175) 0.12 (0.0191)"), "{narrow}");
}

#[test]
fn a_page_without_pictures_has_no_script() {
    assert!(!page(&Picture::new("", "", "")).contains("<script"));
    let with = page(&Picture::new("", "", "").with(Layer::line("after", "", vec![[0.0, 1.0], [1.0, 2.0]])));
    assert_eq!(with.matches("<script>").count(), 1);
}

/// Luminance as WCAG 2 defines it.
fn luminance(colour: &str) -> f64 {
    let digits: String = match colour.len() {
        4 => colour[1..].chars().flat_map(|c| [c, c]).collect(),
        _ => colour[1..7].to_owned(),
    };
    let part = |k: usize| {
        let c = f64::from(u8::from_str_radix(&digits[2 * k..2 * k + 2], 16).unwrap()) / 255.0;
        if c <= 0.03928 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
    };
    0.2126 * part(0) + 0.7152 * part(1) + 0.0722 * part(2)
}

#[test]
fn lines_keep_their_contrast_by_day_by_night_and_on_paper() {
    let page = page(&Picture::new("", "", "").with(Layer::line("after", "", vec![[0.0, 1.0], [1.0, 2.0]])));
    let style = between(&page, "<style>", "</style>");
    let palettes: Vec<&str> = style.split(":root{").skip(1).map(|p| p.split_once('}').unwrap().0).collect();
    assert_eq!(palettes.len(), 3);
    for palette in palettes {
        let colour = |name: &str| {
            let from =
                palette.split_once(&format!("--{name}:")).unwrap_or_else(|| panic!("{name}: {palette}")).1;
            luminance(from.split(';').next().unwrap())
        };
        let contrast = |a: f64, b: f64| (a.max(b) + 0.05) / (a.min(b) + 0.05);
        let back = colour("back");
        for (name, least) in
            [("top", 7.0), ("before", 3.0), ("after", 3.0), ("measured", 3.0), ("ink", 7.0), ("soft", 4.5)]
        {
            assert!(
                contrast(colour(name), back) >= least,
                "{name}: {} in {palette}",
                contrast(colour(name), back)
            );
        }
        // the measurement is told from both models below it, by brightness or by its width
        assert!(
            contrast(colour("top"), colour("after")) > 1.5 && contrast(colour("top"), colour("before")) > 1.5
        );
    }
    assert!(style.contains("polyline.measured{stroke:var(--top);stroke-width:1.1}"));
}
