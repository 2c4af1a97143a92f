//! The page of a drop of a rotor.

mod balls;
mod rotor;
mod scattered;
mod several;
mod verification;

use cageless::contact::hertz::STRESS_LIMIT_PA;
use cageless_io::case_file::CaseFile;
use cageless_io::results::VERSION;
use cageless_study::drop::{DropResult, DropStudy};
use cageless_study::{Provenance, parameter, provenance};

use crate::figure::Figure;
use crate::head::Head;
use crate::page::Page;
use crate::plot::Plot;
use crate::studio::studio_section;
use crate::table::{Cell, Row, Table};
use crate::text::short;
pub use several::rotor_page;

use balls::{balls_in_motion, heat, loads};
use rotor::of_rotor;
use scattered::{distribution, scatter};
use verification::verified;

/// The self-contained page of a drop of the case in `file`.
pub fn drop_page(file: &CaseFile, study: &DropStudy) -> String {
    let case = file.case();
    let record = &study.drop;
    let title = match case.title.as_str() {
        "" => "Drop of a rotor",
        title => title,
    };
    let source = provenance(case, String::new());
    let mut page = Page::new(title, "", &format!("Cageless {VERSION}"));
    page.head(&head(&record.result));
    page.section("Results");
    page.table(&results(study, &source));
    page.section("Rotor and inner ring");
    for figure in of_rotor(case, record, &source) {
        page.figure(&figure);
    }
    page.section("Balls");
    page.figure(&loads(study, &source));
    page.motion(&balls_in_motion(case, study, &source));
    page.section("Energy");
    page.figure(&heat(study, &source));
    if let Some(ensemble) = &study.ensemble {
        page.section("Scattered drops");
        page.table(&distribution(ensemble, &source));
        let rows = ensemble.drops.iter().map(|drop| &drop.bearing);
        let label = "State at the end";
        page.figure(&scatter(&ensemble.distribution, rows, label, &source));
    }
    if let Some(verification) = &study.verification {
        page.section("Verification");
        page.table(&verified(verification, "Verification".to_owned(), &source));
    }
    let toml = file.document().to_toml().unwrap_or_default();
    studio_section(&mut page, &toml, "");
    page.html()
}

fn head(drop: &DropResult) -> Head {
    let fact = |name: &str, result: &str, unit: &str| {
        let value = drop.value(result)?;
        Some(parameter(name, short(value), unit))
    };
    let limit_gpa = 1e-9 * STRESS_LIMIT_PA;
    let stress_gpa = [
        "inner_stress_max_gpa",
        "outer_stress_max_gpa",
        "ball_stress_max_gpa",
    ]
    .into_iter()
    .filter_map(|name| drop.value(name))
    .fold(0.0, f64::max);
    let state = format!(
        "At the end of {} s: {}",
        short(drop.results.number("end_s")),
        words(drop.end_state())
    );
    let failed = drop.end_state() == "backward-whirl" || stress_gpa > limit_gpa;
    let facts = [
        fact("First contact", "first_contact_ms", "ms"),
        fact(
            "Largest force on the rotor",
            "rotor_force_max_weights",
            "× weight",
        ),
        fact("Spin-up of the inner ring", "spin_up_ms", "ms"),
        Some(parameter(
            "Largest contact pressure (ISO 76: 4.2)",
            short(stress_gpa),
            "GPa",
        )),
        fact("Collisions between balls", "collisions", ""),
        fact("Heat of all interfaces", "heat_j", "J"),
    ];
    Head::new(failed.then_some(false), &state).facts(facts.into_iter().flatten())
}

/// A state at the end in words.
fn words(state: &str) -> String {
    match state {
        "at-rest" => "at rest in the bottom".to_owned(),
        other => other.replace('-', " "),
    }
}

fn results(study: &DropStudy, source: &Provenance) -> Table {
    let mut drops = vec![("This drop".to_owned(), &study.drop.result)];
    if let Some(other) = &study.conventional {
        drops.push(("Conventional outer ring".to_owned(), &other.result));
    }
    side_by_side(drops, source)
}

/// Table of the results of drops, one column each.
fn side_by_side(drops: Vec<(String, &DropResult)>, source: &Provenance) -> Table {
    let mut columns = vec![("Result".to_owned(), false)];
    let (names, drops): (Vec<_>, Vec<_>) = drops.into_iter().unzip();
    columns.extend(names.into_iter().map(|name| (name, true)));
    columns.push(("Unit".to_owned(), false));
    let rows = DropResult::table(&drops)
        .into_iter()
        .map(|(label, values, unit)| {
            let mut cells = vec![Cell::text(label)];
            cells.extend(values.iter().map(Cell::number));
            cells.push(Cell::text(unit));
            Row {
                cells,
                ..Row::default()
            }
        });
    Table {
        label: "Results".to_owned(),
        caption: "From the moment at which the magnets let go to the end of the run.".to_owned(),
        columns,
        rows: rows.collect(),
        provenance: Some(source.clone()),
        ..Table::default()
    }
}

fn figure(label: &str, caption: &str, source: &Provenance, plot: Plot) -> Figure {
    Figure {
        label: label.to_owned(),
        caption: caption.to_owned(),
        provenance: source.clone(),
        plot,
    }
}
