//! The folder of a finished run, read back.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use cageless_io::io_error_message;
use cageless_io::results::{SUMMARY, summary_of_tables};
use cageless_report::{RunData, run_from_json};
use serde_json::{Map, Value};

use crate::driver::PAGE_DATA;
use crate::failure::Failure;

/// Larger files are not of a run: histories are decimated.
const BYTES_MAX: u64 = 256 << 20;

/// A finished run.
pub struct FinishedRun {
    /// Data of its page.
    pub data: RunData,
    /// Text of its `summary.json`.
    pub summary: Map<String, Value>,
}

impl FinishedRun {
    /// Reads the folder of a run.
    pub fn read(dir: &Path) -> Result<Self, Failure> {
        let (page_data, summary) = (text(dir, PAGE_DATA)?, text(dir, SUMMARY)?);
        let summary = summary_of_tables(dir, &summary, &[String::new()])?;
        let refused = |name: &str, problem: String| {
            Failure::Input(format!("{}: {problem}", dir.join(name).display()))
        };
        Ok(Self {
            data: run_from_json(&page_data, &summary)
                .map_err(|error| refused(PAGE_DATA, error.to_string()))?,
            summary: serde_json::from_str(&summary)
                .map_err(|error| refused(SUMMARY, format!("is not of a run: {error}")))?,
        })
    }
}

fn text(dir: &Path, name: &str) -> Result<String, Failure> {
    let path = dir.join(name);
    let refused = |problem: String| Failure::Input(format!("{}: {problem}", path.display()));
    let file = File::open(&path).map_err(|error| {
        refused(format!(
            "{}; the folder of a finished run has it (cageless run CASE --out DIR)",
            io_error_message(&error)
        ))
    })?;
    let mut text = String::new();
    (file.take(BYTES_MAX + 1).read_to_string(&mut text))
        .map_err(|error| refused(io_error_message(&error)))?;
    if text.len() as u64 > BYTES_MAX {
        let most = BYTES_MAX >> 20;
        return Err(refused(format!("is larger than {most} MiB: not of a run")));
    }
    Ok(text)
}
