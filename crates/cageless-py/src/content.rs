//! What figures and page of a result are made of.

use std::sync::OnceLock;

use cageless_io::case_file::CaseFile;
use cageless_report::figures::named::{DESIGN, Named, RUN, SEARCH, SWEEP, TOLERANCE};
use cageless_report::figures::{named, sweep};
use cageless_report::tolerance::tolerance_page;
use cageless_report::{
    DesignData, Figure, RunData, SweepData, SweepOutput, design_page, from_json, run_from_json,
    run_json, run_page, sweep_page, to_json,
};
use cageless_results::{Record, SEARCH_SHAPE, Shape, TOLERANCE_SHAPE};
use pyo3::prelude::*;

use crate::analysis::analysed;
use crate::errors::{input, of_file, other};

/// Data of a page, or the page itself.
pub enum Content {
    Run(Box<Later<RunData>>),
    /// Kind and page of a static equilibrium, a drop or a comparison: figures are taken from the page.
    Page(&'static str, Later<String>),
    Design(Box<DesignData>),
    Search(Box<(CaseFile, Record)>),
    Tolerance(Box<Record>),
    Analysis(Box<SweepData>),
}

/// A value that is made when it is first needed.
pub struct Later<T> {
    value: OnceLock<T>,
    make: Box<dyn Fn() -> PyResult<T> + Send + Sync>,
}

impl<T> Later<T> {
    pub fn new(make: impl Fn() -> PyResult<T> + Send + Sync + 'static) -> Self {
        Self {
            value: OnceLock::new(),
            make: Box::new(make),
        }
    }

    pub fn get(&self) -> PyResult<&T> {
        if let Some(value) = self.value.get() {
            return Ok(value);
        }
        let value = (self.make)()?;
        Ok(self.value.get_or_init(|| value))
    }
}

fn foreign(what: &'static str) -> impl Fn(serde_json::Error) -> PyErr {
    move |error| input(format!("{what}: {error}"))
}

/// The record of a JSON text.
fn recorded(shape: &Shape, text: &str) -> Result<Record, String> {
    let values = serde_json::from_str(text).map_err(|e| e.to_string())?;
    Record::read(shape, &values)
}

impl Content {
    /// What [`Self::source`] wrote, of a result of this kind with these values.
    pub fn restored(kind: &str, values: &str, source: String) -> PyResult<Self> {
        Ok(match kind {
            "run" => {
                let values = values.to_owned();
                Self::Run(Box::new(Later::new(move || {
                    run_from_json(&source, &values)
                        .map_err(|e| input(format!("report.json of a saved run: {e}")))
                })))
            }
            "static" => Self::Page("static", Later::new(move || Ok(source.clone()))),
            "drop" => Self::Page("drop", Later::new(move || Ok(source.clone()))),
            "design" => Self::Design(from_json(&source).map_err(foreign("report of a design"))?),
            "search" => {
                let file = CaseFile::parse(&source, "case.toml", &[]).map_err(|e| of_file(&e))?;
                let data = recorded(&SEARCH_SHAPE, values)
                    .map_err(|e| input(format!("numbers of a search: {e}")))?;
                Self::Search(Box::new((file, data)))
            }
            "tolerance" => {
                let record = recorded(&TOLERANCE_SHAPE, values);
                Self::Tolerance(Box::new(
                    record.map_err(|e| input(format!("tolerance.json: {e}")))?,
                ))
            }
            "analysis" => Self::Analysis(from_json(values).map_err(foreign("report of a sweep"))?),
            _ => Self::Page("comparison", Later::new(move || Ok(source.clone()))),
        })
    }

    /// What pickles and folders keep beside the values.
    pub fn source(&self, values: &str) -> PyResult<String> {
        match self {
            Self::Run(data) => run_json(data.get()?, values).map_err(other),
            Self::Page(_, page) => page.get().cloned(),
            Self::Design(data) => to_json(data).map_err(other),
            Self::Search(search) => search.0.document().to_toml().map_err(|e| of_file(&e)),
            Self::Tolerance(_) | Self::Analysis(_) => Ok(String::new()),
        }
    }

