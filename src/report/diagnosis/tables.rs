//! The tables of the page.

use super::text::{self, chance};
use crate::diagnose::answer::{Answer, DataFault, Verdict};
use crate::diagnose::pictures::{Pictures, Standing};
use crate::report::page::{estimates, head, quantity, table};
use crate::report::svg::escaped;
use crate::units::{figure, without_needless_zeros};
use std::fmt::Write;

/// What was found, or that nothing was.
pub fn findings(a: &Answer) -> String {
    let rows: Vec<Vec<String>> = a
        .findings
        .iter()
        .filter(|f| !f.is_fault())
        .map(|f| {
            let values: Vec<String> = text::values(f).iter().map(|v| escaped(v)).collect();
            let ties = if f.resembles {
                "<br><span class=\"note\">only resembles it, and is not in the model</span>".to_owned()
            } else if f.ties.is_empty() {
                String::new()
            } else {
                format!("<br><span class=\"note\">fits as well: {}</span>", escaped(&f.ties.join(", ")))
            };
            vec![
                format!(
                    "<b>{}</b><br>{}<br><code>{}</code>{ties}",
                    escaped(&f.code),
                    escaped(&without_needless_zeros(&f.says)),
                    escaped(&f.term)
                ),
                escaped(&format!("{} {}", f.site.kind, f.site.name)),
                values.join("<br>"),
                escaped(&text::share(f)),
                chance(f.p_value),
            ]
        })
        .collect();
    if rows.is_empty() {
        let says = match a.verdict {
            Verdict::NothingMissing => {
                "No mechanism of the catalogue: what the model leaves over looks like noise."
            }
            Verdict::DataFault => "No mechanism of the catalogue beside the faults of the data.",
            _ => "No mechanism of the catalogue fits.",
        };
        return format!("<p>{says} The chance that all of it is noise: {}.</p>", chance(a.detection.p_value));
    }
    table(&["mechanism", "where", "values with 95 % intervals", "#share", "#chance of noise"], &rows)
}

/// What is wrong with the data, and whether it was kept from the fit.
pub fn faults(a: &Answer) -> String {
    let row = |fault: &DataFault| {
        let DataFault { finding: f, masked } = fault;
        let kept = if fault.is_reading() {
            "no fault: read so"
        } else if *masked {
            "yes"
        } else {
            "no"
        };
        let values: Vec<String> = text::values(f).iter().map(|v| escaped(v)).collect();
        let says = escaped(&without_needless_zeros(&f.says));
        vec![
            format!("<b>{}</b><br>{says}", escaped(&f.code)),
            escaped(&format!("{} {}", f.site.kind, f.site.name)),
            values.join("<br>"),
            kept.into(),
        ]
    };
    let rows: Vec<Vec<String>> = a.faults.iter().map(row).collect();
    table(&["fault", "where", "values", "kept from the fit"], &rows)
}

/// Before and after, on what was fitted and on what was held out.
pub fn proof(a: &Answer) -> String {
    let rows: Vec<Vec<String>> = a
        .proof
        .iter()
        .map(|p| {
            vec![
                head(&p.output, &p.unit),
                figure(p.fit_before),
                figure(p.fit_after),
                format!("<b>{}</b>", figure(p.holdout_before)),
                format!("<b>{}</b>", figure(p.holdout_after)),
                text::fall(p),
                figure(p.noise_floor),
            ]
        })
        .collect();
    let heads = [
        "output",
        "#fitted, before",
        "#fitted, after",
        "#held out, before",
        "#held out, after",
        "#fall, 95 %",
        "#noise floor",
    ];
    let table = table(&heads, &rows);
    if table.is_empty() {
        return table;
    }
    format!(
        "<p class=\"note\">Free-run error, root mean square. What was held out served nothing but this table.</p>{table}"
    )
}

/// What was tried where, and how it scored.
pub fn tried(p: &Pictures, a: &Answer) -> String {
    let top = p.tried.iter().map(|t| t.score).filter(|s| s.is_finite()).fold(0.0, f64::max);
    let rows: Vec<Vec<String>> = p
        .tried
        .iter()
        .map(|t| {
            let (class, word) = match t.standing {
                Standing::Found => ("", "found"),
                Standing::Tie => ("", "fits as well"),
                Standing::Dropped => (" dropped", ""),
            };
            let width = if top > 0.0 { (10.0 * t.score / top).clamp(0.0, 10.0) } else { 0.0 };
            vec![
                escaped(&t.code),
                escaped(&format!("{} {}", t.site.kind, t.site.name)),
                format!("{:.1}", t.score),
                format!("<span class=\"meter{class}\" style=\"width:{width:.2}rem\"></span>"),
                word.into(),
            ]
        })
        .collect();
    let mut out = table(&["mechanism", "site", "#score", "", ""], &rows);
    if !out.is_empty() {
        out = format!(
            "<p class=\"note\">The best of the first round. Score: how unlikely it is that noise alone looks like it (minus the natural logarithm of the chance). The best were then fitted inside the model, and compared where they were not fitted.</p>{out}"
        );
    }
    let signals: Vec<String> =
        a.located.signals.iter().map(|s| format!("{} ({})", escaped(&s.name), chance(s.p_value))).collect();
    if !signals.is_empty() {
        let _ = write!(out, "<p>The mismatch goes with (chance of none): {}.</p>", signals.join(", "));
    }
    if a.located.sites.len() > 1 {
        let sites: Vec<String> =
            a.located.sites.iter().map(|s| escaped(&format!("{} {}", s.kind, s.name))).collect();
        let _ = write!(out, "<p>Sites that come into question: {}.</p>", sites.join(", "));
    }
    out
}

/// The fitted parameters before and after.
pub fn parameters(a: &Answer) -> String {
    let rows: Vec<Vec<String>> = a
        .parameters
        .iter()
        .map(|p| {
            let ([before, after], interval) = estimates([p.before, p.after], p.low, p.high);
            vec![head(&p.name, &p.unit), before, after, interval]
        })
        .collect();
    table(&["parameter", "#before", "#after", "#95 % interval after"], &rows)
}

/// What each mechanism would have had to be to be seen.
pub fn visible(a: &Answer) -> String {
    if a.verdict != Verdict::NothingMissing {
        return String::new();
    }
    let rows: Vec<Vec<String>> = a
        .detection
        .smallest_visible
        .iter()
        .map(|v| {
            vec![
                escaped(&v.code),
                escaped(&format!("{} {}", v.site.kind, v.site.name)),
                escaped(&v.parameter),
                quantity(v.value, &v.unit),
            ]
        })
        .collect();
    let table = table(
        &["mechanism", "where", "parameter", "#smallest size that this recording would have shown"],
        &rows,
    );
    if table.is_empty() {
        table
    } else {
        format!("<p class=\"note\">Smaller effects may be there unseen.</p>{table}")
    }
}
