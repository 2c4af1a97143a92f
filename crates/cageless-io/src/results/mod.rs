//! Results of `run --out DIR`: three tables in Parquet beside a summary in JSON; and the
//! tables of sweeps ([`TableWriter`], [`TableReader`]).
//!
//! | file | a row per |
//! |---|---|
//! | `balls.parquet` | output time and ball; the last time is the end of the run |
//! | `ring.parquet` | output time |
//! | `rotor.parquet` | output time, of the drop of a rotor |
//! | `collisions.parquet` | collision |
//! | `summary.json` | (one document, `RunSummary` of `cageless-study`) |
//!
//! Balls count from 1. The footer of each table has `schema`, `version`, `isa`
//! (instruction set), `case` (JSON, as run), for each column `unit:<column>`, and `file_crc32`, the
//! CRC-32 of the whole file with these eight digits as zeros.
//!
//! Tables grow under a hidden name and take their own when all of them are complete, so
//! that a file that is there can be read, and a `summary.json` stands beside the tables of its
//! own run. Memory does not grow with the run.

mod atomic_file;
mod checksum;
mod columns;
mod csv;
mod error;
mod reader;
mod run_tables;
mod table;
mod values_csv;

use std::iter::{once, repeat_n};
use std::path::{Path, PathBuf};

use cageless::{Collision, RotorSnapshot, Snapshot};

pub use atomic_file::{PartialFile, write_atomically, write_together};
pub use columns::{COLLISIONS, run_columns};
pub use csv::write_csv;
pub use error::{ResultError, is_unusable};
pub use reader::TableReader;
pub use run_tables::read_run_table;
pub use table::{Column, ColumnKind, Row, TableWriter, VERSION};
pub use values_csv::values_csv;

use run_tables::GROUP_ROWS;

/// Version of the layout of results.
pub const SCHEMA: u64 = 1;

/// Files that say something about the tables beside them, written after these.
pub const ABOUT_TABLES: [&str; 7] = [
    "summary.json",
    "report.html",
    "report.json",
    "balls.csv",
    "ring.csv",
    "rotor.csv",
    "collisions.csv",
];

/// Metadata of a run in the footer of every table.
#[derive(Debug, Clone, Copy)]
pub struct Metadata<'a> {
    /// Instruction set that the run used.
    pub isa: &'a str,
    /// The case as run, JSON.
    pub case: &'a str,
    /// Whether its balls move in space.
    pub in_space: bool,
}

/// A row of [`COLLISIONS`].
pub fn collision_values(c: &Collision) -> [f64; COLLISIONS.len()] {
    let number = |index: usize| (index + 1) as f64;
    [
        c.start_s,
        c.duration_s,
        number(c.ball),
        number(c.next_ball),
        c.angle_rad,
        c.approach_speed_m_s,
        c.peak_force_n,
        c.impulse_n_s,
    ]
}

/// Writes the tables of one run as it goes. Without [`RunWriter::finish`] it leaves
/// nothing behind.
#[derive(Debug)]
pub struct RunWriter {
    dir: PathBuf,
    balls: TableWriter,
    ring: TableWriter,
    ring_columns: usize,
    rotor_columns: &'static [Column],
    collisions: TableWriter,
    /// Opened with the first snapshot of a rotor.
    rotor: Option<TableWriter>,
    footer: Vec<(&'static str, String)>,
}

impl RunWriter {
    /// Opens the tables in `dir`, which is created if missing. Tables of an earlier
    /// run stay until this one is finished.
    ///
    /// # Errors
    /// If `dir` cannot be created or written to, or another run is writing there.
    pub fn create(dir: &Path, metadata: &Metadata<'_>) -> Result<Self, ResultError> {
        std::fs::create_dir_all(dir).map_err(|source| ResultError::out(dir, source))?;
        let footer = [
            ("schema", SCHEMA.to_string()),
            ("version", VERSION.to_owned()),
            ("isa", metadata.isa.to_owned()),
            ("case", metadata.case.to_owned()),
        ];
        let open = |name: &str, columns| {
            TableWriter::in_groups(&dir.join(name), columns, &footer, GROUP_ROWS)
        };
        let [balls, ring, rotor_columns] = run_columns(metadata.in_space);
        Ok(Self {
            dir: dir.to_owned(),
            balls: open("balls.parquet", balls)?,
            ring: open("ring.parquet", ring)?,
            ring_columns: ring.len(),
            rotor_columns,
            collisions: open("collisions.parquet", COLLISIONS)?,
            rotor: None,
            footer: footer.to_vec(),
        })
    }

