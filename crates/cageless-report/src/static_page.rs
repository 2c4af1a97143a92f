//! The page of `static`.

use cageless_io::case_file::CaseFile;
use cageless_results::{Record, software};
use cageless_study::{Provenance, lines, parameters};

use crate::data::{Parameter, RacewaySector};
use crate::figure::Figure;
use crate::figures::polar;
use crate::head::Head;
use crate::lead;
use crate::page::{Note, Page};
use crate::studio_page::case_sections;
use crate::table::{Row, Table};
use crate::tables::parameter_table;

/// Results at the head of the page.
const FACTS: [&str; 6] = [
    "inner_pressure_max_mpa",
    "outer_pressure_max_mpa",
    "static_safety_factor",
    "l10r_h",
    "stiffness_yy_n_m",
    "stiffness_zz_n_m",
];

/// Contact forces and pressures of a static equilibrium over ψ.
pub fn load_distribution(file: &CaseFile, record: &Record) -> Figure {
    let raceways = file.case().raceways.iter();
    let sectors: Vec<RacewaySector> = raceways.map(RacewaySector::new).collect();
    polar::static_loads(&record.results, &sectors, provenance(file))
}

fn provenance(file: &CaseFile) -> Provenance {
    Provenance {
        case: file.particulars().title.clone(),
        method: Some("static equilibrium".to_owned()),
        formulation: Some(file.case().formulation.name().to_owned()),
        ..Provenance::default()
    }
}

/// The page of a static equilibrium.
pub fn static_page(file: &CaseFile, record: &Record) -> String {
    let mut page = head(file, record);
    page.open_with([load_distribution(file, record)]);
    page.section("Results");
    page.table(&results(file, record));
    page.section("Balls");
    page.table(&balls(file, record));
    page.notes(Note::Remark, record.sentences("notes"));
    // A seed beyond the whole numbers of TOML leaves the page without a studio, which moves the balls.
    let toml = match file.case().check_motion() {
        Ok(()) => file.document().to_toml().unwrap_or_default(),
        Err(_) => String::new(),
    };
    case_sections(&mut page, "The case as computed", &parameters(file), &toml);
    page.html()
}

fn head(file: &CaseFile, record: &Record) -> Page {
    let case = file.case();
    let title = match file.particulars().title.as_str() {
        "" => "Static equilibrium".to_owned(),
        title => format!("Static equilibrium: {title}"),
    };
    let lead = lead::bearing(case);
    let mut page = Page::new(&title, &lead, &software());
    let facts = FACTS.iter().filter_map(|name| record.row(name));
    page.head(&Head::default().facts(lines(facts)));
    let limits = record.limits().lines().into_iter();
    let limits: Vec<String> = limits
        .map(|(word, limit)| format!("{word}: {limit}"))
        .collect();
    let (broken, kept) = limits.split_at(record.sentences("limits_exceeded").len());
    page.notes(Note::Warning, broken);
    page.notes(Note::Remark, kept);
    page.notes(Note::Warning, record.sentences("warnings"));
    page
}

/// Results under the headings of their groups.
fn results(file: &CaseFile, record: &Record) -> Table {
    let mut table = table(file, vec![]);
    for (heading, rows) in record.groups() {
        table.rows.push(Row {
            cells: vec![heading.to_owned()],
            summary: Some(3),
            ..Row::default()
        });
        let row = |(label, value, unit): (&str, String, String)| {
            Row::from(vec![label.to_owned(), value, unit])
        };
        table.rows.extend(rows.into_iter().map(row));
    }
    table
}

fn table(file: &CaseFile, rows: Vec<Parameter>) -> Table {
    parameter_table(
        "Results",
        "Results of the static equilibrium and ratings of the bearing.",
        &rows,
        Some(provenance(file)),
    )
}

fn balls(file: &CaseFile, record: &Record) -> Table {
    let caption = format!("Each ball in equilibrium: {}.", record.legend());
    Table::of("Balls", &caption, record.columns(), Some(provenance(file)))
}
