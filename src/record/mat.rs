//! # Purpose
//! Files that MATLAB wrote with `save` up to format 7 (MATLAB 5 to 7.2), as a table of text.
//!
//! # Method
//! Elements follow each other, each with a tag of its type and length; an element of type 15 is packed by zlib. Rows and
//! columns of real numbers become columns of the table, matrices one column each (`name.1`), structures theirs
//! (`log.time`). What shares its length with the time, or with most others, is the table.
//!
//! # References
//! The MathWorks, MAT-File Format (R2019b), chapter 1.

use super::turned::{Columns, Turned};
use crate::{Error, Result};
use flate2::read::ZlibDecoder;
use std::io::Read;

const HEADER: usize = 128;
/// Bytes that one packed variable may unpack to.
const LARGEST: u64 = 2 << 30;
/// Structures inside structures.
const DEEPEST: usize = 8;

const MATRIX: u32 = 14;
const PACKED: u32 = 15;

/// Whether bytes begin as such a file does.
pub(super) fn is_one(start: &[u8]) -> bool {
    start.len() >= HEADER
        && start.starts_with(b"MATLAB 5.0 MAT-file")
        && matches!(&start[126..128], b"IM" | b"MI")
}

/// The columns of such a file.
///
/// # Errors
/// What is damaged, cut short or written by a machine of the other byte order.
pub(super) fn columns(bytes: &[u8]) -> Result<Columns> {
    if bytes.get(126..128) != Some(b"IM") {
        return Err(Error::bad_input(
            "this MATLAB file has the byte order of machines that are gone (big-endian)",
        )
        .with_hint("load it in MATLAB or SciPy, and save it again"));
    }
    let mut found = Columns::default();
    let mut rest = bytes.get(HEADER..).unwrap_or_default();
    while let Some((kind, data)) = element(&mut rest)? {
        match kind {
            PACKED => {
                let mut open = Vec::new();
                ZlibDecoder::new(data).take(LARGEST).read_to_end(&mut open).map_err(|_| damaged())?;
                let mut inner = open.as_slice();
                while let Some((MATRIX, data)) = element(&mut inner)? {
                    variable(data, &mut found, "", 0)?;
                }
            }
            MATRIX => variable(data, &mut found, "", 0)?,
            _ => {}
        }
    }
    Ok(found)
}

fn damaged() -> Error {
    Error::bad_input("this MATLAB file is damaged or cut short").with_hint("save or copy it again")
}

/// The next element, none at the end: its type and its bytes.
fn element<'a>(rest: &mut &'a [u8]) -> Result<Option<(u32, &'a [u8])>> {
    if rest.is_empty() {
        return Ok(None);
    }
    let word = |at: usize| -> Result<u32> {
        let four = rest.get(at..at + 4).and_then(|b| b.try_into().ok());
        four.map(u32::from_le_bytes).ok_or_else(damaged)
    };
    let first = word(0)?;
    // up to four bytes stand in the tag itself
    if first >> 16 != 0 {
        let data = rest.get(4..4 + (first >> 16) as usize).filter(|d| d.len() <= 4).ok_or_else(damaged)?;
        *rest = rest.get(8..).ok_or_else(damaged)?;
        return Ok(Some((first & 0xffff, data)));
    }
    let length = word(4)? as usize;
    let data = rest.get(8..8 + length).ok_or_else(damaged)?;
    // all but what is packed fills whole steps of eight; the last may end without them
    let padded = if first == PACKED { length } else { length.next_multiple_of(8) };
    *rest = rest.get(8 + padded..).unwrap_or_default();
    Ok(Some((first, data)))
}

/// The element that must follow.
fn next<'a>(rest: &mut &'a [u8]) -> Result<(u32, &'a [u8])> {
    element(rest)?.ok_or_else(damaged)
}

