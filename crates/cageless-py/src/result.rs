//! The result of a computation: its values as the command writes them, tables, figures, page, files.

use std::path::{Path, PathBuf};

use cageless_io::results::{write_atomically, write_together};
use cageless_report::figures::named;
use cageless_results::{Aim, Kind as ValueKind, Quantity, Record, SEARCH_SHAPE, of_kind};
use cageless_study::Stopped;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::Value;

use crate::content::{Content, figure_of_run};
use crate::errors::{input, of_folder, of_results, other};
use crate::tables::Tables;

/// Files of a kind of result in its folder.
struct Kind {
    name: &'static str,
    values: &'static str,
    /// File of [`Content::source`], where there is one.
    source: &'static str,
}

const PAGE: &str = "report.html";
const fn kind(name: &'static str, values: &'static str, source: &'static str) -> Kind {
    Kind {
        name,
        values,
        source,
    }
}

/// The last is looked for only where there is no other: `cageless report` writes into the folder of
/// a sweep.
const KINDS: [Kind; 9] = [
    kind("run", "summary.json", "report.json"),
    kind("drop", "summary.json", PAGE),
    kind("sweep", "sweep.parquet", ""),
    kind("tolerance", "tolerance.json", ""),
    kind("search", "search.json", "case.toml"),
    kind("design", "design.json", "report.json"),
    kind("static", "static.json", PAGE),
    kind("comparison", "compare.json", PAGE),
    kind("analysis", "report.json", ""),
];

/// A result of any computation.
#[pyclass(frozen, name = "Result", module = "cageless._cageless")]
pub struct Computed {
    kind: &'static Kind,
    values: String,
    stopped: Option<String>,
    /// Tables of each bearing.
    tables: Vec<Py<PyDict>>,
    pub content: Content,
}

impl Computed {
    pub fn new(
        kind: &str,
        values: String,
        stopped: Option<String>,
        tables: Vec<Py<PyDict>>,
        content: Content,
    ) -> PyResult<Self> {
        let kind = KINDS.iter().find(|k| k.name == kind);
        let kind = kind.ok_or_else(|| input("there is no such kind of results"))?;
        Ok(Self {
            kind,
            values,
            stopped,
            tables,
            content,
        })
    }
}

/// Name, unit, label, kind of value and better direction of the scalar results of a kind of result.
#[pyfunction]
pub fn quantities(kind: &str) -> Vec<[&'static str; 5]> {
    let row = |q: &'static Quantity| {
        let kind = match q.kind {
            ValueKind::Number => "number",
            ValueKind::Integer => "integer",
            ValueKind::Flag => "flag",
            ValueKind::Text => "text",
            ValueKind::Numbers | ValueKind::Range => "numbers",
        };
        let better = match q.aim {
            Some(Aim::Low) => "low",
            Some(Aim::High) => "high",
            None => "",
        };
        [q.name, q.unit, q.label, kind, better]
    };
    of_kind(kind).map(row).collect()
}

/// Names of the figures of a kind of result, with what they show.
#[pyfunction]
pub fn figures(kind: &str) -> Vec<(&'static str, &'static str)> {
    named::of_kind(kind)
}

