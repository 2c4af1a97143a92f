//! The folder of a result: one writer at a time, and all files of the result or none.
//!
//! Everything is complete on the disk before a file takes its name. Then the file that speaks for the
//! result, such as `summary.json`, and all files that are replaced go; the new ones take their names, that
//! file last. A process that ends in between leaves the old result, the new one, or files of one of
//! them without the file that speaks for it.

use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::atomic_file::{PARTIAL, PartialFile};
use super::csv::write_csv;
use super::error::ResultError;
use super::table_list::with_tables;
use super::{ABOUT_TABLES, Metadata, RunWriter, SUMMARY, TABLES};
use crate::files::{open_locked, remove_abandoned};

/// Hidden file that is locked while a result is written to its folder.
const LOCK: &str = ".cageless.lock";
/// Beginning of the names of the folders of bearings.
const BEARING: &str = "bearing-";
/// Endings of the files of results.
const ENDINGS: [&str; 7] = ["parquet", "json", "html", "csv", "toml", "step", "stl"];

/// A folder to which nobody else writes a result until this is dropped.
#[derive(Debug)]
pub struct ResultFolder {
    // Files go before the lock does.
    complete: Vec<PartialFile>,
    tables: Vec<(String, String)>,
    replaced: Vec<PathBuf>,
    dir: PathBuf,
    _lock: Lock,
}

/// The locked file, which is removed in the end.
#[derive(Debug)]
struct Lock {
    path: PathBuf,
    _file: File,
}

impl Drop for Lock {
    fn drop(&mut self) {
        // A failure cannot be reported from here; the next process takes the lock over.
        let _ = std::fs::remove_file(&self.path);
    }
}

impl ResultFolder {
    /// Makes the folder if it is missing, keeps others from it, and removes what killed processes left
    /// half-written there.
    ///
    /// # Errors
    /// The folder cannot be made or written to, or another process is writing a result there.
    pub fn open(dir: &Path) -> Result<Self, ResultError> {
        let fail = |source| ResultError::out(dir, source);
        std::fs::create_dir_all(dir).map_err(fail)?;
        let path = dir.join(LOCK);
        let locked = open_locked(&path).map_err(|source| match source.kind() {
            io::ErrorKind::InvalidInput => ResultError::Occupied {
                path: dir.to_owned(),
                partial: path.clone(),
                source,
            },
            _ => fail(source),
        })?;
        let busy = || ResultError::Busy {
            path: dir.to_owned(),
        };
        let _lock = Lock {
            _file: locked.ok_or_else(busy)?,
            path,
        };
        let folder = Self {
            complete: vec![],
            tables: vec![],
            replaced: vec![],
            dir: dir.to_owned(),
            _lock,
        };
        for place in folder.places() {
            remove_partial_files(&place);
        }
        Ok(folder)
    }

    /// The folder.
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// Opens the tables of a run in the folder `place` within, empty for the folder itself.
    ///
    /// # Errors
    /// They cannot be written.
    pub fn tables(&self, place: &str, metadata: &Metadata<'_>) -> Result<RunWriter, ResultError> {
        RunWriter::create(&self.dir, place, metadata)
    }

    /// Completes the tables of a run, and those as CSV, too, if `csv`: of one that stopped early as
    /// well, they hold all rows up to then.
    ///
    /// # Errors
    /// They cannot be written: all that failed are named, and the folder is as it was.
    pub fn add_tables(&mut self, writer: RunWriter, csv: bool) -> Result<(), ResultError> {
        let place = writer.place().to_owned();
        let tables = writer.close().map_err(|errors| self.unchanged(errors))?;
        for (name, table) in tables {
            if csv {
                self.complete.push(write_csv(name, &table)?);
            }
            let path = Path::new(&place).join(name).with_extension("parquet");
            let digits = format!("{:08x}", table.checksum());
            // A slash on every system.
            let path = path.to_string_lossy().replace('\\', "/");
            self.tables.push((path, digits));
            self.complete.push(table);
        }
        Ok(())
    }

    /// Adds a file.
    ///
    /// # Errors
    /// It cannot be written; the folder is as it was.
    pub fn add(&mut self, name: &str, bytes: &[u8]) -> Result<(), ResultError> {
        let path = self.dir.join(name);
        let mut file = PartialFile::create(&path)?;
        file.write_all(bytes)
            .map_err(|source| ResultError::out(&path, source))?;
        self.add_file(file)
    }

