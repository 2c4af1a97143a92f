//! Files that appear complete or not at all.

use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::error::ResultError;
use crate::files::open_locked;

/// Ending of the hidden name of a file in the making.
pub(super) const PARTIAL: &str = ".partial";

/// A file that grows as `.NAME.partial` beside its place and takes its name when it
/// is [committed](Self::commit). Dropped before, it is removed. (Temporary files of the `tempfile`
/// crate would be readable by their owner alone.)
#[derive(Debug)]
pub struct PartialFile {
    file: File,
    checksum: crc32fast::Hasher,
    partial: PathBuf,
    path: PathBuf,
    /// Whether the partial file is no longer this one's to remove.
    released: bool,
}

impl PartialFile {
    /// Opens the partial file of `path`. One that a killed run left is taken over, one
    /// that another run is writing is not.
    ///
    /// # Errors
    /// If the folder cannot be written to, another process writes the same file, or what is in
    /// place of the partial file is not a file of this program.
    pub fn create(path: &Path) -> Result<Self, ResultError> {
        let fail = |source| ResultError::out(path, source);
        let name = path.file_name().ok_or_else(|| {
            fail(io::Error::new(
                io::ErrorKind::InvalidInput,
                "not a file name",
            ))
        })?;
        // The rename at the end would find out, when all the work is done.
        if path.is_dir() {
            return Err(fail(io::ErrorKind::IsADirectory.into()));
        }
        let partial = path.with_file_name(format!(".{}{PARTIAL}", name.to_string_lossy()));
        let file = open_locked(&partial).map_err(|source| match source.kind() {
            io::ErrorKind::InvalidInput => ResultError::Occupied {
                path: path.to_owned(),
                partial: partial.clone(),
                source,
            },
            _ => fail(source),
        })?;
        let file = file.ok_or_else(|| ResultError::Busy {
            path: path.to_owned(),
        })?;
        file.set_len(0).map_err(fail)?;
        Ok(Self {
            file,
            checksum: crc32fast::Hasher::new(),
            partial,
            path: path.to_owned(),
            released: false,
        })
    }

    /// CRC-32 of what was written.
    pub(super) fn checksum(&self) -> u32 {
        self.checksum.clone().finalize()
    }

    /// The open file.
    pub(super) fn file(&self) -> &File {
        &self.file
    }

    /// Replaces bytes that were written.
    pub(super) fn overwrite(&mut self, offset: u64, bytes: &[u8]) -> io::Result<()> {
        self.file.seek(SeekFrom::Start(offset))?;
        self.file.write_all(bytes)?;
        self.file.seek(SeekFrom::End(0)).map(drop)
    }

    /// Takes the file out of a writer that cannot give it away; what stays there is a shell.
    pub(super) fn take(&mut self) -> io::Result<Self> {
        let file = self.file.try_clone()?;
        self.released = true;
        Ok(Self {
            file,
            checksum: self.checksum.clone(),
            partial: self.partial.clone(),
            path: self.path.clone(),
            released: false,
        })
    }

    /// Final path of the file.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Gives the file its name.
    ///
    /// # Errors
    /// If the file cannot be written; a previous file of that name is then untouched.
    pub fn commit(self) -> Result<(), ResultError> {
        self.sync()?;
        self.rename()
    }

    /// Flushes the content to disk so that an out-of-space error surfaces here.
    pub(super) fn sync(&self) -> Result<(), ResultError> {
        let done = self.file.sync_all();
        done.map_err(|source| ResultError::out(&self.path, source))
    }

    /// Gives the file, which is complete and [synced](Self::sync), its name.
    pub(super) fn rename(mut self) -> Result<(), ResultError> {
        std::fs::rename(&self.partial, &self.path)
            .map_err(|source| ResultError::out(&self.path, source))?;
        self.released = true;
        Ok(())
    }
}

impl Write for PartialFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.file.write(bytes)?;
        self.checksum.update(&bytes[..count]);
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for PartialFile {
    fn drop(&mut self) {
        if !self.released {
            // A failure cannot be reported from here.
            let _ = std::fs::remove_file(&self.partial);
        }
    }
}

/// Writes a file that other programs see complete or not at all.
///
/// # Errors
/// If the file cannot be written; a previous file of that name is then untouched.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), ResultError> {
    let mut file = PartialFile::create(path)?;
    file.write_all(bytes)
        .map_err(|source| ResultError::out(path, source))?;
    file.commit()
}