/// Reads the result in a folder; `None` if it is a sweep.
#[pyfunction]
pub fn load(py: Python<'_>, dir: PathBuf) -> PyResult<Option<Computed>> {
    let files = || KINDS.iter().map(|kind| kind.values);
    let mut there: Vec<&str> = files().filter(|name| dir.join(name).is_file()).collect();
    there.dedup();
    if there.len() > 1 {
        there.retain(|name| *name != "report.json");
    }
    let shown = dir.display();
    let name = match there.as_slice() {
        [one] => *one,
        [] => {
            let what = if dir.is_dir() {
                "holds no result"
            } else {
                "is not there"
            };
            let mut names: Vec<&str> = files().collect();
            names.dedup();
            let names = names.join(", ");
            return Err(input(format!(
                "{shown}: {what}: one of {names} is expected in a folder"
            )));
        }
        several => {
            let listed = several.join(", ");
            return Err(input(format!(
                "{shown}: holds several results: {listed}; take a folder for each"
            )));
        }
    };
    if name == "sweep.parquet" {
        return Ok(None);
    }
    let mut text = read(&dir.join(name))?;
    let mut values: Value = serde_json::from_str(&text)
        .map_err(|e| input(format!("{}: cannot be read: {e}", dir.join(name).display())))?;
    let mut kind = match name {
        "summary.json" if dir.join("report.json").is_file() => "run",
        "summary.json" => "drop",
        name => KINDS
            .iter()
            .find(|k| k.values == name)
            .map_or("", |k| k.name),
    };
    let mut reason = stopped(&values);
    if values.get("search").is_some_and(Value::is_object) {
        kind = "search";
        reason = values["refusal"].as_str().map(str::to_owned);
        values = values["search"].take();
        let data =
            Record::read(&SEARCH_SHAPE, &values).map_err(|e| input(format!("{shown}: {e}")))?;
        text = serde_json::to_string(&data).map_err(other)?;
    }
    let file = KINDS
        .iter()
        .find(|k| k.name == kind)
        .map_or("", |k| k.source);
    let source = match file {
        "" => String::new(),
        file => read(&dir.join(file))?,
    };
    let folders = match values["bearings"].as_array() {
        Some(bearings) => (1..=bearings.len())
            .map(|k| dir.join(folder_of(k)))
            .collect(),
        None => vec![dir],
    };
    let tables: PyResult<Vec<Tables>> = match kind {
        "run" | "drop" => folders
            .iter()
            .map(|dir| py.detach(|| Tables::read(dir)))
            .collect(),
        _ => Ok(vec![]),
    };
    let tables: PyResult<_> = tables?.into_iter().map(|t| t.into_arrays(py)).collect();
    let content = Content::restored(kind, &text, source)?;
    Computed::new(kind, text, reason, tables?, content).map(Some)
}

fn read(path: &Path) -> PyResult<String> {
    std::fs::read_to_string(path)
        .map_err(|e| input(format!("{}: cannot be read: {e}", path.display())))
}

/// Folder of the tables of bearing `k`, from 1.
fn folder_of(k: usize) -> String {
    format!("bearing-{k}")
}

/// Reason of an early stop by the physics, from the values of a run or a drop.
fn stopped(values: &Value) -> Option<String> {
    let stop = &values["stopped"];
    if let Some(cause) = stop["cause"].as_str() {
        return (cause != Stopped::INTERRUPTED).then(|| {
            format!(
                "at t = {:.6} s {cause}. To change: {}.",
                stop["time_s"].as_f64().unwrap_or(f64::NAN),
                stop["advice"].as_str().unwrap_or_default()
            )
        });
    }
    let bearings = values["bearings"].as_array().into_iter().flatten();
    let mut reasons = (1..).zip(bearings);
    let of_bearing =
        reasons.find_map(|(k, b)| Some(format!("bearing {k}: {}", b["stopped"].as_str()?)));
    stop.as_str().map(str::to_owned).or(of_bearing)
}

/// Writes a file, which takes its name when it is complete.
#[pyfunction]
pub fn write(path: PathBuf, content: &[u8]) -> PyResult<()> {
    if let Some(folder) = path.parent().filter(|f| f != &Path::new("") && !f.is_dir()) {
        return Err(input(format!(
            "{}: the folder {} is not there; make it first",
            path.display(),
            folder.display()
        )));
    }
    if path.is_dir() {
        let message = "is a directory where a file is to be";
        return Err(input(format!("{}: {message}", path.display())));
    }
    write_atomically(&path, content).map_err(|e| of_results(&e))
}

