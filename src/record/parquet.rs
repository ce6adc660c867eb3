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
        // what is missing, and what is no number, word or time
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::table;
    use ::parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
    use ::parquet::file::properties::WriterProperties;
    use ::parquet::file::writer::SerializedFileWriter;
    use ::parquet::schema::parser::parse_message_type;
    use std::sync::Arc;

    #[test]
    fn numbers_stamps_words_and_what_is_missing_become_a_table() {
        let schema = "message m { required int64 time (TIMESTAMP_MICROS); optional double force_N; optional binary word (UTF8); }";
        let schema = Arc::new(parse_message_type(schema).unwrap());
        let mut bytes = Vec::new();
        let properties = Arc::new(WriterProperties::default());
        let mut file = SerializedFileWriter::new(&mut bytes, schema, properties).unwrap();
        let mut group = file.next_row_group().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        column.typed::<Int64Type>().write_batch(&[0, 500_000, 1_000_000], None, None).unwrap();
        column.close().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        column.typed::<DoubleType>().write_batch(&[1.5, -0.25], Some(&[1, 0, 1]), None).unwrap();
        column.close().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        let words = [ByteArray::from("a, b"), ByteArray::from("c \"d\"")];
        column.typed::<ByteArrayType>().write_batch(&words, Some(&[1, 1, 0]), None).unwrap();
        column.close().unwrap();
        group.close().unwrap();
        file.close().unwrap();
        let text = String::from_utf8(table(&bytes).unwrap().text).unwrap();
        let wanted = "\"time\",\"force_N\",\"word\"\n1970-01-01T00:00:00Z,1.5,\"a, b\"\n1970-01-01T00:00:00.5Z,,\"c \"\"d\"\"\"\n1970-01-01T00:00:01Z,-0.25,\n";
        assert_eq!(text, wanted);
        for end in 0..bytes.len() {
            assert!(table(&bytes[..end]).is_err(), "{end}");
        }
    }
}