    /// The page.
    pub fn page(&self, py: Python<'_>) -> PyResult<String> {
        Ok(match self {
            Self::Page(_, page) => page.get()?.clone(),
            Self::Run(data) => {
                let data = data.get()?;
                py.detach(|| run_page(data))
            }
            Self::Design(data) => py.detach(|| design_page(data)),
            // The case's own raceway is judged for it.
            Self::Search(search) => {
                let (_, data, _) = analysed(py, &search.0, Some(search.1.clone()))?;
                py.detach(|| design_page(&data))
            }
            Self::Tolerance(data) => py.detach(|| tolerance_page(data)),
            Self::Analysis(data) => py.detach(|| sweep_page(data)),
        })
    }

    /// A figure in the JSON of plotly; `output` is what it is about where there are several.
    pub fn figure(&self, py: Python<'_>, name: &str, output: Option<&str>) -> PyResult<String> {
        let none = || format!("this result has nothing to show as {name:?}");
        match self {
            Self::Run(data) => figure_of_run(py, data.get()?, name),
            Self::Page(kind, page) => {
                let found = named::in_page(page.get()?, kind, name);
                found.map(str::to_owned).ok_or_else(|| input(none()))
            }
            Self::Design(data) => drawn(py, &DESIGN, data, name, none),
            Self::Search(search) => drawn(py, &SEARCH, &search.1, name, none),
            Self::Tolerance(data) => drawn(py, &TOLERANCE, data, name, none),
            Self::Analysis(data) => match output {
                None => drawn(py, &SWEEP, data, name, || {
                    "nothing varies in this sweep".into()
                }),
                Some(output) => of_output(data, name, output),
            },
        }
    }
}

/// A figure of a run.
pub fn figure_of_run(py: Python<'_>, data: &RunData, name: &str) -> PyResult<String> {
    drawn(py, &RUN, data, name, || why_empty(data, name))
}

fn drawn<D: Sync>(
    py: Python<'_>,
    figures: &[Named<D>],
    data: &D,
    name: &str,
    none: impl FnOnce() -> String,
) -> PyResult<String> {
    let found = figures.iter().find(|figure| figure.name == name);
    let figure = found.and_then(|figure| py.detach(|| (figure.draw)(data)));
    figure
        .as_ref()
        .map(Figure::json)
        .ok_or_else(|| input(none()))
}

/// The reason of an empty figure of a run, with advice.
fn why_empty(data: &RunData, name: &str) -> String {
    let why = match name {
        "vibration" if data.vibration.is_none() => {
            "the case has no [housing], whose acceleration it shows: add Housing(mass_kg=…, \
             stiffness_n_m=…, damping_n_s_m=…)"
        }
        "collisions" => "no balls touched",
        _ => {
            "the run is too short after its transient: lengthen solver.duration_s or shorten \
             output.interval_us"
        }
    };
    format!("{name} has nothing to show: {why}")
}

/// A figure of one output of a sweep.
fn of_output(data: &SweepData, name: &str, output: &str) -> PyResult<String> {
    let mut outputs = data.outputs.iter();
    let found = outputs.find(|o| o.quantity.name == output);
    let found: &SweepOutput = found.ok_or_else(|| {
        let names = data.outputs.iter().map(|o| o.quantity.name.as_str());
        let names = names.collect::<Vec<_>>().join(", ");
        input(format!(
            "{output:?} is not an output that varies; there are {names}"
        ))
    })?;
    if name == "map" {
        let refused = || input(format!("{output} depends on fewer than two inputs"));
        let map = found.map.as_ref().ok_or_else(refused)?;
        return Ok(sweep::map(found, map, &data.provenance).json());
    }
    if found.effects.is_empty() {
        return Err(input(format!("no input explains {output}")));
    }
    Ok(sweep::effects(found, &data.provenance).json())
}
