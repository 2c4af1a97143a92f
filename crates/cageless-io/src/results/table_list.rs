//! The list of tables in `summary.json`: their checksums, which say whether a table beside it is of the same
//! computation.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::Value;

use super::error::ResultError;
use super::reader::checksum;
use super::{SUMMARY, TABLES};

/// Key of the list, in the file alone.
const LIST: &str = "tables";

/// The JSON of a summary with the checksum of each table as its last entry.
pub(super) fn with_tables(summary: &str, tables: &[(String, String)]) -> String {
    let inner = summary.trim_end();
    let inner = inner.strip_suffix('}').unwrap_or(inner).trim_end();
    let lines = tables.iter();
    let lines = lines.map(|(name, digits)| format!("    \"{name}\": \"{digits}\""));
    let lines: Vec<_> = lines.collect();
    format!("{inner}{}{}\n  }}\n}}\n", opening(), lines.join(",\n"))
}

fn opening() -> String {
    format!(",\n  \"{LIST}\": {{\n")
}

/// The text of `summary.json` in `dir` without the list of tables, once the tables in the folders
/// `places` within are those that it lists.
///
/// # Errors
/// A table is missing, cannot be read or is of another computation.
pub fn summary_of_tables(dir: &Path, text: &str, places: &[String]) -> Result<String, ResultError> {
    let summary = dir.join(SUMMARY);
    let unreadable = |why: &str| ResultError::unreadable(&summary, why);
    let mut values: Value =
        serde_json::from_str(text).map_err(|error| unreadable(&error.to_string()))?;
    let list = values
        .as_object_mut()
        .and_then(|values| values.remove(LIST));
    let list: BTreeMap<String, String> = (list.and_then(|list| serde_json::from_value(list).ok()))
        .ok_or_else(|| {
            unreadable(
                "it lacks `tables`, the checksums of balls.parquet and the other tables: it is not of a \
                 run or drop with --out, or of an earlier version, and must be computed again",
            )
        })?;
    let here = places.iter().flat_map(|place| {
        TABLES.map(|name| match place.is_empty() {
            true => format!("{name}.parquet"),
            false => format!("{place}/{name}.parquet"),
        })
    });
    for name in here {
        let (path, listed) = (dir.join(&name), list.get(&name));
        if listed.is_none() && !path.exists() {
            continue;
        }
        let found = checksum(&path)?;
        if listed != Some(&found) {
            let listed = listed.map_or("no such table", String::as_str);
            let why = format!("which lists {listed} where its checksum is {found}");
            return Err(ResultError::Foreign { path, summary, why });
        }
    }
    // As it was written, to the byte, unless somebody has written it anew.
    let cut = text
        .rsplit_once(&opening())
        .map(|(inner, _)| format!("{inner}\n}}\n"));
    let same = |cut: &String| serde_json::from_str::<Value>(cut).is_ok_and(|cut| cut == values);
    Ok(cut.filter(same).unwrap_or_else(|| values.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_comes_and_goes_to_the_byte() {
        let dir = tempfile::tempdir().unwrap();
        let summary = "{\n  \"a\": 1.50,\n  \"b\": \"}\"\n}\n";
        let text = with_tables(summary, &[]);
        assert_eq!(
            serde_json::from_str::<Value>(&text).unwrap()[LIST],
            serde_json::json!({})
        );
        let places = [String::new()];
        assert_eq!(
            summary_of_tables(dir.path(), &text, &places).unwrap(),
            summary
        );
        let compact = serde_json::from_str::<Value>(&text).unwrap().to_string();
        let found = summary_of_tables(dir.path(), &compact, &places).unwrap();
        assert_eq!(found, "{\"a\":1.5,\"b\":\"}\"}");
        assert!(summary_of_tables(dir.path(), summary, &places).is_err());
    }
}
