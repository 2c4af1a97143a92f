//! Computations of a case or a rotor, each with the files that the command leaves.

use std::collections::HashSet;
use std::path::PathBuf;

use cageless_io::cad::{Export, ExportOptions, Format, export as ring};
use cageless_io::case_file::CaseFile;
use cageless_io::results::{ROTOR, ResultFolder};
use cageless_paper::structures_of;
use cageless_report::compare::compare_page;
use cageless_report::compared_run::compared_runs;
use cageless_report::design_report::design_data;
use cageless_report::drop::drop_page;
use cageless_report::recommended::recommended_document;
use cageless_report::run_report::run_data;
use cageless_report::sheet::SheetFiles;
use cageless_report::to_json;
use cageless_results::{Aim, Record, equilibrium_record_noted};
use cageless_study::benefit_search::BenefitSearch;
use cageless_study::design::{Asked, Designed, design as study_design};
use cageless_study::drop::{DropRequest, study};
use cageless_study::measured::Limits;
use cageless_study::run::{Options, run as simulate};
use cageless_study::sheet::Sheet;
use cageless_study::sweep::analysis::{Goal, analyse as analyse_sweep};
use cageless_study::tolerance::tolerance as within_tolerances;
use cageless_study::{Progress, StudyError, comparison, search as study_search};
use pyo3::prelude::*;
use serde::Serialize;

use crate::background::Background;
use crate::documents::File;
use crate::errors::{Error, Found, input};
use crate::result::{Computed, Content, Files, PAGE, PAGE_DATA, files};
use crate::tables::Tables;

/// Text of `--json`.
fn pretty(result: &impl Serialize) -> Found<String> {
    Ok(serde_json::to_string_pretty(result)? + "\n")
}

/// A result whose folder has a page beside its values, which follows from `seed`.
fn with_seed(
    py: Python<'_>,
    kind: &str,
    values: String,
    tables: Vec<Tables>,
    seed: impl FnOnce() -> Found<Files> + Send + 'static,
) -> Found<Computed> {
    Computed::of(py, kind, values, tables, Content::files(seed))
}

/// Runs a case with everything recorded.
#[pyfunction]
pub fn run(py: Python<'_>, file: &File, verify: bool, background: Background) -> Found<Computed> {
    let file = file.case().clone();
    let mut tables = Tables::default();
    // Verification uses every core, a run alone needs one.
    let record = background.on_one(!verify).run(py, |progress| {
        let options = Options {
            rows: Some(&mut tables),
            verify,
        };
        let mut record = simulate(&file, options, progress)?;
        record.verify(&file, progress);
        Ok::<_, StudyError>(record)
    })??;
    let values = record.summary.to_json()?;
    let content = Content::run(move || Ok(run_data(&file, &record)));
    Computed::of(py, "run", values, vec![tables], content)
}

/// Drops a rotor into its bearings.
#[pyfunction]
pub fn drop(
    py: Python<'_>,
    file: &File,
    compare: bool,
    samples: Option<u64>,
    verify: bool,
    drops: Option<u64>,
    background: Background,
) -> Found<Computed> {
    let request = DropRequest {
        compare,
        samples,
        verify,
        drops,
    };
    let file = file.0.clone();
    let drop = request.check(&file, "case")?;
    let rows = drop.cases().iter().map(|_| None).collect();
    let study = background.run(py, |progress| study(&file, drop, request, rows, progress))??;
    let tables = study.record.bearings.iter().map(Tables::of_drop);
    let (tables, values) = (tables.collect::<Found<_>>()?, study.to_json(&file)?);
    with_seed(py, "drop", values, tables, move || {
        let rotor = file.rotor_toml()?.map(|text| (ROTOR, text));
        Ok(files(
            [(PAGE, drop_page(&file, &study))].into_iter().chain(rotor),
        ))
    })
}

/// Solves the static equilibrium of a case.
#[pyfunction]
pub fn static_equilibrium(py: Python<'_>, file: &File) -> Found<Computed> {
    let (file, note) = file.case().clone().resting()?;
    let record = py.detach(|| equilibrium_record_noted(file.case(), file.particulars(), note))?;
    with_seed(py, "static", pretty(&record)?, vec![], move || {
        Ok(files([("case.toml", file.document().to_toml()?)]))
    })
}

