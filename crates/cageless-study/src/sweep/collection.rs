//! A sweep into a file, whoever computes its rows: resumed where it was left, complete at
//! its end.

use std::ops::Range;
use std::path::{Path, PathBuf};

use cageless::dynamics::InstructionSet;
use cageless_io::results::{Column, Row, TableReader, TableWriter, write_atomically};

use super::checkpoint::{Checkpoint, part_name};
use super::evaluate::{Cancellation, Sweep};
use super::footer::Identity;
use super::merge::merge_sorted;
use super::shard::Shard;
use crate::StudyError;

/// A result in the making. [`super::run`] computes on the threads of this machine; a
/// scheduler hands out [`Collection::missing`], lets [`write_part`] compute each range
/// anywhere, and brings the files back.
#[derive(Debug)]
pub struct Collection {
    columns: Vec<Column>,
    identity: Identity,
    result: PathBuf,
    shard: Option<Shard>,
    range: Range<u64>,
    /// `None` once the result is there.
    checkpoint: Option<Checkpoint>,
}

impl Collection {
    /// Opens the result, and takes up what is there of it.
    ///
    /// # Errors
    /// The result or its work folder belongs to another plan or is in use, or cannot be
    /// written to.
    pub fn open(sweep: &Sweep, result: &Path, shard: Option<Shard>) -> Result<Self, StudyError> {
        let whole = 0..sweep.variants();
        let range = shard.map_or(whole, |shard| shard.range(sweep.variants()));
        if let Some(folder) = result.parent() {
            std::fs::create_dir_all(folder).map_err(|e| StudyError::out(folder, e))?;
        }
        let checkpoint = Checkpoint::open(result)?;
        let mut collection = Self {
            columns: sweep.columns().to_vec(),
            identity: Identity::new(sweep),
            result: result.to_owned(),
            shard,
            range,
            checkpoint: None,
        };
        match collection.prepare(&checkpoint) {
            Err(error) => {
                checkpoint.remove_if_empty();
                return Err(error);
            }
            Ok(true) => checkpoint.remove()?,
            Ok(false) => collection.checkpoint = Some(checkpoint),
        }
        Ok(collection)
    }

    /// Number of variants of the result.
    pub fn total(&self) -> u64 {
        self.range.end - self.range.start
    }

    /// Variants that nobody has computed, in order.
    ///
    /// # Errors
    /// If what is there cannot be read.
    pub fn missing(&self) -> Result<Vec<Range<u64>>, StudyError> {
        match &self.checkpoint {
            Some(checkpoint) => {
                let stock = checkpoint.stock(&self.identity)?;
                Ok(stock.done.gaps(&self.range).collect())
            }
            None => Ok(Vec::new()),
        }
    }

    /// The file for a range of [`Self::missing`], in a folder that goes when the result
    /// is complete: [`write_part`] may write it.
    pub fn part(&self, first: u64) -> PathBuf {
        let name = self.result.file_name().unwrap_or_default();
        let folder = format!("{}.parts", name.to_string_lossy());
        self.result.with_file_name(folder).join(part_name(first))
    }

    /// Takes a file that [`write_part`] has written elsewhere.
    ///
    /// # Errors
    /// It is not of this sweep, or cannot be written.
    pub fn add(&self, first: u64, part: &[u8]) -> Result<(), StudyError> {
        if self.checkpoint.is_none() {
            return Ok(());
        }
        let path = self.part(first);
        write_atomically(&path, part)?;
        let checked = self.check(&path);
        if checked.is_err() {
            // What is foreign must not stay.
            let _ = std::fs::remove_file(&path);
        }
        checked
    }

    fn check(&self, path: &Path) -> Result<(), StudyError> {
        let remedy = "Every computer must have the same version of Cageless";
        self.identity.must_own(&TableReader::open(path)?, remedy)
    }

    /// Keeps rows, which need not be contiguous.
    pub(crate) fn keep(&self, rows: Vec<Row>) -> Result<(), StudyError> {
        let Some(checkpoint) = &self.checkpoint else {
            return Ok(());
        };
        let isa = [InstructionSet::chosen().name().to_owned()];
        let footer = self.identity.footer(&isa, self.shard);
        checkpoint.keep(&self.columns, &footer, rows)
    }

    /// Makes the result if nothing is missing; says whether it did.
    ///
    /// # Errors
    /// If files cannot be read or written.
    pub fn finish(self) -> Result<bool, StudyError> {
        let Some(checkpoint) = self.checkpoint else {
            return Ok(true);
        };
        let stock = checkpoint.stock(&self.identity)?;
        if stock.done.gaps(&self.range).next().is_some() {
            return Ok(false);
        }
        let footer = self.identity.footer(&stock.isa, self.shard);
        let columns = &self.columns;
        merge_sorted(&self.result, columns, &footer, &stock.tables, self.range)?;
        checkpoint.remove()?;
        Ok(true)
    }

    /// Claims the work folder; says whether the result is there already.
    fn prepare(&self, checkpoint: &Checkpoint) -> Result<bool, StudyError> {
        if self
            .identity
            .is_there(&self.result, self.shard, self.total())?
        {
            return Ok(true);
        }
        checkpoint.claim(&self.identity)?;
        Ok(false)
    }
}

/// Computes a range of variants into a file, on this thread; returns false if cancelled.
///
/// # Errors
/// If the file cannot be written.
pub fn write_part(
    sweep: &Sweep,
    range: Range<u64>,
    path: &Path,
    stop: Cancellation<'_>,
) -> Result<bool, StudyError> {
    let Some(rows) = sweep.evaluate(range, stop) else {
        return Ok(false);
    };
    let isa = [InstructionSet::chosen().name().to_owned()];
    let footer = Identity::new(sweep).footer(&isa, None);
    let mut table = TableWriter::create(path, sweep.columns(), &footer)?;
    for row in rows {
        table.push(row)?;
    }
    table.finish()?;
    Ok(true)
}
