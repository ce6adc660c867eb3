//! A diagnosis in the terminal.

use crate::diagnose::Diagnosis;
use crate::diagnose::answer::{Answer, DataFault, FREE_LAW, Finding, Proof, Value, Verdict, at_fault};
use crate::diagnose::catalogue;
use crate::report::fit::untold;
use crate::report::page::{estimate, estimates, interval};
use crate::units::{figure, without_needless_zeros};
use std::fmt::Write;

/// The verdict in one line.
pub fn headline(a: &Answer) -> String {
    let plain = match a.verdict {
        Verdict::NothingMissing => "NOTHING MISSING",
        Verdict::Named => "FOUND what the model leaves out",
        Verdict::Tie => "FOUND, but several names fit alike",
        Verdict::Unknown => "SOMETHING IS MISSING that no name of the catalogue fits",
        Verdict::DataFault => return at_fault(&a.faults).to_uppercase(),
        Verdict::NotIdentifiable => "THIS RECORDING CANNOT TELL",
    };
    plain.to_string()
}

/// The whole report as text: the verdict first.
pub fn text(d: &Diagnosis) -> String {
    let a = &d.answer;
    let mut out = format!("{}\n\n{}\n", headline(a), wrapped(&without_needless_zeros(&a.says)));
    findings(&mut out, a);
    faults(&mut out, a);
    proof(&mut out, a);
    parameters(&mut out, a);
    out += &untold(&d.after.unseen, &d.after.determined);
    located(&mut out, a);
    let hints = hints(a);
    if !hints.is_empty() {
        let _ = write!(out, "\nNext:\n{}\n", wrapped(&hints.join(" ")));
    }
    if a.verdict == Verdict::NothingMissing {
        visible(&mut out, a);
    }
    notes(&mut out, a);
    out
}

fn notes(out: &mut String, a: &Answer) {
    if !a.notes.is_empty() {
        out.push_str("\nTo know beside:\n");
    }
    for note in &a.notes {
        let _ = writeln!(out, "{}", wrapped(&without_needless_zeros(note)));
    }
}

fn findings(out: &mut String, a: &Answer) {
    if a.findings.iter().all(Finding::is_fault) {
        return;
    }
    let sure = !matches!(a.verdict, Verdict::Unknown | Verdict::NotIdentifiable);
    let is_law = a.findings.iter().any(|f| f.resembles || f.code == FREE_LAW);
    let head = if sure || is_law { "finding" } else { "it resembles" };
    let _ = writeln!(out, "\n  {:<22} {:<22} {:>6}   values with 95 % intervals", head, "where", "share");
    for f in a.findings.iter().filter(|f| !f.is_fault()) {
        let site = format!("{} {}", f.site.kind, f.site.name);
        let share = share(f);
        let _ = writeln!(out, "  {:<22} {site:<22} {share:>6}   {}", f.code, values(f).join(", "));
        let _ = writeln!(out, "      {}", f.term);
        if !a.says.contains(&f.says) {
            let _ = writeln!(out, "      {}", without_needless_zeros(&f.says));
        }
        if f.resembles {
            out.push_str("      only resembles it, and is not in the model\n");
        }
        if !f.ties.is_empty() {
            let _ = writeln!(out, "      fits as well: {}", f.ties.join(", "));
        }
    }
    out.push_str("  `gyrospec explain CODE` says more of each.\n");
}

/// What is wrong with the data, and whether it was kept from the fit; and how inputs were read, which is no fault.
fn faults(out: &mut String, a: &Answer) {
    let (readings, faults): (Vec<_>, Vec<_>) = a.faults.iter().partition(|f| f.is_reading());
    let site = |f: &Finding| format!("{} {}", f.site.kind, f.site.name);
    if !faults.is_empty() {
        let _ = writeln!(out, "\n  {:<22} {:<22} {:>6}   values", "fault of the data", "where", "masked");
    }
    for DataFault { finding: f, masked } in faults {
        let masked = if *masked { "yes" } else { "no" };
        let _ = writeln!(out, "  {:<22} {:<22} {masked:>6}   {}", f.code, site(f), values(f).join(", "));
        let _ = writeln!(out, "      {}", f.says);
    }
    if !readings.is_empty() {
        let _ = writeln!(out, "\n  {:<22} where", "how an input was read");
    }
    for DataFault { finding: f, .. } in readings {
        let _ = writeln!(out, "  {:<22} {}\n      {}", f.code, site(f), f.says);
    }
}

/// A unit behind a number; pure numbers have none.
fn behind(unit: &str) -> String {
    if unit == "1" { String::new() } else { format!(" {unit}") }
}

