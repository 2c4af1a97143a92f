//! Tables of a run as CSV.

use std::io::{BufWriter, Write};

use super::atomic_file::PartialFile;
use super::columns::{COLLISIONS, run_columns};
use super::error::ResultError;
use super::run_tables::RunTable;
use super::table::ColumnKind;

/// Writes `NAME.csv` beside the table `name` of a run, which is complete: names with units in the first
/// line, numbers with all of their digits.
///
/// # Errors
/// The table cannot be read, or the file cannot be written.
pub(super) fn write_csv(name: &str, table: &PartialFile) -> Result<PartialFile, ResultError> {
    let [balls, ring, rotor] = run_columns(true);
    let columns = match name {
        "balls" => balls,
        "ring" => ring,
        "rotor" => rotor,
        _ => COLLISIONS,
    };
    let path = table.path().with_extension("csv");
    let fail = |source| ResultError::out(&path, source);
    // By the same handle: a locked file cannot be opened again everywhere.
    let open = table.file().try_clone().map_err(fail)?;
    let table = RunTable::of(open, table.path(), columns)?;
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
    file.sync()?;
    Ok(file)
}
