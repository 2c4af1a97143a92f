//! The sheet of a case: what a decision rests on, on two pages of A4.

use cageless_io::case_file::{CaseFile, Source};
use cageless_results::{Record, software, table_of};
use cageless_study::comparison::RingComparison;
use cageless_study::measured::Limits;
use cageless_study::sheet::SheetResult;
use cageless_study::{Parameter, lines, parameters};

use crate::drawing::{Paper, ring_drawing};
use crate::head::Head;
use crate::lead;
use crate::page::{Note, Page};
use crate::table::{Column, Row, Table};
use crate::tables::parameter_table;

/// Results at the head.
const FACTS: [&str; 8] = [
    "l10r_h",
    "l10_h",
    "static_safety_factor",
    "inner_pressure_max_mpa",
    "operating_clearance_um",
    "stiffness_yy_n_m",
    "l10mr_h",
    "ftf_hz",
];
/// Sections of the case that are no property of bearing or operation.
const LEFT_OUT: [&str; 6] = ["solver", "output", "steady", "limit", "start", "search"];

/// Files of a sheet.
#[derive(Debug)]
pub struct SheetFiles {
    /// Each by its name; `None` without a drawing.
    pub files: [(&'static str, Option<Vec<u8>>); 3],
    /// Why there is no drawing.
    pub undrawn: Option<String>,
}

impl SheetFiles {
    /// Names of the files: the page and the drawing of the outer ring.
    pub const NAMES: [&str; 3] = ["report.html", "drawing.svg", "drawing.pdf"];

    /// Page and drawing of a case with the tolerances on it.
    pub fn new(file: &CaseFile, result: &SheetResult, limits: &Limits) -> Self {
        let drawing = ring_drawing(file, limits).map_err(|error| format!("no drawing: {error}"));
        let page = sheet_page(file, result, drawing.as_ref().map_err(String::as_str));
        let [page_name, svg, pdf] = Self::NAMES;
        let paper = drawing.as_ref().ok();
        Self {
            files: [
                (page_name, Some(page.into())),
                (svg, paper.map(|paper| paper.svg().into())),
                (pdf, paper.map(Paper::pdf)),
            ],
            undrawn: drawing.err(),
        }
    }
}

/// Verdicts, limits and the first facts.
fn head(result: &SheetResult) -> Head {
    let record = &result.equilibrium;
    let judged = result.tolerance.as_ref();
    let benefit = judged.and_then(|judged| judged.benefit.as_ref());
    let mut head = Head::default();
    if let Some(benefit) = benefit {
        head = head.verdict(benefit.helps(), &benefit.answer);
    }
    if let Some(judged) = judged {
        let passes = judged.record.flag("passes");
        head = head.verdict(passes, judged.record.text("headline"));
        head = head.dry(&judged.record);
        if let Some(failing) = failing(&judged.record) {
            head = head.verdict(None, &failing);
        }
        if benefit.is_none() {
            head = head.open_benefit(passes);
        }
    }
    let facts = FACTS.iter().filter_map(|name| record.row(name));
    head.limits(&record.limits().verdicts()).facts(lines(facts))
}

/// The sheet; `drawing` of the outer ring, or why there is none.
fn sheet_page(file: &CaseFile, result: &SheetResult, drawing: Result<&Paper, &str>) -> String {
    let case = file.case();
    let record = &result.equilibrium;
    let title = match file.particulars().title.as_str() {
        "" => "Bearing sheet",
        title => title,
    };
    let lead = lead::bearing(case);
    let mut page = Page::new(title, &lead, &software()).sheet();
    let judged = result.tolerance.as_ref();
    let benefit = judged.and_then(|judged| judged.benefit.as_ref());
    page.head(&head(result));
    page.notes(Note::Warning, record.sentences("warnings"));
    if let Some(judged) = judged {
        page.notes(Note::Warning, judged.record.sentences("warnings"));
    }
    if let Some(benefit) = benefit {
        page.section("Does it help?");
        page.table(&remedies(&benefit.comparison));
    }
    page.section("Life, safety and operation");
    page.table(&results(record));
    let (assumed, entered): (Vec<_>, Vec<_>) = keys_of(file)
        .into_iter()
        .partition(|key| key.source == Source::Default.name());
    page.table(&keys("Entered", "Values of the case file.", &entered));
    page.section("Outer ring");
    match drawing {
        Ok(paper) => page.drawing(paper),
        Err(why) => page.note(Note::Remark, why),
    }
    if let Some(judged) = judged {
        let caption = "The bearing with one deviation at both ends of its range, all else nominal.";
        let rows = table_of(judged.record.parts("influences"));
        page.table(&Table::of("Tolerances", caption, rows, None));
    }
    page.section("Assumed");
    page.table(&keys(
        "Assumed",
        "Values that the case file leaves open.",
        &assumed,
    ));
    if let Some(benefit) = benefit {
        page.note(Note::Remark, &benefit.comparison.draws.text());
    }
    page.notes(Note::Remark, record.sentences("notes"));
    page.html()
}

/// The influences at whose ends the raceway does not work, in a sentence.
pub fn failing(record: &Record) -> Option<String> {
    let failing = |influence: &&Record| influence.number("passed") < influence.number("trials");
    let influences = record.parts("influences").iter().filter(failing);
    let names: Vec<&str> = influences.map(|influence| influence.text("name")).collect();
    let said = || {
        let names = names.join(", ");
        format!("The raceway does not work at the ends of the range of: {names}")
    };
    (!names.is_empty()).then(said)
}

/// Table of the effects of a remedy: each ring with its value, marked where it is better or worse.
fn remedies(comparison: &RingComparison) -> Table {
    let rows = comparison.rows(comparison.subject().into_iter());
    let row = |row: Vec<String>| {
        let mut cells = vec![row[0].clone(), row[1].clone()];
        // Value, difference and judgement of each other ring.
        let last = row.len() - 1;
        for ring in row[2..last].chunks_exact(3) {
            let mark = match ring[2].as_str() {
                "better" => " ✔",
                "worse" => " ✘",
                _ => "",
            };
            cells.push(format!("{}{mark}", ring[0]));
        }
        cells.push(row[last].clone());
        Row::from(cells)
    };
    let names = comparison
        .runs
        .iter()
        .map(|name| (name.clone(), Column::Number));
    let first = [("result".to_owned(), Column::Text)];
    let unit = [("unit".to_owned(), Column::Text)];
    Table {
        label: "Steady operation".to_owned(),
        caption: "Means after the transient with their standard errors; ✔ better, ✘ worse than the plain ring by \
                  more than the error."
            .to_owned(),
        columns: first.into_iter().chain(names).chain(unit).collect(),
        rows: rows.into_iter().map(row).collect(),
        ..Table::default()
    }
}

/// Results of the equilibrium that are not at the head.
fn results(record: &Record) -> Table {
    let facts: Vec<_> = FACTS.iter().filter_map(|name| record.row(name)).collect();
    let rows = record.groups().into_iter().flat_map(|(_, rows)| rows);
    let rows = rows.filter(|row| {
        let (label, _, unit) = row;
        let of_load = unit == "Hz" && label.ends_with("of the loaded bearing");
        !(of_load || label.ends_with("multiple of the shaft frequency") || facts.contains(row))
    });
    let caption = "Results of the static equilibrium and ratings of the bearing.";
    parameter_table("Results", caption, &lines(rows), None)
}

fn keys(label: &str, caption: &str, keys: &[Parameter]) -> Table {
    let without_source = keys.iter().map(|key| Parameter {
        source: String::new(),
        ..key.clone()
    });
    let all: Vec<Parameter> = without_source.collect();
    parameter_table(label, caption, &all, None)
}

/// Keys of bearing and operation.
fn keys_of(file: &CaseFile) -> Vec<Parameter> {
    let all = parameters(file).into_iter();
    all.filter(|key| match key.name.split_once('.') {
        Some((section, _)) => !LEFT_OUT.contains(&section),
        None => false,
    })
    .collect()
}