/// The share of the held-out improvement; none is told where it is none.
pub(super) fn share(f: &Finding) -> String {
    match f.share {
        s if s >= 0.01 => format!("{:.0} %", 100.0 * s),
        s if s > 0.0 => "< 1 %".into(),
        _ => "–".into(),
    }
}

/// The values of a finding with their intervals and units.
pub(super) fn values(f: &Finding) -> Vec<String> {
    let said = |p: &Value| {
        let (value, band) = estimate(p.value, p.low, p.high);
        let band = if band == "–" { String::new() } else { format!(" ({band})") };
        format!("{} = {value}{band}{}", p.name, behind(&p.unit))
    };
    f.parameters.iter().map(said).collect()
}

/// The fall of the held-out error; a dash where nothing was added that could lower it.
pub(super) fn fall(p: &Proof) -> String {
    let none = p.improvement_low == 0.0 && p.improvement_high == 0.0;
    if none { "–".into() } else { interval(p.improvement_low, p.improvement_high) }
}

/// What would tell more, each hint once.
pub(super) fn hints(a: &Answer) -> Vec<&str> {
    let mut said: Vec<&str> = Vec::new();
    for hint in a.next_experiment.iter().chain(&a.located.separating_measurement) {
        if !said.iter().any(|s| s.starts_with(hint.as_str())) {
            said.push(hint);
        }
    }
    said
}

fn proof(out: &mut String, a: &Answer) {
    out.push_str("\nFree-run error (root mean square):\n");
    let _ = writeln!(
        out,
        "  {:<16} {:>11} {:>11} {:>13} {:>13} {:>9}   fall, 95 % interval",
        "output", "fit before", "fit after", "held before", "held after", "noise"
    );
    for p in &a.proof {
        let _ = writeln!(
            out,
            "  {:<16} {:>11} {:>11} {:>13} {:>13} {:>9}   {}{}",
            p.output,
            figure(p.fit_before),
            figure(p.fit_after),
            figure(p.holdout_before),
            figure(p.holdout_after),
            if p.noise_floor.is_finite() { figure(p.noise_floor) } else { "–".into() },
            fall(p),
            behind(&p.unit)
        );
    }
}

fn parameters(out: &mut String, a: &Answer) {
    if a.parameters.is_empty() {
        return;
    }
    let _ = writeln!(out, "\n  {:<16} {:>12} {:>12}   95 % interval", "parameter", "before", "after");
    for p in &a.parameters {
        let ([before, after], band) = estimates([p.before, p.after], p.low, p.high);
        let _ = writeln!(out, "  {:<16} {before:>12} {after:>12}   {band}{}", p.name, behind(&p.unit));
    }
}

fn located(out: &mut String, a: &Answer) {
    if a.verdict == Verdict::NothingMissing {
        return;
    }
    let l = &a.located;
    if l.sites.len() > 1 {
        let sites: Vec<String> = l.sites.iter().map(|s| format!("{} {}", s.kind, s.name)).collect();
        let _ = writeln!(
            out,
            "\nThis recording cannot tell these sites apart, or several are at work: {}.",
            sites.join(", ")
        );
    }
    if let Some(u) = &a.unexplained {
        let _ = writeln!(out, "\nWhat is left goes with {} (chance {}).", u.signal, chance(u.p_value));
    }
}

fn visible(out: &mut String, a: &Answer) {
    if a.detection.smallest_visible.is_empty() {
        return;
    }
    out.push_str("\nThis recording would have shown:\n");
    for v in &a.detection.smallest_visible {
        let _ = writeln!(
            out,
            "  {:<22} {:<22} from {} = {}{}",
            v.code,
            format!("{} {}", v.site.kind, v.site.name),
            v.parameter,
            figure(v.value),
            behind(&v.unit)
        );
    }
}

/// Lines of at most 96 characters.
fn wrapped(text: &str) -> String {
    let mut out = String::new();
    let mut length = 0;
    for word in text.split_whitespace() {
        let size = word.chars().count();
        if length > 0 && length + 1 + size > 96 {
            out.push('\n');
            length = 0;
        } else if length > 0 {
            out.push(' ');
            length += 1;
        }
        out.push_str(word);
        length += size;
    }
    out
}

/// A chance as people read it.
pub(super) fn chance(p: f64) -> String {
    if !p.is_finite() {
        "–".into()
    } else if p < 1e-12 {
        "below 1e−12".into()
    } else if p < 1e-3 {
        format!("{p:.0e}").replace('-', "−")
    } else {
        format!("{p:.3}")
    }
}

/// The plain words of a code.
pub(super) fn title(code: &str) -> &str {
    catalogue::find(code).map_or(code, |m| m.title)
}
