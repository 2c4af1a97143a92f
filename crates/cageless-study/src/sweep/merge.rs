//! Shards into one file.

use std::path::{Path, PathBuf};

use cageless_io::results::TableReader;

use super::checkpoint::Stock;
use super::error::SweepError;
use super::footer::Identity;
use super::index_set::listed;
use super::merge_sorted::merge_sorted;

/// Joins the results of shards into the file that one run would have written, and says
/// how many variants it has.
///
/// # Errors
/// A file, or what is there in place of the result, is not of the same sweep, a variant is
/// missing or there twice, or files cannot be read or written.
pub fn merge(shards: &[PathBuf], result: &Path) -> Result<u64, SweepError> {
    let mut known: Option<(Identity, PathBuf)> = None;
    let mut columns = Vec::new();
    let mut stock = Stock::default();
    for path in shards {
        let table = TableReader::open(path)?;
        let identity = Identity::read(&table).ok_or_else(|| {
            SweepError::Input(format!("{} is not the result of a sweep", path.display()))
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
        return Err(SweepError::Input("there are no shards to merge".to_owned()));
    };
    let missing = stock.done.missing(0..identity.variants);
    if !missing.is_empty() {
        return Err(SweepError::Input(format!(
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
    merge_sorted(
        result,
        &columns,
        &footer,
        &stock.tables,
        0..identity.variants,
    )?;
    Ok(identity.variants)
}
