//! The result of a computation: its values as the command writes them, tables, figures, page, files.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{LazyLock, OnceLock};

use cageless_io::case_file::CaseFile;
use cageless_io::declared;
use cageless_io::results::{ResultFolder, values_csv, write_atomically};
use cageless_report::figures::sweep;
use cageless_report::figures::{
    DESIGN, Named, RUN, SEARCH, SWEEP, TOLERANCE, in_page, of_kind as figures_of_kind,
};
use cageless_report::tolerance::tolerance_page;
use cageless_report::{
    DesignData, Figure, RunData, SweepData, SweepOutput, design_page, from_json, run_from_json,
    run_json, run_page, static_page, sweep_page,
};
use cageless_results::{
    Kind, Quantity, Record, SEARCH_SHAPE, Shape, TOLERANCE_SHAPE, equilibrium_record, of_kind,
};
use cageless_study::tolerance::ToleranceResult;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use serde::de::DeserializeOwned;

use crate::errors::{Error, Found, input, other};
use crate::tables::{Recorded, Tables};

/// Page in the folder of a result.
pub const PAGE: &str = "report.html";
/// Data of the page.
pub const PAGE_DATA: &str = "report.json";

/// Files in the folder of a result by name, beside its values and tables.
pub type Files = BTreeMap<String, String>;

/// A value that is made when it is first needed.
pub type Later<T> = Box<LazyLock<Found<T>, Box<dyn FnOnce() -> Found<T> + Send>>>;