    /// Adds the rows of one output time.
    ///
    /// # Errors
    /// If writing fails, or the arrays of the snapshot are not of one length.
    pub fn snapshot(&mut self, s: &Snapshot) -> Result<(), ResultError> {
        let n = s.balls();
        let arrays = s.arrays();
        if arrays.iter().any(|a| a.len() != n) {
            return Err(ResultError::Ragged { time_s: s.time_s });
        }
        self.balls.numbers(0, repeat_n(s.time_s, n));
        self.balls.numbers(1, (1..=n).map(|number| number as f64));
        for (k, array) in arrays.into_iter().enumerate() {
            self.balls.numbers(k + 2, array.iter().copied());
        }
        self.balls.added(n)?;

        let ring = once(s.time_s).chain(s.ring.values());
        self.ring.row(ring.take(self.ring_columns))?;
        s.rotor.map_or(Ok(()), |rotor| self.rotor(s.time_s, &rotor))
    }

    fn rotor(&mut self, time_s: f64, rotor: &RotorSnapshot) -> Result<(), ResultError> {
        let table = match &mut self.rotor {
            Some(table) => table,
            none => {
                let path = self.dir.join("rotor.parquet");
                none.insert(TableWriter::in_groups(
                    &path,
                    self.rotor_columns,
                    &self.footer,
                    GROUP_ROWS,
                )?)
            }
        };
        let values = once(time_s).chain(rotor.values());
        table.row(values.take(self.rotor_columns.len()))
    }

    /// Adds a collision.
    ///
    /// # Errors
    /// If writing fails.
    pub fn collision(&mut self, c: &Collision) -> Result<(), ResultError> {
        self.collisions.row(collision_values(c))
    }

    /// Completes the tables and gives them their names, after a run that stopped
    /// early as well: they hold all rows up to then. Nothing takes a name before all
    /// tables are complete on the disk; then [`ABOUT_TABLES`] of an earlier run go first.
    ///
    /// # Errors
    /// If writing fails: the folder is then as it was, but for its hidden files. If a
    /// complete table cannot take its name, those that could have theirs, and nothing in
    /// the folder claims that they are one run's. All tables that failed are named.
    pub fn finish(self) -> Result<(), ResultError> {
        let tables = [self.balls, self.ring, self.collisions];
        let closed = tables.into_iter().chain(self.rotor).map(TableWriter::close);
        let dir = &self.dir;
        let tables = all(closed).map_err(|errors| ResultError::Run {
            errors,
            left: format!("{} is as it was", dir.display()),
        })?;
        for name in ABOUT_TABLES {
            let path = dir.join(name);
            match std::fs::remove_file(&path) {
                Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
                    return Err(ResultError::out(&path, error));
                }
                _ => {}
            }
        }
        let renamed = all(tables.into_iter().map(PartialFile::rename));
        renamed.map(drop).map_err(|errors| {
            let left = format!("the tables in {} are not of one run", dir.display());
            ResultError::Run { errors, left }
        })
    }
}

/// Results of all items, or all their errors.
fn all<T>(
    results: impl IntoIterator<Item = Result<T, ResultError>>,
) -> Result<Vec<T>, Vec<ResultError>> {
    let (mut good, mut bad) = (Vec::new(), Vec::new());
    for result in results {
        match result {
            Ok(value) => good.push(value),
            Err(error) => bad.push(error),
        }
    }
    if bad.is_empty() { Ok(good) } else { Err(bad) }
}
