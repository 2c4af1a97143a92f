//! The verdict on a raceway, and the search for the best one.

use cageless_io::case_file::CaseFile;
use cageless_paper::structures_of;
use cageless_report::design_report::{design_data, rings_of};
use cageless_report::figures::{design, search, shape};
use cageless_report::{DesignData, Figure, SearchData, design_page, from_json, to_json};
use cageless_study::design::{DesignResult, Judged, judged};
use cageless_study::rings::rings;
use cageless_study::{Progress, StudyError};
use pyo3::prelude::*;

use crate::background::Background;
use crate::case_file::CaseFile as CaseHandle;
use crate::errors::{input, of_study, other, stopped};

/// Verdict and design results of the raceways of a case.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct Design {
    /// `design --json`.
    numbers: String,
    data: DesignData,
}

/// Judges a case; the exception if a run that it rests on stopped.
pub fn judge(py: Python<'_>, file: &CaseFile) -> PyResult<(Design, Option<PyErr>)> {
    let background = Background::new(Some(1), None)?;
    let found = background.run(py, |progress| analyse(file, None, progress))?;
    let (result, data, stop) = found.map_err(|error| of_study(&error))?;
    let numbers = serde_json::to_string(&result).map_err(other)?;
    Ok((Design { numbers, data }, stop))
}

fn analyse(
    file: &CaseFile,
    search: Option<SearchData>,
    progress: &dyn Progress,
) -> Result<(DesignResult, DesignData, Option<PyErr>), StudyError> {
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
}

#[pymethods]
impl Design {
    /// A design from its `design.json` and `report.json`.
    #[staticmethod]
    fn restored(numbers: String, report: &str) -> PyResult<Self> {
        let data = from_json(report).map_err(|e| input(format!("report of a design: {e}")))?;
        Ok(Self { numbers, data })
    }

    /// `design --json`.
    fn numbers(&self) -> &str {
        &self.numbers
    }

    /// `report.json`.
    fn report(&self) -> PyResult<String> {
        to_json(&self.data).map_err(other)
    }

    /// A figure in the JSON of plotly.
    fn figure(&self, py: Python<'_>, name: &str) -> PyResult<String> {
        let data = &self.data;
        let figure = py.detach(|| match name {
            "curve" => data.curve.as_ref().map(design::curve),
            "contact_track" => data.contact_track.as_ref().map(shape::contact_track),
            "surface" => data.surface.as_ref().map(shape::surface),
            _ => None,
        });
        match figure {
            Some(figure) => Ok(figure.json()),
            None => Err(input(format!("this case has nothing to show as {name:?}"))),
        }
    }

    /// `report.html`.
    fn page(&self, py: Python<'_>) -> String {
        py.detach(|| design_page(&self.data))
    }
}

/// Result of a search.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct Search {
    file: CaseFile,
    data: SearchData,
    refusal: Option<String>,
}

impl Search {
    /// Runs a search, or resumes the one in the folder.
    pub fn find(
        py: Python<'_>,
        file: &CaseFile,
        folder: Option<std::path::PathBuf>,
        background: Background,
    ) -> PyResult<Self> {
        let found = background.run(py, |progress| {
            cageless_study::search::run(file, folder.as_deref(), progress)
        })?;
        let (found, mut data) = found.map_err(|error| of_study(&error))?;
        data.paper = structures_of(&file.case().bearing).map_err(other)?;
        if let Some(folder) = &folder {
            cageless_study::search::forget(folder);
        }
        Ok(Self {
            file: file.clone(),
            refusal: cageless_study::search::refusal(file, &found),
            data,
        })
    }
}

/// A figure of a search.
type Make = fn(&SearchData) -> Figure;

const FIGURES: [(&str, Make); 3] = [
    ("verdicts", search::verdicts),
    ("critical_gaps", search::critical_gaps),
    ("trade_offs", search::trade_offs),
];

#[pymethods]
impl Search {
    /// A search from its numbers, of this case.
    #[staticmethod]
    fn restored(file: &CaseHandle, numbers: &str, refusal: Option<String>) -> PyResult<Self> {
        let data = from_json(numbers).map_err(|e| input(format!("numbers of a search: {e}")))?;
        Ok(Self {
            file: file.file.clone(),
            data,
            refusal,
        })
    }

    /// `search` of `design --search --json`.
    fn numbers(&self) -> PyResult<String> {
        serde_json::to_string(&self.data).map_err(other)
    }

    /// Reason without a recommendation: the message of the command.
    fn refusal(&self) -> Option<String> {
        self.refusal.clone()
    }

    /// A figure in the JSON of plotly.
    fn figure(&self, py: Python<'_>, name: &str) -> PyResult<String> {
        let Some((_, make)) = FIGURES.iter().find(|(n, _)| *n == name) else {
            return Err(input(format!("there is no figure {name:?}")));
        };
        if name == "trade_offs" && self.data.front.is_empty() {
            return Err(input("this search has nothing to show as \"trade_offs\""));
        }
        Ok(py.detach(|| make(&self.data)).json())
    }

    /// `report.html`, for which the case's own raceway is judged.
    fn page(&self, py: Python<'_>) -> PyResult<String> {
        let background = Background::new(Some(1), None)?;
        let search = Some(self.data.clone());
        let found = background.run(py, |progress| {
            let (_, data, _) = analyse(&self.file, search, progress)?;
            Ok(design_page(&data))
        })?;
        found.map_err(|error: StudyError| of_study(&error))
    }
}
