//! Tables of a run as CSV.

use std::io::{BufWriter, Write};
use std::path::Path;

use super::atomic_file::PartialFile;
use super::columns::{COLLISIONS, run_columns};
use super::error::ResultError;
use super::run_tables::RunTable;
use super::table::ColumnKind;

/// Writes `NAME.csv` beside each table of the run in `dir`: names with units in the first line,
/// numbers with all of their digits.
///
/// # Errors
/// A table cannot be read, or a file cannot be written.
pub fn write_csv(dir: &Path) -> Result<(), ResultError> {
    let [balls, ring, rotor] = run_columns(true);
    for (name, columns) in [
        ("balls", balls),
        ("ring", ring),
        ("rotor", rotor),
        ("collisions", COLLISIONS),
    ] {
        let table = dir.join(name).with_extension("parquet");
        if !table.exists() {
            continue;
        }
        let table = RunTable::open(&table, columns)?;
        let path = dir.join(name).with_extension("csv");
        let fail = |source| ResultError::out(&path, source);
        let mut file = BufWriter::new(PartialFile::create(&path)?);
        let names: Vec<&str> = table.columns.iter().map(|column| &*column.name).collect();
        writeln!(file, "{}", names.join(",")).map_err(fail)?;
        for group in table.groups() {
            let group = group?;
            for row in 0..group[0].len() {
                let cells: Vec<String> = (table.columns.iter().zip(&group))
                    .map(|(column, values)| match column.kind {
                        ColumnKind::Ordinal => format!("{:.0}", values[row]),
                        _ => format!("{:?}", values[row]),
                    })
                    .collect();
                writeln!(file, "{}", cells.join(",")).map_err(fail)?;
            }
        }
        let file = file.into_inner().map_err(|e| fail(e.into_error()))?;
        file.commit()?;
    }
    Ok(())
}