/// Values of a search in Python.
#[derive(Serialize)]
struct SearchValues<'a> {
    #[serde(flatten)]
    found: &'a Record,
    #[serde(skip_serializing_if = "Option::is_none")]
    benefit: Option<&'a BenefitSearch>,
}

/// Judges the raceways of a case. `asked` may hold `axial`, for axial loads, `search`, for a search or its
/// resumption in the folder, and `benefit`, for steady operation beside a plain ring.
#[pyfunction]
pub fn design(
    py: Python<'_>,
    file: &File,
    asked: HashSet<String>,
    folder: Option<PathBuf>,
    background: Background,
) -> Found<Computed> {
    let file = file.case().clone();
    let [axial, search, benefit] = ["axial", "search", "benefit"].map(|name| asked.contains(name));
    let background = background.on_one(asked.is_empty());
    let (result, data, stopped) = background.run(py, |progress| {
        let paper = structures_of(&file.case().bearing)?;
        let asked = Asked {
            axial,
            search: search.then_some(&paper),
            benefit,
            folder: folder.as_deref(),
        };
        let Designed {
            result,
            snapshots,
            stopped,
            interrupted,
            ..
        } = study_design(&file, asked, progress)?;
        if interrupted {
            return Err(StudyError::Interrupted.into());
        }
        let data = design_data(&file, &result, &snapshots);
        Ok::<_, Error>((result, data, stopped))
    })??;
    if let (Some(stop), false) = (stopped, search) {
        return Err(cageless_cli::Failure::stopped(&stop, "").into());
    }
    if let Some(folder) = &folder {
        study_search::forget(folder);
    }
    let json = pretty(&result)?;
    let (kind, values) = match &result.search {
        Some(found) => {
            let benefit = result.benefit.as_ref();
            let values = SearchValues { found, benefit };
            ("search", serde_json::to_string(&values)?)
        }
        None => ("design", json.clone()),
    };
    with_seed(py, kind, values, vec![], move || {
        let mut seed = vec![(PAGE_DATA, to_json(&data)?), ("design.json", json)];
        if let Some(case) = recommended_document(&file, &result) {
            seed.push(("recommended.toml", file.edited(&case)?));
        }
        if search {
            seed.push(("case.toml", file.document().to_toml()?));
        }
        Ok(files(seed))
    })
}

/// Compares the ring of a case with that of another, with a conventional one or with its remedies, in
/// steady operation with the same draws of balls.
#[pyfunction]
pub fn compare(
    py: Python<'_>,
    file: &File,
    reference: Option<&File>,
    remedies: bool,
    draws: u64,
    background: Background,
) -> Found<Computed> {
    let case: &CaseFile = file.case();
    let own = ("case".to_owned(), case.clone());
    let remedies = remedies
        .then(|| comparison::Remedies::new(case))
        .transpose()?;
    let rings = match reference {
        _ if remedies.is_some() => vec![],
        Some(other) => vec![("reference".to_owned(), other.case().clone()), own],
        None => vec![
            ("conventional".to_owned(), case.with_conventional_ring()?),
            own,
        ],
    };
    let work = |progress: &dyn Progress| {
        let sampling = comparison::Sampling::Draws(draws);
        match &remedies {
            Some(remedies) => comparison::compare_remedies(remedies, sampling, progress),
            None => comparison::compare(&rings, sampling, progress),
        }
    };
    let (compared, comparison) = background.run(py, work)??;
    with_seed(py, "comparison", pretty(&comparison)?, vec![], move || {
        let page = compare_page(&compared_runs(&compared, &comparison), &comparison);
        Ok(files([(PAGE, page)]))
    })
}

/// Judges the bearing of a case within tolerances, the JSON of a request.
#[pyfunction]
pub fn tolerance(
    py: Python<'_>,
    file: &File,
    request: &str,
    background: Background,
) -> Found<Computed> {
    let (file, request) = (file.case(), serde_json::from_str(request)?);
    let work = |progress: &dyn Progress| within_tolerances(file, "case", &request, progress);
    let data = background.run(py, work)??;
    let values = to_json(&data)? + "\n";
    with_seed(py, "tolerance", values, vec![], || Ok(Files::new()))
}

