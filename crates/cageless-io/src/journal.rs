//! A journal of finished pieces of work, so that a long computation that was killed goes on
//! where it stopped.
//!
//! One JSON document per line: the first says whose journal it is, as a list of lines, each
//! other holds the name of a piece of work and its outcome. Numbers are stored as their bits: what is read back is
//! what was computed. A line that was cut off by the end of the program is dropped.

use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::plan_file::difference;
use crate::system::in_words;

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
    #[error("{}: {why}: remove it or choose another folder", .path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
        /// What is different.
        why: String,
    },
    /// It cannot be read or written.
    #[error("{}: {}", .path.display(), in_words(.source))]
    Io {
        /// The file.
        path: PathBuf,
        /// The cause.
        source: io::Error,
    },
}

#[derive(Serialize, Deserialize)]
struct Head {
    journal_of: Vec<String>,
}

/// Differences that a message names.
const NAMED: usize = 3;

/// The lines of an owner: `key = value` with the section before the key, so that each says
/// by itself what it is about.
fn lines(owner: &str) -> Vec<String> {
    let (mut section, mut counts) = (String::new(), HashMap::new());
    let mut lines = vec![];
    for line in owner.lines().map(str::trim).filter(|l| !l.is_empty()) {
        let inner = |open, close| line.strip_prefix(open)?.strip_suffix(close);
        if let Some(name) = inner("[[", "]]") {
            let count = counts.entry(name).or_insert(0);
            *count += 1;
            section = format!("{name}.{count}.");
        } else if let Some(name) = inner("[", "]") {
            section = format!("{name}.");
        } else {
            lines.push(format!("{section}{line}"));
        }
    }
    lines
}

/// What is different about another owner, in words.
fn why(before: &[String], now: &[String]) -> String {
    let is_key = |line: &&String| line.contains(" = ");
    let heading = |lines: &[String]| -> Vec<String> {
        let others = lines.iter().filter(|l| !is_key(l));
        others.cloned().collect()
    };
    let (was, is) = (heading(before), heading(now));
    let mut found = difference(&before.join("\n"), &now.join("\n"));
    if was != is {
        let change = format!("it is of {}, this is {}", was.join(", "), is.join(", "));
        found.insert(0, change);
    }
    let more = found.len().saturating_sub(NAMED);
    found.truncate(NAMED);
    let more = match more {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    format!("was left by another request: {}{more}", found.join("; "))
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
    /// depend on: headings and TOML) or begins one, and returns what it holds.
    ///
    /// # Errors
    /// [`JournalError::Foreign`] with what differs if it has another owner,
    /// [`JournalError::Io`] if it cannot be read or written.
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
        let foreign = |why: String| JournalError::Foreign {
            path: path.to_owned(),
            why,
        };
        let owner = lines(owner);
        let mut entries = HashMap::new();
        let mut good = 0;
        for (k, line) in text.split_inclusive(|&b| b == b'\n').enumerate() {
            if k == 0 {
                match serde_json::from_slice::<Head>(line) {
                    Ok(head) if head.journal_of == owner => {}
                    // Cut off while the head was written: nothing is lost.
                    Err(_) if !line.ends_with(b"\n") => break,
                    Ok(head) => return Err(foreign(why(&head.journal_of, &owner))),
                    Err(_) => return Err(foreign("is no journal of this version".to_owned())),
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
            let head = Head { journal_of: owner };
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
            Err(JournalError::Foreign { .. })
        ));
    }

    #[test]
    fn another_owner_hears_what_is_different() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("journal");
        let before = "made by 0.9\ntitle = \"a\"\n\n[search]\nbudget = 4\nseed = 1\n\n\
                      [[raceway]]\nspan = 5\n\n[[raceway]]\nspan = 6\n";
        Journal::open(&path, before).unwrap();
        let message = |from: &str, to: &str| {
            let now = before.replace(from, to);
            Journal::open(&path, &now).unwrap_err().to_string()
        };
        let text = message("budget = 4", "budget = 8");
        assert!(
            text.contains("request: search.budget was 4, is 8: remove"),
            "{text}"
        );
        let text = message("span = 6", "span = 7");
        assert!(text.contains("raceway.2.span was 6, is 7"), "{text}");
        let text = message("0.9", "1.0");
        assert!(
            text.contains("it is of made by 0.9, this is made by 1.0"),
            "{text}"
        );
        let text = message(before, "made by 1.0\n[search]\nbudget = 4");
        let first =
            "this is made by 1.0; title was \"a\", is left out; search.seed was 1, is left out";
        assert!(text.contains(first), "{text}");
        assert!(text.contains("; and 2 more: remove it"), "{text}");
        Journal::open(&path, before).unwrap();
        // Whoever looks into it sees a line for each key.
        let head = std::fs::read_to_string(&path).unwrap();
        assert!(
            head.contains("\"search.budget = 4\",\"search.seed = 1\""),
            "{head}"
        );
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