/// Makes a folder and those above it.
#[pyfunction]
pub fn make_folder(path: PathBuf) -> PyResult<()> {
    std::fs::create_dir_all(&path).map_err(|e| of_folder(&path, e))
}

#[pymethods]
impl Computed {
    /// A result from what its methods return.
    #[staticmethod]
    fn restored(
        kind: &str,
        values: String,
        stopped: Option<String>,
        tables: Vec<Py<PyDict>>,
        source: String,
    ) -> PyResult<Self> {
        let content = Content::restored(kind, &values, source)?;
        Self::new(kind, values, stopped, tables, content)
    }

    /// Name of the computation.
    #[getter]
    fn kind(&self) -> &'static str {
        self.kind.name
    }

    /// JSON of the command.
    #[getter]
    fn values(&self) -> &str {
        &self.values
    }

    /// Reason of an early stop, or of a search that recommends nothing: the message of the command.
    #[getter]
    fn stopped(&self) -> Option<&str> {
        self.stopped.as_deref()
    }

    /// Arrays of each bearing, the same at every call.
    fn tables(&self, py: Python<'_>) -> Vec<Py<PyDict>> {
        self.tables
            .iter()
            .map(|table| table.clone_ref(py))
            .collect()
    }

    /// What pickles keep beside the values.
    fn source(&self) -> PyResult<String> {
        self.content.source(&self.values)
    }

    /// A figure in the JSON of plotly: of a run of all balls, counted from 1, and all times, or of
    /// some.
    fn figure(
        &self,
        py: Python<'_>,
        name: &str,
        balls: Option<Vec<usize>>,
        time_s: Option<(f64, f64)>,
        output: Option<&str>,
    ) -> PyResult<String> {
        let (Content::Run(data), true) = (&self.content, balls.is_some() || time_s.is_some())
        else {
            return self.content.figure(py, name, output);
        };
        let mut data = data.get()?.clone();
        if let Some(window) = time_s {
            let tables = Tables::of_arrays(self.tables[0].bind(py))?;
            data = data.within(&tables.snapshots(window)?);
        }
        if let Some(balls) = balls {
            let count = data.balls.len();
            if let Some(ball) = balls.iter().find(|ball| !(1..=count).contains(*ball)) {
                return Err(input(format!(
                    "balls = {ball} is not possible: it must be 1 to {count}"
                )));
            }
            let balls: Vec<usize> = balls.iter().map(|ball| ball - 1).collect();
            data = data.of_balls(&balls);
        }
        figure_of_run(py, &data, name)
    }

    /// `report.html`.
    fn page(&self, py: Python<'_>) -> PyResult<String> {
        self.content.page(py)
    }

    /// Writes the files of the command into a folder; `footers` are the instruction set and the
    /// case as run of each bearing, JSON.
    fn save(&self, py: Python<'_>, dir: PathBuf, footers: Vec<(String, String)>) -> PyResult<()> {
        make_folder(dir.clone())?;
        let kind = self.kind;
        let source = self.source()?;
        let mut files = vec![(kind.values, self.values.clone())];
        if !kind.source.is_empty() {
            files.push((kind.source, source));
        }
        if kind.name == "search" {
            let refusal = Value::from(self.stopped.clone());
            let search = &self.values;
            files[0].1 = format!("{{\"refusal\": {refusal}, \"search\": {search}}}\n");
        } else if kind.source != PAGE {
            files.push((PAGE, self.content.page(py)?));
        }
        for (k, (table, (isa, case))) in self.tables.iter().zip(&footers).enumerate() {
            let folder = match self.tables.len() {
                1 => dir.clone(),
                _ => dir.join(folder_of(k + 1)),
            };
            make_folder(folder.clone())?;
            Tables::of_arrays(table.bind(py))?.write(&folder, isa, case)?;
        }
        let files: Vec<(&str, &str)> = files.iter().map(|(n, t)| (*n, t.as_str())).collect();
        write_together(&dir, &files).map_err(|e| of_results(&e))
    }
}
