//! Analysis of the raceways of a case.

use cageless_io::case_file::CaseFile;
use cageless_report::DesignData;
use cageless_report::design_report::{design_data, rings_of};
use cageless_results::Record;
use cageless_study::design::{DesignResult, Judged, judged};
use cageless_study::rings::rings;
use pyo3::prelude::*;

use crate::background::Background;
use crate::errors::{of_study, stopped};

/// Verdict and page data of the raceways of a case, with a search if there is one.
pub fn analysed(
    py: Python<'_>,
    file: &CaseFile,
    search: Option<Record>,
) -> PyResult<(DesignResult, DesignData, Option<PyErr>)> {
    let background = Background::new(Some(1), None)?;
    let done = background.run(py, |progress| {
        let Judged {
            judgement,
            recommendation,
            snapshots,
        } = judged(file, progress)?;
        let stop = judgement.stopped.as_ref().map(stopped);
        let mut result = DesignResult::new(file.case(), &judgement, recommendation.as_ref());
        result.search = search;
        let mut data = design_data(file, &result, &snapshots);
        data.rings = rings(&rings_of(file, &result), progress)?;
        Ok((result, data, stop))
    })?;
    done.map_err(|error| of_study(&error))
}
