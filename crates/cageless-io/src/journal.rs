//! A journal of finished pieces of work, so that a long computation that was killed goes on
//! where it stopped.
//!
//! One JSON document per line: the first says whose journal it is, each other holds the name
//! of a piece of work and its outcome. Numbers are stored as their bits: what is read back is
//! what was computed. A line that was cut off by the end of the program is dropped.

use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

/// Numbers, or why there are none.
pub type Entry = Result<Vec<f64>, String>;

/// A journal open for writing.
#[derive(Debug)]
pub struct Journal {
    file: File,
}

/// Why a journal cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// It belongs to something else.
    #[error(
        "{}: was left by another case, another request or another version: remove it or choose \
         another folder", .0.display()
    )]
    Foreign(PathBuf),
    /// It cannot be read or written.
    #[error("{}: {source}", .path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// The cause.
        source: io::Error,
    },
}

#[derive(Serialize, Deserialize)]
struct Head {
    journal_of: String,
}

#[derive(Serialize, Deserialize)]
struct Line {
    key: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    bits: Option<Vec<u64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    failure: Option<String>,
}

impl Journal {
    /// Opens the journal of `owner` (a text that changes with everything that the outcomes
    /// depend on) or begins one, and returns what it holds.
    ///
    /// # Errors
    /// [`JournalError::Foreign`] if it has another owner, [`JournalError::Io`] if it cannot be
    /// read or written.
    pub fn open(path: &Path, owner: &str) -> Result<(Self, HashMap<String, Entry>), JournalError> {
        let failed = |source| JournalError::Io {
            path: path.to_owned(),
            source,
        };
        let text = match std::fs::read(path) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == io::ErrorKind::NotFound => vec![],
            Err(error) => return Err(failed(error)),
        };
        let mut entries = HashMap::new();
        let mut good = 0;
        for (k, line) in text.split_inclusive(|&b| b == b'\n').enumerate() {
            if k == 0 {
                match serde_json::from_slice::<Head>(line) {
                    Ok(head) if head.journal_of == owner => {}
                    // Cut off while the head was written: nothing is lost.
                    Err(_) if !line.ends_with(b"\n") => break,
                    _ => return Err(JournalError::Foreign(path.to_owned())),
                }
            } else {
                let Ok(read) = serde_json::from_slice::<Line>(line) else {
                    break;
                };
                if !line.ends_with(b"\n") {
                    break;
                }
                let outcome = match (read.bits, read.failure) {
                    (Some(bits), _) => Ok(bits.into_iter().map(f64::from_bits).collect()),
                    (None, failure) => Err(failure.unwrap_or_default()),
                };
                entries.insert(read.key, outcome);
            }
            good += line.len();
        }
        let mut file = OpenOptions::new()
            .create(true)
            .truncate(false)
            .write(true)
            .open(path)
            .map_err(failed)?;
        file.set_len(good as u64).map_err(failed)?;
        file.seek(SeekFrom::End(0)).map_err(failed)?;
        let mut journal = Self { file };
        if good == 0 {
            let head = Head {
                journal_of: owner.to_owned(),
            };
            journal.line(&head).map_err(failed)?;
        }
        Ok((journal, entries))
    }

    /// Adds the outcome of a piece of work.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn add(&mut self, key: &str, entry: &Entry) -> io::Result<()> {
        self.line(&Line {
            key: key.to_owned(),
            bits: entry
                .as_ref()
                .ok()
                .map(|values| values.iter().map(|v| v.to_bits()).collect()),
            failure: entry.as_ref().err().cloned(),
        })
    }

    fn line<T: Serialize>(&mut self, line: &T) -> io::Result<()> {
        let mut text = serde_json::to_string(line)?;
        text.push('\n');
        self.file.write_all(text.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_read_back_is_what_was_written() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("journal");
        let entries: [(&str, Entry); 3] = [
            ("a", Ok(vec![0.1 + 0.2, -0.0, f64::INFINITY])),
            ("b", Err("does not roll".to_owned())),
            ("c", Ok(vec![1e-308])),
        ];
        let (mut journal, known) = Journal::open(&path, "me").unwrap();
        assert!(known.is_empty());
        for (key, entry) in &entries {
            journal.add(key, entry).unwrap();
        }
        drop(journal);
        // Killed in the middle of a line.
        let mut text = std::fs::read(&path).unwrap();
        let whole = text.len();
        text.extend(b"{\"key\":\"d\",\"bi");
        std::fs::write(&path, &text).unwrap();

        let (journal, known) = Journal::open(&path, "me").unwrap();
        assert_eq!(known.len(), 3);
        for (key, entry) in &entries {
            assert_eq!(known.get(*key), Some(entry));
        }
        drop(journal);
        assert_eq!(std::fs::metadata(&path).unwrap().len() as usize, whole);
        assert!(matches!(
            Journal::open(&path, "you"),
            Err(JournalError::Foreign(_))
        ));
    }

    #[test]
    fn a_file_of_something_else_is_left_alone() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("journal");
        std::fs::write(&path, "title = 'a case'\n").unwrap();
        assert!(Journal::open(&path, "me").is_err());
        assert_eq!(
            std::fs::read_to_string(&path).unwrap(),
            "title = 'a case'\n"
        );
    }
}
