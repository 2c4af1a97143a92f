//! Tables of shards or of a checkpoint into one file.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

use cageless_io::results::{Column, ResultError, Row, TableReader, TableWriter};

use super::checkpoint::{Stock, index};
use super::footer::Identity;
use crate::StudyError;

/// Joins the results of shards into the file that one run would have written, and says
/// how many variants it has.
///
/// # Errors
/// A file, or what is there in place of the result, is not of the same sweep, a variant is
/// missing or there twice, or files cannot be read or written.
pub fn merge(shards: &[PathBuf], result: &Path) -> Result<u64, StudyError> {
    let mut known: Option<(Identity, PathBuf)> = None;
    let mut columns = Vec::new();
    let mut stock = Stock::default();
    for path in shards {
        let table = TableReader::open(path)?;
        let identity = Identity::read(&table).ok_or_else(|| {
            StudyError::Input(format!("{} is not the result of a sweep", path.display()))
        })?;
        if let Some((first, of)) = &known {
            let remedy = format!("It does not go with {}", of.display());
            identity.must_be(&first.text(), &path.display().to_string(), &remedy)?;
        }
        stock.add(&table, "in another shard as well: give each shard once")?;
        columns = table.columns().to_vec();
        known.get_or_insert((identity, path.clone()));
    }
    let Some((identity, _)) = known else {
        return Err(StudyError::Input("there are no shards to merge".to_owned()));
    };
    let whole = 0..identity.variants;
    let missing: Vec<Range<u64>> = stock.done.gaps(&whole).collect();
    if !missing.is_empty() {
        return Err(StudyError::Input(format!(
            "{} of {} variants are missing: {}",
            missing.iter().map(|r| r.end - r.start).sum::<u64>(),
            identity.variants,
            listed(&missing)
        )));
    }
    // The same result may be there: it is made anew.
    identity.is_there(result, None, identity.variants)?;
    stock.tables.sort_unstable();
    let footer = identity.footer(&stock.isa, None);
    merge_sorted(result, &columns, &footer, &stock.tables, whole)?;
    Ok(identity.variants)
}

/// Indices in words: `3, 7 to 9`, cut off after a few.
fn listed(ranges: &[Range<u64>]) -> String {
    const SHOWN: usize = 8;
    let mut words: Vec<String> = ranges
        .iter()
        .take(SHOWN)
        .map(|r| match r.end - r.start {
            1 => r.start.to_string(),
            _ => format!("{} to {}", r.start, r.end - 1),
        })
        .collect();
    if ranges.len() > SHOWN {
        words.push(format!("and {} more ranges", ranges.len() - SHOWN));
    }
    words.join(", ")
}

/// Rows of an open table.
type Rows = Box<dyn Iterator<Item = Result<Row, ResultError>>>;

/// Writes `result` from `tables` (each with its first index, in order), which together
/// hold every variant of `range` once. Memory holds a group of rows of each table that is open, and
/// few are: each spans a short stretch of the sweep.
pub(crate) fn merge_sorted(
    result: &Path,
    columns: &[Column],
    footer: &[(&str, String)],
    tables: &[(u64, PathBuf)],
    range: Range<u64>,
) -> Result<(), StudyError> {
    let mut out = TableWriter::create(result, columns, footer)?;
    let mut waiting = tables.iter().peekable();
    // By the index of its next row.
    let mut open: BTreeMap<u64, (Row, Rows)> = BTreeMap::new();
    let proceed = |open: &mut BTreeMap<_, _>, mut rows: Rows| -> Result<(), ResultError> {
        if let Some(row) = rows.next().transpose()? {
            open.insert(index(&row), (row, rows));
        }
        Ok(())
    };
    for expected in range {
        while let Some((_, path)) = waiting.next_if(|(first, _)| *first <= expected) {
            let table = TableReader::open(path)?;
            if table.columns() != columns {
                let path = path.display();
                let message = format!("{path}: its columns are not those of the sweep");
                return Err(StudyError::Input(message));
            }
            proceed(&mut open, Box::new(table.into_rows()))?;
        }
        let Some((row, rows)) = open.remove(&expected) else {
            return Err(StudyError::Input(format!(
                "{}: variant {expected} is missing, or one is there twice",
                result.display()
            )));
        };
        out.push(row)?;
        proceed(&mut open, rows)?;
    }
    Ok(out.finish()?)
}

#[cfg(test)]
mod tests {
    use super::listed;

    #[test]
    fn ranges_are_told_in_words() {
        assert_eq!(listed(&[1..3, 6..8, 10..11]), "1 to 2, 6 to 7, 10");
    }
}
