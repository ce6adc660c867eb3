//! Parquet files as tables of text, by the crate `parquet`, with the feature of that name.

use super::turned::Turned;
use crate::{Error, Result};
use ::parquet::errors::ParquetError;
use ::parquet::file::reader::{FileReader, SerializedFileReader};
use ::parquet::record::Field;
use bytes::Bytes;
use jiff::Timestamp;

/// The rows of such a file; columns of words, times of day and nested columns come as text or empty.
///
/// # Errors
/// What is damaged, or packed in a way that this build cannot open.
pub(super) fn table(bytes: &[u8]) -> Result<Turned> {
    let reader = SerializedFileReader::new(Bytes::copy_from_slice(bytes)).map_err(|e| refused(&e))?;
    let mut text = String::new();
    let mut count = 0usize;
    for row in reader.get_row_iter(None).map_err(|e| refused(&e))? {
        let row = row.map_err(|e| refused(&e))?;
        // pandas stores the numbers of its rows beside the columns
        let columns = || row.get_column_iter().filter(|(name, _)| !name.starts_with("__index_level_"));
        if count == 0 {
            let names: Vec<String> = columns().map(|(name, _)| quoted(name)).collect();
            text += &(names.join(",") + "\n");
        }
        let cells: Vec<String> = columns().map(|(_, field)| cell(field)).collect();
        text += &(cells.join(",") + "\n");
        count += 1;
    }
    if count == 0 {
        return Err(Error::bad_input("this Parquet file has no rows"));
    }
    Ok(Turned { text: text.into_bytes(), note: format!("a Parquet file of {count} rows") })
}

fn refused(e: &ParquetError) -> Error {
    Error::bad_input(format!("this Parquet file cannot be read: {e}"))
        .with_hint("write it again, packed by snappy, gzip, lz4 or not at all, or as CSV")
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\"").replace(['\n', '\r'], " "))
}

/// A value as a table of text has it; nothing for what is missing.
fn cell(field: &Field) -> String {
    let stamp = |t: std::result::Result<Timestamp, jiff::Error>| t.map(|t| t.to_string()).unwrap_or_default();
    match field {
        Field::Null => String::new(),
        Field::Float(x) if x.is_nan() => String::new(),
        Field::Double(x) if x.is_nan() => String::new(),
        Field::Float(x) => format!("{x}"),
        Field::Double(x) => format!("{x}"),
        Field::Bool(b) => u8::from(*b).to_string(),
        Field::Byte(x) => x.to_string(),
        Field::Short(x) => x.to_string(),
        Field::Int(x) => x.to_string(),
        Field::Long(x) => x.to_string(),
        Field::UByte(x) => x.to_string(),
        Field::UShort(x) => x.to_string(),
        Field::UInt(x) => x.to_string(),
        Field::ULong(x) => x.to_string(),
        Field::TimestampMillis(t) => stamp(Timestamp::from_millisecond(*t)),
        Field::TimestampMicros(t) => stamp(Timestamp::from_microsecond(*t)),
        Field::Str(words) => quoted(words),
        _ => String::new(),
    }
}
