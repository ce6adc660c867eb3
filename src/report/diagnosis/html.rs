//! A diagnosis as one page that opens offline.

use super::svg::{Line, picture};
use super::text::{figure, headline};
use crate::diagnose::Diagnosis;
use crate::diagnose::answer::Answer;
use std::fmt::Write;

const STYLE: &str = "<style>:root{color-scheme:light dark}body{font:16px/1.5 system-ui,sans-serif;max-width:48rem;margin:auto;padding:1rem}\
h1{font-size:1.4rem}table{border-collapse:collapse;width:100%}td,th{border-bottom:1px solid #8886;padding:.3rem .5rem;text-align:left;vertical-align:top}\
figure{margin:1rem 0}svg{width:100%;height:auto;font-size:12px;fill:currentColor}polyline{fill:none;stroke-width:1.4}\
.shade{fill:#8882}polyline.measured{stroke:#777}polyline.before{stroke:#d55e00}polyline.after{stroke:#0072b2;stroke-dasharray:6 2}\
polyline.bound{stroke:#0072b288}.legend span{margin-right:1rem;font-size:.85rem}span.before{color:#d55e00}span.after,span.bound{color:#0072b2}\
code{font-size:.9em;word-break:break-all}@media print{body{max-width:none}}</style>";

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The page.
pub fn html(d: &Diagnosis) -> String {
    let a = &d.answer;
    let title = escaped(headline(a.verdict));
    let mut page = format!(
        "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>{title}</title>{STYLE}</head><body><h1 id=\"verdict\">{title}</h1><p>{}</p>",
        escaped(&a.says)
    );
    findings(&mut page, a);
    pictures(&mut page, d);
    proof(&mut page, a);
    parameters(&mut page, a);
    shape(&mut page, a);
    if let Some(next) = &a.next_experiment {
        let _ = write!(page, "<h2 id=\"next\">What would tell next</h2><p>{}</p>", escaped(next));
    }
    made(&mut page, a);
    page + "</body></html>\n"
}

fn table(page: &mut String, heads: &[&str], rows: impl Iterator<Item = Vec<String>>) {
    page.push_str("<table><tr>");
    for h in heads {
        let _ = write!(page, "<th>{h}</th>");
    }
    page.push_str("</tr>");
    for row in rows {
        page.push_str("<tr>");
        for cell in row {
            let _ = write!(page, "<td>{cell}</td>");
        }
        page.push_str("</tr>");
    }
    page.push_str("</table>");
}

fn findings(page: &mut String, a: &Answer) {
    page.push_str("<h2 id=\"findings\">What was found</h2>");
    if a.findings.is_empty() {
        page.push_str("<p>No mechanism of the catalogue.</p>");
        return;
    }
    let rows = a.findings.iter().map(|f| {
        let values: Vec<String> = f
            .parameters
            .iter()
            .map(|p| {
                format!(
                    "{} = {} {} ({} to {})",
                    p.name,
                    figure(p.value),
                    p.unit,
                    figure(p.low),
                    figure(p.high)
                )
            })
            .collect();
        let ties = if f.ties.is_empty() {
            String::new()
        } else {
            format!("<br>fits as well: {}", f.ties.join(", "))
        };
        vec![
            format!("<b>{}</b><br>{}<br><code>{}</code>{ties}", f.code, escaped(&f.says), escaped(&f.term)),
            escaped(&format!("{} {}", f.site.kind, f.site.name)),
            escaped(&values.join("; ")),
            format!("{:.0} %", 100.0 * f.share),
        ]
    });
    table(page, &["mechanism", "where", "values (95 %)", "share"], rows);
}

fn pictures(page: &mut String, d: &Diagnosis) {
    page.push_str("<h2 id=\"pictures\">Residual before and after</h2>");
    let shaded: Vec<(f64, f64)> = d.answer.located.time.iter().map(|s| (s.from, s.to)).collect();
    for (k, output) in d.before.model.outputs.iter().enumerate() {
        let unit = output.unit.of_differences();
        let fitted = |fit: &crate::estimate::Fit| -> Vec<(f64, f64)> {
            let series = fit.records.iter().take(1).flat_map(|r| &r.series).filter(|s| s.output == k);
            series
                .flat_map(|s| {
                    s.time.iter().copied().zip(s.residual.iter().map(|e| unit.difference_from_si(*e)))
                })
                .collect()
        };
        let held = |h: &[crate::diagnose::prove::Held]| -> Vec<(f64, f64)> {
            let own = h.get(k).into_iter().flat_map(|h| h.time.iter().zip(&h.residual));
            own.flat_map(|(t, e)| t.iter().copied().zip(e.iter().map(|e| unit.difference_from_si(*e))))
                .collect()
        };
        let pair = |before, after| {
            [
                Line { class: "before", name: "before", points: before },
                Line { class: "after", name: "after", points: after },
            ]
        };
        let name = escaped(&output.name);
        let title = |part: &str| format!("{name}, {part}: measured less simulated, {}", unit.text());
        page.push_str(&picture(
            &title("fitted part"),
            "time, s",
            &pair(fitted(&d.before), fitted(&d.after)),
            &shaded,
        ));
        page.push_str(&picture(
            &title("held-out part"),
            "time, s",
            &pair(held(&d.held.0), held(&d.held.1)),
            &[],
        ));
    }
}

fn proof(page: &mut String, a: &Answer) {
    page.push_str("<h2 id=\"proof\">Proof: free-run error, root mean square</h2>");
    let rows = a.proof.iter().map(|p| {
        vec![
            escaped(&p.output),
            format!("{} → {} {}", figure(p.fit_before), figure(p.fit_after), p.unit),
            format!("{} → {} {}", figure(p.holdout_before), figure(p.holdout_after), p.unit),
            format!("{} to {}", figure(p.improvement_low), figure(p.improvement_high)),
            figure(p.noise_floor),
        ]
    });
    table(page, &["output", "fitted part", "held out", "fall, 95 %", "noise floor"], rows);
}

fn parameters(page: &mut String, a: &Answer) {
    page.push_str("<h2 id=\"parameters\">Parameters</h2>");
    let rows = a.parameters.iter().map(|p| {
        vec![
            escaped(&p.name),
            figure(p.before),
            figure(p.after),
            format!("{} to {} {}", figure(p.low), figure(p.high), p.unit),
        ]
    });
    table(page, &["name", "before", "after", "95 %"], rows);
}

fn shape(page: &mut String, a: &Answer) {
    let Some(u) = &a.unexplained else { return };
    let _ = write!(
        page,
        "<h2 id=\"unexplained\">What no name explains</h2><p>It goes with {}.</p>",
        escaped(&u.signal)
    );
    let along = |i: usize| u.shape.iter().map(|s| (s[0], s[i])).collect::<Vec<_>>();
    let lines = [
        Line { class: "after", name: "effect", points: along(1) },
        Line { class: "bound", name: "95 % low", points: along(2) },
        Line { class: "bound", name: "95 % high", points: along(3) },
    ];
    page.push_str(&picture("effect against the signal, SI", &escaped(&u.signal), &lines, &[]));
}

fn made(page: &mut String, a: &Answer) {
    let _ = write!(
        page,
        "<h2 id=\"made\">How this was made</h2><p>{}, seed {}</p>",
        escaped(&a.made.program),
        a.made.seed
    );
    let rows = a.made.inputs.iter().map(|i| vec![escaped(&i.file), format!("<code>{}</code>", i.sha256)]);
    table(page, &["file", "SHA-256"], rows);
}
