//! Runs side by side: one page, the same axes, and their differences.

use cageless_io::plan_file::Computation;
use cageless_study::quantities::{Aim, Kind, QUANTITIES};
use serde::Serialize;
use serde_json::{Map, Value};

use crate::data::{Motion, Provenance};
use crate::figures::compare as figures;
use crate::head::Head;
use crate::motion::MotionFigure;
use crate::page::{Note, Page};
use crate::run::RunData;
use crate::table::{Cell, Row, Table};
use crate::text::short;

/// Relative difference below which two results are called equal.
const EQUAL: f64 = 1e-12;

/// One of the runs of a comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedRun {
    /// Name in tables and legends.
    pub name: String,
    /// Data of its page.
    pub data: RunData,
    /// Its `summary.json`.
    pub summary: Map<String, Value>,
}

/// A scalar result of every run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ComparedResult {
    /// Name with the unit at its end, as in `summary.json`.
    pub name: &'static str,
    /// Wording for readers.
    #[serde(skip)]
    pub label: &'static str,
    /// Unit; empty if there is none.
    pub unit: String,
    /// Values in the order of the runs; `None` where a run has none.
    pub values: Vec<Option<f64>>,
    /// Values less that of the first run.
    pub differences: Vec<Option<f64>>,
    /// Whether a run is better than the first one; `None` if they are equal, or if neither
    /// direction is better.
    pub better: Vec<Option<bool>>,
}

/// `compare --json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunComparison {
    /// Names of the runs; differences are against the first.
    pub runs: Vec<String>,
    /// Scalar results.
    pub results: Vec<ComparedResult>,
}

impl RunComparison {
    /// Differences of runs.
    pub fn new(runs: &[ComparedRun]) -> Self {
        let quantities = QUANTITIES.iter().filter(|q| {
            let of_run = q.computation() == Computation::Run;
            of_run && q.in_tables && matches!(q.kind, Kind::Number | Kind::Integer)
        });
        let results = quantities.filter_map(|quantity| {
            let value = |run: &ComparedRun| run.summary.get(quantity.name)?.as_f64();
            let values: Vec<Option<f64>> = runs.iter().map(value).collect();
            values.iter().any(Option::is_some).then(|| {
                let differences: Vec<_> = values.iter().map(|v| Some((*v)? - values[0]?)).collect();
                let scale = values
                    .iter()
                    .flatten()
                    .fold(0.0, |m: f64, v| m.max(v.abs()));
                let better = |difference: &Option<f64>| {
                    let difference = difference.filter(|d| d.abs() > EQUAL * scale)?;
                    let low = quantity.aim? == Aim::Low;
                    Some(low == (difference < 0.0))
                };
                ComparedResult {
                    name: quantity.name,
                    label: quantity.label,
                    unit: quantity.unit_text(),
                    better: differences.iter().map(better).collect(),
                    values,
                    differences,
                }
            })
        });
        Self {
            runs: runs.iter().map(|run| run.name.clone()).collect(),
            results: results.collect(),
        }
    }

    /// Rows for readers: result, value of the first run, then value, difference and judgement of
    /// each other run, unit.
    pub fn rows(&self) -> Vec<Vec<String>> {
        let text = |value: Option<f64>| value.map_or("–".to_owned(), short);
        let row = |result: &ComparedResult| {
            let mut row = vec![result.label.to_owned(), text(result.values[0])];
            for k in 1..self.runs.len() {
                row.push(text(result.values[k]));
                row.push(signed(result.differences[k]));
                row.push(judged(result.better[k]).to_owned());
            }
            row.push(result.unit.clone());
            row
        };
        self.results.iter().map(row).collect()
    }

    /// Headings of [`Self::rows`].
    pub fn headings(&self) -> Vec<String> {
        let mut head = vec!["result".to_owned(), self.runs[0].clone()];
        for name in &self.runs[1..] {
            head.extend([name.clone(), "difference".to_owned(), String::new()]);
        }
        head.push("unit".to_owned());
        head
    }
}

fn signed(value: Option<f64>) -> String {
    match value {
        None => "–".to_owned(),
        Some(0.0) => "0".to_owned(),
        Some(v) if v > 0.0 => format!("+{}", short(v)),
        Some(v) => short(v),
    }
}

fn judged(better: Option<bool>) -> &'static str {
    match better {
        Some(true) => "better",
        Some(false) => "worse",
        None => "",
    }
}

