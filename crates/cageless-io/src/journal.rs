//! A journal of finished pieces of work, so that a long computation that was killed resumes
//! where it stopped.
//!
//! A line is a checksum and a JSON document: the first document says whose journal it is, as a list
//! of lines, each other holds the name of a piece of work and its outcome. Numbers are stored as
//! their bits: what is read back is what was computed. The checksum is the CRC-32 of all documents
//! up to the end of this one, in eight hexadecimal digits, so that a line that was edited, moved or
//! removed is found. A line that was cut off by the end of the program is dropped.

use std::collections::HashMap;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use crc32fast::Hasher;
use serde::{Deserialize, Serialize};

use crate::files::open_locked;
use crate::plan_file::difference;
use crate::system::io_error_message;

/// Numbers, or why there are none.
pub type Entry = Result<Vec<f64>, String>;

/// A journal open for writing, which no other process can open until it is dropped.
#[derive(Debug)]
pub struct Journal {
    file: File,
    /// Checksum of all documents so far.
    checksum: Hasher,
}

/// Error of a journal.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// It belongs to something else.
    #[error("{}: {why}: remove it or choose another folder", .path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
        /// Difference.
        why: String,
    },
    /// Another process is writing to it.
    #[error("{}: another search is writing there: wait for it or choose another folder", .path.display())]
    Busy {
        /// The file.
        path: PathBuf,
    },
    /// A line is not as it was written.
    #[error("{}:{line}: the line was damaged or edited: remove the file, or everything from this line on", .path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1.
        line: usize,
    },
    /// It cannot be read or written.
    #[error("{}: {}", .path.display(), io_error_message(.source))]
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

/// Difference from another owner as a sentence.
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
    /// [`JournalError::Busy`] if another process has it open, [`JournalError::Damaged`] if a line
    /// is not as it was written, [`JournalError::Io`] if it cannot be read or written.
    pub fn open(path: &Path, owner: &str) -> Result<(Self, HashMap<String, Entry>), JournalError> {
        let failed = |source| JournalError::Io {
            path: path.to_owned(),
            source,
        };
        let busy = || JournalError::Busy {
            path: path.to_owned(),
        };
        let mut file = open_locked(path).map_err(failed)?.ok_or_else(busy)?;
        let mut text = vec![];
        file.read_to_end(&mut text).map_err(failed)?;
        let foreign = |why: String| JournalError::Foreign {
            path: path.to_owned(),
            why,
        };
        let owner = lines(owner);
        let mut entries = HashMap::new();
        let (mut good, mut checksum) = (0, Hasher::new());
        for (k, line) in text.split_inclusive(|&b| b == b'\n').enumerate() {
            let document = checked(line, &mut checksum);
            if k == 0 {
                match document.and_then(|json| serde_json::from_slice::<Head>(json).ok()) {
                    // Cut off while the head was written: nothing is lost.
                    _ if !line.ends_with(b"\n") && is_begun(line) => break,
                    Some(head) if head.journal_of == owner => {}
                    Some(head) => return Err(foreign(why(&head.journal_of, &owner))),
                    None => return Err(foreign("is no journal of this version".to_owned())),
                }
            } else {
                if !line.ends_with(b"\n") {
                    break;
                }
                let read = document.and_then(|json| serde_json::from_slice::<Line>(json).ok());
                let Some(read) = read else {
                    return Err(JournalError::Damaged {
                        path: path.to_owned(),
                        line: k + 1,
                    });
                };
                let outcome = match (read.bits, read.failure) {
                    (Some(bits), _) => Ok(bits.into_iter().map(f64::from_bits).collect()),
                    (None, failure) => Err(failure.unwrap_or_default()),
                };
                entries.insert(read.key, outcome);
            }
            good += line.len();
        }
        file.set_len(good as u64).map_err(failed)?;
        file.seek(SeekFrom::End(0)).map_err(failed)?;
        let mut journal = Self { file, checksum };
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
        let json = serde_json::to_string(line)?;
        self.checksum.update(json.as_bytes());
        let checksum = self.checksum.clone().finalize();
        self.file
            .write_all(format!("{checksum:08x} {json}\n").as_bytes())
    }
}

/// Characters of a checksum and the space after it.
const CHECKSUM_LENGTH: usize = 9;

/// The document of a complete line whose checksum, after those of the lines before, is right.
fn checked<'l>(line: &'l [u8], before: &mut Hasher) -> Option<&'l [u8]> {
    let (checksum, json) = line.split_at_checked(CHECKSUM_LENGTH)?;
    let json = json.strip_suffix(b"\n")?;
    before.update(json);
    let expected = format!("{:08x} ", before.clone().finalize());
    (checksum == expected.as_bytes()).then_some(json)
}

