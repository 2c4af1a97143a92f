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
//! Tables of a drop are in a folder for each bearing, `bearing-1` and so on.
//!
//! Balls count from 1. The footer of each table has `schema`, `version`, `isa`
//! (instruction set), `case` (JSON, as run), for each column `unit:<column>`, and `file_crc32`, the
//! CRC-32 of the whole file with these eight digits as zeros.
//!
//! A [`ResultFolder`] has one writer at a time. Tables grow under a hidden name and take their own when
//! all files of the result are complete, so that a file that is there can be read. `summary.json` comes last and
//! lists the checksums of its tables as `tables`: beside others it is refused. Memory does not grow with the run.

mod atomic_file;
mod checksum;
mod columns;
mod csv;
mod error;
mod folder;
mod reader;
mod run_tables;
mod table;
mod table_list;
mod values_csv;

use std::iter::{once, repeat_n};
use std::path::{Path, PathBuf};

use cageless::{Collision, RotorSnapshot, Snapshot};

pub use atomic_file::{PartialFile, write_atomically};
pub use columns::{COLLISIONS, run_columns};
pub use error::{ResultError, is_unusable};
pub use folder::{ResultFolder, bearing_folder};
pub use reader::TableReader;
pub use run_tables::read_run_table;
pub use table::{Column, ColumnKind, Row, TableWriter, VERSION};
pub use table_list::summary_of_tables;
pub use values_csv::values_csv;

use run_tables::GROUP_ROWS;

/// Version of the layout of results.
pub const SCHEMA: u64 = 1;

/// Numbers of a run or drop, the file that speaks for its tables.
pub const SUMMARY: &str = "summary.json";

/// The rotor file of a drop of one, which repeats it.
pub const ROTOR: &str = "rotor.toml";

/// Files that say something about the tables beside them.
const ABOUT_TABLES: [&str; 5] = [SUMMARY, "summary.csv", "report.html", "report.json", ROTOR];

/// Tables of a run, without their ending.
const TABLES: [&str; 4] = ["balls", "ring", "collisions", "rotor"];

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

/// Writes the tables of one run as it goes; [`ResultFolder::add_tables`] completes them. Without it they
/// leave nothing behind.
#[derive(Debug)]
pub struct RunWriter {
    dir: PathBuf,
    place: String,
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
    /// Opens the tables in the folder `place` within `dir`, which is created if missing. Tables of an
    /// earlier run stay until this one is finished.
    fn create(dir: &Path, place: &str, metadata: &Metadata<'_>) -> Result<Self, ResultError> {
        let dir = dir.join(place);
        std::fs::create_dir_all(&dir).map_err(|source| ResultError::out(&dir, source))?;
        let footer = [
            ("schema", SCHEMA.to_string()),
            ("version", VERSION.to_owned()),
            ("isa", metadata.isa.to_owned()),
            ("case", metadata.case.to_owned()),
        ];
        let [balls, ring, rotor_columns] = run_columns(metadata.in_space);
        let open = |name, columns| {
            TableWriter::in_groups(&table_path(&dir, name), columns, &footer, GROUP_ROWS)
        };
        Ok(Self {
            balls: open("balls", balls)?,
            ring: open("ring", ring)?,
            ring_columns: ring.len(),
            rotor_columns,
            collisions: open("collisions", COLLISIONS)?,
            rotor: None,
            footer: footer.to_vec(),
            place: place.to_owned(),
            dir,
        })
    }

    /// Folder of the tables within that of the result.
    fn place(&self) -> &str {
        &self.place
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
            none => none.insert(TableWriter::in_groups(
                &table_path(&self.dir, "rotor"),
                self.rotor_columns,
                &self.footer,
                GROUP_ROWS,
            )?),
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

    /// Completes the tables, which lack only their names then, by the names of [`TABLES`]; or the errors of all that
    /// cannot be written.
    fn close(self) -> Result<Vec<(&'static str, PartialFile)>, Vec<ResultError>> {
        let tables = [
            Some(self.balls),
            Some(self.ring),
            Some(self.collisions),
            self.rotor,
        ];
        let tables = TABLES.into_iter().zip(tables);
        let tables = tables.filter_map(|(name, table)| Some((name, table?)));
        all(tables.map(|(name, table)| Ok((name, table.close()?))))
    }
}

/// File of a table.
fn table_path(dir: &Path, name: &str) -> PathBuf {
    dir.join(name).with_extension("parquet")
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
