//! Computations of a case or a rotor, each with its result.

use std::path::PathBuf;

use cageless::equilibrium::solve;
use cageless_io::case_file::CaseFile;
use cageless_io::rotor_file::RotorFile;
use cageless_paper::structures_of;
use cageless_report::compare::compare_page;
use cageless_report::compared_run::ComparedRun;
use cageless_report::drop::{drop_page, rotor_page};
use cageless_report::run_report::run_data;
use cageless_report::{static_page, to_json};
use cageless_results::{Aim, static_record};
use cageless_study::drop::{DropRequest, rotor_study, study};
use cageless_study::run::{Options, run as simulate};
use cageless_study::sweep::analysis::{Goal, analyse as analyse_sweep};
use cageless_study::tolerance::{Request, tolerance as within_tolerances};
use cageless_study::{comparison, search as study_search};
use pyo3::prelude::*;
use serde_json::to_string_pretty;

use crate::analysis::analysed;
use crate::background::Background;
use crate::content::{Content, Later};
use crate::errors::{input, of_run, of_start, of_study, of_sweep, other, reason};
use crate::result::Computed;
use crate::tables::Tables;

/// Runs a case with everything recorded.
pub fn run(
    py: Python<'_>,
    file: &CaseFile,
    verify: bool,
    background: Background,
) -> PyResult<Computed> {
    let mut tables = Tables::default();
    let done = background.run(py, |progress| {
        let options = Options {
            rows: Some(&mut tables),
            verify,
        };
        let mut record = simulate(file, options, progress)?;
        record.verify(file, progress);
        Ok(record)
    })?;
    let record = done.map_err(of_run)?;
    let values = record.summary.to_json().map_err(other)?;
    let stopped = reason(&record.outcome.ending);
    let arrays = vec![tables.into_arrays(py)?];
    let file = file.clone();
    let data = Later::new(move || Ok(run_data(&file, &record)));
    Computed::new("run", values, stopped, arrays, Content::Run(Box::new(data)))
}

/// Drops the rotor of a case.
pub fn drop(
    py: Python<'_>,
    file: &CaseFile,
    request: DropRequest,
    background: Background,
) -> PyResult<Computed> {
    request.check(file, "case").map_err(|e| of_study(&e))?;
    let done = background.run(py, |progress| study(file, request, None, progress))?;
    let study = done.map_err(of_run)?;
    let values = study.to_json(file).map_err(other)?;
    let stopped = reason(&study.drop.outcome.ending);
    let tables = vec![Tables::of_drop(&study.drop)?.into_arrays(py)?];
    let file = file.clone();
    let page = Later::new(move || Ok(drop_page(&file, &study)));
    Computed::new("drop", values, stopped, tables, Content::Page("drop", page))
}

/// Drops a rotor into its bearings.
pub fn drop_rotor(
    py: Python<'_>,
    file: &RotorFile,
    request: DropRequest,
    background: Background,
) -> PyResult<Computed> {
    request.check_samples().map_err(|e| of_study(&e))?;
    let rows = || file.bearings().iter().map(|_| None).collect();
    let done = background.run(py, |progress| rotor_study(file, request, rows(), progress))?;
    let study = done.map_err(of_run)?;
    let values = study.to_json(file).map_err(other)?;
    let last = study.drop.last_index() + 1;
    let stopped = reason(&study.drop.last().outcome.ending);
    let stopped = stopped.map(|reason| format!("bearing {last}: {reason}"));
    let bearings = study.drop.bearings.iter();
    let tables: PyResult<_> = bearings
        .map(|b| Tables::of_drop(b)?.into_arrays(py))
        .collect();
    let file = file.clone();
    let page = Later::new(move || Ok(rotor_page(&file, &study)));
    Computed::new(
        "drop",
        values,
        stopped,
        tables?,
        Content::Page("drop", page),
    )
}

/// Solves the static equilibrium of a case.
pub fn static_equilibrium(py: Python<'_>, file: &CaseFile) -> PyResult<Computed> {
    let solved = py.detach(|| solve(file.case()));
    let solved = solved.map_err(|error| of_start(&error))?;
    let record = static_record(file.case(), &solved);
    let values = pretty(to_string_pretty(&record))?;
    let file = file.clone();
    let page = Later::new(move || Ok(static_page(&file, &record)));
    Computed::new(
        "static",
        values,
        None,
        vec![],
        Content::Page("static", page),
    )
}

