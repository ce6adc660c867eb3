//! Tables that are no text: recognised by their first bytes, and turned into text or refused with what to do.

use super::mat;
use super::turned::Turned;
use crate::{Error, Result};

/// Turns bytes into a table of text.
type Turn = fn(&[u8]) -> Result<Turned>;

/// What turns a file that begins so into text; none for what is text, or nothing known.
///
/// # Errors
/// What is known and not read here.
pub(super) fn turn(start: &[u8]) -> Result<Option<Turn>> {
    if mat::is_one(start) {
        return Ok(Some(mat::table));
    }
    if start.starts_with(b"PAR1") {
        return parquet().map(Some);
    }
    let (what, hint) = if start.starts_with(b"MATLAB 7.3 MAT-file") {
        (
            "a MATLAB file of format 7.3",
            "save it with `save('log.mat', '-v7')`, or write a table with `writetable`",
        )
    } else if start.starts_with(b"MATLAB 5.0 MAT-file") {
        ("a MATLAB file whose beginning is damaged or cut short", "save or copy it again")
    } else if is_matlab_4(start) {
        (
            "a MATLAB file of format 4",
            "save it with `save('log.mat', '-v7')`; in Python, `scipy.io.savemat` without format=\"4\"",
        )
    } else if start.starts_with(b"\x89HDF\r\n\x1a\n") {
        (
            "an HDF5 file",
            "write its table as CSV; in Python a pandas frame goes to `gyrospec.recording` as it is",
        )
    } else if start.starts_with(b"PK\x03\x04") {
        (
            "a packed archive, such as a workbook of a spreadsheet",
            "save the sheet as CSV; the Python package reads .xlsx and .ods",
        )
    } else if start.starts_with(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1") {
        ("a workbook of an old spreadsheet", "save the sheet as CSV; the Python package reads .xls")
    } else {
        return Ok(None);
    };
    Err(Error::bad_input(format!("this is {what}, no table of text"))
        .with_line(1)
        .with_column(1)
        .with_hint(hint))
}

/// Whether bytes begin as a variable of MATLAB's format 4: five whole numbers, of either end first, and a name. The first
/// tells machine, storage and kind by its digits.
fn is_matlab_4(start: &[u8]) -> bool {
    let Some(head) = start.get(..20) else { return false };
    let numbers = |of: fn([u8; 4]) -> u32| -> Vec<u32> {
        head.chunks_exact(4).map(|b| of([b[0], b[1], b[2], b[3]])).collect()
    };
    [(numbers(u32::from_le_bytes), 0), (numbers(u32::from_be_bytes), 1)].iter().any(|(n, machine)| {
        let (kind, length) = (n[0] % 1000, n[4] as usize);
        let is_head = n[0] / 1000 == *machine && kind / 10 <= 5 && kind % 10 <= 2 && n[3] <= 1;
        let name = start.get(20..20 + length.min(64)).and_then(|name| name.split_last());
        is_head
            && name.is_some_and(|(end, name)| {
                *end == 0 && !name.is_empty() && name.iter().all(|b| b.is_ascii_alphanumeric() || *b == b'_')
            })
    })
}

#[cfg(feature = "parquet")]
#[allow(clippy::unnecessary_wraps)] // as without the feature
fn parquet() -> Result<Turn> {
    Ok(super::parquet::table)
}

#[cfg(not(feature = "parquet"))]
fn parquet() -> Result<Turn> {
    Err(Error::bad_input("this is a Parquet file, which this build does not read").with_hint(
        "build the program with `--features parquet`, use the Python package, which reads it, or write it as CSV",
    ))
}
