//! Files that appear complete or not at all.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::error::ResultError;

/// A file that grows as `.NAME.partial` beside its place and takes its name when it
/// is committed. Dropped before, it is removed. (Temporary files of the `tempfile`
/// crate would be readable by their owner alone.)
#[derive(Debug)]
pub(super) struct PartialFile {
    file: File,
    bytes: u64,
    checksum: crc32fast::Hasher,
    partial: PathBuf,
    path: PathBuf,
    committed: bool,
}

impl PartialFile {
    /// Opens the partial file of `path`. One that a killed run left is taken over, one
    /// that another run is writing is not.
    pub(super) fn create(path: &Path) -> Result<Self, ResultError> {
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
        let partial = path.with_file_name(format!(".{}.partial", name.to_string_lossy()));
        let file = loop {
            // Not truncated: it may belong to another run until the lock is had.
            let file = OpenOptions::new()
                .create(true)
                .write(true)
                .truncate(false)
                .open(&partial)
                .map_err(fail)?;
            match file.try_lock() {
                Err(TryLockError::WouldBlock) => {
                    return Err(ResultError::Busy {
                        path: path.to_owned(),
                    });
                }
                // Some network file systems have no locks; do without.
                Err(TryLockError::Error(_)) | Ok(()) => {}
            }
            // Committed by another run since it was opened, it is now that run's result.
            if partial.exists() {
                break file;
            }
        };
        file.set_len(0).map_err(fail)?;
        Ok(Self {
            file,
            bytes: 0,
            checksum: crc32fast::Hasher::new(),
            partial,
            path: path.to_owned(),
            committed: false,
        })
    }

    /// How many bytes were written, and their CRC-32.
    pub(super) fn written(&self) -> (u64, u32) {
        (self.bytes, self.checksum.clone().finalize())
    }

    /// Where the file will be.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Gives the file its name.
    pub(super) fn commit(self) -> Result<(), ResultError> {
        self.sync()?;
        self.rename()
    }

    /// Puts the content on the disk: whatever lacks room has failed then.
    pub(super) fn sync(&self) -> Result<(), ResultError> {
        let done = self.file.sync_all();
        done.map_err(|source| ResultError::out(&self.path, source))
    }

    /// Gives the file, which is complete and [synced](Self::sync), its name.
    pub(super) fn rename(mut self) -> Result<(), ResultError> {
        std::fs::rename(&self.partial, &self.path)
            .map_err(|source| ResultError::out(&self.path, source))?;
        self.committed = true;
        Ok(())
    }
}

impl Write for PartialFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.file.write(bytes)?;
        self.bytes += count as u64;
        self.checksum.update(&bytes[..count]);
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for PartialFile {
    fn drop(&mut self) {
        if !self.committed {
            // Nobody is left to hear of a failure.
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