    /// Adds a file that is written.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn add_file(&mut self, file: PartialFile) -> Result<(), ResultError> {
        file.sync()?;
        self.complete.push(file);
        Ok(())
    }

    /// Lets a file of an earlier result go.
    pub fn remove(&mut self, name: &str) {
        self.replaced.push(self.dir.join(name));
    }

    /// Gives all files their names and adds the one that speaks for them, which lists the tables.
    ///
    /// # Errors
    /// A file cannot be written, the folder is as it was then; or it cannot take its name, and the
    /// folder has no file that speaks for a result.
    pub fn commit(&mut self, name: &str, text: &str) -> Result<(), ResultError> {
        match self.tables.is_empty() {
            true => self.add(name, text.as_bytes())?,
            false => {
                let listed = with_tables(text, &self.tables);
                self.add(name, listed.as_bytes())?;
                self.replace_tables();
            }
        }
        self.commit_files()
    }

    /// Gives all files their names, where none speaks for the others; the last goes first and comes last.
    ///
    /// # Errors
    /// Those of [`Self::commit`].
    pub fn commit_files(&mut self) -> Result<(), ResultError> {
        let new: Vec<PathBuf> = self.complete.iter().map(|f| f.path().to_owned()).collect();
        if let Some(path) = new.iter().find(|path| path.is_dir()) {
            let error = ResultError::out(path, io::ErrorKind::IsADirectory.into());
            return Err(self.unchanged(vec![error]));
        }
        let replaced = std::mem::take(&mut self.replaced);
        for path in new.iter().rev().chain(&replaced) {
            match std::fs::remove_file(path) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(self.incomplete(ResultError::out(path, error)));
                }
                _ => {}
            }
        }
        for place in self.places().skip(1) {
            // Of bearings that the result does not have; it stays if there is anything in it.
            let _ = std::fs::remove_dir(place);
        }
        for file in std::mem::take(&mut self.complete) {
            if let Err(error) = file.rename() {
                return Err(self.incomplete(error));
            }
        }
        Ok(())
    }

    /// Lets all tables of an earlier result go, with what is said about them.
    fn replace_tables(&mut self) {
        for place in self.places() {
            let new = self
                .complete
                .iter()
                .any(|file| file.path().parent() == Some(&place));
            if !new && place.join(SUMMARY).exists() {
                // A result of its own.
                continue;
            }
            for name in TABLES {
                let table = place.join(name);
                self.replaced.push(table.with_extension("parquet"));
                self.replaced.push(table.with_extension("csv"));
            }
            self.replaced
                .extend(ABOUT_TABLES.map(|name| place.join(name)));
        }
    }

    /// The folder and those of bearings in it.
    fn places(&self) -> impl Iterator<Item = PathBuf> + use<> {
        let entries = std::fs::read_dir(&self.dir).into_iter().flatten().flatten();
        let bearings = entries.filter(|entry| {
            let name = entry.file_name();
            let number = name.to_str().and_then(|name| name.strip_prefix(BEARING));
            let is_number = number.is_some_and(|text| text.parse::<u32>().is_ok());
            // No link leads out of the folder.
            is_number && entry.file_type().is_ok_and(|kind| kind.is_dir())
        });
        [self.dir.clone()]
            .into_iter()
            .chain(bearings.map(|entry| entry.path()))
    }

    fn unchanged(&self, errors: Vec<ResultError>) -> ResultError {
        let left = format!("{} is as it was", self.dir.display());
        ResultError::Run { errors, left }
    }

    fn incomplete(&self, error: ResultError) -> ResultError {
        let left = format!("{} has no whole result", self.dir.display());
        let errors = vec![error];
        ResultError::Run { errors, left }
    }
}

/// Name of the folder of a bearing, counted from 1.
pub fn bearing_folder(number: usize) -> String {
    format!("{BEARING}{number}")
}

/// Removes files that killed processes left half-written, which nobody has locked.
fn remove_partial_files(dir: &Path) {
    let entries = std::fs::read_dir(dir).into_iter().flatten().flatten();
    for path in entries.map(|entry| entry.path()) {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let of_result = name.strip_prefix('.').and_then(|n| n.strip_suffix(PARTIAL));
        let ending = of_result.and_then(|name| name.rsplit_once('.'));
        if ending.is_none_or(|(_, ending)| !ENDINGS.contains(&ending)) {
            continue;
        }
        remove_abandoned(&path);
    }
}
