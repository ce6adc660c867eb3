//! The folder of tables that the program regenerates.

use super::{HIGHEST_EXPANDED, print_tables};
use crate::Result;
use crate::symbolic::minors::{HIGHEST_ORDER, Program};
use crate::symbolic::table::Table;
use sha2::{Digest, Sha256};
use std::fmt::Write;

/// A file of the folder.
#[derive(Clone, Debug)]
pub struct FolderFile {
    /// Its name in the folder, with its ending.
    pub name: &'static str,
    /// Its whole text.
    pub text: String,
}

/// Every file of the folder `tables/`.
pub fn folder() -> Result<Vec<FolderFile>> {
    let low = 1..=HIGHEST_EXPANDED;
    let high = HIGHEST_EXPANDED + 1..=HIGHEST_ORDER;
    let all = 1..=HIGHEST_ORDER;
    let printed = [
        ("orders-1-8.json", &low, "json"),
        ("orders-1-8.md", &low, "markdown"),
        ("orders-1-8.tex", &low, "latex"),
        ("orders-9-14.md", &high, "markdown"),
        ("integrals.rs", &all, "rust"),
        ("integrals.py", &all, "python"),
        ("integrals.c", &all, "c"),
    ];
    let mut files = printed
        .into_iter()
        .map(|(name, orders, format)| {
            Ok(FolderFile { name, text: print_tables(orders.clone(), format.parse()?)? })
        })
        .collect::<Result<Vec<_>>>()?;
    files.push(FolderFile { name: "index.json", text: index()? });
    Ok(files)
}

/// Term counts and hashes: that of order n is the SHA-256 of `gyrospec table --orders n --format json`.
fn index() -> Result<String> {
    let mut text = String::from("{\"schema\":\"gyrospec.table-index/1\",\"orders\":[");
    for n in 1..=HIGHEST_ORDER {
        let program = Program::new(n)?;
        let table = Table::expand(&program)?;
        let hash = Sha256::digest(print_tables(n..=n, "json".parse()?)?);
        let hash = hash.iter().fold(String::new(), |text, byte| text + &format!("{byte:02x}"));
        let comma = if n == 1 { "" } else { "," };
        let _ = write!(
            text,
            "{comma}\n {{\"n\":{n},\"numerator_terms\":{},\"denominator_terms\":{},\"shared_minors\":{},\"sha256\":\"{hash}\"}}",
            table.numerator.terms().len(),
            table.denominator.terms().len(),
            program.minors.len(),
        );
    }
    text.push_str("\n]}\n");
    Ok(text)
}
