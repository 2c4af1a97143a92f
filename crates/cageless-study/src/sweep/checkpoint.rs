//! The work folder beside a result that is not complete: what was computed so far.
//!
//! `FILE.parts/` holds `plan.toml` (whose rows these are), `lock` (held while somebody
//! computes) and tables of rows, each complete under its name or not there. No row is in
//! two of them.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

use cageless_io::open_locked;
use cageless_io::results::{Column, Row, TableReader, TableWriter, write_atomically};
use cageless_results::Cell;
use rangemap::RangeSet;

use super::footer::{Identity, add_isa};
use crate::StudyError;

/// The open work folder.
#[derive(Debug)]
pub(crate) struct Checkpoint {
    folder: PathBuf,
    /// Unlocked when it is dropped.
    _lock: File,
}

/// Contents of a work folder.
#[derive(Debug, Default)]
pub(crate) struct Stock {
    /// Indices of the variants.
    pub done: RangeSet<u64>,
    /// Each table with its first index.
    pub tables: Vec<(u64, PathBuf)>,
    pub isa: Vec<String>,
}

const LOCK: &str = "lock";
const PLAN: &str = "plan.toml";
/// Remedy of a table that is no part of the sweep.
const AGAIN: &str = "Remove it, and its variants are computed again";

impl Checkpoint {
    /// Opens or makes the work folder of `result`.
    pub(crate) fn open(result: &Path) -> Result<Self, StudyError> {
        let name = result.file_name().unwrap_or_default().to_string_lossy();
        let folder = result.with_file_name(format!("{name}.parts"));
        loop {
            std::fs::create_dir_all(&folder).map_err(|e| StudyError::out(&folder, e))?;
            let path = folder.join(LOCK);
            match open_locked(&path) {
                Ok(Some(_lock)) => return Ok(Self { folder, _lock }),
                Ok(None) => {
                    return Err(StudyError::Input(format!(
                        "{}: another process is computing this sweep; wait for it, or take \
                         another --out",
                        result.display()
                    )));
                }
                // Another process has just finished and taken the folder away.
                Err(e) if e.kind() == io::ErrorKind::NotFound => {}
                Err(e) => return Err(StudyError::out(&path, e)),
            }
        }
    }

    /// Claims the folder for a sweep, or refuses if it belongs to another.
    pub(crate) fn claim(&self, identity: &Identity) -> Result<(), StudyError> {
        let path = self.folder.join(PLAN);
        match std::fs::read_to_string(&path) {
            Ok(before) => identity.must_be(
                &before,
                &format!("what was computed in {}", self.folder.display()),
                "Take the plan back, choose another --out, or remove that folder",
            ),
            Err(e) if e.kind() == io::ErrorKind::NotFound => {
                Ok(write_atomically(&path, identity.text().as_bytes())?)
            }
            Err(e) => Err(StudyError::out(&path, e)),
        }
    }

    /// Checkpointed part of a sweep; half-written files of a killed process are removed, and tables
    /// of another sweep are refused.
    pub(crate) fn stock(&self, identity: &Identity) -> Result<Stock, StudyError> {
        let fail = |e| StudyError::out(&self.folder, e);
        let mut stock = Stock::default();
        for entry in std::fs::read_dir(&self.folder).map_err(fail)? {
            let path = entry.map_err(fail)?.path();
            match path.extension().and_then(|e| e.to_str()) {
                Some("partial") => std::fs::remove_file(&path).map_err(fail)?,
                Some("parquet") => {
                    let table = TableReader::open(&path)
                        .map_err(|e| StudyError::Input(format!("{e}. {AGAIN}")))?;
                    identity.must_own(&table, AGAIN)?;
                    stock.add(&table, "in another table as well; remove this one")?;
                }
                _ => {}
            }
        }
        stock.tables.sort_unstable();
        Ok(stock)
    }

    /// Writes rows, which need not be contiguous.
    pub(crate) fn keep(
        &self,
        columns: &[Column],
        footer: &[(&str, String)],
        mut rows: Vec<Row>,
    ) -> Result<(), StudyError> {
        rows.sort_unstable_by_key(index);
        let Some(first) = rows.first().map(index) else {
            return Ok(());
        };
        let path = self.folder.join(part_name(first));
        let mut table = TableWriter::create(&path, columns, footer)?;
        for row in rows {
            table.push(row)?;
        }
        Ok(table.finish()?)
    }

    /// Removes the folder, now that the result is complete.
    pub(crate) fn remove(self) -> Result<(), StudyError> {
        std::fs::remove_dir_all(&self.folder).map_err(|e| StudyError::out(&self.folder, e))
    }

    /// Removes the folder if there is nothing in it but the lock.
    pub(crate) fn remove_if_empty(self) {
        let others = |name: &std::ffi::OsStr| name != LOCK;
        let empty = std::fs::read_dir(&self.folder)
            .is_ok_and(|mut dir| !dir.any(|e| e.is_ok_and(|e| others(&e.file_name()))));
        if empty {
            // It is in nobody's way if it stays.
            let _ = std::fs::remove_dir_all(&self.folder);
        }
    }
}

impl Stock {
    /// Adds a table; `twice` is what is wrong with a variant that is there already.
    pub(crate) fn add(&mut self, table: &TableReader, twice: &str) -> Result<(), StudyError> {
        add_isa(&mut self.isa, table.footer("isa").unwrap_or_default());
        let mut first = u64::MAX;
        for row in table.rows_of(&[0]) {
            let index = index(&row?);
            if self.done.contains(&index) {
                let path = table.path().display();
                return Err(StudyError::Input(format!(
                    "{path}: variant {index} is {twice}"
                )));
            }
            first = first.min(index);
            self.done.insert(index..index + 1);
        }
        self.tables.push((first, table.path().to_owned()));
        Ok(())
    }
}

/// Name of a table whose first variant is this one.
pub(crate) fn part_name(first: u64) -> String {
    format!("rows-{first:010}.parquet")
}

/// Index of the variant of a row.
pub(crate) fn index(row: &Row) -> u64 {
    match row.first() {
        Some(Cell::Integer(index)) => u64::try_from(*index).unwrap_or(u64::MAX),
        _ => u64::MAX,
    }
}