/// The page of `compare`.
pub fn compare_page(runs: &[ComparedRun], comparison: &RunComparison) -> String {
    let names = comparison.runs.join(", ");
    let software = runs.first().map_or("", |run| &run.data.software);
    let lead: Vec<String> = (runs.iter())
        .map(|run| format!("{}: {}. {}", run.name, run.data.title, run.data.lead))
        .collect();
    let mut page = Page::new(&format!("Comparison: {names}"), &lead.join(" "), software);
    let head = runs.iter().fold(Head::default(), |head, run| {
        let headline = match run.data.headline.as_str() {
            "" => String::new(),
            headline => format!("{}: {headline}", run.name),
        };
        head.verdict(run.data.passes, &headline)
    });
    page.head(&head);
    for run in runs {
        for warning in &run.data.warnings {
            page.note(Note::Warning, &format!("{}: {warning}", run.name));
        }
    }
    page.section("Differences");
    page.note(Note::Remark, SCATTER);
    page.table(&table(runs, comparison));
    page.section("Spacing of the balls");
    figures::spacing(runs).iter().for_each(|f| page.figure(f));
    page.section("Inner ring and loads");
    figures::ring(runs).iter().for_each(|f| page.figure(f));
    figures::loads(runs).iter().for_each(|f| page.figure(f));
    let motions = motions(runs);
    if !motions.is_empty() {
        page.section("Balls in motion");
        page.motion(&MotionFigure {
            label: "Motion".to_owned(),
            caption: "The last orbits of each run, to scale, side by side at the same speed. The \
                      inner rings turn counter-clockwise, load and gravity point down; discrete \
                      raceways are shaded orange, balls 1 and 2 blue, balls in contact ringed."
                .to_owned(),
            bearings: motions,
            moments_s: Vec::new(),
            stretches: Vec::new(),
        });
    }
    page.html()
}

const SCATTER: &str = "One run each. Once balls have hit each other the motion is chaotic: counts of \
    contacts, extremes and means of short runs scatter. What of a result is converged, \
    cageless run --verify says.";

fn table(runs: &[ComparedRun], comparison: &RunComparison) -> Table {
    let headings = comparison.headings();
    let last = headings.len() - 1;
    let numeric = |k: usize| k == 1 || (k > 1 && k < last && (k - 2) % 3 < 2);
    let rows = comparison.rows().into_iter().map(|row| Row {
        cells: (row.into_iter().enumerate())
            .map(|(k, text)| match (numeric(k), k > 1 && (k - 2) % 3 == 1) {
                (true, true) => Cell::dim(text),
                (true, false) => Cell::number(text),
                _ => Cell::text(text),
            })
            .collect(),
        ..Row::default()
    });
    let rows = rows.collect();
    let columns = headings.into_iter().enumerate();
    Table {
        label: "Results".to_owned(),
        caption: format!(
            "Results of each run after its transient, and their difference to {}.",
            comparison.runs[0]
        ),
        columns: columns.map(|(k, name)| (name, numeric(k))).collect(),
        rows,
        provenance: Some(provenance(runs)),
        ..Table::default()
    }
}

/// Provenance of what shows all runs; settings in which they differ stand side by side.
pub(crate) fn provenance(runs: &[ComparedRun]) -> Provenance {
    let all = || runs.iter().map(|run| &run.data.provenance);
    let joined = |of: fn(&Provenance) -> Option<String>| {
        let mut values: Vec<String> = all().filter_map(of).collect();
        values.dedup();
        (!values.is_empty()).then(|| values.join(" / "))
    };
    let cases = runs.iter().zip(all());
    let cases = cases.map(|(run, from)| format!("{}: {}", run.name, from.case));
    let step_us = all().next().and_then(|from| from.step_us);
    Provenance {
        case: cases.collect::<Vec<_>>().join("; "),
        profile: joined(|from| from.profile.clone()),
        friction_law: joined(|from| from.friction_law.clone()),
        method: joined(|from| from.method.clone()),
        step_us: step_us.filter(|_| all().all(|from| from.step_us == step_us)),
        discarded: joined(|from| Some(from.discarded.clone())).unwrap_or_default(),
    }
}

/// The motions, on one time axis that begins with each: runs may have different lengths.
fn motions(runs: &[ComparedRun]) -> Vec<Motion> {
    let motions = runs.iter().filter_map(|run| {
        let mut motion = run.data.motion.clone()?;
        let begin = *motion.time_s.first()?;
        motion.time_s.iter_mut().for_each(|t| *t -= begin);
        motion.title.clone_from(&run.name);
        Some(motion)
    });
    motions.collect()
}