pub fn files(list: impl IntoIterator<Item = (&'static str, String)>) -> Files {
    let owned = |(name, text): (&str, String)| (name.to_owned(), text);
    list.into_iter().map(owned).collect()
}

/// Source of the figures and files of a result.
pub enum Content {
    /// Data of the page of a run.
    Run(Later<RunData>),
    /// Files from which the others follow, which pickles keep, and all of them.
    Files(Later<Files>, OnceLock<Files>),
}

impl Content {
    pub fn run(make: impl FnOnce() -> Found<RunData> + Send + 'static) -> Self {
        Self::Run(Box::new(LazyLock::new(Box::new(make))))
    }

    pub fn files(make: impl FnOnce() -> Found<Files> + Send + 'static) -> Self {
        Self::Files(Box::new(LazyLock::new(Box::new(make))), OnceLock::new())
    }
}

/// The record of a result of a kind.
fn recorded(kind: &str, shape: &Shape, values: &str) -> Found<Record> {
    let record = Record::read(shape, &serde_json::from_str(values)?);
    record.map_err(|error| input(format!("numbers of a {kind}: {error}")))
}

/// All files of a result from those that pickles keep.
fn complete(kind: &str, values: &str, mut all: Files) -> Found<Files> {
    if all.contains_key(PAGE) {
        return Ok(all);
    }
    let numbers = |error| input(format!("numbers of a {kind}: {error}"));
    let page = match kind {
        "static" => {
            let case = all.remove("case.toml").unwrap_or_default();
            let file = CaseFile::parse(&case, "case", &[])?;
            let record = equilibrium_record(file.case(), file.particulars())?;
            static_page(&file, &record)
        }
        "design" | "search" => {
            let data = all.get(PAGE_DATA).map_or("", |text| text);
            let mut data: DesignData = from_json(data).map_err(numbers)?;
            if kind == "search" {
                data.search = Some(recorded(kind, &SEARCH_SHAPE, values)?);
            }
            design_page(&data)
        }
        "tolerance" => tolerance_page(&ToleranceResult {
            record: recorded(kind, &TOLERANCE_SHAPE, values)?,
            benefit: None,
        }),
        "analysis" => sweep_page(&from_json(values).map_err(numbers)?),
        _ => return Ok(all),
    };
    let (kind, json) = match kind {
        "static" => ("static", values),
        _ => ("design", all.get("design.json").map_or("", |json| json)),
    };
    if !json.is_empty() {
        let table = values_csv(kind, &serde_json::from_str(json)?);
        all.insert(format!("{kind}.csv"), table);
    }
    all.insert(PAGE.to_owned(), page);
    Ok(all)
}

/// A result of any computation.
#[pyclass(frozen, name = "Result", module = "cageless._cageless")]
pub struct Computed {
    /// Name of the computation.
    #[pyo3(get)]
    kind: String,
    /// JSON of the command.
    #[pyo3(get)]
    values: String,
    /// Arrays of each bearing.
    #[pyo3(get)]
    tables: Py<PyList>,
    content: Content,
}

/// Name, unit and label of the scalar results of a kind of result, and whether each is a number.
#[pyfunction]
pub fn quantities(kind: &str) -> Vec<(&str, &str, &str, bool)> {
    let row = |q: &'static Quantity| (q.name, q.unit, q.label, q.kind == Kind::Number);
    of_kind(kind).map(row).collect()
}

/// Unit of every name that is declared: of a result, or of a key of a case or rotor file.
#[pyfunction]
pub fn units() -> BTreeMap<&'static str, &'static str> {
    declared::units().collect()
}

/// Names of the figures of a kind of result, with what they show.
#[pyfunction]
pub fn figures(kind: &str) -> Vec<(&'static str, &'static str)> {
    figures_of_kind(kind)
}

/// Writes a file, which takes its name when it is complete.
#[pyfunction]
pub fn write(path: PathBuf, content: &[u8]) -> Found<()> {
    let shown = path.display();
    if let Some(folder) = path.parent().filter(|f| f != &Path::new("") && !f.is_dir()) {
        let folder = folder.display();
        return Err(input(format!(
            "{shown}: the folder {folder} is not there; make it first"
        )));
    }
    if path.is_dir() {
        return Err(input(format!(
            "{shown}: is a directory where a file is to be"
        )));
    }
    Ok(write_atomically(&path, content)?)
}

/// Makes a folder and those above it, and writes files that take their names together.
#[pyfunction]
pub fn write_folder(path: PathBuf, files: BTreeMap<String, Vec<u8>>) -> Found<()> {
    let mut folder = ResultFolder::open(&path)?;
    for (name, content) in &files {
        folder.add(name, content)?;
    }
    Ok(folder.commit_files()?)
}

/// Writes a result: the file `name` that speaks for it, the others, and the tables of each bearing.
#[pyfunction]
pub fn write_result(
    path: PathBuf,
    name: &str,
    text: &str,
    files: Files,
    tables: Vec<Recorded<'_>>,
) -> Found<()> {
    let mut folder = ResultFolder::open(&path)?;
    for bearing in &tables {
        bearing.write(&mut folder)?;
    }
    for (name, text) in &files {
        folder.add(name, text.as_bytes())?;
    }
    Ok(folder.commit(name, text)?)
}

impl Computed {
    pub fn of(
        py: Python<'_>,
        kind: &str,
        values: String,
        tables: Vec<Tables>,
        content: Content,
    ) -> Found<Self> {
        let tables = tables.into_iter().map(|t| t.into_arrays(py));
        Ok(Self {
            kind: kind.to_owned(),
            values,
            tables: PyList::new(py, tables.collect::<Found<Vec<_>>>()?)?.unbind(),
            content,
        })
    }

    /// All files, of a result other than a run.
    fn all(&self, py: Python<'_>) -> Found<&Files> {
        let Content::Files(seed, all) = &self.content else {
            return Err(other("a run has data in place of files"));
        };
        if let Some(all) = all.get() {
            return Ok(all);
        }
        let seed = made(py, seed)?.clone();
        let files = py.detach(|| complete(&self.kind, &self.values, seed))?;
        Ok(all.get_or_init(|| files))
    }

    /// Data of a figure, from the JSON of the values or of the page.
    fn data<D: DeserializeOwned>(&self, json: &str) -> Found<D> {
        from_json(json).map_err(|error| input(format!("numbers of a {}: {error}", self.kind)))
    }
}

/// Value of `later`, made at the first call.
fn made<'l, T: Send + Sync>(py: Python<'_>, later: &'l Later<T>) -> Found<&'l T> {
    let made = py.detach(|| LazyLock::force(later));
    made.as_ref().map_err(|error| Error(error.0.clone_ref(py)))
}

#[pymethods]
impl Computed {
    /// A result from what its attributes and methods return.
    #[new]
    fn new(kind: String, values: String, tables: Py<PyList>, files: Files) -> Self {
        let content = match kind.as_str() {
            "run" => {
                let summary = values.clone();
                Content::run(move || {
                    let text = files.get(PAGE_DATA).map_or("", |text| text);
                    run_from_json(text, &summary)
                        .map_err(|e| input(format!("report.json of a saved run: {e}")))
                })
            }
            _ => Content::files(move || Ok(files)),
        };
        Self {
            kind,
            values,
            tables,
            content,
        }
    }

    /// Files that pickles keep, by name.
    fn seed(&self, py: Python<'_>) -> Found<Files> {
        match &self.content {
            Content::Files(seed, _) => made(py, seed).cloned(),
            Content::Run(data) => {
                let text = run_json(made(py, data)?, &self.values)?;
                Ok(files([(PAGE_DATA, text)]))
            }
        }
    }

    /// Files of the command by name, beside the values.
    fn files(&self, py: Python<'_>) -> Found<Files> {
        let mut files = self.seed(py)?;
        match &self.content {
            Content::Files(..) => files = self.all(py)?.clone(),
            Content::Run(data) => {
                let data = made(py, data)?;
                files.insert(PAGE.to_owned(), py.detach(|| run_page(data)));
            }
        }
        Ok(files)
    }

    /// A figure in the JSON of plotly: of a run of all balls, counted from 1, and all times, or of
    /// some; of a sweep about an output.
    fn figure(
        &self,
        py: Python<'_>,
        name: &str,
        balls: Option<Vec<usize>>,
        time_s: Option<(f64, f64)>,
        output: Option<&str>,
    ) -> Found<String> {
        let nothing = || input(format!("this result has nothing to show as {name:?}"));
        match (&self.content, self.kind.as_str()) {
            (Content::Run(data), _) => {
                let mut data = made(py, data)?.clone();
                if let Some((from, to)) = time_s {
                    let tables = self.tables.bind(py).get_item(0)?;
                    let tables = Tables::of_arrays(tables.cast::<PyDict>().map_err(PyErr::from)?)?;
                    data = data.within(&tables.snapshots(from, to)?);
                }
                if let Some(balls) = balls {
                    let balls: Vec<usize> = balls.iter().map(|ball| ball - 1).collect();
                    data = data.of_balls(&balls);
                }
                let figures = RUN.iter().flat_map(|(_, figures)| *figures);
                drawn(py, figures, &data, name).ok_or_else(|| why_empty(&data, name))
            }
            (_, "design") => {
                let seed = self.seed(py)?;
                let data = self.data(seed.get(PAGE_DATA).map_or("", |text| text))?;
                drawn(py, &DESIGN, &data, name).ok_or_else(nothing)
            }
            (_, kind @ "search") => {
                let record = recorded(kind, &SEARCH_SHAPE, &self.values)?;
                drawn(py, &SEARCH, &record, name).ok_or_else(nothing)
            }
            (_, kind @ "tolerance") => {
                let record = recorded(kind, &TOLERANCE_SHAPE, &self.values)?;
                drawn(py, &TOLERANCE, &record, name).ok_or_else(nothing)
            }
            (_, "analysis") => {
                let data: SweepData = self.data(&self.values)?;
                let nothing = || input("nothing varies in this sweep");
                match output {
                    None => drawn(py, &SWEEP, &data, name).ok_or_else(nothing),
                    Some(output) => of_output(&data, name, output),
                }
            }
            (_, kind) => {
                let page = self.all(py)?.get(PAGE).map_or("", |page| page);
                let found = in_page(page, kind, name).map(str::to_owned);
                found.ok_or_else(|| match in_page(page, kind, &format!("{name}-bearing-1")) {
                    Some(_) => input(format!(
                        "{name} is shown of each bearing: bearings[0].plot_{name}()"
                    )),
                    None => nothing(),
                })
            }
        }
    }
}

fn drawn<'f, D: Sync + 'static>(
    py: Python<'_>,
    figures: impl IntoIterator<Item = &'f Named<D>>,
    data: &D,
    name: &str,
) -> Option<String> {
    let named = figures.into_iter().find(|figure| figure.name == name)?;
    let figure = py.detach(|| (named.draw)(data));
    figure.as_ref().map(Figure::json)
}

/// The reason of an empty figure of a run, with advice.
fn why_empty(data: &RunData, name: &str) -> Error {
    let why = match name {
        "vibration" if data.vibration.is_none() => {
            "the case has no [housing], whose acceleration it shows: add Housing(mass_kg=…, \
             stiffness_n_m=…, damping_n_s_m=…)"
        }
        "collisions" => "no balls touched",
        "contact_angles" | "groove" if data.balls.iter().all(|ball| ball.z_m.is_empty()) => {
            "balls have contact angles in space alone: set model.motion = \"space\""
        }
        _ => {
            "the run is too short after its transient: lengthen solver.duration_s or shorten \
             output.interval_us"
        }
    };
    input(format!("{name} has nothing to show: {why}"))
}

/// A figure of one output of a sweep.
fn of_output(data: &SweepData, name: &str, output: &str) -> Found<String> {
    let mut outputs = data.outputs.iter();
    let found = outputs.find(|o| o.quantity.name == output);
    let found: &SweepOutput = found.ok_or_else(|| {
        let names: Vec<&str> = data.outputs.iter().map(|o| &*o.quantity.name).collect();
        let names = names.join(", ");
        input(format!(
            "{output:?} is not an output that varies; there are {names}"
        ))
    })?;
    let figure = match (name, &found.map) {
        ("map", Some(map)) => sweep::map(found, map, &data.provenance),
        ("map", None) => {
            return Err(input(format!("{output} depends on fewer than two inputs")));
        }
        _ if found.effects.is_empty() => {
            return Err(input(format!("no input explains {output}")));
        }
        _ => sweep::effects(found, &data.provenance),
    };
    Ok(figure.json())
}
