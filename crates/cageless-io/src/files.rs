//! Files of the program's own, under names that others can guess.

#[cfg(unix)]
use std::fs::Metadata;
use std::fs::{File, OpenOptions, TryLockError};
use std::io;
use std::path::Path;

/// Opens a file to read and write, or makes it, and keeps other processes from it until it is
/// dropped; `None` if another has it. Its name is known beforehand, so that somebody else may have
/// put something in its place: a link, symbolic or not, would lead the writing to another file, and
/// a pipe would wait for a reader forever. Both are refused.
///
/// # Errors
/// [`io::ErrorKind::InvalidInput`] for anything but a regular file with one name, else what the
/// system says.
pub fn open_locked(path: &Path) -> io::Result<Option<File>> {
    loop {
        let file = open(path)?;
        // Some network file systems have no locks; do without.
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Ok(None);
        }
        // Renamed, removed or replaced by another process since it was opened, it is no longer the file.
        if is_at(&file, path) {
            return Ok(Some(file));
        }
    }
}

/// Removes a file of the program's own that no process has locked; where there are no locks, none.
pub(crate) fn remove_abandoned(path: &Path) {
    if open(path).is_ok_and(|file| file.try_lock().is_ok() && is_at(&file, path)) {
        // A failure cannot be reported from here.
        let _ = std::fs::remove_file(path);
    }
}

/// Whether an open file is the one at a path.
fn is_at(file: &File, path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let number = |m: &Metadata| (m.dev(), m.ino());
        let (open, there) = (file.metadata(), path.symlink_metadata());
        open.is_ok_and(|open| there.is_ok_and(|there| number(&open) == number(&there)))
    }
    #[cfg(not(unix))]
    {
        let _ = file;
        path.exists()
    }
}

fn open(path: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.create(true).read(true).write(true).truncate(false);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags(libc::O_NOFOLLOW | libc::O_NONBLOCK);
    }
    let is_link = || path.symlink_metadata().is_ok_and(|m| m.is_symlink());
    let file = match options.open(path) {
        Err(_) if is_link() => return Err(refused("is a symbolic link")),
        other => other?,
    };
    let metadata = file.metadata()?;
    if !metadata.is_file() {
        return Err(refused("is not a regular file"));
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        if metadata.nlink() > 1 {
            return Err(refused("is another file as well, by a hard link"));
        }
    }
    Ok(file)
}

fn refused(what: &str) -> io::Error {
    let message = format!("{what}, where a file of the program's own is to be: remove it");
    io::Error::new(io::ErrorKind::InvalidInput, message)
}
