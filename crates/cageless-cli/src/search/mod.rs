//! `design --search`: the library's search on all threads, with progress and a journal.

mod data;
mod findings;
mod workshop;

use std::path::Path;

use cageless::design::search::{Found, SearchError, search};
use cageless_io::case_file::CaseFile;
use cageless_report::SearchData;

use crate::failure::Failure;
use crate::progress::StopFlag;
use workshop::Workshop;

pub use findings::why_none;

/// Searches, or goes on with a search that was killed.
pub fn run(
    file: &CaseFile,
    out: Option<&Path>,
    stop: &StopFlag,
) -> Result<(Found, SearchData), Failure> {
    let mut workshop = Workshop::new(file, out, stop)?;
    let found = search(file.case(), file.search(), &mut |stage, jobs| {
        workshop.execute(stage, jobs)
    });
    workshop.check()?;
    let found = match found {
        Ok(found) => found,
        Err(SearchError::Impossible(message)) => {
            return Err(Failure::Input(format!(
                "no raceway can be recommended: {message}"
            )));
        }
        Err(SearchError::Case(error)) => return Err(error.into()),
        Err(SearchError::Interrupted(_)) => {
            return Err(Failure::Interrupted(match out {
                Some(dir) => format!(
                    "interrupted: the same command goes on from what is in {}",
                    dir.display()
                ),
                None => "interrupted: with --out DIR a search can be continued".to_owned(),
            }));
        }
    };
    workshop.finish();
    let data = data::search_data(file, &found)?;
    Ok((found, data))
}