/// Writes the sheet of a case into a folder; tolerances are depth, lC, θ and ψ of the raceway, `None` the usual ones.
#[pyfunction]
pub fn sheet(
    py: Python<'_>,
    file: &File,
    folder: PathBuf,
    tolerances: [Option<f64>; 4],
    benefit: bool,
    background: Background,
) -> Found<()> {
    let file = file.case();
    let [depth, span, angle, centre_angle_deg] = tolerances;
    let usual = Limits::default();
    let limits = Limits {
        groove_depth_um: depth.unwrap_or(usual.groove_depth_um),
        axial_span_um: span.unwrap_or(usual.axial_span_um),
        half_angle_deg: angle.unwrap_or(usual.half_angle_deg),
        centre_angle_deg,
    };
    let sheet = Sheet::new(file, "case", &limits, benefit)?;
    let result = background.run(py, |progress| sheet.compute(progress))??;
    py.detach(|| {
        let mut folder = ResultFolder::open(&folder)?;
        for (name, contents) in SheetFiles::new(file, &result, &limits).files {
            match contents {
                Some(contents) => folder.add(name, &contents)?,
                None => folder.remove(name),
            }
        }
        Ok(folder.commit("sheet.json", &pretty(&result)?)?)
    })
}

/// Analyses the finished sweep at `path`; of the columns `low` less is better, of `high` more.
#[pyfunction]
pub fn analyse(
    py: Python<'_>,
    path: PathBuf,
    low: Vec<String>,
    high: Vec<String>,
) -> Found<Computed> {
    let goal = |aim| move |column| Goal { column, aim };
    let low = low.into_iter().map(goal(Aim::Low));
    let goals: Vec<Goal> = low.chain(high.into_iter().map(goal(Aim::High))).collect();
    let data = py.detach(|| analyse_sweep(&path, &goals))?;
    let values = to_json(&data)? + "\n";
    with_seed(py, "analysis", values, vec![], || Ok(Files::new()))
}

/// Writes the outer ring as files of formats, into `folder` if it is one; the numbers of each are JSON.
#[pyfunction]
pub fn export(
    py: Python<'_>,
    file: &File,
    folder: Option<PathBuf>,
    targets: Vec<(String, PathBuf)>,
    options: [Option<f64>; 4],
) -> Found<Vec<String>> {
    let [blend_mm, tolerance_um, chord_um, spacing_mm] = options;
    let options = ExportOptions {
        blend_mm,
        tolerance_um,
        chord_um,
        spacing_mm,
    };
    let format = |(name, _): &(String, PathBuf)| {
        let known = Format::ALL.into_iter().find(|f| f.name() == name);
        let problem = "is not possible: it must be of step, stl, csv";
        known.ok_or_else(|| input(format!("formats = {name:?} {problem}")))
    };
    let formats: Vec<Format> = targets.iter().map(format).collect::<Found<_>>()?;
    options.check(&formats)?;
    py.detach(|| {
        let made = formats.iter().map(|&f| ring(file.case(), f, &options));
        let made: Vec<_> = made.collect::<Result<_, _>>()?;
        // Only now, so that bad input leaves no folder behind.
        let mut folder = folder.as_deref().map(ResultFolder::open).transpose()?;
        let write = |(made, (_, path)): (&Export, &(String, PathBuf))| -> Found<String> {
            let numbers = match &mut folder {
                None => made.write_file(path)?,
                Some(folder) => {
                    let (file, numbers) = made.write_partial(path)?;
                    folder.add_file(file)?;
                    numbers
                }
            };
            Ok(serde_json::to_string_pretty(&numbers)?)
        };
        let numbers = made.iter().zip(&targets).map(write);
        let numbers = numbers.collect::<Found<Vec<_>>>()?;
        if let Some(folder) = &mut folder {
            let text = match &numbers[..] {
                [one] => one.clone(),
                several => format!("[{}]", several.join(",\n")),
            };
            folder.commit("export.json", &format!("{text}\n"))?;
        }
        Ok(numbers)
    })
}
