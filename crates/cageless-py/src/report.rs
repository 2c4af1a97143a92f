//! The analysis of a finished sweep.

use std::path::PathBuf;

use cageless_report::figures::sweep;
use cageless_report::{SweepData, SweepOutput, from_json, sweep_page, to_json};
use cageless_results::Aim;
use cageless_study::sweep::analysis::Goal;
use pyo3::prelude::*;

use crate::errors::{input, of_sweep, other};

/// Report of a finished sweep.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct Report {
    data: SweepData,
}

/// Analyses a result.
#[pyfunction]
pub fn analyse(
    py: Python<'_>,
    path: PathBuf,
    low: Vec<String>,
    high: Vec<String>,
) -> PyResult<Report> {
    let goal = |aim| move |column| Goal { column, aim };
    let low = low.into_iter().map(goal(Aim::Low));
    let goals: Vec<Goal> = low.chain(high.into_iter().map(goal(Aim::High))).collect();
    let data = py.detach(|| cageless_study::sweep::analysis::analyse(&path, &goals));
    let data = data.map_err(|e| of_sweep(&e))?;
    Ok(Report { data })
}

#[pymethods]
impl Report {
    /// A report from its `report.json`.
    #[staticmethod]
    fn restored(numbers: &str) -> PyResult<Self> {
        let data = from_json(numbers).map_err(|e| input(format!("report of a sweep: {e}")))?;
        Ok(Self { data })
    }

    /// `report.json`.
    fn numbers(&self) -> PyResult<String> {
        to_json(&self.data).map_err(other)
    }

    /// `report.html`.
    fn page(&self, py: Python<'_>) -> String {
        py.detach(|| sweep_page(&self.data))
    }

    /// Figure of the sensitivity, in the JSON of plotly.
    fn shares(&self) -> PyResult<String> {
        if self.data.outputs.is_empty() || self.data.inputs.is_empty() {
            return Err(input("nothing varies in this sweep"));
        }
        Ok(sweep::shares(&self.data).json())
    }

    /// An output over the inputs that explain most of it.
    fn effects(&self, column: &str) -> PyResult<String> {
        let output = self.output(column)?;
        if output.effects.is_empty() {
            return Err(input(format!("no input explains {column}")));
        }
        Ok(sweep::effects(output, &self.data.provenance).json())
    }

    /// An output over the two inputs that explain most of it.
    fn map(&self, column: &str) -> PyResult<String> {
        let output = self.output(column)?;
        let Some(map) = &output.map else {
            return Err(input(format!("{column} depends on fewer than two inputs")));
        };
        Ok(sweep::map(output, map, &self.data.provenance).json())
    }
}

impl Report {
    fn output(&self, column: &str) -> PyResult<&SweepOutput> {
        let mut outputs = self.data.outputs.iter();
        outputs.find(|o| o.quantity.name == column).ok_or_else(|| {
            let names = self.data.outputs.iter().map(|o| o.quantity.name.as_str());
            let names: Vec<_> = names.collect();
            input(format!(
                "{column:?} is not an output that varies; there are {}",
                names.join(", ")
            ))
        })
    }
}
