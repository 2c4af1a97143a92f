//! A bearing within its tolerances.

use cageless_io::case_file::CaseFile;
use cageless_report::tolerance::{ToleranceData, influence_figure, sample_figure, tolerance_page};
use cageless_report::{from_json, to_json};
use cageless_study::tolerance::{Request, tolerance};
use pyo3::prelude::*;

use crate::background::Background;
use crate::errors::{input, of_study, other};

/// Tolerance analysis of a case.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct Tolerance {
    data: ToleranceData,
}

impl Tolerance {
    pub fn study(
        py: Python<'_>,
        file: &CaseFile,
        request: &Request,
        background: Background,
    ) -> PyResult<Self> {
        let done = background.run(py, |progress| {
            tolerance(file.case(), "case", request, progress)
        })?;
        let data = done.map_err(|error| of_study(&error))?;
        Ok(Self { data })
    }
}

#[pymethods]
impl Tolerance {
    /// An analysis from its `tolerance.json`.
    #[staticmethod]
    fn restored(numbers: &str) -> PyResult<Self> {
        let data = from_json(numbers).map_err(|e| input(format!("tolerance.json: {e}")))?;
        Ok(Self { data })
    }

    /// `tolerance --json`.
    fn numbers(&self) -> PyResult<String> {
        to_json(&self.data).map_err(other)
    }

    /// A figure in the JSON of plotly.
    fn figure(&self, py: Python<'_>, name: &str) -> PyResult<String> {
        let data = &self.data;
        let figure = py.detach(|| match name {
            "influences" => Some(influence_figure(data)),
            "samples" => data.samples.as_ref().map(|s| sample_figure(data, s)),
            _ => None,
        });
        match figure {
            Some(figure) => Ok(figure.json()),
            None => Err(input(format!("there is nothing to show as {name:?}"))),
        }
    }

    /// `report.html`.
    fn page(&self, py: Python<'_>) -> String {
        py.detach(|| tolerance_page(&self.data))
    }
}