/// The text of `--json`.
fn pretty(json: serde_json::Result<String>) -> PyResult<String> {
    Ok(json.map_err(other)? + "\n")
}

/// Judges the raceways of a case, and the exception if a run that the verdict rests on stopped.
pub fn design(py: Python<'_>, file: &CaseFile) -> PyResult<(Computed, Option<PyErr>)> {
    let (result, data, stop) = analysed(py, file, None)?;
    let content = Content::Design(Box::new(data));
    let result = Computed::new(
        "design",
        pretty(to_string_pretty(&result))?,
        None,
        vec![],
        content,
    )?;
    Ok((result, stop))
}

/// Searches for the best raceway of a case, or resumes the search in the folder.
pub fn search(
    py: Python<'_>,
    file: &CaseFile,
    folder: Option<PathBuf>,
    background: Background,
) -> PyResult<Computed> {
    let paper = structures_of(&file.case().bearing).map_err(other)?;
    let done = background.run(py, |progress| {
        study_search::run(file, folder.as_deref(), &paper, progress)
    })?;
    let (found, data) = done.map_err(|error| of_study(&error))?;
    if let Some(folder) = &folder {
        study_search::forget(folder);
    }
    let refusal = study_search::refusal(file, &found);
    let values = serde_json::to_string(&data).map_err(other)?;
    let content = Content::Search(Box::new((file.clone(), data)));
    Computed::new("search", values, refusal, vec![], content)
}

/// Compares the ring of a case with that of another, or with a conventional one, from the same
/// uneven starts.
pub fn compare(
    py: Python<'_>,
    rings: [(&'static str, CaseFile); 2],
    starts: u64,
    background: Background,
) -> PyResult<Computed> {
    let done = background.run(py, |progress| comparison::compare(&rings, starts, progress))?;
    let (compared, comparison) = done.map_err(|error| of_study(&error))?;
    let values = pretty(to_string_pretty(&comparison))?;
    let page = Later::new(move || {
        let runs = compared.iter().zip(&comparison.runs);
        let runs = runs.map(|(ring, name)| ComparedRun {
            name: name.clone(),
            data: run_data(&ring.file, &ring.record),
        });
        Ok(compare_page(&runs.collect::<Vec<_>>(), &comparison))
    });
    Computed::new(
        "comparison",
        values,
        None,
        vec![],
        Content::Page("comparison", page),
    )
}

/// Judges the bearing of a case within tolerances.
pub fn tolerance(
    py: Python<'_>,
    file: &CaseFile,
    request: &Request,
    background: Background,
) -> PyResult<Computed> {
    let done = background.run(py, |progress| {
        within_tolerances(file.case(), "case", request, progress)
    })?;
    let data = done.map_err(|error| of_study(&error))?;
    let values = to_json(&data).map_err(other)?;
    Computed::new(
        "tolerance",
        values,
        None,
        vec![],
        Content::Tolerance(Box::new(data)),
    )
}

/// Analyses the finished sweep at `path`; of the columns `low` less is better, of `high` more.
#[pyfunction]
pub fn analyse(
    py: Python<'_>,
    path: PathBuf,
    low: Vec<String>,
    high: Vec<String>,
) -> PyResult<Computed> {
    let goal = |aim| move |column| Goal { column, aim };
    let low = low.into_iter().map(goal(Aim::Low));
    let goals: Vec<Goal> = low.chain(high.into_iter().map(goal(Aim::High))).collect();
    let data = py.detach(|| analyse_sweep(&path, &goals));
    let data = data.map_err(|e| of_sweep(&e))?;
    let values = to_json(&data).map_err(other)?;
    Computed::new(
        "analysis",
        values,
        None,
        vec![],
        Content::Analysis(Box::new(data)),
    )
}

/// What a drop is asked for beside itself.
pub fn requested(compare: bool, samples: Option<i64>, verify: bool) -> PyResult<DropRequest> {
    Ok(DropRequest {
        compare,
        samples: samples.map(|n| whole("samples", n)).transpose()?,
        verify,
    })
}

/// An option that counts something.
pub fn whole<T: TryFrom<i64>>(option: &str, value: i64) -> PyResult<T> {
    T::try_from(value).map_err(|_| {
        input(format!(
            "{option} = {value} is not possible: it must be 0 or more"
        ))
    })
}