/// Whether this is the beginning of a head.
fn is_begun(line: &[u8]) -> bool {
    let (checksum, json) = line.split_at(line.len().min(CHECKSUM_LENGTH));
    let digits = checksum.iter().take(CHECKSUM_LENGTH - 1);
    let begin = b"{\"journal_of\":";
    let shown = json.len().min(begin.len());
    digits.into_iter().all(u8::is_ascii_hexdigit) && json[..shown] == begin[..shown]
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
        text.extend(b"0123abcd {\"key\":\"d\",\"bi");
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
        let before = "made by 0.9\ntitle = \"a\"\n\n[search]\nruns_max = 4\nseed = 1\n\n\
                      [[raceway]]\nspan = 5\n\n[[raceway]]\nspan = 6\n";
        Journal::open(&path, before).unwrap();
        let message = |from: &str, to: &str| {
            let now = before.replace(from, to);
            Journal::open(&path, &now).unwrap_err().to_string()
        };
        let text = message("runs_max = 4", "runs_max = 8");
        assert!(
            text.contains("request: search.runs_max was 4, is 8: remove"),
            "{text}"
        );
        let text = message("span = 6", "span = 7");
        assert!(text.contains("raceway.2.span was 6, is 7"), "{text}");
        let text = message("0.9", "1.0");
        assert!(
            text.contains("it is of made by 0.9, this is made by 1.0"),
            "{text}"
        );
        let text = message(before, "made by 1.0\n[search]\nruns_max = 4");
        let first =
            "this is made by 1.0; title was \"a\", is left out; search.seed was 1, is left out";
        assert!(text.contains(first), "{text}");
        assert!(text.contains("; and 2 more: remove it"), "{text}");
        Journal::open(&path, before).unwrap();
        // Whoever looks into it sees a line for each key.
        let head = std::fs::read_to_string(&path).unwrap();
        assert!(
            head.contains("\"search.runs_max = 4\",\"search.seed = 1\""),
            "{head}"
        );
    }

    #[test]
    fn a_second_search_waits_for_the_first() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("journal");
        let (mut first, _) = Journal::open(&path, "me").unwrap();
        let busy = Journal::open(&path, "me").unwrap_err();
        assert!(matches!(busy, JournalError::Busy { .. }), "{busy}");
        first.add("a", &Ok(vec![1.0])).unwrap();
        drop(first);
        let (_, known) = Journal::open(&path, "me").unwrap();
        assert_eq!(known.len(), 1);
    }

    #[test]
    fn edited_lines_are_refused() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("journal");
        let (mut journal, _) = Journal::open(&path, "me").unwrap();
        for (k, key) in ["a", "b", "c"].into_iter().enumerate() {
            journal.add(key, &Ok(vec![k as f64 + 0.5])).unwrap();
        }
        drop(journal);
        let whole = std::fs::read(&path).unwrap();
        let is_refused = |bytes: &[u8], what: &str| {
            std::fs::write(&path, bytes).unwrap();
            assert!(Journal::open(&path, "me").is_err(), "{what}");
            // It is left as it is.
            assert_eq!(std::fs::read(&path).unwrap(), bytes, "{what}");
        };
        let text = String::from_utf8(whole.clone()).unwrap();
        let lines: Vec<&str> = text.split_inclusive('\n').collect();
        let joined = |order: &[usize]| order.iter().map(|&k| lines[k]).collect::<String>();
        is_refused(joined(&[0, 2, 1, 3]).as_bytes(), "swapped lines");
        is_refused(joined(&[0, 1, 3]).as_bytes(), "a line removed");
        is_refused(joined(&[0, 1, 1, 2, 3]).as_bytes(), "a line twice");
        let keys = text.replace("\"a\"", "\"x\"").replace("\"b\"", "\"a\"");
        is_refused(keys.as_bytes(), "swapped keys");
        // But for the last line feed, without which the line counts as cut off.
        for at in 0..whole.len() - 1 {
            for bit in 0..8 {
                let mut damaged = whole.clone();
                damaged[at] ^= 1 << bit;
                is_refused(&damaged, &format!("bit {bit} at {at}"));
            }
        }
        std::fs::write(&path, &whole).unwrap();
        assert_eq!(Journal::open(&path, "me").unwrap().1.len(), 3);
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