/// A variable, or a field of one, by the name of what it stands in.
fn variable(data: &[u8], found: &mut Columns, outer: &str, depth: usize) -> Result<()> {
    if data.is_empty() {
        return Ok(());
    }
    let mut rest = data;
    let (_, flags) = next(&mut rest)?;
    let &[class, bits, ..] = flags else { return Err(damaged()) };
    // an object tells neither size nor name in this way
    if class == 17 {
        found.leave_out(outer, "is an object of MATLAB: save its numbers, as in t = ts.Time; x = ts.Data;");
        return Ok(());
    }
    let (_, dimensions) = next(&mut rest)?;
    let size: Vec<usize> = dimensions
        .chunks_exact(4)
        .map(|b| i32::from_le_bytes([b[0], b[1], b[2], b[3]]).max(0) as usize)
        .collect();
    let own = String::from_utf8_lossy(next(&mut rest)?.1).into_owned();
    let name = match (outer.is_empty(), own.is_empty()) {
        (true, _) => own,
        (false, true) => outer.to_owned(),
        (false, false) => format!("{outer}.{own}"),
    };
    match class {
        6..=15 if bits & 8 != 0 => found.leave_out(&name, "is complex"),
        6..=15 => numbers(&mut rest, &size, &name, found)?,
        2 if size.iter().product::<usize>() == 1 && depth < DEEPEST => {
            return fields(&mut rest, found, &name, depth);
        }
        2 => found.leave_out(&name, "is a list of structures"),
        1 => found.leave_out(&name, "is a cell array"),
        4 => found.leave_out(&name, "is text"),
        5 => found.leave_out(&name, "is sparse"),
        _ => found.leave_out(&name, "is an object"),
    }
    Ok(())
}

/// The fields of one structure.
fn fields(rest: &mut &[u8], found: &mut Columns, name: &str, depth: usize) -> Result<()> {
    let length = next(rest)?.1;
    let length =
        length.get(..4).and_then(|b| b.try_into().ok()).map(u32::from_le_bytes).ok_or_else(damaged)?;
    let names = next(rest)?.1;
    for field in names.chunks(length.max(1) as usize) {
        let end = field.iter().position(|b| *b == 0).unwrap_or(field.len());
        let field = String::from_utf8_lossy(&field[..end]);
        let (kind, data) = next(rest)?;
        if kind != MATRIX {
            return Err(damaged());
        }
        variable(data, found, &format!("{name}.{field}"), depth + 1)?;
    }
    Ok(())
}

/// A row or column, or each column of a matrix; one that is wider than long holds its signals in rows.
fn numbers(rest: &mut &[u8], size: &[usize], name: &str, found: &mut Columns) -> Result<()> {
    let (kind, data) = next(rest)?;
    let values = doubles(kind, data)?;
    let count = size.iter().try_fold(1usize, |n, d| n.checked_mul(*d));
    if count != Some(values.len()) {
        return Err(damaged());
    }
    let long: Vec<usize> = size.iter().copied().filter(|d| *d != 1).collect();
    match long[..] {
        [] => found.leave_out(name, "is a single number"),
        [_] => found.add(name.to_owned(), values),
        [rows, columns] if rows > 0 && columns > 0 => {
            let is_wide = columns > rows;
            let (signals, samples) = if is_wide { (rows, columns) } else { (columns, rows) };
            for k in 0..signals {
                let at = |i: usize| if is_wide { values[i * rows + k] } else { values[k * rows + i] };
                found.add(format!("{name}.{}", k + 1), (0..samples).map(at).collect());
            }
        }
        _ => found.leave_out(name, "is empty or has more than two dimensions"),
    }
    Ok(())
}

/// Numbers of any storage as doubles.
#[allow(clippy::cast_lossless)] // one rule for all of them
fn doubles(kind: u32, data: &[u8]) -> Result<Vec<f64>> {
    macro_rules! each {
        ($kind:ty) => {
            data.chunks_exact(size_of::<$kind>())
                .filter_map(|b| b.try_into().ok().map(<$kind>::from_le_bytes))
                .map(|x| x as f64)
                .collect()
        };
    }
    Ok(match kind {
        1 => each!(i8),
        2 => each!(u8),
        3 => each!(i16),
        4 => each!(u16),
        5 => each!(i32),
        6 => each!(u32),
        7 => each!(f32),
        9 => each!(f64),
        12 => each!(i64),
        13 => each!(u64),
        _ => return Err(damaged()),
    })
}

/// The file as a table.
pub(super) fn table(bytes: &[u8]) -> Result<Turned> {
    columns(bytes)?.table("a MATLAB file")
}
