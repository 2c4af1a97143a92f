//! A checksum of the rows of a table, in its footer: `crc32` of the first `crc32_bytes` bytes of
//! the file. (The format has one for each page, but the library writes none.)

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use crc32fast::Hasher;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::writer::SerializedFileWriter;

use super::partial::PartialFile;

const CHECKSUM: &str = "crc32";
const BYTES: &str = "crc32_bytes";

/// Puts the checksum of what was written so far in the footer.
pub(super) fn seal(writer: &mut SerializedFileWriter<PartialFile>) -> Result<(), ParquetError> {
    writer.flush()?;
    let (bytes, checksum) = writer.inner().written();
    for (key, value) in [
        (CHECKSUM, format!("{checksum:08x}")),
        (BYTES, bytes.to_string()),
    ] {
        writer.append_key_value_metadata(KeyValue::new(key.to_owned(), value));
    }
    Ok(())
}

/// Whether the file has the bytes that were written; one without a checksum is believed.
pub(super) fn is_intact(path: &Path, footer: &BTreeMap<String, String>) -> io::Result<bool> {
    let (Some(checksum), Some(bytes)) = (footer.get(CHECKSUM), footer.get(BYTES)) else {
        return Ok(true);
    };
    let Ok(bytes) = bytes.parse() else {
        return Ok(false);
    };
    let mut file = File::open(path)?.take(bytes);
    let (mut hasher, mut buffer) = (Hasher::new(), vec![0; 1 << 16]);
    loop {
        match file.read(&mut buffer)? {
            0 => break,
            count => hasher.update(&buffer[..count]),
        }
    }
    Ok(file.limit() == 0 && format!("{:08x}", hasher.finalize()) == *checksum)
}
