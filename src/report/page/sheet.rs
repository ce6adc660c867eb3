//! A page that is meant for paper: one sheet of A4.

use crate::report::svg::escaped;

const STYLE: &str = include_str!("sheet.css");

/// A page with its own style for paper; `content` is HTML.
pub fn sheet(title: &str, content: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" \
         content=\"width=device-width,initial-scale=1\"><link rel=\"icon\" href=\"data:,\"><title>{}</title><style>\n\
         {STYLE}</style></head><body>\n{content}</body></html>\n",
        escaped(title)
    )
}
