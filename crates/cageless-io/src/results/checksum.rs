//! The checksum of a table: the last key of its footer, `file_crc32`, holds the CRC-32 of all
//! bytes of the file, its own eight digits counted as zeros.
//!
//! It is checked before the footer is interpreted: the Parquet library panics on some damaged
//! footers and believes others.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};

use crc32fast::Hasher;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::writer::SerializedFileWriter;

use super::atomic_file::PartialFile;

/// Name of the checksum in the footer.
pub(super) const CHECKSUM: &str = "file_crc32";
const BLANK: &[u8; 8] = b"00000000";
/// End of every Parquet file, after the length of the footer in four bytes.
const MAGIC: &[u8; 4] = b"PAR1";

/// Damage of a table.
#[derive(Debug)]
pub(super) enum Fault {
    /// Failure to read the file.
    System(io::Error),
    /// File without the end of a Parquet file.
    NotParquet,
    /// Footer without a checksum.
    NoChecksum,
    /// Bytes other than those written.
    Damaged,
}

impl From<io::Error> for Fault {
    fn from(error: io::Error) -> Self {
        Self::System(error)
    }
}

/// Writes the footer with the checksum, and returns the complete file.
pub(super) fn seal(
    writer: &mut SerializedFileWriter<PartialFile>,
) -> Result<PartialFile, ParquetError> {
    let blank = String::from_utf8_lossy(BLANK).into_owned();
    writer.append_key_value_metadata(KeyValue::new(CHECKSUM.to_owned(), blank));
    writer.finish()?;
    let mut file = writer.inner_mut().take()?;
    let digits = format!("{:08x}", file.checksum());
    let place = match digits_at(file.file()) {
        Ok(place) => place,
        Err(Fault::System(error)) => return Err(error.into()),
        Err(fault) => {
            return Err(ParquetError::General(format!(
                "footer as written: {fault:?}"
            )));
        }
    };
    file.overwrite(place, digits.as_bytes())?;
    Ok(file)
}

/// The eight digits.
pub(super) fn digits(file: &mut File) -> Result<[u8; 8], Fault> {
    let place = digits_at(file)?;
    file.seek(SeekFrom::Start(place))?;
    let mut digits = *BLANK;
    file.read_exact(&mut digits)?;
    Ok(digits)
}

/// Checks that the file has the bytes that were written.
pub(super) fn verify(file: &mut File) -> Result<(), Fault> {
    let place = digits_at(file)?;
    let mut hasher = Hasher::new();
    file.seek(SeekFrom::Start(0))?;
    let mut buffer = vec![0; 1 << 16];
    let mut add = |part: &mut dyn Read, hasher: &mut Hasher| loop {
        match part.read(&mut buffer)? {
            0 => return io::Result::Ok(()),
            count => hasher.update(&buffer[..count]),
        }
    };
    add(&mut (&*file).take(place), &mut hasher)?;
    let mut digits = *BLANK;
    file.read_exact(&mut digits)?;
    hasher.update(BLANK);
    add(file, &mut hasher)?;
    if format!("{:08x}", hasher.finalize()).as_bytes() == digits {
        Ok(())
    } else {
        Err(Fault::Damaged)
    }
}

/// Offset of the eight digits in the file.
fn digits_at(mut file: &File) -> Result<u64, Fault> {
    let length = file.metadata()?.len();
    let tail = (MAGIC.len() + size_of::<u32>()) as u64;
    let end = length.checked_sub(tail).ok_or(Fault::NotParquet)?;
    file.seek(SeekFrom::Start(end))?;
    let (mut size, mut magic) = ([0; 4], [0; 4]);
    file.read_exact(&mut size)?;
    file.read_exact(&mut magic)?;
    if magic != *MAGIC {
        return Err(Fault::NotParquet);
    }
    let size = u64::from(u32::from_le_bytes(size));
    let start = end.checked_sub(size).ok_or(Fault::NotParquet)?;
    file.seek(SeekFrom::Start(start))?;
    let mut footer = Vec::new();
    file.take(size).read_to_end(&mut footer)?;
    // Thrift's compact protocol: type and length before each of the two texts.
    let text = |length: usize| [0x18, length as u8];
    let entry = [
        &text(CHECKSUM.len()),
        CHECKSUM.as_bytes(),
        &text(BLANK.len()),
    ]
    .concat();
    // The last one: a text before it may hold the same bytes.
    let found = footer.windows(entry.len()).rposition(|w| w == entry);
    let digits = found.map(|at| at + entry.len()).ok_or(Fault::NoChecksum)?;
    if digits + BLANK.len() > footer.len() {
        return Err(Fault::Damaged);
    }
    Ok(start + digits as u64)
}
